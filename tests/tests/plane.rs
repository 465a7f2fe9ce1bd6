//! Maneuvers in any vertical plane: the vehicle does not yaw, its plane turns.

use mintime::flight::{Outcome, Phase, Witness};
use mintime::mission::{
    Flown, Mission, MissionError, PlantChoice, Room, Source, VehicleChoice, fly_mission, prepare,
};
use mintime::solver::Turns;
use mintime_firmware::config::{ENVELOPE_LATERAL_RAD, ENVELOPE_PITCH_RAD};
use mintime_firmware::player::Player;
use mintime_shared::model::{Limits, State};
use mintime_shared::plane::Plane;
use mintime_shared::replay::{Plan, Replay, Step, TickPeriod};
use mintime_shared::table::ManeuverTable;
use mintime_simulator::{Command, Simulator, Start, Truth, VehicleParameters};
use mintime_tests::reference_cases;
use proptest::prelude::*;

/// A witness that looks away.
struct Unseen;

impl Witness for Unseen {
    fn phase(&mut self, _: Phase, _: f64) {}
    fn event(&mut self, _: f64, _: &str) {}
}

/// Replays a table at 800 Hz on the planning model and returns the truth at T.
fn replayed(table: &ManeuverTable) -> Truth {
    let start = Start { height_m: 1000.0, ..Start::default() };
    let mut simulator = Simulator::new(&VehicleParameters::ideal(), 1, 0.0, start).expect("sound");
    let plan = Plan::new(table);
    let (plane, duration_s) = (plan.plane(), f64::from(plan.duration_s()));
    let mut replay = Replay::new(plan, 0);
    let mut now_us = 0;
    while let Step::Fly(command) = replay.tick(now_us, &TickPeriod::new()) {
        simulator.apply(Command {
            throttle: [0.5; 4],
            rates_radps: plane.turn(command.rate_radps),
            thrust_mps2: command.thrust_mps2,
        });
        now_us += 1250;
        simulator.advance_to((now_us * 1000).min((duration_s * 1e9) as u64));
    }
    simulator.truth()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    /// Turning the heading turns the trajectory about the vertical through the start, and nothing else.
    #[test]
    fn turning_the_heading_turns_the_trajectory(case in 0usize..24, heading in -6.2f32..6.2) {
        let cases = reference_cases();
        let case = &cases[case % cases.len()];
        let straight = case.table();
        let mut turned = straight.clone();
        turned.heading_rad = heading;
        let (a, b) = (replayed(&straight), replayed(&turned));
        let (sin, cos) = f64::from(heading).sin_cos();
        let turn = |[x, y, z]: [f64; 3]| [x * cos - y * sin, x * sin + y * cos, z];
        for (expected, got) in [(turn(a.position_m), b.position_m), (turn(a.velocity_mps), b.velocity_mps)] {
            let miss = expected.iter().zip(got).map(|(e, g)| (e - g).abs()).fold(0.0, f64::max);
            prop_assert!(miss < 2e-4, "{}: {} at {}", case.name, miss, heading);
        }
        prop_assert!((a.planar(0.0).theta - b.planar(f64::from(heading)).theta).abs() < 1e-4);
        prop_assert!((a.tilt_rad() - b.tilt_rad()).abs() < 1e-4);
    }

    /// The envelope is one of the plane: as wide in it and as narrow across it for every heading.
    #[test]
    fn the_envelope_turns_with_the_plane(heading in -6.2f32..6.2, part in 0.5f32..1.5, axis in 0usize..3) {
        prop_assume!((part - 1.0).abs() > 1e-3);
        let mut table = reference_cases().swap_remove(0).table();
        table.heading_rad = heading;
        let mut player = Player::new();
        player.load(Plan::new(&table));
        player.start(0);
        let bound = [ENVELOPE_LATERAL_RAD, ENVELOPE_PITCH_RAD, ENVELOPE_LATERAL_RAD][axis];
        let (sin, cos) = heading.sin_cos();
        // The plane's axes in the body frame, by hand: along the heading, to the left of it, up.
        let direction = [[cos, sin, 0.0], [-sin, cos, 0.0], [0.0, 0.0, 1.0]][axis];
        for sign in [1.0, -1.0] {
            prop_assert_eq!(player.is_off_plan(direction.map(|d| sign * d * part * bound)), part > 1.0);
        }
        prop_assert_eq!(player.plane(), Plane::new(heading));
    }
}

fn mission(along: f64, up: f64, heading_rad: f64, plant: &str, seed: u64) -> Mission {
    let (to, limits) = (State::at_rest(along, up), Limits::TABLE_I);
    Mission {
        source: Source::Solve { to, limits, turns: Turns::Any, heading_rad },
        plant: PlantChoice::from_argument(plant).expect("a plant"),
        seed,
        room: None,
    }
}

fn flown(mission: &Mission) -> Flown {
    let prepared = prepare(&mission.source, mission.room.as_ref()).expect("a maneuver");
    fly_mission(mission, prepared, &VehicleChoice::Hosted, &mut Unseen).expect("a simulation")
}

fn moved(flown: &Flown) -> [f64; 3] {
    let (start, end) =
        (flown.trace.start.as_ref().expect("it began"), flown.trace.end.as_ref().expect("it ended"));
    std::array::from_fn(|i| end.position_m[i] - start.position_m[i])
}

/// (3, 4, 5) on the planning model, and the same distance in every direction.
#[test]
fn any_direction_is_reached_to_the_millimetre() {
    for heading in [4f64.atan2(3.0), 0.0, -2.356_194, 1.5, 3.1, -0.4] {
        let flown = flown(&mission(5.0, 5.0, heading, "ideal", 1));
        assert_eq!(flown.flight.as_ref().expect("a flight").outcome, Outcome::Completed);
        let [x, y, z] = moved(&flown);
        let miss = (x - 5.0 * heading.cos()).hypot(y - 5.0 * heading.sin()).hypot(z - 5.0);
        assert!(miss < 2e-3, "{heading}: {x} {y} {z}");
        let end = flown.final_error().expect("it ended");
        assert!(end.x_m.hypot(end.z_m) < 1e-3 && end.pitch_rate_radps.abs() < 1e-2, "{end:?}");
        // Caught where it was planned to end.
        let last = flown.trace.last.as_ref().expect("truth");
        assert!(
            (last.position_m[0] - 5.0 * heading.cos()).hypot(last.position_m[1] - 5.0 * heading.sin()) < 0.1
        );
    }
}

/// On the simulated airframe every direction ends as near as straight ahead does: its drag and inertia differ a little
/// along and across.
#[test]
fn every_direction_is_flown_as_well_as_straight_ahead() {
    let miss = |heading: f64| {
        let mut sum = 0.0;
        for seed in 1..=4 {
            let flown = flown(&mission(5.0, 5.0, heading, "nominal", seed));
            let result = flown.flight.as_ref().expect("a flight");
            assert_eq!(result.outcome, Outcome::Completed, "{heading}: {:?}", result.reason);
            let [x, y, z] = moved(&flown);
            sum += (x - 5.0 * heading.cos()).hypot(y - 5.0 * heading.sin()).hypot(z - 5.0);
        }
        sum / 4.0
    };
    let straight = miss(0.0);
    println!("heading 0: {straight:.3} m");
    for heading in [4f64.atan2(3.0), -2.356_194, std::f64::consts::FRAC_PI_2, 2.8] {
        let turned = miss(heading);
        println!("heading {heading}: {turned:.3} m");
        assert!(turned < 1.3 * straight + 0.1, "{heading}: {turned} m, straight {straight} m");
    }
}

/// A room with sides of its own is checked where the path leads, not along the plane.
#[test]
fn a_room_with_six_walls_is_checked_in_three_dimensions() {
    let source = mission(5.0, 5.0, 4f64.atan2(3.0), "ideal", 1).source;
    let wide = Room { x_m: (-4.0, 7.5), y_m: Some((-4.0, 8.5)), z_m: (-4.0, 9.5) };
    assert!(prepare(&source, Some(&wide)).is_ok());
    let side_of = |room: Room| match prepare(&source, Some(&room)) {
        Err(MissionError::Room { side, .. }) => side,
        other => panic!("{:?}", other.map(|p| p.extent)),
    };
    assert_eq!(side_of(Room { x_m: (-4.0, 5.0), ..wide }), "ahead of");
    assert_eq!(side_of(Room { y_m: Some((-4.0, 6.0)), ..wide }), "to the left of");
    assert_eq!(side_of(Room { y_m: Some((-0.1, 8.5)), ..wide }), "to the right of");
}

//! Whole flights through real frames: solved, packed, uploaded, flown, caught, landed, and compared with truth.

use mintime::flight::{Outcome, Phase, Witness};
use mintime::mission::{
    Flown, Mission, PlanarError, PlantChoice, Room, Source, VehicleChoice, fly_mission, prepare,
};
use mintime::solver::Turns;
use mintime_shared::model::{Limits, State};

/// Remembers the phases it was told of.
#[derive(Default)]
struct Phases(Vec<Phase>);

impl Witness for Phases {
    fn phase(&mut self, phase: Phase, _now_s: f64) {
        self.0.push(phase);
    }
    fn event(&mut self, _now_s: f64, _text: &str) {}
}

fn mission(x: f64, z: f64, plant: &str, seed: u64) -> Mission {
    Mission {
        source: Source::Solve {
            to: State::at_rest(x, z),
            limits: Limits::TABLE_I,
            turns: Turns::Any,
            heading_rad: 0.0,
        },
        plant: PlantChoice::from_argument(plant).expect("a plant"),
        seed,
        room: None,
    }
}

fn flown(mission: &Mission) -> Flown {
    let prepared = prepare(&mission.source, mission.room.as_ref()).expect("a maneuver");
    fly_mission(mission, prepared, &VehicleChoice::Hosted, &mut Phases::default()).expect("a simulation")
}

#[test]
fn five_five_is_flown_end_to_end() {
    let mission = mission(5.0, 5.0, "nominal", 1);
    let prepared = prepare(&mission.source, None).expect("a maneuver");
    let solution = prepared.solution.as_ref().expect("solved");
    assert!(solution.certificate.verified);
    assert!((solution.extremal.duration_s() - 1.411_220_050_3).abs() < 1e-9);
    assert!(prepared.bytes.len() <= 128);

    let mut phases = Phases::default();
    let flown = fly_mission(&mission, prepared, &VehicleChoice::Hosted, &mut phases).expect("a simulation");
    let result = flown.flight.as_ref().expect("a flight");
    assert_eq!(result.outcome, Outcome::Completed, "{:?}", result.reason);
    use Phase::{Catch, Download, Hover, Land, Maneuver, Prepare, TakeOff};
    assert_eq!(phases.0, [Prepare, TakeOff, Hover, Maneuver, Catch, Land, Download]);
    // The vehicle's own record covers the maneuver tick by tick.
    let seconds: f64 = result.record.iter().map(|t| f64::from(t.interval_us) * 1e-6).sum();
    assert!((seconds - 1.4112).abs() < 2.0 * 1.3e-3, "{seconds}");
    assert_eq!(result.missed_ticks, 0);
    assert!((result.flown_duration_s - 1.41122).abs() < 1e-4);
    // The gate: what the cameras saw was within it, so truth is near it (they are off by 1 mrad themselves).
    let start = flown.start_error().expect("it began");
    assert!(start.theta_rad.abs() < 5e-3 && start.vx_mps.hypot(start.vz_mps) < 0.03, "{start:?}");
    // Without learning the nominal vehicle misses by the lag and drag it has, and is caught all the same.
    let end = flown.final_error().expect("it ended");
    assert!(end.x_m.hypot(end.z_m) < 1.2 && end.theta_rad.abs() < 0.15, "{end:?}");
    assert!(end.vx_mps.hypot(end.vz_mps) < 1.6 && end.pitch_rate_radps.abs() < 0.5, "{end:?}");
    let last = flown.trace.last.as_ref().expect("truth");
    assert!(last.on_ground && !last.crashed);
}

/// On the planning model itself only start errors and the replay's rounding are left.
#[test]
fn the_ideal_vehicle_arrives_to_the_millimetre() {
    for (x, z) in [(5.0, 5.0), (0.0, 3.0), (15.0, 0.0), (-3.0, 4.0), (1.0, -2.0)] {
        let flown = flown(&mission(x, z, "ideal", 1));
        assert_eq!(flown.flight.as_ref().expect("a flight").outcome, Outcome::Completed);
        let PlanarError { x_m, vx_mps, z_m, vz_mps, theta_rad, .. } = flown.final_error().expect("it ended");
        assert!(
            x_m.hypot(z_m) < 1e-3 && vx_mps.hypot(vz_mps) < 1e-3,
            "{x},{z}: {x_m} {z_m} {vx_mps} {vz_mps}"
        );
        assert!(theta_rad.abs() < 1e-4, "{x},{z}: {theta_rad}");
    }
}

/// What is planned for is enough: flights stay within the path and the distance kept free to catch the vehicle.
#[test]
fn flights_stay_within_the_room_that_they_ask_for() {
    for (x, z) in [(5.0, 5.0), (0.0, 3.0), (12.0, 0.0), (-3.0, 4.0), (1.0, -2.0), (0.3, 0.0)] {
        for seed in [1, 2, 3] {
            let mut mission = mission(x, z, "nominal", seed);
            let extent = prepare(&mission.source, None).expect("a maneuver").extent;
            let catch = extent.catch_distance_m();
            mission.room = Some(Room {
                x_m: (extent.x_m.0 - catch, extent.x_m.1 + catch),
                y_m: None,
                z_m: (extent.z_m.0 - catch, extent.z_m.1 + catch),
            });
            let flown = flown(&mission);
            let result = flown.flight.as_ref().expect("a flight");
            assert_eq!(result.outcome, Outcome::Completed, "{x},{z} seed {seed}: {:?}", result.reason);
            for sample in &flown.trace.samples {
                let s = sample.truth.planar;
                let inside = s.x > extent.x_m.0 - catch
                    && s.x < extent.x_m.1 + catch
                    && s.z < extent.z_m.1 + catch
                    && sample.truth.position_m[1].abs() < catch;
                assert!(inside, "{x},{z} seed {seed}: {s:?} outside {extent:?} + {catch}");
            }
            let last = flown.trace.last.as_ref().expect("truth");
            assert!(last.on_ground && !last.crashed, "{x},{z} seed {seed}");
        }
    }
}

#[test]
fn a_flip_turns_once_and_a_seed_repeats_itself() {
    let first = flown(&mission(0.0, 4.0, "nominal", 7));
    let again = flown(&mission(0.0, 4.0, "nominal", 7));
    let other = flown(&mission(0.0, 4.0, "nominal", 8));
    assert_eq!(first.turns(), 1);
    let turned = first.trace.end.as_ref().expect("it ended").planar(0.0).theta;
    assert!((turned - core::f64::consts::TAU).abs() < 0.5, "{turned}");
    assert_eq!(first.trace.samples, again.trace.samples);
    assert_ne!(first.final_error(), other.final_error());
}

/// A vehicle that refuses the trigger hovers: it is landed in peace, not dropped. Its battery is good enough to arm and
/// too weak under load to fly a maneuver.
#[test]
fn a_refused_trigger_lands() {
    let mut refused = 0;
    for charge in [0.20, 0.25, 0.30, 0.35] {
        let mut mission = mission(5.0, 5.0, "nominal", 1);
        mission.plant.parameters.battery.charge = charge;
        let flown = flown(&mission);
        let Ok(result) = &flown.flight else { continue };
        if result.outcome == Outcome::NotTriggered {
            refused += 1;
            assert!(result.reason.as_ref().is_some_and(|r| r.contains("battery")), "{:?}", result.reason);
        }
        let last = flown.trace.last.as_ref().expect("truth");
        // The motors stop two centimetres above the floor, and the flight is over when they have.
        let floor_m = flown.prepared.extent.z_m.0 - flown.prepared.extent.catch_distance_m();
        let height_m = last.position_m[2] - floor_m;
        assert!(height_m < 0.03 && !last.crashed, "charge {charge}: {height_m} m");
    }
    assert!(refused > 0, "no charge in the list was refused: the test sees nothing");
}

/// Ticks and missed ticks are the vehicle's own count, even where its recorder was full.
#[test]
fn long_maneuvers_count_all_their_ticks() {
    let flown = flown(&mission(100.0, 0.0, "ideal", 1));
    let result = flown.flight.as_ref().expect("a flight");
    assert!((f64::from(result.ticks) - result.flown_duration_s * 800.0).abs() < 2.0, "{}", result.ticks);
    assert!(result.record.len() < result.ticks as usize);
    assert_eq!(result.missed_ticks, 0);
}

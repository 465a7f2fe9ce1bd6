//! The firmware image that gets flashed, flown on the emulated flight controller through the same client as a real one.

use std::sync::{Arc, Mutex};

use emulator::core::Timing;
use mintime::firmware_image::FirmwareImage;
use mintime::flight::{FlightPlan, Outcome, Phase, Scene, VirtualVehicle, Witness, fly};
use mintime::mission::{
    Flown, Mission, PlanarError, PlantChoice, Prepared, Source, VehicleChoice, fly_mission, prepare,
};
use mintime::solver::Turns;
use mintime_firmware::config::{BoardStatus, Capabilities, StoreStatus, VehicleConfig};
use mintime_firmware::vehicle::Vehicle;
use mintime_firmware::watch::{Watch, flags};
use mintime_shared::messages::{BoardTelemetry, FlightState, RECORD_BYTES};
use mintime_shared::model::{Limits, State};
use nalgebra::Vector3;

/// The image, built once.
fn image() -> FirmwareImage {
    static IMAGE: std::sync::OnceLock<FirmwareImage> = std::sync::OnceLock::new();
    IMAGE.get_or_init(|| FirmwareImage::build(&mut |_| {}).expect("the firmware builds")).clone()
}

fn on_board() -> VehicleChoice {
    VehicleChoice::Virtual { image: image(), both_timings: false }
}

/// Nobody watches.
struct Unseen;

impl Witness for Unseen {
    fn phase(&mut self, _: Phase, _: f64) {}
    fn event(&mut self, _: f64, _: &str) {}
}

fn mission(x_m: f64, z_m: f64, turns: Turns, plant: &str, seed: u64) -> (Mission, Prepared) {
    let source =
        Source::Solve { to: State::at_rest(x_m, z_m), limits: Limits::TABLE_I, turns, heading_rad: 0.0 };
    let plant = PlantChoice::from_argument(plant).expect("a plant that is built in");
    let prepared = prepare(&source, None).expect("a maneuver that can be flown");
    (Mission { source, plant, seed, room: None }, prepared)
}

fn flown(x_m: f64, z_m: f64, turns: Turns, plant: &str, vehicle: &VehicleChoice) -> Flown {
    let (mission, prepared) = mission(x_m, z_m, turns, plant, 1);
    fly_mission(&mission, prepared, vehicle, &mut Unseen).expect("the flight takes place")
}

/// Completed, with every tick, and without a mistake that the emulator saw.
fn assert_well_flown(flown: &Flown, what: &str) {
    let result = flown.flight.as_ref().unwrap_or_else(|e| panic!("{what}: {e}"));
    assert_eq!(result.outcome, Outcome::Completed, "{what}: {:?}", result.reason);
    assert_eq!(result.missed_ticks, 0, "{what}");
    assert!(flown.is_success(), "{what}: {:?}", flown.reason());
    if let Some(emulated) = &flown.emulated {
        assert_eq!(emulated.board.bugs, Vec::<String>::new(), "{what}");
    }
}

fn distance_m(a: &PlanarError, b: &PlanarError) -> f64 {
    (a.x_m - b.x_m).hypot(a.z_m - b.z_m)
}

#[test]
fn the_image_flies_a_diagonal_a_flip_and_a_dash_as_the_hosted_vehicle_does() {
    let on_board = on_board();
    for (x_m, z_m, turns, what) in [
        (5.0, 5.0, Turns::Any, "(5, 5)"),
        (0.0, 4.0, Turns::Any, "a vertical flip"),
        (15.0, 0.0, Turns::Any, "a 15 m dash"),
    ] {
        let board = flown(x_m, z_m, turns, "nominal", &on_board);
        let hosted = flown(x_m, z_m, turns, "nominal", &VehicleChoice::Hosted);
        assert_well_flown(&board, what);
        assert_well_flown(&hosted, what);
        let (a, b) = (board.final_error().expect("flown"), hosted.final_error().expect("flown"));
        // The plant is the same and so is the logic; what differs is the latency (85 µs against 100 µs), what the gyro
        // chip rounds, and when the hover's noise let the maneuver begin.
        assert!(distance_m(&a, &b) < 0.25, "{what}: {a:?} {b:?}");
        assert!((a.vx_mps - b.vx_mps).hypot(a.vz_mps - b.vz_mps) < 0.5, "{what}: {a:?} {b:?}");
        assert!((a.theta_rad - b.theta_rad).abs() < 0.05, "{what}: {a:?} {b:?}");
    }
}

#[test]
fn on_the_planning_model_the_image_arrives_where_it_should() {
    let flown = flown(5.0, 5.0, Turns::Any, "ideal", &on_board());
    assert_well_flown(&flown, "(5, 5), ideal");
    let error = flown.final_error().expect("flown");
    // Setpoints take effect a tick's latency late (85 µs); the plan's own speed is 10 m/s at most and its rate 10 rad/s.
    assert!(error.x_m.hypot(error.z_m) < 0.02, "{error:?}");
    assert!(error.vx_mps.hypot(error.vz_mps) < 0.05, "{error:?}");
    assert!(error.theta_rad.abs() < 0.01, "{error:?}");
}

/// What the flight logic on the board got and gave, tick by tick, over a whole flight.
fn recorded_flight() -> Vec<Watch> {
    let (mission, prepared) = mission(5.0, 5.0, Turns::Any, "nominal", 7);
    let scene = Scene {
        parameters: &mission.plant.parameters,
        seed: mission.seed,
        ground_z_m: -4.0,
        heading_rad: 0.0,
        maneuver_s: f64::from(prepared.table.duration_s()),
    };
    let mut vehicle =
        VirtualVehicle::new(&scene, image().elf(), Timing::Pessimistic).expect("an image of this firmware");
    let ticks = Arc::new(Mutex::new(Vec::new()));
    let seen = Arc::clone(&ticks);
    vehicle.observe(move |watch| seen.lock().expect("one thread").push(*watch));
    let plan = FlightPlan::new(prepared.table, Vector3::zeros(), Some(VehicleConfig::REFERENCE));
    let result = fly(&mut vehicle, &plan, &mut Unseen).expect("a flight");
    assert_eq!(result.outcome, Outcome::Completed, "{:?}", result.reason);
    drop(vehicle);
    Arc::into_inner(ticks).expect("the only owner").into_inner().expect("one thread")
}

#[test]
fn what_the_image_computed_is_what_the_library_computes_bit_for_bit() {
    let ticks = recorded_flight();
    let unseen: Vec<_> = ticks.windows(2).filter(|pair| pair[1].ticks != pair[0].ticks + 1).collect();
    assert!(unseen.is_empty(), "ticks were not seen: {unseen:?}");
    assert_eq!(ticks[0].ticks, 1);
    let record = vec![[0_u8; RECORD_BYTES]; 3200];
    let nothing = Capabilities { gyro: false, motors: false };
    let mut vehicle = Vehicle::new(None, nothing, record);
    // What the board says before its first tick.
    vehicle.set_board_status(&BoardStatus {
        capabilities: nothing,
        starting: true,
        telemetry: BoardTelemetry::default(),
        store: StoreStatus { present: true, ..StoreStatus::default() },
    });
    let mut maneuver_ticks = 0;
    for watch in &ticks {
        let got = vehicle.tick(&watch.input());
        let gave = watch.output();
        let bits = |throttle: Option<[f32; 4]>| throttle.map(|t| t.map(f32::to_bits));
        assert_eq!(bits(got.throttle), bits(gave.throttle), "tick {}", watch.ticks);
        assert_eq!(
            got.setpoint.thrust_mps2.to_bits(),
            gave.setpoint.thrust_mps2.to_bits(),
            "tick {}",
            watch.ticks
        );
        assert_eq!(
            got.setpoint.rates_radps.map(f32::to_bits),
            gave.setpoint.rates_radps.map(f32::to_bits),
            "tick {}",
            watch.ticks
        );
        assert_eq!(Some(vehicle.state()), FlightState::from_index(watch.state), "tick {}", watch.ticks);
        maneuver_ticks += u32::from(vehicle.state() == FlightState::Maneuver);
        let has = |bit: u32| watch.flags & bit != 0;
        vehicle.set_board_status(&BoardStatus {
            capabilities: Capabilities { gyro: has(flags::CAN_MEASURE), motors: has(flags::CAN_DRIVE) },
            starting: has(flags::STARTING),
            telemetry: BoardTelemetry::default(),
            store: watch.store(),
        });
        let mut out = vec![0; watch.room as usize];
        vehicle.transmit(&mut out);
        vehicle.receive(watch.received());
    }
    assert!(maneuver_ticks > 1100, "{maneuver_ticks}");
}

#[test]
fn one_seed_is_one_flight() {
    let choice = on_board();
    let fly_once = |seed| {
        let (mission, prepared) = mission(2.0, 0.0, Turns::Any, "nominal", seed);
        fly_mission(&mission, prepared, &choice, &mut Unseen).expect("a flight")
    };
    let (a, b, c) = (fly_once(3), fly_once(3), fly_once(4));
    let record = |flown: &Flown| flown.flight.as_ref().expect("flown").record.clone();
    assert_eq!(record(&a), record(&b));
    assert_eq!(a.final_error(), b.final_error());
    assert_ne!(record(&a), record(&c));
}

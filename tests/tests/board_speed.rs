//! How fast the virtual board runs: a floor far below what it does, so that a build or a change that makes it slow is seen.
#![cfg(unix)]

use emulator::core::Timing;
use mintime::firmware_image::FirmwareImage;
use mintime::flight::{FlightPlan, Outcome, Phase, Scene, VirtualVehicle, Witness, fly};
use mintime::mission::{PlantChoice, Source, prepare};
use mintime::solver::Turns;
use mintime_firmware::config::VehicleConfig;
use mintime_shared::model::{Limits, State};
use nalgebra::Vector3;
use rustix::time::{ClockId, clock_gettime};

/// Seconds flown per second of processor. On a core that does nothing else it is 10 and more (`docs/emulator.md`, Speed).
/// About half of that: time of a processor shared with other work passes with the caches full of that work's data.
const FLOOR: f64 = 5.0;
/// The fastest of these many counts.
const FLIGHTS: usize = 4;

struct Unseen;

impl Witness for Unseen {
    fn phase(&mut self, _: Phase, _: f64) {}
    fn event(&mut self, _: f64, _: &str) {}
}

/// What this thread has had of a processor, s. What others have had of it does not count.
fn processor_s() -> f64 {
    let time = clock_gettime(ClockId::ThreadCPUTime);
    time.tv_sec as f64 + time.tv_nsec as f64 * 1e-9
}

/// Flies 2 m ahead and back to the ground: seconds flown per second of processor.
fn flown(image: &FirmwareImage, timing: Timing) -> f64 {
    let source = Source::Solve {
        to: State::at_rest(2.0, 0.0),
        limits: Limits::TABLE_I,
        turns: Turns::Any,
        heading_rad: 0.0,
    };
    let plant = PlantChoice::from_argument("nominal").expect("built in");
    let prepared = prepare(&source, None).expect("a maneuver that can be flown");
    let scene = Scene {
        parameters: &plant.parameters,
        seed: 1,
        ground_z_m: -4.0,
        heading_rad: 0.0,
        maneuver_s: f64::from(prepared.table.duration_s()),
    };
    let mut vehicle = VirtualVehicle::new(&scene, image.elf(), timing).expect("an image of this firmware");
    let plan = FlightPlan::new(prepared.table, Vector3::zeros(), Some(VehicleConfig::REFERENCE));
    let start_s = processor_s();
    let result = fly(&mut vehicle, &plan, &mut Unseen).expect("a flight");
    let taken_s = processor_s() - start_s;
    assert_eq!(result.outcome, Outcome::Completed, "{:?}", result.reason);
    vehicle.now_ns() as f64 * 1e-9 / taken_s
}

#[test]
fn the_closed_loop_runs_much_faster_than_real_time() {
    let image = FirmwareImage::build(&mut |_| {}).expect("the firmware builds");
    for timing in [Timing::Pessimistic, Timing::Optimistic] {
        let mut factors = Vec::new();
        while factors.len() < FLIGHTS && factors.iter().all(|factor| *factor < FLOOR) {
            factors.push(flown(&image, timing));
        }
        println!("{timing:?}: {factors:.1?} times real time");
        assert!(factors.iter().any(|factor| *factor >= FLOOR), "{timing:?}: {factors:.1?} times real time");
    }
}

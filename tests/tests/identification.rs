//! Identification of a vehicle that runs the firmware image, on the emulated flight controller.

use emulator::core::Timing;
use mintime::firmware_image::FirmwareImage;
use mintime::flight::{HopPlan, Phase, Scene, VirtualVehicle, Witness, fly_hops};
use mintime::identification::identify;
use mintime_firmware::config::VehicleConfig;
use mintime_simulator::VehicleParameters;

struct Unseen;

impl Witness for Unseen {
    fn phase(&mut self, _: Phase, _: f64) {}
    fn event(&mut self, _: f64, _: &str) {}
}

#[test]
fn the_image_is_found_to_be_a_tenth_too_weak() {
    let image = FirmwareImage::build(&mut |_| {}).expect("the firmware builds");
    let mut parameters = VehicleParameters::nominal();
    parameters.rotors.thrust_coefficient_ns2 *= 0.9;
    let scene =
        Scene { parameters: &parameters, seed: 1, ground_z_m: 0.0, heading_rad: 0.0, maneuver_s: 0.0 };
    let mut vehicle = VirtualVehicle::new(&scene, image.elf(), Timing::Pessimistic).expect("a board");
    let file = VehicleConfig::REFERENCE;
    let plan = HopPlan { vehicle: Some(file), ..HopPlan::default() };
    let flight = fly_hops(&mut vehicle, &plan, &mut Unseen).expect("flown");
    assert_eq!(vehicle.report().bugs, Vec::<String>::new());
    let found = identify(&flight, &file).expect("enough data");
    // The rotors' own scatter is in the truth.
    let trace = vehicle.into_trace();
    let (from, to) = flight.hover_s;
    let hovering = || trace.samples.iter().filter(|s| (from..to).contains(&(s.time_ns as f64 * 1e-9)));
    let given = hovering().map(|s| s.truth.thrust_mps2).sum::<f64>();
    let asked = hovering().map(|s| f64::from(s.setpoint_thrust_mps2)).sum::<f64>();
    assert!((found.thrust_scale / (given / asked) - 1.0).abs() < 0.01, "{found:?}");
    assert!((found.lag_s - 0.033).abs() < 0.005, "{found:?}");
}

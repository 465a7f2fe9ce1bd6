//! A vehicle that runs the firmware image learns, on the emulated flight controller.

use mintime::firmware_image::FirmwareImage;
use mintime::learning::{
    Budget, History, Observer, Response, SimulatedFlyer, SimulatedVehicle, StopReason, Unseen, airframe,
    learn, plan, target,
};
use mintime::mission::VehicleChoice;
use mintime_shared::table::ManeuverTable;
use mintime_shared::vehicle::VehicleConfig;

struct Silent;

impl Observer for Silent {
    fn flown(&mut self, _: &History, _: &ManeuverTable) {}
}

#[test]
fn the_image_learns_a_flip_with_a_tenth_less_thrust() {
    let image = FirmwareImage::build(&mut |_| {}).expect("the firmware builds");
    let mut vehicle = SimulatedVehicle {
        choice: VehicleChoice::Virtual { image, both_timings: false },
        plant: airframe(0.9),
        seed: 7,
        room: None,
        response: Response::IDEAL,
        heading_rad: 0.0,
    };
    let found = vehicle.identify(&mut Unseen).expect("enough data");
    assert!((found.thrust_scale - 0.9).abs() < 0.03, "{found:?}");
    let plan = plan(&target((0.0, 4.0, "")), &VehicleConfig::REFERENCE, &found).expect("a plan");
    vehicle.response = plan.response;
    let mut unseen = Unseen;
    let mut flyer = SimulatedFlyer { vehicle: &vehicle, witness: &mut unseen, last: None };
    let history = History::of("4 m flip", "virtual", Some(7));
    let budget = Budget { flights: 10, repeats: 2 };
    let learned = learn(&plan, history, budget, &mut flyer, &mut Silent);
    assert_eq!(learned.stop, StopReason::Converged, "{:?}", learned.history);
    let history = &learned.history;
    assert!(history.learned_duration_s <= 1.2 * history.optimum_duration_s);
    for repeat in &history.repeats {
        let truth = repeat.true_final_error.expect("flown to its end");
        assert!(truth.in_tolerances() <= 1.0, "{truth:?}");
    }
}

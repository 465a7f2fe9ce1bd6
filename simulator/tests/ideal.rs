//! The planning model against the closed forms that plan maneuvers.

use mintime_shared::{
    model::{GRAVITY_MPS2, State},
    motion,
};
use mintime_simulator::{Command, Event, Simulator, Start, VehicleParameters};
use proptest::prelude::*;

/// A planar command along a heading of zero: pitch rate and thrust per mass.
fn command(rate: f32, thrust: f32) -> Command {
    Command { throttle: [0.5; 4], rates_radps: [0.0, rate, 0.0], thrust_mps2: thrust }
}

proptest! {
    #[test]
    fn bang_segments_end_where_the_closed_form_says(
        segments in prop::collection::vec((-10.0f32..10.0, 1.0f32..20.0, 1u64..400_000_000), 1..12)
    ) {
        let start = Start { height_m: 1000.0, ..Start::default() };
        let mut simulator = Simulator::new(&VehicleParameters::ideal(), 0, 0.0, start).unwrap();
        let (mut now, mut expected) = (0, State::at_rest(0.0, 1000.0));
        for (rate, thrust, duration_ns) in segments {
            simulator.apply(command(rate, thrust));
            now += duration_ns;
            simulator.advance_to(now);
            let tau = duration_ns as f64 * 1e-9;
            let turn = motion::bang(f64::from(rate), tau);
            expected = motion::advance(expected, f64::from(thrust), GRAVITY_MPS2, tau, &turn);
            let error = simulator.truth().planar(0.0).minus(expected);
            prop_assert!(error.to_array().iter().all(|e| e.abs() < 1e-9), "{error:?}");
        }
    }

    #[test]
    fn the_same_in_any_heading(heading in -3.1f64..3.1, rate in -10.0f32..10.0, thrust in 1.0f32..20.0) {
        let start = Start { height_m: 100.0, heading_rad: heading, ..Start::default() };
        let mut simulator = Simulator::new(&VehicleParameters::ideal(), 0, 0.0, start).unwrap();
        simulator.apply(command(rate, thrust));
        simulator.advance_to(900_000_000);
        let turn = motion::bang(f64::from(rate), 0.9);
        let expected = motion::advance(State::at_rest(0.0, 100.0), f64::from(thrust), GRAVITY_MPS2, 0.9, &turn);
        let error = simulator.truth().planar(heading).minus(expected);
        prop_assert!(error.to_array().iter().all(|e| e.abs() < 1e-9), "{error:?}");
    }
}

#[test]
fn sensors_tell_the_truth() {
    let start = Start { height_m: 10.0, x_m: 1.0, y_m: -2.0, heading_rad: 0.3 };
    let mut vehicle = VehicleParameters::ideal();
    // Exact comparisons below: not even the last digit stirs.
    vehicle.gyro.noise_density_radps = 0.0;
    let mut simulator = Simulator::new(&vehicle, 5, 0.0, start).unwrap();
    let mut seen = (0, 0);
    for k in 0..400 {
        let (time, event) = simulator.next_event().unwrap();
        let truth = simulator.truth();
        assert_eq!(time, truth.time_ns);
        match event {
            Event::Gyro(sample) => {
                seen.0 += 1;
                assert_eq!(time, seen.0 * 1_250_000);
                assert_eq!(sample.rates_radps, truth.rates_radps.map(|w| w as f32));
                assert_eq!(sample.specific_force_mps2, [0.0, 0.0, truth.thrust_mps2 as f32]);
            }
            Event::MotionCapture(pose) => {
                seen.1 += 1;
                assert_eq!((time, pose.captured_ns), (seen.1 * 5_000_000, time));
                assert_eq!(pose.position_m, truth.position_m);
                assert!(pose.attitude.iter().zip(truth.attitude).all(|(a, b)| (a - b).abs() < 1e-12));
            }
        }
        simulator.apply(command(0.01 * k as f32, 9.0));
    }
    assert_eq!(seen, (320, 80));
}

#[test]
fn turns_are_counted() {
    let start = Start { height_m: 100.0, ..Start::default() };
    for (rates, heading) in
        [([0.0, 10.0, 0.0], 0.0), ([-10.0, 0.0, 0.0], std::f64::consts::FRAC_PI_2), ([0.0, -10.0, 0.0], 0.0)]
    {
        let mut simulator = Simulator::new(&VehicleParameters::ideal(), 0, 0.0, start).unwrap();
        simulator.apply(Command { throttle: [0.5; 4], rates_radps: rates, thrust_mps2: 9.0 });
        simulator.advance_to(2_000_000_000);
        let turned = f64::from(rates[1] - rates[0]) * 2.0;
        assert!((simulator.truth().planar(heading).theta - turned).abs() < 1e-9);
        assert!((simulator.truth().planar(heading + 0.01).theta - turned).abs() < 0.1);
        let back = simulator.truth().planar(heading + std::f64::consts::PI).theta;
        assert!((back + turned).abs() < 1e-9);
    }
}

#[test]
fn motors_off_falls_and_rests() {
    let start = Start { height_m: 0.05, ..Start::default() };
    let mut simulator = Simulator::new(&VehicleParameters::ideal(), 0, 0.2, start).unwrap();
    simulator.apply(Command { throttle: [0.0; 4], ..command(3.0, 15.0) });
    simulator.advance_to(1_000_000_000);
    let truth = simulator.truth();
    assert!(truth.on_ground && !truth.crashed && truth.contacts == 1);
    assert_eq!((truth.position_m, truth.rates_radps, truth.thrust_mps2), ([0.0, 0.0, 0.2], [0.0; 3], 0.0));
    // On again: it stays while thrust is below gravity, and leaves with the first command above.
    simulator.apply(command(1.0, 9.0));
    simulator.advance_to(1_100_000_000);
    assert!(simulator.truth().on_ground && simulator.truth().rates_radps == [0.0; 3]);
    simulator.apply(command(0.0, 10.81));
    let climb = 0.5 * (f64::from(10.81f32) - GRAVITY_MPS2);
    simulator.advance_to(2_100_000_000);
    assert!((simulator.truth().position_m[2] - 0.2 - climb).abs() < 1e-9, "{:?}", simulator.truth());
}

//! Axes and signs from throttle to gyro, motor by motor, against the table of `mintime_shared::frames`.

use mintime_shared::frames::MOTORS;
use mintime_simulator::{Command, Event, Simulator, Start, VehicleParameters};

/// Nominal mechanics with a straight, noise-free gyro.
fn vehicle() -> VehicleParameters {
    let mut vehicle = VehicleParameters::nominal();
    vehicle.rotors.thrust_error = 0.0;
    vehicle.imu.misalignment_rad = 0.0;
    vehicle.gyro.bias_radps = 0.0;
    vehicle.gyro.vibration_radps = 0.0;
    vehicle.gyro.noise_density_radps = 0.0;
    vehicle
}

/// Gyro counts and true state after a tenth of a second in the air, with throttles about hover.
fn after(change: [f32; 4]) -> ([i16; 3], mintime_simulator::Truth) {
    let start = Start { height_m: 5.0, ..Start::default() };
    let mut simulator = Simulator::new(&vehicle(), 3, 0.0, start).unwrap();
    simulator.apply(Command { throttle: change.map(|c| 0.42 + c), ..Command::OFF });
    loop {
        if let (time, Event::Gyro(sample)) = simulator.next_event().unwrap()
            && time > 100_000_000
        {
            return (sample.gyro_raw, simulator.truth());
        }
    }
}

#[test]
fn each_motor_turns_the_body_as_its_place_says() {
    for (index, motor) in MOTORS.into_iter().enumerate() {
        let mut change = [0.0; 4];
        change[index] = 0.05;
        let (gyro, truth) = after(change);
        // More thrust on the left rolls to the right (+x), in front raises the nose (−y).
        let expected = [f64::from(motor.left), -f64::from(motor.forward), f64::from(motor.yaw)];
        for axis in 0..3 {
            assert!(truth.rates_radps[axis] * expected[axis] > 0.01, "motor {}: {truth:?}", index + 1);
            assert!(f64::from(gyro[axis]) * expected[axis] > 5.0, "motor {}: {gyro:?}", index + 1);
        }
    }
}

#[test]
fn pairs_of_motors_turn_about_one_axis_only() {
    let push = |select: fn(usize) -> i8| core::array::from_fn(|i| 0.03 * f32::from(select(i)));
    // Left against right: roll right. Rear against front: nose down. Clockwise against counter-clockwise rotors: left.
    for (axis, change) in
        [(0, push(|i| MOTORS[i].left)), (1, push(|i| -MOTORS[i].forward)), (2, push(|i| MOTORS[i].yaw))]
    {
        let (gyro, truth) = after(change);
        assert!(truth.rates_radps[axis] > 0.1 && gyro[axis] > 100, "axis {axis}: {truth:?}");
        for other in [(axis + 1) % 3, (axis + 2) % 3] {
            assert!(
                truth.rates_radps[other].abs() < 1e-3 * truth.rates_radps[axis],
                "axis {axis}: {truth:?}"
            );
        }
    }
}

#[test]
fn nose_down_is_positive_theta_and_flies_forward() {
    let change = core::array::from_fn(|i| -0.03 * f32::from(MOTORS[i].forward));
    let (_, truth) = after(change);
    let plane = truth.planar(0.0);
    assert!(plane.theta > 0.0 && plane.vx > 0.0);
    // Seen along the opposite heading everything horizontal changes sign.
    let back = truth.planar(core::f64::consts::PI);
    assert!((back.theta + plane.theta).abs() < 1e-12 && (back.vx + plane.vx).abs() < 1e-12);
}

#[test]
fn heading_is_counter_clockwise_from_above() {
    let start = Start { heading_rad: 0.4, height_m: 5.0, ..Start::default() };
    let mut simulator = Simulator::new(&vehicle(), 3, 0.0, start).unwrap();
    let change: [f32; 4] = core::array::from_fn(|i| -0.03 * f32::from(MOTORS[i].forward));
    simulator.apply(Command { throttle: change.map(|c| 0.42 + c), ..Command::OFF });
    simulator.advance_to(200_000_000);
    let truth = simulator.truth();
    assert!((truth.heading_rad() - 0.4).abs() < 1e-6);
    let across = truth.planar(0.4 + core::f64::consts::FRAC_PI_2);
    assert!(truth.planar(0.4).vx > 0.01 && across.vx.abs() < 1e-9, "{across:?}");
}

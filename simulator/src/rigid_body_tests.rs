//! The equations of motion against what must hold for every rigid body.

use super::*;

/// Nominal, without anything that dissipates or varies.
fn vacuum() -> VehicleParameters {
    let mut vehicle = VehicleParameters::nominal();
    vehicle.drag.rotor_per_s = [0.0; 3];
    vehicle.drag.body_ns2_per_m2 = [0.0; 3];
    vehicle.rotors.thrust_error = 0.0;
    vehicle.battery.resistance_ohm = 0.0;
    vehicle
}

fn tumbling() -> BodyState {
    let attitude = UnitQuaternion::from_euler_angles(0.3, -0.7, 1.1);
    BodyState {
        velocity: Vector3::new(1.0, -2.0, 3.0),
        rates: Vector3::new(9.0, -14.0, 6.0),
        ..BodyState::at_rest(Vector3::new(0.5, 0.2, 10.0), attitude, 0.9)
    }
}

fn run(
    vehicle: &VehicleParameters,
    start: BodyState,
    throttle: [f64; 4],
    steps: usize,
    step_s: f64,
) -> BodyState {
    let body = RigidBody::new(vehicle, 0);
    (0..steps).fold(start, |state, _| body.step(&state, &throttle, false, step_s))
}

#[test]
fn free_tumbling_falls_on_a_parabola_and_keeps_energy_and_angular_momentum() {
    let vehicle = vacuum();
    let body = RigidBody::new(&vehicle, 0);
    let start = tumbling();
    let end = run(&vehicle, start, [0.0; 4], 4000, 2.5e-4);
    let fall = start.position + start.velocity - Vector3::z() * (0.5 * vehicle.gravity_mps2);
    assert!((end.position - fall).norm() < 1e-10, "{}", end.position - fall);
    let ((e0, l0), (e1, l1)) = (body.invariants(&start), body.invariants(&end));
    assert!((e1 - e0).abs() < 1e-9 * e0, "energy {e0} {e1}");
    assert!((l1 - l0).norm() < 1e-9, "angular momentum {}", l1 - l0);
}

#[test]
fn spinning_rotors_take_part_in_the_angular_momentum() {
    // Rotors that only spin, without air: with no thrust there is no reaction torque either.
    let mut vehicle = vacuum();
    vehicle.rotors.thrust_coefficient_ns2 = 1e-18;
    vehicle.rotors.inertia_kgm2 = 5e-5;
    let body = RigidBody::new(&vehicle, 0);
    let start = BodyState { rotors: Vector4::new(900.0, 0.0, 0.0, 1400.0), ..tumbling() };
    // Two of one direction speed up, two of the other stay.
    let end = run(&vehicle, start, [0.6, 0.0, 0.0, 0.9], 4000, 2.5e-4);
    let change = body.invariants(&end).1 - body.invariants(&start).1;
    assert!(change.norm() < 1e-8, "{change}");
    assert!((end.rotors - start.rotors).norm() > 100.0);
}

#[test]
fn the_integration_is_of_fourth_order() {
    let mut vehicle = VehicleParameters::nominal();
    vehicle.rotors.thrust_error = 0.0;
    // Large steps and fast rates, so that the truncation stands far above rounding. Rotors only speed up: smooth.
    let start = BodyState { rotors: Vector4::from_element(600.0), ..tumbling() };
    let throttle = [0.5, 0.6, 0.7, 0.8];
    let after = |step_s: f64| run(&vehicle, start, throttle, (0.064 / step_s).round() as usize, step_s);
    let reference = after(6.25e-5);
    let error = |step_s: f64| {
        let state = after(step_s);
        (state.position - reference.position).norm() + (state.rates - reference.rates).norm()
    };
    let order = (error(4e-3) / error(2e-3)).log2();
    assert!((3.6..4.6).contains(&order), "{order}");
    // What the simulator uses: far below the resolution of every sensor.
    assert!(error(2.5e-4) < 1e-7, "{}", error(2.5e-4));
}

#[test]
fn at_hover_speed_thrust_equals_weight() {
    let vehicle = vacuum();
    let body = RigidBody::new(&vehicle, 0);
    let level = BodyState::at_rest(Vector3::zeros(), UnitQuaternion::identity(), 0.9);
    let state = BodyState { rotors: Vector4::from_element(vehicle.hover_speed_radps()), ..level };
    assert!((body.thrust_mps2(&state) - vehicle.gravity_mps2).abs() < 1e-12);
    let voltage = body.battery_v(&state);
    let throttle = vehicle.throttle(vehicle.gravity_mps2, voltage);
    let derivative = body.derivative(&state, &[throttle; 4], false);
    assert!(derivative.velocity.norm() < 1e-12 && derivative.rates.norm() < 1e-12);
    assert!(derivative.rotors.norm() < 1e-6);
    // RotorPy's parameters give 1086 rad/s: sqrt(0.752 × 9.81/(4 × 1.562522e-6)).
    assert!((vehicle.hover_speed_radps() - 1086.4).abs() < 0.1);
}

#[test]
fn rotor_drag_slows_along_the_body_axes() {
    let mut vehicle = vacuum();
    vehicle.drag.rotor_per_s = [0.5, 0.3, 0.1];
    let body = RigidBody::new(&vehicle, 0);
    // Heading along world y: body x is world y.
    let attitude = UnitQuaternion::from_euler_angles(0.0, 0.0, core::f64::consts::FRAC_PI_2);
    let state = BodyState {
        velocity: Vector3::new(0.0, 4.0, 2.0),
        rotors: Vector4::from_element(vehicle.hover_speed_radps()),
        ..BodyState::at_rest(Vector3::zeros(), attitude, 0.9)
    };
    let force = body.specific_force(&state);
    assert!((force - Vector3::new(-2.0, 0.0, 9.81 - 0.2)).norm() < 1e-12, "{force}");
}

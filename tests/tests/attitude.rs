//! The attitude estimate against an integrator in `f64` that shares nothing with it, and levelling in closed loop.

use mintime_firmware::attitude::{AttitudeEstimate, Motion, descent_thrust_mps2, level_rates};
use mintime_firmware::config::VehicleConfig;
use mintime_firmware::config::control::LEVEL_RATE_MAX_RADPS;
use mintime_firmware::mixer::{Demand, RotorDrive, mix};
use mintime_firmware::rate_control::{RateController, RateInput};
use mintime_shared::model::GRAVITY_MPS2;
use mintime_simulator::{Command, Event, Simulator, Start, VehicleParameters};
use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use proptest::prelude::*;

const TICK_S: f64 = 1.25e-3;
const REST: [f32; 3] = [0.0, 0.0, GRAVITY_MPS2 as f32];

fn f32s(v: Vector3<f64>) -> [f32; 3] {
    [v.x as f32, v.y as f32, v.z as f32]
}

fn up(attitude: &UnitQuaternion<f64>) -> Vector3<f64> {
    attitude.inverse_transform_vector(&Vector3::z())
}

fn angle_to_up(estimate: &AttitudeEstimate, attitude: &UnitQuaternion<f64>) -> f64 {
    Vector3::from(estimate.up_in_body().map(f64::from)).angle(&up(attitude))
}

fn norm(estimate: &AttitudeEstimate) -> f32 {
    estimate.rotation().wxyz().iter().map(|c| c * c).sum()
}

/// Rates that vary like those of a vehicle thrown about: three sines an axis.
#[derive(Clone, Debug)]
struct Profile([[(f64, f64, f64); 3]; 3]);

impl Profile {
    fn at(&self, t: f64) -> Vector3<f64> {
        Vector3::from(self.0.map(|axis| axis.iter().map(|(a, w, p)| a * (w * t + p).sin()).sum::<f64>()))
    }
}

fn profile() -> impl Strategy<Value = Profile> {
    let sine = (-4.0f64..4.0, 0.2f64..25.0, 0.0f64..6.3);
    prop::array::uniform3(prop::array::uniform3(sine)).prop_map(Profile)
}

/// Classical Runge-Kutta on the quaternion, eight steps a tick.
fn integrate(mut q: UnitQuaternion<f64>, profile: &Profile, t: f64) -> UnitQuaternion<f64> {
    const STEPS: usize = 8;
    let h = TICK_S / STEPS as f64;
    let slope = |q: Quaternion<f64>, t: f64| q * Quaternion::from_parts(0.0, profile.at(t)) * 0.5;
    for i in 0..STEPS {
        let t = t + h * i as f64;
        let (q0, k1) = (q.into_inner(), slope(q.into_inner(), t));
        let k2 = slope(q0 + k1 * (h / 2.0), t + h / 2.0);
        let k3 = slope(q0 + k2 * (h / 2.0), t + h / 2.0);
        let k4 = slope(q0 + k3 * h, t + h);
        q = UnitQuaternion::new_normalize(q0 + (k1 + k2 * 2.0 + k3 * 2.0 + k4) * (h / 6.0));
    }
    q
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(16))]

    /// A minute of any motion, by the gyro alone.
    #[test]
    fn a_minute_of_turning_is_integrated(profile in profile()) {
        let mut estimate = AttitudeEstimate::new();
        let mut truth = UnitQuaternion::identity();
        // The estimate learns the first rate before it integrates.
        estimate.update(f32s(profile.at(0.0)), REST, 0.0, Motion::Maneuver);
        let mut worst = 0.0f64;
        for i in 0..48_000 {
            let t = f64::from(i) * TICK_S;
            truth = integrate(truth, &profile, t);
            estimate.update(f32s(profile.at(t + TICK_S)), REST, TICK_S as f32, Motion::Maneuver);
            worst = worst.max(angle_to_up(&estimate, &truth));
            prop_assert!((norm(&estimate) - 1.0).abs() < 1e-5, "{}", norm(&estimate));
        }
        prop_assert!(worst < 2e-3, "{} rad", worst);
    }

    /// Gravity at rest gives the tilt at once, whichever way the vehicle lies.
    #[test]
    fn rest_is_seen_at_once(axis in prop::array::uniform3(-1.0f64..1.0), angle in 0.0f64..std::f64::consts::PI) {
        let axis = Vector3::from(axis);
        prop_assume!(axis.norm() > 1e-2);
        let truth = UnitQuaternion::from_scaled_axis(axis.normalize() * angle);
        let mut estimate = AttitudeEstimate::new();
        let accel = f32s(up(&truth) * GRAVITY_MPS2);
        estimate.update([0.0; 3], accel, TICK_S as f32, Motion::MotorsOff);
        prop_assert!(estimate.is_known() && angle_to_up(&estimate, &truth) < 0.05);
        for _ in 0..1600 {
            estimate.update([0.0; 3], accel, TICK_S as f32, Motion::MotorsOff);
        }
        prop_assert!(angle_to_up(&estimate, &truth) < 2e-4, "{}", angle_to_up(&estimate, &truth));
        // Turning on from there ends level in the ideal motion u' = u × ω, and never leads away from it.
        let mut u = up(&truth);
        for _ in 0..6000 {
            let rates = Vector3::from(level_rates(f32s(u)).map(f64::from));
            prop_assert!(rates.norm() <= 1.0001 * f64::from(LEVEL_RATE_MAX_RADPS) && rates.z == 0.0);
            let before = u.z;
            u = (u + u.cross(&rates) * 2.5e-4).normalize();
            prop_assert!(before < -0.999 || u.z >= before - 1e-6, "it turned away: {} to {}", before, u.z);
        }
        prop_assert!(u.angle(&Vector3::z()) < 0.02, "{}", u.angle(&Vector3::z()));
    }
}

proptest! {
    /// Nothing that is not a number gets in, and the estimate stays a rotation.
    #[test]
    fn any_input_leaves_a_rotation(
        steps in prop::collection::vec((prop::array::uniform7(prop::num::f32::ANY), 0usize..3), 1..60),
    ) {
        let mut estimate = AttitudeEstimate::new();
        for ([x, y, z, ax, ay, az, dt], motion) in steps {
            let motion = [Motion::MotorsOff, Motion::Flying, Motion::Maneuver][motion];
            estimate.update([x, y, z], [ax, ay, az], dt, motion);
            estimate.update([1e30, -1e30, 3.0], [ax, ay, az], 1.0, motion);
            estimate.update([0.0; 3], [ax, 0.0, 9.81], 0.1, motion);
            prop_assert!((norm(&estimate) - 1.0).abs() < 1e-3, "{}", norm(&estimate));
            prop_assert!(estimate.tilt_rad().is_finite() && estimate.descent_thrust_mps2().is_finite());
            prop_assert!(estimate.level_rates().iter().all(|r| r.abs() <= LEVEL_RATE_MAX_RADPS));
        }
    }
}

/// A full flip with a gyro that is 0.5 % off.
#[test]
fn a_flip_leaves_little() {
    let mut estimate = AttitudeEstimate::new();
    estimate.update([0.0; 3], REST, TICK_S as f32, Motion::MotorsOff);
    let ticks = (core::f64::consts::TAU / 10.0 / TICK_S) as usize;
    let rate = (1.005 * core::f64::consts::TAU / (ticks as f64 * TICK_S)) as f32;
    estimate.update([0.0, rate, 0.0], REST, 0.0, Motion::Maneuver);
    for _ in 0..ticks {
        // In a flip the accelerometer shows thrust along z, whatever the tilt.
        estimate.update([0.0, rate, 0.0], [0.0, 0.0, 9.81], TICK_S as f32, Motion::Maneuver);
    }
    let tilt = estimate.tilt_rad();
    assert!(tilt < 0.05 && (tilt - 0.005 * core::f32::consts::TAU).abs() < 1e-3, "{tilt}");
}

/// What gravity in flight is for and what it costs: a wrong bias is bounded, a lean is not taken for level.
#[test]
fn gravity_in_flight_is_believed_a_little() {
    let level = || {
        let mut estimate = AttitudeEstimate::new();
        estimate.update([0.0; 3], REST, TICK_S as f32, Motion::MotorsOff);
        estimate
    };
    let mut estimate = level();
    // Ten minutes of hover with a bias of 1 mrad/s: 0.6 rad without gravity.
    for _ in 0..480_000 {
        estimate.update([1.0e-3, 0.0, 0.0], REST, TICK_S as f32, Motion::Flying);
    }
    // The vehicle is level all the while; the estimate leans by bias over gain.
    assert!((estimate.tilt_rad() - 0.05).abs() < 5e-3, "{}", estimate.tilt_rad());
    // A lean of 0.3 rad for 3 s: thrust along z all the while.
    let mut estimate = level();
    for i in 0..2640 {
        let rate = if i < 240 { 1.0 } else { 0.0 };
        let thrust = [0.0, 0.0, (GRAVITY_MPS2 / 0.3f64.cos()) as f32];
        estimate.update([0.0, rate, 0.0], thrust, TICK_S as f32, Motion::Flying);
    }
    assert!((0.27..0.301).contains(&estimate.tilt_rad()), "{}", estimate.tilt_rad());
    // Not while it accelerates, and not in a maneuver.
    for (motion, force) in [(Motion::Flying, 11.0), (Motion::Maneuver, GRAVITY_MPS2 as f32)] {
        let before = estimate.up_in_body();
        for _ in 0..800 {
            estimate.update([0.0; 3], [0.0, 0.0, force], TICK_S as f32, motion);
        }
        let after = estimate.up_in_body();
        assert!(before.iter().zip(after).all(|(a, b)| (a - b).abs() < 1e-4), "{before:?} {after:?}");
    }
}

#[test]
fn thrust_for_a_descent_holds_the_vertical_part_and_then_lets_go() {
    let g = GRAVITY_MPS2 as f32;
    for tilt in [0.0f32, 0.3, 0.7, 1.0] {
        let up = descent_thrust_mps2(tilt.cos()) * tilt.cos();
        assert!((up - 0.95 * g).abs() < 1e-4, "{tilt}: {up}");
    }
    assert!(descent_thrust_mps2(0.0) <= 0.1001 * g && descent_thrust_mps2(-1.0) <= 0.1001 * g);
    assert!(descent_thrust_mps2(f32::NAN).is_finite());
    // No jump anywhere, and never more than twice the weight.
    let mut last = descent_thrust_mps2(-1.0);
    for i in -1000..=1000 {
        let thrust = descent_thrust_mps2(i as f32 * 1e-3);
        assert!((thrust - last).abs() < 0.06 && thrust <= 1.9001 * g, "{i}: {thrust}");
        last = thrust;
    }
}

/// Exactly upside down there is a way, and always the same.
#[test]
fn upside_down_rolls_right() {
    for zero in [0.0, -0.0] {
        assert_eq!(level_rates([zero, -zero, -1.0]), [LEVEL_RATE_MAX_RADPS, 0.0, 0.0]);
    }
    assert!(level_rates([0.0, 0.0, 1.0]).iter().all(|r| *r == 0.0));
}

/// From any attitude and let go: upright within a second, on the simulated airframe with its own gyro.
#[test]
fn any_attitude_is_levelled_within_a_second() {
    let config = VehicleConfig::REFERENCE;
    let mut draw = 12345u64;
    let mut uniform = || {
        draw = draw.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (draw >> 11) as f64 / (1u64 << 53) as f64
    };
    let mut slowest = 0.0f64;
    for case in 0..200 {
        // Uniform over all rotations (Shoemake), and one exactly upside down.
        let (a, b, c) = (uniform(), uniform() * std::f64::consts::TAU, uniform() * std::f64::consts::TAU);
        let (p, q) = (a.sqrt(), (1.0 - a).sqrt());
        let random = [p * c.cos(), q * b.sin(), q * b.cos(), p * c.sin()];
        let attitude = if case == 0 { [0.0, 1.0, 0.0, 0.0] } else { random };
        let mut parameters = VehicleParameters::nominal();
        // The bias is learned on the ground before.
        parameters.gyro.bias_radps = 0.0;
        let start = Start { height_m: 200.0, ..Start::default() };
        let mut simulator = Simulator::new(&parameters, case, 0.0, start).expect("sound");
        simulator.let_go(attitude);
        let [w, x, y, z] = attitude;
        let truth = UnitQuaternion::new_normalize(Quaternion::new(w, x, y, z));
        // What rest before the fall would have taught it.
        let mut estimate = AttitudeEstimate::new();
        for _ in 0..800 {
            estimate.update([0.0; 3], f32s(up(&truth) * GRAVITY_MPS2), TICK_S as f32, Motion::MotorsOff);
        }
        let (mut rate, mut drive) = (RateController::new(), RotorDrive::new());
        let (mut asked, mut last_ns, mut level_since) = ([0.0; 3], 0, None);
        while simulator.now_ns() < 1_500_000_000 {
            let Some((now, event)) = simulator.next_event() else { break };
            let Event::Gyro(sample) = event else { continue };
            let dt_s = ((now - last_ns) as f32 * 1e-9).min(2.5e-3);
            last_ns = now;
            estimate.update(sample.rates_radps, sample.specific_force_mps2, dt_s, Motion::Maneuver);
            let (next, thrust_mps2) = (estimate.level_rates(), estimate.descent_thrust_mps2());
            let input = RateInput {
                asked,
                next,
                measured: sample.rates_radps,
                thrust_mps2,
                dt_s,
                ..RateInput::default()
            };
            let demand = Demand { thrust_mps2, acceleration_radps2: rate.update(&config, &input) };
            let mixed = mix(&config, &demand);
            rate.limited(&mixed.saturation);
            let battery = Some(simulator.battery_v());
            let throttle = drive.throttles(&config, mixed.thrusts_n, battery, dt_s);
            simulator.apply(Command { throttle, rates_radps: next, thrust_mps2 });
            asked = next;
            if simulator.truth().tilt_rad() < 0.1 {
                level_since.get_or_insert(now);
            } else {
                level_since = None;
            }
        }
        let settled = level_since.unwrap_or(u64::MAX) as f64 * 1e-9;
        assert!(settled < 1.0, "case {case}: {settled} s from {attitude:?}");
        slowest = slowest.max(settled);
    }
    println!("slowest {slowest:.3} s");
}

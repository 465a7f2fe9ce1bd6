//! What the mixer knows of a particular vehicle: its thrust map, its battery, its wiring, its propellers; and what it says
//! of demands that the vehicle cannot meet.

use mintime_firmware::config::VehicleConfig;
use mintime_firmware::mixer::{Demand, RotorDrive, mix, speed_of_throttle, throttle_of_speed, to_outputs};
use mintime_firmware::rate_control::{RateController, RateInput};
use mintime_shared::frames::MOTORS;
use proptest::prelude::*;

const REFERENCE: VehicleConfig = VehicleConfig::REFERENCE;
const TICK_S: f32 = 1.25e-3;

/// Thrust per mass and angular acceleration by r × F and the reaction torques, in `f64`.
fn effect(config: &VehicleConfig, thrusts: [f32; 4]) -> (f64, [f64; 3]) {
    let (mut force, mut torque) = (0.0, [0.0; 3]);
    let sense = if config.reversed { -1.0 } else { 1.0 };
    for (place, f) in MOTORS.iter().zip(thrusts.map(f64::from)) {
        force += f;
        torque[0] += f64::from(place.left) * f64::from(config.arm_left_m) * f;
        torque[1] -= f64::from(place.forward) * f64::from(config.arm_forward_m) * f;
        torque[2] += sense * f64::from(place.yaw) * f64::from(config.torque_per_thrust_m) * f;
    }
    let [jx, jy, jz] = config.inertia_kgm2.map(f64::from);
    (force / f64::from(config.mass_kg), [torque[0] / jx, torque[1] / jy, torque[2] / jz])
}

/// Every way to wire four motors to four lines.
fn permutations() -> Vec<[u8; 4]> {
    let mut all = Vec::new();
    for code in 0..256u32 {
        let lines = [code & 3, code >> 2 & 3, code >> 4 & 3, code >> 6 & 3].map(|l| l as u8);
        if (0..4).all(|l| lines.contains(&l)) {
            all.push(lines);
        }
    }
    all
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    /// The thrust map and its inverse, both ways, for any share.
    #[test]
    fn the_map_and_its_inverse_are_one(share in 0f32..=1.0, throttle in 0f32..=1.0) {
        let speed = speed_of_throttle(share, throttle);
        prop_assert!((throttle_of_speed(share, speed) - throttle).abs() < 2e-6, "{} {}", share, throttle);
        // Against the formula itself, in f64.
        let (a, u) = (f64::from(share), f64::from(throttle));
        prop_assert!((f64::from(speed).powi(2) - ((1.0 - a) * u * u + a * u)).abs() < 1e-6);
        let back = throttle_of_speed(share, throttle);
        prop_assert!((speed_of_throttle(share, back) - throttle).abs() < 2e-6 && (0.0..=1.0).contains(&back));
        // Nothing changes for a vehicle whose thrust is all square.
        prop_assert_eq!(throttle_of_speed(0.0, throttle).to_bits(), throttle.to_bits());
    }

    /// In steady state the map, written down in f64, gives the thrust that was asked for.
    #[test]
    fn steady_thrust_is_what_was_asked_for(
        share in 0f32..=1.0, thrusts in prop::array::uniform4(0.1875f32..5.0), volts in 14f32..17.0,
    ) {
        let config = VehicleConfig { thrust_linear_share: share, ..REFERENCE };
        let mut drive = RotorDrive::new();
        let mut throttle = [0.0; 4];
        for _ in 0..800 {
            throttle = drive.throttles(&config, thrusts, Some(volts), TICK_S);
        }
        for (u, thrust) in throttle.iter().zip(thrusts) {
            let (a, u) = (f64::from(share), f64::from(*u));
            let ratio = f64::from(volts) / f64::from(config.battery_nominal_v);
            let given = f64::from(config.rotor_thrust_max_n) * ((1.0 - a) * u * u + a * u) * ratio * ratio;
            prop_assert!((given - f64::from(thrust)).abs() < 2e-3, "{} for {}", given, thrust);
        }
    }

    /// What the mixer says it gives is what the rotors give, and it owns up to every shortfall.
    #[test]
    fn the_report_is_true(
        thrust in -5f32..60.0,
        acceleration in prop_oneof![prop::array::uniform3(-900f32..900.0), prop::array::uniform3(-30f32..30.0)],
        reversed: bool,
    ) {
        let config = VehicleConfig { reversed, ..REFERENCE };
        let mixed = mix(&config, &Demand { thrust_mps2: thrust, acceleration_radps2: acceleration });
        let (given, turned) = effect(&config, mixed.thrusts_n);
        let said = mixed.saturation;
        prop_assert!((given - f64::from(said.achieved_mps2)).abs() < 1e-3, "{} {:?}", given, said);
        prop_assert_eq!(said.thrust, (given - f64::from(thrust)).abs() > 1e-4 || said.thrust);
        if !said.thrust {
            prop_assert!((given - f64::from(thrust)).abs() < 1e-4, "thrust is kept where nothing saturates");
        }
        for axis in 0..3 {
            let (turned, want) = (turned[axis], f64::from(acceleration[axis]));
            prop_assert!((turned - f64::from(said.achieved_radps2[axis])).abs() < 0.02, "{:?}", said);
            if !said.axes[axis] {
                prop_assert!((turned - want).abs() < 0.02, "axis {}: {} of {}", axis, turned, want);
            } else {
                prop_assert!(turned.abs() <= want.abs() + 0.02, "axis {}: {} of {}", axis, turned, want);
            }
        }
    }

    /// Every line carries exactly one motor's value, whatever the wiring, and it is that motor's.
    #[test]
    fn wiring_is_applied_once(which in 0usize..24, values in prop::array::uniform4(0f32..1.0)) {
        let outputs = permutations()[which];
        let config = VehicleConfig { outputs, ..REFERENCE };
        prop_assert!(config.check().is_ok());
        let lines = to_outputs(&config, values);
        for place in 0..4 {
            prop_assert_eq!(lines[usize::from(outputs[place])], values[place]);
        }
        // The opposite wiring leads back.
        let mut inverse = [0; 4];
        for (place, line) in outputs.iter().enumerate() {
            inverse[usize::from(*line)] = place as u8;
        }
        prop_assert_eq!(to_outputs(&VehicleConfig { outputs: inverse, ..REFERENCE }, lines), values);
        prop_assert_eq!(to_outputs(&REFERENCE, values), values);
    }

    /// Two motors on a line, or a line that does not exist, are found out, and nothing panics.
    #[test]
    fn bad_wiring_is_found_out(outputs in prop::array::uniform4(prop::num::u8::ANY)) {
        let config = VehicleConfig { outputs, ..REFERENCE };
        prop_assert_eq!(config.check().is_ok(), permutations().contains(&outputs));
        to_outputs(&config, [1.0; 4]);
    }
}

#[test]
fn impossible_models_are_found_out_and_each_is_another_vehicle() {
    for bad in [-0.1, 1.1, f32::NAN] {
        assert!(VehicleConfig { thrust_linear_share: bad, ..REFERENCE }.check().is_err());
        assert!(VehicleConfig { sag_v_per_n: bad, ..REFERENCE }.check().is_err());
    }
    let others = [
        VehicleConfig { thrust_linear_share: 0.2, ..REFERENCE },
        VehicleConfig { sag_v_per_n: 0.02, ..REFERENCE },
        VehicleConfig { outputs: [1, 0, 2, 3], ..REFERENCE },
        VehicleConfig { reversed: true, ..REFERENCE },
    ];
    for (i, a) in others.iter().enumerate() {
        assert_ne!(a.hash(), REFERENCE.hash());
        assert!(others[..i].iter().all(|b| a.hash() != b.hash()));
    }
}

/// Between two measurements the voltage falls with the thrust that grows, and a new measurement is believed.
#[test]
fn the_battery_sags_ahead_of_its_measurement() {
    let config = VehicleConfig { sag_v_per_n: 0.05, ..REFERENCE };
    let (mut ahead, mut behind) = (RotorDrive::new(), RotorDrive::new());
    let both = |ahead: &mut RotorDrive, behind: &mut RotorDrive, thrust: f32, volts: f32, ticks: u32| {
        let mut throttles = (0.0, 0.0);
        for _ in 0..ticks {
            throttles.0 = ahead.throttles(&config, [thrust; 4], Some(volts), TICK_S)[0];
            throttles.1 = behind.throttles(&REFERENCE, [thrust; 4], Some(volts), TICK_S)[0];
        }
        throttles
    };
    both(&mut ahead, &mut behind, 2.0, 15.9, 400);
    let (a, b) = both(&mut ahead, &mut behind, 2.0, 16.0, 1);
    assert_eq!(a, b, "a new measurement is believed as it is");
    // 2 N a rotor to 5 N: 12 N more, 0.6 V less.
    let (a, b) = both(&mut ahead, &mut behind, 5.0, 16.0, 400);
    assert!((f64::from(a / b) - 16.0 / (16.0 - 0.05 * 12.0)).abs() < 1e-4, "{a} {b}");
    // What the next measurement says is in it already.
    let (a, b) = both(&mut ahead, &mut behind, 5.0, 15.4, 1);
    assert!((a - b).abs() < 1e-3, "{a} {b}");
    // Without a voltage it has nothing to go by.
    let (a, b) = (
        ahead.throttles(&config, [5.0; 4], None, TICK_S)[0],
        behind.throttles(&REFERENCE, [5.0; 4], None, TICK_S)[0],
    );
    assert!((a - b).abs() < 1e-2);
}

/// A torque in proportion to thrust is learned in calm flight, and at another thrust the same share of it is right at
/// once; with the axis saturated nothing is learned.
#[test]
fn the_trim_is_learned_in_calm_flight_and_kept() {
    let offset = [0.4f32, -0.9, 0.05];
    let learn = |limited: bool| {
        let mut rate = RateController::new();
        let mut spin = [0.0f32; 3];
        let mut asked = |rate: &mut RateController, thrust_mps2: f32| {
            let input = RateInput {
                measured: spin,
                thrust_mps2,
                dt_s: TICK_S,
                follow_angle: true,
                ..RateInput::default()
            };
            let demand = rate.update(&REFERENCE, &input);
            let mut report = mix(&REFERENCE, &Demand::default()).saturation;
            report.axes = [limited; 3];
            rate.limited(&report);
            for ((spin, demand), offset) in spin.iter_mut().zip(demand).zip(offset) {
                *spin += (demand + offset * thrust_mps2) * TICK_S;
            }
        };
        for _ in 0..16_000 {
            asked(&mut rate, 9.81);
        }
        let trim = rate.trim();
        rate.reset([0.0; 3]);
        assert_eq!(rate.trim(), trim, "a maneuver begins with the trim");
        let mut worst = [0.0f32; 3];
        for _ in 0..800 {
            // The thrust of a maneuver, in which nothing is learned for its rates.
            asked(&mut rate, 20.0);
            for (worst, error) in worst.iter_mut().zip(rate.angle_error_rad()) {
                *worst = worst.max(error.abs());
            }
        }
        rate.rest([0.0; 3]);
        assert_eq!(rate.trim(), [0.0; 3]);
        (trim, worst)
    };
    let (trim, worst) = learn(false);
    for axis in 0..2 {
        assert!((trim[axis] + offset[axis]).abs() < 0.02, "{trim:?}");
        assert!(worst[axis] < 2e-3, "{worst:?}");
    }
    let (trim, worst) = learn(true);
    assert_eq!(trim, [0.0; 3]);
    assert!(worst[1] > 0.03, "without it the vehicle leaves its plan: {worst:?}");
}

/// An axis at its limit winds nothing up, unless its angle is owed to a plan; and it unwinds at any time.
#[test]
fn a_saturated_axis_winds_up_only_what_is_owed() {
    let after = |follow_angle: bool| {
        let mut rate = RateController::new();
        let asked = [3.0, -3.0, 1.0];
        for _ in 0..40 {
            let input = RateInput {
                asked,
                next: asked,
                dt_s: TICK_S,
                thrust_mps2: 9.81,
                follow_angle,
                ..RateInput::default()
            };
            rate.update(&REFERENCE, &input);
            let mut report = mix(&REFERENCE, &Demand::default()).saturation;
            report.axes = [true, false, true];
            rate.limited(&report);
        }
        let wound = rate.angle_error_rad();
        // The other way round it unwinds, limit or not.
        let input = RateInput {
            measured: asked.map(|a| 3.0 * a),
            dt_s: TICK_S,
            follow_angle,
            ..RateInput::default()
        };
        rate.update(&REFERENCE, &input);
        assert!(rate.angle_error_rad()[1].abs() < wound[1].abs());
        wound
    };
    let (free, owed) = (after(false), after(true));
    // The first step is taken before anything is known of a limit.
    assert!(free[0].abs() < 0.002 && free[2].abs() < 0.002, "{free:?}");
    assert!(free[1] < -0.08 && owed[0] > 0.08 && owed[1] == free[1], "{free:?} {owed:?}");
}

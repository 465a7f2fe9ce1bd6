//! From demands to rotor thrusts to throttles, judged by the forces and torques that the rotors then make.

use mintime_firmware::config::control::TRIM_BOUND;
use mintime_firmware::config::{INTEGRAL_BOUND_RAD, VehicleConfig, YAW_RESERVE};
use mintime_firmware::mixer::{Demand, RotorDrive, mix, rotor_thrusts};
use mintime_firmware::rate_control::{RateController, RateInput};
use mintime_shared::frames::MOTORS;
use proptest::prelude::*;

const VEHICLE: VehicleConfig = VehicleConfig::REFERENCE;

/// Thrust per mass (m/s²) and angular acceleration (rad/s²) that four rotor thrusts give: r × F and the reaction
/// torques, in `f64`.
fn effect(thrusts: [f32; 4]) -> (f64, [f64; 3]) {
    let (mut force, mut torque) = (0.0, [0.0; 3]);
    for (place, f) in MOTORS.iter().zip(thrusts.map(f64::from)) {
        let x = f64::from(place.forward) * f64::from(VEHICLE.arm_forward_m);
        let y = f64::from(place.left) * f64::from(VEHICLE.arm_left_m);
        force += f;
        torque[0] += y * f;
        torque[1] -= x * f;
        torque[2] += f64::from(place.yaw) * f64::from(VEHICLE.torque_per_thrust_m) * f;
    }
    let [jx, jy, jz] = VEHICLE.inertia_kgm2.map(f64::from);
    (force / f64::from(VEHICLE.mass_kg), [torque[0] / jx, torque[1] / jy, torque[2] / jz])
}

fn mixed(thrust_mps2: f32, acceleration_radps2: [f32; 3]) -> [f32; 4] {
    rotor_thrusts(&VEHICLE, &Demand { thrust_mps2, acceleration_radps2 })
}

/// By how much roll, pitch and yaw each move a rotor, N.
fn shares(acceleration: [f32; 3]) -> [f64; 3] {
    let arms = [VEHICLE.arm_left_m, VEHICLE.arm_forward_m, VEHICLE.torque_per_thrust_m];
    std::array::from_fn(|i| {
        f64::from(VEHICLE.inertia_kgm2[i]) * f64::from(acceleration[i]) / (4.0 * f64::from(arms[i]))
    })
}

fn low() -> f64 {
    f64::from(VEHICLE.rotor_thrust_idle_n)
}

fn high() -> f64 {
    f64::from(VEHICLE.rotor_thrust_max_n)
}

fn near(got: f64, want: f64, scale: f64) -> bool {
    (got - want).abs() <= 2e-5 * scale
}

fn demand() -> impl Strategy<Value = (f32, [f32; 3])> {
    (
        -20f32..80.0,
        prop_oneof![
            prop::array::uniform3(-1500f32..1500.0),
            prop::array::uniform3(-150f32..150.0),
            prop::array::uniform3(-15f32..15.0)
        ],
    )
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(3000))]

    #[test]
    fn thrusts_are_finite_and_in_range_for_any_demand(
        thrust in prop::num::f32::ANY, acceleration in prop::array::uniform3(prop::num::f32::ANY),
    ) {
        for f in mixed(thrust, acceleration).map(f64::from) {
            prop_assert!((low()..=high()).contains(&f), "{}", f);
        }
    }

    /// What the rotors can give, less the reserve for yaw, is given exactly.
    #[test]
    fn demands_within_reach_are_met(
        thrust in 1f32..44.0, direction in prop::array::uniform3(-1f32..1.0), part in 0f64..0.95,
    ) {
        let collective = f64::from(thrust * VEHICLE.mass_kg) / 4.0;
        let room = (collective - low()).min(high() - collective).max(0.0) * part;
        // Scaled so that all three together fill a part of the room.
        let used: f64 = shares(direction).iter().map(|s| s.abs()).sum();
        let scale = (room / used) as f32;
        let acceleration = direction.map(|a| a * scale);
        let (given, turned) = effect(mixed(thrust, acceleration));
        prop_assert!(near(given, f64::from(thrust), 45.0), "{} {}", given, thrust);
        for ((got, want), scale) in turned.iter().zip(acceleration).zip([400.0, 300.0, 45.0]) {
            prop_assert!(near(*got, f64::from(want), scale), "{:?} {:?}", turned, acceleration);
        }
    }

    /// Roll and pitch keep their direction always, and their size where they fit the range less the reserve for yaw.
    #[test]
    fn roll_and_pitch_outlast_saturation((thrust, acceleration) in demand()) {
        let [roll, pitch, _] = shares(acceleration);
        let fits = (high() - low()) * (1.0 - f64::from(YAW_RESERVE));
        let asked = 2.0 * (roll.abs() + pitch.abs());
        let scale = (fits / asked).min(1.0);
        let (_, [ax, ay, _]) = effect(mixed(thrust, acceleration));
        prop_assert!(near(ax, scale * f64::from(acceleration[0]), 400.0), "{} of {:?}", ax, acceleration);
        prop_assert!(near(ay, scale * f64::from(acceleration[1]), 300.0), "{} of {:?}", ay, acceleration);
    }

    /// Yaw never grows or turns round, and thrust gives way to it by no more than the reserve.
    #[test]
    fn yaw_gives_way_first((thrust, acceleration) in demand()) {
        let [ax, ay, az] = acceleration;
        let (given, [.., turned]) = effect(mixed(thrust, acceleration));
        let asked = f64::from(az);
        prop_assert!(turned * asked >= -1e-3 && turned.abs() <= asked.abs() + 1e-3, "{} of {}", turned, asked);
        let (without, _) = effect(mixed(thrust, [ax, ay, 0.0]));
        let reserve = 2.0 * f64::from(YAW_RESERVE) * (high() - low()) / f64::from(VEHICLE.mass_kg);
        prop_assert!((given - without).abs() <= reserve + 1e-4, "{} without yaw, {} with", without, given);
        // Enough of it is left to hold a heading whatever roll, pitch and thrust ask for: half the reserve a rotor.
        let floor = (0.49 * f64::from(YAW_RESERVE) * (high() - low())).min(shares(acceleration)[2].abs());
        prop_assert!(shares([0.0, 0.0, turned as f32])[2].abs() >= floor - 1e-4, "{} of {}", turned, asked);
    }

    /// Without yaw, thrust is the nearest to the wanted that roll and pitch leave possible.
    #[test]
    fn thrust_gives_way_no_more_than_it_must((thrust, [ax, ay, _]) in demand()) {
        let thrusts = mixed(thrust, [ax, ay, 0.0]);
        let (given, _) = effect(thrusts);
        let wanted = f64::from(thrust);
        let lowest = thrusts.iter().copied().fold(f32::INFINITY, f32::min);
        let highest = thrusts.iter().copied().fold(f32::NEG_INFINITY, f32::max);
        let stuck_low = near(f64::from(lowest), low(), 8.5);
        let stuck_high = near(f64::from(highest), high(), 8.5);
        prop_assert!(
            near(given, wanted, 45.0) || (given > wanted && stuck_low) || (given < wanted && stuck_high),
            "{} of {}: {:?}", given, wanted, thrusts
        );
    }

    #[test]
    fn throttles_are_in_range_for_any_input(
        steps in prop::collection::vec((prop::array::uniform4(prop::num::f32::ANY), prop::option::of(prop::num::f32::ANY)), 1..20),
        dt_s in prop_oneof![0f32..0.0025, prop::num::f32::NORMAL],
    ) {
        let mut drive = RotorDrive::new();
        for (thrusts, battery) in steps {
            for throttle in drive.throttles(&VEHICLE, thrusts, battery, dt_s) {
                prop_assert!((0.0..=1.0).contains(&throttle), "{}", throttle);
            }
        }
        // And it comes back from whatever it was fed.
        let wanted = [2.0; 4];
        let mut throttle = [0.0; 4];
        for _ in 0..2000 {
            throttle = drive.throttles(&VEHICLE, wanted, Some(14.8), 1.25e-3);
        }
        prop_assert!(throttle.iter().all(|t| (t - (2.0f32 / 8.5).sqrt()).abs() < 1e-4), "{:?}", throttle);
    }

    /// Below a cap no rotor is ever told to turn faster than the cap's own thrust needs, however the thrusts jump.
    #[test]
    fn nothing_leads_beyond_the_cap(
        cap_n in 0.25f32..8.5, shares in prop::collection::vec(prop::array::uniform4(0f32..=1.0), 1..60),
        volts in prop::option::of(13.0f32..16.8), dt_s in 0f32..0.0025,
    ) {
        let mut drive = RotorDrive::new();
        let compensation = 14.8 / volts.unwrap_or(14.8);
        let most = (f64::from(cap_n) / 8.5).sqrt() * f64::from(compensation);
        for share in shares {
            let thrusts = share.map(|share| share * cap_n);
            for throttle in drive.throttles_below(&VEHICLE, thrusts, volts, dt_s, cap_n) {
                prop_assert!(f64::from(throttle) <= most * (1.0 + 1e-5), "{} for {}", throttle, most);
            }
        }
    }

    /// At rest the throttle is the square root of the thrust's share, times nominal over actual voltage.
    #[test]
    fn steady_throttle_is_the_square_root_map(
        thrusts in prop::array::uniform4(0.125f32..8.4), battery in prop::option::of(12.0f32..17.0),
    ) {
        let mut drive = RotorDrive::new();
        let mut throttle = [0.0; 4];
        for _ in 0..800 {
            throttle = drive.throttles(&VEHICLE, thrusts, battery, 1.25e-3);
        }
        for (throttle, thrust) in throttle.iter().zip(thrusts) {
            let compensation = 14.8 / f64::from(battery.unwrap_or(14.8));
            let want = (f64::from(thrust) / 8.5).sqrt() * compensation;
            prop_assert!((f64::from(*throttle) - want.min(1.0)).abs() < 1e-4, "{} for {}", throttle, want);
        }
    }

    /// An implausible voltage is not compensated for.
    #[test]
    fn an_implausible_voltage_is_ignored(battery in prop_oneof![
        -1e3f32..8.8, 20.8f32..1e6, Just(f32::NAN), Just(f32::INFINITY), Just(0.0)
    ]) {
        let mut with = RotorDrive::new();
        let mut without = RotorDrive::new();
        for _ in 0..10 {
            let (a, b) = (
                with.throttles(&VEHICLE, [3.0; 4], Some(battery), 1.25e-3),
                without.throttles(&VEHICLE, [3.0; 4], None, 1.25e-3),
            );
            prop_assert_eq!(a, b);
        }
    }

    /// The rate loop's demand is finite and its memory bounded, whatever it is told.
    #[test]
    fn the_rate_loop_takes_any_input(
        steps in prop::collection::vec((prop::array::uniform9(prop::num::f32::ANY), prop::num::f32::ANY), 1..30),
    ) {
        let mut loop_ = RateController::new();
        for ([a, b, c, d, e, f, g, h, i], dt) in steps {
            let input = RateInput {
                asked: [a, b, c], next: [d, e, f], measured: [g, h, i], thrust_mps2: a, dt_s: dt,
                follow_angle: dt > a,
            };
            loop_.update(&VEHICLE, &input);
            prop_assert!(loop_.trim().iter().all(|t| t.abs() <= TRIM_BOUND), "{:?}", loop_.trim());
            let errors = loop_.angle_error_rad();
            prop_assert!(errors.iter().all(|e| e.abs() <= INTEGRAL_BOUND_RAD), "{:?}", errors);
        }
        loop_.rest([0.0; 3]);
        prop_assert_eq!(loop_.update(&VEHICLE, &RateInput { dt_s: 1.25e-3, ..RateInput::default() }), [0.0; 3]);
    }
}

/// The axes one by one, in words: which rotors speed up for what.
#[test]
fn signs_axis_by_axis() {
    // Motors 1 to 4: rear right, front right, rear left, front left.
    let louder = |acceleration: [f32; 3]| {
        let rest = mixed(9.81, [0.0; 3])[0];
        mixed(9.81, acceleration).map(|f| f > rest)
    };
    assert_eq!(louder([20.0, 0.0, 0.0]), [false, false, true, true], "rolling right lifts the left");
    assert_eq!(louder([0.0, 20.0, 0.0]), [true, false, true, false], "nose down lifts the rear");
    // 1 and 4 turn clockwise, so they push the body counter-clockwise.
    assert_eq!(
        louder([0.0, 0.0, 5.0]),
        [true, false, false, true],
        "yawing left speeds up the clockwise rotors"
    );
    // The rate loop in front of it: slower than asked means more of the same.
    for axis in 0..3 {
        let mut next = [0.0; 3];
        next[axis] = 1.0;
        let input = RateInput { next, dt_s: 1.25e-3, ..RateInput::default() };
        let demand = RateController::new().update(&VEHICLE, &input);
        let turned = effect(mixed(9.81, demand)).1;
        for (i, t) in turned.iter().enumerate() {
            assert!(if i == axis { *t > 1.0 } else { t.abs() < 1e-3 }, "axis {axis}: {turned:?}");
        }
    }
}

/// A demand that is no number is no torque, and hover.
#[test]
fn nonsense_demands_hover() {
    let hover = mixed(9.81, [0.0; 3]);
    for bad in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
        assert_eq!(mixed(bad, [0.0; 3]), hover);
        assert_eq!(mixed(9.81, [bad; 3]), hover);
    }
}

/// The lag of the rotors is made up for: the model reaches a step within a few response times, not lags.
#[test]
fn the_drive_leads_the_rotors() {
    let mut drive = RotorDrive::new();
    for _ in 0..800 {
        drive.throttles(&VEHICLE, [1.0; 4], None, 1.25e-3);
    }
    let (from, to) = ((1.0f32 / 8.5).sqrt(), (2.0f32 / 8.5).sqrt());
    let first = drive.throttles(&VEHICLE, [2.0; 4], None, 1.25e-3)[0];
    assert!((first - (from + 3.3 * (to - from))).abs() < 1e-4, "{first}");
    // A real rotor behind it, first order: within 5 % of the step after 30 ms.
    let mut speed = f64::from(from);
    let mut throttle = first;
    for _ in 0..24 {
        speed += (f64::from(throttle) - speed) * (1.25e-3 / 0.033);
        throttle = drive.throttles(&VEHICLE, [2.0; 4], None, 1.25e-3)[0];
    }
    assert!((speed - f64::from(to)).abs() < 0.05 * f64::from(to - from), "{speed} for {to}");
}

/// Roll, pitch or lift that falls short is a limit, each by itself; yaw that does, and thrust above what is asked, is none.
#[test]
fn what_counts_as_the_rotors_limit() {
    let hover = 9.81;
    let (much, most) = (2000.0, 4.0 * VEHICLE.rotor_thrust_max_n / VEHICLE.mass_kg);
    for (thrust_mps2, acceleration_radps2, limit) in [
        (hover, [0.0, 0.0, 0.0], false),
        (hover, [20.0, 20.0, 1.0], false),
        (hover, [much, 0.0, 0.0], true),
        (hover, [-much, 0.0, 0.0], true),
        (hover, [0.0, much, 0.0], true),
        (hover, [0.0, -much, 0.0], true),
        (hover, [0.0, 0.0, much], false),
        (0.0, [0.0; 3], false),
        (most, [0.0; 3], false),
        (most * 1.05, [0.0; 3], false),
        (most * 1.06, [0.0; 3], true),
    ] {
        let saturation = mix(&VEHICLE, &Demand { thrust_mps2, acceleration_radps2 }).saturation;
        assert_eq!(saturation.is_limit(thrust_mps2), limit, "{thrust_mps2} {acceleration_radps2:?}");
    }
}

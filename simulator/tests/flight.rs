//! Ground, battery, and the reserve of thrust.

use mintime_simulator::{Command, Simulator, Start, Truth, VehicleParameters};
use proptest::prelude::*;

const MS: u64 = 1_000_000;

fn command(throttle: f32) -> Command {
    Command { throttle: [throttle; 4], ..Command::OFF }
}

/// All rotors alike, so that equal throttles neither roll nor pitch.
fn even() -> VehicleParameters {
    let mut vehicle = VehicleParameters::nominal();
    vehicle.rotors.thrust_error = 0.0;
    vehicle
}

#[test]
fn the_ground_holds_the_vehicle_until_thrust_lifts_it() {
    let start = Start { x_m: 1.0, y_m: 2.0, heading_rad: 0.7, ..Start::default() };
    let mut simulator = Simulator::new(&VehicleParameters::nominal(), 2, -0.3, start).unwrap();
    let before = simulator.truth();
    assert!(before.on_ground && (before.heading_rad() - 0.7).abs() < 1e-12);
    simulator.apply(command(0.3));
    simulator.advance_to(1000 * MS);
    let held = simulator.truth();
    assert!(held.on_ground && held.thrust_mps2 > 3.0 && held.thrust_mps2 < 9.81);
    assert_eq!((held.position_m, held.attitude), ([1.0, 2.0, -0.3], before.attitude));
    simulator.apply(command(0.6));
    simulator.advance_to(1300 * MS);
    let up = simulator.truth();
    assert!(!up.on_ground && up.position_m[2] > -0.2 && up.contacts == 0);
}

/// Flies up for a while, cuts the motors, and looks after the touch-down.
fn drop_after(climb_ms: u64) -> Truth {
    let mut simulator = Simulator::new(&even(), 2, 0.0, Start::default()).unwrap();
    simulator.apply(command(0.5));
    simulator.advance_to(climb_ms * MS);
    simulator.apply(Command::OFF);
    simulator.advance_to(5000 * MS);
    simulator.truth()
}

#[test]
fn a_soft_touch_down_is_a_landing_and_a_hard_one_a_crash() {
    let soft = drop_after(130);
    let contact = soft.last_contact.unwrap();
    assert!(soft.on_ground && !soft.crashed && !contact.crash && contact.speed_mps < 1.4, "{soft:?}");
    let hard = drop_after(1500);
    let contact = hard.last_contact.unwrap();
    assert!(hard.on_ground && hard.crashed && contact.crash && contact.speed_mps > 5.0, "{hard:?}");
    assert_eq!((hard.position_m[2], hard.velocity_mps), (0.0, [0.0; 3]));
}

#[test]
fn a_tilted_touch_down_is_a_crash_and_ends_the_flight() {
    let start = Start { height_m: 1.0, ..Start::default() };
    let mut simulator = Simulator::new(&even(), 2, 0.0, start).unwrap();
    simulator.apply(Command { throttle: [0.1, 0.5, 0.1, 0.5], ..Command::OFF });
    simulator.advance_to(3000 * MS);
    let wreck = simulator.truth();
    assert!(wreck.crashed && wreck.last_contact.unwrap().tilt_rad > 0.52, "{wreck:?}");
    simulator.apply(command(1.0));
    simulator.advance_to(4000 * MS);
    assert_eq!(simulator.truth().position_m, wreck.position_m);
}

#[test]
fn free_fall_follows_the_parabola() {
    let mut vehicle = even();
    vehicle.drag.body_ns2_per_m2 = [0.0; 3];
    let start = Start { height_m: 30.0, ..Start::default() };
    let mut simulator = Simulator::new(&vehicle, 2, 0.0, start).unwrap();
    simulator.advance_to(1234 * MS);
    let truth = simulator.truth();
    assert!((truth.position_m[2] - 30.0 + 0.5 * 9.81 * 1.234 * 1.234).abs() < 1e-10);
    assert!((truth.velocity_mps[2] + 9.81 * 1.234).abs() < 1e-10);
}

#[test]
fn body_drag_bounds_the_fall() {
    let start = Start { height_m: 900.0, ..Start::default() };
    let mut simulator = Simulator::new(&even(), 2, 0.0, start).unwrap();
    simulator.advance_to(20_000 * MS);
    // m g = c v²: 27.2 m/s.
    let terminal = (0.752 * 9.81 / 0.010_f64).sqrt();
    assert!((simulator.truth().velocity_mps[2] + terminal).abs() < 1e-3);
}

#[test]
fn rotors_follow_with_their_time_constant() {
    let mut vehicle = even();
    vehicle.battery.resistance_ohm = 0.0;
    vehicle.battery.full_v = 14.8;
    vehicle.battery.empty_v = 14.8;
    vehicle.rotors.time_constant_down_s = 0.05;
    let mut simulator = Simulator::new(&vehicle, 2, 0.0, Start::default()).unwrap();
    simulator.apply(command(0.3));
    simulator.advance_to(33 * MS);
    let full = 0.3_f32;
    let steady = f64::from(full) * 2332.4;
    let share = simulator.truth().rotor_speeds_radps[0] / steady;
    assert!((share - (1.0 - (-1.0_f64).exp())).abs() < 1e-6, "{share}");
    simulator.advance_to(2000 * MS);
    simulator.apply(command(0.0));
    simulator.advance_to(2050 * MS);
    let share = simulator.truth().rotor_speeds_radps[0] / steady;
    assert!((share - (-1.0_f64).exp()).abs() < 1e-6, "{share}");
}

#[test]
fn voltage_sags_under_load_recovers_and_falls_with_use() {
    let start = Start { height_m: 2.0, ..Start::default() };
    let mut simulator = Simulator::new(&even(), 2, 0.0, start).unwrap();
    let resting = simulator.battery_v();
    simulator.apply(command(1.0));
    simulator.advance_to(300 * MS);
    let loaded = simulator.battery_v();
    simulator.apply(Command::OFF);
    simulator.advance_to(2000 * MS);
    let recovered = simulator.battery_v();
    // Four rotors at some 8 N draw above 100 A.
    assert!((1.5..3.0).contains(&(resting - loaded)), "{resting} {loaded}");
    assert!(recovered < resting && resting - recovered < 0.05, "{resting} {recovered}");
}

#[test]
fn thrust_reserve_lasts_to_the_end_of_the_battery() {
    // Attitude control needs 15 % above the largest planned thrust per mass, 20 m/s².
    for charge in [1.0, 0.5, 0.0] {
        let mut vehicle = VehicleParameters::nominal();
        vehicle.battery.charge = charge;
        for seed in 0..20 {
            let start = Start { height_m: 2.0, ..Start::default() };
            let mut simulator = Simulator::new(&vehicle, seed, 0.0, start).unwrap();
            simulator.apply(command(1.0));
            simulator.advance_to(400 * MS);
            let thrust = simulator.truth().thrust_mps2;
            assert!((23.0..60.0).contains(&thrust), "{charge} {seed} {thrust}");
        }
    }
}

#[test]
fn helper_throttle_hovers() {
    let vehicle = even();
    let start = Start { height_m: 2.0, ..Start::default() };
    let mut simulator = Simulator::new(&vehicle, 2, 0.0, start).unwrap();
    for k in 1..2000 {
        let throttle = vehicle.throttle(9.81, f64::from(simulator.battery_v()));
        simulator.apply(command(throttle as f32));
        simulator.advance_to(k * MS);
    }
    assert!((simulator.truth().thrust_mps2 - 9.81).abs() < 1e-3, "{:?}", simulator.truth());
}

/// Bit patterns of every kind: subnormal, huge, infinite, NaN.
fn any_f32() -> impl Strategy<Value = f32> {
    prop_oneof![any::<u32>().prop_map(f32::from_bits), 0.0f32..=1.0, Just(0.0), Just(1.0)]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    #[test]
    fn no_command_ever_yields_nan(
        ideal: bool,
        seed: u64,
        height in 0.0f64..30.0,
        commands in prop::collection::vec(
            (prop::array::uniform4(any_f32()), prop::array::uniform3(any_f32()), any_f32(), 1u64..300), 1..10)
    ) {
        let vehicle = if ideal { VehicleParameters::ideal() } else { VehicleParameters::nominal() };
        let start = Start { height_m: height, ..Start::default() };
        let mut simulator = Simulator::new(&vehicle, seed, 0.0, start).unwrap();
        let mut now = 0;
        for (throttle, rates_radps, thrust_mps2, ms) in commands {
            simulator.apply(Command { throttle, rates_radps, thrust_mps2 });
            now += ms * MS;
            simulator.advance_to(now);
            let truth = simulator.truth();
            let planar = truth.planar(0.3);
            prop_assert!(truth.position_m.iter().chain(&truth.velocity_mps).chain(&truth.attitude)
                .chain(&truth.rates_radps).chain(&truth.rotor_speeds_radps).all(|v| v.is_finite()), "{truth:?}");
            prop_assert!(planar.to_array().iter().all(|v| v.is_finite()));
            prop_assert!(truth.battery_v > 5.0 && truth.thrust_mps2 >= 0.0 && truth.position_m[2] >= 0.0);
            prop_assert!((truth.attitude.iter().map(|q| q * q).sum::<f64>() - 1.0).abs() < 1e-9);
        }
        while simulator.next_event_time_ns() <= now {
            let (time, _) = simulator.next_event().unwrap();
            prop_assert!(time <= now);
        }
    }
}

//! A recovery tick by tick: what it does tilted, tipped over, on the ground, and with a sensor that says nothing.

mod logic;

use logic::{Bench, FRESH_TICKS, HOVER, TICK_US};
use mintime_firmware::config::{
    RECOVERY_FORCE, RECOVERY_LOW_THRUST_MPS2, RECOVERY_RANGE, RECOVERY_SETTLES_S, RECOVERY_STANDS,
    RECOVERY_STANDS_S, RECOVERY_UPRIGHT_COS,
};
use mintime_firmware::gyro::ImuSample;
use mintime_shared::messages::{FlightState, Reply, Request, Setpoint};

/// Thrust of a level recovery, m/s².
const SINKS_MPS2: f32 = RECOVERY_FORCE * 9.81;
const SETTLES_TICKS: usize = (RECOVERY_SETTLES_S * 800.0) as usize;
const STANDS_TICKS: usize = (RECOVERY_STANDS_S * 800.0) as usize;

/// Turns by rates that nobody asked for, a blow, until the tilt's cosine is so low.
fn tip(bench: &mut Bench, until: f32) {
    loop {
        let mut sample = bench.sample();
        sample.gyro_radps[0] += 20.0;
        let number = bench.number + 1;
        bench.tick_with(Some(sample), TICK_US, &[Request::Status]);
        let Some(Reply::Status(status)) = bench.answer(number) else { panic!("no status") };
        if status.up_body[2] < until {
            return;
        }
    }
}

/// An accelerometer with an axis that says nothing is not believed on the others.
#[test]
fn a_recovery_goes_by_whole_samples() {
    for (sideways_mps2, up_mps2, adjusts) in [
        (0.0, 0.0, true),
        (f32::NAN, 0.0, false),
        (f32::INFINITY, 0.0, false),
        (0.0, f32::NAN, false),
        (0.0, f32::NEG_INFINITY, false),
    ] {
        let mut bench = Bench::in_state(FlightState::Recovery);
        for _ in 0..400 {
            let accel_mps2 = [sideways_mps2, 0.0, up_mps2];
            let sample = ImuSample { accel_mps2, ..bench.sample() };
            bench.tick_with(Some(sample), TICK_US, &[]);
        }
        assert_eq!(bench.logic.state(), FlightState::Recovery);
        let flown = bench.out.setpoint.thrust_mps2;
        let wanted = if adjusts { RECOVERY_RANGE.1 * SINKS_MPS2 } else { SINKS_MPS2 };
        assert!((flown - wanted).abs() < 0.01, "{sideways_mps2}, {up_mps2}: {flown} for {wanted}");
    }
}

/// However wrong the specific force, the thrust stays within its range, and comes back from its end at once.
#[test]
fn a_recoverys_thrust_keeps_to_its_range() {
    let (low, high) = RECOVERY_RANGE;
    for (force_mps2, end_mps2, back_mps2) in
        [(0.0, high * SINKS_MPS2, 30.0), (100.0, low * SINKS_MPS2, -30.0)]
    {
        let mut bench = Bench::in_state(FlightState::Recovery);
        let mut fly = |force_mps2: f32, ticks: usize| {
            for _ in 0..ticks {
                let sample = ImuSample { accel_mps2: [0.0, 0.0, force_mps2], ..bench.sample() };
                bench.tick_with(Some(sample), TICK_US, &[]);
            }
            assert_eq!(bench.logic.state(), FlightState::Recovery);
            bench.out.setpoint.thrust_mps2
        };
        let most = fly(force_mps2, SETTLES_TICKS + 100);
        assert!((most - end_mps2).abs() < 0.01, "{most} for {end_mps2}");
        let back = fly(back_mps2, 10);
        assert!((back - most).abs() > 0.5, "{most}, then {back}");
    }
}

/// Beyond 60 degrees of tilt it turns upright first, with little thrust; within it sinks.
#[test]
fn a_tilted_recovery_turns_upright_first() {
    let mut bench = Bench::flying();
    bench.stream = Some(Setpoint { rates_radps: [4.0, 0.0, 0.0], ..HOVER });
    while bench.telemetry().up_body[2] > 0.2 {
        assert!(bench.ticks < 3000);
    }
    bench.stream = None;
    bench.run_while(FlightState::Tracking, FRESH_TICKS + 10);
    let mut tilted = 0;
    loop {
        // The attitude by which the next tick steers.
        let up = bench.telemetry().up_body[2];
        if up > 0.99 {
            break;
        }
        bench.run(1);
        let Setpoint { rates_radps: [roll, ..], thrust_mps2 } = bench.out.setpoint;
        assert!(roll < 0.0, "it turns back: {roll}");
        if up < RECOVERY_UPRIGHT_COS {
            tilted += 1;
            assert_eq!(thrust_mps2, RECOVERY_LOW_THRUST_MPS2, "{up}");
        } else {
            assert!(thrust_mps2 > 0.99 * SINKS_MPS2, "{thrust_mps2} at {up}");
        }
    }
    assert!(tilted > 20, "{tilted}");
    assert_eq!(bench.logic.state(), FlightState::Recovery);
}

/// Upright again its rotors settle anew before the specific force says anything, and what it stood on counts no more.
#[test]
fn a_recovery_that_was_tipped_over_begins_anew() {
    let mut bench = Bench::in_state(FlightState::Recovery);
    bench.stands = true;
    while bench.out.setpoint.thrust_mps2 > RECOVERY_STANDS * SINKS_MPS2 {
        bench.run(1);
    }
    bench.run(STANDS_TICKS / 2);
    tip(&mut bench, RECOVERY_UPRIGHT_COS);
    while bench.telemetry().up_body[2] < RECOVERY_UPRIGHT_COS {}
    assert_eq!(bench.logic.state(), FlightState::Recovery);
    let ticks = bench.run_while(FlightState::Recovery, 1600);
    assert!(ticks.abs_diff(SETTLES_TICKS + STANDS_TICKS) < 4, "{ticks}");
    assert_eq!(bench.logic.state(), FlightState::Landed);
}

/// What was never asked to lift lies on the ground: tilted it gets what it was asked for at most, and is not righted.
#[test]
fn a_tilted_vehicle_that_never_lifted_is_left_alone() {
    let little = Setpoint { thrust_mps2: 1.5, ..HOVER };
    let mut bench = Bench::armed();
    bench.stream = Some(little);
    bench.run(20);
    assert_eq!(bench.logic.state(), FlightState::Tracking);
    tip(&mut bench, 0.3);
    bench.stream = None;
    bench.run_while(FlightState::Tracking, FRESH_TICKS + 10);
    bench.run(20);
    assert!(bench.telemetry().up_body[2] < 0.4);
    assert_eq!((bench.logic.state(), bench.out.setpoint), (FlightState::Recovery, little));
}

//! The flight logic tick by tick: what it does about each fault, and that a person stops it in every state.

mod logic;

use logic::{Bench, FRESH_TICKS, TICK_US, table};
use mintime_firmware::config::VehicleConfig;
use mintime_firmware::gyro::ImuSample;
use mintime_shared::messages::{
    AbortReason, FlightState, KillSwitch, Purpose, Refusal, Reply, Request, Setpoint,
};
use mintime_shared::settings::Settings;

const ALL_STATES: [FlightState; 9] = FlightState::ALL;

/// Samples stay away: up to seven ticks are flown through, the eighth stops the motors.
#[test]
fn missing_samples() {
    for state in [FlightState::Armed, FlightState::Tracking, FlightState::Maneuver, FlightState::Recovery] {
        for missing in 1..=8 {
            let mut bench = Bench::in_state(state);
            for _ in 0..missing {
                bench.tick_with(None, TICK_US, &[]);
            }
            let stopped = missing == 8;
            let want = if stopped { FlightState::Terminated } else { state };
            assert_eq!(bench.logic.state(), want, "{missing} missing in {state:?}");
            let telemetry = bench.telemetry();
            assert_eq!(telemetry.abort, stopped.then_some(AbortReason::GyroMissing));
            assert_eq!(telemetry.missing_samples, missing);
            bench.run(30);
            assert_eq!(bench.logic.state(), want);
        }
    }
}

/// A missing sample is recorded as missing.
#[test]
fn missing_samples_are_recorded() {
    let mut bench = Bench::maneuver();
    let before = bench.telemetry().recorded as usize;
    bench.tick_with(None, TICK_US, &[]);
    bench.run_while(FlightState::Maneuver, 2000);
    let record = bench.record();
    let missing: Vec<usize> = (0..record.len()).filter(|&i| record[i].gyro_radps.is_none()).collect();
    assert_eq!(missing, [before + 1]);
}

#[test]
fn samples_that_are_no_numbers_count_as_missing() {
    for bad in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
        for axis in 0..3 {
            let mut bench = Bench::maneuver();
            for tick in 1..=8 {
                let mut sample = bench.sample();
                sample.gyro_radps[axis] = bad;
                bench.tick_with(Some(sample), TICK_US, &[]);
                let want = if tick == 8 { FlightState::Terminated } else { FlightState::Maneuver };
                assert_eq!(bench.logic.state(), want, "{bad} tick {tick}");
            }
            assert_eq!(bench.abort(), Some(AbortReason::GyroMissing));
        }
    }
    // Where the accelerometer is broken the flight goes on: nothing flies by it.
    let mut bench = Bench::flying();
    for _ in 0..100 {
        let sample = ImuSample { accel_mps2: [f32::NAN; 3], ..bench.sample() };
        bench.tick_with(Some(sample), TICK_US, &[]);
    }
    assert_eq!(bench.logic.state(), FlightState::Tracking);
}

#[test]
fn a_saturated_gyro_stops_at_the_fourth_sample() {
    for axis in 0..3 {
        for sign in [1.0, -1.0] {
            let mut bench = Bench::flying();
            for tick in 1..=4 {
                let mut sample = bench.sample();
                sample.gyro_radps[axis] = 34.9 * sign + 1e-3 * tick as f32;
                bench.tick_with(Some(sample), TICK_US, &[]);
                let want = if tick == 4 { FlightState::Terminated } else { FlightState::Tracking };
                assert_eq!(bench.logic.state(), want, "axis {axis} tick {tick}");
            }
            assert_eq!(bench.abort(), Some(AbortReason::GyroSaturated));
        }
    }
    // Three are a knock.
    let mut bench = Bench::flying();
    for _ in 0..10 {
        for _ in 0..3 {
            let sample = ImuSample { gyro_radps: [34.9, 0.0, 0.0], ..bench.sample() };
            bench.tick_with(Some(sample), TICK_US, &[]);
        }
        bench.run(1);
    }
    assert_eq!(bench.logic.state(), FlightState::Tracking);
}

#[test]
fn a_frozen_gyro_stops_within_thirty_milliseconds() {
    // Just before the fast turn of (5, 5): on the slow arc before it the plan hardly asks for another rate.
    let mut bench = Bench::maneuver();
    bench.run(560);
    let frozen = bench.sample();
    let mut ticks = 0;
    while bench.logic.state() == FlightState::Maneuver {
        bench.tick_with(Some(frozen), TICK_US, &[]);
        ticks += 1;
        assert!(ticks < 60, "frozen and nobody noticed");
    }
    assert_eq!(bench.logic.state(), FlightState::Terminated);
    assert_eq!(bench.abort(), Some(AbortReason::GyroFrozen));
    assert!((24..=28).contains(&ticks), "{ticks} ticks");
}

/// In hover a noiseless gyro that shows exactly the setpoint is no frozen one.
#[test]
fn a_still_vehicle_is_not_frozen() {
    let mut bench = Bench::flying();
    for _ in 0..400 {
        let sample = ImuSample { gyro_radps: [1e-3; 3], ..bench.sample() };
        bench.tick_with(Some(sample), TICK_US, &[]);
    }
    assert_eq!(bench.logic.state(), FlightState::Tracking);
}

/// A vehicle that does not follow: 100 ms of an error beyond 8 rad/s.
#[test]
fn a_runaway_stops() {
    for state in [FlightState::Tracking, FlightState::Recovery] {
        let mut bench = Bench::in_state(state);
        let mut ticks = 0;
        while bench.logic.state() == state {
            let wobble = 1e-3 * ((bench.ticks % 5) as f32);
            let sample = ImuSample { gyro_radps: [0.0, 8.5 + wobble, 0.0], ..bench.sample() };
            bench.tick_with(Some(sample), TICK_US, &[]);
            ticks += 1;
            assert!(ticks <= 90);
        }
        assert_eq!((bench.logic.state(), ticks), (FlightState::Terminated, 80));
        assert_eq!(bench.abort(), Some(AbortReason::Runaway));
    }
    // A reversal that takes half of that is none.
    let mut bench = Bench::flying();
    for i in 0..400 {
        let rate = if i % 80 < 60 { 9.0 } else { 0.0 };
        let wobble = 1e-3 * ((i % 5) as f32);
        bench.tick_with(
            Some(ImuSample { gyro_radps: [rate + wobble, 0.0, 0.0], ..bench.sample() }),
            TICK_US,
            &[],
        );
    }
    assert_eq!(bench.logic.state(), FlightState::Tracking);
}

/// A vehicle that turns otherwise than planned gives the maneuver up: back to the host if it is there, motors off if not.
#[test]
fn off_plan_ends_the_maneuver() {
    for (axis, error_radps, limit_s) in [(0, 5.0, 0.6 / 5.0), (1, 7.0, 0.8 / 7.0), (2, -5.0, 0.6 / 5.0)] {
        for host in [true, false] {
            let mut bench = Bench::maneuver();
            if !host {
                bench.stream = None;
                bench.run(FRESH_TICKS + 10);
            }
            let mut ticks = 0;
            while bench.logic.state() == FlightState::Maneuver {
                let mut sample = bench.sample();
                sample.gyro_radps[axis] += error_radps;
                bench.tick_with(Some(sample), TICK_US, &[]);
                ticks += 1;
                assert!(ticks < 400);
            }
            let want = if host { FlightState::Tracking } else { FlightState::Recovery };
            assert_eq!(bench.logic.state(), want, "axis {axis}");
            let took_s = ticks as f32 * 1.25e-3;
            assert!((took_s - limit_s).abs() < 0.03, "axis {axis}: {took_s} s for {limit_s} s");
            let telemetry = bench.telemetry();
            assert_eq!(telemetry.abort, Some(AbortReason::OffPlan));
            assert!(!telemetry.maneuver_complete);
            assert!(telemetry.maneuver_s < table().duration_s());
        }
    }
}

#[test]
fn late_ticks_end_the_maneuver() {
    // One tick so late that eight were missed.
    let mut bench = Bench::maneuver();
    let sample = bench.sample();
    bench.tick_with(Some(sample), 9_900, &[]);
    assert_eq!(bench.logic.state(), FlightState::Maneuver, "one less is flown through");
    let sample = bench.sample();
    bench.tick_with(Some(sample), 10_000, &[]);
    assert_eq!(bench.logic.state(), FlightState::Tracking);
    let telemetry = bench.telemetry();
    assert_eq!(telemetry.abort, Some(AbortReason::LateTicks));
    assert_eq!((telemetry.late_ticks, telemetry.worst_interval_us), (2, 10_000));
    // Many that are a little late.
    let mut bench = Bench::maneuver();
    for late in 1..=40 {
        assert_eq!(bench.logic.state(), FlightState::Maneuver, "{late}");
        let sample = bench.sample();
        bench.tick_with(Some(sample), 2000, &[]);
    }
    assert_eq!(bench.logic.state(), FlightState::Tracking);
    assert_eq!(bench.abort(), Some(AbortReason::LateTicks));
    // In flight by setpoints late ticks are counted only.
    let mut bench = Bench::flying();
    for _ in 0..100 {
        let sample = bench.sample();
        bench.tick_with(Some(sample), 2000, &[]);
    }
    assert_eq!(bench.logic.state(), FlightState::Tracking);
    assert_eq!(bench.telemetry().late_ticks, 100);
}

/// With the thrust capped for the bench no rotor is told to turn faster than at its quarter of the cap, not even to get there.
#[test]
fn on_the_bench_no_throttle_leads_beyond_the_cap() {
    const CAP_MPS2: f32 = 4.0;
    let vehicle = VehicleConfig::REFERENCE;
    let mut bench = Bench::ready();
    bench.kill = KillSwitch::Absent;
    bench.stands = true;
    let settings = Settings { bench_thrust_mps2: CAP_MPS2, ..Settings::DEFAULT };
    assert_eq!(bench.ask(Request::WriteSettings(settings)), Reply::Done);
    bench.arm();
    let share = f64::from(CAP_MPS2 * vehicle.mass_kg / 4.0 / vehicle.rotor_thrust_max_n);
    let most = share.sqrt() * f64::from(vehicle.battery_nominal_v) / 15.5;
    let mut highest = 0.0;
    for step in 0..20_u8 {
        // A switch that is heard by now may stop it. It does not lift the cap.
        bench.kill = if step < 10 { KillSwitch::Absent } else { KillSwitch::Run };
        let thrust_mps2 = if step % 2 == 0 { 20.0 } else { 1.0 };
        bench.stream = Some(Setpoint { rates_radps: [0.0; 3], thrust_mps2 });
        for _ in 0..30 {
            bench.tick(&[]);
            let throttles = bench.out.throttle.expect("motors on").map(f64::from);
            highest = throttles.into_iter().fold(highest, f64::max);
        }
    }
    assert!((highest / most - 1.0).abs() < 1e-4, "{highest} for {most}");
}

/// Kill switch, emergency stop and disarm, in every state: motors off in the same tick.
#[test]
fn a_person_stops_it_in_every_state() {
    for state in ALL_STATES {
        let mut bench = Bench::in_state(state);
        assert_eq!(bench.ask(Request::EmergencyStop), Reply::Done);
        assert_eq!((bench.logic.state(), bench.out.throttle), (FlightState::Terminated, None), "{state:?}");
        assert_eq!(bench.abort(), Some(AbortReason::EmergencyStop));

        let mut bench = Bench::in_state(state);
        bench.kill = KillSwitch::Stop;
        bench.tick(&[]);
        let want = if state.motors_on() { FlightState::Terminated } else { state };
        assert_eq!((bench.logic.state(), bench.out.throttle), (want, None), "{state:?}");
        if state.motors_on() {
            assert_eq!(bench.abort(), Some(AbortReason::KillSwitch));
            // The switch must be released before an acknowledgement leads out.
            assert_eq!(bench.acknowledge(), Reply::Refused(Refusal::KillSwitch));
            bench.kill = KillSwitch::Run;
            bench.run(10);
            assert_eq!(bench.logic.state(), FlightState::Terminated);
            assert_eq!(bench.acknowledge(), Reply::Done);
            assert_eq!(bench.logic.state(), FlightState::Disarmed);
        }

        let mut bench = Bench::in_state(state);
        let (reply, want) = match state {
            FlightState::Terminated => (Reply::Refused(Refusal::WrongState(state)), state),
            // Motors off is what was asked for, and it is so.
            FlightState::Boot | FlightState::Calibrating => (Reply::Done, state),
            _ => (Reply::Done, FlightState::Disarmed),
        };
        assert_eq!(bench.ask(Request::Disarm), reply, "{state:?}");
        assert_eq!((bench.logic.state(), bench.out.throttle), (want, None), "{state:?}");
    }
}

/// Opposite wishes in one tick: the safer one wins, in either order.
#[test]
fn stops_win_over_what_comes_with_them() {
    for stop_first in [true, false] {
        let pair = |stop: Request, go: Request| if stop_first { [stop, go] } else { [go, stop] };
        let mut bench = Bench::ready();
        bench.tick(&pair(Request::Disarm, Request::Arm(Purpose::Flight)));
        assert_eq!(bench.logic.state(), FlightState::Disarmed);
        for state in [FlightState::Armed, FlightState::Tracking, FlightState::Landed] {
            let mut bench = Bench::in_state(state);
            bench.tick(&pair(Request::EmergencyStop, Request::Disarm));
            assert_eq!(bench.logic.state(), FlightState::Terminated);
        }
        // An acknowledgement that comes with another stop leads nowhere, and the next one still does.
        let mut bench = Bench::in_state(FlightState::Terminated);
        let incident = bench.telemetry().incident.expect("it waits").number;
        bench.tick(&pair(Request::EmergencyStop, Request::Acknowledge { incident }));
        assert_eq!(bench.logic.state(), FlightState::Terminated);
        assert_eq!(bench.ask(Request::Acknowledge { incident }), Reply::Done);
        assert_eq!(bench.logic.state(), FlightState::Disarmed);
        let mut bench = Bench::in_state(FlightState::Tracking);
        bench.tick(&pair(Request::EmergencyStop, Request::Trigger { checksum: table().checksum() }));
        assert_eq!(bench.logic.state(), FlightState::Terminated);
    }
}

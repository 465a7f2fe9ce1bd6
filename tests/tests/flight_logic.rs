//! The flight logic tick by tick: what it refuses, what it does about each fault, and that it does the same every time.

mod logic;

use logic::{
    BOTH, Bench, FRESH_TICKS, HOVER, Record, TICK_US, bytes_of, chunk, chunks, made_for, table, table_of,
};
use mintime_firmware::config::VehicleConfig;
use mintime_firmware::flight::{FlightLogic, Inbox, Outbox, TickInput};
use mintime_firmware::gyro::ImuSample;
use mintime_firmware::vehicle::Vehicle;
use mintime_shared::framing::encode;
use mintime_shared::messages::{
    AbortReason, ArmingBlock, FlightState, KillSwitch, Message, PROTOCOL_VERSION, Purpose, RECORD_BYTES,
    Refusal, Reply, Request, Setpoint, Uplink,
};
use mintime_shared::replay::{Plan, Replay, Step, TickPeriod};
use mintime_shared::settings::Settings;
use mintime_shared::table::{ManeuverTable, TableError};
use mintime_tests::reference_cases;

const ALL_STATES: [FlightState; 9] = FlightState::ALL;

// ---------------------------------------------------------------------------------------------------------- arming

/// A bias beyond belief is no calibration.
#[test]
fn an_incredible_bias_is_not_learned() {
    let mut bench = Bench::new();
    for _ in 0..1200 {
        let sample = bench.sample();
        let gyro_radps = sample.gyro_radps.map(|r| r + 0.2);
        bench.tick_with(Some(ImuSample { gyro_radps, ..sample }), TICK_US, &[]);
    }
    let block = ArmingBlock(bench.telemetry().arming_block);
    assert!(block.contains(ArmingBlock::NOT_CALIBRATED), "{block}");
}

/// A credible one is, and removed from what is flown by.
#[test]
fn the_bias_is_removed() {
    let mut bench = Bench::new();
    let bias = [0.05, -0.03, 0.02];
    for i in 0..1200 {
        let noise = 1e-3 * ((i % 5) as f32 - 2.0);
        let gyro_radps = bias.map(|b: f32| b + noise);
        bench.tick_with(Some(ImuSample { gyro_radps, accel_mps2: [0.0; 3] }), TICK_US, &[]);
    }
    let rates = bench.telemetry().rates_radps;
    // The last tick's sample was the bench's own, without bias.
    for (rate, bias) in rates.iter().zip(bias) {
        assert!((rate + bias).abs() < 3e-3, "{rates:?}");
    }
}

#[test]
fn armed_motors_idle_and_stop_after_thirty_seconds() {
    let mut bench = Bench::armed();
    let armed_us = bench.now_us;
    let idle = (0.035f32 / 8.5).sqrt() * 14.8 / 15.5;
    for throttle in bench.out.throttle.expect("motors on") {
        // The floor stands whatever the battery.
        assert!((throttle - idle).abs() < 5e-3, "{throttle}");
    }
    // Setpoints without thrust do not keep it awake, and do not lift.
    bench.stream = Some(Setpoint { rates_radps: [0.0; 3], thrust_mps2: 0.5 });
    bench.run_while(FlightState::Armed, 30_000);
    assert_eq!(bench.logic.state(), FlightState::Disarmed);
    assert_eq!(bench.now_us - armed_us, 30_000_000);
    assert_eq!(bench.abort(), Some(AbortReason::IdleTimeout));
    bench.stream = None;
    // It may have been moved while it was armed: it must stand still for a window again.
    assert_eq!(bench.refusal(Request::Arm(Purpose::Flight)), Refusal::ArmingBlocked(ArmingBlock::MOVING.0));
    bench.run(401);
    bench.arm();
    assert_eq!(bench.abort(), None);
}

/// A hand on the vehicle counts at once, not at the end of a window.
#[test]
fn a_vehicle_that_begins_to_move_is_not_armed() {
    let mut bench = Bench::ready();
    let mut sample = bench.sample();
    sample.gyro_radps[2] += 0.5;
    bench.tick_with(Some(sample), TICK_US, &[Request::Arm(Purpose::Flight)]);
    assert_eq!(
        bench.answer(bench.number),
        Some(Reply::Refused(Refusal::ArmingBlocked(ArmingBlock::MOVING.0)))
    );
    bench.run(300);
    assert_eq!(bench.refusal(Request::Arm(Purpose::Flight)), Refusal::ArmingBlocked(ArmingBlock::MOVING.0));
    bench.run(101);
    bench.arm();
}

/// A bias learned on a vehicle that turned slowly and evenly is unlearned when it stands.
#[test]
fn a_wrong_bias_is_learned_anew() {
    let mut bench = Bench::new();
    for _ in 0..900 {
        let mut sample = bench.sample();
        sample.gyro_radps[2] += 0.08;
        bench.tick_with(Some(sample), TICK_US, &[]);
    }
    // Standing still now reads as turning backwards.
    assert!((bench.telemetry().rates_radps[2] + 0.08).abs() < 5e-3);
    assert_eq!(bench.refusal(Request::Arm(Purpose::Flight)), Refusal::ArmingBlocked(ArmingBlock::MOVING.0));
    bench.run(800);
    assert!(bench.telemetry().rates_radps[2].abs() < 5e-3);
    bench.arm();
}

/// Every timeout hangs on the clock: one that runs backwards stops the motors, whatever they were doing.
#[test]
fn a_clock_that_runs_backwards_stops_the_motors() {
    for state in ALL_STATES {
        for back_us in [1, 10_000, 3_600_000_000] {
            let mut bench = Bench::in_state(state);
            bench.now_us = bench.now_us.saturating_sub(back_us + TICK_US);
            bench.tick(&[]);
            let motors_were_on = state.motors_on();
            let want = if motors_were_on { FlightState::Terminated } else { state };
            assert_eq!(bench.logic.state(), want, "{state:?}");
            assert_eq!(bench.out.throttle, None);
            if motors_were_on {
                assert_eq!(bench.abort(), Some(AbortReason::Clock));
            }
        }
    }
}

/// A lost link lifts nothing: a vehicle that stood on the ground goes on standing there, and soon knows that it does.
#[test]
fn a_lost_link_does_not_lift() {
    let mut bench = Bench::armed();
    bench.stands = true;
    bench.stream = Some(Setpoint { rates_radps: [0.0; 3], thrust_mps2: 1.5 });
    bench.run(40);
    assert_eq!(bench.logic.state(), FlightState::Tracking);
    bench.stream = None;
    bench.run_while(FlightState::Tracking, FRESH_TICKS + 20);
    let mut ticks = 0;
    while bench.logic.state() == FlightState::Recovery {
        // Not with a thrust map a fifth off, either.
        assert!(bench.out.setpoint.thrust_mps2 < 9.81 / 1.2, "{:?}", bench.out.setpoint);
        bench.run(1);
        ticks += 1;
    }
    assert_eq!(bench.logic.state(), FlightState::Landed);
    assert!((280..480).contains(&ticks), "{ticks} ticks");
    // From a hover it sinks.
    let mut bench = Bench::in_state(FlightState::Recovery);
    bench.run(10);
    assert!(bench.out.setpoint.thrust_mps2 < 9.81);
    // And a battery reading that disappears changes no throttle.
    let before = bench.out.throttle.expect("motors on");
    bench.battery_v = None;
    bench.run(1);
    for (a, b) in before.iter().zip(bench.out.throttle.expect("motors on")) {
        assert!((a - b).abs() < 0.02, "{a} {b}");
    }
}

#[test]
fn setpoints_beyond_sense_are_refused() {
    let good = HOVER;
    for bad in [
        Setpoint { rates_radps: [1e30, 0.0, 0.0], ..good },
        Setpoint { rates_radps: [0.0, -36.0, 0.0], ..good },
        Setpoint { thrust_mps2: -1.0, ..good },
        Setpoint { thrust_mps2: 101.0, ..good },
    ] {
        let mut bench = Bench::flying();
        assert_eq!(bench.refusal(Request::Setpoint { sequence: 9, setpoint: bad }), Refusal::OutOfRange);
        assert_eq!(bench.out.setpoint, good);
    }
}

/// A maneuver flown blind to beyond its end is no complete one.
#[test]
fn a_gap_over_the_end_is_an_abort() {
    let mut bench = Bench::maneuver();
    let sample = bench.sample();
    bench.tick_with(Some(sample), 2_000_000, &[]);
    let telemetry = bench.telemetry();
    assert_eq!(telemetry.abort, Some(AbortReason::LateTicks));
    assert!(!telemetry.maneuver_complete);
    assert!(telemetry.maneuver_missed_ticks >= 1598, "{}", telemetry.maneuver_missed_ticks);
}

#[test]
fn an_impossible_battery_voltage_counts_as_unknown() {
    let mut bench = Bench::ready();
    for volts in [9e9, 3.0, f32::INFINITY] {
        bench.battery_v = Some(volts);
        assert_eq!(
            bench.refusal(Request::Arm(Purpose::Flight)),
            Refusal::ArmingBlocked(ArmingBlock::BATTERY_UNKNOWN.0)
        );
    }
}

/// A setpoint from before arming does not lift.
#[test]
fn old_setpoints_do_not_lift() {
    let mut bench = Bench::ready();
    bench.tick(&[Request::Setpoint { sequence: 9, setpoint: HOVER }]);
    bench.arm();
    bench.run(100);
    assert_eq!(bench.logic.state(), FlightState::Armed);
    // Nor one that comes in the very tick of arming before the request.
    let mut bench = Bench::ready();
    bench.tick(&[Request::Setpoint { sequence: 9, setpoint: HOVER }, Request::Arm(Purpose::Flight)]);
    bench.run(100);
    assert_eq!(bench.logic.state(), FlightState::Armed);
}

// ---------------------------------------------------------------------------------------------------- link and time

#[test]
fn without_setpoints_it_sinks_and_then_stops() {
    let mut bench = Bench::flying();
    bench.stream = None;
    let last_us = bench.now_us;
    bench.run_while(FlightState::Tracking, 200);
    let lost_us = bench.now_us;
    assert_eq!(bench.logic.state(), FlightState::Recovery);
    assert!((100_000 - 10_000..=100_000 + 1250).contains(&(lost_us - last_us)), "{}", lost_us - last_us);
    let levels = bench.out.setpoint.rates_radps;
    assert!(levels.iter().all(|r| r.abs() < 1e-3), "level already: {levels:?}");
    assert!((8.7..8.9).contains(&bench.out.setpoint.thrust_mps2), "sinks gently");
    bench.run_while(FlightState::Recovery, 2000);
    assert_eq!(bench.logic.state(), FlightState::Terminated);
    assert_eq!(bench.now_us - lost_us, 2_000_000);
    assert_eq!(bench.abort(), Some(AbortReason::LinkLost));
    // Nothing leads out of it but an acknowledgement: neither setpoints nor a disarm.
    bench.stream = Some(HOVER);
    bench.run(100);
    assert_eq!(bench.logic.state(), FlightState::Terminated);
    assert_eq!(bench.refusal(Request::Disarm), Refusal::WrongState(FlightState::Terminated));
    assert_eq!(bench.acknowledge(), Reply::Done);
    bench.run(100);
    assert_eq!(bench.logic.state(), FlightState::Disarmed);
}

#[test]
fn the_host_may_come_back_in_time() {
    let mut bench = Bench::flying();
    bench.stream = None;
    bench.run(1200);
    assert_eq!(bench.logic.state(), FlightState::Recovery);
    bench.stream = Some(HOVER);
    bench.run(8);
    assert_eq!(bench.logic.state(), FlightState::Tracking);
    assert_eq!(bench.abort(), None);
}

/// The maneuver needs no link; after it the host gets its time to come back.
#[test]
fn a_lost_link_does_not_end_a_maneuver() {
    let mut bench = Bench::maneuver();
    bench.stream = None;
    bench.run_while(FlightState::Maneuver, 2000);
    assert_eq!(bench.logic.state(), FlightState::Recovery);
    assert!(bench.telemetry().maneuver_complete);
    bench.run(1500);
    assert_eq!(bench.logic.state(), FlightState::Recovery, "1.9 s alone");
    bench.run(120);
    assert_eq!(bench.logic.state(), FlightState::Terminated);
}

// ------------------------------------------------------------------------------------------------------------ tables

#[test]
fn with_motors_on_no_upload_changes_anything() {
    for state in [FlightState::Armed, FlightState::Tracking, FlightState::Maneuver, FlightState::Recovery] {
        let mut bench = Bench::in_state(state);
        let other = table_of("horizontal_5");
        let before = bench.read_table();
        assert_eq!(before[..], bytes_of(&table())[..]);
        assert_eq!(bench.refusal(chunks(&bytes_of(&other))[0].clone()), Refusal::MotorsOn, "{state:?}");
        assert_eq!(
            bench.refusal(Request::CommitTable { checksum: other.checksum() }),
            Refusal::MotorsOn,
            "{state:?}"
        );
        assert_eq!(bench.read_table(), before, "{state:?}");
        assert_eq!(bench.logic.state(), state);
        // Nothing was staged behind the refusal either.
        bench.ask(Request::EmergencyStop);
        assert_eq!(bench.refusal(Request::CommitTable { checksum: other.checksum() }), Refusal::NotStaged);
    }
}

#[test]
fn a_refused_table_leaves_the_old_one() {
    let mut bench = Bench::ready();
    let mut good = bytes_of(&table());
    assert_eq!(bench.read_table(), [0u8; 0]);
    assert_eq!(bench.refusal(Request::CommitTable { checksum: 1 }), Refusal::NotStaged);
    bench.commit(&table());
    // Asked again after a lost answer: it is so already.
    let again = bench.ask(Request::CommitTable { checksum: table().checksum() });
    assert_eq!(again, Reply::Committed { checksum: table().checksum(), duration_s: table().duration_s() });
    let before = bench.read_table();

    let try_bytes = |bench: &mut Bench, bytes: &[u8], checksum: u32| match bench.stage(bytes) {
        Reply::Refused(refusal) => refusal,
        Reply::Staged { length } => {
            assert_eq!(usize::from(length), bytes.len());
            bench.refusal(Request::CommitTable { checksum })
        }
        reply => panic!("{reply:?}"),
    };
    let checksum = table().checksum();
    assert_eq!(try_bytes(&mut bench, &[], checksum), Refusal::Table(TableError::Length));
    assert_eq!(try_bytes(&mut bench, &good[..112], checksum), Refusal::Table(TableError::Checksum));
    assert_eq!(try_bytes(&mut bench, &[0x55; 204], checksum), Refusal::Table(TableError::Checksum));
    assert_eq!(try_bytes(&mut bench, &good.clone(), !checksum), Refusal::NotStaged, "another one named");
    good[60] ^= 4;
    assert_eq!(try_bytes(&mut bench, &good, checksum), Refusal::Table(TableError::Checksum));
    let foreign = made_for(VehicleConfig::REFERENCE.hash() ^ 1);
    assert_eq!(try_bytes(&mut bench, &foreign.0, foreign.1), Refusal::Table(TableError::OtherVehicle));
    assert_eq!(bench.read_table(), before);
    assert_eq!(bench.telemetry().table, checksum);

    let own = made_for(VehicleConfig::REFERENCE.hash());
    bench.stage(&own.0);
    assert!(matches!(bench.ask(Request::CommitTable { checksum: own.1 }), Reply::Committed { .. }));
    assert_eq!(bench.read_table(), own.0);
}

/// A table within its own limits, beyond this vehicle's.
#[test]
fn a_table_beyond_the_vehicle_is_refused() {
    use mintime_shared::model::{Inputs, Limits, RateMode, Segment, State, ThrustLevel};
    use mintime_shared::table::{ANY_VEHICLE, Kind, LinkPolicy, TableHeader};
    for (thrust_max_mps2, rate_max_radps, fits) in
        [(30.0, 15.0, true), (30.1, 15.0, false), (30.0, 15.1, false)]
    {
        let limits = Limits { thrust_min_mps2: 1.0, thrust_max_mps2, rate_max_radps, gravity_mps2: 9.81 };
        let inputs = Inputs { rate: RateMode::Plus, thrust: ThrustLevel::Max };
        let header = TableHeader {
            vehicle: ANY_VEHICLE,
            kind: Kind::Learned,
            link: LinkPolicy::Finish,
            limits,
            heading_rad: 0.0,
            start: State::origin(),
            end: State { theta: 0.1 * rate_max_radps, ..State::at_rest(0.1, 0.1) },
        };
        let made = ManeuverTable::new(header, None, [Segment { inputs, duration: 0.1 }]).expect("sound");
        let mut bench = Bench::ready();
        bench.stage(&bytes_of(&made));
        let reply = bench.ask(Request::CommitTable { checksum: made.checksum() });
        if fits {
            assert!(matches!(reply, Reply::Committed { .. }), "{reply:?}");
        } else {
            assert_eq!(reply, Reply::Refused(Refusal::Table(TableError::BeyondVehicle)));
        }
    }
}

// ---------------------------------------------------------------------------------------------------------- maneuver

#[test]
fn a_trigger_is_refused_unless_all_is_well() {
    let checksum = table().checksum();
    let trigger = Request::Trigger { checksum };
    for state in
        ALL_STATES.into_iter().filter(|s| !matches!(s, FlightState::Tracking | FlightState::Maneuver))
    {
        let mut bench = Bench::in_state(state);
        assert_eq!(bench.refusal(trigger.clone()), Refusal::WrongState(state));
        assert_eq!(bench.logic.state(), state);
    }
    let mut bench = Bench::flying();
    assert_eq!(bench.refusal(trigger.clone()), Refusal::NotCommitted, "no table at all");
    assert_eq!(bench.refusal(Request::Trigger { checksum: 0 }), Refusal::NotCommitted, "nor one named 0");
    let mut bench = Bench::in_state(FlightState::Tracking);
    assert_eq!(bench.refusal(Request::Trigger { checksum: checksum ^ 1 }), Refusal::NotCommitted);
    for battery in [None, Some(13.9), Some(f32::NAN)] {
        bench.battery_v = battery;
        assert_eq!(bench.refusal(trigger.clone()), Refusal::BatteryLow, "{battery:?}");
    }
    bench.battery_v = Some(15.5);
    // In the very tick in which the setpoint grows stale the vehicle still flies; then it is lost.
    bench.stream = None;
    bench.run(60);
    let sample = bench.sample();
    bench.tick_with(Some(sample), 60_000, std::slice::from_ref(&trigger));
    let number = bench.number;
    assert_eq!(bench.answer(number), Some(Reply::Refused(Refusal::StaleSetpoint)));
    bench.stream = Some(HOVER);
    bench.run(10);
    assert_eq!(bench.ask(trigger.clone()), Reply::Done);
    assert_eq!(bench.logic.state(), FlightState::Maneuver);
    assert_eq!(bench.refusal(trigger), Refusal::WrongState(FlightState::Maneuver));
}

/// The answer was lost and the host asks again under the same number: done, but not a second time. A new number is a
/// new maneuver.
#[test]
fn a_repeated_trigger_fires_once() {
    let mut bench = Bench::in_state(FlightState::Tracking);
    let number = bench.number + 1;
    let again = |bench: &mut Bench| {
        let rest = core::mem::replace(&mut bench.number, number - 1);
        let reply = bench.trigger();
        bench.number = rest;
        reply
    };
    assert_eq!(bench.trigger(), Reply::Done);
    bench.run(99);
    let elapsed = bench.telemetry().maneuver_s;
    assert_eq!(again(&mut bench), Reply::Done);
    assert!(bench.telemetry().maneuver_s > elapsed);
    bench.run_while(FlightState::Maneuver, 2000);
    assert_eq!(again(&mut bench), Reply::Done);
    assert_eq!(bench.logic.state(), FlightState::Tracking);
    bench.run(40);
    assert_eq!(bench.trigger(), Reply::Done);
    assert_eq!(bench.logic.state(), FlightState::Maneuver);
}

/// It runs to T: as many ticks as fit, each recorded with what the replay commands, then back to the host.
#[test]
fn a_maneuver_runs_to_its_end_and_is_recorded() {
    for case in reference_cases() {
        let table = case.table();
        let mut bench = Bench::ready();
        bench.commit(&table);
        bench.arm();
        // Into the attitude that the maneuver begins with.
        let pitch_radps = table.start.theta / 0.5;
        bench.stream = Some(Setpoint { rates_radps: [0.0, pitch_radps, 0.0], ..HOVER });
        bench.run(400);
        bench.stream = Some(HOVER);
        bench.run(60);
        let number = bench.number + 1;
        let before_us = bench.now_us;
        bench.tick(&[Request::Trigger { checksum: table.checksum() }]);
        assert_eq!(bench.answer(number), Some(Reply::Done), "{}", case.name);
        let start_us = bench.now_us;
        assert_eq!(start_us, before_us + TICK_US, "from the very tick of the request");

        let mut replay = Replay::new(Plan::new(&table), start_us);
        let mut expected = Vec::new();
        while bench.logic.state() == FlightState::Maneuver {
            let Step::Fly(command) = replay.tick(bench.now_us, &TickPeriod::new()) else {
                panic!("{}: flown beyond T", case.name);
            };
            let flown = bench.out.setpoint;
            assert_eq!(flown.rates_radps, [0.0, command.rate_radps, 0.0]);
            assert_eq!(flown.thrust_mps2, command.thrust_mps2);
            expected.push((command, bench.out.throttle.expect("motors on")));
            bench.tick(&[]);
        }
        assert_eq!(bench.logic.state(), FlightState::Tracking, "{}", case.name);
        assert_eq!(bench.out.setpoint, HOVER);
        let ticks = (case.duration_s / 1250e-6).ceil() as usize;
        assert_eq!(expected.len(), ticks, "{}: {:?}", case.name, bench.abort());
        let telemetry = bench.telemetry();
        assert!(telemetry.maneuver_complete && telemetry.abort.is_none());
        assert_eq!(telemetry.maneuver_s, table.duration_s());
        assert_eq!(telemetry.recorded as usize, ticks);

        let record = bench.record();
        assert_eq!(record.len(), ticks);
        for (i, (tick, (command, throttle))) in record.iter().zip(expected).enumerate() {
            assert_eq!(u64::from(tick.interval_us), if i == 0 { 0 } else { TICK_US });
            assert!((tick.rate_radps - command.rate_radps).abs() < 6e-4, "{tick:?}");
            assert!((tick.thrust_mps2 - command.thrust_mps2).abs() < 6e-4, "{tick:?}");
            for (recorded, given) in tick.throttle.iter().zip(throttle) {
                assert!((recorded - given).abs() < 1.3e-4);
            }
            assert!(tick.gyro_radps.is_some());
        }
        assert_eq!(bench.refusal(Request::ReadRecord { first: ticks as u32 + 1 }), Refusal::NoRecord);
        assert_eq!(bench.refusal(Request::ReadRecord { first: u32::MAX }), Refusal::NoRecord);
    }
}

#[test]
fn no_record_is_read_during_a_maneuver() {
    let mut bench = Bench::maneuver();
    assert_eq!(bench.refusal(Request::ReadRecord { first: 0 }), Refusal::WrongState(FlightState::Maneuver));
    let mut bench = Bench::ready();
    assert!(bench.record().is_empty());
}

/// A record longer than its memory keeps its beginning.
#[test]
fn a_full_recorder_keeps_the_beginning() {
    let mut bench = Bench::ready();
    bench.logic = FlightLogic::new(Some(VehicleConfig::REFERENCE), BOTH, vec![[0; RECORD_BYTES]; 100]);
    bench.run(900);
    bench.commit(&table());
    bench.arm();
    bench.stream = Some(HOVER);
    bench.run(20);
    assert_eq!(bench.trigger(), Reply::Done);
    bench.run_while(FlightState::Maneuver, 2000);
    assert!(bench.telemetry().maneuver_complete);
    assert_eq!(bench.record().len(), 100);
}

// ------------------------------------------------------------------------------------------------------------ faults

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

// ---------------------------------------------------------------------------------------------------------- messages

#[test]
fn another_protocol_version_is_refused_and_nothing_done() {
    for version in [0, PROTOCOL_VERSION - 1, PROTOCOL_VERSION + 1, 255] {
        let mut bench = Bench::flying();
        let mut inbox = Inbox::new();
        let mut outbox = Outbox::new();
        for (number, request) in [Request::EmergencyStop, Request::Disarm].into_iter().enumerate() {
            inbox.push_back(Uplink { version, number: number as u16, request }).expect("room");
        }
        let imu = Some(bench.sample());
        let input =
            TickInput { now_us: bench.now_us + TICK_US, imu, battery_v: Some(15.5), kill: KillSwitch::Run };
        bench.logic.tick(&input, &mut inbox, &mut outbox);
        assert_eq!(bench.logic.state(), FlightState::Tracking);
        for number in [0, 1] {
            let reply = Reply::Refused(Refusal::ProtocolVersion);
            assert!(outbox.iter().any(|m| *m == Message::Reply { number, reply: reply.clone() }));
        }
    }
}

#[test]
fn setpoints_that_are_no_numbers_are_refused_and_not_flown() {
    for bad in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
        let wrong = [[bad, 0.0, 0.0], [0.0, bad, 0.0], [0.0, 0.0, bad]]
            .map(|rates_radps| Setpoint { rates_radps, ..HOVER });
        for setpoint in wrong.into_iter().chain([Setpoint { thrust_mps2: bad, ..HOVER }]) {
            let mut bench = Bench::flying();
            bench.tick(&[]);
            bench.tick(&[]);
            assert_eq!(bench.refusal(Request::Setpoint { sequence: 9, setpoint }), Refusal::NotFinite);
            assert_eq!(bench.out.setpoint, HOVER);
            // And they do not count as a sign of life.
            bench.stream = None;
            for _ in 0..FRESH_TICKS + 10 {
                bench.tick(&[Request::Setpoint { sequence: 9, setpoint }]);
            }
            assert_eq!(bench.logic.state(), FlightState::Recovery);
        }
    }
}

/// Setpoints are not answered, everything else is, once, with its number.
#[test]
fn every_request_is_answered_once() {
    for state in ALL_STATES {
        let requests = [
            Request::Identify,
            Request::Status,
            Request::SetTelemetry { period_ms: 20 },
            chunk(8, 0, &[1]),
            Request::CommitTable { checksum: 5 },
            Request::ReadTable,
            Request::ListTables,
            Request::ReadVehicle,
            Request::ReadSettings,
            Request::Calibrate,
            Request::CalibrateScale { axis: 0, turns: 1 },
            Request::Acknowledge { incident: 7 },
            Request::TestMotor { motor: 0, throttle: 0.1, duration_ms: 10 },
            Request::Record,
            Request::ReadEvents { first: 0 },
            Request::Arm(Purpose::Flight),
            Request::Disarm,
            Request::EmergencyStop,
            Request::Trigger { checksum: 5 },
            Request::ReadRecord { first: 0 },
        ];
        for request in requests {
            let mut bench = Bench::in_state(state);
            bench.stream = None;
            bench.said.clear();
            let sequence = bench.sequence.wrapping_add(1);
            bench.tick(&[
                Request::Setpoint { sequence, setpoint: HOVER },
                Request::Heartbeat,
                request.clone(),
            ]);
            let replies: Vec<u16> = bench
                .said
                .iter()
                .filter_map(|m| match m {
                    Message::Reply { number, .. } => Some(*number),
                    Message::Telemetry(_) => None,
                })
                .collect();
            assert_eq!(replies, [bench.number], "{request:?} in {state:?}");
        }
    }
}

#[test]
fn telemetry_comes_every_twenty_milliseconds() {
    let mut bench = Bench::ready();
    bench.said.clear();
    bench.run(800);
    let count = bench.said.iter().filter(|m| matches!(m, Message::Telemetry(_))).count();
    assert_eq!(count, 50);
}

/// More requests than fit the inbox, at one instant: an emergency stop among them is not lost.
#[test]
fn an_emergency_stop_finds_room() {
    for place in 0..12 {
        let mut vehicle = Vehicle::new(Some(VehicleConfig::REFERENCE), BOTH, vec![[0; RECORD_BYTES]; 100]);
        let send = |vehicle: &mut Vehicle<Record>, request| {
            let uplink = Uplink { version: PROTOCOL_VERSION, number: 1, request };
            vehicle.receive(encode(&uplink).expect("it fits").as_bytes());
        };
        let mut now_us = 0;
        let mut tick = |vehicle: &mut Vehicle<Record>| {
            now_us += TICK_US;
            let imu = Some(ImuSample {
                gyro_radps: [1e-6 * (now_us % 7000) as f32; 3],
                accel_mps2: [0.0, 0.0, 9.81],
            });
            vehicle.tick(&TickInput { now_us, imu, battery_v: Some(15.0), kill: KillSwitch::Run })
        };
        for _ in 0..900 {
            tick(&mut vehicle);
        }
        send(&mut vehicle, Request::Arm(Purpose::Flight));
        tick(&mut vehicle);
        assert_eq!(vehicle.state(), FlightState::Armed);
        // A disarm behind it does not undo it.
        for i in 0..12 {
            send(&mut vehicle, if i == place { Request::EmergencyStop } else { Request::Status });
        }
        send(&mut vehicle, Request::Disarm);
        assert_eq!(tick(&mut vehicle).throttle, None, "place {place}");
        assert_eq!(vehicle.state(), FlightState::Terminated);
    }
}

//! The flight logic tick by tick: tables taken and refused, the trigger, and a maneuver to its end.

mod logic;

use logic::{BOTH, Bench, HOVER, TICK_US, bytes_of, chunks, made_for, table, table_of};
use mintime_firmware::config::VehicleConfig;
use mintime_firmware::flight::FlightLogic;
use mintime_shared::messages::{FlightState, Purpose, RECORD_BYTES, Refusal, Reply, Request, Setpoint};
use mintime_shared::replay::{Plan, Replay, Step, TickPeriod};
use mintime_shared::table::{ANY_VEHICLE, ManeuverTable, TableError};
use mintime_tests::reference_cases;

const ALL_STATES: [FlightState; 9] = FlightState::ALL;

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
    let nobodys = made_for(ANY_VEHICLE);
    assert_eq!(try_bytes(&mut bench, &nobodys.0, nobodys.1), Refusal::Table(TableError::AnyVehicle));
    assert_eq!(bench.read_table(), before);
    assert_eq!(bench.telemetry().table, checksum);

    let own = table_of("horizontal_5");
    bench.commit(&own);
    assert_eq!(bench.read_table()[..], bytes_of(&own)[..]);
}

/// A table within its own limits, beyond this vehicle's.
#[test]
fn a_table_beyond_the_vehicle_is_refused() {
    use mintime_shared::model::{Inputs, Limits, RateMode, Segment, State, ThrustLevel};
    use mintime_shared::table::{Kind, LinkPolicy, TableHeader};
    for (thrust_max_mps2, rate_max_radps, fits) in
        [(30.0, 15.0, true), (30.1, 15.0, false), (30.0, 15.1, false)]
    {
        let limits = Limits { thrust_min_mps2: 1.0, thrust_max_mps2, rate_max_radps, gravity_mps2: 9.81 };
        let inputs = Inputs { rate: RateMode::Plus, thrust: ThrustLevel::Max };
        let header = TableHeader {
            vehicle: VehicleConfig::REFERENCE.hash(),
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

/// Of several triggers in one tick one is flown, and only who asked for that one is told so.
#[test]
fn of_two_triggers_in_one_tick_one_is_flown() {
    let trigger = Request::Trigger { checksum: table().checksum() };
    let mut bench = Bench::in_state(FlightState::Tracking);
    bench.tick(&[trigger.clone(), trigger.clone()]);
    assert_eq!(bench.answer(bench.number - 1), Some(Reply::Done));
    assert_eq!(bench.answer(bench.number), Some(Reply::Refused(Refusal::WrongState(FlightState::Maneuver))));
    assert_eq!(bench.logic.state(), FlightState::Maneuver);
    // The second is none that has been flown.
    bench.number -= 1;
    assert_eq!(bench.refusal(trigger), Refusal::WrongState(FlightState::Maneuver));
}

/// Armed for what was asked first; who wants something else is told so.
#[test]
fn of_two_purposes_in_one_tick_the_first_counts() {
    for (first, second) in [(Purpose::Flight, Purpose::MotorTest), (Purpose::MotorTest, Purpose::Flight)] {
        let mut bench = Bench::ready();
        bench.tick(&[Request::Arm(first), Request::Arm(second), Request::Arm(first)]);
        assert_eq!(bench.answer(bench.number - 2), Some(Reply::Done));
        assert_eq!(bench.answer(bench.number - 1), Some(Reply::Refused(Refusal::OtherPurpose)));
        assert_eq!(bench.answer(bench.number), Some(Reply::Done));
        let test = Request::TestMotor { motor: 0, throttle: 0.1, duration_ms: 10 };
        let want = match first {
            Purpose::Flight => Reply::Refused(Refusal::OtherPurpose),
            Purpose::MotorTest => Reply::Done,
        };
        assert_eq!(bench.ask(test), want);
    }
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

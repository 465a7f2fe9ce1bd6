//! The flight logic request by request: what is repeated, overtaken, left over from before arming, or comes at a bad moment
//! does no harm.

mod logic;

use logic::{BOTH, Bench, HOVER, Store, TICK_US, bytes_of, chunk, status, table, table_of};
use mintime_firmware::config::{BoardStatus, StoreStatus, VehicleConfig};
use mintime_firmware::flight::{FlightLogic, Inbox};
use mintime_firmware::keeping::Key;
use mintime_firmware::link::Link;
use mintime_firmware::store::Damage;
use mintime_shared::framing::encode;
use mintime_shared::messages::{
    ArmingBlock, CalibrationError, FlightState, Happening, IncidentCause, PROTOCOL_VERSION, Purpose,
    RECORD_BYTES, Refusal, Reply, Request, Setpoint, TableName, Uplink,
};
use mintime_shared::settings::Settings;

const ARM: Request = Request::Arm(Purpose::Flight);
/// A store that is there and does nothing by itself.
const IDLE_STORE: StoreStatus = StoreStatus { present: true, busy: false, finished: 0, failed: false };

fn name(text: &str) -> TableName {
    TableName::try_from(text).expect("a short name")
}

/// A request under the number of an earlier one.
fn ask_as(bench: &mut Bench, number: u16, request: Request) -> Reply {
    let rest = core::mem::replace(&mut bench.number, number.wrapping_sub(1));
    let reply = bench.ask(request);
    bench.number = rest;
    reply
}

fn disarm(bench: &mut Bench) {
    bench.stream = None;
    assert_eq!(bench.ask(Request::Disarm), Reply::Done);
    bench.run(900);
}

/// How often something stands in the event log.
fn logged(bench: &mut Bench, what: Happening) -> usize {
    let mut count = 0;
    let mut first = 0;
    loop {
        let Reply::Events(log) = bench.ask(Request::ReadEvents { first }) else { panic!("no events") };
        if log.events.is_empty() {
            return count;
        }
        count += log.events.iter().filter(|event| event.what == what).count();
        first = log.first + log.events.len() as u32;
    }
}

// -------------------------------------------------------------------------------------------------- asked again

/// A repetition is one of the same request: another table under that number is not said to have been flown.
#[test]
fn another_table_under_a_flown_triggers_number_is_refused() {
    let mut bench = Bench::in_state(FlightState::Tracking);
    assert_eq!(bench.trigger(), Reply::Done);
    let number = bench.number;
    let checksum = table_of("horizontal_5").checksum();
    let refused = Reply::Refused(Refusal::WrongState(FlightState::Maneuver));
    assert_eq!(ask_as(&mut bench, number, Request::Trigger { checksum }), refused);
}

/// A refusal is logged once for each request, and one that passes by itself not at all.
#[test]
fn a_host_that_insists_does_not_flush_the_log() {
    let mut bench = Bench::ready();
    let refusal = Refusal::NoSuchTable;
    let number = bench.number + 1;
    for _ in 0..5 {
        let load = Request::LoadTable { name: name("none") };
        assert_eq!(ask_as(&mut bench, number, load), Reply::Refused(refusal));
    }
    assert_eq!(logged(&mut bench, Happening::Refused(refusal)), 1);
    bench.battery_v = Some(13.0);
    let low = Refusal::ArmingBlocked(ArmingBlock::BATTERY_LOW.0);
    assert_eq!(bench.refusal(ARM), low);
    assert_eq!(logged(&mut bench, Happening::Refused(low)), 0);
}

/// The same acknowledgement twice in a tick is one.
#[test]
fn an_acknowledgement_is_logged_once() {
    let mut bench = Bench::ready();
    let incident = bench.logic.report(IncidentCause::BrownOut);
    bench.tick(&[Request::Acknowledge { incident }, Request::Acknowledge { incident }]);
    for number in [bench.number - 1, bench.number] {
        assert_eq!(bench.answer(number), Some(Reply::Done));
    }
    assert_eq!(logged(&mut bench, Happening::Acknowledged(incident)), 1);
}

/// Asked again, a record goes on.
#[test]
fn a_record_asked_for_twice_is_one() {
    let mut bench = Bench::flying();
    assert_eq!(bench.ask(Request::Record), Reply::Done);
    bench.run(50);
    assert_eq!(bench.ask(Request::Record), Reply::Done);
    let recorded = bench.telemetry().recorded;
    assert!(recorded > 50);
    disarm(&mut bench);
    let total = bench.record().len() as u32;
    assert!(total >= recorded);
    assert_eq!(bench.refusal(Request::ReadRecord { first: total }), Refusal::NoRecord);
}

/// Of the very moment when the calibration ends a host that asks to arm in every tick learns nothing else.
#[test]
fn arming_waits_until_the_calibration_is_over() {
    let mut bench = Bench::new();
    for _ in 0..900 {
        match bench.ask(ARM) {
            Reply::Done => return assert_eq!(bench.logic.state(), FlightState::Armed),
            Reply::Refused(Refusal::ArmingBlocked(_)) => {}
            other => panic!("{other:?} in {:?}", bench.logic.state()),
        }
    }
    panic!("never armed");
}

// ------------------------------------------------------------------------------------------------- left over

/// A setpoint that was overtaken on the way is not flown.
#[test]
fn overtaken_setpoints_are_not_flown() {
    let mut bench = Bench::flying();
    bench.stream = None;
    let sequence = bench.sequence;
    let yaw = Setpoint { rates_radps: [0.0, 0.0, 1.0], ..HOVER };
    for (ahead, asked, flown) in [(2, HOVER, HOVER), (1, yaw, HOVER), (2, yaw, HOVER), (3, yaw, yaw)] {
        bench.tick(&[Request::Setpoint { sequence: sequence.wrapping_add(ahead), setpoint: asked }]);
        assert_eq!(bench.out.setpoint, flown, "{ahead}");
    }
}

/// Setpoints on their way while the motors stop are nobody's fault, whatever it was armed for.
#[test]
fn setpoints_to_standing_motors_are_not_refused() {
    let mut bench = Bench::ready();
    assert_eq!(bench.ask(Request::Arm(Purpose::MotorTest)), Reply::Done);
    disarm(&mut bench);
    let setpoint = bench.setpoint(HOVER);
    bench.tick(&[setpoint]);
    assert_eq!(bench.answer(bench.number), None);
}

/// What was counted, tested, triggered and numbered before counts no more once it is armed again.
#[test]
fn arming_begins_anew() {
    let mut bench = Bench::in_state(FlightState::Tracking);
    bench.sequence += 5;
    bench.run(8);
    assert!(bench.telemetry().setpoints_lost > 0);
    assert_eq!(bench.trigger(), Reply::Done);
    let number = bench.number;
    disarm(&mut bench);
    assert!(!bench.telemetry().maneuver_complete, "it was ordered to stop");
    bench.arm();
    assert_eq!(bench.telemetry().setpoints_lost, 0);
    // Another host begins with its own numbers.
    bench.sequence = 0;
    bench.stream = Some(HOVER);
    bench.run(60);
    assert_eq!(bench.logic.state(), FlightState::Tracking);
    let checksum = table().checksum();
    assert_eq!(ask_as(&mut bench, number, Request::Trigger { checksum }), Reply::Done);
    assert_eq!(bench.logic.state(), FlightState::Maneuver);

    let mut bench = Bench::ready();
    assert_eq!(bench.ask(Request::Arm(Purpose::MotorTest)), Reply::Done);
    let test = Request::TestMotor { motor: 2, throttle: 0.1, duration_ms: 2000 };
    assert_eq!(bench.ask(test), Reply::Done);
    assert_eq!(bench.ask(Request::Disarm), Reply::Done);
    bench.run(900);
    assert_eq!(bench.ask(Request::Arm(Purpose::MotorTest)), Reply::Done);
    assert_eq!(bench.out.throttle, Some([0.0; 4]));
}

/// Late ticks are counted for each maneuver.
#[test]
fn late_ticks_of_an_earlier_maneuver_do_not_count() {
    let mut bench = Bench::in_state(FlightState::Tracking);
    for _ in 0..2 {
        assert_eq!(bench.trigger(), Reply::Done);
        for _ in 0..30 {
            let sample = bench.sample();
            bench.tick_with(Some(sample), 2000, &[]);
        }
        assert_eq!(bench.logic.state(), FlightState::Maneuver);
        bench.run_while(FlightState::Maneuver, 2000);
        assert_eq!(bench.abort(), None);
        bench.run(100);
    }
}

// ------------------------------------------------------------------------------------------------- bad moments

#[test]
fn a_vehicle_that_knows_nothing_says_so() {
    let mut bench = Bench::of(FlightLogic::new(None, BOTH, vec![[0; RECORD_BYTES]; 1]));
    bench.run(900);
    let Reply::Identity(identity) = bench.ask(Request::Identify) else { panic!("no identity") };
    assert_eq!(identity.vehicle, 0);
    // Nor is there a table to store, not even the one that is none.
    let nothing = Request::StoreTable { name: name("none"), checksum: 0 };
    assert_eq!(bench.refusal(nothing), Refusal::NotCommitted);
}

/// Bytes that begin alike but belong to a table of another length begin anew.
#[test]
fn another_length_begins_anew() {
    let bytes = bytes_of(&table());
    let mut bench = Bench::ready();
    for total in [bytes.len() + 1, bytes.len()] {
        assert_eq!(bench.ask(chunk(total, 0, &bytes[..30])), Reply::Staged { length: 30 });
    }
}

/// Guided turns asked for under another number are other ones; none ends them.
#[test]
fn guided_turns_belong_to_their_request() {
    let mut bench = Bench::ready();
    let turns = Request::CalibrateScale { axis: 2, turns: 1 };
    assert_eq!(bench.ask(turns.clone()), Reply::Pending);
    let number = bench.number;
    bench.run(900);
    let mut reply = Reply::Pending;
    for _ in 0..20 {
        bench.run(1000);
        reply = ask_as(&mut bench, number, turns.clone());
    }
    assert_eq!(reply, Reply::Refused(Refusal::Calibration(CalibrationError::NotTurned)));
    assert_eq!(bench.ask(turns), Reply::Pending);
    assert_eq!(bench.ask(Request::CalibrateScale { axis: 2, turns: 0 }), Reply::Done);
}

/// The angle that passes while the gyro is silent is nobody's guess; a sample or two that are lost cost nothing.
#[test]
fn a_gyro_that_falls_silent_ends_guided_turns() {
    let lost = Reply::Refused(Refusal::Calibration(CalibrationError::SamplesLost));
    for (silent_ticks, expected) in [(6, Reply::Pending), (10, lost)] {
        let mut bench = Bench::ready();
        let turns = Request::CalibrateScale { axis: 2, turns: 1 };
        assert_eq!(bench.ask(turns.clone()), Reply::Pending);
        let number = bench.number;
        bench.run(900);
        for tick in 0..400 {
            let mut sample = bench.sample();
            sample.gyro_radps[2] += 2.0;
            let seen = Some(sample).filter(|_| !(200..200 + silent_ticks).contains(&tick));
            bench.tick_with(seen, TICK_US, &[]);
        }
        assert_eq!(ask_as(&mut bench, number, turns), expected, "{silent_ticks} ticks");
    }
}

/// A job that the board has not taken yet keeps the motors off as well as one that it works on.
#[test]
fn a_job_that_waits_blocks_arming() {
    let mut bench = Bench::ready();
    bench.logic.set_board_status(&BoardStatus { store: IDLE_STORE, ..status(BOTH, false) });
    let settings = Settings { heartbeat_ms: 700, ..Settings::DEFAULT };
    assert_eq!(bench.ask(Request::WriteSettings(settings)), Reply::Pending);
    assert_eq!(bench.refusal(ARM), Refusal::ArmingBlocked(ArmingBlock::STORING.0));
}

/// A failure is told to who wanted that value, and is forgotten with the next one that is written.
#[test]
fn a_failure_is_told_of_its_own_value_only() {
    let mut bench = Bench::with_store();
    let settings = Request::WriteSettings(Settings { heartbeat_ms: 700, ..Settings::DEFAULT });
    bench.store.as_mut().expect("a store").fails = true;
    assert_eq!(bench.ask(settings.clone()), Reply::Pending);
    bench.run(20);
    bench.store.as_mut().expect("a store").fails = false;
    let vehicle = VehicleConfig { mass_kg: 0.75, ..VehicleConfig::REFERENCE };
    assert_eq!(bench.settle(&Request::WriteVehicle(vehicle)).0, Reply::Done);
    assert_eq!(bench.settle(&settings).0, Reply::Done);
}

/// Switched on with the tables (5, 5) and nothing else in its store, and this damage, which a person has read of.
fn with_damage(kept: bool, places: &[u8]) -> Bench {
    let mut old = Bench::with_store();
    old.commit(&table());
    let flip = Request::StoreTable { name: name("flip"), checksum: table().checksum() };
    assert_eq!(old.settle(&flip).0, Reply::Done);
    let store = old.store.expect("a store").kept.into_iter().filter(|_| kept).collect::<Vec<_>>();
    let mut bench = Bench::ready();
    for (key, value) in &store {
        assert!(bench.logic.restore(*key, value));
    }
    let mut damage = Damage::NONE;
    for place in places {
        damage.set(Key::Table(*place), true);
    }
    bench.logic.note_damage(damage);
    assert_eq!(bench.acknowledge(), Reply::Done);
    bench.store = Some(Store { kept: store, ticks: 5, ..Store::default() });
    bench
}

/// A table of which an older copy is left keeps its place, and is written anew where it is stored again.
#[test]
fn a_damaged_table_of_which_a_copy_is_left_is_kept() {
    let mut bench = with_damage(true, &[0]);
    bench.run(50);
    assert_eq!(bench.store.as_ref().expect("a store").jobs, 0);
    bench.commit(&table());
    let flip = Request::StoreTable { name: name("flip"), checksum: table().checksum() };
    assert_eq!(bench.settle(&flip).0, Reply::Done);
    assert_eq!(bench.store.as_ref().expect("a store").jobs, 1);
}

/// Places of lost tables are freed one after the other, each tried once, and only where there is a store.
#[test]
fn lost_places_are_freed_one_by_one_and_once() {
    let mut bench = with_damage(false, &[2, 6]);
    bench.store = None;
    bench.logic.set_board_status(&status(BOTH, false));
    assert_eq!(bench.logic.job(), None, "without a store");
    for _ in 0..3 {
        bench.logic.set_board_status(&BoardStatus { store: IDLE_STORE, ..status(BOTH, false) });
        assert_eq!(bench.logic.job().map(|job| job.key), Some(Key::Table(2)), "it has not been taken yet");
    }
    let mut bench = with_damage(false, &[2]);
    bench.store.as_mut().expect("a store").fails = true;
    bench.run(100);
    assert_eq!(bench.store.as_ref().expect("a store").jobs, 1, "flash that fails is not worn further");
}

/// A disarm finds room in a full inbox as an emergency stop does, and what it displaces is counted.
#[test]
fn a_disarm_finds_room() {
    let mut link = Link::new();
    let mut inbox = Inbox::new();
    let mut receive = |number, request| {
        let uplink = Uplink { version: PROTOCOL_VERSION, number, request, heard_ms: 0 };
        link.receive(encode(&uplink).expect("it fits").as_bytes(), None, &mut inbox);
        (inbox.back().map(|last| last.number), link.errors())
    };
    for number in 1..=4 {
        assert_eq!(receive(number, Request::Heartbeat), (Some(number), 0));
    }
    assert_eq!(receive(5, Request::Heartbeat), (Some(4), 1), "lost, and counted");
    assert_eq!(receive(6, Request::Disarm), (Some(6), 2));
}

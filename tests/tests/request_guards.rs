//! The flight logic request by request: what is repeated, overtaken, left over from before arming, or comes at a bad moment
//! does no harm.

mod logic;

use logic::{BOTH, Bench, HOVER, bytes_of, chunk, name, table, table_of};
use mintime_firmware::config::VehicleConfig;
use mintime_firmware::flight::{FlightLogic, Inbox};
use mintime_firmware::link::Link;
use mintime_shared::framing::encode;
use mintime_shared::messages::{
    ArmingBlock, FlightState, Happening, IncidentCause, Message, PROTOCOL_VERSION, Purpose, RECORD_BYTES,
    Refusal, Reply, Request, Setpoint, Uplink,
};

const ARM: Request = Request::Arm(Purpose::Flight);

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
    assert_eq!(bench.ask_as(number, Request::Trigger { checksum }), refused);
}

/// A refusal is logged once for each request, and one that passes by itself not at all.
#[test]
fn a_host_that_insists_does_not_flush_the_log() {
    let mut bench = Bench::ready();
    let refusal = Refusal::NoSuchTable;
    let number = bench.number + 1;
    for _ in 0..5 {
        let load = Request::LoadTable { name: name("none") };
        assert_eq!(bench.ask_as(number, load), Reply::Refused(refusal));
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
    bench.disarm();
    let total = bench.record().len() as u32;
    assert!(total >= recorded);
    assert_eq!(bench.refusal(Request::ReadRecord { first: total }), Refusal::NoRecord);
}

/// A record begins anew, whatever a maneuver has left in its place.
#[test]
fn a_record_asked_for_replaces_the_last() {
    let mut bench = Bench::maneuver();
    bench.run_while(FlightState::Maneuver, 2000);
    assert!(bench.telemetry().recorded > 1000);
    assert_eq!(bench.ask(Request::Record), Reply::Done);
    bench.run(10);
    assert_eq!(bench.telemetry().recorded, 11, "one a tick, from the one that began it");
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

/// Whoever asks how it is or who, paired or not, does not say that its host is there.
#[test]
fn a_strangers_question_is_no_sign_of_the_host() {
    let key = Some(*b"a secret of both");
    for (key, request, state) in [
        (None, Request::Identify, FlightState::Disarmed),
        (None, Request::Heartbeat, FlightState::Armed),
        (key, Request::Identify, FlightState::Disarmed),
        (key, Request::Heartbeat, FlightState::Armed),
        (key, Request::Status, FlightState::Disarmed),
    ] {
        let mut bench = Bench::ready();
        assert_eq!(bench.ask(Request::Pair(key)), Reply::Done);
        bench.arm();
        bench.heartbeat = false;
        for _ in 0..20 {
            bench.run(50);
            bench.tick(core::slice::from_ref(&request));
        }
        assert_eq!(bench.logic.state(), state, "{key:?} {request:?}");
    }
}

/// Telemetry comes as often as was asked for, from the very tick in which it was.
#[test]
fn telemetry_comes_as_often_as_asked_for() {
    let mut bench = Bench::ready();
    for (period_ms, ticks) in [(50, 40), (5, 4), (20, 16), (100, 80)] {
        bench.said.clear();
        assert_eq!(bench.ask(Request::SetTelemetry { period_ms }), Reply::Done);
        let told = |bench: &Bench| bench.said.iter().filter(|m| matches!(m, Message::Telemetry(_))).count();
        assert_eq!(told(&bench), 1, "{period_ms} ms: at once");
        bench.run(ticks - 1);
        assert_eq!(told(&bench), 1, "{period_ms} ms: not before its time");
        bench.run(1 + 2 * ticks);
        assert_eq!(told(&bench), 4, "{period_ms} ms");
    }
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

/// Half of all sequence numbers lie ahead of the last one, half behind it.
#[test]
fn a_setpoint_far_ahead_is_new_and_one_further_is_old() {
    let yaw = Setpoint { rates_radps: [0.0, 0.0, 1.0], ..HOVER };
    for (ahead, flown) in [(0x7fff, yaw), (0x8000, HOVER), (0xffff, HOVER)] {
        let mut bench = Bench::flying();
        bench.stream = None;
        let sequence = bench.sequence.wrapping_add(ahead);
        bench.tick(&[Request::Setpoint { sequence, setpoint: yaw }]);
        assert_eq!(bench.out.setpoint, flown, "{ahead}");
    }
}

/// A battery at its limit is not below it.
#[test]
fn a_battery_at_its_limit_is_enough_to_arm_and_to_trigger() {
    let mut bench = Bench::ready();
    bench.commit(&table());
    bench.battery_v = Some(VehicleConfig::REFERENCE.battery_low_v);
    bench.arm();
    bench.stream = Some(HOVER);
    bench.run(60);
    assert_eq!(bench.trigger(), Reply::Done);
}

/// Setpoints on their way while the motors stop are nobody's fault, whatever it was armed for.
#[test]
fn setpoints_to_standing_motors_are_not_refused() {
    let mut bench = Bench::ready();
    assert_eq!(bench.ask(Request::Arm(Purpose::MotorTest)), Reply::Done);
    bench.disarm();
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
    bench.disarm();
    assert!(!bench.telemetry().maneuver_complete, "it was ordered to stop");
    bench.arm();
    assert_eq!(bench.telemetry().setpoints_lost, 0);
    // Another host begins with its own numbers.
    bench.sequence = 0;
    bench.stream = Some(HOVER);
    bench.run(60);
    assert_eq!(bench.logic.state(), FlightState::Tracking);
    let checksum = table().checksum();
    assert_eq!(bench.ask_as(number, Request::Trigger { checksum }), Reply::Done);
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

/// Where there is room a stop displaces nothing.
#[test]
fn a_stop_that_has_room_displaces_nothing() {
    let (mut link, mut inbox) = (Link::new(), Inbox::new());
    for (number, request) in
        [(1, Request::Heartbeat), (2, Request::EmergencyStop), (3, Request::Status), (4, Request::Disarm)]
    {
        let uplink = Uplink { version: PROTOCOL_VERSION, number, request, heard_ms: 0 };
        link.receive(encode(&uplink).expect("it fits").as_bytes(), None, &mut inbox);
    }
    assert_eq!(inbox.iter().map(|uplink| uplink.number).collect::<Vec<_>>(), [1, 2, 3, 4]);
    assert_eq!(link.errors(), 0);
}

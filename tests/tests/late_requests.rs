//! How old a request is: what may turn a motor is not obeyed late, and what stops one always is.

mod logic;

use logic::{Bench, FRESH_TICKS, HOVER, TICK_US, table};
use mintime_firmware::flight::{Inbox, Outbox, TickInput};
use mintime_firmware::gyro::ImuSample;
use mintime_shared::messages::{
    AbortReason, FlightState, KillSwitch, Message, PROTOCOL_VERSION, Purpose, REQUEST_AGE_MS, Refusal, Reply,
    Request, Setpoint, Uplink, milliseconds,
};

const ARM: Request = Request::Arm(Purpose::Flight);
const LATE: Reply = Reply::Refused(Refusal::Late);

#[test]
fn a_request_may_be_as_old_as_that() {
    assert_eq!(Bench::ready().aged(REQUEST_AGE_MS).ask(ARM), Reply::Done);
    assert_eq!(Bench::ready().aged(REQUEST_AGE_MS + 1).ask(ARM), LATE);
    // Of a time that has not come: it was meant for another start.
    assert_eq!(Bench::ready().aged(0u32.wrapping_sub(1)).ask(ARM), LATE);
}

/// The clock's 32 bits of milliseconds begin anew after 49 days; nothing becomes late or young by that.
#[test]
fn the_clock_begins_anew() {
    let anew_us = (1u64 << 32) * 1000;
    for (before_ms, age_ms) in [(150, 300), (150, 301), (0, 300), (0, 301)] {
        let mut bench = Bench::new();
        // Two seconds to learn the bias in.
        bench.now_us = anew_us - 2_000_000 - before_ms * 1000 + 150_000;
        while bench.now_us < anew_us + 150_000 - TICK_US {
            bench.run(1);
        }
        bench.age_ms = age_ms;
        let want = if age_ms > REQUEST_AGE_MS { LATE } else { Reply::Done };
        assert_eq!(bench.ask(ARM), want, "{} ms", milliseconds(bench.now_us));
        assert!(milliseconds(bench.now_us) < 160, "it has begun anew");
    }
}

/// Old setpoints are none: with nothing but such the vehicle comes down as with none.
#[test]
fn late_setpoints_are_not_flown() {
    let mut bench = Bench::flying();
    bench.stream_age_ms = REQUEST_AGE_MS;
    bench.run(800);
    assert_eq!(bench.logic.state(), FlightState::Tracking);
    bench.stream_age_ms = REQUEST_AGE_MS + 1;
    let ticks = bench.run_while(FlightState::Tracking, 200);
    assert!(ticks <= FRESH_TICKS + 9, "{ticks}");
    assert_eq!(bench.logic.state(), FlightState::Recovery);
    // They count as lost as soon as a newer one tells by its number, and once.
    let lost = bench.telemetry().setpoints_lost;
    let late = bench.sequence;
    bench.stream_age_ms = 0;
    bench.run(9);
    assert_eq!(bench.logic.state(), FlightState::Tracking);
    let telemetry = bench.telemetry();
    assert!(telemetry.setpoints_lost > lost && telemetry.setpoints_lost - lost < u32::from(late));
}

/// Nobody takes off by what was asked for long ago.
#[test]
fn late_setpoints_lift_nothing() {
    let mut bench = Bench::armed();
    bench.stream = Some(HOVER);
    bench.stream_age_ms = REQUEST_AGE_MS + 1;
    bench.run_while(FlightState::Armed, 500);
    assert_eq!(bench.logic.state(), FlightState::Disarmed, "nobody is there");
    assert_eq!(bench.abort(), Some(AbortReason::HeartbeatLost));
}

/// A sign of life that a bridge held back is none.
#[test]
fn late_heartbeats_hold_nothing_armed() {
    for (age_ms, state) in [(REQUEST_AGE_MS, FlightState::Armed), (REQUEST_AGE_MS + 1, FlightState::Disarmed)]
    {
        let mut bench = Bench::armed();
        bench.stream_age_ms = age_ms;
        bench.run(410);
        assert_eq!(bench.logic.state(), state, "{age_ms} ms");
    }
}

/// What has been done is not refused because its repetition is late: its answer was lost.
#[test]
fn late_repetitions_are_told_that_it_is_done() {
    let mut armed = Bench::armed().aged(10_000);
    assert_eq!(armed.ask(ARM), Reply::Done);

    let mut flying = Bench::in_state(FlightState::Tracking);
    assert_eq!(flying.trigger(), Reply::Done);
    let number = flying.number;
    flying.run(80);
    flying.age_ms = 10_000;
    flying.number = number - 1;
    assert_eq!(flying.ask(Request::Trigger { checksum: table().checksum() }), Reply::Done);
    assert_eq!(flying.logic.state(), FlightState::Maneuver);
    // Under that number, but for another table: it was not that one which flew.
    flying.number = number - 1;
    assert_eq!(flying.ask(Request::Trigger { checksum: 1 }), LATE);

    let mut tested = Bench::ready();
    assert_eq!(tested.ask(Request::Arm(Purpose::MotorTest)), Reply::Done);
    let test = Request::TestMotor { motor: 0, throttle: 0.1, duration_ms: 500 };
    assert_eq!(tested.ask(test.clone()), Reply::Done);
    tested.age_ms = 10_000;
    tested.number -= 1;
    assert_eq!(tested.ask(test.clone()), Reply::Done);
    assert_eq!(tested.ask(test), LATE, "another one");
}

/// What has no time says not that its host is there: a bridge may have kept it.
#[test]
fn what_has_no_time_holds_nothing_armed() {
    let mut bench = Bench::armed();
    bench.heartbeat = false;
    for _ in 0..9 {
        bench.ask(Request::Status);
        bench.run(49);
    }
    assert_eq!(bench.logic.state(), FlightState::Disarmed);
    assert_eq!(bench.abort(), Some(AbortReason::HeartbeatLost));
}

/// A host that begins anew in the air, with any number, is followed once its last setpoint is no longer fresh.
#[test]
fn a_host_may_begin_anew() {
    let mut bench = Bench::flying();
    bench.run(8 * 40);
    let before = bench.sequence;
    assert!(before > 30);
    // Overtaken on the way: not flown while there is a newer one.
    let other = Setpoint { thrust_mps2: 5.0, ..HOVER };
    let behind = Request::Setpoint { sequence: before - 3, setpoint: other };
    bench.tick(&[behind]);
    bench.tick(&[]);
    assert_eq!(bench.out.setpoint.thrust_mps2, HOVER.thrust_mps2);
    bench.stream = None;
    bench.run(FRESH_TICKS + 20);
    assert_eq!(bench.logic.state(), FlightState::Recovery);
    // The very same one again is a copy.
    bench.tick(&[Request::Setpoint { sequence: before, setpoint: HOVER }]);
    bench.tick(&[]);
    assert_eq!(bench.logic.state(), FlightState::Recovery);
    let lost = bench.telemetry().setpoints_lost;
    bench.sequence = 0;
    bench.stream = Some(HOVER);
    bench.run(400);
    assert_eq!(bench.logic.state(), FlightState::Tracking);
    assert_eq!(bench.telemetry().setpoints_lost, lost, "none of the new host's");
}

/// However much is asked, telemetry comes: without it no request is in time.
#[test]
fn telemetry_has_a_place_of_its_own() {
    let mut logic = Bench::ready().logic;
    let mut outbox = Outbox::new();
    let mut said = 0;
    let begin = 900;
    for tick in begin..begin + 800 {
        let now_us = tick * TICK_US;
        let mut inbox = Inbox::new();
        for number in 0..4 {
            let request = Request::ReadVehicle;
            inbox
                .push_back(Uplink { version: PROTOCOL_VERSION, number, request, heard_ms: 0 })
                .expect("room");
        }
        let imu = Some(ImuSample { gyro_radps: [0.0; 3], accel_mps2: [0.0, 0.0, 9.81] });
        let input = TickInput { now_us, imu, battery_v: Some(15.5), kill: KillSwitch::Run };
        logic.tick(&input, &mut inbox, &mut outbox);
        logic.telemeter(&mut outbox);
        // The line carries one answer a tick.
        said += usize::from(matches!(outbox.pop_front(), Some(Message::Telemetry(_))));
    }
    assert!(said >= 49, "{said} in a second");
}

/// What stops is obeyed however old it is.
#[test]
fn a_stop_is_never_late() {
    for state in [FlightState::Armed, FlightState::Tracking, FlightState::Maneuver, FlightState::Recovery] {
        for (request, end) in
            [(Request::Disarm, FlightState::Disarmed), (Request::EmergencyStop, FlightState::Terminated)]
        {
            let mut bench = Bench::in_state(state).aged(3_600_000);
            assert_eq!(bench.ask(request), Reply::Done);
            assert_eq!(bench.logic.state(), end);
        }
    }
}

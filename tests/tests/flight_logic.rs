//! The flight logic tick by tick: arming, the link, messages, and that a lost host lifts and drops nothing.

mod logic;

use logic::{BOTH, Bench, FRESH_TICKS, HOVER, Record, TICK_US, chunk};
use mintime_firmware::config::VehicleConfig;
use mintime_firmware::flight::{Inbox, Outbox, TickInput};
use mintime_firmware::gyro::ImuSample;
use mintime_firmware::vehicle::Vehicle;
use mintime_shared::framing::encode;
use mintime_shared::messages::{
    AbortReason, ArmingBlock, FlightState, KillSwitch, Message, PROTOCOL_VERSION, Purpose, RECORD_BYTES,
    Refusal, Reply, Request, Setpoint, Uplink,
};
use mintime_shared::settings::Settings;

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

/// Nor does anybody arm by it.
#[test]
fn a_clock_that_runs_backwards_arms_nothing() {
    let mut bench = Bench::ready();
    bench.now_us -= 2 * TICK_US;
    let refusal = bench.refusal(Request::Arm(Purpose::Flight));
    assert_eq!(refusal, Refusal::WrongState(FlightState::Disarmed));
    bench.run(2);
    bench.arm();
}

/// A motor test that comes again under its number goes on; it does not begin anew, nor after it is over.
#[test]
fn a_motor_test_that_is_repeated_lasts_its_time() {
    let mut bench = Bench::ready();
    assert_eq!(bench.ask(Request::Arm(Purpose::MotorTest)), Reply::Done);
    let test = Request::TestMotor { motor: 0, throttle: 0.1, duration_ms: 100 };
    let turns = |bench: &Bench| bench.out.throttle.expect("armed").iter().any(|t| *t > 0.0);
    let number = bench.number;
    let mut turned = 0;
    for _ in 0..300 {
        bench.number = number;
        assert_eq!(bench.ask(test.clone()), Reply::Done);
        turned += usize::from(turns(&bench));
    }
    assert_eq!(turned, 80);
    // Another number is another test.
    assert_eq!(bench.ask(test), Reply::Done);
    bench.tick(&[]);
    assert!(turns(&bench));
}

/// Without a kill switch a motor under test gets no more than its share of the thrust that is allowed on the bench.
#[test]
fn a_motor_test_keeps_to_the_bench_cap() {
    for bench_thrust_mps2 in [0.3, 1.0] {
        let mut bench = Bench::ready();
        let settings = Settings { bench_thrust_mps2, ..Settings::DEFAULT };
        assert_eq!(bench.ask(Request::WriteSettings(settings)), Reply::Done);
        bench.kill = KillSwitch::Absent;
        assert_eq!(bench.ask(Request::Arm(Purpose::MotorTest)), Reply::Done);
        let throttle = mintime_shared::messages::MOTOR_TEST_THROTTLE_MAX;
        assert_eq!(bench.ask(Request::TestMotor { motor: 0, throttle, duration_ms: 500 }), Reply::Done);
        bench.tick(&[]);
        let told = bench.out.throttle.expect("armed").into_iter().fold(0.0, f32::max);
        let config = VehicleConfig::REFERENCE;
        let share = config.thrust_linear_share;
        let volts = bench.battery_v.expect("a battery") / config.battery_nominal_v;
        let thrust_n = config.rotor_thrust_max_n * ((1.0 - share) * told + share) * told * volts * volts;
        let most_n = (bench_thrust_mps2 * config.mass_kg / 4.0).max(config.rotor_thrust_idle_n);
        assert!(told > 0.0 && thrust_n <= most_n * 1.001, "{thrust_n} N of {most_n}");
        assert!(thrust_n >= most_n * 0.999 || told == throttle, "{thrust_n} N of {most_n}");
    }
}

/// A request is the one before only as long as it is asked again: another host may begin with the same number.
#[test]
fn a_calibration_under_a_number_of_long_ago_is_a_new_one() {
    let mut bench = Bench::ready();
    let turns = Request::CalibrateScale { axis: 2, turns: 1 };
    for request in [Request::Calibrate, turns] {
        let number = bench.number;
        let again = |bench: &mut Bench| {
            bench.number = number;
            bench.ask(request.clone())
        };
        let settle = |bench: &mut Bench| {
            for pending in 0..20_000 {
                let reply = again(bench);
                if reply != Reply::Pending {
                    assert_eq!(again(bench), reply, "its answer was lost");
                    return (pending, reply);
                }
                bench.run(1);
            }
            panic!("pending for ever");
        };
        let (first, reply) = settle(&mut bench);
        assert!(first > 10, "{request:?}");
        bench.run(13_000);
        let (second, same) = settle(&mut bench);
        assert!(second > 10 && same == reply, "{request:?}: {second}, {same:?} after {reply:?}");
    }
}

/// A lost link lifts nothing: a vehicle that was not asked to lift since it was armed gets no more thrust than it was asked for
/// last, and no torque to right it, wherever it leans; and soon it knows that it stands.
#[test]
fn a_lost_link_does_not_lift() {
    for asked_mps2 in [1.0, 1.5, 3.0, 5.0, 0.74 * 9.81] {
        for leans_rad in [0.0, 0.2] {
            let mut bench = Bench::armed();
            bench.stands = true;
            bench.stream = Some(Setpoint { rates_radps: [0.0; 3], thrust_mps2: asked_mps2 });
            bench.run(40);
            assert_eq!(bench.logic.state(), FlightState::Tracking);
            bench.stream =
                Some(Setpoint { rates_radps: [leans_rad / 0.25, 0.0, 0.0], thrust_mps2: asked_mps2 });
            bench.run(200);
            bench.stream = None;
            bench.run_while(FlightState::Tracking, FRESH_TICKS + 20);
            let mut ticks = 0;
            while bench.logic.state() == FlightState::Recovery {
                let Setpoint { rates_radps, thrust_mps2 } = bench.out.setpoint;
                assert!(thrust_mps2 <= asked_mps2 && rates_radps == [0.0; 3], "{:?}", bench.out.setpoint);
                bench.run(1);
                ticks += 1;
            }
            assert_eq!(bench.logic.state(), FlightState::Landed, "{asked_mps2} {leans_rad}");
            assert!((280..480).contains(&ticks), "{ticks} ticks");
        }
    }
}

/// In the air little may have been asked for a moment only: who was asked to lift since arming is not dropped. Standing, it is
/// not lifted, not with a thrust map a fifth off either; and another arming begins anew.
#[test]
fn a_lost_link_does_not_drop() {
    let mut bench = Bench::flying();
    for round in 0..2 {
        bench.stands = true;
        bench.stream = Some(Setpoint { rates_radps: [0.0; 3], thrust_mps2: 1.5 });
        bench.run(40);
        bench.stream = None;
        bench.run_while(FlightState::Tracking, FRESH_TICKS + 20);
        let begins_mps2 = bench.out.setpoint.thrust_mps2;
        let wanted = if round == 0 { 0.72 * 9.81..0.9 * 9.81 } else { 1.4..1.6 };
        assert!(wanted.contains(&begins_mps2), "{begins_mps2}");
        while bench.logic.state() == FlightState::Recovery {
            assert!(bench.out.setpoint.thrust_mps2 < 9.81 / 1.2, "{:?}", bench.out.setpoint);
            bench.run(1);
        }
        assert_eq!(bench.logic.state(), FlightState::Landed);
        assert_eq!(bench.ask(Request::Disarm), Reply::Done);
        bench.run(500);
        bench.arm();
    }
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

// ---------------------------------------------------------------------------------------------------------- messages

#[test]
fn another_protocol_version_is_refused_and_nothing_done() {
    for version in [0, PROTOCOL_VERSION - 1, PROTOCOL_VERSION + 1, 255] {
        let mut bench = Bench::flying();
        let mut inbox = Inbox::new();
        let mut outbox = Outbox::new();
        for (number, request) in [Request::EmergencyStop, Request::Disarm].into_iter().enumerate() {
            inbox.push_back(Uplink { version, number: number as u16, request, heard_ms: 0 }).expect("room");
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
    const READY_TICKS: u64 = 900;
    const READY_MS: u32 = (READY_TICKS * TICK_US / 1000) as u32;
    for place in 0..12 {
        let mut vehicle = Vehicle::new(Some(VehicleConfig::REFERENCE), BOTH, vec![[0; RECORD_BYTES]; 100]);
        let send = |vehicle: &mut Vehicle<Record>, request| {
            let uplink = Uplink { version: PROTOCOL_VERSION, number: 1, request, heard_ms: READY_MS };
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
        for _ in 0..READY_TICKS {
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

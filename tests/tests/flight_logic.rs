//! The flight logic tick by tick: what it refuses, what it does about each fault, and that it does the same every time.

use mintime_firmware::config::{BoardStatus, Capabilities, VehicleConfig};
use mintime_firmware::flight::{FlightLogic, Inbox, Outbox, TickInput, TickOutput};
use mintime_firmware::gyro::ImuSample;
use mintime_firmware::vehicle::Vehicle;
use mintime_shared::framing::{Decoder, encode};
use mintime_shared::messages::{
    AbortReason, ArmingBlock, BoardTelemetry, Downlink, FlightState, Message, PROTOCOL_VERSION, RECORD_BYTES,
    RecordedTick, Refusal, Reply, Request, Setpoint, Telemetry, Uplink,
};
use mintime_shared::replay::{Plan, Replay, Step, TickPeriod};
use mintime_shared::table::{MAX_TABLE_BYTES, ManeuverTable, TableError};
use mintime_tests::reference_cases;
use proptest::prelude::*;

const TICK_US: u64 = 1250;
/// Ticks that a setpoint stays fresh.
const FRESH_TICKS: usize = 80;

type Record = Vec<[u8; RECORD_BYTES]>;

/// A flight logic on a bench: every tick by hand, with a gyro that shows what was asked.
struct Bench {
    logic: FlightLogic<Record>,
    now_us: u64,
    number: u16,
    battery_v: Option<f32>,
    kill: bool,
    /// Streamed every eight ticks, as a host does.
    stream: Option<Setpoint>,
    ticks: usize,
    out: TickOutput,
    said: Vec<Message>,
}

const HOVER: Setpoint = Setpoint { rates_radps: [0.0; 3], thrust_mps2: 9.81 };

impl Bench {
    fn new() -> Self {
        Self::with(Capabilities { gyro: true, motors: true })
    }

    fn with(capabilities: Capabilities) -> Self {
        Self {
            logic: FlightLogic::new(VehicleConfig::REFERENCE, capabilities, vec![[0; RECORD_BYTES]; 3200]),
            now_us: 0,
            number: 0,
            battery_v: Some(15.5),
            kill: false,
            stream: None,
            ticks: 0,
            out: TickOutput::default(),
            said: Vec::new(),
        }
    }

    /// Switched on, calibrated, ready to arm.
    fn ready() -> Self {
        let mut bench = Self::new();
        bench.run(900);
        assert_eq!(bench.telemetry().arming_block, 0, "{}", ArmingBlock(bench.telemetry().arming_block));
        bench
    }

    fn armed() -> Self {
        let mut bench = Self::ready();
        bench.arm();
        bench
    }

    fn arm(&mut self) {
        assert_eq!(self.ask(Request::Arm(Purpose::Flight)), Reply::Done);
        assert_eq!(self.logic.state(), FlightState::Armed);
    }

    fn flying() -> Self {
        let mut bench = Self::armed();
        bench.stream = Some(HOVER);
        bench.run(20);
        assert_eq!(bench.logic.state(), FlightState::Tracking);
        bench
    }

    /// In a state, by requests and the passing of time alone. In the air a table is committed.
    fn in_state(state: FlightState) -> Self {
        let mut bench = Self::ready();
        if state != FlightState::Disarmed {
            bench.commit(&table());
            bench.arm();
        }
        match state {
            FlightState::Disarmed | FlightState::Armed => {}
            FlightState::Terminated => assert_eq!(bench.ask(Request::EmergencyStop), Reply::Done),
            FlightState::Tracking | FlightState::Maneuver | FlightState::Recovery => {
                bench.stream = Some(HOVER);
                bench.run(20);
                if state == FlightState::Maneuver {
                    assert_eq!(bench.trigger(), Reply::Done);
                    bench.run(50);
                }
                if state == FlightState::Recovery {
                    bench.stream = None;
                    bench.run(FRESH_TICKS + 20);
                }
            }
        }
        assert_eq!(bench.logic.state(), state);
        bench
    }

    fn maneuver() -> Self {
        Self::in_state(FlightState::Maneuver)
    }

    /// A sample as a perfect vehicle would give it: the setpoint, and noise that never repeats.
    fn sample(&self) -> ImuSample {
        let noise = 1e-3 * ((self.ticks % 17) as f32 - 8.0) / 8.0;
        ImuSample {
            gyro_radps: self.out.setpoint.rates_radps.map(|r| r + noise),
            accel_mps2: [0.0, 0.0, 9.81],
        }
    }

    fn tick_with(&mut self, imu: Option<ImuSample>, interval_us: u64, requests: &[Request]) {
        self.now_us += interval_us;
        let mut inbox = Inbox::new();
        let mut requests = requests.to_vec();
        if let Some(setpoint) = self.stream.filter(|_| self.ticks.is_multiple_of(8)) {
            requests.push(Request::Setpoint(setpoint));
        }
        for request in requests {
            self.number = self.number.wrapping_add(1);
            inbox
                .push_back(Uplink { version: PROTOCOL_VERSION, number: self.number, request })
                .expect("the inbox has room");
        }
        let mut outbox = Outbox::new();
        let input = TickInput { now_us: self.now_us, imu, battery_v: self.battery_v, kill: self.kill };
        self.out = self.logic.tick(&input, &mut inbox, &mut outbox);
        self.logic.telemeter(&mut outbox);
        assert!(inbox.is_empty());
        check_throttles(&self.out, self.logic.state());
        self.ticks += 1;
        self.said.extend(outbox.iter().cloned());
    }

    fn tick(&mut self, requests: &[Request]) {
        let sample = self.sample();
        self.tick_with(Some(sample), TICK_US, requests);
    }

    fn run(&mut self, ticks: usize) {
        for _ in 0..ticks {
            self.tick(&[]);
        }
    }

    /// Runs until a state is left; how many ticks that took.
    fn run_while(&mut self, state: FlightState, most: usize) -> usize {
        for ticks in 0..most {
            if self.logic.state() != state {
                return ticks;
            }
            self.tick(&[]);
        }
        panic!("still {state:?} after {most} ticks");
    }

    /// The answer to the request sent last.
    fn answer(&self, number: u16) -> Option<Reply> {
        self.said.iter().rev().find_map(|m| match m {
            Message::Reply { number: n, reply } if *n == number => Some(reply.clone()),
            _ => None,
        })
    }

    fn ask(&mut self, request: Request) -> Reply {
        let number = self.number.wrapping_add(1);
        self.tick(&[request]);
        self.answer(number).expect("an answer in the same tick")
    }

    fn refusal(&mut self, request: Request) -> Refusal {
        match self.ask(request) {
            Reply::Refused(refusal) => refusal,
            reply => panic!("not refused: {reply:?}"),
        }
    }

    fn telemetry(&mut self) -> Telemetry {
        match self.ask(Request::Status) {
            Reply::Status(telemetry) => telemetry,
            reply => panic!("no status: {reply:?}"),
        }
    }

    fn abort(&mut self) -> Option<AbortReason> {
        self.telemetry().abort
    }

    fn read_table(&mut self) -> Vec<u8> {
        match self.ask(Request::ReadTable) {
            Reply::Table(bytes) => bytes.to_vec(),
            reply => panic!("no table: {reply:?}"),
        }
    }

    fn commit(&mut self, table: &ManeuverTable) {
        let reply = self.ask(stage(table));
        assert!(matches!(reply, Reply::Staged { .. }), "{reply:?}");
        let reply = self.ask(Request::CommitTable { checksum: table.checksum() });
        assert_eq!(reply, Reply::Committed { duration_s: table.duration_s() });
    }

    fn trigger(&mut self) -> Reply {
        self.ask(Request::Trigger { checksum: table().checksum() })
    }

    fn record(&mut self) -> Vec<RecordedTick> {
        let mut record = Vec::new();
        loop {
            let first = record.len() as u32;
            let Reply::Record(chunk) = self.ask(Request::ReadRecord { first }) else {
                panic!("no record");
            };
            assert_eq!(chunk.first, first);
            let (ticks, rest) = chunk.bytes.as_chunks::<RECORD_BYTES>();
            assert!(rest.is_empty());
            record.extend(ticks.iter().map(RecordedTick::from_bytes));
            if record.len() as u32 == chunk.total {
                return record;
            }
            assert!(!ticks.is_empty());
        }
    }
}

/// No throttle without motors, and none out of range with them.
fn check_throttles(out: &TickOutput, state: FlightState) {
    assert_eq!(out.throttle.is_some(), state.motors_on(), "{state:?}");
    for throttle in out.throttle.iter().flatten() {
        assert!((0.0..=1.0).contains(throttle), "{throttle}");
    }
    assert!(out.setpoint.is_finite());
}

fn table_of(name: &str) -> ManeuverTable {
    reference_cases().into_iter().find(|c| c.name == name).expect("the case exists").table()
}

fn table() -> ManeuverTable {
    table_of("general_5_5")
}

fn bytes_of(table: &ManeuverTable) -> heapless::Vec<u8, MAX_TABLE_BYTES> {
    let mut buffer = [0; MAX_TABLE_BYTES];
    let length = table.encode(&mut buffer).expect("it fits");
    heapless::Vec::from_slice(&buffer[..length]).expect("it fits")
}

fn stage(table: &ManeuverTable) -> Request {
    Request::StageTable(bytes_of(table))
}

const ALL_STATES: [FlightState; 6] = [
    FlightState::Disarmed,
    FlightState::Armed,
    FlightState::Tracking,
    FlightState::Maneuver,
    FlightState::Recovery,
    FlightState::Terminated,
];

// ---------------------------------------------------------------------------------------------------------- arming

/// Each reason that blocks arming, alone where it can be.
#[test]
fn arming_is_refused_for_each_reason() {
    use ArmingBlock as B;
    let blocked = |bench: &mut Bench| {
        let refusal = bench.refusal(Request::Arm(Purpose::Flight));
        assert!(!bench.logic.state().motors_on());
        match refusal {
            Refusal::ArmingBlocked(bits) => ArmingBlock(bits),
            other => panic!("{other:?}"),
        }
    };
    let mut bench = Bench::with(Capabilities { gyro: false, motors: true });
    bench.run(900);
    assert_eq!(blocked(&mut bench), B::NO_GYRO);
    let mut bench = Bench::with(Capabilities { gyro: true, motors: false });
    bench.run(900);
    assert_eq!(blocked(&mut bench), B::NO_MOTORS);

    // While its drivers start a board is not called without gyro and motors yet, but it does not arm either.
    let mut status = BoardStatus {
        capabilities: Capabilities { gyro: false, motors: false },
        starting: true,
        telemetry: BoardTelemetry { missed_ticks: 3, ..BoardTelemetry::default() },
    };
    let mut bench = Bench::new();
    assert_eq!(bench.telemetry().board, None);
    bench.logic.set_board_status(&status);
    bench.run(900);
    assert_eq!(blocked(&mut bench), B::STARTING);
    assert_eq!(bench.telemetry().board, Some(status.telemetry));
    status.starting = false;
    bench.logic.set_board_status(&status);
    assert_eq!(blocked(&mut bench), B::none().when(B::NO_GYRO, true).when(B::NO_MOTORS, true));
    status.capabilities = Capabilities { gyro: true, motors: true };
    bench.logic.set_board_status(&status);
    bench.arm();

    let mut bench = Bench::new();
    bench.run(100);
    assert_eq!(blocked(&mut bench), B::NOT_CALIBRATED);

    let mut bench = Bench::ready();
    for _ in 0..7 {
        bench.tick_with(None, TICK_US, &[]);
    }
    assert_eq!(bench.telemetry().arming_block, 0, "seven samples missing, then one: well");
    for _ in 0..8 {
        bench.tick_with(None, TICK_US, &[]);
    }
    bench.tick_with(None, TICK_US, &[Request::Arm(Purpose::Flight)]);
    let number = bench.number;
    assert_eq!(bench.answer(number), Some(Reply::Refused(Refusal::ArmingBlocked(B::GYRO_SILENT.0))));
    bench.arm();

    let mut bench = Bench::ready();
    let same = bench.sample();
    for _ in 0..402 {
        bench.tick_with(Some(same), TICK_US, &[]);
    }
    bench.tick_with(Some(same), TICK_US, &[Request::Arm(Purpose::Flight)]);
    let number = bench.number;
    assert_eq!(bench.answer(number), Some(Reply::Refused(Refusal::ArmingBlocked(B::GYRO_FROZEN.0))));
    bench.arm();

    // Turned in the hand at 1 rad/s now and then.
    let mut bench = Bench::ready();
    for i in 0..900 {
        let rate = if i % 100 < 10 { 1.0 } else { 0.001 * (i % 7) as f32 };
        bench.tick_with(Some(ImuSample { gyro_radps: [rate, 0.0, 0.0], ..bench.sample() }), TICK_US, &[]);
    }
    assert_eq!(blocked(&mut bench), B::MOVING);
    bench.run(900);
    bench.arm();

    let mut bench = Bench::ready();
    for unknown in [None, Some(f32::NAN), Some(0.0), Some(-3.0), Some(f32::INFINITY)] {
        bench.battery_v = unknown;
        assert_eq!(blocked(&mut bench), B::BATTERY_UNKNOWN, "{unknown:?}");
    }
    bench.battery_v = Some(13.9);
    assert_eq!(blocked(&mut bench), B::BATTERY_LOW);
    bench.battery_v = Some(15.5);
    bench.kill = true;
    assert_eq!(blocked(&mut bench), B::KILL_SWITCH);
    bench.kill = false;
    let sample = bench.sample();
    bench.tick_with(Some(sample), 10_000, &[Request::Arm(Purpose::Flight)]);
    let number = bench.number;
    assert_eq!(bench.answer(number), Some(Reply::Refused(Refusal::ArmingBlocked(B::LATE_TICKS.0))));
    assert_eq!(bench.ask(Request::EmergencyStop), Reply::Done);
    assert_eq!(blocked(&mut bench), B::STOPPED);
    assert_eq!(bench.ask(Request::Disarm), Reply::Done);
    bench.arm();
    // Asked twice is harmless.
    assert_eq!(bench.ask(Request::Arm(Purpose::Flight)), Reply::Done);
}

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

/// A lost link never raises the thrust: a vehicle that stood on the ground goes on standing there.
#[test]
fn a_lost_link_does_not_lift() {
    let mut bench = Bench::armed();
    bench.stream = Some(Setpoint { rates_radps: [0.0; 3], thrust_mps2: 1.5 });
    bench.run(40);
    assert_eq!(bench.logic.state(), FlightState::Tracking);
    bench.stream = None;
    bench.run(FRESH_TICKS + 20);
    assert_eq!(bench.logic.state(), FlightState::Recovery);
    assert_eq!(bench.out.setpoint.thrust_mps2, 1.5);
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
        assert_eq!(bench.refusal(Request::Setpoint(bad)), Refusal::OutOfRange);
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
    bench.tick(&[Request::Setpoint(HOVER)]);
    bench.arm();
    bench.run(100);
    assert_eq!(bench.logic.state(), FlightState::Armed);
    // Nor one that comes in the very tick of arming before the request.
    let mut bench = Bench::ready();
    bench.tick(&[Request::Setpoint(HOVER), Request::Arm(Purpose::Flight)]);
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
    assert_eq!(bench.out.setpoint.rates_radps, [0.0; 3]);
    assert!((9.0..9.8).contains(&bench.out.setpoint.thrust_mps2), "sinks gently");
    bench.run_while(FlightState::Recovery, 2000);
    assert_eq!(bench.logic.state(), FlightState::Terminated);
    assert_eq!(bench.now_us - lost_us, 1_500_000);
    assert_eq!(bench.abort(), Some(AbortReason::LinkLost));
    // Nothing starts it again but a disarm.
    bench.stream = Some(HOVER);
    bench.run(100);
    assert_eq!(bench.logic.state(), FlightState::Terminated);
    assert_eq!(bench.ask(Request::Disarm), Reply::Done);
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
    bench.run(1100);
    assert_eq!(bench.logic.state(), FlightState::Recovery, "1.4 s alone");
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
        assert_eq!(bench.refusal(stage(&other)), Refusal::MotorsOn, "{state:?}");
        assert_eq!(
            bench.refusal(Request::CommitTable { checksum: other.checksum() }),
            Refusal::MotorsOn,
            "{state:?}"
        );
        assert_eq!(bench.read_table(), before, "{state:?}");
        assert_eq!(bench.logic.state(), state);
        // Nothing was staged behind the refusal either.
        bench.ask(Request::EmergencyStop);
        bench.ask(Request::Disarm);
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
    assert_eq!(again, Reply::Committed { duration_s: table().duration_s() });
    let before = bench.read_table();

    let try_bytes = |bench: &mut Bench, bytes: &[u8], checksum: u32| {
        let staged = heapless::Vec::from_slice(bytes).expect("it fits");
        match bench.ask(Request::StageTable(staged)) {
            Reply::Refused(refusal) => refusal,
            Reply::Staged { length } => {
                assert_eq!(usize::from(length), bytes.len());
                bench.refusal(Request::CommitTable { checksum })
            }
            reply => panic!("{reply:?}"),
        }
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
    bench.ask(Request::StageTable(heapless::Vec::from_slice(&own.0).expect("it fits")));
    assert!(matches!(bench.ask(Request::CommitTable { checksum: own.1 }), Reply::Committed { .. }));
    assert_eq!(bench.read_table(), own.0);
}

/// (5, 5) made for a certain vehicle: bytes and checksum.
fn made_for(vehicle: u32) -> (Vec<u8>, u32) {
    let mut bytes = bytes_of(&table()).to_vec();
    bytes.truncate(bytes.len() - 4);
    bytes[4..8].copy_from_slice(&vehicle.to_le_bytes());
    let checksum = mintime_shared::crc32(&bytes);
    bytes.extend(checksum.to_le_bytes());
    (bytes, checksum)
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
        bench.ask(stage(&made));
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
    for state in [FlightState::Disarmed, FlightState::Armed, FlightState::Recovery, FlightState::Terminated] {
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
        bench.stream = Some(HOVER);
        bench.run(20);
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
        assert_eq!(expected.len(), ticks, "{}", case.name);
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
                assert!((recorded - given).abs() < 1e-5);
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
    bench.logic = FlightLogic::new(
        VehicleConfig::REFERENCE,
        Capabilities { gyro: true, motors: true },
        vec![[0; RECORD_BYTES]; 100],
    );
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
            let want = if host { FlightState::Tracking } else { FlightState::Terminated };
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

/// Kill switch, emergency stop and disarm, in every state: motors off in the same tick.
#[test]
fn a_person_stops_it_in_every_state() {
    for state in ALL_STATES {
        let mut bench = Bench::in_state(state);
        assert_eq!(bench.ask(Request::EmergencyStop), Reply::Done);
        assert_eq!((bench.logic.state(), bench.out.throttle), (FlightState::Terminated, None), "{state:?}");
        assert_eq!(bench.abort(), Some(AbortReason::EmergencyStop));

        let mut bench = Bench::in_state(state);
        bench.kill = true;
        bench.tick(&[]);
        let want = if state.motors_on() { FlightState::Terminated } else { state };
        assert_eq!((bench.logic.state(), bench.out.throttle), (want, None), "{state:?}");
        if state.motors_on() {
            assert_eq!(bench.abort(), Some(AbortReason::KillSwitch));
            // The switch must be released before a disarm clears it.
            assert_eq!(bench.refusal(Request::Disarm), Refusal::WrongState(FlightState::Terminated));
            bench.kill = false;
            bench.run(10);
            assert_eq!(bench.logic.state(), FlightState::Terminated);
        }

        let mut bench = Bench::in_state(state);
        assert_eq!(bench.ask(Request::Disarm), Reply::Done);
        assert_eq!((bench.logic.state(), bench.out.throttle), (FlightState::Disarmed, None), "{state:?}");
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
        let mut bench = Bench::in_state(FlightState::Terminated);
        bench.tick(&pair(Request::EmergencyStop, Request::Disarm));
        assert_eq!(bench.logic.state(), FlightState::Terminated);
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
        let input = TickInput { now_us: bench.now_us + TICK_US, imu, battery_v: Some(15.5), kill: false };
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
            assert_eq!(bench.refusal(Request::Setpoint(setpoint)), Refusal::NotFinite);
            assert_eq!(bench.out.setpoint, HOVER);
            // And they do not count as a sign of life.
            bench.stream = None;
            for _ in 0..FRESH_TICKS + 10 {
                bench.tick(&[Request::Setpoint(setpoint)]);
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
            stage(&table()),
            Request::CommitTable { checksum: 5 },
            Request::ReadTable,
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
            bench.tick(&[Request::Setpoint(HOVER), request.clone()]);
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

// -------------------------------------------------------------------------------------------------------- any inputs

/// One tick of an arbitrary life.
#[derive(Clone, Debug)]
struct Moment {
    step_us: u64,
    gyro: Option<[f32; 3]>,
    battery_v: Option<f32>,
    kill: bool,
    requests: Vec<Uplink>,
}

fn any_request() -> impl Strategy<Value = Request> {
    let number = prop_oneof![
        4 => -10f32..10.0,
        1 => prop::num::f32::ANY,
    ];
    prop_oneof![
        3 => Just(Request::Arm(Purpose::Flight)),
        1 => Just(Request::Disarm),
        1 => Just(Request::EmergencyStop),
        1 => Just(Request::Status),
        1 => Just(Request::Identify),
        1 => Just(Request::ReadTable),
        2 => Just(stage(&table())),
        1 => prop::collection::vec(any::<u8>(), 0..=MAX_TABLE_BYTES)
            .prop_map(|b| Request::StageTable(heapless::Vec::from_slice(&b).expect("it fits"))),
        2 => Just(Request::CommitTable { checksum: table().checksum() }),
        1 => any::<u32>().prop_map(|checksum| Request::CommitTable { checksum }),
        6 => Just(Request::Setpoint(HOVER)),
        3 => (prop::array::uniform3(number.clone()), number)
            .prop_map(|(rates_radps, thrust_mps2)| Request::Setpoint(Setpoint { rates_radps, thrust_mps2 })),
        4 => Just(Request::Trigger { checksum: table().checksum() }),
        1 => any::<u32>().prop_map(|checksum| Request::Trigger { checksum }),
        1 => prop_oneof![0u32..2000, any::<u32>()].prop_map(|first| Request::ReadRecord { first }),
    ]
}

prop_compose! {
    fn moment()(
        step_us in prop_oneof![60 => Just(TICK_US), 10 => 0u64..3000, 1 => 0u64..3_000_000, 1 => any::<u64>()],
        gyro in prop_oneof![
            20 => prop::array::uniform3(-0.02f32..0.02).prop_map(Some),
            2 => prop::array::uniform3(-40f32..40.0).prop_map(Some),
            1 => prop::array::uniform3(prop::num::f32::ANY).prop_map(Some),
            1 => Just(None),
        ],
        battery_v in prop_oneof![20 => Just(Some(15.5)), 1 => prop::option::of(prop::num::f32::ANY)],
        kill in prop::bool::weighted(0.004),
        requests in prop::collection::vec(
            (prop_oneof![50 => Just(PROTOCOL_VERSION), 1 => any::<u8>()], any::<u16>(), any_request()),
            0..4,
        ),
    ) -> Moment {
        let requests = requests.into_iter().map(|(version, number, request)| Uplink { version, number, request }).collect();
        Moment { step_us, gyro, battery_v, kill, requests }
    }
}

/// Lives through moments after a second of stillness, checking every tick. Returns all that came out, as text: bit for
/// bit, since `f32` prints so that it reads back.
fn live(moments: &[Moment]) -> (Vec<FlightState>, String) {
    let mut logic = FlightLogic::new(
        VehicleConfig::REFERENCE,
        Capabilities { gyro: true, motors: true },
        vec![[0; RECORD_BYTES]; 400],
    );
    let mut outbox = Outbox::new();
    let mut now_us = 0u64;
    let mut story = String::new();
    let mut states = Vec::new();
    let still = (0..850).map(|i| Moment {
        step_us: TICK_US,
        gyro: Some([1e-3 * (i % 7) as f32; 3]),
        battery_v: Some(15.5),
        kill: false,
        requests: Vec::new(),
    });
    for moment in still.chain(moments.iter().cloned()) {
        now_us = now_us.saturating_add(moment.step_us);
        let mut inbox = Inbox::new();
        for uplink in moment.requests {
            inbox.push_back(uplink).expect("three at most");
        }
        let input = TickInput {
            now_us,
            imu: moment.gyro.map(|gyro_radps| ImuSample { gyro_radps, accel_mps2: [0.0; 3] }),
            battery_v: moment.battery_v,
            kill: moment.kill,
        };
        let out = logic.tick(&input, &mut inbox, &mut outbox);
        logic.telemeter(&mut outbox);
        check_throttles(&out, logic.state());
        states.push(logic.state());
        story += &format!("{out:?}");
        while let Some(message) = outbox.pop_front() {
            // Everything it says can be sent.
            let frame = encode(&Downlink { version: PROTOCOL_VERSION, message }).expect("it fits a frame");
            story += &format!("{:?}", frame.as_bytes());
        }
    }
    (states, story)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(600))]

    #[test]
    fn no_input_makes_it_panic_or_leave_its_range(moments in prop::collection::vec(moment(), 1..250)) {
        let (states, story) = live(&moments);
        prop_assert_eq!(live(&moments), (states, story), "the same inputs gave other outputs");
    }

    /// Any bytes on the line.
    #[test]
    fn no_bytes_on_the_line_make_it_panic(
        chunks in prop::collection::vec((prop::collection::vec(any::<u8>(), 0..400), prop::option::of(any_request())), 1..40),
    ) {
        let mut vehicle = Vehicle::new(
            VehicleConfig::REFERENCE,
            Capabilities { gyro: true, motors: true },
            vec![[0; RECORD_BYTES]; 100],
        );
        let mut decoder = Decoder::new();
        for (tick, (noise, request)) in (1u64..).zip(chunks) {
            vehicle.receive(&noise);
            vehicle.receive(&[0]);
            let asked = request.is_some_and(|r| !matches!(r, Request::Setpoint(_)) && {
                let uplink = Uplink { version: PROTOCOL_VERSION, number: 77, request: r };
                vehicle.receive(encode(&uplink).expect("it fits").as_bytes());
                true
            });
            let imu = Some(ImuSample { gyro_radps: [1e-3 * (tick % 3) as f32; 3], accel_mps2: [0.0; 3] });
            vehicle.tick(&TickInput { now_us: tick * TICK_US, imu, battery_v: Some(15.0), kill: false });
            // What it says is messages, and among them the answer, noise or not.
            let mut out = [0; 4000];
            let length = vehicle.transmit(&mut out);
            let mut answered = false;
            for &byte in &out[..length] {
                let Some(said) = decoder.push::<Downlink>(byte) else { continue };
                let said = said.expect("a sound frame");
                answered |= matches!(said.message, Message::Reply { number: 77, .. });
            }
            prop_assert_eq!(answered, asked);
        }
    }
}

/// The lives above are not all spent on the ground.
#[test]
fn arbitrary_lives_reach_every_state() {
    use proptest::strategy::ValueTree;
    use proptest::test_runner::TestRunner;
    let mut runner = TestRunner::deterministic();
    let mut seen = [false; 6];
    for _ in 0..60 {
        let moments = prop::collection::vec(moment(), 250)
            .new_tree(&mut runner)
            .expect("moments can be drawn")
            .current();
        for state in live(&moments).0 {
            seen[ALL_STATES.iter().position(|s| *s == state).expect("a known state")] = true;
        }
    }
    assert_eq!(seen, [true; 6], "{ALL_STATES:?}");
}

/// More requests than fit the inbox, at one instant: an emergency stop among them is not lost.
#[test]
fn an_emergency_stop_finds_room() {
    for place in 0..12 {
        let mut vehicle = Vehicle::new(
            VehicleConfig::REFERENCE,
            Capabilities { gyro: true, motors: true },
            vec![[0; RECORD_BYTES]; 100],
        );
        let send = |vehicle: &mut Vehicle<Record>, request| {
            let uplink = Uplink { version: PROTOCOL_VERSION, number: 1, request };
            vehicle.receive(encode(&uplink).expect("it fits").as_bytes());
        };
        let mut now_us = 0;
        let mut tick = |vehicle: &mut Vehicle<Record>| {
            now_us += TICK_US;
            let imu =
                Some(ImuSample { gyro_radps: [1e-6 * (now_us % 7000) as f32; 3], accel_mps2: [0.0; 3] });
            vehicle.tick(&TickInput { now_us, imu, battery_v: Some(15.0), kill: false })
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

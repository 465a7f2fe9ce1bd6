//! A flight logic on a bench: every tick by hand, with a gyro that shows what was asked, a battery, a kill switch and, where
//! it has one, a store.

#![allow(dead_code, reason = "each test file uses its part")]

use std::sync::LazyLock;

use mintime_firmware::config::{BoardStatus, Capabilities, RATE_RESPONSE_S, StoreStatus, VehicleConfig};
use mintime_firmware::flight::{FlightLogic, Inbox, Outbox, TickInput, TickOutput};
use mintime_firmware::gyro::ImuSample;
use mintime_firmware::keeping::{Job, Key};
use mintime_shared::messages::{
    AbortReason, ArmingBlock, BoardTelemetry, FlightState, KillSwitch, Message, PROTOCOL_VERSION, Purpose,
    RECORD_BYTES, RecordedTick, Refusal, Reply, Request, STAGE_CHUNK_BYTES, Setpoint, TableName, Telemetry,
    Uplink, milliseconds,
};
use mintime_shared::table::{MAX_TABLE_BYTES, ManeuverTable};
use mintime_tests::reference_cases;

pub(crate) const TICK_US: u64 = 1250;
/// Ticks that a setpoint stays fresh.
pub(crate) const FRESH_TICKS: usize = 80;
pub(crate) const HOVER: Setpoint = Setpoint { rates_radps: [0.0; 3], thrust_mps2: 9.81 };
pub(crate) const BOTH: Capabilities = Capabilities { gyro: true, motors: true };

pub(crate) type Record = Vec<[u8; RECORD_BYTES]>;

/// A board's store: takes a job, is busy for some ticks, keeps it or fails.
#[derive(Clone, Debug, Default)]
pub(crate) struct Store {
    pub(crate) kept: Vec<(Key, Vec<u8>)>,
    pub(crate) fails: bool,
    /// Ticks that a job takes.
    pub(crate) ticks: usize,
    pub(crate) under_way: Option<(Job, usize)>,
    pub(crate) finished: u32,
    pub(crate) failed: bool,
    /// Jobs done.
    pub(crate) jobs: usize,
}

impl Store {
    /// One tick of the board, given what the flight logic wants written.
    pub(crate) fn work(&mut self, job: Option<&Job>) -> StoreStatus {
        if self.under_way.is_none()
            && let Some(job) = job.filter(|job| job.ticket != self.finished)
        {
            self.under_way = Some((job.clone(), self.ticks));
        }
        if let Some((job, left)) = &mut self.under_way {
            if *left > 0 {
                *left -= 1;
            } else {
                (self.finished, self.failed) = (job.ticket, self.fails);
                self.jobs += 1;
                if !self.fails {
                    self.kept.retain(|(key, _)| *key != job.key);
                    if !job.value.is_empty() {
                        self.kept.push((job.key, job.value.to_vec()));
                    }
                }
                self.under_way = None;
            }
        }
        StoreStatus {
            present: true,
            busy: self.under_way.is_some(),
            finished: self.finished,
            failed: self.failed,
        }
    }
}

pub(crate) struct Bench {
    pub(crate) logic: FlightLogic<Record>,
    pub(crate) now_us: u64,
    pub(crate) number: u16,
    pub(crate) sequence: u16,
    pub(crate) battery_v: Option<f32>,
    pub(crate) kill: KillSwitch,
    /// Streamed every eight ticks, as a host does.
    pub(crate) stream: Option<Setpoint>,
    /// A sign of life every hundred ticks, as a host gives it.
    pub(crate) heartbeat: bool,
    /// How long ago the host heard the vehicle when it asked, ms ...
    pub(crate) age_ms: u32,
    /// ... and when it streamed or gave a sign of life.
    pub(crate) stream_age_ms: u32,
    /// It stands on something, whatever its motors do.
    pub(crate) stands: bool,
    pub(crate) store: Option<Store>,
    /// Body rates: those of a healthy vehicle, as the rate loop expects them.
    rates_radps: [f32; 3],
    pub(crate) ticks: usize,
    pub(crate) out: TickOutput,
    pub(crate) said: Vec<Message>,
}

impl Bench {
    pub(crate) fn new() -> Self {
        Self::with(BOTH)
    }

    pub(crate) fn with(capabilities: Capabilities) -> Self {
        Self::of(FlightLogic::new(
            Some(VehicleConfig::REFERENCE),
            capabilities,
            vec![[0; RECORD_BYTES]; 3200],
        ))
    }

    pub(crate) fn of(logic: FlightLogic<Record>) -> Self {
        Self {
            logic,
            now_us: 0,
            number: 0,
            sequence: 0,
            battery_v: Some(15.5),
            kill: KillSwitch::Run,
            stream: None,
            heartbeat: true,
            age_ms: 0,
            stream_age_ms: 0,
            stands: false,
            store: None,
            rates_radps: [0.0; 3],
            ticks: 0,
            out: TickOutput::default(),
            said: Vec::new(),
        }
    }

    /// Switched on, calibrated, ready to arm.
    pub(crate) fn ready() -> Self {
        let mut bench = Self::new();
        bench.run(900);
        assert_eq!(bench.telemetry().arming_block, 0, "{}", ArmingBlock(bench.telemetry().arming_block));
        bench
    }

    /// The same, with a store.
    pub(crate) fn with_store() -> Self {
        let mut bench = Self::ready();
        bench.store = Some(Store { ticks: 5, ..Store::default() });
        bench.run(2);
        bench
    }

    pub(crate) fn armed() -> Self {
        let mut bench = Self::ready();
        bench.arm();
        bench
    }

    pub(crate) fn arm(&mut self) {
        assert_eq!(self.ask(Request::Arm(Purpose::Flight)), Reply::Done);
        assert_eq!(self.logic.state(), FlightState::Armed);
    }

    pub(crate) fn flying() -> Self {
        let mut bench = Self::armed();
        bench.stream = Some(HOVER);
        bench.run(20);
        assert_eq!(bench.logic.state(), FlightState::Tracking);
        bench
    }

    /// In a state, by requests and the passing of time alone. From armed on a table is committed.
    pub(crate) fn in_state(state: FlightState) -> Self {
        if matches!(state, FlightState::Boot | FlightState::Calibrating) {
            let mut bench = Self::new();
            if state == FlightState::Boot {
                bench.logic.set_board_status(&status(Capabilities { gyro: false, motors: true }, true));
            }
            bench.run(50);
            assert_eq!(bench.logic.state(), state);
            return bench;
        }
        let mut bench = Self::ready();
        if state != FlightState::Disarmed {
            bench.commit(&table());
            bench.arm();
        }
        if state == FlightState::Terminated {
            assert_eq!(bench.ask(Request::EmergencyStop), Reply::Done);
        }
        if state.airborne() || state == FlightState::Landed {
            bench.stream = Some(HOVER);
            bench.run(20);
        }
        if state == FlightState::Maneuver {
            assert_eq!(bench.trigger(), Reply::Done);
            bench.run(50);
        }
        if matches!(state, FlightState::Recovery | FlightState::Landed) {
            bench.stream = None;
            bench.run(FRESH_TICKS + 20);
            assert_eq!(bench.logic.state(), FlightState::Recovery);
        }
        if state == FlightState::Landed {
            bench.stands = true;
            bench.run_while(FlightState::Recovery, 1600);
        }
        assert_eq!(bench.logic.state(), state);
        bench
    }

    pub(crate) fn maneuver() -> Self {
        Self::in_state(FlightState::Maneuver)
    }

    /// Where the rates are a tick later.
    fn followed(&self) -> [f32; 3] {
        let blend = TICK_US as f32 * 1e-6 / RATE_RESPONSE_S;
        core::array::from_fn(|i| {
            self.rates_radps[i] + blend * (self.out.setpoint.rates_radps[i] - self.rates_radps[i])
        })
    }

    /// A sample as a healthy vehicle would give it: it follows the setpoint, with noise that never repeats.
    pub(crate) fn sample(&self) -> ImuSample {
        let noise = 1e-3 * ((self.ticks % 17) as f32 - 8.0) / 8.0;
        let falls = self.logic.state() == FlightState::Recovery && !self.stands;
        let force = if falls { self.out.setpoint.thrust_mps2 } else { 9.81 };
        ImuSample { gyro_radps: self.followed().map(|r| r + noise), accel_mps2: [0.0, 0.0, force] }
    }

    pub(crate) fn tick_with(&mut self, imu: Option<ImuSample>, interval_us: u64, requests: &[Request]) {
        self.now_us += interval_us;
        self.rates_radps = self.followed();
        let mut inbox = Inbox::new();
        let now_ms = milliseconds(self.now_us);
        let asked = now_ms.wrapping_sub(self.age_ms);
        let mut requests: Vec<_> = requests.iter().map(|request| (request.clone(), asked)).collect();
        let streamed = now_ms.wrapping_sub(self.stream_age_ms);
        if let Some(setpoint) = self.stream.filter(|_| self.ticks.is_multiple_of(8)) {
            requests.push((self.setpoint(setpoint), streamed));
        }
        if self.heartbeat && requests.is_empty() && self.ticks.is_multiple_of(100) {
            requests.push((Request::Heartbeat, streamed));
        }
        for (request, heard_ms) in requests {
            self.number = self.number.wrapping_add(1);
            inbox
                .push_back(Uplink { version: PROTOCOL_VERSION, number: self.number, request, heard_ms })
                .expect("the inbox has room");
        }
        let mut outbox = Outbox::new();
        let input = TickInput { now_us: self.now_us, imu, battery_v: self.battery_v, kill: self.kill };
        if let Some(store) = &mut self.store {
            let store = store.work(self.logic.job());
            self.logic.set_board_status(&BoardStatus { store, ..status(BOTH, false) });
        }
        self.out = self.logic.tick(&input, &mut inbox, &mut outbox);
        self.logic.telemeter(&mut outbox);
        assert!(inbox.is_empty());
        check_throttles(&self.out, self.logic.state());
        self.ticks += 1;
        self.said.extend(outbox.iter().cloned());
    }

    /// Asks so late from now on, ms.
    pub(crate) fn aged(mut self, age_ms: u32) -> Self {
        self.age_ms = age_ms;
        self
    }

    pub(crate) fn tick(&mut self, requests: &[Request]) {
        let sample = self.sample();
        self.tick_with(Some(sample), TICK_US, requests);
    }

    pub(crate) fn run(&mut self, ticks: usize) {
        for _ in 0..ticks {
            self.tick(&[]);
        }
    }

    /// Runs until a state is left; how many ticks that took.
    pub(crate) fn run_while(&mut self, state: FlightState, most: usize) -> usize {
        for ticks in 0..most {
            if self.logic.state() != state {
                return ticks;
            }
            self.tick(&[]);
        }
        panic!("still {state:?} after {most} ticks");
    }

    /// The next setpoint of the stream, as a request.
    pub(crate) fn setpoint(&mut self, setpoint: Setpoint) -> Request {
        self.sequence = self.sequence.wrapping_add(1);
        Request::Setpoint { sequence: self.sequence, setpoint }
    }

    /// The answer to the request of this number.
    pub(crate) fn answer(&self, number: u16) -> Option<Reply> {
        self.said.iter().rev().find_map(|m| match m {
            Message::Reply { number: n, reply } if *n == number => Some(reply.clone()),
            _ => None,
        })
    }

    pub(crate) fn ask(&mut self, request: Request) -> Reply {
        let number = self.number.wrapping_add(1);
        self.tick(&[request]);
        self.answer(number).expect("an answer in the same tick")
    }

    /// A request under the number of an earlier one.
    pub(crate) fn ask_as(&mut self, number: u16, request: Request) -> Reply {
        let rest = core::mem::replace(&mut self.number, number.wrapping_sub(1));
        let reply = self.ask(request);
        self.number = rest;
        reply
    }

    /// Disarms and waits until it may be armed again.
    pub(crate) fn disarm(&mut self) {
        self.stream = None;
        assert_eq!(self.ask(Request::Disarm), Reply::Done);
        self.run(900);
    }

    pub(crate) fn refusal(&mut self, request: Request) -> Refusal {
        match self.ask(request) {
            Reply::Refused(refusal) => refusal,
            reply => panic!("not refused: {reply:?}"),
        }
    }

    /// Asks again and again while the answer is that it is under way; how often that was.
    pub(crate) fn settle(&mut self, request: &Request) -> (Reply, usize) {
        for pending in 0..200 {
            match self.ask(request.clone()) {
                Reply::Pending => {}
                reply => return (reply, pending),
            }
        }
        panic!("pending for ever: {request:?}");
    }

    pub(crate) fn telemetry(&mut self) -> Telemetry {
        match self.ask(Request::Status) {
            Reply::Status(telemetry) => telemetry,
            reply => panic!("no status: {reply:?}"),
        }
    }

    pub(crate) fn abort(&mut self) -> Option<AbortReason> {
        self.telemetry().abort
    }

    /// Acknowledges what waits.
    pub(crate) fn acknowledge(&mut self) -> Reply {
        let incident = self.telemetry().incident.expect("an incident waits").number;
        self.ask(Request::Acknowledge { incident })
    }

    pub(crate) fn read_table(&mut self) -> Vec<u8> {
        match self.ask(Request::ReadTable) {
            Reply::Table(bytes) => bytes.to_vec(),
            reply => panic!("no table: {reply:?}"),
        }
    }

    /// Stages bytes chunk by chunk: the first refusal, or the length held at the end.
    pub(crate) fn stage(&mut self, bytes: &[u8]) -> Reply {
        let mut reply = Reply::Pending;
        for request in chunks(bytes) {
            reply = self.ask(request);
            if matches!(reply, Reply::Refused(_)) {
                break;
            }
        }
        reply
    }

    pub(crate) fn commit(&mut self, table: &ManeuverTable) {
        let bytes = bytes_of(table);
        assert_eq!(self.stage(&bytes), Reply::Staged { length: bytes.len() as u16 });
        let checksum = table.checksum();
        let reply = self.ask(Request::CommitTable { checksum });
        assert_eq!(reply, Reply::Committed { checksum, duration_s: table.duration_s() });
    }

    pub(crate) fn trigger(&mut self) -> Reply {
        self.ask(Request::Trigger { checksum: table().checksum() })
    }

    pub(crate) fn record(&mut self) -> Vec<RecordedTick> {
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

/// What a board says that has these capabilities and no store.
pub(crate) fn status(capabilities: Capabilities, starting: bool) -> BoardStatus {
    BoardStatus {
        capabilities,
        starting,
        telemetry: BoardTelemetry { missed_ticks: 3, ..BoardTelemetry::default() },
        store: StoreStatus::default(),
    }
}

/// No throttle without motors, and none out of range with them.
pub(crate) fn check_throttles(out: &TickOutput, state: FlightState) {
    assert_eq!(out.throttle.is_some(), state.motors_on(), "{state:?}");
    for throttle in out.throttle.iter().flatten() {
        assert!((0.0..=1.0).contains(throttle), "{throttle}");
    }
    assert!(out.setpoint.is_finite());
}

pub(crate) fn table_of(name: &str) -> ManeuverTable {
    reference_cases().into_iter().find(|c| c.name == name).expect("the case exists").table()
}

pub(crate) fn table() -> ManeuverTable {
    // Read once: a million ticks ask for it.
    static TABLE: LazyLock<ManeuverTable> = LazyLock::new(|| table_of("general_5_5"));
    TABLE.clone()
}

pub(crate) fn bytes_of(table: &ManeuverTable) -> heapless::Vec<u8, MAX_TABLE_BYTES> {
    let mut buffer = [0; MAX_TABLE_BYTES];
    let length = table.encode(&mut buffer).expect("it fits");
    heapless::Vec::from_slice(&buffer[..length]).expect("it fits")
}

pub(crate) fn name(text: &str) -> TableName {
    TableName::try_from(text).expect("a short name")
}

/// One chunk of a table.
pub(crate) fn chunk(total: usize, offset: usize, bytes: &[u8]) -> Request {
    let bytes = heapless::Vec::from_slice(bytes).expect("no longer than a chunk");
    Request::Stage { total: total as u16, offset: offset as u16, bytes }
}

/// All chunks of a table in order; of none, an empty one.
pub(crate) fn chunks(bytes: &[u8]) -> Vec<Request> {
    if bytes.is_empty() {
        return vec![chunk(0, 0, &[])];
    }
    let pieces = bytes.chunks(STAGE_CHUNK_BYTES).enumerate();
    pieces.map(|(n, piece)| chunk(bytes.len(), n * STAGE_CHUNK_BYTES, piece)).collect()
}

/// (5, 5) made for a certain vehicle: bytes and checksum.
pub(crate) fn made_for(vehicle: u32) -> (Vec<u8>, u32) {
    let mut bytes = bytes_of(&table()).to_vec();
    bytes.truncate(bytes.len() - 4);
    bytes[4..8].copy_from_slice(&vehicle.to_le_bytes());
    let checksum = mintime_shared::crc32(&bytes);
    bytes.extend(checksum.to_le_bytes());
    (bytes, checksum)
}

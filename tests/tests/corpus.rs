//! What the fuzz targets were given and found, run every day: `data/corpus`, one directory a target.

use std::fs;
use std::path::{Path, PathBuf};

use mintime_firmware::receiver::{CHANNELS, crc8};
use mintime_shared::framing::encode;
use mintime_shared::messages::{
    FlightState, MOTOR_TEST_THROTTLE_MAX, PROTOCOL_VERSION, Purpose, Request, STAGE_CHUNK_BYTES, Setpoint,
    Uplink,
};
use mintime_shared::replay::TICK_PERIOD_US;
use mintime_shared::settings::Settings;
use mintime_shared::table::{LinkPolicy, MAX_TABLE_BYTES, ManeuverTable};
use mintime_shared::vehicle::VehicleConfig;
use mintime_tests::fuzz::{
    LASTS, STEP_ACCEL, STEP_GYRO, STEP_LOST, STEP_MISSING, STEP_STOP, past_checksum, receiver, table, uplink,
};
use mintime_tests::reference_cases;

fn directory(target: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("data/corpus").join(target)
}

/// Runs all that is kept for a target, which is `least` files or more.
fn run<T>(target: &str, least: usize, body: fn(&[u8]) -> T) -> Vec<T> {
    let mut files: Vec<_> =
        fs::read_dir(directory(target)).expect("the corpus").map(|f| f.expect("a file").path()).collect();
    files.sort();
    assert!(files.len() >= least, "{target}: {} files", files.len());
    let answer = |file: PathBuf| {
        // Where it panics its name is the last that was said.
        println!("{}", file.display());
        body(&fs::read(&file).expect("readable"))
    };
    files.into_iter().map(answer).collect()
}

/// The corpus would see little if its vehicles stayed on the ground.
fn assert_all_states(lives: &[Vec<FlightState>]) {
    // Boot ends with the first tick.
    for state in FlightState::ALL.into_iter().filter(|state| *state != FlightState::Boot) {
        assert!(lives.iter().flatten().any(|s| *s == state), "never {state:?}");
    }
}

#[test]
fn uplinks_are_survived() {
    assert_all_states(&run("uplink", 40, uplink));
}

#[test]
fn contents_of_sound_frames_are_survived() {
    assert_all_states(&run("past_checksum", 40, past_checksum));
}

#[test]
fn tables_are_refused_or_flown() {
    run("table", 40, table);
}

#[test]
fn the_receiver_runs_after_three_frames_only() {
    run("receiver", 25, receiver);
}

// -------------------------------------------------------------------------------------------- where the files are from

/// Steps of a vehicle's life as the fuzz targets read them.
#[derive(Clone, Default)]
struct Life {
    bytes: Vec<u8>,
    sequence: u16,
    number: u16,
    framed: bool,
    /// Ticks so far.
    ticks: u64,
}

/// How long a step lasts, in ticks: the place among `fuzz::LASTS`.
const ONE: u8 = 0;
const EIGHT: u8 = 3;
const EIGHTY: u8 = 5;
const CALIBRATE: u8 = 7;

impl Life {
    /// Ready to arm. `framed`: frames for the line, not contents.
    fn ready(framed: bool) -> Self {
        Self { framed, ..Self::default() }.step(CALIBRATE, &[])
    }

    fn step(mut self, step: u8, bytes: &[u8]) -> Self {
        self.bytes.push(step);
        self.ticks += LASTS[usize::from(step & 7)];
        self.bytes.extend([0; 3].iter().filter(|_| step & STEP_GYRO != 0));
        self.bytes.extend([0; 3].iter().filter(|_| step & STEP_ACCEL != 0));
        self.bytes.push(u8::try_from(bytes.len()).expect("a step's length is a byte"));
        self.bytes.extend(bytes);
        self
    }

    /// The vehicle's clock when the next step begins.
    fn now_ms(&self) -> u32 {
        (self.ticks * u64::from(TICK_PERIOD_US) / 1000) as u32
    }

    fn encoded(&mut self, request: Request) -> Vec<u8> {
        self.number += 1;
        // A content's time is its age.
        let heard_ms = if self.framed { self.now_ms() } else { 0 };
        let uplink = Uplink { version: PROTOCOL_VERSION, number: self.number, request, heard_ms };
        if self.framed { encode(&uplink).expect("it fits").as_bytes().to_vec() } else { content(&uplink) }
    }

    fn ask(mut self, step: u8, request: Request) -> Self {
        let bytes = self.encoded(request);
        self.step(step, &bytes)
    }

    fn fly(mut self, step: u8, thrust_mps2: f32) -> Self {
        self.sequence += 1;
        let setpoint = Setpoint { rates_radps: [0.0; 3], thrust_mps2 };
        let sequence = self.sequence;
        self.ask(step, Request::Setpoint { sequence, setpoint })
    }

    fn tracking(framed: bool) -> Self {
        let mut life = Self::ready(framed).ask(ONE, Request::Arm(Purpose::Flight));
        for _ in 0..4 {
            life = life.fly(EIGHT, 9.81);
        }
        life
    }

    fn commit(mut self, table: &ManeuverTable) -> Self {
        let bytes = bytes_of(table);
        for (n, chunk) in bytes.chunks(STAGE_CHUNK_BYTES).enumerate() {
            self = self.ask(
                ONE,
                Request::Stage {
                    total: bytes.len() as u16,
                    offset: (n * STAGE_CHUNK_BYTES) as u16,
                    bytes: heapless::Vec::from_slice(chunk).expect("a chunk"),
                },
            );
        }
        self.ask(ONE, Request::CommitTable { checksum: table.checksum() })
    }

    fn maneuver(framed: bool, link: LinkPolicy) -> Self {
        let mut table = table_of("general_5_5");
        table.link = link;
        let mut life =
            Self::ready(framed).commit(&table).ask(ONE, Request::Arm(Purpose::Flight)).fly(EIGHT, 9.81);
        for _ in 0..3 {
            life = life.fly(EIGHT, 9.81);
        }
        life.ask(EIGHTY, Request::Trigger { checksum: table.checksum() })
    }
}

/// What a frame is around.
fn content(uplink: &Uplink) -> Vec<u8> {
    let mut buffer = [0; 280];
    postcard::to_slice(uplink, &mut buffer).expect("it fits").to_vec()
}

fn table_of(name: &str) -> ManeuverTable {
    reference_cases().into_iter().find(|case| case.name == name).expect("the case exists").table()
}

fn bytes_of(table: &ManeuverTable) -> Vec<u8> {
    let mut buffer = [0; MAX_TABLE_BYTES];
    let length = table.encode(&mut buffer).expect("it fits");
    buffer[..length].to_vec()
}

/// One request of every kind.
fn requests() -> Vec<Request> {
    let name = || "flip".try_into().expect("short");
    vec![
        Request::Identify,
        Request::Status,
        Request::Heartbeat,
        Request::SetTelemetry { period_ms: 5 },
        Request::Stage { total: 204, offset: 0, bytes: heapless::Vec::from_slice(&[7; 128]).expect("short") },
        Request::CommitTable { checksum: 1 },
        Request::ReadTable,
        Request::ListTables,
        Request::StoreTable { name: name(), checksum: 1 },
        Request::LoadTable { name: name() },
        Request::DeleteTable { name: name() },
        Request::ReadVehicle,
        Request::WriteVehicle(VehicleConfig::REFERENCE),
        Request::ReadSettings,
        Request::WriteSettings(Settings::DEFAULT),
        Request::Pair(Some([9; 16])),
        Request::Pair(None),
        Request::Calibrate,
        Request::CalibrateScale { axis: 2, turns: -3 },
        Request::Arm(Purpose::Flight),
        Request::Arm(Purpose::MotorTest),
        Request::Disarm,
        Request::EmergencyStop,
        Request::Acknowledge { incident: 1 },
        Request::Setpoint { sequence: 1, setpoint: Setpoint::default() },
        Request::Trigger { checksum: 1 },
        Request::TestMotor { motor: 3, throttle: MOTOR_TEST_THROTTLE_MAX, duration_ms: 2000 },
        Request::Record,
        Request::ReadRecord { first: 0 },
        Request::ReadEvents { first: 0 },
    ]
}

/// Lives that get somewhere, and lives that are damaged on the way.
fn lives(framed: bool) -> Vec<Vec<u8>> {
    let mut all: Vec<Vec<u8>> =
        requests().into_iter().map(|request| Life::ready(framed).ask(EIGHT, request).bytes).collect();
    let flying = || Life::tracking(framed);
    let maneuver = |link| Life::maneuver(framed, link);
    let mut paired = Life::ready(framed).ask(ONE, Request::Pair(Some([9; 16])));
    let request = Request::Arm(Purpose::Flight);
    // What is sealed carries its true time.
    let heard_ms = paired.now_ms();
    let content = content(&Uplink { version: PROTOCOL_VERSION, number: 50, request, heard_ms });
    let sealed = [&content[..], &mintime_shared::seal::seal(&[9; 16], 1, 1, &content)].concat();
    if !framed {
        paired = paired.step(EIGHT, &sealed).step(EIGHT, &sealed);
    }
    let damaged = |at: usize, with: u8| {
        let mut life = flying().bytes;
        let at = life.len() * at / 16;
        life[at] ^= with;
        life
    };
    all.extend(
        [
            paired.ask(ONE, Request::Status),
            flying().ask(EIGHTY, Request::Record).ask(EIGHTY, Request::Disarm),
            flying().step(CALIBRATE, &[]).step(CALIBRATE, &[]),
            flying().step(EIGHT | STEP_MISSING, &[]).fly(ONE, 9.81),
            flying().step(EIGHT | STEP_STOP, &[]).ask(ONE, Request::Arm(Purpose::Flight)),
            flying().step(EIGHT | STEP_LOST, &[]).ask(ONE, Request::Acknowledge { incident: 1 }),
            flying().step(EIGHT | STEP_LOST | STEP_STOP, &[]),
            flying().step(EIGHTY | STEP_GYRO, &[]).step(EIGHTY | STEP_ACCEL, &[]).fly(EIGHT, f32::NAN),
            flying().fly(EIGHT, 100.0).fly(EIGHT, f32::INFINITY).fly(EIGHT, -1.0),
            maneuver(LinkPolicy::Finish).step(CALIBRATE, &[]).step(CALIBRATE, &[]),
            maneuver(LinkPolicy::Abandon).step(CALIBRATE, &[]).step(CALIBRATE, &[]),
            maneuver(LinkPolicy::Finish).fly(EIGHTY, 9.81).ask(EIGHT, Request::EmergencyStop),
            maneuver(LinkPolicy::Finish).step(EIGHT | STEP_MISSING, &[]).step(EIGHTY, &[0; 40]),
            maneuver(LinkPolicy::Finish)
                .step(EIGHTY | STEP_GYRO, &[])
                .ask(ONE, Request::ReadRecord { first: 3 }),
        ]
        .map(|life| life.bytes),
    );
    // Cut short, a bit flipped, noise.
    all.extend([3, 7, 12, 15].map(|part| {
        let life = maneuver(LinkPolicy::Finish).bytes;
        life[..life.len() * part / 16].to_vec()
    }));
    all.extend([(3, 1), (6, 0x80), (9, 0x10), (12, 0xff)].map(|(at, with)| damaged(at, with)));
    all.extend([0x00, 0x55, 0xff].map(|byte| Life::ready(framed).step(EIGHT, &[byte; 255]).bytes));
    all
}

fn tables() -> Vec<Vec<u8>> {
    let mut all: Vec<_> = reference_cases().iter().map(|case| bytes_of(&case.table())).collect();
    let arcs = bytes_of(&table_of("general_5_5"));
    all.extend([0, 3, 4, 8, 40, arcs.len() - 5, arcs.len() - 1].map(|length| arcs[..length].to_vec()));
    // Each field once, checksum and layout mended by the target: its highest byte, so that it matters.
    all.extend([7, 8, 9, 13, 17, 21, 25, 29, 33, 53, 73, 78, 82, 84, 88].map(|at: usize| {
        let mut bytes = arcs.clone();
        bytes[at] ^= 0x41;
        bytes
    }));
    let mut longer = arcs.clone();
    longer.extend([1; 8]);
    all.extend([longer, vec![0xff; MAX_TABLE_BYTES], vec![0; MAX_TABLE_BYTES + 1]]);
    all
}

fn channels(fifth: u16) -> Vec<u8> {
    let mut frame = vec![0xC8, 24, 0x16];
    let mut payload = [0u8; 22];
    for (n, value) in (0..CHANNELS).map(|n| (n, if n == 4 { fifth } else { 992 })) {
        for bit in (n * 11..n * 11 + 11).filter(|bit| value >> (bit - n * 11) & 1 == 1) {
            payload[bit / 8] |= 1 << (bit % 8);
        }
    }
    frame.extend(payload);
    frame.push(crc8(&frame[2..]));
    frame
}

fn received() -> Vec<Vec<u8>> {
    const HIGH: u16 = 1811;
    let step = |wait: u8, bytes: &[u8]| [&[wait, bytes.len() as u8], bytes].concat();
    let many = |wait: u8, values: &[u16]| -> Vec<u8> {
        values.iter().flat_map(|value| step(wait, &channels(*value))).collect()
    };
    let quality = |percent: u8| {
        let mut frame = vec![0xC8, 12, 0x14, 90, 90, percent, 5, 0, 2, 3, 90, 100, 5];
        frame.push(crc8(&frame[2..]));
        step(1, &frame)
    };
    let runs = || many(2, &[HIGH; 3]);
    let then = |bytes: Vec<u8>| [runs(), bytes].concat();
    let mut all = vec![
        many(2, &[HIGH; 2]),
        runs(),
        then(many(2, &[172])),
        then(many(2, &[992, HIGH, HIGH, HIGH])),
        then(step(124, &[])),
        then(step(125, &[])),
        then(step(126, &channels(HIGH))),
        then(step(255, &channels(HIGH))),
        then([quality(0), many(2, &[HIGH; 4]), quality(80), many(2, &[HIGH; 3])].concat()),
        then(quality(100)),
        many(126, &[HIGH; 5]),
        many(2, &[HIGH, 172, HIGH, HIGH, 172]),
        many(2, &[2047, 0, 2047, 2047, 2047]),
        then([&[1, 0x80 | 25][..], &channels(172)[..25]].concat()),
        [&[1, 0x80 | 25][..], &channels(HIGH)[..25]].concat().repeat(4),
        step(1, &[0xC8; 127]),
        step(1, &[0xC8, 62, 0x16].repeat(40)),
        then(step(1, &[0xC8, 1, 0x16, 0])),
        then(step(1, &[0xC8, 63, 0x16, 0])),
        then([step(1, &[0xC8, 62]), many(1, &[HIGH; 4]), step(130, &[0; 40])].concat()),
    ];
    // Cut, flipped, of the wrong length or address.
    all.extend([1, 2, 13, 25].map(|length| then(step(1, &channels(HIGH)[..length]).repeat(6))));
    all.extend([0, 1, 2, 9, 25].map(|at| {
        let mut frame = channels(HIGH);
        frame[at] ^= 1;
        [step(1, &frame).repeat(3), step(1, &channels(HIGH))].concat()
    }));
    all
}

/// Writes what the corpus began with. What was found since stays.
#[test]
#[ignore = "writes into the source tree"]
fn write_the_seeds() {
    for (target, files) in [
        ("uplink", lives(true)),
        ("past_checksum", lives(false)),
        ("table", tables()),
        ("receiver", received()),
    ] {
        let directory = directory(target);
        fs::create_dir_all(&directory).expect("a directory");
        for (n, bytes) in files.iter().enumerate() {
            fs::write(directory.join(format!("seed-{n:02}")), bytes).expect("writable");
        }
    }
}

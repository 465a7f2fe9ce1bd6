//! What docs/protocol.md and docs/vehicles.md say is what the code does: the bytes of every example, the length of every
//! message, the number of every variant, and a vehicle file that a vehicle takes.

use heapless::Vec as Few;
use mintime_firmware::config::{INBOX, INCIDENTS, OUTBOX, REPEATED_US, TELEMETRY_RANGE_MS};
use mintime_shared::framing::Frame;
use mintime_shared::messages::{
    AbortReason, ArmingBlock, BoardTelemetry, CalibrationError, Downlink, EVENTS, EVENTS_PER_CHUNK, Event,
    EventChunk, FlightState, GyroFault, Happening, Identity, Incident, IncidentCause, KillSwitch,
    MAX_CHUNK_BYTES, Message, PROTOCOL_VERSION, Purpose, RecordChunk, RecordedTick, Refusal, Reply, Request,
    STAGE_CHUNK_BYTES, Setpoint, StoredTable, TableName, Telemetry, Uplink, record_flags,
};
use mintime_shared::model::LimitsError;
use mintime_shared::seal::{PairingKey, seal};
use mintime_shared::settings::{Settings, SettingsError};
use mintime_shared::table::{MAX_TABLE_BYTES, SCHEMA_HASH, TableError};
use mintime_shared::vehicle::{VehicleConfig, VehicleError};
use mintime_tests::reference_cases;
use serde::Serialize;
use std::fmt::Debug;

const DOCUMENT: &str = include_str!("../../docs/protocol.md");

/// The key of the sealed example.
const KEY: PairingKey = [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15];
/// Its session and counter.
const SESSION: u32 = 0x1122_3344;
/// A second since power-up.
const HEARD_MS: u32 = 1000;
const COUNTER: u32 = 0x0102_0304;

/// From a heading to the next of its rank or above.
fn section(heading: &str) -> &'static str {
    let begin = DOCUMENT.find(&format!("\n{heading}\n")).unwrap_or_else(|| panic!("no heading {heading}"));
    let rank = heading.split(' ').next().expect("a heading").len();
    let rest = &DOCUMENT[begin + heading.len() + 2..];
    let end = rest
        .match_indices("\n#")
        .find(|(at, _)| rest[at + 1..].chars().take_while(|c| *c == '#').count() <= rank)
        .map_or(rest.len(), |(at, _)| at);
    &rest[..end]
}

/// The bytes of the code block behind `<!-- example: NAME -->`; what is drawn below them is left out.
fn example(name: &str) -> String {
    let marker = format!("<!-- example: {name} -->");
    let (_, rest) = DOCUMENT.split_once(&marker).unwrap_or_else(|| panic!("no example {name}"));
    let is_hex = |word: &str, digits| word.len() == digits && u32::from_str_radix(word, 16).is_ok();
    let mut bytes = Vec::new();
    for line in
        rest.lines().skip_while(|line| !line.starts_with("    ")).take_while(|l| l.starts_with("    "))
    {
        let offset = line.split_whitespace().next().is_some_and(|word| is_hex(word, 4));
        bytes.extend(line.split_whitespace().skip(usize::from(offset)).take_while(|word| is_hex(word, 2)));
    }
    bytes.join(" ")
}

fn hex(bytes: &[u8]) -> String {
    bytes.iter().map(|b| format!("{b:02x}")).collect::<Vec<_>>().join(" ")
}

fn frame(message: &impl Serialize) -> Vec<u8> {
    let mut frame = Frame::new();
    frame.fill(message).expect("a message fits a frame");
    frame.as_bytes().to_vec()
}

fn up(number: u16, request: Request) -> Vec<u8> {
    frame(&Uplink { version: PROTOCOL_VERSION, number, request, heard_ms: HEARD_MS })
}

/// Bytes of a request's longest frame.
fn longest(request: Request) -> usize {
    frame(&Uplink { version: PROTOCOL_VERSION, number: u16::MAX, request, heard_ms: u32::MAX }).len()
}

fn sealed(number: u16, request: Request) -> Vec<u8> {
    let mut frame = Frame::new();
    let uplink = Uplink { version: PROTOCOL_VERSION, number, request, heard_ms: HEARD_MS };
    frame.fill_sealed(&uplink, |content| seal(&KEY, SESSION, COUNTER, content)).expect("it fits");
    frame.as_bytes().to_vec()
}

fn down(message: Message) -> Vec<u8> {
    frame(&Downlink { version: PROTOCOL_VERSION, message })
}

fn reply(number: u16, reply: Reply) -> Vec<u8> {
    down(Message::Reply { number, reply })
}

/// The telemetry of the example.
fn telemetry() -> Telemetry {
    Telemetry {
        time_us: 1_000_000,
        state: FlightState::Tracking,
        arming_block: ArmingBlock::MOVING.0,
        abort: Some(AbortReason::OffPlan),
        incident: None,
        kill: KillSwitch::Run,
        table: 0xdead_beef,
        maneuver_s: 1.5,
        maneuver_complete: true,
        maneuver_ticks: 1129,
        maneuver_missed_ticks: 4,
        battery_v: 15.25,
        rates_radps: [0.25, -0.5, 1.0],
        up_body: [0.0, 0.0, 1.0],
        ticks: 800,
        late_ticks: 1,
        missing_samples: 2,
        worst_interval_us: 1300,
        link_errors: 3,
        setpoints_lost: 5,
        recorded: 1129,
        events: 9,
        board: None,
    }
}

fn general_5_5() -> Vec<u8> {
    let cases = reference_cases();
    let table = cases.iter().find(|case| case.name == "general_5_5").expect("the case").table();
    let mut buffer = [0; MAX_TABLE_BYTES];
    let length = table.encode(&mut buffer).expect("it fits");
    buffer[..length].to_vec()
}

#[test]
fn the_examples_are_what_the_code_sends() {
    let table = general_5_5();
    let chunk = Few::from_slice(&table).expect("it fits one chunk");
    let setpoint = Setpoint { rates_radps: [1.0, -2.0, 0.5], thrust_mps2: 9.81 };
    let refused = Refusal::Table(TableError::Limits(LimitsError::CannotLift));
    let tick = RecordedTick {
        interval_us: 1250,
        gyro_radps: Some([0.0096, 9.87, -0.0203]),
        rate_radps: 10.0,
        thrust_mps2: 20.0,
        throttle: [0.5, 0.75, 0.25, 1.0],
        flags: record_flags::HOST_FRESH | record_flags::MANEUVER | record_flags::BATTERY,
    };
    let key = hex(&KEY);
    let examples = [
        ("arm", up(1, Request::Arm(Purpose::Flight))),
        ("identify", up(1, Request::Identify)),
        ("setpoint", up(300, Request::Setpoint { sequence: 7, setpoint })),
        ("trigger", up(301, Request::Trigger { checksum: 0x1234_5678 })),
        ("sealed arm", sealed(1, Request::Arm(Purpose::Flight))),
        ("telemetry", down(Message::Telemetry(telemetry()))),
        ("refused", reply(301, Reply::Refused(refused))),
        ("done", reply(1, Reply::Done)),
        ("tick", tick.to_bytes().to_vec()),
        ("table", table),
    ];
    let wrong: Vec<_> = examples
        .iter()
        .filter(|(name, bytes)| example(name) != hex(bytes))
        .map(|(name, bytes)| format!("{name}:\n  document {}\n  code     {}", example(name), hex(bytes)))
        .collect();
    assert!(wrong.is_empty(), "docs/protocol.md has other bytes than the code:\n{}", wrong.join("\n"));
    for (words, what) in [
        (key.replace(' ', ""), "the key of the sealed example"),
        (format!("{SESSION:08X}"), "its session"),
        (format!("{COUNTER:08X}"), "its counter"),
        (format!("{SCHEMA_HASH:08X}"), "the schema"),
        (format!("{:08X}", VehicleConfig::REFERENCE.hash()), "the reference vehicle's hash"),
        (format!("protocol version, {PROTOCOL_VERSION}"), "the protocol version"),
    ] {
        assert!(DOCUMENT.contains(&words), "docs/protocol.md does not say {words}: {what}");
    }
    let staged = up(1, Request::Stage { total: chunk.len() as u16, offset: 0, bytes: chunk }).len();
    assert!(DOCUMENT.contains(&format!("a frame of {staged} bytes")), "staged: {staged} bytes");
}

/// The name of a variant.
fn name(value: &impl Debug) -> String {
    format!("{value:?}").chars().take_while(char::is_ascii_alphanumeric).collect()
}

/// The number of a variant on the wire.
fn number(value: &impl Serialize) -> u8 {
    postcard::to_slice(value, &mut [0; 400]).expect("it fits")[0]
}

/// The cells of the row of a variant, by number and name.
fn row(section: &str, number: impl std::fmt::Display, name: &str) -> Option<Vec<String>> {
    let begin = format!("| {number} | `{name}");
    let row = section.lines().find(|line| {
        line.strip_prefix(&begin).is_some_and(|rest| !rest.starts_with(|c: char| c.is_ascii_alphanumeric()))
    })?;
    Some(row.split('|').map(|cell| cell.trim().to_owned()).collect())
}

fn all_are_listed<T: Debug + Serialize>(heading: &str, values: &[T]) {
    let text = section(heading);
    for (place, value) in values.iter().enumerate() {
        assert_eq!(usize::from(number(value)), place, "{value:?}: the list in this test is in another order");
        assert!(row(text, place, &name(value)).is_some(), "{heading}: no row for {place} {}", name(value));
    }
}

#[test]
fn every_variant_stands_under_its_number() {
    all_are_listed("### Flight states", &FlightState::ALL);
    all_are_listed("### Abort reasons", &AbortReason::ALL);
    all_are_listed(
        "### Kill switch",
        &[KillSwitch::Absent, KillSwitch::Lost, KillSwitch::Stop, KillSwitch::Run],
    );
    all_are_listed("### Incident causes", &causes());
    all_are_listed("### Refusals", &refusals());
    use CalibrationError as C;
    let calibration = [
        C::Turns,
        C::NotStill,
        C::NotTurned,
        C::WrongDirection,
        C::TooFast,
        C::TooSlow,
        C::TooFar,
        C::Wobble,
        C::BiasDrift,
        C::Implausible,
        C::SamplesLost,
    ];
    all_are_listed("### Calibration errors", &calibration);
    use SettingsError as S;
    let settings = [S::NotFinite, S::GyroScale, S::GyroCutoff, S::KillSwitch, S::BenchThrust, S::Timeouts];
    all_are_listed("### Settings errors", &settings);
    use VehicleError as V;
    let vehicle = [
        V::NotFinite,
        V::Mass,
        V::Inertia,
        V::Geometry,
        V::Thrust,
        V::Rotor,
        V::Battery,
        V::PlanLimits,
        V::Outputs,
    ];
    all_are_listed("### Vehicle errors", &vehicle);
    use TableError as T;
    let tables = [
        T::Length,
        T::Checksum,
        T::Schema,
        T::Malformed,
        T::OtherVehicle,
        T::Limits(LimitsError::Rate),
        T::NotFinite,
        T::Empty,
        T::TooManySegments,
        T::Duration,
        T::TooLong,
        T::Arcs,
        T::ArcRate,
        T::End,
        T::BeyondVehicle,
        T::Gravity,
        T::AnyVehicle,
    ];
    all_are_listed("### Table errors", &tables);
    all_are_listed("### Events", &happenings());
    let faults = [
        GyroFault::Bus,
        GyroFault::Identity(0),
        GyroFault::Configuration(0),
        GyroFault::Register(0),
        GyroFault::Chip(0),
    ];
    all_are_listed("### Board", &faults);
    let blocks = section("### Arming blocks");
    for (place, (bit, _)) in ArmingBlock::REASONS.iter().enumerate() {
        assert_eq!(bit.0, 1 << place);
        assert!(blocks.contains(&format!("| {place} | `")), "no row for arming block {place}");
    }
}

fn causes() -> Vec<IncidentCause> {
    use IncidentCause as I;
    vec![
        I::Terminated(AbortReason::EmergencyStop),
        I::Panic(u32::MAX),
        I::HardFault { pc: u32::MAX, cfsr: u32::MAX },
        I::StackOverflow,
        I::ClockLost,
        I::UnexpectedInterrupt(u32::MAX),
        I::SetUp(u32::MAX),
        I::BrownOut,
        I::Watchdog,
        I::StoreDamaged,
    ]
}

fn refusals() -> Vec<Refusal> {
    use Refusal as R;
    vec![
        R::ProtocolVersion,
        R::MotorsOn,
        R::WrongState(FlightState::Armed),
        R::ArmingBlocked(u32::MAX),
        R::Table(TableError::Limits(LimitsError::CannotLift)),
        R::NotStaged,
        R::NotCommitted,
        R::StaleSetpoint,
        R::BatteryLow,
        R::NotFinite,
        R::NoRecord,
        R::OutOfRange,
        R::BatteryThrust,
        R::OutsideGate,
        R::Gap { expected: u16::MAX },
        R::Vehicle(VehicleError::Mass),
        R::Settings(SettingsError::Timeouts),
        R::NoSuchTable,
        R::StoreFull,
        R::StoreFailed,
        R::NoSuchIncident,
        R::KillSwitch,
        R::NotSealed,
        R::Calibration(CalibrationError::Turns),
        R::OtherPurpose,
        R::Late,
    ]
}

fn happenings() -> Vec<Happening> {
    use Happening as H;
    vec![
        H::Started,
        H::Incident(IncidentCause::HardFault { pc: u32::MAX, cfsr: u32::MAX }),
        H::Acknowledged(u16::MAX),
        H::Entered(FlightState::Armed),
        H::Aborted(AbortReason::Clock),
        H::Refused(Refusal::ArmingBlocked(u32::MAX)),
        H::Committed(u32::MAX),
        H::Stored,
        H::Calibrated,
    ]
}

/// No zero in it: nothing that COBS could shorten, and no variable-length number below its longest.
fn full<const N: usize>() -> Few<u8, N> {
    Few::from_slice(&[0xff; N]).expect("it fits")
}

fn fullest_telemetry() -> Telemetry {
    let incident =
        Incident { number: u16::MAX, cause: IncidentCause::HardFault { pc: u32::MAX, cfsr: u32::MAX } };
    Telemetry {
        time_us: u64::MAX,
        state: FlightState::Terminated,
        arming_block: u32::MAX,
        abort: Some(AbortReason::EmergencyStop),
        incident: Some(incident),
        kill: KillSwitch::Run,
        table: u32::MAX,
        maneuver_s: f32::MAX,
        maneuver_complete: true,
        maneuver_ticks: u32::MAX,
        maneuver_missed_ticks: u32::MAX,
        battery_v: f32::MAX,
        rates_radps: [f32::MIN; 3],
        up_body: [f32::MIN; 3],
        ticks: u32::MAX,
        late_ticks: u32::MAX,
        missing_samples: u32::MAX,
        worst_interval_us: u32::MAX,
        link_errors: u32::MAX,
        setpoints_lost: u32::MAX,
        recorded: u32::MAX,
        events: u32::MAX,
        board: Some(BoardTelemetry {
            gyro_fault: Some(GyroFault::Chip(u8::MAX)),
            latency_ns: u32::MAX,
            latency_min_ns: u32::MAX,
            latency_max_ns: u32::MAX,
            tick_max_ns: u32::MAX,
            missed_ticks: u32::MAX,
            load_permille: u16::MAX,
            stack_used_bytes: u16::MAX,
            motor_errors: u32::MAX,
            gyro_errors: u32::MAX,
            spurious_edges: u32::MAX,
        }),
    }
}

fn longest_name() -> TableName {
    TableName::try_from("nnnnnnnnnnnnnnnn").expect("sixteen bytes")
}

#[test]
fn every_message_is_as_long_as_it_says() {
    let checksum = u32::MAX;
    let requests = [
        Request::Identify,
        Request::Status,
        Request::Heartbeat,
        Request::SetTelemetry { period_ms: u16::MAX },
        Request::Stage { total: u16::MAX, offset: u16::MAX, bytes: full::<STAGE_CHUNK_BYTES>() },
        Request::CommitTable { checksum },
        Request::ReadTable,
        Request::ListTables,
        Request::StoreTable { name: longest_name(), checksum },
        Request::LoadTable { name: longest_name() },
        Request::DeleteTable { name: longest_name() },
        Request::ReadVehicle,
        Request::WriteVehicle(VehicleConfig::REFERENCE),
        Request::ReadSettings,
        Request::WriteSettings(Settings {
            kill_run_us: 1999,
            heartbeat_ms: 2000,
            recovery_ms: 5000,
            ..Settings::DEFAULT
        }),
        Request::Pair(Some([0xff; 16])),
        Request::Calibrate,
        Request::CalibrateScale { axis: 2, turns: 4 },
        Request::Arm(Purpose::MotorTest),
        Request::Disarm,
        Request::EmergencyStop,
        Request::Acknowledge { incident: u16::MAX },
        Request::Setpoint { sequence: u16::MAX, setpoint: Setpoint::default() },
        Request::Trigger { checksum },
        Request::TestMotor { motor: 3, throttle: 0.1, duration_ms: u16::MAX },
        Request::Record,
        Request::ReadRecord { first: u32::MAX },
        Request::ReadEvents { first: u32::MAX },
    ];
    let mut wrong = Vec::new();
    let mut check = |text: &str, place: usize, named: &str, length: usize| {
        let cells = row(text, place, named).unwrap_or_else(|| panic!("no row for {place} {named}"));
        if cells.get(4) != Some(&length.to_string()) {
            wrong.push(format!("{named}: {length}, not {:?}", cells.get(4)));
        }
    };
    for (place, request) in requests.into_iter().enumerate() {
        assert_eq!(usize::from(number(&request)), place);
        check(section("## Host to vehicle"), place, &name(&request), longest(request.clone()));
    }

    let event = Event {
        time_ms: u32::MAX,
        what: Happening::Incident(IncidentCause::HardFault { pc: u32::MAX, cfsr: u32::MAX }),
    };
    let stored = StoredTable { name: longest_name(), checksum, duration_s: f32::MAX };
    let replies = [
        Reply::Identity(Identity {
            firmware_version: [255; 3],
            table_schema: u32::MAX,
            vehicle: u32::MAX,
            session: u32::MAX,
            paired: true,
            last_counter: u32::MAX,
            last_counter_mac: u64::MAX,
            thrust_min_mps2: f32::MAX,
            thrust_max_mps2: f32::MAX,
            rate_max_radps: f32::MAX,
        }),
        Reply::Status(fullest_telemetry()),
        Reply::Staged { length: u16::MAX },
        Reply::Committed { checksum, duration_s: f32::MAX },
        Reply::Table(full()),
        Reply::Tables(std::iter::repeat_n(stored, 8).collect()),
        Reply::Vehicle(Some(VehicleConfig::REFERENCE)),
        Reply::Settings(Settings { kill_run_us: 1700, ..Settings::DEFAULT }),
        Reply::Record(RecordChunk { first: u32::MAX, total: u32::MAX, bytes: full::<MAX_CHUNK_BYTES>() }),
        Reply::Events(EventChunk {
            first: u32::MAX,
            newest: u32::MAX,
            events: std::iter::repeat_n(event, EVENTS_PER_CHUNK).collect(),
        }),
        Reply::Done,
        Reply::Pending,
        Reply::Refused(Refusal::ArmingBlocked(u32::MAX)),
    ];
    let mut longest = 0;
    for (place, answer) in replies.into_iter().enumerate() {
        assert_eq!(usize::from(number(&answer)), place);
        let length = reply(u16::MAX, answer.clone()).len();
        longest = longest.max(length);
        check(section("## Vehicle to host"), place, &name(&answer), length);
    }
    assert!(wrong.is_empty(), "docs/protocol.md has other lengths than the code:\n{}", wrong.join("\n"));
    let said = format!("the longest that version {PROTOCOL_VERSION} can send is {longest}");
    assert!(DOCUMENT.contains(&said), "docs/protocol.md does not say: {said}");
    let telemetry = down(Message::Telemetry(fullest_telemetry())).len();
    assert!(DOCUMENT.contains(&format!("to {telemetry} bytes")), "telemetry: to {telemetry} bytes");
    let least = down(Message::Telemetry(Telemetry::default())).len();
    assert!(DOCUMENT.contains(&format!("{least} to")), "telemetry: {least} to");
}

/// How many of a kind are held at once, and for how long: the numbers in the prose.
#[test]
fn the_bounds_in_the_text_are_the_codes() {
    let safety = include_str!("../../docs/safety.md");
    let repeated_s = REPEATED_US / 1_000_000;
    let (least_ms, most_ms) = TELEMETRY_RANGE_MS;
    for (text, said) in [
        (section("### Incident causes"), format!("Up to {INCIDENTS} wait")),
        (safety, format!("up to {INCIDENTS} wait")),
        (section("### Events"), format!("the last {EVENTS}")),
        (DOCUMENT, format!("A tick takes at most {INBOX} requests")),
        (DOCUMENT, format!("Up to {OUTBOX} messages wait for the line")),
        (DOCUMENT, format!("interval `u16` ms, {least_ms} to {most_ms} |")),
        (DOCUMENT, format!("at most {EVENTS_PER_CHUNK} [events](#events)")),
        (DOCUMENT, format!("less than {repeated_s} s after it was last asked for")),
    ] {
        assert!(text.contains(&said), "the documents do not say: {said}");
    }
}

/// Every field of the two files that a person writes stands in their tables.
#[test]
fn every_parameter_is_described() {
    let vehicles = include_str!("../../docs/vehicles.md");
    let names = |value: &serde_json::Value| -> Vec<String> {
        value.as_object().expect("an object").keys().cloned().collect()
    };
    let vehicle = serde_json::to_value(VehicleConfig::REFERENCE).expect("JSON");
    for name in names(&vehicle) {
        assert!(vehicles.contains(&format!("| `{name}` |")), "docs/vehicles.md has no row for {name}");
    }
    let settings = serde_json::to_value(Settings::DEFAULT).expect("JSON");
    for name in names(&settings) {
        assert!(
            section("## Settings").contains(&format!("| `{name}` |")),
            "docs/protocol.md has no row for {name}"
        );
    }
    let telemetry = serde_json::to_value(fullest_telemetry()).expect("JSON");
    let text = section("### Telemetry");
    for name in names(&telemetry).into_iter().chain(names(&telemetry["board"])) {
        let described =
            text.contains(&format!("`{name}`")) || section("### Board").contains(&format!("`{name}`"));
        assert!(described, "docs/protocol.md does not describe {name}");
    }
}

/// The worked vehicle of docs/vehicles.md is one, and it is the one that is built in.
#[test]
fn the_vehicle_file_of_the_documents_is_taken() {
    let text = include_str!("../../docs/vehicles/agilicious.json");
    let vehicle: VehicleConfig = serde_json::from_str(text).expect("it parses");
    assert_eq!(vehicle.check(), Ok(()));
    assert_eq!(vehicle, VehicleConfig::REFERENCE);
    let said = format!("hash {:08X}", vehicle.hash());
    let vehicles = include_str!("../../docs/vehicles.md");
    assert!(vehicles.contains(&said), "docs/vehicles.md does not say: {said}");
    assert!(
        vehicles.contains(text.trim()),
        "docs/vehicles.md shows another file than docs/vehicles/agilicious.json"
    );
}

//! Frames: whatever happens to the bytes, no message comes out that nobody sent.

use mintime_shared::crc32;
use mintime_shared::framing::{Decoder, FrameError, MAX_FRAME_BYTES, encode};
use mintime_shared::messages::{
    AbortReason, ArmingBlock, BoardTelemetry, CalibrationError, Downlink, EVENTS_PER_CHUNK, Event,
    EventChunk, FlightState, GyroFault, Happening, Identity, Incident, IncidentCause, KillSwitch,
    MAX_CHUNK_BYTES, Message, PROTOCOL_VERSION, Purpose, RECORD_BYTES, RecordChunk, RecordedTick, Refusal,
    Reply, Request, STAGE_CHUNK_BYTES, Setpoint, Telemetry, Uplink,
};
use mintime_shared::model::LimitsError;
use mintime_shared::settings::SettingsError;
use mintime_shared::table::{MAX_TABLE_BYTES, TableError};
use mintime_shared::vehicle::VehicleError;
use proptest::prelude::*;
use proptest::sample::select;
use serde::{Serialize, de::DeserializeOwned};

type Received<M> = Vec<Result<M, FrameError>>;

fn receive<M: DeserializeOwned>(decoder: &mut Decoder, bytes: &[u8]) -> Received<M> {
    bytes.iter().filter_map(|&byte| decoder.push(byte)).collect()
}

fn frame_of(message: &impl Serialize) -> Vec<u8> {
    encode(message).expect("a message fits a frame").as_bytes().to_vec()
}

fn content_of(message: &impl Serialize) -> Vec<u8> {
    postcard::to_slice(message, &mut [0; 400]).expect("it fits").to_vec()
}

/// Equality that holds for NaN too: the bytes.
fn same<M: Serialize>(a: &M, b: &M) -> bool {
    frame_of(a) == frame_of(b)
}

/// COBS as Cheshire and Baker describe it, written anew: groups of up to 254 bytes without a zero, each led by its
/// length plus one. Nothing follows a last group that is full.
fn cobs(content: &[u8]) -> Vec<u8> {
    let mut coded = Vec::new();
    let mut group = Vec::new();
    for &byte in content {
        if byte != 0 {
            group.push(byte);
        }
        if byte == 0 || group.len() == 254 {
            coded.push(group.len() as u8 + 1);
            coded.append(&mut group);
        }
    }
    let full = content.len() >= 254 && !content[content.len() - 254..].contains(&0);
    if !(full && group.is_empty()) {
        coded.push(group.len() as u8 + 1);
        coded.append(&mut group);
    }
    coded
}

/// A frame around any content, its checksum valid.
fn framed(content: &[u8]) -> Vec<u8> {
    let mut sealed = content.to_vec();
    sealed.extend(crc32(content).to_le_bytes());
    let mut bytes = cobs(&sealed);
    bytes.push(0);
    bytes
}

fn float() -> impl Strategy<Value = f32> {
    prop_oneof![prop::num::f32::ANY, Just(0.0), Just(f32::NAN), Just(f32::INFINITY)]
}

fn bytes<const N: usize>() -> impl Strategy<Value = heapless::Vec<u8, N>> {
    // Zeros and their absence are what framing is about.
    let content = prop_oneof![
        prop::collection::vec(prop_oneof![Just(0u8), any::<u8>()], 0..=N),
        prop::collection::vec(1u8.., 0..=N),
        prop::collection::vec(1u8.., N),
    ];
    content.prop_map(|v| heapless::Vec::from_slice(&v).expect("it fits"))
}

fn request() -> impl Strategy<Value = Request> {
    let setpoint = (prop::array::uniform3(float()), float());
    prop_oneof![
        select(vec![
            Request::Identify,
            Request::Status,
            Request::ReadTable,
            Request::Arm(Purpose::Flight),
            Request::Disarm,
            Request::EmergencyStop
        ]),
        (any::<u16>(), any::<u16>(), bytes::<STAGE_CHUNK_BYTES>())
            .prop_map(|(total, offset, bytes)| Request::Stage { total, offset, bytes }),
        any::<u32>().prop_map(|checksum| Request::CommitTable { checksum }),
        any::<u32>().prop_map(|checksum| Request::Trigger { checksum }),
        any::<u32>().prop_map(|first| Request::ReadRecord { first }),
        (any::<u16>(), setpoint).prop_map(|(sequence, (rates_radps, thrust_mps2))| Request::Setpoint {
            sequence,
            setpoint: Setpoint { rates_radps, thrust_mps2 },
        }),
    ]
}

prop_compose! {
    fn uplink()(
        version in any::<u8>(), number in any::<u16>(), request in request(), heard_ms in any::<u32>()
    ) -> Uplink {
        // Elsewhere it is not on the line.
        let heard_ms = if request.is_timed() { heard_ms } else { 0 };
        Uplink { version, number, request, heard_ms }
    }
}

const STATES: [FlightState; 9] = FlightState::ALL;

const ABORTS: [AbortReason; 16] = AbortReason::ALL;

fn refusals() -> Vec<Refusal> {
    vec![
        Refusal::ProtocolVersion,
        Refusal::MotorsOn,
        Refusal::WrongState(FlightState::Terminated),
        Refusal::ArmingBlocked(u32::MAX),
        Refusal::Table(TableError::Limits(LimitsError::CannotLift)),
        Refusal::Table(TableError::BeyondVehicle),
        Refusal::NotStaged,
        Refusal::NotCommitted,
        Refusal::StaleSetpoint,
        Refusal::BatteryLow,
        Refusal::NotFinite,
        Refusal::NoRecord,
        Refusal::OutOfRange,
        Refusal::BatteryThrust,
        Refusal::OutsideGate,
        Refusal::Gap { expected: u16::MAX },
        Refusal::Vehicle(VehicleError::Outputs),
        Refusal::Settings(SettingsError::Timeouts),
        Refusal::NoSuchTable,
        Refusal::StoreFull,
        Refusal::StoreFailed,
        Refusal::NoSuchIncident,
        Refusal::KillSwitch,
        Refusal::NotSealed,
        Refusal::Calibration(CalibrationError::SamplesLost),
        Refusal::OtherPurpose,
        Refusal::Late,
    ]
}

fn gyro_fault() -> impl Strategy<Value = GyroFault> {
    any::<u8>().prop_flat_map(|byte| {
        select(vec![
            GyroFault::Bus,
            GyroFault::Identity(byte),
            GyroFault::Configuration(byte),
            GyroFault::Register(byte),
            GyroFault::Chip(byte),
        ])
    })
}

prop_compose! {
    fn board()(
        gyro_fault in prop::option::of(gyro_fault()), counts in prop::array::uniform8(any::<u32>()),
        load_permille in any::<u16>(), stack_used_bytes in any::<u16>(),
    ) -> BoardTelemetry {
        let [
            latency_ns, latency_min_ns, latency_max_ns, tick_max_ns, missed_ticks, motor_errors, gyro_errors,
            spurious_edges,
        ] = counts;
        BoardTelemetry {
            gyro_fault, latency_ns, latency_min_ns, latency_max_ns, tick_max_ns, missed_ticks, load_permille,
            stack_used_bytes, motor_errors, gyro_errors, spurious_edges,
        }
    }
}

prop_compose! {
    fn telemetry()(
        time_us in any::<u64>(), state in select(&STATES[..]), arming_block in any::<u32>(),
        abort in prop::option::of(select(&ABORTS[..])), table in any::<u32>(), floats in prop::array::uniform5(float()),
        maneuver_complete in any::<bool>(), counts in prop::array::uniform8(any::<u32>()),
        board in prop::option::of(board()),
    ) -> Telemetry {
        let [maneuver_s, battery_v, x, y, z] = floats;
        let [
            ticks, late_ticks, missing_samples, worst_interval_us, link_errors, recorded, maneuver_ticks,
            maneuver_missed_ticks,
        ] = counts;
        Telemetry {
            time_us, state, arming_block, abort, incident: None, kill: KillSwitch::Lost, table, maneuver_s, maneuver_complete, maneuver_ticks,
            maneuver_missed_ticks, battery_v,
            rates_radps: [x, y, z], ticks, late_ticks, missing_samples, worst_interval_us, link_errors, recorded,
            up_body: [z, x, y], setpoints_lost: ticks, events: recorded, board,
        }
    }
}

fn reply() -> impl Strategy<Value = Reply> {
    let identity = (any::<[u8; 3]>(), any::<u32>(), any::<u32>(), float(), float());
    let events = prop::collection::vec((any::<u32>(), any::<u16>()), 0..=EVENTS_PER_CHUNK);
    let record = (any::<u32>(), any::<u32>(), bytes::<MAX_CHUNK_BYTES>());
    prop_oneof![
        identity.prop_map(|(firmware_version, table_schema, vehicle, thrust_max_mps2, rate_max_radps)| {
            Reply::Identity(Identity {
                firmware_version,
                table_schema,
                vehicle,
                session: vehicle,
                paired: table_schema.is_multiple_of(2),
                last_counter: table_schema,
                last_counter_mac: u64::from(vehicle) << 20,
                thrust_min_mps2: rate_max_radps,
                thrust_max_mps2,
                rate_max_radps,
            })
        }),
        telemetry().boxed().prop_map(Reply::Status).boxed(),
        any::<u16>().prop_map(|length| Reply::Staged { length }),
        (any::<u32>(), float()).prop_map(|(checksum, duration_s)| Reply::Committed { checksum, duration_s }),
        (any::<u32>(), any::<u32>(), events).prop_map(|(first, newest, events)| {
            let events = events.into_iter();
            let events =
                events.map(|(time_ms, n)| Event { time_ms, what: Happening::Acknowledged(n) }).collect();
            Reply::Events(EventChunk { first, newest, events })
        }),
        bytes::<MAX_TABLE_BYTES>().prop_map(Reply::Table),
        record.prop_map(|(first, total, bytes)| Reply::Record(RecordChunk { first, total, bytes })),
        Just(Reply::Done),
        select(refusals()).prop_map(Reply::Refused),
    ]
}

fn downlink() -> impl Strategy<Value = Downlink> {
    let message = prop_oneof![
        (any::<u16>(), reply().boxed()).prop_map(|(number, reply)| Message::Reply { number, reply }),
        telemetry().boxed().prop_map(Message::Telemetry).boxed(),
    ];
    (any::<u8>(), message.boxed()).prop_map(|(version, message)| Downlink { version, message }).boxed()
}

/// What happens to one byte on the way.
#[derive(Clone, Copy, Debug)]
enum Damage {
    Flip(u8),
    Drop,
    Duplicate,
    Insert(u8),
}

fn damage() -> impl Strategy<Value = Damage> {
    prop_oneof![
        (1u8..).prop_map(Damage::Flip),
        Just(Damage::Drop),
        Just(Damage::Duplicate),
        any::<u8>().prop_map(Damage::Insert),
    ]
}

fn damaged(bytes: &[u8], at: usize, damage: Damage) -> Vec<u8> {
    let replacement: &[u8] = match damage {
        Damage::Flip(bits) => &[bytes[at] ^ bits],
        Damage::Drop => &[],
        Damage::Duplicate => &[bytes[at], bytes[at]],
        Damage::Insert(byte) => &[byte, bytes[at]],
    };
    [&bytes[..at], replacement, &bytes[at + 1..]].concat()
}

/// Two messages on one line, one byte of the first frame damaged: nothing but these two comes out, in order, and only
/// a damaged closing zero takes the second along.
fn survives<M: Serialize + DeserializeOwned + std::fmt::Debug>(
    first: &M,
    second: &M,
    at: prop::sample::Index,
    damage: Damage,
) -> Result<(), TestCaseError> {
    let (one, two) = (frame_of(first), frame_of(second));
    let at = at.index(one.len());
    let bytes = [damaged(&one, at, damage), two].concat();
    let received: Received<M> = receive(&mut Decoder::new(), &bytes);
    let good: Vec<M> = received.into_iter().flatten().collect();
    let closing = at + 1 == one.len();
    if let [both @ .., last] = &good[..] {
        prop_assert!(same(last, second) || (closing && same(last, first)), "{:?}", last);
        prop_assert!(both.len() <= 1 && both.iter().all(|m| same(m, first)), "{:?}", both);
    }
    prop_assert!(closing || good.last().is_some_and(|m| same(m, second)), "the second was lost");
    if !closing && !matches!(damage, Damage::Insert(0) if at == 0) {
        prop_assert_eq!(good.len(), 1, "a damaged frame was accepted");
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1000))]

    #[test]
    fn messages_survive_any_cutting_of_the_stream(
        uplinks in prop::collection::vec(uplink(), 1..6),
        downlinks in prop::collection::vec(downlink(), 1..6),
        idle in prop::collection::vec(0usize..4, 12),
    ) {
        // The decoder takes single bytes; idle zeros between frames say nothing.
        fn check<M: Serialize + DeserializeOwned>(sent: &[M], idle: &[usize]) -> Result<(), TestCaseError> {
            let stream: Vec<u8> = sent.iter().zip(idle).flat_map(|(message, &idle)| {
                let mut bytes = frame_of(message);
                bytes.extend(vec![0; idle]);
                bytes
            }).collect();
            let got: Received<M> = receive(&mut Decoder::new(), &stream);
            prop_assert_eq!(got.len(), sent.len());
            for (got, sent) in got.iter().zip(sent) {
                prop_assert!(got.as_ref().is_ok_and(|m| same(m, sent)));
            }
            Ok(())
        }
        check(&uplinks, &idle)?;
        check(&downlinks, &idle)?;
    }

    #[test]
    fn a_frame_is_cobs_of_content_and_checksum(uplink in uplink(), downlink in downlink()) {
        let content = content_of(&uplink);
        prop_assert_eq!(frame_of(&uplink), framed(&content));
        let content = content_of(&downlink);
        prop_assert_eq!(frame_of(&downlink), framed(&content));
    }

    #[test]
    fn every_message_fits_a_frame_and_holds_one_zero(uplink in uplink(), downlink in downlink()) {
        for frame in [frame_of(&uplink), frame_of(&downlink)] {
            prop_assert!(frame.len() <= MAX_FRAME_BYTES);
            prop_assert_eq!(frame.iter().position(|&b| b == 0), Some(frame.len() - 1));
        }
    }

    #[test]
    fn one_damaged_byte_never_makes_another_message(
        up in (uplink(), uplink()), down in (downlink(), downlink()), at in any::<prop::sample::Index>(), damage in damage(),
    ) {
        survives(&up.0, &up.1, at, damage)?;
        survives(&down.0, &down.1, at, damage)?;
    }

    #[test]
    fn noise_is_survived_from_the_next_zero_on(
        noise in prop::collection::vec(any::<u8>(), 0..900), uplink in uplink(), downlink in downlink(),
    ) {
        let up: Received<Uplink> = receive(&mut Decoder::new(), &[&noise, &[0][..], &frame_of(&uplink)].concat());
        prop_assert!(matches!(up.split_last(), Some((Ok(m), rest)) if same(m, &uplink) && rest.iter().all(Result::is_err)));
        let down: Received<Downlink> = receive(&mut Decoder::new(), &[&noise, &[0][..], &frame_of(&downlink)].concat());
        prop_assert!(
            matches!(down.split_last(), Some((Ok(m), rest)) if same(m, &downlink) && rest.iter().all(Result::is_err))
        );
    }

    #[test]
    fn an_overlong_frame_is_dropped_whole(
        filling in prop::collection::vec(1u8.., MAX_FRAME_BYTES + 1..2000), uplink in uplink(),
    ) {
        let stream = [&filling, &[0][..], &frame_of(&uplink)].concat();
        let received: Received<Uplink> = receive(&mut Decoder::new(), &stream);
        prop_assert_eq!(received.len(), 2);
        prop_assert_eq!(received[0].as_ref().err(), Some(&FrameError::TooLong));
        prop_assert!(received[1].as_ref().is_ok_and(|m| same(m, &uplink)));
        // A good frame glued behind it goes with it.
        let glued = [&filling[..], &frame_of(&uplink)].concat();
        let received: Received<Uplink> = receive(&mut Decoder::new(), &glued);
        prop_assert_eq!(received.len(), 1);
        prop_assert_eq!(received[0].as_ref().err(), Some(&FrameError::TooLong));
    }

    /// Past the checksum too: random content, and real content cut, prolonged or patched.
    #[test]
    fn decoders_survive_any_content(
        content in prop::collection::vec(any::<u8>(), 0..270), uplink in uplink(), downlink in downlink(),
        cut in any::<prop::sample::Index>(), patch in any::<u8>(), at in any::<prop::sample::Index>(),
    ) {
        let mut contents = vec![content];
        for real in [
            content_of(&uplink),
            content_of(&downlink),
        ] {
            contents.push(real[..cut.index(real.len())].to_vec());
            contents.push([&real[..], &[patch]].concat());
            let mut patched = real.to_vec();
            patched[at.index(real.len())] = patch;
            contents.push(patched);
        }
        for content in contents {
            let frame = framed(&content);
            let up: Received<Uplink> = receive(&mut Decoder::new(), &frame);
            let down: Received<Downlink> = receive(&mut Decoder::new(), &frame);
            prop_assert_eq!((up.len(), down.len()), (1, 1));
            // What is understood can be said again.
            for m in up.into_iter().flatten() { prop_assert!(encode(&m).is_ok()); }
            for m in down.into_iter().flatten() { prop_assert!(encode(&m).is_ok()); }
        }
    }

    #[test]
    fn decoders_survive_any_bytes(bytes in prop::collection::vec(any::<u8>(), 0..1200)) {
        let up: Received<Uplink> = receive(&mut Decoder::new(), &bytes);
        let down: Received<Downlink> = receive(&mut Decoder::new(), &bytes);
        prop_assert!(up.iter().all(Result::is_err) && down.iter().all(Result::is_err));
    }

    #[test]
    fn a_recorded_tick_survives_its_packing(
        interval_us in any::<u16>(), gyro in prop::option::of(prop::array::uniform3(-34.9f32..34.9)),
        rate_radps in -34.9f32..34.9, thrust_mps2 in 0f32..65.0, throttle in prop::array::uniform4(0f32..=1.0),
    ) {
        let tick = RecordedTick { interval_us, gyro_radps: gyro, rate_radps, thrust_mps2, throttle, flags: interval_us ^ 0x55 };
        let back = RecordedTick::from_bytes(&tick.to_bytes());
        prop_assert_eq!((back.interval_us, back.flags), (interval_us, interval_us ^ 0x55));
        prop_assert_eq!(back.gyro_radps.is_some(), gyro.is_some());
        let near = |a: f32, b: f32, step: f32| (a - b).abs() <= 0.51 * step;
        prop_assert!(near(back.rate_radps, rate_radps, 35.0 / 32767.0));
        prop_assert!(near(back.thrust_mps2, thrust_mps2, 1e-3));
        for (a, b) in back.throttle.iter().zip(throttle) { prop_assert!(near(*a, b, 1.1 / 4095.0)); }
        for (a, b) in back.gyro_radps.iter().flatten().zip(gyro.iter().flatten()) {
            prop_assert!(near(*a, *b, 35.0 / 32767.0));
        }
        prop_assert_eq!(RecordedTick::from_bytes(&back.to_bytes()), back);
    }

    /// What does not fit saturates; what is no number becomes zero. A saturated gyro is not a missing one.
    #[test]
    fn a_recorded_tick_takes_any_number(words in prop::array::uniform9(float())) {
        let [x, y, z, rate_radps, thrust_mps2, a, b, c, d] = words;
        let tick = RecordedTick {
            interval_us: 0, gyro_radps: Some([x, y, z]), rate_radps, thrust_mps2, throttle: [a, b, c, d], flags: 0,
        };
        let back = RecordedTick::from_bytes(&tick.to_bytes());
        prop_assert!(back.gyro_radps.is_some());
        prop_assert!(back.rate_radps.abs() <= 35.0 && (0.0..=65.6).contains(&back.thrust_mps2));
        prop_assert!(back.throttle.iter().all(|t| (0.0..=1.0).contains(t)));
    }
}

/// The largest of everything: longest varints, full buffers, content without zeros so that COBS adds the most.
#[test]
fn the_largest_messages_fit() {
    let full = |n: usize| vec![0xff; n];
    let table = heapless::Vec::from_slice(&full(MAX_TABLE_BYTES)).expect("it fits");
    let telemetry = Telemetry {
        time_us: u64::MAX,
        state: FlightState::Terminated,
        arming_block: u32::MAX,
        abort: Some(AbortReason::EmergencyStop),
        incident: Some(Incident {
            number: u16::MAX,
            cause: IncidentCause::HardFault { pc: u32::MAX, cfsr: u32::MAX },
        }),
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
    };
    // What the protocol's description says.
    let status = Message::Reply { number: u16::MAX, reply: Reply::Status(telemetry) };
    assert_eq!(frame_of(&Downlink { version: PROTOCOL_VERSION, message: status }).len(), 184);

    let chunk = RecordChunk {
        first: u32::MAX,
        total: u32::MAX,
        bytes: heapless::Vec::from_slice(&full(MAX_CHUNK_BYTES)).expect("it fits"),
    };
    let mut largest = 0;
    let bytes = heapless::Vec::from_slice(&full(STAGE_CHUNK_BYTES)).expect("it fits");
    let request = Request::Stage { total: u16::MAX, offset: u16::MAX, bytes };
    largest =
        largest.max(frame_of(&Uplink { version: 255, number: u16::MAX, request, heard_ms: u32::MAX }).len());
    for reply in [Reply::Status(telemetry), Reply::Table(table), Reply::Record(chunk)] {
        let message = Message::Reply { number: u16::MAX, reply };
        largest = largest.max(frame_of(&Downlink { version: 255, message }).len());
    }
    largest = largest.max(frame_of(&Downlink { version: 255, message: Message::Telemetry(telemetry) }).len());
    assert!(largest <= MAX_FRAME_BYTES, "{largest} bytes");
    // The bound is a bound, not a guess far off.
    assert!(largest > MAX_FRAME_BYTES - 20, "{largest} bytes");
    assert_eq!(MAX_CHUNK_BYTES % RECORD_BYTES, 0);
}

#[test]
fn what_does_not_fit_is_refused_not_cut() {
    for length in 0..400 {
        let content = vec![0xffu8; length];
        match encode(&content) {
            Ok(frame) => {
                let mut decoder = Decoder::new();
                let back: Received<Vec<u8>> = receive(&mut decoder, frame.as_bytes());
                assert_eq!(back, [Ok(content)], "{length}");
            }
            Err(error) => {
                assert_eq!(error, FrameError::TooLong);
                assert!(length > 260, "{length}");
            }
        }
    }
}

/// A record chunk without a zero, with numbers of every length: one of them fills the last group of 254 bytes exactly.
#[test]
fn record_chunks_arrive_whatever_their_length() {
    let mut exact = false;
    for number in [1, 200, 20_000] {
        for (first, total) in [(1, 1), (1, 200), (200, 200), (20_000, 20_000), (u32::MAX, u32::MAX)] {
            for length in 0..=MAX_CHUNK_BYTES {
                let bytes = heapless::Vec::from_slice(&vec![0x5a; length]).expect("it fits");
                let reply = Reply::Record(RecordChunk { first, total, bytes });
                let sent = Downlink { version: PROTOCOL_VERSION, message: Message::Reply { number, reply } };
                let frame = frame_of(&sent);
                let got: Received<Downlink> = receive(&mut Decoder::new(), &frame);
                assert_eq!(got, [Ok(sent)], "{length} bytes");
                exact |= frame.len() > 256 && frame[frame.len() - 256] == 0xff;
            }
        }
    }
    assert!(exact, "no chunk ended on a full group");
}

/// Each way in which a frame can be wrong has its name.
#[test]
fn every_frame_error_is_reachable() {
    let first = |bytes: &[u8]| receive::<Uplink>(&mut Decoder::new(), bytes).first().cloned();
    assert_eq!(first(&[[1; MAX_FRAME_BYTES + 1].as_slice(), &[0]].concat()), Some(Err(FrameError::TooLong)));
    assert_eq!(first(&[3, 7, 7, 0]), Some(Err(FrameError::TooShort)));
    assert_eq!(first(&[9, 7, 7, 0]), Some(Err(FrameError::Encoding)));
    assert_eq!(first(&[6, 1, 2, 3, 4, 5, 0]), Some(Err(FrameError::Checksum)));
    assert_eq!(first(&framed(&[])), Some(Err(FrameError::Content)));
    assert_eq!(first(&framed(&[1, 1, 99])), Some(Err(FrameError::Content)));
    assert_eq!(first(&[0, 0, 0]), None);
}

/// Pinned: two builds that speak the same protocol version must speak the same bytes. Whoever changes these on purpose
/// raises [`PROTOCOL_VERSION`].
#[test]
fn the_bytes_on_the_line_are_these() {
    let hex = |bytes: &[u8]| bytes.iter().map(|b| format!("{b:02x}")).collect::<String>();
    assert_eq!(PROTOCOL_VERSION, 4);
    let up = |number, request| {
        hex(&frame_of(&Uplink { version: PROTOCOL_VERSION, number, request, heard_ms: 1000 }))
    };
    let setpoint = Setpoint { rates_radps: [1.0, -2.0, 0.5], thrust_mps2: 9.81 };
    assert_eq!(up(1, Request::Identify), "030401058f4053e100");
    assert_eq!(
        up(300, Request::Setpoint { sequence: 7, setpoint }),
        "0604ac0216070103803f010102c001010c3fc3f51c41e807ce79dfd500"
    );
    assert_eq!(up(301, Request::Trigger { checksum: 0x1234_5678 }), "1004ad0217f8acd19101e807c8a0575e00");
    let telemetry = Telemetry {
        time_us: 1_000_000,
        state: FlightState::Tracking,
        arming_block: ArmingBlock::MOVING.0,
        abort: Some(AbortReason::OffPlan),
        incident: Some(Incident { number: 2, cause: IncidentCause::Watchdog }),
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
        setpoints_lost: 4,
        recorded: 1129,
        events: 17,
        board: None,
    };
    let down = |message| hex(&frame_of(&Downlink { version: PROTOCOL_VERSION, message }));
    assert_eq!(
        down(Message::Telemetry(telemetry)),
        "130401c0843d0410010301020803effdb6f50d0107c03f01e90804010374410103803e010102bf0103803f0101010101010101010e803fa0060102940a0304e9081105dd68756f00"
    );
    let refused = Reply::Refused(Refusal::Table(TableError::Limits(LimitsError::CannotLift)));
    assert_eq!(down(Message::Reply { number: 301, reply: refused }), "02040bad020c040506d7c6e1e700");
}

/// Every refusal says something a person can act on, in one line.
#[test]
fn refusals_are_sentences() {
    let texts: Vec<String> =
        refusals().iter().map(ToString::to_string).chain(ABORTS.iter().map(ToString::to_string)).collect();
    for text in &texts {
        assert!(text.len() > 10 && !text.contains('\n'), "{text}");
    }
    assert_eq!(ArmingBlock(u32::MAX).to_string().split("; ").count(), ArmingBlock::REASONS.len());
    assert_eq!(ArmingBlock::none().to_string(), "no reason");
}

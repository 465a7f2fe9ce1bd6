//! What the fuzz targets do with the bytes they are given, and what is promised for all of them.
//!
//! `fuzz/` hands them bytes by the million; `tests/corpus.rs` the committed ones, every day.

use mintime_firmware::config::{Capabilities, VehicleConfig};
use mintime_firmware::flight::TickInput;
use mintime_firmware::gyro::ImuSample;
use mintime_firmware::receiver::{
    CHANNELS, KillState, KillSwitch, KillSwitchConfig, LOST_US, crc8, pulse_us,
};
use mintime_firmware::vehicle::Vehicle;
use mintime_shared::framing::{Decoder, encode, parse};
use mintime_shared::messages::{self, Downlink, FlightState, RECORD_BYTES, Uplink};
use mintime_shared::replay::{Plan, Replay, Step, TICK_PERIOD_US, TickPeriod};
use mintime_shared::table::{MAX_TABLE_BYTES, ManeuverTable, SCHEMA_HASH, TableError};
use serde::ser::SerializeTuple;

/// Most ticks of one life.
const LIFE_TICKS: u64 = 6000;
/// Ticks until a vehicle that stands still can be armed.
const CALIBRATION: u64 = 900;
/// Ticks that a step of a life may last.
pub const LASTS: [u64; 8] = [1, 2, 4, 8, 32, 80, 200, CALIBRATION];

/// Rates in the next three bytes, not the quiet of a vehicle that does what it is asked.
pub const STEP_GYRO: u8 = 1 << 3;
/// Accelerations likewise.
pub const STEP_ACCEL: u8 = 1 << 4;
/// The sample is missing.
pub const STEP_MISSING: u8 = 1 << 5;
/// The kill switch says stop.
pub const STEP_STOP: u8 = 1 << 6;
/// The kill switch is lost; both: there is none.
pub const STEP_LOST: u8 = 1 << 7;

/// Takes bytes off the beginning, fewer where there are no more.
fn take<'a>(data: &mut &'a [u8], count: usize) -> &'a [u8] {
    let (taken, rest) = data.split_at(count.min(data.len()));
    *data = rest;
    taken
}

/// Three signed bytes, up to ± `bound`; missing ones are zero.
fn triple(data: &mut &[u8], bound: f32) -> [f32; 3] {
    let bytes = take(data, 3);
    core::array::from_fn(|i| f32::from(bytes.get(i).copied().unwrap_or(0) as i8) / 127.0 * bound)
}

/// Bytes from the serial line into a vehicle, in steps: a byte that says how long the step lasts (the lowest three bits)
/// and what is sensed ([`STEP_GYRO`] and so on), three bytes of rates and of accelerations if so, a length, and so many
/// bytes for the line.
///
/// Answers the states it came to.
///
/// # Panics
/// Where the vehicle breaks a promise.
pub fn uplink(data: &[u8]) -> Vec<FlightState> {
    live(data, |bytes, _| bytes.to_vec())
}

/// The same, but what each step says is a frame's content: its checksum is right, whatever is in it. Where it is a request whose
/// age counts, the time in it is how old it is, ms: no fuzzer guesses what time it is.
///
/// # Panics
/// Where the vehicle breaks a promise.
pub fn past_checksum(data: &[u8]) -> Vec<FlightState> {
    live(data, |content, now_ms| match parse::<Uplink>(content) {
        Ok(mut uplink) if uplink.request.is_timed() => {
            uplink.heard_ms = now_ms.wrapping_sub(uplink.heard_ms);
            encode(&uplink).expect("a request fits").as_bytes().to_vec()
        }
        _ => framed(content),
    })
}

/// A sound frame around any content that is not too long for one.
fn framed(content: &[u8]) -> Vec<u8> {
    struct Raw<'a>(&'a [u8]);
    impl serde::Serialize for Raw<'_> {
        fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
            let mut tuple = serializer.serialize_tuple(self.0.len())?;
            self.0.iter().try_for_each(|byte| tuple.serialize_element(byte))?;
            tuple.end()
        }
    }
    encode(&Raw(content)).expect("a length in one byte fits").as_bytes().to_vec()
}

fn live(mut data: &[u8], line: fn(&[u8], u32) -> Vec<u8>) -> Vec<FlightState> {
    let mut states = Vec::new();
    let capabilities = Capabilities { gyro: true, motors: true };
    let mut vehicle =
        Vehicle::new(Some(VehicleConfig::REFERENCE), capabilities, vec![[0; RECORD_BYTES]; 100]);
    vehicle.set_session(1);
    let mut decoder = Decoder::new();
    let mut ticks = 0;
    let mut rates_radps = [0.0_f32; 3];
    let mut asked = messages::Setpoint::default();
    while !data.is_empty() && ticks < LIFE_TICKS {
        let step = take(&mut data, 1).first().copied().unwrap_or_default();
        let gyro = (step & STEP_GYRO != 0).then(|| triple(&mut data, 40.0));
        let accel = (step & STEP_ACCEL != 0).then(|| triple(&mut data, 200.0));
        let length = take(&mut data, 1).first().copied().unwrap_or_default();
        let now_ms = (ticks * u64::from(TICK_PERIOD_US) / 1000) as u32;
        vehicle.receive(&line(take(&mut data, usize::from(length)), now_ms));
        let kill = match step & (STEP_STOP | STEP_LOST) {
            0 => messages::KillSwitch::Run,
            STEP_STOP => messages::KillSwitch::Stop,
            STEP_LOST => messages::KillSwitch::Lost,
            _ => messages::KillSwitch::Absent,
        };
        for _ in 0..LASTS[usize::from(step & 7)] {
            ticks += 1;
            // It follows, with noise that never repeats.
            for (rate, asked) in rates_radps.iter_mut().zip(asked.rates_radps) {
                *rate += 0.13 * (asked - *rate);
            }
            let noise = 1e-3 * ((ticks % 17) as f32 - 8.0) / 8.0;
            let sample = ImuSample {
                gyro_radps: gyro.unwrap_or(rates_radps).map(|rate| rate + noise),
                accel_mps2: accel.unwrap_or([0.0, 0.0, 9.81]),
            };
            let imu = (step & STEP_MISSING == 0).then_some(sample);
            let input =
                TickInput { now_us: ticks * u64::from(TICK_PERIOD_US), imu, battery_v: Some(15.5), kill };
            let out = vehicle.tick(&input);
            let state = vehicle.state();
            assert_eq!(out.throttle.is_some(), state.motors_on(), "{state:?}: {out:?}");
            if states.last() != Some(&state) {
                states.push(state);
            }
            let throttle = out.throttle.unwrap_or_default();
            assert!(throttle.iter().all(|t| (0.0..=1.0).contains(t)), "{state:?}: {out:?}");
            assert!(out.setpoint.is_in_range(), "{state:?}: {out:?}");
            assert!(
                !state.motors_on()
                    || !matches!(kill, messages::KillSwitch::Stop | messages::KillSwitch::Lost),
                "{state:?} with {kill:?}"
            );
            asked = out.setpoint;
            let mut room = [0; 64];
            let sent = vehicle.transmit(&mut room);
            for byte in &room[..sent] {
                if let Some(said) = decoder.push::<Downlink>(*byte) {
                    said.expect("what it says is sound");
                }
            }
        }
    }
    states
}

/// Bytes as a maneuver table: as they are; with layout and checksum made right; with the end made right, too. What passes
/// is laid out, replayed on a clock that the bytes decide, and packed again.
///
/// # Panics
/// Where something is not finite, or is not what was packed.
pub fn table(data: &[u8]) {
    if let Ok(table) = ManeuverTable::decode(data) {
        fly(&table, data);
        assert_eq!(packed(&table), data, "one table, two encodings");
    }
    let Some(mended) = mended(data) else { return };
    match ManeuverTable::decode(&mended) {
        Ok(table) => fly(&table, data),
        Err(TableError::End) => {
            // Nothing but the end is wrong with it.
            let body = mended.get(..mended.len() - 4).expect("a checksum");
            let mut table: ManeuverTable =
                mintime_shared::framing::parse(body).expect("it was parsed before");
            let plan = Plan::new(&table);
            table.end = plan.state_at(plan.duration_s());
            if table.check().is_ok() {
                fly(&table, data);
            }
        }
        Err(_) => {}
    }
}

/// The bytes with this layout and the checksum that belongs to them.
fn mended(data: &[u8]) -> Option<Vec<u8>> {
    let body = data.get(..data.len().checked_sub(4)?)?;
    let mut bytes = SCHEMA_HASH.to_le_bytes().to_vec();
    bytes.extend(body.get(4..)?);
    bytes.extend(mintime_shared::crc32(&bytes).to_le_bytes());
    Some(bytes)
}

fn packed(table: &ManeuverTable) -> Vec<u8> {
    let mut buffer = [0; MAX_TABLE_BYTES];
    let length = table.encode(&mut buffer).expect("it fits");
    buffer[..length].to_vec()
}

/// What is promised of every table that was accepted.
fn fly(table: &ManeuverTable, clock: &[u8]) {
    let bytes = packed(table);
    let again = ManeuverTable::decode(&bytes).expect("what is accepted is accepted again");
    assert_eq!(again, *table);
    // Whether this vehicle may fly it makes no difference to what follows.
    let able = VehicleConfig::REFERENCE.plan_limits();
    let _ = table.check_for(VehicleConfig::REFERENCE.hash(), &able);
    let plan = Plan::new(table);
    let duration_s = plan.duration_s();
    assert!(duration_s > 0.0 && duration_s.is_finite());
    for n in 0..=16 {
        let state = plan.state_at(duration_s * n as f32 / 16.0);
        assert!(
            [state.x, state.vx, state.z, state.vz, state.theta].iter().all(|v| v.is_finite()),
            "{state:?} at {n}/16 of {table:?}"
        );
    }
    let mut replay = Replay::new(plan, 1_000_000);
    let mut now_us = 1_000_000_u64;
    let mut period = TickPeriod::new();
    let mut steps = clock.iter().cycle();
    // The shortest interval is longer than nothing, so that it ends.
    let mut over = false;
    for _ in 0..12_000 {
        match replay.tick(now_us, &period) {
            Step::Over => {
                over = true;
                break;
            }
            Step::Fly(command) => {
                let bound = 3.0 * table.limits.rate_max_radps * 1.001;
                assert!(command.rate_radps.abs() <= bound, "{command:?} of {table:?}");
                let bound = 2.0 * table.limits.thrust_max_mps2 * 1.001;
                assert!((0.0..=bound).contains(&command.thrust_mps2), "{command:?} of {table:?}");
            }
        }
        let interval_us = match steps.next().copied().unwrap_or_default() {
            late @ 0..8 => u64::from(late) * 1700 + 900,
            byte => 1200 + u64::from(byte) % 100,
        };
        period.observe(interval_us);
        now_us += interval_us;
    }
    assert!(over, "{duration_s} s have not passed by {now_us} µs");
}

/// Bytes from the receiver, in steps: half the milliseconds since the last (255: the clock goes back), how many bytes, the
/// bytes; with the highest bit of the count set the frame that they are is given its length and checksum.
///
/// # Panics
/// Where it runs without three frames that say so, or on what is old, or depends on where the bytes were cut.
pub fn receiver(mut data: &[u8]) {
    let mut whole = KillSwitch::new(KillSwitchConfig::DEFAULT);
    let mut pieces = whole.clone();
    let mut now_us = 1_000_000_u64;
    let mut heard: Vec<u8> = Vec::new();
    let mut heard_us = 0;
    while !data.is_empty() {
        let [wait, count] = core::array::from_fn(|_| take(&mut data, 1).first().copied().unwrap_or_default());
        now_us = if wait == 255 { now_us.saturating_sub(10_000) } else { now_us + u64::from(wait) * 2000 };
        let mut bytes = take(&mut data, usize::from(count & 0x7f)).to_vec();
        if count & 0x80 != 0 && bytes.len() >= 3 {
            bytes[1] = (bytes.len() - 1) as u8;
            bytes.push(crc8(&bytes[2..]));
        }
        // As on the board: silence is seen in the tick in which it is too long.
        assert_eq!(whole.update(now_us, &[]), pieces.update(now_us, &[]));
        if !bytes.is_empty() {
            heard_us = now_us;
        }
        heard.extend(&bytes);
        let state = whole.update(now_us, &bytes);
        // What the pieces say one after the other; a stop between two that run counts for all of them.
        let (mut ran, mut stopped) = (pieces.state() == KillState::Run, None);
        for byte in bytes.chunks(1) {
            let said = pieces.update(now_us, byte);
            ran |= said == KillState::Run;
            stopped = stopped.or(Some(said).filter(|said| ran && said.kills()));
        }
        let expected = stopped.filter(|_| !pieces.state().kills()).unwrap_or(pieces.state());
        assert_eq!(state, expected, "it depends on where the bytes were cut");
        assert_eq!(state.kills(), state != KillState::Run);
        if state == KillState::Run {
            let frames = heard.windows(26).filter(|window| says_run(window)).count();
            assert!(frames >= 3, "it runs after {frames} frames that say run");
            assert!(now_us.saturating_sub(heard_us) <= LOST_US, "it runs on what is old");
            assert_ne!(whole.link_quality(), Some(0));
        }
    }
}

/// Whether 26 bytes are a frame of channels whose fifth is high: written from the protocol, not from the parser.
fn says_run(window: &[u8]) -> bool {
    let [0xC8, 24, 0x16, payload @ .., checksum] = window else { return false };
    let mut channels = [0u16; CHANNELS];
    for (bit, channel) in (0..payload.len() * 8).map(|bit| (bit, bit / 11)) {
        let set = payload[bit / 8] >> (bit % 8) & 1;
        channels[channel] |= u16::from(set) << (bit % 11);
    }
    *checksum == crc8(&window[2..25]) && pulse_us(channels[4]) > KillSwitchConfig::DEFAULT.run_above_us
}

//! The flight record: one entry of 20 bytes a tick.

use heapless::Vec;
use serde::{Deserialize, Serialize};

/// Most bytes of a record chunk: [`RECORDS_PER_CHUNK`] ticks.
pub const MAX_CHUNK_BYTES: usize = RECORDS_PER_CHUNK * RECORD_BYTES;
/// Ticks in one record chunk.
pub const RECORDS_PER_CHUNK: usize = 12;
/// Bytes of one recorded tick.
pub const RECORD_BYTES: usize = 20;

/// A run of recorded ticks.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct RecordChunk {
    /// Index of the first tick here.
    pub first: u32,
    /// Ticks in the whole record.
    pub total: u32,
    /// [`RECORD_BYTES`] a tick.
    pub bytes: Vec<u8, MAX_CHUNK_BYTES>,
}

/// Flags of a recorded tick, bits of [`RecordedTick::flags`].
pub mod record_flags {
    /// The tick came more than half a period late.
    pub const LATE: u16 = 1;
    /// The rotors could not give all that was asked for.
    pub const SATURATED: u16 = 1 << 1;
    /// The host's setpoints were fresh.
    pub const HOST_FRESH: u16 = 1 << 2;
    /// In a maneuver.
    pub const MANEUVER: u16 = 1 << 3;
    /// There was a battery voltage.
    pub const BATTERY: u16 = 1 << 4;
}

/// One recorded tick, 20 bytes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RecordedTick {
    /// Since the previous recorded tick, µs (0 for the first; saturates at 65 ms).
    pub interval_us: u16,
    /// Gyro, bias removed, rad/s about forward, left, up; `None` where the sample was missing.
    pub gyro_radps: Option<[f32; 3]>,
    /// Commanded rate about the maneuver's axis (outside maneuvers: about left, the pitch rate), rad/s.
    pub rate_radps: f32,
    /// Commanded thrust per mass, m/s².
    pub thrust_mps2: f32,
    /// Throttles of the four motors, 0..1.
    pub throttle: [f32; 4],
    /// Bits of [`record_flags`].
    pub flags: u16,
}

impl RecordedTick {
    /// rad/s per count: ±2000 degrees/s, the gyro's range, in 16 bits.
    const RATE_LSB: f32 = 35.0 / 32767.0;
    /// m/s² per count: up to 65.5.
    const THRUST_LSB: f32 = 1.0e-3;
    /// Throttles have 12 bits; a speed controller takes 11.
    const THROTTLE_LSB: f32 = 1.0 / 4095.0;
    /// A gyro value that no sample has.
    const MISSING: i16 = i16::MIN;

    /// Packs the tick, little-endian: interval, gyro ×3, rate (i16 each), thrust (u16), throttle ×4 (12 bits each, two in
    /// three bytes, low bits first), flags (u16). `as` saturates and turns NaN into zero.
    pub fn to_bytes(&self) -> [u8; RECORD_BYTES] {
        let rate = |v: f32| (libm::roundf(v / Self::RATE_LSB) as i16).max(-i16::MAX).to_le_bytes();
        let [i0, i1] = self.interval_us.to_le_bytes();
        let [[x0, x1], [y0, y1], [z0, z1]] =
            self.gyro_radps.map_or([Self::MISSING.to_le_bytes(); 3], |g| g.map(rate));
        let [r0, r1] = rate(self.rate_radps);
        let [t0, t1] = (libm::roundf(self.thrust_mps2 / Self::THRUST_LSB) as u16).to_le_bytes();
        let [a, b, c, d] = self.throttle.map(|t| (libm::roundf(t / Self::THROTTLE_LSB) as u16).min(4095));
        let pair = |low: u16, high: u16| [low as u8, (low >> 8 | high << 4) as u8, (high >> 4) as u8];
        let ([m0, m1, m2], [m3, m4, m5]) = (pair(a, b), pair(c, d));
        let [f0, f1] = self.flags.to_le_bytes();
        [i0, i1, x0, x1, y0, y1, z0, z1, r0, r1, t0, t1, m0, m1, m2, m3, m4, m5, f0, f1]
    }

    /// Unpacks a tick.
    pub fn from_bytes(bytes: &[u8; RECORD_BYTES]) -> Self {
        let [i0, i1, x0, x1, y0, y1, z0, z1, r0, r1, t0, t1, m0, m1, m2, m3, m4, m5, f0, f1] = *bytes;
        let gyro = [[x0, x1], [y0, y1], [z0, z1]].map(i16::from_le_bytes);
        let pair = |low: u8, middle: u8, high: u8| {
            let (low, middle, high) = (u16::from(low), u16::from(middle), u16::from(high));
            [low | (middle & 0xF) << 8, middle >> 4 | high << 4]
        };
        let ([a, b], [c, d]) = (pair(m0, m1, m2), pair(m3, m4, m5));
        Self {
            interval_us: u16::from_le_bytes([i0, i1]),
            gyro_radps: (!gyro.contains(&Self::MISSING)).then(|| gyro.map(|v| f32::from(v) * Self::RATE_LSB)),
            rate_radps: f32::from(i16::from_le_bytes([r0, r1])) * Self::RATE_LSB,
            thrust_mps2: f32::from(u16::from_le_bytes([t0, t1])) * Self::THRUST_LSB,
            throttle: [a, b, c, d].map(|t| f32::from(t) * Self::THROTTLE_LSB),
            flags: u16::from_le_bytes([f0, f1]),
        }
    }
}

//! A radio receiver that speaks CRSF: frames of channels at a steady rate, link statistics between them.
//!
//! A frame is an address, the length of what follows, a type, the payload and a CRC-8 (polynomial 0xD5) over type and
//! payload.

/// Speed of its line (baud).
pub const CRSF_BAUD: u32 = 420_000;
/// A channel's values for pulses of 988, 1500 and 2012 µs.
pub const CRSF_LOW: u16 = 172;
/// See [`CRSF_LOW`].
pub const CRSF_MIDDLE: u16 = 992;
/// See [`CRSF_LOW`].
pub const CRSF_HIGH: u16 = 1811;

const FLIGHT_CONTROLLER: u8 = 0xC8;
const CHANNELS: u8 = 0x16;
const LINK_STATISTICS: u8 = 0x14;
/// Frames of channels from one of link statistics to the next.
const FRAMES_PER_STATISTICS: u64 = 10;

/// What is wrong with the line.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum CrsfDefect {
    /// Nothing.
    #[default]
    None,
    /// Nothing is sent.
    Silent,
    /// One bit of each frame is flipped, another one each time.
    FlippedBit,
}

/// The receiver.
#[derive(Clone, Debug)]
pub struct CrsfReceiver {
    /// Values of channels 1..16, 0..=2047.
    pub channels: [u16; 16],
    /// Quality of the link from the pilot (%).
    pub link_quality: u8,
    /// From frame to frame (ns).
    pub period_ns: u64,
    /// What is wrong.
    pub defect: CrsfDefect,
    next_ns: u64,
    count: u64,
}

impl CrsfReceiver {
    /// All channels in the middle, a good link, 250 frames a second, the first of them a period after power-up.
    pub fn new() -> Self {
        let period_ns = 4_000_000;
        Self {
            channels: [CRSF_MIDDLE; 16],
            link_quality: 100,
            period_ns,
            defect: CrsfDefect::None,
            next_ns: period_ns,
            count: 0,
        }
    }

    /// When the next frame begins (ns).
    pub fn next_event_ns(&self) -> u64 {
        self.next_ns
    }

    /// What begins to be sent up to `ns`.
    pub fn advance(&mut self, ns: u64) -> Option<Vec<u8>> {
        if ns < self.next_ns {
            return None;
        }
        // One that was plugged in late does not catch up.
        self.next_ns = (self.next_ns + self.period_ns).max(ns + 1);
        self.count += 1;
        let mut frames = vec![frame(CHANNELS, &pack(&self.channels))];
        if self.count.is_multiple_of(FRAMES_PER_STATISTICS) {
            frames.push(frame(LINK_STATISTICS, &[90, 90, self.link_quality, 5, 0, 2, 3, 90, 100, 5]));
        }
        match self.defect {
            CrsfDefect::None => {}
            CrsfDefect::Silent => return None,
            CrsfDefect::FlippedBit => {
                for bytes in &mut frames {
                    let bit = (self.count * 7) as usize % (bytes.len() * 8);
                    bytes[bit / 8] ^= 1 << (bit % 8);
                }
            }
        }
        Some(frames.concat())
    }
}

impl Default for CrsfReceiver {
    fn default() -> Self {
        Self::new()
    }
}

fn frame(kind: u8, payload: &[u8]) -> Vec<u8> {
    let mut bytes = vec![FLIGHT_CONTROLLER, payload.len() as u8 + 2, kind];
    bytes.extend_from_slice(payload);
    let check = bytes[2..].iter().fold(0_u8, |crc, byte| {
        (0..8).fold(crc ^ byte, |crc, _| crc << 1 ^ if crc >> 7 == 1 { 0xD5 } else { 0 })
    });
    bytes.push(check);
    bytes
}

/// 16 times 11 bits, lowest bit first.
fn pack(channels: &[u16; 16]) -> [u8; 22] {
    let mut payload = [0; 22];
    for bit in 0..16 * 11 {
        let value = channels[bit / 11].min(2047) >> (bit % 11) & 1;
        payload[bit / 8] |= (value as u8) << (bit % 8);
    }
    payload
}

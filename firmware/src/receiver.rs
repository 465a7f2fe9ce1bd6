//! The kill switch: a channel of a radio receiver that speaks CRSF.
//!
//! CRSF frames at 420,000 baud: an address, the length of what follows, a type, the payload, and a CRC-8 over type and
//! payload. Two types matter here: the channels (0x16: 16 channels of 11 bits, every 2 to 20 ms) and the link statistics
//! (0x14), whose link quality of zero says that the receiver repeats what it last heard.
//!
//! Whatever is not known means kill: no frame yet, none for [`LOST_US`], a link quality of zero, a switch between its
//! positions. One frame is enough to kill, [`KillSwitchConfig::frames_to_run`] in a row are needed to run.
//!
//! A frame counts only where address, length and checksum are right. CRC-8 with the polynomial 0xD5 sees every single
//! flipped bit, but of arbitrary bytes one frame in 256 passes; the address, the length and the three frames in a row stand
//! against that.

use core::cell::Cell;

/// Without a frame of channels for this long the switch is lost, µs. Receivers send one every 2 to 20 ms and stop, or set
/// the link quality to zero, when they lose their transmitter.
pub const LOST_US: u64 = 250_000;
/// Speed of the line (baud).
pub const BAUD: u32 = 420_000;
/// Bytes looked at in one call at most; a line at [`BAUD`] brings 53 in 1.25 ms.
pub const BYTES_PER_CALL: usize = 128;

/// Frames are addressed to the flight controller ...
const ADDRESS_FLIGHT_CONTROLLER: u8 = 0xC8;
/// ... of this type for the channels, ...
const TYPE_CHANNELS: u8 = 0x16;
/// ... of this one for the link statistics.
const TYPE_LINK_STATISTICS: u8 = 0x14;
/// Address, length, 62 bytes at most.
const FRAME_BYTES: usize = 64;
/// Channels in a frame.
pub const CHANNELS: usize = 16;
/// Bits of a channel.
const CHANNEL_BITS: usize = 11;
/// Bytes of all channels.
const CHANNELS_BYTES: usize = CHANNELS * CHANNEL_BITS / 8;
/// Bytes of the link statistics.
const STATISTICS_BYTES: usize = 10;
/// Place of the link quality (of the way from the pilot to the vehicle) among them.
const LINK_QUALITY: usize = 2;

/// What the pilot's switch says. Only [`Self::Run`] lets motors turn.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum KillState {
    /// Never heard of.
    #[default]
    Unknown,
    /// Heard once, not any more.
    Lost,
    /// In its kill position, or not long enough in the other.
    Kill,
    /// In its run position.
    Run,
}

impl KillState {
    /// Whether motors must stand still.
    pub const fn kills(self) -> bool {
        !matches!(self, Self::Run)
    }
}

/// Which switch, and where its positions end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct KillSwitchConfig {
    /// Number of the channel as transmitters count, 1 to 16. Any other number never runs.
    pub channel: u8,
    /// Above this it says run, at it and below kill, µs of a classical servo pulse.
    pub run_above_us: u16,
    /// Frames in a row that must say run; 0 counts as 1.
    pub frames_to_run: u8,
}

impl KillSwitchConfig {
    /// AUX1, a switch of two positions.
    pub const DEFAULT: Self = Self { channel: 5, run_above_us: 1700, frames_to_run: 3 };

    /// Whether it can be used: a channel that exists, and a bound within what a channel can say.
    pub const fn is_valid(&self) -> bool {
        self.channel >= 1
            && self.channel <= CHANNELS as u8
            && self.run_above_us > 1000
            && self.run_above_us < 2000
    }
}

impl Default for KillSwitchConfig {
    fn default() -> Self {
        Self::DEFAULT
    }
}

/// A frame that passed its checks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Frame {
    /// The channels, as sent: 172 to 1811 for 988 to 2012 µs.
    Channels([u16; CHANNELS]),
    /// Quality of the link from the pilot, %.
    LinkQuality(u8),
    /// Of a type that is of no use here.
    Other,
}

/// A channel's value as the length of a classical servo pulse, µs: 992 is 1500, and eight counts are 5 µs.
pub const fn pulse_us(value: u16) -> u16 {
    // At most 2047 counts: 2159 µs.
    let value = if value > 2047 { 2047 } else { value };
    ((value as u32 * 5 + 7040) / 8) as u16
}

/// Cuts a stream of bytes into frames.
#[derive(Clone, Debug)]
pub struct Parser {
    bytes: [u8; FRAME_BYTES],
    length: usize,
    errors: u32,
}

impl Parser {
    /// At the beginning of a stream.
    pub const fn new() -> Self {
        Self { bytes: [0; FRAME_BYTES], length: 0, errors: 0 }
    }

    /// Frames refused for their checksum or length since the beginning; saturates.
    pub const fn errors(&self) -> u32 {
        self.errors
    }

    /// Takes a byte, and answers the frame that it completes. Shifts at most 64 bytes.
    #[inline(never)]
    pub fn push(&mut self, byte: u8) -> Option<Frame> {
        if let Some(slot) = self.bytes.get_mut(self.length) {
            *slot = byte;
            self.length += 1;
        }
        self.align();
        let whole = self.whole()?;
        let (body, check) = self.bytes.get(2..whole)?.split_at_checked(whole - 3)?;
        let frame = (check == [crc8(body)]).then(|| decode(body)).flatten();
        if frame.is_none() {
            self.errors = self.errors.saturating_add(1);
            // The beginning may have been none: with the next byte another is looked for in what came since.
            self.drop_front(1);
            return None;
        }
        self.drop_front(whole);
        frame
    }

    /// Length of the frame under way, once all of it is there.
    fn whole(&self) -> Option<usize> {
        let length = usize::from(*self.bytes.get(1)?) + 2;
        (self.length >= length).then_some(length)
    }

    /// Drops bytes until a frame may begin with the first one.
    fn align(&mut self) {
        let held = self.bytes.get(..self.length).unwrap_or_default();
        // Type and checksum at least, and no more than a frame may have.
        let fits = |length: Option<&u8>| length.is_none_or(|n| (2..=62).contains(n));
        let begins = |&at: &usize| {
            held.get(at) == Some(&ADDRESS_FLIGHT_CONTROLLER) && fits(held.get(at.saturating_add(1)))
        };
        let skip = (0..held.len()).find(begins).unwrap_or(held.len());
        if skip > 0 {
            self.drop_front(skip);
        }
    }

    #[inline(never)]
    fn drop_front(&mut self, count: usize) {
        let count = count.min(self.length);
        // Byte by byte: it is rare, and the library's way to move them takes more than a kilobyte of flash.
        let bytes = Cell::from_mut(self.bytes.as_mut_slice()).as_slice_of_cells();
        for (to, from) in bytes.iter().zip(bytes.iter().take(self.length).skip(count)) {
            to.set(from.get());
        }
        self.length -= count;
    }
}

impl Default for Parser {
    fn default() -> Self {
        Self::new()
    }
}

/// The checksum does not cover the length: a known type has its own or is no frame.
fn decode(body: &[u8]) -> Option<Frame> {
    let (kind, payload) = body.split_first()?;
    match *kind {
        TYPE_CHANNELS => (payload.len() == CHANNELS_BYTES).then(|| Frame::Channels(unpack(payload))),
        TYPE_LINK_STATISTICS if payload.len() != STATISTICS_BYTES => None,
        TYPE_LINK_STATISTICS => payload.get(LINK_QUALITY).copied().map(Frame::LinkQuality),
        _ => Some(Frame::Other),
    }
}

/// 16 times 11 bits, lowest bit first.
fn unpack(payload: &[u8]) -> [u16; CHANNELS] {
    let mut channels = [0; CHANNELS];
    let mut bits = 0_u32;
    let mut count = 0;
    let mut bytes = payload.iter();
    for channel in &mut channels {
        while count < CHANNEL_BITS {
            bits |= u32::from(bytes.next().copied().unwrap_or(0)) << count;
            count += 8;
        }
        *channel = (bits & 0x7FF) as u16;
        bits >>= CHANNEL_BITS;
        count -= CHANNEL_BITS;
    }
    channels
}

/// CRC-8 with the polynomial 0xD5, as DVB-S2 has it.
#[inline(never)]
pub fn crc8(bytes: &[u8]) -> u8 {
    bytes.iter().fold(0, |crc, byte| {
        (0..8).fold(crc ^ byte, |crc, _| if crc & 0x80 != 0 { crc << 1 ^ 0xD5 } else { crc << 1 })
    })
}

/// What the pilot wants, from the receiver's bytes.
#[derive(Clone, Debug)]
pub struct KillSwitch {
    config: KillSwitchConfig,
    parser: Parser,
    /// By the last frame.
    position: KillState,
    /// What first stopped it among the bytes of this update.
    dipped: Option<KillState>,
    /// What the last update answered.
    state: KillState,
    /// When the last frame of channels came.
    heard_us: Option<u64>,
    /// Frames in a row that said run.
    run_frames: u8,
    /// None until told; a receiver that tells none is believed.
    link_quality: Option<u8>,
    frames: u32,
}

impl KillSwitch {
    /// Nothing heard yet.
    pub const fn new(config: KillSwitchConfig) -> Self {
        Self {
            config,
            parser: Parser::new(),
            position: KillState::Unknown,
            dipped: None,
            state: KillState::Unknown,
            heard_us: None,
            run_frames: 0,
            link_quality: None,
            frames: 0,
        }
    }

    /// Makes it another switch; the same one goes on. Where a receiver was heard the new switch is lost until it is heard, not
    /// one that was never there.
    pub fn configure(&mut self, config: KillSwitchConfig) {
        if self.config != config {
            let heard = self.position != KillState::Unknown;
            *self = Self::new(config);
            if heard {
                (self.position, self.state) = (KillState::Lost, KillState::Lost);
            }
        }
    }

    /// Takes what the receiver sent since the last call, at most [`BYTES_PER_CALL`] bytes of it, and answers what the pilot
    /// wants at `now_us`. Call it every tick, with or without bytes: silence is an answer too. A switch that ran, did not, and
    /// runs again, all in these bytes, does not run in this answer.
    #[inline(never)]
    pub fn update(&mut self, now_us: u64, bytes: &[u8]) -> KillState {
        // More than a line can bring in a tick is what piled up while nothing ran: the oldest of it is worth the least.
        let recent = bytes.get(bytes.len().saturating_sub(BYTES_PER_CALL)..).unwrap_or_default();
        self.dipped = None;
        for &byte in recent {
            match self.parser.push(byte) {
                Some(Frame::Channels(channels)) => self.channels(now_us, &channels),
                Some(Frame::LinkQuality(quality)) => {
                    self.link_quality = Some(quality);
                    if quality == 0 {
                        self.lose();
                    }
                }
                Some(Frame::Other) | None => {}
            }
        }
        // A clock that went back has lost count of the silence.
        let fresh = |heard: u64| now_us.checked_sub(heard).is_some_and(|age| age <= LOST_US);
        if self.heard_us.is_some_and(|heard| !fresh(heard)) {
            self.lose();
        }
        self.state = match self.dipped {
            Some(dipped) if self.position == KillState::Run => dipped,
            _ => self.position,
        };
        self.state
    }

    /// What the last update answered.
    pub const fn state(&self) -> KillState {
        self.state
    }

    /// Frames of channels heard; saturates.
    pub const fn frames(&self) -> u32 {
        self.frames
    }

    /// Frames refused for their checksum; saturates.
    pub const fn errors(&self) -> u32 {
        self.parser.errors()
    }

    /// Quality of the link from the pilot, %, if the receiver tells it.
    pub const fn link_quality(&self) -> Option<u8> {
        self.link_quality
    }

    fn lose(&mut self) {
        self.run_frames = 0;
        if self.position != KillState::Unknown {
            self.go(KillState::Lost);
        }
    }

    fn go(&mut self, state: KillState) {
        if state.kills() && self.position == KillState::Run {
            self.dipped = self.dipped.or(Some(state));
        }
        self.position = state;
    }

    fn channels(&mut self, now_us: u64, channels: &[u16; CHANNELS]) {
        self.heard_us = Some(now_us);
        self.frames = self.frames.saturating_add(1);
        if self.link_quality == Some(0) {
            self.go(KillState::Lost);
            self.run_frames = 0;
            return;
        }
        let value = usize::from(self.config.channel).checked_sub(1).and_then(|n| channels.get(n));
        let runs = value.is_some_and(|value| pulse_us(*value) > self.config.run_above_us);
        self.run_frames = if runs { self.run_frames.saturating_add(1) } else { 0 };
        let running = runs && self.run_frames >= self.config.frames_to_run;
        self.go(if running { KillState::Run } else { KillState::Kill });
    }
}

#[cfg(test)]
mod tests;

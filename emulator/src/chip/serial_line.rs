//! The host's end of a serial line, and what a receiver makes of the waveform it sends.

use std::collections::VecDeque;

use super::usart::Frame;

/// A byte that the firmware sent.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SerialByte {
    /// When its stop bit ended (ns).
    pub ns: u64,
    /// The byte.
    pub byte: u8,
    /// The speed it was sent at (baud).
    pub baud: u32,
}

/// What the host puts on the line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Symbol {
    Byte(u8),
    /// A byte with a bit disturbed: the receiver sees noise.
    Noisy(u8),
    /// The line held low for this long (ns).
    Break(u64),
    /// The line left alone for this long (ns).
    Pause(u64),
}

/// The host's end of one line.
#[derive(Clone, Debug)]
pub(crate) struct SerialLine {
    /// Speed of the host (baud).
    pub(crate) baud: u32,
    queue: VecDeque<Symbol>,
    /// When the first symbol of the queue starts (ns).
    start_ns: u64,
    /// What the firmware sent and nobody has taken yet.
    pub(crate) sent: VecDeque<SerialByte>,
    /// A break of the firmware's.
    pub(crate) breaks: u32,
}

/// Speeds further apart than this are outside what the receiver tolerates once its own clock's error is taken off
/// (RM0090 table 144: 3.33 % in all).
const TOLERANCE: f64 = 0.025;

impl SerialLine {
    pub(crate) fn new() -> Self {
        Self { baud: 921_600, queue: VecDeque::new(), start_ns: 0, sent: VecDeque::new(), breaks: 0 }
    }

    /// Bits take this long at the host's speed (ns).
    fn bit_ns(&self) -> f64 {
        1e9 / f64::from(self.baud.max(1))
    }

    pub(crate) fn send(&mut self, ns: u64, bytes: &[u8]) {
        self.open(ns);
        self.queue.extend(bytes.iter().map(|&byte| Symbol::Byte(byte)));
    }

    pub(crate) fn send_noisy(&mut self, ns: u64, byte: u8) {
        self.open(ns);
        self.queue.push_back(Symbol::Noisy(byte));
    }

    pub(crate) fn send_break(&mut self, ns: u64, length_ns: u64) {
        self.open(ns);
        self.queue.push_back(Symbol::Break(length_ns));
    }

    pub(crate) fn pause(&mut self, ns: u64, length_ns: u64) {
        self.open(ns);
        self.queue.push_back(Symbol::Pause(length_ns));
    }

    /// Bytes and the like not yet on their way.
    pub(crate) fn queued(&self) -> usize {
        self.queue.len()
    }

    /// When the receiver is done with the first symbol: in the middle of its stop bit.
    pub(crate) fn next_ns(&self) -> u64 {
        match self.queue.front() {
            None => u64::MAX,
            Some(Symbol::Byte(_) | Symbol::Noisy(_)) => self.start_ns + (9.5 * self.bit_ns()) as u64,
            Some(Symbol::Break(length) | Symbol::Pause(length)) => self.start_ns + length,
        }
    }

    /// When the next symbol that is not silence starts; `u64::MAX` while none is queued.
    pub(crate) fn next_start_ns(&self) -> u64 {
        match self.queue.front() {
            None => u64::MAX,
            Some(Symbol::Pause(length)) => self.start_ns + length,
            Some(_) => self.start_ns,
        }
    }

    /// Takes the first symbol, as a receiver with bits of `bit_ns` and `word_bits` sees it. None for a pause.
    pub(crate) fn take(&mut self, bit_ns: f64, word_bits: u32) -> Option<Frame> {
        let symbol = self.queue.pop_front()?;
        let frame_ns = 10.0 * self.bit_ns();
        match symbol {
            Symbol::Pause(length) => {
                self.start_ns += length;
                None
            }
            Symbol::Break(length) => {
                self.start_ns += length;
                Some(Frame { word: 0, framing: true, noise: false })
            }
            Symbol::Byte(byte) | Symbol::Noisy(byte) => {
                let next = match self.queue.front() {
                    Some(Symbol::Byte(next) | Symbol::Noisy(next)) => frame_bits(*next),
                    Some(Symbol::Break(_)) => 0,
                    _ => 0x3FF,
                };
                let line = u32::from(frame_bits(byte)) | u32::from(next) << 10 | 0xFFF0_0000;
                let mut frame = sample(line, bit_ns / self.bit_ns(), word_bits);
                frame.noise |= matches!(symbol, Symbol::Noisy(_));
                self.start_ns += frame_ns as u64;
                Some(frame)
            }
        }
    }

    /// Makes the queue start no earlier than `ns` if it is empty.
    fn open(&mut self, ns: u64) {
        if self.queue.is_empty() {
            self.start_ns = self.start_ns.max(ns);
        }
    }
}

/// Start bit, eight data bits, stop bit; first bit lowest.
fn frame_bits(byte: u8) -> u16 {
    u16::from(byte) << 1 | 1 << 9
}

/// Samples a line: `ratio` is the length of the receiver's bit in bits of the sender.
fn sample(line: u32, ratio: f64, word_bits: u32) -> Frame {
    let beyond = (ratio - 1.0).abs() > TOLERANCE;
    if !beyond {
        // Every sample of a bit lies in that bit.
        let word = (line >> 1 & ((1 << word_bits) - 1)) as u16;
        return Frame { word, framing: line >> (word_bits + 1) & 1 == 0, noise: false };
    }
    let at = |bits: f64| line >> (bits * ratio).clamp(0.0, 31.0) as u32 & 1;
    let mut word = 0;
    let mut noise = false;
    // Three samples in the middle of each bit; two of them decide (RM0090 figure 301).
    let mut vote = |bit: u32| {
        let middle = f64::from(bit) + 0.5;
        let ones = at(middle - 1.0 / 16.0) + at(middle) + at(middle + 1.0 / 16.0);
        noise |= ones % 3 != 0;
        u16::from(ones >= 2)
    };
    for bit in 0..word_bits {
        word |= vote(bit + 1) << bit;
    }
    Frame { word, framing: true, noise }
}

#[cfg(test)]
mod tests {
    use super::{frame_bits, sample};

    fn receive(byte: u8, ratio: f64) -> super::Frame {
        sample(u32::from(frame_bits(byte)) | 0xFFFF_FC00, ratio, 8)
    }

    #[test]
    fn equal_speeds_agree_and_others_do_not() {
        for byte in [0x00, 0x55, 0x81, 0xFF] {
            for ratio in [0.98, 1.0, 1.0016, 1.02] {
                let frame = receive(byte, ratio);
                assert_eq!(
                    (frame.word, frame.framing, frame.noise),
                    (u16::from(byte), false, false),
                    "{ratio}"
                );
            }
            assert!(receive(byte, 1.03).framing);
        }
        assert_ne!(receive(0x55, 2.0).word, 0x55);
    }
}

//! The contract between the chip and the board around it.

use super::pin::Pin;

/// One period of a PWM signal on a pin, told when the period is over.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pulse {
    /// When the line went high [ns since power-up].
    pub start_ns: u64,
    /// How long it stayed high (ns).
    pub high_ns: f64,
    /// Length of the timer's period (ns).
    pub period_ns: f64,
    /// The period was cut short: the timer stopped, or the pin went elsewhere.
    pub cut: bool,
}

/// How a word was clocked over SPI.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SpiWord {
    /// What the master sent, right-aligned.
    pub value: u16,
    /// 8 or 16.
    pub bits: u8,
    /// Clock rate (Hz).
    pub clock_hz: u32,
    /// The mode, 0..=3: CPOL in bit 1, CPHA in bit 0.
    pub mode: u8,
    /// Least significant bit first.
    pub lsb_first: bool,
}

/// What a board does to the chip, collected during a call.
#[derive(Clone, Debug, Default)]
pub struct Effects {
    /// Pins the board drives from now on, and how; `None` lets go.
    pub levels: Vec<(Pin, Option<bool>)>,
    /// What devices send to serial ports from now on: port (1..=6), speed (baud), bytes.
    pub serial: Vec<(u8, u32, Vec<u8>)>,
    /// Mistakes of the firmware that a device noticed. A device says the same thing once.
    pub bugs: Vec<String>,
}

/// What surrounds the chip. Times are nanoseconds since power-up and never go back.
pub trait Board {
    /// Frequency of the crystal (Hz), if there is one.
    fn crystal_hz(&self) -> Option<u32>;
    /// The chip drives `pin` as a plain output, or (`None`) no longer does.
    fn output(&mut self, ns: u64, pin: Pin, level: Option<bool>, effects: &mut Effects);
    /// A period of a timer's output on `pin` is over; `ns` is its end. Periods that are low throughout are not told.
    fn pulse(&mut self, ns: u64, pin: Pin, pulse: Pulse, effects: &mut Effects);
    /// SPI `bus` (1..=3) has clocked a word; the answer is what the selected device sent meanwhile. All ones where
    /// nothing drives the line.
    fn spi(&mut self, ns: u64, bus: u8, word: SpiWord, effects: &mut Effects) -> u16;
    /// Voltage on an analog input (V).
    fn analog_v(&mut self, ns: u64, pin: Pin) -> f64;
    /// When something happens next on the board; `u64::MAX` for never. Called after every other call.
    fn next_event_ns(&self) -> u64;
    /// Lets everything up to and including `ns` happen.
    fn advance(&mut self, ns: u64, effects: &mut Effects);
}

/// A bare chip with nothing but a crystal.
#[derive(Clone, Debug)]
pub struct BareBoard {
    /// Frequency of the crystal (Hz).
    pub crystal_hz: Option<u32>,
}

impl Default for BareBoard {
    fn default() -> Self {
        Self { crystal_hz: Some(8_000_000) }
    }
}

impl Board for BareBoard {
    fn crystal_hz(&self) -> Option<u32> {
        self.crystal_hz
    }
    fn output(&mut self, _: u64, _: Pin, _: Option<bool>, _: &mut Effects) {}
    fn pulse(&mut self, _: u64, _: Pin, _: Pulse, _: &mut Effects) {}
    fn spi(&mut self, _: u64, _: u8, _: SpiWord, _: &mut Effects) -> u16 {
        0xFFFF
    }
    fn analog_v(&mut self, _: u64, _: Pin) -> f64 {
        0.0
    }
    fn next_event_ns(&self) -> u64 {
        u64::MAX
    }
    fn advance(&mut self, _: u64, _: &mut Effects) {}
}

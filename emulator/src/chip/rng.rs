//! The random number generator (RM0090 section 24): the same numbers on every run with the same seed.

const CR_RNGEN: u32 = 1 << 2;
const CR_IE: u32 = 1 << 3;
const SR_DRDY: u32 = 1;
const SR_CECS: u32 = 1 << 1;
const SR_SECS: u32 = 1 << 2;
const SR_CEIS: u32 = 1 << 5;
const SR_SEIS: u32 = 1 << 6;

/// A number takes 40 cycles of the 48 MHz clock (RM0090 section 24.1) (ns).
const NUMBER_NS: u64 = 834;

/// What is wrong with the generator.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum RngDefect {
    /// Nothing.
    #[default]
    None,
    /// Its analog part repeats itself: SECS and SEIS, no numbers (RM0090 section 24.3.2).
    Seed,
    /// Its clock is off or too slow: CECS and CEIS (RM0090 section 24.3.2).
    Clock,
    /// No number is ever ready.
    Silent,
}

/// The registers.
#[derive(Clone, Debug)]
pub(crate) struct Rng {
    cr: u32,
    state: u64,
    /// When the next number is ready (ns).
    ready_ns: u64,
    pub(crate) defect: RngDefect,
}

impl Rng {
    pub(crate) fn new() -> Self {
        Self { cr: 0, state: 0x0123_4567_89AB_CDEF, ready_ns: u64::MAX, defect: RngDefect::None }
    }

    pub(crate) fn reset(&mut self) {
        (self.cr, self.ready_ns) = (0, u64::MAX);
    }

    pub(crate) fn seed(&mut self, seed: u64) {
        // Never zero, from which the sequence would not come away.
        self.state = seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1;
    }

    fn status(&self, ns: u64) -> u32 {
        if self.cr & CR_RNGEN == 0 {
            return 0;
        }
        match self.defect {
            RngDefect::None if ns >= self.ready_ns => SR_DRDY,
            RngDefect::None | RngDefect::Silent => 0,
            RngDefect::Seed => SR_SECS | SR_SEIS,
            RngDefect::Clock => SR_CECS | SR_CEIS,
        }
    }

    pub(crate) fn read(&mut self, offset: u32, ns: u64) -> u32 {
        match offset {
            0x00 => self.cr,
            0x04 => self.status(ns),
            // Zero while no number is ready (RM0090 section 24.4.3).
            0x08 if self.status(ns) & SR_DRDY != 0 => {
                self.ready_ns = ns + NUMBER_NS;
                // Xorshift: random enough, and the same on every run.
                let mut x = self.state;
                x ^= x << 13;
                x ^= x >> 7;
                x ^= x << 17;
                self.state = x;
                (x >> 32) as u32
            }
            _ => 0,
        }
    }

    pub(crate) fn write(&mut self, offset: u32, value: u32, ns: u64) {
        if offset == 0 {
            if value & !self.cr & CR_RNGEN != 0 {
                self.ready_ns = ns + NUMBER_NS;
            }
            self.cr = value & (CR_RNGEN | CR_IE);
        }
    }
}

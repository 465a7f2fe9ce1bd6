//! A number that no two starts share: 64 bits at start-up, so that a host can tell one run of the board from the next.
//!
//! From the chip's generator (RM0090 section 24), which needs the 48 MHz clock. Where that does not deliver, a mix of what
//! differs between chips and starts; not for secrets, either of them.
#![allow(unsafe_code)]

use core::ptr;

use cortex_m::peripheral::DWT;
use embassy_stm32::pac::{RCC, RNG, UID};

/// Polls for one number: 40 cycles of the generator's clock (RM0090 section 24.1), 140 of the processor's; a poll takes 5 at
/// least.
const POLLS: u32 = 1000;
/// Numbers drawn for two that differ; the first one after the start is not used (RM0090 section 24.3.1).
const DRAWS: u32 = 8;

/// A number, and where it is from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Entropy {
    /// 64 bits.
    pub(super) bits: u64,
    /// They are the generator's; otherwise a mix that may repeat.
    pub(super) random: bool,
}

/// Draws the number. `noise` is whatever else is at hand, as counts of a converter. Takes less than 0.1 ms.
#[inline(never)]
pub(super) fn draw(noise: u32) -> Entropy {
    match generator() {
        Some(bits) => Entropy { bits, random: true },
        None => Entropy { bits: mix(noise), random: false },
    }
}

fn generator() -> Option<u64> {
    RCC.ahb2enr().modify(|w| w.set_rngen(true));
    // The clock takes two cycles to arrive.
    let _ = RCC.ahb2enr().read();
    RNG.cr().modify(|w| w.set_rngen(true));
    let bits = two_words();
    RNG.cr().modify(|w| w.set_rngen(false));
    RCC.ahb2enr().modify(|w| w.set_rngen(false));
    bits
}

fn two_words() -> Option<u64> {
    let first = word()?;
    let mut before = first;
    let mut bits = None;
    for _ in 0..DRAWS {
        let next = word()?;
        // A generator that repeats itself is none (RM0090 section 24.3.1, FIPS 140-2).
        if next != before {
            match bits {
                None => bits = Some(next),
                Some(high) => return Some(u64::from(high) << 32 | u64::from(next)),
            }
        }
        before = next;
    }
    None
}

fn word() -> Option<u32> {
    for _ in 0..POLLS {
        let status = RNG.sr().read();
        if status.seis() || status.ceis() || status.secs() || status.cecs() {
            return None;
        }
        if status.drdy() {
            // Zero is what the register reads as when there is no number.
            return Some(RNG.dr().read()).filter(|word| *word != 0);
        }
    }
    None
}

/// Cycle counter, noise and the chip's own number, stirred.
fn mix(noise: u32) -> u64 {
    let mut state = u64::from(DWT::cycle_count()) << 32 | u64::from(noise);
    for n in 0..3 {
        // SAFETY: the chip's unique number, three words of system memory (RM0090 section 39.1).
        let part = unsafe { ptr::read_volatile((UID.as_ptr() as *const u32).add(n)) };
        // SplitMix64's finish: every bit of the input reaches every bit of the output.
        state = (state ^ u64::from(part)).wrapping_add(0x9E37_79B9_7F4A_7C15);
        state = (state ^ state >> 30).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        state = (state ^ state >> 27).wrapping_mul(0x94D0_49BB_1331_11EB);
        state ^= state >> 31;
    }
    state
}

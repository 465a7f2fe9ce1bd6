//! The independent watchdog, petted only when every party has proven alive.
//!
//! Each party checks in as it makes progress; supervision pets the watchdog only once *all* have. A dead control
//! loop is thus caught even while the link lives, and the other way round.
//!
//! Its oscillator is 32 kHz nominal but 17..47 kHz in the data sheet (DS8626, LSI characteristics), so the timeout of
//! 750 counts of four cycles is 94 ms nominal, 64 ms at the fast end and 176 ms at the slow end. Supervision runs every
//! 20 ms and the slowest party checks in every 20 ms: 40 ms in the worst case.

use core::sync::atomic::{AtomicU32, Ordering};

use embassy_stm32::pac::IWDG;
use embassy_stm32::pac::iwdg::vals::Key;

/// Reload value in counts of four oscillator cycles (the prescaler's reset value).
const RELOAD: u16 = 750;

/// Who must check in.
#[derive(Clone, Copy)]
#[repr(u32)]
pub(super) enum Party {
    /// The control tick ran.
    Control = 1 << 0,
    /// The sending side of the link went round its loop; the receiving side is part of the control tick.
    LinkTransmit = 1 << 1,
}

const ALL: u32 = Party::Control as u32 | Party::LinkTransmit as u32;

static CHECKED_IN: AtomicU32 = AtomicU32::new(0);

/// Starts the watchdog; nothing but a reset stops it again.
///
/// Called before the clocks are set up, so that a crystal that does not start ends in a reset too. Until the first pet
/// the counter runs from its reset value of 4095 counts: 512 ms nominal, 349 ms at the fast end.
pub(super) fn start() {
    IWDG.kr().write(|w| w.set_key(Key::START));
    IWDG.kr().write(|w| w.set_key(Key::ENABLE));
    IWDG.rlr().write(|w| w.set_rl(RELOAD));
}

/// Notes that `party` made progress.
pub(super) fn check_in(party: Party) {
    CHECKED_IN.fetch_or(party as u32, Ordering::Relaxed);
}

/// Pets the watchdog if everyone has checked in since the last pet. Call from supervision only.
pub(super) fn pet_if_all_alive() {
    if CHECKED_IN.load(Ordering::Relaxed) & ALL == ALL {
        CHECKED_IN.store(0, Ordering::Relaxed);
        IWDG.kr().write(|w| w.set_key(Key::RESET));
    }
}

//! The independent watchdog, petted only when every party has proven alive.
//!
//! Each party checks in as it makes progress; supervision pets the watchdog only once *all* have. A dead control
//! loop is thus caught even while the link lives, and the other way round.
//!
//! Its oscillator is 32 kHz nominal but 17..47 kHz in the data sheet (DS8626, LSI characteristics), so the timeout of
//! 750 counts of four cycles is 94 ms nominal, 64 ms at the fast end and 176 ms at the slow end. Supervision runs every
//! 20 ms and the slowest party checks in every 20 ms: 40 ms in the worst case.

use core::sync::atomic::{AtomicU32, Ordering};

use cortex_m::peripheral::DWT;
use embassy_stm32::pac::IWDG;
use embassy_stm32::pac::iwdg::vals::{Key, Pr};

/// Reload value in counts of four oscillator cycles (the prescaler's reset value).
const RELOAD: u16 = 750;
/// While flash is erased: 4095 counts of sixteen cycles, 2.05 s nominal, 1.39 s at the fast end, 3.86 s at the slow end. An
/// erase of a sector of 16 KiB takes 0.5 s at most when flash is programmed by words (DS8626, flash memory programming; 0.8 s
/// by bytes), and the processor stands still meanwhile.
const LONG_RELOAD: u16 = 4095;
/// Longest wait for new values to arrive in the watchdog's clock domain, cycles of the processor: 10 ms at 168 MHz. They take
/// five cycles of the oscillator (RM0090 section 21.4.4), 0.3 ms at the slow end, if that means the oscillator itself; drivers
/// elsewhere allow for six cycles after the prescaler, 5.6 ms with sixteen.
const UPDATE_CYCLES: u32 = 1_680_000;

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

/// The watchdog did not take a new timeout.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Stuck;

/// Gives the board the time that an erase takes, and pets the watchdog once. Thread mode only, as is [`shorten`]: nobody
/// else pets meanwhile.
///
/// # Errors
///
/// [`Stuck`]: the timeout is one or the other.
pub(super) fn lengthen() -> Result<(), Stuck> {
    set_timeout(Pr::DIVIDE_BY16, LONG_RELOAD)
}

/// Back to the usual timeout, and pets the watchdog once.
///
/// # Errors
///
/// [`Stuck`]: the timeout is one or the other.
pub(super) fn shorten() -> Result<(), Stuck> {
    set_timeout(Pr::DIVIDE_BY4, RELOAD)
}

fn set_timeout(prescaler: Pr, reload: u16) -> Result<(), Stuck> {
    // An earlier change must have arrived before the next one may be made.
    wait_for_update()?;
    IWDG.kr().write(|w| w.set_key(Key::ENABLE));
    IWDG.pr().write(|w| w.set_pr(prescaler));
    IWDG.rlr().write(|w| w.set_rl(reload));
    let arrived = wait_for_update();
    // Pets, and closes the registers.
    IWDG.kr().write(|w| w.set_key(Key::RESET));
    arrived
}

fn wait_for_update() -> Result<(), Stuck> {
    let begin = DWT::cycle_count();
    while DWT::cycle_count().wrapping_sub(begin) < UPDATE_CYCLES {
        let status = IWDG.sr().read();
        if !status.pvu() && !status.rvu() {
            return Ok(());
        }
    }
    Err(Stuck)
}

//! What the clock set-up leaves out: flash caches, the clock monitor and what is left without the crystal, a watchdog that
//! pauses under a debugger, the cycle counter, and waking up from pending interrupts.

use embassy_stm32::pac;
use embassy_stm32::pac::rcc::vals::{Pllsrc, Sw};

use super::facts::PREDIV_OF_INTERNAL_OSCILLATOR;
use super::fault;

/// First chip revision whose flash prefetch works: revision Z. Revision A (0x1000) must leave it off (erratum in
/// ES0182).
const FIRST_REVISION_WITH_PREFETCH: u16 = 0x1001;

/// Switches on the instruction and data caches and, where the chip can, the prefetch buffer.
///
/// At 168 MHz flash takes five wait states (RM0090 section 3.5.1); without these every jump pays them. Whoever erases
/// flash must reset the data cache afterwards.
pub(super) fn enable_flash_caches() {
    let revision = pac::DBGMCU.idcode().read().rev_id();
    // A reset leaves in the caches what it interrupted, an erase perhaps. They can be emptied only while they are off, as they
    // are after it (RM0090 section 3.9.1).
    pac::FLASH.acr().modify(|w| {
        w.set_icrst(true);
        w.set_dcrst(true);
    });
    pac::FLASH.acr().modify(|w| {
        w.set_icrst(false);
        w.set_dcrst(false);
    });
    pac::FLASH.acr().modify(|w| {
        w.set_icen(true);
        w.set_dcen(true);
        w.set_prften(revision >= FIRST_REVISION_WITH_PREFETCH);
    });
}

/// Raises a non-maskable interrupt when the crystal stops (RM0090 section 7.2.7); the handler is in `fault`.
pub(super) fn enable_clock_monitor() {
    pac::RCC.cr().modify(|w| w.set_csson(true));
}

/// Polls for the PLL: it locks within 300 µs (DS8626), 4800 cycles of the internal oscillator, and a poll takes at least 6.
const LOCK_POLLS: u32 = 1600;

/// The chip at full speed where the crystal has stopped: the clock monitor leaves it with the internal oscillator, 16 MHz
/// (RM0090 section 7.2.7), on which the PLL can run as well. The rate is then off as the oscillator is, by 1 % at 25 °C and up
/// to 4 % between -10 and 85 °C (DS8626): good enough for what ends a run. Whether the chip runs at full speed; at once where
/// it did.
pub(super) fn recover_clock() -> bool {
    let fast = || pac::RCC.cfgr().read().sws() == Sw::PLL1_P;
    if fast() {
        return true;
    }
    // It is off already, as its source is.
    pac::RCC.cr().modify(|w| w.set_pllon(false));
    pac::RCC.pllcfgr().modify(|w| {
        w.set_pllsrc(Pllsrc::HSI);
        w.set_pllm(PREDIV_OF_INTERNAL_OSCILLATOR);
    });
    pac::RCC.cr().modify(|w| w.set_pllon(true));
    if !(0..LOCK_POLLS).any(|_| pac::RCC.cr().read().pllrdy()) {
        return false;
    }
    // Dividers and wait states are those of full speed still.
    pac::RCC.cfgr().modify(|w| w.set_sw(Sw::PLL1_P));
    (0..LOCK_POLLS).any(|_| fast())
}

/// Bit of the system control register: an interrupt that becomes pending is an event, even while interrupts are off.
const SEVONPEND: u32 = 1 << 4;

/// Starts the cycle counter and makes pending interrupts wake the processor; see `idle`. Once.
pub(super) fn prepare_core() {
    let Some(mut core) = cortex_m::Peripherals::take() else {
        fault::set_up_failed(line!());
    };
    core.DCB.enable_trace();
    core.DWT.set_cycle_count(0);
    core.DWT.enable_cycle_counter();
    #[allow(unsafe_code)]
    // SAFETY: changes when a sleep ends, nothing else.
    unsafe {
        core.SCB.scr.modify(|scr| scr | SEVONPEND);
    }
}

/// Stops the watchdog while a debug probe holds the core.
pub(super) fn pause_watchdog_in_debug() {
    pac::DBGMCU.apb1fzr().modify(|w| w.set_iwdg(true));
}

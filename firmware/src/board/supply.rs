//! The chip's own supply: a supply that falls ends the run before the chip does what nobody wrote.
//!
//! The programmable voltage detector at its highest level says so at 2.9 V falling (RM0090 section 5.4.1). Flash with five
//! wait states at 168 MHz, and programmed by words, is specified from 2.7 V on (RM0090 tables 10 and 7): there is a margin
//! in which the program still does what it says.
//!
//! What follows: stop frames, motor lines low, the reason kept, reset. After the reset the board is disarmed; its start goes
//! no further than here while the supply is low. Who wants motors again has to arm, and `fault::kept` tells why.
#![allow(unsafe_code)]

use embassy_stm32::interrupt;
use embassy_stm32::interrupt::InterruptExt;
use embassy_stm32::pac::{EXTI, PWR, RCC};

use super::fault;

/// The detector's line among the external interrupts (RM0090 section 12.2.5).
const LINE: usize = 16;
/// 2.9 V falling, 3.0 V rising (RM0090 section 5.4.1, PLS; DS8626).
const HIGHEST_LEVEL: u8 = 7;
/// Looks at the detector before it is believed that the supply stays low; 30 ms at 168 MHz.
const SETTLE_POLLS: u32 = 500_000;

/// Watches the supply from now on. One that is low already does not count as falling: wait for it, within reason, and end
/// the run if it stays low.
pub(super) fn watch() {
    RCC.apb1enr().modify(|w| w.set_pwren(true));
    PWR.cr1().modify(|w| {
        w.set_pls(HIGHEST_LEVEL);
        w.set_pvde(true);
    });
    // The detector's output rises as the supply falls.
    EXTI.ftsr(0).modify(|w| w.set_line(LINE, false));
    EXTI.rtsr(0).modify(|w| w.set_line(LINE, true));
    let recovered = (0..SETTLE_POLLS).any(|_| !PWR.csr1().read().pvdo());
    if !recovered {
        fault::brown_out();
    }
    EXTI.pr(0).write(|w| w.set_line(LINE, true));
    EXTI.imr(0).modify(|w| w.set_line(LINE, true));
    // SAFETY: its handler ends the run by registers alone; no critical section relies on its mask.
    unsafe { interrupt::PVD.enable() };
}

/// The supply falls.
#[interrupt]
unsafe fn PVD() {
    fault::brown_out()
}

//! Motor outputs: held low until there is a driver, and forced low by every fault.

use embassy_stm32::pac::gpio::vals::{Moder, Pupdr};
use embassy_stm32::pac::{self};

use super::facts::{MOTOR_PINS, MOTOR_PORT};

/// Drives all four motor pins low as plain outputs, whatever owned them before.
///
/// A low line is no signal at all to a speed controller: it stays or becomes disarmed. Touches registers only, so it
/// is safe in a fault handler and before the clocks are set up.
pub(super) fn force_low() {
    pac::RCC.ahb1enr().modify(|w| w.set_gpioben(true));
    for pin in MOTOR_PINS {
        MOTOR_PORT.bsrr().write(|w| w.set_br(pin, true));
        MOTOR_PORT.pupdr().modify(|w| w.set_pupdr(pin, Pupdr::PULL_DOWN));
        MOTOR_PORT.moder().modify(|w| w.set_moder(pin, Moder::OUTPUT));
    }
}

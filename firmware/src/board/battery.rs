//! Battery voltage by single conversions of ADC1, never waited for.
//!
//! A conversion takes 23 µs (480 + 12 cycles at 21 MHz). Each round of supervision collects the result of the
//! conversion that the round before it started, so that nothing ever spins on a flag.

use core::sync::atomic::{AtomicU32, Ordering};

use embassy_stm32::gpio::Flex;
use embassy_stm32::pac::adc::vals::SampleTime;
use embassy_stm32::pac::adccommon::vals::Adcpre;
use embassy_stm32::pac::{ADC1, ADC123_COMMON};
use embassy_stm32::{Peri, peripherals, rcc};

use super::facts::{BATTERY_CHANNEL, BATTERY_VOLTS_PER_COUNT, BatteryParts};

/// Latest reading as bits of an `f32` [V]; not a number while there is none.
static VOLTAGE_BITS: AtomicU32 = AtomicU32::new(f32::NAN.to_bits());

/// The converter, set up for the battery pin.
pub(super) struct Battery {
    _adc: Peri<'static, peripherals::ADC1>,
    _pin: Flex<'static>,
}

impl Battery {
    /// Powers the converter and starts the first conversion.
    pub(super) fn new(parts: BatteryParts) -> Self {
        let BatteryParts { adc, pin } = parts;
        rcc::enable_and_reset::<peripherals::ADC1>();
        let mut pin = Flex::new(pin);
        pin.set_as_analog();

        // 84 MHz / 4 = 21 MHz; the converter takes up to 36 MHz.
        ADC123_COMMON.ccr().modify(|w| w.set_adcpre(Adcpre::DIV4));
        // The longest sampling time: the divider is a high-impedance source.
        ADC1.smpr1().modify(|w| w.set_smp(usize::from(BATTERY_CHANNEL) - 10, SampleTime::CYCLES480));
        ADC1.sqr3().modify(|w| w.set_sq(0, BATTERY_CHANNEL));
        // Needs 3 µs to settle before the first conversion: that is started by the first `sample`.
        ADC1.cr2().modify(|w| w.set_adon(true));
        Self { _adc: adc, _pin: pin }
    }

    /// Publishes the finished conversion, if there is one, and starts the next.
    pub(super) fn sample(&mut self) {
        let finished = ADC1.sr().read().eoc();
        let volts =
            if finished { f32::from(ADC1.dr().read().data()) * BATTERY_VOLTS_PER_COUNT } else { f32::NAN };
        VOLTAGE_BITS.store(volts.to_bits(), Ordering::Relaxed);
        ADC1.cr2().modify(|w| w.set_swstart(true));
    }
}

/// Latest battery voltage [V], or none while there has been no conversion or it failed to finish.
pub(super) fn voltage() -> Option<f32> {
    let volts = f32::from_bits(VOLTAGE_BITS.load(Ordering::Relaxed));
    (!volts.is_nan()).then_some(volts)
}

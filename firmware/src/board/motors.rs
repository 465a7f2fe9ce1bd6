//! Motor lines: low before anything else, connected to their timer once, stopped and low again after every fault.

use embassy_stm32::pac;
use embassy_stm32::pac::gpio::vals::{Moder, Ospeedr, Ot, Pupdr};
use mintime_firmware::dshot::{BIT_COUNTS, FRAME_BITS, ZERO_COUNTS};

use super::core_setup;
use super::facts::{MOTOR_ALTERNATE_FUNCTION, MOTOR_DMA_STREAM, MOTOR_PINS, MOTOR_PORT, MOTOR_TIMER};

/// Frames that tell the motors to stop, on the way down.
const STOP_FRAMES: u32 = 4;
/// Empty bits before each, 67 µs: what was cut short must be over for the speed controllers.
const GAP_BITS: u32 = 40;
/// Polls for one bit. It lasts 280 cycles of the processor, and a poll at least 6.
const BIT_POLLS: u32 = 100;
/// Polls for the stream to let go when it is switched off: it finishes the word it has in hand.
const STREAM_POLLS: u32 = 200;

/// Drives all four motor pins low as plain outputs, whatever owned them before.
///
/// A low line is no signal at all to a speed controller: it stays or becomes disarmed. Touches registers only, so it
/// is safe in a fault handler and before the clocks are set up.
pub(super) fn force_low() {
    pac::RCC.ahb1enr().modify(|w| w.set_gpioben(true));
    // The clock is there two of its cycles later; a write before that is lost (ES0182, "Delay after an RCC peripheral clock
    // enabling"). Reading back takes as long.
    let _ = pac::RCC.ahb1enr().read();
    for pin in MOTOR_PINS {
        MOTOR_PORT.bsrr().write(|w| w.set_br(pin, true));
        MOTOR_PORT.pupdr().modify(|w| w.set_pupdr(pin, Pupdr::PULL_DOWN));
        MOTOR_PORT.moder().modify(|w| w.set_moder(pin, Moder::OUTPUT));
    }
}

/// Hands the pins to the timer, which must hold them low at that moment.
pub(super) fn connect() {
    for pin in MOTOR_PINS {
        MOTOR_PORT.afr(pin / 8).modify(|w| w.set_afr(pin % 8, MOTOR_ALTERNATE_FUNCTION));
        MOTOR_PORT.otyper().modify(|w| w.set_ot(pin, Ot::PUSH_PULL));
        MOTOR_PORT.ospeedr().modify(|w| w.set_ospeedr(pin, Ospeedr::MEDIUM_SPEED));
        MOTOR_PORT.pupdr().modify(|w| w.set_pupdr(pin, Pupdr::PULL_DOWN));
        MOTOR_PORT.moder().modify(|w| w.set_moder(pin, Moder::ALTERNATE));
    }
}

/// The end of every run: tells the motors to stop, then holds the lines low.
///
/// Without the stop frames a speed controller would hold its last throttle until it misses the signal, up to half a
/// second. They take 0.4 ms, with interrupts off, by registers only and with every wait bounded. Where the crystal is lost
/// the lines are low while the chip gets back to speed, 0.2 ms; should it not, they stay low, for a frame at a wrong rate is
/// none.
pub(super) fn shut_down() {
    // In this order: a peripheral without its clock must not be touched.
    if pac::RCC.ahb1enr().read().gpioben()
        && pac::RCC.apb1enr().read().tim4en()
        && MOTOR_PINS.iter().all(|pin| MOTOR_PORT.moder().read().moder(*pin) == Moder::ALTERNATE)
    {
        cut_frame();
        if core_setup::recover_clock() {
            send_stop_frames();
        }
    }
    force_low();
}

/// Ends what the timer and its stream are doing; the timer holds the lines low.
fn cut_frame() {
    MOTOR_TIMER.dier().write(|_| {});
    stop_stream();
    set_pulse(0);
    MOTOR_TIMER.arr().write(|w| w.set_arr(BIT_COUNTS - 1));
    // The values hold at once, and a round that was a frame's wait is over.
    MOTOR_TIMER.egr().write(|w| w.set_ug(true));
}

/// Switches the stream off and waits until it has let go.
pub(super) fn stop_stream() {
    let stream = pac::DMA1.st(MOTOR_DMA_STREAM);
    stream.cr().modify(|w| w.set_en(false));
    for _ in 0..STREAM_POLLS {
        if !stream.cr().read().en() {
            break;
        }
    }
}

fn send_stop_frames() {
    MOTOR_TIMER.cr1().write(|w| {
        w.set_arpe(true);
        w.set_cen(true);
    });
    for _ in 0..STOP_FRAMES {
        wait_bits(GAP_BITS);
        // Holds from the next bit on, for the frame's sixteen: value and checksum of a stop are zeros.
        set_pulse(ZERO_COUNTS);
        wait_bits(FRAME_BITS as u32);
        set_pulse(0);
        wait_bits(1);
    }
}

fn set_pulse(counts: u16) {
    for channel in 0..MOTOR_PINS.len() {
        MOTOR_TIMER.ccr(channel).write(|w| w.set_ccr(counts));
    }
}

fn wait_bits(bits: u32) {
    for _ in 0..bits {
        MOTOR_TIMER.sr().write(|w| w.set_uif(false));
        for _ in 0..BIT_POLLS {
            if MOTOR_TIMER.sr().read().uif() {
                break;
            }
        }
    }
}

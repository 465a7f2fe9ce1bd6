//! Four motors at once: DShot600 by one timer and one DMA burst a tick.
//!
//! TIM4 counts 140 cycles of 84 MHz per bit and pulses its four channels by their compare registers, which are
//! preloaded: what is written during a bit holds from the next one on. At each update the timer asks the DMA
//! controller for four words, the next bit of each motor, which go to the four compare registers through DMAR. The
//! first bit is written by the program; 16 and 17 are empty, so that the line is low when the stream ends.
//!
//! A frame begins [`MOTOR_START_US`] after the gyro's edge, not when the program is done: the timer first counts what is
//! left of that with all lines low, as one long empty bit, and the update at its end begins the first. So the latency is
//! that constant to within the stamp's own error, and the processor is free meanwhile. A frame that is ready too late
//! begins at once and is counted.
//!
//! The stream's interrupt stops the timer there, before it could ask for more: a request that nobody serves would be
//! served first in the next frame and shift it by a bit.
//!
//! Nothing waits: a frame is started in one tick and looked after in the next, 1.2 ms after it had to be finished.
#![allow(unsafe_code)]

use core::sync::atomic::{AtomicU32, Ordering};

use cortex_m::peripheral::DWT;
use embassy_stm32::interrupt;
use embassy_stm32::pac::DMA1;
use embassy_stm32::pac::dma::vals::{Dir, Pl, Size};
use embassy_stm32::pac::timer::vals::Ocm;
use embassy_stm32::{peripherals, rcc};
use mintime_firmware::config::MOTOR_COUNT;
use mintime_firmware::dshot::{BIT_COUNTS, FRAME_BITS, Frame};

use super::facts::{
    CORE_MHZ, MOTOR_DMA_CHANNEL, MOTOR_DMA_STREAM, MOTOR_FIRST_COMPARE, MOTOR_START_US, MOTOR_TIMER,
    MotorParts, TIMER_MHZ,
};
use super::motors;

/// Bits that the stream brings: the second to the last, and two empty ones.
const STREAM_BITS: usize = FRAME_BITS + 1;
/// Words that the stream moves.
const STREAM_WORDS: u16 = (STREAM_BITS * MOTOR_COUNT) as u16;
/// A frame and its two empty bits last 30 µs. One that takes longer than this from when it was handed over is lost.
const FRAME_LIMIT_CYCLES: u32 = (MOTOR_START_US + 60) * CORE_MHZ;
/// Processor cycles per count of the timer.
const CYCLES_PER_COUNT: u32 = CORE_MHZ / TIMER_MHZ as u32;
/// From the edge to the first bit, counts of the timer.
const WAIT_COUNTS: u16 = MOTOR_START_US as u16 * TIMER_MHZ;
/// The wait can begin here at the latest.
const LAST_COUNT: u16 = WAIT_COUNTS - 2;

/// What the stream reads, bit by bit, motor by motor. In main RAM: DMA cannot reach the core-coupled memory. Atomics,
/// because somebody else reads them.
static BITS: [[AtomicU32; MOTOR_COUNT]; STREAM_BITS] =
    [const { [const { AtomicU32::new(0) }; MOTOR_COUNT] }; STREAM_BITS];

/// Frames that came to their end.
static FINISHED: AtomicU32 = AtomicU32::new(0);
/// The cycle counter when the latest did.
static END_CYCLES: AtomicU32 = AtomicU32::new(0);

/// The motor outputs.
pub(super) struct Motors {
    _parts: MotorParts,
    started: u32,
    /// The cycle counter at the start of the frame under way, if there is one.
    under_way: Option<u32>,
    errors: u32,
}

impl Motors {
    /// Takes the four lines over; they stay low until the first frame.
    pub(super) fn new(parts: MotorParts) -> Self {
        set_up_timer();
        let stream = DMA1.st(MOTOR_DMA_STREAM);
        stream.par().write_value(MOTOR_TIMER.dmar().as_ptr() as u32);
        stream.m0ar().write_value(BITS.as_ptr() as u32);
        motors::connect();
        Self { _parts: parts, started: 0, under_way: None, errors: 0 }
    }

    /// Looks after the frame of the last tick: the cycle counter at the end of its last bit, if it was sent in full. One
    /// that was not is taken back and counted.
    pub(super) fn finish(&mut self) -> Option<u32> {
        let start = self.under_way?;
        let stopped = !DMA1.st(MOTOR_DMA_STREAM).cr().read().en();
        if stopped && FINISHED.load(Ordering::Relaxed) == self.started {
            self.under_way = None;
            return Some(END_CYCLES.load(Ordering::Relaxed));
        }
        if DWT::cycle_count().wrapping_sub(start) > FRAME_LIMIT_CYCLES {
            self.errors = self.errors.saturating_add(1);
            self.take_back();
            self.under_way = None;
        }
        None
    }

    /// Starts a frame: at its time after the edge that it answers, or at once where there is none or the time is past. One
    /// that is still under way is let finish, and this one is counted as an error.
    pub(super) fn send(&mut self, frames: &[Frame; MOTOR_COUNT], edge: Option<u32>) {
        if self.under_way.is_some() || DMA1.st(MOTOR_DMA_STREAM).cr().read().en() {
            self.errors = self.errors.saturating_add(1);
            return;
        }
        self.started = FINISHED.load(Ordering::Relaxed).wrapping_add(1);
        // In this order: the stream reads its first word when it is switched on (RM0090 10.3.7).
        fill(frames);
        start_stream();
        // The round that waits, an empty bit; all lines stay low. No request, for the stream's first word is the second bit.
        MOTOR_TIMER.arr().write(|w| w.set_arr(WAIT_COUNTS));
        MOTOR_TIMER.egr().write(|w| w.set_ug(true));
        // The update that this was is no request, whether or not the timer keeps it in mind until its requests are enabled.
        MOTOR_TIMER.sr().write(|w| w.set_uif(false));
        // These hold from the end of that round on: the first bit, on all lines at once, and the request for the second.
        set_bit_rate();
        for (channel, frame) in frames.iter().enumerate() {
            MOTOR_TIMER.ccr(channel).write(|w| w.set_ccr(frame.pulse_counts(0)));
        }
        MOTOR_TIMER.dier().write(|w| w.set_ude(true));
        // The round began with the edge.
        let now = DWT::cycle_count();
        let passed = edge.map_or(u32::MAX, |edge| now.wrapping_sub(edge) / CYCLES_PER_COUNT);
        let late = passed > u32::from(LAST_COUNT);
        MOTOR_TIMER.cnt().write(|w| w.set_cnt(if late { LAST_COUNT } else { passed as u16 }));
        MOTOR_TIMER.cr1().write(|w| {
            w.set_arpe(true);
            w.set_cen(true);
        });
        self.under_way = Some(now);
        self.errors = self.errors.saturating_add(u32::from(late && edge.is_some()));
    }

    /// Frames that were not sent in time or not in full.
    pub(super) fn errors(&self) -> u32 {
        self.errors
    }

    /// Ends whatever the stream and the timer are doing; the lines are low then.
    fn take_back(&mut self) {
        MOTOR_TIMER.dier().write(|_| {});
        motors::stop_stream();
        // A reset of the timer forgets a request that nobody served. The lines are pulled down meanwhile.
        set_up_timer();
    }
}

/// Puts the second bit and those after it where the stream reads them.
fn fill(frames: &[Frame; MOTOR_COUNT]) {
    // The last two are empty for ever.
    for (slot, words) in (1..FRAME_BITS).zip(&BITS) {
        for (word, frame) in words.iter().zip(frames) {
            word.store(u32::from(frame.pulse_counts(slot)), Ordering::Relaxed);
        }
    }
}

/// Makes the stream ready for the timer's requests.
fn start_stream() {
    clear_flags();
    let stream = DMA1.st(MOTOR_DMA_STREAM);
    stream.ndtr().write(|w| w.set_ndt(STREAM_WORDS));
    // The words are in memory before the stream may read them.
    cortex_m::asm::dmb();
    stream.cr().write(|w| {
        w.set_chsel(MOTOR_DMA_CHANNEL);
        w.set_dir(Dir::MEMORY_TO_PERIPHERAL);
        w.set_minc(true);
        w.set_msize(Size::BITS32);
        w.set_psize(Size::BITS32);
        w.set_pl(Pl::VERY_HIGH);
        w.set_tcie(true);
        w.set_teie(true);
        w.set_en(true);
    });
}

/// A round of the timer is a bit, from the end of the present one on.
fn set_bit_rate() {
    MOTOR_TIMER.arr().write(|w| w.set_arr(BIT_COUNTS - 1));
}

/// The timer from scratch: stopped, four channels in PWM mode 1 at zero.
fn set_up_timer() {
    rcc::enable_and_reset::<peripherals::TIM4>();
    MOTOR_TIMER.psc().write_value(0);
    set_bit_rate();
    for pair in 0..2 {
        MOTOR_TIMER.ccmr_output(pair).write(|w| {
            for channel in 0..2 {
                w.set_ocm(channel, Ocm::PWM_MODE1);
                w.set_ocpe(channel, true);
            }
        });
    }
    MOTOR_TIMER.dcr().write(|w| {
        w.set_dba(MOTOR_FIRST_COMPARE);
        // Transfers less one.
        w.set_dbl(MOTOR_COUNT as u8 - 1);
    });
    MOTOR_TIMER.cr1().write(|w| w.set_arpe(true));
    MOTOR_TIMER.egr().write(|w| w.set_ug(true));
    MOTOR_TIMER.ccer().write(|w| {
        for channel in 0..MOTOR_COUNT {
            w.set_cce(channel, true);
        }
    });
}

/// The stream is done: during the first empty bit, or after an error of the bus.
#[interrupt]
unsafe fn DMA1_STREAM6() {
    let cycles = DWT::cycle_count();
    MOTOR_TIMER.dier().write(|_| {});
    MOTOR_TIMER.cr1().write(|w| w.set_arpe(true));
    let (register, stream) = (MOTOR_DMA_STREAM / 4, MOTOR_DMA_STREAM % 4);
    if DMA1.isr(register).read().tcif(stream) {
        END_CYCLES.store(cycles, Ordering::Relaxed);
        // One writer: no read-modify-write needed.
        FINISHED.store(FINISHED.load(Ordering::Relaxed).wrapping_add(1), Ordering::Relaxed);
    }
    clear_flags();
    cortex_m::asm::dsb();
}

fn clear_flags() {
    let (register, stream) = (MOTOR_DMA_STREAM / 4, MOTOR_DMA_STREAM % 4);
    DMA1.ifcr(register).write(|w| {
        w.set_tcif(stream, true);
        w.set_htif(stream, true);
        w.set_teif(stream, true);
        w.set_dmeif(stream, true);
        w.set_feif(stream, true);
    });
}

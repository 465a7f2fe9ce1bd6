//! What starts a control tick: the gyro's data-ready edge, stamped at once, or a timer where the edge stays away.
//!
//! The edge's handler has the highest priority and no critical section masks it ([`super::critical`]), so that the
//! stamp is late by the interrupt's entry only: 0.1 µs, and 0.4 µs where it meets the end of a motor frame. It pends the
//! control tick, a software interrupt of the next priority, and closes the line, for nothing could stop a line that rings from
//! taking the whole processor at that priority. The timer opens it again when the next edge may come ([`listen`]).
#![allow(unsafe_code)]

use core::sync::atomic::{AtomicU32, Ordering};

use cortex_m::peripheral::{DWT, NVIC};
use embassy_stm32::gpio::{Input, Pull};
use embassy_stm32::interrupt;
use embassy_stm32::interrupt::InterruptExt;
use embassy_stm32::pac::timer::vals::Urs;
use embassy_stm32::pac::{EXTI, SYSCFG, TIM7};
use embassy_stm32::{Peri, peripherals, rcc};

use super::facts::{CONTROL_INTERRUPT, EDGE_LINE, EDGE_PORT, TIMER_MHZ};

/// The cycle counter at the latest edge.
static EDGE_CYCLES: AtomicU32 = AtomicU32::new(0);

/// The data-ready pin, while it is no interrupt yet.
pub(super) struct EdgeInput(Input<'static>);

impl EdgeInput {
    /// With a pull-down: a line that nobody drives has no edges.
    pub(super) fn new(pin: Peri<'static, peripherals::PC4>) -> Self {
        Self(Input::new(pin, Pull::Down))
    }
}

/// Makes rising edges of the pin start ticks from now on.
pub(super) fn enable_edge(input: EdgeInput) {
    // Dropping the input would disconnect the pin.
    core::mem::forget(input.0);
    SYSCFG.exticr(EDGE_LINE / 4).modify(|w| w.set_exti(EDGE_LINE % 4, EDGE_PORT));
    EXTI.ftsr(0).modify(|w| w.set_line(EDGE_LINE, false));
    EXTI.rtsr(0).modify(|w| w.set_line(EDGE_LINE, true));
    EXTI.pr(0).write(|w| w.set_line(EDGE_LINE, true));
    EXTI.imr(0).modify(|w| w.set_line(EDGE_LINE, true));
    // SAFETY: its handler below touches atomics and registers of its own only; no critical section relies on its mask.
    unsafe { interrupt::EXTI4.enable() };
}

/// The edge.
#[interrupt]
unsafe fn EXTI4() {
    let cycles = DWT::cycle_count();
    // In this order: whatever the line does from here on, it asks for nothing.
    EXTI.imr(0).modify(|w| w.set_line(EDGE_LINE, false));
    EXTI.pr(0).write(|w| w.set_line(EDGE_LINE, true));
    EDGE_CYCLES.store(cycles, Ordering::Relaxed);
    NVIC::pend(CONTROL_INTERRUPT);
    // The line is clear before the handler returns, or it would be entered twice.
    cortex_m::asm::dsb();
}

/// Opens the line for the next edge; edges before that count for nothing. Whether there were any.
pub(super) fn listen() -> bool {
    let noisy = EXTI.pr(0).read().line(EDGE_LINE);
    EXTI.pr(0).write(|w| w.set_line(EDGE_LINE, true));
    // The edge's handler, who writes there too, cannot come in between.
    EXTI.imr(0).modify(|w| w.set_line(EDGE_LINE, true));
    noisy
}

/// The cycle counter at the latest edge. It holds while the line is closed.
pub(super) fn edge_cycles() -> u32 {
    EDGE_CYCLES.load(Ordering::Relaxed)
}

/// The timer that opens the line and runs a tick without a sample: TIM7, which can do nothing else and has no pin.
pub(super) struct LateTimer {
    _timer: Peri<'static, peripherals::TIM7>,
}

impl LateTimer {
    /// Counts microseconds; stands still until it is armed.
    pub(super) fn new(timer: Peri<'static, peripherals::TIM7>) -> Self {
        rcc::enable_and_reset::<peripherals::TIM7>();
        TIM7.psc().write_value(TIMER_MHZ - 1);
        // Setting the counter back is no update worth an interrupt.
        TIM7.cr1().write(|w| w.set_urs(Urs::COUNTER_ONLY));
        TIM7.dier().write(|w| w.set_uie(true));
        Self { _timer: timer }
    }

    /// Fires this many microseconds from now (1..=65535; more counts as the most), and again after as long, until it is
    /// armed anew.
    pub(super) fn arm(&mut self, delay_us: u64) {
        let counts = u16::try_from(delay_us).unwrap_or(u16::MAX).max(2);
        TIM7.cr1().modify(|w| w.set_cen(false));
        TIM7.arr().write(|w| w.set_arr(counts - 1));
        // Takes the prescaler over and sets the counter to zero.
        TIM7.egr().write(|w| w.set_ug(true));
        self.clear();
        TIM7.cr1().modify(|w| w.set_cen(true));
    }

    /// Takes its firing back.
    pub(super) fn clear(&mut self) {
        TIM7.sr().write(|w| w.set_uif(false));
    }
}

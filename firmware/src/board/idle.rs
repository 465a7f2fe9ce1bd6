//! Thread mode: runs the tasks, sleeps when there is nothing to do, and measures how long.
#![allow(unsafe_code)]

use core::ptr;
use core::sync::atomic::{AtomicU32, Ordering};

use cortex_m::peripheral::DWT;
use embassy_executor::{Spawner, raw};
use static_cell::StaticCell;

static EXECUTOR: StaticCell<raw::Executor> = StaticCell::new();

/// Cycles slept since power-up; wraps.
static ASLEEP_CYCLES: AtomicU32 = AtomicU32::new(0);

/// Runs for ever. `spawn` starts the tasks.
///
/// Sleeps with interrupts off, so that what woke the processor runs only after the time is taken and is not counted as
/// sleep; the chip wakes all the same because `core_setup` makes a pending interrupt an event. That delays whatever
/// woke it by some ten cycles. A task woken between the poll and the sleep has left an event: the sleep then ends at
/// once.
pub(super) fn run(spawn: impl FnOnce(Spawner)) -> ! {
    // Without interrupt executors a woken task always signals an event; the context is not looked at.
    let executor: &'static raw::Executor = EXECUTOR.init(raw::Executor::new(ptr::null_mut()));
    spawn(executor.spawner());
    loop {
        // SAFETY: the executor is initialised, and polled from here only.
        unsafe { executor.poll() };
        cortex_m::interrupt::disable();
        let from = DWT::cycle_count();
        cortex_m::asm::wfe();
        let asleep = DWT::cycle_count().wrapping_sub(from);
        // SAFETY: they were on before, for start-up never switches them off.
        unsafe { cortex_m::interrupt::enable() };
        // One writer: no read-modify-write needed.
        ASLEEP_CYCLES.store(ASLEEP_CYCLES.load(Ordering::Relaxed).wrapping_add(asleep), Ordering::Relaxed);
    }
}

/// Measures the processor's load between two calls, which must be less than 25 s apart (the counters wrap).
pub(super) struct LoadMeter {
    cycles: u32,
    asleep: u32,
}

impl LoadMeter {
    /// Begins to measure.
    pub(super) fn new() -> Self {
        Self { cycles: DWT::cycle_count(), asleep: ASLEEP_CYCLES.load(Ordering::Relaxed) }
    }

    /// Part of the time since the last call that the processor was awake, ‰.
    pub(super) fn permille(&mut self) -> u16 {
        let now = Self::new();
        // In units of 1024 cycles, so that a thousandfold of them still fits.
        let all = now.cycles.wrapping_sub(self.cycles) >> 10;
        let asleep = now.asleep.wrapping_sub(self.asleep) >> 10;
        *self = now;
        let awake = all.saturating_sub(asleep).saturating_mul(1000).checked_div(all).unwrap_or(0);
        u16::try_from(awake).unwrap_or(1000)
    }
}

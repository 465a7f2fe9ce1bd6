//! Critical sections that leave the three most urgent interrupts on.
//!
//! The usual implementation masks every interrupt, so that a log line or a copy of received bytes would delay the time
//! stamp of the gyro's edge unseen: a measured latency would be better than the true one. This one raises the
//! processor's base priority instead and so masks priorities 1..15 only.
//!
//! Rule that makes it sound: handlers of priority 0 (`tick_source`, `dshot`, `supply`) touch atomics and registers of their own
//! only; no waker, no pipe, nothing that a critical section guards.
#![allow(unsafe_code)]

use core::sync::atomic::{Ordering, compiler_fence};

use cortex_m::register::basepri;
use critical_section::RawRestoreState;

/// Priority 1 in the four upper bits, where this chip keeps it: masks 1 and everything less urgent.
const MASK: u8 = 1 << 4;

struct BasePriority;
critical_section::set_impl!(BasePriority);

// SAFETY: one core; whatever may run inside a critical section's code has priority 1..15 or is thread mode, and is
// masked between `acquire` and `release`. Nested sections restore what they found.
unsafe impl critical_section::Impl for BasePriority {
    unsafe fn acquire() -> RawRestoreState {
        let before = basepri::read();
        // SAFETY: priorities are masked more strictly or as before, never less: nested sections find `MASK`.
        unsafe { basepri::write(MASK) };
        // The new priority holds from here on, and nothing is moved out of the section.
        cortex_m::asm::isb();
        compiler_fence(Ordering::SeqCst);
        u32::from(before)
    }

    unsafe fn release(before: RawRestoreState) {
        compiler_fence(Ordering::SeqCst);
        // SAFETY: the value is the one that `acquire` found.
        unsafe { basepri::write(before as u8) };
    }
}

//! How much of the stack was ever used.
#![allow(unsafe_code)]

use core::ptr;

use cortex_m_rt::STACK_PAINT_VALUE;

unsafe extern "C" {
    static _stack_start: u32;
    static _stack_end: u32;
}

/// Deepest use of the stack since start-up [bytes]: start-up paints it, and what is no longer paint was used.
///
/// At most 4096 words are looked at, a tenth of a millisecond, in thread mode.
pub(super) fn used_bytes() -> u32 {
    let top = &raw const _stack_start as u32;
    let mut address = &raw const _stack_end as u32;
    // SAFETY: aligned and inside the stack, which is RAM; volatile, because it is other code's memory.
    while address < top && unsafe { ptr::read_volatile(address as *const u32) } == STACK_PAINT_VALUE {
        address += 4;
    }
    top - address
}

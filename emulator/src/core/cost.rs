//! Cycles of an instruction before memory has its say (Cortex-M4 Technical Reference Manual, table 3-1 and 7-1).
use crate::core::op::{Barrier, Float2, Float3, Op};

/// Which of the two figures of the cycle model drives virtual time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Timing {
    /// Flash without wait states, no other master on the bus, refills of the pipeline in one cycle.
    Optimistic,
    /// Wait states behind the accelerator's caches (RM0090 section 3.5.2), one cycle lost to another bus master at
    /// each access to SRAM, the bridges to the peripheral buses at their slowest, DMA that takes its time, refills of the pipeline in three cycles, divisions of full length.
    Pessimistic,
}

/// Refill of the pipeline after a taken branch (the manual says 1 to 3).
pub(crate) const fn refill(pessimistic: bool) -> u64 {
    if pessimistic { 3 } else { 1 }
}

/// Cycles lost to another bus master at an access to SRAM.
pub(crate) const fn contention(pessimistic: bool) -> u64 {
    if pessimistic { 1 } else { 0 }
}

/// Exception entry and return, tail-chaining (Cortex-M4 TRM 3.9).
pub(crate) const ENTRY: u64 = 12;
/// Return pops eight words and refills.
pub(crate) const RETURN: u64 = 10;
/// From one handler to the next without unstacking.
pub(crate) const TAIL_CHAIN: u64 = 6;

/// Early termination: the more bits the quotient has, the longer (2 to 12 cycles).
pub(crate) fn division(dividend: u32, divisor: u32, pessimistic: bool) -> u64 {
    if pessimistic {
        return 12;
    }
    let quotient_bits = (divisor.leading_zeros() + 1).saturating_sub(dividend.leading_zeros());
    2 + u64::from(quotient_bits) * 10 / 33
}

/// Cycles that depend on the encoding alone. Loads count their first cycle here, the second where it cannot be
/// hidden behind a load or store before it.
pub(crate) fn fixed(op: Op) -> u8 {
    let cycles = match op {
        Op::Push { list } | Op::Pop { list } | Op::Ldm { list, .. } | Op::Stm { list, .. } => {
            1 + list.count_ones()
        }
        Op::Ldrd { .. } | Op::Strd { .. } => 3,
        Op::Ldrex { .. } | Op::Strex { .. } => 2,
        Op::TableBranch { .. } => 2,
        Op::Vldm { count, .. } | Op::Vstm { count, .. } => 1 + u32::from(count),
        Op::Vldr { double, .. } | Op::Vstr { double, .. } => 2 + u32::from(double),
        Op::VmovPair { .. } => 2,
        Op::Float3 { op: Float3::Div, .. } | Op::Float2 { op: Float2::Sqrt, .. } => 14,
        Op::Float3 { op: Float3::Nmul, .. } => 1,
        Op::Float3 { .. } => 3,
        Op::Barrier { kind: Barrier::Instruction } => 4,
        // The remaining cycles depend on the operands.
        Op::Udiv { .. } | Op::Sdiv { .. } => 0,
        _ => 1,
    };
    cycles as u8
}

//! Which exception comes next: pending, active, enabled and priorities (B1.5.3 to B1.5.5, B3.4).
use crate::core::Core;

/// Interrupt lines of an STM32F405 (RM0090 table 62).
pub(crate) const IRQS: usize = 82;
/// Exceptions, the sixteen of the architecture included.
const EXCEPTIONS: usize = 16 + IRQS;
/// Bits of implemented interrupts, by exception number.
const IRQ_MASK: u128 = ((1 << IRQS) - 1) << 16;

pub(crate) const NMI: u16 = 2;
pub(crate) const HARD_FAULT: u16 = 3;
pub(crate) const MEM_MANAGE: u16 = 4;
pub(crate) const BUS_FAULT: u16 = 5;
pub(crate) const USAGE_FAULT: u16 = 6;
pub(crate) const SV_CALL: u16 = 11;
pub(crate) const DEBUG_MONITOR: u16 = 12;
pub(crate) const PEND_SV: u16 = 14;
pub(crate) const SYS_TICK: u16 = 15;

/// Priority of a thread that masks nothing.
pub(crate) const LOWEST: i16 = 256;

/// State of every exception; sets are bit masks by exception number.
#[derive(Clone, Debug)]
pub(crate) struct Nvic {
    pub(crate) pending: u128,
    pub(crate) active: u128,
    pub(crate) enabled: u128,
    /// Configured priorities; only the upper four bits exist.
    pub(crate) priority: [u8; EXCEPTIONS],
    /// AIRCR.PRIGROUP.
    pub(crate) group: u8,
    lines: u128,
}

impl Default for Nvic {
    fn default() -> Self {
        Self { pending: 0, active: 0, enabled: !IRQ_MASK, priority: [0; EXCEPTIONS], group: 0, lines: 0 }
    }
}

/// The set with one exception.
pub(crate) fn bit(exception: u16) -> u128 {
    1_u128.checked_shl(u32::from(exception)).unwrap_or(0)
}

impl Nvic {
    /// Levels as last given to [`set_lines`](Self::set_lines); bit n is IRQ n.
    pub(crate) fn lines(&self) -> u128 {
        self.lines
    }

    /// New levels: one that rises pends its interrupt (B3.4.1).
    pub(crate) fn set_lines(&mut self, lines: u128) {
        let rising = (lines & !self.lines) << 16;
        self.lines = lines;
        self.pending |= rising & IRQ_MASK;
    }

    /// Levels still high pend again, but for interrupts being handled.
    pub(crate) fn pend_high_lines(&mut self) {
        self.pending |= (self.lines << 16) & IRQ_MASK & !self.active;
    }

    /// Priority of an exception as configured; fixed below zero for the first three.
    pub(crate) fn priority_of(&self, exception: u16) -> i16 {
        match exception {
            0 => LOWEST,
            1 => -3,
            NMI => -2,
            HARD_FAULT => -1,
            _ => i16::from(self.priority.get(usize::from(exception)).copied().unwrap_or(0)),
        }
    }

    /// The part of a priority that preempts (B1.5.4): bits PRIGROUP..0 are the subpriority.
    pub(crate) fn group_priority(&self, priority: i16) -> i16 {
        if (0..LOWEST).contains(&priority) { priority & !((2_i16 << self.group) - 1) } else { priority }
    }

    /// Highest group priority among `set`; [`LOWEST`] where it is empty.
    pub(crate) fn highest_group(&self, set: u128) -> i16 {
        each(set).map(|exception| self.group_priority(self.priority_of(exception))).min().unwrap_or(LOWEST)
    }

    /// The pending, enabled exception of the highest priority, subpriority and lowest number.
    pub(crate) fn next_pending(&self) -> Option<(u16, i16)> {
        let candidates = self.pending & self.enabled;
        if candidates == 0 {
            return None;
        }
        each(candidates)
            .min_by_key(|&exception| (self.priority_of(exception), exception))
            .map(|exception| (exception, self.group_priority(self.priority_of(exception))))
    }
}

/// The members of a set, lowest number first.
fn each(mut set: u128) -> impl Iterator<Item = u16> {
    std::iter::from_fn(move || {
        if set == 0 {
            return None;
        }
        let number = set.trailing_zeros() as u16;
        set &= set - 1;
        Some(number)
    })
}

impl Core {
    /// ExecutionPriority() (B1.5.4).
    pub(crate) fn execution_priority(&self) -> i16 {
        let mut priority = self.nvic.highest_group(self.nvic.active);
        if self.basepri != 0 {
            priority = priority.min(self.nvic.group_priority(i16::from(self.basepri)));
        }
        if self.primask {
            priority = priority.min(0);
        }
        if self.faultmask {
            priority = priority.min(-1);
        }
        priority
    }

    /// The exception to take now, if any.
    pub(crate) fn exception_to_take(&self) -> Option<u16> {
        let (exception, priority) = self.nvic.next_pending()?;
        (priority < self.execution_priority()).then_some(exception)
    }

    /// Whether WFI would wake: an exception would preempt were PRIMASK clear (B1.5.19).
    pub(crate) fn wakes(&self) -> bool {
        let Some((_, priority)) = self.nvic.next_pending() else { return false };
        let mut masked = self.nvic.highest_group(self.nvic.active);
        if self.basepri != 0 {
            masked = masked.min(self.nvic.group_priority(i16::from(self.basepri)));
        }
        if self.faultmask {
            masked = masked.min(-1);
        }
        priority < masked
    }

    /// New levels of the interrupt lines.
    pub(crate) fn set_lines(&mut self, lines: u128) {
        let before = self.nvic.pending;
        self.nvic.set_lines(lines);
        if self.scs.sends_event_on_pend() && before != self.nvic.pending {
            self.event = true;
        }
        self.deadline = 0;
    }

    /// Marks an exception pending; with SEVONPEND that is an event (B1.5.18).
    pub(crate) fn pend(&mut self, exception: u16) {
        let bit = bit(exception);
        if self.nvic.pending & bit == 0 {
            self.nvic.pending |= bit;
            if self.scs.sends_event_on_pend() {
                self.event = true;
            }
        }
        self.deadline = 0;
    }
}

//! SysTick (B3.3), counted from where it was last touched instead of tick by tick.
use crate::bus::{Cycle, NEVER};

/// The timer of the architecture: 24 bits, down.
#[derive(Clone, Debug, Default)]
pub(crate) struct SysTick {
    enabled: bool,
    /// TICKINT.
    interrupt: bool,
    /// CLKSOURCE: the core clock, or an eighth of it (RM0090 section 6.2).
    core_clock: bool,
    /// COUNTFLAG.
    counted: bool,
    reload: u32,
    /// Value at `since`.
    value: u32,
    since: Cycle,
}

impl SysTick {
    fn divider(&self) -> u64 {
        if self.core_clock { 1 } else { 8 }
    }

    /// Ticks until the counter next reaches zero, from `value`.
    fn first_zero(&self) -> Option<u64> {
        match (self.value, self.reload) {
            (0, 0) => None,
            (0, reload) => Some(u64::from(reload) + 1),
            (value, _) => Some(u64::from(value)),
        }
    }

    /// When the counter next reaches zero.
    pub(crate) fn next_event(&self) -> Cycle {
        match self.first_zero() {
            Some(ticks) if self.enabled => self.since + ticks * self.divider(),
            _ => NEVER,
        }
    }

    /// Counts up to `now`; whether SysTick becomes pending.
    pub(crate) fn advance(&mut self, now: Cycle) -> bool {
        if !self.enabled || now <= self.since {
            return false;
        }
        let ticks = (now - self.since) / self.divider();
        if ticks == 0 {
            return false;
        }
        self.since += ticks * self.divider();
        let period = u64::from(self.reload) + 1;
        match self.first_zero() {
            None => false,
            Some(first) if ticks < first => {
                self.value = (first - ticks) as u32;
                false
            }
            Some(first) => {
                let after = (ticks - first) % period;
                self.value = if after == 0 { 0 } else { (period - after) as u32 };
                self.counted = true;
                self.interrupt
            }
        }
    }

    /// SYST_CSR; reading clears COUNTFLAG. The caller has advanced.
    pub(crate) fn read_control(&mut self) -> u32 {
        let counted = std::mem::take(&mut self.counted);
        u32::from(self.enabled)
            | u32::from(self.interrupt) << 1
            | u32::from(self.core_clock) << 2
            | u32::from(counted) << 16
    }

    pub(crate) fn write_control(&mut self, value: u32, now: Cycle) {
        if !self.enabled {
            self.since = now;
        }
        self.enabled = value & 1 != 0;
        self.interrupt = value & 2 != 0;
        self.core_clock = value & 4 != 0;
    }

    pub(crate) fn reload(&self) -> u32 {
        self.reload
    }

    pub(crate) fn set_reload(&mut self, value: u32) {
        self.reload = value & 0xFF_FFFF;
    }

    pub(crate) fn value(&self) -> u32 {
        self.value
    }

    /// Any write clears the counter and COUNTFLAG.
    pub(crate) fn clear_value(&mut self, now: Cycle) {
        self.value = 0;
        self.counted = false;
        self.since = now;
    }
}

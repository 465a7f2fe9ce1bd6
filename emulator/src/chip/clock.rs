//! The clock tree: how cycles of the core clock relate to nanoseconds and to the clocks of the buses.

use crate::bus::Cycle;

/// Frequency of the internal oscillator, which runs the chip after a reset (Hz).
pub const HSI_HZ: u32 = 16_000_000;

/// One setting of the clocks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Rates {
    /// SYSCLK (Hz).
    pub sysclk_hz: u32,
    /// HCLK, the core clock (Hz).
    pub hclk_hz: u32,
    /// HCLK cycles per cycle of PCLK1: a power of two.
    pub apb1_divider: u32,
    /// HCLK cycles per cycle of PCLK2: a power of two.
    pub apb2_divider: u32,
}

/// The two peripheral buses.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Apb {
    /// The slow one.
    One,
    /// The fast one.
    Two,
}

/// Clocks and the piecewise-linear map between [`Cycle`] and nanoseconds since power-up.
#[derive(Clone, Debug)]
pub struct Clock {
    rates: Rates,
    anchor_cycle: Cycle,
    anchor_ns: u64,
}

const NS_PER_S: u64 = 1_000_000_000;

impl Clock {
    /// As after a reset: everything runs from the internal oscillator.
    pub fn new() -> Self {
        Self { rates: Rates::RESET, anchor_cycle: 0, anchor_ns: 0 }
    }

    /// The present rates.
    pub fn rates(&self) -> Rates {
        self.rates
    }

    /// Nanoseconds since power-up at `cycle`, rounded down. Cycles before the last change of rate count as that change.
    pub fn ns(&self, cycle: Cycle) -> u64 {
        let (seconds, rest) = self.since_anchor(cycle);
        self.anchor_ns + seconds * NS_PER_S + rest * NS_PER_S / u64::from(self.rates.hclk_hz)
    }

    /// First cycle at or after `ns`; [`crate::bus::NEVER`] for `u64::MAX`. Times before the last change of rate count
    /// as that change.
    pub fn cycle(&self, ns: u64) -> Cycle {
        if ns == u64::MAX {
            return crate::bus::NEVER;
        }
        let hclk = u64::from(self.rates.hclk_hz);
        let ns = ns.saturating_sub(self.anchor_ns);
        self.anchor_cycle + (ns / NS_PER_S) * hclk + ((ns % NS_PER_S) * hclk).div_ceil(NS_PER_S)
    }

    /// Length of `cycles` at the present rate (ns).
    pub fn span_ns(&self, cycles: u64) -> f64 {
        cycles as f64 * 1e9 / f64::from(self.rates.hclk_hz)
    }

    /// Cycles that last at least `ns` at the present rate.
    pub fn cycles_for(&self, ns: u64) -> u64 {
        let hclk = u64::from(self.rates.hclk_hz);
        (ns / NS_PER_S) * hclk + ((ns % NS_PER_S) * hclk).div_ceil(NS_PER_S)
    }

    /// HCLK cycles per cycle of a bus clock.
    pub fn apb_divider(&self, bus: Apb) -> u32 {
        match bus {
            Apb::One => self.rates.apb1_divider,
            Apb::Two => self.rates.apb2_divider,
        }
    }

    /// Frequency of a bus clock (Hz).
    pub fn apb_hz(&self, bus: Apb) -> u32 {
        self.rates.hclk_hz / self.apb_divider(bus)
    }

    /// HCLK cycles per cycle of the timers of a bus: they run at twice its rate unless that is undivided (RM0090
    /// section 7.2).
    pub fn timer_divider(&self, bus: Apb) -> u32 {
        match self.apb_divider(bus) {
            1 => 1,
            divider => divider / 2,
        }
    }

    /// Changes the rates at `at`.
    pub fn switch(&mut self, at: Cycle, rates: Rates) {
        self.anchor_ns = self.ns(at);
        self.anchor_cycle = self.anchor_cycle.max(at);
        self.rates = rates;
    }

    /// Whole seconds and the cycles left over, so that no product below overflows.
    fn since_anchor(&self, cycle: Cycle) -> (u64, u64) {
        let cycles = cycle.saturating_sub(self.anchor_cycle);
        let hclk = u64::from(self.rates.hclk_hz);
        (cycles / hclk, cycles % hclk)
    }
}

impl Default for Clock {
    fn default() -> Self {
        Self::new()
    }
}

impl Rates {
    /// After a reset.
    pub const RESET: Self = Self { sysclk_hz: HSI_HZ, hclk_hz: HSI_HZ, apb1_divider: 1, apb2_divider: 1 };
}

#[cfg(test)]
mod tests {
    use super::{Clock, Rates};

    #[test]
    fn time_goes_on_across_a_change_of_rate() {
        let mut clock = Clock::new();
        assert_eq!(clock.ns(16_000), 1_000_000);
        clock.switch(
            16_000,
            Rates { sysclk_hz: 168_000_000, hclk_hz: 168_000_000, apb1_divider: 4, apb2_divider: 2 },
        );
        assert_eq!(clock.ns(16_000 + 168_000), 2_000_000);
        assert_eq!(clock.cycle(2_000_000), 184_000);
        for ns in [1_000_006, 1_500_000, 3_600_000_000_123] {
            let cycle = clock.cycle(ns);
            assert!(clock.ns(cycle) >= ns.saturating_sub(1) && clock.ns(cycle - 1) < ns);
        }
        assert_eq!((clock.timer_divider(super::Apb::One), clock.timer_divider(super::Apb::Two)), (2, 1));
    }
}

//! A timer that counts up: time base, compare channels, requests (RM0090 sections 17 to 20).
//!
//! Nothing happens cycle by cycle. A timer knows when its count was what, and brings its flags up to date when
//! somebody looks ([`Timer::step`]); only what somebody waits for becomes an event ([`Timer::next_due`]).

use super::timer_outputs::Period;
use crate::bus::{Cycle, NEVER};

pub(super) const CR1_CEN: u32 = 1;
pub(super) const CR1_UDIS: u32 = 1 << 1;
pub(super) const CR1_URS: u32 = 1 << 2;
pub(super) const CR1_OPM: u32 = 1 << 3;
pub(super) const CR1_ARPE: u32 = 1 << 7;
pub(super) const DIER_UDE: u32 = 1 << 8;
/// Interrupts and requests of the channels.
const DIER_CHANNELS: u32 = 0x1E << 8 | 0x1E;

/// A register whose written value counts from the next update.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Preloaded {
    /// As written.
    pub(super) written: u32,
    /// As it counts.
    pub(super) active: u32,
}

/// What the manual does not say of requests for DMA; firmware must work either way.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Requests {
    /// One that nobody has served outlives its enable bit.
    pub(super) sticky: bool,
    /// Enabling those of the update makes one at once where the update's flag stands.
    pub(super) standing: bool,
}

/// One timer.
#[derive(Clone, Debug)]
pub(crate) struct Timer {
    /// Channels: 0 for a basic timer, else 1, 2 or 4.
    pub(super) channels: usize,
    /// 32 bits wide (TIM2 and TIM5).
    pub(super) wide: bool,
    /// Outputs need BDTR.MOE (TIM1 and TIM8).
    pub(super) advanced: bool,
    pub(super) cr1: u32,
    pub(super) cr2: u32,
    pub(super) smcr: u32,
    pub(super) dier: u32,
    pub(super) sr: u32,
    pub(super) ccmr: [u32; 2],
    pub(super) ccer: u32,
    pub(super) bdtr: u32,
    pub(super) dcr: u32,
    pub(super) other: u32,
    pub(super) rcr: u32,
    pub(super) psc: Preloaded,
    pub(super) arr: Preloaded,
    pub(super) ccr: [Preloaded; 4],
    /// HCLK cycles per cycle of the timer's clock.
    pub(super) divider: u32,
    /// When the count was `origin_count` and the prescaler zero; while stopped, what is left of the prescaler.
    pub(super) origin: Cycle,
    pub(super) origin_count: u32,
    phase: u64,
    /// Highest count of this period that compare matches have been looked for at; -1 for none.
    pub(super) checked: i64,
    /// When the present output period began.
    pub(super) period_start: Cycle,
    /// Requests of the update left to serve: a burst asks more than once.
    pub(super) burst_left: u32,
    /// Place of the next access through DMAR.
    pub(super) burst_index: u32,
    /// What the manual does not say of requests.
    pub(super) requests: Requests,
    /// Requests of the channels left to serve, as bits.
    pub(super) channel_requests: u8,
}

/// What [`Timer::step`] came across.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Step {
    /// The flags are up to date.
    Current,
    /// An output period ended.
    Period(Period),
}

impl Timer {
    pub(crate) fn new(index: usize) -> Self {
        let channels = match index {
            0..=4 | 7 => 4,
            5 | 6 => 0,
            8 | 11 => 2,
            _ => 1,
        };
        let wide = matches!(index, 1 | 4);
        let full = if wide { u32::MAX } else { 0xFFFF };
        Self {
            channels,
            wide,
            advanced: matches!(index, 0 | 7),
            cr1: 0,
            cr2: 0,
            smcr: 0,
            dier: 0,
            sr: 0,
            ccmr: [0; 2],
            ccer: 0,
            bdtr: 0,
            dcr: 0,
            other: 0,
            rcr: 0,
            psc: Preloaded::default(),
            arr: Preloaded { written: full, active: full },
            ccr: [Preloaded::default(); 4],
            divider: 1,
            origin: 0,
            origin_count: 0,
            phase: 0,
            checked: -1,
            period_start: 0,
            burst_left: 0,
            burst_index: 0,
            channel_requests: 0,
            requests: Requests::default(),
        }
    }

    pub(crate) fn running(&self) -> bool {
        self.cr1 & CR1_CEN != 0
    }

    /// Largest count.
    pub(super) fn full(&self) -> u32 {
        if self.wide { u32::MAX } else { 0xFFFF }
    }

    /// HCLK cycles per count.
    pub(super) fn tick(&self) -> u64 {
        u64::from(self.divider) * (u64::from(self.psc.active) + 1)
    }

    /// The count at `now`, which lies in the present period.
    pub(super) fn count(&self, now: Cycle) -> u32 {
        if !self.running() {
            return self.origin_count;
        }
        let counted = now.saturating_sub(self.origin) / self.tick();
        (u64::from(self.origin_count) + counted).min(u64::from(self.full())) as u32
    }

    /// The last count of the present period: the limit, or, once beyond it, the largest count.
    fn top(&self) -> u32 {
        if self.origin_count > self.arr.active { self.full() } else { self.arr.active }
    }

    fn period_end(&self) -> Cycle {
        self.time_of(u64::from(self.top()) + 1)
    }

    /// When the count reaches `count`, not less than that at the origin.
    fn time_of(&self, count: u64) -> Cycle {
        let ticks = count.saturating_sub(u64::from(self.origin_count));
        self.origin.saturating_add(ticks.saturating_mul(self.tick()))
    }

    /// Lets at most one output period end, and sets the flags of whatever has happened up to `now`. Call until it
    /// answers [`Step::Current`].
    pub(crate) fn step(&mut self, now: Cycle) -> Step {
        // A limit of zero stops the counter (RM0090 section 18.4.12).
        if !self.running() || self.arr.active == 0 {
            return Step::Current;
        }
        let end = self.period_end();
        if end > now {
            self.match_up_to(i64::from(self.count(now)));
            return Step::Current;
        }
        let top = self.top();
        let overflow = top == self.arr.active;
        self.match_up_to(i64::from(top));
        for channel in 0..self.channels {
            if overflow && self.ccr[channel].active > top {
                self.matched(channel);
            }
        }
        let period =
            Period { start: self.period_start, end, cut: false, high: self.highs(self.period_start, end) };
        (self.origin, self.origin_count, self.checked, self.period_start) = (end, 0, -1, end);
        if overflow {
            self.update(true);
        }
        if self.cr1 & CR1_OPM != 0 && overflow {
            self.phase = 0;
            self.cr1 &= !CR1_CEN;
        }
        self.match_up_to(0);
        if self.quiet() && self.running() {
            // Nobody looks at the periods that follow: pass over all of them at once.
            let length = self.tick() * (u64::from(self.arr.active) + 1);
            let whole = now.saturating_sub(self.origin) / length;
            if whole > 0 {
                self.match_up_to(i64::from(self.arr.active));
                self.origin += whole * length;
                self.period_start = self.origin;
                self.checked = -1;
                if self.cr1 & CR1_UDIS == 0 {
                    self.sr |= 1;
                }
            }
        }
        Step::Period(period)
    }

    /// When something happens that cannot wait until somebody looks. `watched` says that an output goes to a pin.
    pub(crate) fn next_due(&self, watched: bool) -> Cycle {
        if !self.running() || self.arr.active == 0 {
            return NEVER;
        }
        let mut due = NEVER;
        let update_waited_for = self.dier & 1 != 0 && self.sr & 1 == 0
            || self.dier & DIER_UDE != 0 && self.burst_left == 0
            || self.cr1 & CR1_OPM != 0;
        if update_waited_for || watched && self.emits() {
            due = self.period_end();
        }
        if self.dier & DIER_CHANNELS == 0 {
            return due;
        }
        for channel in 0..self.channels {
            let interrupt = self.dier >> (channel + 1) & 1 != 0 && self.sr >> (channel + 1) & 1 == 0;
            let request = self.dier >> (channel + 9) & 1 != 0 && self.channel_requests >> channel & 1 == 0;
            if interrupt || request {
                due = due.min(self.next_match(channel));
            }
        }
        due
    }

    /// An update event; `counted` is false for one that software asked for.
    pub(super) fn update(&mut self, counted: bool) {
        if self.cr1 & CR1_UDIS != 0 {
            return;
        }
        self.psc.active = self.psc.written;
        self.arr.active = self.arr.written;
        for ccr in &mut self.ccr {
            ccr.active = ccr.written;
        }
        if counted || self.cr1 & CR1_URS == 0 {
            self.sr |= 1;
            if self.dier & DIER_UDE != 0 {
                self.ask();
            }
        }
    }

    /// The update asks for DMA, once or for a burst.
    pub(super) fn ask(&mut self) {
        self.burst_left = (self.dcr >> 8 & 0x1F) + 1;
        self.burst_index = 0;
    }

    /// Starts and stops counting.
    pub(super) fn set_running(&mut self, now: Cycle, run: bool) {
        if run == self.running() {
            return;
        }
        if run {
            self.origin = now.saturating_sub(self.phase);
            self.period_start = now;
            self.cr1 |= CR1_CEN;
        } else {
            self.hold(now);
            self.phase = now.saturating_sub(self.origin);
            self.cr1 &= !CR1_CEN;
        }
    }

    /// Moves the origin to the present count, so that what follows may run at another rate.
    pub(super) fn hold(&mut self, now: Cycle) {
        if !self.running() {
            return;
        }
        let tick = self.tick();
        let count = self.count(now);
        let passed = now.saturating_sub(self.origin);
        self.origin = now - passed % tick;
        self.origin_count = count;
    }

    /// Sets the count, with the prescaler at zero if `restart`.
    pub(super) fn set_count(&mut self, now: Cycle, count: u32, restart: bool) {
        self.hold(now);
        if restart {
            (self.origin, self.phase, self.period_start) = (now, 0, now);
        }
        self.origin_count = count & self.full();
        self.checked = i64::from(self.origin_count) - i64::from(restart);
    }

    /// The chip's clocks change.
    pub(crate) fn set_divider(&mut self, now: Cycle, divider: u32) {
        if divider != self.divider {
            self.hold(now);
            self.origin = now;
            self.divider = divider;
        }
    }

    /// Whether periods may pass with nobody told.
    fn quiet(&self) -> bool {
        !self.emits()
            && (self.dier & DIER_UDE == 0 || self.burst_left > 0)
            && self.dier >> 9 & 0xF & !u32::from(self.channel_requests) == 0
            && self.cr1 & CR1_OPM == 0
    }

    /// Sets the flags of channels whose value lies beyond what was looked at and not beyond `count`.
    fn match_up_to(&mut self, count: i64) {
        if count <= self.checked {
            return;
        }
        for channel in 0..self.channels {
            let value = i64::from(self.ccr[channel].active);
            if value > self.checked && value <= count {
                self.matched(channel);
            }
        }
        self.checked = count;
    }

    /// A compare match. Capture is not emulated: such a channel never matches.
    pub(super) fn matched(&mut self, channel: usize) {
        if self.mode_bits(channel) & 3 == 0 {
            self.sr |= 1 << (channel + 1);
            self.channel_requests |= ((self.dier >> (channel + 9) & 1) as u8) << channel;
        }
    }

    fn next_match(&self, channel: usize) -> Cycle {
        if self.mode_bits(channel) & 3 != 0 {
            return NEVER;
        }
        let value = self.ccr[channel].active;
        if value > self.arr.active {
            // Then the overflow sets the flag.
            return self.period_end();
        }
        if i64::from(value) > self.checked && value >= self.origin_count {
            return self.time_of(u64::from(value));
        }
        self.period_end().saturating_add(u64::from(value) * self.tick())
    }
}

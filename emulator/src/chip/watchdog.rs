//! The two watchdogs (RM0090 sections 21 and 22).

use crate::bus::{Cycle, NEVER};

/// The independent watchdog: it counts on its own oscillator and nothing but a reset stops it.
#[derive(Clone, Debug)]
pub(crate) struct Iwdg {
    /// Frequency of its oscillator (Hz); 32 kHz nominal, 17 to 47 kHz by the data sheet.
    pub(crate) lsi_hz: u32,
    prescaler: u32,
    reload: u32,
    open: bool,
    started: bool,
    /// Register values on their way into the counter's clock domain, and when they arrive (ns).
    pending: Option<(u32, u32, u64)>,
    /// When the counter reaches zero (ns).
    due_ns: u64,
    last_reload: (u64, u32),
}

/// Cycles that a new prescaler or reload value takes to arrive: of the oscillator by the words of RM0090 section 21.4.4, behind the
/// divider by what drivers allow for. The longer counts here.
const SYNCHRONISE: u64 = 5;

impl Iwdg {
    pub(crate) fn new(lsi_hz: u32) -> Self {
        Self {
            lsi_hz,
            prescaler: 0,
            reload: 0xFFF,
            open: false,
            started: false,
            pending: None,
            due_ns: u64::MAX,
            last_reload: (0, 0),
        }
    }

    /// When the watchdog bites unless it is petted (ns).
    pub(crate) fn due_ns(&self) -> u64 {
        self.due_ns
    }

    pub(crate) fn read(&mut self, offset: u32, ns: u64) -> u32 {
        self.settle(ns);
        let pending = self.pending.is_some();
        match offset {
            0x04 => self.pending.map_or(self.prescaler, |(prescaler, ..)| prescaler),
            0x08 => self.pending.map_or(self.reload, |(_, reload, _)| reload),
            0x0C => {
                let changed =
                    |new: fn(&(u32, u32, u64)) -> u32, old| self.pending.as_ref().map_or(old, new) != old;
                u32::from(pending && changed(|p| p.0, self.prescaler))
                    | u32::from(pending && changed(|p| p.1, self.reload)) << 1
            }
            _ => 0,
        }
    }

    /// The answer is a mistake.
    pub(crate) fn write(&mut self, offset: u32, value: u32, ns: u64) -> Option<&'static str> {
        self.settle(ns);
        match offset {
            0x00 => {
                self.open = value & 0xFFFF == 0x5555;
                match value & 0xFFFF {
                    0xAAAA if self.started => self.restart(ns, self.reload),
                    0xCCCC if !self.started => {
                        self.started = true;
                        self.restart(ns, 0xFFF);
                    }
                    _ => {}
                }
            }
            0x04 | 0x08 if !self.open => {
                return Some("IWDG_PR or IWDG_RLR is written without 0x5555 in IWDG_KR");
            }
            0x04 | 0x08 => {
                let (prescaler, reload, _) = self.pending.unwrap_or((self.prescaler, self.reload, 0));
                let cycles = SYNCHRONISE * (4 << self.prescaler.min(6));
                let arrives = ns + cycles * 1_000_000_000 / u64::from(self.lsi_hz.max(1));
                self.pending = Some(if offset == 4 {
                    (value & 7, reload, arrives)
                } else {
                    (prescaler, value & 0xFFF, arrives)
                });
            }
            _ => {}
        }
        None
    }

    /// Takes over values that have arrived.
    fn settle(&mut self, ns: u64) {
        if let Some((prescaler, reload, arrives)) = self.pending
            && ns >= arrives
        {
            self.pending = None;
            self.reload = reload;
            if prescaler != self.prescaler {
                // What is left of the count goes on at the new rate.
                let (since, count) = self.last_reload;
                let counted = (arrives.saturating_sub(since) / self.count_ns().max(1)) as u32;
                self.prescaler = prescaler;
                if self.started {
                    self.restart(arrives, count.saturating_sub(counted));
                }
            }
        }
    }

    fn count_ns(&self) -> u64 {
        (4 << self.prescaler.min(6)) * 1_000_000_000 / u64::from(self.lsi_hz.max(1))
    }

    fn restart(&mut self, ns: u64, count: u32) {
        self.last_reload = (ns, count);
        let cycles = (u64::from(count) + 1) * (4 << self.prescaler.min(6));
        self.due_ns = ns + cycles * 1_000_000_000 / u64::from(self.lsi_hz.max(1));
    }
}

/// The window watchdog: a seven-bit counter on PCLK1 / 4096.
#[derive(Clone, Debug)]
pub(crate) struct Wwdg {
    started: bool,
    cfr: u32,
    early: bool,
    count: u32,
    since: Cycle,
}

impl Wwdg {
    pub(crate) fn new() -> Self {
        Self { started: false, cfr: 0x7F, early: false, count: 0x7F, since: 0 }
    }

    fn tick(&self, divider: u32) -> u64 {
        u64::from(divider) * (4096 << (self.cfr >> 7 & 3))
    }

    fn count(&self, now: Cycle, divider: u32) -> u32 {
        if !self.started {
            return self.count;
        }
        let counted = now.saturating_sub(self.since) / self.tick(divider);
        u64::from(self.count).saturating_sub(counted) as u32
    }

    /// When it wakes software (count 0x40) or, after that, bites.
    pub(crate) fn due(&self, divider: u32) -> Cycle {
        if !self.started {
            return NEVER;
        }
        let last = if self.early { 0x3F } else { 0x40 };
        self.since + u64::from(self.count.saturating_sub(last)) * self.tick(divider)
    }

    /// The level of the interrupt line.
    pub(crate) fn interrupt(&self) -> bool {
        self.early && self.cfr >> 9 & 1 == 1
    }

    /// The time of [`Self::due`] has come. Answers whether the chip resets.
    pub(crate) fn fire(&mut self, now: Cycle, divider: u32) -> bool {
        self.early = true;
        self.count(now, divider) < 0x40
    }

    pub(crate) fn read(&self, offset: u32, now: Cycle, divider: u32) -> u32 {
        match offset {
            0x00 => self.count(now, divider) | u32::from(self.started) << 7,
            0x04 => self.cfr,
            0x08 => u32::from(self.early),
            _ => 0,
        }
    }

    /// Answers whether the chip resets.
    pub(crate) fn write(&mut self, offset: u32, value: u32, now: Cycle, divider: u32) -> bool {
        match offset {
            0x00 => {
                let too_early = self.started && self.count(now, divider) > self.cfr & 0x7F;
                self.started |= value >> 7 & 1 == 1;
                (self.count, self.since) = (value & 0x7F, now);
                return self.started && (too_early || value & 0x40 == 0);
            }
            0x04 => self.cfr = value & 0x3FF,
            0x08 => self.early &= value & 1 == 1,
            _ => {}
        }
        false
    }
}

//! Reset and clock control (RM0090 section 7).

use super::clock::{HSI_HZ, Rates};
use crate::bus::{Cycle, NEVER};

/// Start-up times (ns) (DS8626, oscillator and PLL characteristics; typical, the PLL's the longest).
const HSI_START_NS: u64 = 2_200;
const HSE_START_NS: u64 = 2_000_000;
const PLL_LOCK_NS: u64 = 200_000;
const LSI_START_NS: u64 = 15_000;
const LSE_START_NS: u64 = 2_000_000_000;

const CSR_RMVF: u32 = 1 << 24;
/// Reset by the pin, which every reset inside the chip pulls low.
pub(crate) const CSR_PINRSTF: u32 = 1 << 26;
/// Power-on and brown-out reset.
pub(crate) const CSR_POWER_UP: u32 = CSR_PINRSTF | 1 << 25 | 1 << 27;
/// Reset asked for by the core.
pub(crate) const CSR_SFTRSTF: u32 = 1 << 28;
/// Reset by the independent watchdog.
pub(crate) const CSR_IWDGRSTF: u32 = 1 << 29;
/// Reset by the window watchdog.
pub(crate) const CSR_WWDGRSTF: u32 = 1 << 30;

const CR_HSION: u32 = 1;
const CR_HSEON: u32 = 1 << 16;
const CR_CSSON: u32 = 1 << 19;
const CR_PLLON: u32 = 1 << 24;
const CR_PLLI2SON: u32 = 1 << 26;
const CIR_CSSF: u32 = 1 << 7;

/// An oscillator: on or off, and since when it is stable.
#[derive(Clone, Copy, Debug, Default)]
struct Oscillator {
    on: bool,
    ready_at: Cycle,
}

impl Oscillator {
    fn switch(&mut self, on: bool, ready_at: Cycle) {
        if on && !self.on {
            self.ready_at = ready_at;
        }
        self.on = on;
    }

    fn ready(&self, now: Cycle) -> bool {
        self.on && now >= self.ready_at
    }
}

/// The registers.
#[derive(Clone, Debug)]
pub(crate) struct Rcc {
    /// AHB1, AHB2, AHB3, APB1, APB2.
    pub(crate) reset: [u32; 5],
    /// The same order.
    pub(crate) enable: [u32; 5],
    low_power_enable: [u32; 5],
    hsi: Oscillator,
    hse: Oscillator,
    pll: Oscillator,
    plli2s: Oscillator,
    lsi: Oscillator,
    lse: Oscillator,
    trim: u32,
    bypass: bool,
    css: bool,
    css_flag: bool,
    /// The crystal has stopped.
    hse_dead: bool,
    /// The PLL locks no more.
    pub(crate) pll_dead: bool,
    pllcfgr: u32,
    cfgr: u32,
    interrupts: u32,
    bdcr: u32,
    flags: u32,
    sscgr: u32,
    plli2scfgr: u32,
}

/// What the chip must do after a write.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Done {
    /// Clocks may have changed.
    pub(crate) clocks: bool,
    /// Reset bits newly set, by register.
    pub(crate) resets: Option<(usize, u32)>,
    /// The backup domain is reset.
    pub(crate) backup: bool,
    /// A mistake.
    pub(crate) bug: Option<&'static str>,
}

impl Rcc {
    /// As at power-up.
    pub(crate) fn new() -> Self {
        Self {
            reset: [0; 5],
            enable: [0x0010_0000, 0, 0, 0, 0],
            low_power_enable: [0x7E67_91FF, 0xF1, 1, 0x36FE_C9FF, 0x0007_5F33],
            hsi: Oscillator { on: true, ready_at: 0 },
            hse: Oscillator::default(),
            pll: Oscillator::default(),
            plli2s: Oscillator::default(),
            lsi: Oscillator::default(),
            lse: Oscillator::default(),
            trim: 0x80,
            bypass: false,
            css: false,
            css_flag: false,
            hse_dead: false,
            pll_dead: false,
            pllcfgr: 0x2400_3010,
            cfgr: 0,
            interrupts: 0,
            bdcr: 0,
            flags: CSR_POWER_UP,
            sscgr: 0,
            plli2scfgr: 0x2000_3000,
        }
    }

    /// A system reset for the reason `cause` (bits of CSR): the backup domain and the causes stay.
    pub(crate) fn system_reset(&mut self, cause: u32) {
        let kept = (self.bdcr, self.lse, self.flags, self.hse_dead, self.pll_dead);
        *self = Self::new();
        (self.bdcr, self.lse, self.flags, self.hse_dead, self.pll_dead) = kept;
        self.flags |= cause | CSR_PINRSTF;
    }

    /// Whether the clock of a gate is on.
    pub(crate) fn enabled(&self, (register, bit): (usize, u8)) -> bool {
        self.enable[register] >> bit & 1 == 1
    }

    /// The level of the interrupt line.
    pub(crate) fn interrupt(&self) -> bool {
        self.interrupts >> 8 & self.interrupts & 0x3F != 0
    }

    /// The clock monitor has seen the crystal stop and the flag is not cleared yet: the non-maskable interrupt.
    pub(crate) fn nmi(&self) -> bool {
        self.css_flag
    }

    pub(crate) fn read(&self, offset: u32, now: Cycle) -> u32 {
        let flag = |on: bool, bit: u32| u32::from(on) << bit;
        match offset {
            0x00 => {
                flag(self.hsi.on, 0)
                    | flag(self.hsi.ready(now), 1)
                    | self.trim
                    | flag(self.hse.on, 16)
                    | flag(self.hse_ready(now), 17)
                    | flag(self.bypass, 18)
                    | flag(self.css, 19)
                    | flag(self.pll.on, 24)
                    | flag(self.pll.ready(now), 25)
                    | flag(self.plli2s.on, 26)
                    | flag(self.plli2s.ready(now), 27)
            }
            0x04 => self.pllcfgr,
            0x08 => self.cfgr,
            0x0C => self.interrupts | flag(self.css_flag, 7),
            0x10 | 0x14 | 0x18 | 0x20 | 0x24 => self.reset[Self::group(offset - 0x10)],
            0x30 | 0x34 | 0x38 | 0x40 | 0x44 => self.enable[Self::group(offset - 0x30)],
            0x50 | 0x54 | 0x58 | 0x60 | 0x64 => self.low_power_enable[Self::group(offset - 0x50)],
            0x70 => self.bdcr | flag(self.lse.on, 0) | flag(self.lse.ready(now), 1),
            0x74 => flag(self.lsi.on, 0) | flag(self.lsi.ready(now), 1) | self.flags,
            0x80 => self.sscgr,
            0x84 => self.plli2scfgr,
            _ => 0,
        }
    }

    /// `after(ns)` is the cycle `ns` from now; `backup_open` is PWR_CR.DBP.
    pub(crate) fn write(
        &mut self,
        offset: u32,
        value: u32,
        now: Cycle,
        after: impl Fn(u64) -> Cycle,
        backup_open: bool,
    ) -> Done {
        let mut done = Done::default();
        match offset {
            0x00 => self.write_cr(value, now, after, &mut done),
            0x04 => {
                if self.pll.on && (value ^ self.pllcfgr) & 0x0F43_7FFF != 0 {
                    done.bug = Some("RCC_PLLCFGR is written while the PLL is on");
                } else {
                    self.pllcfgr = value;
                }
            }
            0x08 => {
                let source = value & 3;
                let ready = match source {
                    0 => self.hsi.ready(now),
                    1 => self.hse_ready(now),
                    2 => self.pll.ready(now),
                    _ => false,
                };
                let status = if ready { source } else { self.cfgr >> 2 & 3 };
                if !ready {
                    done.bug = Some("RCC_CFGR.SW selects a clock that is not ready");
                }
                self.cfgr = value & !0x0000_030C | status << 2;
                done.clocks = true;
            }
            0x0C => {
                // Bits 16..=23 clear the flags in 0..=7; 8..=13 enable.
                self.interrupts = self.interrupts & 0x3F & !(value >> 16) | value & 0x3F00;
                if value >> 16 & CIR_CSSF != 0 && !self.hse_dead {
                    self.css_flag = false;
                }
                if value >> 23 & 1 == 1 {
                    self.css_flag = false;
                }
            }
            0x10 | 0x14 | 0x18 | 0x20 | 0x24 => {
                let group = Self::group(offset - 0x10);
                done.resets = Some((group, value & !self.reset[group]));
                self.reset[group] = value;
            }
            0x30 | 0x34 | 0x38 | 0x40 | 0x44 => self.enable[Self::group(offset - 0x30)] = value,
            0x50 | 0x54 | 0x58 | 0x60 | 0x64 => self.low_power_enable[Self::group(offset - 0x50)] = value,
            0x70 if !backup_open => done.bug = Some("RCC_BDCR is written while PWR_CR.DBP protects it"),
            0x70 => self.write_bdcr(value, after, &mut done),
            0x74 => {
                self.lsi.switch(value & 1 == 1, after(LSI_START_NS));
                if value & CSR_RMVF != 0 {
                    self.flags = 0;
                }
            }
            0x80 => self.sscgr = value,
            0x84 => self.plli2scfgr = value,
            _ => {}
        }
        done
    }

    /// The crystal stops (`true`) or would run again.
    pub(crate) fn fail_crystal(&mut self, dead: bool) -> Done {
        self.hse_dead = dead;
        let mut done = Done::default();
        if !dead || !self.hse.on {
            return done;
        }
        let used = self.cfgr >> 2 & 3 == 1 || self.cfgr >> 2 & 3 == 2 && self.pll_from_crystal();
        if self.css {
            // RM0090 section 7.2.7: the crystal is switched off, and the PLL if it fed it.
            self.css_flag = true;
            self.hse.on = false;
            if self.pll_from_crystal() {
                self.pll.on = false;
            }
        } else if used {
            done.bug = Some("the crystal stopped while it clocked the chip and RCC_CR.CSSON was off");
        }
        if used {
            self.hsi.on = true;
            self.cfgr &= !0xF;
            done.clocks = true;
        }
        done
    }

    /// Rates that follow from the registers; `crystal_hz` is what the board carries.
    pub(crate) fn rates(&self, crystal_hz: u32) -> Rates {
        let sysclk = match self.cfgr >> 2 & 3 {
            1 => u64::from(crystal_hz),
            2 => {
                let source = if self.pll_from_crystal() { crystal_hz } else { HSI_HZ };
                let m = u64::from(self.pllcfgr & 0x3F).max(1);
                let n = u64::from(self.pllcfgr >> 6 & 0x1FF);
                let p = 2 * (u64::from(self.pllcfgr >> 16 & 3) + 1);
                u64::from(source) * n / (m * p)
            }
            _ => u64::from(HSI_HZ),
        };
        // At least a kilohertz, so that a nonsensical setting does not stop time.
        let sysclk_hz = u32::try_from(sysclk).unwrap_or(u32::MAX).max(512_000);
        let ahb_shift = match self.cfgr >> 4 & 0xF {
            n @ 8..=11 => n - 7,
            n @ 12..=15 => n - 6,
            _ => 0,
        };
        let apb = |bits: u32| if bits & 4 == 0 { 1 } else { 2 << (bits & 3) };
        Rates {
            sysclk_hz,
            hclk_hz: sysclk_hz >> ahb_shift,
            apb1_divider: apb(self.cfgr >> 10 & 7),
            apb2_divider: apb(self.cfgr >> 13 & 7),
        }
    }

    fn pll_from_crystal(&self) -> bool {
        self.pllcfgr >> 22 & 1 == 1
    }

    fn hse_ready(&self, now: Cycle) -> bool {
        self.hse.ready(now) && !self.hse_dead
    }

    fn write_cr(&mut self, value: u32, now: Cycle, after: impl Fn(u64) -> Cycle, done: &mut Done) {
        let status = self.cfgr >> 2 & 3;
        let pll_source_on = if self.pll_from_crystal() { self.hse_ready(now) } else { self.hsi.ready(now) };
        // What clocks the chip cannot be switched off.
        self.hsi.switch(value & CR_HSION != 0 || status == 0, after(HSI_START_NS));
        let crystal_used = status == 1 || status == 2 && self.pll_from_crystal();
        self.hse.switch(value & CR_HSEON != 0 || crystal_used, after(HSE_START_NS));
        if value & CR_PLLON != 0 && !self.pll.on && !pll_source_on {
            done.bug = Some("the PLL is switched on before its source is ready");
        }
        let locked_at = if self.pll_dead { NEVER } else { after(PLL_LOCK_NS) };
        self.pll.switch(value & CR_PLLON != 0 || status == 2, locked_at);
        self.plli2s.switch(value & CR_PLLI2SON != 0, after(PLL_LOCK_NS));
        self.trim = value & 0xF8;
        self.bypass = value >> 18 & 1 == 1;
        self.css = value & CR_CSSON != 0;
    }

    fn write_bdcr(&mut self, value: u32, after: impl Fn(u64) -> Cycle, done: &mut Done) {
        if value >> 16 & 1 == 1 {
            self.lse.on = false;
            self.bdcr = 1 << 16;
            done.backup = true;
            return;
        }
        self.lse.switch(value & 1 == 1, after(LSE_START_NS));
        // RTCSEL is set once; only a reset of the domain lets it change.
        let select = if self.bdcr >> 8 & 3 == 0 { value & 0x300 } else { self.bdcr & 0x300 };
        self.bdcr = value & 0x8004 | select;
    }

    /// Index of a register within its group of AHB1, AHB2, AHB3, (gap), APB1, APB2.
    fn group(offset: u32) -> usize {
        match offset {
            0x0 => 0,
            0x4 => 1,
            0x8 => 2,
            0x10 => 3,
            _ => 4,
        }
    }
}

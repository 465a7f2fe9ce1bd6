//! External interrupts (RM0090 section 12) and the choice of their pins in SYSCFG (section 9).

use super::pin::Pin;

/// Lines 0 to 22: pins, then PVD, RTC and USB.
const LINES: u32 = 0x007F_FFFF;

/// Registers of EXTI and of SYSCFG.
#[derive(Clone, Debug, Default)]
pub(crate) struct Exti {
    imr: u32,
    emr: u32,
    rtsr: u32,
    ftsr: u32,
    pr: u32,
    swier: u32,
    /// An event for the core, until it is told.
    event: bool,
    exticr: [u32; 4],
    memrmp: u32,
    syscfg_other: u32,
}

impl Exti {
    /// SYSCFG to its reset values.
    pub(crate) fn reset_syscfg(&mut self) {
        (self.exticr, self.memrmp, self.syscfg_other) = ([0; 4], 0, 0);
    }

    /// Whether the line of `pin` listens to it.
    pub(crate) fn listens(&self, pin: Pin) -> bool {
        self.port_of(pin.number()) == pin.port()
    }

    /// An edge on a line. It stays pending even while the line is masked: the mask comes after the pending register
    /// (RM0090 figure 42).
    pub(crate) fn edge(&mut self, line: usize, rising: bool) {
        let trigger = if rising { self.rtsr } else { self.ftsr };
        self.pr |= trigger & 1 << line;
        // An event passes by the pending register (RM0090 section 12.2.3).
        self.event |= trigger & self.emr & 1 << line != 0;
    }

    /// An event for the core came since last asked.
    pub(crate) fn take_event(&mut self) -> bool {
        std::mem::take(&mut self.event)
    }

    /// Levels of the interrupt lines, as bits of the IRQ numbers: EXTI0..4 are 6..10, EXTI9_5 is 23, EXTI15_10 is 40,
    /// PVD is 1, RTC wake-up 3, RTC alarm 41.
    pub(crate) fn lines(&self) -> u128 {
        let active = u128::from(self.pr & self.imr);
        let any = |mask: u128, irq: u8| u128::from(active & mask != 0) << irq;
        (active & 0x1F) << 6
            | any(0x3E0, 23)
            | any(0xFC00, 40)
            | any(1 << 16, 1)
            | any(1 << 17, 41)
            | any(1 << 18, 42)
            | any(1 << 22, 3)
    }

    /// All the interrupt lines that [`Self::lines`] may set.
    pub(crate) const IRQS: u128 = 0x1F << 6 | 1 << 23 | 1 << 40 | 1 << 1 | 1 << 41 | 1 << 42 | 1 << 3;

    pub(crate) fn read(&self, offset: u32) -> u32 {
        match offset {
            0x00 => self.imr,
            0x04 => self.emr,
            0x08 => self.rtsr,
            0x0C => self.ftsr,
            0x10 => self.swier,
            0x14 => self.pr,
            _ => 0,
        }
    }

    pub(crate) fn write(&mut self, offset: u32, value: u32) {
        let value = value & LINES;
        match offset {
            0x00 => self.imr = value,
            0x04 => self.emr = value,
            0x08 => self.rtsr = value,
            0x0C => self.ftsr = value,
            0x10 => {
                self.pr |= value & !self.swier & self.imr;
                self.event |= value & !self.swier & self.emr != 0;
                self.swier |= value;
            }
            0x14 => {
                self.pr &= !value;
                self.swier &= !value;
            }
            _ => {}
        }
    }

    pub(crate) fn read_syscfg(&self, offset: u32) -> u32 {
        match offset {
            0x00 => self.memrmp,
            0x08..=0x14 => self.exticr[(offset as usize - 8) / 4],
            // The compensation cell is ready once it is on.
            0x20 => self.syscfg_other & 1 | (self.syscfg_other & 1) << 8,
            _ => 0,
        }
    }

    pub(crate) fn write_syscfg(&mut self, offset: u32, value: u32) {
        match offset {
            0x00 => self.memrmp = value & 3,
            0x08..=0x14 => self.exticr[(offset as usize - 8) / 4] = value & 0xFFFF,
            0x20 => self.syscfg_other = value,
            _ => {}
        }
    }

    fn port_of(&self, line: usize) -> usize {
        (self.exticr[(line / 4) & 3] >> (4 * (line % 4)) & 15) as usize
    }
}

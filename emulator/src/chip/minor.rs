//! Peripherals that are little more than memory: PWR, RTC and its backup registers, CRC, DBGMCU.

use super::rng::Rng;

/// Device identity: STM32F405 (0x413), the latest revision (0x100F).
const IDCODE: u32 = 0x100F_6413;

/// Their registers.
#[derive(Clone, Debug)]
pub(crate) struct Minor {
    pwr_cr: u32,
    pwr_csr: u32,
    rtc: [u32; 40],
    crc: u32,
    crc_spare: u8,
    rng: Rng,
    /// Supply of the chip (V).
    supply_v: f64,
    /// Output of the voltage detector.
    pvdo: bool,
    debug: [u32; 3],
    backup_sram: Box<[u8]>,
}

impl Minor {
    pub(crate) fn new() -> Self {
        Self {
            pwr_cr: 0x4000,
            pwr_csr: 0,
            rtc: reset_rtc(),
            crc: u32::MAX,
            crc_spare: 0,
            rng: Rng::new(),
            supply_v: 3.3,
            pvdo: false,
            debug: [0; 3],
            backup_sram: vec![0; 4096].into(),
        }
    }

    /// A system reset: the backup domain and the debug registers stay.
    pub(crate) fn reset(&mut self) {
        self.reset_pwr();
        self.reset_crc();
        self.reset_rng();
    }

    /// The backup domain to its reset values.
    pub(crate) fn reset_backup(&mut self) {
        self.rtc = reset_rtc();
    }

    pub(crate) fn reset_pwr(&mut self) {
        (self.pwr_cr, self.pwr_csr) = (0x4000, self.pwr_csr & 0x200);
        self.pvdo = false;
    }

    pub(crate) fn reset_crc(&mut self) {
        (self.crc, self.crc_spare) = (u32::MAX, 0);
    }

    pub(crate) fn reset_rng(&mut self) {
        self.rng.reset();
    }

    /// PWR_CR.DBP: the backup domain may be written.
    pub(crate) fn backup_open(&self) -> bool {
        self.pwr_cr >> 8 & 1 == 1
    }

    pub(crate) fn read_pwr(&self, offset: u32) -> u32 {
        match offset {
            0x00 => self.pwr_cr,
            // The regulators are always ready: VOSRDY, and BRR once BRE is on.
            // PVDO is bit 2.
            0x04 => self.pwr_csr | 1 << 14 | (self.pwr_csr >> 9 & 1) << 3 | u32::from(self.pvdo) << 2,
            _ => 0,
        }
    }

    /// Answers whether the voltage detector's output changed, and to what.
    pub(crate) fn write_pwr(&mut self, offset: u32, value: u32) -> Option<bool> {
        match offset {
            0x00 => self.pwr_cr = value & 0x43F3,
            0x04 => self.pwr_csr = value & 0x300,
            _ => {}
        }
        self.detect()
    }

    pub(crate) fn read_rtc(&self, offset: u32) -> u32 {
        let value = self.rtc.get(offset as usize / 4).copied().unwrap_or(0);
        if offset == 0x0C {
            // RSF is always up; INITF follows INIT, and the write flags are ready.
            return value | 1 << 5 | (value >> 7 & 1) << 6 | 7;
        }
        value
    }

    pub(crate) fn write_rtc(&mut self, offset: u32, value: u32) {
        if self.backup_open()
            && let Some(register) = self.rtc.get_mut(offset as usize / 4)
        {
            *register = value;
        }
    }

    pub(crate) fn read_crc(&self, offset: u32) -> u32 {
        match offset {
            0x00 => self.crc,
            0x04 => u32::from(self.crc_spare),
            _ => 0,
        }
    }

    pub(crate) fn write_crc(&mut self, offset: u32, value: u32) {
        match offset {
            0x00 => {
                // CRC-32 with the Ethernet polynomial, a word at a time, most significant bit first.
                self.crc ^= value;
                for _ in 0..32 {
                    self.crc = self.crc << 1 ^ if self.crc >> 31 == 1 { 0x04C1_1DB7 } else { 0 };
                }
            }
            0x04 => self.crc_spare = value as u8,
            0x08 if value & 1 == 1 => self.crc = u32::MAX,
            _ => {}
        }
    }

    /// The random number generator.
    pub(crate) fn rng(&mut self) -> &mut Rng {
        &mut self.rng
    }

    /// Supply of the chip (V). Answers whether the detector's output changed, and to what.
    pub(crate) fn set_supply_v(&mut self, volts: f64) -> Option<bool> {
        self.supply_v = volts;
        self.detect()
    }

    /// The programmable voltage detector (RM0090 section 5.2.3): up while the supply is below the level of PWR_CR.PLS; the
    /// way back needs 0.1 V more (DS8626, PVD hysteresis). Off, it says nothing.
    fn detect(&mut self) -> Option<bool> {
        const FALLING_V: [f64; 8] = [2.0, 2.1, 2.3, 2.5, 2.6, 2.7, 2.8, 2.9];
        let on = self.pwr_cr >> 4 & 1 == 1;
        let level = FALLING_V[(self.pwr_cr >> 5 & 7) as usize] + if self.pvdo { 0.1 } else { 0.0 };
        let low = on && self.supply_v < level;
        let changed = low != self.pvdo;
        self.pvdo = low;
        changed.then_some(low)
    }

    /// DBGMCU_CR.DBG_SLEEP (RM0090 section 38.16.3).
    pub(crate) fn debug_sleep(&self) -> bool {
        self.debug[0] & 1 != 0
    }

    pub(crate) fn read_debug(&self, offset: u32) -> u32 {
        match offset {
            0x00 => IDCODE,
            0x04..=0x0C => self.debug[(offset as usize - 4) / 4],
            _ => 0,
        }
    }

    pub(crate) fn write_debug(&mut self, offset: u32, value: u32) {
        if let 0x04..=0x0C = offset {
            self.debug[(offset as usize - 4) / 4] = value;
        }
    }

    pub(crate) fn read_backup_sram(&self, offset: u32, bytes: usize) -> u32 {
        let at = offset as usize & 0xFFF;
        self.backup_sram.iter().skip(at).take(bytes).rev().fold(0, |word, &byte| word << 8 | u32::from(byte))
    }

    pub(crate) fn write_backup_sram(&mut self, offset: u32, bytes: usize, value: u32) {
        if self.backup_open() {
            let at = offset as usize & 0xFFF;
            for (cell, byte) in self.backup_sram.iter_mut().skip(at).take(bytes).zip(value.to_le_bytes()) {
                *cell = byte;
            }
        }
    }
}

/// Date 1 January, prescalers for 32,768 Hz (RM0090 section 26.6).
fn reset_rtc() -> [u32; 40] {
    let mut registers = [0; 40];
    (registers[1], registers[4], registers[5]) = (0x2101, 0x007F_00FF, 0xFFFF);
    registers
}

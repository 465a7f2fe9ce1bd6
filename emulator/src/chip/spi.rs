//! The registers and the shifter of an SPI as master (RM0090 section 28.5).

const CR1_CPHA: u32 = 1;
const CR1_MSTR: u32 = 1 << 2;
const CR1_SPE: u32 = 1 << 6;
const CR1_SSI: u32 = 1 << 8;
const CR1_SSM: u32 = 1 << 9;
const CR1_RXONLY: u32 = 1 << 10;
const CR1_DFF: u32 = 1 << 11;
const CR1_CRCEN: u32 = 1 << 13;
const CR1_BIDIMODE: u32 = 1 << 15;
const SR_RXNE: u32 = 1;
const SR_TXE: u32 = 1 << 1;
const SR_MODF: u32 = 1 << 5;
const SR_OVR: u32 = 1 << 6;
const SR_BSY: u32 = 1 << 7;

/// One SPI.
#[derive(Clone, Debug)]
pub(crate) struct Spi {
    cr1: u32,
    cr2: u32,
    crc_polynomial: u32,
    i2s: [u32; 2],
    received: u16,
    rxne: bool,
    overrun: bool,
    overrun_read: bool,
    mode_fault: bool,
    waiting: Option<u16>,
    shifting: Option<u16>,
}

impl Spi {
    pub(crate) fn new() -> Self {
        Self {
            cr1: 0,
            cr2: 0,
            crc_polynomial: 7,
            i2s: [0, 2],
            received: 0,
            rxne: false,
            overrun: false,
            overrun_read: false,
            mode_fault: false,
            waiting: None,
            shifting: None,
        }
    }

    /// Bits of a word.
    pub(crate) fn bits(&self) -> u8 {
        if self.cr1 & CR1_DFF != 0 { 16 } else { 8 }
    }

    /// Cycles of the bus clock in a bit.
    pub(crate) fn bit_cycles(&self) -> u32 {
        2 << (self.cr1 >> 3 & 7)
    }

    /// CPOL and CPHA as a mode.
    pub(crate) fn mode(&self) -> u8 {
        ((self.cr1 >> 1 & 1) << 1 | self.cr1 & CR1_CPHA) as u8
    }

    pub(crate) fn lsb_first(&self) -> bool {
        self.cr1 >> 7 & 1 == 1
    }

    fn status(&self) -> u32 {
        let flag = |on: bool, bit: u32| if on { bit } else { 0 };
        flag(self.rxne, SR_RXNE)
            | flag(self.waiting.is_none(), SR_TXE)
            | flag(self.mode_fault, SR_MODF)
            | flag(self.overrun, SR_OVR)
            | flag(self.shifting.is_some() || self.waiting.is_some() && self.enabled(), SR_BSY)
    }

    fn enabled(&self) -> bool {
        self.cr1 & (CR1_SPE | CR1_MSTR) == CR1_SPE | CR1_MSTR
    }

    /// The level of the interrupt line.
    pub(crate) fn interrupt(&self) -> bool {
        self.rxne && self.cr2 >> 6 & 1 == 1
            || self.waiting.is_none() && self.cr2 >> 7 & 1 == 1
            || (self.overrun || self.mode_fault) && self.cr2 >> 5 & 1 == 1
    }

    /// Whether the receiver asks for DMA.
    pub(crate) fn receive_requested(&self) -> bool {
        self.cr2 & 1 == 1 && self.rxne
    }

    /// Whether the sender asks for DMA.
    pub(crate) fn transmit_requested(&self) -> bool {
        self.cr2 >> 1 & 1 == 1 && self.waiting.is_none()
    }

    pub(crate) fn read(&mut self, offset: u32) -> u32 {
        match offset {
            0x00 => self.cr1,
            0x04 => self.cr2,
            0x08 => {
                let status = self.status();
                // OVR goes when DR and then SR are read, as they just have been (RM0090 section 28.3.10).
                if std::mem::take(&mut self.overrun_read) {
                    self.overrun = false;
                }
                status
            }
            0x0C => {
                self.rxne = false;
                self.overrun_read = self.overrun;
                u32::from(self.received)
            }
            0x10 => self.crc_polynomial,
            0x1C => self.i2s[0],
            0x20 => self.i2s[1],
            _ => 0,
        }
    }

    /// Answers whether the shifter has just begun a word, and a mistake or a use that is not emulated.
    pub(crate) fn write(&mut self, offset: u32, value: u32) -> (bool, Option<&'static str>) {
        match offset {
            0x00 => {
                let was_enabled = self.cr1 & CR1_SPE != 0;
                let changed = self.cr1 ^ value;
                self.cr1 = value & 0xFFFF;
                let mut bug = None;
                if was_enabled && value & CR1_SPE == 0 && self.shifting.is_some() {
                    bug = Some("is switched off in the middle of a word");
                    self.shifting = None;
                }
                if was_enabled && value & CR1_SPE != 0 && changed & 0x083F != 0 {
                    bug = Some("has its format or rate changed while it is on");
                }
                if value & CR1_SPE != 0 {
                    if value & CR1_MSTR == 0 {
                        bug = Some("is used as a slave, which is not emulated");
                    }
                    if value & (CR1_RXONLY | CR1_CRCEN | CR1_BIDIMODE) != 0 {
                        bug = Some("is used one-way or with a checksum, which is not emulated");
                    }
                    if value & CR1_MSTR != 0 && value & CR1_SSM != 0 && value & CR1_SSI == 0 {
                        // RM0090 section 28.3.10: a master that is selected gives up.
                        self.mode_fault = true;
                        self.cr1 &= !(CR1_SPE | CR1_MSTR);
                        bug =
                            Some("is a master with SSM set and SSI clear: it faults and switches itself off");
                    }
                }
                (self.load(), bug)
            }
            0x04 => {
                self.cr2 = value & 0xF7;
                (false, None)
            }
            0x08 => (false, None),
            0x0C => {
                let lost = self.waiting.is_some();
                let value = if self.bits() == 8 { value & 0xFF } else { value & 0xFFFF };
                self.waiting = Some(value as u16);
                (
                    self.load(),
                    lost.then_some("is given a word while the one before still waits (TXE is clear)"),
                )
            }
            0x10 => {
                self.crc_polynomial = value & 0xFFFF;
                (false, None)
            }
            0x1C | 0x20 => {
                self.i2s[(offset as usize - 0x1C) / 4] = value;
                let used = offset == 0x1C && value >> 11 & 1 == 1;
                (false, used.then_some("is used for I2S, which is not emulated"))
            }
            _ => (false, None),
        }
    }

    /// The word in the shifter, if there is one.
    pub(crate) fn shifting(&self) -> Option<u16> {
        self.shifting
    }

    /// The word has been exchanged for `answer`. Answers whether the next one begins.
    pub(crate) fn exchanged(&mut self, answer: u16) -> bool {
        self.shifting = None;
        if self.rxne {
            self.overrun = true;
        } else {
            self.received = if self.bits() == 8 { answer & 0xFF } else { answer };
            self.rxne = true;
        }
        self.load()
    }

    fn load(&mut self) -> bool {
        if self.shifting.is_some() || !self.enabled() {
            return false;
        }
        self.shifting = self.waiting.take();
        self.shifting.is_some()
    }
}

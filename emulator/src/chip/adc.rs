//! The three analog-to-digital converters: regular conversions, started by software (RM0090 section 13).

use crate::bus::Cycle;

const SR_EOC: u32 = 1 << 1;
const SR_STRT: u32 = 1 << 4;
const SR_OVR: u32 = 1 << 5;
const CR1_SCAN: u32 = 1 << 8;
const CR2_ADON: u32 = 1;
const CR2_CONT: u32 = 1 << 1;
const CR2_DMA: u32 = 1 << 8;
const CR2_DDS: u32 = 1 << 9;
const CR2_EOCS: u32 = 1 << 10;
const CR2_ALIGN: u32 = 1 << 11;
const CR2_SWSTART: u32 = 1 << 30;

/// Time to settle after power-on (DS8626, ADC characteristics: 3 µs at most).
pub(crate) const SETTLE_NS: u64 = 3_000;

/// One converter.
#[derive(Clone, Debug, Default)]
pub(crate) struct Adc {
    sr: u32,
    cr1: u32,
    cr2: u32,
    smpr: [u32; 2],
    sqr: [u32; 3],
    other: [u32; 8],
    data: u16,
    rank: u32,
    converting: bool,
    dma_request: bool,
    powered_at: Cycle,
}

/// What the chip must do after a write.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Done {
    /// A conversion begins.
    pub(crate) start: bool,
    /// Conversions stop.
    pub(crate) stop: bool,
    /// A mistake, or a use that is not emulated.
    pub(crate) bug: Option<&'static str>,
}

impl Adc {
    /// The level of the interrupt line that the three share.
    pub(crate) fn interrupt(&self) -> bool {
        self.sr & SR_EOC != 0 && self.cr1 >> 5 & 1 == 1 || self.sr & SR_OVR != 0 && self.cr1 >> 26 & 1 == 1
    }

    /// Whether a result waits for DMA.
    pub(crate) fn requested(&self) -> bool {
        self.dma_request
    }

    /// Channel of the conversion under way.
    pub(crate) fn channel(&self) -> u8 {
        let rank = self.rank as usize;
        // Ranks 1..=6 in SQR3, 7..=12 in SQR2, 13..=16 in SQR1.
        (self.sqr[2 - (rank / 6).min(2)] >> (5 * (rank % 6)) & 31) as u8
    }

    /// Length of the conversion under way, in cycles of the converter's clock: sampling and one cycle a bit.
    pub(crate) fn conversion_cycles(&self) -> u32 {
        const SAMPLING: [u32; 8] = [3, 15, 28, 56, 84, 112, 144, 480];
        let channel = u32::from(self.channel()).min(18);
        let bits =
            if channel >= 10 { self.smpr[0] >> (3 * (channel - 10)) } else { self.smpr[1] >> (3 * channel) };
        let resolution = 12 - 2 * (self.cr1 >> 24 & 3);
        SAMPLING[(bits & 7) as usize] + resolution
    }

    pub(crate) fn read(&mut self, offset: u32) -> u32 {
        match offset {
            0x00 => self.sr,
            0x04 => self.cr1,
            0x08 => self.cr2,
            0x0C | 0x10 => self.smpr[(offset as usize - 0x0C) / 4],
            0x2C..=0x34 => self.sqr[(offset as usize - 0x2C) / 4],
            0x4C => {
                self.sr &= !SR_EOC;
                self.dma_request = false;
                u32::from(self.data)
            }
            0x14..=0x28 | 0x38 | 0x3C => self.other[(offset as usize / 4) & 7],
            _ => 0,
        }
    }

    pub(crate) fn write(
        &mut self,
        offset: u32,
        value: u32,
        now: Cycle,
        settled: impl Fn(Cycle) -> bool,
    ) -> Done {
        let mut done = Done::default();
        match offset {
            0x00 => self.sr &= value,
            0x04 => self.cr1 = value & 0x07C0_FFFF,
            0x08 => {
                if self.cr2 & CR2_ADON == 0 && value & CR2_ADON != 0 {
                    self.powered_at = now;
                }
                self.cr2 = value & 0x3F7F_0F03;
                if value & CR2_DMA == 0 {
                    self.dma_request = false;
                }
                if value & 0x3030_0000 != 0 || value & 1 << 22 != 0 {
                    done.bug = Some(
                        "is set to an external trigger or an injected conversion, which is not emulated",
                    );
                }
                if self.cr2 & CR2_ADON == 0 {
                    done.stop = std::mem::take(&mut self.converting);
                } else if value & CR2_SWSTART != 0 {
                    if !settled(self.powered_at) {
                        done.bug = Some("is started within 3 µs of being switched on");
                    }
                    if !self.converting {
                        (self.rank, self.converting, done.start) = (0, true, true);
                        self.sr |= SR_STRT;
                    }
                }
            }
            0x0C | 0x10 => self.smpr[(offset as usize - 0x0C) / 4] = value,
            0x2C..=0x34 => self.sqr[(offset as usize - 0x2C) / 4] = value,
            0x14..=0x28 | 0x38 | 0x3C => self.other[(offset as usize / 4) & 7] = value,
            _ => {}
        }
        done
    }

    /// A conversion is done; `counts` is its result of 12 bits. Answers whether another begins.
    pub(crate) fn converted(&mut self, counts: u16) -> bool {
        let dma = self.cr2 & CR2_DMA != 0;
        if self.sr & SR_EOC != 0 && (dma || self.cr2 & CR2_EOCS != 0) {
            // Nobody took the result before.
            self.sr |= SR_OVR;
            self.dma_request = false;
        } else {
            let counts = counts >> (2 * (self.cr1 >> 24 & 3));
            self.data = if self.cr2 & CR2_ALIGN != 0 { counts << 4 } else { counts };
            self.dma_request = dma;
        }
        let last = self.cr1 & CR1_SCAN == 0 || self.rank >= (self.sqr[0] >> 20 & 15);
        if last || dma || self.cr2 & CR2_EOCS != 0 {
            self.sr |= SR_EOC;
        }
        if last && dma && self.cr2 & CR2_DDS == 0 {
            // No request after this one until DMA is switched off and on again (RM0090 section 13.8.1).
            self.converting = false;
        } else {
            self.converting = !last || self.cr2 & CR2_CONT != 0;
        }
        self.rank = if last { 0 } else { self.rank + 1 };
        self.converting
    }
}

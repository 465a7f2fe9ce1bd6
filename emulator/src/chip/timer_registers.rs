//! The registers of a timer (RM0090 section 18.4).

use super::timer::{CR1_ARPE, CR1_CEN, CR1_UDIS, DIER_UDE, Timer};
use crate::bus::Cycle;

const BDTR_BKE: u32 = 1 << 12;
/// Registers reached through DMAR, from CR1 on.
const REGISTERS: u32 = 20;

impl Timer {
    /// Reads a register; the flags are up to date.
    pub(crate) fn read(&mut self, offset: u32, now: Cycle) -> u32 {
        match offset {
            0x00 => self.cr1,
            0x04 => self.cr2,
            0x08 => self.smcr,
            0x0C => self.dier,
            0x10 => self.sr,
            0x18 => self.ccmr[0],
            0x1C => self.ccmr[1],
            0x20 => self.ccer,
            0x24 => self.count(now),
            0x28 => self.psc.written,
            0x2C => self.arr.written,
            0x30 => self.rcr,
            0x34 | 0x38 | 0x3C | 0x40 => {
                let channel = (offset as usize - 0x34) / 4;
                if self.mode_bits(channel) & 3 != 0 {
                    // Reading a captured value clears its flag.
                    self.sr &= !(2 << channel);
                }
                self.ccr[channel].written
            }
            0x44 => self.bdtr,
            0x48 => self.dcr,
            0x4C => {
                let target = self.burst_target();
                target.map_or(0, |offset| self.read(offset, now))
            }
            0x50 => self.other,
            _ => 0,
        }
    }

    /// Writes a register; the flags are up to date. The answer is a mistake, or a use that is not emulated.
    pub(crate) fn write(&mut self, offset: u32, value: u32, now: Cycle) -> Option<&'static str> {
        match offset {
            0x00 => {
                self.set_running(now, value & CR1_CEN != 0);
                self.cr1 = value & 0x3FE | self.cr1 & CR1_CEN;
                if value & 0x70 != 0 {
                    return Some("counts down or centre-aligned, which is not emulated");
                }
            }
            0x04 => self.cr2 = value,
            0x08 => {
                self.smcr = value;
                if value & 0x4007 != 0 {
                    return Some("is set to follow a trigger or an external clock, which is not emulated");
                }
            }
            0x0C => {
                let enabled = value & !self.dier & DIER_UDE != 0;
                self.dier = value & 0x7F5F;
                if enabled && self.requests.standing && self.sr & 1 != 0 {
                    self.ask();
                }
                if !self.requests.sticky {
                    // Without its enable bit a request is gone.
                    if self.dier >> 8 & 1 == 0 {
                        self.burst_left = 0;
                    }
                    self.channel_requests &= (self.dier >> 9) as u8 & 0xF;
                }
            }
            0x10 => self.sr &= value,
            0x14 => self.generate(value, now),
            0x18 | 0x1C => {
                let half = (offset as usize - 0x18) / 4;
                self.ccmr[half] = value & 0xFFFF;
                for channel in [2 * half, 2 * half + 1] {
                    if self.mode_bits(channel) & 8 == 0 {
                        self.ccr[channel].active = self.ccr[channel].written;
                    }
                }
                if (value & 3 != 0 || value >> 8 & 3 != 0) && self.channels > 0 {
                    return Some("is set to capture, which is not emulated");
                }
            }
            0x20 => self.ccer = value & 0xFFFF,
            0x24 => self.set_count(now, value, false),
            0x28 => self.psc.written = value & 0xFFFF,
            0x2C => {
                self.arr.written = value & self.full();
                if self.cr1 & CR1_ARPE == 0 {
                    self.hold(now);
                    let was_stopped = self.arr.active == 0;
                    self.arr.active = self.arr.written;
                    if was_stopped {
                        self.origin = now;
                    }
                }
            }
            0x30 => {
                self.rcr = value & 0xFF;
                if self.rcr != 0 {
                    return Some("repeats periods (RCR), which is not emulated");
                }
            }
            0x34 | 0x38 | 0x3C | 0x40 => {
                let channel = (offset as usize - 0x34) / 4;
                self.ccr[channel].written = value & self.full();
                if self.mode_bits(channel) & 8 == 0 {
                    self.ccr[channel].active = self.ccr[channel].written;
                }
            }
            0x44 => {
                self.bdtr = value & 0xFFFF;
                if value & BDTR_BKE != 0 {
                    return Some("lets a break input stop its outputs (BKE), which is not emulated");
                }
            }
            0x48 => self.dcr = value & 0x1F1F,
            0x4C => {
                let target = self.burst_target();
                return target.and_then(|offset| self.write(offset, value, now));
            }
            0x50 => self.other = value,
            _ => {}
        }
        None
    }

    /// The level of the interrupt lines: update, capture/compare, trigger and commutation, break.
    pub(crate) fn interrupts(&self) -> [bool; 4] {
        let active = self.sr & self.dier;
        [active & 1 != 0, active & 0x1E != 0, active & 0x60 != 0, active & 0x80 != 0]
    }

    /// Whether the update asks for DMA.
    pub(crate) fn update_requested(&self) -> bool {
        self.burst_left > 0 && self.dier >> 8 & 1 == 1
    }

    /// Whether a channel asks for DMA.
    pub(crate) fn channel_requested(&self, channel: u8) -> bool {
        self.channel_requests >> channel & 1 == 1 && self.dier >> (channel + 9) & 1 == 1
    }

    /// DMA serves one request.
    pub(crate) fn acknowledge(&mut self, channel: Option<u8>) {
        match channel {
            None => self.burst_left = self.burst_left.saturating_sub(1),
            Some(channel) => self.channel_requests &= !(1 << channel),
        }
    }

    /// EGR.
    fn generate(&mut self, value: u32, now: Cycle) {
        if value & 1 != 0 {
            self.update(false);
            // The counter restarts even where the update itself is disabled.
            self.set_count(now, 0, true);
        }
        for channel in 0..self.channels {
            if value >> (channel + 1) & 1 == 1 {
                self.matched(channel);
            }
        }
        if value & 1 != 0 && self.cr1 & CR1_UDIS != 0 {
            self.psc.active = self.psc.written;
        }
    }

    /// Offset of the register that the next access through DMAR reaches, and moves on.
    fn burst_target(&mut self) -> Option<u32> {
        let (base, length) = (self.dcr & 0x1F, (self.dcr >> 8 & 0x1F) + 1);
        let register = base + self.burst_index;
        self.burst_index = (self.burst_index + 1) % length;
        // DMAR does not reach itself.
        (register < REGISTERS && register != 0x4C / 4).then_some(4 * register)
    }
}

//! An access to a register, and what follows from it.

use super::adc::SETTLE_NS;
use super::events::Slot;
use super::map::{self, Block};
use super::{Board, Chip, adc, bytes, dma, exti, flash, gpio, or_never, spi, timer, usart, watchdog};
use crate::bus::{Access, Cycle, Master, NEVER, Width};
use crate::memory::Memory;

impl<B: Board> Chip<B> {
    /// Reads; a sub-word access takes its lanes of the register.
    pub(super) fn read_block(
        &mut self,
        memory: &mut Memory,
        block: Block,
        offset: u32,
        access: Access,
        master: Master,
    ) -> u32 {
        if !self.reachable(memory, block, offset, access, "read", master) {
            return 0;
        }
        let at = access.at;
        let register = offset & !3;
        let word = match block {
            Block::Timer(n) => {
                self.sync_timer(memory, n, at);
                let value = self.timers[usize::from(n)].read(register, at);
                self.timer_changed(n);
                value
            }
            Block::Rtc => self.minor.read_rtc(register),
            Block::Wwdg => self.wwdg.read(register, at, self.wwdg_divider()),
            Block::Iwdg => self.iwdg.read(register, self.clock.ns(at)),
            Block::Spi(n) => {
                let spi = &mut self.spis[usize::from(n)];
                let before = spi.interrupt();
                let value = spi.read(register);
                if spi.interrupt() != before {
                    self.refresh(block);
                }
                value
            }
            Block::Usart(n) => {
                let value = self.usarts[usize::from(n)].read(register);
                self.refresh(block);
                value
            }
            Block::Pwr => self.minor.read_pwr(register),
            Block::Adc => self.read_adc(register),
            Block::Syscfg => self.exti.read_syscfg(register),
            Block::Exti => self.exti.read(register),
            Block::Gpio(n) => self.gpio[usize::from(n)].read(register),
            Block::Crc => self.minor.read_crc(register),
            Block::Rcc => self.rcc.read(register, at),
            Block::Flash => self.flash.read(register),
            Block::Dma(n) => self.dma[usize::from(n)].read(register),
            Block::BackupSram => return self.minor.read_backup_sram(offset, bytes(access.width)),
            Block::Rng => self.minor.rng().read(register, self.clock.ns(at)),
            Block::Debug => self.minor.read_debug(register),
        };
        let lanes = word >> (8 * (offset & 3));
        match access.width {
            Width::Byte => lanes & 0xFF,
            Width::Half => lanes & 0xFFFF,
            Width::Word => lanes,
        }
    }

    /// Writes.
    pub(super) fn write_block(
        &mut self,
        memory: &mut Memory,
        block: Block,
        offset: u32,
        access: Access,
        value: u32,
    ) {
        if !self.reachable(memory, block, offset, access, "written", Master::Core) {
            return;
        }
        let at = access.at;
        let value = match access.width {
            Width::Byte => value & 0xFF,
            Width::Half => value & 0xFFFF,
            Width::Word => value,
        };
        if block == Block::BackupSram {
            return self.minor.write_backup_sram(offset, bytes(access.width), value);
        }
        let register = offset & !3;
        let value = self.lanes(block, register, offset, access, value);
        match block {
            Block::Timer(n) => self.write_timer(memory, n, register, access, value),
            Block::Rtc => {
                self.minor.write_rtc(register, value);
                // TSE, WUTE, ALRBE, ALRAE (RM0090 section 26.6.3).
                if register == 0x08 && value & 0xF00 != 0 {
                    let text = "RTC is set to wake, to alarm or to stamp times, which is not emulated";
                    report(memory, access, Some(text.into()));
                }
            }
            Block::Wwdg => {
                let divider = self.wwdg_divider();
                if self.wwdg.write(register, value, at, divider) {
                    self.ask_for_reset(super::rcc::CSR_WWDGRSTF);
                }
                self.events.set(Slot::Wwdg, self.wwdg.due(divider));
                self.refresh(block);
            }
            Block::Iwdg => {
                let bug = self.iwdg.write(register, value, self.clock.ns(at));
                self.events.set(Slot::Iwdg, self.clock.cycle(self.iwdg.due_ns()));
                note(memory, access, block, bug);
            }
            Block::Spi(n) => {
                let (started, bug) = self.spis[usize::from(n)].write(register, value);
                if bug.is_some() {
                    let text = bug.map(|text| format!("{} {text}", block.name()));
                    report(memory, access, text);
                }
                self.spi_changed(memory, n, at, access, started);
            }
            Block::Usart(n) => {
                let divider = self.clock.apb_divider(map::usart_bus(n));
                if let Some(done) = self.usarts[usize::from(n)].write(register, value, at, divider) {
                    self.events.set(Slot::UsartTx(n), done);
                }
                if let Some(text) = self.usarts[usize::from(n)].take_bug() {
                    report(memory, access, Some(format!("{} {text}, which is not emulated", block.name())));
                }
                if self.usarts[usize::from(n)].take_opened() {
                    self.events
                        .set(Slot::UsartIdle(n), at + self.usarts[usize::from(n)].frame_cycles(divider));
                }
                self.refresh(block);
            }
            Block::Pwr => {
                let change = self.minor.write_pwr(register, value);
                self.supply_detected(change);
            }
            Block::Adc => self.write_adc(memory, register, access, value),
            Block::Syscfg => self.exti.write_syscfg(register, value),
            Block::Exti => {
                self.exti.write(register, value);
                self.refresh(block);
            }
            Block::Gpio(n) => self.write_gpio(memory, n, register, at, value),
            Block::Crc => self.minor.write_crc(register, value),
            Block::Rcc => {
                let before = self.rcc.enable;
                self.write_rcc(memory, register, access, value);
                for (fresh, (now, before)) in
                    self.fresh_gates.iter_mut().zip(self.rcc.enable.iter().zip(before))
                {
                    if *now != before {
                        *fresh = (now & !before, at);
                    }
                }
            }
            Block::Flash => {
                let done = self.flash.write(memory, at, register, value);
                self.flash_done(memory, access, done);
            }
            Block::Dma(n) => self.write_dma(memory, n, register, access, value),
            Block::Rng => self.minor.rng().write(register, value, self.clock.ns(at)),
            Block::Debug => self.minor.write_debug(register, value),
            Block::BackupSram => {}
        }
    }

    /// The voltage detector's output changed: line 16 of the external interrupts (RM0090 section 12.2.5).
    pub(super) fn supply_detected(&mut self, change: Option<bool>) {
        if let Some(low) = change {
            self.exti.edge(16, low);
            self.refresh(Block::Exti);
        }
    }

    /// What follows from a write to the flash interface or to flash memory.
    pub(super) fn flash_done(&mut self, memory: &mut Memory, access: Access, done: flash::Done) {
        if let Some(ns) = done.busy_ns {
            let until = access.at + self.clock.cycles_for(ns);
            memory.flash_interface.busy_until = until;
            self.events.set(Slot::Flash, until);
        }
        report(memory, access, done.bug);
        if done.access_control {
            self.check_wait_states(memory, access.at, access.pc);
        }
        self.refresh(Block::Flash);
    }

    /// Sets registers of `block` to their reset values.
    pub(super) fn reset_block(&mut self, memory: &mut Memory, block: Block, at: Cycle) {
        match block {
            Block::Timer(n) => {
                self.sync_timer(memory, n, at);
                self.cut_pulses(memory, n, at);
                let index = usize::from(n);
                let requests = self.timers[index].requests;
                self.timers[index] = timer::Timer::new(index);
                self.timers[index].requests = requests;
                self.timers[index].set_divider(at, self.clock.timer_divider(map::timer_bus(n)));
                self.timer_changed(n);
            }
            Block::Wwdg => {
                self.wwdg = watchdog::Wwdg::new();
                self.events.set(Slot::Wwdg, NEVER);
            }
            Block::Spi(n) => {
                self.spis[usize::from(n)] = spi::Spi::new();
                self.events.set(Slot::Spi(n), NEVER);
            }
            Block::Usart(n) => {
                self.usarts[usize::from(n)] = usart::Usart::new();
                self.events.set(Slot::UsartTx(n), NEVER);
                self.events.set(Slot::UsartIdle(n), NEVER);
            }
            Block::Pwr => self.minor.reset_pwr(),
            Block::Syscfg => self.exti.reset_syscfg(),
            Block::Gpio(n) => {
                self.change_gpio(memory, n, at, true, gpio::Gpio::reset);
            }
            Block::Crc => self.minor.reset_crc(),
            Block::Dma(n) => {
                self.dma[usize::from(n)] = dma::Dma::new();
                if n == 1 {
                    (0..8).for_each(|stream| self.events.set(Slot::MemoryCopy(stream), NEVER));
                }
            }
            Block::Rng => self.minor.reset_rng(),
            Block::Rtc | Block::Iwdg | Block::Adc | Block::Exti => {}
            Block::Rcc | Block::Flash | Block::BackupSram | Block::Debug => {}
        }
        self.refresh(block);
    }

    /// Brings the interrupt lines of a block up to date.
    pub(super) fn refresh(&mut self, block: Block) {
        match block {
            Block::Timer(n) => self.refresh_timer(n),
            Block::Wwdg => self.set_line(0, self.wwdg.interrupt()),
            Block::Spi(n) => {
                self.set_line(map::SPI_IRQS[usize::from(n)], self.spis[usize::from(n)].interrupt());
            }
            Block::Usart(n) => {
                self.set_line(map::USART_IRQS[usize::from(n)], self.usarts[usize::from(n)].interrupt());
            }
            Block::Adc => self.set_line(18, self.adcs.iter().any(adc::Adc::interrupt)),
            Block::Exti => self.lines = self.lines & !exti::Exti::IRQS | self.exti.lines(),
            Block::Rcc => self.set_line(5, self.rcc.interrupt()),
            Block::Flash => self.set_line(4, self.flash.interrupt()),
            Block::Dma(n) => {
                let controller = usize::from(n);
                let active = self.dma[controller].interrupts();
                if active == 0 && self.lines & map::DMA_LINES[controller & 1] == 0 {
                    return;
                }
                for stream in 0..8 {
                    self.set_line(map::dma_irq(controller, stream), active >> stream & 1 == 1);
                }
            }
            _ => {}
        }
    }

    /// The word that a write of less than a word amounts to. AHB peripherals take single lanes; on APB the whole
    /// register is written (RM0090 section 2.3, note on register access).
    fn lanes(&mut self, block: Block, register: u32, offset: u32, access: Access, value: u32) -> u32 {
        if access.width == Width::Word {
            return value;
        }
        let shift = 8 * (offset & 3);
        let mask = if access.width == Width::Byte { 0xFF } else { 0xFFFF } << shift;
        let old = match block {
            // BSRR reads as zero: lanes not written change nothing.
            Block::Gpio(_) if register == 0x18 => 0,
            Block::Gpio(n) => self.gpio[usize::from(n)].read(register),
            Block::Rcc => self.rcc.read(register, access.at),
            Block::Flash => self.flash.read(register),
            _ => 0,
        };
        old & !mask | value << shift
    }

    fn write_timer(&mut self, memory: &mut Memory, n: u8, register: u32, access: Access, value: u32) {
        self.sync_timer(memory, n, access.at);
        // What changes an output or restarts the count ends the pulse under way.
        let index = usize::from(n);
        let stops = register == 0x00 && value & 1 == 0 || register == 0x14 && value & 1 != 0;
        let switches = register == 0x20 && self.timers[index].ccer != value || register == 0x44;
        if stops || switches {
            self.cut_pulses(memory, n, access.at);
        }
        if let Some(text) = self.timers[index].write(register, value, access.at) {
            report(memory, access, Some(format!("TIM{} {text}", n + 1)));
        }
        self.timer_changed(n);
    }

    fn write_dma(&mut self, memory: &mut Memory, n: u8, register: u32, access: Access, value: u32) {
        let controller = usize::from(n);
        let done = self.dma[controller].write(register, value);
        if let Some(bug) = done.bug {
            report(memory, access, Some(format!("{bug} (DMA{})", n + 1)));
        }
        if let Some(stream) = done.enabled {
            self.stream_enabled(memory, controller, stream, access);
        }
        if let Some(stream) = done.disabled
            && n == 1
        {
            self.events.set(Slot::MemoryCopy(stream as u8), NEVER);
        }
        self.refresh(Block::Dma(n));
    }

    fn read_adc(&mut self, register: u32) -> u32 {
        let value = match register {
            0x300 => (0..3).fold(0, |all, n| all | (self.adcs[n].read(0) & 0x3F) << (8 * n)),
            0x304 => self.adc_common,
            0x308.. => 0,
            _ => self.adcs[(register >> 8) as usize & 3].read(register & 0xFF),
        };
        self.refresh(Block::Adc);
        value
    }

    fn write_adc(&mut self, memory: &mut Memory, register: u32, access: Access, value: u32) {
        match register {
            0x304 => {
                self.adc_common = value & 0x00C3_EF1F;
                if value & 0x1F != 0 {
                    report(
                        memory,
                        access,
                        Some("ADC_CCR.MULTI joins converters, which is not emulated".into()),
                    );
                }
            }
            0x300 | 0x308.. => {}
            _ => {
                let n = (register >> 8) as u8;
                let clock = &self.clock;
                let settled = |since: Cycle| access.at >= since + clock.cycles_for(SETTLE_NS);
                let done = self.adcs[usize::from(n)].write(register & 0xFF, value, access.at, settled);
                if let Some(text) = done.bug {
                    report(memory, access, Some(format!("ADC{} {text}", n + 1)));
                }
                if done.start || done.stop {
                    let end = done.start.then(|| access.at + self.conversion_cycles(n));
                    self.events.set(Slot::Adc(n), or_never(end));
                    self.check_adc_clock(memory, access);
                }
                self.refresh(Block::Adc);
            }
        }
    }
}

/// Notes a mistake of the firmware.
pub(super) fn report(memory: &mut Memory, access: Access, text: Option<String>) {
    if let Some(text) = text {
        memory.report(access.at, access.pc, text);
    }
}

fn note(memory: &mut Memory, access: Access, _: Block, text: Option<&str>) {
    report(memory, access, text.map(String::from));
}

//! The private peripheral bus: system control space, DWT, and what a debugger would use (ARMv7-M ARM B3.2, C1).
use crate::{
    bus::{AccessError, Peripherals, Width},
    core::{
        Core, Fault,
        nvic::{self, BUS_FAULT, MEM_MANAGE, PEND_SV, SV_CALL, SYS_TICK, USAGE_FAULT, bit},
    },
    memory::Memory,
};

/// System handlers and their bits in SHCSR: active, then pending (0: none).
const HANDLERS: [(u16, u32, u32); 7] = [
    (MEM_MANAGE, 1, 1 << 13),
    (BUS_FAULT, 1 << 1, 1 << 14),
    (USAGE_FAULT, 1 << 3, 1 << 12),
    (SV_CALL, 1 << 7, 1 << 15),
    (nvic::DEBUG_MONITOR, 1 << 8, 0),
    (PEND_SV, 1 << 10, 0),
    (SYS_TICK, 1 << 11, 0),
];

impl Core {
    pub(crate) fn read_system<P: Peripherals>(
        &mut self,
        memory: &mut Memory,
        peripherals: &mut P,
        address: u32,
        width: Width,
    ) -> Result<u32, Fault> {
        let _ = peripherals;
        if !self.privileged() {
            return Err(self.bus_fault(memory, AccessError::Privileged(address)));
        }
        let word = self.read_word(address & 0xFFFFC) >> (8 * (address & 3));
        Ok(match width {
            Width::Byte => word & 0xFF,
            Width::Half => word & 0xFFFF,
            Width::Word => word,
        })
    }

    fn read_word(&mut self, offset: u32) -> u32 {
        let set = |set: u128, from: u32| ((set >> 16) >> (8 * (offset - from)).min(127)) as u32;
        match offset {
            // DWT: CTRL with four comparators, CYCCNT; the other counters read 0.
            0x1000 => self.scs.dwt_control,
            0x1004 => self.cycle_count(),
            0xE004 => 2,
            0xE010 => {
                self.count_systick();
                self.systick.read_control()
            }
            0xE014 => self.systick.reload(),
            0xE018 => {
                self.count_systick();
                self.systick.value()
            }
            // CALIB: no reference known.
            0xE01C => 0x4000_0000,
            0xE100..0xE11C => set(self.nvic.enabled & !0xFFFF, 0xE100),
            0xE180..0xE19C => set(self.nvic.enabled & !0xFFFF, 0xE180),
            0xE200..0xE21C => set(self.nvic.pending, 0xE200),
            0xE280..0xE29C => set(self.nvic.pending, 0xE280),
            0xE300..0xE31C => set(self.nvic.active, 0xE300),
            0xE400..0xE4F0 => self.priorities(16 + (offset - 0xE400)),
            0xED00 => 0x410F_C241,
            0xED04 => self.interrupt_control(),
            0xED08 => self.scs.vtor,
            0xED0C => 0xFA05_0000 | u32::from(self.nvic.group) << 8,
            0xED10 => self.scs.scr,
            0xED14 => self.scs.ccr,
            0xED18..0xED24 => self.priorities(4 + (offset - 0xED18)),
            0xED24 => self.handler_state(),
            0xED28 => self.scs.cfsr,
            0xED2C => self.scs.hfsr,
            0xED30 => self.scs.dfsr,
            0xED34 => self.scs.mmfar,
            0xED38 => self.scs.bfar,
            0xED88 => self.scs.cpacr,
            0xEDFC => self.scs.demcr,
            0xEF34 => self.scs.fpccr,
            0xEF38 => self.scs.fpcar,
            0xEF3C => self.scs.fpdscr,
            0xEF40 => 0x1011_0021,
            0xEF44 => 0x1100_0011,
            _ => 0,
        }
    }

    pub(crate) fn write_system<P: Peripherals>(
        &mut self,
        memory: &mut Memory,
        peripherals: &mut P,
        address: u32,
        width: Width,
        value: u32,
    ) -> Result<(), Fault> {
        let offset = address & 0xF_FFFF;
        // STIR alone may be open to unprivileged code (CCR.USERSETMPEND).
        let open = offset == 0xEF00 && self.scs.ccr & 2 != 0;
        if !self.privileged() && !open {
            return Err(self.bus_fault(memory, AccessError::Privileged(address)));
        }
        let bytes = match width {
            Width::Byte => 1,
            Width::Half => 2,
            Width::Word => 4,
        };
        match offset {
            0xE400..0xE4F0 => self.set_priorities(16 + (offset - 0xE400), value, bytes),
            0xED18..0xED24 => self.set_priorities(4 + (offset - 0xED18), value, bytes),
            // Elsewhere bytes not written count as zero: right for registers where ones act.
            _ => {
                let kept = if bytes == 4 { value } else { value & ((1 << (8 * bytes)) - 1) };
                self.write_word(memory, peripherals, offset & !3, kept << (8 * (offset & 3)));
            }
        }
        self.deadline = 0;
        Ok(())
    }

    fn write_word<P: Peripherals>(
        &mut self,
        memory: &mut Memory,
        peripherals: &mut P,
        offset: u32,
        value: u32,
    ) {
        let irqs = |from: u32| {
            let implemented = ((1_u128 << nvic::IRQS) - 1) << 16;
            (u128::from(value).checked_shl(8 * (offset - from)).unwrap_or(0) << 16) & implemented
        };
        match offset {
            0x1000 => {
                let count = self.cycle_count();
                self.scs.dwt_control = self.scs.dwt_control & !0x007F_1FFF | value & 0x007F_1FFF;
                self.set_cycle_count(count);
            }
            0x1004 => self.set_cycle_count(value),
            0xE010 => {
                self.count_systick();
                self.systick.write_control(value, self.cycle);
            }
            0xE014 => {
                self.count_systick();
                self.systick.set_reload(value);
            }
            0xE018 => {
                self.count_systick();
                self.systick.clear_value(self.cycle);
            }
            0xE100..0xE11C => self.nvic.enabled |= irqs(0xE100),
            0xE180..0xE19C => self.nvic.enabled &= !irqs(0xE180),
            0xE200..0xE21C => {
                let set = irqs(0xE200);
                self.pend_set(set);
            }
            0xE280..0xE29C => {
                self.nvic.pending &= !irqs(0xE280);
                self.nvic.pend_high_lines();
            }
            0xED04 => self.write_interrupt_control(value),
            0xED08 => self.scs.vtor = value & 0xFFFF_FF80,
            0xED0C if value >> 16 == 0x05FA => {
                self.nvic.group = (value >> 8 & 7) as u8;
                if value & 4 != 0 {
                    peripherals.request_reset();
                }
            }
            0xED10 => {
                self.scs.scr = value & 0x16;
                if value & 4 != 0 {
                    memory.report(
                        self.cycle,
                        self.r[15].wrapping_sub(4),
                        "SCR.SLEEPDEEP set: deep sleep runs as sleep here".to_owned(),
                    );
                }
            }
            0xED14 => self.scs.ccr = value & 0x31B,
            0xED24 => self.set_handler_state(value),
            0xED28 => self.scs.cfsr &= !value,
            0xED2C => self.scs.hfsr &= !value,
            0xED30 => self.scs.dfsr &= !value,
            0xED34 => self.scs.mmfar = value,
            0xED38 => self.scs.bfar = value,
            0xED88 => {
                self.scs.cpacr = value & 0x00F0_0000;
                self.fp_ready = false;
            }
            // DWT_FUNCTION0 to 3 (C1.8.16).
            0x1028 | 0x1038 | 0x1048 | 0x1058 if value & 0xF != 0 => memory.report(
                self.cycle,
                self.r[15].wrapping_sub(4),
                "DWT_FUNCTION set: the comparators of the watchpoint unit are not emulated".to_owned(),
            ),
            0xED94 if value & 1 != 0 => memory.report(
                self.cycle,
                self.r[15].wrapping_sub(4),
                "MPU_CTRL.ENABLE set: the memory protection unit is not emulated".to_owned(),
            ),
            0xEDFC => {
                let count = self.cycle_count();
                self.scs.demcr = value & 0x0100_07F1;
                self.set_cycle_count(count);
            }
            0xEF00 => {
                let irq = (value & 0x1FF) as usize;
                if irq < nvic::IRQS {
                    self.pend(irq as u16 + 16);
                }
            }
            0xEF34 => {
                self.scs.fpccr = value & 0xC000_017B;
                self.fp_ready = false;
            }
            0xEF38 => self.scs.fpcar = value & !7,
            0xEF3C => self.scs.fpdscr = value & 0x07C0_0000,
            // ITM, FPB, MPU, debug: nobody listens.
            _ => {}
        }
    }

    /// Brings SysTick up to date.
    pub(crate) fn count_systick(&mut self) {
        if self.systick.advance(self.cycle) {
            self.pend(SYS_TICK);
        }
    }

    /// CYCCNT counts while the core clock runs.
    fn cycle_count(&self) -> u32 {
        if self.scs.counts_cycles() {
            (self.clocked() as u32).wrapping_add(self.scs.cycle_count)
        } else {
            self.scs.cycle_count
        }
    }

    fn set_cycle_count(&mut self, count: u32) {
        self.scs.cycle_count =
            if self.scs.counts_cycles() { count.wrapping_sub(self.clocked() as u32) } else { count };
    }

    fn pend_set(&mut self, set: u128) {
        let before = self.nvic.pending;
        self.nvic.pending |= set;
        if self.scs.sends_event_on_pend() && before != self.nvic.pending {
            self.event = true;
        }
    }

    /// Four priority bytes from exception `first`.
    fn priorities(&self, first: u32) -> u32 {
        let byte = |n: u32| self.nvic.priority.get((first + n) as usize).copied().unwrap_or(0);
        u32::from_le_bytes([byte(0), byte(1), byte(2), byte(3)])
    }

    fn set_priorities(&mut self, first: u32, value: u32, bytes: usize) {
        for (exception, byte) in (first..).zip(value.to_le_bytes().into_iter().take(bytes)) {
            // Those the architecture reserves have none.
            let exists = matches!(exception, 4..=6 | 11 | 12 | 14..);
            if let Some(priority) = self.nvic.priority.get_mut(exception as usize)
                && exists
            {
                *priority = byte & 0xF0;
            }
        }
    }

    /// ICSR (B3.2.4).
    fn interrupt_control(&mut self) -> u32 {
        self.count_systick();
        let pending = |exception| u32::from(self.nvic.pending & bit(exception) != 0);
        let next = self.nvic.next_pending().map_or(0, |(exception, _)| u32::from(exception));
        let alone = self.nvic.active & !bit(self.ipsr) == 0;
        pending(nvic::NMI) << 31
            | pending(PEND_SV) << 28
            | pending(SYS_TICK) << 26
            | u32::from(self.nvic.pending >> 16 != 0) << 22
            | next << 12
            | u32::from(alone) << 11
            | u32::from(self.ipsr)
    }

    fn write_interrupt_control(&mut self, value: u32) {
        for (set, exception) in [(31, nvic::NMI), (28, PEND_SV), (26, SYS_TICK)] {
            if value & 1 << set != 0 {
                self.pend(exception);
            }
        }
        for (clear, exception) in [(27, PEND_SV), (25, SYS_TICK)] {
            if value & 1 << clear != 0 {
                self.nvic.pending &= !bit(exception);
            }
        }
    }

    /// SHCSR (B3.2.13).
    fn handler_state(&self) -> u32 {
        HANDLERS.iter().fold(self.scs.shcsr, |state, &(exception, active, pending)| {
            let active = if self.nvic.active & bit(exception) != 0 { active } else { 0 };
            let pending = if self.nvic.pending & bit(exception) != 0 { pending } else { 0 };
            state | active | pending
        })
    }

    fn set_handler_state(&mut self, value: u32) {
        self.scs.shcsr = value & 0x0007_0000;
        for (exception, active, pending) in HANDLERS {
            let put = |set: &mut u128, on: bool| {
                *set = if on { *set | bit(exception) } else { *set & !bit(exception) };
            };
            put(&mut self.nvic.active, value & active != 0);
            if pending != 0 {
                put(&mut self.nvic.pending, value & pending != 0);
            }
        }
    }
}

//! MRS and MSR (ARMv7-M ARM B5.2.2, B5.2.3).
use crate::core::Core;

impl Core {
    fn on_process_stack(&self) -> bool {
        self.process_stack && self.ipsr == 0
    }

    pub(crate) fn read_special(&self, sysm: u8) -> u32 {
        let (mut main, mut process) = (self.r[13], self.other_sp);
        if self.on_process_stack() {
            std::mem::swap(&mut main, &mut process);
        }
        match sysm {
            0..8 => {
                let ipsr = if sysm & 1 != 0 { u32::from(self.ipsr) } else { 0 };
                let apsr = if sysm & 4 == 0 { self.apsr() } else { 0 };
                // EPSR reads as zero.
                apsr | ipsr
            }
            20 => {
                u32::from(self.unprivileged)
                    | u32::from(self.on_process_stack()) << 1
                    | u32::from(self.fpca) << 2
            }
            _ if !self.privileged() => 0,
            8 => main,
            9 => process,
            16 => u32::from(self.primask),
            17 | 18 => u32::from(self.basepri),
            19 => u32::from(self.faultmask),
            _ => 0,
        }
    }

    pub(crate) fn write_special(&mut self, sysm: u8, mask: u8, value: u32) {
        if sysm < 4 {
            if mask & 2 != 0 {
                self.set_nzcvq(value);
            }
            if mask & 1 != 0 {
                self.ge = (value >> 16 & 15) as u8;
            }
            return;
        }
        if !self.privileged() {
            return;
        }
        match sysm {
            8 if !self.on_process_stack() => self.r[13] = value & !3,
            9 if self.on_process_stack() => self.r[13] = value & !3,
            8 | 9 => self.other_sp = value & !3,
            16 => self.primask = value & 1 != 0,
            17 => self.basepri = value as u8 & 0xF0,
            18 => {
                let new = value as u8 & 0xF0;
                if new != 0 && (new < self.basepri || self.basepri == 0) {
                    self.basepri = new;
                }
            }
            19 if value & 1 == 0 || self.execution_priority() > -1 => self.faultmask = value & 1 != 0,
            20 => {
                if self.ipsr == 0 {
                    let process = value & 2 != 0;
                    if process != self.process_stack {
                        std::mem::swap(&mut self.r[13], &mut self.other_sp);
                    }
                    self.process_stack = process;
                }
                self.unprivileged = value & 1 != 0;
                self.fpca = value & 4 != 0;
                self.fp_ready = false;
            }
            _ => {}
        }
        self.deadline = 0;
    }
}

//! Reset, exception entry and return (ARMv7-M ARM B1.5.5 to B1.5.8).
use crate::{
    bus::Peripherals,
    core::{
        Core, Fault, Lockup, Sleep, cost,
        nvic::{self, BUS_FAULT, HARD_FAULT, MEM_MANAGE, bit},
    },
    memory::Memory,
};

impl Core {
    /// TakeReset (B1.5.5).
    pub(crate) fn reset(&mut self, memory: &mut Memory) {
        let fresh =
            Self { flash_slots: Box::default(), ram_slots: Box::default(), ..Self::empty(self.timing) };
        let old = std::mem::replace(self, fresh);
        self.flash_slots = old.flash_slots;
        self.other_slots = old.other_slots;
        self.ram_slots = old.ram_slots;
        self.flash_alias = old.flash_alias;
        self.cycle = old.cycle;
        self.counters = old.counters;
        self.event = old.event;
        let word = |at: usize| {
            memory.flash.get(at..at + 4).map_or(0, |b| u32::from_le_bytes([b[0], b[1], b[2], b[3]]))
        };
        self.r[13] = word(0) & !3;
        self.r[14] = u32::MAX;
        self.start_at(word(4));
    }

    /// Continues at `target`, whose bit 0 becomes EPSR.T.
    pub(crate) fn start_at(&mut self, target: u32) {
        self.pc = target & !1;
        self.thumb = target & 1 != 0;
    }

    /// ExceptionEntry (B1.5.6); `pc` is where the exception returns to.
    pub(crate) fn enter<P: Peripherals>(
        &mut self,
        memory: &mut Memory,
        peripherals: &mut P,
        exception: u16,
    ) -> Result<(), Lockup> {
        let handler = self.ipsr != 0;
        let link = match (handler, self.process_stack) {
            (true, _) => 0xFFFF_FFF1,
            (false, false) => 0xFFFF_FFF9,
            (false, true) => 0xFFFF_FFFD,
        };
        let link = if self.fpca { link & !0x10 } else { link };
        self.cycle += cost::ENTRY;
        let stacked = self.push_frame(memory, peripherals);
        if !handler && self.process_stack {
            std::mem::swap(&mut self.r[13], &mut self.other_sp);
        }
        self.fpca = false;
        let mut exception = exception;
        exception = self.late_arrival(memory, peripherals, exception);
        if stacked.is_err() {
            // A derived exception; the one of higher priority goes first, the other stays pending (B1.5.11).
            let derived = self.record(Fault::Stacking, self.execution_priority());
            if self.nvic.priority_of(derived) < self.nvic.priority_of(exception) {
                self.nvic.pending |= bit(exception);
                exception = derived;
            } else if derived != exception {
                self.nvic.pending |= bit(derived);
            }
        }
        self.take(memory, peripherals, exception, link)
    }

    /// An exception of higher priority that comes during the stacking goes first, on the same frame; the one that caused
    /// the stacking stays pending (Cortex-M4 TRM section 3.9.1).
    fn late_arrival<P: Peripherals>(
        &mut self,
        memory: &mut Memory,
        peripherals: &mut P,
        exception: u16,
    ) -> u16 {
        if peripherals.next_event() <= self.cycle {
            peripherals.advance(memory, self.cycle);
        }
        let lines = peripherals.interrupt_lines();
        if lines != self.nvic.lines() {
            self.set_lines(lines);
        }
        match self.nvic.next_pending() {
            Some((late, _)) if self.nvic.priority_of(late) < self.nvic.priority_of(exception) => {
                self.nvic.pending |= bit(exception);
                late
            }
            _ => exception,
        }
    }

    /// ExceptionTaken (B1.5.6): to the handler, with `link` to return by.
    fn take<P: Peripherals>(
        &mut self,
        memory: &mut Memory,
        peripherals: &mut P,
        exception: u16,
        link: u32,
    ) -> Result<(), Lockup> {
        let mut exception = exception;
        self.nvic.pending &= !bit(exception);
        let mut vector = self.read_vector(memory, peripherals, exception);
        if vector.is_none() {
            self.scs.hfsr |= 1 << 1;
            if matches!(exception, HARD_FAULT | nvic::NMI) {
                return Err(Lockup { fault: Fault::VectorTable });
            }
            self.nvic.pending |= bit(exception);
            exception = HARD_FAULT;
            self.nvic.pending &= !bit(exception);
            vector = self.read_vector(memory, peripherals, exception);
        }
        let Some(vector) = vector else { return Err(Lockup { fault: Fault::VectorTable }) };
        self.r[14] = link;
        self.nvic.active |= bit(exception);
        self.ipsr = exception;
        self.process_stack = false;
        self.it = 0;
        self.it_before = 0;
        self.exclusive = false;
        self.event = true;
        self.fp_ready = false;
        self.counters.exceptions += 1;
        self.fetch_line = u32::MAX;
        self.start_at(vector);
        Ok(())
    }

    fn read_vector<P: Peripherals>(
        &mut self,
        memory: &mut Memory,
        peripherals: &mut P,
        exception: u16,
    ) -> Option<u32> {
        let address = self.scs.vtor.wrapping_add(4 * u32::from(exception));
        // Entries wait before they begin (`Core::stalls`); only a tail-chain gets here while flash is busy.
        self.cycle = self.cycle.max(memory.flash_interface.busy_until);
        self.read::<4, P>(memory, peripherals, address).ok()
    }

    /// PushStack.
    fn push_frame<P: Peripherals>(&mut self, memory: &mut Memory, peripherals: &mut P) -> Result<(), Fault> {
        let size = if self.fpca { 0x68 } else { 0x20 };
        let align = self.scs.aligns_stack() || self.fpca;
        let sp = self.r[13];
        let padded = align && sp & 4 != 0;
        let frame = sp.wrapping_sub(size) & if align { !7 } else { !3 };
        self.r[13] = frame;
        let xpsr = self.xpsr() & !(1 << 9) | u32::from(padded) << 9;
        let r = self.r;
        let basic = [r[0], r[1], r[2], r[3], r[12], r[14], self.pc, xpsr];
        for (word, value) in (0..).zip(basic) {
            self.write::<4, P>(memory, peripherals, frame.wrapping_add(4 * word), value)?;
        }
        if !self.fpca {
            return Ok(());
        }
        if self.scs.fpccr & 1 << 30 != 0 {
            self.note_lazy_frame(frame.wrapping_add(0x20));
            Ok(())
        } else {
            self.cycle += 17;
            self.store_float_frame(memory, peripherals, frame.wrapping_add(0x20))
        }
    }

    /// UpdateFPCCR: where the state goes should anyone touch it, and who may be told of a fault then.
    fn note_lazy_frame(&mut self, address: u32) {
        self.scs.fpcar = address & !7;
        let priority = self.execution_priority();
        let ready = |exception| self.nvic.priority_of(exception) < priority;
        let enabled = |exception: u16| self.scs.shcsr & 1 << (exception + 12) != 0;
        let bits = u32::from(ready(nvic::DEBUG_MONITOR)) << 8
            | u32::from(enabled(BUS_FAULT) && ready(BUS_FAULT)) << 6
            | u32::from(enabled(MEM_MANAGE) && ready(MEM_MANAGE)) << 5
            | u32::from(-1 < priority) << 4
            | u32::from(self.ipsr == 0) << 3
            | u32::from(!self.privileged()) << 1
            | 1;
        self.scs.fpccr = self.scs.fpccr & 0xC000_0000 | bits;
    }

    fn store_float_frame<P: Peripherals>(
        &mut self,
        memory: &mut Memory,
        peripherals: &mut P,
        address: u32,
    ) -> Result<(), Fault> {
        for n in 0..16_u32 {
            let value = self.s[n as usize];
            self.write::<4, P>(memory, peripherals, address.wrapping_add(4 * n), value)?;
        }
        self.write::<4, P>(memory, peripherals, address.wrapping_add(0x40), self.fpscr)
    }

    /// ExecuteFPCheck (B1.5.7): access rights, lazy state to its frame, a fresh context if none is active.
    #[inline(never)]
    pub(crate) fn prepare_float<P: Peripherals>(
        &mut self,
        memory: &mut Memory,
        peripherals: &mut P,
    ) -> Result<(), Fault> {
        match self.scs.cpacr >> 20 & 3 {
            3 => {}
            1 if self.privileged() => {}
            _ => return Err(Fault::NoCoprocessor),
        }
        if self.scs.lazy_active() {
            self.cycle += 17;
            let address = self.scs.fpcar;
            if self.store_float_frame(memory, peripherals, address).is_err() {
                return Err(Fault::LazyStacking);
            }
            self.scs.fpccr &= !1;
        }
        if self.scs.fpccr & 1 << 31 != 0 && !self.fpca {
            self.fpca = true;
            self.fpscr = self.scs.fpdscr;
        }
        self.fp_ready = true;
        Ok(())
    }

    /// ExceptionReturn (B1.5.8).
    pub(crate) fn exception_return<P: Peripherals>(
        &mut self,
        memory: &mut Memory,
        peripherals: &mut P,
        value: u32,
    ) -> Result<(), Lockup> {
        let returning = self.ipsr;
        let others = self.nvic.active & !bit(returning);
        let to_handler = value & 0xF == 1;
        let to_process_stack = value & 0xF == 0xD;
        let legal = value & 0xFFFF_FFE0 == 0xFFFF_FFE0 && matches!(value & 0xF, 1 | 9 | 0xD);
        let nested = if to_handler { others != 0 } else { others == 0 || self.scs.thread_from_any_level() };
        let consistent = legal && nested && self.nvic.active & bit(returning) != 0;
        self.nvic.active = others;
        if returning != nvic::NMI {
            self.faultmask = false;
        }
        self.nvic.pend_high_lines();
        if !consistent {
            return self.refuse_return(memory, peripherals, value);
        }
        if let Some(next) = self.exception_to_take() {
            self.cycle += cost::TAIL_CHAIN;
            return self.take(memory, peripherals, next, value);
        }
        self.cycle += cost::RETURN;
        self.exclusive = false;
        self.event = true;
        self.fp_ready = false;
        if to_process_stack {
            std::mem::swap(&mut self.r[13], &mut self.other_sp);
        }
        let frame = self.r[13];
        let popped = self.pop_frame(memory, peripherals, value & 0x10 == 0);
        let fault = match popped {
            Err(fault) => Some(fault),
            Ok(xpsr) if (xpsr & 0x1FF != 0) != to_handler => Some(Fault::InvalidPc),
            Ok(xpsr) => {
                self.set_nzcvq(xpsr);
                self.ge = (xpsr >> 16 & 15) as u8;
                self.it = ((xpsr >> 25 & 3) | (xpsr >> 10 & 0x3F) << 2) as u8;
                self.thumb = xpsr & 1 << 24 != 0;
                self.ipsr = (xpsr & 0x1FF) as u16;
                self.process_stack = to_process_stack;
                None
            }
        };
        if let Some(fault) = fault {
            // "PushStack() to negate PopStack()": the frame is where it was.
            self.r[13] = frame;
            if to_process_stack {
                std::mem::swap(&mut self.r[13], &mut self.other_sp);
            }
            return self.chain_fault(memory, peripherals, fault, value);
        }
        self.fpca = value & 0x10 == 0;
        self.fetch_line = u32::MAX;
        if self.ipsr == 0 && self.scs.sleeps_on_exit() {
            self.sleep = Sleep::Interrupt;
        }
        self.deadline = 0;
        Ok(())
    }

    fn refuse_return<P: Peripherals>(
        &mut self,
        memory: &mut Memory,
        peripherals: &mut P,
        value: u32,
    ) -> Result<(), Lockup> {
        self.chain_fault(memory, peripherals, Fault::InvalidPc, value & 0x0FFF_FFFF | 0xF000_0000)
    }

    /// A fault of an exception return: its handler runs on the frame that was to be popped.
    fn chain_fault<P: Peripherals>(
        &mut self,
        memory: &mut Memory,
        peripherals: &mut P,
        fault: Fault,
        link: u32,
    ) -> Result<(), Lockup> {
        let priority = self.execution_priority();
        let exception = self.record(fault, priority);
        if exception == HARD_FAULT && priority <= -1 {
            return Err(Lockup { fault });
        }
        self.take(memory, peripherals, exception, link)
    }

    /// PopStack; nothing changes on a fault. Returns the stacked xPSR.
    fn pop_frame<P: Peripherals>(
        &mut self,
        memory: &mut Memory,
        peripherals: &mut P,
        float: bool,
    ) -> Result<u32, Fault> {
        let frame = self.r[13];
        let mut words = [0; 8];
        for (n, word) in (0..).zip(&mut words) {
            *word = self
                .read::<4, P>(memory, peripherals, frame.wrapping_add(4 * n))
                .map_err(|_| Fault::Unstacking)?;
        }
        if float {
            if self.scs.lazy_active() {
                self.scs.fpccr &= !1;
            } else {
                self.cycle += 17;
                let base = frame.wrapping_add(0x20);
                for n in 0..16_u32 {
                    self.s[n as usize] = self
                        .read::<4, P>(memory, peripherals, base.wrapping_add(4 * n))
                        .map_err(|_| Fault::Unstacking)?;
                }
                self.fpscr = self
                    .read::<4, P>(memory, peripherals, base.wrapping_add(0x40))
                    .map_err(|_| Fault::Unstacking)?;
            }
        }
        let [r0, r1, r2, r3, r12, lr, pc, xpsr] = words;
        (self.r[0], self.r[1], self.r[2], self.r[3], self.r[12], self.r[14]) = (r0, r1, r2, r3, r12, lr);
        self.pc = pc & !1;
        let size = if float { 0x68 } else { 0x20 };
        let padded = xpsr & 1 << 9 != 0 && (self.scs.aligns_stack() || float);
        self.r[13] = frame.wrapping_add(size) | u32::from(padded) << 2;
        Ok(xpsr)
    }
}

//! The Cortex-M4F: ARMv7E-M with FPv4-SP, its NVIC, SysTick and DWT, as the ARMv7-M Architecture Reference Manual
//! (ARM DDI 0403E) describes them. Section numbers in this module are that manual's.
mod access;
mod alu;
mod cost;
mod decode;
mod exception;
mod execute;
mod fault;
mod float;
mod nvic;
mod op;
mod special;
mod status;
mod system;
mod systick;

pub use cost::Timing;
pub(crate) use execute::Exit;
pub use fault::Fault;
pub(crate) use fault::Lockup;
pub(crate) use nvic::SV_CALL;

use crate::{
    bus::Cycle,
    core::{
        nvic::Nvic,
        op::{Op, Slot},
        status::SystemControl,
        systick::SysTick,
    },
    memory::{FLASH_BASE, FLASH_BYTES, Memory, SRAM_BASE, SRAM_BYTES},
};

/// Figures the core keeps about its own work.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counters {
    /// Instructions executed, those whose condition failed included.
    pub instructions: u64,
    /// Cycles spent in WFI, WFE or sleep-on-exit.
    pub asleep: u64,
    /// Of those, cycles in which the core's clock stood still: all, unless DBGMCU_CR keeps it running.
    pub stopped: u64,
    /// Exceptions entered.
    pub exceptions: u64,
}

/// The processor core.
#[derive(Clone, Debug)]
pub struct Core {
    /// Where virtual time stands.
    pub cycle: Cycle,
    /// What it has done so far.
    pub counters: Counters,
    /// R0 to R15; R13 is the stack pointer in use, R15 while executing the address of the instruction plus 4.
    pub(crate) r: [u32; 16],
    /// The instruction to execute next.
    pub(crate) pc: u32,
    /// The stack pointer not in use: PSP while MSP is, and the reverse.
    pub(crate) other_sp: u32,
    pub(crate) n: bool,
    pub(crate) z: bool,
    pub(crate) c: bool,
    pub(crate) v: bool,
    pub(crate) q: bool,
    pub(crate) ge: u8,
    /// ITSTATE (B1.4.2).
    pub(crate) it: u8,
    /// ITSTATE before the instruction at `it_pc`, should it fault.
    it_before: u8,
    it_pc: u32,
    /// EPSR.T; 0 faults at the next instruction.
    pub(crate) thumb: bool,
    pub(crate) ipsr: u16,
    pub(crate) primask: bool,
    pub(crate) faultmask: bool,
    pub(crate) basepri: u8,
    /// CONTROL.nPRIV, SPSEL and FPCA.
    pub(crate) unprivileged: bool,
    pub(crate) process_stack: bool,
    pub(crate) fpca: bool,
    /// Single registers of the floating-point extension.
    pub(crate) s: [u32; 32],
    pub(crate) fpscr: u32,
    /// Floating-point instructions may run without a check (ExecuteFPCheck would do nothing).
    pub(crate) fp_ready: bool,
    /// Event register (B1.5.18).
    pub(crate) event: bool,
    pub(crate) sleep: Sleep,
    /// The local monitor holds an exclusive access (A3.4).
    exclusive: bool,
    pub(crate) nvic: Nvic,
    pub(crate) scs: SystemControl,
    pub(crate) systick: SysTick,
    /// When to leave the inner loop; slow paths bring it forward.
    pub(crate) deadline: Cycle,
    /// End of the last single load or store: one that follows at once is pipelined.
    pipelined: Cycle,
    fault_address: u32,
    /// A read of data waits for flash.
    waits_for_flash: bool,
    /// The line instructions come from (pessimistic timing).
    fetch_line: u32,
    /// Bit 27 of the addresses under which flash runs: 0x0800_0000 or, aliased, 0.
    flash_alias: u32,
    /// It just changed, so that what was decoded for the other one counts.
    alias_changed: bool,
    flash_slots: Box<[Slot]>,
    /// The same for the other alias; empty until that is used. Branches hold whole addresses, so each needs its own.
    other_slots: Box<[Slot]>,
    ram_slots: Box<[(u32, Slot)]>,
    pub(crate) timing: Timing,
}

/// Whether and why the core sleeps.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Sleep {
    Awake,
    /// WFI or sleep-on-exit: until an interrupt would preempt, PRIMASK disregarded.
    Interrupt,
    /// WFE: until the event register is set.
    Event,
    /// Lock-up (B1.5.15): until a reset, or a non-maskable interrupt if it is not that one's own.
    LockedUp,
}

impl Core {
    /// A core before its first reset.
    pub fn new(timing: Timing) -> Self {
        Self {
            flash_slots: vec![Slot::EMPTY; FLASH_BYTES as usize / 2].into(),
            ram_slots: vec![(0, Slot::EMPTY); SRAM_BYTES as usize / 2].into(),
            ..Self::empty(timing)
        }
    }

    /// All but the room for decoded instructions.
    fn empty(timing: Timing) -> Self {
        Self {
            cycle: 0,
            counters: Counters::default(),
            r: [0; 16],
            pc: 0,
            other_sp: 0,
            n: false,
            z: false,
            c: false,
            v: false,
            q: false,
            ge: 0,
            it: 0,
            it_before: 0,
            it_pc: 0,
            thumb: true,
            ipsr: 0,
            primask: false,
            faultmask: false,
            basepri: 0,
            unprivileged: false,
            process_stack: false,
            fpca: false,
            s: [0; 32],
            fpscr: 0,
            fp_ready: false,
            event: false,
            sleep: Sleep::Awake,
            exclusive: false,
            nvic: Nvic::default(),
            scs: SystemControl::default(),
            systick: SysTick::default(),
            deadline: 0,
            pipelined: 0,
            fault_address: 0,
            waits_for_flash: false,
            fetch_line: u32::MAX,
            flash_alias: 0,
            alias_changed: false,
            flash_slots: Box::default(),
            other_slots: Box::default(),
            ram_slots: Box::default(),
            timing,
        }
    }

    /// Register `number`, 0..=15; 15 is the address of the instruction to execute next.
    pub fn register(&self, number: u8) -> u32 {
        if number >= 15 { self.pc } else { self.r[usize::from(number)] }
    }

    /// Sets register `number` (0..=12, 14 or 15) as a debugger does; 15 is where execution goes on. Others stay.
    pub fn set_register(&mut self, number: u8, value: u32) {
        match number {
            0..=12 | 14 => self.r[usize::from(number)] = value,
            15 => (self.pc, self.it) = (value & !1, 0),
            _ => {}
        }
    }

    /// A single register of the floating-point extension as bits; 0 past S31.
    pub fn float_register(&self, number: u8) -> u32 {
        self.s.get(usize::from(number)).copied().unwrap_or(0)
    }

    /// Pends the non-maskable interrupt, which ends any sleep.
    pub(crate) fn pend_non_maskable(&mut self) {
        self.nvic.pending |= nvic::bit(nvic::NMI);
        self.event = true;
    }

    /// Number of the exception being handled (IPSR); 0 in thread mode.
    pub fn exception_number(&self) -> u16 {
        self.ipsr
    }

    /// Whether the core waits for an interrupt or an event.
    pub fn is_asleep(&self) -> bool {
        self.sleep != Sleep::Awake
    }

    /// Cycles in which the core was clocked: what CYCCNT counts.
    pub fn clocked(&self) -> Cycle {
        self.cycle - self.counters.stopped
    }

    /// APSR, IPSR and EPSR combined (B1.4.2).
    pub fn xpsr(&self) -> u32 {
        let it = u32::from(self.it);
        self.apsr() | u32::from(self.ipsr) | u32::from(self.thumb) << 24 | (it & 3) << 25 | (it >> 2) << 10
    }

    pub(crate) fn apsr(&self) -> u32 {
        u32::from(self.n) << 31
            | u32::from(self.z) << 30
            | u32::from(self.c) << 29
            | u32::from(self.v) << 28
            | u32::from(self.q) << 27
            | u32::from(self.ge) << 16
    }

    pub(crate) fn set_nzcvq(&mut self, value: u32) {
        self.n = value >> 31 & 1 != 0;
        self.z = value >> 30 & 1 != 0;
        self.c = value >> 29 & 1 != 0;
        self.v = value >> 28 & 1 != 0;
        self.q = value >> 27 & 1 != 0;
    }

    /// Thread mode with nPRIV set may not do everything.
    pub(crate) fn privileged(&self) -> bool {
        self.ipsr != 0 || !self.unprivileged
    }

    /// Address of the last data access without an answer.
    pub(crate) fn fault_address(&self) -> u32 {
        self.fault_address
    }

    /// Whether SVCall would preempt.
    pub(crate) fn can_call_supervisor(&self) -> bool {
        self.nvic.group_priority(self.nvic.priority_of(SV_CALL)) < self.execution_priority()
    }

    /// Starts an image that lives in RAM, as a debugger does: the vector table at its lowest address.
    pub(crate) fn start_in_ram(&mut self, memory: &Memory, vectors: u32, entry: u32) {
        self.scs.vtor = vectors & 0xFFFF_FF80;
        if let Some(word) = memory.peek(vectors, 4) {
            self.r[13] = u32::from_le_bytes([word[0], word[1], word[2], word[3]]) & !3;
        }
        self.start_at(entry | 1);
    }

    /// Bytes of the instruction at `pc`.
    fn length_at(&self, memory: &Memory, pc: u32) -> u32 {
        let (bytes, offset) = if pc >= SRAM_BASE {
            (&memory.sram, pc.wrapping_sub(SRAM_BASE))
        } else {
            (&memory.flash, pc & !FLASH_BASE)
        };
        let first = bytes.get(offset as usize + 1).copied().unwrap_or(0);
        if decode::is_wide(u16::from(first) << 8) { 4 } else { 2 }
    }

    /// Whether the core, awake, can do nothing before flash is done with an operation: a read of flash stalls the bus
    /// meanwhile (RM0090 section 3.6.1), be it for an instruction, for data or for the vector of an exception.
    pub(crate) fn stalls(&mut self, memory: &Memory) -> bool {
        if memory.flash_interface.busy_until <= self.cycle {
            self.waits_for_flash = false;
            return false;
        }
        let in_flash = |address: u32| address & !FLASH_BASE < FLASH_BYTES;
        self.waits_for_flash
            || in_flash(self.pc)
            || in_flash(self.scs.vtor) && self.exception_to_take().is_some()
    }

    /// The instruction at `pc` waits for flash and starts again then.
    pub(crate) fn wait_for_flash(&mut self) {
        self.take_back();
        self.waits_for_flash = true;
    }

    /// Whether a handler of a fault is active.
    pub(crate) fn handles_fault(&self) -> bool {
        let handlers = [nvic::HARD_FAULT, nvic::MEM_MANAGE, nvic::BUS_FAULT, nvic::USAGE_FAULT];
        handlers.iter().any(|handler| self.nvic.active & nvic::bit(*handler) != 0)
    }

    /// Stands still.
    pub(crate) fn lock_up(&mut self) {
        self.sleep = Sleep::LockedUp;
    }

    /// Lock-up ends for a non-maskable interrupt that preempts (B1.5.15).
    pub(crate) fn leaves_lockup(&self) -> bool {
        self.nvic.pending & nvic::bit(nvic::NMI) != 0 && self.execution_priority() > -2
    }

    /// Forgets what was decoded from flash that has changed.
    pub(crate) fn follow_flash(&mut self, memory: &mut Memory) {
        for changed in memory.take_changes() {
            // An instruction may start one halfword earlier.
            let first = (changed.start as usize).saturating_sub(2) / 2;
            let last = (changed.end as usize).div_ceil(2).min(self.flash_slots.len());
            let mut executed: Option<(u32, u32)> = None;
            for alias in [&mut self.flash_slots, &mut self.other_slots] {
                let slots = alias.get_mut(first..last).unwrap_or_default();
                for (slot, at) in slots.iter_mut().zip((first as u32 * 2..).step_by(2)) {
                    if slot.op != Op::Undecoded {
                        let (from, to) = executed.unwrap_or((at, at));
                        executed = Some((from.min(at), to.max(at + 2)));
                        *slot = Slot::EMPTY;
                    }
                }
            }
            if let Some((start, end)) = executed {
                memory.suspect_fetches(start..end);
            }
        }
    }
}

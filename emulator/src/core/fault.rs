//! Faults: what they set, who handles them, and when nobody can (ARMv7-M ARM B1.5.14, B1.5.15).
use crate::{
    bus::Peripherals,
    core::{
        Core,
        nvic::{BUS_FAULT, HARD_FAULT, MEM_MANAGE, USAGE_FAULT},
    },
    memory::Memory,
};

/// Why an instruction did not complete (B1.5.14).
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum Fault {
    /// UFSR.UNDEFINSTR.
    #[error("undefined instruction")]
    Undefined,
    /// UFSR.INVSTATE.
    #[error("execution outside Thumb state")]
    InvalidState,
    /// UFSR.INVPC.
    #[error("integrity check of an exception return failed")]
    InvalidPc,
    /// UFSR.NOCP.
    #[error("coprocessor missing or disabled")]
    NoCoprocessor,
    /// UFSR.UNALIGNED.
    #[error("unaligned access")]
    Unaligned,
    /// UFSR.DIVBYZERO.
    #[error("division by zero")]
    DivideByZero,
    /// MMFSR.IACCVIOL: execute-never region.
    #[error("instruction fetch from an execute-never region")]
    InstructionAccess,
    /// BFSR.IBUSERR.
    #[error("instruction fetch where nothing lies")]
    InstructionBus,
    /// BFSR.PRECISERR.
    #[error("data access without an answer")]
    DataBus,
    /// BFSR.STKERR.
    #[error("stacking for an exception failed")]
    Stacking,
    /// BFSR.UNSTKERR.
    #[error("unstacking for an exception return failed")]
    Unstacking,
    /// BFSR.LSPERR.
    #[error("lazy stacking of floating-point state failed")]
    LazyStacking,
    /// HFSR.VECTTBL.
    #[error("reading the vector table failed")]
    VectorTable,
    /// HFSR.DEBUGEVT: BKPT with no debugger attached.
    #[error("breakpoint without a debugger")]
    Breakpoint,
    /// None that a program sees: the access waits for flash, and the instruction starts again when that is done.
    #[error("flash is busy")]
    FlashBusy,
    /// SVC at a priority that SVCall cannot preempt.
    #[error("supervisor call at too high a priority")]
    SupervisorCall,
}

/// The core stopped for good (B1.5.15).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Lockup {
    /// The fault that found no handler.
    pub(crate) fault: Fault,
}

impl Fault {
    /// The exception it raises, and its bit in CFSR.
    fn target(self) -> (u16, u32) {
        match self {
            Self::InstructionAccess => (MEM_MANAGE, 0),
            Self::InstructionBus => (BUS_FAULT, 8),
            Self::DataBus => (BUS_FAULT, 9),
            Self::Unstacking => (BUS_FAULT, 11),
            Self::Stacking => (BUS_FAULT, 12),
            Self::LazyStacking => (BUS_FAULT, 13),
            Self::Undefined => (USAGE_FAULT, 16),
            Self::InvalidState => (USAGE_FAULT, 17),
            Self::InvalidPc => (USAGE_FAULT, 18),
            Self::NoCoprocessor => (USAGE_FAULT, 19),
            Self::Unaligned => (USAGE_FAULT, 24),
            Self::DivideByZero => (USAGE_FAULT, 25),
            Self::VectorTable | Self::Breakpoint | Self::SupervisorCall | Self::FlashBusy => (HARD_FAULT, 0),
        }
    }
}

impl Core {
    /// Enters the handler of a fault of the instruction at `pc`.
    pub(crate) fn take_fault<P: Peripherals>(
        &mut self,
        memory: &mut Memory,
        peripherals: &mut P,
        fault: Fault,
    ) -> Result<(), Lockup> {
        self.take_back();
        let priority = self.execution_priority();
        if fault == Fault::DataBus && priority < 0 && self.scs.ignores_bus_faults() {
            // The access reads as zero or is lost, and the instruction is over.
            self.pc = self.pc.wrapping_add(self.length_at(memory, self.pc));
            return Ok(());
        }
        let exception = self.record(fault, priority);
        if exception == HARD_FAULT && priority <= -1 {
            return Err(Lockup { fault });
        }
        self.enter(memory, peripherals, exception)
    }

    /// Forgets the attempt to execute the instruction at `pc`.
    pub(crate) fn take_back(&mut self) {
        if self.it_before != 0 && self.it_pc == self.pc {
            self.it = self.it_before;
        }
        self.it_before = 0;
    }

    /// Sets the status bits of a fault and finds the exception that handles it at `priority` (B1.5.4, escalation).
    pub(super) fn record(&mut self, fault: Fault, priority: i16) -> u16 {
        let (exception, status) = fault.target();
        match fault {
            Fault::VectorTable => self.scs.hfsr |= 1 << 1,
            Fault::Breakpoint => {
                self.scs.hfsr |= 1 << 31;
                self.scs.dfsr |= 1 << 1;
            }
            Fault::SupervisorCall => self.scs.hfsr |= 1 << 30,
            _ => self.scs.cfsr |= 1 << status,
        }
        if fault == Fault::DataBus {
            self.scs.cfsr |= 1 << 15;
            self.scs.bfar = self.fault_address;
        }
        if exception == HARD_FAULT {
            return HARD_FAULT;
        }
        let enabled = self.scs.shcsr & 1 << (exception + 12) != 0;
        if enabled && self.nvic.group_priority(self.nvic.priority_of(exception)) < priority {
            return exception;
        }
        self.scs.hfsr |= 1 << 30;
        HARD_FAULT
    }
}

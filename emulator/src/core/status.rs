//! Registers of the system control block that hold state of their own (B3.2).

/// CCR.STKALIGN, set at reset on the Cortex-M4.
const STKALIGN: u32 = 1 << 9;

/// System control: configuration and fault status.
#[derive(Clone, Debug)]
pub(crate) struct SystemControl {
    pub(crate) vtor: u32,
    pub(crate) scr: u32,
    pub(crate) ccr: u32,
    /// Enables of SHCSR, bits 18..16.
    pub(crate) shcsr: u32,
    pub(crate) cfsr: u32,
    pub(crate) hfsr: u32,
    pub(crate) dfsr: u32,
    pub(crate) mmfar: u32,
    pub(crate) bfar: u32,
    pub(crate) cpacr: u32,
    pub(crate) fpccr: u32,
    pub(crate) fpcar: u32,
    pub(crate) fpdscr: u32,
    /// DEMCR; only TRCENA and the vector catch bits are kept.
    pub(crate) demcr: u32,
    pub(crate) dwt_control: u32,
    /// CYCCNT minus the cycles the core was awake, while counting; the count itself otherwise.
    pub(crate) cycle_count: u32,
}

impl Default for SystemControl {
    fn default() -> Self {
        Self {
            vtor: 0,
            scr: 0,
            ccr: STKALIGN,
            shcsr: 0,
            cfsr: 0,
            hfsr: 0,
            dfsr: 0,
            mmfar: 0,
            bfar: 0,
            cpacr: 0,
            // ASPEN and LSPEN.
            fpccr: 0xC000_0000,
            fpcar: 0,
            fpdscr: 0,
            demcr: 0,
            dwt_control: 0x4000_0000,
            cycle_count: 0,
        }
    }
}

impl SystemControl {
    pub(crate) fn unaligned_traps(&self) -> bool {
        self.ccr & 1 << 3 != 0
    }

    pub(crate) fn division_traps(&self) -> bool {
        self.ccr & 1 << 4 != 0
    }

    pub(crate) fn ignores_bus_faults(&self) -> bool {
        self.ccr & 1 << 8 != 0
    }

    pub(crate) fn aligns_stack(&self) -> bool {
        self.ccr & STKALIGN != 0
    }

    pub(crate) fn thread_from_any_level(&self) -> bool {
        self.ccr & 1 != 0
    }

    pub(crate) fn sends_event_on_pend(&self) -> bool {
        self.scr & 1 << 4 != 0
    }

    pub(crate) fn sleeps_on_exit(&self) -> bool {
        self.scr & 1 << 1 != 0
    }

    /// LSPACT: the FP frame on the stack is still to be filled.
    pub(crate) fn lazy_active(&self) -> bool {
        self.fpccr & 1 != 0
    }

    pub(crate) fn counts_cycles(&self) -> bool {
        self.dwt_control & 1 != 0 && self.demcr & 1 << 24 != 0
    }
}

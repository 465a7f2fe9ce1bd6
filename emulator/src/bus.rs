//! The contract between the core and everything outside it.

use crate::memory::Memory;

/// A point in virtual time: cycles of the core clock (HCLK) since power-up. Where the core clock changes, the count
/// goes on at the new rate; peripherals keep the relation to seconds.
pub type Cycle = u64;

/// "Never", as a point in time.
pub const NEVER: Cycle = u64::MAX;

/// Width of one access.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Width {
    /// 8 bits.
    Byte,
    /// 16 bits.
    Half,
    /// 32 bits.
    Word,
}

/// Who drives the bus.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Master {
    /// The core.
    Core,
    /// One of the DMA controllers, 1 or 2.
    Dma(u8),
}

/// One access to an address that is not plain memory.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Access {
    /// When.
    pub at: Cycle,
    /// Where.
    pub address: u32,
    /// How wide.
    pub width: Width,
    /// The instruction that does it, for messages; 0 for DMA.
    pub pc: u32,
}

/// Why an access has no answer. The core takes a BusFault (precise); what a DMA controller does stands with it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum AccessError {
    /// Nothing lies there.
    #[error("nothing lies at {0:#010x}")]
    Nothing(u32),
    /// Something lies there on the chip that this emulator does not have.
    #[error("{1} at {0:#010x} is not emulated")]
    NotEmulated(u32, &'static str),
    /// It can only be read.
    #[error("{1} at {0:#010x} cannot be written")]
    ReadOnly(u32, &'static str),
    /// Unprivileged code may not.
    #[error("unprivileged code reaches for the system control space at {0:#010x}")]
    Privileged(u32),
}

impl AccessError {
    /// Where.
    pub fn address(self) -> u32 {
        match self {
            Self::Nothing(at) | Self::NotEmulated(at, _) | Self::ReadOnly(at, _) | Self::Privileged(at) => at,
        }
    }
}

/// Everything at 0x4000_0000 to 0x5FFF_FFFF, and writes to flash memory (programming).
///
/// The core calls [`advance`](Self::advance) whenever its clock reaches [`next_event`](Self::next_event), so a
/// peripheral costs nothing while nothing happens in it.
pub trait Peripherals {
    /// Reads. `memory` is there for side effects (DMA, flash).
    ///
    /// # Errors
    /// [`AccessError`].
    fn read(&mut self, memory: &mut Memory, access: Access) -> Result<u32, AccessError>;
    /// Writes the low bits of `value`.
    ///
    /// # Errors
    /// [`AccessError`].
    fn write(&mut self, memory: &mut Memory, access: Access, value: u32) -> Result<(), AccessError>;
    /// When something happens next without an access; [`NEVER`] where nothing will. Cheap: called after every access.
    fn next_event(&self) -> Cycle;
    /// Lets everything up to and including `now` happen.
    fn advance(&mut self, memory: &mut Memory, now: Cycle);
    /// Levels of the interrupt lines; bit n is IRQ n (RM0090 table 62). Cheap: called after every access and advance.
    fn interrupt_lines(&self) -> u128;
    /// Whether the core's clock goes on while it sleeps, so that a debugger finds it (DBGMCU_CR.DBG_SLEEP).
    fn clocks_core_in_sleep(&self) -> bool {
        false
    }
    /// Level of the line of the non-maskable interrupt.
    fn non_maskable(&self) -> bool {
        false
    }
    /// Name of what lies at an address, for messages.
    fn name_at(&self, address: u32) -> Option<String> {
        let _ = address;
        None
    }
    /// An event that wakes WFE came from outside since last asked (RM0090 section 12.2.3).
    fn take_event(&mut self) -> bool {
        false
    }
    /// Cycles that the core waits for an access beyond the one that the instruction takes, in pessimistic timing.
    fn wait_states(&self, address: u32) -> Cycle {
        let _ = address;
        0
    }
    /// Whether reading `address`, which has just been read, again and again from `at` on gives the same and changes nothing
    /// until [`next_event`](Self::next_event), if nothing is written. No where that is not known.
    fn rests(&self, address: u32, at: Cycle) -> bool {
        let _ = (address, at);
        false
    }
    /// Which of the two figures of the cycle model is wanted; told once, before anything else.
    fn set_pessimistic(&mut self, pessimistic: bool) {
        let _ = pessimistic;
    }
    /// Whether the chip resets now, once; after it the machine calls [`reset`](Self::reset).
    fn take_reset(&mut self) -> bool;
    /// A system reset: registers to their reset values (those that survive one stay), memory is left alone.
    fn reset(&mut self, memory: &mut Memory, now: Cycle);
    /// The core asked for a reset (AIRCR.SYSRESETREQ).
    fn request_reset(&mut self);
}

//! The whole machine: core, memories and peripherals under one clock.
mod faults;
mod image;
mod kind;
mod semihosting;

pub use faults::FaultRecord;

use crate::{
    bus::{Access, AccessError, Cycle, NEVER, Peripherals},
    core::{Core, Exit, Fault, Lockup, Sleep, Timing},
    memory::Memory,
};

pub use image::{ImageError, flash_content, loaded, occupied, symbol_address, symbols};

/// Why [`Machine::run_until`] returned.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum Stop {
    /// Virtual time has reached what was asked for.
    #[error("time is up")]
    ReachedTime,
    /// The program ended through semihosting with this code (SYS_EXIT, SYS_EXIT_EXTENDED).
    #[error("the program exited with code {0}")]
    Exit(i32),
    /// A fault in a handler that may not be interrupted (B1.5.15), with [`Machine::stop_at_lockups`] set. Hardware stands
    /// still until reset.
    #[error(
        "lock-up at {pc:#010x}: {fault} (CFSR {cfsr:#010x}, HFSR {hfsr:#010x}, BFAR {bfar:#010x}){}",
        faults::told(.chain)
    )]
    Lockup {
        /// Instruction that faulted.
        pc: u32,
        /// How.
        fault: Fault,
        /// Configurable Fault Status Register.
        cfsr: u32,
        /// HardFault Status Register.
        hfsr: u32,
        /// BusFault Address Register.
        bfar: u32,
        /// The faults that led there, the first one first.
        chain: Vec<FaultRecord>,
    },
    /// BKPT, with [`Machine::stop_at_breakpoints`] set.
    #[error("breakpoint {code} at {pc:#010x}")]
    Breakpoint {
        /// The instruction itself.
        pc: u32,
        /// Its immediate.
        code: u8,
    },
    /// An instruction this emulator does not have.
    #[error("the instruction {encoding:#010x} at {pc:#010x} is not implemented")]
    Unimplemented {
        /// Where.
        pc: u32,
        /// Both halfwords, the first one high.
        encoding: u32,
    },
}

/// Core, memories and peripherals. A clone goes on by itself from the same instant.
#[derive(Clone, Debug)]
pub struct Machine<P> {
    /// The processor.
    pub core: Core,
    /// Flash and RAM.
    pub memory: Memory,
    /// Everything else.
    pub peripherals: P,
    /// Whether BKPT 0xAB asks the host (as with a debug probe attached) or faults (as without).
    pub semihosting: bool,
    /// Whether other breakpoints stop the machine (as with a debug probe attached) or fault.
    pub stop_at_breakpoints: bool,
    /// Whether a lock-up stops the machine. Else time goes on as it does in hardware, until something resets the chip.
    pub stop_at_lockups: bool,
    /// What the program wrote through semihosting.
    pub output: Vec<u8>,
    /// The last fault taken.
    pub last_fault: Option<FaultRecord>,
    /// Faults of which none has been returned from, the first one first.
    pub fault_chain: Vec<FaultRecord>,
    /// Core clock, for semihosting's clock; Hz.
    pub clock_hz: u64,
    symbols: image::Symbols,
    /// Level of the non-maskable interrupt's line when last looked at.
    non_maskable: bool,
}

/// Nothing outside the core: for bare programs, and for test images built for other Cortex-M boards (linked at 0, RAM
/// at 0x2000_0000) that stay away from peripherals.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct NoPeripherals {
    reset: bool,
}

impl Peripherals for NoPeripherals {
    fn read(&mut self, _: &mut Memory, access: Access) -> Result<u32, AccessError> {
        Err(AccessError::Nothing(access.address))
    }

    fn write(&mut self, _: &mut Memory, access: Access, _: u32) -> Result<(), AccessError> {
        Err(AccessError::Nothing(access.address))
    }

    fn next_event(&self) -> Cycle {
        NEVER
    }

    fn advance(&mut self, _: &mut Memory, _: Cycle) {}

    fn interrupt_lines(&self) -> u128 {
        0
    }

    fn take_reset(&mut self) -> bool {
        std::mem::take(&mut self.reset)
    }

    fn reset(&mut self, _: &mut Memory, _: Cycle) {}

    fn request_reset(&mut self) {
        self.reset = true;
    }
}

impl<P: Peripherals> Machine<P> {
    /// A machine with blank flash; `seed` makes the noise in RAM at power-up. Load an image before running.
    pub fn new(mut peripherals: P, timing: Timing, seed: u64) -> Self {
        peripherals.set_pessimistic(timing == Timing::Pessimistic);
        Self {
            core: Core::new(timing),
            memory: Memory::new(seed),
            peripherals,
            semihosting: true,
            stop_at_breakpoints: false,
            stop_at_lockups: false,
            output: Vec::new(),
            last_fault: None,
            fault_chain: Vec::new(),
            clock_hz: 168_000_000,
            symbols: image::Symbols::default(),
            non_maskable: false,
        }
    }

    /// Where virtual time stands; cycles of the core clock.
    pub fn time(&self) -> Cycle {
        self.core.cycle
    }

    /// Runs until virtual time reaches `limit`, or something stops the machine. Time may end a few cycles late, by
    /// the length of one instruction or exception entry.
    pub fn run_until(&mut self, limit: Cycle) -> Stop {
        loop {
            self.settle();
            if self.core.cycle >= limit {
                return Stop::ReachedTime;
            }
            if self.core.sleep != Sleep::Awake {
                self.sleep(limit);
                continue;
            }
            if self.core.stalls(&self.memory) {
                self.stall(limit);
                continue;
            }
            let result = match self.core.exception_to_take() {
                Some(exception) => self.core.enter(&mut self.memory, &mut self.peripherals, exception),
                None if !self.core.thumb => {
                    // The instruction at the target faults (B1.5.14); it is still to be executed.
                    self.fault(Fault::InvalidState)
                }
                None => {
                    self.core.deadline =
                        limit.min(self.peripherals.next_event()).min(self.core.systick.next_event());
                    match self.core.run(&mut self.memory, &mut self.peripherals) {
                        Exit::Deadline => continue,
                        Exit::Fault(fault) => self.fault(fault),
                        Exit::SupervisorCall => self.supervisor_call(),
                        Exit::ExceptionReturn(value) => {
                            self.core.exception_return(&mut self.memory, &mut self.peripherals, value)
                        }
                        Exit::Breakpoint(0xAB) if self.semihosting => match self.semihost() {
                            Some(code) => return Stop::Exit(code),
                            None => Ok(()),
                        },
                        Exit::Breakpoint(code) if self.stop_at_breakpoints => {
                            return Stop::Breakpoint { pc: self.core.pc, code };
                        }
                        Exit::Breakpoint(_) => self.fault(Fault::Breakpoint),
                        Exit::Unimplemented => {
                            return Stop::Unimplemented { pc: self.core.pc, encoding: self.encoding_at_pc() };
                        }
                    }
                }
            };
            if let Err(lockup) = result
                && let Some(stop) = self.lock_up(lockup)
            {
                return stop;
            }
        }
    }

    /// Lets everything outside the core catch up with its clock.
    fn settle(&mut self) {
        let now = self.core.cycle;
        if self.peripherals.next_event() <= now {
            self.peripherals.advance(&mut self.memory, now);
            self.memory.flash_interface.forget_recent();
        }
        let lines = self.peripherals.interrupt_lines();
        if lines != self.core.nvic.lines() {
            self.core.set_lines(lines);
        }
        let non_maskable = self.peripherals.non_maskable();
        if non_maskable && !std::mem::replace(&mut self.non_maskable, non_maskable) {
            self.core.pend_non_maskable();
        }
        self.non_maskable = non_maskable;
        if self.core.systick.next_event() <= now {
            self.core.count_systick();
        }
        if self.peripherals.take_reset() {
            self.core.reset(&mut self.memory);
            self.peripherals.reset(&mut self.memory, now);
            self.core.set_lines(self.peripherals.interrupt_lines());
        }
        if self.peripherals.take_event() {
            self.core.event = true;
        }
        if self.memory.has_changes() {
            self.core.follow_flash(&mut self.memory);
        }
    }

    /// Skips to whatever may wake the core.
    fn sleep(&mut self, limit: Cycle) {
        let core = &mut self.core;
        let wakes = match core.sleep {
            // Unlike WFI, WFE waits for what PRIMASK lets through (B1.5.18).
            Sleep::Event => std::mem::take(&mut core.event) || core.exception_to_take().is_some(),
            Sleep::LockedUp => core.leaves_lockup(),
            _ => core.wakes(),
        };
        if wakes {
            core.sleep = Sleep::Awake;
            return;
        }
        let next =
            limit.min(self.peripherals.next_event()).min(core.systick.next_event()).max(core.cycle + 1);
        if core.sleep != Sleep::LockedUp {
            core.counters.asleep += next - core.cycle;
            if !self.peripherals.clocks_core_in_sleep() {
                core.counters.stopped += next - core.cycle;
            }
        }
        core.cycle = next;
    }

    /// Waits for flash, no longer than until something else happens: a watchdog, say, that resets the chip in the middle of
    /// an erase.
    fn stall(&mut self, limit: Cycle) {
        let until = self.memory.flash_interface.busy_until;
        let next = limit.min(self.peripherals.next_event()).min(self.core.systick.next_event()).min(until);
        self.core.cycle = next.max(self.core.cycle + 1);
    }

    fn fault(&mut self, fault: Fault) -> Result<(), Lockup> {
        if fault == Fault::FlashBusy {
            self.core.wait_for_flash();
            return Ok(());
        }
        self.note_fault(fault);
        self.core.take_fault(&mut self.memory, &mut self.peripherals, fault)
    }

    fn supervisor_call(&mut self) -> Result<(), Lockup> {
        let core = &mut self.core;
        if core.can_call_supervisor() {
            return core.enter(&mut self.memory, &mut self.peripherals, crate::core::SV_CALL);
        }
        self.fault(Fault::SupervisorCall)
    }

    /// Both halfwords of the instruction to execute.
    fn encoding_at_pc(&mut self) -> u32 {
        let half = |at: u32| {
            self.memory.peek(at, 2).map_or(0xFFFF, |bytes| u32::from(bytes[0]) | u32::from(bytes[1]) << 8)
        };
        half(self.core.pc) << 16 | half(self.core.pc.wrapping_add(2))
    }
}

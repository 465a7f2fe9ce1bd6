//! Faults that were taken, kept so that a test can say what went wrong, and the lock-up at their end.
use std::fmt;

use crate::{
    Machine, Stop,
    bus::{Cycle, Peripherals},
    core::{Fault, Lockup},
};

/// Faults of a chain that are kept: a handler that faults ends in a lock-up at the third.
const MOST_FAULTS: usize = 8;

/// A fault taken.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FaultRecord {
    /// When.
    pub at: Cycle,
    /// Instruction that faulted.
    pub pc: u32,
    /// How.
    pub fault: Fault,
    /// Address of a data access (BFAR); meaningful for [`Fault::DataBus`].
    pub address: u32,
    /// What lies there, where that has a name.
    pub place: Option<String>,
}

impl fmt::Display for FaultRecord {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} at {:#010x}, cycle {}", self.fault, self.pc, self.at)?;
        if self.fault == Fault::DataBus {
            write!(f, ", to {:#010x}", self.address)?;
            if let Some(place) = &self.place {
                write!(f, " ({place})")?;
            }
        }
        Ok(())
    }
}

/// The faults behind a lock-up, for its message.
pub(super) fn told(chain: &[FaultRecord]) -> String {
    chain.iter().enumerate().fold(String::new(), |text, (index, fault)| {
        text + if index == 0 { "; it began with " } else { ", then " } + &fault.to_string()
    })
}

impl<P: Peripherals> Machine<P> {
    /// Keeps what is known of a fault.
    pub(super) fn note_fault(&mut self, fault: Fault) {
        let core = &self.core;
        let address = core.fault_address();
        let place = if fault == Fault::DataBus { self.peripherals.name_at(address) } else { None };
        let record = FaultRecord { at: core.cycle, pc: core.pc, fault, address, place };
        if !core.handles_fault() {
            self.fault_chain.clear();
        }
        if self.fault_chain.len() < MOST_FAULTS {
            self.fault_chain.push(record.clone());
        }
        self.last_fault = Some(record);
    }

    /// The core stands still (B1.5.15): a mistake of the program. Answers with the stop, where one is wanted.
    pub(super) fn lock_up(&mut self, lockup: Lockup) -> Option<Stop> {
        let core = &mut self.core;
        core.lock_up();
        let stop = Stop::Lockup {
            pc: core.pc,
            fault: lockup.fault,
            cfsr: core.scs.cfsr,
            hfsr: core.scs.hfsr,
            bfar: core.scs.bfar,
            chain: self.fault_chain.clone(),
        };
        self.memory.report(core.cycle, core.pc, stop.to_string());
        self.stop_at_lockups.then_some(stop)
    }

    /// The last fault, if the program is still in its handler: most handlers end in a loop.
    pub fn standing_fault(&self) -> Option<&FaultRecord> {
        self.core.handles_fault().then_some(self.fault_chain.first()).flatten()
    }
}

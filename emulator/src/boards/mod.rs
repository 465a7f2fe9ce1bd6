//! Boards: which pin of the chip leads to which device.

mod speedybee_f405_v3;

use crate::{Machine, Stop, bus::Cycle, chip::Chip};

pub use speedybee_f405_v3::{MotorSignal, MotorUpdate, SpeedyBeeF405V3};

/// [`Machine::run_until`] of this board's machine, compiled here together with all that it calls. A caller in another
/// crate would compile the generic function anew, without a chance to see into the rest of the emulator.
#[inline(never)]
pub fn run_until(machine: &mut Machine<Chip<SpeedyBeeF405V3>>, limit: Cycle) -> Stop {
    machine.run_until(limit)
}

//! Whether a block can be reached: its clock and its reset (RM0090 section 7.3).

use super::clock::Apb;
use super::map::{Block, ENABLE_REGISTERS};
use super::{Board, Chip};
use crate::bus::{Access, Cycle, Master};
use crate::memory::Memory;

impl<B: Board> Chip<B> {
    /// Whether the clock of a block is on and its reset released; says so if not.
    #[inline(always)]
    pub(super) fn reachable(
        &self,
        memory: &mut Memory,
        block: Block,
        offset: u32,
        access: Access,
        verb: &str,
        master: Master,
    ) -> bool {
        let gate = match block {
            Block::Adc if offset < 0x300 => Some((4, 8 + (offset >> 8) as u8)),
            Block::Adc if self.rcc.enable[4] & 0x700 == 0 => Some((4, 8)),
            _ => block.gate(),
        };
        let Some(gate) = gate else { return true };
        if self.open(gate, access.at) {
            return true;
        }
        self.refuse(memory, block, gate, access, verb, master);
        false
    }

    /// Whether a block with one gate can be reached at `at`; if so, it stays that way until something is written.
    pub(super) fn answers(&self, block: Block, at: Cycle) -> bool {
        block.gate().is_some_and(|gate| self.open(gate, at))
    }

    #[inline(always)]
    fn open(&self, gate: (usize, u8), at: Cycle) -> bool {
        let (fresh, since) = self.fresh_gates[gate.0];
        self.rcc.enabled(gate)
            && self.rcc.reset[gate.0] >> gate.1 & 1 == 0
            && (fresh >> gate.1 & 1 == 0 || at >= since + self.gate_cycles(gate.0))
    }

    /// From the bit in an enable register to the clock (ES0182, "Delay after an RCC peripheral clock enabling"): two cycles of
    /// AHB, or one of AHB and one of APB.
    fn gate_cycles(&self, register: usize) -> Cycle {
        match register {
            3 => 1 + u64::from(self.clock.apb_divider(Apb::One)),
            4 => 1 + u64::from(self.clock.apb_divider(Apb::Two)),
            _ => 2,
        }
    }

    /// Says why a block cannot be reached.
    #[cold]
    fn refuse(
        &self,
        memory: &mut Memory,
        block: Block,
        gate: (usize, u8),
        access: Access,
        verb: &str,
        master: Master,
    ) {
        let who = if let Master::Dma(n) = master { format!(" by DMA{n}") } else { String::new() };
        let why = if self.rcc.reset[gate.0] >> gate.1 & 1 == 1 {
            "it is held in reset".into()
        } else if self.rcc.enabled(gate) {
            let cycles = self.gate_cycles(gate.0);
            format!(
                "its clock, just switched on, is not there yet: that takes {cycles} cycles (read the register back)"
            )
        } else {
            format!("its clock is off ({} bit {})", ENABLE_REGISTERS[gate.0], gate.1)
        };
        memory.report(access.at, access.pc, format!("{} is {verb}{who} while {why}", block.name()));
    }
}

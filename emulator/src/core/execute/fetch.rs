//! Where instructions come from when they have not been decoded in place: flash, SRAM, or nowhere.
use crate::{
    core::{
        Core, Exit, Fault, decode,
        op::{Op, Slot},
    },
    memory::{FLASH_BASE, FLASH_BYTES, Memory, SRAM_BASE},
};

impl Core {
    /// Decodes at `pc`, `offset` into flash.
    #[cold]
    #[inline(never)]
    pub(super) fn decode_from_flash(&mut self, memory: &mut Memory, pc: u32, offset: u32) -> Slot {
        memory.check_fetch(self.cycle, offset);
        let half = |at: u32| {
            let at = at as usize;
            memory.flash.get(at..at + 2).map_or(0xFFFF, |bytes| u16::from_le_bytes([bytes[0], bytes[1]]))
        };
        decode::decode(pc, half(offset), half(offset + 2))
    }

    /// Code in SRAM; decoded anew wherever memory differs from what was decoded.
    #[inline(never)]
    pub(super) fn fetch_from_ram(&mut self, memory: &Memory, pc: u32) -> Result<Slot, Exit> {
        let offset = pc.wrapping_sub(SRAM_BASE) as usize;
        let Some(bytes) = memory.sram.get(offset..offset + 2) else {
            return Err(self.fetch_elsewhere(pc));
        };
        let first = u16::from_le_bytes([bytes[0], bytes[1]]);
        let second = match memory.sram.get(offset + 2..offset + 4) {
            Some(bytes) if decode::is_wide(first) => u16::from_le_bytes([bytes[0], bytes[1]]),
            None if decode::is_wide(first) => return Err(Exit::Fault(Fault::InstructionBus)),
            _ => 0,
        };
        let raw = u32::from(first) << 16 | u32::from(second);
        let Some(entry) = self.ram_slots.get_mut(offset >> 1) else {
            return Err(Exit::Fault(Fault::InstructionBus));
        };
        if entry.0 != raw || entry.1.op == Op::Undecoded {
            *entry = (raw, decode::decode(pc, first, second));
        }
        Ok(entry.1)
    }

    /// Neither SRAM nor flash as it was: the other alias of flash, or a fault.
    fn fetch_elsewhere(&mut self, pc: u32) -> Exit {
        if pc & !FLASH_BASE < FLASH_BYTES {
            self.flash_alias = pc & FLASH_BASE;
            self.alias_changed = true;
            self.deadline = 0;
            return Exit::Deadline;
        }
        // Peripheral, device and system space are XN (B3.1, table B3-1).
        match pc >> 29 {
            2 | 5..=7 => Exit::Fault(Fault::InstructionAccess),
            _ => Exit::Fault(Fault::InstructionBus),
        }
    }
}

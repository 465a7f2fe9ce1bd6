//! Loads and stores: memory at once, everything else through slower and slower paths (B3.1, RM0090 section 2.3).
use crate::{
    bus::{Access, AccessError, Peripherals, Width},
    core::{
        Core, Fault,
        cost::{Timing, contention},
    },
    memory::{CCM_BASE, CCM_BYTES, FLASH_BASE, FLASH_BYTES, Memory, SRAM_BASE, SRAM_BYTES},
};

/// Reads a little-endian value of up to four bytes; `None` past the end.
#[inline(always)]
fn load<const N: usize>(bytes: &[u8], offset: u32) -> Option<u32> {
    let offset = offset as usize;
    let slice = bytes.get(offset..offset + N)?;
    let mut word = [0; 4];
    word[..N].copy_from_slice(slice);
    Some(u32::from_le_bytes(word))
}

#[inline(always)]
fn store<const N: usize>(bytes: &mut [u8], offset: u32, value: u32) -> Option<()> {
    let offset = offset as usize;
    bytes.get_mut(offset..offset + N)?.copy_from_slice(&value.to_le_bytes()[..N]);
    Some(())
}

/// Reads `N` bytes of SRAM; `None` where that is not all SRAM, or not aligned.
#[inline(always)]
pub(super) fn load_sram<const N: usize>(memory: &Memory, address: u32) -> Option<u32> {
    if address & (N as u32 - 1) == 0 {
        load::<N>(&memory.sram, address.wrapping_sub(SRAM_BASE))
    } else {
        None
    }
}

/// Writes the low `N` bytes of `value` to SRAM; false, and nothing done, where that is not all SRAM, or not aligned.
#[inline(always)]
pub(super) fn store_sram<const N: usize>(memory: &mut Memory, address: u32, value: u32) -> bool {
    address & (N as u32 - 1) == 0
        && store::<N>(&mut memory.sram, address.wrapping_sub(SRAM_BASE), value).is_some()
}

const fn width<const N: usize>() -> Width {
    match N {
        1 => Width::Byte,
        2 => Width::Half,
        _ => Width::Word,
    }
}

impl Core {
    /// Reads `N` bytes as an instruction does.
    #[inline(always)]
    pub(crate) fn read<const N: usize, P: Peripherals>(
        &mut self,
        memory: &mut Memory,
        peripherals: &mut P,
        address: u32,
    ) -> Result<u32, Fault> {
        if let Some(value) = load_sram::<N>(memory, address) {
            self.cycle += contention(self.timing == Timing::Pessimistic);
            return Ok(value);
        }
        if address & (N as u32 - 1) == 0 {
            let offset = address.wrapping_sub(FLASH_BASE);
            if memory.flash_interface.is_recent(offset)
                && let Some(value) = load::<N>(&memory.flash, offset)
            {
                return Ok(value);
            }
        }
        self.read_slowly::<N, P>(memory, peripherals, address)
    }

    /// Writes the low `N` bytes of `value` as an instruction does.
    #[inline(always)]
    pub(crate) fn write<const N: usize, P: Peripherals>(
        &mut self,
        memory: &mut Memory,
        peripherals: &mut P,
        address: u32,
        value: u32,
    ) -> Result<(), Fault> {
        if store_sram::<N>(memory, address, value) {
            self.cycle += contention(self.timing == Timing::Pessimistic);
            return Ok(());
        }
        self.write_slowly::<N, P>(memory, peripherals, address, value)
    }

    #[inline(never)]
    fn read_slowly<const N: usize, P: Peripherals>(
        &mut self,
        memory: &mut Memory,
        peripherals: &mut P,
        address: u32,
    ) -> Result<u32, Fault> {
        if address & (N as u32 - 1) != 0 {
            self.check_unaligned(address)?;
            self.cycle += 1;
            let mut value = 0;
            for n in 0..N as u32 {
                let byte = self.read::<1, P>(memory, peripherals, address.wrapping_add(n))?;
                value |= byte << (8 * n);
            }
            return Ok(value);
        }
        match address >> 24 {
            0x00 | 0x08 => {
                let offset = address & !FLASH_BASE;
                if offset < FLASH_BYTES {
                    return self.read_flash::<N>(memory, offset);
                }
            }
            0x10 => {
                if let Some(value) = load::<N>(&memory.ccm, address - CCM_BASE) {
                    return Ok(value);
                }
            }
            0x20 if address - SRAM_BASE < SRAM_BYTES => {
                return Ok(load::<N>(&memory.sram, address - SRAM_BASE).unwrap_or(0));
            }
            0x22 | 0x23 | 0x42 | 0x43 => {
                let (word, bit) = bit_band(address);
                return Ok((self.read::<4, P>(memory, peripherals, word)? >> bit) & 1);
            }
            0xE0 if address & 0xFFF0_0000 == 0xE000_0000 && address & !0xFFF != 0xE004_2000 => {
                return self.read_system(memory, peripherals, address, width::<N>());
            }
            _ => {}
        }
        if !leaves_core(address) {
            return Err(self.bus_fault(memory, unanswered(address)));
        }
        if self.timing == Timing::Pessimistic {
            self.cycle += peripherals.wait_states(address);
        }
        let access = Access { at: self.cycle, address, width: width::<N>(), pc: self.r[15].wrapping_sub(4) };
        // A read waits for the writes before it.
        self.line_falls = None;
        let answer = peripherals.read(memory, access);
        self.after_peripheral(memory, peripherals);
        answer.map_err(|error| self.bus_fault(memory, error))
    }

    #[inline(never)]
    fn write_slowly<const N: usize, P: Peripherals>(
        &mut self,
        memory: &mut Memory,
        peripherals: &mut P,
        address: u32,
        value: u32,
    ) -> Result<(), Fault> {
        if address & (N as u32 - 1) != 0 {
            self.check_unaligned(address)?;
            self.cycle += 1;
            for n in 0..N as u32 {
                self.write::<1, P>(memory, peripherals, address.wrapping_add(n), value >> (8 * n))?;
            }
            return Ok(());
        }
        let mut target = address;
        match address >> 24 {
            0x00 | 0x08 if address & !FLASH_BASE < FLASH_BYTES => target = address | FLASH_BASE,
            0x10 if address - CCM_BASE < CCM_BYTES => {
                store::<N>(&mut memory.ccm, address - CCM_BASE, value);
                return Ok(());
            }
            0x22 | 0x23 | 0x42 | 0x43 => {
                let (word, bit) = bit_band(address);
                let old = self.read::<4, P>(memory, peripherals, word)?;
                let new = old & !(1 << bit) | (value & 1) << bit;
                return self.write::<4, P>(memory, peripherals, word, new);
            }
            0xE0 if address & 0xFFF0_0000 == 0xE000_0000 && address & !0xFFF != 0xE004_2000 => {
                return self.write_system(memory, peripherals, address, width::<N>(), value);
            }
            _ if leaves_core(address) => {}
            _ => return Err(self.bus_fault(memory, unanswered(address))),
        }
        let pc = self.r[15].wrapping_sub(4);
        if self.timing == Timing::Pessimistic {
            self.cycle += peripherals.wait_states(target);
        }
        let access = Access { at: self.cycle, address: target, width: width::<N>(), pc };
        let before = self.nvic.lines();
        let answer = peripherals.write(memory, access, value);
        self.after_peripheral(memory, peripherals);
        if before & !self.nvic.lines() != 0 {
            self.line_falls =
                Some((access.at + peripherals.wait_states(target), before & !self.nvic.lines()));
        }
        answer.map_err(|error| self.bus_fault(memory, error))
    }

    /// A handler returns: were the write that cleared its request still in the write buffer, the line would stand and the
    /// handler be entered again (ARM application note 321).
    pub(super) fn check_late_clear(&mut self, memory: &mut Memory, returning: u16) {
        if let Some((until, lines)) = self.line_falls.take()
            && self.cycle < until
            && returning >= 16
            && lines >> (returning - 16) & 1 == 1
        {
            let what = format!(
                "the handler of interrupt {} returns right after the write that clears its request: without DSB it may be \
                 entered twice",
                returning - 16
            );
            memory.report(self.cycle, self.r[15].wrapping_sub(4), what);
        }
    }

    /// A flash read through the data cache, stale lines included.
    fn read_flash<const N: usize>(&mut self, memory: &mut Memory, offset: u32) -> Result<u32, Fault> {
        let interface = &mut memory.flash_interface;
        if interface.busy_until > self.cycle {
            return Err(Fault::FlashBusy);
        }
        let miss = interface.touch_data(offset);
        if miss && self.timing == Timing::Pessimistic {
            self.cycle += u64::from(interface.latency);
        }
        if let Some(line) = interface.stale_line(offset) {
            let value = load::<N>(&line, offset & 15).unwrap_or(0);
            if load::<N>(&memory.flash, offset) != Some(value) {
                let what = format!(
                    "read of {:#010x} from a stale line of the flash data cache (DCRST missing)",
                    offset | FLASH_BASE
                );
                memory.report(self.cycle, self.r[15].wrapping_sub(4), what);
            }
            return Ok(value);
        }
        Ok(load::<N>(&memory.flash, offset).unwrap_or(0))
    }

    /// Takes over what an access may have changed outside: the next event, interrupt lines, flash.
    pub(crate) fn after_peripheral<P: Peripherals>(&mut self, memory: &mut Memory, peripherals: &P) {
        self.deadline = self.deadline.min(peripherals.next_event());
        let lines = peripherals.interrupt_lines();
        if lines != self.nvic.lines() {
            self.set_lines(lines);
        }
        memory.flash_interface.forget_recent();
        if memory.flash_interface.busy_until > self.cycle || memory.has_changes() {
            self.deadline = 0;
        }
    }

    /// A3.2.1: unaligned accesses reach normal memory only, and only if UNALIGN_TRP allows.
    fn check_unaligned(&self, address: u32) -> Result<(), Fault> {
        let device = matches!(address >> 24, 0x40..=0x5F | 0xA0..=0xFF);
        if self.scs.unaligned_traps() || device { Err(Fault::Unaligned) } else { Ok(()) }
    }

    /// Notes the address of a data fault.
    pub(crate) fn bus_fault(&mut self, memory: &mut Memory, error: AccessError) -> Fault {
        memory.report(self.cycle, self.r[15].wrapping_sub(4), error.to_string());
        self.fault_address = error.address();
        Fault::DataBus
    }
}

/// Why nothing inside the core answers (RM0090 figure 18 and section 36.4).
fn unanswered(address: u32) -> AccessError {
    match address >> 24 {
        0x60..=0x9F => AccessError::NotEmulated(address, "external memory (FSMC)"),
        0xA0 if address & 0x00FF_F000 == 0 => AccessError::NotEmulated(address, "FSMC"),
        _ => AccessError::Nothing(address),
    }
}

/// Whether an address outside the memories belongs to [`Peripherals`]: peripherals, system memory with its factory
/// words, and DBGMCU.
fn leaves_core(address: u32) -> bool {
    matches!(address >> 16, 0x1FFF | 0x4000..=0x5FFF | 0xE004)
}

/// Word and bit behind an address of a bit-band alias (B3.1.1).
fn bit_band(address: u32) -> (u32, u32) {
    let offset = address & 0x01FF_FFFF;
    let byte = offset >> 5;
    ((address & 0xF000_0000) | byte & !3, (byte & 3) * 8 + (offset >> 2 & 7))
}

#[cfg(test)]
mod tests {
    use super::bit_band;

    #[test]
    fn the_alias_of_a_bit() {
        assert_eq!(bit_band(0x2200_0000), (0x2000_0000, 0));
        assert_eq!(bit_band(0x4247_0000 + 4 * 9), (0x4002_3800, 9));
        assert_eq!(bit_band(0x23FF_FFFC), (0x200F_FFFC, 31));
    }
}

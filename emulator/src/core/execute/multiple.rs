//! Loads and stores of several registers, and single ones in their general form (ARMv7-M ARM A7.7).
use crate::{
    bus::Peripherals,
    core::{
        Core, Fault,
        op::{Index, Op, Size},
    },
    memory::{Memory, SRAM_BASE},
};

impl Core {
    /// Single loads that are not frequent; `Some` where the PC was loaded.
    pub(super) fn load<P: Peripherals>(
        &mut self,
        memory: &mut Memory,
        peripherals: &mut P,
        op: Op,
    ) -> Result<Option<u32>, Fault> {
        let (size, rt, address, base) = match op {
            Op::Load { size, rt, rn, imm, index } => {
                let (address, base) = self.index(rn, imm, index);
                (size, rt, address, Some((rn, base)))
            }
            Op::LoadReg { size, rt, rn, rm, n } => {
                let offset = self.r[usize::from(rm & 15)] << (n & 3);
                (size, rt, self.r[usize::from(rn & 15)].wrapping_add(offset), None)
            }
            Op::LoadLit { size, rt, address } => (size, rt, address, None),
            _ => return Ok(None),
        };
        let value = match size {
            Size::Word => self.read::<4, P>(memory, peripherals, address)?,
            Size::Half => self.read::<2, P>(memory, peripherals, address)?,
            Size::Byte => self.read::<1, P>(memory, peripherals, address)?,
            Size::SignedHalf => self.read::<2, P>(memory, peripherals, address)? as i16 as u32,
            Size::SignedByte => self.read::<1, P>(memory, peripherals, address)? as i8 as u32,
        };
        if rt == 15 && address & 3 != 0 {
            return Err(Fault::Unaligned);
        }
        if let Some((rn, base)) = base {
            self.r[usize::from(rn & 15)] = base;
        }
        if rt == 15 {
            return Ok(Some(value));
        }
        self.r[usize::from(rt & 15)] = if rt == 13 { value & !3 } else { value };
        Ok(None)
    }

    /// Address and base register after it (A4.6.3).
    pub(super) fn index(&self, rn: u8, imm: i16, index: Index) -> (u32, u32) {
        let base = self.r[usize::from(rn & 15)];
        let moved = base.wrapping_add(i32::from(imm) as u32);
        match index {
            Index::Offset => (moved, base),
            Index::Pre => (moved, moved),
            Index::Post => (base, moved),
        }
    }

    /// Single stores that are not frequent.
    pub(super) fn store<P: Peripherals>(
        &mut self,
        memory: &mut Memory,
        peripherals: &mut P,
        size: Size,
        address: u32,
        value: u32,
    ) -> Result<(), Fault> {
        match size {
            Size::Word => self.write::<4, P>(memory, peripherals, address, value),
            Size::Half | Size::SignedHalf => self.write::<2, P>(memory, peripherals, address, value),
            Size::Byte | Size::SignedByte => self.write::<1, P>(memory, peripherals, address, value),
        }
    }

    /// STMDB SP!.
    pub(super) fn push<P: Peripherals>(
        &mut self,
        memory: &mut Memory,
        peripherals: &mut P,
        list: u16,
    ) -> Result<(), Fault> {
        let start = self.r[13].wrapping_sub(4 * list.count_ones());
        self.store_list(memory, peripherals, start, list)?;
        self.r[13] = start;
        Ok(())
    }

    /// LDMIA SP!; `Some` where the PC was loaded.
    pub(super) fn pop<P: Peripherals>(
        &mut self,
        memory: &mut Memory,
        peripherals: &mut P,
        list: u16,
    ) -> Result<Option<u32>, Fault> {
        let start = self.r[13];
        let loaded = self.load_list(memory, peripherals, start, list)?;
        self.r[13] = start.wrapping_add(4 * list.count_ones());
        Ok(loaded)
    }

    pub(super) fn load_multiple<P: Peripherals>(
        &mut self,
        memory: &mut Memory,
        peripherals: &mut P,
        rn: u8,
        list: u16,
        before: bool,
        writeback: bool,
    ) -> Result<Option<u32>, Fault> {
        let (base, bytes) = (self.r[usize::from(rn & 15)], 4 * list.count_ones());
        let (start, end) = if before {
            (base.wrapping_sub(bytes), base.wrapping_sub(bytes))
        } else {
            (base, base.wrapping_add(bytes))
        };
        let loaded = self.load_list(memory, peripherals, start, list)?;
        if writeback {
            self.r[usize::from(rn & 15)] = end;
        }
        Ok(loaded)
    }

    pub(super) fn store_multiple<P: Peripherals>(
        &mut self,
        memory: &mut Memory,
        peripherals: &mut P,
        rn: u8,
        list: u16,
        before: bool,
        writeback: bool,
    ) -> Result<(), Fault> {
        let (base, bytes) = (self.r[usize::from(rn & 15)], 4 * list.count_ones());
        let (start, end) = if before {
            (base.wrapping_sub(bytes), base.wrapping_sub(bytes))
        } else {
            (base, base.wrapping_add(bytes))
        };
        self.store_list(memory, peripherals, start, list)?;
        if writeback {
            self.r[usize::from(rn & 15)] = end;
        }
        Ok(())
    }

    /// Registers from consecutive words. On a fault none has changed, so that the instruction can run again.
    fn load_list<P: Peripherals>(
        &mut self,
        memory: &mut Memory,
        peripherals: &mut P,
        start: u32,
        list: u16,
    ) -> Result<Option<u32>, Fault> {
        if start & 3 != 0 {
            return Err(Fault::Unaligned);
        }
        let mut registers = self.r;
        let (mut left, mut address) = (list, start);
        let from = start.wrapping_sub(SRAM_BASE) as usize;
        if let Some(bytes) = memory.sram.get(from..from + 4 * list.count_ones() as usize) {
            for word in bytes.chunks_exact(4) {
                registers[left.trailing_zeros() as usize & 15] =
                    u32::from_le_bytes([word[0], word[1], word[2], word[3]]);
                left &= left.wrapping_sub(1);
            }
            self.contend(list.count_ones());
        } else {
            while left != 0 {
                registers[left.trailing_zeros() as usize & 15] =
                    self.read::<4, P>(memory, peripherals, address)?;
                left &= left.wrapping_sub(1);
                address = address.wrapping_add(4);
            }
        }
        let target = registers[15];
        registers[15] = self.r[15];
        registers[13] &= !3;
        self.r = registers;
        Ok((list & 0x8000 != 0).then_some(target))
    }

    fn store_list<P: Peripherals>(
        &mut self,
        memory: &mut Memory,
        peripherals: &mut P,
        start: u32,
        list: u16,
    ) -> Result<(), Fault> {
        if start & 3 != 0 {
            return Err(Fault::Unaligned);
        }
        let (mut left, mut address) = (list, start);
        let from = start.wrapping_sub(SRAM_BASE) as usize;
        if let Some(bytes) = memory.sram.get_mut(from..from + 4 * list.count_ones() as usize) {
            for word in bytes.chunks_exact_mut(4) {
                word.copy_from_slice(&self.r[left.trailing_zeros() as usize & 15].to_le_bytes());
                left &= left.wrapping_sub(1);
            }
            self.contend(list.count_ones());
            return Ok(());
        }
        while left != 0 {
            let value = self.r[left.trailing_zeros() as usize & 15];
            self.write::<4, P>(memory, peripherals, address, value)?;
            left &= left.wrapping_sub(1);
            address = address.wrapping_add(4);
        }
        Ok(())
    }

    /// Cycles lost to another bus master over some accesses to SRAM.
    fn contend(&mut self, accesses: u32) {
        if self.timing == crate::core::Timing::Pessimistic {
            self.cycle += u64::from(accesses);
        }
    }
}

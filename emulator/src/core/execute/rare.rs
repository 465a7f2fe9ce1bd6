//! Instructions compilers seldom emit: DSP, saturation, exclusive access, special registers.
use crate::{
    bus::Peripherals,
    core::{
        Core, Fault, alu, cost,
        op::{Dsp, Long, Op, Saturating, Shift, Size},
    },
    memory::Memory,
};

/// The half of a word that bit `at` of `mode` selects.
fn half(word: u32, top: bool) -> i64 {
    i64::from(if top { (word >> 16) as i16 } else { word as i16 })
}

impl Core {
    /// False for what no one executes.
    #[inline(never)]
    pub(super) fn execute_rare<P: Peripherals, const PESSIMISTIC: bool>(
        &mut self,
        memory: &mut Memory,
        peripherals: &mut P,
        op: Op,
    ) -> Result<bool, Fault> {
        let r = |n: u8| self.r[usize::from(n & 15)];
        let (rd, value) = match op {
            Op::AsrImm { rd, rm, n } => (rd, alu::shift(r(rm), Shift::Asr, n, false).0),
            Op::Extend { kind, rd, rn, rm, rotate } => {
                let base = if rn == 15 { 0 } else { r(rn) };
                (rd, extend(kind, base, r(rm).rotate_right(u32::from(rotate))))
            }
            Op::Sbfx { rd, rn, lsb, width } => {
                // The field may reach past bit 31 only in UNPREDICTABLE encodings.
                let shift = (32 - u32::from(width)) & 31;
                (rd, ((((r(rn) >> (lsb & 31)) << shift) as i32) >> shift) as u32)
            }
            Op::Clz { rd, rm } => (rd, r(rm).leading_zeros()),
            Op::Rbit { rd, rm } => (rd, r(rm).reverse_bits()),
            Op::Rev { rd, rm } => (rd, r(rm).swap_bytes()),
            Op::Rev16 { rd, rm } => (rd, r(rm).swap_bytes().rotate_right(16)),
            Op::Revsh { rd, rm } => (rd, (r(rm) as u16).swap_bytes() as i16 as u32),
            Op::Sel { rd, rn, rm } => {
                let mask = (0..4).fold(0, |mask, n| mask | (u32::from(self.ge >> n & 1) * 0xFF) << (8 * n));
                (rd, r(rn) & mask | r(rm) & !mask)
            }
            Op::Pkh { rd, rn, rm, top, n } => {
                let value = if top {
                    let shifted = alu::shift(r(rm), Shift::Asr, if n == 0 { 32 } else { n }, false).0;
                    r(rn) & 0xFFFF_0000 | shifted & 0xFFFF
                } else {
                    r(rn) & 0xFFFF | (r(rm) << (n & 31)) & 0xFFFF_0000
                };
                (rd, value)
            }
            Op::Parallel { prefix, lanes, rd, rn, rm } => {
                let (value, ge) = alu::parallel(prefix, lanes, r(rn), r(rm));
                self.ge = ge.unwrap_or(self.ge);
                (rd, value)
            }
            Op::Udiv { rd, rn, rm } => {
                let (n, m) = (r(rn), r(rm));
                if m == 0 && self.scs.division_traps() {
                    return Err(Fault::DivideByZero);
                }
                self.cycle += cost::division(n, m, PESSIMISTIC);
                (rd, n.checked_div(m).unwrap_or(0))
            }
            Op::Sdiv { rd, rn, rm } => {
                let (n, m) = (r(rn) as i32, r(rm) as i32);
                if m == 0 && self.scs.division_traps() {
                    return Err(Fault::DivideByZero);
                }
                self.cycle += cost::division(n.unsigned_abs(), m.unsigned_abs(), PESSIMISTIC);
                (rd, if m == 0 { 0 } else { n.wrapping_div(m) as u32 })
            }
            Op::Smlal { lo, hi, rn, rm } => {
                let product = i64::from(r(rn) as i32) * i64::from(r(rm) as i32);
                let sum = (i64::from(r(hi)) << 32 | i64::from(r(lo))).wrapping_add(product);
                self.r[usize::from(lo & 15)] = sum as u32;
                (hi, (sum >> 32) as u32)
            }
            Op::Long { op, mode, lo, hi, rn, rm } => {
                let sum = self.long(op, mode, r(lo), r(hi), r(rn), r(rm));
                self.r[usize::from(lo & 15)] = sum as u32;
                (hi, (sum >> 32) as u32)
            }
            Op::Dsp { op, mode, rd, rn, rm, ra } => {
                let addend = if ra == 15 { 0 } else { r(ra) };
                (rd, self.dsp(op, mode, r(rn), r(rm), addend))
            }
            Op::Ssat { .. } | Op::Usat { .. } | Op::Ssat16 { .. } | Op::Usat16 { .. } => self.saturate(op),
            Op::Saturating { op, rd, rn, rm } => {
                let (m, n) = (i64::from(r(rm) as i32), i64::from(r(rn) as i32));
                let (doubled, first) = alu::saturate_signed(2 * n, 32);
                let doubled = i64::from(doubled as i32);
                let (sum, first) = match op {
                    Saturating::Qadd => (m + n, false),
                    Saturating::Qsub => (m - n, false),
                    Saturating::Qdadd => (m + doubled, first),
                    Saturating::Qdsub => (m - doubled, first),
                };
                let (value, second) = alu::saturate_signed(sum, 32);
                self.q |= first | second;
                (rd, value)
            }
            Op::Ldrex { size, rt, rn, imm } => {
                let address = r(rn).wrapping_add(u32::from(imm));
                (rt, self.load_exclusive(memory, peripherals, size, address)?)
            }
            Op::Strex { size, rd, rt, rn, imm } => {
                let (address, value) = (r(rn).wrapping_add(u32::from(imm)), r(rt));
                (rd, self.store_exclusive(memory, peripherals, size, address, value)?)
            }
            Op::Mrs { rd, sysm } => (rd, self.read_special(sysm)),
            other => return Ok(self.control(other)),
        };
        self.r[usize::from(rd & 15)] = if rd == 13 { value & !3 } else { value };
        Ok(true)
    }

    /// Instructions without a destination; false for one that is none of them.
    fn control(&mut self, op: Op) -> bool {
        match op {
            Op::Msr { rn, mask, sysm } => self.write_special(sysm, mask, self.r[usize::from(rn & 15)]),
            Op::Cps { disable, masks } if self.privileged() => {
                if masks & 2 != 0 {
                    self.primask = disable;
                }
                // CPSID f does nothing at the priority of HardFault or above (B5.2.1).
                if masks & 1 != 0 && (!disable || self.execution_priority() > -1) {
                    self.faultmask = disable;
                }
                self.deadline = if disable { self.deadline } else { 0 };
            }
            Op::Clrex => self.exclusive = false,
            Op::Sev => self.event = true,
            // Barriers order what is in order here; CPS without privilege does nothing.
            Op::Barrier { .. } => self.line_falls = None,
            Op::Cps { .. } => {}
            _ => return false,
        }
        true
    }

    fn load_exclusive<P: Peripherals>(
        &mut self,
        memory: &mut Memory,
        peripherals: &mut P,
        size: Size,
        address: u32,
    ) -> Result<u32, Fault> {
        let value = match size {
            Size::Word if address & 3 != 0 => return Err(Fault::Unaligned),
            Size::Half if address & 1 != 0 => return Err(Fault::Unaligned),
            Size::Word => self.read::<4, P>(memory, peripherals, address)?,
            Size::Half => self.read::<2, P>(memory, peripherals, address)?,
            _ => self.read::<1, P>(memory, peripherals, address)?,
        };
        self.exclusive = true;
        Ok(value)
    }

    /// 0 where the store happened.
    fn store_exclusive<P: Peripherals>(
        &mut self,
        memory: &mut Memory,
        peripherals: &mut P,
        size: Size,
        address: u32,
        value: u32,
    ) -> Result<u32, Fault> {
        if matches!(size, Size::Word) && address & 3 != 0 || matches!(size, Size::Half) && address & 1 != 0 {
            return Err(Fault::Unaligned);
        }
        if !std::mem::take(&mut self.exclusive) {
            return Ok(1);
        }
        self.store(memory, peripherals, size, address, value)?;
        Ok(0)
    }

    fn saturate(&mut self, op: Op) -> (u8, u32) {
        let r = |n: u8| self.r[usize::from(n & 15)];
        let shifted = |rn: u8, asr: bool, n: u8| {
            let value = r(rn) as i32;
            i64::from(if asr { value >> (n & 31) } else { value << (n & 31) })
        };
        let halves = |rn: u8, clamp: &dyn Fn(i64) -> (u32, bool)| {
            let (low, first) = clamp(half(r(rn), false));
            let (high, second) = clamp(half(r(rn), true));
            (high << 16 | low & 0xFFFF, first | second)
        };
        let (rd, (value, saturated)) = match op {
            Op::Ssat { rd, rn, bits, asr, n } => (rd, alu::saturate_signed(shifted(rn, asr, n), bits)),
            Op::Usat { rd, rn, bits, asr, n } => (rd, alu::saturate_unsigned(shifted(rn, asr, n), bits)),
            Op::Ssat16 { rd, rn, bits } => (rd, halves(rn, &|v| alu::saturate_signed(v, bits))),
            Op::Usat16 { rd, rn, bits } => (rd, halves(rn, &|v| alu::saturate_unsigned(v, bits))),
            _ => (0, (r(0), false)),
        };
        self.q |= saturated;
        (rd, value)
    }

    fn dsp(&mut self, op: Dsp, mode: u8, n: u32, m: u32, addend: u32) -> u32 {
        let signed = |word: u32| i64::from(word as i32);
        let (swap, round) = (mode & 1 != 0, u64::from(mode & 1) << 31);
        let products = (half(n, false) * half(m, swap), half(n, true) * half(m, !swap));
        let sum = match op {
            Dsp::Smla => half(n, mode & 2 != 0) * half(m, mode & 1 != 0) + signed(addend),
            Dsp::Smlaw => {
                // Bits 47..16 of the product.
                ((signed(n) * half(m, mode & 1 != 0)) >> 16) + signed(addend)
            }
            Dsp::Smlad => products.0 + products.1 + signed(addend),
            Dsp::Smlsd => products.0 - products.1 + signed(addend),
            Dsp::Smmla | Dsp::Smmls => {
                let product = signed(n).wrapping_mul(signed(m));
                let base = signed(addend) << 32;
                let total =
                    if op == Dsp::Smmla { base.wrapping_add(product) } else { base.wrapping_sub(product) };
                return ((total as u64).wrapping_add(round) >> 32) as u32;
            }
            Dsp::Usada8 => {
                let difference = |at: u32| (n >> at & 0xFF).abs_diff(m >> at & 0xFF);
                return (0..4).fold(addend, |sum, lane| sum.wrapping_add(difference(8 * lane)));
            }
        };
        self.q |= sum != i64::from(sum as i32);
        sum as u32
    }

    fn long(&self, op: Long, mode: u8, lo: u32, hi: u32, n: u32, m: u32) -> u64 {
        let sum = u64::from(hi) << 32 | u64::from(lo);
        let swap = mode & 1 != 0;
        let products = (half(n, false) * half(m, swap), half(n, true) * half(m, !swap));
        let addend = match op {
            Long::Umaal => {
                return u64::from(n) * u64::from(m) + u64::from(hi) + u64::from(lo);
            }
            Long::Smlal16 => half(n, mode & 2 != 0) * half(m, mode & 1 != 0),
            Long::Smlald => products.0 + products.1,
            Long::Smlsld => products.0 - products.1,
        };
        sum.wrapping_add(addend as u64)
    }
}

/// SXTAH, UXTAH, SXTAB16, UXTAB16, SXTAB, UXTAB.
fn extend(kind: u8, base: u32, rotated: u32) -> u32 {
    let (low, high) = (rotated & 0xFF, rotated >> 16 & 0xFF);
    let sixteens = |low: u32, high: u32| {
        let bottom = base.wrapping_add(low) & 0xFFFF;
        let top = (base >> 16).wrapping_add(high) << 16;
        top | bottom
    };
    match kind {
        0 => base.wrapping_add(rotated as i16 as u32),
        1 => base.wrapping_add(rotated & 0xFFFF),
        2 => sixteens(low as i8 as u32, high as i8 as u32),
        3 => sixteens(low, high),
        4 => base.wrapping_add(rotated as i8 as u32),
        _ => base.wrapping_add(low),
    }
}

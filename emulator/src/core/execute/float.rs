//! Floating-point instructions on the register file (ARMv7-M ARM A7.7, B1.5.7); arithmetic stands in `core::float`.
use crate::{
    bus::Peripherals,
    core::{
        Core, Fault,
        float::{self, Context},
        op::{Float2, Float3, Op},
    },
    memory::Memory,
};

const SIGN: u32 = 0x8000_0000;

impl Core {
    #[inline(never)]
    pub(super) fn execute_float(&mut self, op: Op) {
        let s = |n: u8| self.s[usize::from(n & 31)];
        let mut context = Context::new(self.fpscr);
        let (d, value) = match op {
            Op::Vadd { d, n, m } => (d, float::add(&mut context, s(n), s(m))),
            Op::Vsub { d, n, m } => (d, float::subtract(&mut context, s(n), s(m))),
            Op::Vmul { d, n, m } => (d, float::multiply(&mut context, s(n), s(m))),
            Op::Float3 { op, d, n, m } => (d, three(&mut context, op, s(d), s(n), s(m))),
            Op::Float2 { op, d, m } => (d, two(&mut context, op, s(d), s(m))),
            Op::VmovImm { d, imm } => (d, imm),
            Op::VcvtFixed { d, to_fixed, half, unsigned, fraction } => {
                let value = if to_fixed {
                    float::to_fixed(&mut context, s(d), half, unsigned, fraction)
                } else {
                    float::from_fixed(&mut context, s(d), half, unsigned, fraction)
                };
                (d, value)
            }
            Op::Vcmp { d, m, zero, e } => {
                let nzcv = float::compare(&mut context, s(d), if zero { 0 } else { s(m) }, e);
                self.fpscr = context.fpscr & 0x0FFF_FFFF | nzcv << 28;
                return;
            }
            Op::VmovPair { m, rt, rt2, to_core } => {
                let (first, second) = (usize::from(m & 31), usize::from((m + 1) & 31));
                let (rt, rt2) = (usize::from(rt & 15), usize::from(rt2 & 15));
                if to_core {
                    (self.r[rt], self.r[rt2]) = (self.s[first], self.s[second]);
                } else {
                    (self.s[first], self.s[second]) = (self.r[rt], self.r[rt2]);
                }
                return;
            }
            Op::Vmrs { rt } => {
                self.r[usize::from(rt & 15)] = self.fpscr;
                return;
            }
            Op::Vmsr { rt } => {
                self.fpscr = self.r[usize::from(rt & 15)] & float::FPSCR_MASK;
                return;
            }
            _ => return,
        };
        self.fpscr = context.fpscr;
        self.s[usize::from(d & 31)] = value;
    }

    #[allow(clippy::too_many_arguments, reason = "the fields of the encoding")]
    pub(super) fn load_floats<P: Peripherals>(
        &mut self,
        memory: &mut Memory,
        peripherals: &mut P,
        rn: u8,
        d: u8,
        count: u8,
        before: bool,
        writeback: bool,
    ) -> Result<(), Fault> {
        let (start, end) = self.range(rn, count, before)?;
        for n in 0..count {
            let address = start.wrapping_add(4 * u32::from(n));
            self.s[usize::from((d + n) & 31)] = self.read::<4, P>(memory, peripherals, address)?;
        }
        if writeback {
            self.r[usize::from(rn & 15)] = end;
        }
        Ok(())
    }

    #[allow(clippy::too_many_arguments, reason = "the fields of the encoding")]
    pub(super) fn store_floats<P: Peripherals>(
        &mut self,
        memory: &mut Memory,
        peripherals: &mut P,
        rn: u8,
        d: u8,
        count: u8,
        before: bool,
        writeback: bool,
    ) -> Result<(), Fault> {
        let (start, end) = self.range(rn, count, before)?;
        for n in 0..count {
            let address = start.wrapping_add(4 * u32::from(n));
            let value = self.s[usize::from((d + n) & 31)];
            self.write::<4, P>(memory, peripherals, address, value)?;
        }
        if writeback {
            self.r[usize::from(rn & 15)] = end;
        }
        Ok(())
    }

    /// Where a transfer of `count` words starts, and what the base becomes.
    fn range(&self, rn: u8, count: u8, before: bool) -> Result<(u32, u32), Fault> {
        let base = self.r[usize::from(rn & 15)] & if rn == 15 { !3 } else { !0 };
        let bytes = 4 * u32::from(count);
        let (start, end) = if before {
            (base.wrapping_sub(bytes), base.wrapping_sub(bytes))
        } else {
            (base, base.wrapping_add(bytes))
        };
        if start & 3 == 0 { Ok((start, end)) } else { Err(Fault::Unaligned) }
    }
}

fn three(context: &mut Context, op: Float3, d: u32, n: u32, m: u32) -> u32 {
    match op {
        Float3::Mla => {
            let product = float::multiply(context, n, m);
            float::add(context, d, product)
        }
        Float3::Mls => {
            let product = float::multiply(context, n, m);
            float::add(context, d, product ^ SIGN)
        }
        Float3::Nmla => {
            let product = float::multiply(context, n, m);
            float::add(context, d ^ SIGN, product ^ SIGN)
        }
        Float3::Nmls => {
            let product = float::multiply(context, n, m);
            float::add(context, d ^ SIGN, product)
        }
        Float3::Nmul => float::multiply(context, n, m) ^ SIGN,
        Float3::Div => float::divide(context, n, m),
        Float3::Fma => float::fused(context, n, m, d),
        Float3::Fms => float::fused(context, n ^ SIGN, m, d),
        Float3::Fnma => float::fused(context, n ^ SIGN, m, d ^ SIGN),
        Float3::Fnms => float::fused(context, n, m, d ^ SIGN),
    }
}

fn two(context: &mut Context, op: Float2, d: u32, m: u32) -> u32 {
    match op {
        Float2::Mov => m,
        Float2::Abs => m & !SIGN,
        Float2::Neg => m ^ SIGN,
        Float2::Sqrt => float::square_root(context, m),
        Float2::FromHalf(top) => float::from_half(context, (if top { m >> 16 } else { m }) as u16),
        Float2::ToHalf(top) => {
            let half = u32::from(float::to_half(context, m));
            if top { d & 0xFFFF | half << 16 } else { d & 0xFFFF_0000 | half }
        }
        Float2::FromUnsigned => float::from_integer(context, false, m),
        Float2::FromSigned => float::from_integer(context, (m as i32) < 0, (m as i32).unsigned_abs()),
        Float2::ToUnsigned => float::to_integer(context, m, true, false),
        Float2::ToSigned => float::to_integer(context, m, false, false),
        Float2::ToUnsignedZero => float::to_integer(context, m, true, true),
        Float2::ToSignedZero => float::to_integer(context, m, false, true),
    }
}

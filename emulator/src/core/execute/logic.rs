//! Data-processing operations in their general form (ARMv7-M ARM A5.3.1).
use crate::core::{Core, alu, op::Alu};

impl Core {
    /// One operation on `x` and the operand `y`, whose shifter left `carry`.
    #[inline]
    pub(super) fn data_operation(&mut self, op: Alu, s: bool, rd: u8, x: u32, y: u32, carry: bool) {
        let (value, c, v) = match op {
            Alu::And | Alu::Tst => (x & y, carry, self.v),
            Alu::Bic => (x & !y, carry, self.v),
            Alu::Orr => (x | y, carry, self.v),
            Alu::Orn => (x | !y, carry, self.v),
            Alu::Eor | Alu::Teq => (x ^ y, carry, self.v),
            Alu::Mov => (y, carry, self.v),
            Alu::Mvn => (!y, carry, self.v),
            Alu::Add | Alu::Cmn => alu::add_with_carry(x, y, false),
            Alu::Adc => alu::add_with_carry(x, y, self.c),
            Alu::Sbc => alu::add_with_carry(x, !y, self.c),
            Alu::Sub | Alu::Cmp => alu::add_with_carry(x, !y, true),
            Alu::Rsb => alu::add_with_carry(!x, y, true),
        };
        if !matches!(op, Alu::Tst | Alu::Teq | Alu::Cmn | Alu::Cmp) {
            self.r[usize::from(rd & 15)] = if rd == 13 { value & !3 } else { value };
        }
        if s {
            self.n = (value as i32) < 0;
            self.z = value == 0;
            self.c = c;
            self.v = v;
        }
    }
}

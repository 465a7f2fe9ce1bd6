//! N, Z, C and V: what sets them and what they decide (ARMv7-M ARM A2.3, A7.3).
use crate::core::Core;

/// For every condition the values of N, Z, C and V (as a number of four bits) with which it passes, as bits.
const PASSING: [u16; 16] = {
    let mut passing = [0; 16];
    let mut nzcv = 0;
    while nzcv < 16 {
        let (n, z, c, v) = (nzcv >> 3 & 1 != 0, nzcv >> 2 & 1 != 0, nzcv >> 1 & 1 != 0, nzcv & 1 != 0);
        let holds = [z, c, n, v, c && !z, n == v, n == v && !z, true];
        let mut condition = 0;
        while condition < 16 {
            if condition >= 14 || holds[condition / 2] == (condition % 2 == 0) {
                passing[condition] |= 1 << nzcv;
            }
            condition += 1;
        }
        nzcv += 1;
    }
    passing
};

impl Core {
    /// `value << n` with flags; `n` is 1..=31.
    #[inline(always)]
    pub(super) fn shift_left(&mut self, value: u32, n: u8) -> u32 {
        self.c = value << ((n - 1) & 31) >> 31 != 0;
        self.sign_and_zero(value << (n & 31))
    }

    /// `value >> n` with flags; `n` is 1..=31.
    #[inline(always)]
    pub(super) fn shift_right(&mut self, value: u32, n: u8) -> u32 {
        self.c = value >> ((n - 1) & 31) & 1 != 0;
        self.sign_and_zero(value >> (n & 31))
    }

    #[inline(always)]
    fn sign_and_zero(&mut self, value: u32) -> u32 {
        self.n = (value as i32) < 0;
        self.z = value == 0;
        value
    }

    /// `x - y` with flags.
    #[inline(always)]
    pub(super) fn subtract(&mut self, x: u32, y: u32) -> u32 {
        let result = x.wrapping_sub(y);
        self.n = (result as i32) < 0;
        self.z = x == y;
        self.c = x >= y;
        self.v = ((x ^ y) & (x ^ result)) >> 31 != 0;
        result
    }

    /// ConditionPassed (A7.3): `condition` is a four-bit code.
    #[inline]
    pub(crate) fn passes(&self, condition: u8) -> bool {
        let nzcv =
            u32::from(self.n) << 3 | u32::from(self.z) << 2 | u32::from(self.c) << 1 | u32::from(self.v);
        PASSING[usize::from(condition & 15)] >> nzcv & 1 != 0
    }
}

//! Integer arithmetic without state (ARMv7-M ARM A2.2.1, A5.3.2, A7.4.2).
use crate::core::op::{Lanes, Parallel, Shift};

/// `x + y + carry`, with carry and overflow out (AddWithCarry).
#[inline(always)]
pub(crate) fn add_with_carry(x: u32, y: u32, carry: bool) -> (u32, bool, bool) {
    let wide = u64::from(x) + u64::from(y) + u64::from(carry);
    let sum = wide as u32;
    (sum, wide >> 32 != 0, ((x ^ sum) & (y ^ sum)) >> 31 != 0)
}

/// A shift of `n` places with the carry it leaves (Shift_C); `n` = 0 changes nothing but for RRX.
#[inline]
pub(crate) fn shift(value: u32, shift: Shift, n: u8, carry: bool) -> (u32, bool) {
    let n = u32::from(n);
    match (shift, n) {
        (Shift::Rrx, _) => (u32::from(carry) << 31 | value >> 1, value & 1 != 0),
        (_, 0) => (value, carry),
        (Shift::Lsl, 1..32) => (value << n, (value << (n - 1)) >> 31 != 0),
        (Shift::Lsl, 32) => (0, value & 1 != 0),
        (Shift::Lsr, 1..32) => (value >> n, (value >> (n - 1)) & 1 != 0),
        (Shift::Lsr, 32) => (0, value >> 31 != 0),
        (Shift::Lsl | Shift::Lsr, _) => (0, false),
        (Shift::Asr, 1..32) => (((value as i32) >> n) as u32, ((value as i32) >> (n - 1)) & 1 != 0),
        (Shift::Asr, _) => (((value as i32) >> 31) as u32, value >> 31 != 0),
        (Shift::Ror, _) => {
            let result = value.rotate_right(n);
            (result, result >> 31 != 0)
        }
    }
}

/// ThumbExpandImm_C: the value, and the carry of a rotated constant (2: unchanged).
pub(crate) fn expand_immediate(code: u32) -> (u32, u8) {
    let byte = code & 0xFF;
    if code >> 10 == 0 {
        let value = match code >> 8 {
            0 => byte,
            1 => byte << 16 | byte,
            2 => byte << 24 | byte << 8,
            _ => byte * 0x0101_0101,
        };
        return (value, 2);
    }
    let value = (0x80 | (code & 0x7F)).rotate_right(code >> 7);
    (value, (value >> 31) as u8)
}

/// Clamps to `bits` signed bits (1..=32), and whether that changed the value.
pub(crate) fn saturate_signed(value: i64, bits: u8) -> (u32, bool) {
    let max = (1_i64 << (bits - 1)) - 1;
    let clamped = value.clamp(-max - 1, max);
    (clamped as u32, clamped != value)
}

/// Clamps to `bits` unsigned bits (0..=31).
pub(crate) fn saturate_unsigned(value: i64, bits: u8) -> (u32, bool) {
    let clamped = value.clamp(0, (1_i64 << bits) - 1);
    (clamped as u32, clamped != value)
}

/// A parallel addition or subtraction: result, and the GE flags where it sets them.
pub(crate) fn parallel(prefix: Parallel, lanes: Lanes, x: u32, y: u32) -> (u32, Option<u8>) {
    let (width, count) = match lanes {
        Lanes::Add8 | Lanes::Sub8 => (8_u32, 4_u32),
        _ => (16, 2),
    };
    let signed = matches!(prefix, Parallel::Signed | Parallel::Saturating | Parallel::SignedHalving);
    let lane = |word: u32, at: u32| -> i32 {
        let raw = word << (32 - width - at * width);
        if signed { (raw as i32) >> (32 - width) } else { (raw >> (32 - width)) as i32 }
    };
    let mask = (1_u32 << width) - 1;
    let (mut result, mut ge) = (0, 0_u8);
    for at in 0..count {
        let crossed = matches!(lanes, Lanes::Asx | Lanes::Sax);
        let subtract = match lanes {
            Lanes::Add8 | Lanes::Add16 => false,
            Lanes::Sub8 | Lanes::Sub16 => true,
            // ASX adds in the high half and subtracts in the low one, SAX the reverse.
            Lanes::Asx => at == 0,
            Lanes::Sax => at == 1,
        };
        let a = lane(x, at);
        let b = lane(y, if crossed { 1 - at } else { at });
        let value = if subtract { a - b } else { a + b };
        let kept = match prefix {
            Parallel::Saturating => {
                let max = (1_i32 << (width - 1)) - 1;
                value.clamp(-max - 1, max)
            }
            Parallel::UnsignedSaturating => value.clamp(0, mask as i32),
            Parallel::SignedHalving | Parallel::UnsignedHalving => value >> 1,
            Parallel::Signed | Parallel::Unsigned => value,
        };
        result |= (kept as u32 & mask) << (at * width);
        let set = match prefix {
            Parallel::Unsigned if !subtract => value > mask as i32,
            _ => value >= 0,
        };
        if set {
            ge |= if width == 8 { 1 << at } else { 3 << (2 * at) };
        }
    }
    let sets = matches!(prefix, Parallel::Signed | Parallel::Unsigned);
    (result, sets.then_some(ge))
}

//! Comparison, and conversion from and to integers, fixed point and half precision (ARMv7-M ARM A2.5.5).
use std::cmp::Ordering;

use super::{
    AHP, Context, DEFAULT_NAN, DN, FZ, INFINITY, IOC, IXC, Kind, OFC, QUIET, RMODE, SIGN, UFC, jam,
    normalise, rounds_up,
};

/// FPCompare of two numbers where it raises nothing; else none.
#[inline(always)]
pub(crate) fn compare_numbers(fpscr: u32, a: u32, b: u32) -> Option<u32> {
    let ordering = f32::from_bits(a).partial_cmp(&f32::from_bits(b)).filter(|_| fpscr & FZ == 0)?;
    Some(match ordering {
        Ordering::Equal => 0b0110,
        Ordering::Less => 0b1000,
        Ordering::Greater => 0b0010,
    })
}

/// FPCompare: N, Z, C and V as a number of four bits. With `quiet_too`, any NaN is invalid.
pub(crate) fn compare(context: &mut Context, a: u32, b: u32, quiet_too: bool) -> u32 {
    let (x, y) = (context.unpack(a), context.unpack(b));
    if x.is_nan() || y.is_nan() {
        if quiet_too || x.kind == Kind::SignalingNan || y.kind == Kind::SignalingNan {
            context.raise(IOC);
        }
        return 0b0011;
    }
    let value = |kind: Kind, bits: u32| if kind == Kind::Zero { 0.0 } else { f32::from_bits(bits) };
    let (x, y) = (value(x.kind, a), value(y.kind, b));
    if x == y {
        0b0110
    } else if x < y {
        0b1000
    } else {
        0b0010
    }
}

/// FixedToFP of a signed magnitude, rounding as FPSCR says.
pub(crate) fn from_integer(context: &mut Context, sign: bool, magnitude: u32) -> u32 {
    if magnitude == 0 { 0 } else { context.round(sign, 0, u128::from(magnitude)) }
}

/// VCVT from fixed point: always to nearest.
pub(crate) fn from_fixed(context: &mut Context, bits: u32, half: bool, unsigned: bool, fraction: u8) -> u32 {
    let value = match (half, unsigned) {
        (true, true) => i64::from(bits as u16),
        (true, false) => i64::from(bits as i16),
        (false, true) => i64::from(bits),
        (false, false) => i64::from(bits as i32),
    };
    if value == 0 {
        return 0;
    }
    let mode = context.fpscr & RMODE;
    context.fpscr &= !RMODE;
    let result = context.round(value < 0, -i32::from(fraction), u128::from(value.unsigned_abs()));
    context.fpscr |= mode;
    result
}

/// FPToFixed to 32 bits without fraction.
pub(crate) fn to_integer(context: &mut Context, bits: u32, unsigned: bool, to_zero: bool) -> u32 {
    let mode = if to_zero { 3 } else { context.rounding() };
    fixed(context, bits, 32, unsigned, 0, mode)
}

/// VCVT to fixed point: always towards zero.
pub(crate) fn to_fixed(context: &mut Context, bits: u32, half: bool, unsigned: bool, fraction: u8) -> u32 {
    let width = if half { 16 } else { 32 };
    let value = fixed(context, bits, width, unsigned, fraction, 3);
    match (half, unsigned) {
        (true, true) => value & 0xFFFF,
        (true, false) => value as i16 as u32,
        _ => value,
    }
}

fn fixed(context: &mut Context, bits: u32, width: u32, unsigned: bool, fraction: u8, mode: u32) -> u32 {
    let number = context.unpack(bits);
    let (min, max) = if unsigned {
        (0, (1_i128 << width) - 1)
    } else {
        (-(1_i128 << (width - 1)), (1_i128 << (width - 1)) - 1)
    };
    let saturated = if number.sign { min } else { max };
    match number.kind {
        Kind::QuietNan | Kind::SignalingNan => {
            context.raise(IOC);
            return 0;
        }
        Kind::Infinity => {
            context.raise(IOC);
            return saturated as u32;
        }
        Kind::Zero => return 0,
        Kind::Finite => {}
    }
    let exponent = number.exponent + i32::from(fraction);
    // 2^40 times a significand is out of range however wide the result.
    let (magnitude, rest, half) = if exponent >= 0 {
        (number.significand << exponent.min(40), 0, 1)
    } else {
        // The two lowest bits hold the first bit cut off and, sticky, the rest.
        let cut = jam(number.significand as u64 * 4, (-exponent) as u32);
        (u128::from(cut >> 2), cut & 3, 2)
    };
    let up = rounds_up(mode, number.sign, magnitude & 1 != 0, rest, half);
    let magnitude = (magnitude + u128::from(up)) as i128;
    let value = if number.sign { -magnitude } else { magnitude };
    if value < min || value > max {
        context.raise(IOC);
        return saturated as u32;
    }
    if rest != 0 {
        context.raise(IXC);
    }
    value as u32
}

/// FPHalfToSingle; denormal halves are never flushed.
pub(crate) fn from_half(context: &mut Context, bits: u16) -> u32 {
    let bits = u32::from(bits);
    let (sign, field, fraction) = ((bits & 0x8000) << 16, bits >> 10 & 0x1F, bits & 0x3FF);
    match (field, fraction) {
        (0, 0) => sign,
        (0, _) => {
            // Denormal: all are normal numbers in single precision.
            let leading = 31 - fraction.leading_zeros();
            sign | (leading + 127 - 24) << 23 | (fraction << (23 - leading)) & 0x7F_FFFF
        }
        (31, _) if context.fpscr & AHP == 0 => {
            if fraction == 0 {
                return sign | INFINITY;
            }
            if fraction & 0x200 == 0 {
                context.raise(IOC);
            }
            if context.fpscr & DN != 0 { DEFAULT_NAN } else { sign | INFINITY | QUIET | fraction << 13 }
        }
        _ => sign | (field + 127 - 15) << 23 | fraction << 13,
    }
}

/// FPSingleToHalf.
pub(crate) fn to_half(context: &mut Context, bits: u32) -> u16 {
    let number = context.unpack(bits);
    let alternative = context.fpscr & AHP != 0;
    let sign = if bits & SIGN != 0 { 0x8000_u16 } else { 0 };
    match number.kind {
        Kind::QuietNan | Kind::SignalingNan => {
            if alternative || number.kind == Kind::SignalingNan {
                context.raise(IOC);
            }
            if alternative {
                return sign;
            }
            if context.fpscr & DN != 0 { 0x7E00 } else { sign | 0x7E00 | (bits >> 13) as u16 & 0x1FF }
        }
        Kind::Infinity if alternative => {
            context.raise(IOC);
            sign | 0x7FFF
        }
        Kind::Infinity => sign | 0x7C00,
        Kind::Zero => sign,
        Kind::Finite => {
            let (mut top, exponent) = normalise(number.exponent, number.significand);
            let mut biased = exponent + 62 + 15;
            let tiny = biased <= 0;
            if tiny {
                top = jam(top, (1 - biased) as u32);
                biased = 0;
            }
            let (fraction, rest) = ((top >> 52) as u32, top & ((1 << 52) - 1));
            let up = rounds_up(context.rounding(), number.sign, fraction & 1 != 0, rest, 1 << 51);
            let fraction = fraction + u32::from(up);
            let result = if tiny { fraction } else { ((biased as u32 - 1) << 10) + fraction };
            if alternative && result > 0x7FFF {
                context.raise(IOC);
                return sign | 0x7FFF;
            }
            if !alternative && result >= 0x7C00 {
                context.raise(OFC | IXC);
                let infinite = context.overflow(number.sign) == INFINITY;
                return sign | if infinite { 0x7C00 } else { 0x7BFF };
            }
            if rest != 0 {
                context.raise(if tiny { UFC | IXC } else { IXC });
            }
            sign | result as u16
        }
    }
}

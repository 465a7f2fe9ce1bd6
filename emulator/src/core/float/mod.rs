//! Single-precision arithmetic with the modes and flags of FPSCR (ARMv7-M ARM A2.5).
//!
//! Exact: operands become integers times powers of two, the result is formed exactly (or with a sticky bit) and
//! rounded once. Where nothing but Inexact could be raised and that flag stands already, the host's IEEE 754
//! arithmetic gives the same bits sooner.
mod convert;

pub(crate) use convert::{
    compare, compare_numbers, from_fixed, from_half, from_integer, to_fixed, to_half, to_integer,
};

/// Bits of FPSCR that exist.
pub(crate) const FPSCR_MASK: u32 = 0xF7C0_009F;
const IOC: u32 = 1;
const DZC: u32 = 1 << 1;
const OFC: u32 = 1 << 2;
const UFC: u32 = 1 << 3;
const IXC: u32 = 1 << 4;
const IDC: u32 = 1 << 7;
const FZ: u32 = 1 << 24;
const DN: u32 = 1 << 25;
const AHP: u32 = 1 << 26;
const RMODE: u32 = 3 << 22;
const SIGN: u32 = 1 << 31;
const INFINITY: u32 = 0x7F80_0000;
const DEFAULT_NAN: u32 = 0x7FC0_0000;
const QUIET: u32 = 1 << 22;

/// FPSCR while an instruction runs.
pub(crate) struct Context {
    /// With the flags raised so far.
    pub(crate) fpscr: u32,
}

/// An operand taken apart.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Kind {
    Zero,
    Finite,
    Infinity,
    QuietNan,
    SignalingNan,
}

/// `(-1)^sign * significand * 2^exponent`, where finite.
#[derive(Clone, Copy)]
struct Number {
    kind: Kind,
    sign: bool,
    exponent: i32,
    significand: u128,
}

impl Number {
    fn is_nan(self) -> bool {
        matches!(self.kind, Kind::QuietNan | Kind::SignalingNan)
    }
}

impl Context {
    pub(crate) fn new(fpscr: u32) -> Self {
        Self { fpscr }
    }

    fn raise(&mut self, flags: u32) {
        self.fpscr |= flags;
    }

    /// 0 to nearest, 1 to plus infinity, 2 to minus infinity, 3 to zero.
    fn rounding(&self) -> u32 {
        (self.fpscr & RMODE) >> 22
    }

    /// Round to nearest, no flush to zero, Inexact raised already.
    fn host_will_do(&self) -> bool {
        self.fpscr & (RMODE | FZ | IXC) == IXC
    }

    /// FPUnpack: with flush to zero, denormal operands count as zero.
    fn unpack(&mut self, bits: u32) -> Number {
        let (sign, field, fraction) = (bits & SIGN != 0, bits >> 23 & 0xFF, bits & 0x7F_FFFF);
        let number = |kind, exponent, significand: u32| Number {
            kind,
            sign,
            exponent,
            significand: u128::from(significand),
        };
        match (field, fraction) {
            (0, 0) => number(Kind::Zero, 0, 0),
            (0, _) if self.fpscr & FZ != 0 => {
                self.raise(IDC);
                number(Kind::Zero, 0, 0)
            }
            (0, _) => number(Kind::Finite, -149, fraction),
            (255, 0) => number(Kind::Infinity, 0, 0),
            (255, _) if fraction & QUIET != 0 => number(Kind::QuietNan, 0, fraction),
            (255, _) => number(Kind::SignalingNan, 0, fraction),
            _ => number(Kind::Finite, field as i32 - 150, fraction | 0x80_0000),
        }
    }

    fn invalid(&mut self) -> u32 {
        self.raise(IOC);
        DEFAULT_NAN
    }

    /// FPProcessNaN.
    fn process_nan(&mut self, number: Number, bits: u32) -> u32 {
        if number.kind == Kind::SignalingNan {
            self.raise(IOC);
        }
        if self.fpscr & DN != 0 { DEFAULT_NAN } else { bits | QUIET }
    }

    /// FPProcessNaNs: the first signaling NaN, else the first quiet one.
    fn process_nans(&mut self, operands: &[(Number, u32)]) -> Option<u32> {
        let signaling = operands.iter().find(|(number, _)| number.kind == Kind::SignalingNan);
        let (number, bits) = signaling.or_else(|| operands.iter().find(|(number, _)| number.is_nan()))?;
        Some(self.process_nan(*number, *bits))
    }

    /// FPRound: `significand * 2^exponent`, not zero; its lowest bit may be sticky if there are 27 bits or more.
    fn round(&mut self, sign: bool, exponent: i32, significand: u128) -> u32 {
        // Leading one to bit 62; what falls off stays as a sticky bit.
        let (mut top, exponent) = normalise(exponent, significand);
        let signed = u32::from(sign) << 31;
        let mut biased = exponent + 62 + 127;
        let tiny = biased <= 0;
        if tiny {
            if self.fpscr & FZ != 0 {
                self.raise(UFC);
                return signed;
            }
            top = jam(top, (1 - biased) as u32);
            biased = 0;
        }
        let (mut fraction, rest) = ((top >> 39) as u32, top & ((1 << 39) - 1));
        fraction += u32::from(rounds_up(self.rounding(), sign, fraction & 1 != 0, rest, 1 << 38));
        if rest != 0 {
            self.raise(if tiny { UFC | IXC } else { IXC });
        }
        // The carry of rounding moves into the exponent by itself; so does the hidden bit.
        let bits = if tiny { fraction } else { ((biased as u32 - 1) << 23) + fraction };
        if bits >= INFINITY {
            self.raise(OFC | IXC);
            return signed | self.overflow(sign);
        }
        signed | bits
    }

    fn overflow(&self, sign: bool) -> u32 {
        match (self.rounding(), sign) {
            (0, _) | (1, false) | (2, true) => INFINITY,
            _ => INFINITY - 1,
        }
    }

    /// A sum that is exactly zero: negative only when rounding to minus infinity.
    fn zero_sum(&self) -> u32 {
        if self.rounding() == 2 { SIGN } else { 0 }
    }
}

/// Shifts right; what falls off stays as a sticky bit.
fn jam(value: u64, by: u32) -> u64 {
    if by >= 64 {
        return u64::from(value != 0);
    }
    value >> by | u64::from(value & ((1 << by) - 1) != 0)
}

fn jam_wide(value: u128, by: u32) -> u128 {
    if by >= 128 {
        return u128::from(value != 0);
    }
    value >> by | u128::from(value & ((1 << by) - 1) != 0)
}

/// The leading one at bit 62.
fn normalise(exponent: i32, significand: u128) -> (u64, i32) {
    let leading = 127 - significand.leading_zeros() as i32;
    let shift = leading - 62;
    let top = if shift > 0 { jam_wide(significand, shift as u32) } else { significand << -shift };
    (top as u64, exponent + shift)
}

/// Whether a magnitude rounds up: `rest` of `2 * half` is cut off.
fn rounds_up(mode: u32, sign: bool, odd: bool, rest: u64, half: u64) -> bool {
    match mode {
        0 => rest > half || rest == half && odd,
        1 => rest != 0 && !sign,
        2 => rest != 0 && sign,
        _ => false,
    }
}

/// A result of the host that raises nothing but Inexact: normal, and so far from the smallest normal number that it
/// was not tiny before rounding.
#[inline(always)]
fn plain(value: f32) -> Option<u32> {
    let bits = value.to_bits();
    let field = bits >> 23 & 0xFF;
    (field.wrapping_sub(2) < 253).then_some(bits)
}

/// An operation that the host's arithmetic can do.
#[derive(Clone, Copy)]
pub(crate) enum Simple {
    Add,
    Subtract,
    Multiply,
}

/// The result of an operation that raises nothing new, as most do; else none.
#[inline(always)]
pub(crate) fn simple(fpscr: u32, operation: Simple, a: u32, b: u32) -> Option<u32> {
    let (x, y) = (f32::from_bits(a), f32::from_bits(b));
    let value = match operation {
        Simple::Add => x + y,
        Simple::Subtract => x - y,
        Simple::Multiply => x * y,
    };
    if Context::new(fpscr).host_will_do() { plain(value) } else { None }
}

/// FPAdd.
#[inline]
pub(crate) fn add(context: &mut Context, a: u32, b: u32) -> u32 {
    simple(context.fpscr, Simple::Add, a, b).unwrap_or_else(|| add_exactly(context, a, b))
}

/// FPSub.
#[inline]
pub(crate) fn subtract(context: &mut Context, a: u32, b: u32) -> u32 {
    if let Some(bits) = simple(context.fpscr, Simple::Subtract, a, b) {
        return bits;
    }
    // A NaN keeps its sign where -b as an operand would turn it.
    if b << 1 > INFINITY << 1 {
        return add_exactly(context, a, b);
    }
    add_exactly(context, a, b ^ SIGN)
}

/// FPMul.
#[inline]
pub(crate) fn multiply(context: &mut Context, a: u32, b: u32) -> u32 {
    simple(context.fpscr, Simple::Multiply, a, b).unwrap_or_else(|| multiply_exactly(context, a, b))
}

#[inline(never)]
fn add_exactly(context: &mut Context, a: u32, b: u32) -> u32 {
    let (x, y) = (context.unpack(a), context.unpack(b));
    if let Some(nan) = context.process_nans(&[(x, a), (y, b)]) {
        return nan;
    }
    match (x.kind, y.kind) {
        (Kind::Infinity, Kind::Infinity) if x.sign != y.sign => context.invalid(),
        (Kind::Infinity, _) => a,
        (_, Kind::Infinity) => b,
        (Kind::Zero, Kind::Zero) if x.sign == y.sign => u32::from(x.sign) << 31,
        _ => sum(context, x, y),
    }
}

/// The sum of two finite numbers, not both zero with one sign.
fn sum(context: &mut Context, x: Number, y: Number) -> u32 {
    if x.significand == 0 && y.significand == 0 {
        return context.zero_sum();
    }
    if x.significand == 0 {
        return context.round(y.sign, y.exponent, y.significand);
    }
    if y.significand == 0 {
        return context.round(x.sign, x.exponent, x.significand);
    }
    // Both with the leading one at bit 124; the smaller one moves down. When bits fall off, the exponents differ by
    // more than 70, so nothing cancels and the sticky bit decides as the bits would have.
    let raise = |number: Number| {
        let up = number.significand.leading_zeros() as i32 - 3;
        (number.exponent - up, number.significand << up, number.sign)
    };
    let (mut high, mut low) = (raise(x), raise(y));
    if (low.0, low.1) > (high.0, high.1) {
        std::mem::swap(&mut high, &mut low);
    }
    let moved = jam_wide(low.1, (high.0 - low.0) as u32);
    let total = if high.2 == low.2 { high.1 + moved } else { high.1 - moved };
    if total == 0 { context.zero_sum() } else { context.round(high.2, high.0, total) }
}

#[inline(never)]
fn multiply_exactly(context: &mut Context, a: u32, b: u32) -> u32 {
    let (x, y) = (context.unpack(a), context.unpack(b));
    if let Some(nan) = context.process_nans(&[(x, a), (y, b)]) {
        return nan;
    }
    let sign = x.sign != y.sign;
    let signed = u32::from(sign) << 31;
    match (x.kind, y.kind) {
        (Kind::Infinity, Kind::Zero) | (Kind::Zero, Kind::Infinity) => context.invalid(),
        (Kind::Infinity, _) | (_, Kind::Infinity) => signed | INFINITY,
        (Kind::Zero, _) | (_, Kind::Zero) => signed,
        _ => context.round(sign, x.exponent + y.exponent, x.significand * y.significand),
    }
}

/// FPDiv.
pub(crate) fn divide(context: &mut Context, a: u32, b: u32) -> u32 {
    if context.host_will_do()
        && let Some(bits) = plain(f32::from_bits(a) / f32::from_bits(b))
    {
        return bits;
    }
    let (x, y) = (context.unpack(a), context.unpack(b));
    if let Some(nan) = context.process_nans(&[(x, a), (y, b)]) {
        return nan;
    }
    let sign = x.sign != y.sign;
    let signed = u32::from(sign) << 31;
    match (x.kind, y.kind) {
        (Kind::Infinity, Kind::Infinity) | (Kind::Zero, Kind::Zero) => context.invalid(),
        (Kind::Infinity, _) => signed | INFINITY,
        (Kind::Zero, _) | (_, Kind::Infinity) => signed,
        (_, Kind::Zero) => {
            context.raise(DZC);
            signed | INFINITY
        }
        _ => {
            // At least 64 bits of quotient, the remainder as a sticky bit.
            let dividend = x.significand << 88;
            let quotient = dividend / y.significand;
            let sticky = u128::from(quotient * y.significand != dividend);
            context.round(sign, x.exponent - 88 - y.exponent, quotient | sticky)
        }
    }
}

/// FPSqrt.
pub(crate) fn square_root(context: &mut Context, a: u32) -> u32 {
    if context.host_will_do()
        && let Some(bits) = plain(f32::from_bits(a).sqrt())
    {
        return bits;
    }
    let x = context.unpack(a);
    match x.kind {
        Kind::QuietNan | Kind::SignalingNan => context.process_nan(x, a),
        Kind::Zero => u32::from(x.sign) << 31,
        _ if x.sign => context.invalid(),
        Kind::Infinity => INFINITY,
        Kind::Finite => {
            // An even exponent halves exactly.
            let shift = 80 + (x.exponent & 1);
            let radicand = x.significand << shift;
            let root = radicand.isqrt();
            let sticky = u128::from(root * root != radicand);
            context.round(false, (x.exponent - shift) / 2, root | sticky)
        }
    }
}

/// FPMulAdd: `addend + a * b`, rounded once.
pub(crate) fn fused(context: &mut Context, a: u32, b: u32, addend: u32) -> u32 {
    if context.host_will_do()
        && let Some(bits) = fused_by_host(a, b, addend)
    {
        return bits;
    }
    let (x, y, z) = (context.unpack(a), context.unpack(b), context.unpack(addend));
    let nan = context.process_nans(&[(z, addend), (x, a), (y, b)]);
    let meaningless = matches!((x.kind, y.kind), (Kind::Infinity, Kind::Zero) | (Kind::Zero, Kind::Infinity));
    if meaningless && matches!(z.kind, Kind::QuietNan) {
        return context.invalid();
    }
    if let Some(nan) = nan {
        return nan;
    }
    let sign = x.sign != y.sign;
    let infinite = x.kind == Kind::Infinity || y.kind == Kind::Infinity;
    if meaningless || infinite && z.kind == Kind::Infinity && z.sign != sign {
        return context.invalid();
    }
    if z.kind == Kind::Infinity {
        return addend;
    }
    if infinite {
        return u32::from(sign) << 31 | INFINITY;
    }
    let significand = x.significand * y.significand;
    let kind = if significand == 0 { Kind::Zero } else { Kind::Finite };
    let product = Number { kind, sign, exponent: x.exponent + y.exponent, significand };
    if kind == Kind::Zero && z.kind == Kind::Zero && sign == z.sign {
        return u32::from(sign) << 31;
    }
    sum(context, product, z)
}

/// In double precision the product is exact; the sum is rounded to odd (with the error of the addition, which is
/// exact too), after which rounding to single precision is correct because 53 >= 24 + 2 (Boldo and Melquiond,
/// "Emulation of a FMA and correctly rounded sums", 2008, theorem 1).
fn fused_by_host(a: u32, b: u32, addend: u32) -> Option<u32> {
    let double = |bits| f64::from(f32::from_bits(bits));
    let (product, addend) = (double(a) * double(b), double(addend));
    let sum = product + addend;
    let part = sum - product;
    let error = (product - (sum - part)) + (addend - part);
    let mut bits = sum.to_bits();
    if error != 0.0 && bits & 1 == 0 {
        bits = if (error > 0.0) == (sum > 0.0) { bits + 1 } else { bits.wrapping_sub(1) };
    }
    plain(f64::from_bits(bits) as f32)
}

#[cfg(test)]
mod tests;

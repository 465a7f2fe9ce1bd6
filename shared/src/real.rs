//! The one scalar abstraction: every formula is written once and evaluated in `f64` on the host, in `f32` on the
//! vehicle, and in whatever else implements [`Real`] (the solver's derivatives, for one).
//!
//! Transcendental functions come from `libm` on both sides, never from the platform, so that host and vehicle agree
//! bit for bit. No fused multiply-add is used anywhere for the same reason.

use core::fmt::Debug;
use core::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

/// A real scalar.
pub trait Real:
    Copy
    + Debug
    + PartialEq
    + PartialOrd
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + AddAssign
    + SubAssign
{
    /// The nearest representable value of a constant.
    fn from_f64(value: f64) -> Self;
    /// The value as `f64` (exact for `f32` and `f64`).
    fn to_f64(self) -> f64;
    /// Square root.
    fn sqrt(self) -> Self;
    /// Sine and cosine of an angle in radians.
    fn sin_cos(self) -> (Self, Self);
    /// Four-quadrant arctangent of `self / x`, in (-π, π].
    fn atan2(self, x: Self) -> Self;
    /// ln(1 + self), accurate near zero.
    fn ln_1p(self) -> Self;
    /// Neither infinite nor NaN.
    fn is_finite(self) -> bool;

    /// 0.
    #[inline]
    fn zero() -> Self {
        Self::from_f64(0.0)
    }
    /// 1.
    #[inline]
    fn one() -> Self {
        Self::from_f64(1.0)
    }
    /// Absolute value.
    #[inline]
    fn abs(self) -> Self {
        if self < Self::zero() { -self } else { self }
    }
    /// The smaller of two; `self` where they do not compare.
    #[inline]
    fn min(self, other: Self) -> Self {
        if other < self { other } else { self }
    }
    /// The larger of two; `self` where they do not compare.
    #[inline]
    fn max(self, other: Self) -> Self {
        if other > self { other } else { self }
    }
}

/// The value, or the bound where it is below that or not a number. The bound is a number.
///
/// As [`f32::max`], but by one comparison: on the vehicle that is a call to a routine of thirty instructions.
#[inline]
pub fn at_least(value: f32, bound: f32) -> f32 {
    if value > bound { value } else { bound }
}

/// The value, or the bound where it is above that or not a number. The bound is a number.
#[inline]
pub fn at_most(value: f32, bound: f32) -> f32 {
    if value < bound { value } else { bound }
}

impl Real for f64 {
    #[inline]
    fn from_f64(value: f64) -> Self {
        value
    }
    #[inline]
    fn to_f64(self) -> f64 {
        self
    }
    #[inline]
    fn sqrt(self) -> Self {
        libm::sqrt(self)
    }
    #[inline]
    fn sin_cos(self) -> (Self, Self) {
        libm::sincos(self)
    }
    #[inline]
    fn atan2(self, x: Self) -> Self {
        libm::atan2(self, x)
    }
    #[inline]
    fn ln_1p(self) -> Self {
        libm::log1p(self)
    }
    #[inline]
    fn is_finite(self) -> bool {
        f64::is_finite(self)
    }
}

impl Real for f32 {
    #[inline]
    fn from_f64(value: f64) -> Self {
        value as f32
    }
    #[inline]
    fn to_f64(self) -> f64 {
        f64::from(self)
    }
    #[inline]
    fn sqrt(self) -> Self {
        sqrt(self)
    }
    #[inline]
    fn sin_cos(self) -> (Self, Self) {
        libm::sincosf(self)
    }
    #[inline]
    fn atan2(self, x: Self) -> Self {
        libm::atan2f(self, x)
    }
    #[inline]
    fn ln_1p(self) -> Self {
        libm::log1pf(self)
    }
    #[inline]
    fn is_finite(self) -> bool {
        f32::is_finite(self)
    }
}

/// Square root. Rounded correctly, as IEEE 754 wants it, so that every implementation gives the same bits; the vehicle's
/// processor has an instruction for it that is ten times faster than `libm`.
#[inline]
pub fn sqrt(x: f32) -> f32 {
    #[cfg(all(target_arch = "arm", target_abi = "eabihf"))]
    {
        hardware_sqrt(x)
    }
    #[cfg(not(all(target_arch = "arm", target_abi = "eabihf")))]
    {
        libm::sqrtf(x)
    }
}

#[cfg(all(target_arch = "arm", target_abi = "eabihf"))]
#[allow(unsafe_code)]
#[inline]
fn hardware_sqrt(x: f32) -> f32 {
    let mut bits = x.to_bits();
    // SAFETY: works on registers only; the scratch register is told to the compiler.
    unsafe {
        core::arch::asm!(
            "vmov s15, {bits}",
            "vsqrt.f32 s15, s15",
            "vmov {bits}, s15",
            bits = inout(reg) bits,
            out("s15") _,
            options(pure, nomem, nostack),
        );
    }
    f32::from_bits(bits)
}

//! Forward-mode derivatives: a value with `N` partial derivatives that obeys [`Real`], so that the closed forms of
//! [`mintime_shared::motion`] yield their own Jacobians.

use core::cmp::Ordering;
use core::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

use mintime_shared::real::Real;

/// A value and its partial derivatives with respect to `N` independent variables.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Dual<const N: usize> {
    pub(crate) value: f64,
    pub(crate) grad: [f64; N],
}

impl<const N: usize> Dual<N> {
    /// A number that depends on nothing.
    #[inline]
    pub(crate) fn constant(value: f64) -> Self {
        Self { value, grad: [0.0; N] }
    }

    /// The `index`-th independent variable.
    #[inline]
    pub(crate) fn variable(value: f64, index: usize) -> Self {
        let mut grad = [0.0; N];
        grad[index] = 1.0;
        Self { value, grad }
    }

    /// f(self) by the chain rule.
    #[inline]
    fn chain(self, value: f64, slope: f64) -> Self {
        Self { value, grad: self.grad.map(|g| g * slope) }
    }

    /// f(self, other) by the chain rule.
    #[inline]
    fn chain2(self, other: Self, value: f64, by_self: f64, by_other: f64) -> Self {
        Self { value, grad: core::array::from_fn(|i| by_self * self.grad[i] + by_other * other.grad[i]) }
    }
}

impl<const N: usize> PartialEq for Dual<N> {
    fn eq(&self, other: &Self) -> bool {
        self.value == other.value
    }
}

impl<const N: usize> PartialOrd for Dual<N> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        self.value.partial_cmp(&other.value)
    }
}

impl<const N: usize> Add for Dual<N> {
    type Output = Self;
    #[inline]
    fn add(self, o: Self) -> Self {
        self.chain2(o, self.value + o.value, 1.0, 1.0)
    }
}

impl<const N: usize> Sub for Dual<N> {
    type Output = Self;
    #[inline]
    fn sub(self, o: Self) -> Self {
        self.chain2(o, self.value - o.value, 1.0, -1.0)
    }
}

impl<const N: usize> Mul for Dual<N> {
    type Output = Self;
    #[inline]
    fn mul(self, o: Self) -> Self {
        self.chain2(o, self.value * o.value, o.value, self.value)
    }
}

impl<const N: usize> Div for Dual<N> {
    type Output = Self;
    #[inline]
    fn div(self, o: Self) -> Self {
        let inverse = 1.0 / o.value;
        let quotient = self.value * inverse;
        self.chain2(o, quotient, inverse, -quotient * inverse)
    }
}

impl<const N: usize> Neg for Dual<N> {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        self.chain(-self.value, -1.0)
    }
}

impl<const N: usize> AddAssign for Dual<N> {
    #[inline]
    fn add_assign(&mut self, o: Self) {
        *self = *self + o;
    }
}

impl<const N: usize> SubAssign for Dual<N> {
    #[inline]
    fn sub_assign(&mut self, o: Self) {
        *self = *self - o;
    }
}

impl<const N: usize> Real for Dual<N> {
    #[inline]
    fn from_f64(value: f64) -> Self {
        Self::constant(value)
    }
    #[inline]
    fn to_f64(self) -> f64 {
        self.value
    }
    #[inline]
    fn sqrt(self) -> Self {
        let root = libm::sqrt(self.value);
        self.chain(root, 0.5 / root)
    }
    #[inline]
    fn sin_cos(self) -> (Self, Self) {
        let (s, c) = libm::sincos(self.value);
        (self.chain(s, c), self.chain(c, -s))
    }
    #[inline]
    fn atan2(self, x: Self) -> Self {
        let norm2 = self.value * self.value + x.value * x.value;
        self.chain2(x, libm::atan2(self.value, x.value), x.value / norm2, -self.value / norm2)
    }
    #[inline]
    fn ln_1p(self) -> Self {
        self.chain(libm::log1p(self.value), 1.0 / (1.0 + self.value))
    }
    #[inline]
    fn is_finite(self) -> bool {
        self.value.is_finite() && self.grad.iter().all(|g| g.is_finite())
    }
}

#[cfg(test)]
mod tests {
    use mintime_shared::motion::{Arc, singular};

    use super::*;

    #[test]
    fn arc_moments_have_the_derivatives_of_their_finite_differences() {
        for (rate, drift, tau) in [(0.4, 0.3, 5.0), (-0.9, 0.1, 0.2), (0.05, -0.2, 8.0), (1e-3, 0.0, 3.0)] {
            let dual = singular(
                Arc { rate: Dual::<3>::variable(rate, 0), drift: Dual::variable(drift, 1) },
                Dual::variable(tau, 2),
            );
            let step = 1e-6;
            for index in 0..3 {
                let at = |h: f64| {
                    let mut v = [rate, drift, tau];
                    v[index] += h;
                    singular(Arc { rate: v[0], drift: v[1] }, v[2])
                };
                let (up, down) = (at(step), at(-step));
                for (exact, plus, minus) in [
                    (dual.angle, up.angle, down.angle),
                    (dual.velocity_along, up.velocity_along, down.velocity_along),
                    (dual.velocity_across, up.velocity_across, down.velocity_across),
                    (dual.position_along, up.position_along, down.position_along),
                    (dual.position_across, up.position_across, down.position_across),
                ] {
                    let difference = (plus - minus) / (2.0 * step);
                    let scale = 1.0 + difference.abs();
                    assert!((exact.grad[index] - difference).abs() < 1e-6 * scale, "{exact:?} {difference}");
                }
            }
        }
    }
}

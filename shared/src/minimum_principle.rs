//! Pontryagin's minimum principle for the planar quadrotor: costate, Hamiltonian, switching functions and control laws
//! of the paper's section III. Everything here is dimensionless, eq. (3)-(5): gravity and rate limit are 1.

use serde::{Deserialize, Serialize};

use crate::model::{RateMode, State, ThrustLevel};
use crate::motion::Arc;
use crate::real::Real;

/// The four constants of the translational costate, eq. (9): p1 = c1, p2 = c2 − c1 t, p3 = c3, p4 = c4 − c3 t.
/// Normalised by H = 0 with the constant 1 of eq. (7).
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Costate<T> {
    /// c1 = p1.
    pub c1: T,
    /// c2 = p2(0).
    pub c2: T,
    /// c3 = p3.
    pub c3: T,
    /// c4 = p4(0).
    pub c4: T,
}

impl<T: Real> Costate<T> {
    /// From the order (c1, c2, c3, c4).
    pub fn from_array([c1, c2, c3, c4]: [T; 4]) -> Self {
        Self { c1, c2, c3, c4 }
    }

    /// In the order (c1, c2, c3, c4).
    pub fn to_array(self) -> [T; 4] {
        [self.c1, self.c2, self.c3, self.c4]
    }

    /// p2(t) = c2 − c1 t, eq. (9).
    pub fn p2(&self, t: T) -> T {
        self.c2 - self.c1 * t
    }

    /// p4(t) = c4 − c3 t, eq. (9).
    pub fn p4(&self, t: T) -> T {
        self.c4 - self.c3 * t
    }

    /// The thrust switching function Φ_T, eq. (18).
    pub fn phi_t(&self, t: T, theta: T) -> T {
        let (s, c) = theta.sin_cos();
        self.p2(t) * s + self.p4(t) * c
    }

    /// Φ̇_R, eq. (13), at thrust `u_t`.
    pub fn phi_r_rate(&self, t: T, theta: T, u_t: T) -> T {
        let (s, c) = theta.sin_cos();
        u_t * (self.p4(t) * s - self.p2(t) * c)
    }

    /// h = H − Φ_R u_R: the part of the Hamiltonian (7) that does not contain the rate. Since H ≡ 0 on an extremal,
    /// Φ_R u_R = −h, and law (16) is h ≥ 0 on every bang arc, h = 0 on a singular one.
    pub fn rate_free_hamiltonian(&self, t: T, state: &State<T>, u_t: T) -> T {
        T::one() + self.c1 * state.vx + self.c3 * state.vz + u_t * self.phi_t(t, state.theta) - self.p4(t)
    }

    /// The Hamiltonian, eq. (7).
    pub fn hamiltonian(&self, t: T, state: &State<T>, u_r: T, u_t: T, phi_r: T) -> T {
        self.rate_free_hamiltonian(t, state, u_t) + phi_r * u_r
    }

    /// The pitch angle on a singular arc in (−π, π]: the branch of eq. (14) that satisfies the generalised
    /// Legendre-Clebsch (Kelley) condition Φ_T ≤ 0, thrust anti-parallel to (p2, p4).
    pub fn singular_angle(&self, t: T) -> T {
        (-self.p2(t)).atan2(-self.p4(t))
    }

    /// The singular rate, eq. (15).
    pub fn singular_rate(&self, t: T) -> T {
        self.arc(t).rate
    }

    /// The singular arc that is entered at time `t`. `None`-free: where (p2, p4) vanishes the numbers are not finite.
    pub fn arc(&self, t: T) -> Arc<T> {
        let (p2, p4) = (self.p2(t), self.p4(t));
        let norm2 = p2 * p2 + p4 * p4;
        Arc {
            rate: (self.c2 * self.c3 - self.c1 * self.c4) / norm2,
            drift: (p2 * self.c1 + p4 * self.c3) / norm2,
        }
    }

    /// d²Φ_R/dt² contains −u_T·(Kelley margin)·u_R with the margin −Φ_T: it must not be negative on a singular arc.
    pub fn kelley_margin(&self, t: T, theta: T) -> T {
        -self.phi_t(t, theta)
    }
}

/// The control law (16): which rate minimises the Hamiltonian. `Singular` at exactly zero.
pub fn optimal_rate<T: Real>(phi_r: T) -> RateMode {
    if phi_r < T::zero() {
        RateMode::Plus
    } else if phi_r > T::zero() {
        RateMode::Minus
    } else {
        RateMode::Singular
    }
}

/// The control law (20): which thrust minimises the Hamiltonian.
pub fn optimal_thrust<T: Real>(phi_t: T) -> ThrustLevel {
    if phi_t > T::zero() { ThrustLevel::Min } else { ThrustLevel::Max }
}

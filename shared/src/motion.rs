//! Exact motion over one segment: a bang arc (constant rate) or a singular arc (rate of eq. (15)), in closed form.
//!
//! Both are the same integral. With thrust F held, the acceleration is F n(σ) − g ẑ, where n = (sin θ, cos θ) turns by
//! the angle φ(σ) since the segment began, so only four *moments* of the turn are needed, in the frame of the entry
//! direction (along it, and across it on the side to which θ grows):
//!
//! ∫cos φ, ∫sin φ for the velocity, and the same under ∫(τ − σ)·dσ for the position.
//!
//! On a singular arc p(σ) = p(0) − σ (c1, c3) moves along a straight line and n = −p/|p|. Everything depends on two
//! numbers taken at the entry, the rate x and d = p·(c1, c3)/|p|²:
//!
//! u_R(σ) = x / Q²(σ),  Q² = 1 − 2dσ + (x² + d²)σ²,  Q = |p(σ)|/|p(0)|,
//!
//! which stays regular where p does not move at all (x = d = 0: a straight line).
//!
//! Units are whatever the caller is consistent in: SI, or the dimensionless ones of eq. (3) with gravity = 1.

use crate::model::State;
use crate::real::Real;

/// What a segment does to the direction of thrust: total turn, and the moments of the direction in the entry frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Turn<T> {
    /// Change of θ over the segment, rad.
    pub angle: T,
    /// ∫cos φ dσ.
    pub velocity_along: T,
    /// ∫sin φ dσ.
    pub velocity_across: T,
    /// ∫(τ − σ) cos φ dσ.
    pub position_along: T,
    /// ∫(τ − σ) sin φ dσ.
    pub position_across: T,
}

/// A singular arc as seen from its entry: eq. (15) with time counted from there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Arc<T> {
    /// Rate at the entry, x.
    pub rate: T,
    /// d = p·(c1, c3)/|p|² at the entry: minus half the logarithmic derivative of |p|².
    pub drift: T,
}

impl<T: Real> Arc<T> {
    /// Q²(σ), the squared length of p relative to the entry.
    fn q_squared(&self, sigma: T) -> T {
        let along = T::one() - self.drift * sigma;
        let across = self.rate * sigma;
        along * along + across * across
    }

    /// The singular rate, eq. (15), a time σ after the entry.
    pub fn rate_at(&self, sigma: T) -> T {
        self.rate / self.q_squared(sigma)
    }

    /// The turn θ(σ) − θ(0).
    pub fn angle_at(&self, sigma: T) -> T {
        (self.rate * sigma).atan2(T::one() - self.drift * sigma)
    }

    /// The same arc seen from a time σ later.
    pub fn advanced(&self, sigma: T) -> Self {
        let q2 = self.q_squared(sigma);
        let k2 = self.rate * self.rate + self.drift * self.drift;
        Self { rate: self.rate / q2, drift: (self.drift - k2 * sigma) / q2 }
    }

    /// The largest |u_R| for 0 ≤ σ ≤ τ: at the point of the interval where |p| is smallest.
    pub fn peak_rate(&self, tau: T) -> T {
        let k2 = self.rate * self.rate + self.drift * self.drift;
        let nearest = if k2 > T::zero() { (self.drift / k2).max(T::zero()).min(tau) } else { T::zero() };
        self.rate_at(nearest).abs()
    }
}

/// A constant rate for a time τ. Exact at every rate, zero included.
pub fn bang<T: Real>(rate: T, tau: T) -> Turn<T> {
    let angle = rate * tau;
    let (s, c) = angle.sin_cos();
    // sin a / a, (1 − cos a)/a, (1 − cos a)/a², (a − sin a)/a²
    let (sinc, versine, half, cubic) = if angle.abs() > T::from_f64(0.25) {
        let v = T::one() - c;
        (s / angle, v / angle, v / (angle * angle), (angle - s) / (angle * angle))
    } else {
        // Taylor series: the closed forms cancel here, and at 0.25 the first term left out is below 1e-17.
        let q = angle * angle;
        let series = |coefficients: [f64; 6]| {
            coefficients.iter().rev().fold(T::one(), |sum, &k| T::one() - q * sum * T::from_f64(k))
        };
        let sinc = series([1.0 / 6.0, 1.0 / 20.0, 1.0 / 42.0, 1.0 / 72.0, 1.0 / 110.0, 1.0 / 156.0]);
        let half = series([1.0 / 12.0, 1.0 / 30.0, 1.0 / 56.0, 1.0 / 90.0, 1.0 / 132.0, 1.0 / 182.0])
            * T::from_f64(0.5);
        let cubic = series([1.0 / 20.0, 1.0 / 42.0, 1.0 / 72.0, 1.0 / 110.0, 1.0 / 156.0, 1.0 / 210.0])
            * angle
            * T::from_f64(1.0 / 6.0);
        (sinc, half * angle, half, cubic)
    };
    Turn {
        angle,
        velocity_along: sinc * tau,
        velocity_across: versine * tau,
        position_along: half * tau * tau,
        position_across: cubic * tau * tau,
    }
}

/// A singular arc for a time τ.
pub fn singular<T: Real>(arc: Arc<T>, tau: T) -> Turn<T> {
    // cos φ = (1 − dσ)/Q and sin φ = xσ/Q, so three moments of 1/Q give all four integrals.
    let (x, d) = (arc.rate, arc.drift);
    let [m0, m1, m2] = inverse_moments(d, x * x, tau);
    Turn {
        angle: arc.angle_at(tau),
        velocity_along: m0 - d * m1,
        velocity_across: x * m1,
        position_along: tau * (m0 - d * m1) - (m1 - d * m2),
        position_across: x * (tau * m1 - m2),
    }
}

/// ∫σⁿ/Q(σ) dσ over \[0, τ\], n = 0, 1, 2, with Q² = (1 − dσ)² + x²σ² > 0. Takes x², not x, so that its
/// derivatives stay finite where x = 0.
pub fn inverse_moments<T: Real>(d: T, x_squared: T, tau: T) -> [T; 3] {
    let q_squared = |sigma: T| {
        let along = T::one() - d * sigma;
        along * along + x_squared * sigma * sigma
    };
    let k2 = x_squared + d * d;
    if k2 * tau * tau < T::from_f64(0.25) {
        // Closed forms cancel for short arcs; 1/Q is analytic with its nearest singularity at |σ| = 1/k, so ten Gauss
        // points are exact to rounding here.
        let half = tau * T::from_f64(0.5);
        let mut sums = [T::zero(); 3];
        for (node, weight) in GAUSS_10 {
            for sign in [-1.0, 1.0] {
                let sigma = half * T::from_f64(1.0 + sign * node);
                let f = T::from_f64(weight) * half / q_squared(sigma).sqrt();
                sums[0] += f;
                sums[1] += f * sigma;
                sums[2] += f * sigma * sigma;
            }
        }
        return sums;
    }
    let k = k2.sqrt();
    let q = q_squared(tau).sqrt();
    let two = T::from_f64(2.0);
    let y = k * tau / (T::one() + q);
    // ∫dσ/Q = 2 artanh(y)/k; y < 1 unless p runs through the origin, which |u_R| ≤ 1 rules out. Where the arc begins close
    // to the origin y may round to 1 all the same: the same quotient by (1 + q)² − k²τ² = 2 (1 + q − dτ).
    let excess = if y < T::one() {
        two * y / (T::one() - y)
    } else {
        let sum = T::one() + q + k * tau;
        sum * sum / (two * (T::one() + q - d * tau)) - T::one()
    };
    let m0 = excess.ln_1p() / k;
    let m1 = (q - T::one() + d * m0) / k2;
    let m2 = (tau * q - m0 + T::from_f64(3.0) * d * m1) / (two * k2);
    [m0, m1, m2]
}

/// Positive nodes and weights of the ten-point Gauss-Legendre rule on \[−1, 1\].
const GAUSS_10: [(f64, f64); 5] = [
    (0.148_874_338_981_631_21, 0.295_524_224_714_752_87),
    (0.433_395_394_129_247_2, 0.269_266_719_309_996_36),
    (0.679_409_568_299_024_4, 0.219_086_362_515_982_04),
    (0.865_063_366_688_984_5, 0.149_451_349_150_580_6),
    (0.973_906_528_517_171_7, 0.066_671_344_308_688_14),
];

/// The state after a segment of length `tau` with thrust per mass `thrust` and the given turn.
pub fn advance<T: Real>(state: State<T>, thrust: T, gravity: T, tau: T, turn: &Turn<T>) -> State<T> {
    let (s, c) = state.theta.sin_cos();
    // Along = (s, c) and across = (c, −s) in (x, z): θ grows from z towards x.
    let rotate = |along: T, across: T| (along * s + across * c, along * c - across * s);
    let (dvx, dvz) = rotate(turn.velocity_along, turn.velocity_across);
    let (dx, dz) = rotate(turn.position_along, turn.position_across);
    State {
        x: state.x + state.vx * tau + thrust * dx,
        vx: state.vx + thrust * dvx,
        z: state.z + state.vz * tau + thrust * dz - gravity * tau * tau * T::from_f64(0.5),
        vz: state.vz + thrust * dvz - gravity * tau,
        theta: state.theta + turn.angle,
    }
}

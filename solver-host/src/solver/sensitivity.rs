//! How T changes with the data of a maneuver, read off its costate.

use mintime_shared::model::{RateMode, Segment, State, ThrustLevel};
use serde::{Deserialize, Serialize};

use super::extremal::Extremal;

/// Derivatives of T, SI units. They belong to the maneuver's own branch: where another structure or winding takes over,
/// T has a kink.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Sensitivities {
    /// ∂T/∂(x, ẋ, z, ż, θ) at the start: p(0). s/m, s²/m, s/m, s²/m, s/rad.
    pub from: [f64; 5],
    /// The same at the end: −p(T).
    pub to: [f64; 5],
    /// ∂T/∂(F_min/m), s³/m: at least zero.
    pub thrust_min: f64,
    /// ∂T/∂(F_max/m), s³/m: at most zero.
    pub thrust_max: f64,
    /// ∂T/∂ω_max, s²/rad: at most zero.
    pub rate_max: f64,
}

impl Extremal {
    /// The derivatives of T with respect to start, end and limits.
    ///
    /// The first two are the costate itself. For the limits, ∂T/∂λ = ∫∂H/∂λ dt along the extremal: Φ_T over the phases
    /// at the thrust limit in question, and −|Φ_R| over the bang arcs (both by H = 0, eq. (7)).
    pub fn sensitivities(&self) -> Sensitivities {
        let (rate, gravity) = (self.limits.rate_max_radps, self.limits.gravity_mps2);
        let t = self.duration_s() * rate;
        let c = &self.costate;
        let to_si = |[p1, p2, p3, p4, p5]: [f64; 5]| {
            [p1 * rate / gravity, p2 / gravity, p3 * rate / gravity, p4 / gravity, p5 / rate]
        };
        let p5_end = self.phi_r_at(self.duration_s());
        let [mut low, mut high, mut turning] = [0.0; 3];
        let mut begin_s = 0.0;
        let mut begin = self.from;
        for segment in &self.segments {
            let [phi_t, h] = self.integrals(segment, begin_s, begin);
            match segment.inputs.thrust {
                ThrustLevel::Min => low += phi_t,
                ThrustLevel::Max => high += phi_t,
            }
            if segment.inputs.rate != RateMode::Singular {
                // Φ_R u_R = −h on a bang.
                turning -= h;
            }
            begin = self.advance(segment, begin_s, begin, segment.duration);
            begin_s += segment.duration;
        }
        Sensitivities {
            from: to_si([c.c1, c.c2, c.c3, c.c4, self.phi_r0]),
            to: to_si([-c.c1, -c.p2(t), -c.c3, -c.p4(t), -p5_end]),
            thrust_min: low / (rate * gravity),
            thrust_max: high / (rate * gravity),
            rate_max: turning / (rate * rate),
        }
    }

    /// ∫Φ_T and ∫h over a segment, dimensionless.
    fn integrals(&self, segment: &Segment<f64>, begin_s: f64, begin: State<f64>) -> [f64; 2] {
        let scale = self.limits.scale();
        let u_t = self.limits.dimensionless().thrust(segment.inputs.thrust);
        let steps = libm::ceil(segment.duration / scale.time_s).max(1.0);
        let half_s = 0.5 * segment.duration / steps;
        let mut sums = [0.0; 2];
        for i in 0..steps as u32 {
            for (node, weight) in GAUSS_6 {
                for sign in [-1.0, 1.0] {
                    let tau_s = half_s * (f64::from(2 * i + 1) + sign * node);
                    let state = scale.to_dimensionless(self.advance(segment, begin_s, begin, tau_s));
                    let time = (begin_s + tau_s) / scale.time_s;
                    let w = weight * half_s / scale.time_s;
                    sums[0] += w * self.costate.phi_t(time, state.theta);
                    sums[1] += w * self.costate.rate_free_hamiltonian(time, &state, u_t);
                }
            }
        }
        sums
    }
}

/// Positive nodes and weights of the six-point Gauss-Legendre rule on \[−1, 1\]: over one radian its error is below
/// 1e-14.
pub(crate) const GAUSS_6: [(f64, f64); 3] = [
    (0.238_619_186_083_196_9, 0.467_913_934_572_691),
    (0.661_209_386_466_264_5, 0.360_761_573_048_138_6),
    (0.932_469_514_203_152, 0.171_324_492_379_170_35),
];

//! The certificate law by law: what the minimum principle demands, what was found, what rounding may make of it.

use serde::Serialize;

use crate::solver::{RATE_TOLERANCE, Solution, Tolerances};

/// A maneuver's certificate.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Laws {
    /// All laws hold.
    pub verified: bool,
    /// The costate or the thrust is not unique; an extremal all the same.
    pub degenerate: bool,
    /// The laws.
    pub laws: Vec<Law>,
    /// Constants c1 to c4 of the costate, eq. (9), dimensionless.
    pub costate: [f64; 4],
    /// Φ_R at the start, dimensionless.
    pub phi_r0: f64,
    /// Full turns, positive towards +x.
    pub turns: i32,
    /// Other windings: turns and the duration of the best maneuver found with them, s.
    pub others: Vec<(i32, f64)>,
    /// No maneuver between these states is faster, s.
    pub lower_bound_s: f64,
}

/// One law of the minimum principle, or one condition on the maneuver.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Law {
    /// Its name.
    pub name: &'static str,
    /// What it says.
    pub says: &'static str,
    /// What was found.
    pub found: f64,
    /// The bound on it.
    pub bound: f64,
    /// Whether the bound is the least that is allowed, not the most.
    pub at_least: bool,
    /// Unit; empty for dimensionless numbers.
    pub unit: &'static str,
    /// Whether it holds.
    pub holds: bool,
}

fn at_most(name: &'static str, says: &'static str, found: f64, bound: f64, unit: &'static str) -> Law {
    Law { name, says, found, bound, at_least: false, unit, holds: found <= bound }
}

fn at_least(name: &'static str, says: &'static str, found: f64, bound: f64, unit: &'static str) -> Law {
    Law { name, says, found, bound, at_least: true, unit, holds: found >= bound }
}

impl Laws {
    pub(super) fn of(solution: &Solution) -> Self {
        let (extremal, certificate) = (&solution.extremal, &solution.certificate);
        let Tolerances { final_state, law } = Tolerances::of(extremal);
        let arrival = [
            ("arrives: x", "m"),
            ("arrives: speed in x", "m/s"),
            ("arrives: z", "m"),
            ("arrives: speed in z", "m/s"),
            ("arrives: pitch", "rad"),
        ];
        const ARRIVES: &str = "the motion, integrated by a method of its own, ends in the demanded state";
        let mut laws: Vec<Law> = arrival
            .into_iter()
            .zip(certificate.final_state_error.into_iter().zip(final_state))
            .map(|((name, unit), (error, most))| at_most(name, ARRIVES, error.abs(), most, unit))
            .collect();
        laws.extend([
            at_most(
                "H = 0",
                "the Hamiltonian (7) vanishes all along: the end time is free",
                certificate.hamiltonian,
                law,
                "",
            ),
            at_most(
                "control laws",
                "the pitch rate is at +limit where Φ_R < 0 and at −limit where Φ_R > 0 (16); the thrust is highest where Φ_T < 0 and lowest where Φ_T > 0 (20)",
                certificate.control_law,
                law,
                "",
            ),
            at_least(
                "Kelley",
                "on singular arcs −Φ_T ≥ 0: they minimise, and do not maximise",
                certificate.kelley,
                -law,
                "",
            ),
            at_most(
                "rate on arcs",
                "singular arcs turn within the rate limit, |u_R| ≤ 1",
                certificate.singular_rate_max,
                1.0 + RATE_TOLERANCE,
                "",
            ),
            Law {
                holds: certificate.min_segment_s > 0.0,
                ..at_least("segments", "every segment lasts", certificate.min_segment_s, 0.0, "s")
            },
            at_least(
                "lower bound",
                "T is not below what no maneuver can beat: that with an unlimited body rate, and |Δθ|/ω_max",
                extremal.duration_s(),
                certificate.lower_bound_s * (1.0 - BOUND_ROUNDING),
                "s",
            ),
        ]);
        Self {
            verified: certificate.verified,
            degenerate: certificate.degenerate,
            laws,
            costate: extremal.costate.to_array(),
            phi_r0: extremal.phi_r0,
            turns: extremal.turns,
            others: solution.alternatives.iter().map(|a| (a.turns, a.duration_s)).collect(),
            lower_bound_s: certificate.lower_bound_s,
        }
    }
}

/// Where T is the bound itself, rounding may put either above the other.
const BOUND_ROUNDING: f64 = 1e-9;

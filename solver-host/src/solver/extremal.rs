//! A maneuver that satisfies the minimum principle, and what can be read off it.

use core::f64::consts::TAU;

use heapless::Vec;
use mintime_shared::minimum_principle::Costate;
use mintime_shared::model::{Inputs, Limits, RateMode, Segment, State};
use mintime_shared::motion::{Arc, advance, bang, singular};
use serde::{Deserialize, Serialize};

use super::problem::Problem;
use super::structure::{Candidate, MAX_SEGMENTS};

/// An extremal: inputs over time, and the costate that proves them stationary.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Extremal {
    /// Start, SI.
    pub from: State<f64>,
    /// End as asked for, SI, without the winding: see [`Extremal::end`].
    pub to: State<f64>,
    /// Limits, SI.
    pub limits: Limits<f64>,
    /// Winding k: the maneuver ends at θ_T + 2πk.
    pub turns: i32,
    /// Segments in order; durations in s, above zero.
    pub segments: Vec<Segment<f64>, MAX_SEGMENTS>,
    /// Constants of eq. (9), dimensionless, H = 0 with the constant 1.
    pub costate: Costate<f64>,
    /// Φ_R(0) = p5(0), dimensionless.
    pub phi_r0: f64,
}

/// A place within an extremal.
struct Located {
    segment: Segment<f64>,
    /// Time since the segment began, s.
    since_s: f64,
    /// Start of the segment.
    begin_s: f64,
    begin: State<f64>,
}

impl Extremal {
    /// From a solution of the core in the units of eq. (3). Pieces without length are left out.
    pub(crate) fn new(
        from: State<f64>,
        to: State<f64>,
        limits: &Limits<f64>,
        turns: i32,
        core: &Candidate,
    ) -> Self {
        let time_s = limits.scale().time_s;
        let mut segments = Vec::new();
        for piece in &core.pieces {
            if piece.length > SHORTEST {
                // Capacities are equal, so there is room.
                let _ = segments.push(Segment { inputs: piece.inputs, duration: piece.length * time_s });
            }
        }
        let costate = Costate::from_array(core.c);
        let problem = Problem::new(from, to, limits, turns);
        let phi_r0 = core.pieces.iter().find(|p| p.length > SHORTEST).map_or(0.0, |piece| {
            let start = State::from_array(problem.from);
            let h = costate.rate_free_hamiltonian(0.0, &start, problem.thrust(piece.inputs.thrust));
            -h * piece.sign()
        });
        Self { from, to, limits: *limits, turns, segments, costate, phi_r0 }
    }

    /// T, s.
    pub fn duration_s(&self) -> f64 {
        self.segments.iter().map(|s| s.duration).sum()
    }

    /// The end with its winding: `to` with 2πk added to the angle.
    pub fn end(&self) -> State<f64> {
        State { theta: self.to.theta + f64::from(self.turns) * TAU, ..self.to }
    }

    /// The state at time `t_s`, SI, exact. Times outside \[0, T\] give the nearest end.
    pub fn state_at(&self, t_s: f64) -> State<f64> {
        self.locate(t_s).map_or(self.from, |l| self.advance(&l.segment, l.begin_s, l.begin, l.since_s))
    }

    /// The inputs at time `t_s`; at a switch those that follow. `None` for a maneuver without segments.
    pub fn inputs_at(&self, t_s: f64) -> Option<Inputs> {
        self.locate(t_s).map(|l| l.segment.inputs)
    }

    /// The pitch rate at time `t_s`, rad/s; on a singular arc that of eq. (15).
    pub fn rate_at(&self, t_s: f64) -> f64 {
        let limit = self.limits.rate_max_radps;
        self.locate(t_s).map_or(0.0, |l| match l.segment.inputs.rate {
            RateMode::Plus => limit,
            RateMode::Minus => -limit,
            RateMode::Singular => self.costate.singular_rate((l.begin_s + l.since_s) * limit) * limit,
        })
    }

    /// The collective thrust per mass at time `t_s`, m/s².
    pub fn thrust_at(&self, t_s: f64) -> f64 {
        self.inputs_at(t_s).map_or(0.0, |i| self.limits.thrust(i.thrust))
    }

    /// The switching function Φ_T of eq. (18) at time `t_s`, dimensionless.
    pub fn phi_t_at(&self, t_s: f64) -> f64 {
        self.costate
            .phi_t(t_s.clamp(0.0, self.duration_s()) * self.limits.rate_max_radps, self.state_at(t_s).theta)
    }

    /// The switching function Φ_R of eq. (12) at time `t_s`, dimensionless, by H = 0; zero on singular arcs.
    pub fn phi_r_at(&self, t_s: f64) -> f64 {
        self.locate(t_s).map_or(0.0, |l| {
            let sign: f64 = l.segment.inputs.rate.sign().unwrap_or(0.0);
            -sign * self.rate_free_hamiltonian(&l)
        })
    }

    /// The Hamiltonian of eq. (7) at time `t_s` with Φ_R taken from its initial value on the first segment; zero along
    /// an extremal. [`super::verify()`] integrates Φ_R itself.
    pub fn rate_free_hamiltonian_at(&self, t_s: f64) -> f64 {
        self.locate(t_s).map_or(0.0, |l| self.rate_free_hamiltonian(&l))
    }

    fn rate_free_hamiltonian(&self, l: &Located) -> f64 {
        let scale = self.limits.scale();
        let state = self.advance(&l.segment, l.begin_s, l.begin, l.since_s);
        let thrust = self.limits.dimensionless().thrust(l.segment.inputs.thrust);
        let t = (l.begin_s + l.since_s) / scale.time_s;
        self.costate.rate_free_hamiltonian(t, &scale.to_dimensionless(state), thrust)
    }

    pub(crate) fn advance(
        &self,
        segment: &Segment<f64>,
        begin_s: f64,
        begin: State<f64>,
        tau_s: f64,
    ) -> State<f64> {
        let limit = self.limits.rate_max_radps;
        let turn = match segment.inputs.rate {
            RateMode::Plus => bang(limit, tau_s),
            RateMode::Minus => bang(-limit, tau_s),
            RateMode::Singular => {
                let arc = self.costate.arc(begin_s * limit);
                singular(Arc { rate: arc.rate * limit, drift: arc.drift * limit }, tau_s)
            }
        };
        advance(begin, self.limits.thrust(segment.inputs.thrust), self.limits.gravity_mps2, tau_s, &turn)
    }

    fn locate(&self, t_s: f64) -> Option<Located> {
        let mut begin_s = 0.0;
        let mut begin = self.from;
        let last = self.segments.len().checked_sub(1)?;
        for (i, segment) in self.segments.iter().enumerate() {
            let end_s = begin_s + segment.duration;
            if t_s < end_s || i == last {
                let since_s = (t_s - begin_s).clamp(0.0, segment.duration);
                return Some(Located { segment: *segment, since_s, begin_s, begin });
            }
            begin = self.advance(segment, begin_s, begin, segment.duration);
            begin_s = end_s;
        }
        None
    }
}

/// Pieces up to this length (1/ω_max or rad) are not there: below it the rounding of T decides their sign.
pub(crate) const SHORTEST: f64 = 1e-11;

//! What is asked, what is answered, and why there may be no answer.

use mintime_shared::model::{Limits, LimitsError, State};
use serde::{Deserialize, Serialize};

use super::extremal::Extremal;
use super::verify::Certificate;

/// Which windings k may be flown; the end angle is θ_T + 2πk. Angles count as given, unwrapped.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum Turns {
    /// The fastest of all with |θ_T + 2πk − θ_0| ≤ 4π.
    #[default]
    Any,
    /// This k only.
    Exactly(i32),
}

/// A question: the minimum-time maneuver between two states. SI units.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Request {
    /// Start.
    pub from: State<f64>,
    /// End, without winding.
    pub to: State<f64>,
    /// Limits of the vehicle.
    pub limits: Limits<f64>,
    /// Windings allowed.
    pub turns: Turns,
}

impl Request {
    /// Rest to rest at level attitude over a displacement (m), limits of the paper's Table I, any winding.
    pub fn rest_to_rest(x_m: f64, z_m: f64) -> Self {
        Self {
            from: State::origin(),
            to: State::at_rest(x_m, z_m),
            limits: Limits::TABLE_I,
            turns: Turns::Any,
        }
    }

    /// Checks everything that can be checked before solving.
    ///
    /// # Errors
    /// [`SolveError::NotFinite`], [`SolveError::Limits`] (F_min ≥ g is let through: such maneuvers exist),
    /// [`SolveError::TooManyTurns`], [`SolveError::AlreadyThere`].
    pub fn validate(&self) -> Result<(), SolveError> {
        if !self.from.is_finite() || !self.to.is_finite() {
            return Err(SolveError::NotFinite);
        }
        match self.limits.validate() {
            Ok(()) | Err(LimitsError::CannotSink) => {}
            Err(error) => return Err(SolveError::Limits(error)),
        }
        if let Turns::Exactly(k) = self.turns
            && k.unsigned_abs() > MOST_TURNS
        {
            return Err(SolveError::TooManyTurns);
        }
        // The same attitude may be whole turns away.
        let away = (self.to.theta - self.from.theta) / core::f64::consts::TAU;
        let there = match self.turns {
            Turns::Any => (away - libm::round(away)).abs() < SAME_ANGLE,
            Turns::Exactly(k) => (away + f64::from(k)).abs() < SAME_ANGLE,
        };
        if there && (State { theta: self.to.theta, ..self.from }) == self.to {
            return Err(SolveError::AlreadyThere);
        }
        Ok(())
    }
}

/// Parts of a turn that are rounding.
const SAME_ANGLE: f64 = 1e-14;

/// Most whole turns that can be asked for.
pub const MOST_TURNS: u32 = 8;

/// A winding that was solved but did not win, or ties with the winner as its mirror image.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Alternative {
    /// Winding k.
    pub turns: i32,
    /// T of the best extremal found with it, s.
    pub duration_s: f64,
}

/// Most alternatives reported.
pub const MAX_ALTERNATIVES: usize = 12;

/// An answer.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Solution {
    /// The fastest maneuver found.
    pub extremal: Extremal,
    /// Its independent check; `verified` is true.
    pub certificate: Certificate,
    /// Other windings that were solved on the way, fastest first. Windings abandoned because they cannot win are not
    /// listed.
    pub alternatives: heapless::Vec<Alternative, MAX_ALTERNATIVES>,
    /// Evaluations of residual and Jacobian it took.
    pub evaluations: u32,
}

/// Why there is no answer.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum SolveError {
    /// NaN or infinite.
    #[error("the start or end state is not finite: give five finite numbers each (x, vx, z, vz, theta)")]
    NotFinite,
    /// Limits that cannot be planned with.
    #[error("{0}")]
    Limits(#[from] LimitsError),
    /// More than [`MOST_TURNS`] turns.
    #[error("that many full turns are not supported: ask for at most 8 either way")]
    TooManyTurns,
    /// Start and end are the same state: T = 0.
    #[error(
        "start and end are the same state, so there is nothing to fly (T = 0): change the end or ask for a turn"
    )]
    AlreadyThere,
    /// The caller cancelled.
    #[error("cancelled after {evaluations} evaluations")]
    Cancelled {
        /// Evaluations spent.
        evaluations: u32,
    },
    /// No maneuver passed the independent check.
    #[error(
        "no verified minimum-time maneuver was found (lower bound {lower_bound_s:.6} s, {evaluations} evaluations): \
         move the start or end a little, or fix the number of turns"
    )]
    NotVerified {
        /// T of the fastest maneuver that reaches the end but breaks a law, s, if any.
        feasible_s: Option<f64>,
        /// Nothing is faster than this, s.
        lower_bound_s: f64,
        /// Evaluations spent.
        evaluations: u32,
        /// Wall time spent, s; 0 where there is no clock.
        elapsed_s: f64,
    },
}

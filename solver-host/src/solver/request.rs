//! What is asked, what is answered, and why there may be no answer.

use core::f64::consts::TAU;
use core::fmt;

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
    /// [`SolveError::AngleTooLarge`], [`SolveError::TooManyTurns`], [`SolveError::AlreadyThere`].
    pub fn validate(&self) -> Result<(), SolveError> {
        if !self.from.is_finite() || !self.to.is_finite() {
            return Err(SolveError::NotFinite);
        }
        match self.limits.validate() {
            Ok(()) | Err(LimitsError::CannotSink) => {}
            Err(error) => return Err(SolveError::Limits(error)),
        }
        if self.from.theta.abs().max(self.to.theta.abs()) > ANGLE_MAX_RAD {
            return Err(SolveError::AngleTooLarge);
        }
        let away = (self.to.theta - self.from.theta) / TAU;
        if let Turns::Exactly(k) = self.turns
            && (away + f64::from(k)).abs() > f64::from(MOST_TURNS) + 0.5 + SAME_ANGLE
        {
            return Err(SolveError::TooManyTurns);
        }
        // The same attitude may be whole turns away.
        let left = match self.turns {
            Turns::Any => away + f64::from(self.nearest_turns()),
            Turns::Exactly(k) => away + f64::from(k),
        };
        let there = left.abs() < SAME_ANGLE * (1.0 + self.from.theta.abs() + self.to.theta.abs());
        if there && (State { theta: self.to.theta, ..self.from }) == self.to {
            return Err(SolveError::AlreadyThere);
        }
        Ok(())
    }

    /// The winding k with the least net turn |θ_T + 2πk − θ_0|.
    pub fn nearest_turns(&self) -> i32 {
        // Beyond an i32 it saturates; such angles are refused.
        -libm::round((self.to.theta - self.from.theta) / TAU) as i32
    }

    /// The same question with whole turns taken off both angles, and what must be added to its windings to get this one's:
    /// only differences count, and large angles cost digits.
    pub(crate) fn reduced(&self) -> (Self, i32) {
        // Angles within a turn stay exactly as they are.
        let whole = |angle: f64| if angle.abs() < TAU { 0.0 } else { libm::round(angle / TAU) };
        let (start, end) = (whole(self.from.theta), whole(self.to.theta));
        let shift = (start - end) as i32;
        let turns = match self.turns {
            Turns::Any => Turns::Any,
            Turns::Exactly(k) => Turns::Exactly(k.saturating_sub(shift)),
        };
        let from = State { theta: self.from.theta - start * TAU, ..self.from };
        let to = State { theta: self.to.theta - end * TAU, ..self.to };
        (Self { from, to, turns, ..*self }, shift)
    }
}

/// Parts of a turn that are rounding.
const SAME_ANGLE: f64 = 1e-14;

/// Most whole turns that can be asked for, net: |θ_T + 2πk − θ_0| is at most half a turn more.
pub const MOST_TURNS: u32 = 8;

/// Largest start or end angle, rad: beyond it an f64 does not hold the angle as finely as it is checked.
pub const ANGLE_MAX_RAD: f64 = 1.0e4;

/// Most ω_max T, rad: what takes longer by its lower bound is refused. Hours of flight at a rate of one radian a second,
/// or a rate limit that no vehicle has; the work of solving and checking grows with it.
pub const LONGEST_RAD: f64 = 1.0e4;

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
    /// Windings that could have won but for which no verified maneuver was found. Only
    /// [`solve_all_windings`](super::solve_all_windings) looks at each.
    pub unsolved: heapless::Vec<i32, MAX_ALTERNATIVES>,
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
    /// An angle beyond [`ANGLE_MAX_RAD`].
    #[error(
        "angles beyond {ANGLE_MAX_RAD} rad are not supported: take whole turns off the start and end angles"
    )]
    AngleTooLarge,
    /// More than [`MOST_TURNS`] turns.
    #[error("that many full turns are not supported: ask for a net turn of at most 8 and a half either way")]
    TooManyTurns,
    /// ω_max T is more than [`LONGEST_RAD`].
    #[error(
        "the maneuver takes at least {}, more than {LONGEST_RAD} rad at the maximum body rate: bring start and end \
         closer together, or give a lower body rate",
        Seconds(*.lower_bound_s)
    )]
    TooLong {
        /// Nothing is faster than this, s.
        lower_bound_s: f64,
    },
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
        "no verified minimum-time maneuver was found ({}lower bound {}; {evaluations} evaluations{}): move the start or \
         end a little, or fix the number of turns",
        Feasible(*.feasible_s),
        Seconds(*.lower_bound_s),
        Elapsed(*.elapsed_s)
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

/// A duration for a person: six decimals where they mean something.
struct Seconds(f64);

impl fmt::Display for Seconds {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let size = self.0.abs();
        if size == 0.0 || (1e-3..1e6).contains(&size) {
            write!(f, "{:.6} s", self.0)
        } else {
            write!(f, "{:.3e} s", self.0)
        }
    }
}

/// The fastest that reaches the end, if any.
struct Feasible(Option<f64>);

impl fmt::Display for Feasible {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0 {
            Some(t) => write!(f, "one that breaks a law of the minimum principle takes {}; ", Seconds(t)),
            None => Ok(()),
        }
    }
}

/// The time spent, where there was a clock.
struct Elapsed(f64);

impl fmt::Display for Elapsed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.0 > 0.0 { write!(f, ", {:.3} s", self.0) } else { Ok(()) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn refusals_say_what_is_known_in_short_numbers() {
        let refused = |feasible_s, lower_bound_s, elapsed_s| {
            SolveError::NotVerified { feasible_s, lower_bound_s, evaluations: 7, elapsed_s }.to_string()
        };
        let text = refused(Some(1.25), 1e150, 0.5);
        for part in ["1.250000 s", "1.000e150 s", "7 evaluations", "0.500 s"] {
            assert!(text.contains(part), "{text}");
        }
        assert!(!refused(None, 0.5, 0.0).contains("breaks a law"));
        assert!(SolveError::TooLong { lower_bound_s: f64::INFINITY }.to_string().len() < 200);
    }

    #[test]
    fn whole_turns_of_either_angle_move_the_winding_and_nothing_else() {
        let request = |start: f64, end: f64, turns| Request {
            from: State { theta: start, ..State::origin() },
            to: State { theta: end, ..State::at_rest(1.0, 0.0) },
            turns,
            ..Request::rest_to_rest(0.0, 0.0)
        };
        let (same, shift) = request(100.0, 0.3, Turns::Exactly(15)).reduced();
        assert_eq!((shift, same.turns), (16, Turns::Exactly(-1)));
        assert!((same.from.theta - (100.0 - 16.0 * TAU)).abs() < 1e-13);
        for turns in [8, 24] {
            assert_eq!(request(100.0, 0.3, Turns::Exactly(turns)).validate(), Ok(()));
        }
        for turns in [-8, 7, 25, i32::MIN, i32::MAX] {
            assert_eq!(request(100.0, 0.3, Turns::Exactly(turns)).validate(), Err(SolveError::TooManyTurns));
        }
        assert_eq!(request(1e5, 0.0, Turns::Any).validate(), Err(SolveError::AngleTooLarge));
    }
}

//! Sweeps: a family of requests solved one from the next, and where the structure of their maneuvers changes.

use mintime_shared::model::{RateMode, ThrustLevel};

use super::extremal::Extremal;
use super::request::{Request, Solution, SolveError};
use super::{solve, solve_from};

/// What kind of maneuver it is, without durations: enough to see a structure change.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shape {
    /// Whole turns, without their sign: mirror images tie.
    pub turns: u32,
    /// Segments.
    pub segments: usize,
    /// Singular arcs.
    pub arcs: usize,
    /// Segments at minimum thrust.
    pub low_thrust: usize,
}

impl Extremal {
    /// Its shape.
    pub fn shape(&self) -> Shape {
        let count = |f: &dyn Fn(RateMode, ThrustLevel) -> bool| {
            self.segments.iter().filter(|s| f(s.inputs.rate, s.inputs.thrust)).count()
        };
        Shape {
            turns: self.turns.unsigned_abs(),
            segments: self.segments.len(),
            arcs: count(&|rate, _| rate == RateMode::Singular),
            low_thrust: count(&|_, thrust| thrust == ThrustLevel::Min),
        }
    }
}

/// The fastest of the neighbour's branch and a cold look at all windings.
///
/// # Errors
/// Those of [`solve`].
pub fn solve_beside(neighbour: &Extremal, request: &Request) -> Result<Solution, SolveError> {
    let cold = solve(request)?;
    match solve_from(neighbour, request) {
        Ok(warm) if warm.extremal.duration_s() < cold.extremal.duration_s() * (1.0 - BETTER) => Ok(warm),
        _ => Ok(cold),
    }
}

/// A neighbour's maneuver replaces a cold one only if it is faster by this, relative.
const BETTER: f64 = 1e-9;

/// Where, between `low` and `high`, a property of the fastest maneuver changes: bisection to `tolerance` (in the
/// sweep's own unit). `None` where both ends agree.
///
/// # Errors
/// Those of [`solve`].
pub fn change<P: PartialEq>(
    family: impl Fn(f64) -> Request,
    property: impl Fn(&Extremal) -> P,
    (mut low, mut high): (f64, f64),
    tolerance: f64,
) -> Result<Option<f64>, SolveError> {
    let at = |parameter: f64| solve(&family(parameter)).map(|s| property(&s.extremal));
    let first = at(low)?;
    if at(high)? == first {
        return Ok(None);
    }
    while (high - low).abs() > tolerance {
        let middle = 0.5 * (low + high);
        // Neighbouring numbers cannot be halved.
        if middle == low || middle == high {
            break;
        }
        if at(middle)? == first {
            low = middle;
        } else {
            high = middle;
        }
    }
    Ok(Some(0.5 * (low + high)))
}

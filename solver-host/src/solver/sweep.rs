//! Sweeps: a family of requests solved one from the next, and where the structure of their maneuvers changes.

use core::fmt;

use mintime_shared::model::{Inputs, RateMode, ThrustLevel};

use super::extremal::Extremal;
use super::request::{Request, Solution, SolveError};
use super::structure::{MAX_SEGMENTS, opposite};
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

/// Which inputs follow each other, and how often the vehicle turns over: a maneuver without its durations.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Structure {
    /// Winding k.
    pub turns: i32,
    /// Inputs by segment.
    pub inputs: heapless::Vec<Inputs, MAX_SEGMENTS>,
}

impl Structure {
    /// That of the mirror image in x.
    #[must_use]
    pub fn mirrored(&self) -> Self {
        let mirror = |i: &Inputs| Inputs { rate: opposite(i.rate), ..*i };
        Self { turns: -self.turns, inputs: self.inputs.iter().map(mirror).collect() }
    }

    /// Of a structure and its mirror image the one that turns forward (k > 0) or, without a turn, begins forward.
    #[must_use]
    pub fn up_to_mirror(&self) -> Self {
        let forward = match self.turns {
            0 => self.inputs.first().is_none_or(|i| i.rate != RateMode::Minus),
            k => k > 0,
        };
        if forward { self.clone() } else { self.mirrored() }
    }
}

/// In words like `+max smax -min`, the same as the reference maneuvers use.
impl fmt::Display for Structure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (i, inputs) in self.inputs.iter().enumerate() {
            let rate = match inputs.rate {
                RateMode::Plus => "+",
                RateMode::Minus => "-",
                RateMode::Singular => "s",
            };
            let thrust = match inputs.thrust {
                ThrustLevel::Min => "min",
                ThrustLevel::Max => "max",
            };
            write!(f, "{}{rate}{thrust}", if i == 0 { "" } else { " " })?;
        }
        Ok(())
    }
}

impl Extremal {
    /// Its structure.
    pub fn structure(&self) -> Structure {
        Structure { turns: self.turns, inputs: self.segments.iter().map(|s| s.inputs).collect() }
    }

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

//! Design study: how T of given maneuvers depends on what a vehicle can do, and which of its limits buys the most.
//!
//! Each parameter is varied alone, the others stay at the vehicle's values. Derivatives come from the costate
//! ([`Sensitivities`]), not from differences; the *elasticity* d ln T / d ln p = (p/T) ∂T/∂p says by how many per cent T
//! changes where the parameter changes by one, so that parameters can be compared.

mod picture;
mod table;

use std::path::Path;

use mintime_shared::model::{Limits, LimitsError, State};
use serde::Serialize;

use crate::drawing::{PictureError, file};
use crate::parallel;
use crate::solver::{Extremal, Request, Sensitivities, SolveError, Turns, solve, solve_from};

/// A limit of the vehicle that a designer chooses.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Parameter {
    /// Greatest collective thrust per mass, m/s².
    MaxThrust,
    /// Least collective thrust per mass, m/s².
    MinThrust,
    /// Greatest body rate, rad/s.
    Rate,
}

impl Parameter {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::MaxThrust, Self::MinThrust, Self::Rate];

    /// Its name in arguments and tables.
    pub fn name(self) -> &'static str {
        match self {
            Self::MaxThrust => "max-thrust",
            Self::MinThrust => "min-thrust",
            Self::Rate => "rate",
        }
    }

    /// SI.
    pub fn unit(self) -> &'static str {
        match self {
            Self::MaxThrust | Self::MinThrust => "m/s²",
            Self::Rate => "rad/s",
        }
    }

    /// Its value among the limits.
    pub fn of(self, limits: &Limits<f64>) -> f64 {
        match self {
            Self::MaxThrust => limits.thrust_max_mps2,
            Self::MinThrust => limits.thrust_min_mps2,
            Self::Rate => limits.rate_max_radps,
        }
    }

    /// The limits with another value of it.
    #[must_use]
    pub fn set(self, limits: &Limits<f64>, value: f64) -> Limits<f64> {
        match self {
            Self::MaxThrust => Limits { thrust_max_mps2: value, ..*limits },
            Self::MinThrust => Limits { thrust_min_mps2: value, ..*limits },
            Self::Rate => Limits { rate_max_radps: value, ..*limits },
        }
    }

    /// ∂T/∂p.
    fn derivative(self, sensitivities: &Sensitivities) -> f64 {
        match self {
            Self::MaxThrust => sensitivities.thrust_max,
            Self::MinThrust => sensitivities.thrust_min,
            Self::Rate => sensitivities.rate_max,
        }
    }

    /// What is worth looking at around the vehicle's value: only what can hover.
    pub fn usual_range(self, limits: &Limits<f64>) -> Range {
        let (value, gravity) = (self.of(limits), limits.gravity_mps2);
        let (low, high) = match self {
            Self::MaxThrust => {
                let least = 1.05 * gravity.max(limits.thrust_min_mps2);
                ((0.6 * value).max(least), (2.0 * value).max(1.2 * least))
            }
            Self::MinThrust => ((0.02 * gravity).min(value), (0.95 * gravity).max(value)),
            Self::Rate => (0.3 * value, 3.0 * value),
        };
        Range { low, high, count: POINTS }
    }
}

/// Points along a parameter if nothing else is said.
const POINTS: usize = 61;
/// Most points along a parameter.
pub const MOST_POINTS: usize = 10_000;
/// Most maneuvers in one study: more cannot be told apart in a picture.
pub const MOST_MANEUVERS: usize = 6;

/// Even values from low to high.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Range {
    /// First value.
    pub low: f64,
    /// Last value.
    pub high: f64,
    /// How many, at least two.
    pub count: usize,
}

impl Range {
    fn values(&self) -> Vec<f64> {
        let last = self.count.saturating_sub(1).max(1) as f64;
        (0..self.count).map(|i| self.low + (self.high - self.low) * i as f64 / last).collect()
    }
}

/// Why there is no study.
#[derive(Debug, thiserror::Error)]
pub enum DesignError {
    /// The vehicle's own limits cannot be planned with.
    #[error("{0}")]
    Limits(#[from] LimitsError),
    /// A maneuver was not solved with the vehicle's own limits.
    #[error("x = {x_m} m, z = {z_m} m: {source}")]
    Solve {
        /// Displacement, m.
        x_m: f64,
        /// Displacement, m.
        z_m: f64,
        /// Why.
        source: SolveError,
    },
    /// None, or more than [`MOST_MANEUVERS`].
    #[error("a study compares one to {MOST_MANEUVERS} maneuvers, {0} were given")]
    Maneuvers(usize),
    /// A range without values, or with too many.
    #[error("a range needs a first value below its last and 2 to {MOST_POINTS} points, like 12:40:57")]
    Range,
}

/// The fastest maneuver at one value of a parameter.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Found {
    /// T, s.
    pub duration_s: f64,
    /// Winding k.
    pub turns: i32,
    /// ∂T/∂p on the maneuver's own branch: s per unit of the parameter.
    pub derivative: f64,
    /// d ln T / d ln p.
    pub elasticity: f64,
}

impl Found {
    fn new(parameter: Parameter, extremal: &Extremal) -> Self {
        let duration_s = extremal.duration_s();
        let derivative = parameter.derivative(&extremal.sensitivities());
        let elasticity = derivative * parameter.of(&extremal.limits) / duration_s;
        Self { duration_s, turns: extremal.turns, derivative, elasticity }
    }
}

/// One value of a parameter.
#[derive(Clone, Debug, PartialEq)]
pub struct Point {
    /// The parameter's value.
    pub value: f64,
    /// The maneuver, or why there is none: a vehicle that cannot hover, for one.
    pub outcome: Result<Found, SolveError>,
}

/// One maneuver along one parameter.
#[derive(Clone, Debug, PartialEq)]
pub struct Curve {
    /// What is varied.
    pub parameter: Parameter,
    /// With the vehicle's own value.
    pub here: Found,
    /// Over the range.
    pub points: Vec<Point>,
}

/// One maneuver.
#[derive(Clone, Debug, PartialEq)]
pub struct Maneuver {
    /// Displacement from rest to rest, m.
    pub x_m: f64,
    /// Displacement from rest to rest, m.
    pub z_m: f64,
    /// T with the vehicle's own limits, s.
    pub duration_s: f64,
    /// One for each parameter, in the order asked for.
    pub curves: Vec<Curve>,
}

impl Maneuver {
    /// The parameter whose change by one per cent changes T most.
    pub fn buys_most(&self) -> Option<&Curve> {
        self.curves.iter().max_by(|a, b| a.here.elasticity.abs().total_cmp(&b.here.elasticity.abs()))
    }
}

/// A study.
#[derive(Clone, Debug, PartialEq)]
pub struct Study {
    /// The vehicle's own limits.
    pub limits: Limits<f64>,
    /// In the order asked for.
    pub maneuvers: Vec<Maneuver>,
}

/// What to study.
#[derive(Clone, Debug, PartialEq)]
pub struct Question {
    /// Displacements (x, z), m: from rest to rest, level at both ends.
    pub displacements: Vec<(f64, f64)>,
    /// The vehicle's own limits.
    pub limits: Limits<f64>,
    /// Windings allowed.
    pub turns: Turns,
    /// What to vary, and over which values.
    pub parameters: Vec<(Parameter, Range)>,
}

impl Question {
    /// Solves everything, on all cores.
    ///
    /// # Errors
    /// [`DesignError`]; single values of a parameter that cannot be flown are no error, but said so in their [`Point`].
    pub fn study(&self) -> Result<Study, DesignError> {
        if !(1..=MOST_MANEUVERS).contains(&self.displacements.len()) {
            return Err(DesignError::Maneuvers(self.displacements.len()));
        }
        let usable = |r: &Range| {
            r.low.is_finite() && r.high.is_finite() && r.low < r.high && (2..=MOST_POINTS).contains(&r.count)
        };
        if !self.parameters.iter().all(|(_, range)| usable(range)) {
            return Err(DesignError::Range);
        }
        self.limits.validate()?;
        let maneuvers = self.displacements.iter().map(|&place| self.maneuver(place));
        Ok(Study { limits: self.limits, maneuvers: maneuvers.collect::<Result<_, _>>()? })
    }

    fn request(&self, (x_m, z_m): (f64, f64), limits: Limits<f64>) -> Request {
        Request { from: State::origin(), to: State::at_rest(x_m, z_m), limits, turns: self.turns }
    }

    fn maneuver(&self, place: (f64, f64)) -> Result<Maneuver, DesignError> {
        let (x_m, z_m) = place;
        let here = solve(&self.request(place, self.limits))
            .map_err(|source| DesignError::Solve { x_m, z_m, source })?
            .extremal;
        let curve = |&(parameter, range): &(Parameter, Range)| Curve {
            parameter,
            here: Found::new(parameter, &here),
            points: self.points(place, parameter, range),
        };
        let curves = self.parameters.iter().map(curve).collect();
        Ok(Maneuver { x_m, z_m, duration_s: here.duration_s(), curves })
    }

    fn points(&self, place: (f64, f64), parameter: Parameter, range: Range) -> Vec<Point> {
        let values = range.values();
        let request = |value: f64| -> Result<Request, SolveError> {
            let limits = parameter.set(&self.limits, value);
            limits.validate()?;
            Ok(self.request(place, limits))
        };
        let cold = |value: &f64| solve(&request(*value)?).map(|solution| solution.extremal);
        let mut found: Vec<Result<Extremal, SolveError>> = parallel::map(&values, cold, |_| {});
        // A cold look may miss the fastest maneuver; a neighbour that found it shows the way.
        let forwards = (1..values.len()).map(|i| (i, i - 1));
        let backwards = (1..values.len()).rev().map(|i| (i - 1, i));
        for (pupil, teacher) in forwards.chain(backwards) {
            if let (Ok(known), Ok(request)) = (&found[teacher], request(values[pupil]))
                && let Ok(other) = solve_from(known, &request)
                && found[pupil]
                    .as_ref()
                    .map_or(matches!(found[pupil], Err(SolveError::NotVerified { .. })), |own| {
                        other.extremal.duration_s() < own.duration_s() * (1.0 - FASTER)
                    })
            {
                found[pupil] = Ok(other.extremal);
            }
        }
        values
            .into_iter()
            .zip(found)
            .map(|(value, outcome)| Point { value, outcome: outcome.map(|e| Found::new(parameter, &e)) })
            .collect()
    }
}

/// A maneuver is faster than another only by more than this, relative.
const FASTER: f64 = 1e-9;

impl Study {
    /// The picture, as SVG.
    pub fn svg(&self) -> String {
        picture::draw(self)
    }

    /// All points, as CSV.
    pub fn csv(&self) -> String {
        table::csv(self)
    }

    /// Writes the picture, SVG or PNG by the file's ending. The file appears only when it is whole.
    ///
    /// # Errors
    /// [`PictureError`]: unknown ending, a path that cannot be written to, a full disk.
    pub fn write_picture(&self, path: &Path) -> Result<(), PictureError> {
        file::write(&self.svg(), path)
    }
}

/// Checks that a picture can be written to `path`, without creating it.
///
/// # Errors
/// What [`Study::write_picture`] would return, as far as it can be known beforehand.
pub fn check_picture(path: &Path) -> Result<(), PictureError> {
    file::check(path)
}

//! The numbers that learning may change in a table: the duration of each segment and, where there are singular arcs, the
//! width and the peak time that they share.
//!
//! The width is learned as its logarithm, so that it keeps its sign and never reaches zero. Beside them stands the heading, which is
//! learned by itself: a gyro that sits askew turns the whole plane.

use mintime_shared::model::{RateMode, Segment};
use mintime_shared::table::{ArcProfile, Kind, MAX_SEGMENTS, ManeuverTable, TableError, TableHeader};
use nalgebra::DVector;

/// Most parameters: every segment, and the arc's two.
pub const MAX_PARAMETERS: usize = MAX_SEGMENTS + 2;
/// A profile wider than this is a straight line, s: its numbers do nothing.
const STRAIGHT_S: f64 = 100.0;
/// No segment gets shorter, s: one tick.
pub(super) const SHORTEST_S: f64 = 1.25e-3;
/// What counts as an equally large change: of a duration, s, ...
const DURATION_SCALE_S: f64 = 0.02;
/// ... of the logarithm of the width, ...
const WIDTH_SCALE: f64 = 0.2;
/// ... and of the peak time over the width, or, where the arcs are so narrow that they pass far from their peak, as for a
/// duration.
const PEAK_SCALE: f64 = 0.2;
/// How far the arcs' peak rate stays below the limit, as a part of it: rounding to `f32`.
const RATE_MARGIN: f64 = 1.0e-4;

/// A maneuver that goes less far is not turned, m: its heading hardly moves its end.
pub(super) const TURNED_FROM_M: f64 = 1.0;
/// Largest difference between the heading flown and the one asked for, rad. More than an askew gyro is a mistake in a file.
pub const HEADING_MAX_RAD: f64 = 0.1;

/// The parameters of a table, in the order of a Jacobian's columns.
#[derive(Clone, Debug, PartialEq)]
pub struct Parameters {
    /// Of each segment, s.
    pub durations_s: Vec<f64>,
    /// Width and peak time of the arcs, s; `None` without arcs, or where they are straight.
    pub arc: Option<(f64, f64)>,
    /// Heading, rad. It moves the end out of the plane, where the other numbers do nothing, so it is no column of the Jacobian.
    pub heading_rad: f64,
}

impl Parameters {
    /// Those of a table.
    pub fn of(table: &ManeuverTable) -> Self {
        let arc = table.arcs.map(|arc| (f64::from(arc.width_s), f64::from(arc.peak_s)));
        Self {
            durations_s: table.segments().map(|s| f64::from(s.duration)).collect(),
            arc: arc.filter(|(width_s, _)| width_s.abs() < STRAIGHT_S),
            heading_rad: f64::from(table.heading_rad),
        }
    }

    /// How many there are.
    pub fn count(&self) -> usize {
        self.durations_s.len() + if self.arc.is_some() { 2 } else { 0 }
    }

    /// T, s.
    pub fn duration_s(&self) -> f64 {
        self.durations_s.iter().sum()
    }

    /// What counts as an equally large change of each: s, and 1 for the logarithm of the width.
    pub fn scales(&self) -> DVector<f64> {
        let durations = self.durations_s.iter().map(|_| DURATION_SCALE_S);
        let peak = |width_s: f64| (PEAK_SCALE * width_s.abs()).max(DURATION_SCALE_S);
        let arc = self.arc.iter().flat_map(|(width_s, _)| [WIDTH_SCALE, peak(*width_s)]);
        DVector::from_vec(durations.chain(arc).collect())
    }

    /// The least change of each that is allowed: no segment vanishes, and no arc that may be flown through its peak gets so
    /// narrow that it exceeds a rate there, rad/s. Narrower ones pass by their peak; how near they may come, the table's check
    /// says.
    pub(super) fn lower_bounds(&self, rate_max_radps: f64) -> DVector<f64> {
        let durations = self.durations_s.iter().map(|d| SHORTEST_S - d);
        let narrowest = |width_s: f64| ((1.0 + RATE_MARGIN) / (rate_max_radps * width_s.abs())).ln();
        let arc = self.arc.iter().flat_map(|(width_s, _)| [narrowest(*width_s).min(0.0), f64::NEG_INFINITY]);
        DVector::from_vec(durations.chain(arc).collect())
    }

    /// The fastest that the arcs turn, rad/s; `None` without arcs. A table may not exceed its rate limit there.
    pub(super) fn arc_rate_radps(&self, of: &ManeuverTable) -> Option<f64> {
        let (width_s, peak_s) = self.arc?;
        let rate = |at_s: f64| 1.0 / (width_s.abs() * (1.0 + ((at_s - peak_s) / width_s).powi(2)));
        let mut begin_s = 0.0;
        let mut fastest = None;
        for (segment, duration_s) in of.segments().zip(&self.durations_s) {
            let end_s = begin_s + duration_s;
            if segment.inputs.rate == RateMode::Singular {
                let nearest_s = peak_s.clamp(begin_s, end_s.max(begin_s));
                fastest = Some(rate(nearest_s).max(fastest.unwrap_or(0.0)));
            }
            begin_s = end_s;
        }
        fastest
    }

    /// The parameters after a change of each.
    #[must_use]
    pub fn moved(&self, change: &DVector<f64>) -> Self {
        let count = self.durations_s.len();
        Self {
            durations_s: self.durations_s.iter().zip(change).map(|(d, by)| d + by).collect(),
            arc: self.arc.map(|(width, peak)| (width * change[count].exp(), peak + change[count + 1])),
            heading_rad: self.heading_rad,
        }
    }

    /// The parameters with a plane turned so that an end `across_m` to the left of it comes back, for a maneuver that goes `along_m`
    /// far: at most [`HEADING_MAX_RAD`] off the heading asked for.
    pub(super) fn turned(self, across_m: f64, along_m: f64, asked_rad: f64) -> Self {
        if along_m.abs() < TURNED_FROM_M {
            return self;
        }
        let off =
            (self.heading_rad - asked_rad - across_m / along_m).clamp(-HEADING_MAX_RAD, HEADING_MAX_RAD);
        Self { heading_rad: asked_rad + off, ..self }
    }

    /// The table with these parameters instead of its own, marked as learned.
    ///
    /// # Errors
    /// The reason for which a vehicle would refuse it.
    pub fn into_table(&self, of: &ManeuverTable) -> Result<ManeuverTable, TableError> {
        let header = TableHeader {
            vehicle: of.vehicle,
            kind: Kind::Learned,
            link: of.link,
            limits: of.limits,
            heading_rad: self.heading_rad as f32,
            start: of.start,
            end: of.end,
        };
        let learned = self.arc.map(|(width, peak)| ArcProfile { width_s: width as f32, peak_s: peak as f32 });
        let segments = of
            .segments()
            .zip(&self.durations_s)
            .map(|(s, duration)| Segment { inputs: s.inputs, duration: *duration as f32 });
        ManeuverTable::new(header, learned.or(of.arcs), segments)
    }
}

//! What a report shows, as plain data.

use mintime_shared::model::{Limits, Segment, State};

use crate::flight_log::PlannedSample;

/// Everything a report shows. Samples with numbers that are not finite are left out of the picture.
#[derive(Clone, Debug, PartialEq)]
pub struct ReportData {
    /// One line, e.g. `Minimum-time maneuver to x = 5 m, z = 5 m`.
    pub title: String,
    /// Lines below the title.
    pub subtitle: Vec<String>,
    /// The planned maneuver, from t = 0 to T, in order of time.
    pub planned: Vec<PlannedSample>,
    /// The flown maneuver with some time before and after, in order of time, in the plan's coordinates. May be empty.
    pub flown: Vec<FlownSample>,
    /// Inputs of the plan by segment, durations in s, from t = 0. May be empty: then no segments are marked.
    pub segments: Vec<Segment<f64>>,
    /// Limits the maneuver was planned with.
    pub limits: Limits<f64>,
    /// Rows of the small table: label, value with unit.
    pub facts: Vec<(String, String)>,
}

/// The flight at one instant.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FlownSample {
    /// Time from the start of the maneuver, s; negative before it.
    pub t_s: f64,
    /// True state in the maneuver's plane, SI units, in the plan's coordinates.
    pub state: State<f64>,
    /// True pitch rate, rad/s.
    pub rate_radps: f64,
    /// True collective thrust per mass, m/s².
    pub thrust_mps2: f64,
    /// Phase of the flight, e.g. `hover`, `maneuver`, `catch`. Changes of phase are marked.
    pub phase: String,
}

//! What a report shows, as plain data.

use mintime_shared::model::{Limits, Segment, State};

use crate::flight_log::PlannedSample;
use crate::mission::{Flown, PlanFrame, rate_in_plane};

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

impl FlownSample {
    /// A flight around its maneuver, in the plan's coordinates: time and position from the true start. From `before` s
    /// ahead of it to `after` s past its end; empty where it never began.
    pub fn of_flight(flown: &Flown, (before_s, after_s): (f64, f64)) -> Vec<Self> {
        let duration_s = f64::from(flown.prepared.table.duration_s());
        let Some(frame) = PlanFrame::of(flown) else { return Vec::new() };
        flown
            .trace
            .samples
            .iter()
            .filter(|s| (-before_s..=duration_s + after_s).contains(&frame.since_s(s.time_ns)))
            .map(|s| Self {
                t_s: frame.since_s(s.time_ns),
                state: frame.state(s.truth.planar),
                rate_radps: rate_in_plane(s.truth.body_rates_radps, flown.heading_rad()),
                thrust_mps2: s.truth.thrust_mps2,
                phase: s.phase.clone(),
            })
            .collect()
    }
}

//! Maneuvers as samples over time.

use mintime_shared::model::State;

use crate::solver::Extremal;

/// Times of all switches and of the end, s, separated by spaces.
pub(crate) fn switch_times(extremal: &Extremal) -> String {
    let mut t_s = 0.0;
    let times = extremal.segments.iter().map(|segment| {
        t_s += segment.duration;
        t_s.to_string()
    });
    times.collect::<Vec<_>>().join(" ")
}

/// An instant of a maneuver.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Instant {
    pub(crate) t_s: f64,
    pub(crate) state: State<f64>,
    pub(crate) rate_radps: f64,
    pub(crate) thrust_mps2: f64,
}

impl Instant {
    pub(crate) fn of(extremal: &Extremal, t_s: f64) -> Self {
        Self {
            t_s,
            state: extremal.state_at(t_s),
            rate_radps: extremal.rate_at(t_s),
            thrust_mps2: extremal.thrust_at(t_s),
        }
    }
}

/// Multiples of a step from 0 on, and the end.
pub(crate) fn times(duration_s: f64, step_s: f64) -> Vec<f64> {
    let whole = (duration_s / step_s - 1e-9).ceil().max(0.0) as u32;
    (0..whole).map(|i| f64::from(i) * step_s).chain([duration_s]).collect()
}

//! What of the data is shown: finite samples in order of time, the window of time, segments as spans.

use mintime_shared::model::{Inputs, RateMode, State, ThrustLevel};

use super::data::ReportData;
use crate::drawing::axis::Range;

/// Numbers beyond this, in any unit used here, are taken for faults and left out.
const LARGEST: f64 = 1e6;

/// One instant of the plan or the flight: its state finite, everything else if it is finite.
#[derive(Clone, Copy, Debug)]
pub(super) struct Instant {
    pub(super) t_s: f64,
    pub(super) x_m: f64,
    pub(super) z_m: f64,
    pub(super) theta_rad: f64,
    pub(super) rate_radps: Option<f64>,
    pub(super) thrust_mps2: Option<f64>,
    pub(super) phi_r: Option<f64>,
    pub(super) phi_t: Option<f64>,
}

/// A part of the time axis with a name.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Span {
    pub(super) from_s: f64,
    pub(super) to_s: f64,
    pub(super) name: String,
}

/// The data as it is drawn.
#[derive(Debug)]
pub(super) struct View {
    /// The plan in order of time.
    pub(super) planned: Vec<Instant>,
    /// The flight in order of time, within the window.
    pub(super) flown: Vec<Instant>,
    /// Duration of the plan, s; 0 without one.
    pub(super) duration_s: f64,
    /// Shown part of the time axis, s.
    pub(super) window: Range,
    /// Singular arcs.
    pub(super) singular: Vec<Span>,
    /// The rate input: `+`, `−`, `s`.
    pub(super) rate_inputs: Vec<Span>,
    /// The thrust input: `max`, `min`.
    pub(super) thrust_inputs: Vec<Span>,
    /// Phases of the flight, within the window.
    pub(super) phases: Vec<Span>,
}

fn usable(v: f64) -> bool {
    v.is_finite() && v.abs() <= LARGEST
}

/// Time for sorting, in whole ns: the two samples at a switch keep their order whatever their last bits.
fn order(t_s: f64) -> f64 {
    (t_s * 1e9).round()
}

impl Instant {
    fn new(
        t_s: f64,
        state: &State<f64>,
        rate_radps: f64,
        thrust_mps2: f64,
        [phi_r, phi_t]: [f64; 2],
    ) -> Option<Self> {
        let all = [t_s, state.x, state.z, state.theta];
        let some = |v: f64| usable(v).then_some(v);
        all.into_iter().all(usable).then(|| Self {
            t_s,
            x_m: state.x,
            z_m: state.z,
            theta_rad: state.theta,
            rate_radps: some(rate_radps),
            thrust_mps2: some(thrust_mps2),
            phi_r: some(phi_r),
            phi_t: some(phi_t),
        })
    }

    /// The state between two instants, linearly. The inputs are those of the earlier one: they jump.
    fn between(&self, later: &Self, t_s: f64) -> Self {
        let gap = later.t_s - self.t_s;
        let part = if gap > 0.0 { ((t_s - self.t_s) / gap).clamp(0.0, 1.0) } else { 0.0 };
        let mix = |a: f64, b: f64| a + (b - a) * part;
        Self {
            t_s,
            x_m: mix(self.x_m, later.x_m),
            z_m: mix(self.z_m, later.z_m),
            theta_rad: mix(self.theta_rad, later.theta_rad),
            ..*self
        }
    }
}

/// The instant at a time, interpolated; `None` outside the data.
pub(super) fn at(instants: &[Instant], t_s: f64) -> Option<Instant> {
    let after = instants.partition_point(|i| i.t_s < t_s - 1e-9);
    let later = instants.get(after)?;
    match after.checked_sub(1).and_then(|before| instants.get(before)) {
        Some(earlier) => Some(earlier.between(later, t_s)),
        None => (later.t_s <= t_s + 1e-9).then_some(*later),
    }
}

impl View {
    pub(super) fn new(data: &ReportData) -> Self {
        let mut planned: Vec<Instant> = data
            .planned
            .iter()
            .filter_map(|p| Instant::new(p.t_s, &p.state, p.rate_radps, p.thrust_mps2, [p.phi_r, p.phi_t]))
            .collect();
        planned.sort_by(|a, b| order(a.t_s).total_cmp(&order(b.t_s)));
        let mut flown: Vec<(Instant, &str)> = data
            .flown
            .iter()
            .filter_map(|f| {
                let instant =
                    Instant::new(f.t_s, &f.state, f.rate_radps, f.thrust_mps2, [f64::NAN, f64::NAN])?;
                Some((instant, f.phase.as_str()))
            })
            .collect();
        flown.sort_by(|a, b| order(a.0.t_s).total_cmp(&order(b.0.t_s)));

        let inputs = spans(data);
        let planned_end = planned.last().map_or(0.0, |last| last.t_s);
        let duration_s = inputs.last().map_or(planned_end, |last| planned_end.max(last.1)).max(0.0);
        let window = window(duration_s, Range::of(flown.iter().map(|(f, _)| f.t_s)));
        flown.retain(|(f, _)| f.t_s >= window.low && f.t_s <= window.high);

        let name_rate = |mode| match mode {
            RateMode::Plus => "+",
            RateMode::Minus => "−",
            RateMode::Singular => "s",
        };
        let name_thrust = |level| match level {
            ThrustLevel::Max => "max",
            ThrustLevel::Min => "min",
        };
        let rate_inputs = merge(inputs.iter().map(|i| (i.0, i.1, name_rate(i.2.rate))));
        Self {
            singular: rate_inputs.iter().filter(|span| span.name == "s").cloned().collect(),
            rate_inputs,
            thrust_inputs: merge(inputs.iter().map(|i| (i.0, i.1, name_thrust(i.2.thrust)))),
            phases: phases(&flown, window),
            planned,
            flown: flown.into_iter().map(|(instant, _)| instant).collect(),
            duration_s,
            window,
        }
    }
}

/// The shown part of the time axis: the maneuver, and of the flight before and after it as much as leaves the
/// maneuver the larger part of the picture.
fn window(duration_s: f64, flown: Option<Range>) -> Range {
    let whole = Range { low: 0.0, high: duration_s }.and(flown);
    let window = if duration_s > 0.0 {
        whole.within(Range { low: -0.25 * duration_s - 0.05, high: 1.5 * duration_s + 0.1 })
    } else {
        whole
    };
    if window.span() > 0.0 {
        window.at_least(1e-3)
    } else {
        Range { low: window.low, high: window.low + 1.0 }
    }
}

/// Segments as (from, to, inputs), up to the first whose duration makes no sense.
fn spans(data: &ReportData) -> Vec<(f64, f64, Inputs)> {
    let mut t_s = 0.0;
    data.segments
        .iter()
        .map_while(|segment| {
            let from = t_s;
            t_s += segment.duration;
            (usable(t_s) && segment.duration >= 0.0).then_some((from, t_s, segment.inputs))
        })
        .collect()
}

/// Neighbours with the same name become one.
fn merge<'a>(parts: impl IntoIterator<Item = (f64, f64, &'a str)>) -> Vec<Span> {
    let mut merged: Vec<Span> = Vec::new();
    for (from_s, to_s, name) in parts {
        match merged.last_mut() {
            Some(last) if last.name == name => last.to_s = to_s,
            _ => merged.push(Span { from_s, to_s, name: name.to_owned() }),
        }
    }
    merged
}

/// A phase lasts from its first sample to the first of the next.
fn phases(flown: &[(Instant, &str)], window: Range) -> Vec<Span> {
    let ends = flown.iter().skip(1).map(|(next, _)| next.t_s).chain([window.high]);
    let parts = flown.iter().zip(ends).map(|((instant, name), end)| (instant.t_s, end, *name));
    merge(parts).into_iter().filter(|span| !span.name.is_empty()).collect()
}

//! The four quantities that are shown over time: pitch, pitch rate, thrust per mass, position.

use std::f64::consts::PI;

use super::data::ReportData;
use super::path_panel::Unit;
use super::time_panel::{Series, TimePanel};
use super::view::{Instant, View};
use crate::drawing::axis::Range;

/// Values beyond this many limits are outside the panel.
const BEYOND_LIMIT: f64 = 1.6;

fn series(instants: &[Instant], value: impl Fn(&Instant) -> Option<f64>) -> Series {
    instants.iter().filter_map(|i| Some((i.t_s, value(i)?))).collect()
}

fn values<'a>(all: impl IntoIterator<Item = &'a Series>) -> Option<Range> {
    Range::of(all.into_iter().flatten().map(|(_, v)| *v))
}

/// The panels from top to bottom.
pub(super) fn panels(data: &ReportData, view: &View, unit: Unit) -> [TimePanel; 4] {
    [pitch(view), rate(data, view), thrust(data, view), position(view, unit)]
}

fn pitch(view: &View) -> TimePanel {
    let [planned, flown] = [&view.planned, &view.flown].map(|i| series(i, |i| Some(i.theta_rad)));
    // A tumbling vehicle leaves the panel after half a turn too many.
    let range = match (values([&planned]), values([&flown])) {
        (Some(p), Some(f)) => p.and(Some(f.within(Range { low: p.low - PI, high: p.high + PI }))),
        (p, f) => p.or(f).unwrap_or(Range { low: 0.0, high: 0.0 }),
    };
    TimePanel {
        class: "pitch",
        label: "pitch θ (rad)".to_owned(),
        range: range.at_least(0.2).padded(0.08),
        planned: vec![planned],
        flown: vec![flown],
        names: Vec::new(),
        limits: Vec::new(),
        switching: None,
        strip: view.phases.clone(),
    }
}

fn rate(data: &ReportData, view: &View) -> TimePanel {
    let [planned, flown] = [&view.planned, &view.flown].map(|i| series(i, |i| i.rate_radps));
    let limit = Some(data.limits.rate_max_radps).filter(|l| l.is_finite() && *l > 0.0 && *l < 1e6);
    let seen = values([&planned, &flown]);
    let range = match limit {
        Some(limit) => {
            let beyond = Range { low: -BEYOND_LIMIT * limit, high: BEYOND_LIMIT * limit };
            Range { low: -limit, high: limit }.and(seen.map(|s| s.within(beyond)))
        }
        None => seen.unwrap_or(Range { low: -1.0, high: 1.0 }),
    };
    let phi = series(&view.planned, |i| i.phi_r);
    TimePanel {
        class: "rate",
        label: "pitch rate (rad/s)".to_owned(),
        range: range.at_least(1e-3).padded(0.1),
        planned: vec![planned],
        flown: vec![flown],
        names: Vec::new(),
        limits: limit.map(|l| vec![-l, l]).unwrap_or_default(),
        switching: switching(phi, 0.0, limit),
        strip: view.rate_inputs.clone(),
    }
}

fn thrust(data: &ReportData, view: &View) -> TimePanel {
    let [planned, flown] = [&view.planned, &view.flown].map(|i| series(i, |i| i.thrust_mps2));
    let (low, high) = (data.limits.thrust_min_mps2, data.limits.thrust_max_mps2);
    let limits =
        Some((low, high)).filter(|(l, h)| l.is_finite() && h.is_finite() && l < h && *h < 1e6 && *l > -1e6);
    let seen = values([&planned, &flown]);
    let range = match limits {
        Some((low, high)) => {
            let beyond = Range { low: low.min(0.0), high: high.abs() * BEYOND_LIMIT };
            Range { low: low.min(0.0), high }.and(seen.map(|s| s.within(beyond)))
        }
        None => seen.unwrap_or(Range { low: 0.0, high: 1.0 }),
    };
    let phi = series(&view.planned, |i| i.phi_t);
    TimePanel {
        class: "thrust",
        label: "thrust (m/s²)".to_owned(),
        range: range.at_least(1e-3).padded(0.08),
        planned: vec![planned],
        flown: vec![flown],
        names: Vec::new(),
        limits: limits.map(|(l, h)| vec![l, h]).unwrap_or_default(),
        switching: limits.and_then(|(l, h)| switching(phi, 0.5 * (l + h), Some(0.5 * (h - l)))),
        strip: view.thrust_inputs.clone(),
    }
}

/// −Φ about the middle between the limits, scaled to reach nearly to them: above the middle the minimum principle asks
/// for the upper limit, below it for the lower, eq. (16) and (20).
fn switching(phi: Series, middle: f64, half_span: Option<f64>) -> Option<(Series, f64)> {
    let largest = phi.iter().map(|(_, v)| v.abs()).fold(0.0, f64::max);
    let half_span = half_span?;
    if !(largest > 0.0 && half_span > 0.0) {
        return None;
    }
    let scale = 0.85 * half_span / largest;
    Some((phi.into_iter().map(|(t, v)| (t, middle - v * scale)).collect(), middle))
}

fn position(view: &View, unit: Unit) -> TimePanel {
    let x = |i: &Instant| Some(i.x_m * unit.per_m);
    let z = |i: &Instant| Some(i.z_m * unit.per_m);
    let planned = vec![series(&view.planned, x), series(&view.planned, z)];
    let flown = vec![series(&view.flown, x), series(&view.flown, z)];
    let range = match (values(&planned), values(&flown)) {
        // A vehicle that flies off leaves the panel, as it leaves the path's.
        (Some(planned), flown) => {
            let planned = planned.at_least(1e-3 * unit.per_m);
            planned.and(flown.map(|f| f.within(planned.padded(1.0))))
        }
        (None, Some(flown)) => flown,
        (None, None) => Range { low: 0.0, high: 1.0 },
    };
    let shown = if view.flown.is_empty() { &planned } else { &flown };
    let names =
        shown.iter().zip(["x", "z"]).filter_map(|(series, name)| Some((series.last()?.1, name))).collect();
    TimePanel {
        class: "position",
        label: format!("position ({})", unit.name),
        range: range.at_least(1e-3 * unit.per_m).padded(0.08),
        planned,
        flown,
        names,
        limits: Vec::new(),
        switching: None,
        strip: Vec::new(),
    }
}

//! The vehicle drawn along a path: where, and how large.

use super::path_panel::Plane;
use super::view::{Instant, View, at};
use crate::drawing::svg::Svg;
use crate::drawing::symbol::{self, SPAN_M};

/// Smallest and largest span on the page: below the tilt cannot be seen, above the drawings hide each other.
const SPAN_PX: (f64, f64) = (24.0, 38.0);
/// Intervals between drawings to choose from, s.
const INTERVALS_S: [f64; 8] = [0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0];
/// At most about this many drawings.
const DRAWINGS: f64 = 40.0;

/// How the vehicle is drawn in one picture.
#[derive(Clone, Copy, Debug)]
pub(super) struct Symbol {
    span_px: f64,
    thrust_max: f64,
}

/// Time between drawings for a maneuver of this duration, s.
pub(super) fn interval_s(duration_s: f64) -> f64 {
    INTERVALS_S.into_iter().find(|dt| duration_s / dt <= DRAWINGS).unwrap_or(duration_s / DRAWINGS)
}

/// When to draw the vehicle: at even times from start to end, without those at which the plan has hardly moved on.
pub(super) fn instants(plane: &Plane, symbol: &Symbol, view: &View) -> Vec<f64> {
    let step = interval_s(view.duration_s);
    let source = if view.planned.is_empty() { &view.flown } else { &view.planned };
    let mut drawn: Vec<(f64, Instant)> = Vec::new();
    for t_s in (0..100).map(|i| f64::from(i) * step).take_while(|t| *t <= view.duration_s + 1e-9) {
        let Some(now) = at(source, t_s) else { continue };
        let moved = drawn.last().is_none_or(|(_, last)| {
            let (a, b) = (plane.of(last), plane.of(&now));
            (a.0 - b.0).hypot(a.1 - b.1) > 0.3 * symbol.span_px
                || (last.theta_rad - now.theta_rad).abs() > 0.5
        });
        if moved {
            drawn.push((t_s, now));
        }
    }
    drawn.into_iter().map(|(t_s, _)| t_s).collect()
}

impl Symbol {
    pub(super) fn new(plane: &Plane, thrust_max: f64) -> Self {
        Self { span_px: (SPAN_M * plane.scale()).clamp(SPAN_PX.0, SPAN_PX.1), thrust_max }
    }

    /// Draws the vehicle at each of the times. Colour and opacity are those of the group it is drawn in.
    pub(super) fn draw(&self, svg: &mut Svg, plane: &Plane, source: &[Instant], times_s: &[f64]) {
        for instant in times_s.iter().filter_map(|t| at(source, *t)) {
            let (x, y) = plane.of(&instant);
            let thrust = instant.thrust_mps2.map_or(0.0, |f| (f / self.thrust_max).clamp(0.0, 1.3));
            symbol::draw(svg, (x, y), instant.theta_rad, self.span_px, thrust);
        }
    }
}

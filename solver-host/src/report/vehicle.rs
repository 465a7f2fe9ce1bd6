//! The vehicle seen from the side: a bar with two rotors, and a line along the thrust, as long as the thrust is large.

use super::path_panel::Plane;
use super::svg::{Svg, px};
use super::view::{Instant, View, at};

/// Rotor tip to rotor tip of the vehicle the limits of the paper's Table I belong to, m.
const SPAN_M: f64 = 0.5;
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

/// The definition the drawings refer to: span 1, hub at the origin, upright. Colour comes from outside.
pub(super) const DEFINITION: &str = concat!(
    r##"<g id="vehicle" fill="none" stroke-linecap="round"><path d="M-.36 0H.36" stroke-width=".075"/>"##,
    r##"<path d="M-.36 0V-.1M.36 0V-.1" stroke-width=".04"/>"##,
    r##"<path d="M-.54-.115H-.18M.18-.115H.54" stroke-width=".045"/></g>"##,
);

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
                || (last.theta_deg - now.theta_deg).abs() > 30.0
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
            // θ turns the thrust axis from up towards +x: clockwise on the page, as SVG counts.
            svg.raw(&format!(
                r##"<g transform="translate({} {}) rotate({}) scale({})"><use href="#vehicle"/><path d="M0 0V{}" stroke-width=".03"/></g>"##,
                px(x),
                px(y),
                px(instant.theta_deg % 360.0),
                px(self.span_px),
                px(-0.62 * thrust),
            ));
        }
    }
}

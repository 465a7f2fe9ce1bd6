//! Quantities over time in a grid of panels: the paper's Fig. 6 and 7.

use crate::drawing::axis::Range;
use crate::drawing::plot::{Axes, Plot};
use crate::drawing::style::{
    AXIS_BELOW, AXIS_LEFT, FLOWN, INK, LIMIT, MARGIN, MUTED, SINGULAR, SWITCHING, TEXT_SIZE, WIDTH,
};
use crate::drawing::svg::{Rect, Svg, TextStyle};

/// Height of a panel.
const HEIGHT: f64 = 190.0;
/// Space between panels, upwards and along.
const GAP: (f64, f64) = (26.0, 30.0);

/// Stroke of the line at which switching functions are zero.
pub(crate) fn zero() -> String {
    format!(r#"stroke="{SWITCHING}" stroke-width="1" stroke-dasharray="1.5 4""#)
}

/// A curve: values over time, s.
pub(crate) struct Curve {
    pub(crate) points: Vec<(f64, f64)>,
    /// Stroke attributes.
    pub(crate) stroke: String,
    /// Name, written at its end.
    pub(crate) name: Option<&'static str>,
}

/// An instant that an upright line marks.
pub(crate) struct Mark {
    pub(crate) t_s: f64,
    /// Stroke attributes.
    pub(crate) stroke: String,
}

impl Mark {
    /// Of the plan.
    pub(crate) fn planned(t_s: f64) -> Self {
        Self { t_s, stroke: format!(r#"stroke="{MUTED}" stroke-width="1.2""#) }
    }

    /// Of what was learned.
    pub(crate) fn learned(t_s: f64) -> Self {
        Self { t_s, stroke: format!(r#"stroke="{FLOWN}" stroke-width="1.2""#) }
    }
}

/// A panel.
pub(crate) struct Panel {
    /// Quantity and unit.
    pub(crate) label: &'static str,
    pub(crate) range: Range,
    /// Values of limits.
    pub(crate) limits: Vec<f64>,
    /// Where the switching functions are zero.
    pub(crate) zero: Option<f64>,
    pub(crate) curves: Vec<Curve>,
}

impl Panel {
    /// A panel that shows all of its curves.
    pub(crate) fn of(label: &'static str, curves: Vec<Curve>) -> Self {
        let values = curves.iter().flat_map(|c| &c.points).map(|(_, v)| *v);
        let range = Range::of(values).unwrap_or(Range { low: 0.0, high: 1.0 }).at_least(1e-3).padded(0.08);
        Self { label, range, limits: Vec::new(), zero: None, curves }
    }

    /// The same with lines at limits.
    pub(crate) fn limited(mut self, limits: &[f64]) -> Self {
        self.range = self.range.and(Range::of(limits.iter().copied()).map(|r| r.padded(0.08)));
        self.limits = limits.to_vec();
        self
    }

    /// The same with a line where the switching functions are zero.
    pub(crate) fn with_zero(mut self, zero: f64) -> Self {
        self.zero = Some(zero);
        self
    }
}

/// Draws panels in two columns below `top`, with `shaded` parts of the time axis and lines at `marks`. Returns the lower
/// edge.
pub(crate) fn draw(
    svg: &mut Svg,
    panels: &[Panel],
    time: Range,
    shaded: &[(f64, f64)],
    marks: &[Mark],
    top: f64,
) -> f64 {
    let rows = panels.len().div_ceil(2);
    let names = 24.0;
    let width = 0.5 * (WIDTH - 2.0 * MARGIN - 2.0 * AXIS_LEFT - GAP.1) - names;
    for (i, panel) in panels.iter().enumerate() {
        let (row, column) = (i / 2, i % 2);
        let x = MARGIN + AXIS_LEFT + column as f64 * (width + names + GAP.1 + AXIS_LEFT);
        let rect = Rect { x, y: top + row as f64 * (HEIGHT + GAP.0), width, height: HEIGHT };
        let plot = Plot { rect, x: time, y: panel.range };
        for (from, to) in shaded {
            let cell =
                Rect { x: plot.x(*from), y: rect.y, width: plot.x(*to) - plot.x(*from), height: rect.height };
            svg.rect(&cell, &format!(r#"class="singular" fill="{SINGULAR}""#));
        }
        let last = row + 1 == rows;
        plot.axes(svg, &Axes { x: last.then_some("time t (s)"), y: panel.label });
        for mark in marks {
            let x = plot.x(mark.t_s);
            svg.line((x, rect.y), (x, rect.bottom()), &mark.stroke);
        }
        for limit in &panel.limits {
            let y = plot.y(*limit);
            let style = format!(r#"stroke="{LIMIT}" stroke-width="1.5" stroke-dasharray="7 5""#);
            svg.line((rect.x, y), (rect.right(), y), &style);
        }
        if let Some(value) = panel.zero {
            let y = plot.y(value);
            svg.line((rect.x, y), (rect.right(), y), &zero());
        }
        plot.clipped(svg, &format!("panel{i}"), |svg| {
            for curve in &panel.curves {
                svg.curve(&plot.points(curve.points.iter().copied()), &curve.stroke);
            }
        });
        plot.frame(svg);
        names_of(svg, &plot, panel);
    }
    top + rows as f64 * (HEIGHT + GAP.0) - GAP.0 + AXIS_BELOW
}

/// Names of curves right of the plot, one below the other.
fn names_of(svg: &mut Svg, plot: &Plot, panel: &Panel) {
    let ends = panel.curves.iter().filter_map(|c| Some((plot.y(c.points.last()?.1), c.name?)));
    let mut places: Vec<(f64, &str)> = ends.collect();
    places.sort_by(|a, b| a.0.total_cmp(&b.0));
    let middle = places.iter().map(|p| p.0).sum::<f64>() / places.len().max(1) as f64;
    let crowded = places.windows(2).any(|pair| pair[1].0 - pair[0].0 < TEXT_SIZE);
    for (i, (y, name)) in places.iter().enumerate() {
        let spread = middle + (i as f64 - 0.5 * (places.len() as f64 - 1.0)) * (TEXT_SIZE + 2.0);
        let y = if crowded { spread } else { *y };
        let y = y.clamp(plot.rect.y + 8.0, plot.rect.bottom() - 8.0);
        svg.text((plot.rect.right() + 7.0, y + 5.0), name, TextStyle::new(TEXT_SIZE, INK));
    }
}

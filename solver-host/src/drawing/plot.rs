//! A plot: a rectangle of the page that shows ranges of two quantities.

use super::axis::{Range, nice_step, tick_label, ticks};
use super::style::{FRAME, GRID, INK, SMALL_SIZE, TEXT_SIZE};
use super::svg::{Anchor, Point, Rect, Svg, TextStyle};

/// Least distance between ticks along and up, page units.
const TICKS: (f64, f64) = (66.0, 26.0);
/// Most intervals between ticks of an axis: more are not read.
const MOST_INTERVALS: f64 = 18.0;

/// A plot with two linear axes.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Plot {
    pub(crate) rect: Rect,
    pub(crate) x: Range,
    pub(crate) y: Range,
}

/// What its axes say.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Axes<'a> {
    /// Quantity and unit below the plot; without it no tick labels either, for a plot above another.
    pub(crate) x: Option<&'a str>,
    /// Quantity and unit on the left.
    pub(crate) y: &'a str,
}

impl Plot {
    /// Both axes to one scale, these ranges in the middle.
    pub(crate) fn to_scale(rect: Rect, x: Range, y: Range) -> Self {
        let scale = (rect.width / x.span()).min(rect.height / y.span());
        let around = |range: Range, length: f64| {
            let half = 0.5 * length / scale;
            Range { low: range.middle() - half, high: range.middle() + half }
        };
        Self { rect, x: around(x, rect.width), y: around(y, rect.height) }
    }

    pub(crate) fn x(&self, value: f64) -> f64 {
        self.rect.x + (value - self.x.low) / self.x.span() * self.rect.width
    }

    pub(crate) fn y(&self, value: f64) -> f64 {
        self.rect.bottom() - (value - self.y.low) / self.y.span() * self.rect.height
    }

    pub(crate) fn point(&self, (x, y): (f64, f64)) -> Point {
        (self.x(x), self.y(y))
    }

    pub(crate) fn points(&self, values: impl IntoIterator<Item = (f64, f64)>) -> Vec<Point> {
        values.into_iter().map(|v| self.point(v)).collect()
    }

    /// Grid, ticks and labels.
    pub(crate) fn axes(&self, svg: &mut Svg, axes: &Axes<'_>) {
        self.axes_with(svg, axes, self.steps());
    }

    /// The same of axes to one scale: one step for both shows that they are.
    pub(crate) fn axes_to_scale(&self, svg: &mut Svg, axes: &Axes<'_>) {
        let (x, y) = self.steps();
        self.axes_with(svg, axes, (x.max(y), x.max(y)));
    }

    /// Nice steps along and up.
    fn steps(&self) -> (f64, f64) {
        let step = |range: Range, length: f64, apart: f64| {
            nice_step(range.span(), (length / apart).floor().min(MOST_INTERVALS))
        };
        (step(self.x, self.rect.width, TICKS.0), step(self.y, self.rect.height, TICKS.1))
    }

    fn axes_with(&self, svg: &mut Svg, axes: &Axes<'_>, (x_step, y_step): (f64, f64)) {
        let rect = self.rect;
        let small = TextStyle::new(SMALL_SIZE, INK);
        let grid = format!(r#"stroke="{GRID}""#);
        for value in ticks(self.x, x_step) {
            let x = self.x(value);
            svg.line((x, rect.y), (x, rect.bottom()), &grid);
            if axes.x.is_some() {
                svg.text(
                    (x, rect.bottom() + 18.0),
                    &tick_label(value, x_step),
                    small.anchored(Anchor::Middle),
                );
            }
        }
        for value in ticks(self.y, y_step) {
            let y = self.y(value);
            svg.line((rect.x, y), (rect.right(), y), &grid);
            svg.text((rect.x - 8.0, y + 5.0), &tick_label(value, y_step), small.anchored(Anchor::End));
        }
        let label = TextStyle::new(TEXT_SIZE, INK);
        svg.text_upwards((rect.x - 48.0, rect.y + 0.5 * rect.height), axes.y, label);
        if let Some(text) = axes.x {
            let middle = rect.x + 0.5 * rect.width;
            svg.text((middle, rect.bottom() + 40.0), text, label.anchored(Anchor::Middle));
        }
    }

    /// The frame around it.
    pub(crate) fn frame(&self, svg: &mut Svg) {
        svg.rect(&self.rect, &format!(r#"fill="none" stroke="{FRAME}""#));
    }

    /// Draws with nothing outside the plot shown. `name` is unique on the page.
    pub(crate) fn clipped(&self, svg: &mut Svg, name: &str, draw: impl FnOnce(&mut Svg)) {
        svg.raw(&format!(r#"<clipPath id="{name}">"#));
        svg.rect(&self.rect, "");
        svg.raw("</clipPath>");
        svg.open_group(&format!(r#"clip-path="url(#{name})""#));
        draw(svg);
        svg.close_group();
    }
}

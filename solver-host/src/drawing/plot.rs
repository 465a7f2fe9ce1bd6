//! A plot: a rectangle of the page that shows ranges of two quantities.

use super::axis::{Range, Steps, nice_step, tick_label, ticks};
use super::style::{FRAME, GRID, INK, SMALL_SIZE, TEXT_SIZE};
use super::svg::{Anchor, Point, Rect, Svg, TextStyle};

/// Least distance between ticks along and up, page units.
const TICKS: (f64, f64) = (66.0, 26.0);

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
    /// Which ticks are nice on the left.
    pub(crate) steps: Steps,
}

impl Plot {
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
        let rect = self.rect;
        let small = TextStyle::new(SMALL_SIZE, INK);
        let grid = format!(r#"stroke="{GRID}""#);
        let step = nice_step(self.x.span(), (rect.width / TICKS.0).floor(), Steps::Decimal);
        for value in ticks(self.x, step) {
            let x = self.x(value);
            svg.line((x, rect.y), (x, rect.bottom()), &grid);
            if axes.x.is_some() {
                svg.text((x, rect.bottom() + 18.0), &tick_label(value, step), small.anchored(Anchor::Middle));
            }
        }
        let step = nice_step(self.y.span(), (rect.height / TICKS.1).floor(), axes.steps);
        for value in ticks(self.y, step) {
            let y = self.y(value);
            svg.line((rect.x, y), (rect.right(), y), &grid);
            svg.text((rect.x - 8.0, y + 5.0), &tick_label(value, step), small.anchored(Anchor::End));
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

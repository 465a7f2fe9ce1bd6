//! A panel with two linear axes.

use crate::drawing::axis::{Range, Steps, nice_step, tick_label, ticks};
use crate::drawing::style::{FRAME, GRID, INK, SMALL_SIZE, TEXT_SIZE};
use crate::drawing::svg::{Anchor, Point, Rect, Svg, TextStyle};

/// From data to the page.
#[derive(Clone, Copy, Debug)]
pub(super) struct Plot {
    pub(super) rect: Rect,
    pub(super) x: Range,
    pub(super) y: Range,
}

impl Plot {
    /// Both axes to one scale, the data in the middle.
    pub(super) fn to_scale(rect: Rect, x: Range, y: Range) -> Self {
        let scale = (rect.width / x.span()).min(rect.height / y.span());
        let around = |range: Range, length: f64| {
            let half = 0.5 * length / scale;
            Range { low: range.middle() - half, high: range.middle() + half }
        };
        Self { rect, x: around(x, rect.width), y: around(y, rect.height) }
    }

    pub(super) fn point(&self, x: f64, y: f64) -> Point {
        let part = |range: Range, value: f64| (value - range.low) / range.span();
        (
            self.rect.x + part(self.x, x) * self.rect.width,
            self.rect.bottom() - part(self.y, y) * self.rect.height,
        )
    }

    /// Grid, ticks and labels; no numbers along x without a label for it. One step for both axes where both are to one
    /// scale.
    pub(super) fn axes(&self, svg: &mut Svg, x_label: &str, y_label: &str, y_steps: Steps, one_step: bool) {
        let rect = self.rect;
        svg.rect(&rect, "fill=\"#ffffff\"");
        let small = TextStyle::new(SMALL_SIZE, INK);
        let label = TextStyle::new(TEXT_SIZE, INK);
        let grid = format!(r#"stroke="{GRID}""#);
        let x_step = nice_step(self.x.span(), (rect.width / 70.0).floor(), Steps::Decimal);
        // Steps of degrees are few, and the next larger one may be all of the axis.
        let apart = if let Steps::Degrees = y_steps { 26.0 } else { 40.0 };
        let own = nice_step(self.y.span(), (rect.height / apart).floor(), y_steps);
        let y_step = if one_step { x_step.max(own) } else { own };
        let x_step = if one_step { y_step } else { x_step };
        for value in ticks(self.x, x_step) {
            let (x, _) = self.point(value, self.y.low);
            svg.line((x, rect.y), (x, rect.bottom()), &grid);
            if !x_label.is_empty() {
                let text = tick_label(value, x_step);
                svg.text((x, rect.bottom() + 18.0), &text, small.anchored(Anchor::Middle));
            }
        }
        for value in ticks(self.y, y_step) {
            let (_, y) = self.point(self.x.low, value);
            svg.line((rect.x, y), (rect.right(), y), &grid);
            svg.text((rect.x - 8.0, y + 5.0), &tick_label(value, y_step), small.anchored(Anchor::End));
        }
        let middle = (rect.x + 0.5 * rect.width, rect.y + 0.5 * rect.height);
        svg.text((middle.0, rect.bottom() + 40.0), x_label, label.anchored(Anchor::Middle));
        svg.text_upwards((rect.x - 48.0, middle.1), y_label, label);
    }

    pub(super) fn frame(&self, svg: &mut Svg) {
        svg.rect(&self.rect, &format!(r#"fill="none" stroke="{FRAME}""#));
    }
}

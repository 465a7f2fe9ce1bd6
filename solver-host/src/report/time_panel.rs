//! One panel over time: curves planned and flown, limits, the switching function, and a strip that names the inputs.

use super::view::{Span, View};
use crate::drawing::axis::Range;
use crate::drawing::plot::{Axes, Plot};
use crate::drawing::style::{
    CELLS, FLOWN, INK, LIMIT, MUTED, SINGULAR, SMALL_SIZE, STRIP, SWITCHING, TEXT_SIZE,
};
use crate::drawing::svg::{Anchor, Point, Rect, Svg, TextStyle, fit, text_width};

/// Values over time, s.
pub(super) type Series = Vec<(f64, f64)>;

/// What one panel shows.
#[derive(Debug)]
pub(super) struct TimePanel {
    /// Short name, for the element's class.
    pub(super) class: &'static str,
    /// Quantity and unit.
    pub(super) label: String,
    /// Shown values.
    pub(super) range: Range,
    pub(super) planned: Vec<Series>,
    pub(super) flown: Vec<Series>,
    /// Names of the curves, at their ends.
    pub(super) names: Vec<(f64, &'static str)>,
    /// Values of limits.
    pub(super) limits: Vec<f64>,
    /// The switching function in the panel's own scale, and where it is zero.
    pub(super) switching: Option<(Series, f64)>,
    /// The strip above the panel.
    pub(super) strip: Vec<Span>,
}

/// A panel's plot over time.
struct Frame(Plot);

impl Frame {
    fn points(&self, series: &Series) -> Vec<Point> {
        // A little beyond the window, so that curves reach the frame and are cut there.
        let wider = self.0.x.padded(0.05);
        series
            .iter()
            .filter(|(t, _)| *t >= wider.low && *t <= wider.high)
            .map(|point| self.0.point(*point))
            .collect()
    }

    fn span(&self, span: &Span, y: f64, height: f64) -> Rect {
        let clamp = |t| self.0.x(t).clamp(self.0.rect.x, self.0.rect.right());
        let x = clamp(span.from_s);
        Rect { x, y, width: clamp(span.to_s) - x, height }
    }
}

/// Draws a panel; `labelled` panels carry the labels of the time axis.
pub(super) fn draw(svg: &mut Svg, view: &View, panel: &TimePanel, rect: Rect, labelled: bool) {
    let frame = Frame(Plot { rect, x: view.window, y: panel.range });
    svg.open_group(&format!(r#"class="{}""#, panel.class));
    svg.rect(&rect, "fill=\"#ffffff\"");
    for span in &view.singular {
        svg.rect(&frame.span(span, rect.y, rect.height), &format!(r#"class="singular" fill="{SINGULAR}""#));
    }
    let time = labelled.then_some("time t (s)");
    frame.0.axes(svg, &Axes { x: time, y: &panel.label });
    ends_of_maneuver(svg, &frame, view);

    frame.0.clipped(svg, panel.class, |svg| {
        for limit in &panel.limits {
            let y = frame.0.y(*limit);
            let style = format!(r#"stroke="{LIMIT}" stroke-width="1.5" stroke-dasharray="7 5""#);
            svg.line((rect.x, y), (rect.right(), y), &style);
        }
        for series in &panel.flown {
            svg.curve(&frame.points(series), &format!(r#"class="flown" stroke="{FLOWN}" stroke-width="3""#));
        }
        if let Some((series, zero)) = &panel.switching {
            let y = frame.0.y(*zero);
            let style = format!(r#"stroke="{SWITCHING}" stroke-width="1" stroke-dasharray="1.5 4""#);
            svg.line((rect.x, y), (rect.right(), y), &style);
            svg.curve(
                &frame.points(series),
                &format!(r#"class="switching" stroke="{SWITCHING}" stroke-width="1.6""#),
            );
        }
        for series in &panel.planned {
            svg.curve(
                &frame.points(series),
                &format!(r#"class="planned" stroke="{INK}" stroke-width="1.5""#),
            );
        }
    });
    frame.0.frame(svg);
    strip(svg, &frame, panel);
    names(svg, &frame, panel);
    svg.close_group();
}

/// Lines at 0 and T where the window shows more than the maneuver.
fn ends_of_maneuver(svg: &mut Svg, frame: &Frame, view: &View) {
    for t in [0.0, view.duration_s] {
        if view.duration_s > 0.0 && t > frame.0.x.low && t < frame.0.x.high {
            let x = frame.0.x(t);
            svg.line(
                (x, frame.0.rect.y),
                (x, frame.0.rect.bottom()),
                &format!(r#"stroke="{MUTED}" stroke-width="1.2""#),
            );
        }
    }
}

fn strip(svg: &mut Svg, frame: &Frame, panel: &TimePanel) {
    let (y, height) = (frame.0.rect.y - STRIP, STRIP - 2.0);
    for (i, span) in panel.strip.iter().enumerate() {
        let cell = frame.span(span, y, height);
        if cell.width <= 0.0 {
            continue;
        }
        let fill = if span.name == "s" { SINGULAR } else { CELLS[i % 2] };
        svg.rect(&cell, &format!(r##"fill="{fill}" stroke="#ffffff""##));
        let name = fit(&span.name, SMALL_SIZE, cell.width.max(text_width("max", SMALL_SIZE)));
        if text_width(&name, SMALL_SIZE) + 1.0 <= cell.width {
            let at = (cell.x + 0.5 * cell.width, y + height - 4.0);
            svg.text(at, &name, TextStyle::new(SMALL_SIZE, MUTED).anchored(Anchor::Middle));
        }
    }
}

/// Names the curves at the right edge. Two that end together are named inside, where they are farthest apart.
fn names(svg: &mut Svg, frame: &Frame, panel: &TimePanel) {
    let style = TextStyle::new(TEXT_SIZE, INK);
    let mut places: Vec<(f64, &str)> = panel.names.iter().map(|(v, name)| (frame.0.y(*v), *name)).collect();
    places.sort_by(|a, b| a.0.total_cmp(&b.0));
    if let ([first, second], [(above, _), (below, _)]) = (panel.names.as_slice(), places.as_slice())
        && below - above < SMALL_SIZE
        && let Some((t, one, other)) = farthest_apart(panel)
    {
        let (x, y, y_other) = (frame.0.x(t), frame.0.y(one), frame.0.y(other));
        let (above, below) = if y < y_other { (first.1, second.1) } else { (second.1, first.1) };
        svg.text((x - 7.0, y.min(y_other) - 4.0), above, style.anchored(Anchor::End));
        svg.text((x + 7.0, y.max(y_other) + 13.0), below, style);
        return;
    }
    for (y, name) in places {
        let y = y.clamp(frame.0.rect.y + 6.0, frame.0.rect.bottom() - 6.0);
        svg.text((frame.0.rect.right() + 7.0, y + 5.0), name, style);
    }
}

/// When the two curves of a panel are farthest apart, and their values then.
fn farthest_apart(panel: &TimePanel) -> Option<(f64, f64, f64)> {
    [&panel.planned, &panel.flown]
        .into_iter()
        .filter_map(|curves| match curves.as_slice() {
            [one, other] => one
                .iter()
                .zip(other)
                .map(|((t, a), (_, b))| (*t, *a, *b))
                .max_by(|p, q| (p.1 - p.2).abs().total_cmp(&(q.1 - q.2).abs())),
            _ => None,
        })
        .next()
}

//! One panel over time: curves planned and flown, limits, the switching function, and a strip that names the inputs.

use super::axis::{Range, Steps, nice_step, tick_label, ticks};
use super::style::{
    CELLS, FLOWN, FRAME, GRID, INK, LIMIT, MUTED, SINGULAR, SMALL_SIZE, STRIP, SWITCHING, TEXT_SIZE,
};
use super::svg::{Anchor, Point, Rect, Svg, TextStyle, fit, text_width};
use super::view::{Span, View};

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
    /// Which ticks are nice.
    pub(super) steps: Steps,
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

struct Frame {
    rect: Rect,
    time: Range,
    values: Range,
}

impl Frame {
    fn x(&self, t_s: f64) -> f64 {
        self.rect.x + (t_s - self.time.low) / self.time.span() * self.rect.width
    }

    fn y(&self, value: f64) -> f64 {
        self.rect.bottom() - (value - self.values.low) / self.values.span() * self.rect.height
    }

    fn points(&self, series: &Series) -> Vec<Point> {
        // A little beyond the window, so that curves reach the frame and are cut there.
        let wider = self.time.padded(0.05);
        series
            .iter()
            .filter(|(t, _)| *t >= wider.low && *t <= wider.high)
            .map(|(t, v)| (self.x(*t), self.y(*v)))
            .collect()
    }

    fn span(&self, span: &Span, y: f64, height: f64) -> Rect {
        let clamp = |t| self.x(t).clamp(self.rect.x, self.rect.right());
        let x = clamp(span.from_s);
        Rect { x, y, width: clamp(span.to_s) - x, height }
    }
}

/// Draws a panel; `labelled` panels carry the labels of the time axis.
pub(super) fn draw(svg: &mut Svg, view: &View, panel: &TimePanel, rect: Rect, labelled: bool) {
    let frame = Frame { rect, time: view.window, values: panel.range };
    svg.open_group(&format!(r#"class="{}""#, panel.class));
    svg.raw(&format!(r#"<clipPath id="{}">"#, panel.class));
    svg.rect(&rect, "");
    svg.raw("</clipPath>");

    svg.rect(&rect, "fill=\"#ffffff\"");
    for span in &view.singular {
        svg.rect(&frame.span(span, rect.y, rect.height), &format!(r#"class="singular" fill="{SINGULAR}""#));
    }
    axes(svg, &frame, panel, labelled);
    ends_of_maneuver(svg, &frame, view);

    svg.open_group(&format!(r#"clip-path="url(#{})""#, panel.class));
    for limit in &panel.limits {
        let y = frame.y(*limit);
        let style = format!(r#"stroke="{LIMIT}" stroke-width="1.5" stroke-dasharray="7 5""#);
        svg.line((rect.x, y), (rect.right(), y), &style);
    }
    for series in &panel.flown {
        svg.curve(&frame.points(series), &format!(r#"class="flown" stroke="{FLOWN}" stroke-width="3""#));
    }
    if let Some((series, zero)) = &panel.switching {
        let y = frame.y(*zero);
        let style = format!(r#"stroke="{SWITCHING}" stroke-width="1" stroke-dasharray="1.5 4""#);
        svg.line((rect.x, y), (rect.right(), y), &style);
        svg.curve(
            &frame.points(series),
            &format!(r#"class="switching" stroke="{SWITCHING}" stroke-width="1.6""#),
        );
    }
    for series in &panel.planned {
        svg.curve(&frame.points(series), &format!(r#"class="planned" stroke="{INK}" stroke-width="1.5""#));
    }
    svg.close_group();
    svg.rect(&rect, &format!(r#"fill="none" stroke="{FRAME}""#));
    strip(svg, &frame, panel);
    names(svg, &frame, panel);
    svg.close_group();
}

fn axes(svg: &mut Svg, frame: &Frame, panel: &TimePanel, labelled: bool) {
    let rect = frame.rect;
    let small = TextStyle::new(SMALL_SIZE, INK);
    let grid = format!(r#"stroke="{GRID}""#);
    let step = nice_step(frame.time.span(), (rect.width / 78.0).floor(), Steps::Decimal);
    for t in ticks(frame.time, step) {
        let x = frame.x(t);
        svg.line((x, rect.y), (x, rect.bottom()), &grid);
        if labelled {
            svg.text((x, rect.bottom() + 18.0), &tick_label(t, step), small.anchored(Anchor::Middle));
        }
    }
    let step = nice_step(frame.values.span(), (rect.height / 26.0).floor(), panel.steps);
    for value in ticks(frame.values, step) {
        let y = frame.y(value);
        svg.line((rect.x, y), (rect.right(), y), &grid);
        svg.text((rect.x - 8.0, y + 5.0), &tick_label(value, step), small.anchored(Anchor::End));
    }
    let label = TextStyle::new(TEXT_SIZE, INK);
    svg.text_upwards((rect.x - 48.0, rect.y + 0.5 * rect.height), &panel.label, label);
    if labelled {
        let middle = rect.x + 0.5 * rect.width;
        svg.text((middle, rect.bottom() + 40.0), "time t (s)", label.anchored(Anchor::Middle));
    }
}

/// Lines at 0 and T where the window shows more than the maneuver.
fn ends_of_maneuver(svg: &mut Svg, frame: &Frame, view: &View) {
    for t in [0.0, view.duration_s] {
        if view.duration_s > 0.0 && t > frame.time.low && t < frame.time.high {
            let x = frame.x(t);
            svg.line(
                (x, frame.rect.y),
                (x, frame.rect.bottom()),
                &format!(r#"stroke="{MUTED}" stroke-width="1.2""#),
            );
        }
    }
}

fn strip(svg: &mut Svg, frame: &Frame, panel: &TimePanel) {
    let (y, height) = (frame.rect.y - STRIP, STRIP - 2.0);
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
    let mut places: Vec<(f64, &str)> = panel.names.iter().map(|(v, name)| (frame.y(*v), *name)).collect();
    places.sort_by(|a, b| a.0.total_cmp(&b.0));
    if let ([first, second], [(above, _), (below, _)]) = (panel.names.as_slice(), places.as_slice())
        && below - above < SMALL_SIZE
        && let Some((t, one, other)) = farthest_apart(panel)
    {
        let (x, y, y_other) = (frame.x(t), frame.y(one), frame.y(other));
        let (above, below) = if y < y_other { (first.1, second.1) } else { (second.1, first.1) };
        svg.text((x - 7.0, y.min(y_other) - 4.0), above, style.anchored(Anchor::End));
        svg.text((x + 7.0, y.max(y_other) + 13.0), below, style);
        return;
    }
    for (y, name) in places {
        let y = y.clamp(frame.rect.y + 6.0, frame.rect.bottom() - 6.0);
        svg.text((frame.rect.right() + 7.0, y + 5.0), name, style);
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

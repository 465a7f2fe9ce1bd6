//! A flight and the fastest maneuver between the same states: their paths with marks at equal times, and their motion
//! over time.

use mintime_shared::model::State;

use crate::benchmark::Score;
use crate::drawing::axis::Range;
use crate::drawing::legend::{self, Key};
use crate::drawing::page;
use crate::drawing::plot::{Axes, Plot};
use crate::drawing::style::{AXIS_BELOW, AXIS_LEFT, FLOWN, INK, LIMIT, MARGIN, SMALL_SIZE, WIDTH};
use crate::drawing::svg::{Anchor, Rect, Svg, TextStyle};

/// Height of the panels together.
const PANELS: f64 = 600.0;
/// Width of the path's panel.
const PATH: f64 = 600.0;
/// Between two panels over time.
const GAP: f64 = 14.0;
/// Samples of the fastest maneuver.
const SAMPLES: u32 = 600;
/// Intervals between marks to choose from, s.
const MARKS_S: [f64; 8] = [0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0];
/// Most marks on the slower path.
const MOST_MARKS: f64 = 24.0;

type Track = Vec<(f64, State<f64>)>;
/// Label, value of a state, smallest range.
type Quantity = (&'static str, fn(&State<f64>) -> f64, f64);

pub(super) fn draw(score: &Score, title: &str, subtitle: &[String]) -> String {
    let extremal = &score.optimal.extremal;
    let optimal_s = extremal.duration_s();
    let optimal: Track = (0..=SAMPLES)
        .map(|i| optimal_s * f64::from(i) / f64::from(SAMPLES))
        .map(|t| (t, extremal.state_at(t)))
        .collect();
    let step_s = MARKS_S.into_iter().find(|s| score.duration_s / s <= MOST_MARKS).unwrap_or(score.duration_s);

    let mut svg = Svg::default();
    let y = page::heading(&mut svg, WIDTH, title, subtitle);
    let y = legend::rows(&mut svg, &keys(step_s), (MARGIN, WIDTH - MARGIN), y + 34.0) + 22.0;
    let path = Rect { x: MARGIN + AXIS_LEFT, y, width: PATH - AXIS_LEFT, height: PANELS };
    draw_path(&mut svg, path, &score.flown, &optimal, step_s);
    let left = MARGIN + PATH + 24.0 + AXIS_LEFT;
    let height = (PANELS - 2.0 * GAP) / 3.0;
    let quantities: [Quantity; 3] =
        [("x (m)", |s| s.x, 0.1), ("z (m)", |s| s.z, 0.1), ("pitch θ (rad)", |s| s.theta, 0.2)];
    for (i, (label, value, least)) in quantities.into_iter().enumerate() {
        let rect = Rect { x: left, y: y + i as f64 * (height + GAP), width: WIDTH - MARGIN - left, height };
        let range = Range::of(score.flown.iter().chain(&optimal).map(|(_, s)| value(s)));
        let range = range.unwrap_or(Range { low: 0.0, high: 1.0 }).at_least(least).padded(0.08);
        let plot =
            Plot { rect, x: Range { low: 0.0, high: 1.04 * score.duration_s.max(optimal_s) }, y: range };
        plot.axes(&mut svg, &Axes { x: (i == 2).then_some("time from departure (s)"), y: label });
        durations(&mut svg, &plot, optimal_s, score.duration_s, i == 0);
        let points = |track: &Track| plot.points(track.iter().map(|(t, s)| (*t, value(s))));
        svg.curve(&points(&score.flown), &format!(r#"stroke="{FLOWN}" stroke-width="3""#));
        svg.curve(&points(&optimal), &format!(r#"stroke="{INK}" stroke-width="1.4""#));
        plot.frame(&mut svg);
    }
    page::document(WIDTH, y + PANELS + AXIS_BELOW + MARGIN, title, &subtitle.join(" "), svg)
}

/// Where the fastest maneuver and the flight end, with their names if `named`: side by side where they are close.
fn durations(svg: &mut Svg, plot: &Plot, optimal_s: f64, duration_s: f64, named: bool) {
    let close = (plot.x(optimal_s) - plot.x(duration_s)).abs() < 24.0;
    let (before, after) = if close { (Anchor::End, Anchor::Start) } else { (Anchor::Middle, Anchor::Middle) };
    let gap = if close { 3.0 } else { 0.0 };
    for (x, name, anchor, shift) in
        [(plot.x(optimal_s), "T*", before, -gap), (plot.x(duration_s), "T", after, gap)]
    {
        let dashes = format!(r#"stroke="{LIMIT}" stroke-width="1.2" stroke-dasharray="5 4""#);
        svg.line((x, plot.rect.y), (x, plot.rect.bottom()), &dashes);
        if named {
            let style = TextStyle::new(SMALL_SIZE, INK).bold().anchored(anchor);
            svg.text((x + shift, plot.rect.y - 5.0), name, style);
        }
    }
}

fn keys(step_s: f64) -> [Key; 5] {
    let line = |colour: &str, text| Key::line(&format!(r#"stroke="{colour}" stroke-width="2.4""#), text);
    [
        line(FLOWN, "flown"),
        line(INK, "fastest maneuver between the same two states"),
        Key::dot(4.0, &format!(r#"fill="{LIMIT}""#), format!("every {step_s} s")),
        Key::dot(5.5, &start(), "start"),
        Key::dot(5.5, &end(), "end"),
    ]
}

/// How the start is marked.
fn start() -> String {
    format!(r##"fill="#ffffff" stroke="{INK}" stroke-width="2.2""##)
}

/// How the end is marked.
fn end() -> String {
    format!(r##"fill="{INK}" stroke="#ffffff" stroke-width="1.6""##)
}

fn draw_path(svg: &mut Svg, rect: Rect, flown: &Track, optimal: &Track, step_s: f64) {
    let nothing = Range { low: 0.0, high: 1.0 };
    let all = || flown.iter().chain(optimal);
    let x = Range::of(all().map(|(_, s)| s.x)).unwrap_or(nothing);
    let z = Range::of(all().map(|(_, s)| s.z)).unwrap_or(nothing);
    let least = (0.02 * x.span().max(z.span())).max(1e-3);
    let plot = Plot::to_scale(rect, x.at_least(least).padded(0.07), z.at_least(least).padded(0.07));
    plot.axes_to_scale(svg, &Axes { x: Some("x (m)"), y: "z (m)" });
    for (track, colour, width) in [(flown, FLOWN, 3.0), (optimal, INK, 1.4)] {
        let points = plot.points(track.iter().map(|(_, s)| (s.x, s.z)));
        svg.curve(&points, &format!(r#"stroke="{colour}" stroke-width="{width}""#));
        let last_s = track.last().map_or(0.0, |(t, _)| *t);
        let marks = (1..).map(|i| f64::from(i) * step_s).take_while(|t| *t < last_s);
        for mark in marks {
            let after = track.partition_point(|(t, _)| *t < mark);
            let (Some((ta, a)), Some((tb, b))) = (track.get(after.saturating_sub(1)), track.get(after))
            else {
                continue;
            };
            let u = if tb > ta { (mark - ta) / (tb - ta) } else { 0.0 };
            let at = plot.point((a.x + (b.x - a.x) * u, a.z + (b.z - a.z) * u));
            svg.circle(at, width + 1.6, &format!(r##"fill="{colour}" stroke="#ffffff" stroke-width="0.8""##));
        }
    }
    if let (Some((_, first)), Some((_, last))) = (flown.first(), flown.last()) {
        svg.circle(plot.point((first.x, first.z)), 5.5, &start());
        svg.circle(plot.point((last.x, last.z)), 5.5, &end());
    }
    plot.frame(svg);
}

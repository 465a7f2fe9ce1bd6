//! A study's picture: for each parameter T above, and its elasticity below.

use std::f64::consts::TAU;

use super::{Curve, Found, Maneuver, Parameter, Point, Study};
use crate::drawing::axis::Range;
use crate::drawing::legend::{self, Key};
use crate::drawing::page;
use crate::drawing::plot::{Axes, Plot};
use crate::drawing::style::{AXIS_BELOW, AXIS_LEFT, MARGIN, MUTED, WIDTH};
use crate::drawing::svg::{Rect, Svg};

/// Heights of the upper and the lower panels.
const HEIGHTS: (f64, f64) = (320.0, 200.0);
/// Strokes of maneuvers: Okabe and Ito's colours, and dashes for those who see none.
const STROKES: [(&str, &str); super::MOST_MANEUVERS] = [
    ("#16263a", ""),
    ("#d55e00", r#"stroke-dasharray="9 4""#),
    ("#0072b2", r#"stroke-dasharray="3 3""#),
    ("#009e73", r#"stroke-dasharray="12 3 3 3""#),
    ("#cc79a7", r#"stroke-dasharray="6 2""#),
    ("#e69f00", r#"stroke-dasharray="2 4""#),
];

/// The picture as SVG text.
pub(super) fn draw(study: &Study) -> String {
    let limits = &study.limits;
    let title = "Duration of fastest maneuvers against the vehicle's limits";
    let lines = [
        format!(
            "Each limit varied alone; the dots are the vehicle: {} and {} m/s² of greatest and least thrust per mass, {} rad/s.",
            limits.thrust_max_mps2, limits.thrust_min_mps2, limits.rate_max_radps
        ),
        "Below, the elasticity: by how many per cent T changes where the limit changes by one. It jumps where the number of full turns changes,"
            .to_owned(),
        "and where a full turn of pitch takes all of T: T = 2π/ω_{max}, which more thrust does not shorten."
            .to_owned(),
    ];
    let mut svg = Svg::default();
    let y = page::heading(&mut svg, WIDTH, title, &lines);
    let keys: Vec<Key> = study
        .maneuvers
        .iter()
        .zip(STROKES)
        .map(|(m, stroke)| {
            let text = format!("x = {} m, z = {} m: T = {:.3} s", m.x_m, m.z_m, m.duration_s);
            Key::line(&attributes(stroke), text)
        })
        .chain([Key::line(&vehicle_line(), "the vehicle's own value")])
        .collect();
    let top = legend::rows(&mut svg, &keys, (MARGIN, WIDTH - MARGIN), y + 34.0) + 28.0;

    let columns: Vec<Parameter> =
        study.maneuvers.first().map(|m| m.curves.iter().map(|c| c.parameter).collect()).unwrap_or_default();
    let count = columns.len().max(1) as f64;
    let gap = 14.0;
    let width = (WIDTH - 2.0 * MARGIN - (count - 1.0) * gap) / count - AXIS_LEFT;
    let duration = |f: &Found| f.duration_s;
    let elasticity = |f: &Found| f.elasticity;
    let longest = range(study, None, duration);
    for (i, parameter) in columns.into_iter().enumerate() {
        let x = MARGIN + AXIS_LEFT + i as f64 * (width + AXIS_LEFT + gap);
        let values = study.maneuvers.iter().filter_map(|m| curve(m, parameter)).flat_map(|c| &c.points);
        let along = Range::of(values.map(|p| p.value)).unwrap_or(Range { low: 0.0, high: 1.0 });
        let upper = Plot {
            rect: Rect { x, y: top, width, height: HEIGHTS.0 },
            x: along,
            y: Range { low: 0.0, high: 1.05 * longest.high },
        };
        let label = format!("{} ({})", words(parameter), parameter.unit());
        upper.axes(&mut svg, &Axes { x: None, y: "T (s)" });
        panel(&mut svg, study, parameter, &upper, (&format!("duration{i}"), false), duration);
        let lower = Plot {
            rect: Rect { x, y: top + HEIGHTS.0 + 24.0, width, height: HEIGHTS.1 },
            x: along,
            y: range(study, Some(parameter), elasticity).and(Range::of([0.0])).at_least(0.01).padded(0.06),
        };
        lower.axes(&mut svg, &Axes { x: Some(&label), y: "elasticity (% per %)" });
        panel(&mut svg, study, parameter, &lower, (&format!("elasticity{i}"), true), elasticity);
    }
    let height = top + HEIGHTS.0 + 24.0 + HEIGHTS.1 + AXIS_BELOW + MARGIN;
    page::document(WIDTH, height, title, &lines.join(" "), svg)
}

/// What a parameter is called on an axis.
fn words(parameter: Parameter) -> &'static str {
    match parameter {
        Parameter::MaxThrust => "greatest thrust per mass",
        Parameter::MinThrust => "least thrust per mass",
        Parameter::Rate => "greatest body rate",
    }
}

fn attributes((colour, dashes): (&str, &str)) -> String {
    format!(r#"stroke="{colour}" stroke-width="2.2" {dashes}"#)
}

fn vehicle_line() -> String {
    format!(r#"stroke="{MUTED}" stroke-width="1.2" stroke-dasharray="5 4""#)
}

fn curve(maneuver: &Maneuver, parameter: Parameter) -> Option<&Curve> {
    maneuver.curves.iter().find(|c| c.parameter == parameter)
}

/// Of a value, over all maneuvers along one parameter or along all.
fn range(study: &Study, parameter: Option<Parameter>, value: fn(&Found) -> f64) -> Range {
    let curves = study.maneuvers.iter().flat_map(|m| &m.curves);
    let shown = curves.filter(|c| parameter.is_none_or(|p| p == c.parameter));
    let found = shown.flat_map(|c| c.points.iter().filter_map(|p| p.outcome.as_ref().ok()).chain([&c.here]));
    Range::of(found.map(value)).unwrap_or(Range { low: 0.0, high: 1.0 })
}

fn panel(
    svg: &mut Svg,
    study: &Study,
    parameter: Parameter,
    plot: &Plot,
    (name, jumps): (&str, bool),
    value: fn(&Found) -> f64,
) {
    let own = parameter.of(&study.limits);
    plot.clipped(svg, name, |svg| {
        let x = plot.x(own);
        svg.line((x, plot.rect.y), (x, plot.rect.bottom()), &vehicle_line());
        for (maneuver, stroke) in study.maneuvers.iter().zip(STROKES) {
            let Some(curve) = curve(maneuver, parameter) else { continue };
            // Derivatives jump where another number of turns takes over, and where T is no longer than its turns.
            let turns = |point: &Point, found: &Found| {
                let rate_radps = parameter.set(&study.limits, point.value).rate_max_radps;
                let turning_s = TAU * f64::from(found.turns.abs()) / rate_radps;
                (found.turns.abs(), found.duration_s <= turning_s * (1.0 + 1e-6))
            };
            // A gap where there is no maneuver.
            let joined = |a: &Point, b: &Point| match (&a.outcome, &b.outcome) {
                (Ok(found), Ok(next)) => !jumps || turns(a, found) == turns(b, next),
                _ => false,
            };
            for group in curve.points.chunk_by(joined) {
                let found = group.iter().filter_map(|p| Some((p.value, value(p.outcome.as_ref().ok()?))));
                svg.curve(&plot.points(found), &format!(r#"class="curve" {}"#, attributes(stroke)));
            }
            let dot = format!(r##"fill="{}" stroke="#ffffff" stroke-width="1.2""##, stroke.0);
            svg.circle(plot.point((own, value(&curve.here))), 5.0, &dot);
        }
    });
    plot.frame(svg);
}

//! Inputs over time for a family of maneuvers: the parameter to the right, time upwards, a band for each value of the
//! input, as in the paper's Fig. 3 and 5.

use mintime_shared::model::{Inputs, RateMode, ThrustLevel};

use super::line::{Sample, changes_of};
use crate::drawing::legend::Key;
use crate::drawing::plot::Plot;
use crate::drawing::style::{BACK, FORWARD, FULL, INK, LEAST, MUTED, SINGULAR, SMALL_SIZE};
use crate::drawing::svg::{Anchor, Point, Svg, TextStyle, text_width};

/// Which of the two inputs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Input {
    Rate,
    Thrust,
}

/// Colour and name of an input's value.
fn look(input: Input, inputs: &Inputs) -> (&'static str, &'static str) {
    match (input, inputs.rate, inputs.thrust) {
        (Input::Rate, RateMode::Plus, _) => (FORWARD, "+1"),
        (Input::Rate, RateMode::Minus, _) => (BACK, "−1"),
        (Input::Rate, RateMode::Singular, _) => (SINGULAR, "singular"),
        (Input::Thrust, _, ThrustLevel::Max) => (FULL, "max"),
        (Input::Thrust, _, ThrustLevel::Min) => (LEAST, "min"),
    }
}

/// Keys of all values.
pub(crate) fn keys() -> [Key; 5] {
    let key = |input, rate, thrust, text| Key::area(look(input, &Inputs { rate, thrust }).0, text);
    [
        key(Input::Rate, RateMode::Plus, ThrustLevel::Max, "+1: forward at the limit"),
        key(Input::Rate, RateMode::Minus, ThrustLevel::Max, "−1: back at the limit"),
        key(Input::Rate, RateMode::Singular, ThrustLevel::Max, "singular arc"),
        key(Input::Thrust, RateMode::Plus, ThrustLevel::Max, "full thrust (max)"),
        key(Input::Thrust, RateMode::Plus, ThrustLevel::Min, "least thrust (min)"),
    ]
}

/// Segments with one value of the input, as indices.
struct Run {
    fill: &'static str,
    name: &'static str,
    first: usize,
    end: usize,
}

fn runs(input: Input, sample: &Sample) -> Vec<Run> {
    let mut runs: Vec<Run> = Vec::new();
    for (i, inputs) in sample.structure.inputs.iter().enumerate() {
        let (fill, name) = look(input, inputs);
        match runs.last_mut() {
            Some(run) if run.name == name => run.end = i + 1,
            _ => runs.push(Run { fill, name, first: i, end: i + 1 }),
        }
    }
    runs
}

/// The time at which segment `i` begins, s.
fn begins_s(sample: &Sample, i: usize) -> f64 {
    sample.extremal.segments.iter().take(i).map(|s| s.duration).sum()
}

/// Draws the bands, the switches between them, T, and the places where the structure changes. Samples are refined, see
/// [`super::line::Family::sweep`].
pub(crate) fn draw(svg: &mut Svg, plot: &Plot, samples: &[Sample], input: Input) {
    for group in samples.chunk_by(|a, b| a.structure == b.structure) {
        let Some(first) = group.first() else { continue };
        for run in runs(input, first) {
            let side = |i: usize| -> Vec<Point> {
                plot.points(group.iter().map(|sample| (sample.at, begins_s(sample, i))))
            };
            let (lower, upper) = (side(run.first), side(run.end));
            let outline = lower.iter().chain(upper.iter().rev()).copied().collect();
            svg.area(&[outline], &format!(r#"fill="{}""#, run.fill));
            svg.curve(&lower, &format!(r#"stroke="{MUTED}" stroke-width="1""#));
            if let Some(at) = room(&lower, &upper, text_width(run.name, SMALL_SIZE)) {
                let style = TextStyle::new(SMALL_SIZE, INK).anchored(Anchor::Middle);
                svg.text((at.0, at.1 + 5.0), run.name, style);
            }
        }
    }
    for (at, _, _) in changes_of(samples) {
        let x = plot.x(at);
        svg.line(
            (x, plot.rect.y),
            (x, plot.rect.bottom()),
            &format!(r#"stroke="{INK}" stroke-width="1" stroke-dasharray="5 4""#),
        );
    }
    let duration = plot.points(samples.iter().map(|s| (s.at, s.extremal.duration_s())));
    svg.curve(&duration, &format!(r#"class="duration" stroke="{INK}" stroke-width="2.6""#));
}

/// Where between two curves over the same x a text fits, as its middle; the place with most room.
fn room(lower: &[Point], upper: &[Point], width: f64) -> Option<Point> {
    let (half, needed) = (0.5 * width + 6.0, SMALL_SIZE + 3.0);
    let (left, right) = (lower.first()?.0, lower.last()?.0);
    let mut best: Option<(f64, Point)> = None;
    for x in lower.iter().map(|p| p.0).filter(|x| x - half >= left && x + half <= right) {
        let within = lower.iter().zip(upper).filter(|(p, _)| (p.0 - x).abs() <= half);
        let (below, above) = within.fold((f64::INFINITY, f64::NEG_INFINITY), |(below, above), (l, u)| {
            (below.min(l.1), above.max(u.1))
        });
        // Wider places count only up to what reads well, so that labels stay near the middle.
        let free = (below - above).min(2.0 * needed) - 0.02 * (x - 0.5 * (left + right)).abs();
        if below - above >= needed && best.is_none_or(|(most, _)| free > most) {
            best = Some((free, (x, 0.5 * (below + above))));
        }
    }
    best.map(|(_, at)| at)
}

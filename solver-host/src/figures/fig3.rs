//! Fig. 3: T and the switching times of purely horizontal maneuvers, from rest to rest.

use super::bands::{self, Input};
use super::line::{Family, Sample, changes_of, steps};
use super::samples::switch_times;
use super::{Content, FigureError, Number};
use crate::drawing::axis::Range;
use crate::drawing::csv::Csv;
use crate::drawing::legend::{self, Key};
use crate::drawing::page;
use crate::drawing::plot::{Axes, Plot};
use crate::drawing::style::{AXIS_BELOW, AXIS_LEFT, INK, MARGIN, PAPER, SMALL_SIZE, WIDTH};
use crate::drawing::svg::{Anchor, Rect, Svg, TextStyle};
use crate::solver::Request;

/// Changes of structure are found to this, m.
pub(super) const TOLERANCE_M: f64 = 5e-5;
/// Where the paper, in steps of 0.1 m, sees them.
const PAPER_CHANGES_M: [f64; 3] = [1.6, 2.4, 7.9];
/// Height of a panel.
const PANEL: f64 = 330.0;

pub(super) fn draw() -> Result<Content, FigureError> {
    let family =
        Family { request: |x_m| Request::rest_to_rest(x_m, 0.0), name: |e| e.structure().up_to_mirror() };
    let samples = family.sweep(&steps(1, 300, 20.0), TOLERANCE_M)?;
    let changes: Vec<f64> = changes_of(&samples).iter().map(|(at, _, _)| *at).collect();
    let title = "Fig. 3: horizontal maneuvers, duration and switching times".to_owned();
    let at = |i: usize| changes.get(i).map_or("?".to_owned(), |x| format!("{x:.3}"));
    let lines = [
        "A maneuver begins at t = 0 and moves upwards; at each line an input switches to the value above it."
            .to_owned(),
        format!(
            "Arcs appear at {} m (paper: 1.6), least thrust vanishes at {} m (2.4), the arcs merge at {} m (7.9).",
            at(0),
            at(1),
            at(2)
        ),
    ];
    let mut svg = Svg::default();
    let y = page::heading(&mut svg, WIDTH, &title, &lines);
    let mut keys = vec![
        Key::line(&format!(r#"stroke="{INK}" stroke-width="2.6""#), "duration T"),
        Key::line(
            &format!(r#"stroke="{INK}" stroke-width="1" stroke-dasharray="5 4""#),
            "structure changes (m)",
        ),
        Key::line(
            &format!(r#"stroke="{PAPER}" stroke-width="1.6" stroke-dasharray="2 4""#),
            "where the paper sees it, in steps of 0.1 m",
        ),
    ];
    keys.extend(bands::keys());
    let y = legend::rows(&mut svg, &keys, (MARGIN, WIDTH - MARGIN), y + 34.0);
    let height = panels(&mut svg, &samples, y + 36.0);
    Ok(Content {
        svg: page::document(WIDTH, height, &title, &lines.join(" "), svg),
        title,
        tables: vec![("", csv(&samples))],
        numbers: numbers(&samples),
    })
}

fn panels(svg: &mut Svg, samples: &[Sample], top: f64) -> f64 {
    let width = WIDTH - 2.0 * MARGIN - AXIS_LEFT;
    let mut y = top;
    for (input, label, below) in [
        (Input::Rate, "t (s) and pitch rate u_{R}", None),
        (Input::Thrust, "t (s) and thrust u_{T}", Some("displacement x_{T} (m)")),
    ] {
        let rect = Rect { x: MARGIN + AXIS_LEFT, y, width, height: PANEL };
        let plot = Plot { rect, x: Range { low: 0.0, high: 15.0 }, y: Range { low: 0.0, high: 2.0 } };
        plot.axes(svg, &Axes { x: below, y: label });
        bands::draw(svg, &plot, samples, input);
        marks(svg, &plot, &PAPER_CHANGES_M);
        plot.frame(svg);
        if input == Input::Rate {
            change_labels(svg, &plot, samples);
        }
        y += PANEL + 24.0;
    }
    y - 24.0 + AXIS_BELOW + MARGIN
}

/// Where the paper sees changes, from the top of the plot down to the longest maneuvers.
pub(super) fn marks(svg: &mut Svg, plot: &Plot, at: &[f64]) {
    for value in at {
        let x = plot.x(*value);
        let style = format!(r#"class="paper" stroke="{PAPER}" stroke-width="1.6" stroke-dasharray="2 4""#);
        svg.line((x, plot.rect.y), (x, plot.rect.bottom()), &style);
    }
}

/// Above the plot, where the structure changes.
pub(super) fn change_labels(svg: &mut Svg, plot: &Plot, samples: &[Sample]) {
    for (at, _, _) in changes_of(samples) {
        let style = TextStyle::new(SMALL_SIZE, INK).anchored(Anchor::Middle).bold();
        svg.text((plot.x(at), plot.rect.y - 7.0), &format!("{at:.3}"), style);
    }
}

fn csv(samples: &[Sample]) -> String {
    let mut csv = Csv::new("x_m,duration_s,turns,structure,switch_times_s");
    for s in samples {
        let times = switch_times(&s.extremal);
        csv.row([&s.at, &s.extremal.duration_s(), &s.structure.turns, &s.structure, &times]);
    }
    csv.finish()
}

fn numbers(samples: &[Sample]) -> Vec<Number> {
    let changes = changes_of(samples);
    let change = changes.iter().map(|(at, a, b)| {
        Number::new(format!("structure changes from {} to {} at x =", a.structure, b.structure), *at, "m")
    });
    let durations = samples
        .iter()
        .filter(|s| [3.0, 6.0, 9.0, 12.0, 15.0].contains(&s.at))
        .map(|s| Number::new(format!("x = {} m: T =", s.at), s.extremal.duration_s(), "s"));
    durations.chain(change).collect()
}

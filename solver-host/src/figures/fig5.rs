//! Fig. 5: T and the switching times of purely vertical maneuvers, from rest to rest; and how much the paper's maneuvers
//! lose below its flip.

use mintime_shared::model::Limits;

use super::bands::{self, Input};
use super::fig3::{TOLERANCE_M, change_labels, marks};
use super::level::LevelClimb;
use super::line::{Family, Sample, changes_of, steps};
use super::samples::switch_times;
use super::{Content, FigureError, Number};
use crate::drawing::axis::Range;
use crate::drawing::csv::Csv;
use crate::drawing::legend::{self, Key};
use crate::drawing::page;
use crate::drawing::plot::{Axes, Plot};
use crate::drawing::style::{AXIS_BELOW, AXIS_LEFT, INK, MARGIN, PAPER, WIDTH};
use crate::drawing::svg::{Rect, Svg};
use crate::parallel;
use crate::solver::{Request, SolveError, Turns, solve};

/// Where the paper, in steps of 0.1 m, sees its flip win, and an arc upside down appear.
const PAPER_CHANGES_M: [f64; 2] = [2.5, 6.3];
/// Heights of the panels.
const PANELS: [f64; 3] = [330.0, 330.0, 130.0];
/// Stroke of the paper's own curves.
const DASHED: &str = r#"stroke-width="2" stroke-dasharray="7 4""#;
/// Stroke of the windings that do not win.
const OTHER: &str = r#"stroke-width="1.6" stroke-dasharray="1.5 3.5" stroke-linecap="round""#;

/// The fastest at one height beside what else can be flown.
struct Row<'a> {
    sample: &'a Sample,
    /// T without a turn, and with one, s.
    by_turns_s: [f64; 2],
    level: LevelClimb,
}

impl Row<'_> {
    /// T of the paper's maneuver: the faster of the level climb and the flip, s.
    fn paper_s(&self) -> f64 {
        self.level.duration_s().min(self.by_turns_s[1])
    }

    /// By how much that is longer than T, %.
    fn excess_percent(&self) -> f64 {
        (self.paper_s() / self.sample.extremal.duration_s() - 1.0) * 100.0
    }
}

fn with_turns(z_m: f64, turns: i32) -> Result<f64, SolveError> {
    let request = Request { turns: Turns::Exactly(turns), ..Request::rest_to_rest(0.0, z_m) };
    Ok(solve(&request)?.extremal.duration_s())
}

fn rows(samples: &[Sample]) -> Result<Vec<Row<'_>>, SolveError> {
    let row = |sample: &Sample| -> Result<[f64; 2], SolveError> {
        let best_s = sample.extremal.duration_s();
        let of = |turns: i32| {
            if sample.structure.turns == turns { Ok(best_s) } else { with_turns(sample.at, turns) }
        };
        Ok([of(0)?, of(1)?])
    };
    let solved = parallel::map(samples, row, |_| {});
    samples
        .iter()
        .zip(solved)
        .map(|(sample, by_turns_s)| {
            let level = LevelClimb { z_m: sample.at, limits: Limits::TABLE_I };
            Ok(Row { sample, by_turns_s: by_turns_s?, level })
        })
        .collect()
}

/// Where the paper's level climb and the flip take equally long, m: by bisection.
fn papers_flip_m() -> Result<f64, SolveError> {
    let (mut low, mut high) = (2.0, 3.0);
    while high - low > TOLERANCE_M {
        let z_m = 0.5 * (low + high);
        if (LevelClimb { z_m, limits: Limits::TABLE_I }).duration_s() < with_turns(z_m, 1)? {
            low = z_m;
        } else {
            high = z_m;
        }
    }
    Ok(0.5 * (low + high))
}

pub(super) fn draw() -> Result<Content, FigureError> {
    let family =
        Family { request: |z_m| Request::rest_to_rest(0.0, z_m), name: |e| e.structure().up_to_mirror() };
    let samples = family.sweep(&steps(1, 200, 20.0), TOLERANCE_M)?;
    let rows = rows(&samples)?;
    let papers_flip_m = papers_flip_m()?;
    let flip_m = changes_of(&samples)
        .iter()
        .find(|(_, a, b)| a.structure.turns != b.structure.turns)
        .map_or(f64::NAN, |(at, _, _)| *at);
    let title = "Fig. 5: vertical maneuvers, duration and switching times".to_owned();
    let lines = [
        "A maneuver begins at t = 0 and moves upwards; at each line an input switches to the value above it."
            .to_owned(),
        format!(
            "Level, as the paper flies, loses to the flip from {papers_flip_m:.2} m. A swing while the thrust is low beats level at every height, so the flip wins from {flip_m:.3} m only."
        ),
    ];
    let mut svg = Svg::default();
    let y = page::heading(&mut svg, WIDTH, &title, &lines);
    let ink = |rest: &str| format!(r#"stroke="{INK}" {rest}"#);
    let vermilion = |rest: &str| format!(r#"stroke="{PAPER}" {rest}"#);
    let mut keys = vec![
        Key::line(&ink(r#"stroke-width="2.6""#), "duration T"),
        Key::line(&ink(OTHER), "the other number of turns, slower"),
        Key::line(&ink(r#"stroke-width="1" stroke-dasharray="5 4""#), "structure changes (m)"),
        Key::line(&vermilion(DASHED), "level, as in the paper: not optimal"),
        Key::line(
            &vermilion(r#"stroke-width="1.6" stroke-dasharray="2 4""#),
            "where the paper sees changes, in steps of 0.1 m",
        ),
    ];
    keys.extend(bands::keys());
    let y = legend::rows(&mut svg, &keys, (MARGIN, WIDTH - MARGIN), y + 34.0);
    let height = panels(&mut svg, &samples, &rows, y + 36.0);
    let worst = rows.iter().max_by(|a, b| a.excess_percent().total_cmp(&b.excess_percent()));
    let mut numbers = vec![
        Number::new("the flip wins from z =", flip_m, "m"),
        Number::new("the paper's level climb is slower than the flip from z =", papers_flip_m, "m"),
    ];
    numbers.extend(worst.map(|row| {
        let what = format!("at z = {:.2} m the paper's maneuver is longer by", row.sample.at);
        Number::new(what, row.excess_percent(), "%")
    }));
    numbers.extend(changes_of(&samples).iter().map(|(at, a, b)| {
        Number::new(format!("structure changes from {} to {} at z =", a.structure, b.structure), *at, "m")
    }));
    Ok(Content {
        svg: page::document(WIDTH, height, &title, &lines.join(" "), svg),
        title,
        tables: vec![("", csv(&rows))],
        numbers,
    })
}

fn panels(svg: &mut Svg, samples: &[Sample], rows: &[Row<'_>], top: f64) -> f64 {
    let width = WIDTH - 2.0 * MARGIN - AXIS_LEFT;
    let x = Range { low: 0.0, high: 10.0 };
    let mut y = top;
    let mut rect = |height: f64| {
        let rect = Rect { x: MARGIN + AXIS_LEFT, y, width, height };
        y += height + 24.0;
        rect
    };
    // The paper's branch as far as it is the paper's maneuver, and a little further.
    let level = rows.iter().take_while(|r| r.level.duration_s() < r.by_turns_s[1] * 1.03);
    let level: Vec<&Row<'_>> = level.collect();
    for (input, label) in
        [(Input::Rate, "t (s) and pitch rate u_{R}"), (Input::Thrust, "t (s) and thrust u_{T}")]
    {
        let plot = Plot { rect: rect(PANELS[0]), x, y: Range { low: 0.0, high: 2.0 } };
        plot.axes(svg, &Axes { x: None, y: label });
        bands::draw(svg, &plot, samples, input);
        marks(svg, &plot, &PAPER_CHANGES_M);
        for turns in [0, 1] {
            let slower = rows.iter().filter(|r| r.sample.structure.turns.unsigned_abs() as usize != turns);
            let curve = plot.points(slower.map(|r| (r.sample.at, r.by_turns_s[turns])));
            svg.curve(&curve, &format!(r#"class="other-winding" stroke="{INK}" {OTHER}"#));
        }
        let papers =
            |value: fn(&LevelClimb) -> f64| plot.points(level.iter().map(|r| (r.sample.at, value(&r.level))));
        let dashed = format!(r#"class="paper" stroke="{PAPER}" {DASHED}"#);
        svg.curve(&papers(LevelClimb::duration_s), &dashed);
        if input == Input::Thrust {
            svg.curve(&papers(LevelClimb::switch_s), &dashed);
        } else {
            change_labels(svg, &plot, samples);
        }
        plot.frame(svg);
    }
    let plot = Plot { rect: rect(PANELS[2]), x, y: Range { low: 0.0, high: 4.0 } };
    let axes = Axes { x: Some("displacement z_{T} (m)"), y: "paper's loss (%)" };
    plot.axes(svg, &axes);
    let curve = plot.points(rows.iter().map(|r| (r.sample.at, r.excess_percent())));
    svg.curve(&curve, &format!(r#"class="paper" stroke="{PAPER}" {DASHED}"#));
    plot.frame(svg);
    plot.rect.bottom() + AXIS_BELOW + MARGIN
}

fn csv(rows: &[Row<'_>]) -> String {
    let mut csv = Csv::new(
        "z_m,duration_s,turns,structure,switch_times_s,without_turn_s,with_one_turn_s,level_as_in_paper_s,\
         level_thrust_switch_s",
    );
    for row in rows {
        let s = row.sample;
        let (times, [none, one]) = (switch_times(&s.extremal), row.by_turns_s);
        csv.row([
            &s.at,
            &s.extremal.duration_s(),
            &s.structure.turns,
            &s.structure,
            &times,
            &none,
            &one,
            &row.level.duration_s(),
            &row.level.switch_s(),
        ]);
    }
    csv.finish()
}

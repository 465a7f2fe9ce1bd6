//! Fig. 1: vertical maneuvers of 2, 4 and 6 m, drawn along their paths. At 2 m the paper flies level all the way, which is
//! not optimal: its maneuver stands beside ours.

use mintime_shared::model::Limits;

use super::level::LevelClimb;
use super::samples::{Instant, times};
use super::{Content, FigureError, Number, path};
use crate::drawing::csv::Csv;
use crate::drawing::page;
use crate::drawing::plot::Plot;
use crate::drawing::style::{AXIS_BELOW, AXIS_LEFT, INK, MARGIN, MUTED, PAPER, SMALL_SIZE, TEXT_SIZE, WIDTH};
use crate::drawing::svg::{Anchor, Rect, Svg, TextStyle, px};
use crate::solver::{Extremal, Request, solve};

/// Between drawings of the vehicle, s, and in the enlargements: as in the paper.
const VEHICLE_STEP_S: (f64, f64) = (0.03, 0.01);
/// Between samples of the path and rows of the table, s.
const PATH_STEP_S: f64 = 0.005;
/// Page units a metre, and in the enlargements.
const PER_M: (f64, f64) = (112.0, 240.0);
/// Heights shown, m.
const SHOWN_M: (f64, f64) = (-0.45, 6.55);
/// Between the enlargements, page units: for the axis of the one and the heading of the other.
const BETWEEN: f64 = 78.0;
/// Width of a column, page units.
const COLUMN: f64 = 176.0;

/// A maneuver of the figure.
struct Maneuver {
    name: &'static str,
    colour: &'static str,
    duration_s: f64,
    flies: Flies,
}

enum Flies {
    Optimum(Box<Extremal>),
    Level(LevelClimb),
}

impl Maneuver {
    fn optimum(name: &'static str, z_m: f64) -> Result<Self, FigureError> {
        let found = solve(&Request::rest_to_rest(0.0, z_m))?.extremal;
        let duration_s = found.duration_s();
        Ok(Self { name, colour: INK, duration_s, flies: Flies::Optimum(Box::new(found)) })
    }

    fn sampled(&self, step_s: f64) -> Vec<Instant> {
        let at = |t_s: f64| match &self.flies {
            Flies::Optimum(extremal) => {
                let mut instant = Instant::of(extremal, t_s);
                // Mirror images tie; all are drawn to the same side.
                if extremal.structure().up_to_mirror() != extremal.structure() {
                    let s = &mut instant.state;
                    (s.x, s.vx, s.theta) = (-s.x, -s.vx, -s.theta);
                    instant.rate_radps = -instant.rate_radps;
                }
                instant
            }
            Flies::Level(climb) => Instant {
                t_s,
                state: climb.state_at(t_s),
                rate_radps: 0.0,
                thrust_mps2: climb.thrust_at(t_s),
            },
        };
        times(self.duration_s, step_s).into_iter().map(at).collect()
    }
}

fn maneuvers() -> Result<[Maneuver; 4], FigureError> {
    let climb = LevelClimb { z_m: 2.0, limits: Limits::TABLE_I };
    let paper = Maneuver {
        name: "2 m as in the paper",
        colour: PAPER,
        duration_s: climb.duration_s(),
        flies: Flies::Level(climb),
    };
    Ok([
        paper,
        Maneuver::optimum("2 m", 2.0)?,
        Maneuver::optimum("4 m", 4.0)?,
        Maneuver::optimum("6 m", 6.0)?,
    ])
}

pub(super) fn draw() -> Result<Content, FigureError> {
    let all = maneuvers()?;
    let title = "Fig. 1: vertical maneuvers of 2 m, 4 m and 6 m".to_owned();
    let (coarse, fine) = VEHICLE_STEP_S;
    let gain_ms = (all[0].duration_s - all[1].duration_s) * 1e3;
    let lines = [
        format!(
            "The vehicle every {coarse} s, in the enlargements every {fine} s, to scale, with its thrust (blue). At 4 m and 6 m it turns over once and brakes with its thrust down."
        ),
        format!(
            "The paper keeps the vehicle level below its flip. That is not optimal: a swing while the thrust is low is {gain_ms:.1} ms faster at 2 m."
        ),
    ];
    let mut svg = Svg::default();
    let top = page::heading(&mut svg, WIDTH, &title, &lines) + 58.0;
    let height = (SHOWN_M.1 - SHOWN_M.0) * PER_M.0;
    for (i, maneuver) in all.iter().enumerate() {
        let x = MARGIN + AXIS_LEFT + i as f64 * COLUMN;
        let rect = Rect { x, y: top, width: COLUMN - 8.0, height };
        let plot = path::plane(rect, (0.0, 0.5 * (SHOWN_M.0 + SHOWN_M.1)), PER_M.0);
        path::grid(&mut svg, &plot, (0.5, 0.5), (i == 0, true));
        show(&mut svg, &plot, maneuver, VEHICLE_STEP_S.0, &format!("column{i}"));
        let middle = rect.x + 0.5 * rect.width;
        let style = TextStyle::new(SMALL_SIZE, maneuver.colour).anchored(Anchor::Middle).bold();
        svg.text((middle, top - 26.0), maneuver.name, style);
        svg.text((middle, top - 8.0), &format!("T = {:.4} s", maneuver.duration_s), style);
    }
    let bottom = top + height;
    let label = TextStyle::new(TEXT_SIZE, INK);
    svg.text_upwards((MARGIN + 14.0, top + 0.5 * height), "z (m)", label);
    let middle = MARGIN + AXIS_LEFT + 2.0 * COLUMN;
    svg.text((middle, bottom + 40.0), "x (m)", label.anchored(Anchor::Middle));

    let left = MARGIN + AXIS_LEFT + 4.0 * COLUMN + 62.0;
    let width = WIDTH - MARGIN - left;
    let boxed = 0.5 * (height - BETWEEN);
    let enlarge = |svg: &mut Svg, row: f64, maneuver: &Maneuver, from: (f64, f64), name: &str, text: &str| {
        let rect = Rect { x: left, y: top + row * (boxed + BETWEEN), width, height: boxed };
        let plot = path::plane(rect, from, PER_M.1);
        path::grid(svg, &plot, (0.2, 0.2), (true, true));
        show(svg, &plot, maneuver, VEHICLE_STEP_S.1, name);
        svg.text((left + 0.5 * width, rect.bottom() + 40.0), "x (m)", label.anchored(Anchor::Middle));
        svg.text_upwards((left - 46.0, rect.y + 0.5 * boxed), "z (m)", label);
        svg.text((left, rect.y - 8.0), text, TextStyle::new(SMALL_SIZE, MUTED));
        plot
    };
    let flip = enlarge(&mut svg, 0.0, &all[2], (-0.1, 3.5), "flip", "the flip of the 4 m maneuver, enlarged");
    let swing =
        enlarge(&mut svg, 1.0, &all[1], (0.0, 1.5), "swing", "the swing of the 2 m maneuver, enlarged");
    for (column, zoom) in [(2.0, flip), (1.0, swing)] {
        outline(&mut svg, top, column, &zoom);
    }
    Ok(Content {
        svg: page::document(WIDTH, bottom + AXIS_BELOW + MARGIN, &title, &lines.join(" "), svg),
        title,
        tables: vec![("", csv(&all))],
        numbers: all.iter().map(|m| Number::new(format!("{}: T =", m.name), m.duration_s, "s")).collect(),
    })
}

fn show(svg: &mut Svg, plot: &Plot, maneuver: &Maneuver, step_s: f64, name: &str) {
    let (path, vehicles) = (maneuver.sampled(PATH_STEP_S), maneuver.sampled(step_s));
    plot.clipped(svg, name, |svg| {
        path::draw(svg, plot, (&path, &vehicles), Limits::TABLE_I.thrust_max_mps2, maneuver.colour);
    });
    plot.frame(svg);
}

/// In a column, what of it an enlargement shows: as wide as the column at most.
fn outline(svg: &mut Svg, top: f64, column: f64, zoom: &Plot) {
    let x = MARGIN + AXIS_LEFT + column * COLUMN;
    let y = |z_m: f64| top + (SHOWN_M.1 - z_m) * PER_M.0;
    let rect = Rect { x: x + 2.0, y: y(zoom.y.high), width: COLUMN - 12.0, height: zoom.y.span() * PER_M.0 };
    svg.rect(
        &rect,
        &format!(r#"fill="none" stroke="{MUTED}" stroke-width="1.2" stroke-dasharray="{} 3""#, px(4.0)),
    );
}

fn csv(all: &[Maneuver]) -> String {
    let mut csv = Csv::new("maneuver,t_s,x_m,vx_mps,z_m,vz_mps,theta_rad,rate_radps,thrust_mps2");
    for maneuver in all {
        for i in maneuver.sampled(PATH_STEP_S) {
            let (name, s) = (maneuver.name, i.state);
            csv.row([&name, &i.t_s, &s.x, &s.vx, &s.z, &s.vz, &s.theta, &i.rate_radps, &i.thrust_mps2]);
        }
    }
    csv.finish()
}

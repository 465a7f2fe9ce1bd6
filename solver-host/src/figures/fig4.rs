//! Fig. 4: horizontal maneuvers, drawn along their paths.

use mintime_shared::model::Limits;

use super::samples::{Instant, times};
use super::{Content, FigureError, Number, path};
use crate::drawing::axis::Range;
use crate::drawing::csv::Csv;
use crate::drawing::page;
use crate::drawing::style::{AXIS_BELOW, AXIS_LEFT, INK, MARGIN, TEXT_SIZE, WIDTH};
use crate::drawing::svg::{Anchor, Rect, Svg, TextStyle};
use crate::solver::{Extremal, Request, solve};

/// Displacements, m.
const DISPLACEMENTS_M: [f64; 5] = [3.0, 6.0, 9.0, 12.0, 15.0];
/// Between drawings of the vehicle, s: as in the paper.
const VEHICLE_STEP_S: f64 = 0.02;
/// Between samples of the path and rows of the table, s.
const PATH_STEP_S: f64 = 0.005;
/// Space around the paths, m.
const AROUND_M: f64 = 0.4;

pub(super) fn draw() -> Result<Content, FigureError> {
    let solved = DISPLACEMENTS_M.map(|x_m| Ok((x_m, solve(&Request::rest_to_rest(x_m, 0.0))?.extremal)));
    let maneuvers: Vec<(f64, Extremal)> = solved.into_iter().collect::<Result<_, FigureError>>()?;
    let title = "Fig. 4: horizontal maneuvers from 3 m to 15 m".to_owned();
    let lines = [format!(
        "The vehicle every {VEHICLE_STEP_S} s, to scale, with its thrust (blue). From rest at x = 0 to rest at x_{{T}}, without height gained or lost in the end."
    )];
    let mut svg = Svg::default();
    let mut y = page::heading(&mut svg, WIDTH, &title, &lines) + 26.0;
    let width = WIDTH - 2.0 * MARGIN - AXIS_LEFT;
    let per_m = width / (15.0 + 2.0 * AROUND_M);
    let mut csv = Csv::new("x_to_m,t_s,x_m,vx_mps,z_m,vz_mps,theta_rad,rate_radps,thrust_mps2");
    for (i, (x_m, extremal)) in maneuvers.iter().enumerate() {
        let sampled = |step_s: f64| -> Vec<Instant> {
            times(extremal.duration_s(), step_s).into_iter().map(|t| Instant::of(extremal, t)).collect()
        };
        let (fine, vehicles) = (sampled(PATH_STEP_S), sampled(VEHICLE_STEP_S));
        let z = Range::of(fine.iter().map(|i| i.state.z)).unwrap_or(Range { low: 0.0, high: 0.0 });
        let height = (z.span() + 2.0 * AROUND_M) * per_m;
        let rect = Rect { x: MARGIN + AXIS_LEFT, y, width, height };
        let plot = path::plane(rect, (7.5, z.middle()), per_m);
        let last = i + 1 == maneuvers.len();
        path::grid(&mut svg, &plot, (1.0, 0.5), (true, last));
        plot.clipped(&mut svg, &format!("row{i}"), |svg| {
            path::draw(svg, &plot, (&fine, &vehicles), Limits::TABLE_I.thrust_max_mps2, INK);
        });
        plot.frame(&mut svg);
        let text = format!("x_{{T}} = {x_m} m: T = {:.3} s", extremal.duration_s());
        let style = TextStyle::new(TEXT_SIZE, INK).bold().anchored(Anchor::End);
        svg.text((plot.rect.right() - 10.0, plot.rect.bottom() - 9.0), &text, style);
        for s in &fine {
            let (state, rate, thrust) = (s.state, s.rate_radps, s.thrust_mps2);
            csv.row([x_m, &s.t_s, &state.x, &state.vx, &state.z, &state.vz, &state.theta, &rate, &thrust]);
        }
        y += height + 10.0;
    }
    let label = TextStyle::new(TEXT_SIZE, INK);
    let bottom = y - 10.0;
    let middle = MARGIN + AXIS_LEFT + 0.5 * width;
    svg.text((middle, bottom + 40.0), "x (m)", label.anchored(Anchor::Middle));
    svg.text_upwards((MARGIN + 14.0, 0.5 * bottom), "z (m)", label);
    let numbers = maneuvers
        .iter()
        .map(|(x_m, e)| Number::new(format!("x = {x_m} m: T ="), e.duration_s(), "s"))
        .collect();
    Ok(Content {
        svg: page::document(WIDTH, bottom + AXIS_BELOW + MARGIN, &title, &lines[0], svg),
        title,
        tables: vec![("", csv.finish())],
        numbers,
    })
}

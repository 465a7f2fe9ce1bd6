//! Maneuvers drawn along their paths in the vertical plane, both axes to one scale.

use super::samples::Instant;
use crate::drawing::axis::{Range, nice_step, tick_label, ticks};
use crate::drawing::plot::Plot;
use crate::drawing::style::{GRID, INK, SMALL_SIZE, THRUST};
use crate::drawing::svg::{Anchor, Rect, Svg, TextStyle};
use crate::drawing::symbol;

/// A plot of the plane around a point, at so many page units a metre.
pub(crate) fn plane(rect: Rect, (x_m, z_m): (f64, f64), per_m: f64) -> Plot {
    let around = |middle: f64, length: f64| {
        let half = 0.5 * length / per_m;
        Range { low: middle - half, high: middle + half }
    };
    Plot { rect, x: around(x_m, rect.width), y: around(z_m, rect.height) }
}

/// Grid lines, steps apart along x and z, with numbers on the left and below, where asked for.
pub(crate) fn grid(
    svg: &mut Svg,
    plot: &Plot,
    (step_x_m, step_z_m): (f64, f64),
    (left, below): (bool, bool),
) {
    let (rect, small) = (plot.rect, TextStyle::new(SMALL_SIZE, INK));
    let line = format!(r#"stroke="{GRID}""#);
    // Numbers need more room than lines.
    let wide = nice_step(plot.x.span(), (rect.width / 40.0).floor()).max(step_x_m);
    for value in ticks(plot.x, step_x_m) {
        svg.line((plot.x(value), rect.y), (plot.x(value), rect.bottom()), &line);
    }
    for value in ticks(plot.x, wide).into_iter().filter(|_| below) {
        let at = (plot.x(value), rect.bottom() + 18.0);
        svg.text(at, &tick_label(value, wide), small.anchored(Anchor::Middle));
    }
    for value in ticks(plot.y, step_z_m) {
        let y = plot.y(value);
        svg.line((rect.x, y), (rect.right(), y), &line);
        if left {
            svg.text((rect.x - 8.0, y + 5.0), &tick_label(value, step_z_m), small.anchored(Anchor::End));
        }
    }
}

/// A path with the vehicle, to scale, at some of its instants. Thrusts are parts of `thrust_max_mps2`.
pub(crate) fn draw(
    svg: &mut Svg,
    plot: &Plot,
    (path, vehicles): (&[Instant], &[Instant]),
    thrust_max_mps2: f64,
    colour: &str,
) {
    let span = symbol::SPAN_M * plot.rect.width / plot.x.span();
    let points = plot.points(path.iter().map(|i| (i.state.x, i.state.z)));
    svg.open_group(r#"class="vehicles" fill="none" stroke-linecap="round" stroke-opacity=".8""#);
    for i in vehicles {
        let at = plot.point((i.state.x, i.state.z));
        let attitude = (i.state.theta, i.thrust_mps2 / thrust_max_mps2);
        symbol::draw_fine(svg, at, attitude, span, [colour, THRUST]);
    }
    svg.close_group();
    svg.curve(&points, r##"stroke="#ffffff" stroke-width="4" stroke-opacity=".8""##);
    svg.curve(&points, &format!(r#"class="path" stroke="{colour}" stroke-width="2""#));
}

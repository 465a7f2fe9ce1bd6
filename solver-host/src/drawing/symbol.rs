//! The vehicle seen from the side: a bar with two rotors, and a line along the thrust, as long as the thrust is large.

use std::fmt::Write as _;

use super::svg::{Point, Svg, px};

/// Rotor tip to rotor tip of the vehicle the limits of the paper's Table I belong to, m.
pub(crate) const SPAN_M: f64 = 0.5;

/// The definition the drawings refer to: span 1, hub at the origin, upright. Colour comes from outside.
pub(crate) const DEFINITION: &str = concat!(
    r##"<g id="vehicle" fill="none" stroke-linecap="round"><path d="M-.36 0H.36" stroke-width=".075"/>"##,
    r##"<path d="M-.36 0V-.1M.36 0V-.1" stroke-width=".04"/>"##,
    r##"<path d="M-.54-.115H-.18M.18-.115H.54" stroke-width=".045"/></g>"##,
);

/// Draws the vehicle, `span` units wide, with a part of its greatest thrust. Colour and opacity are those of the group it
/// is drawn in.
pub(crate) fn draw(svg: &mut Svg, at: Point, theta_rad: f64, span: f64, thrust: f64) {
    // θ turns the thrust axis from up towards +x: clockwise on the page, as SVG counts.
    svg.raw(&format!(
        r##"<g transform="translate({} {}) rotate({}) scale({})"><use href="#vehicle"/><path d="M0 0V{}" stroke-width=".03"/></g>"##,
        px(at.0),
        px(at.1),
        px(theta_rad.to_degrees() % 360.0),
        px(span),
        px(-0.62 * thrust),
    ));
}

/// The lines of the vehicle at span 1, hub at the origin, upright: bar, masts, rotors.
const LINES: [[Point; 2]; 5] = [
    [(-0.36, 0.0), (0.36, 0.0)],
    [(-0.36, 0.0), (-0.36, -0.1)],
    [(0.36, 0.0), (0.36, -0.1)],
    [(-0.54, -0.115), (-0.18, -0.115)],
    [(0.18, -0.115), (0.54, -0.115)],
];

/// Draws the vehicle in hair lines, however large, for pictures with many of them: body in one colour, thrust in another.
pub(crate) fn draw_fine(
    svg: &mut Svg,
    at: Point,
    (theta_rad, thrust): (f64, f64),
    span: f64,
    [body, force]: [&str; 2],
) {
    let (sin, cos) = theta_rad.sin_cos();
    let turned = |(x, y): Point| (at.0 + span * (x * cos - y * sin), at.1 + span * (x * sin + y * cos));
    let path = |lines: &[[Point; 2]]| {
        lines.iter().fold(String::new(), |mut path, line| {
            let [from, to] = line.map(turned);
            // Writing to a string does not fail.
            let _ = write!(path, "M{} {}L{} {}", px(from.0), px(from.1), px(to.0), px(to.1));
            path
        })
    };
    let arrow = [[(0.0, 0.0), (0.0, -0.62 * thrust)]];
    svg.raw(&format!(r#"<path d="{}" stroke="{force}" stroke-width="0.9"/>"#, path(&arrow)));
    svg.raw(&format!(r#"<path class="vehicle" d="{}" stroke="{body}" stroke-width="1.1"/>"#, path(&LINES)));
}

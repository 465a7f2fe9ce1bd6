//! The pictures parse, hold what they should, and their contours lie where arithmetic says.

use crate::benchmark::{Cell, Gains, Grid, Rules, ScoreMap, score_linear};

use super::map::contour;
use super::{render_map, render_score};
use crate::drawing::png;

/// A map whose score is a plane over the displacements, with one hole.
fn plane() -> ScoreMap {
    let grid = Grid::even([0.0, 4.0], [-1.0, 2.0], [9, 7]);
    let score = |x: f64, z: f64| 1.0 + 0.25 * x + 0.1 * z;
    let mut cells: Vec<Cell> = grid
        .z_m
        .iter()
        .flat_map(|z| grid.x_m.iter().map(move |x| score(*x, *z)))
        .map(|score| Cell::Scored { duration_s: score, optimal_s: 1.0, score })
        .collect();
    cells[0] = Cell::Failed("it <never> arrives".to_owned());
    ScoreMap { grid, cells }
}

#[test]
fn contours_of_a_plane_are_where_they_should_be() {
    let map = plane();
    let pieces = contour(&map, 1.5);
    assert!(pieces.len() > 6);
    for (x, z) in pieces.iter().flat_map(|(a, b)| [a, b]) {
        assert!((1.0 + 0.25 * x + 0.1 * z - 1.5).abs() < 1e-12, "{x} {z}");
    }
    // From the lowest z to the highest: x falls by 0.4 m for each metre.
    let length: f64 = pieces.iter().map(|(a, b)| (a.0 - b.0).hypot(a.1 - b.1)).sum();
    assert!((length - 3.0 * 1f64.hypot(0.4)).abs() < 1e-9, "{length}");
    assert!(contour(&map, 9.0).is_empty());
}

#[test]
fn both_pictures_are_sound() {
    let score = score_linear(&Gains::default(), &Rules::default(), 4.0, 1.0).expect("a score");
    let of_score = render_score(&score, "a < b & c", &["line".to_owned()]);
    let of_map = render_map(&plane(), "map", &[]);
    for (svg, parts) in [
        (&of_score, vec!["a &lt; b &amp; c", ">T*<", ">T<", "time from departure (s)", "flown"]),
        (&of_map, vec!["displacement x (m)", "T / T*"]),
    ] {
        png::parse(svg).expect("it parses");
        assert!(parts.iter().all(|part| svg.contains(part)), "{parts:?}");
        assert!(!svg.contains("NaN") && !svg.contains("inf"));
    }
    assert_eq!(of_score, render_score(&score, "a < b & c", &["line".to_owned()]));
}

/// Nothing to draw is drawn as nothing.
#[test]
fn maps_of_nothing_parse() {
    for points in [[1, 1], [0, 0], [1, 5]] {
        let grid = Grid::even([0.0, 0.0], [0.0, 1.0], points);
        let cells = vec![Cell::Here; grid.len()];
        png::parse(&render_map(&ScoreMap { grid, cells }, "t", &[])).expect("it parses");
    }
}

//! T(x, z) from rest to rest over a quadrant, with lines of equal T and the lines where the structure of the fastest
//! maneuver changes. T(x, z) = T(|x|, |z|) by mirror image and by flying backwards, so one quadrant says everything.

mod badge;
mod contour;
mod grid;
mod outline;
mod picture;

use grid::Grid;

use super::samples::switch_times;
use super::{Content, FigureError, Number};
use crate::drawing::csv::Csv;
use outline::{Division, divide};

/// The whole quadrant, m, and its intervals.
const WHOLE: ((f64, f64), (usize, usize)) = ((15.0, 10.0), (150, 100));
/// The part near the origin, where most structures are, m, and its intervals.
const DETAIL: ((f64, f64), (usize, usize)) = ((3.0, 3.2), (100, 107));

/// A grid and what it is divided into.
struct Chart {
    grid: Grid,
    division: Division,
}

impl Chart {
    fn new((end, intervals): ((f64, f64), (usize, usize))) -> Result<Self, FigureError> {
        let grid = Grid::new(end, intervals)?;
        let division = divide(&grid);
        Ok(Self { grid, division })
    }
}

pub(super) fn draw() -> Result<Content, FigureError> {
    let charts = [Chart::new(WHOLE)?, Chart::new(DETAIL)?];
    let (title, svg, structures) = picture::draw(&charts);
    let count = |chart: &Chart| chart.division.borders.iter().map(|b| b.2.len()).sum::<usize>() as f64;
    let numbers = vec![
        Number::new("grid points", charts.iter().map(|c| c.grid.nodes.len() as f64).sum(), ""),
        Number::new("structures with a number on the map", structures as f64, ""),
        Number::new("points on lines where the structure changes", charts.iter().map(count).sum(), ""),
    ];
    Ok(Content { title, svg, tables: vec![("", points(&charts)), ("-borders", borders(&charts))], numbers })
}

/// All grid points.
fn points(charts: &[Chart; 2]) -> String {
    let mut csv = Csv::new("x_m,z_m,duration_s,turns,structure,switch_times_s");
    for Chart { grid, .. } in charts {
        for (i, node) in grid.nodes.iter().enumerate() {
            let (x, z) = grid.place(i);
            let e = &node.extremal;
            csv.row([&x, &z, &e.duration_s(), &e.turns, &e.structure(), &switch_times(e)]);
        }
    }
    csv.finish()
}

/// The lines where the structure changes, point by point. Lines are numbered; a point stands on its line to
/// [`grid::TOLERANCE_M`] where one of its coordinates is one of the grid, and joins lines elsewhere.
fn borders(charts: &[Chart; 2]) -> String {
    let mut csv =
        Csv::new("line,x_m,z_m,turns_on_one_side,structure_on_one_side,turns_on_other,structure_on_other");
    let mut line = 0;
    for Chart { grid, division } in charts {
        for (a, b, points) in &division.borders {
            line += 1;
            let (a, b) = (&grid.structures[*a], &grid.structures[*b]);
            for (x, z) in points {
                csv.row([&line, x, z, &a.turns, a, &b.turns, b]);
            }
        }
    }
    csv.finish()
}

//! The linear controller's score over a grid of displacements.

use std::fmt::Write as _;

use super::error::BenchmarkError;
use super::linear::{Gains, durations_linear};
use super::score::Rules;
use crate::parallel;

/// Displacements from rest to rest: the points of a grid, in rows of equal z from low to high.
#[derive(Clone, Debug, PartialEq)]
pub struct Grid {
    /// Displacements along x, m, in order.
    pub x_m: Vec<f64>,
    /// Displacements along z, m, in order.
    pub z_m: Vec<f64>,
}

impl Grid {
    /// Evenly spaced points from `first` to `last` on each axis, ends included.
    pub fn even(x_m: [f64; 2], z_m: [f64; 2], points: [usize; 2]) -> Self {
        let axis = |[first, last]: [f64; 2], count: usize| {
            let step = if count > 1 { (last - first) / (count - 1) as f64 } else { 0.0 };
            (0..count).map(|i| first + step * i as f64).collect()
        };
        Self { x_m: axis(x_m, points[0]), z_m: axis(z_m, points[1]) }
    }

    /// Number of points.
    pub fn len(&self) -> usize {
        self.x_m.len() * self.z_m.len()
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    fn point(&self, index: usize) -> (f64, f64) {
        (self.x_m[index % self.x_m.len()], self.z_m[index / self.x_m.len()])
    }
}

/// One point of a map.
#[derive(Clone, Debug)]
pub enum Cell {
    /// Measured.
    Scored {
        /// T_controller, s.
        duration_s: f64,
        /// T* between the states at departure and arrival, s.
        optimal_s: f64,
        /// The one over the other.
        score: f64,
    },
    /// Within two tolerances of the origin: there is no maneuver to measure.
    Here,
    /// Why there is no score.
    Failed(String),
}

/// Scores over a grid.
#[derive(Clone, Debug)]
pub struct ScoreMap {
    /// The displacements.
    pub grid: Grid,
    /// A cell for each, row by row.
    pub cells: Vec<Cell>,
}

/// Flies the controller to every point of a grid, on all cores. `progress` hears how many points have been done since it
/// heard last.
///
/// # Errors
/// Gains and rules that are wrong for all points: [`Gains::validate`], [`Rules::validate`].
pub fn map_linear(
    gains: &Gains,
    rules: &Rules,
    grid: Grid,
    progress: impl Fn(usize) + Sync,
) -> Result<ScoreMap, BenchmarkError> {
    gains.validate()?;
    rules.validate()?;
    let points: Vec<(f64, f64)> = (0..grid.len()).map(|index| grid.point(index)).collect();
    let cells = parallel::map(&points, |(x_m, z_m)| cell(gains, rules, *x_m, *z_m), progress);
    Ok(ScoreMap { cells, grid })
}

fn cell(gains: &Gains, rules: &Rules, x_m: f64, z_m: f64) -> Cell {
    if x_m.hypot(z_m) <= 2.0 * rules.tolerance.position_m {
        return Cell::Here;
    }
    match durations_linear(gains, rules, x_m, z_m) {
        Ok((duration_s, optimal_s)) => Cell::Scored { duration_s, optimal_s, score: duration_s / optimal_s },
        Err(error) => Cell::Failed(error.to_string()),
    }
}

impl ScoreMap {
    /// The displacements (x, z), m, in the order of the cells.
    pub fn points(&self) -> impl Iterator<Item = (f64, f64)> {
        (0..self.cells.len()).map(|index| self.grid.point(index))
    }

    /// The displacement and score of every point that has one.
    pub fn scores(&self) -> impl Iterator<Item = (f64, f64, f64)> {
        self.points().zip(&self.cells).filter_map(|((x_m, z_m), cell)| match cell {
            Cell::Scored { score, .. } => Some((x_m, z_m, *score)),
            Cell::Here | Cell::Failed(_) => None,
        })
    }

    /// How many points failed.
    pub fn failed(&self) -> usize {
        self.cells.iter().filter(|c| matches!(c, Cell::Failed(_))).count()
    }

    /// The map as CSV. Columns: displacement, T_controller, T*, score; a reason where there is none.
    pub fn csv(&self) -> String {
        let mut out = String::from("x_m,z_m,controller_s,optimal_s,score,remark\n");
        for ((x, z), cell) in self.points().zip(&self.cells) {
            // Writing to a string does not fail.
            let _ = match cell {
                Cell::Scored { duration_s, optimal_s, score } => {
                    writeln!(out, "{x},{z},{duration_s},{optimal_s},{score},")
                }
                Cell::Here => writeln!(out, "{x},{z},0,0,,"),
                Cell::Failed(reason) => writeln!(out, "{x},{z},,,,\"{}\"", reason.replace('"', "'")),
            };
        }
        out
    }
}

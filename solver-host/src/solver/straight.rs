//! Maneuvers that are one straight push: full thrust at a constant angle all the way.
//!
//! They are a single singular arc with c1 = c3 = 0, so nothing is left of the square system: the costate is not unique and
//! p0 = 0 is a multiplier too. But no search is needed. Even with an unlimited body rate nothing is faster, and whether two
//! states are joined this way is seen at once. T jumps there: a little more speed at the end needs another maneuver.

use super::problem::Problem;
use super::structure::{Candidate, Piece};

/// How far, relative, the end may be from the push's own: rounding of the data. The check that follows is sharper.
const ROUNDING: f64 = 1e-9;

/// The straight push that solves a problem, if there is one.
pub(crate) fn straight(problem: &Problem) -> Option<Candidate> {
    let [x0, vx0, z0, vz0, theta0] = problem.from;
    let [x1, vx1, z1, vz1, theta1] = problem.to;
    if theta0 != theta1 {
        return None;
    }
    let (s, c) = libm::sincos(theta0);
    let (ax, az) = (problem.u_max * s, problem.u_max * c - 1.0);
    let t = ((vx1 - vx0) * ax + (vz1 - vz0) * az) / (ax * ax + az * az);
    let misses = |end: f64, reached: f64, size: f64| (end - reached).abs() > ROUNDING * size;
    let (reach, speed) = (problem.u_max * t * t, problem.u_max * t);
    let arrives = t > 0.0
        && !misses(vx1, vx0 + ax * t, speed)
        && !misses(vz1, vz0 + az * t, speed)
        && !misses(x1, x0 + (vx0 + 0.5 * ax * t) * t, reach)
        && !misses(z1, z0 + (vz0 + 0.5 * az * t) * t, reach);
    if !arrives {
        return None;
    }
    // Thrust against p, and H = 0: 1 − λ (u_max − cos θ) = 0. Above gravity's share since u_max > 1.
    let lambda = 1.0 / (problem.u_max - c);
    let mut pieces = heapless::Vec::new();
    // One piece always fits.
    let _ = pieces.push(Piece::arc(t));
    Some(Candidate { pieces, c: [0.0, -lambda * s, 0.0, -lambda * c] })
}

//! Tiny problems: a milliradian of tilt, a millimetre a second.
//!
//! Near hover and for short times the dynamics are homogeneous: with T of order ε the vehicle turns by ε, and ẋ changes by
//! ε², x by ε³, ż by ε, z by ε². So a problem can be enlarged until it is of ordinary size, solved there, and its
//! maneuver shrunk again step by step with hardly a change of shape. Solving it as it stands would mean to follow the rate
//! limit over many orders of magnitude.

use core::f64::consts::TAU;

use super::problem::Problem;

/// Size (dimensionless, of order T) up to which a problem is tiny.
const TINY: f64 = 0.5;
/// Size that it is enlarged to.
const ORDINARY: f64 = 1.5;
/// Ratio of sizes from one step to the next on the way back.
const SHRINK: f64 = 0.6;
/// T over the size beyond which a tiny problem's answer is doubted; those solved lie between two and four.
const LARGEST_RATIO: f64 = 6.0;
/// Steps at most: from one to 1e-9.
const STEPS: usize = 45;

/// The enlarged versions of a tiny problem of winding 0, largest first, the problem itself last. Empty where it is not tiny.
pub(crate) fn enlarged(problem: &Problem) -> heapless::Vec<Problem, STEPS> {
    let mut list = heapless::Vec::new();
    let size = size(problem);
    if size.is_nan() || size <= 0.0 || size > TINY {
        return list;
    }
    let mut factor = ORDINARY / size;
    while factor > 1.0 && !list.is_full() {
        // Room was just asked for.
        let _ = list.push(dilated(problem, factor));
        factor *= SHRINK;
    }
    if let Some(last) = list.last_mut() {
        *last = *problem;
    }
    list
}

/// Whether T is so long that a tiny problem must have a faster maneuver.
pub(crate) fn doubtful(problem: &Problem, duration: f64) -> bool {
    let size = size(problem);
    size > 0.0 && size <= TINY && duration > LARGEST_RATIO * size
}

/// Whole turns nearest to an angle.
fn upright(angle: f64) -> f64 {
    libm::round(angle / TAU) * TAU
}

/// The order of T.
fn size(problem: &Problem) -> f64 {
    let (f, g) = (&problem.from, &problem.to);
    let (x, z) = ((g[0] - f[0]).abs(), (g[2] - f[2]).abs());
    let mut size = libm::cbrt(x).max(libm::sqrt(z)).max((g[4] - f[4]).abs());
    for state in [f, g] {
        let tilt = (state[4] - upright(f[4])).abs();
        size = size.max(libm::sqrt(state[1].abs())).max(state[3].abs()).max(tilt);
    }
    size
}

/// Everything enlarged by the powers of `factor` that it scales with.
fn dilated(problem: &Problem, factor: f64) -> Problem {
    let base = upright(problem.from[4]);
    let square = factor * factor;
    let mut p = *problem;
    for state in [&mut p.from, &mut p.to] {
        state[0] *= square * factor;
        state[1] *= square;
        state[2] *= square;
        state[3] *= factor;
        state[4] = base + factor * (state[4] - base);
    }
    p
}

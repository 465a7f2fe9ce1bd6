//! The windings that did not win: [`solve`] gives them up as soon as they cannot, this solves each to its end.

use core::cmp::Ordering;
use core::f64::consts::{PI, TAU};

use super::request::{Alternative, Request, Solution, SolveError, Turns};
use super::search::Effort;
use super::{solve, solve_cancellable, solve_core};
use core::sync::atomic::{AtomicBool, Ordering as Memory};

/// Windings further than this from the start's angle are not looked at, rad.
const FURTHEST_RAD: f64 = 4.0 * PI;

/// [`solve`] with the best maneuver of every winding k that could have won among the alternatives: all k with
/// |θ_T + 2πk − θ_0| ≤ 4π and |θ_T + 2πk − θ_0|/ω_max below the best T. A request for one winding has none.
///
/// A winding that has lost is not insisted on: one for which no maneuver is found at the first attempt is left out.
///
/// # Errors
/// Those of [`solve`].
pub fn solve_all_windings(request: &Request) -> Result<Solution, SolveError> {
    solve_all_windings_cancellable(request, &AtomicBool::new(false))
}

/// [`solve_all_windings`] that gives up soon after `cancel` becomes true.
///
/// # Errors
/// Those of [`solve_cancellable`].
pub fn solve_all_windings_cancellable(
    request: &Request,
    cancel: &AtomicBool,
) -> Result<Solution, SolveError> {
    let mut solution = solve_cancellable(request, cancel)?;
    if request.turns != Turns::Any {
        return Ok(solution);
    }
    let best_s = solution.extremal.duration_s();
    let turn = request.to.theta - request.from.theta;
    // Angles are any finite numbers: whole turns beyond the reach of an i32 are cut off by the range below.
    let nearest = libm::round(-turn / TAU);
    for offset in [-2.0, -1.0, 0.0, 1.0, 2.0] {
        let k = nearest + offset;
        let angle = (turn + k * TAU).abs();
        let known = |turns: i32| {
            turns == solution.extremal.turns || solution.alternatives.iter().any(|a| a.turns == turns)
        };
        let in_range =
            angle <= FURTHEST_RAD * (1.0 + f64::EPSILON) && k.abs() <= f64::from(super::MOST_TURNS);
        if !in_range || angle / request.limits.rate_max_radps >= best_s || known(k as i32) {
            continue;
        }
        let wound = Request { turns: Turns::Exactly(k as i32), ..*request };
        match solve_core(&wound, Effort::LIGHT, &|| cancel.load(Memory::Relaxed)) {
            Ok(other) => {
                let duration_s = other.extremal.duration_s();
                // At most five windings, and room for twelve.
                let _ = solution.alternatives.push(Alternative { turns: k as i32, duration_s });
                solution.evaluations = solution.evaluations.saturating_add(other.evaluations);
            }
            Err(error @ SolveError::Cancelled { .. }) => return Err(error),
            Err(_) => {}
        }
    }
    let by_duration =
        |a: &Alternative, b: &Alternative| a.duration_s.partial_cmp(&b.duration_s).unwrap_or(Ordering::Equal);
    solution.alternatives.sort_unstable_by(by_duration);
    // A winding's own search may do better than what was found on the way.
    match solution.alternatives.first() {
        Some(first) if first.duration_s < best_s * (1.0 - super::search::TIE) => {
            solve(&Request { turns: Turns::Exactly(first.turns), ..*request })
        }
        _ => Ok(solution),
    }
}

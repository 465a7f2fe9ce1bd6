//! The windings that did not win: [`solve`](super::solve) gives them up as soon as they cannot, this solves each to its
//! end.

use core::f64::consts::{PI, TAU};
use core::mem::replace;
use core::sync::atomic::{AtomicBool, Ordering};

use super::request::{Alternative, Request, Solution, SolveError, Turns};
use super::search::TIE;
use super::solve_cancellable;

/// Windings further than this from the start's angle are not looked at, rad.
const FURTHEST_RAD: f64 = 4.0 * PI;

/// [`solve`](super::solve) with the best maneuver of every winding k that could have won among the alternatives: all k with
/// |θ_T + 2πk − θ_0| ≤ 4π and |θ_T + 2πk − θ_0|/ω_max below the best T. A request for one winding has none.
///
/// Each is solved as if it had been asked for. One that turns out faster becomes the answer; one for which no verified
/// maneuver is found is listed as unsolved.
///
/// # Errors
/// Those of [`solve`](super::solve).
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
    let first = solve_cancellable(request, cancel);
    if request.turns != Turns::Any {
        return first;
    }
    let (mut solution, failure) = match first {
        Ok(solution) => (Some(solution), None),
        Err(error @ SolveError::NotVerified { .. }) => (None, Some(error)),
        Err(error) => return Err(error),
    };
    let mut unsolved = heapless::Vec::new();
    let turn = request.to.theta - request.from.theta;
    let nearest = request.nearest_turns();
    for k in nearest - 2..=nearest + 2 {
        let angle = (turn + f64::from(k) * TAU).abs();
        let best_s = solution.as_ref().map_or(f64::INFINITY, |s| s.extremal.duration_s());
        // A winding already known is solved again: on the way to the fastest it was not looked at closely.
        if angle > FURTHEST_RAD * (1.0 + f64::EPSILON) || angle / request.limits.rate_max_radps >= best_s {
            continue;
        }
        match solve_cancellable(&Request { turns: Turns::Exactly(k), ..*request }, cancel) {
            Ok(other) => solution = Some(solution.map_or(other.clone(), |known| merged(known, other))),
            Err(SolveError::NotVerified { evaluations, .. }) => {
                if let Some(known) = &mut solution {
                    known.evaluations = known.evaluations.saturating_add(evaluations);
                }
                // At most five windings, and room for twelve.
                let _ = unsolved.push(k);
            }
            Err(error) => return Err(error),
        }
    }
    if cancel.load(Ordering::Relaxed) {
        return Err(SolveError::Cancelled { evaluations: solution.map_or(0, |s| s.evaluations) });
    }
    match (solution, failure) {
        (Some(mut solution), _) => {
            // Found on the way to another, or too slow by now, though not when asked for.
            let best_s = solution.extremal.duration_s();
            let bound_s = |k: i32| (turn + f64::from(k) * TAU).abs() / request.limits.rate_max_radps;
            unsolved.retain(|&k| solution.duration_of(k).is_none() && bound_s(k) < best_s);
            solution.unsolved = unsolved;
            solution.alternatives.sort_unstable_by(|a, b| a.duration_s.total_cmp(&b.duration_s));
            Ok(solution)
        }
        (None, Some(error)) => Err(error),
        // Without a failure there was a solution.
        (None, None) => Err(SolveError::Cancelled { evaluations: 0 }),
    }
}

/// What is known with one winding's own solution added.
fn merged(mut known: Solution, mut other: Solution) -> Solution {
    let evaluations = known.evaluations.saturating_add(other.evaluations);
    let (turns, duration_s) = (other.extremal.turns, other.extremal.duration_s());
    if duration_s < known.extremal.duration_s() * (1.0 - TIE) {
        // The answer so far becomes an alternative.
        core::mem::swap(&mut known, &mut other);
        known.alternatives = replace(&mut other.alternatives, heapless::Vec::new());
        known.alternatives.retain(|a| a.turns != turns);
        if other.extremal.turns != turns {
            let former = Alternative { turns: other.extremal.turns, duration_s: other.extremal.duration_s() };
            // Room for twelve, and nine windings at most.
            let _ = known.alternatives.push(former);
        }
    } else if turns != known.extremal.turns {
        match known.alternatives.iter_mut().find(|a| a.turns == turns) {
            Some(same) => same.duration_s = same.duration_s.min(duration_s),
            None => {
                let _ = known.alternatives.push(Alternative { turns, duration_s });
            }
        }
    }
    known.evaluations = evaluations;
    known
}

impl Solution {
    /// T of the best maneuver known with a winding, s.
    fn duration_of(&self, turns: i32) -> Option<f64> {
        if turns == self.extremal.turns {
            return Some(self.extremal.duration_s());
        }
        self.alternatives.iter().find(|a| a.turns == turns).map(|a| a.duration_s)
    }
}

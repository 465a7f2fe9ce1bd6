//! Minimum-time maneuvers from any state to any state, verified against Pontryagin's minimum principle.
//!
//! # How it works
//!
//! With an unlimited body rate the problem is easy (`relax`). From there a continuation in the rate limit (`path`)
//! follows each promising start (`starts`) to the real limit: Newton steps on a small square system in the lengths of
//! the bang and singular arcs and the costate constants (`linearise`, `newton`), with the structure changed wherever a
//! law of the minimum principle would break (`events`). What arrives is checked by an integrator of its own
//! ([`verify()`]) before it is returned.
//!
//! Everything but [`solve`]'s clock needs no allocation and nothing beyond `core` and `libm`.
//!
//! ```
//! use mintime::solver::{Request, solve};
//!
//! let answer = solve(&Request::rest_to_rest(5.0, 5.0))?;
//! assert!(answer.certificate.verified);
//! assert!((answer.extremal.duration_s() - 1.4112200503).abs() < 1e-9);
//! # Ok::<(), mintime::solver::SolveError>(())
//! ```

mod conditions;
mod dense;
mod detour;
mod dual;
mod events;
mod extremal;
mod linearise;
mod neighbour;
mod newton;
pub mod paper;
mod path;
mod polyhedron;
mod problem;
mod relax;
mod request;
mod rigid;
mod rotation;
mod scan;
mod search;
mod sensitivity;
mod starts;
mod straight;
mod structure;
pub mod sweep;
mod tiny;
mod verify;
mod windings;

use core::sync::atomic::{AtomicBool, Ordering};

#[cfg(feature = "std")]
pub(crate) use dual::Dual;
pub use extremal::Extremal;
pub use request::{
    ANGLE_MAX_RAD, Alternative, LONGEST_RAD, MAX_ALTERNATIVES, MOST_TURNS, Request, Solution, SolveError,
    Turns,
};
pub use sensitivity::Sensitivities;
pub use structure::MAX_SEGMENTS;
pub use verify::{Certificate, FINAL_STATE_TOLERANCE, LAW_TOLERANCE, RATE_TOLERANCE, Tolerances, verify};
pub use windings::{solve_all_windings, solve_all_windings_cancellable};

use newton::Newton;
use problem::Problem;
use search::{Effort, Search};
use structure::Candidate;
use verify::verify_cancellable;

/// The minimum-time maneuver for a request.
///
/// The answer is verified: see [`Certificate`]. It is deterministic, allocates nothing, prints nothing, and takes about
/// a tenth of a millisecond for most requests.
///
/// # Errors
/// The input errors of [`Request::validate`], [`SolveError::TooLong`], and [`SolveError::NotVerified`] where no maneuver passed the check.
pub fn solve(request: &Request) -> Result<Solution, SolveError> {
    solve_cancellable(request, &AtomicBool::new(false))
}

/// [`solve`] that gives up soon after `cancel` becomes true (within a millisecond).
///
/// # Errors
/// Those of [`solve`], and [`SolveError::Cancelled`].
pub fn solve_cancellable(request: &Request, cancel: &AtomicBool) -> Result<Solution, SolveError> {
    timed(|| solve_core(request, Effort::NORMAL, &|| cancel.load(Ordering::Relaxed)))
}

/// Adds the wall time to an error that tells it.
#[cfg(feature = "std")]
fn timed(work: impl FnOnce() -> Result<Solution, SolveError>) -> Result<Solution, SolveError> {
    let clock = std::time::Instant::now();
    work().map_err(|error| match error {
        SolveError::NotVerified { feasible_s, lower_bound_s, evaluations, .. } => SolveError::NotVerified {
            feasible_s,
            lower_bound_s,
            evaluations,
            elapsed_s: clock.elapsed().as_secs_f64(),
        },
        other => other,
    })
}

/// There is no clock here.
#[cfg(not(feature = "std"))]
fn timed(work: impl FnOnce() -> Result<Solution, SolveError>) -> Result<Solution, SolveError> {
    work()
}

/// The maneuver for a request near one that is already solved, of the same winding and on the same branch: some ten to
/// twenty microseconds for a close neighbour. It does not look whether another winding has become faster; where it does
/// not arrive, or the request asks for another winding, it solves from cold.
///
/// # Errors
/// Those of [`solve`].
pub fn solve_from(neighbour: &Extremal, request: &Request) -> Result<Solution, SolveError> {
    request.validate()?;
    if let Some(turns) = neighbour::common_turns(neighbour, request) {
        let mut newton = Newton::new();
        let target = Problem::new(request.from, request.to, &request.limits, turns);
        if let Some(candidate) = neighbour::carry(&mut newton, neighbour, &target, &|| false) {
            let extremal = Extremal::new(request.from, request.to, &request.limits, turns, &candidate);
            let certificate = verify(&extremal);
            if certificate.verified {
                let alternatives = heapless::Vec::new();
                let evaluations = newton.evaluations;
                let unsolved = heapless::Vec::new();
                return Ok(Solution { extremal, certificate, alternatives, unsolved, evaluations });
            }
        }
    }
    solve(request)
}

/// [`solve`] that also runs every start, forwards and backwards in time, and looks in from displaced problems: some
/// thirty times slower, for the rare request whose fastest maneuver hides from [`solve`].
///
/// # Errors
/// Those of [`solve_cancellable`].
pub fn solve_thoroughly(request: &Request, cancel: &AtomicBool) -> Result<Solution, SolveError> {
    timed(|| solve_core(request, Effort::THOROUGH, &|| cancel.load(Ordering::Relaxed)))
}

/// [`solve`] without a clock.
fn solve_core(
    request: &Request,
    effort: Effort,
    cancelled: &dyn Fn() -> bool,
) -> Result<Solution, SolveError> {
    request.validate()?;
    let (reduced, shift) = request.reduced();
    let fixed = match reduced.turns {
        Turns::Any => None,
        Turns::Exactly(k) => Some(k),
    };
    let rate = request.limits.rate_max_radps;
    let problem = Problem::new(reduced.from, reduced.to, &request.limits, 0);
    let verified = |candidate: &Candidate, turns: i32| {
        let extremal = Extremal::new(reduced.from, reduced.to, &request.limits, turns, candidate);
        verify_cancellable(&extremal, cancelled).is_some_and(|c| c.verified)
    };
    let mut search = Search::new(problem, fixed, effort, &verified, cancelled);
    let relaxed = search.lower_bound();
    if relaxed.is_nan() || relaxed > LONGEST_RAD {
        let lower_bound_s = if relaxed.is_nan() { f64::INFINITY } else { relaxed / rate };
        return Err(SolveError::TooLong { lower_bound_s });
    }
    let finished = search.run();
    let evaluations = search.newton.evaluations;
    if !finished || cancelled() {
        return Err(SolveError::Cancelled { evaluations });
    }
    if let Some((best, others)) = search.found.split_first() {
        let turns = best.turns + shift;
        let extremal = Extremal::new(request.from, request.to, &request.limits, turns, &best.candidate);
        let certificate = verify(&extremal);
        let alternatives = others
            .iter()
            .take(MAX_ALTERNATIVES)
            .map(|f| Alternative { turns: f.turns + shift, duration_s: f.duration / rate })
            .collect();
        // Everything kept has passed; a mirror image of it passes too.
        if certificate.verified {
            let unsolved = heapless::Vec::new();
            return Ok(Solution { extremal, certificate, alternatives, unsolved, evaluations });
        }
    }
    let turning =
        fixed.map_or(0.0, |k| Problem::new(reduced.from, reduced.to, &request.limits, k).turn().abs());
    Err(SolveError::NotVerified {
        feasible_s: search.refused.is_finite().then_some(search.refused / rate),
        lower_bound_s: relaxed.max(turning) / rate,
        evaluations,
        elapsed_s: 0.0,
    })
}

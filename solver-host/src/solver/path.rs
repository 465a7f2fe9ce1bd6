//! Continuation along a family of problems, with structure changes on the way: from the infinite-rate limit to the real
//! rate limit, or from one set of data to another.

use super::events::{Repair, drop_piece, repair};
use super::newton::Newton;
use super::problem::{Direction, Problem};
use super::structure::{Candidate, MAX_SEGMENTS, MAX_UNKNOWNS, Piece};

/// Structure changes within one step.
const MOST_EVENTS: u32 = 10;
/// T may miss its tangent prediction by this much of itself before a step is rejected.
const MISS: f64 = 0.04;
/// Growth of the step after an easy step and after a fair one.
const GROW_EASY: f64 = 2.5;
const GROW_FAIR: f64 = 1.5;
/// Newton iterations up to which a step counts as easy, and as fair.
const EASY: u32 = 4;
const FAIR: u32 = 8;
/// Failures in a row after which short pieces are deleted on trial.
const DELETE_AFTER: u32 = 3;
/// What counts as short, rad or 1/ω_max.
const SHORT: f64 = 0.15;
/// Step factor after a failure.
const SHRINK: f64 = 0.4;
/// A step this small relative to the whole way means that the path ends here.
const SMALLEST_STEP: f64 = 1e-5;

/// Why a path ended early.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Dead {
    /// The first solve failed.
    NotBegun,
    /// Newton or the repairs failed at every step length. T that it was heading for, cautiously.
    Stuck { heading_for: f64 },
    /// The evaluation budget is used up.
    Budget { heading_for: f64 },
    /// Its T exceeded that of a maneuver already found.
    Slower,
    /// The caller cancelled.
    Cancelled,
}

/// A family of problems: `base` + λ·`direction`, at the inverse rate limit `mu` + λ·`direction.mu`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Family {
    pub(crate) base: Problem,
    pub(crate) mu: f64,
    pub(crate) direction: Direction,
}

impl Family {
    /// λ is μ itself.
    pub(crate) fn rate_limit(problem: &Problem) -> Self {
        Self { base: *problem, mu: 0.0, direction: Direction::MU }
    }

    fn at(&self, lambda: f64) -> (Problem, f64) {
        (self.direction.apply(&self.base, lambda), self.mu + lambda * self.direction.mu)
    }
}

/// What bounds a path.
pub(crate) struct Bounds<'a> {
    /// Evaluations it may take.
    pub(crate) budget: u32,
    /// Dimensionless T at which it is abandoned.
    pub(crate) slower_than: f64,
    /// T grows with λ along the family, as it does with μ.
    pub(crate) monotone: bool,
    /// Asked once a step.
    pub(crate) cancelled: &'a dyn Fn() -> bool,
}

/// Follows `candidate` from λ = `from` (not yet solved there) to λ = 1.
pub(crate) fn follow(
    newton: &mut Newton,
    family: &Family,
    candidate: &mut Candidate,
    from: f64,
    bounds: &Bounds<'_>,
) -> Result<(), Dead> {
    let start_count = newton.evaluations;
    let spent = |newton: &Newton| newton.evaluations - start_count;
    let (problem, mu) = family.at(from);
    newton.converge_damped(&problem, mu, candidate, &family.direction).ok_or(Dead::NotBegun)?;
    settle(newton, &problem, mu, candidate, &family.direction, bounds.budget).ok_or(Dead::NotBegun)?;
    let mut lambda = from;
    let mut step = 1.5 * from.max(0.05 * (1.0 - from).min(0.2));
    let mut trial = candidate.clone();
    let mut failures = 0;
    while lambda < 1.0 {
        if (bounds.cancelled)() {
            return Err(Dead::Cancelled);
        }
        let next = if lambda + step > 0.999 { 1.0 } else { lambda + step };
        let (problem, mu_next) = family.at(next);
        let (_, mu_now) = family.at(lambda);
        trial.clone_from(candidate);
        trial.shift(&newton.tangent, next - lambda);
        let now = candidate.duration(mu_now);
        let slope = slope(candidate, &newton.tangent, mu_now, family.direction.mu);
        let predicted = now + (next - lambda) * slope;
        // T grows ever more slowly, most so at the beginning: what a path that dies early says counts little.
        let heading_for = now + lambda * (1.0 - lambda) * slope.max(0.0);
        if spent(newton) > bounds.budget {
            return Err(Dead::Budget { heading_for });
        }
        let tangent = newton.tangent;
        let before = newton.evaluations;
        let plausible = |reached: f64| {
            (reached - predicted).abs() < MISS * now + 1e-9
                && (!bounds.monotone || reached > now * (1.0 - 1e-9))
        };
        let mut settled = settle(newton, &problem, mu_next, &mut trial, &family.direction, bounds.budget)
            .filter(|_| plausible(trial.duration(mu_next)));
        if settled.is_none() {
            failures += 1;
            if failures == DELETE_AFTER {
                // Where a short piece vanishes like a square root, Newton does not see it vanish: try without it.
                settled = vanishing(candidate, &tangent, next - lambda).find_map(|index| {
                    trial.clone_from(candidate);
                    trial.shift(&tangent, next - lambda);
                    (drop_piece(&mut trial, index)
                        && settle(newton, &problem, mu_next, &mut trial, &family.direction, bounds.budget)
                            .is_some()
                        && plausible(trial.duration(mu_next)))
                    .then_some(1)
                });
            }
        }
        if let Some(events) = settled {
            failures = 0;
            let iterations = newton.evaluations - before;
            core::mem::swap(candidate, &mut trial);
            lambda = next;
            if candidate.duration(mu_next) > bounds.slower_than {
                return Err(Dead::Slower);
            }
            if events == 0 && iterations <= EASY {
                step *= GROW_EASY;
            } else if iterations <= FAIR {
                step *= GROW_FAIR;
            }
        } else {
            newton.tangent = tangent;
            step = (next - lambda) * SHRINK;
            if step < SMALLEST_STEP * (1.0 - from) {
                return Err(Dead::Stuck { heading_for });
            }
        }
    }
    Ok(())
}

/// dT/dλ along the tangent.
fn slope(candidate: &Candidate, tangent: &[f64; MAX_UNKNOWNS], mu: f64, mu_slope: f64) -> f64 {
    let of = |(piece, slope): (&Piece, &f64)| {
        if piece.is_arc() { *slope } else { slope * mu + piece.length * mu_slope }
    };
    candidate.pieces.iter().zip(tangent).map(of).sum()
}

/// Pieces that are short and shrinking along the tangent.
fn vanishing(
    candidate: &Candidate,
    tangent: &[f64; MAX_UNKNOWNS],
    step: f64,
) -> impl Iterator<Item = usize> + use<> {
    let mut short = [false; MAX_SEGMENTS];
    for (i, (piece, slope)) in candidate.pieces.iter().zip(tangent).enumerate() {
        short[i] = *slope < 0.0 && (piece.length < SHORT || piece.length + 4.0 * slope * step < 0.0);
    }
    (0..candidate.pieces.len()).filter(move |&i| short[i])
}

/// Solves at one parameter value, changing the structure until every law holds. The number of changes, or `None`.
pub(crate) fn settle(
    newton: &mut Newton,
    problem: &Problem,
    mu: f64,
    candidate: &mut Candidate,
    direction: &Direction,
    budget: u32,
) -> Option<u32> {
    let limit = newton.evaluations + budget;
    for events in 0..=MOST_EVENTS {
        if newton.evaluations > limit {
            return None;
        }
        newton.converge(problem, mu, candidate, direction)?;
        match repair(problem, mu, candidate) {
            Repair::None => return Some(events),
            Repair::Changed => {}
            Repair::Stuck => return None,
        }
    }
    None
}

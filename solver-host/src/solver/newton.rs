//! Newton's method on the square system of one structure.

use super::linearise::Linearised;
use super::problem::{Direction, Problem};
use super::structure::{Candidate, MAX_UNKNOWNS};

/// Weighted residual from which one more Newton step lands at rounding: convergence is quadratic.
const NEARLY: f64 = 1e-7;
/// Iterations that a continuation step may take; more means that the step was too long.
const MOST: u32 = 14;
/// Iterations of a damped solve, and its shortest step.
const MOST_DAMPED: u32 = 30;
const SMALLEST_DAMPING: f64 = 1e-3;
/// Largest change of a bang angle in one iteration, rad; the whole step is shortened to it.
const LARGEST_TURN_STEP: f64 = 0.7;
/// Largest change of an arc's duration in one iteration, relative to T.
const LARGEST_ARC_STEP: f64 = 0.35;
/// A residual this much larger than the first is divergence.
const DIVERGED: f64 = 1e3;

/// Work counters and the tangent of the latest solve.
#[derive(Clone, Debug)]
pub(crate) struct Newton {
    lin: Linearised,
    pub(crate) tangent: [f64; MAX_UNKNOWNS],
    step: [f64; MAX_UNKNOWNS],
    /// Evaluations of residual and Jacobian so far.
    pub(crate) evaluations: u32,
}

impl Newton {
    pub(crate) fn new() -> Self {
        Self {
            lin: Linearised::new(),
            tangent: [0.0; MAX_UNKNOWNS],
            step: [0.0; MAX_UNKNOWNS],
            evaluations: 0,
        }
    }

    /// One evaluation and elimination. `None` where the system is singular or not square.
    fn iterate(
        &mut self,
        problem: &Problem,
        mu: f64,
        candidate: &Candidate,
        direction: &Direction,
    ) -> Option<f64> {
        self.evaluations += 1;
        if !self.lin.evaluate(problem, mu, candidate, direction) || !self.lin.norm.is_finite() {
            return None;
        }
        let norm = self.lin.norm;
        self.lin.solve(&mut self.step, &mut self.tangent)?;
        Some(norm)
    }

    /// Solves for `candidate` in place; the number of iterations, or `None`.
    pub(crate) fn converge(
        &mut self,
        problem: &Problem,
        mu: f64,
        candidate: &mut Candidate,
        direction: &Direction,
    ) -> Option<u32> {
        let mut first = 0.0;
        for iteration in 1..=MOST {
            let norm = self.iterate(problem, mu, candidate, direction)?;
            if iteration == 1 {
                first = norm.max(1e-2);
            } else if norm > DIVERGED * first {
                return None;
            }
            let scale = self.limit(candidate, mu);
            candidate.shift(&self.step, scale);
            if norm < NEARLY {
                return Some(iteration);
            }
        }
        None
    }

    /// Like [`Self::converge`] from a poor start: every step must shrink the residual.
    pub(crate) fn converge_damped(
        &mut self,
        problem: &Problem,
        mu: f64,
        candidate: &mut Candidate,
        direction: &Direction,
    ) -> Option<u32> {
        let mut norm = self.iterate(problem, mu, candidate, direction)?;
        for iteration in 1..=MOST_DAMPED {
            let mut scale = self.limit(candidate, mu);
            let step = self.step;
            if norm < NEARLY {
                candidate.shift(&step, scale);
                return Some(iteration);
            }
            let origin = candidate.clone();
            loop {
                candidate.shift(&step, scale);
                match self.iterate(problem, mu, candidate, direction) {
                    Some(next) if next < norm * (1.0 - 0.2 * scale) => {
                        norm = next;
                        break;
                    }
                    _ => {}
                }
                scale *= 0.5;
                if scale < SMALLEST_DAMPING {
                    return None;
                }
                candidate.clone_from(&origin);
            }
        }
        None
    }

    /// Iterates to rounding. Returns the last weighted residual.
    pub(crate) fn polish(&mut self, problem: &Problem, mu: f64, candidate: &mut Candidate) -> Option<f64> {
        let mut best = f64::INFINITY;
        for _ in 0..6 {
            let norm = self.iterate(problem, mu, candidate, &Direction::MU)?;
            if norm >= 0.5 * best || norm < 1e-16 {
                return Some(norm);
            }
            best = norm;
            candidate.shift(&self.step, 1.0);
        }
        Some(best)
    }

    /// How much of the step to take.
    fn limit(&self, candidate: &Candidate, mu: f64) -> f64 {
        let arc_limit = LARGEST_ARC_STEP * candidate.duration(mu).abs().max(1e-3);
        let mut scale = 1.0_f64;
        for (piece, step) in candidate.pieces.iter().zip(&self.step) {
            let largest = if piece.is_arc() { arc_limit } else { LARGEST_TURN_STEP };
            if step.abs() * scale > largest {
                scale = largest / step.abs();
            }
        }
        scale
    }
}

impl Candidate {
    /// Adds a multiple of a step of the unknowns.
    pub(crate) fn shift(&mut self, step: &[f64; MAX_UNKNOWNS], scale: f64) {
        let n = self.pieces.len();
        for (piece, s) in self.pieces.iter_mut().zip(step) {
            piece.length += scale * s;
        }
        for (c, s) in self.c.iter_mut().zip(&step[n..]) {
            *c += scale * s;
        }
    }
}

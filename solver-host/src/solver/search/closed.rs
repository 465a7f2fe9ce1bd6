//! Maneuvers that need no continuation: a straight push, those at the bound of their winding, those with few numbers.

use core::f64::consts::TAU;

use super::super::request::MOST_TURNS;
use super::super::rigid::{Limit, rigid};
use super::super::rotation::rotation_limited;
use super::super::straight::straight;
use super::super::structure::Candidate;
use super::{Search, TIE};

impl Search<'_> {
    /// A straight push is as fast as the relaxation: where there is one, the search is over.
    pub(super) fn straight(&mut self) -> bool {
        let turns = -libm::round(self.problem.turn() / TAU);
        if turns.abs() > f64::from(MOST_TURNS) || self.turns.is_some_and(|k| f64::from(k) != turns) {
            return false;
        }
        if let Some(candidate) = straight(&self.wound(turns as i32)) {
            let duration = candidate.duration(1.0);
            self.add(candidate, turns as i32, duration);
        }
        !self.found.is_empty()
    }

    /// Maneuvers at the bound |Δθ|/ω_max of their winding.
    pub(super) fn rotation_limited(&mut self) {
        let relaxed = self.relaxed[0].map_or(0.0, |r| r.lower_bound);
        for turns in self.windings() {
            let problem = self.wound(turns);
            let bound = problem.turn().abs();
            if !(self.cancelled)()
                && bound >= relaxed
                && bound < self.best()
                && let Some(candidate) = rotation_limited(&problem)
            {
                self.add(candidate, turns, bound);
            }
        }
    }

    /// Maneuvers with fewer free numbers than end conditions. Rest to rest at one angle has none: it needs at least three
    /// rate switches.
    pub(super) fn rigid(&mut self) {
        let (f, g) = (&self.problem.from, &self.problem.to);
        let at_rest = |s: &[f64; 5]| s[1] == 0.0 && s[3] == 0.0;
        if at_rest(f) && at_rest(g) && f[4] == g[4] {
            return;
        }
        let Some(relaxed) = self.relaxed[0] else { return };
        for turns in self.windings() {
            let problem = self.wound(turns);
            let best = self.best();
            if problem.turn().abs() >= best {
                continue;
            }
            let deep = self.effort.insist
                && (!self.lost.is_empty() || self.doubtful || self.found.is_empty() || self.idle());
            let mut faster: Option<Candidate> = None;
            let limit = Limit { slower_than: best * (1.0 + TIE), cancelled: self.cancelled };
            rigid(&problem, &relaxed, &limit, deep, |candidate| {
                let better = faster.as_ref().is_none_or(|f| candidate.duration(1.0) < f.duration(1.0));
                if better && (self.verified)(&candidate, turns) {
                    faster = Some(candidate);
                }
            });
            if let Some(candidate) = faster {
                let duration = candidate.duration(1.0);
                self.add(candidate, turns, duration);
            }
        }
    }
}

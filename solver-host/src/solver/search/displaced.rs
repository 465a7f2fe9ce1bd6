//! The long way round: problems beside the one asked for, solved and carried over.

use core::f64::consts::TAU;

use super::super::detour::DETOURS;
use super::super::path::{Bounds, Family, follow, settle};
use super::super::problem::{Direction, Problem};
use super::super::structure::Candidate;
use super::super::tiny;
use super::{Effort, Found, MAX_WINDINGS, SETTLED, Search};

/// T over what bounds it beyond which a winding without any maneuver is suspect.
const FAR: f64 = 2.0;
/// What a stronger or weaker vehicle has left beyond hover, F_max − g, over what this one has.
const STRENGTHS: [f64; 8] = [1.5, 2.5, 0.6, 0.3, 4.0, 0.12, 8.0, 16.0];
/// T of a displaced problem over the best T of the problem itself beyond which its maneuver is of no use.
const FURTHEST: f64 = 1.4;

impl Search<'_> {
    /// Solves a tiny problem at an ordinary size and shrinks its maneuver.
    pub(super) fn enlarge(&mut self) {
        if self.turns.is_some_and(|k| k != 0) {
            return;
        }
        let sizes = tiny::enlarged(&self.problem);
        let Some((first, smaller)) = sizes.split_first() else { return };
        // Of ordinary size, so this goes no deeper.
        let mut search = Search::new(*first, Some(0), Effort::NORMAL, &|_, _| true, self.cancelled);
        search.newton.evaluations = self.newton.evaluations;
        self.was_cancelled |= !search.run();
        self.newton.evaluations = search.newton.evaluations;
        let Some(mut found) = search.found.first().cloned() else { return };
        let mut from = *first;
        for problem in smaller {
            let Some((candidate, duration)) = self.carry_to(&from, &found, problem) else { return };
            found = Found { candidate, duration, ..found };
            from = *problem;
        }
        self.add(found.candidate, found.turns, found.duration);
    }

    /// Solves displaced problems and carries their solutions over, for the windings that may hide a faster maneuver.
    pub(super) fn detour(&mut self) {
        // Mirror images take the same ways round.
        let orientation = self.problem.orientation();
        // What is open now stays so: the first maneuver that is found need not be the best.
        let open: heapless::Vec<i32, MAX_WINDINGS> =
            self.windings().into_iter().filter(|&k| self.effort.everything || self.open(k)).collect();
        for detour in &DETOURS {
            let displaced = detour.apply(&self.problem, orientation);
            for &turns in &open {
                if self.was_cancelled || (self.cancelled)() {
                    self.was_cancelled = true;
                    return;
                }
                if self.effort.everything || !self.settled(turns) {
                    self.detour_by(&displaced, turns);
                }
            }
        }
    }

    /// Where all that is known is far slower than what bounds it and paths died, solves the problem for stronger and for
    /// weaker vehicles, and carries the maneuvers over along F_max: between a strong vehicle, which flies an arc between
    /// two turns, and a weak one, which only turns, there are limits at which no start leads to the fastest maneuver.
    pub(super) fn other_strengths(&mut self) {
        let spare = self.problem.u_max - 1.0;
        if spare <= 0.0 || (self.lost.is_empty() && !self.doubtful) {
            return;
        }
        for turns in self.windings() {
            for factor in STRENGTHS {
                if self.was_cancelled || !self.slow(turns) {
                    break;
                }
                let u_max = 1.0 + factor * spare;
                if u_max > self.problem.u_min {
                    self.detour_by(&Problem { u_max, ..self.problem }, turns);
                }
            }
        }
    }

    /// This winding could still win, and everything known is far from what bounds it.
    fn slow(&self, turns: i32) -> bool {
        self.best() > FAR * self.wound(turns).turn().abs().max(self.lower_bound())
    }

    /// A path of this winding has died that could have won, or nothing of it is known though it should.
    fn open(&self, turns: i32) -> bool {
        let best = self.best();
        let lost = self.lost.iter().any(|(k, t)| *k == turns && *t * SETTLED < best);
        self.wound(turns).turn().abs() < best && (lost || self.missing(turns))
    }

    /// Nothing of this winding is known, and what is known of others is far from its bound.
    pub(super) fn missing(&self, turns: i32) -> bool {
        let turn = self.wound(turns).turn().abs();
        let best = self.best();
        turn < best
            && best > FAR * turn.max(self.lower_bound())
            && self.found.iter().all(|f| f.turns != turns)
    }

    /// Everything there is, for one winding.
    pub(super) fn thoroughly(&mut self, turns: i32) {
        let effort = core::mem::replace(&mut self.effort, Effort::THOROUGH);
        self.tried.clear();
        let backward = self.problem.is_backward();
        self.pass(backward, Some(turns), self.effort.paths);
        self.pass(!backward, Some(turns), self.effort.paths);
        let orientation = self.problem.orientation();
        for detour in &DETOURS {
            if self.was_cancelled || (self.cancelled)() {
                self.was_cancelled = true;
                break;
            }
            if !self.settled(turns) {
                self.detour_by(&detour.apply(&self.problem, orientation), turns);
            }
        }
        self.effort = effort;
    }

    /// It cannot win any more, or what was found is hardly slower than what its lost path was heading for.
    fn settled(&self, turns: i32) -> bool {
        let best = self.best();
        let lost =
            self.lost.iter().filter(|(k, _)| *k == turns).map(|(_, t)| *t).fold(f64::INFINITY, f64::min);
        self.wound(turns).turn().abs() >= best || (lost < f64::INFINITY && best < SETTLED * lost)
    }

    fn detour_by(&mut self, displaced: &Problem, turns: i32) {
        // Only what arrives at the problem itself needs to pass the check.
        let effort = if self.effort.everything {
            Effort { everything: false, ..self.effort }
        } else {
            Effort::NEIGHBOUR
        };
        let mut search = Search::new(*displaced, Some(turns), effort, &|_, _| true, self.cancelled);
        search.newton.evaluations = self.newton.evaluations;
        search.limit = FURTHEST * self.best();
        let backward = self.problem.is_backward();
        search.pass(backward, Some(turns), effort.paths);
        if search.found.is_empty() {
            search.pass(!backward, Some(turns), effort.paths);
        }
        self.newton.evaluations = search.newton.evaluations;
        self.was_cancelled |= search.was_cancelled;
        for neighbour in &search.found {
            if let Some((candidate, duration)) = self.carry(displaced, neighbour) {
                self.add(candidate, neighbour.turns, duration);
            }
        }
    }

    /// Continuation in the data at the real rate limit, from a neighbour's solution to this problem.
    fn carry(&mut self, from: &Problem, neighbour: &Found) -> Option<(Candidate, f64)> {
        let mut base = *from;
        base.to[4] += f64::from(neighbour.turns) * TAU;
        let target = self.wound(neighbour.turns);
        self.carry_to(&base, neighbour, &target)
    }

    /// The same between any two problems of one winding.
    fn carry_to(&mut self, from: &Problem, neighbour: &Found, target: &Problem) -> Option<(Candidate, f64)> {
        let family = Family { base: *from, mu: 1.0, direction: Direction::between(from, target) };
        let mut candidate = neighbour.candidate.clone();
        let bounds = Bounds {
            budget: self.effort.path_budget,
            slower_than: f64::INFINITY,
            monotone: false,
            cancelled: self.cancelled,
        };
        follow(&mut self.newton, &family, &mut candidate, 0.0, &bounds).ok()?;
        settle(&mut self.newton, target, 1.0, &mut candidate, &Direction::MU, self.effort.path_budget)?;
        self.newton.polish(target, 1.0, &mut candidate)?;
        let duration = candidate.duration(1.0);
        Some((candidate, duration))
    }
}

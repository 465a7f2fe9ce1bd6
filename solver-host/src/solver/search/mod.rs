//! The search over starts: which continuations to run, in what order, and what to try when they fail.

mod closed;
mod displaced;
mod keep;

use core::f64::consts::TAU;

use heapless::Vec;

use super::newton::Newton;
use super::path::{Bounds, Dead, Family, follow};
use super::problem::Problem;
use super::relax::{Relaxation, elementary_bound, first_mu, relax};
use super::starts::{LARGEST_TURN, Start, build, starts};
use super::structure::{Candidate, Piece};
use super::tiny;

/// How hard to look.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Effort {
    /// Evaluations one path may take; losers use the most.
    path_budget: u32,
    /// Starts tried in one pass.
    paths: usize,
    /// A start whose estimate exceeds the best T by this factor is not tried.
    hopeless: f64,
    /// Run the detours even where nothing went wrong.
    everything: bool,
    /// Where nothing is found, look again backwards in time, from displaced problems, and with more effort.
    insist: bool,
}

impl Effort {
    /// Enough for almost every problem: the winner is the first start in five of six.
    pub(crate) const NORMAL: Self =
        Self { path_budget: 400, paths: 4, hopeless: 1.1, everything: false, insist: true };
    /// For a neighbour that serves as a stepping stone: there are more of them.
    const NEIGHBOUR: Self = Self { path_budget: 200, paths: 2, ..Self::NORMAL };
    /// A second look at everything, some thirty times slower.
    pub(crate) const THOROUGH: Self =
        Self { path_budget: 1500, paths: 12, hopeless: 1.6, everything: true, insist: true };
}

/// Best T over the T that a lost path was heading for, below which nothing is lost.
const SETTLED: f64 = 1.005;
/// T over its estimate beyond which a path is doubted.
const DOUBTFUL: f64 = 1.08;
/// T over its lower bound from which on a maneuver is so short that the turning rules it.
const SHORT: f64 = 1.3;
/// Starts that each winding which can still win is given then, forwards and backwards in time.
const OWN_STARTS: usize = 4;
/// What the turning costs, at least, as a part of its estimate, which is of first order.
const LEAST_SHARE: f64 = 0.7;
/// The first μ, and smaller ones to try where the first solve fails.
const FIRST_MU_FACTORS: [f64; 3] = [1.0, 0.2, 0.04];
/// Two durations this close, relative, are the same maneuver or its mirror image.
pub(crate) const TIE: f64 = 1e-9;
/// Angle of a bang that does nothing, rad.
const IDLE: f64 = 1e-5;
/// Most lost paths remembered.
const MAX_LOST: usize = 24;
/// Windings looked at, as far as their net turn is no more than [`LARGEST_TURN`]; others need to be asked for.
const WINDINGS: i32 = 4;
/// Most starts remembered.
const MAX_TRIED: usize = 64;
/// Most windings kept.
pub(crate) const MAX_WINDINGS: usize = 12;

/// One winding's best maneuver.
#[derive(Clone, Debug)]
pub(crate) struct Found {
    pub(crate) candidate: Candidate,
    pub(crate) turns: i32,
    /// Dimensionless T.
    pub(crate) duration: f64,
}

/// State of one search.
pub(crate) struct Search<'a> {
    effort: Effort,
    /// Winding 0.
    problem: Problem,
    /// Its relaxation, and that of the problem backwards.
    relaxed: [Option<Relaxation>; 2],
    turns: Option<i32>,
    /// Nothing slower than this, dimensionless, is of interest.
    pub(crate) limit: f64,
    /// Passes the independent check, given the winding.
    verified: &'a dyn Fn(&Candidate, i32) -> bool,
    /// T of the fastest maneuver that did not pass.
    pub(crate) refused: f64,
    cancelled: &'a dyn Fn() -> bool,
    pub(crate) newton: Newton,
    /// Best of each winding.
    pub(crate) found: Vec<Found, MAX_WINDINGS>,
    /// Paths that died but could have won, as winding and the T they were heading for.
    lost: Vec<(i32, f64), MAX_LOST>,
    /// A path ended far from its estimate: it may have slipped to another branch.
    doubtful: bool,
    /// Starts already followed, and whether backwards in time.
    tried: Vec<(Start, bool), MAX_TRIED>,
    was_cancelled: bool,
}

impl<'a> Search<'a> {
    pub(crate) fn new(
        problem: Problem,
        turns: Option<i32>,
        effort: Effort,
        verified: &'a dyn Fn(&Candidate, i32) -> bool,
        cancelled: &'a dyn Fn() -> bool,
    ) -> Self {
        Self {
            effort,
            problem,
            relaxed: [relax(&problem), None],
            turns,
            limit: f64::INFINITY,
            verified,
            refused: f64::INFINITY,
            cancelled,
            newton: Newton::new(),
            found: Vec::new(),
            lost: Vec::new(),
            doubtful: false,
            tried: Vec::new(),
            was_cancelled: false,
        }
    }

    /// Nothing is faster than this, of any winding; NaN where the numbers are beyond what can be computed with.
    pub(crate) fn lower_bound(&self) -> f64 {
        if !self.problem.from.iter().chain(&self.problem.to).all(|v| v.is_finite()) {
            return f64::NAN;
        }
        self.relaxed[0].map_or_else(|| elementary_bound(&self.problem), |r| r.lower_bound)
    }

    /// Runs everything. False where the caller cancelled.
    pub(crate) fn run(&mut self) -> bool {
        let problem = self.problem;
        if self.straight() {
            return true;
        }
        // A problem and the same backwards go the same ways, so that they come to the same answer.
        let backward = self.problem.is_backward();
        self.pass(backward, self.turns, self.effort.paths);
        self.rotation_limited();
        self.rigid();
        let again =
            if self.effort.insist { self.unfinished() || self.doubtful } else { self.found.is_empty() };
        if again {
            // Run the other way it starts from other guesses.
            self.lost.clear();
            self.pass(!backward, self.turns, self.effort.paths);
        }
        if self.effort.insist && self.suspicious() {
            self.each_winding();
        }
        if self.effort.insist && tiny::doubtful(&problem, self.best()) {
            self.enlarge();
        }
        if self.effort.insist && !self.was_cancelled {
            self.other_strengths();
        }
        if self.effort.insist && !self.was_cancelled {
            self.detour();
        }
        if self.effort.insist && !self.effort.everything {
            for turns in self.windings() {
                if !self.was_cancelled && self.missing(turns) {
                    self.thoroughly(turns);
                }
            }
        }
        self.add_mirror_images();
        self.sort();
        !self.was_cancelled && !(self.cancelled)()
    }

    fn unfinished(&self) -> bool {
        !self.was_cancelled
            && (self.found.is_empty() || self.lost_at() < f64::INFINITY || self.effort.everything)
    }

    /// Least T at which a path died that could still win, of the windings that are not known to be at their bound.
    fn lost_at(&self) -> f64 {
        let best = self.best();
        let open = |turns: i32| {
            self.found
                .iter()
                .all(|f| f.turns != turns || f.duration > (1.0 + TIE) * self.wound(turns).turn().abs())
        };
        self.lost
            .iter()
            .filter(|(turns, t)| *t < best && open(*turns))
            .map(|(_, t)| *t)
            .fold(f64::INFINITY, f64::min)
    }

    /// A maneuver was found that begins or ends with a bang of no length beside an arc: it is simpler than that.
    fn idle(&self) -> bool {
        let idle = |piece: Option<&Piece>| piece.is_some_and(|p| !p.is_arc() && p.length < IDLE);
        self.found.iter().any(|f| idle(f.candidate.pieces.first()) || idle(f.candidate.pieces.last()))
    }

    fn best(&self) -> f64 {
        self.found.iter().map(|f| f.duration).fold(self.limit, f64::min)
    }

    /// The problem with a winding.
    fn wound(&self, turns: i32) -> Problem {
        let mut problem = self.problem;
        problem.to[4] += f64::from(turns) * TAU;
        problem
    }

    /// The answer may not be the best: something went wrong on the way, or the maneuver is so short that the estimates,
    /// which are of first order, may have ranked the windings wrongly.
    fn suspicious(&self) -> bool {
        let Some(relaxed) = &self.relaxed[0] else { return true };
        self.unfinished() || self.doubtful || self.best() > SHORT * relaxed.lower_bound
    }

    /// Gives every winding that can still win starts of its own, the smaller net turns first.
    fn each_winding(&mut self) {
        for backwards in [self.problem.is_backward(), !self.problem.is_backward()] {
            for turns in self.windings() {
                let bound = self.wound(turns).turn().abs();
                if bound < self.best() {
                    self.pass(backwards, Some(turns), OWN_STARTS);
                }
            }
        }
    }

    /// The windings asked for, the smaller net turns first.
    fn windings(&self) -> Vec<i32, MAX_WINDINGS> {
        let net = |k: i32| self.wound(k).turn().abs();
        let mut list: Vec<i32, MAX_WINDINGS> = match self.turns {
            Some(k) => core::iter::once(k).collect(),
            None => (-WINDINGS..=WINDINGS).filter(|&k| net(k) <= LARGEST_TURN).collect(),
        };
        list.sort_unstable_by(|a, b| net(*a).total_cmp(&net(*b)));
        list
    }

    /// Continuation in the rate limit from the best starts, of one winding or all, forwards or backwards in time.
    fn pass(&mut self, backwards: bool, turns: Option<i32>, paths: usize) {
        let direction = usize::from(backwards);
        let problem = if backwards { self.problem.reversed() } else { self.problem };
        if self.relaxed[direction].is_none() {
            self.relaxed[direction] = relax(&problem);
        }
        let Some(relaxed) = self.relaxed[direction] else { return };
        let mu = first_mu(relaxed.duration);
        // Backwards, θ runs from θ_T + 2πk to θ_0: the winding is moved to the end and changes sign.
        let wanted = if backwards { turns.map(|k| -k) } else { turns };
        let own = turns != self.turns;
        let list = starts(&problem, &relaxed, wanted, mu);
        for (i, start) in list.iter().enumerate() {
            let best = self.best();
            // A few starts are tried for their own sake, more as long as they promise to be faster.
            let mut enough = if i < paths { self.effort.hopeless * best } else { best };
            if own && i < paths {
                enough = enough.max(relaxed.duration + (best - relaxed.duration) / LEAST_SHARE);
            }
            if self.was_cancelled || i >= 2 * paths || start.estimate > enough {
                break;
            }
            if self.tried.iter().any(|(other, back)| *back == backwards && other.same(start)) {
                continue;
            }
            // A full list is a search that has taken too long already.
            let _ = self.tried.push((*start, backwards));
            if let Some((mut candidate, duration)) = self.path(&problem, &relaxed, start, mu, best, backwards)
            {
                let mut turns = start.turns;
                if backwards {
                    candidate.reverse(duration);
                    turns = -turns;
                }
                self.add(candidate, turns, duration);
            }
        }
    }

    /// One continuation in the rate limit.
    fn path(
        &mut self,
        problem: &Problem,
        relaxed: &Relaxation,
        start: &Start,
        mu: f64,
        slower_than: f64,
        backwards: bool,
    ) -> Option<(Candidate, f64)> {
        let mut wound = *problem;
        wound.to[4] += f64::from(start.turns) * TAU;
        let family = Family::rate_limit(&wound);
        let bounds = Bounds {
            budget: self.effort.path_budget,
            slower_than,
            monotone: true,
            cancelled: self.cancelled,
        };
        let mut outcome = Err(Dead::NotBegun);
        for mu in FIRST_MU_FACTORS.map(|factor| factor * mu) {
            let Some(mut candidate) = build(problem, relaxed, start, mu) else { continue };
            outcome =
                follow(&mut self.newton, &family, &mut candidate, mu, &bounds).map(|()| candidate.clone());
            if !matches!(outcome, Err(Dead::NotBegun)) {
                break;
            }
        }
        match outcome {
            Ok(mut candidate) => {
                self.newton.polish(&wound, 1.0, &mut candidate)?;
                let duration = candidate.duration(1.0);
                self.doubtful |= duration > DOUBTFUL * start.estimate;
                Some((candidate, duration))
            }
            Err(Dead::Cancelled) => {
                self.was_cancelled = true;
                None
            }
            Err(Dead::Slower) => None,
            Err(dead) => {
                let died_at = match dead {
                    // Where the system is nearly singular its slope is of no use.
                    Dead::Stuck { heading_for } | Dead::Budget { heading_for } => {
                        heading_for.min(start.estimate)
                    }
                    _ => relaxed.duration,
                };
                if start.estimate < slower_than {
                    // A full list is long enough to know that something was lost.
                    let _ = self.lost.push((if backwards { -start.turns } else { start.turns }, died_at));
                }
                None
            }
        }
    }
}

//! The search over starts: which continuations to run, in what order, and what to try when they fail.

use core::f64::consts::TAU;

use heapless::Vec;

use super::detour::DETOURS;
use super::newton::Newton;
use super::path::{Bounds, Dead, Family, follow, settle};
use super::problem::{Direction, Problem};
use super::relax::{Relaxation, first_mu, relax};
use super::request::MOST_TURNS;
use super::rigid::rigid;
use super::rotation::rotation_limited;
use super::starts::{LARGEST_TURN, Start, build, starts};
use super::straight::straight;
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
    /// Run the backward pass and the detours even where nothing went wrong.
    everything: bool,
    /// Where nothing is found, look again backwards in time, from displaced problems, and with more effort.
    insist: bool,
}

impl Effort {
    /// Enough for almost every problem: the winner is the first start in five of six.
    pub(crate) const NORMAL: Self =
        Self { path_budget: 400, paths: 4, hopeless: 1.1, everything: false, insist: true };
    /// For windings that have lost already: backwards too where nothing is found, no more.
    pub(crate) const LIGHT: Self = Self { insist: false, ..Self::NORMAL };
    /// For a neighbour that serves as a stepping stone: there are more of them.
    const NEIGHBOUR: Self = Self { path_budget: 200, paths: 3, ..Self::NORMAL };
    /// A second look at everything, some thirty times slower.
    pub(crate) const THOROUGH: Self =
        Self { path_budget: 1500, paths: 12, hopeless: 1.6, everything: true, insist: true };
}

/// Best T over the T at which a lost path died, below which nothing is lost.
const SETTLED: f64 = 1.02;
/// T over its estimate beyond which a path is doubted.
const DOUBTFUL: f64 = 1.08;
/// The first μ, and smaller ones to try where the first solve fails.
const FIRST_MU_FACTORS: [f64; 3] = [1.0, 0.2, 0.04];
/// Two durations this close, relative, are the same maneuver or its mirror image.
pub(crate) const TIE: f64 = 1e-9;
/// Angle of a bang that does nothing, rad.
const IDLE: f64 = 1e-5;
/// Most lost paths remembered.
const MAX_LOST: usize = 8;
/// Windings looked at for maneuvers at their bound; start and end angles further apart need them to be asked for.
const WINDINGS: i32 = 4;
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
    turns: Option<i32>,
    /// Passes the independent check, given the winding.
    verified: &'a dyn Fn(&Candidate, i32) -> bool,
    /// T of the fastest maneuver that did not pass.
    pub(crate) refused: f64,
    cancelled: &'a dyn Fn() -> bool,
    pub(crate) newton: Newton,
    /// Best of each winding.
    pub(crate) found: Vec<Found, MAX_WINDINGS>,
    /// Paths that died but could have won, as winding and T where they died: the true T may be anywhere above it.
    lost: Vec<(i32, f64), MAX_LOST>,
    /// A path ended far from its estimate: it may have slipped to another branch.
    doubtful: bool,
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
            turns,
            verified,
            refused: f64::INFINITY,
            cancelled,
            newton: Newton::new(),
            found: Vec::new(),
            lost: Vec::new(),
            doubtful: false,
            was_cancelled: false,
        }
    }

    /// Runs everything. False where the caller cancelled.
    pub(crate) fn run(&mut self) -> bool {
        let problem = self.problem;
        if self.straight() {
            return true;
        }
        self.pass(&problem, false);
        self.rotation_limited();
        self.rigid();
        let again =
            if self.effort.insist { self.unfinished() || self.doubtful } else { self.found.is_empty() };
        if again && !self.was_cancelled {
            // The same problem backwards starts from other guesses.
            self.lost.clear();
            self.pass(&problem, true);
        }
        if self.effort.insist && tiny::doubtful(&problem, self.best()) {
            self.enlarge();
        }
        if self.effort.insist && self.unfinished() {
            self.detour();
        }
        if self.effort.insist && !self.was_cancelled && self.found.is_empty() && !self.effort.everything {
            self.effort = Effort::THOROUGH;
            self.pass(&problem, false);
            self.pass(&problem, true);
            self.detour();
        }
        self.add_mirror_images();
        self.sort();
        !self.was_cancelled
    }

    fn unfinished(&self) -> bool {
        !self.was_cancelled
            && (self.found.is_empty() || self.lost_at() < f64::INFINITY || self.effort.everything)
    }

    /// Least T at which a path died, of the windings that are not known to be at their bound.
    fn lost_at(&self) -> f64 {
        let open = |turns: i32| {
            self.found
                .iter()
                .all(|f| f.turns != turns || f.duration > (1.0 + TIE) * self.wound(turns).turn().abs())
        };
        self.lost.iter().filter(|(turns, _)| open(*turns)).map(|(_, t)| *t).fold(f64::INFINITY, f64::min)
    }

    /// A straight push is as fast as the relaxation: where there is one, the search is over.
    fn straight(&mut self) -> bool {
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
    fn rotation_limited(&mut self) {
        let relaxed = relax(&self.problem).map_or(0.0, |r| r.lower_bound);
        let windings = match self.turns {
            Some(k) => k..=k,
            None => -WINDINGS..=WINDINGS,
        };
        for turns in windings {
            let problem = self.wound(turns);
            let bound = problem.turn().abs();
            let promising =
                bound >= relaxed && bound < self.best() && (self.turns.is_some() || bound <= LARGEST_TURN);
            if promising && let Some(candidate) = rotation_limited(&problem) {
                self.add(candidate, turns, bound);
            }
        }
    }

    /// Maneuvers with fewer free numbers than end conditions. Rest to rest at one angle has none: it needs at least three
    /// rate switches.
    fn rigid(&mut self) {
        let (f, g) = (&self.problem.from, &self.problem.to);
        let at_rest = |s: &[f64; 5]| s[1] == 0.0 && s[3] == 0.0;
        if at_rest(f) && at_rest(g) && f[4] == g[4] {
            return;
        }
        let Some(relaxed) = relax(&self.problem) else { return };
        let windings = match self.turns {
            Some(k) => k..=k,
            None => -WINDINGS..=WINDINGS,
        };
        for turns in windings {
            let problem = self.wound(turns);
            let best = self.best();
            if problem.turn().abs() >= best || (self.turns.is_none() && problem.turn().abs() > LARGEST_TURN) {
                continue;
            }
            let deep = self.effort.insist
                && (!self.lost.is_empty() || self.doubtful || self.found.is_empty() || self.idle());
            let mut faster: Option<Candidate> = None;
            rigid(&problem, &relaxed, best * (1.0 + TIE), deep, |candidate| {
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

    /// A maneuver was found that begins or ends with a bang of no length beside an arc: it is simpler than that.
    fn idle(&self) -> bool {
        let idle = |piece: Option<&Piece>| piece.is_some_and(|p| !p.is_arc() && p.length < IDLE);
        self.found.iter().any(|f| idle(f.candidate.pieces.first()) || idle(f.candidate.pieces.last()))
    }

    /// What was found is hardly slower than where a path died, so that path has nothing better to offer.
    fn settled(&self) -> bool {
        !self.effort.everything && self.lost_at() < f64::INFINITY && self.best() < SETTLED * self.lost_at()
    }

    fn best(&self) -> f64 {
        self.found.iter().map(|f| f.duration).fold(f64::INFINITY, f64::min)
    }

    /// The problem with a winding.
    fn wound(&self, turns: i32) -> Problem {
        let mut problem = self.problem;
        problem.to[4] += f64::from(turns) * TAU;
        problem
    }

    /// Continuation in the rate limit from the best starts, forwards or backwards in time.
    fn pass(&mut self, base: &Problem, backwards: bool) {
        let problem = if backwards { base.reversed() } else { *base };
        let Some(relaxed) = relax(&problem) else { return };
        let mu = first_mu(relaxed.duration);
        // Backwards, θ runs from θ_T + 2πk to θ_0: the winding is moved to the end and changes sign.
        let wanted = if backwards { self.turns.map(|k| -k) } else { self.turns };
        let list = starts(&problem, &relaxed, wanted, mu);
        for (i, start) in list.iter().enumerate() {
            let best = self.best();
            // A few starts are tried for their own sake, more as long as they promise to be faster.
            let enough = if i < self.effort.paths { self.effort.hopeless * best } else { best };
            if self.was_cancelled || i >= 2 * self.effort.paths || start.estimate > enough {
                break;
            }
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
                    Dead::Stuck { duration } | Dead::Budget { duration } => duration,
                    _ => start.estimate,
                };
                if start.estimate < slower_than {
                    // A full list is long enough to know that something was lost.
                    let _ = self.lost.push((if backwards { -start.turns } else { start.turns }, died_at));
                }
                None
            }
        }
    }

    /// Solves a tiny problem at an ordinary size and shrinks its maneuver.
    fn enlarge(&mut self) {
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

    /// Solves displaced problems and carries their solutions over.
    fn detour(&mut self) {
        for detour in &DETOURS {
            if self.settled() {
                return;
            }
            if self.was_cancelled || (self.cancelled)() {
                self.was_cancelled = true;
                return;
            }
            let displaced = detour.apply(&self.problem);
            // Only what arrives at the problem itself needs to pass the check.
            let effort = if self.effort.everything {
                Effort { everything: false, ..self.effort }
            } else {
                Effort::NEIGHBOUR
            };
            let mut search = Search::new(displaced, self.turns, effort, &|_, _| true, self.cancelled);
            search.newton.evaluations = self.newton.evaluations;
            search.pass(&displaced, false);
            if search.found.is_empty() {
                search.pass(&displaced, true);
            }
            self.newton.evaluations = search.newton.evaluations;
            self.was_cancelled |= search.was_cancelled;
            for neighbour in &search.found {
                if let Some((candidate, duration)) = self.carry(&displaced, neighbour) {
                    self.add(candidate, neighbour.turns, duration);
                }
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

    /// Keeps the best of each winding; of two that are equally fast the simpler one.
    fn add(&mut self, candidate: Candidate, turns: i32, duration: f64) {
        if !(duration.is_finite() && duration > 0.0) {
            return;
        }
        let as_good = |f: &Found| {
            let pieces = f.candidate.pieces.len();
            let limit = if candidate.pieces.len() < pieces { 1.0 + TIE } else { 1.0 - TIE };
            f.turns == turns && duration >= f.duration * limit
        };
        if self.found.iter().any(as_good) {
            return;
        }
        if !(self.verified)(&candidate, turns) {
            // As good as lost: somewhere near there may be one that passes.
            self.refused = self.refused.min(duration);
            let _ = self.lost.push((turns, duration));
            return;
        }
        let found = Found { candidate, turns, duration };
        if let Some(same) = self.found.iter_mut().find(|f| f.turns == turns) {
            *same = found;
        } else {
            // A full list means twelve windings: the others cannot win any more.
            let _ = self.found.push(found);
        }
    }

    /// Where the problem is its own mirror image, so are its solutions.
    fn add_mirror_images(&mut self) {
        let Some(sum) = self.problem.mirror_sum() else { return };
        for index in 0..self.found.len() {
            let mut image = self.found[index].clone();
            image.candidate.mirror();
            image.turns = sum - image.turns;
            if image.turns == self.found[index].turns {
                // Of two mirror images with the same winding, the one that turns towards +θ first.
                if self.found[index].candidate.pieces.first().is_some_and(|p| p.sign() < 0.0) {
                    self.found[index] = image;
                }
            } else if self.turns.is_none_or(|k| k == image.turns) {
                self.add(image.candidate, image.turns, image.duration);
            }
        }
    }

    /// Fastest first; of ties the smaller net turn, then the positive one.
    fn sort(&mut self) {
        let base = self.problem.turn();
        let net = |f: &Found| base + f64::from(f.turns) * TAU;
        self.found.sort_unstable_by(|a, b| {
            if (a.duration - b.duration).abs() > TIE * a.duration.max(b.duration) {
                return a.duration.total_cmp(&b.duration);
            }
            let (x, y) = (net(a), net(b));
            if (x.abs() - y.abs()).abs() > 1e-9 { x.abs().total_cmp(&y.abs()) } else { y.total_cmp(&x) }
        });
    }
}

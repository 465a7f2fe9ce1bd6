//! Starting structures for the continuation: at μ → 0 every bang is an instant turn, so a maneuver is the relaxed one
//! with a turn onto its thrust direction, a turn off it, and possibly a flip where |p| is smallest.

use core::f64::consts::{FRAC_PI_2, PI, TAU};

use heapless::Vec;
use mintime_shared::minimum_principle::Costate;
use mintime_shared::model::ThrustLevel;

use super::problem::Problem;
use super::relax::Relaxation;
use super::structure::{Candidate, Piece, turning};

/// Most starts kept, best first.
pub(crate) const MAX_STARTS: usize = 12;

/// A start for the continuation, not yet built.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Start {
    /// Winding k: θ(T) = θ_T + 2πk.
    pub(crate) turns: i32,
    /// Estimate of T at μ = 1, first order.
    pub(crate) estimate: f64,
    first_turn: f64,
    last_turn: f64,
    extra_middle: i32,
}

impl Start {
    /// Leads to the same iterate.
    pub(crate) fn same(&self, other: &Self) -> bool {
        self.turns == other.turns
            && self.extra_middle == other.extra_middle
            && self.first_turn == other.first_turn
            && self.last_turn == other.last_turn
    }
}

/// Whole extra turns considered in the middle and at the end.
const EXTRA_TURNS: [i32; 5] = [0, -1, 1, -2, 2];
/// Extra turns considered at the start, besides those that a winding asked for needs.
const MOST_EXTRA: i32 = 2;
/// Most total turn considered: |θ_T + 2πk − θ_0| ≤ 4π (and a rest for fixed windings beyond).
pub(crate) const LARGEST_TURN: f64 = 2.0 * TAU + 1e-9;
/// Samples a turn when reading off the thrust along a sweep.
const SAMPLES: f64 = 48.0;
/// Fixed-point iterations for the time a bang in the middle takes.
const WINDOW_ITERATIONS: usize = 12;

/// Everything the starts share.
struct Frame<'a> {
    problem: &'a Problem,
    costate: Costate<f64>,
    duration: f64,
    mu: f64,
}

/// Angle in (−π, π].
pub(crate) fn wrap(angle: f64) -> f64 {
    let turns = libm::ceil((angle - PI) / TAU);
    angle - turns * TAU
}

/// Starts in the order of their estimates. `turns` fixes the winding; otherwise all are considered.
pub(crate) fn starts(
    problem: &Problem,
    relaxed: &Relaxation,
    turns: Option<i32>,
    mu: f64,
) -> Vec<Start, MAX_STARTS> {
    let frame = Frame::new(problem, relaxed, mu);
    let (costate, t) = (frame.costate, frame.duration);
    let arc = costate.arc(0.0);
    let first = wrap(costate.singular_angle(0.0) - problem.from[4]);
    let arc_turn = arc.angle_at(t);
    // The end angle without winding, seen from where the arc ends.
    let arrive = problem.from[4] + first + arc_turn;
    let last = wrap(problem.to[4] - arrive);
    let nearest = nearest_time(&costate, t);
    let interior = nearest > 0.02 * t && nearest < 0.98 * t;

    let norm = |time: f64| libm::hypot(costate.p2(time), costate.p4(time));
    let (norm_0, norm_t) = (norm(0.0), norm(t));
    let base = problem.turn();
    // The winding without extra turns.
    let nearest = libm::round((first + arc_turn + last - base) / TAU) as i32;
    let extra = turns.map_or(0, |wanted| wanted - nearest);
    let mut list: Vec<Start, MAX_STARTS> = Vec::new();
    for extra_mid in EXTRA_TURNS {
        if extra_mid != 0 && !interior {
            continue;
        }
        let mid_cost = frame.middle(extra_mid).map_or(0.0, |m| m.cost);
        for extra_first in extra.min(0) - MOST_EXTRA..=extra.max(0) + MOST_EXTRA {
            let first_turn = first + f64::from(extra_first) * TAU;
            let first_cost = norm_0 * frame.turn_cost(first_turn.abs());
            // A winding that is asked for leaves no choice at the end.
            let (own, all) = match turns {
                Some(wanted) => ([wanted - nearest - extra_mid - extra_first], EXTRA_TURNS),
                None => ([0], EXTRA_TURNS),
            };
            for extra_last in if turns.is_some() { &own[..] } else { &all[..] } {
                let last_turn = last + f64::from(*extra_last) * TAU;
                let total = first_turn + arc_turn + f64::from(extra_mid) * TAU + last_turn;
                let k = nearest + extra_first + extra_mid + extra_last;
                if turns.is_none() && total.abs() > LARGEST_TURN {
                    continue;
                }
                let estimate = t + mid_cost + first_cost + norm_t * frame.turn_cost(last_turn.abs());
                let position = list.iter().position(|s| estimate < s.estimate).unwrap_or(list.len());
                if position >= MAX_STARTS {
                    continue;
                }
                if list.is_full() {
                    list.pop();
                }
                // There is room: one was just dropped if there was none.
                let _ = list.insert(
                    position,
                    Start { turns: k, estimate, first_turn, last_turn, extra_middle: extra_mid },
                );
            }
        }
    }
    list
}

/// The iterate that a start stands for.
pub(crate) fn build(problem: &Problem, relaxed: &Relaxation, start: &Start, mu: f64) -> Option<Candidate> {
    let frame = Frame::new(problem, relaxed, mu);
    frame.build(relaxed, start.first_turn, start.extra_middle, start.last_turn)
}

/// When |p| is smallest on [0, T].
fn nearest_time(costate: &Costate<f64>, t: f64) -> f64 {
    let square = costate.c1 * costate.c1 + costate.c3 * costate.c3;
    if square > 0.0 {
        ((costate.c1 * costate.c2 + costate.c3 * costate.c4) / square).clamp(0.0, t)
    } else {
        0.0
    }
}

/// A bang in the middle of the arc.
#[derive(Clone, Copy, Debug)]
struct Middle {
    /// When it begins and ends in the relaxed time.
    begin: f64,
    end: f64,
    /// Turn, signed.
    turn: f64,
    /// θ where it begins.
    angle: f64,
    cost: f64,
}

impl<'a> Frame<'a> {
    fn new(problem: &'a Problem, relaxed: &Relaxation, mu: f64) -> Self {
        Self { problem, costate: Costate::from_array(relaxed.c), duration: relaxed.duration, mu }
    }

    /// ∫(u_max − u_T cos α) dα from thrust along −p to an angle β away from it.
    fn turn_cost(&self, beta: f64) -> f64 {
        let (low, high) = (self.problem.u_min, self.problem.u_max);
        let whole = libm::floor(beta / TAU);
        let rest = beta - whole * TAU;
        let s = libm::sin(rest);
        let pull = if rest < FRAC_PI_2 {
            high * s
        } else if rest < 3.0 * FRAC_PI_2 {
            high + low * (s - 1.0)
        } else {
            high - 2.0 * low + high * (s + 1.0)
        };
        high * beta - pull - whole * (2.0 * high - 2.0 * low)
    }

    /// The bang in the middle of the arc with a number of extra whole turns; none where the arc is slow enough.
    fn middle(&self, extra: i32) -> Option<Middle> {
        let arc = self.costate.arc(0.0);
        if extra == 0 && arc.peak_rate(self.duration) * self.mu <= 1.0 {
            return None;
        }
        let nearest = nearest_time(&self.costate, self.duration);
        // The bang leaves the arc at nearest − w and meets it again at nearest + w; while it lasts the arc's direction
        // turns too, and the two must agree: 2w = μ |turn(w)|. The iteration contracts from above.
        let whole = f64::from(extra) * TAU;
        let peak = arc.advanced(nearest);
        let turn_within = |w: f64| {
            let before = nearest.min(w);
            let after = (self.duration - nearest).min(w);
            -peak.angle_at(-before) + peak.angle_at(after) + whole
        };
        let mut half = 0.5 * self.mu * (PI + whole.abs());
        for _ in 0..WINDOW_ITERATIONS {
            half = 0.5 * self.mu * turn_within(half).abs();
        }
        let begin = (nearest - half).max(0.0);
        let end = (nearest + half).min(self.duration);
        let angle = self.costate.singular_angle(begin);
        let turn = turn_within(half);
        // The price at the real rate limit: ∫(u_max|p| + u_T Φ_T) dt while θ turns through the middle.
        let steps = (turn.abs() / TAU * SAMPLES) as usize + 2;
        let mut cost = 0.0;
        for i in 0..steps {
            let a = (i as f64 + 0.5) / steps as f64;
            let time = (nearest + (a - 0.5) * turn.abs()).clamp(0.0, self.duration);
            let phi_t = self.costate.phi_t(time, angle + a * turn);
            let u = if phi_t > 0.0 { self.problem.u_min } else { self.problem.u_max };
            let norm = libm::hypot(self.costate.p2(time), self.costate.p4(time));
            cost += (self.problem.u_max * norm + u * phi_t) * turn.abs() / steps as f64;
        }
        Some(Middle { begin, end, turn, angle, cost })
    }

    /// Appends a bang of `turn` that starts at `angle` and at time `begin`, divided by the sign of Φ_T.
    fn sweep(&self, candidate: &mut Candidate, angle: f64, turn: f64, begin: f64) -> bool {
        let rate = turning(turn);
        let size = turn.abs();
        let steps = (size / TAU * SAMPLES) as usize + 1;
        let phi_t = |a: f64| {
            let time = (begin + self.mu * a).clamp(0.0, self.duration);
            self.costate.phi_t(time, angle + if turn < 0.0 { -a } else { a })
        };
        let level = |phi: f64| if phi > 0.0 { ThrustLevel::Min } else { ThrustLevel::Max };
        let (mut from, mut previous, mut before) = (0.0, 0.0, phi_t(0.0));
        for i in 1..=steps {
            let a = size * i as f64 / steps as f64;
            let now = phi_t(a);
            if level(now) != level(before) {
                let crossing = previous + (a - previous) * before / (before - now);
                if crossing > from && !candidate.push(Piece::bang(rate, level(before), crossing - from)) {
                    return false;
                }
                from = crossing.max(from);
            }
            (previous, before) = (a, now);
        }
        candidate.push(Piece::bang(rate, level(before), size - from))
    }

    fn build(
        &self,
        relaxed: &Relaxation,
        first_turn: f64,
        extra_middle: i32,
        last_turn: f64,
    ) -> Option<Candidate> {
        let mut candidate = Candidate { pieces: Vec::new(), c: relaxed.c };
        let start = self.problem.from[4];
        // The relaxed times are kept, so that p(t) points where the arcs do; the bangs shorten the arcs next to them.
        let (first_time, last_time) = (self.mu * first_turn.abs(), self.mu * last_turn.abs());
        let floor = 0.05 * self.duration * self.mu;
        let mut ok = self.sweep(&mut candidate, start, first_turn, 0.0);
        if let Some(m) = self.middle(extra_middle) {
            ok &= candidate.push(Piece::arc((m.begin - first_time).max(floor)));
            ok &= self.sweep(&mut candidate, m.angle, m.turn, m.begin);
            ok &= candidate.push(Piece::arc((self.duration - last_time - m.end).max(floor)));
        } else {
            ok &= candidate.push(Piece::arc((self.duration - first_time - last_time).max(floor)));
        }
        // Only the direction counts here, not the winding.
        let angle = self.costate.singular_angle(self.duration);
        ok &= self.sweep(&mut candidate, angle, last_turn, self.duration - self.mu * last_turn.abs());
        (ok && candidate.normalise()).then_some(candidate)
    }
}

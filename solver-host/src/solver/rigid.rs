//! Maneuvers with fewer free numbers than end conditions: one to four bangs, an arc, an arc and a bang.
//!
//! The states they reach have no volume, so random requests do not meet them; but every optimum's own first and last
//! pieces are of this kind (Bellman), and whoever plans anew along a maneuver asks for them. Their costate is not
//! unique, so the square system is singular and the continuation loses its way just before the real rate limit. Here the
//! few numbers are fitted to the end state directly by damped least squares, and a costate is found afterwards:
//! from the arc's shape where there is an arc, c = 0 where the vehicle turns one way all the time, and otherwise a point
//! of the polyhedron that the laws (16) and (20), linear in c, leave.

use mintime_shared::model::{RateMode, State, ThrustLevel};
use mintime_shared::motion::{Arc, advance, bang, singular};
use mintime_shared::real::Real;

use super::dual::Dual;
use super::events::trace;
use super::polyhedron::{Law, least_costate};
use super::problem::Problem;
use super::relax::Relaxation;
use super::starts::wrap;
use super::structure::{Candidate, Piece, opposite, turning};

/// Bangs in a fitted sequence; fewer come out where lengths vanish.
const BANGS: usize = 4;
/// Numbers fitted.
const NUMBERS: usize = 5;
/// Equations: five end states, and Φ_T = 0 where the thrust switches before an arc.
const EQUATIONS: usize = 6;
/// Most iterations of the descent, and of those the ones after which it must have come near.
const ITERATIONS: usize = 60;
const PROBATION: usize = 12;
/// Undamped iterations after it.
const HOMING: usize = 15;
/// Largest change of the arc's drift, times its length, in one of them.
const LARGEST_DRIFT_STEP: f64 = 0.3;
/// Damping, of columns scaled to one: of the first step, the least that is more than none, the one below which a small
/// gain means that the descent is over, and the one at which it has failed.
const FIRST_DAMPING: f64 = 1e-3;
const LEAST_DAMPING: f64 = 1e-14;
const STALLED: f64 = 1e-6;
const LARGEST_DAMPING: f64 = 1e6;
/// Weighted misses: given up beyond this on probation; near enough for undamped steps; done; still accepted.
const HOPELESS: f64 = 0.03;
const NEAR: f64 = 0.02;
const ARRIVED: f64 = 1e-14;
const ACCEPTED: f64 = 1e-11;
/// Lengths up to this are zero.
const VANISHED: f64 = 1e-9;
/// Samples of each piece at which the laws are asked for.
const SAMPLES: usize = 16;

/// What is fitted: the lengths of the pieces, then the arc's two numbers.
#[derive(Clone, Copy, Debug)]
struct Shape {
    pieces: [Piece; BANGS],
    count: usize,
    arc: bool,
}

/// Calls `found` with every maneuver of this kind that arrives, faster than `slower_than`.
///
/// `deep` also tries bangs in both directions, some thirty sequences.
pub(crate) fn rigid(
    problem: &Problem,
    relaxed: &Relaxation,
    slower_than: f64,
    deep: bool,
    mut found: impl FnMut(Candidate),
) {
    let turn = problem.turn();
    for thrust in [ThrustLevel::Max, ThrustLevel::Min] {
        let mut pieces = [Piece::bang(turning(turn), thrust, 0.25 * turn.abs()); BANGS];
        for piece in pieces.iter_mut().skip(1).step_by(2) {
            piece.inputs.thrust = other(thrust);
        }
        let shape = Shape { pieces, count: BANGS, arc: false };
        if turn != 0.0 && turn.abs() < slower_than {
            attempt(problem, shape, [0.0; 2], slower_than, &mut found);
        }
    }
    if !deep {
        return;
    }
    with_arc(problem, relaxed, slower_than, &mut found);
    // Backwards in time an arc and a bang are a bang and an arc.
    let reversed = problem.reversed();
    let [c1, c2, c3, c4] = relaxed.c;
    let t = relaxed.duration;
    let seen_back = Relaxation { c: [-c1, c2 - c1 * t, -c3, c4 - c3 * t], ..*relaxed };
    with_arc(&reversed, &seen_back, slower_than, &mut |mut candidate: Candidate| {
        candidate.reverse(candidate.duration(1.0));
        found(candidate);
    });
    both_ways(problem, relaxed, slower_than, &mut found);
}

/// One or two bangs (or none) and an arc, and a bang after it.
fn with_arc(problem: &Problem, relaxed: &Relaxation, slower_than: f64, found: &mut impl FnMut(Candidate)) {
    let costate = mintime_shared::minimum_principle::Costate::from_array(relaxed.c);
    let onto_arc = wrap(costate.singular_angle(0.0) - problem.from[4]);
    let arc = costate.arc(0.0);
    // A long bang leaves little of the relaxed solution; then the arc hardly turns.
    for (turn, numbers) in [(onto_arc, [arc.rate, arc.drift]), (problem.turn(), [0.0; 2])] {
        let bang = |thrust| Piece::bang(turning(turn), thrust, turn.abs());
        let rest = Piece::arc((relaxed.duration - turn.abs()).max(0.1 * relaxed.duration));
        let mut attempt = |pieces: [Piece; 3], count| {
            let pieces = [pieces[0], pieces[1], pieces[2], pieces[0]];
            attempt(problem, Shape { pieces, count, arc: true }, numbers, slower_than, found);
        };
        let first = bang(ThrustLevel::Max);
        attempt([first, rest, first], 2);
        let half = |thrust| Piece { length: 0.5 * turn.abs(), ..bang(thrust) };
        attempt([half(ThrustLevel::Min), half(ThrustLevel::Max), rest], 3);
        let left = problem.turn() - turn;
        for sign in [-1.0, 1.0] {
            let last = Piece::bang(turning(sign), ThrustLevel::Max, (sign * left).max(0.1));
            attempt([first, rest, last], 3);
        }
    }
}

/// Bangs in both directions.
fn both_ways(problem: &Problem, relaxed: &Relaxation, slower_than: f64, found: &mut impl FnMut(Candidate)) {
    let turn = problem.turn();
    let total = relaxed.duration.max(turn.abs());
    for first in 0..4_u8 {
        let rate = if first & 1 == 0 { RateMode::Plus } else { RateMode::Minus };
        let thrust = if first & 2 == 0 { ThrustLevel::Max } else { ThrustLevel::Min };
        // Each bit says whether the next switch changes the rate or the thrust; 0 would turn one way only.
        for switches in 1..8_u8 {
            let mut piece = Piece::bang(rate, thrust, 0.0);
            let mut pieces = [piece; BANGS];
            for (i, next) in pieces.iter_mut().enumerate().skip(1) {
                if switches & (1 << (i - 1)) != 0 {
                    piece.inputs.rate = opposite(piece.inputs.rate);
                } else {
                    piece.inputs.thrust = other(piece.inputs.thrust);
                }
                *next = piece;
            }
            // The turns one way and the other add up to the total, their difference is the turn asked for.
            for stretch in STRETCHES {
                for piece in &mut pieces {
                    let share = 0.5 * (stretch * total + piece.sign() * turn);
                    let same = pieces_with(switches, piece.sign(), rate);
                    piece.length = share / f64::from(same);
                }
                let shape = Shape { pieces, count: BANGS, arc: false };
                attempt(problem, shape, [0.0; 2], slower_than, found);
            }
        }
    }
}

/// First guesses of T over its lower bound.
const STRETCHES: [f64; 2] = [1.1, 2.0];

/// How many of the four pieces turn towards `sign`.
fn pieces_with(switches: u8, sign: f64, first: RateMode) -> u8 {
    let mut rate = if first == RateMode::Minus { -1.0 } else { 1.0 };
    let mut count = u8::from(rate == sign);
    for i in 0..BANGS - 1 {
        if switches & (1 << i) != 0 {
            rate = -rate;
        }
        count += u8::from(rate == sign);
    }
    count.max(1)
}

fn other(thrust: ThrustLevel) -> ThrustLevel {
    match thrust {
        ThrustLevel::Min => ThrustLevel::Max,
        ThrustLevel::Max => ThrustLevel::Min,
    }
}

/// Fits one shape, finds its costate and hands it over.
fn attempt(
    problem: &Problem,
    mut shape: Shape,
    arc: [f64; 2],
    slower_than: f64,
    found: &mut impl FnMut(Candidate),
) {
    let Some(arc) = fit(problem, &mut shape, arc) else { return };
    // What has vanished goes, and what then meets its like joins it; what is left is fitted again, now regular.
    let before = shape.count;
    shape.tidy();
    let arc = if shape.count < before {
        let Some(arc) = fit(problem, &mut shape, arc) else { return };
        arc
    } else {
        arc
    };
    let duration: f64 = shape.pieces[..shape.count].iter().map(|p| p.length).sum();
    if shape.count == 0 || duration >= slower_than {
        return;
    }
    let mut candidate = Candidate { pieces: heapless::Vec::new(), c: [0.0; 4] };
    if !shape.pieces[..shape.count].iter().all(|p| p.length > 0.0 && candidate.push(*p)) {
        return;
    }
    let one_way = candidate.pieces.iter().all(|p| !p.is_arc() && p.sign() == candidate.pieces[0].sign());
    let c = if shape.arc {
        costate_of_arc(problem, &candidate, arc)
    } else if one_way {
        Some([0.0; 4])
    } else {
        costate_of_bangs(problem, &candidate)
    };
    if let Some(c) = c {
        candidate.c = c;
        found(candidate);
    }
}

impl Shape {
    fn tidy(&mut self) {
        let mut kept = 0;
        for i in 0..self.count {
            let piece = self.pieces[i];
            if piece.length <= VANISHED {
                continue;
            }
            if kept > 0 && self.pieces[kept - 1].inputs == piece.inputs {
                self.pieces[kept - 1].length += piece.length;
            } else {
                self.pieces[kept] = piece;
                kept += 1;
            }
        }
        self.arc = self.pieces[..kept].iter().any(Piece::is_arc);
        self.count = kept;
    }

    /// The numbers that are fitted: all lengths, then the arc's two.
    fn numbers(&self) -> usize {
        self.count + if self.arc { 2 } else { 0 }
    }

    /// Where the maneuver ends, and Φ_T/|p| at a thrust switch before the arc, with derivatives.
    fn end(&self, problem: &Problem, values: &[f64; NUMBERS]) -> [Dual<NUMBERS>; EQUATIONS] {
        let mut state = State::from_array(problem.from.map(Dual::constant));
        let one = Dual::constant(1.0);
        let mut phi_t = Dual::constant(0.0);
        for (i, piece) in self.pieces[..self.count].iter().enumerate() {
            let length = Dual::variable(values[i], i);
            let turn = if piece.is_arc() {
                let (a, b) = (self.count, self.count + 1);
                singular(
                    Arc { rate: Dual::variable(values[a], a), drift: Dual::variable(values[b], b) },
                    length,
                )
            } else {
                bang(Dual::constant(piece.sign()), length)
            };
            let thrust = Dual::constant(problem.thrust(piece.inputs.thrust));
            if i > 0 && piece.is_arc() && self.pieces[0].inputs.thrust == ThrustLevel::Min {
                // p = −n at the entry; a time σ earlier it was p + σ (c1, c3), and the angle was less by the turn.
                let (a, b) = (self.count, self.count + 1);
                let sigma = Dual::variable(values[i - 1], i - 1);
                let (sin, cos) = (sigma * Dual::constant(self.pieces[i - 1].sign())).sin_cos();
                let (rate, drift) = (Dual::variable(values[a], a), Dual::variable(values[b], b));
                phi_t = (one + drift * sigma) * cos + rate * sigma * sin;
            }
            state = advance(state, thrust, one, length, &turn);
        }
        let [x, vx, z, vz, theta] = state.to_array();
        [x, vx, z, vz, theta, phi_t]
    }
}

/// What is fitted, for one shape: weighted misses and their derivatives.
struct Fit<'a> {
    problem: &'a Problem,
    shape: &'a Shape,
    weights: [f64; EQUATIONS],
    /// Numbers in use.
    count: usize,
}

/// Misses and columns of derivatives at one iterate.
struct Evaluation {
    misses: [f64; EQUATIONS],
    columns: [[f64; EQUATIONS]; NUMBERS],
    square: f64,
}

/// Fits a shape in place: the lengths (kept from below zero) and the arc's numbers, which it returns where it arrives.
///
/// First by Levenberg-Marquardt without the drift, since that of a short arc hardly matters; then by Gauss-Newton with
/// it. Lengths and drift trade places along a narrow curved valley, in which every descent crawls; but at its end
/// nothing is missed, so undamped steps converge quadratically, over ridges if need be.
fn fit(problem: &Problem, shape: &mut Shape, arc: [f64; 2]) -> Option<[f64; 2]> {
    let count = shape.numbers();
    if count > NUMBERS || count == 0 {
        return None;
    }
    let mut values = [0.0; NUMBERS];
    for (value, piece) in values.iter_mut().zip(&shape.pieces[..shape.count]) {
        *value = piece.length;
    }
    if shape.arc {
        values[shape.count..].iter_mut().zip(arc).for_each(|(v, a)| *v = a);
    }
    let duration: f64 = shape.pieces[..shape.count].iter().map(|p| p.length.abs()).sum();
    let velocity = 1.0 / (problem.u_max * duration.max(1e-3));
    let position = velocity / duration.max(1e-3);
    let weights = [position, velocity, position, velocity, 1.0, 1.0];
    let fit = Fit { problem, shape, weights, count };
    let free = if shape.arc { count - 1 } else { count };
    let mut square = fit.descend(&mut values, free);
    if shape.arc && square < NEAR * NEAR {
        square = fit.home_in(&mut values);
    }
    if square.is_nan() || square > ACCEPTED * ACCEPTED {
        return None;
    }
    for (piece, value) in shape.pieces.iter_mut().zip(&values) {
        piece.length = *value;
    }
    Some(if shape.arc { [values[shape.count], values[shape.count + 1]] } else { [0.0; 2] })
}

impl Fit<'_> {
    fn evaluate(&self, values: &[f64; NUMBERS]) -> Evaluation {
        let [x, vx, z, vz, theta] = self.problem.to;
        let target = [x, vx, z, vz, theta, 0.0];
        let end = self.shape.end(self.problem, values);
        let misses: [f64; EQUATIONS] = core::array::from_fn(|k| self.weights[k] * (end[k].value - target[k]));
        let columns = core::array::from_fn(|i| core::array::from_fn(|k| self.weights[k] * end[k].grad[i]));
        Evaluation { misses, columns, square: misses.iter().map(|m| m * m).sum() }
    }

    /// Least-squares step in the first `free` numbers.
    fn step(&self, at: &Evaluation, free: usize, damping: f64) -> [f64; NUMBERS] {
        // Columns scaled to one: the shape of a short arc moves the end a million times less than a length does.
        let size =
            at.columns.map(|c| libm::sqrt(c.iter().map(|v| v * v).sum::<f64>()).max(f64::MIN_POSITIVE));
        let mut columns = at.columns;
        for (column, size) in columns.iter_mut().zip(size) {
            column.iter_mut().for_each(|v| *v /= size);
        }
        let mut step = least_squares(&columns, free, &at.misses, damping);
        for (s, size) in step.iter_mut().zip(size) {
            *s /= size;
        }
        step
    }

    fn shifted(&self, values: &[f64; NUMBERS], step: &[f64; NUMBERS]) -> [f64; NUMBERS] {
        core::array::from_fn(|i| {
            let sum = values[i] + step[i];
            if i < self.shape.count { sum.max(0.0) } else { sum }
        })
    }

    /// Levenberg-Marquardt in the first `free` numbers. The square of the miss that is left.
    fn descend(&self, values: &mut [f64; NUMBERS], free: usize) -> f64 {
        let mut at = self.evaluate(values);
        let mut damping = FIRST_DAMPING;
        for iteration in 0..ITERATIONS {
            if at.square < ARRIVED * ARRIVED || at.square.is_nan() {
                break;
            }
            if iteration == PROBATION && at.square > HOPELESS * HOPELESS {
                break;
            }
            let trial = self.shifted(values, &self.step(&at, free, damping));
            let next = self.evaluate(&trial);
            if next.square < at.square {
                let stalled = next.square > 0.5 * at.square;
                (*values, at) = (trial, next);
                damping *= 0.1;
                if stalled && damping < STALLED {
                    break;
                }
            } else {
                damping = (8.0 * damping).max(LEAST_DAMPING);
                if damping > LARGEST_DAMPING {
                    break;
                }
            }
        }
        at.square
    }

    /// Gauss-Newton in all numbers, up or down. The square of the miss at the best point, which it leaves in `values`.
    fn home_in(&self, values: &mut [f64; NUMBERS]) -> f64 {
        let drift = self.count - 1;
        let mut here = *values;
        let mut at = self.evaluate(&here);
        let mut best = at.square;
        for _ in 0..HOMING {
            let mut step = self.step(&at, self.count, 0.0);
            let length = self.shape.pieces[..self.shape.count].iter().zip(&here).find(|(p, _)| p.is_arc());
            let largest = LARGEST_DRIFT_STEP / length.map_or(1.0, |(_, length)| length.max(0.1));
            if step[drift].abs() > largest {
                // The rest makes the best of what the drift is allowed.
                let allowed = step[drift].clamp(-largest, largest);
                let misses = core::array::from_fn(|k| at.misses[k] + at.columns[drift][k] * allowed);
                step = self.step(&Evaluation { misses, ..at }, drift, 0.0);
                step[drift] = allowed;
            }
            here = self.shifted(&here, &step);
            at = self.evaluate(&here);
            if at.square.is_nan() || at.square > NEAR * NEAR {
                break;
            }
            if at.square < best {
                (*values, best) = (here, at.square);
                if best < ARRIVED * ARRIVED {
                    break;
                }
            }
        }
        best
    }
}

/// The x that minimises |A x + b|² + damping |x|², by modified Gram-Schmidt on the columns: A'A would square the
/// condition, which short arcs make large.
fn least_squares(
    columns: &[[f64; EQUATIONS]; NUMBERS],
    count: usize,
    b: &[f64; EQUATIONS],
    damping: f64,
) -> [f64; NUMBERS] {
    const ROWS: usize = EQUATIONS + NUMBERS;
    let root = libm::sqrt(damping);
    let mut q = [[0.0; ROWS]; NUMBERS];
    for (i, column) in columns.iter().enumerate() {
        q[i][..EQUATIONS].copy_from_slice(column);
        q[i][EQUATIONS + i] = root;
    }
    let mut rest = [0.0; ROWS];
    rest[..EQUATIONS].copy_from_slice(b);
    let dot = |a: &[f64; ROWS], b: &[f64; ROWS]| a.iter().zip(b).map(|(x, y)| x * y).sum::<f64>();
    let mut r = [[0.0; NUMBERS]; NUMBERS];
    let mut y = [0.0; NUMBERS];
    for i in 0..count {
        let norm = libm::sqrt(dot(&q[i], &q[i])).max(f64::MIN_POSITIVE);
        r[i][i] = norm;
        q[i] = q[i].map(|v| v / norm);
        let unit = q[i];
        for j in i + 1..count {
            let along = dot(&unit, &q[j]);
            r[i][j] = along;
            q[j].iter_mut().zip(unit).for_each(|(v, u)| *v -= along * u);
        }
        y[i] = -dot(&unit, &rest);
        rest.iter_mut().zip(unit).for_each(|(v, u)| *v += y[i] * u);
    }
    let mut x = [0.0; NUMBERS];
    for i in (0..count).rev() {
        let sum: f64 = (i + 1..count).map(|j| r[i][j] * x[j]).sum();
        x[i] = (y[i] - sum) / r[i][i];
    }
    x
}

/// c from the arc's two numbers and h = 0 on it. `None` where p would not point against the thrust.
fn costate_of_arc(problem: &Problem, candidate: &Candidate, [rate, drift]: [f64; 2]) -> Option<[f64; 4]> {
    let index = candidate.pieces.iter().position(Piece::is_arc)?;
    let node = trace(problem, 1.0, &Candidate { c: [0.0, 0.0, 0.0, -1.0], ..candidate.clone() })[index];
    let [_, vx, _, vz, theta] = node.state;
    let (s, c) = libm::sincos(theta);
    // (p2, p4) = −λ (s, c) at the entry, (c1, c3) = drift·p + rate·p rotated by a quarter turn, and h = 0.
    let (along, across) = (drift * s - rate * c, drift * c + rate * s);
    let inverse = along * vx + across * vz + problem.u_max - c;
    if inverse.is_nan() || inverse <= 0.0 {
        return None;
    }
    let lambda = 1.0 / inverse;
    let (c1, c3) = (-lambda * along, -lambda * across);
    Some([c1, -lambda * s + c1 * node.t, c3, -lambda * c + c3 * node.t])
}

/// A costate that satisfies the laws of bangs, if there is one.
fn costate_of_bangs(problem: &Problem, candidate: &Candidate) -> Option<[f64; 4]> {
    let mut list: heapless::Vec<Law, { BANGS * (2 * SAMPLES + 3) }> = heapless::Vec::new();
    let nodes = trace(problem, 1.0, candidate);
    let switch_of =
        |rate: bool, t: f64| {
            let pairs = candidate.pieces.iter().zip(candidate.pieces.iter().skip(1)).zip(&nodes[1..]);
            pairs
                .filter(|((a, b), _)| {
                    if rate { a.inputs.rate != b.inputs.rate } else { a.inputs.thrust != b.inputs.thrust }
                })
                .map(|(_, node)| (node.t - t).abs())
                .fold(1.0, f64::min)
        };
    for (i, piece) in candidate.pieces.iter().enumerate() {
        let thrust = problem.thrust(piece.inputs.thrust);
        let sign = if piece.inputs.thrust == ThrustLevel::Max { -1.0 } else { 1.0 };
        let node = nodes[i];
        if let Some(before) = i.checked_sub(1).map(|j| candidate.pieces[j]) {
            let (h, phi_t) = laws(node.t, &node.state, thrust);
            let (row, offset) = if before.inputs.rate != piece.inputs.rate { h } else { phi_t };
            list.push(Law { row, offset, equal: true, room: 0.0 }).ok()?;
        }
        for j in 0..=SAMPLES {
            let tau = piece.length * j as f64 / SAMPLES as f64;
            let turn = bang(piece.sign(), tau);
            let state = advance(State::from_array(node.state), thrust, 1.0, tau, &turn);
            let t = node.t + tau;
            let ((row, offset), phi_t) = laws(t, &state.to_array(), thrust);
            list.push(Law { row, offset, equal: false, room: switch_of(true, t) }).ok()?;
            let row = phi_t.0.map(|r| sign * r);
            list.push(Law { row, offset: phi_t.1, equal: false, room: switch_of(false, t) }).ok()?;
        }
    }
    // As much room as there is between the samples; where a switching function leaves zero it grows with the time.
    ROOM.iter().find_map(|room| least_costate(&list, *room))
}

/// Distances that the inequalities keep, relative to the time from the next switch, most first.
const ROOM: [f64; 5] = [1e-2, 1e-3, 1e-4, 1e-5, 1e-7];

/// h and Φ_T as (row, offset): offset + row·c.
type Affine = ([f64; 4], f64);

fn laws(t: f64, state: &[f64; 5], thrust: f64) -> (Affine, Affine) {
    let (s, c) = libm::sincos(state[4]);
    let (a, b) = (thrust * s, thrust * c - 1.0);
    (([state[1] - t * a, a, state[3] - t * b, b], 1.0), ([-t * s, s, -t * c, c], 0.0))
}

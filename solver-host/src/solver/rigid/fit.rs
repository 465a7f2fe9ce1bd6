//! Lengths and an arc's two numbers fitted to the end state by damped least squares.

use mintime_shared::model::{State, ThrustLevel};
use mintime_shared::motion::{Arc, advance, bang, singular};
use mintime_shared::real::Real;

use super::super::dual::Dual;
use super::super::problem::Problem;
use super::super::structure::Piece;
use super::{EQUATIONS, NUMBERS, Shape, VANISHED};

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
impl Shape {
    pub(super) fn tidy(&mut self) {
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
pub(super) fn fit(problem: &Problem, shape: &mut Shape, arc: [f64; 2]) -> Option<[f64; 2]> {
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

//! The square system of one structure and its Jacobian, propagated segment by segment in closed form.
//!
//! Unknowns: the length of each piece and c. Equations: five end states; H-condition h = 0 at each rate switch between
//! bangs; Φ_T = 0 at each thrust switch; at each entry of a singular arc h = 0 and Φ̇_R = 0. Leaving an arc is free,
//! because h stays zero along it. One more column carries the derivative along a [`Direction`] of the data, and another
//! the residual, so that a single elimination yields the Newton step and the tangent of the solution path.

use mintime_shared::model::ThrustLevel;
use mintime_shared::motion::{Arc, Turn, bang, singular};

use super::conditions::{ArcData, boundary, gradient};
use super::dual::Dual;
use super::problem::{Direction, Problem};
use super::structure::{Candidate, MAX_UNKNOWNS, Piece};

/// Columns: unknowns, then the direction of the data, then the residual.
const WIDTH: usize = MAX_UNKNOWNS + 2;

type Row = [f64; WIDTH];

/// Where a piece begins.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Node {
    /// Dimensionless time.
    pub(crate) t: f64,
    /// (x, ẋ, z, ż, θ).
    pub(crate) state: [f64; 5],
}

/// Residual and Jacobian of the square system at one iterate.
#[derive(Clone, Debug)]
pub(crate) struct Linearised {
    size: usize,
    rows: [Row; MAX_UNKNOWNS],
    /// Weighted largest residual.
    pub(crate) norm: f64,
}

/// Derivatives of time and state with respect to all columns.
struct Columns {
    t: Row,
    state: [Row; 5],
}

impl Linearised {
    pub(crate) fn new() -> Self {
        Self { size: 0, rows: [[0.0; WIDTH]; MAX_UNKNOWNS], norm: f64::INFINITY }
    }

    /// Evaluates the system for `candidate` at the inverse rate limit `mu`.
    ///
    /// False where the structure is not square (a boundary that no extremal has), which the caller treats as a failure
    /// of this path.
    pub(crate) fn evaluate(
        &mut self,
        problem: &Problem,
        mu: f64,
        candidate: &Candidate,
        direction: &Direction,
    ) -> bool {
        let pieces = &candidate.pieces;
        let n = pieces.len();
        let unknowns = candidate.unknowns();
        let along = unknowns;
        self.size = unknowns;
        let [c1, _, c3, _] = candidate.c;
        let duration = candidate.duration(mu).max(f64::MIN_POSITIVE);
        let velocity_weight = 1.0 / (problem.u_max * duration);
        let position_weight = velocity_weight / duration;

        let mut columns = Columns { t: [0.0; WIDTH], state: [[0.0; WIDTH]; 5] };
        for (row, d) in columns.state.iter_mut().zip(direction.from) {
            row[along] = d;
        }
        let mut node = Node { t: 0.0, state: problem.from };
        let mut next_row = 5;
        let mut norm = 0.0_f64;
        for (i, piece) in pieces.iter().enumerate() {
            let (sin, cos) = libm::sincos(node.state[4]);
            if i > 0 {
                let before = pieces[i - 1];
                let conditions = boundary(&before, piece);
                for condition in conditions {
                    let Some(kind) = condition else { continue };
                    if next_row >= unknowns {
                        return false;
                    }
                    let level = before.inputs.thrust;
                    let thrust = problem.thrust(level);
                    let thrust_slope = thrust_direction(direction, &before);
                    let g = gradient(kind, &candidate.c, &node, thrust, (sin, cos));
                    let row = &mut self.rows[next_row];
                    for (j, value) in row.iter_mut().enumerate().take(unknowns + 1) {
                        *value = g.vx * columns.state[1][j]
                            + g.vz * columns.state[3][j]
                            + g.theta * columns.state[4][j]
                            + g.t * columns.t[j];
                    }
                    for k in 0..4 {
                        row[n + k] += g.c[k];
                    }
                    row[along] += g.thrust * thrust_slope;
                    row[along + 1] = g.value;
                    norm = norm.max(g.value.abs());
                    next_row += 1;
                }
            }
            let thrust = problem.thrust(piece.inputs.thrust);
            let thrust_slope = thrust_direction(direction, piece);
            if piece.is_arc() {
                let arc_data = ArcData::new(&candidate.c, node.t);
                let dual = singular(
                    Arc {
                        rate: Dual::<2>::variable(arc_data.rate, 0),
                        drift: Dual::variable(arc_data.drift, 1),
                    },
                    Dual::constant(piece.length),
                );
                let turn = value_of(&dual);
                // Derivatives of the arc's two numbers with respect to every column.
                let mut by_rate = [0.0; WIDTH];
                let mut by_drift = [0.0; WIDTH];
                for j in 0..=unknowns {
                    by_rate[j] = arc_data.rate_by_t * columns.t[j];
                    by_drift[j] = arc_data.drift_by_t * columns.t[j];
                }
                for k in 0..4 {
                    by_rate[n + k] += arc_data.rate_by_c[k];
                    by_drift[n + k] += arc_data.drift_by_c[k];
                }
                let moved = motion(&turn, thrust, (sin, cos));
                columns.carry(piece.length, &moved, unknowns + 1);
                for (index, by) in [(0, &by_rate), (1, &by_drift)] {
                    let slope = grad_of(&dual, index);
                    let m = motion(&slope, thrust, (sin, cos));
                    for (row, factor) in columns.state.iter_mut().zip([m.x, m.vx, m.z, m.vz, slope.angle]) {
                        for (value, b) in row.iter_mut().zip(by).take(unknowns + 1) {
                            *value += factor * b;
                        }
                    }
                }
                columns.add_thrust(along, thrust_slope / thrust, &moved);
                node.step(piece.length, &moved, turn.angle);
                let end_rate = Arc { rate: arc_data.rate, drift: arc_data.drift }.rate_at(piece.length);
                columns.own(i, &node, thrust, end_rate, 1.0);
            } else {
                let sign = piece.sign();
                let tau = piece.length * mu;
                // At μ = 0 a bang is an instant turn.
                let turn = if mu > 0.0 {
                    bang(sign / mu, tau)
                } else {
                    Turn { angle: sign * piece.length, ..bang(0.0, 0.0) }
                };
                let moved = motion(&turn, thrust, (sin, cos));
                columns.carry(tau, &moved, unknowns + 1);
                columns.add_thrust(along, thrust_slope / thrust, &moved);
                if direction.mu != 0.0 && mu > 0.0 {
                    let (dmu, a) = (direction.mu, piece.length);
                    columns.state[0][along] += dmu * (node.state[1] * a + 2.0 * moved.x / mu);
                    columns.state[1][along] += dmu * moved.vx / mu;
                    columns.state[2][along] += dmu * (node.state[3] * a + 2.0 * moved.z / mu - a * tau);
                    columns.state[3][along] += dmu * (moved.vz / mu - a);
                    columns.t[along] += dmu * a;
                }
                node.step(tau, &moved, turn.angle);
                columns.own(i, &node, thrust, sign, mu);
            }
        }
        if next_row != unknowns {
            return false;
        }
        let weights = [position_weight, velocity_weight, position_weight, velocity_weight, 1.0];
        for (k, w) in weights.into_iter().enumerate() {
            let row = &mut self.rows[k];
            for (value, column) in row.iter_mut().zip(&columns.state[k]).take(unknowns + 1) {
                *value = w * column;
            }
            row[along] -= w * direction.to[k];
            let miss = w * (node.state[k] - problem.to[k]);
            row[along + 1] = miss;
            norm = norm.max(miss.abs());
        }
        self.norm = if c1.is_finite() && c3.is_finite() && norm.is_finite() { norm } else { f64::INFINITY };
        true
    }

    /// Eliminates in place and writes the Newton step and the tangent along the direction.
    ///
    /// Returns the smallest over the largest pivot, or `None` where the Jacobian is singular to rounding.
    pub(crate) fn solve(
        &mut self,
        step: &mut [f64; MAX_UNKNOWNS],
        tangent: &mut [f64; MAX_UNKNOWNS],
    ) -> Option<f64> {
        let n = self.size;
        let (mut smallest, mut largest) = (f64::INFINITY, 0.0_f64);
        for k in 0..n {
            let mut pivot_row = k;
            let mut best = self.rows[k][k].abs();
            for i in k + 1..n {
                let candidate = self.rows[i][k].abs();
                if candidate > best {
                    best = candidate;
                    pivot_row = i;
                }
            }
            // NaN must fail here too.
            if best.is_nan() || best <= PIVOT_FLOOR {
                return None;
            }
            smallest = smallest.min(best);
            largest = largest.max(best);
            self.rows.swap(k, pivot_row);
            let (upper, lower) = self.rows.split_at_mut(k + 1);
            let pivot = &upper[k];
            let inverse = 1.0 / pivot[k];
            for row in lower.iter_mut().take(n - k - 1) {
                let factor = row[k] * inverse;
                if factor != 0.0 {
                    for (value, p) in row[k + 1..n + 2].iter_mut().zip(&pivot[k + 1..n + 2]) {
                        *value -= factor * p;
                    }
                }
            }
        }
        for k in (0..n).rev() {
            let row = &self.rows[k];
            let (mut tangent_sum, mut step_sum) = (row[n], row[n + 1]);
            for j in k + 1..n {
                tangent_sum += row[j] * tangent[j];
                step_sum += row[j] * step[j];
            }
            tangent[k] = -tangent_sum / row[k];
            step[k] = -step_sum / row[k];
        }
        Some(smallest / largest)
    }
}

/// A pivot below this is zero to rounding: rows are scaled to order one.
const PIVOT_FLOOR: f64 = 1e-14;

/// d(thrust)/d(direction) of the level a piece uses.
fn thrust_direction(direction: &Direction, piece: &Piece) -> f64 {
    match piece.inputs.thrust {
        ThrustLevel::Min => direction.u_min,
        ThrustLevel::Max => direction.u_max,
    }
}

/// Thrust times the moments of a turn, rotated to the plane's axes.
struct Motion {
    x: f64,
    vx: f64,
    z: f64,
    vz: f64,
}

fn motion(turn: &Turn<f64>, thrust: f64, (s, c): (f64, f64)) -> Motion {
    Motion {
        x: thrust * (turn.position_along * s + turn.position_across * c),
        vx: thrust * (turn.velocity_along * s + turn.velocity_across * c),
        z: thrust * (turn.position_along * c - turn.position_across * s),
        vz: thrust * (turn.velocity_along * c - turn.velocity_across * s),
    }
}

impl Node {
    fn step(&mut self, tau: f64, m: &Motion, angle: f64) {
        let s = &mut self.state;
        s[0] += s[1] * tau + m.x;
        s[1] += m.vx;
        s[2] += s[3] * tau + m.z - 0.5 * tau * tau;
        s[3] += m.vz - tau;
        s[4] += angle;
        self.t += tau;
    }
}

impl Columns {
    /// Carries all columns over a piece: a change of the entry state.
    fn carry(&mut self, tau: f64, m: &Motion, count: usize) {
        let [x, vx, z, vz, theta] = &mut self.state;
        for j in 0..count {
            x[j] += tau * vx[j] + m.z * theta[j];
            z[j] += tau * vz[j] - m.x * theta[j];
            vx[j] += m.vz * theta[j];
            vz[j] -= m.vx * theta[j];
        }
    }

    /// A change of the thrust, relative.
    fn add_thrust(&mut self, along: usize, relative: f64, m: &Motion) {
        if relative != 0.0 {
            self.state[0][along] += relative * m.x;
            self.state[1][along] += relative * m.vx;
            self.state[2][along] += relative * m.z;
            self.state[3][along] += relative * m.vz;
        }
    }

    /// A change of the piece's own length: the right-hand side of eq. (4) at its end. `turn` is dθ/d(length), `time`
    /// dt/d(length).
    fn own(&mut self, index: usize, end: &Node, thrust: f64, turn: f64, time: f64) {
        let (s, c) = libm::sincos(end.state[4]);
        self.state[0][index] = time * end.state[1];
        self.state[1][index] = time * thrust * s;
        self.state[2][index] = time * end.state[3];
        self.state[3][index] = time * (thrust * c - 1.0);
        self.state[4][index] = turn;
        self.t[index] = time;
    }
}

fn value_of(t: &Turn<Dual<2>>) -> Turn<f64> {
    Turn {
        angle: t.angle.value,
        velocity_along: t.velocity_along.value,
        velocity_across: t.velocity_across.value,
        position_along: t.position_along.value,
        position_across: t.position_across.value,
    }
}

fn grad_of(t: &Turn<Dual<2>>, i: usize) -> Turn<f64> {
    Turn {
        angle: t.angle.grad[i],
        velocity_along: t.velocity_along.grad[i],
        velocity_across: t.velocity_across.grad[i],
        position_along: t.position_along.grad[i],
        position_across: t.position_across.grad[i],
    }
}

#[cfg(test)]
mod tests {
    use mintime_shared::model::RateMode;
    use mintime_shared::model::ThrustLevel::{Max, Min};

    use super::*;

    fn example() -> (Problem, Candidate) {
        let problem = Problem {
            from: [0.0, 1.0, 0.0, -0.4, 0.3],
            to: [30.0, 0.0, 20.0, 0.5, 0.2],
            u_min: 0.1,
            u_max: 2.0,
        };
        let mut candidate = Candidate { pieces: heapless::Vec::new(), c: [-0.05, -0.42, -0.08, -0.75] };
        for piece in [
            Piece::bang(RateMode::Plus, Min, 0.3),
            Piece::bang(RateMode::Plus, Max, 0.7),
            Piece::arc(4.0),
            Piece::bang(RateMode::Minus, Max, 0.9),
            Piece::bang(RateMode::Plus, Max, 0.2),
            Piece::arc(0.4),
            Piece::bang(RateMode::Plus, Max, 1.1),
        ] {
            assert!(candidate.push(piece));
        }
        (problem, candidate)
    }

    fn residual(l: &Linearised) -> std::vec::Vec<f64> {
        l.rows[..l.size].iter().map(|r| r[l.size + 1]).collect()
    }

    #[test]
    fn jacobian_agrees_with_finite_differences_in_every_column() {
        let (problem, candidate) = example();
        let direction = Direction {
            mu: 0.7,
            from: [0.0, 0.3, 0.0, -0.2, 0.5],
            to: [1.0, 0.2, 0.7, 0.1, -0.3],
            u_min: 0.02,
            u_max: -0.1,
        };
        let mu = 0.6;
        let mut center = Linearised::new();
        assert!(center.evaluate(&problem, mu, &candidate, &direction));
        let n = candidate.unknowns();
        let weight = |c: &Candidate, m: f64| {
            let d = c.duration(m);
            [1.0 / (d * d), 1.0 / d, 1.0 / (d * d), 1.0 / d, 1.0]
        };
        for column in 0..=n {
            let step = 1e-6;
            let shifted = |h: f64| {
                let (mut p, mut c, mut m) = (problem, candidate.clone(), mu);
                if column < c.pieces.len() {
                    c.pieces[column].length += h;
                } else if column < n {
                    c.c[column - c.pieces.len()] += h;
                } else {
                    p = direction.apply(&problem, h);
                    m += h * direction.mu;
                }
                let mut l = Linearised::new();
                assert!(l.evaluate(&p, m, &c, &direction));
                // The row weights depend on the duration and thrust; undo them to compare like with like.
                let mut r = residual(&l);
                let (now, then) = (weight(&c, m), weight(&candidate, mu));
                for k in 0..5 {
                    let power = if k == 4 { 0 } else { 1 };
                    let thrust = if power == 1 { p.u_max / problem.u_max } else { 1.0 };
                    r[k] *= then[k] / now[k] * thrust;
                }
                r
            };
            let (up, down) = (shifted(step), shifted(-step));
            for row in 0..n {
                let difference = (up[row] - down[row]) / (2.0 * step);
                let exact = center.rows[row][column];
                assert!(
                    (exact - difference).abs() < 2e-7 * (1.0 + exact.abs()),
                    "{row} {column} {exact} {difference}"
                );
            }
        }
    }

    #[test]
    fn elimination_solves_the_system() {
        let (problem, candidate) = example();
        let mut l = Linearised::new();
        assert!(l.evaluate(&problem, 0.6, &candidate, &Direction::MU));
        let matrix = l.clone();
        let (mut step, mut tangent) = ([0.0; MAX_UNKNOWNS], [0.0; MAX_UNKNOWNS]);
        assert!(l.solve(&mut step, &mut tangent).is_some());
        let n = matrix.size;
        for row in &matrix.rows[..n] {
            let a: f64 = (0..n).map(|j| row[j] * step[j]).sum::<f64>() + row[n + 1];
            let b: f64 = (0..n).map(|j| row[j] * tangent[j]).sum::<f64>() + row[n];
            assert!(a.abs() < 1e-9 && b.abs() < 1e-9, "{a} {b}");
        }
    }
}

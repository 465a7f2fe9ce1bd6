//! The quantities the paper itself works with, for a given extremal: the final state residual P_res, the linear
//! conditions A c = r with their least-squares solution, C_res and the residual of the boundary value problem.
//!
//! The search does not use them; they let a reader of Hehn, Ritz, D'Andrea, "Quadrocopter performance benchmarking using
//! optimal control", find every step of its section IV in numbers. All dimensionless, eq. (3)-(5).

use heapless::Vec;
use mintime_shared::model::{RateMode, State};

use super::dense::gauss;
use super::extremal::Extremal;
use super::structure::MAX_SEGMENTS;
use super::verify::verify;

/// Which condition a row of A c = r expresses.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Condition {
    /// Φ_R = 0 at a rate switch, by H = 0: eq. (27), and (36) at both ends of an arc.
    RateSwitch,
    /// ∫Φ̇_R dt over a whole interval between rate switches, or over an arc, equals the change of Φ_R: eq. (28).
    RateIntegral,
    /// Φ_T = 0 at a thrust switch: eq. (29).
    ThrustSwitch,
    /// Φ̇_R = 0 at an end of an arc: eq. (37).
    ArcEdge,
}

/// One row of A c = r.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Row {
    /// What it expresses.
    pub condition: Condition,
    /// When, s: the switch, or the start of the interval.
    pub time_s: f64,
    /// Row of A.
    pub a: [f64; 4],
    /// Entry of r.
    pub r: f64,
}

/// Most rows: per segment one switch of each kind, one integral, and two ends of an arc.
pub const MAX_ROWS: usize = 5 * MAX_SEGMENTS;

/// Section IV of the paper in numbers.
#[derive(Clone, Debug, PartialEq)]
pub struct Explanation {
    /// P_res, eq. (24) and (33), with W = 1: squared dimensionless final-state error of the switching times.
    pub p_res: f64,
    /// A and r, eq. (30).
    pub rows: Vec<Row, MAX_ROWS>,
    /// c* = (AᵀA)⁻¹Aᵀr, eq. (31). `None` where the conditions do not determine c.
    pub c_least_squares: Option<[f64; 4]>,
    /// C_res, eq. (34), with W_c = 1: squared residual of A c = r at the extremal's own c.
    pub c_res: f64,
    /// C_res at c*, which is the least there is.
    pub c_res_least_squares: f64,
    /// Residual of the boundary value problem, eq. (32): P_res after integrating the augmented system (21).
    pub bvp_residual: f64,
}

/// A point on the extremal in the units of eq. (3).
struct Point {
    t: f64,
    state: State<f64>,
}

impl Extremal {
    /// The paper's quantities for this maneuver.
    pub fn explain(&self) -> Explanation {
        let scale = self.limits.scale();
        let squared = |e: State<f64>| scale.to_dimensionless(e).to_array().iter().map(|v| v * v).sum::<f64>();
        let p_res = squared(self.state_at(f64::INFINITY).minus(self.end()));
        let rows = self.rows();
        let c_least_squares = least_squares(&rows);
        let c_res = |c: &[f64; 4]| rows.iter().map(|row| residual(row, c)).map(|e| e * e).sum();
        Explanation {
            p_res,
            c_least_squares,
            c_res: c_res(&self.costate.to_array()),
            c_res_least_squares: c_least_squares.as_ref().map_or(0.0, c_res),
            bvp_residual: squared(State::from_array(verify(self).final_state_error)),
            rows,
        }
    }

    fn rows(&self) -> Vec<Row, MAX_ROWS> {
        let mut rows = Vec::new();
        let limit = self.limits.rate_max_radps;
        let thrusts = self.limits.dimensionless();
        // There is room for every row: see MAX_ROWS.
        let mut push = |condition, t: f64, a, r| {
            let _ = rows.push(Row { condition, time_s: t / limit, a, r });
        };
        let mut t = 0.0;
        let mut integral = [0.0; 4];
        let mut interval = 0.0;
        let last = self.segments.len().saturating_sub(1);
        for (i, segment) in self.segments.iter().enumerate() {
            let u_t = thrusts.thrust(segment.inputs.thrust);
            let sign: f64 = segment.inputs.rate.sign().unwrap_or(0.0);
            let begin = self.point(t);
            let end = self.point(t + segment.duration * limit);
            let arc = segment.inputs.rate == RateMode::Singular;
            let moments = self.rate_integral(u_t, t, end.t);
            for (sum, m) in integral.iter_mut().zip(moments) {
                *sum += m;
            }
            if i == 0 && !arc {
                // Φ_R(0) = −h(0)/u_R stays on the left of (28).
                let h = h_row(&begin, u_t);
                for (sum, g) in integral.iter_mut().zip(h) {
                    *sum -= g / sign;
                }
            }
            let next = self.segments.get(i + 1);
            let switches = next.is_none_or(|n| n.inputs.rate != segment.inputs.rate);
            if switches {
                let mut r = if interval == 0.0 && self.starts_with_bang() { self.first_sign() } else { 0.0 };
                if i == last && !arc {
                    let h = h_row(&end, u_t);
                    for (sum, g) in integral.iter_mut().zip(h) {
                        *sum += g / sign;
                    }
                    r -= 1.0 / sign;
                }
                push(Condition::RateIntegral, interval, integral, r);
                integral = [0.0; 4];
                interval = end.t;
            }
            if arc {
                for point in [&begin, &end] {
                    push(Condition::RateSwitch, point.t, h_row(point, u_t), -1.0);
                    push(Condition::ArcEdge, point.t, phi_r_rate_row(point), 0.0);
                }
            }
            if let Some(n) = next {
                if !arc && switches && n.inputs.rate != RateMode::Singular {
                    push(Condition::RateSwitch, end.t, h_row(&end, u_t), -1.0);
                }
                if n.inputs.thrust != segment.inputs.thrust {
                    push(Condition::ThrustSwitch, end.t, phi_t_row(&end), 0.0);
                }
            }
            t = end.t;
        }
        rows
    }

    fn starts_with_bang(&self) -> bool {
        self.segments.first().is_some_and(|s| s.inputs.rate != RateMode::Singular)
    }

    /// 1/u_R(0).
    fn first_sign(&self) -> f64 {
        self.segments.first().and_then(|s| s.inputs.rate.sign()).unwrap_or(0.0)
    }

    fn point(&self, t: f64) -> Point {
        let scale = self.limits.scale();
        Point { t, state: scale.to_dimensionless(self.state_at(t * scale.time_s)) }
    }

    /// ∫Φ̇_R dt, eq. (13), as a row: Φ̇_R is linear in c.
    fn rate_integral(&self, u_t: f64, begin: f64, end: f64) -> [f64; 4] {
        let steps = libm::ceil(end - begin).max(1.0);
        let half = 0.5 * (end - begin) / steps;
        let mut sums = [0.0; 4];
        for i in 0..steps as u32 {
            for (node, weight) in super::sensitivity::GAUSS_6 {
                for side in [-1.0, 1.0] {
                    let at = self.point(begin + half * (f64::from(2 * i + 1) + side * node));
                    for (sum, g) in sums.iter_mut().zip(phi_r_rate_row(&at)) {
                        *sum += weight * half * u_t * g;
                    }
                }
            }
        }
        sums
    }
}

/// h = 1 + row·c: H without Φ_R u_R.
fn h_row(at: &Point, u_t: f64) -> [f64; 4] {
    let (s, c) = libm::sincos(at.state.theta);
    [at.state.vx - u_t * at.t * s, u_t * s, at.state.vz - u_t * at.t * c + at.t, u_t * c - 1.0]
}

/// Φ_T as a row.
fn phi_t_row(at: &Point) -> [f64; 4] {
    let (s, c) = libm::sincos(at.state.theta);
    [-at.t * s, s, -at.t * c, c]
}

/// Φ̇_R/u_T as a row.
fn phi_r_rate_row(at: &Point) -> [f64; 4] {
    let (s, c) = libm::sincos(at.state.theta);
    [at.t * c, -c, -at.t * s, s]
}

fn residual(row: &Row, c: &[f64; 4]) -> f64 {
    row.a.iter().zip(c).map(|(a, c)| a * c).sum::<f64>() - row.r
}

/// c* of eq. (31).
fn least_squares(rows: &Vec<Row, MAX_ROWS>) -> Option<[f64; 4]> {
    let mut normal = [[0.0; 5]; 4];
    for row in rows {
        for (line, a) in normal.iter_mut().zip(row.a) {
            let right = row.a.into_iter().chain(core::iter::once(row.r));
            for (value, b) in line.iter_mut().zip(right) {
                *value += a * b;
            }
        }
    }
    gauss(&mut normal)
}

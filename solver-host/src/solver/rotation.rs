//! Maneuvers that take exactly |Δθ|/ω_max: the vehicle turns at the limit all the way and the thrust alone brings it to
//! the end. No maneuver of that winding is faster.
//!
//! They are extremals with c = 0 and Φ_R = ±1, so H = 0 holds and Φ_T vanishes throughout: law (20) leaves the thrust
//! free, and every profile that reaches the end is as good. The paper's parametrisation has no room for them, and the
//! continuation in the rate limit ends where an arc between two turns of the same sense shrinks to nothing. Of all
//! profiles this takes the one with the least impulse ∫u_T dt, which is bang-bang: maximum thrust where
//! w = 1 + λ·φ < 0, φ = (sin θ, cos θ, (T − t) sin θ, (T − t) cos θ), with four multipliers λ for the four translational
//! end conditions ∫u_T φ dt = m.

use heapless::Vec;
use mintime_shared::model::ThrustLevel;

use super::dense::gauss;
use super::events::trace;
use super::problem::Problem;
use super::structure::{Candidate, MAX_SEGMENTS, Piece, turning};

/// Nodes of the midpoint rule that the smoothed problem is solved on.
const NODES: usize = 96;
/// Smoothing of the switch, in units of w: each value starts from the solution of the one before.
const SMOOTHING: [f64; 5] = [1.0, 0.3, 0.1, 0.03, 0.01];
/// Newton iterations for each.
const ITERATIONS: usize = 8;
/// Nodes on either side of a touching point that count towards it.
const TOUCH_NODES: usize = 4;
/// Half of the shortest piece worth starting from, rad.
const SHORTEST_PIECE: f64 = 1e-3;
/// Iterations of the exact correction of the switching times, and the end error (relative) at which it is done.
const CORRECTIONS: usize = 20;
const ARRIVED: f64 = 1e-14;

/// The rotation-limited maneuver of this winding, if there is one.
pub(crate) fn rotation_limited(problem: &Problem) -> Option<Candidate> {
    let turn = problem.turn();
    let duration = turn.abs();
    if duration <= 0.0 {
        return None;
    }
    let sign = if turn < 0.0 { -1.0 } else { 1.0 };
    let (f, g) = (&problem.from, &problem.to);
    let demand = [
        g[1] - f[1],
        g[3] - f[3] + duration,
        g[0] - f[0] - f[1] * duration,
        g[2] - f[2] - f[3] * duration + 0.5 * duration * duration,
    ];
    let phi = |t: f64| {
        let (s, c) = libm::sincos(f[4] + sign * t);
        let left = duration - t;
        [s, c, left * s, left * c]
    };
    let lambda = multipliers(problem, duration, &demand, phi)?;
    let w = |t: f64| 1.0 + phi(t).iter().zip(&lambda).map(|(p, l)| p * l).sum::<f64>();

    // Read off the switches, then move them as little as possible until the end is met exactly.
    let mut switches: Vec<f64, MAX_SEGMENTS> = Vec::new();
    let step = duration / NODES as f64;
    let at: [f64; NODES + 1] = core::array::from_fn(|i| w(step * i as f64));
    for i in 0..NODES {
        let (t, a, b) = (step * i as f64, at[i], at[i + 1]);
        if (a < 0.0) != (b < 0.0) {
            switches.push(t + step * a / (a - b)).ok()?;
        } else if i > 0 && a.abs() < at[i - 1].abs() && a.abs() <= b.abs() && (at[i - 1] < 0.0) == (a < 0.0) {
            // w almost touches zero: what the smoothed thrust gives way here is a short piece of the other level.
            let half = 0.5 * given_way(&at, i) * step;
            if half > SHORTEST_PIECE && half < 2.0 * step {
                switches.push(t - half).ok()?;
                switches.push(t + half).ok()?;
            }
        }
    }
    let first = if w(0.0) < 0.0 { ThrustLevel::Max } else { ThrustLevel::Min };
    if switches.len() < 4 || switches.len() + 1 > MAX_SEGMENTS {
        return None;
    }
    for _ in 0..CORRECTIONS {
        let candidate = assemble(&switches, duration, sign, first)?;
        let nodes = trace(problem, 1.0, &candidate);
        let end = nodes[candidate.pieces.len()].state;
        let miss = [end[1] - g[1], end[3] - g[3], end[0] - g[0], end[2] - g[2]];
        let scale = problem.u_max * (1.0 + duration * duration);
        if miss.iter().all(|m| m.abs() <= ARRIVED * scale) {
            return Some(candidate);
        }
        correct(problem, &mut switches, &miss, first, phi)?;
    }
    // Rounding may keep it above the target; the caller verifies.
    assemble(&switches, duration, sign, first)
}

/// How many nodes' worth of the other thrust level the smoothed solution uses around a node where |w| is least.
fn given_way(w: &[f64; NODES + 1], node: usize) -> f64 {
    let epsilon = SMOOTHING[SMOOTHING.len() - 1];
    let near = node.saturating_sub(TOUCH_NODES)..=(node + TOUCH_NODES).min(NODES);
    near.map(|i| 0.5 * (1.0 - w[i].abs() / libm::sqrt(w[i] * w[i] + epsilon * epsilon))).sum()
}

/// λ by Newton's method on the smoothed dual, which is concave: smoothing towards zero. `None` where it diverges, as it
/// does where the end cannot be reached.
fn multipliers(
    problem: &Problem,
    duration: f64,
    demand: &[f64; 4],
    phi: impl Fn(f64) -> [f64; 4],
) -> Option<[f64; 4]> {
    let mid = 0.5 * (problem.u_max + problem.u_min);
    let half = 0.5 * (problem.u_max - problem.u_min);
    let step = duration / NODES as f64;
    let rows: [[f64; 4]; NODES] = core::array::from_fn(|i| phi((i as f64 + 0.5) * step));
    let residual = |lambda: &[f64; 4], epsilon: f64| {
        let mut m = [[0.0; 5]; 4];
        for row in &rows {
            let w = 1.0 + row.iter().zip(lambda).map(|(p, l)| p * l).sum::<f64>();
            let root = libm::sqrt(w * w + epsilon * epsilon);
            let u = mid - half * w / root;
            let slope = -half * epsilon * epsilon / (root * root * root);
            for i in 0..4 {
                m[i][4] += u * row[i] * step;
                for j in 0..4 {
                    m[i][j] += slope * row[i] * row[j] * step;
                }
            }
        }
        for i in 0..4 {
            m[i][4] = demand[i] - m[i][4];
        }
        m
    };
    // Positions weigh like velocities times the duration.
    let size = |m: &[[f64; 5]; 4]| {
        m[0][4].abs() + m[1][4].abs() + (m[2][4].abs() + m[3][4].abs()) / duration.max(1.0)
    };
    let tolerance = 1e-3 * half * duration;
    let mut lambda = [0.0; 4];
    let mut miss = f64::INFINITY;
    for epsilon in SMOOTHING {
        let mut m = residual(&lambda, epsilon);
        miss = size(&m);
        for _ in 0..ITERATIONS {
            if miss < 1e-6 * tolerance {
                break;
            }
            let delta = gauss(&mut m)?;
            let mut scale = 1.0;
            let before = miss;
            loop {
                let trial: [f64; 4] = core::array::from_fn(|i| lambda[i] + scale * delta[i]);
                let next = residual(&trial, epsilon);
                if size(&next) < before * (1.0 - 0.1 * scale) {
                    (lambda, m, miss) = (trial, next, size(&next));
                    break;
                }
                scale *= 0.5;
                if scale < 1e-3 {
                    break;
                }
            }
            if miss >= before {
                break;
            }
        }
    }
    // What the midpoint rule and the last smoothing leave is small; what is unreachable leaves much.
    (miss < 20.0 * tolerance && lambda.iter().all(|l| l.is_finite())).then_some(lambda)
}

/// Least change of the switching times that removes the miss to first order.
fn correct(
    problem: &Problem,
    switches: &mut Vec<f64, MAX_SEGMENTS>,
    miss: &[f64; 4],
    first: ThrustLevel,
    phi: impl Fn(f64) -> [f64; 4],
) -> Option<()> {
    // Moving a switch later keeps the earlier thrust on for longer: the moments grow by that jump times φ.
    let jump = problem.u_max - problem.u_min;
    let mut columns: Vec<[f64; 4], MAX_SEGMENTS> = Vec::new();
    let mut sign = if first == ThrustLevel::Max { 1.0 } else { -1.0 };
    for &t in switches.iter() {
        columns.push(phi(t).map(|p| sign * jump * p)).ok()?;
        sign = -sign;
    }
    let mut m = [[0.0; 5]; 4];
    for i in 0..4 {
        for j in 0..4 {
            m[i][j] = columns.iter().map(|c| c[i] * c[j]).sum();
        }
        m[i][4] = -miss[i];
    }
    let y = gauss(&mut m)?;
    for (t, column) in switches.iter_mut().zip(&columns) {
        *t += column.iter().zip(&y).map(|(c, y)| c * y).sum::<f64>();
    }
    Some(())
}

/// The maneuver with these switches; `None` where they are out of order.
fn assemble(
    switches: &Vec<f64, MAX_SEGMENTS>,
    duration: f64,
    sign: f64,
    first: ThrustLevel,
) -> Option<Candidate> {
    let mut candidate = Candidate { pieces: Vec::new(), c: [0.0; 4] };
    let mut level = first;
    let mut before = 0.0;
    for &t in switches.iter().chain(core::iter::once(&duration)) {
        if t.is_nan()
            || t <= before
            || t > duration
            || !candidate.push(Piece::bang(turning(sign), level, t - before))
        {
            return None;
        }
        before = t;
        level = if level == ThrustLevel::Max { ThrustLevel::Min } else { ThrustLevel::Max };
    }
    Some(candidate)
}

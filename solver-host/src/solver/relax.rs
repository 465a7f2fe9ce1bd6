//! The infinite-rate relaxation: thrust in any direction at once, anywhere in the disc |u| ≤ u_max (the hull of what
//! the thrust limits allow). It starts the continuation, and its dual gives a rigorous lower bound on T.
//!
//! With s = t/T and p(s) = P0 + s (P1 − P0) the end conditions read b(T) + ∇K(P0, P1) = 0, K = ∫|p| ds convex. For any
//! P at all, a duration T is impossible where
//!
//! ψ(T) = −[(P1·vT − P0·v0) T + (P0 − P1)·Δx + T² (m_z + u_max K)] > 0,  m = (P0 + P1)/2,
//!
//! a parabola open downwards: every P rules out an interval of T. Newton's method maximises its upper end over P, so
//! that even an unfinished iteration leaves a valid bound.

use mintime_shared::motion::inverse_moments;
use mintime_shared::real::Real;

use super::dense::gauss;
use super::dual::Dual;
use super::problem::Problem;

/// Solution of the relaxation.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Relaxation {
    /// Dimensionless duration.
    pub(crate) duration: f64,
    /// Constants of eq. (9), scaled by H(0) = 0.
    pub(crate) c: [f64; 4],
    /// Rigorous lower bound on the dimensionless duration at any body-rate limit.
    pub(crate) lower_bound: f64,
}

/// Smoothing of |p|, relative to |(P0, P1)|: first value, last value, factor between.
const SMOOTHING: (f64, f64, f64) = (1e-1, 1e-4, 0.1);
/// Newton iterations for one smoothing value; three to five are usual.
const ITERATIONS: usize = 25;
/// Residual (relative to u_max) at which the relaxation counts as solved.
const SOLVED: f64 = 1e-10;
/// Where p runs (almost) through zero the singular rate is unbounded: p is pushed sideways until its peak is the rate
/// limit at the first μ divided by this.
const PUSH: f64 = 0.3;

/// The inverse rate limit at which a continuation begins.
pub(crate) fn first_mu(duration: f64) -> f64 {
    0.02 * (duration / 6.0).min(1.0)
}

/// K and its gradient (∂P0, ∂P1), smoothed, at P = (P0x, P0z, P1x, P1z).
fn support<T: Real>(p: &[T; 4], epsilon2: T) -> [T; 4] {
    let (dx, dz) = (p[2] - p[0], p[3] - p[1]);
    let a = p[0] * p[0] + p[1] * p[1] + epsilon2;
    let length2 = dx * dx + dz * dz;
    let cross = p[0] * dz - p[1] * dx;
    let drift = -(p[0] * dx + p[1] * dz) / a;
    let x_squared = (cross * cross + epsilon2 * length2) / (a * a);
    let root = a.sqrt();
    let [m0, m1, m2] = inverse_moments(drift, x_squared, T::one());
    // ∫(p, s p)/|p| ds
    let zeroth = [(p[0] * m0 + dx * m1) / root, (p[1] * m0 + dz * m1) / root];
    let first = [(p[0] * m1 + dx * m2) / root, (p[1] * m1 + dz * m2) / root];
    [zeroth[0] - first[0], zeroth[1] - first[1], first[0], first[1]]
}

/// What the end conditions ask of the gradient of K at a duration T: b(T) of the module's text, divided by u_max.
fn demand(problem: &Problem, t: f64) -> [f64; 4] {
    let u = problem.u_max;
    let (f, g) = (&problem.from, &problem.to);
    let axis = |i: usize, gravity: f64| {
        let velocity = (g[i + 1] - f[i + 1] + gravity * t) / (u * t);
        let position = (g[i] - f[i] - f[i + 1] * t + 0.5 * gravity * t * t) / (u * t * t);
        // ∫(1 − s) p/|p| must be −position, ∫p/|p| must be −velocity.
        (position, velocity - position)
    };
    let (x0, x1) = axis(0, 0.0);
    let (z0, z1) = axis(2, 1.0);
    [x0, z0, x1, z1]
}

/// An upper bound on K = ∫|p| ds that is off by at most the smoothing: ∫√(|p|² + ε²) = P·∇K_ε + ε²∫1/√(|p|² + ε²).
fn length_integral(p: &[f64; 4]) -> f64 {
    const EPSILON2: f64 = 1e-12;
    let e = EPSILON2 * dot(p, p).max(f64::MIN_POSITIVE);
    let (dx, dz) = (p[2] - p[0], p[3] - p[1]);
    let a = p[0] * p[0] + p[1] * p[1] + e;
    let cross = p[0] * dz - p[1] * dx;
    let drift = -(p[0] * dx + p[1] * dz) / a;
    let x_squared = (cross * cross + e * (dx * dx + dz * dz)) / (a * a);
    let [m0, _, _] = inverse_moments(drift, x_squared, 1.0);
    dot(p, &support(p, e)) + e * m0 / libm::sqrt(a)
}

/// The interval of T that P rules out, (lower end, upper end).
fn excluded(problem: &Problem, p: &[f64; 4]) -> (f64, f64) {
    let (f, g) = (&problem.from, &problem.to);
    let k = length_integral(p);
    let quadratic = 0.5 * (p[1] + p[3]) + problem.u_max * k;
    let linear = p[2] * g[1] + p[3] * g[3] - p[0] * f[1] - p[1] * f[3];
    let constant = (p[0] - p[2]) * (g[0] - f[0]) + (p[1] - p[3]) * (g[2] - f[2]);
    let discriminant = linear * linear - 4.0 * quadratic * constant;
    if discriminant.is_nan() || discriminant <= 0.0 || quadratic <= 0.0 {
        return (0.0, 0.0);
    }
    let root = libm::sqrt(discriminant);
    // The stable pair of roots of quadratic T² + linear T + constant = 0.
    let q = -0.5 * (linear + if linear < 0.0 { -root } else { root });
    let (a, b) = (q / quadratic, if q != 0.0 { constant / q } else { 0.0 });
    (a.min(b), a.max(b))
}

fn dot(a: &[f64; 4], b: &[f64; 4]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

fn normalise(p: &mut [f64; 4]) {
    let norm = libm::sqrt(dot(p, p));
    if norm > 0.0 {
        for v in p.iter_mut() {
            *v /= norm;
        }
    }
}

/// −(the linear acceleration of least energy) at its two ends: the costate of the energy-optimal transfer in time T.
fn energy_costate(problem: &Problem, t: f64) -> [f64; 4] {
    let (f, g) = (&problem.from, &problem.to);
    let axis = |i: usize, gravity: f64| {
        // u(s) = A + B s: mean = velocity, ∫(1 − s)u = position.
        let mean = (g[i + 1] - f[i + 1]) / t + gravity;
        let position = (g[i] - f[i] - f[i + 1] * t) / (t * t) + 0.5 * gravity;
        let slope = 6.0 * mean - 12.0 * position;
        let start = mean - 0.5 * slope;
        (start, start + slope)
    };
    let (x0, x1) = axis(0, 0.0);
    let (z0, z1) = axis(2, 1.0);
    [-x0, -z0, -x1, -z1]
}

/// Steps of the chain of [`chained_bound`]; each rules out a further interval, and the last ones hardly move.
const CHAIN: usize = 40;

/// A rigorous lower bound without any iteration that could fail: starting from elementary bounds, the energy-optimal
/// costate at the bound so far rules out an interval beyond it, again and again.
fn chained_bound(problem: &Problem) -> f64 {
    let mut bound = elementary_bound(problem);
    for _ in 0..CHAIN {
        let mut p = energy_costate(problem, bound);
        normalise(&mut p);
        let (low, high) = excluded(problem, &p);
        if !(low <= bound && high > bound * (1.0 + 1e-4)) {
            break;
        }
        bound = high;
    }
    bound
}

/// By the mean acceleration, and by covering the distance at full acceleration from the initial speed.
pub(crate) fn elementary_bound(problem: &Problem) -> f64 {
    let (f, g) = (&problem.from, &problem.to);
    let authority = problem.u_max + 1.0;
    let distance = libm::hypot(g[0] - f[0], g[2] - f[2]);
    let speed_change = libm::hypot(g[1] - f[1], g[3] - f[3]);
    let speed = libm::hypot(f[1], f[3]);
    let by_distance = 2.0 * distance
        / (libm::sqrt(speed * speed + 2.0 * authority * distance) + speed).max(f64::MIN_POSITIVE);
    (speed_change / authority).max(by_distance)
}

/// A lower bound from a costate near the relaxation's own, such as that of the extremal itself: one or two ascents instead
/// of the whole solution, and rigorous whatever it is given. Never above, and hardly below, that of [`relax`].
pub(crate) fn lower_bound_near(problem: &Problem, c: [f64; 4], duration: f64) -> Option<f64> {
    let [c1, c2, c3, c4] = c;
    let mut p = [c2, c4, c2 - c1 * duration, c4 - c3 * duration];
    normalise(&mut p);
    let mut bound = elementary_bound(problem);
    let (low, mut t) = excluded(problem, &p);
    if t.is_nan() || low > bound || t <= bound {
        return None;
    }
    bound = t;
    for _ in 0..ASCENTS {
        let Some((delta, _)) = newton(problem, &p, t, SMOOTHING.1) else { break };
        let mut next: [f64; 4] = core::array::from_fn(|i| p[i] + delta[i]);
        normalise(&mut next);
        let (low, high) = excluded(problem, &next);
        if low.is_nan() || low > bound || high <= bound {
            break;
        }
        let gain = high / bound - 1.0;
        (p, t, bound) = (next, high, high);
        if gain < 1e-7 {
            break;
        }
    }
    Some(bound)
}

/// Steps of [`lower_bound_near`].
const ASCENTS: usize = 4;

/// Solves the relaxation. `None` where start and end coincide (T = 0) or Newton fails altogether.
pub(crate) fn relax(problem: &Problem) -> Option<Relaxation> {
    let still = (0..4).all(|i| problem.from[i] == problem.to[i]);
    if still && problem.from[1] == 0.0 && problem.from[3] == 0.0 {
        return None;
    }
    let mut t = chained_bound(problem);
    let mut bound = t;
    let mut p = energy_costate(problem, t);
    normalise(&mut p);
    let mut smoothing = SMOOTHING.0;
    let mut solved = false;
    loop {
        for _ in 0..ITERATIONS {
            let Some((delta, size)) = newton(problem, &p, t, smoothing) else { break };
            solved = size < SOLVED;
            if solved {
                break;
            }
            // Damping: the residual must shrink, and T may not move by more than a third at once.
            let mut scale = (0.3 * t / delta[4].abs().max(f64::MIN_POSITIVE)).min(1.0);
            let mut accepted = false;
            for _ in 0..12 {
                let mut trial: [f64; 4] = core::array::from_fn(|i| p[i] + scale * delta[i]);
                normalise(&mut trial);
                let trial_t = t + scale * delta[4];
                let k = support(&trial, smoothing * smoothing);
                let b = demand(problem, trial_t);
                let r: [f64; 4] = core::array::from_fn(|i| k[i] + b[i]);
                if libm::sqrt(dot(&r, &r)) < size * (1.0 - 0.1 * scale) {
                    p = trial;
                    t = trial_t;
                    accepted = true;
                    break;
                }
                scale *= 0.5;
            }
            let (low, high) = excluded(problem, &p);
            if low <= bound && high > bound {
                bound = high;
            }
            if !accepted {
                break;
            }
        }
        if smoothing <= SMOOTHING.1 * 1.0001 {
            break;
        }
        smoothing *= SMOOTHING.2;
    }
    if !(t.is_finite() && p.iter().all(|v| v.is_finite())) {
        return None;
    }
    let (low, high) = excluded(problem, &p);
    if low <= bound && high > bound {
        bound = high;
    }
    let _ = solved;
    Some(Relaxation { duration: t, c: constants(problem, &mut p, t, PUSH * first_mu(t)), lower_bound: bound })
}

/// Newton's step in (p, T) at one smoothing, and the residual.
fn newton(problem: &Problem, p: &[f64; 4], t: f64, smoothing: f64) -> Option<([f64; 5], f64)> {
    let dual: [Dual<4>; 4] = core::array::from_fn(|i| Dual::variable(p[i], i));
    let k = support(&dual, Dual::constant(smoothing * smoothing));
    let b = demand(problem, t);
    let slope = {
        let h = 1e-6 * t;
        let (up, down) = (demand(problem, t + h), demand(problem, t - h));
        core::array::from_fn::<f64, 4, _>(|i| (up[i] - down[i]) / (2.0 * h))
    };
    let residual: [f64; 4] = core::array::from_fn(|i| k[i].value + b[i]);
    let mut matrix = [[0.0; 6]; 5];
    for i in 0..4 {
        matrix[i][..4].copy_from_slice(&k[i].grad);
        matrix[i][4] = slope[i];
        matrix[i][5] = -residual[i];
    }
    matrix[4][..4].copy_from_slice(p);
    Some((gauss(&mut matrix)?, libm::sqrt(dot(&residual, &residual))))
}

/// Pushes p away from zero and scales it by H(0) = 0.
fn constants(problem: &Problem, p: &mut [f64; 4], t: f64, push: f64) -> [f64; 4] {
    let (dx, dz) = (p[2] - p[0], p[3] - p[1]);
    let length = libm::hypot(dx, dz);
    let start = libm::hypot(p[0], p[1]).max(libm::hypot(p[2], p[3]));
    if length > 0.0 {
        // Signed distance of the origin from the line that p runs along.
        let nearest = (p[0] * dz - p[1] * dx) / length;
        let least = (push * length / t).min(0.2 * start);
        if nearest.abs() < least {
            let shift = if nearest < 0.0 { -least - nearest } else { least - nearest };
            for (i, direction) in [dz, -dx, dz, -dx].into_iter().enumerate() {
                p[i] += shift * direction / length;
            }
        }
    }
    let c = [(p[0] - p[2]) / t, p[0], (p[1] - p[3]) / t, p[1]];
    let magnitude = libm::hypot(p[0], p[1]);
    let h = c[0] * problem.from[1] + c[2] * problem.from[3] - problem.u_max * magnitude - p[1];
    // h = −1 after scaling. It is negative where the maneuver's duration is positive; guard against rounding at zero.
    let scale = if h < -1e-6 * magnitude { -1.0 / h } else { 1.0 / (problem.u_max * magnitude).max(1e-12) };
    c.map(|v| v * scale)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::solver::{Request, solve};

    #[test]
    fn the_bound_near_an_extremal_is_that_of_the_relaxation() {
        for (x, z) in [(5.0, 5.0), (10.0, -5.0), (0.0, 6.0), (15.0, 0.0), (0.01, 0.0), (-12.0, 9.0)] {
            let extremal = solve(&Request::rest_to_rest(x, z)).expect("solved").extremal;
            let problem = extremal.problem();
            let full = relax(&problem).expect("not at the end already").lower_bound;
            let duration = extremal.duration_s() * extremal.limits.rate_max_radps;
            let near = lower_bound_near(&problem, extremal.costate.to_array(), duration).expect("a bound");
            // Never above the relaxation's optimum, which `full` is to rounding.
            assert!(near <= full * (1.0 + 1e-9) && near > full * (1.0 - 1e-6), "({x}, {z}): {near} {full}");
        }
    }

    #[test]
    fn a_costate_that_has_nothing_to_do_with_the_problem_gives_a_lower_bound_all_the_same() {
        let extremal = solve(&Request::rest_to_rest(5.0, 5.0)).expect("solved").extremal;
        let problem = extremal.problem();
        let full = relax(&problem).expect("not at the end already").lower_bound;
        for c in [[0.3, -1.0, 0.1, 0.2], [0.0, 0.0, 0.0, -1.0], [-2.0, 0.0, 5.0, 1.0], [0.0, 1.0, 0.0, 0.0]] {
            if let Some(bound) = lower_bound_near(&problem, c, 14.0) {
                assert!(bound <= full * (1.0 + 1e-9), "{c:?}: {bound} {full}");
            }
        }
    }
}

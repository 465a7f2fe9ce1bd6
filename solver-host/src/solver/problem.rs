//! The problem the core solves: dimensionless by eq. (3), the winding already part of the end angle, and the rate limit
//! relaxed to 1/μ ≥ 1.

use mintime_shared::model::{Limits, State, ThrustLevel};

/// A boundary value problem in the units of eq. (3).
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Problem {
    /// Start (x, ẋ, z, ż, θ).
    pub(crate) from: [f64; 5],
    /// End; the angle includes 2πk.
    pub(crate) to: [f64; 5],
    /// Lower thrust limit over gravity.
    pub(crate) u_min: f64,
    /// Upper thrust limit over gravity.
    pub(crate) u_max: f64,
}

impl Problem {
    /// From SI data, with the start moved to the origin (only the displacement matters) and `turns` added to the end.
    pub(crate) fn new(from: State<f64>, to: State<f64>, limits: &Limits<f64>, turns: i32) -> Self {
        let scale = limits.scale();
        let range = limits.dimensionless();
        let start = scale.to_dimensionless(State { x: 0.0, z: 0.0, ..from });
        let mut end = scale.to_dimensionless(State { x: to.x - from.x, z: to.z - from.z, ..to });
        end.theta += f64::from(turns) * core::f64::consts::TAU;
        Self { from: start.to_array(), to: end.to_array(), u_min: range.min, u_max: range.max }
    }

    /// The problem run backwards: its solutions are this one's with time reversed.
    pub(crate) fn reversed(&self) -> Self {
        let [x0, vx0, z0, vz0, theta0] = self.from;
        let [x1, vx1, z1, vz1, theta1] = self.to;
        Self { from: [0.0, -vx1, 0.0, -vz1, theta1], to: [x0 - x1, -vx0, z0 - z1, -vz0, theta0], ..*self }
    }

    /// A sign that changes for the mirror image and not for the problem backwards.
    pub(crate) fn orientation(&self) -> f64 {
        let [x, vx0, vx1] = [self.to[0] - self.from[0], self.from[1], self.to[1]];
        let first = [self.from[4] + self.to[4], vx1 - vx0, x].into_iter().find(|v| *v != 0.0);
        if first.is_some_and(|v| v < 0.0) { -1.0 } else { 1.0 }
    }

    /// Whether it is the backward one of the pair that it makes with the problem backwards; the same for mirror images.
    pub(crate) fn is_backward(&self) -> bool {
        let (f, g) = (&self.from, &self.to);
        let speed = |s: &[f64; 5]| s[1] * s[1] + s[3] * s[3];
        let differences = [g[2] - f[2], f[3] + g[3], speed(g) - speed(f), libm::cos(g[4]) - libm::cos(f[4])];
        differences.into_iter().find(|v| *v != 0.0).is_some_and(|v| v < 0.0)
    }

    /// The winding k' of the mirror image of a maneuver of winding k, as the sum k + k'. `None` where the problem is
    /// not its own mirror image.
    pub(crate) fn mirror_sum(&self) -> Option<i32> {
        let half_turns = |angle: f64| {
            let j = libm::round(angle / core::f64::consts::PI);
            (angle - j * core::f64::consts::PI).abs().le(&1e-12).then_some(j)
        };
        let upright = self.from[0] == self.to[0] && self.from[1] == 0.0 && self.to[1] == 0.0;
        if !upright {
            return None;
        }
        // θ goes to 2πj/2 − θ about the start's own mirror angle.
        Some((half_turns(self.from[4])? - half_turns(self.to[4])?) as i32)
    }

    pub(crate) fn thrust(&self, level: ThrustLevel) -> f64 {
        match level {
            ThrustLevel::Min => self.u_min,
            ThrustLevel::Max => self.u_max,
        }
    }

    /// θ(T) − θ(0) that is asked for.
    pub(crate) fn turn(&self) -> f64 {
        self.to[4] - self.from[4]
    }
}

/// A direction in the space of problems, for predictors and sensitivities: derivatives of everything a [`Problem`] and
/// μ hold with respect to one parameter.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Direction {
    pub(crate) mu: f64,
    pub(crate) from: [f64; 5],
    pub(crate) to: [f64; 5],
    pub(crate) u_min: f64,
    pub(crate) u_max: f64,
}

impl Direction {
    /// The direction of the rate limit's inverse.
    pub(crate) const MU: Self = Self { mu: 1.0, from: [0.0; 5], to: [0.0; 5], u_min: 0.0, u_max: 0.0 };

    /// From one problem to another.
    pub(crate) fn between(a: &Problem, b: &Problem) -> Self {
        let minus = |p: &[f64; 5], q: &[f64; 5]| core::array::from_fn(|i| q[i] - p[i]);
        Self {
            mu: 0.0,
            from: minus(&a.from, &b.from),
            to: minus(&a.to, &b.to),
            u_min: b.u_min - a.u_min,
            u_max: b.u_max - a.u_max,
        }
    }

    /// The problem a step along this direction.
    pub(crate) fn apply(&self, p: &Problem, step: f64) -> Problem {
        let plus = |a: &[f64; 5], d: &[f64; 5]| core::array::from_fn(|i| a[i] + step * d[i]);
        Problem {
            from: plus(&p.from, &self.from),
            to: plus(&p.to, &self.to),
            u_min: p.u_min + step * self.u_min,
            u_max: p.u_max + step * self.u_max,
        }
    }
}

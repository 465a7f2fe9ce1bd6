//! Problems near a given one: where a problem does not solve directly, a neighbour often does, and its maneuver can be
//! carried over.

use core::f64::consts::PI;

use super::problem::Problem;

/// One problem near another.
pub(crate) struct Detour {
    /// Displacement of the end, relative to the distance, and its direction.
    displacement: (f64, f64),
    /// Change of the end's velocity (horizontal, vertical), relative to the speed.
    velocity: (f64, f64),
    /// Factor on the upper thrust limit.
    thrust: f64,
}

impl Detour {
    const fn moved(length: f64, direction: f64) -> Self {
        Self { displacement: (length, direction), velocity: (0.0, 0.0), thrust: 1.0 }
    }

    const fn faster(horizontal: f64, vertical: f64) -> Self {
        Self { displacement: (0.0, 0.0), velocity: (horizontal, vertical), thrust: 1.0 }
    }

    const fn stronger(thrust: f64) -> Self {
        Self { displacement: (0.0, 0.0), velocity: (0.0, 0.0), thrust }
    }

    pub(crate) fn apply(&self, problem: &Problem) -> Problem {
        let mut p = *problem;
        let (f, g) = (&problem.from, &problem.to);
        let distance = libm::hypot(g[0] - f[0], g[2] - f[2]).max(SHORT_DISTANCE);
        let speed = libm::hypot(f[1], f[3]).max(libm::hypot(g[1], g[3]));
        let (s, c) = libm::sincos(self.displacement.1);
        p.to[0] += distance * self.displacement.0 * c;
        p.to[2] += distance * self.displacement.0 * s;
        p.to[1] += speed * self.velocity.0;
        p.to[3] += speed * self.velocity.1;
        p.u_max *= self.thrust;
        p
    }
}

/// Neighbours tried when a problem does not solve directly.
pub(crate) const DETOURS: [Detour; 14] = [
    Detour::moved(0.12, 0.4),
    Detour::moved(0.12, 0.4 + 1.5 * PI),
    Detour::moved(0.12, 0.4 + 0.5 * PI),
    Detour::moved(0.12, 0.4 + PI),
    Detour::stronger(0.94),
    Detour::stronger(1.08),
    Detour::faster(0.1, 0.05),
    Detour::faster(-0.1, -0.05),
    Detour::faster(-0.05, 0.1),
    Detour::faster(0.05, -0.1),
    Detour::moved(0.5, 0.9),
    Detour::moved(0.5, 0.9 + PI),
    Detour::moved(0.5, 0.9 + 0.5 * PI),
    Detour::moved(0.5, 0.9 + 1.5 * PI),
];
/// Dimensionless displacement below which it is the turning that takes the time.
const SHORT_DISTANCE: f64 = 5.0;

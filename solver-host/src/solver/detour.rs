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
    /// It is the start's velocity that changes.
    start: bool,
    /// Factor on the upper thrust limit.
    thrust: f64,
}

impl Detour {
    const fn moved(length: f64, direction: f64) -> Self {
        Self { displacement: (length, direction), velocity: (0.0, 0.0), start: false, thrust: 1.0 }
    }

    const fn faster(horizontal: f64, vertical: f64) -> Self {
        Self { displacement: (0.0, 0.0), velocity: (horizontal, vertical), start: false, thrust: 1.0 }
    }

    /// As [`Self::faster`] is for the problem backwards.
    const fn begun(horizontal: f64, vertical: f64) -> Self {
        Self { start: true, ..Self::faster(horizontal, vertical) }
    }

    const fn stronger(thrust: f64) -> Self {
        Self { displacement: (0.0, 0.0), velocity: (0.0, 0.0), start: false, thrust }
    }

    /// The problem displaced; to the other side where `orientation` is −1.
    pub(crate) fn apply(&self, problem: &Problem, orientation: f64) -> Problem {
        let mut p = *problem;
        let (f, g) = (&problem.from, &problem.to);
        let distance = libm::hypot(g[0] - f[0], g[2] - f[2]).max(SHORT_DISTANCE);
        let speed = libm::hypot(f[1], f[3]).max(libm::hypot(g[1], g[3]));
        let (s, c) = libm::sincos(self.displacement.1);
        p.to[0] += orientation * distance * self.displacement.0 * c;
        p.to[2] += distance * self.displacement.0 * s;
        let state = if self.start { &mut p.from } else { &mut p.to };
        state[1] += orientation * speed * self.velocity.0;
        state[3] += speed * self.velocity.1;
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
    Detour::begun(-0.1, -0.05),
    Detour::faster(-0.05, 0.1),
    Detour::begun(0.05, -0.1),
    Detour::moved(0.5, 0.9),
    Detour::moved(0.5, 0.9 + PI),
    Detour::moved(0.5, 0.9 + 0.5 * PI),
    Detour::moved(0.5, 0.9 + 1.5 * PI),
];
/// Dimensionless displacement below which it is the turning that takes the time.
const SHORT_DISTANCE: f64 = 5.0;

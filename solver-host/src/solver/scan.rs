//! The switching functions along a bang: where they are on the wrong side of zero.

use mintime_shared::minimum_principle::Costate;

use super::linearise::Node;
use super::problem::Problem;
use super::structure::Piece;

/// Largest angle between samples of the switching functions, rad.
const SAMPLE_ANGLE: f64 = 0.12;
/// Further samples in the first and last step, as parts of it.
const NEAR_THE_ENDS: [f64; 2] = [1.0 / 512.0, 1.0 / 16.0];

/// One sample of a bang.
#[derive(Clone, Copy)]
pub(crate) struct Sample {
    /// Angle since the piece began.
    pub(crate) a: f64,
    pub(crate) h: f64,
    pub(crate) phi_t: f64,
}

/// h and Φ_T along a bang, ends included. Next to the ends the samples stand closer: where a switch should have become
/// an arc, h dips below zero right beside it, for less than a whole step.
pub(crate) fn sample(
    problem: &Problem,
    mu: f64,
    costate: &Costate<f64>,
    piece: &Piece,
    node: &Node,
    mut each: impl FnMut(Sample),
) {
    let count = (piece.length / SAMPLE_ANGLE) as usize + 2;
    let step = piece.length / count as f64;
    let sign = piece.sign();
    let thrust = problem.thrust(piece.inputs.thrust);
    let (s0, c0) = libm::sincos(node.state[4]);
    let mut look = |a: f64, (s, c): (f64, f64)| {
        let t = node.t + mu * a;
        // ∫(sin θ, cos θ) dt at constant rate.
        let vx = node.state[1] + thrust * mu * sign * (c0 - c);
        let vz = node.state[3] + thrust * mu * sign * (s - s0) - mu * a;
        let (p2, p4) = (costate.p2(t), costate.p4(t));
        let phi_t = p2 * s + p4 * c;
        each(Sample { a, h: 1.0 + costate.c1 * vx + costate.c3 * vz + thrust * phi_t - p4, phi_t });
    };
    let direction = |a: f64| libm::sincos(node.state[4] + sign * a);
    look(0.0, (s0, c0));
    for a in NEAR_THE_ENDS.map(|part| part * step) {
        look(a, direction(a));
    }
    let (ds, dc) = libm::sincos(sign * step);
    let (mut s, mut c) = (s0, c0);
    for i in 1..count {
        (s, c) = (s * dc + c * ds, c * dc - s * ds);
        look(step * i as f64, (s, c));
    }
    for a in NEAR_THE_ENDS.map(|part| piece.length - part * step).into_iter().rev().chain([piece.length]) {
        look(a, direction(a));
    }
}

/// h and Φ_T at one angle of a bang.
pub(crate) fn exact(
    problem: &Problem,
    mu: f64,
    costate: &Costate<f64>,
    piece: &Piece,
    node: &Node,
    a: f64,
) -> Sample {
    let thrust = problem.thrust(piece.inputs.thrust);
    let sign = piece.sign();
    let (s0, c0) = libm::sincos(node.state[4]);
    let (s, c) = libm::sincos(node.state[4] + sign * a);
    let t = node.t + mu * a;
    let vx = node.state[1] + thrust * mu * sign * (c0 - c);
    let vz = node.state[3] + thrust * mu * sign * (s - s0) - mu * a;
    let p4 = costate.p4(t);
    let phi_t = costate.p2(t) * s + p4 * c;
    Sample { a, h: 1.0 + costate.c1 * vx + costate.c3 * vz + thrust * phi_t - p4, phi_t }
}

/// An interval of a bang on which a function that should not be negative is.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Run {
    pub(crate) piece: usize,
    /// Angles where it begins and ends.
    pub(crate) from: f64,
    pub(crate) to: f64,
    /// Angle of the worst sample.
    pub(crate) at: f64,
    pub(crate) depth: f64,
}

/// Finds the deepest run of negative values in a sequence of samples.
pub(crate) struct Scan {
    piece: usize,
    tolerance: f64,
    /// The last two samples, latest first.
    previous: [Option<(f64, f64)>; 2],
    /// Where the parabola through three samples dips below zero although they do not: angle and half the second
    /// derivative.
    pub(crate) dips: heapless::Vec<(f64, f64), 4>,
    open: Option<Run>,
    worst: Option<Run>,
}

impl Scan {
    pub(crate) fn new(piece: usize, tolerance: f64) -> Self {
        Self { piece, tolerance, previous: [None; 2], dips: heapless::Vec::new(), open: None, worst: None }
    }

    /// Notes a dip between samples.
    fn look_between(&mut self, a: f64, value: f64) {
        let [Some((b, v)), Some((c, w))] = self.previous else { return };
        // The parabola through the three, by divided differences.
        let first = (v - w) / (b - c);
        let curvature = ((value - v) / (a - b) - first) / (a - c);
        if value < 0.0 || v < 0.0 || w < 0.0 || curvature.is_nan() || curvature <= 0.0 {
            return;
        }
        let slope = first + curvature * (b - c);
        let at = b - slope / (2.0 * curvature);
        let least = v - slope * slope / (4.0 * curvature);
        if least < -self.tolerance && at > c && at < a {
            // More than four dips in one piece: the first are mended first.
            let _ = self.dips.push((at, curvature));
        }
    }

    /// A dip's true value.
    pub(crate) fn dip(&mut self, at: f64, curvature: f64, value: f64, length: f64) {
        if value < 0.0 {
            let half = libm::sqrt(-value / curvature);
            let (from, to) = ((at - half).max(0.0), (at + half).min(length));
            self.close(Run { piece: self.piece, from, to, at, depth: -value });
        }
    }

    pub(crate) fn add(&mut self, a: f64, value: f64) {
        self.look_between(a, value);
        let crossing = match self.previous[0] {
            Some((b, v)) if (v < 0.0) != (value < 0.0) => b + (a - b) * v / (v - value),
            _ => a,
        };
        if value < 0.0 {
            let run =
                self.open.get_or_insert(Run { piece: self.piece, from: crossing, to: a, at: a, depth: 0.0 });
            run.to = a;
            if -value > run.depth {
                run.depth = -value;
                run.at = a;
            }
        } else if let Some(mut run) = self.open.take() {
            run.to = crossing;
            self.close(run);
        }
        self.previous = [Some((a, value)), self.previous[0]];
    }

    fn close(&mut self, run: Run) {
        if run.depth > self.tolerance {
            self.worst = worse(self.worst, Some(run));
        }
    }

    pub(crate) fn finish(mut self, length: f64) -> Option<Run> {
        if let Some(mut run) = self.open.take() {
            run.to = length;
            self.close(run);
        }
        self.worst
    }
}

/// The deeper of two runs.
pub(crate) fn worse(a: Option<Run>, b: Option<Run>) -> Option<Run> {
    match (a, b) {
        (Some(x), Some(y)) => Some(if y.depth > x.depth { y } else { x }),
        (x, y) => x.or(y),
    }
}

//! What an extremal's boundaries between segments must satisfy, and the numbers of an arc: values and derivatives.

use super::linearise::Node;
use super::structure::Piece;

/// What must vanish at a boundary.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Condition {
    /// h = H − Φ_R u_R, that is Φ_R = 0 by H = 0.
    RateFree,
    /// Φ_T, eq. (29).
    ThrustSwitch,
    /// Φ̇_R/u_T, eq. (37).
    Tangency,
}

/// The conditions between two pieces.
pub(crate) fn boundary(before: &Piece, after: &Piece) -> [Option<Condition>; 2] {
    if after.is_arc() {
        return [Some(Condition::RateFree), Some(Condition::Tangency)];
    }
    if before.is_arc() {
        return [None, None];
    }
    let rate = (before.inputs.rate != after.inputs.rate).then_some(Condition::RateFree);
    let thrust = (before.inputs.thrust != after.inputs.thrust).then_some(Condition::ThrustSwitch);
    [rate, thrust]
}

/// Value of a condition and its partial derivatives.
pub(crate) struct Gradient {
    pub(crate) value: f64,
    pub(crate) vx: f64,
    pub(crate) vz: f64,
    pub(crate) theta: f64,
    pub(crate) t: f64,
    pub(crate) thrust: f64,
    pub(crate) c: [f64; 4],
}

pub(crate) fn gradient(kind: Condition, c: &[f64; 4], node: &Node, u: f64, (s, co): (f64, f64)) -> Gradient {
    let t = node.t;
    let [c1, c2, c3, c4] = *c;
    let (p2, p4) = (c2 - c1 * t, c4 - c3 * t);
    let phi_t = p2 * s + p4 * co;
    let across = p2 * co - p4 * s;
    match kind {
        Condition::RateFree => Gradient {
            value: 1.0 + c1 * node.state[1] + c3 * node.state[3] + u * phi_t - p4,
            vx: c1,
            vz: c3,
            theta: u * across,
            t: c3 - u * (c1 * s + c3 * co),
            thrust: phi_t,
            c: [node.state[1] - u * t * s, u * s, node.state[3] - u * t * co + t, u * co - 1.0],
        },
        Condition::ThrustSwitch => Gradient {
            value: phi_t,
            vx: 0.0,
            vz: 0.0,
            theta: across,
            t: -(c1 * s + c3 * co),
            thrust: 0.0,
            c: [-t * s, s, -t * co, co],
        },
        Condition::Tangency => Gradient {
            value: -across,
            vx: 0.0,
            vz: 0.0,
            theta: phi_t,
            t: c1 * co - c3 * s,
            thrust: 0.0,
            c: [t * co, -co, -t * s, s],
        },
    }
}

/// The two numbers of an arc entered at time t, and their derivatives.
pub(crate) struct ArcData {
    pub(crate) rate: f64,
    pub(crate) drift: f64,
    pub(crate) rate_by_t: f64,
    pub(crate) drift_by_t: f64,
    pub(crate) rate_by_c: [f64; 4],
    pub(crate) drift_by_c: [f64; 4],
}

impl ArcData {
    pub(crate) fn new(c: &[f64; 4], t: f64) -> Self {
        let [c1, c2, c3, c4] = *c;
        let (p2, p4) = (c2 - c1 * t, c4 - c3 * t);
        let inverse = 1.0 / (p2 * p2 + p4 * p4);
        let rate = (c2 * c3 - c1 * c4) * inverse;
        let drift = (p2 * c1 + p4 * c3) * inverse;
        let norm_by_c = [-2.0 * t * p2, 2.0 * p2, -2.0 * t * p4, 2.0 * p4];
        let rate_by = [-c4, c3, c2, -c1];
        let drift_by = [p2 - t * c1, c1, p4 - t * c3, c3];
        Self {
            rate,
            drift,
            rate_by_t: 2.0 * rate * drift,
            drift_by_t: drift * drift - rate * rate,
            rate_by_c: core::array::from_fn(|k| (rate_by[k] - rate * norm_by_c[k]) * inverse),
            drift_by_c: core::array::from_fn(|k| (drift_by[k] - drift * norm_by_c[k]) * inverse),
        }
    }
}

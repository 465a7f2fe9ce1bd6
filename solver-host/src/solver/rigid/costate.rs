//! A costate for a maneuver whose costate is not unique: from its arc, or a point of the polyhedron that the laws leave.

use mintime_shared::model::{State, ThrustLevel};
use mintime_shared::motion::{advance, bang};

use super::super::events::trace;
use super::super::polyhedron::{Law, least_costate};
use super::super::problem::Problem;
use super::super::structure::{Candidate, Piece};
use super::BANGS;

/// Samples of each piece at which the laws are asked for.
const SAMPLES: usize = 16;

/// c from the arc's two numbers and h = 0 on it. `None` where p would not point against the thrust.
pub(super) fn costate_of_arc(
    problem: &Problem,
    candidate: &Candidate,
    [rate, drift]: [f64; 2],
) -> Option<[f64; 4]> {
    let index = candidate.pieces.iter().position(Piece::is_arc)?;
    let node = trace(problem, 1.0, &Candidate { c: [0.0, 0.0, 0.0, -1.0], ..candidate.clone() })[index];
    let [_, vx, _, vz, theta] = node.state;
    let (s, c) = libm::sincos(theta);
    // (p2, p4) = −λ (s, c) at the entry, (c1, c3) = drift·p + rate·p rotated by a quarter turn, and h = 0.
    let (along, across) = (drift * s - rate * c, drift * c + rate * s);
    let inverse = along * vx + across * vz + problem.u_max - c;
    if inverse.is_nan() || inverse <= 0.0 {
        return None;
    }
    let lambda = 1.0 / inverse;
    let (c1, c3) = (-lambda * along, -lambda * across);
    Some([c1, -lambda * s + c1 * node.t, c3, -lambda * c + c3 * node.t])
}

/// A costate that satisfies the laws of bangs, if there is one.
pub(super) fn costate_of_bangs(problem: &Problem, candidate: &Candidate) -> Option<[f64; 4]> {
    let mut list: heapless::Vec<Law, { BANGS * (2 * SAMPLES + 3) }> = heapless::Vec::new();
    let nodes = trace(problem, 1.0, candidate);
    let switch_of =
        |rate: bool, t: f64| {
            let pairs = candidate.pieces.iter().zip(candidate.pieces.iter().skip(1)).zip(&nodes[1..]);
            pairs
                .filter(|((a, b), _)| {
                    if rate { a.inputs.rate != b.inputs.rate } else { a.inputs.thrust != b.inputs.thrust }
                })
                .map(|(_, node)| (node.t - t).abs())
                .fold(1.0, f64::min)
        };
    for (i, piece) in candidate.pieces.iter().enumerate() {
        let thrust = problem.thrust(piece.inputs.thrust);
        let sign = if piece.inputs.thrust == ThrustLevel::Max { -1.0 } else { 1.0 };
        let node = nodes[i];
        if let Some(before) = i.checked_sub(1).map(|j| candidate.pieces[j]) {
            let (h, phi_t) = laws(node.t, &node.state, thrust);
            let (row, offset) = if before.inputs.rate != piece.inputs.rate { h } else { phi_t };
            list.push(Law { row, offset, equal: true, room: 0.0 }).ok()?;
        }
        for j in 0..=SAMPLES {
            let tau = piece.length * j as f64 / SAMPLES as f64;
            let turn = bang(piece.sign(), tau);
            let state = advance(State::from_array(node.state), thrust, 1.0, tau, &turn);
            let t = node.t + tau;
            let ((row, offset), phi_t) = laws(t, &state.to_array(), thrust);
            list.push(Law { row, offset, equal: false, room: switch_of(true, t) }).ok()?;
            let row = phi_t.0.map(|r| sign * r);
            list.push(Law { row, offset: phi_t.1, equal: false, room: switch_of(false, t) }).ok()?;
        }
    }
    // As much room as there is between the samples; where a switching function leaves zero it grows with the time.
    ROOM.iter().find_map(|room| least_costate(&list, *room))
}

/// Distances that the inequalities keep, relative to the time from the next switch, most first.
const ROOM: [f64; 5] = [1e-2, 1e-3, 1e-4, 1e-5, 1e-7];

/// h and Φ_T as (row, offset): offset + row·c.
type Affine = ([f64; 4], f64);

fn laws(t: f64, state: &[f64; 5], thrust: f64) -> (Affine, Affine) {
    let (s, c) = libm::sincos(state[4]);
    let (a, b) = (thrust * s, thrust * c - 1.0);
    (([state[1] - t * a, a, state[3] - t * b, b], 1.0), ([-t * s, s, -t * c, c], 0.0))
}

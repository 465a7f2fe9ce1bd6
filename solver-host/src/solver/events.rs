//! Where a converged iterate breaks a law, and how its structure must change.

use mintime_shared::minimum_principle::Costate;
use mintime_shared::model::{RateMode, State, ThrustLevel};
use mintime_shared::motion::{Arc, advance, bang, singular};

use super::linearise::Node;
use super::problem::Problem;
use super::scan::{Run, Scan, exact, sample, worse};
use super::structure::{Candidate, INSERTED_LENGTH, MAX_SEGMENTS, Piece, opposite};

/// Lengths below minus this are negative.
const NEGATIVE: f64 = 1e-12;
/// A bang up to this angle between two arcs does nothing, rad.
const IDLE: f64 = 1e-7;
/// Violations of the laws (dimensionless, relative to |p| or 1) up to this are rounding.
const LAW_TOLERANCE: f64 = 1e-9;
/// Relative excess of the rate limit on an arc that still counts as rounding.
const RATE_TOLERANCE: f64 = 1e-9;
/// What happened.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Repair {
    /// Every law holds.
    None,
    /// The structure was changed: solve again.
    Changed,
    /// No structure change helps here.
    Stuck,
}

/// Checks the laws in the order negative lengths, arc rate, thrust, rate, and repairs the worst violation of the first
/// kind found.
pub(crate) fn repair(problem: &Problem, mu: f64, candidate: &mut Candidate) -> Repair {
    if let Some(index) = most_negative(candidate) {
        return done(drop_piece(candidate, index));
    }
    let nodes = trace(problem, mu, candidate);
    let costate = Costate::from_array(candidate.c);
    let mut worst_arc: Option<(usize, f64)> = None;
    for (i, piece) in candidate.pieces.iter().enumerate() {
        if piece.is_arc() {
            let node = &nodes[i];
            let scale = libm::hypot(costate.p2(node.t), costate.p4(node.t));
            if costate.phi_t(node.t, node.state[4]) > 1e-3 * scale {
                return Repair::Stuck;
            }
            let excess = costate.arc(node.t).peak_rate(piece.length) * mu - 1.0;
            if excess > RATE_TOLERANCE && worst_arc.is_none_or(|(_, w)| excess > w) {
                worst_arc = Some((i, excess));
            }
        }
    }
    if let Some((index, _)) = worst_arc {
        return done(split_arc(candidate, index, &nodes[index], mu));
    }
    let mut thrust_run: Option<Run> = None;
    let mut rate_run: Option<Run> = None;
    for (i, piece) in candidate.pieces.iter().enumerate() {
        if piece.is_arc() || piece.length <= 0.0 {
            continue;
        }
        let scale = 1.0 + libm::hypot(costate.p2(nodes[i].t), costate.p4(nodes[i].t));
        let sign = if piece.inputs.thrust == ThrustLevel::Max { -1.0 } else { 1.0 };
        let mut thrust_scan = Scan::new(i, LAW_TOLERANCE * scale);
        let mut rate_scan = Scan::new(i, LAW_TOLERANCE * scale);
        sample(problem, mu, &costate, piece, &nodes[i], |s| {
            thrust_scan.add(s.a, sign * s.phi_t);
            rate_scan.add(s.a, s.h);
        });
        for (at, curvature) in thrust_scan.dips.clone() {
            let phi_t = exact(problem, mu, &costate, piece, &nodes[i], at).phi_t;
            thrust_scan.dip(at, curvature, sign * phi_t, piece.length);
        }
        for (at, curvature) in rate_scan.dips.clone() {
            let h = exact(problem, mu, &costate, piece, &nodes[i], at).h;
            rate_scan.dip(at, curvature, h, piece.length);
        }
        thrust_run = worse(thrust_run, thrust_scan.finish(piece.length));
        rate_run = worse(rate_run, rate_scan.finish(piece.length));
    }
    if let Some(run) = thrust_run {
        return done(flip_thrust(candidate, &run));
    }
    if let Some(run) = rate_run {
        return done(change_rate(candidate, &run, mu));
    }
    Repair::None
}

fn done(changed: bool) -> Repair {
    if changed { Repair::Changed } else { Repair::Stuck }
}

/// States between the pieces.
pub(crate) fn trace(problem: &Problem, mu: f64, candidate: &Candidate) -> [Node; MAX_SEGMENTS + 1] {
    let mut nodes = [Node::default(); MAX_SEGMENTS + 1];
    let costate = Costate::from_array(candidate.c);
    let mut state = State::from_array(problem.from);
    let mut t = 0.0;
    for (i, piece) in candidate.pieces.iter().enumerate() {
        nodes[i] = Node { t, state: state.to_array() };
        let tau = piece.duration(mu);
        let turn = if piece.is_arc() { singular(costate.arc(t), tau) } else { bang(piece.sign() / mu, tau) };
        state = advance(state, problem.thrust(piece.inputs.thrust), 1.0, tau, &turn);
        t += tau;
    }
    nodes[candidate.pieces.len()] = Node { t, state: state.to_array() };
    nodes
}

fn most_negative(candidate: &Candidate) -> Option<usize> {
    let mut worst = None;
    let mut least = -NEGATIVE;
    let arc = |i: usize| candidate.pieces.get(i).is_some_and(Piece::is_arc);
    for (i, piece) in candidate.pieces.iter().enumerate() {
        // Between two arcs a bang of no length may stand anywhere: the system is singular unless it goes.
        let idle = piece.length < IDLE && i > 0 && arc(i - 1) && arc(i + 1);
        if piece.length < least || idle {
            least = piece.length.min(least);
            worst = Some(i);
        }
    }
    worst
}

/// Removes a piece whose length became negative and mends the boundary it leaves.
pub(crate) fn drop_piece(candidate: &mut Candidate, index: usize) -> bool {
    let n = candidate.pieces.len();
    if n < 2 {
        return false;
    }
    let piece = candidate.pieces[index];
    for neighbour in [index.wrapping_sub(1), index + 1] {
        // Two neighbours that vanish together: dropping one would only swap their switches back and forth.
        let other = candidate.pieces.get(neighbour).copied();
        if n > 3 && other.is_some_and(|o| o.length < 0.0 && !o.is_arc()) && !piece.is_arc() {
            candidate.pieces.remove(index.max(neighbour));
            candidate.pieces.remove(index.min(neighbour));
            return candidate.normalise();
        }
    }
    let at_end = index == 0 || index + 1 == n;
    if at_end {
        let neighbour = candidate.pieces[if index == 0 { 1 } else { n - 2 }];
        if neighbour.is_arc() && !piece.is_arc() {
            // Turning onto the arc the other way round.
            let end = &mut candidate.pieces[index];
            end.inputs.rate = opposite(piece.inputs.rate);
            end.length = piece.length.abs();
            return true;
        }
        candidate.pieces.remove(index);
        return candidate.normalise();
    }
    candidate.pieces.remove(index);
    let (before, after) = (candidate.pieces[index - 1], candidate.pieces[index]);
    let both = before.inputs.rate != after.inputs.rate && before.inputs.thrust != after.inputs.thrust;
    if both && !before.is_arc() && !after.is_arc() {
        // The two switches changed places.
        let swapped = if piece.inputs.rate == before.inputs.rate {
            Piece::bang(after.inputs.rate, before.inputs.thrust, piece.length.abs())
        } else {
            Piece::bang(before.inputs.rate, after.inputs.thrust, piece.length.abs())
        };
        return candidate.insert(index, swapped);
    }
    candidate.normalise()
}

/// Splits an arc that turns faster than the limit by a bang around its fastest point.
fn split_arc(candidate: &mut Candidate, index: usize, node: &Node, mu: f64) -> bool {
    let piece = candidate.pieces[index];
    let arc = Costate::from_array(candidate.c).arc(node.t);
    let k2 = arc.rate * arc.rate + arc.drift * arc.drift;
    let rate = if arc.rate > 0.0 { RateMode::Plus } else { RateMode::Minus };
    // Not `clamp`: a length that rounding made negative must not matter here.
    let nearest = (arc.drift / k2).min(piece.length).max(0.0);
    // Where the fastest point is an end of the arc and a bang the other way is next to it, the new bang goes between
    // them. With the rate rising linearly to the end, a time s after it crosses the limit, Φ_R returns to zero for a
    // bang of 1.5 s.
    let too_fast = fast_part(&arc, piece.length, mu);
    let turned_by = |i: Option<&Piece>| i.is_some_and(|p| p.inputs.rate == opposite(rate));
    let bang = |time: f64| Piece::bang(rate, ThrustLevel::Max, (time / mu).max(INSERTED_LENGTH));
    if nearest >= piece.length && turned_by(candidate.pieces.get(index + 1)) {
        let time = (1.5 * (piece.length - too_fast.0)).min(0.9 * piece.length);
        candidate.pieces[index].length -= time;
        return candidate.insert(index + 1, bang(time));
    }
    if nearest <= 0.0 && index > 0 && turned_by(candidate.pieces.get(index - 1)) {
        let time = (1.5 * too_fast.1).min(0.9 * piece.length);
        candidate.pieces[index].length -= time;
        return candidate.insert(index, bang(time));
    }
    let peak = arc.advanced(nearest);
    let excess = (peak.rate.abs() * mu - 1.0).max(0.0);
    // Near the peak u_R = x(1 − x²s²): the bang covers the same angle, so its half length is √3 times the half width
    // of the part that is too fast.
    let half = libm::sqrt(3.0 * excess) / peak.rate.abs();
    let before = (nearest - half).max(0.02 * piece.length);
    let after = (piece.length - nearest - half).max(0.02 * piece.length);
    candidate.pieces[index].length = before;
    candidate.insert(index + 1, bang(2.0 * half)) && candidate.insert(index + 2, Piece::arc(after))
}

/// Where |u_R| exceeds the limit on an arc of the given length.
fn fast_part(arc: &Arc<f64>, length: f64, mu: f64) -> (f64, f64) {
    // |x| μ = Q² = 1 − 2dσ + k²σ²
    let k2 = arc.rate * arc.rate + arc.drift * arc.drift;
    let centre = arc.drift / k2;
    let half = libm::sqrt((centre * centre - (1.0 - arc.rate.abs() * mu) / k2).max(0.0));
    ((centre - half).min(length).max(0.0), (centre + half).min(length).max(0.0))
}

/// Flips the thrust on a run.
fn flip_thrust(candidate: &mut Candidate, run: &Run) -> bool {
    let piece = candidate.pieces[run.piece];
    let other = match piece.inputs.thrust {
        ThrustLevel::Min => ThrustLevel::Max,
        ThrustLevel::Max => ThrustLevel::Min,
    };
    cut(candidate, run, Piece::bang(piece.inputs.rate, other, run.to - run.from)) && candidate.normalise()
}

/// Replaces the run of a piece by `middle`, keeping what lies before and after it.
fn cut(candidate: &mut Candidate, run: &Run, middle: Piece) -> bool {
    let piece = candidate.pieces[run.piece];
    let (before, after) = (run.from, piece.length - run.to);
    candidate.pieces[run.piece] = middle;
    let mut ok = true;
    if after > 1e-9 {
        ok &= candidate.insert(run.piece + 1, Piece { length: after, ..piece });
    }
    if before > 1e-9 {
        ok &= candidate.insert(run.piece, Piece { length: before, ..piece });
    }
    ok
}

/// Mends a run on which h < 0, that is Φ_R has the sign of u_R.
fn change_rate(candidate: &mut Candidate, run: &Run, mu: f64) -> bool {
    let n = candidate.pieces.len();
    let i = run.piece;
    let piece = candidate.pieces[i];
    let width = run.to - run.from;
    let other = opposite(piece.inputs.rate);
    let at_start = run.from <= 1e-9;
    let at_stop = run.to >= piece.length - 1e-9;
    if i == 0 && at_start {
        // A maneuver that begins by turning back: the piece grows by what the new one takes away.
        candidate.pieces[0].length += width;
        return candidate.insert(0, Piece { length: width, ..Piece::bang(other, piece.inputs.thrust, 0.0) })
            && candidate.normalise();
    }
    if i + 1 == n && at_stop {
        candidate.pieces[i].length += width;
        return candidate.push(Piece::bang(other, piece.inputs.thrust, width)) && candidate.normalise();
    }
    let max_thrust = piece.inputs.thrust == ThrustLevel::Max;
    let switch = |j: usize, k: usize| {
        let (a, b) = (candidate.pieces[j], candidate.pieces[k]);
        !a.is_arc() && !b.is_arc() && a.inputs.rate != b.inputs.rate
    };
    let boundary = if at_start && i > 0 && switch(i - 1, i) {
        Some(i)
    } else if at_stop && i + 1 < n && switch(i, i + 1) {
        Some(i + 1)
    } else {
        None
    };
    if let Some(b) = boundary {
        if max_thrust {
            // Φ_R touches zero at the switch: an arc begins there.
            for j in [b - 1, b] {
                let length = &mut candidate.pieces[j].length;
                *length = (*length - 0.25 * width).max(0.5 * *length);
            }
            return candidate.insert(b, Piece::arc((0.5 * width * mu).max(INSERTED_LENGTH * mu)));
        }
        // No arc at minimum thrust: turn back for a moment on both sides of the switch.
        let (left, right) = (candidate.pieces[b - 1], candidate.pieces[b]);
        let (dl, dr) = (width.min(0.5 * left.length), width.min(0.5 * right.length));
        candidate.pieces[b - 1].length -= dl;
        candidate.pieces[b].length -= dr;
        return candidate.insert(b, Piece { length: dr, ..left })
            && candidate.insert(b, Piece { length: dl, ..right });
    }
    if max_thrust {
        let arc = Piece::arc((0.5 * width * mu).max(INSERTED_LENGTH * mu));
        let centre = run.at.clamp(run.from, run.to);
        let narrow = Run {
            from: (centre - 0.25 * width).max(0.0),
            to: (centre + 0.25 * width).min(piece.length),
            ..*run
        };
        return cut(candidate, &narrow, arc) && candidate.normalise();
    }
    cut(candidate, run, Piece::bang(other, ThrustLevel::Min, width)) && candidate.normalise()
}

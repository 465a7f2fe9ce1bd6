//! Maneuvers with fewer free numbers than end conditions: one to four bangs, an arc, an arc and a bang.
//!
//! The states they reach have no volume, so random requests do not meet them; but every optimum's own first and last
//! pieces are of this kind (Bellman), and whoever plans anew along a maneuver asks for them. Their costate is not
//! unique, so the square system is singular and the continuation loses its way just before the real rate limit. Here the
//! few numbers are fitted to the end state directly by damped least squares, and a costate is found afterwards:
//! from the arc's shape where there is an arc, c = 0 where the vehicle turns one way all the time, and otherwise a point
//! of the polyhedron that the laws (16) and (20), linear in c, leave.

mod costate;
mod fit;

use mintime_shared::model::{RateMode, ThrustLevel};

use super::problem::Problem;
use super::relax::Relaxation;
use super::starts::wrap;
use super::structure::{Candidate, Piece, opposite, turning};
use costate::{costate_of_arc, costate_of_bangs};
use fit::fit;

/// Bangs in a fitted sequence; fewer come out where lengths vanish.
const BANGS: usize = 4;
/// Numbers fitted.
const NUMBERS: usize = 5;
/// Equations: five end states, and Φ_T = 0 where the thrust switches before an arc.
const EQUATIONS: usize = 6;
/// Lengths up to this are zero.
const VANISHED: f64 = 1e-9;
/// What is fitted: the lengths of the pieces, then the arc's two numbers.
#[derive(Clone, Copy, Debug)]
struct Shape {
    pieces: [Piece; BANGS],
    count: usize,
    arc: bool,
}

/// What ends the enumeration.
pub(crate) struct Limit<'a> {
    /// Dimensionless T from which on a maneuver is of no interest.
    pub(crate) slower_than: f64,
    /// Asked before every fit.
    pub(crate) cancelled: &'a dyn Fn() -> bool,
}

/// Calls `found` with every maneuver of this kind that arrives, faster than the limit, until it is cancelled.
///
/// `deep` also tries bangs in both directions, some thirty sequences.
pub(crate) fn rigid(
    problem: &Problem,
    relaxed: &Relaxation,
    limit: &Limit<'_>,
    deep: bool,
    mut found: impl FnMut(Candidate),
) {
    let turn = problem.turn();
    for thrust in [ThrustLevel::Max, ThrustLevel::Min] {
        let mut pieces = [Piece::bang(turning(turn), thrust, 0.25 * turn.abs()); BANGS];
        for piece in pieces.iter_mut().skip(1).step_by(2) {
            piece.inputs.thrust = other(thrust);
        }
        let shape = Shape { pieces, count: BANGS, arc: false };
        if turn != 0.0 && turn.abs() < limit.slower_than {
            attempt(problem, shape, [0.0; 2], limit, &mut found);
        }
    }
    if !deep {
        return;
    }
    with_arc(problem, relaxed, limit, &mut found);
    // Backwards in time an arc and a bang are a bang and an arc.
    let reversed = problem.reversed();
    let [c1, c2, c3, c4] = relaxed.c;
    let t = relaxed.duration;
    let seen_back = Relaxation { c: [-c1, c2 - c1 * t, -c3, c4 - c3 * t], ..*relaxed };
    with_arc(&reversed, &seen_back, limit, &mut |mut candidate: Candidate| {
        candidate.reverse(candidate.duration(1.0));
        found(candidate);
    });
    both_ways(problem, relaxed, limit, &mut found);
}

/// One or two bangs (or none) and an arc, and a bang after it.
fn with_arc(problem: &Problem, relaxed: &Relaxation, limit: &Limit<'_>, found: &mut impl FnMut(Candidate)) {
    let costate = mintime_shared::minimum_principle::Costate::from_array(relaxed.c);
    let onto_arc = wrap(costate.singular_angle(0.0) - problem.from[4]);
    let arc = costate.arc(0.0);
    // A long bang leaves little of the relaxed solution; then the arc hardly turns.
    for (turn, numbers) in [(onto_arc, [arc.rate, arc.drift]), (problem.turn(), [0.0; 2])] {
        let bang = |thrust| Piece::bang(turning(turn), thrust, turn.abs());
        let rest = Piece::arc((relaxed.duration - turn.abs()).max(0.1 * relaxed.duration));
        let mut attempt = |pieces: [Piece; 3], count| {
            let pieces = [pieces[0], pieces[1], pieces[2], pieces[0]];
            attempt(problem, Shape { pieces, count, arc: true }, numbers, limit, found);
        };
        let first = bang(ThrustLevel::Max);
        attempt([first, rest, first], 2);
        let half = |thrust| Piece { length: 0.5 * turn.abs(), ..bang(thrust) };
        attempt([half(ThrustLevel::Min), half(ThrustLevel::Max), rest], 3);
        let left = problem.turn() - turn;
        for sign in [-1.0, 1.0] {
            let last = Piece::bang(turning(sign), ThrustLevel::Max, (sign * left).max(0.1));
            attempt([first, rest, last], 3);
        }
    }
}

/// Bangs in both directions.
fn both_ways(problem: &Problem, relaxed: &Relaxation, limit: &Limit<'_>, found: &mut impl FnMut(Candidate)) {
    let turn = problem.turn();
    let total = relaxed.duration.max(turn.abs());
    for first in 0..4_u8 {
        let rate = if first & 1 == 0 { RateMode::Plus } else { RateMode::Minus };
        let thrust = if first & 2 == 0 { ThrustLevel::Max } else { ThrustLevel::Min };
        // Each bit says whether the next switch changes the rate or the thrust; 0 would turn one way only.
        for switches in 1..8_u8 {
            let mut piece = Piece::bang(rate, thrust, 0.0);
            let mut pieces = [piece; BANGS];
            for (i, next) in pieces.iter_mut().enumerate().skip(1) {
                if switches & (1 << (i - 1)) != 0 {
                    piece.inputs.rate = opposite(piece.inputs.rate);
                } else {
                    piece.inputs.thrust = other(piece.inputs.thrust);
                }
                *next = piece;
            }
            // The turns one way and the other add up to the total, their difference is the turn asked for.
            for stretch in STRETCHES {
                for piece in &mut pieces {
                    let share = 0.5 * (stretch * total + piece.sign() * turn);
                    let same = pieces_with(switches, piece.sign(), rate);
                    piece.length = share / f64::from(same);
                }
                let shape = Shape { pieces, count: BANGS, arc: false };
                attempt(problem, shape, [0.0; 2], limit, found);
            }
        }
    }
}

/// First guesses of T over its lower bound.
const STRETCHES: [f64; 2] = [1.1, 2.0];

/// How many of the four pieces turn towards `sign`.
fn pieces_with(switches: u8, sign: f64, first: RateMode) -> u8 {
    let mut rate = if first == RateMode::Minus { -1.0 } else { 1.0 };
    let mut count = u8::from(rate == sign);
    for i in 0..BANGS - 1 {
        if switches & (1 << i) != 0 {
            rate = -rate;
        }
        count += u8::from(rate == sign);
    }
    count.max(1)
}

fn other(thrust: ThrustLevel) -> ThrustLevel {
    match thrust {
        ThrustLevel::Min => ThrustLevel::Max,
        ThrustLevel::Max => ThrustLevel::Min,
    }
}

/// Fits one shape, finds its costate and hands it over.
fn attempt(
    problem: &Problem,
    mut shape: Shape,
    arc: [f64; 2],
    limit: &Limit<'_>,
    found: &mut impl FnMut(Candidate),
) {
    if (limit.cancelled)() {
        return;
    }
    let Some(arc) = fit(problem, &mut shape, arc) else { return };
    // What has vanished goes, and what then meets its like joins it; what is left is fitted again, now regular.
    let before = shape.count;
    shape.tidy();
    let arc = if shape.count < before {
        let Some(arc) = fit(problem, &mut shape, arc) else { return };
        arc
    } else {
        arc
    };
    let duration: f64 = shape.pieces[..shape.count].iter().map(|p| p.length).sum();
    if shape.count == 0 || duration >= limit.slower_than {
        return;
    }
    let mut candidate = Candidate { pieces: heapless::Vec::new(), c: [0.0; 4] };
    if !shape.pieces[..shape.count].iter().all(|p| p.length > 0.0 && candidate.push(*p)) {
        return;
    }
    let one_way = candidate.pieces.iter().all(|p| !p.is_arc() && p.sign() == candidate.pieces[0].sign());
    let c = if shape.arc {
        costate_of_arc(problem, &candidate, arc)
    } else if one_way {
        Some([0.0; 4])
    } else {
        costate_of_bangs(problem, &candidate)
    };
    if let Some(c) = c {
        candidate.c = c;
        found(candidate);
    }
}

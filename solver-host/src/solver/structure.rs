//! A candidate's structure: which inputs follow each other, without durations.

use heapless::Vec;
use mintime_shared::model::{Inputs, RateMode, ThrustLevel};

/// Most segments a maneuver may have. Rest to rest needs at most 9, moving ends at most 13 in all problems seen; the
/// rest is room for structures on their way through the continuation.
pub const MAX_SEGMENTS: usize = 24;

/// Unknowns of the square system: one length per segment and the four constants of eq. (9).
pub(crate) const MAX_UNKNOWNS: usize = MAX_SEGMENTS + 4;

/// A segment and its length: the *angle* of a bang (duration over μ, so that μ → 0 is regular), the duration of an arc.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Piece {
    pub(crate) inputs: Inputs,
    pub(crate) length: f64,
}

impl Piece {
    pub(crate) fn bang(rate: RateMode, thrust: ThrustLevel, length: f64) -> Self {
        Self { inputs: Inputs { rate, thrust }, length }
    }

    pub(crate) fn arc(length: f64) -> Self {
        Self { inputs: Inputs { rate: RateMode::Singular, thrust: ThrustLevel::Max }, length }
    }

    pub(crate) fn is_arc(&self) -> bool {
        self.inputs.rate == RateMode::Singular
    }

    /// Turning direction of a bang, 0 for an arc.
    pub(crate) fn sign(&self) -> f64 {
        match self.inputs.rate {
            RateMode::Plus => 1.0,
            RateMode::Minus => -1.0,
            RateMode::Singular => 0.0,
        }
    }

    /// Dimensionless duration at the inverse rate limit `mu`.
    pub(crate) fn duration(&self, mu: f64) -> f64 {
        if self.is_arc() { self.length } else { self.length * mu }
    }
}

/// The opposite rate limit; an arc stays an arc.
pub(crate) fn opposite(rate: RateMode) -> RateMode {
    match rate {
        RateMode::Plus => RateMode::Minus,
        RateMode::Minus => RateMode::Plus,
        RateMode::Singular => RateMode::Singular,
    }
}

/// The rate limit that turns towards the sign of `direction`.
pub(crate) fn turning(direction: f64) -> RateMode {
    if direction < 0.0 { RateMode::Minus } else { RateMode::Plus }
}

/// A structure with its lengths and the translational costate constants: one iterate.
#[derive(Clone, Debug)]
pub(crate) struct Candidate {
    pub(crate) pieces: Vec<Piece, MAX_SEGMENTS>,
    pub(crate) c: [f64; 4],
}

impl Candidate {
    /// Total dimensionless duration at the inverse rate limit `mu`.
    pub(crate) fn duration(&self, mu: f64) -> f64 {
        self.pieces.iter().map(|p| p.duration(mu)).sum()
    }

    /// Number of unknowns of the square system.
    pub(crate) fn unknowns(&self) -> usize {
        self.pieces.len() + 4
    }

    /// Inserts a piece. False where there is no room.
    pub(crate) fn insert(&mut self, index: usize, piece: Piece) -> bool {
        self.pieces.insert(index, piece).is_ok()
    }

    /// Appends a piece. False where there is no room.
    pub(crate) fn push(&mut self, piece: Piece) -> bool {
        self.pieces.push(piece).is_ok()
    }

    /// The same maneuver run backwards, for the reversed problem: rates change sign, p(t) becomes p(T − t).
    pub(crate) fn reverse(&mut self, duration: f64) {
        self.pieces.reverse();
        for piece in &mut self.pieces {
            piece.inputs.rate = opposite(piece.inputs.rate);
        }
        let [c1, c2, c3, c4] = self.c;
        self.c = [-c1, c2 - c1 * duration, -c3, c4 - c3 * duration];
    }

    /// The mirror image in x.
    pub(crate) fn mirror(&mut self) {
        for piece in &mut self.pieces {
            piece.inputs.rate = opposite(piece.inputs.rate);
        }
        self.c[0] = -self.c[0];
        self.c[1] = -self.c[1];
    }

    /// Merges neighbours with equal inputs and repairs boundaries that no extremal has: thrust and rate switching at
    /// once, thrust switching at an arc (arcs are at maximum thrust).
    pub(crate) fn normalise(&mut self) -> bool {
        let mut i = 0;
        while i + 1 < self.pieces.len() {
            let (a, b) = (self.pieces[i], self.pieces[i + 1]);
            if a.inputs == b.inputs {
                self.pieces[i].length += b.length;
                self.pieces.remove(i + 1);
                continue;
            }
            let rates_differ = a.inputs.rate != b.inputs.rate;
            let thrusts_differ = a.inputs.thrust != b.inputs.thrust;
            if rates_differ && thrusts_differ {
                // A short maximum-thrust piece on the side that is at minimum thrust keeps the system square.
                let (position, rate) = if a.inputs.thrust == ThrustLevel::Min {
                    (i + 1, a.inputs.rate)
                } else {
                    (i + 1, b.inputs.rate)
                };
                if !self.insert(position, Piece::bang(rate, ThrustLevel::Max, INSERTED_LENGTH)) {
                    return false;
                }
                continue;
            }
            i += 1;
        }
        true
    }
}

/// Angle of a piece that only separates two others, rad: small, and not zero so that Newton sees a direction.
pub(crate) const INSERTED_LENGTH: f64 = 1e-3;

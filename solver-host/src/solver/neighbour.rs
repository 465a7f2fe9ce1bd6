//! From one maneuver to the next: the solution of a nearby request, carried over by continuation in the data.

use mintime_shared::model::{RateMode, ThrustLevel};

use super::extremal::Extremal;
use super::newton::Newton;
use super::path::{Bounds, Family, follow, settle};
use super::problem::{Direction, Problem};
use super::request::{Request, Turns};
use super::structure::{Candidate, Piece};

/// Evaluations a neighbour's maneuver may take to arrive; far neighbours are better solved from cold.
const BUDGET: u32 = 300;

impl Extremal {
    /// Back to the units of eq. (3).
    pub(crate) fn to_core(&self) -> Candidate {
        let mut candidate = Candidate { pieces: heapless::Vec::new(), c: self.costate.to_array() };
        for segment in &self.segments {
            let length = segment.duration * self.limits.rate_max_radps;
            // Capacities are equal, so there is room.
            let _ = candidate.push(Piece { inputs: segment.inputs, length });
        }
        candidate
    }

    /// The problem this is a solution of.
    pub(crate) fn problem(&self) -> Problem {
        Problem::new(self.from, self.to, &self.limits, self.turns)
    }
}

/// The winding that a request and a neighbour agree on.
pub(crate) fn common_turns(neighbour: &Extremal, request: &Request) -> Option<i32> {
    match request.turns {
        Turns::Any => Some(neighbour.turns),
        Turns::Exactly(k) => (k == neighbour.turns).then_some(k),
    }
}

/// Carries the neighbour's maneuver over. `None` where it does not arrive.
pub(crate) fn carry(
    newton: &mut Newton,
    neighbour: &Extremal,
    target: &Problem,
    cancelled: &dyn Fn() -> bool,
) -> Option<Candidate> {
    let base = neighbour.problem();
    let start = neighbour.to_core();
    if start.pieces.is_empty() || start.pieces.iter().any(|p| !is_allowed(p)) {
        return None;
    }
    let direction = Direction::between(&base, target);
    // One step if the neighbour is near: predicted along the tangent, corrected, checked.
    let mut candidate = start.clone();
    if newton.converge(&base, 1.0, &mut candidate, &direction).is_some() {
        candidate.shift(&newton.tangent, 1.0);
        let predicted = candidate.duration(1.0);
        if settle(newton, target, 1.0, &mut candidate, &Direction::MU, BUDGET).is_some()
            && (candidate.duration(1.0) / predicted - 1.0).abs() < ONE_STEP_MISS
        {
            return Some(candidate);
        }
    }
    candidate = start;
    let family = Family { base, mu: 1.0, direction };
    let bounds = Bounds { budget: BUDGET, slower_than: f64::INFINITY, monotone: false, cancelled };
    follow(newton, &family, &mut candidate, 0.0, &bounds).ok()?;
    Some(candidate)
}

/// Relative miss of the predicted T up to which a single step counts as having stayed on its branch.
const ONE_STEP_MISS: f64 = 0.02;

/// Arcs are at maximum thrust; anything else is no extremal and no start.
fn is_allowed(piece: &Piece) -> bool {
    piece.length.is_finite()
        && (piece.inputs.rate != RateMode::Singular || piece.inputs.thrust == ThrustLevel::Max)
}

//! One solved request as JSON. Field names are part of the interface.

use mintime::pack::{PackError, pack};
use mintime::solver::{Certificate, Request, Solution, SolveError, Turns, solve_all_windings};
use mintime_shared::model::{RateMode, ThrustLevel};
use mintime_shared::table::{ANY_VEHICLE, MAX_TABLE_BYTES, ManeuverTable};
use serde::Serialize;
use std::time::Instant;

/// A maneuver, its certificate and its costs. Costate, `hamiltonian` and `control_law` are dimensionless, H = 0 with
/// the constant 1 of eq. (7); everything else is SI.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct Answer {
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) name: Option<String>,
    pub(crate) duration_s: f64,
    pub(crate) turns: i32,
    pub(crate) segments: Vec<AnswerSegment>,
    /// `null` where T = 0: there is none.
    pub(crate) costate: Option<[f64; 4]>,
    pub(crate) certificate: Certificate,
    pub(crate) alternatives: Vec<AnswerAlternative>,
    /// Windings that could have won but were not solved.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub(crate) unsolved: Vec<i32>,
    pub(crate) solve_time_s: f64,
    /// 0 where there is no table.
    pub(crate) table_bytes: usize,
}

#[derive(Clone, Debug, Serialize)]
pub(crate) struct AnswerSegment {
    pub(crate) duration_s: f64,
    pub(crate) rate: &'static str,
    pub(crate) thrust: &'static str,
}

#[derive(Clone, Debug, Serialize)]
pub(crate) struct AnswerAlternative {
    pub(crate) turns: i32,
    pub(crate) duration_s: f64,
}

/// A request's answer with what stands behind it.
pub(crate) struct Solved {
    pub(crate) answer: Answer,
    /// `None` where T = 0. A maneuver may be right and still fit no table: beyond what a table or a flight controller can
    /// do, or with limits that no vehicle can hover with.
    pub(crate) maneuver: Option<(Solution, Result<ManeuverTable, PackError>)>,
}

/// Solves a request, packs the maneuver and replays the table.
pub(crate) fn answer(request: &Request, name: Option<String>) -> Result<Solved, SolveError> {
    let clock = Instant::now();
    let solution = match solve_all_windings(request) {
        Err(SolveError::AlreadyThere) => {
            return Ok(Solved { answer: at_once(request, name), maneuver: None });
        }
        result => result?,
    };
    let solve_time_s = clock.elapsed().as_secs_f64();
    let table = pack(&solution.extremal, ANY_VEHICLE, 0.0);
    let bytes = |t: &ManeuverTable| t.encode(&mut [0; MAX_TABLE_BYTES]).ok();
    let table_bytes = table.as_ref().ok().and_then(bytes).unwrap_or(0);
    let extremal = &solution.extremal;
    let answer = Answer {
        name,
        duration_s: extremal.duration_s(),
        turns: extremal.turns,
        segments: extremal
            .segments
            .iter()
            .map(|s| AnswerSegment {
                duration_s: s.duration,
                rate: rate_word(s.inputs.rate),
                thrust: thrust_word(s.inputs.thrust),
            })
            .collect(),
        costate: Some(extremal.costate.to_array()),
        certificate: solution.certificate,
        alternatives: solution
            .alternatives
            .iter()
            .map(|a| AnswerAlternative { turns: a.turns, duration_s: a.duration_s })
            .collect(),
        unsolved: solution.unsolved.to_vec(),
        solve_time_s,
        table_bytes,
    };
    Ok(Solved { answer, maneuver: Some((solution, table)) })
}

/// Start and end are the same state, but perhaps for whole turns of the angles that are given: T = 0, nothing to fly.
fn at_once(request: &Request, name: Option<String>) -> Answer {
    let certificate = Certificate {
        verified: true,
        degenerate: true,
        final_state_error: [0.0; 5],
        hamiltonian: 0.0,
        control_law: 0.0,
        kelley: 0.0,
        singular_rate_max: 0.0,
        min_segment_s: 0.0,
        lower_bound_s: 0.0,
    };
    Answer {
        name,
        duration_s: 0.0,
        turns: match request.turns {
            Turns::Exactly(k) => k,
            Turns::Any => request.nearest_turns(),
        },
        segments: Vec::new(),
        costate: None,
        certificate,
        alternatives: Vec::new(),
        unsolved: Vec::new(),
        solve_time_s: 0.0,
        table_bytes: 0,
    }
}

/// `+`, `-` or `singular`.
pub(crate) fn rate_word(rate: RateMode) -> &'static str {
    match rate {
        RateMode::Plus => "+",
        RateMode::Minus => "-",
        RateMode::Singular => "singular",
    }
}

/// `min` or `max`.
pub(crate) fn thrust_word(thrust: ThrustLevel) -> &'static str {
    match thrust {
        ThrustLevel::Min => "min",
        ThrustLevel::Max => "max",
    }
}

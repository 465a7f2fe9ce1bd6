//! What repeated flights taught: error by component and duration, flight by flight.

use serde::Serialize;

use crate::learning::{
    ANGLE_TOLERANCE_RAD, FlightEntry, History, POSITION_TOLERANCE_M, VELOCITY_TOLERANCE_MPS,
};

/// A run of flights of one maneuver, each corrected by what the ones before taught.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Learning {
    /// What is compared, e.g. position at the end.
    pub components: Vec<Component>,
    /// The flights, in order.
    pub flights: Vec<LearningFlight>,
    /// How it ended, in words.
    pub verdict: String,
}

/// One component of the error at the end.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Component {
    /// Its name.
    pub name: String,
    /// Its unit.
    pub unit: String,
    /// Largest magnitude that is good enough, in that unit.
    pub tolerance: f64,
}

/// One flight.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct LearningFlight {
    /// Its name, e.g. its number.
    pub label: String,
    /// Errors in the order of [`Learning::components`], in their units; empty where it brought none back.
    pub errors: Vec<f64>,
    /// Duration of its plan, s.
    pub duration_s: f64,
    /// What became of it, in words; empty where it is as it should be.
    pub note: String,
}

impl From<&History> for Learning {
    fn from(history: &History) -> Self {
        let component = |name: &str, unit: &str, tolerance| Component {
            name: name.to_owned(),
            unit: unit.to_owned(),
            tolerance,
        };
        let taught = history.flights.iter().enumerate().map(|(i, entry)| {
            let best = history.best == Some(i);
            flight((i + 1).to_string(), entry, if best { "the best table" } else { "" })
        });
        let repeated = history
            .repeats
            .iter()
            .enumerate()
            .map(|(i, entry)| flight(format!("r{}", i + 1), entry, "repeat"));
        Self {
            components: vec![
                component("position", "m", POSITION_TOLERANCE_M),
                component("velocity", "m/s", VELOCITY_TOLERANCE_MPS),
                component("pitch", "rad", ANGLE_TOLERANCE_RAD),
            ],
            flights: taught.chain(repeated).collect(),
            verdict: format!(
                "Outcome: {}. Duration: learned {:.4} s, planned for this vehicle {:.4} s, optimum without lag and drag {:.4} s.",
                history.reason.as_deref().unwrap_or("learning is under way"),
                history.learned_duration_s,
                history.planned_duration_s,
                history.optimum_duration_s
            ),
        }
    }
}

/// A flight whose end was seen, or why it was not.
fn flight(label: String, entry: &FlightEntry, remark: &str) -> LearningFlight {
    let errors = entry.final_error.map(|e| vec![e.position_m(), e.velocity_mps(), e.theta_rad.abs()]);
    let note = match &entry.reason {
        Some(reason) => format!("{}: {reason}", entry.outcome),
        None if entry.outcome != "completed" => entry.outcome.clone(),
        None => remark.to_owned(),
    };
    LearningFlight { label, errors: errors.unwrap_or_default(), duration_s: entry.duration_s, note }
}

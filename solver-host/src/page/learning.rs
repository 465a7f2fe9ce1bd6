//! What repeated flights taught: error by component and duration, flight by flight.

use serde::Serialize;

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

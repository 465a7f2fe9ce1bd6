//! Plain policy gradient, to compare with: p ← p − γ Jᵀ W² e.
//!
//! It goes down the slope of the weighed squared error, with the derivatives of the ideal model about the planned maneuver, once
//! and for all, and with the longest step that does not overshoot in the stiffest direction, γ = 1/σ². It knows nothing of
//! thrust scale, lags and start. Directions in which the Jacobian is κ times weaker need κ² times as many flights.

use serde::Serialize;

use super::campaign::{FlightFailure, Flyer};
use super::correction::weights;
use super::history::StateError;
use super::model::Response;
use super::parameters::Parameters;
use super::plan::{PlanError, Target, paper_table};

/// What came of it.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct GradientResult {
    /// The flight that first ended within the tolerances, from 1; `None` where none did.
    pub flights: Option<u32>,
    /// Error of the first flight, in tolerances.
    pub first: f64,
    /// Error of the best flight, in tolerances.
    pub best: f64,
    /// Flights that were flown.
    pub flown: u32,
    /// Why it ended early.
    pub reason: Option<String>,
}

/// Learns so; ends with the first flight that ends within the tolerances.
///
/// # Errors
/// [`PlanError`] where there is nothing to fly.
pub fn policy_gradient(
    target: &Target,
    flyer: &mut impl Flyer,
    flights: u32,
) -> Result<GradientResult, PlanError> {
    let table = paper_table(target)?;
    let mut parameters = Parameters::of(&table);
    let jacobian = Response::IDEAL.linearised(&table, &parameters).1;
    let (weights, scales) = (weights(), parameters.scales());
    let scaled =
        nalgebra::DMatrix::from_fn(5, parameters.count(), |i, j| weights[i] * jacobian[(i, j)] * scales[j]);
    let stiffest = scaled.singular_values().max();
    let gain = 1.0 / (stiffest * stiffest);
    let mut result =
        GradientResult { flights: None, first: f64::NAN, best: f64::INFINITY, flown: 0, reason: None };
    for number in 1..=flights {
        let next = match parameters.into_table(&table) {
            Ok(next) => next,
            Err(error) => {
                result.reason = Some(error.to_string());
                break;
            }
        };
        // Numbers of its own, for noise of its own.
        let flown = flyer.fly(&next, 2000 + number);
        result.flown = number;
        let error: StateError = match flown {
            Ok(flown) => flown.observed.final_error,
            Err(FlightFailure::Broken { reason, .. } | FlightFailure::Lost { reason }) => {
                result.reason = Some(reason);
                break;
            }
        };
        let far = error.in_tolerances();
        if number == 1 {
            result.first = far;
        }
        result.best = result.best.min(far);
        if far <= 1.0 {
            result.flights = Some(number);
            break;
        }
        let wanted = -nalgebra::DVector::from_column_slice(&error.to_array()).component_mul(&weights);
        let step = (scaled.transpose() * wanted * gain).component_mul(&scales);
        parameters = parameters.moved(&step);
    }
    Ok(result)
}

//! Plain rules to compare with: policy gradient, and steps by a fixed inverse.
//!
//! Both start from the maneuver as planned for the vehicle file, and know nothing of thrust scale, lags, drag and the start's
//! error. Both use the derivatives of the ideal model about the planned maneuver, once and for all.
//!
//! - Policy gradient: p ← p − γ Jᵀ W² e goes down the slope of the weighed squared error, with the longest step that does not
//!   overshoot in the stiffest direction, γ = 1/σ². Directions in which the Jacobian is κ times weaker need κ² times as many
//!   flights.
//! - Fixed inverse: p ← p − γ J⁺ e with γ = 1, the step that would take the error away on the ideal model.

use nalgebra::{DMatrix, DVector};
use serde::Serialize;

use super::campaign::{FlightFailure, Flyer};
use super::correction::{correct, weights};
use super::history::StateError;
use super::model::Response;
use super::parameters::Parameters;
use super::plan::{PlanError, Target, paper_table};

/// How to step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rule {
    /// Down the slope.
    PolicyGradient,
    /// By the inverse.
    FixedInverse,
}

/// What came of it.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct RuleResult {
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
pub fn learn_plainly(
    rule: Rule,
    target: &Target,
    flyer: &mut impl Flyer,
    flights: u32,
) -> Result<RuleResult, PlanError> {
    let table = paper_table(target)?;
    let mut parameters = Parameters::of(&table);
    let jacobian = Response::IDEAL.linearised(&table, &parameters).1;
    let rate_max = f64::from(table.limits.rate_max_radps);
    let mut result =
        RuleResult { flights: None, first: f64::NAN, best: f64::INFINITY, flown: 0, reason: None };
    for number in 1..=flights {
        let next = match parameters.into_table(&table) {
            Ok(next) => next,
            Err(error) => {
                result.reason = Some(error.to_string());
                break;
            }
        };
        // Numbers of its own, for noise of its own.
        let flown = flyer.fly(&next, NOISE_OF_ITS_OWN + number);
        result.flown = number;
        let error = match flown {
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
        let change = match rule {
            Rule::PolicyGradient => descent(&jacobian, &error, &parameters),
            Rule::FixedInverse => match correct(&jacobian, &error, &parameters, rate_max) {
                Ok(correction) => correction.change,
                Err(error) => {
                    result.reason = Some(error.to_string());
                    break;
                }
            },
        };
        parameters = parameters.moved(&change);
    }
    Ok(result)
}

/// Flights of a plain rule are numbered from here.
const NOISE_OF_ITS_OWN: u32 = 2000;

/// −γ Jᵀ W² e in scaled parameters.
fn descent(jacobian: &DMatrix<f64>, error: &StateError, parameters: &Parameters) -> DVector<f64> {
    let (weights, scales) = (weights(), parameters.scales());
    let scaled = DMatrix::from_fn(jacobian.nrows(), jacobian.ncols(), |i, j| {
        weights[i] * jacobian[(i, j)] * scales[j]
    });
    let stiffest = scaled.singular_values().max();
    let weighed = DVector::from_column_slice(&error.to_array()).component_mul(&weights);
    (scaled.transpose() * weighed / -(stiffest * stiffest)).component_mul(&scales)
}

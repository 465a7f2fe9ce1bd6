//! One correction: the least change of the parameters that takes the error away, as far as the linear model can be believed.
//!
//! With rows in units of the tolerances and columns in units of [`Parameters::scales`], A = W J S, the change S y is the damped
//! minimum-norm solution of A y = −W e: y = −Σ vᵢ σᵢ/(σᵢ² + λ²) uᵢᵀ W e over the singular values. λ is zero where that stays
//! within the trust region |yᵢ| ≤ ρ, and otherwise as large as brings it there (Levenberg). A parameter that would leave its
//! bounds is put on its bound, and the others do without it.

use mintime_shared::table::ManeuverTable;
use nalgebra::{DMatrix, DVector};

use super::history::{ANGLE_TOLERANCE_RAD, POSITION_TOLERANCE_M, StateError, VELOCITY_TOLERANCE_MPS};
use super::parameters::Parameters;

/// End states to correct.
const STATES: usize = 5;
/// Singular values below this part of the largest count as zero: such a direction would need thousands of times the change.
const RANK_TOLERANCE: f64 = 1.0e-3;
/// How far an arc that is held at its rate limit stays below it, as a part of it.
const ARC_MARGIN: f64 = 2.0e-3;
/// Largest change of a parameter in one correction, in units of its scale.
pub const TRUST: f64 = 2.0;

/// A correction.
#[derive(Clone, Debug, PartialEq)]
pub struct Correction {
    /// Change of each parameter.
    pub change: DVector<f64>,
    /// Singular values of the scaled Jacobian, largest first.
    pub singular_values: Vec<f64>,
    /// λ over the largest singular value; 0 where the full step was within the trust region.
    pub damping: f64,
    /// Parameters on their bounds.
    pub at_bounds: usize,
}

impl Correction {
    /// Largest over smallest singular value.
    pub fn condition(&self) -> f64 {
        self.singular_values.first().zip(self.singular_values.last()).map_or(f64::NAN, |(a, b)| a / b)
    }
}

/// Why the end cannot be corrected.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum CorrectionError {
    /// Fewer parameters than end states.
    #[error(
        "this maneuver has {parameters} numbers to change and five end states to correct: learn one with more segments, or with \
         an arc"
    )]
    TooFew {
        /// Parameters.
        parameters: usize,
    },
    /// The parameters move the end in fewer than five directions.
    #[error(
        "the {parameters} numbers of this maneuver move its end in {rank} directions only, five are needed: learn another maneuver"
    )]
    Rank {
        /// Parameters that are not on their bounds.
        parameters: usize,
        /// Directions.
        rank: usize,
    },
    /// Nonsense came in.
    #[error("the error at the end is not finite: motion capture or the model gave nonsense")]
    NotFinite,
}

/// The weights of the end states: one over their tolerances.
pub fn weights() -> DVector<f64> {
    let (p, v, a) = (1.0 / POSITION_TOLERANCE_M, 1.0 / VELOCITY_TOLERANCE_MPS, 1.0 / ANGLE_TOLERANCE_RAD);
    DVector::from_column_slice(&[p, v, p, v, a])
}

/// Something that a change may not move further than this, to first order: slope · change = room.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Limit {
    slope: DVector<f64>,
    room: f64,
}

impl Limit {
    /// The rate at which the arcs turn, to stay within a table's limit.
    pub(super) fn of_arcs(parameters: &Parameters, table: &ManeuverTable) -> Option<Self> {
        let rate = |p: &Parameters| p.arc_rate_radps(table);
        let now = rate(parameters)?;
        let scales = parameters.scales();
        let mut slope = DVector::zeros(parameters.count());
        for j in 0..slope.len() {
            let step = 1.0e-4 * scales[j];
            let mut change = DVector::zeros(slope.len());
            change[j] = step;
            slope[j] =
                (rate(&parameters.moved(&change))? - rate(&parameters.moved(&-change))?) / (2.0 * step);
        }
        // A breath inside: the rate is no straight line.
        let room = f64::from(table.limits.rate_max_radps) * (1.0 - ARC_MARGIN) - now;
        (slope.norm() > 0.0).then_some(Self { slope, room })
    }
}

/// The change of the parameters that takes an error away.
///
/// # Errors
/// [`CorrectionError`] where there is none.
pub fn correct(
    jacobian: &DMatrix<f64>,
    error: &StateError,
    parameters: &Parameters,
    rate_max_radps: f64,
) -> Result<Correction, CorrectionError> {
    correct_within(jacobian, error, parameters, rate_max_radps, None)
}

/// The same with something that may move so far and no further, as one more equation.
///
/// # Errors
/// [`CorrectionError`] where there is none.
pub(super) fn correct_within(
    jacobian: &DMatrix<f64>,
    error: &StateError,
    parameters: &Parameters,
    rate_max_radps: f64,
    limit: Option<&Limit>,
) -> Result<Correction, CorrectionError> {
    let count = parameters.count();
    if count < STATES {
        return Err(CorrectionError::TooFew { parameters: count });
    }
    let weights = weights();
    let scales = parameters.scales();
    let low = parameters.lower_bounds(rate_max_radps);
    let mut scaled = DMatrix::from_fn(STATES, count, |i, j| weights[i] * jacobian[(i, j)] * scales[j]);
    let mut wanted = -DVector::from_column_slice(&error.to_array()).component_mul(&weights);
    if let Some(limit) = limit {
        let row = limit.slope.component_mul(&scales);
        // As heavy as the heaviest of the others.
        let weight = scaled.norm() / row.norm();
        scaled = scaled.insert_row(STATES, 0.0);
        scaled.row_mut(STATES).copy_from(&(row * weight).transpose());
        wanted = wanted.push(limit.room * weight);
    }
    if !scaled.iter().chain(wanted.iter()).all(|v| v.is_finite()) {
        return Err(CorrectionError::NotFinite);
    }

    let mut free: Vec<usize> = (0..count).collect();
    let mut change = DVector::zeros(count);
    loop {
        let step = Step::new(&scaled.select_columns(&free), &wanted, free.len())?;
        let leaving: Vec<usize> = free
            .iter()
            .zip(step.step.iter())
            .filter(|(j, y)| *y * scales[**j] < low[**j])
            .map(|(j, _)| *j)
            .collect();
        if leaving.is_empty() {
            for (j, y) in free.iter().zip(step.step.iter()) {
                change[*j] = y * scales[*j];
            }
            return Ok(Correction {
                change,
                singular_values: step.singular_values,
                damping: step.damping,
                at_bounds: count - free.len(),
            });
        }
        for j in leaving {
            change[j] = low[j];
            wanted -= scaled.column(j) * (low[j] / scales[j]);
            free.retain(|other| *other != j);
        }
    }
}

/// A damped step of the parameters that are free, in units of their scales.
struct Step {
    step: DVector<f64>,
    singular_values: Vec<f64>,
    damping: f64,
}

impl Step {
    fn new(scaled: &DMatrix<f64>, wanted: &DVector<f64>, parameters: usize) -> Result<Self, CorrectionError> {
        let svd = scaled.clone().svd(true, true);
        let (Some(u), Some(v_t)) = (&svd.u, &svd.v_t) else { return Err(CorrectionError::NotFinite) };
        let largest = svd.singular_values.max();
        let rank = svd.singular_values.iter().filter(|s| **s > RANK_TOLERANCE * largest).count();
        if rank < STATES {
            return Err(CorrectionError::Rank { parameters, rank });
        }
        let along = u.transpose() * wanted;
        let solve = |damping: f64| {
            let lambda = damping * largest;
            let parts = DVector::from_fn(along.len(), |i, _| {
                let sigma = svd.singular_values[i];
                along[i] * sigma / (sigma * sigma + lambda * lambda)
            });
            v_t.transpose() * parts
        };
        let (mut damping, mut step) = (0.0, solve(0.0));
        while step.amax() > TRUST && damping < 1.0e3 {
            damping = if damping == 0.0 { RANK_TOLERANCE } else { damping * 1.25 };
            step = solve(damping);
        }
        let mut singular_values: Vec<f64> = svd.singular_values.iter().copied().collect();
        singular_values.sort_by(|a, b| b.total_cmp(a));
        Ok(Self { step, singular_values, damping })
    }
}

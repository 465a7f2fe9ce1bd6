//! Before the first flight: the maneuver for the vehicle as it turned out to be, and a rehearsal of it on the model.

use mintime_firmware::config::{RATE_RESPONSE_S, ROTOR_RESPONSE_S};
use mintime_shared::model::{Limits, LimitsError, State};
use mintime_shared::table::{ANY_VEHICLE, Kind, ManeuverTable, TableError, TableHeader};
use mintime_shared::vehicle::{MOTOR_COUNT, VehicleConfig};

use super::correction::{CorrectionError, correct};
use super::history::{IdentifiedResponse, StateError};
use super::model::Response;
use super::parameters::Parameters;
use crate::identification::Identified;
use crate::pack::{PackError, pack};
use crate::solver::{Request, SolveError, Turns, solve};

/// Part of a vehicle's full thrust that is planned with at most: the rest is for attitude.
pub const THRUST_SHARE: f64 = 0.9;
/// Corrections that a rehearsal takes at most.
const REHEARSAL_STEPS: u32 = 60;
/// A rehearsed end is this near, in tolerances.
const REHEARSED: f64 = 0.01;
/// One that no step brings nearer is flown all the same up to here, in tolerances: a first flight ends farther away anyway.
const NEAR_ENOUGH: f64 = 3.0;

impl Response {
    /// A vehicle that was identified. Its rate loop follows as its reference model does; what the rotors lag behind the model
    /// the loop feeds forward comes on top.
    pub fn identified(found: &IdentifiedResponse) -> Self {
        let rate_lag_s = f64::from(RATE_RESPONSE_S) + RATE_EXTRA_LAG_S;
        Self { thrust_scale: found.thrust_scale, thrust_lag_s: found.response_s, rate_lag_s, drag_per_s: 0.0 }
    }
}

/// What a rate comes later than the loop's reference model, s: half a tick, and the rotors' own response where the loop has not
/// caught up with it.
const RATE_EXTRA_LAG_S: f64 = 0.001;

impl IdentifiedResponse {
    /// A vehicle that is as its file says.
    pub fn of_file(file: &VehicleConfig) -> Self {
        let rotor_lag_s = f64::from(file.rotor_lag_s);
        let response_s = rotor_lag_s.min(f64::from(ROTOR_RESPONSE_S));
        Self { thrust_scale: 1.0, thrust_scale_std: 0.0, rotor_lag_s, response_s }
    }
}

impl From<&Identified> for IdentifiedResponse {
    fn from(found: &Identified) -> Self {
        Self {
            thrust_scale: found.thrust_scale,
            thrust_scale_std: found.thrust_scale_std,
            rotor_lag_s: found.lag_s,
            response_s: found.response_s,
        }
    }
}

/// What shall be learned.
#[derive(Clone, Debug)]
pub enum Target {
    /// A maneuver from rest to rest: where to, within which limits (true thrust per mass), with which windings, and the heading
    /// of its plane, rad.
    Solve {
        /// End.
        to: State<f64>,
        /// Limits.
        limits: Limits<f64>,
        /// Windings.
        turns: Turns,
        /// Heading, rad.
        heading_rad: f64,
    },
    /// A table. Its segments are flown as they are, with the durations that the vehicle needs; one that was learned before is
    /// learned on.
    Table {
        /// The table.
        table: Box<ManeuverTable>,
        /// Heading of its plane, rad; that of a learned table may differ from it by what an askew gyro needs.
        heading_rad: f64,
    },
}

/// A maneuver that is ready to be learned.
#[derive(Clone, Debug)]
pub struct LearningPlan {
    /// The table of the first flight.
    pub table: ManeuverTable,
    /// Heading of the plane that the maneuver is to be in, rad.
    pub heading_rad: f64,
    /// How the vehicle is taken to answer.
    pub response: Response,
    /// Duration of the maneuver as planned for this vehicle, before the rehearsal, s.
    pub planned_duration_s: f64,
    /// Least duration within the limits asked for, s.
    pub optimum_duration_s: f64,
}

/// Why nothing can be learned.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum PlanError {
    /// No maneuver.
    #[error(transparent)]
    Solve(#[from] SolveError),
    /// Limits with which nothing can be flown.
    #[error(transparent)]
    Limits(#[from] LimitsError),
    /// No table.
    #[error(transparent)]
    Pack(#[from] PackError),
    /// A table that no vehicle takes.
    #[error(transparent)]
    Table(#[from] TableError),
    /// Its end cannot be corrected.
    #[error(transparent)]
    Correction(#[from] CorrectionError),
    /// The vehicle is too weak or too slow.
    #[error(
        "with the thrust that this vehicle has ({available_mps2:.1} m/s² may be planned with) it cannot fly the maneuver: see to \
         battery and propellers, and that its file tells its mass"
    )]
    Weak {
        /// True thrust per mass that may be planned with, m/s².
        available_mps2: f64,
    },
    /// The table starts in motion or tilted: nobody can hover there.
    #[error(
        "the maneuver does not start at rest and level, so it cannot be flown from a hover: make one that does"
    )]
    NotFromRest,
    /// The model finds no durations.
    #[error(
        "even the model of this vehicle does not reach the end ({left:.1} tolerances are left): plan with lower limits or a shorter \
         way"
    )]
    Rehearsal {
        /// What is left of the error, in tolerances.
        left: f64,
    },
}

/// Plans for a vehicle: solves with the thrust that it truly has, commands what makes that thrust, and rehearses.
///
/// # Errors
/// [`PlanError`]; nothing has moved.
pub fn plan(
    target: &Target,
    config: &VehicleConfig,
    found: &IdentifiedResponse,
) -> Result<LearningPlan, PlanError> {
    let response = Response::identified(found);
    let (table, optimum_duration_s) = match target {
        Target::Solve { to, limits, turns, heading_rad } => {
            limits.validate()?;
            let request = |limits| Request { from: State::origin(), to: *to, limits, turns: *turns };
            let optimum_duration_s = solve(&request(*limits))?.extremal.duration_s();
            let able = within_vehicle(limits, config, found.thrust_scale)?;
            let planned = solve(&request(able))?;
            let table = pack(&planned.extremal, config.hash(), *heading_rad)?;
            (commanded(&table, found.thrust_scale)?, optimum_duration_s)
        }
        Target::Table { table, .. } => {
            let limits = table.limits.cast();
            let (from, to): (State<f64>, State<f64>) = (table.start.cast(), table.end.cast());
            if (from.vx, from.vz, from.theta) != (0.0, 0.0, 0.0) {
                return Err(PlanError::NotFromRest);
            }
            // Given thrusts are commands: the vehicle makes more or less of them.
            let limits = scaled(limits, found.thrust_scale);
            let request = Request { from, to, limits, turns: Turns::Exactly(0) };
            (ManeuverTable::clone(table), solve(&request)?.extremal.duration_s())
        }
    };
    let planned_duration_s = f64::from(table.duration_s());
    // One that was learned in flight knows better than the model.
    let learned = matches!(target, Target::Table { table, .. } if table.kind == Kind::Learned);
    let table = if learned { table } else { rehearse(&table, &response)? };
    let table = table.assigned_to(config.hash(), &config.plan_limits())?;
    let (Target::Solve { heading_rad, .. } | Target::Table { heading_rad, .. }) = *target;
    Ok(LearningPlan { table, heading_rad, response, planned_duration_s, optimum_duration_s })
}

/// The table that the paper flies first: for the limits asked for, of a vehicle that is as its file says, for any vehicle.
pub(super) fn paper_table(target: &Target) -> Result<ManeuverTable, PlanError> {
    match target {
        Target::Solve { to, limits, turns, heading_rad } => {
            let request = Request { from: State::origin(), to: *to, limits: *limits, turns: *turns };
            Ok(pack(&solve(&request)?.extremal, ANY_VEHICLE, *heading_rad)?)
        }
        Target::Table { table, .. } => Ok(ManeuverTable::clone(table)),
    }
}

/// The limits asked for, as far as a vehicle has them. True thrust per mass is the scale times what is commanded.
fn within_vehicle(
    limits: &Limits<f64>,
    config: &VehicleConfig,
    scale: f64,
) -> Result<Limits<f64>, PlanError> {
    let able = config.plan_limits();
    let full_mps2 = f64::from(config.rotor_thrust_max_n) * MOTOR_COUNT as f64 / f64::from(config.mass_kg);
    let most_mps2 = scale * f64::from(able.thrust_max_mps2).min(THRUST_SHARE * full_mps2);
    // A breath inside, for the table holds `f32`.
    let inside = 1.0e-6;
    let planned = Limits {
        thrust_min_mps2: limits.thrust_min_mps2.max(scale * f64::from(able.thrust_min_mps2) * (1.0 + inside)),
        thrust_max_mps2: limits.thrust_max_mps2.min(most_mps2 * (1.0 - inside)),
        rate_max_radps: limits.rate_max_radps.min(f64::from(able.rate_max_radps)),
        ..*limits
    };
    planned.validate().map_err(|_| PlanError::Weak { available_mps2: most_mps2 })?;
    Ok(planned)
}

/// The same table with thrusts that make the planned ones on a vehicle of another thrust scale.
fn commanded(table: &ManeuverTable, scale: f64) -> Result<ManeuverTable, TableError> {
    let limits = scaled(table.limits.cast(), 1.0 / scale).cast();
    let header = TableHeader {
        vehicle: table.vehicle,
        kind: Kind::Learned,
        link: table.link,
        limits,
        heading_rad: table.heading_rad,
        start: table.start,
        end: table.end,
    };
    ManeuverTable::new(header, table.arcs, table.segments())
}

fn scaled(limits: Limits<f64>, by: f64) -> Limits<f64> {
    Limits {
        thrust_min_mps2: limits.thrust_min_mps2 * by,
        thrust_max_mps2: limits.thrust_max_mps2 * by,
        ..limits
    }
}

/// Learns on the model: the table that arrives there.
fn rehearse(table: &ManeuverTable, response: &Response) -> Result<ManeuverTable, PlanError> {
    let rate_max = f64::from(table.limits.rate_max_radps);
    let target = table.end.cast::<f64>();
    let miss = |parameters: &Parameters| {
        let (end, jacobian) = response.linearised(table, parameters);
        (StateError::from_array(end.minus(target).to_array()), jacobian)
    };
    let mut parameters = Parameters::of(table);
    let (mut error, mut jacobian) = miss(&parameters);
    let mut best = (error.in_tolerances(), parameters.into_table(table)?);
    for _ in 0..REHEARSAL_STEPS {
        if error.in_tolerances() <= REHEARSED {
            break;
        }
        let correction = correct(&jacobian, &error, &parameters, rate_max)?;
        // Half the step, and half of that, until it is one ahead and a vehicle takes the table.
        let mut part = 1.0;
        let (better, found, slope) = loop {
            let next = parameters.moved(&(&correction.change * part));
            let (left, slope) = miss(&next);
            let ahead = left.in_tolerances() < error.in_tolerances() && next.into_table(table).is_ok();
            if ahead || part < 0.05 {
                break (next, left, slope);
            }
            part *= 0.5;
        };
        (parameters, error, jacobian) = (better, found, slope);
        if let Ok(rehearsed) = parameters.into_table(table)
            && error.in_tolerances() < best.0
        {
            best = (error.in_tolerances(), rehearsed);
        }
    }
    let (left, rehearsed) = best;
    if left > NEAR_ENOUGH {
        return Err(PlanError::Rehearsal { left });
    }
    Ok(rehearsed)
}

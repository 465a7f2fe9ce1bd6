//! From a verified extremal to the table that a vehicle flies, and the proof that the table arrives.

use mintime_shared::messages::Identity;
use mintime_shared::model::{GRAVITY_MPS2, RateMode, Segment, State};
use mintime_shared::motion;
use mintime_shared::replay::{Command, Plan, Replay, Step, TICK_PERIOD_US, TickPeriod};
use mintime_shared::table::{
    ArcProfile, Kind, LinkPolicy, ManeuverTable, PlanLimits, TableError, TableHeader,
};

use crate::solver::Extremal;

/// The replay tolerance: how far the tick-by-tick replay of a table may miss the planned end. Position, m.
pub const REPLAY_POSITION_M: f64 = 0.5e-3;
/// Velocity, m/s.
pub const REPLAY_VELOCITY_MPS: f64 = 1.0e-3;
/// Angle, rad.
pub const REPLAY_ANGLE_RAD: f64 = 0.02e-3;

/// Why an extremal has no table.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum PackError {
    /// The table would be refused by a vehicle.
    #[error("the maneuver does not fit a table: {0}")]
    Table(#[from] TableError),
    /// The replay at 800 Hz would miss the end.
    #[error(
        "replayed at 800 Hz the maneuver would miss its end by {position_m:.4} m, {velocity_mps:.4} m/s, \
         {angle_rad:.6} rad: it is too fast for a flight controller, lower the body rate"
    )]
    Replay {
        /// Distance, m.
        position_m: f64,
        /// Speed, m/s.
        velocity_mps: f64,
        /// Angle, rad.
        angle_rad: f64,
    },
}

/// Packs an extremal for a vehicle (a hash, or [`mintime_shared::table::ANY_VEHICLE`]) and a plane's heading (rad),
/// and replays the table to see that it arrives.
///
/// # Errors
/// [`PackError`].
pub fn pack(extremal: &Extremal, vehicle: u32, heading_rad: f64) -> Result<ManeuverTable, PackError> {
    let singular = extremal.segments.iter().any(|s| s.inputs.rate == RateMode::Singular);
    let arcs = singular.then(|| ArcProfile::from_costate(&extremal.costate, &extremal.limits)).transpose()?;
    let header = TableHeader {
        vehicle,
        kind: Kind::Extremal,
        link: LinkPolicy::Finish,
        limits: extremal.limits.cast(),
        heading_rad: heading_rad as f32,
        start: extremal.from.cast(),
        end: extremal.end().cast(),
    };
    let segments =
        extremal.segments.iter().map(|s| Segment { inputs: s.inputs, duration: s.duration as f32 });
    let table = ManeuverTable::new(header, arcs, segments)?;
    let miss = replay(&table, extremal.from).minus(extremal.end());
    let (position_m, velocity_mps, angle_rad) =
        (libm::hypot(miss.x, miss.z), libm::hypot(miss.vx, miss.vz), miss.theta.abs());
    if position_m <= REPLAY_POSITION_M && velocity_mps <= REPLAY_VELOCITY_MPS && angle_rad <= REPLAY_ANGLE_RAD
    {
        Ok(table)
    } else {
        Err(PackError::Replay { position_m, velocity_mps, angle_rad })
    }
}

/// A table for the vehicle that said who it is: one for any vehicle becomes its own. Whoever uploads a table to a vehicle says
/// that it is meant for it.
///
/// # Errors
/// [`TableError`]: made for another one, or beyond what this one can do; or the vehicle does not know what it is.
pub fn for_vehicle(table: &ManeuverTable, identity: &Identity) -> Result<ManeuverTable, TableError> {
    let able = PlanLimits {
        thrust_min_mps2: identity.thrust_min_mps2,
        thrust_max_mps2: identity.thrust_max_mps2,
        rate_max_radps: identity.rate_max_radps,
        gravity_mps2: GRAVITY_MPS2 as f32,
    };
    table.assigned_to(identity.vehicle, &able)
}

/// Where the replay of a table at 800 Hz ends, from a given start: the vehicle's own code in `f32`, a perfect plant in
/// `f64`.
pub fn replay(table: &ManeuverTable, start: State<f64>) -> State<f64> {
    let plan = Plan::new(table);
    let (gravity, duration_s) = (f64::from(table.limits.gravity_mps2), f64::from(plan.duration_s()));
    let mut replay = Replay::new(plan, 0);
    let (mut state, mut now_us) = (start, 0_u64);
    while let Step::Fly(Command { rate_radps, thrust_mps2 }) = replay.tick(now_us, &TickPeriod::new()) {
        let next_us = now_us + u64::from(TICK_PERIOD_US);
        let tau = (next_us as f64 * 1e-6).min(duration_s) - now_us as f64 * 1e-6;
        let turn = motion::bang(f64::from(rate_radps), tau);
        state = motion::advance(state, f64::from(thrust_mps2), gravity, tau, &turn);
        now_us = next_us;
    }
    state
}

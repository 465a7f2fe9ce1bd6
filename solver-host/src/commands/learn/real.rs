//! A real vehicle that learns: flown, seen, and flown back to its start.

use std::time::Instant;

use mintime::flight::{FlightError, FlightPlan, FlightResult, Outcome, Witness, fly_and_return};
use mintime::learning::{Eyes, FlightFailure, Flown, Flyer, Response};
use mintime::mission::{self, Room, Source, prepare_for};
use mintime_shared::table::ManeuverTable;
use mintime_shared::vehicle::VehicleConfig;
use nalgebra::Vector3;

use super::super::live::Watched;
use super::super::progress::Progress;
use super::super::seen::Seen as Kept;

/// A vehicle in a room.
pub(super) struct RealFlyer<'a> {
    pub(super) watched: Watched,
    pub(super) config: VehicleConfig,
    pub(super) room: Room,
    pub(super) response: Response,
    /// Heading of the plane that the maneuver is to be in, rad.
    pub(super) heading_rad: f64,
    pub(super) progress: &'a mut Progress,
    /// The last flight that took place.
    pub(super) last: Option<mission::Flown>,
}

impl Flyer for RealFlyer<'_> {
    fn fly(&mut self, table: &ManeuverTable, _number: u32) -> Result<Flown, FlightFailure> {
        let lost = |reason: String| FlightFailure::Lost { reason };
        let source = Source::Learned { bytes: super::bytes(table), heading_rad: self.heading_rad };
        // What does not fit the room is not flown.
        let prepared =
            prepare_for(&source, Some(&self.room), &self.config).map_err(|e| lost(e.to_string()))?;
        let start_m = self.watched.start_m;
        let plan = FlightPlan::new(table.clone(), start_m, None).along(self.heading_rad);
        self.watched.vehicle.expect_maneuver(f64::from(table.duration_s()));
        let clock = Instant::now();
        let mut kept = Kept::new(&mut *self.progress, self.heading_rad);
        let mut eyes = Eyes::new(&mut kept);
        let flight = fly_and_return(&mut self.watched.vehicle, &plan, &mut eyes);
        let told = seen_end(&flight, &eyes, table, start_m, self.heading_rad, &self.response);
        let wall_time_s = clock.elapsed().as_secs_f64();
        self.last = Some(mission::Flown {
            prepared,
            flight,
            vehicle: "real",
            emulated: None,
            trace: kept.into_trace(),
            virtual_time_s: wall_time_s,
            wall_time_s,
        });
        told
    }
}

/// What a flight tells of its end.
fn seen_end<W: Witness>(
    flight: &Result<FlightResult, FlightError>,
    eyes: &Eyes<'_, W>,
    table: &ManeuverTable,
    start_m: Vector3<f64>,
    heading_rad: f64,
    response: &Response,
) -> Result<Flown, FlightFailure> {
    let result = flight.as_ref().map_err(|e| FlightFailure::Lost { reason: e.to_string() })?;
    let broken = |outcome, reason| FlightFailure::Broken { outcome, reason };
    if !matches!(result.outcome, Outcome::Completed | Outcome::NotCaught) {
        return Err(broken(result.outcome.name(), result.reason.clone().unwrap_or_default()));
    }
    let observed = eyes
        .observed(table, start_m, heading_rad, &result.record, response)
        .map_err(|e| broken("not-seen", e.to_string()))?;
    Ok(Flown { observed, true_final_error: None, true_across: None, outcome: result.outcome.name() })
}

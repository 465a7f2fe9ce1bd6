//! A real vehicle that learns: flown, seen, and flown back to its start.

use mintime::flight::{FlightError, FlightPlan, Outcome, fly_and_return};
use mintime::learning::{Eyes, FlightFailure, Flown, Flyer, Response};
use mintime::mission::{Room, Source, prepare_for};
use mintime_shared::table::ManeuverTable;
use mintime_shared::vehicle::VehicleConfig;

use super::super::live::Watched;
use super::super::progress::Progress;

/// A vehicle in a room.
pub(super) struct RealFlyer<'a> {
    pub(super) watched: Watched,
    pub(super) config: VehicleConfig,
    pub(super) room: Room,
    pub(super) response: Response,
    pub(super) progress: &'a mut Progress,
}

impl Flyer for RealFlyer<'_> {
    fn fly(&mut self, table: &ManeuverTable, _number: u32) -> Result<Flown, FlightFailure> {
        let lost = |reason: String| FlightFailure::Lost { reason };
        let source = Source::Table(super::bytes(table));
        // What does not fit the room is not flown.
        prepare_for(&source, Some(&self.room), &self.config).map_err(|e| lost(e.to_string()))?;
        let start_m = self.watched.start_m;
        let plan = FlightPlan { table: table.clone(), start_m, vehicle: None };
        self.watched.vehicle.expect_maneuver(f64::from(table.duration_s()));
        let mut eyes = Eyes::new(self.progress);
        let flight = fly_and_return(&mut self.watched.vehicle, &plan, &mut eyes);
        let result = flight.map_err(|e: FlightError| lost(e.to_string()))?;
        let broken = |outcome, reason| FlightFailure::Broken { outcome, reason };
        if !matches!(result.outcome, Outcome::Completed | Outcome::NotCaught) {
            return Err(broken(result.outcome.name(), result.reason.unwrap_or_default()));
        }
        let observed = eyes
            .observed(table, start_m, &result.record, &self.response)
            .map_err(|e| broken("not-seen", e.to_string()))?;
        Ok(Flown { observed, true_final_error: None, outcome: result.outcome.name() })
    }
}

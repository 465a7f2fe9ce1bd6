//! Simulated vehicles that learn: the flight logic in this process, or the firmware image on the virtual board.

use emulator::core::Timing;
use mintime_shared::table::{MAX_TABLE_BYTES, ManeuverTable};
use mintime_shared::vehicle::VehicleConfig;
use nalgebra::Vector3;

use super::campaign::{FlightFailure, Flown, Flyer};
use super::history::{Across, IdentifiedResponse, StateError};
use super::model::Response;
use super::observation::Eyes;
use crate::flight::{
    FlightError, HopPlan, HostedVehicle, Outcome, Phase, Scene, VirtualVehicle, Witness, fly_hops,
};
use crate::identification::{HOPS_MIN, IdentificationError, identify};
use crate::mission::{
    self, Mission, MissionError, PlantChoice, Room, Source, VehicleChoice, fly_again, prepare,
};

/// A vehicle in the simulator: its errors come from its seed, the noise of each flight from the flight's number too.
#[derive(Clone, Debug)]
pub struct SimulatedVehicle {
    /// What flies.
    pub choice: VehicleChoice,
    /// The airframe.
    pub plant: PlantChoice,
    /// Seed of its errors.
    pub seed: u64,
    /// Free space.
    pub room: Option<Room>,
    /// How it is taken to answer, to see the end of a flight well.
    pub response: Response,
    /// Heading of the plane that maneuvers are to be in, rad.
    pub heading_rad: f64,
}

/// Why a simulated vehicle could not be identified.
#[derive(Debug, thiserror::Error)]
pub enum IdentifyError {
    /// It cannot be set up.
    #[error(transparent)]
    Mission(#[from] MissionError),
    /// The flight failed.
    #[error("the flight that identifies the vehicle failed: {0}")]
    Flight(#[from] FlightError),
    /// It says too little.
    #[error(transparent)]
    Identification(#[from] IdentificationError),
}

/// The hover and the few hops before learning.
pub fn hop_plan() -> HopPlan {
    HopPlan { hops: HOPS_MIN, ..HopPlan::default() }
}

impl SimulatedVehicle {
    /// Hovers and hops, and says what that tells.
    ///
    /// # Errors
    /// [`IdentifyError`].
    pub fn identify(&self, witness: &mut impl Witness) -> Result<IdentifiedResponse, IdentifyError> {
        let scene = Scene {
            parameters: &self.plant.parameters,
            seed: self.seed,
            ground_z_m: 0.0,
            heading_rad: 0.0,
            maneuver_s: 0.0,
        };
        let file = VehicleConfig::REFERENCE;
        let plan = HopPlan { vehicle: Some(file), ..hop_plan() };
        let flight = match &self.choice {
            VehicleChoice::Hosted => {
                let mut vehicle = HostedVehicle::new(&scene).map_err(MissionError::from)?;
                fly_hops(&mut vehicle, &plan, witness)?
            }
            VehicleChoice::Virtual { image, .. } => {
                let vehicle = VirtualVehicle::new(&scene, image.elf(), Timing::Pessimistic);
                fly_hops(&mut vehicle.map_err(MissionError::from)?, &plan, witness)?
            }
        };
        Ok((&identify(&flight, &file)?).into())
    }
}

/// A simulated vehicle and who watches it.
#[derive(Debug)]
pub struct SimulatedFlyer<'a, W> {
    /// The vehicle.
    pub vehicle: &'a SimulatedVehicle,
    /// Is told of each flight.
    pub witness: &'a mut W,
    /// The last flight that took place.
    pub last: Option<mission::Flown>,
}

impl<W: Witness> Flyer for SimulatedFlyer<'_, W> {
    fn fly(&mut self, table: &ManeuverTable, number: u32) -> Result<Flown, FlightFailure> {
        let SimulatedVehicle { choice, plant, seed, room, heading_rad, .. } = self.vehicle;
        let lost = |reason: String| FlightFailure::Lost { reason };
        let mut buffer = [0; MAX_TABLE_BYTES];
        let length = table.encode(&mut buffer).map_err(|e| lost(e.to_string()))?;
        let source = Source::Learned { bytes: buffer[..length].to_vec(), heading_rad: *heading_rad };
        let mission = Mission { source, plant: plant.clone(), seed: *seed, room: *room };
        let prepared = prepare(&mission.source, room.as_ref()).map_err(|e| lost(e.to_string()))?;
        let mut eyes = Eyes::new(&mut *self.witness);
        let flown =
            fly_again(&mission, number, prepared, choice, &mut eyes).map_err(|e| lost(e.to_string()))?;
        let told = seen_end(&flown, &eyes, table, self.vehicle);
        self.last = Some(flown);
        told
    }
}

/// What a flight tells of its end.
fn seen_end<W: Witness>(
    flown: &mission::Flown,
    eyes: &Eyes<'_, W>,
    table: &ManeuverTable,
    vehicle: &SimulatedVehicle,
) -> Result<Flown, FlightFailure> {
    let lost = |reason: String| FlightFailure::Lost { reason };
    if flown.outcome() == "crashed" {
        return Err(lost(flown.reason().unwrap_or_default()));
    }
    let result = flown.flight.as_ref().map_err(|e| lost(e.to_string()))?;
    let broken = |reason: String| FlightFailure::Broken { outcome: result.outcome.name(), reason };
    if !matches!(result.outcome, Outcome::Completed | Outcome::NotCaught) {
        return Err(broken(flown.reason().unwrap_or_default()));
    }
    let observed = eyes
        .observed(table, Vector3::zeros(), vehicle.heading_rad, &result.record, &vehicle.response)
        .map_err(|e| FlightFailure::Broken { outcome: "not-seen", reason: e.to_string() })?;
    let truth = flown.final_error();
    let true_final_error = truth.map(|e| StateError {
        x_m: e.x_m,
        vx_mps: e.vx_mps,
        z_m: e.z_m,
        vz_mps: e.vz_mps,
        theta_rad: e.theta_rad,
    });
    let true_across = truth.map(|e| Across { y_m: e.y_m, vy_mps: e.vy_mps });
    Ok(Flown { observed, true_final_error, true_across, outcome: result.outcome.name() })
}

/// A witness that looks away.
#[derive(Clone, Copy, Debug, Default)]
pub struct Unseen;

impl Witness for Unseen {
    fn phase(&mut self, _: Phase, _: f64) {}
    fn event(&mut self, _: f64, _: &str) {}
}

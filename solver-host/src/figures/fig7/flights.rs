//! The two flights of Fig. 7, of one simulated vehicle: as planned, knowing nothing of it, and as learned.

use mintime_shared::model::{Limits, State};
use mintime_shared::table::ManeuverTable;
use mintime_shared::vehicle::VehicleConfig;
use mintime_simulator::VehicleParameters;

use crate::figures::FigureError;
use crate::learning::{
    Budget, History, Observer, Response, SimulatedFlyer, SimulatedVehicle, StopReason, Target, Unseen, learn,
    plan,
};
use crate::mission::{Flown, Mission, PlantChoice, Source, VehicleChoice, fly_mission, prepare};
use crate::solver::{Solution, Turns};

/// Seed of the simulated vehicle's errors and noise.
const SEED: u64 = 1;
/// Flights that teach, at most, and one of what was learned: the one that is shown.
const BUDGET: Budget = Budget { flights: 10, repeats: 1 };

/// The maneuver and how it was flown.
pub(super) struct Flights {
    /// The plan: the fastest maneuver of a vehicle that is as its file says.
    pub(super) plan: Solution,
    /// That plan flown.
    pub(super) unlearned: Flown,
    /// The learned table flown, once more after learning.
    pub(super) learned: Flown,
    /// Flights that it took to learn it.
    pub(super) taught_by: usize,
}

impl Flights {
    /// Solves, flies and learns the maneuver to x = 5 m, z = 5 m.
    pub(super) fn fly() -> Result<Self, FigureError> {
        let (to, limits, turns) = (State::at_rest(5.0, 5.0), Limits::TABLE_I, Turns::Any);
        let plant = PlantChoice { name: "nominal".to_owned(), parameters: VehicleParameters::nominal() };

        let source = Source::Solve { to, limits, turns, heading_rad: 0.0 };
        let prepared = prepare(&source, None)?;
        let mission = Mission { source, plant: plant.clone(), seed: SEED, room: None };
        let unlearned = fly_mission(&mission, prepared, &VehicleChoice::Hosted, &mut Unseen)?;
        let Some(plan) = unlearned.prepared.solution.clone() else {
            return Err(FigureError::Flight("it has no plan".to_owned()));
        };

        let target = Target::Solve { to, limits, turns, heading_rad: 0.0 };
        let (learned, taught_by) = learned(&target, plant)?;
        Ok(Self { plan, unlearned, learned, taught_by })
    }
}

/// Learns the maneuver; the flight of what was learned, and the number of flights before it.
fn learned(target: &Target, plant: PlantChoice) -> Result<(Flown, usize), FigureError> {
    let choice = VehicleChoice::Hosted;
    let mut vehicle = SimulatedVehicle {
        choice,
        plant,
        seed: SEED,
        room: None,
        response: Response::IDEAL,
        heading_rad: 0.0,
    };
    let found = vehicle.identify(&mut Unseen)?;
    let ready = plan(target, &VehicleConfig::REFERENCE, &found)?;
    vehicle.response = ready.response;
    let mut flyer = SimulatedFlyer { vehicle: &vehicle, witness: &mut Unseen, last: None };
    let history = History::of("5,5", vehicle.choice.name(), Some(SEED));
    let learned = learn(&ready, history, BUDGET, &mut flyer, &mut Unwatched);
    match flyer.last {
        Some(flown) if learned.stop == StopReason::Converged => Ok((flown, learned.history.flights.len())),
        _ => Err(FigureError::NotLearned(learned.stop)),
    }
}

/// Nobody follows the campaign.
struct Unwatched;

impl Observer for Unwatched {
    fn flown(&mut self, _: &History, _: &ManeuverTable) {}
}

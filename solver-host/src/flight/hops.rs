//! A flight that asks the vehicle what it is: hover, then short hops up and down, then land.
//!
//! In hover position control finds the thrust command that carries the weight. In a hop the thrust is open-loop, so that
//! what the vehicle makes of a step is not undone by whoever watches it: a step one way, the same step the other way, and
//! the vehicle is at rest again, a few centimetres from where it was. Attitude stays under control all along.

use mintime_shared::messages::{FlightState, Identity, Request};
use mintime_shared::vehicle::VehicleConfig;
use nalgebra::Vector3;

use super::connection::{Connection, Phase};
use super::outcome::{FlightError, Sight, Witness};
use super::position_control::Reference;
use super::{CLIMB_MPS, Calmness, Flight, HEADING_RAD};

/// The climb dies away for this long before anything is measured, s.
const SETTLE_S: f64 = 3.0;
/// The thrust that hovers is the mean command of this long, s.
const BASE_S: f64 = 1.0;
/// Before a hop the vehicle is within this of its place, m, ...
const CALM_POSITION_M: f64 = 0.03;
/// ... and slower than this, m/s ...
const CALM_SPEED_MPS: f64 = 0.03;
/// ... or has had this long, s: what it then does counts as it is.
const CALM_TIMEOUT_S: f64 = 4.0;
/// A hop that leads farther than this is broken off, m.
const HOP_BOUND_M: f64 = 0.35;

/// How to hover and hop.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HopPlan {
    /// Height above where it stands, m.
    pub height_m: f64,
    /// Length of the hover that is measured, s.
    pub hover_s: f64,
    /// Number of hops, first up and first down in turn.
    pub hops: u32,
    /// Change of thrust per mass, m/s².
    pub step_mps2: f64,
    /// Length of either half of a hop, s.
    pub pulse_s: f64,
    /// Rest between two hops at least, s.
    pub rest_s: f64,
    /// What the vehicle is, to be told where it does not know; `None` for a real one, which nobody but a person tells.
    pub vehicle: Option<VehicleConfig>,
}

impl Default for HopPlan {
    fn default() -> Self {
        Self {
            height_m: 1.2,
            hover_s: 8.0,
            hops: 12,
            step_mps2: 2.0,
            pulse_s: 0.15,
            rest_s: 1.2,
            vehicle: None,
        }
    }
}

/// One hop as it was flown.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hop {
    /// When its first half was commanded, s on the clock of the poses.
    pub began_s: f64,
    /// When its second half had passed, s.
    pub ended_s: f64,
}

/// What such a flight brings back.
#[derive(Clone, Debug)]
pub struct HopFlight {
    /// Who flew.
    pub identity: Identity,
    /// Every pose with what was commanded on it.
    pub sights: Vec<Sight>,
    /// When the measured hover began and ended, s.
    pub hover_s: (f64, f64),
    /// The hops that were flown to their end.
    pub hops: Vec<Hop>,
}

/// Keeps what is seen, and hands everything on.
struct Recorder<'a, W> {
    witness: &'a mut W,
    sights: Vec<Sight>,
}

impl<W: Witness> Witness for Recorder<'_, W> {
    fn phase(&mut self, phase: Phase, now_s: f64) {
        self.witness.phase(phase, now_s);
    }

    fn event(&mut self, now_s: f64, text: &str) {
        self.witness.event(now_s, text);
    }

    fn saw(&mut self, sight: &Sight) {
        self.sights.push(*sight);
        self.witness.saw(sight);
    }
}

/// Takes off where the vehicle stands, hovers, hops and lands.
///
/// # Errors
/// [`FlightError`] where the flight could not take place or lost its vehicle. The motors are off then, or the vehicle
/// has been told to switch them off.
pub fn fly_hops(
    connection: &mut impl Connection,
    plan: &HopPlan,
    witness: &mut impl Witness,
) -> Result<HopFlight, FlightError> {
    let mut recorder = Recorder { witness, sights: Vec::new() };
    let mut flight = Flight::new(connection, &mut recorder);
    let result = flight.run_hops(plan);
    flight.end(&result);
    let (identity, hover_s, hops) = result?;
    Ok(HopFlight { identity, sights: recorder.sights, hover_s, hops })
}

/// Who flew, from when to when it hovered (s), and the hops.
type Seen = (Identity, (f64, f64), Vec<Hop>);

impl<C: Connection, W: Witness> Flight<'_, C, W> {
    fn run_hops(&mut self, plan: &HopPlan) -> Result<Seen, FlightError> {
        self.enter(Phase::Prepare);
        let ground = self.step()?.position_m;
        let mut identity = self.identify()?;
        if let Some(vehicle) = plan.vehicle.filter(|vehicle| vehicle.hash() != identity.vehicle) {
            self.call("telling the vehicle what it is", Request::WriteVehicle(vehicle))?;
            identity = self.identify()?;
        }
        self.arm()?;
        self.level();

        self.enter(Phase::TakeOff);
        let top = ground + Vector3::z() * plan.height_m;
        self.move_to(ground, top, CLIMB_MPS)?;
        self.enter(Phase::Hover);
        self.calmness = Calmness::Calm;
        self.hover_for(SETTLE_S)?;
        let from_s = self.now_s;
        let mut base_mps2 = self.hover_for(plan.hover_s)?;
        let hover_s = (from_s, self.now_s);
        let mut hops = Vec::new();
        for number in 0..plan.hops {
            let first = if number % 2 == 0 { plan.step_mps2 } else { -plan.step_mps2 };
            hops.extend(self.hop(base_mps2, first, plan.pulse_s)?);
            base_mps2 = self.rest(top, plan.rest_s)?;
        }
        self.enter(Phase::Land);
        self.land(ground.z)?;
        Ok((identity, hover_s, hops))
    }

    /// Holds the reference for a while; returns the mean thrust commanded in the last second of it, m/s².
    fn hover_for(&mut self, duration_s: f64) -> Result<f64, FlightError> {
        let until_s = self.now_s + duration_s;
        let (mut sum, mut count) = (0.0, 0_u32);
        while self.now_s < until_s {
            self.watch("hovering", &[FlightState::Tracking])?;
            if let Some(setpoint) = self.said.filter(|_| self.now_s > until_s - BASE_S) {
                sum += f64::from(setpoint.thrust_mps2);
                count += 1;
            }
        }
        Ok(sum / f64::from(count.max(1)))
    }

    /// One hop; `None` where it led too far and was broken off.
    fn hop(&mut self, base_mps2: f64, first_mps2: f64, pulse_s: f64) -> Result<Option<Hop>, FlightError> {
        let centre = self.reference.map(|r| r.position_m);
        // What is set now is sent with the next pose: the hop begins there.
        let set = |change: f64| Some((base_mps2 + change) as f32);
        self.thrust_mps2 = set(first_mps2);
        let mut began_s = None;
        loop {
            let estimate = self.watch("hopping", &[FlightState::Tracking])?;
            let since_s = *began_s.get_or_insert(self.now_s);
            let part = (self.now_s - since_s) / pulse_s;
            let astray = centre.is_some_and(|c| (estimate.position_m - c).norm() > HOP_BOUND_M);
            if astray || part >= 2.0 {
                self.thrust_mps2 = None;
                return Ok((!astray).then_some(Hop { began_s: since_s, ended_s: self.now_s }));
            }
            self.thrust_mps2 = set(if part < 1.0 { first_mps2 } else { -first_mps2 });
        }
    }

    /// Back to the place and calm; returns the thrust that hovers.
    fn rest(&mut self, place: Vector3<f64>, rest_s: f64) -> Result<f64, FlightError> {
        self.reference = Some(Reference::hold(place, HEADING_RAD));
        let since_s = self.now_s;
        while self.now_s - since_s < CALM_TIMEOUT_S {
            let estimate = self.watch("hovering", &[FlightState::Tracking])?;
            let calm = (estimate.position_m - place).norm() <= CALM_POSITION_M
                && estimate.velocity_mps.norm() <= CALM_SPEED_MPS;
            if calm && self.now_s - since_s >= rest_s {
                break;
            }
        }
        self.hover_for(BASE_S)
    }
}

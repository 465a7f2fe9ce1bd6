//! What came of a mission: truth against plan, and how it went.

use mintime_shared::model::State;
use mintime_shared::replay::Plan;
use mintime_simulator::Truth;

use super::{EmulatedFlight, Prepared};
use crate::flight::{FlightError, FlightResult, Outcome, Trace};

/// A flown mission.
#[derive(Debug)]
pub struct Flown {
    /// What was flown.
    pub prepared: Prepared,
    /// How it went; an error for a flight that was lost.
    pub flight: Result<FlightResult, FlightError>,
    /// What flew: its name.
    pub vehicle: &'static str,
    /// What the emulator measured, where it ran the vehicle.
    pub emulated: Option<EmulatedFlight>,
    /// What was logged on the side.
    pub trace: Trace,
    /// Virtual time that the flight took, s.
    pub virtual_time_s: f64,
    /// Wall time that flying took, s.
    pub wall_time_s: f64,
}

/// Truth less plan, at one instant, in the maneuver's plane and across it. SI units.
#[derive(Clone, Copy, Debug, Default, PartialEq, serde::Serialize)]
pub struct PlanarError {
    /// Position along the heading.
    pub x_m: f64,
    /// Velocity along the heading.
    pub vx_mps: f64,
    /// Height.
    pub z_m: f64,
    /// Vertical velocity.
    pub vz_mps: f64,
    /// Pitch angle.
    pub theta_rad: f64,
    /// Pitch rate. Plans begin at rest and end turning, often at the limit.
    pub pitch_rate_radps: f64,
    /// Position out of the plane, to the left of the heading.
    pub y_m: f64,
    /// Velocity out of the plane.
    pub vy_mps: f64,
}

/// Rate of turn in the plane of a heading in the body frame, rad/s.
pub fn rate_in_plane([roll, pitch, _]: [f64; 3], heading_rad: f64) -> f64 {
    pitch * heading_rad.cos() - roll * heading_rad.sin()
}

impl PlanarError {
    fn new(
        difference: State<f64>,
        [y_m, vy_mps]: [f64; 2],
        truth: &Truth,
        planned_rate_radps: f64,
        heading_rad: f64,
    ) -> Self {
        let State { x, vx, z, vz, theta } = difference;
        let pitch_rate_radps = rate_in_plane(truth.rates_radps, heading_rad) - planned_rate_radps;
        Self { x_m: x, vx_mps: vx, z_m: z, vz_mps: vz, theta_rad: theta, pitch_rate_radps, y_m, vy_mps }
    }
}

impl Flown {
    /// Truth when the maneuver began less the planned start at the hover point. `None` if it never began.
    pub fn start_error(&self) -> Option<PlanarError> {
        let truth = self.trace.start.as_ref()?;
        let planned = self.prepared.table.start.cast::<f64>();
        let origin = State { x: planned.x, z: planned.z, ..State::origin() };
        let heading_rad = self.heading_rad();
        let difference = truth.planar(heading_rad).minus(planned.minus(origin));
        Some(PlanarError::new(difference, truth.across(heading_rad), truth, 0.0, heading_rad))
    }

    /// Truth when the table's time had passed less the planned end, positions relative to the true start.
    pub fn final_error(&self) -> Option<PlanarError> {
        let heading_rad = self.heading_rad();
        let (start, end) = (self.trace.start.as_ref()?, self.trace.end.as_ref()?);
        let table = &self.prepared.table;
        let began = start.planar(heading_rad);
        let planned = table.end.cast::<f64>();
        let from = table.start.cast::<f64>();
        // θ counts from where the vehicle's own turn counter stood at the start, in whole turns.
        let turn = core::f64::consts::TAU;
        let counted = ((began.theta - from.theta) / turn).round() * turn;
        let flown = end.planar(heading_rad);
        let relative = State {
            x: flown.x - began.x - (planned.x - from.x),
            vx: flown.vx - planned.vx,
            z: flown.z - began.z - (planned.z - from.z),
            vz: flown.vz - planned.vz,
            theta: flown.theta - counted - planned.theta,
        };
        let ([y0, _], [y, vy]) = (start.across(heading_rad), end.across(heading_rad));
        Some(PlanarError::new(relative, [y - y0, vy], end, self.final_rate_radps(), heading_rad))
    }

    /// How it went, in one word: that of [`FlightResult::outcome`], `lost` for a flight that failed, `crashed` where the
    /// vehicle hit the ground, whatever it reported itself.
    pub fn outcome(&self) -> &'static str {
        match &self.flight {
            _ if self.crashed() => "crashed",
            Ok(result) => result.outcome.name(),
            Err(_) => "lost",
        }
    }

    /// Why it went otherwise than planned, in words.
    pub fn reason(&self) -> Option<String> {
        let told = match &self.flight {
            Ok(result) => result.reason.clone(),
            Err(error) => Some(error.to_string()),
        };
        if !self.crashed() {
            return told;
        }
        Some(format!("the vehicle hit the ground{}", told.map(|t| format!("; {t}")).unwrap_or_default()))
    }

    /// Flown to the end, caught and landed.
    pub fn is_success(&self) -> bool {
        !self.crashed() && self.flight.as_ref().is_ok_and(|r| r.outcome == Outcome::Completed)
    }

    fn crashed(&self) -> bool {
        self.trace.last.as_ref().is_some_and(|truth| truth.crashed)
    }

    /// Pitch rate at which the plan ends, rad/s: it is still turning.
    fn final_rate_radps(&self) -> f64 {
        let plan = Plan::new(&self.prepared.table);
        let (end_s, step_s) = (plan.duration_s(), 1.0e-4);
        f64::from(plan.integrals((end_s - step_s).max(0.0), end_s).0 / step_s.min(end_s))
    }

    /// Heading of the plane that the maneuver is to be in, rad from the world's x axis, where the nose points.
    pub fn heading_rad(&self) -> f64 {
        self.prepared.heading_rad
    }

    /// Full turns of the maneuver.
    pub fn turns(&self) -> i32 {
        let table = &self.prepared.table;
        self.prepared.solution.as_ref().map_or_else(
            || ((table.end.theta - table.start.theta) / core::f32::consts::TAU).round() as i32,
            |s| s.extremal.turns,
        )
    }
}

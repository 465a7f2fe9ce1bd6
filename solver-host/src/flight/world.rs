//! The simulated world around a flight controller: airframe and cameras, and what truth says of the flight.

use mintime_shared::messages::{FlightState, Setpoint};
use mintime_simulator::{
    Command, ImuSample, PoseSample, Simulator, SimulatorError, Start, Truth, VehicleParameters,
};
use nalgebra::{Quaternion, UnitQuaternion, Vector3};

use super::connection::{Phase, Pose};
use crate::flight_log::{FlightSample, MocapSample, Truth as LoggedTruth};

/// Outside a maneuver every so many ticks are logged: 100 Hz.
const CALM_LOG_EVERY: u32 = 8;
/// Every tick is logged for this long after a maneuver, ns.
const LOG_AFTER_NS: u64 = 400_000_000;
/// No pose for this long means that motion capture has stopped, ns.
pub(super) const POSE_TIMEOUT_NS: u64 = 1_000_000_000;

/// What truth says about the maneuver.
#[derive(Clone, Debug, Default)]
pub struct Trace {
    /// Samples of the whole flight, dense around the maneuver.
    pub samples: Vec<FlightSample>,
    /// When the maneuver began, ns.
    pub start_ns: Option<u64>,
    /// Truth then.
    pub start: Option<Truth>,
    /// Truth when the table's duration had passed, had it not been cut short.
    pub end: Option<Truth>,
    /// Truth at the end of the flight.
    pub last: Option<Truth>,
}

/// What flies, where, and for how long.
#[derive(Clone, Copy, Debug)]
pub struct Scene<'a> {
    /// The airframe.
    pub parameters: &'a VehicleParameters,
    /// Seed of all that is random.
    pub seed: u64,
    /// The ground's height over the origin of the world, m; the vehicle stands on it, level and at rest.
    pub ground_z_m: f64,
    /// Heading of the maneuver's plane, rad. The vehicle's nose points along the world's x axis.
    pub heading_rad: f64,
    /// Duration after whose passing truth is noted, s.
    pub maneuver_s: f64,
}

/// One control tick, as the log sees it.
pub(super) struct Tick<'a> {
    pub(super) time_ns: u64,
    pub(super) sample: Option<&'a ImuSample>,
    pub(super) state: FlightState,
    pub(super) setpoint: Setpoint,
    pub(super) throttle: [f32; 4],
}

/// Airframe, cameras and log.
#[derive(Clone, Debug)]
pub(super) struct World {
    pub(super) simulator: Simulator,
    heading_rad: f64,
    maneuver_ns: u64,
    phase: Phase,
    state: FlightState,
    ticks: u32,
    dense_until_ns: u64,
    trace: Trace,
}

impl World {
    pub(super) fn new(scene: &Scene<'_>) -> Result<Self, SimulatorError> {
        Ok(Self {
            simulator: Simulator::new(scene.parameters, scene.seed, scene.ground_z_m, Start::default())?,
            heading_rad: scene.heading_rad,
            maneuver_ns: (scene.maneuver_s * 1e9).round() as u64,
            phase: Phase::default(),
            state: FlightState::default(),
            ticks: 0,
            dense_until_ns: 0,
            trace: Trace::default(),
        })
    }

    pub(super) fn enter(&mut self, phase: Phase) {
        self.phase = phase;
    }

    /// What has been logged, with the truth of this instant.
    pub(super) fn into_trace(mut self) -> Trace {
        self.trace.last = Some(self.simulator.truth());
        self.trace
    }

    /// Notes truth where a tick begins the maneuver, then hands the command to the airframe.
    pub(super) fn command(&mut self, tick: &Tick<'_>) {
        if tick.state == FlightState::Maneuver && self.state != FlightState::Maneuver {
            self.trace.start_ns = Some(tick.time_ns);
            self.trace.start = Some(self.simulator.truth());
            self.trace.end = None;
            self.dense_until_ns = tick.time_ns + self.maneuver_ns + LOG_AFTER_NS;
        }
        self.state = tick.state;
        self.apply(tick.throttle, tick.setpoint);
    }

    /// What the motors shall do from now on.
    pub(super) fn apply(&mut self, throttle: [f32; 4], setpoint: Setpoint) {
        self.simulator.apply(Command {
            throttle,
            rates_radps: setpoint.rates_radps,
            thrust_mps2: setpoint.thrust_mps2,
        });
    }

    /// Logs a tick: all of them around a maneuver, some of them else.
    pub(super) fn log(&mut self, tick: &Tick<'_>) {
        self.ticks = self.ticks.wrapping_add(1);
        if tick.time_ns >= self.dense_until_ns && !self.ticks.is_multiple_of(CALM_LOG_EVERY) {
            return;
        }
        self.trace.samples.push(FlightSample {
            time_ns: tick.time_ns,
            phase: self.phase.name().to_owned(),
            truth: self.logged_truth(),
            gyro_radps: tick.sample.map(|s| s.rates_radps),
            setpoint_radps: tick.setpoint.rates_radps,
            setpoint_thrust_mps2: tick.setpoint.thrust_mps2,
            throttle: tick.throttle,
            battery_v: self.simulator.battery_v(),
            mocap: None,
        });
    }

    fn logged_truth(&self) -> LoggedTruth {
        let truth = self.simulator.truth();
        LoggedTruth {
            position_m: truth.position_m,
            velocity_mps: truth.velocity_mps,
            attitude_wxyz: truth.attitude,
            body_rates_radps: truth.rates_radps,
            thrust_mps2: truth.thrust_mps2,
            planar: truth.planar(self.heading_rad),
        }
    }

    /// When the maneuver's duration has passed, if that is still to come.
    pub(super) fn end_ns(&self) -> Option<u64> {
        let end = self.trace.start_ns.map(|start| start + self.maneuver_ns);
        end.filter(|_| self.trace.end.is_none())
    }

    /// Stops at the instant at which the maneuver's duration has passed, to note truth, if nothing else happens before.
    pub(super) fn note_end(&mut self) {
        if let Some(end_ns) = self.end_ns()
            && self.simulator.next_event_time_ns() > end_ns
        {
            self.simulator.advance_to(end_ns);
            self.trace.end = Some(self.simulator.truth());
        }
    }

    /// Logs a pose and gives it to the host.
    pub(super) fn pose(&mut self, arrived_ns: u64, pose: &PoseSample) -> Pose {
        let [w, x, y, z] = pose.attitude;
        if let Some(last) = self.trace.samples.last_mut() {
            last.mocap = Some(MocapSample {
                captured_ns: pose.captured_ns,
                position_m: pose.position_m,
                attitude_wxyz: pose.attitude,
            });
        }
        Pose {
            captured_s: pose.captured_ns as f64 * 1e-9,
            arrived_s: arrived_ns as f64 * 1e-9,
            position_m: Vector3::from(pose.position_m),
            attitude: UnitQuaternion::from_quaternion(Quaternion::new(w, x, y, z)),
        }
    }
}

/// Whether the airframe is the planning model itself.
pub(super) fn is_planning_model(parameters: &VehicleParameters) -> bool {
    parameters.model == mintime_simulator::Model::Planning
}

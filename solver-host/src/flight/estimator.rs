//! Position, velocity and attitude from motion capture and from what the vehicle was told to do.
//!
//! Poses arrive late, so everything is estimated at the time of capture and then carried forward to now with the
//! commands given meanwhile. The estimate is of the simplest kind that hovers within the gate: fixed gains, and one
//! disturbance acceleration that takes up what is wrong with the thrust map.

use std::collections::VecDeque;

use mintime_shared::messages::Setpoint;
use mintime_shared::model::GRAVITY_MPS2;
use nalgebra::{UnitQuaternion, Vector3};

use super::connection::Pose;

/// From a setpoint's sending until the airframe responds, s: serial line, half a tick, rotors.
const RESPONSE_S: f64 = 0.014;
/// Bandwidth of the observer in calm flight, rad/s: well above the position loop, well below the cameras' rate.
const CALM_BANDWIDTH_RADPS: f64 = 15.0;
/// Bandwidth during and after a maneuver, where the thrust model is wrong by more.
const AGILE_BANDWIDTH_RADPS: f64 = 45.0;
/// Weight of a measured attitude against the propagated one in calm flight; the rest averages the cameras' noise.
const CALM_ATTITUDE_GAIN: f64 = 0.15;
/// The same in agile flight.
const AGILE_ATTITUDE_GAIN: f64 = 0.8;
/// Largest disturbance acceleration believed, m/s²: a thrust map wrong by 15 %, and a breeze.
const DISTURBANCE_MAX_MPS2: f64 = 3.0;
/// Commands older than this are history, s.
const HISTORY_S: f64 = 0.2;

/// Where the vehicle is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Estimate {
    /// Position, m.
    pub position_m: Vector3<f64>,
    /// Velocity, m/s.
    pub velocity_mps: Vector3<f64>,
    /// Attitude, body to world.
    pub attitude: UnitQuaternion<f64>,
    /// Acceleration that the commands do not explain, m/s².
    pub disturbance_mps2: Vector3<f64>,
}

impl Estimate {
    /// Angle between the thrust axis and the vertical, rad.
    pub fn tilt_rad(&self) -> f64 {
        (self.attitude * Vector3::z()).angle(&Vector3::z())
    }

    /// Heading of the forward axis, rad.
    pub fn heading_rad(&self) -> f64 {
        let forward = self.attitude * Vector3::x();
        forward.y.atan2(forward.x)
    }
}

/// How calm the flight is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Calmness {
    /// Standing on the ground: thrust is not acceleration.
    Grounded,
    /// Hovering, climbing, sinking.
    Calm,
    /// In or right after a maneuver.
    Agile,
}

/// The observer.
#[derive(Clone, Debug)]
pub struct Estimator {
    captured: Option<(f64, Estimate)>,
    /// Commands with the time from which they act on the airframe, s.
    commands: VecDeque<(f64, Setpoint)>,
}

impl Default for Estimator {
    fn default() -> Self {
        Self::new()
    }
}

impl Estimator {
    /// Nothing known.
    pub fn new() -> Self {
        Self { captured: None, commands: VecDeque::new() }
    }

    /// Notes what the vehicle is told to do from `sent_s` on, by the host or by its table.
    pub fn note_command(&mut self, sent_s: f64, setpoint: Setpoint) {
        self.commands.push_back((sent_s + RESPONSE_S, setpoint));
        while self.commands.len() > 1 && self.commands[1].0 < sent_s - HISTORY_S {
            self.commands.pop_front();
        }
    }

    /// Takes a pose; returns the estimate at its arrival plus the vehicle's response time: when a setpoint sent now
    /// begins to act.
    pub fn update(&mut self, pose: &Pose, calmness: Calmness) -> Estimate {
        let captured = match self.captured {
            Some((since, estimate)) if pose.captured_s > since => {
                let predicted = self.propagate(estimate, since, pose.captured_s, calmness);
                correct(predicted, pose, pose.captured_s - since, calmness)
            }
            Some((_, estimate)) => estimate,
            None => Estimate {
                position_m: pose.position_m,
                velocity_mps: Vector3::zeros(),
                attitude: pose.attitude,
                disturbance_mps2: Vector3::zeros(),
            },
        };
        self.captured = Some((pose.captured_s, captured));
        self.propagate(captured, pose.captured_s, pose.arrived_s + RESPONSE_S, calmness)
    }

    /// Carries an estimate from one time to another with the commands in force.
    fn propagate(&self, mut estimate: Estimate, from_s: f64, to_s: f64, calmness: Calmness) -> Estimate {
        if calmness == Calmness::Grounded {
            return estimate;
        }
        let mut now = from_s;
        while now < to_s {
            let next_change = self.commands.iter().map(|c| c.0).find(|&t| t > now).unwrap_or(to_s);
            let next = next_change.min(to_s);
            let hover = Setpoint { rates_radps: [0.0; 3], thrust_mps2: GRAVITY_MPS2 as f32 };
            let command = self.commands.iter().rev().find(|c| c.0 <= now).map_or(hover, |c| c.1);
            let dt = next - now;
            let rates = Vector3::from(command.rates_radps.map(f64::from));
            let half = UnitQuaternion::from_scaled_axis(rates * (dt / 2.0));
            let middle = estimate.attitude * half;
            let acceleration = middle * Vector3::z() * f64::from(command.thrust_mps2)
                - Vector3::z() * GRAVITY_MPS2
                + estimate.disturbance_mps2;
            estimate.position_m += estimate.velocity_mps * dt + acceleration * (dt * dt / 2.0);
            estimate.velocity_mps += acceleration * dt;
            estimate.attitude = middle * half;
            now = next;
        }
        estimate
    }
}

/// Corrects a prediction by a pose. Gains put the observer's poles at one place, exp(−bandwidth·dt).
fn correct(predicted: Estimate, pose: &Pose, dt: f64, calmness: Calmness) -> Estimate {
    let error = pose.position_m - predicted.position_m;
    let (bandwidth, attitude_gain) = match calmness {
        Calmness::Grounded | Calmness::Calm => (CALM_BANDWIDTH_RADPS, CALM_ATTITUDE_GAIN),
        Calmness::Agile => (AGILE_BANDWIDTH_RADPS, AGILE_ATTITUDE_GAIN),
    };
    let pole = (-bandwidth * dt).exp();
    let attitude = predicted.attitude.try_slerp(&pose.attitude, attitude_gain, 1e-9).unwrap_or(pose.attitude);
    let corrected = match calmness {
        // On the ground nothing moves.
        Calmness::Grounded => Estimate {
            position_m: pose.position_m,
            velocity_mps: Vector3::zeros(),
            disturbance_mps2: Vector3::zeros(),
            ..predicted
        },
        Calmness::Calm => {
            let disturbance = predicted.disturbance_mps2 + error * ((1.0 - pole).powi(3) / (dt * dt));
            Estimate {
                position_m: predicted.position_m + error * (1.0 - pole.powi(3)),
                velocity_mps: predicted.velocity_mps
                    + error * (1.5 * (1.0 - pole).powi(2) * (1.0 + pole) / dt),
                disturbance_mps2: disturbance.cap_magnitude(DISTURBANCE_MAX_MPS2),
                ..predicted
            }
        }
        // The thrust model is wrong in many ways at once: what it does is not one disturbance.
        Calmness::Agile => Estimate {
            position_m: predicted.position_m + error * (1.0 - pole.powi(2)),
            velocity_mps: predicted.velocity_mps + error * ((1.0 - pole).powi(2) / dt),
            ..predicted
        },
    };
    Estimate { attitude, ..corrected }
}

//! Position control: from where the vehicle is and should be to body rates and thrust.
//!
//! Cascade of the usual kind: position and velocity error give an acceleration, the acceleration gives a thrust
//! direction, the angle to that direction gives body rates. It also catches a vehicle that comes out of a maneuver
//! tilted and moving.

use mintime_shared::messages::Setpoint;
use mintime_shared::model::GRAVITY_MPS2;
use nalgebra::{Matrix3, Rotation3, UnitQuaternion, Vector3};

use super::estimator::Estimate;

/// Position gain, 1/s²: 3 rad/s.
const POSITION_GAIN: f64 = 9.0;
/// Velocity gain, 1/s: damping ratio 0.9.
const VELOCITY_GAIN: f64 = 5.4;
/// Attitude gain, 1/s: three times faster than the position loop, three times slower than the rate loop.
const ATTITUDE_GAIN: f64 = 10.0;
/// Heading gain, 1/s: yaw torque is weak.
const HEADING_GAIN: f64 = 3.0;
/// Largest acceleration asked for along the ground, m/s²: 35° of tilt.
const LATERAL_MAX_MPS2: f64 = 7.0;
/// Vertical acceleration asked for, m/s².
const VERTICAL_MPS2: (f64, f64) = (-6.0, 8.0);
/// Largest body rate asked for, rad/s.
const RATE_MAX_RADPS: f64 = 6.0;
/// Thrust per mass asked for, m/s²: never so little that attitude is lost.
const THRUST_MPS2: (f64, f64) = (3.0, 20.0);

/// Where the vehicle should be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reference {
    /// Position, m.
    pub position_m: Vector3<f64>,
    /// Velocity, m/s.
    pub velocity_mps: Vector3<f64>,
    /// Heading, rad.
    pub heading_rad: f64,
}

impl Reference {
    /// At rest at a place.
    pub fn hold(position_m: Vector3<f64>, heading_rad: f64) -> Self {
        Self { position_m, velocity_mps: Vector3::zeros(), heading_rad }
    }
}

/// The setpoint that leads from the estimate to the reference.
pub fn control(estimate: &Estimate, reference: &Reference) -> Setpoint {
    let wanted = POSITION_GAIN * (reference.position_m - estimate.position_m)
        + VELOCITY_GAIN * (reference.velocity_mps - estimate.velocity_mps)
        - estimate.disturbance_mps2;
    let lateral = Vector3::new(wanted.x, wanted.y, 0.0).cap_magnitude(LATERAL_MAX_MPS2);
    let vertical = wanted.z.clamp(VERTICAL_MPS2.0, VERTICAL_MPS2.1);
    let thrust = lateral + Vector3::z() * (vertical + GRAVITY_MPS2);

    let up = thrust.normalize();
    let heading = Vector3::new(reference.heading_rad.cos(), reference.heading_rad.sin(), 0.0);
    // `up` is within 70° of the vertical, so it never lines up with the heading.
    let left = up.cross(&heading).normalize();
    let axes = Matrix3::from_columns(&[left.cross(&up), left, up]);
    let target = UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_unchecked(axes));
    let error = (estimate.attitude.inverse() * target).scaled_axis();
    let rates = Vector3::new(ATTITUDE_GAIN * error.x, ATTITUDE_GAIN * error.y, HEADING_GAIN * error.z)
        .cap_magnitude(RATE_MAX_RADPS);
    let along_body = thrust.dot(&(estimate.attitude * Vector3::z()));
    Setpoint {
        rates_radps: [rates.x as f32, rates.y as f32, rates.z as f32],
        thrust_mps2: along_body.clamp(THRUST_MPS2.0, THRUST_MPS2.1) as f32,
    }
}

//! Body-rate control from the gyro alone: proportional on the setpoint, integral on the deviation from the expected
//! response, feed-forward of what is known beforehand, per axis.
//!
//! No vehicle turns at once, so a loop that integrates setpoint less rate winds up in every turn and overshoots its end.
//! This one integrates against a reference model: the setpoint as a healthy vehicle follows it, first order with
//! [`RATE_RESPONSE_S`]. Its lag at the beginning of a turn and at the end cancel, and what is left of the integral is the
//! angle by which the vehicle departs from its plan for reasons that are not planned: this is how a vehicle that has
//! no idea of its attitude still flies a turn to its end, and how it knows that it does not.
//!
//! Known beforehand are:
//!
//! - the angular acceleration of the reference model, of which [`FEED_FORWARD`] is asked for at once;
//! - the gyroscopic torque of a turn about an axis that is none of the body's own, as in a diagonal plane;
//! - the *trim*: the torque that unequal rotors and an off-centre mass make, in proportion to thrust. It is learned in
//!   calm flight and kept in a maneuver, which begins with a fresh integral and has no time to learn it.
//!
//! The proportional path sees the gyro through a low-pass filter ([`LowPass`]), for noise and vibration go through it to
//! the motors; the integral smooths by itself, and the angle must not be late.

use mintime_shared::real::{at_least, at_most};

use crate::config::control::{
    FEED_FORWARD, RATE_FILTER_HZ, TRIM_BOUND, TRIM_CALM_RADPS, TRIM_GAIN_PER_S3, TRIM_THRUST_MIN_MPS2,
};
use crate::config::{
    INTEGRAL_BOUND_RAD, RATE_GAIN_PER_S, RATE_INTEGRAL_PER_S2, RATE_RESPONSE_S, VehicleConfig,
};
use crate::low_pass::LowPass;
use crate::mixer::Saturation;

/// Divided by the compiler: on the vehicle a division is as long as ten multiplications.
const FEED_FORWARD_PER_S: f32 = FEED_FORWARD / RATE_RESPONSE_S;

/// What a step of the loop works on.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct RateInput {
    /// Commanded over the step that ends now, rad/s.
    pub asked: [f32; 3],
    /// Commanded from now on, rad/s.
    pub next: [f32; 3],
    /// Measured at its end, rad/s.
    pub measured: [f32; 3],
    /// Collective thrust per mass commanded from now on, m/s².
    pub thrust_mps2: f32,
    /// Length of the step, s.
    pub dt_s: f32,
    /// Whether the angle itself is owed, as in a maneuver. Elsewhere somebody else closes a loop around the attitude, and
    /// the integral of an axis at its limit must not grow: anti-windup.
    pub follow_angle: bool,
}

/// The loop's memory.
#[derive(Clone, Copy, Debug)]
pub struct RateController {
    expected_radps: [f32; 3],
    angle_error_rad: [f32; 3],
    /// Angular acceleration per thrust, rad/s² per m/s².
    trim: [f32; 3],
    filter: LowPass,
    /// Which axes got less than they asked for in the last step.
    limited: [bool; 3],
}

impl RateController {
    /// A fresh loop.
    pub const fn new() -> Self {
        Self {
            expected_radps: [0.0; 3],
            angle_error_rad: [0.0; 3],
            trim: [0.0; 3],
            filter: LowPass::new(RATE_FILTER_HZ),
            limited: [false; 3],
        }
    }

    /// Sets the cutoff of the gyro's low-pass, Hz, within what [`mintime_shared::settings::Settings::check`] allows. It
    /// starts over: with the motors off.
    pub fn set_cutoff_hz(&mut self, cutoff_hz: f32) {
        self.filter = LowPass::new(f64::from(cutoff_hz));
    }

    /// Forgets accumulated errors, but not the trim; the vehicle turns at these rates now.
    pub fn reset(&mut self, measured: [f32; 3]) {
        let measured = measured.map(finite);
        self.expected_radps = measured;
        self.angle_error_rad = [0.0; 3];
        self.filter.settle(measured);
        self.limited = [false; 3];
    }

    /// Forgets the trim as well: the motors are off, and what flies next may be loaded otherwise.
    pub fn rest(&mut self, measured: [f32; 3]) {
        self.reset(measured);
        self.trim = [0.0; 3];
    }

    /// Accumulated expected less measured angle since the reset, rad, bounded.
    pub fn angle_error_rad(&self) -> [f32; 3] {
        self.angle_error_rad
    }

    /// The trim, rad/s² per m/s² of thrust.
    pub fn trim(&self) -> [f32; 3] {
        self.trim
    }

    /// Says what the mixer made of the last demand: an axis that gets less than it asks for learns no trim, and its integral
    /// grows only where the angle is owed.
    pub fn limited(&mut self, saturation: &Saturation) {
        self.limited = saturation.axes;
    }

    /// One step: the angular acceleration to ask for, rad/s².
    ///
    /// The integral compares what was expected with what was done over the same step.
    pub fn update(&mut self, config: &VehicleConfig, input: &RateInput) -> [f32; 3] {
        let RateInput { asked, next, measured, thrust_mps2, dt_s, follow_angle } = *input;
        let blend = (dt_s / RATE_RESPONSE_S).clamp(0.0, 1.0);
        let filtered = self.filter.update(measured);
        let calm = thrust_mps2 >= TRIM_THRUST_MIN_MPS2 && next.iter().all(|r| r.abs() <= TRIM_CALM_RADPS);
        // One division for three axes.
        let learning = if calm { TRIM_GAIN_PER_S3 * dt_s / thrust_mps2 } else { 0.0 };
        let mut demand = gyroscopic(config, self.expected_radps);
        let memory = self
            .expected_radps
            .iter_mut()
            .zip(&mut self.angle_error_rad)
            .zip(&mut self.trim)
            .zip(self.limited);
        let rates = asked.into_iter().zip(next).zip(measured).zip(filtered);
        let gains = RATE_GAIN_PER_S.into_iter().zip(RATE_INTEGRAL_PER_S2);
        for (
            ((slot, (((expected, angle_error), trim), limited)), (((asked, next), done), filtered)),
            (gain, integral),
        ) in demand.iter_mut().zip(memory).zip(rates).zip(gains)
        {
            // The trapezoid of the response over the step, so that its integral is the setpoint's but for the lag.
            let before = *expected;
            *expected = finite(before + blend * (asked - before));
            let error = finite(*angle_error + (0.5 * (before + *expected) - done) * dt_s);
            let error = error.clamp(-INTEGRAL_BOUND_RAD, INTEGRAL_BOUND_RAD);
            if follow_angle || !limited || error.abs() < angle_error.abs() {
                *angle_error = error;
            }
            if calm && !limited {
                let learned = *trim + learning * *angle_error;
                *trim = at_most(at_least(finite(learned), -TRIM_BOUND), TRIM_BOUND);
            }
            let known = FEED_FORWARD_PER_S * (next - *expected) + *trim * thrust_mps2;
            *slot += gain * (next - filtered) + integral * *angle_error + known;
        }
        demand
    }
}

impl Default for RateController {
    fn default() -> Self {
        Self::new()
    }
}

/// The angular acceleration that a body turning at these rates needs so as to go on turning: J⁻¹ (ω × Jω).
fn gyroscopic(config: &VehicleConfig, [wx, wy, wz]: [f32; 3]) -> [f32; 3] {
    let [jx, jy, jz] = config.inertia_kgm2;
    [(jz - jy) / jx * wy * wz, (jx - jz) / jy * wz * wx, (jy - jx) / jz * wx * wy]
}

/// NaN would stay for ever.
fn finite(value: f32) -> f32 {
    if value.is_finite() { value } else { 0.0 }
}

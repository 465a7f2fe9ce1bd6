//! Body-rate control from the gyro alone: proportional and integral, per axis.
//!
//! The integral of the rate error is the angle by which the vehicle lags its setpoints since the loop was reset: this
//! is how a vehicle that has no idea of its attitude still flies a planned turn to its end.

use crate::config::{INTEGRAL_BOUND_RAD, RATE_GAIN_PER_S, RATE_INTEGRAL_PER_S2};

/// The loop's memory.
#[derive(Clone, Copy, Debug, Default)]
pub struct RateController {
    angle_error_rad: [f32; 3],
}

impl RateController {
    /// A fresh loop.
    pub const fn new() -> Self {
        Self { angle_error_rad: [0.0; 3] }
    }

    /// Forgets accumulated errors.
    pub fn reset(&mut self) {
        *self = Self::new();
    }

    /// Accumulated setpoint less measured angle since the reset, rad, bounded.
    pub fn angle_error_rad(&self) -> [f32; 3] {
        self.angle_error_rad
    }

    /// One step of length `dt_s`: the angular acceleration to ask for, rad/s².
    ///
    /// `setpoint` is what was commanded over the step that ends now together with `measured`; `next` is what is
    /// commanded from now on. The integral compares what was asked with what was done over the same step.
    pub fn update(&mut self, setpoint: [f32; 3], next: [f32; 3], measured: [f32; 3], dt_s: f32) -> [f32; 3] {
        let mut demand = [0.0; 3];
        let axes =
            demand.iter_mut().zip(&mut self.angle_error_rad).zip(RATE_GAIN_PER_S).zip(RATE_INTEGRAL_PER_S2);
        for ((((slot, angle_error), gain), integral), ((asked, next), done)) in
            axes.zip(setpoint.into_iter().zip(next).zip(measured))
        {
            let error = *angle_error + (asked - done) * dt_s;
            // NaN would stay for ever.
            *angle_error =
                if error.is_finite() { error.clamp(-INTEGRAL_BOUND_RAD, INTEGRAL_BOUND_RAD) } else { 0.0 };
            *slot = gain * (next - done) + integral * *angle_error;
        }
        demand
    }
}

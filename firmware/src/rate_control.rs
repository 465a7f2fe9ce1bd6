//! Body-rate control from the gyro alone: proportional on the setpoint, integral on the deviation from the expected
//! response, per axis.
//!
//! No vehicle turns at once, so a loop that integrates setpoint less rate winds up in every turn and overshoots its end.
//! This one integrates against a reference model: the setpoint as a healthy vehicle follows it, first order with
//! [`RATE_RESPONSE_S`]. Its lag at the beginning of a turn and at the end cancel, and what is left of the integral is the
//! angle by which the vehicle departs from its plan for reasons that are not planned: this is how a vehicle that has
//! no idea of its attitude still flies a turn to its end, and how it knows that it does not.

use crate::config::{INTEGRAL_BOUND_RAD, RATE_GAIN_PER_S, RATE_INTEGRAL_PER_S2, RATE_RESPONSE_S};

/// The loop's memory.
#[derive(Clone, Copy, Debug, Default)]
pub struct RateController {
    expected_radps: [f32; 3],
    angle_error_rad: [f32; 3],
}

impl RateController {
    /// A fresh loop.
    pub const fn new() -> Self {
        Self { expected_radps: [0.0; 3], angle_error_rad: [0.0; 3] }
    }

    /// Forgets accumulated errors; the vehicle turns at these rates now.
    pub fn reset(&mut self, measured: [f32; 3]) {
        *self = Self { expected_radps: measured, angle_error_rad: [0.0; 3] };
    }

    /// Accumulated expected less measured angle since the reset, rad, bounded.
    pub fn angle_error_rad(&self) -> [f32; 3] {
        self.angle_error_rad
    }

    /// One step of length `dt_s`: the angular acceleration to ask for, rad/s².
    ///
    /// `asked` is what was commanded over the step that ends now with `measured`; `next` is what is commanded from now
    /// on. The integral compares what was expected with what was done over the same step.
    pub fn update(&mut self, asked: [f32; 3], next: [f32; 3], measured: [f32; 3], dt_s: f32) -> [f32; 3] {
        let blend = (dt_s / RATE_RESPONSE_S).clamp(0.0, 1.0);
        let mut demand = [0.0; 3];
        let memory = self.expected_radps.iter_mut().zip(&mut self.angle_error_rad);
        let rates = asked.into_iter().zip(next).zip(measured);
        let gains = RATE_GAIN_PER_S.into_iter().zip(RATE_INTEGRAL_PER_S2);
        for (((slot, (expected, angle_error)), ((asked, next), done)), (gain, integral)) in
            demand.iter_mut().zip(memory).zip(rates).zip(gains)
        {
            // The trapezoid of the response over the step, so that its integral is the setpoint's but for the lag.
            let before = *expected;
            *expected = finite(before + blend * (asked - before));
            let error = finite(*angle_error + (0.5 * (before + *expected) - done) * dt_s);
            *angle_error = error.clamp(-INTEGRAL_BOUND_RAD, INTEGRAL_BOUND_RAD);
            *slot = gain * (next - done) + integral * *angle_error;
        }
        demand
    }
}

/// NaN would stay for ever.
fn finite(value: f32) -> f32 {
    if value.is_finite() { value } else { 0.0 }
}

//! The planning model, eq. (2) carried to three dimensions, in closed form.
//!
//! Under constant body rates ω and thrust per mass F the thrust axis is R₀ exp(\[ω\]t) ẑ. By Rodrigues' formula its
//! integrals are sums of ẑ, ω × ẑ and ω × (ω × ẑ) with scalar functions of |ω|t, so velocity and position follow exactly.
//! This is written independently of the formulas that plan maneuvers: a flight compares the two.

use nalgebra::{Quaternion, UnitQuaternion, Vector3};

use crate::rigid_body::BodyState;

/// Body rates beyond this, rad/s, are cut off: nothing built turns faster, and the series below converge to rounding.
pub(crate) const RATE_MAX_RADPS: f64 = 200.0;

/// Thrust per mass beyond this, m/s², is cut off: a hundred times gravity.
pub(crate) const THRUST_MAX_MPS2: f64 = 1000.0;

/// The state after a step of at most a millisecond under `state.rates` and a thrust per mass, in m/s².
pub(crate) fn step(state: &BodyState, thrust_mps2: f64, gravity_mps2: f64, step_s: f64) -> BodyState {
    let h = step_s;
    let once = state.rates.cross(&Vector3::z());
    let twice = state.rates.cross(&once);
    let angle = state.rates.norm() * h;
    // (1 − cos φ)/φ², (φ − sin φ)/φ³, (φ²/2 − 1 + cos φ)/φ⁴.
    let a = series(angle, [2.0, 12.0, 30.0, 56.0, 90.0]);
    let b = series(angle, [6.0, 20.0, 42.0, 72.0, 110.0]);
    let c = series(angle, [24.0, 30.0, 56.0, 90.0, 132.0]);
    let rotation = state.rotation();
    let axis_integral = rotation * (Vector3::z() * h + once * (h * h * a) + twice * (h * h * h * b));
    let axis_double_integral =
        rotation * (Vector3::z() * (0.5 * h * h) + once * (h * h * h * b) + twice * (h * h * h * h * c));
    let gravity = Vector3::z() * gravity_mps2;
    BodyState {
        position: state.position + state.velocity * h + axis_double_integral * thrust_mps2
            - gravity * (0.5 * h * h),
        velocity: state.velocity + axis_integral * thrust_mps2 - gravity * h,
        attitude: turned(rotation, state.rates * h).into_inner(),
        ..*state
    }
}

/// An attitude after a turn by a rotation vector (rad) given in body axes.
pub(crate) fn turned(attitude: UnitQuaternion<f64>, turn: Vector3<f64>) -> UnitQuaternion<f64> {
    let angle = turn.norm();
    let (sin, cos) = libm::sincos(0.5 * angle);
    let per_angle = if angle > 1e-9 { sin / angle } else { 0.5 };
    UnitQuaternion::new_normalize(attitude.into_inner() * Quaternion::from_parts(cos, turn * per_angle))
}

/// (1 − (φ²/r₁)(1 − (φ²/r₂)(…)))/r₀: an alternating series by the ratios of its terms. For φ ≤ 0.2 the first term left
/// out is below 1e-16.
fn series(angle: f64, ratios: [f64; 5]) -> f64 {
    let square = angle * angle;
    let [first, rest @ ..] = ratios;
    rest.iter().rev().fold(1.0, |sum, ratio| 1.0 - square / ratio * sum) / first
}

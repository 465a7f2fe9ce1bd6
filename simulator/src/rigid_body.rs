//! The rigid body and its rotors: forces, torques, and their integration.
//!
//! World frame: z up. Body frame: x forward, y left, z up, origin at the centre of mass. Newton and Euler:
//!
//! m v̇ = R (T ẑ + f_drag) − m g ẑ,  J ω̇ = Σ rᵢ × Tᵢ ẑ + Σ sᵢ (κ Tᵢ + J_r Ω̇ᵢ) ẑ − ω × (J ω + h),
//!
//! with Tᵢ = kᵢ Ωᵢ², sᵢ the yaw sign of [`MOTORS`], and h = −ẑ Σ sᵢ J_r Ωᵢ the angular momentum of the rotors.

use mintime_shared::frames::MOTORS;
use nalgebra::{Matrix3, Quaternion, UnitQuaternion, Vector3, Vector4};

use crate::{
    noise::{Noise, Source},
    parameters::{Battery, VehicleParameters},
};

/// Body rates beyond this, rad/s, turn by a radian and more in a step of a quarter of a millisecond.
const RATE_SOUND_RADPS: f64 = 4000.0;

/// Position, velocity (world), attitude (body to world), body rates, rotor speeds, battery charge (0 to 1); also
/// their time derivatives.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct BodyState {
    pub(crate) position: Vector3<f64>,
    pub(crate) velocity: Vector3<f64>,
    pub(crate) attitude: Quaternion<f64>,
    pub(crate) rates: Vector3<f64>,
    pub(crate) rotors: Vector4<f64>,
    pub(crate) charge: f64,
}

impl BodyState {
    /// At rest, rotors stopped.
    pub(crate) fn at_rest(position: Vector3<f64>, attitude: UnitQuaternion<f64>, charge: f64) -> Self {
        Self {
            position,
            velocity: Vector3::zeros(),
            attitude: attitude.into_inner(),
            rates: Vector3::zeros(),
            rotors: Vector4::zeros(),
            charge,
        }
    }

    fn plus(&self, derivative: &Self, step_s: f64) -> Self {
        Self {
            position: self.position + derivative.position * step_s,
            velocity: self.velocity + derivative.velocity * step_s,
            attitude: self.attitude + derivative.attitude * step_s,
            rates: self.rates + derivative.rates * step_s,
            rotors: self.rotors + derivative.rotors * step_s,
            charge: self.charge + derivative.charge * step_s,
        }
    }

    /// Whether the integration still means something: all numbers finite, and less than a radian of turn in a step.
    pub(crate) fn is_sound(&self) -> bool {
        let finite = |v: &[f64]| v.iter().all(|x| x.is_finite());
        finite(self.position.as_slice())
            && finite(self.velocity.as_slice())
            && finite(self.attitude.coords.as_slice())
            && self.rates.norm() < RATE_SOUND_RADPS
            && finite(self.rotors.as_slice())
            && self.charge.is_finite()
    }

    /// Attitude as a rotation, body to world.
    pub(crate) fn rotation(&self) -> UnitQuaternion<f64> {
        UnitQuaternion::new_normalize(self.attitude)
    }
}

/// The vehicle as a mechanical system.
#[derive(Clone, Debug)]
pub(crate) struct RigidBody {
    mass_kg: f64,
    gravity_mps2: f64,
    battery: Battery,
    inertia: Matrix3<f64>,
    inertia_inverse: Matrix3<f64>,
    /// Thrust coefficient of each rotor, errors included.
    thrust_coefficients: Vector4<f64>,
    /// Torque about the body axes per thrust of each rotor, m.
    torque_per_thrust: [Vector3<f64>; 4],
    /// Yaw sign of each rotor.
    yaw: Vector4<f64>,
    torque_ratio_m: f64,
    rotor_inertia: f64,
    time_constant_up_s: f64,
    time_constant_down_s: f64,
    /// Steady rotor speed per throttle and volt.
    speed_per_volt: f64,
    rotor_drag_per_s: Vector3<f64>,
    body_drag: Vector3<f64>,
    hover_speed: f64,
}

impl RigidBody {
    pub(crate) fn new(parameters: &VehicleParameters, seed: u64) -> Self {
        let VehicleParameters { body, rotors, drag, esc, .. } = parameters;
        let mut noise = Noise::new(seed, Source::Rotors);
        let inertia = Matrix3::from_diagonal(&Vector3::from(body.inertia_kgm2));
        Self {
            mass_kg: body.mass_kg,
            gravity_mps2: parameters.gravity_mps2,
            battery: parameters.battery.clone(),
            inertia,
            inertia_inverse: Matrix3::from_diagonal(&Vector3::from(body.inertia_kgm2.map(|j| 1.0 / j))),
            thrust_coefficients: Vector4::from_fn(|_, _| {
                rotors.thrust_coefficient_ns2 * (1.0 + noise.within(rotors.thrust_error))
            }),
            torque_per_thrust: MOTORS.map(|motor| {
                let arm = Vector3::new(
                    f64::from(motor.forward) * body.rotor_forward_m,
                    f64::from(motor.left) * body.rotor_left_m,
                    0.0,
                );
                arm.cross(&Vector3::z()) + Vector3::z() * f64::from(motor.yaw) * rotors.torque_ratio_m
            }),
            yaw: Vector4::from(MOTORS.map(|motor| f64::from(motor.yaw))),
            torque_ratio_m: rotors.torque_ratio_m,
            rotor_inertia: rotors.inertia_kgm2,
            time_constant_up_s: rotors.time_constant_up_s,
            time_constant_down_s: rotors.time_constant_down_s,
            speed_per_volt: esc.full_speed_radps / esc.nominal_v,
            rotor_drag_per_s: Vector3::from(drag.rotor_per_s),
            body_drag: Vector3::from(drag.body_ns2_per_m2),
            hover_speed: parameters.hover_speed_radps(),
        }
    }

    /// Thrust of each rotor, N.
    fn thrusts(&self, rotors: &Vector4<f64>) -> Vector4<f64> {
        self.thrust_coefficients.component_mul(&rotors.component_mul(rotors))
    }

    /// Collective thrust per mass, m/s².
    pub(crate) fn thrust_mps2(&self, state: &BodyState) -> f64 {
        self.thrusts(&state.rotors).sum() / self.mass_kg
    }

    /// Battery voltage under load, V.
    pub(crate) fn battery_v(&self, state: &BodyState) -> f64 {
        self.battery.voltage_v(state.charge, self.air_power_w(state))
    }

    /// Mechanical power that the rotors put into the air, W.
    fn air_power_w(&self, state: &BodyState) -> f64 {
        self.torque_ratio_m * self.thrusts(&state.rotors).dot(&state.rotors)
    }

    /// Specific force in the body frame in free flight, m/s²: all forces but gravity, per mass.
    pub(crate) fn specific_force(&self, state: &BodyState) -> Vector3<f64> {
        let velocity = state.rotation().inverse_transform_vector(&state.velocity);
        let rotor_drag = self.rotor_drag_per_s * (state.rotors.mean() / self.hover_speed);
        let body_drag = self.body_drag.component_mul(&velocity.abs()) / self.mass_kg;
        Vector3::z() * self.thrust_mps2(state) - (rotor_drag + body_drag).component_mul(&velocity)
    }

    /// Time derivative of the state under throttles. On the ground only the rotors move.
    fn derivative(&self, state: &BodyState, throttle: &[f64; 4], on_ground: bool) -> BodyState {
        let air_w = self.air_power_w(state);
        let voltage = self.battery.voltage_v(state.charge, air_w);
        let charge = -self.battery.discharge_per_s(state.charge, air_w);
        let spin_up = Vector4::from_fn(|i, _| {
            let lag = throttle[i] * self.speed_per_volt * voltage - state.rotors[i];
            lag / if lag > 0.0 { self.time_constant_up_s } else { self.time_constant_down_s }
        });
        if on_ground {
            return BodyState {
                position: Vector3::zeros(),
                velocity: Vector3::zeros(),
                attitude: Quaternion::from_parts(0.0, Vector3::zeros()),
                rates: Vector3::zeros(),
                rotors: spin_up,
                charge,
            };
        }
        let thrusts = self.thrusts(&state.rotors);
        let torque =
            self.torque_per_thrust.iter().zip(thrusts.iter()).map(|(arm, t)| arm * *t).sum::<Vector3<f64>>()
                + Vector3::z() * self.rotor_inertia * self.yaw.dot(&spin_up);
        let momentum =
            self.inertia * state.rates - Vector3::z() * self.rotor_inertia * self.yaw.dot(&state.rotors);
        BodyState {
            position: state.velocity,
            velocity: state.rotation() * self.specific_force(state) - Vector3::z() * self.gravity_mps2,
            attitude: state.attitude * Quaternion::from_parts(0.0, 0.5 * state.rates),
            rates: self.inertia_inverse * (torque - state.rates.cross(&momentum)),
            rotors: spin_up,
            charge,
        }
    }

    /// One step of the classical Runge-Kutta method of fourth order.
    pub(crate) fn step(
        &self,
        state: &BodyState,
        throttle: &[f64; 4],
        on_ground: bool,
        step_s: f64,
    ) -> BodyState {
        let rate = |s: &BodyState| self.derivative(s, throttle, on_ground);
        let k1 = rate(state);
        let k2 = rate(&state.plus(&k1, 0.5 * step_s));
        let k3 = rate(&state.plus(&k2, 0.5 * step_s));
        let k4 = rate(&state.plus(&k3, step_s));
        let mut next = state
            .plus(&k1, step_s / 6.0)
            .plus(&k2, step_s / 3.0)
            .plus(&k3, step_s / 3.0)
            .plus(&k4, step_s / 6.0);
        next.attitude = next.attitude.normalize();
        next
    }

    /// Kinetic and potential energy of the body without its rotors' spin, J; angular momentum of body and rotors in the
    /// world frame, N m s.
    #[cfg(test)]
    fn invariants(&self, state: &BodyState) -> (f64, Vector3<f64>) {
        let momentum = self.inertia * state.rates;
        let energy = 0.5 * self.mass_kg * state.velocity.norm_squared()
            + 0.5 * state.rates.dot(&momentum)
            + self.mass_kg * self.gravity_mps2 * state.position.z;
        let spin = Vector3::z() * self.rotor_inertia * self.yaw.dot(&state.rotors);
        (energy, state.rotation() * (momentum - spin))
    }
}

#[cfg(test)]
#[path = "rigid_body_tests.rs"]
mod tests;

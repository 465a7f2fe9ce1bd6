//! The first-principles model that learning differentiates: eq. (2), with thrust and rate that follow their commands late,
//! and with the rotors' drag.
//!
//! ```text
//! ẍ = k F sin θ − D cos θ     τ_F Ḟ = F_c − F     D = d √(kF/g) (ẋ cos θ − ż sin θ)
//! z̈ = k F cos θ + D sin θ − g     τ_ω ω̇ = ω_c − ω     θ̇ = ω
//! ```
//!
//! F_c and ω_c are what the table commands, k the thrust scale, D the deceleration along the body's forward axis. Integrated by
//! the classical Runge-Kutta method with steps that end at every switch; in dual numbers, which carry the derivatives by all
//! parameters along, exact for the method.

use mintime_shared::model::{State, ThrustLevel};
use mintime_shared::real::Real;
use mintime_shared::table::ManeuverTable;
use nalgebra::DMatrix;
use serde::{Deserialize, Serialize};

use super::correction::weights;
use super::history::StateError;
use super::parameters::{MAX_PARAMETERS, Parameters};
use crate::solver::Dual;

/// Longest step of the integration, s.
const STEP_S: f64 = 1.0e-3;
/// A lag below this is none, s: the step would have to be shorter.
const NO_LAG_S: f64 = 1.0e-3;

/// Largest drag that is believed, 1/s: four times that of a racing quadrotor.
const DRAG_MAX_PER_S: f64 = 2.0;
/// How finely it is looked for, 1/s.
const DRAG_RESOLUTION_PER_S: f64 = 1.0e-3;

/// How a vehicle answers its commands.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Response {
    /// True over commanded thrust.
    pub thrust_scale: f64,
    /// Time constant of the thrust, s; less than a millisecond counts as none.
    pub thrust_lag_s: f64,
    /// Time constant of the pitch rate, s; less than a millisecond counts as none.
    pub rate_lag_s: f64,
    /// Deceleration over speed along the body's forward axis with the rotors at hover speed, 1/s.
    pub drag_per_s: f64,
}

impl Response {
    /// The planning model itself.
    pub const IDEAL: Self = Self { thrust_scale: 1.0, thrust_lag_s: 0.0, rate_lag_s: 0.0, drag_per_s: 0.0 };

    /// Where a table ends with these parameters in place of its own, from its own start at rest with thrust that hovers.
    pub fn end(&self, table: &ManeuverTable, parameters: &Parameters) -> State<f64> {
        let durations: Vec<f64> = parameters.durations_s.clone();
        let arc = arc_of(table, parameters);
        State::from_array(self.integrate(table, &durations, arc))
    }

    /// The same with its derivatives by each parameter: x, ẋ, z, ż, θ in rows, parameters in columns (those of
    /// [`Parameters`]: seconds, the logarithm of the width, seconds).
    pub fn linearised(&self, table: &ManeuverTable, parameters: &Parameters) -> (State<f64>, DMatrix<f64>) {
        type D = Dual<MAX_PARAMETERS>;
        let count = parameters.durations_s.len();
        let durations: Vec<D> =
            parameters.durations_s.iter().enumerate().map(|(i, d)| D::variable(*d, i)).collect();
        let (width, peak) = arc_of(table, parameters);
        let (mut width, mut peak) = (D::constant(width), D::constant(peak));
        if parameters.arc.is_some() {
            // By the logarithm: ∂w/∂ln w = w.
            width.grad[count] = width.value;
            peak.grad[count + 1] = 1.0;
        }
        let end = self.integrate(table, &durations, (width, peak));
        let jacobian = DMatrix::from_fn(5, parameters.count(), |i, j| end[i].grad[j]);
        (State::from_array(end.map(|v| v.value)), jacobian)
    }

    /// The same vehicle with the drag that explains an error at the end best: the least weighted square of what is left of it.
    #[must_use]
    pub fn with_drag_of(&self, table: &ManeuverTable, parameters: &Parameters, error: &StateError) -> Self {
        let weights = weights();
        let (target, seen) = (table.end.cast::<f64>(), error.to_array());
        let dragged = |drag_per_s: f64| Self { drag_per_s, ..*self };
        let left = |drag_per_s: f64| {
            let miss = dragged(drag_per_s).end(table, parameters).minus(target).to_array();
            (0..5).map(|i| (weights[i] * (seen[i] - miss[i])).powi(2)).sum::<f64>()
        };
        // Golden section.
        let part = 0.5 * (5.0_f64.sqrt() - 1.0);
        let (mut low, mut high) = (0.0, DRAG_MAX_PER_S);
        while high - low > DRAG_RESOLUTION_PER_S {
            let (a, b) = (high - part * (high - low), low + part * (high - low));
            if left(a) < left(b) { high = b } else { low = a }
        }
        dragged(0.5 * (low + high))
    }

    fn integrate<T: Real>(&self, table: &ManeuverTable, durations_s: &[T], arc: (T, T)) -> [T; 5] {
        let limits = table.limits.cast::<f64>();
        let start = table.start.cast::<f64>().to_array();
        let hover = T::from_f64(limits.gravity_mps2 / self.thrust_scale);
        let [x, vx, z, vz, theta] = start.map(T::from_f64);
        let mut state = [x, vx, z, vz, theta, T::zero(), hover];
        let mut began = T::zero();
        for (segment, &duration) in table.segments().zip(durations_s) {
            let steps = (duration.to_f64() / STEP_S).ceil().max(1.0);
            let h = duration * T::from_f64(1.0 / steps);
            let thrust = match segment.inputs.thrust {
                ThrustLevel::Min => limits.thrust_min_mps2,
                ThrustLevel::Max => limits.thrust_max_mps2,
            };
            let sign: Option<f64> = segment.inputs.rate.sign();
            let command = |time: T| match sign {
                Some(sign) => T::from_f64(sign * limits.rate_max_radps),
                None => {
                    let (width, since) = (arc.0, time - arc.1);
                    width / (width * width + since * since)
                }
            };
            for i in 0..steps as u32 {
                let time = began + h * T::from_f64(f64::from(i));
                state = self.step(state, time, h, &command, T::from_f64(thrust), limits.gravity_mps2);
            }
            began += duration;
        }
        let [x, vx, z, vz, theta, ..] = state;
        [x, vx, z, vz, theta]
    }

    /// One step of the Runge-Kutta method. Without a lag the input is the command.
    fn step<T: Real>(
        &self,
        state: [T; 7],
        time: T,
        h: T,
        command: &impl Fn(T) -> T,
        thrust: T,
        gravity_mps2: f64,
    ) -> [T; 7] {
        let half = h * T::from_f64(0.5);
        let rate = |s: &[T; 7], t: T| self.derivative(s, command(t), thrust, gravity_mps2);
        let moved = |by: &[T; 7], length: T| core::array::from_fn(|i| state[i] + by[i] * length);
        let k1 = rate(&state, time);
        let k2 = rate(&moved(&k1, half), time + half);
        let k3 = rate(&moved(&k2, half), time + half);
        let k4 = rate(&moved(&k3, h), time + h);
        let (sixth, two) = (h * T::from_f64(1.0 / 6.0), T::from_f64(2.0));
        core::array::from_fn(|i| state[i] + sixth * (k1[i] + two * (k2[i] + k3[i]) + k4[i]))
    }

    fn derivative<T: Real>(&self, state: &[T; 7], rate: T, thrust: T, gravity_mps2: f64) -> [T; 7] {
        let [_, vx, _, vz, theta, omega, force] = *state;
        let follow = |is: T, wished: T, lag_s: f64| (wished - is) * T::from_f64(1.0 / lag_s);
        let (omega, turning) = if self.rate_lag_s < NO_LAG_S {
            (rate, T::zero())
        } else {
            (omega, follow(omega, rate, self.rate_lag_s))
        };
        let (force, building) = if self.thrust_lag_s < NO_LAG_S {
            (thrust, T::zero())
        } else {
            (force, follow(force, thrust, self.thrust_lag_s))
        };
        let true_thrust = force * T::from_f64(self.thrust_scale);
        let (sin, cos) = theta.sin_cos();
        let mut drag = T::zero();
        if self.drag_per_s > 0.0 {
            // Rotors' drag grows with their speed, thrust with its square.
            let speed = (true_thrust * T::from_f64(1.0 / gravity_mps2)).sqrt();
            drag = T::from_f64(self.drag_per_s) * speed * (vx * cos - vz * sin);
        }
        [
            vx,
            true_thrust * sin - drag * cos,
            vz,
            true_thrust * cos + drag * sin - T::from_f64(gravity_mps2),
            omega,
            turning,
            building,
        ]
    }
}

fn arc_of(table: &ManeuverTable, parameters: &Parameters) -> (f64, f64) {
    let own = table.arcs.map(|arc| (f64::from(arc.width_s), f64::from(arc.peak_s)));
    parameters.arc.or(own).unwrap_or((1.0, 0.0))
}

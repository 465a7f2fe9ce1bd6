//! What the vehicle is made of: every number of the physical model, with unit and meaning.
//!
//! The values of the two built-in vehicles, and where each comes from, stand in `presets.rs`; `docs/vehicles.md` shows
//! them as a table. Quantities marked *drawn* differ from vehicle to vehicle: the simulator draws them once, from the
//! seed.

mod presets;
mod read;

pub(crate) use presets::ACCELEROMETER_G_MPS2;
pub use read::ParameterError;
use serde::{Deserialize, Serialize};

/// Standard gravity on Earth in m/s², as flight planning uses it.
pub const STANDARD_GRAVITY_MPS2: f64 = mintime_shared::model::GRAVITY_MPS2;

/// A vehicle and the sensors that watch it. SI units.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct VehicleParameters {
    /// Which equations move the vehicle.
    pub model: Model,
    /// Gravity, m/s².
    pub gravity_mps2: f64,
    /// Mass, inertia, shape.
    pub body: Body,
    /// The four rotors.
    pub rotors: Rotors,
    /// Aerodynamic drag of the whole vehicle.
    pub drag: Drag,
    /// Battery.
    pub battery: Battery,
    /// Electronic speed controllers: from throttle to rotor speed.
    pub esc: Esc,
    /// The clock and the mounting that gyro and accelerometer share.
    pub imu: Imu,
    /// Gyro.
    pub gyro: Gyro,
    /// Accelerometer.
    pub accelerometer: Accelerometer,
    /// Motion capture system of the room.
    pub motion_capture: MotionCapture,
    /// The ground and what it forgives.
    pub ground: Ground,
}

/// Which equations move the vehicle.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Model {
    /// A rigid body with four rotors: only the throttles act.
    RigidBody,
    /// The planning model, eq. (2) carried to three dimensions: body rates and thrust per mass follow the command at
    /// once and exactly; body, rotors, drag and battery do not matter. All throttles at zero mean motors off.
    Planning,
}

/// Mass, inertia, shape.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Body {
    /// Mass, kg.
    pub mass_kg: f64,
    /// Moments of inertia about the body axes x (forward), y (left), z (up), kg m². Products of inertia are zero.
    pub inertia_kgm2: [f64; 3],
    /// Distance of the rotors from the centre of mass along the body x axis, m.
    pub rotor_forward_m: f64,
    /// Distance of the rotors from the centre of mass along the body y axis, m.
    pub rotor_left_m: f64,
}

/// The four rotors.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Rotors {
    /// Thrust over rotor speed squared, N s²/rad².
    pub thrust_coefficient_ns2: f64,
    /// Reaction torque over thrust, κ, m.
    pub torque_ratio_m: f64,
    /// Time constant of the rotor speed when it rises, s. At least 0.001.
    pub time_constant_up_s: f64,
    /// Time constant of the rotor speed when it falls, s. At least 0.001.
    pub time_constant_down_s: f64,
    /// Moment of inertia of one rotor with its bell about its axis, kg m²: reaction to spin-up, and gyroscopic torque.
    pub inertia_kgm2: f64,
    /// Largest relative error of a rotor's thrust coefficient (and with it of its torque): *drawn* for each rotor,
    /// uniform within ± this.
    pub thrust_error: f64,
}

/// Aerodynamic drag of the whole vehicle.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Drag {
    /// Rotor drag: deceleration over speed along the body axes, 1/s, with the rotors at hover speed. It scales with the
    /// mean rotor speed.
    pub rotor_per_s: [f64; 3],
    /// Drag of the body: force over speed squared along the body axes, N s²/m².
    pub body_ns2_per_m2: [f64; 3],
}

/// Battery: an open-circuit voltage that falls with the charge drawn, behind a resistance.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Battery {
    /// Open-circuit voltage when full, V.
    pub full_v: f64,
    /// Open-circuit voltage when empty, V. Between the two it falls linearly with the charge drawn.
    pub empty_v: f64,
    /// Capacity, A s (1 Ah is 3600 A s).
    pub capacity_as: f64,
    /// Charge at the start, 0 to 1.
    pub charge: f64,
    /// Resistance of cells and leads together, Ω.
    pub resistance_ohm: f64,
    /// Share of the electric power that reaches the air, above 0 and at most 1.
    pub efficiency: f64,
    /// Power of everything that is not a motor, W.
    pub electronics_w: f64,
}

/// Electronic speed controllers: the steady rotor speed is throttle × `full_speed_radps` × battery voltage /
/// `nominal_v`, and zero throttle stops the rotor.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Esc {
    /// Steady rotor speed at full throttle and nominal voltage, rad/s.
    pub full_speed_radps: f64,
    /// Battery voltage to which `full_speed_radps` belongs, V.
    pub nominal_v: f64,
}

/// The clock and the mounting that gyro and accelerometer share.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Imu {
    /// Output data rate, Hz.
    pub rate_hz: f64,
    /// Largest relative error of the sensor's own clock: *drawn*, uniform within ± this. The phase of the first sample
    /// is drawn as well, unless this is 0.
    pub clock_error: f64,
    /// Largest rotation of the sensor about each body axis, rad: *drawn*, uniform within ± this.
    pub misalignment_rad: f64,
    /// Whether the SI values carry the quantisation and the saturation of the raw counts. The raw counts always do.
    pub quantised: bool,
}

/// Gyro: true rate → misalignment → vibration → low-pass filter → scale, bias, noise → counts.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Gyro {
    /// Range, degrees per second: the counts saturate here.
    pub range_dps: f64,
    /// Counts per degree per second.
    pub lsb_per_dps: f64,
    /// −3 dB bandwidth of the low-pass filter, Hz; 0 switches it off.
    pub bandwidth_hz: f64,
    /// Density of the white noise, rad/s/√Hz.
    pub noise_density_radps: f64,
    /// Bias of each axis, rad/s: *drawn*, normal with this standard deviation.
    pub bias_radps: f64,
    /// Largest relative scale error of each axis: *drawn*, uniform within ± this.
    pub scale_error: f64,
    /// Amplitude on each axis, rad/s, of the vibration of one rotor at hover speed and its own frequency. It grows with
    /// the square of the rotor's speed, as the force of an imbalance does.
    pub vibration_radps: f64,
}

/// Accelerometer: specific force (acceleration minus gravity), treated as the gyro is.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Accelerometer {
    /// Range in units of 9.80665 m/s²: the counts saturate here.
    pub range_g: f64,
    /// Counts per 9.80665 m/s².
    pub lsb_per_g: f64,
    /// −3 dB bandwidth of the low-pass filter, Hz; 0 switches it off.
    pub bandwidth_hz: f64,
    /// Density of the white noise, m/s²/√Hz.
    pub noise_density_mps2: f64,
    /// Bias of each axis, m/s²: *drawn*, normal with this standard deviation.
    pub bias_mps2: f64,
    /// Largest relative scale error of each axis: *drawn*, uniform within ± this.
    pub scale_error: f64,
    /// Amplitude on each axis, m/s², of the vibration of one rotor at hover speed; see [`Gyro::vibration_radps`].
    pub vibration_mps2: f64,
}

/// Motion capture: position of the centre of mass and attitude of the body, late and noisy.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct MotionCapture {
    /// Frames per second, Hz.
    pub rate_hz: f64,
    /// Time from the exposure to the arrival of the pose, s.
    pub latency_s: f64,
    /// Additional latency, uniform from 0 to this, s. At most one frame period, so that poses arrive in order.
    pub latency_jitter_s: f64,
    /// Standard deviation of the position noise on each axis, m.
    pub position_noise_m: f64,
    /// Standard deviation of the attitude noise about each axis, rad.
    pub attitude_noise_rad: f64,
    /// Standard deviation, about each axis, of the constant rotation between the frame of the markers and the body,
    /// rad: *drawn*.
    pub attitude_offset_rad: f64,
    /// Probability that a frame is lost, 0 to [`MotionCapture::DROP_OUT_MAX`].
    pub drop_out: f64,
}

impl MotionCapture {
    /// Highest probability of a lost frame that still makes sense to simulate. To lose all, inject
    /// [`Fault::MotionCaptureSilent`](crate::Fault::MotionCaptureSilent).
    pub const DROP_OUT_MAX: f64 = 0.99;
}

/// The ground and what it forgives.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Ground {
    /// A touch-down at more than this vertical speed, m/s, is a crash.
    pub crash_speed_mps: f64,
    /// A touch-down with more than this tilt, rad, is a crash.
    pub crash_tilt_rad: f64,
}

impl VehicleParameters {
    /// Rotor speed at which four perfect rotors carry the weight, rad/s.
    pub fn hover_speed_radps(&self) -> f64 {
        libm::sqrt(self.body.mass_kg * self.gravity_mps2 / (4.0 * self.rotors.thrust_coefficient_ns2))
    }

    /// Steady thrust per mass, m/s², of four perfect rotors with the same throttle (0 to 1) at a battery voltage (V,
    /// under load).
    pub fn thrust_mps2(&self, throttle: f64, battery_v: f64) -> f64 {
        let speed = throttle.clamp(0.0, 1.0) * self.esc.full_speed_radps * battery_v / self.esc.nominal_v;
        4.0 * self.rotors.thrust_coefficient_ns2 * speed * speed / self.body.mass_kg
    }

    /// Throttle, 0 to 1, at which four perfect rotors give a thrust per mass (m/s²) at a battery voltage (V, under
    /// load): the inverse of [`thrust_mps2`](Self::thrust_mps2), cut off at full throttle.
    pub fn throttle(&self, thrust_mps2: f64, battery_v: f64) -> f64 {
        let full = self.thrust_mps2(1.0, battery_v);
        if full > 0.0 { libm::sqrt((thrust_mps2 / full).clamp(0.0, 1.0)) } else { 1.0 }
    }
}

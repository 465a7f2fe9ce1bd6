//! From a TOML file to a vehicle that can exist: overrides on a base vehicle, then physical checks.

use toml::{Table, Value};

use super::{MotionCapture, VehicleParameters};

/// Why a vehicle description was refused.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ParameterError {
    /// The text is not TOML, or not the TOML of a vehicle: a wrong type or an unknown field.
    #[error("the vehicle description cannot be read: {0}")]
    Format(String),
    /// `base` names a vehicle that is not built in.
    #[error("there is no base vehicle `{0}`: write base = \"nominal\" or base = \"ideal\"")]
    UnknownBase(String),
    /// A value cannot belong to a vehicle.
    #[error("{field} is {value}, but {rule}")]
    Value {
        /// Path of the field, as in `body.mass_kg`.
        field: String,
        /// The value given.
        value: f64,
        /// What holds for every vehicle, as the second half of a sentence.
        rule: &'static str,
    },
}

/// What a number must be, and the sentence that says so.
#[derive(Clone, Copy)]
enum Rule {
    Positive,
    NotNegative,
    /// Time constants: long enough for the fixed steps of the integration.
    Lag,
    /// Coefficients in 1/s: slow enough for the fixed steps of the integration.
    Decay,
    /// Relative errors of half and more are no longer errors, and 1 would divide by zero.
    RelativeError,
    /// Above 0, at most 1.
    Efficiency,
    /// 0 to 1.
    Share,
    Probability,
    /// Sampling rates: above zero, and at most what the fixed steps of the integration can serve.
    Rate,
    /// Angles up to a quarter turn.
    Angle,
}

/// Highest sampling rate the simulator serves, Hz: one sample in each step of the integration.
const RATE_MAX_HZ: f64 = 4000.0;

/// Shortest rotor time constant, s: four steps of the integration.
const LAG_MIN_S: f64 = 0.001;

/// Fastest linear drag, 1/s: forty steps of the integration to decay.
const DECAY_MAX_PER_S: f64 = 100.0;

/// No quantity of a small vehicle, in SI units, is larger: beyond it the arithmetic would overflow, not fly.
const MAGNITUDE_MAX: f64 = 1e6;

impl Rule {
    fn check(self, value: f64) -> Option<&'static str> {
        if !value.is_finite() {
            return Some("it must be a finite number");
        }
        if value.abs() > MAGNITUDE_MAX {
            return Some("no small vehicle has such a value: check the unit (SI)");
        }
        let (holds, rule) = match self {
            Self::Positive => (value > 0.0, "it must be above zero"),
            Self::NotNegative => (value >= 0.0, "it must not be negative"),
            Self::Lag => (value >= LAG_MIN_S, "it must be at least 0.001 s"),
            Self::Decay => ((0.0..=DECAY_MAX_PER_S).contains(&value), "it must lie between 0 and 100 1/s"),
            Self::RelativeError => {
                ((0.0..0.5).contains(&value), "it must lie between 0 and 0.5 (0.02 is 2 %)")
            }
            Self::Efficiency => (value > 0.0 && value <= 1.0, "it must be above 0 and at most 1"),
            Self::Share => ((0.0..=1.0).contains(&value), "it must lie between 0 and 1"),
            Self::Probability => {
                ((0.0..=MotionCapture::DROP_OUT_MAX).contains(&value), "it must lie between 0 and 0.99")
            }
            Self::Rate => ((1.0..=RATE_MAX_HZ).contains(&value), "it must lie between 1 and 4000 Hz"),
            Self::Angle => {
                ((0.0..=core::f64::consts::FRAC_PI_2).contains(&value), "it must lie between 0 and π/2 rad")
            }
        };
        (!holds).then_some(rule)
    }
}

impl VehicleParameters {
    /// Reads a vehicle from TOML. Every field is optional; those that are missing keep the value of the vehicle that
    /// `base` names, `"nominal"` (also without `base`) or `"ideal"`.
    ///
    /// ```
    /// # use mintime_simulator::VehicleParameters;
    /// let heavier = VehicleParameters::from_toml("body.mass_kg = 0.85\n[battery]\ncharge = 0.4")?;
    /// assert_eq!(heavier.rotors, VehicleParameters::nominal().rotors);
    /// # Ok::<(), mintime_simulator::ParameterError>(())
    /// ```
    ///
    /// # Errors
    /// [`ParameterError`], with one sentence that names the field and says what to write instead.
    pub fn from_toml(text: &str) -> Result<Self, ParameterError> {
        let mut given: Table =
            text.parse().map_err(|e: toml::de::Error| ParameterError::Format(e.to_string().trim().into()))?;
        let base = match given.remove("base") {
            None => Self::nominal(),
            Some(Value::String(name)) if name == "nominal" => Self::nominal(),
            Some(Value::String(name)) if name == "ideal" => Self::ideal(),
            Some(other) => {
                return Err(ParameterError::UnknownBase(
                    other.as_str().map_or_else(|| other.to_string(), str::to_owned),
                ));
            }
        };
        let mut merged = Table::try_from(&base).map_err(|e| ParameterError::Format(e.to_string()))?;
        overlay(&mut merged, given);
        let vehicle: Self = merged
            .try_into()
            .map_err(|e: toml::de::Error| ParameterError::Format(one_line(&e.to_string())))?;
        vehicle.validate()?;
        Ok(vehicle)
    }

    /// Writes every field as TOML that [`from_toml`](Self::from_toml) reads back unchanged.
    ///
    /// # Errors
    /// [`ParameterError::Format`] if a value has no place in TOML; the fields of this type all have one.
    pub fn to_toml(&self) -> Result<String, ParameterError> {
        toml::to_string(self).map_err(|e| ParameterError::Format(e.to_string()))
    }

    /// Checks that such a vehicle can exist and, for a rigid body, that it can lift its own weight.
    ///
    /// # Errors
    /// [`ParameterError::Value`] with the first field that is wrong.
    pub fn validate(&self) -> Result<(), ParameterError> {
        let refuse =
            |field: &str, value, rule| Err(ParameterError::Value { field: field.to_owned(), value, rule });
        for (field, value, rule) in self.scalars() {
            if let Some(rule) = rule.check(value) {
                return refuse(field, value, rule);
            }
        }
        for (field, values, rule) in self.vectors() {
            for (value, axis) in values.into_iter().zip(["x", "y", "z"]) {
                if let Some(rule) = rule.check(value) {
                    return refuse(&format!("{field} along {axis}"), value, rule);
                }
            }
        }
        let [x, y, z] = self.body.inertia_kgm2;
        if x + y < z || y + z < x || z + x < y {
            let largest = x.max(y).max(z);
            return refuse(
                "the largest of body.inertia_kgm2",
                largest,
                "no solid body has a moment above the sum of the other two",
            );
        }
        if self.battery.empty_v > self.battery.full_v {
            return refuse("battery.empty_v", self.battery.empty_v, "it must not be above battery.full_v");
        }
        if self.motion_capture.latency_jitter_s * self.motion_capture.rate_hz > 1.0 {
            return refuse(
                "motion_capture.latency_jitter_s",
                self.motion_capture.latency_jitter_s,
                "it must not exceed one frame period, or poses would arrive out of order",
            );
        }
        let lift = self.thrust_mps2(1.0, self.battery.empty_v);
        if self.model == super::Model::RigidBody && lift <= self.gravity_mps2 {
            return refuse(
                "full thrust per mass on an empty battery, m/s²",
                lift,
                "it must be above gravity, or the vehicle cannot fly: check mass, rotors, esc and battery",
            );
        }
        Ok(())
    }

    /// Every number of the vehicle that is not a vector, with its path and its rule.
    fn scalars(&self) -> [(&'static str, f64, Rule); 45] {
        use Rule::{Angle, Efficiency, Lag, NotNegative, Positive, Probability, Rate, RelativeError, Share};
        let Self { body, rotors, battery, esc, imu, gyro, accelerometer, motion_capture, ground, .. } = self;
        [
            ("gravity_mps2", self.gravity_mps2, Positive),
            ("body.mass_kg", body.mass_kg, Positive),
            ("body.rotor_forward_m", body.rotor_forward_m, Positive),
            ("body.rotor_left_m", body.rotor_left_m, Positive),
            ("rotors.thrust_coefficient_ns2", rotors.thrust_coefficient_ns2, Positive),
            ("rotors.torque_ratio_m", rotors.torque_ratio_m, Positive),
            ("rotors.time_constant_up_s", rotors.time_constant_up_s, Lag),
            ("rotors.time_constant_down_s", rotors.time_constant_down_s, Lag),
            ("rotors.inertia_kgm2", rotors.inertia_kgm2, NotNegative),
            ("rotors.thrust_error", rotors.thrust_error, RelativeError),
            ("battery.full_v", battery.full_v, Positive),
            ("battery.empty_v", battery.empty_v, Positive),
            ("battery.capacity_as", battery.capacity_as, Positive),
            ("battery.charge", battery.charge, Share),
            ("battery.resistance_ohm", battery.resistance_ohm, NotNegative),
            ("battery.efficiency", battery.efficiency, Efficiency),
            ("battery.electronics_w", battery.electronics_w, NotNegative),
            ("esc.full_speed_radps", esc.full_speed_radps, Positive),
            ("esc.nominal_v", esc.nominal_v, Positive),
            ("imu.rate_hz", imu.rate_hz, Rate),
            ("imu.clock_error", imu.clock_error, RelativeError),
            ("imu.misalignment_rad", imu.misalignment_rad, Angle),
            ("gyro.range_dps", gyro.range_dps, Positive),
            ("gyro.lsb_per_dps", gyro.lsb_per_dps, Positive),
            ("gyro.bandwidth_hz", gyro.bandwidth_hz, NotNegative),
            ("gyro.noise_density_radps", gyro.noise_density_radps, NotNegative),
            ("gyro.bias_radps", gyro.bias_radps, NotNegative),
            ("gyro.scale_error", gyro.scale_error, RelativeError),
            ("gyro.vibration_radps", gyro.vibration_radps, NotNegative),
            ("accelerometer.range_g", accelerometer.range_g, Positive),
            ("accelerometer.lsb_per_g", accelerometer.lsb_per_g, Positive),
            ("accelerometer.bandwidth_hz", accelerometer.bandwidth_hz, NotNegative),
            ("accelerometer.noise_density_mps2", accelerometer.noise_density_mps2, NotNegative),
            ("accelerometer.bias_mps2", accelerometer.bias_mps2, NotNegative),
            ("accelerometer.scale_error", accelerometer.scale_error, RelativeError),
            ("accelerometer.vibration_mps2", accelerometer.vibration_mps2, NotNegative),
            ("motion_capture.rate_hz", motion_capture.rate_hz, Rate),
            ("motion_capture.latency_s", motion_capture.latency_s, Share),
            ("motion_capture.latency_jitter_s", motion_capture.latency_jitter_s, Share),
            ("motion_capture.position_noise_m", motion_capture.position_noise_m, NotNegative),
            ("motion_capture.attitude_noise_rad", motion_capture.attitude_noise_rad, Angle),
            ("motion_capture.attitude_offset_rad", motion_capture.attitude_offset_rad, Angle),
            ("motion_capture.drop_out", motion_capture.drop_out, Probability),
            ("ground.crash_speed_mps", ground.crash_speed_mps, NotNegative),
            ("ground.crash_tilt_rad", ground.crash_tilt_rad, Angle),
        ]
    }

    fn vectors(&self) -> [(&'static str, [f64; 3], Rule); 3] {
        [
            ("body.inertia_kgm2", self.body.inertia_kgm2, Rule::Positive),
            ("drag.rotor_per_s", self.drag.rotor_per_s, Rule::Decay),
            ("drag.body_ns2_per_m2", self.drag.body_ns2_per_m2, Rule::NotNegative),
        ]
    }
}

/// Puts the given values over those of the base, table by table.
fn overlay(base: &mut Table, given: Table) {
    for (key, value) in given {
        match (base.get_mut(&key), value) {
            (Some(Value::Table(below)), Value::Table(above)) => overlay(below, above),
            (_, value) => {
                base.insert(key, value);
            }
        }
    }
}

/// The parser's message on one line: its own spans several, and the position it shows is that of the merged table.
fn one_line(message: &str) -> String {
    message.split_whitespace().collect::<Vec<_>>().join(" ")
}

//! The planar quadrotor of the paper's section II: limits, states, inputs, and the dimensionless form.
//!
//! Axes: x along the plane's heading, z up, pitch θ positive nose-down, so that positive θ accelerates towards +x
//! (eq. (2): ẍ = F sin θ, z̈ = F cos θ − g, θ̇ = ω, with F the thrust per mass). Angles are unwrapped: 2π is one
//! full turn, not zero.
//!
//! SI units stand at every interface. Inside the solver everything is dimensionless by eq. (3): time in 1/ω_max,
//! length in g/ω_max², so that gravity and the rate limit are both 1 and only two numbers are left, the thrust limits
//! in units of gravity (eq. (5)).

use serde::{Deserialize, Serialize};

use crate::real::Real;

/// Standard planning gravity of the paper, m/s².
pub const GRAVITY_MPS2: f64 = 9.81;

/// Limits of a vehicle, eq. (1), and the gravity it flies in. SI units.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Limits<T> {
    /// Lowest collective thrust per mass, m/s². Greater than zero, below gravity for a vehicle that can hover.
    pub thrust_min_mps2: T,
    /// Highest collective thrust per mass, m/s². Above gravity for a vehicle that can hover.
    pub thrust_max_mps2: T,
    /// Highest magnitude of the pitch rate, rad/s. Greater than zero.
    pub rate_max_radps: T,
    /// Gravity, m/s². Greater than zero.
    pub gravity_mps2: T,
}

/// Why a set of limits cannot be planned with.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, thiserror::Error)]
pub enum LimitsError {
    /// A limit is NaN or infinite.
    #[error("a limit is not a finite number: give finite numbers for thrust, body rate and gravity")]
    NotFinite,
    /// Gravity is zero or negative.
    #[error("gravity must be above zero (9.81 m/s² on Earth)")]
    Gravity,
    /// The rate limit is zero or negative.
    #[error("the maximum body rate must be above zero")]
    Rate,
    /// The lowest thrust is not above zero.
    #[error("the minimum thrust must be above zero: fixed-pitch rotors cannot pull down")]
    ThrustNotPositive,
    /// The lowest thrust is not below the highest.
    #[error("the minimum thrust must be below the maximum thrust: check their order")]
    ThrustOrder,
    /// The lowest thrust is gravity or more: the vehicle can only climb.
    #[error("the minimum thrust is not below gravity, so the vehicle cannot hover or sink: lower it")]
    CannotSink,
    /// The highest thrust is gravity or less: the vehicle can only fall.
    #[error("the maximum thrust is not above gravity, so the vehicle cannot hover: raise it")]
    CannotLift,
}

impl Limits<f64> {
    /// Table I of the paper: the ETH Flying Machine Arena vehicle, 1..20 m/s², 10 rad/s.
    pub const TABLE_I: Self = Self {
        thrust_min_mps2: 1.0,
        thrust_max_mps2: 20.0,
        rate_max_radps: 10.0,
        gravity_mps2: GRAVITY_MPS2,
    };
}

impl<T: Real> Limits<T> {
    /// Checks that the limits are finite and ordered and that the vehicle can hover, climb and sink.
    ///
    /// # Errors
    /// The first [`LimitsError`] that applies, in the order of the enum.
    pub fn validate(&self) -> Result<(), LimitsError> {
        let zero = T::zero();
        let all = [self.thrust_min_mps2, self.thrust_max_mps2, self.rate_max_radps, self.gravity_mps2];
        if !all.iter().all(|v| v.is_finite()) {
            return Err(LimitsError::NotFinite);
        }
        if self.gravity_mps2 <= zero {
            return Err(LimitsError::Gravity);
        }
        if self.rate_max_radps <= zero {
            return Err(LimitsError::Rate);
        }
        if self.thrust_min_mps2 <= zero {
            return Err(LimitsError::ThrustNotPositive);
        }
        if self.thrust_min_mps2 >= self.thrust_max_mps2 {
            return Err(LimitsError::ThrustOrder);
        }
        if self.thrust_min_mps2 >= self.gravity_mps2 {
            return Err(LimitsError::CannotSink);
        }
        if self.thrust_max_mps2 <= self.gravity_mps2 {
            return Err(LimitsError::CannotLift);
        }
        Ok(())
    }

    /// The same limits in another precision.
    pub fn cast<U: Real>(&self) -> Limits<U> {
        Limits {
            thrust_min_mps2: U::from_f64(self.thrust_min_mps2.to_f64()),
            thrust_max_mps2: U::from_f64(self.thrust_max_mps2.to_f64()),
            rate_max_radps: U::from_f64(self.rate_max_radps.to_f64()),
            gravity_mps2: U::from_f64(self.gravity_mps2.to_f64()),
        }
    }

    /// Thrust per mass of a level, m/s².
    pub fn thrust(&self, level: ThrustLevel) -> T {
        match level {
            ThrustLevel::Min => self.thrust_min_mps2,
            ThrustLevel::Max => self.thrust_max_mps2,
        }
    }

    /// The two dimensionless thrust limits U_T of eq. (5): thrust over gravity.
    pub fn dimensionless(&self) -> ThrustRange<T> {
        ThrustRange {
            min: self.thrust_min_mps2 / self.gravity_mps2,
            max: self.thrust_max_mps2 / self.gravity_mps2,
        }
    }

    /// The transformation of eq. (3) that belongs to these limits.
    pub fn scale(&self) -> Scale<T> {
        let time_s = T::one() / self.rate_max_radps;
        Scale {
            time_s,
            velocity_mps: self.gravity_mps2 * time_s,
            length_m: self.gravity_mps2 * time_s * time_s,
        }
    }
}

/// Planar state (x, ẋ, z, ż, θ): SI units (m, m/s, m, m/s, rad), or dimensionless by eq. (3) inside the solver.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct State<T> {
    /// Horizontal position.
    pub x: T,
    /// Horizontal velocity.
    pub vx: T,
    /// Vertical position, up.
    pub z: T,
    /// Vertical velocity, up.
    pub vz: T,
    /// Pitch angle, unwrapped, positive towards +x.
    pub theta: T,
}

impl<T: Real> State<T> {
    /// At rest, level, at the origin.
    pub fn origin() -> Self {
        Self::from_array([T::zero(); 5])
    }

    /// At rest and level at a position.
    pub fn at_rest(x: T, z: T) -> Self {
        Self { x, z, ..Self::origin() }
    }

    /// From the order (x, ẋ, z, ż, θ).
    pub fn from_array([x, vx, z, vz, theta]: [T; 5]) -> Self {
        Self { x, vx, z, vz, theta }
    }

    /// In the order (x, ẋ, z, ż, θ).
    pub fn to_array(self) -> [T; 5] {
        [self.x, self.vx, self.z, self.vz, self.theta]
    }

    /// All five finite.
    pub fn is_finite(&self) -> bool {
        self.to_array().iter().all(|v| v.is_finite())
    }

    /// The same state in another precision.
    pub fn cast<U: Real>(self) -> State<U> {
        State::from_array(self.to_array().map(|v| U::from_f64(v.to_f64())))
    }

    /// Component-wise difference.
    pub fn minus(self, other: Self) -> Self {
        Self {
            x: self.x - other.x,
            vx: self.vx - other.vx,
            z: self.z - other.z,
            vz: self.vz - other.vz,
            theta: self.theta - other.theta,
        }
    }
}

/// The dimensionless thrust range of eq. (5), in units of gravity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ThrustRange<T> {
    /// Lower limit.
    pub min: T,
    /// Upper limit.
    pub max: T,
}

impl<T: Real> ThrustRange<T> {
    /// The value of a level.
    pub fn thrust(&self, level: ThrustLevel) -> T {
        match level {
            ThrustLevel::Min => self.min,
            ThrustLevel::Max => self.max,
        }
    }
}

/// Units of eq. (3): what one dimensionless unit is in SI.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scale<T> {
    /// One unit of time, s: 1/ω_max.
    pub time_s: T,
    /// One unit of velocity, m/s: g/ω_max.
    pub velocity_mps: T,
    /// One unit of length, m: g/ω_max².
    pub length_m: T,
}

impl<T: Real> Scale<T> {
    /// SI to dimensionless.
    pub fn to_dimensionless(&self, s: State<T>) -> State<T> {
        State {
            x: s.x / self.length_m,
            vx: s.vx / self.velocity_mps,
            z: s.z / self.length_m,
            vz: s.vz / self.velocity_mps,
            theta: s.theta,
        }
    }

    /// Dimensionless to SI.
    pub fn to_si(&self, s: State<T>) -> State<T> {
        State {
            x: s.x * self.length_m,
            vx: s.vx * self.velocity_mps,
            z: s.z * self.length_m,
            vz: s.vz * self.velocity_mps,
            theta: s.theta,
        }
    }
}

/// What the pitch rate does during one segment, eq. (16).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum RateMode {
    /// u_R = +1: at the positive limit.
    Plus,
    /// u_R = −1: at the negative limit.
    Minus,
    /// u_R = u_R,sing(t): on a singular arc, eq. (15).
    Singular,
}

impl RateMode {
    /// +1, −1, or `None` on a singular arc.
    pub fn sign<T: Real>(self) -> Option<T> {
        match self {
            Self::Plus => Some(T::one()),
            Self::Minus => Some(-T::one()),
            Self::Singular => None,
        }
    }
}

/// Which limit the thrust is at, eq. (20).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum ThrustLevel {
    /// The lower limit.
    Min,
    /// The upper limit.
    Max,
}

/// Both inputs during one segment.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub struct Inputs {
    /// Pitch rate.
    pub rate: RateMode,
    /// Thrust.
    pub thrust: ThrustLevel,
}

/// Inputs held for a duration: s in a table, 1/ω_max in the solver.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Segment<T> {
    /// The inputs.
    pub inputs: Inputs,
    /// How long. Above zero.
    pub duration: T,
}

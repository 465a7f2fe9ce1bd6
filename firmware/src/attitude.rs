//! Which way is up: a six-axis estimate from gyro and accelerometer.
//!
//! A quaternion is turned by the gyro at every sample. The exponential of the turn is a series: at 800 Hz no turn is
//! large. Gravity corrects the two angles that it can see, and only where the accelerometer measures gravity:
//!
//! - at rest with the motors off, strongly: nothing else acts;
//! - in quasi-steady flight, weakly. In flight an accelerometer measures thrust and drag, not gravity: its reading lies
//!   along the body's own z axis *whatever the tilt*, so a filter that believes it holds every lean for level. On the
//!   average over a hover thrust does point up, and only this average is used;
//! - in a maneuver, or while the reading differs from g or the vehicle turns, not at all.
//!
//! The heading is that of the start plus what the gyro has seen of it: nothing here depends on it.
//!
//! Cost of an update: some 130 multiplications and additions, one square root and one division where gravity is used;
//! no trigonometry. At one to three cycles each and 168 MHz below 3 µs.

use mintime_shared::model::GRAVITY_MPS2;
use mintime_shared::real::{at_least, at_most, sqrt};

use crate::config::control::{
    ATTITUDE_RATE_MAX_RADPS, ATTITUDE_STEP_MAX_S, DESCENT_THRUST, DESCENT_TILT_COS,
    GRAVITY_GAIN_FLYING_PER_S, GRAVITY_GAIN_RESTING_PER_S, GRAVITY_WINDOW_FLYING_MPS2,
    GRAVITY_WINDOW_RESTING_MPS2, INVERTED_THRUST_MPS2, LEVEL_GAIN_PER_S, LEVEL_RATE_MAX_RADPS,
    RESTING_RATE_RADPS, STEADY_RATE_RADPS,
};

/// What the vehicle is doing, as far as gravity is concerned.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Motion {
    /// Motors off: it rests, or somebody carries it.
    MotorsOff,
    /// It flies by setpoints: hover, climb, catch.
    Flying,
    /// It flies a maneuver, or recovers from one.
    Maneuver,
}

/// A rotation from the body to a level frame, as a unit quaternion (w, x, y, z).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rotation([f32; 4]);

impl Rotation {
    /// None.
    pub const IDENTITY: Self = Self([1.0, 0.0, 0.0, 0.0]);

    /// As (w, x, y, z).
    pub fn wxyz(&self) -> [f32; 4] {
        self.0
    }

    /// Turned on by a rotation vector in the body frame, rad; finite and at most a radian or so long.
    #[must_use]
    pub fn turned(&self, [rx, ry, rz]: [f32; 3]) -> Self {
        let half_squared = 0.25 * (rx * rx + ry * ry + rz * rz);
        let c = 1.0 - half_squared * (0.5 - half_squared * (1.0 / 24.0));
        let s = 0.5 - half_squared * (1.0 / 12.0 - half_squared * (1.0 / 240.0));
        let (dx, dy, dz) = (s * rx, s * ry, s * rz);
        let [w, x, y, z] = self.0;
        Self::normalised([
            w * c - x * dx - y * dy - z * dz,
            w * dx + x * c + y * dz - z * dy,
            w * dy - x * dz + y * c + z * dx,
            w * dz + x * dy - y * dx + z * c,
        ])
    }

    /// One step of Newton's method from a norm near one: no root, no division.
    fn normalised(q: [f32; 4]) -> Self {
        let squared = q.iter().fold(0.0, |sum, c| sum + c * c);
        Self(q.map(|c| c * (1.5 - 0.5 * squared)))
    }

    /// The vertical, upwards, in the body frame.
    pub fn up_in_body(&self) -> [f32; 3] {
        let [w, x, y, z] = self.0;
        [2.0 * (x * z - w * y), 2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y)]
    }

    /// The shortest one for which `up`, a unit vector in the body frame, is the vertical.
    fn with_up([ux, uy, uz]: [f32; 3]) -> Self {
        if uz < -0.999 {
            // Upside down: about the forward axis, as good as any.
            return Self([0.0, 1.0, 0.0, 0.0]);
        }
        // From the body's `up` to z: the axis is up × z, and w the cosine of half the angle.
        let w = sqrt(0.5 * (1.0 + uz));
        let scale = 0.5 / w;
        Self::normalised([w, uy * scale, -ux * scale, 0.0])
    }

    /// As a rotation vector, rad, at most half a turn long.
    pub fn vector(&self) -> [f32; 3] {
        let [w, x, y, z] = self.0;
        let sign = if w < 0.0 { -1.0 } else { 1.0 };
        let sine = sqrt(x * x + y * y + z * z);
        // Near zero the angle is twice the sine.
        let scale = if sine > 1.0e-4 { 2.0 * libm::atan2f(sine, sign * w) / sine } else { 2.0 };
        [x, y, z].map(|c| c * sign * scale)
    }
}

/// The turn over a step from the rates at its two ends, as a rotation vector. A body whose axis of turn moves turns by
/// more than the mean of its rates: the cross product is the first term of that (coning).
pub fn turn_between(before: [f32; 3], after: [f32; 3], dt_s: f32) -> [f32; 3] {
    let [ax, ay, az] = before;
    let [bx, by, bz] = after;
    let (mean, coning) = (0.5 * dt_s, dt_s * dt_s * (1.0 / 12.0));
    [
        mean * (ax + bx) + coning * (ay * bz - az * by),
        mean * (ay + by) + coning * (az * bx - ax * bz),
        mean * (az + bz) + coning * (ax * by - ay * bx),
    ]
}

/// The estimate.
#[derive(Clone, Copy, Debug)]
pub struct AttitudeEstimate {
    rotation: Rotation,
    /// Rates at the end of the last step.
    rates_radps: [f32; 3],
    known: bool,
}

impl AttitudeEstimate {
    /// Nothing known: level is assumed.
    pub const fn new() -> Self {
        Self { rotation: Rotation::IDENTITY, rates_radps: [0.0; 3], known: false }
    }

    /// Takes one sample: body rates with bias and scale corrected, rad/s, and specific force, m/s², `dt_s` after the one
    /// before. A sample with a NaN or infinity, or a time that is none, changes nothing.
    pub fn update(&mut self, gyro_radps: [f32; 3], accel_mps2: [f32; 3], dt_s: f32, motion: Motion) {
        let sound = dt_s >= 0.0 && dt_s.is_finite() && gyro_radps.iter().all(|r| r.is_finite());
        if !sound {
            return;
        }
        let bound = ATTITUDE_RATE_MAX_RADPS;
        let rates = gyro_radps.map(|r| at_most(at_least(r, -bound), bound));
        let dt_s = at_most(dt_s, ATTITUDE_STEP_MAX_S);
        let mut turn = turn_between(self.rates_radps, rates, dt_s);
        self.rates_radps = rates;
        if let Some((measured, gain)) = gravity(accel_mps2, rates, motion) {
            let [vx, vy, vz] = self.rotation.up_in_body();
            let [ux, uy, uz] = measured;
            let resting = motion == Motion::MotorsOff;
            if resting && (!self.known || ux * vx + uy * vy + uz * vz < 0.0) {
                // At first sight, or put down the other way up: no use in turning there slowly.
                self.rotation = Rotation::with_up(measured);
                self.known = true;
                return;
            }
            // Turning about measured × believed brings the believed vertical to the measured one.
            let share = at_most(gain * dt_s, 1.0);
            let pull = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
            for (turn, pull) in turn.iter_mut().zip(pull) {
                *turn += share * pull;
            }
        }
        self.rotation = self.rotation.turned(turn);
    }

    /// Whether the vehicle has been seen at rest: before, the attitude is a guess.
    pub fn is_known(&self) -> bool {
        self.known
    }

    /// From the body to the level frame.
    pub fn rotation(&self) -> Rotation {
        self.rotation
    }

    /// The vertical, upwards, in the body frame: a unit vector.
    pub fn up_in_body(&self) -> [f32; 3] {
        self.rotation.up_in_body()
    }

    /// Angle between the thrust axis and the vertical, rad, 0 to π.
    pub fn tilt_rad(&self) -> f32 {
        let [x, y, z] = self.up_in_body();
        libm::atan2f(sqrt(x * x + y * y), z)
    }

    /// Body rates that turn the vehicle upright, rad/s; its heading is left alone.
    pub fn level_rates(&self) -> [f32; 3] {
        level_rates(self.up_in_body())
    }

    /// Collective thrust per mass for a gentle descent while the vehicle is turned upright, m/s².
    pub fn descent_thrust_mps2(&self) -> f32 {
        let [_, _, z] = self.up_in_body();
        descent_thrust_mps2(z)
    }
}

impl Default for AttitudeEstimate {
    fn default() -> Self {
        Self::new()
    }
}

/// The direction of gravity in a specific force and how fast to believe it, 1/s; `None` where it is none.
fn gravity(accel_mps2: [f32; 3], rates_radps: [f32; 3], motion: Motion) -> Option<([f32; 3], f32)> {
    let (gain, window_mps2, rate_radps) = match motion {
        Motion::MotorsOff => (GRAVITY_GAIN_RESTING_PER_S, GRAVITY_WINDOW_RESTING_MPS2, RESTING_RATE_RADPS),
        Motion::Flying => (GRAVITY_GAIN_FLYING_PER_S, GRAVITY_WINDOW_FLYING_MPS2, STEADY_RATE_RADPS),
        Motion::Maneuver => return None,
    };
    let calm = rates_radps.iter().all(|r| r.abs() <= rate_radps);
    let length = sqrt(accel_mps2.iter().fold(0.0, |sum, a| sum + a * a));
    // False for NaN.
    let plausible = (length - GRAVITY_MPS2 as f32).abs() <= window_mps2;
    (calm && plausible).then(|| (accel_mps2.map(|a| a / length), gain))
}

/// Body rates that turn the vehicle upright along the shortest way, rad/s, given the vertical in the body frame (a unit
/// vector). Upside down to within a degree every way is as short: it rolls to the right.
///
/// The rate is [`LEVEL_GAIN_PER_S`] times the chord 2 sin(tilt/2), which is the tilt near level and grows all the way to
/// upside down, up to [`LEVEL_RATE_MAX_RADPS`].
pub fn level_rates([ux, uy, uz]: [f32; 3]) -> [f32; 3] {
    // The axis z × up, as long as the sine of the tilt: about it the body turns its z axis towards the vertical.
    let (ax, ay) = (-uy, ux);
    let sine = sqrt(ax * ax + ay * ay);
    if uz < 0.0 && sine < 0.02 {
        return [LEVEL_RATE_MAX_RADPS, 0.0, 0.0];
    }
    // Over the sine; below the horizon the chord has the form that does not divide by zero at the other end.
    let chord = if uz > 0.0 { sqrt(2.0 / (1.0 + uz)) } else { sqrt(2.0 * (1.0 - uz)) / at_least(sine, 0.02) };
    let wanted = LEVEL_GAIN_PER_S * chord;
    let scale = if wanted * sine > LEVEL_RATE_MAX_RADPS { LEVEL_RATE_MAX_RADPS / sine } else { wanted };
    let rate = |axis: f32| at_most(at_least(axis * scale, -LEVEL_RATE_MAX_RADPS), LEVEL_RATE_MAX_RADPS);
    [rate(ax), rate(ay), 0.0]
}

/// Collective thrust per mass for a gentle descent, m/s², given the cosine of the tilt: [`DESCENT_THRUST`] of gravity
/// upwards while the tilt is below 60°, then less and less as thrust points sideways, and next to nothing upside down.
pub fn descent_thrust_mps2(tilt_cos: f32) -> f32 {
    let level = DESCENT_THRUST * GRAVITY_MPS2 as f32;
    if tilt_cos >= DESCENT_TILT_COS {
        return level / tilt_cos;
    }
    let part = at_most(at_least(tilt_cos / DESCENT_TILT_COS, 0.0), 1.0);
    INVERTED_THRUST_MPS2 + (level / DESCENT_TILT_COS - INVERTED_THRUST_MPS2) * part
}

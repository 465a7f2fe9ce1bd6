//! Numbers of the rate loop, the attitude estimate and the gyro's calibration, with unit and reason.

use mintime_shared::model::GRAVITY_MPS2;

/// Longest step that the attitude estimate integrates, s: longer than the supervisor lets the gyro stay away with the
/// motors on. The series of the exponential are exact to 1e-4 even there.
pub const ATTITUDE_STEP_MAX_S: f32 = 0.020;
/// Largest rate that the attitude estimate believes, rad/s: no gyro of 2000 degrees/s says more on an axis.
pub const ATTITUDE_RATE_MAX_RADPS: f32 = 40.0;
/// How fast gravity pulls the attitude estimate while the vehicle rests with its motors off, 1/s: a quarter of a second
/// averages two hundred samples, far below the accelerometer's own bias (0.02 g: 20 mrad).
pub const GRAVITY_GAIN_RESTING_PER_S: f32 = 4.0;
/// The same in quasi-steady flight, 1/s. A gyro bias wrong by 1 mrad/s then costs 50 mrad at the end and no more; and a
/// lean of 0.3 rad for 3 s, during which the accelerometer says "level", costs 18 mrad.
pub const GRAVITY_GAIN_FLYING_PER_S: f32 = 0.02;
/// Specific force within this of gravity may be gravity while the vehicle rests, m/s²: bias and scale of the sensor.
pub const GRAVITY_WINDOW_RESTING_MPS2: f32 = 0.8;
/// The same in flight, m/s²: level thrust g/cos(tilt) leaves it at 0.31 rad.
pub const GRAVITY_WINDOW_FLYING_MPS2: f32 = 0.5;
/// Rates above this are no rest, rad/s: a bias not yet known stays below it.
pub const RESTING_RATE_RADPS: f32 = 0.15;
/// Rates above this are no quasi-steady flight, rad/s.
pub const STEADY_RATE_RADPS: f32 = 0.5;

/// Gain with which a vehicle is turned upright, 1/s: a quarter of the rate loop's own.
pub const LEVEL_GAIN_PER_S: f32 = 10.0;
/// Largest rate at which a vehicle is turned upright, rad/s: half a turn in 0.4 s, and 200 rad/s² stop it within 0.16 rad.
pub const LEVEL_RATE_MAX_RADPS: f32 = 8.0;
/// Vertical part of the thrust while sinking, over gravity: as [`super::RECOVERY_FORCE`].
pub const DESCENT_THRUST: f32 = 0.95;
/// Cosine of the tilt up to which thrust makes up for the tilt: 60°, where it is twice as much as level.
pub const DESCENT_TILT_COS: f32 = 0.5;
/// Thrust per mass with the rotors below the horizon, m/s²: it drives the vehicle down, so only what keeps the rotors
/// awake. Attitude takes what it needs from the mixer whatever the thrust.
pub const INVERTED_THRUST_MPS2: f32 = 0.1 * GRAVITY_MPS2 as f32;

/// Whole turns that a scale calibration may take. More turns divide the error of putting the vehicle back; but the end
/// must be told from a pause a quarter turn earlier, at any plausible scale.
pub const SCALE_TURNS_MAX: u8 = 4;
/// Largest plausible relative scale error. The sensor's data sheet bounds it at 2 %.
pub const SCALE_ERROR_MAX: f32 = 0.05;
/// Longest time from the first motion to rest, s: bias that drifts by 0.1 mrad/s meanwhile costs 1.5 mrad.
pub const SCALE_TURNING_MAX_S: f32 = 30.0;
/// Longest gap between two samples of a turn, s: the mean of the rates at its ends stands for those in between, which of a
/// hand whose rate swings by 1 rad/s five times a second is off by 0.1 mrad.
pub const SCALE_GAP_MAX_S: f32 = 0.010;
/// Longest wait for a vehicle at rest before it is turned, and for the turn to begin, s.
pub const SCALE_WAITING_MAX_S: f32 = 20.0;
/// Angle that is motion, rad; in the wrong sense it is the wrong direction.
pub const SCALE_MOTION_RAD: f32 = 0.5;
/// Turn about another axis that must not be left at the end, rad: the vehicle was not put back as it stood, or turned
/// about an axis of its own. 0.1 rad across costs half its square over a turn: 0.08 % of one turn, 0.02 % of four.
pub const SCALE_WOBBLE_RAD: f32 = 0.1;
/// Change of bias from before to after that is believed, rad/s: half of it times half the time is what it costs.
pub const SCALE_BIAS_DRIFT_RADPS: f32 = 2.0e-3;

/// Cutoff of the gyro's low-pass filter in the proportional path, Hz: above what the rotors can follow (16 Hz), below
/// their imbalance at hover (some 170 Hz). It delays by 1.3 ms, a tenth of the rotors' response.
pub const RATE_FILTER_HZ: f64 = 150.0;
/// Part of the reference model's acceleration that is asked for at once. All of it would follow the plan's angle closer
/// (by a tenth), yet end further from its goal: thrust is as late as the rotors are, and a rate that is less late than
/// thrust points it the wrong way meanwhile.
pub const FEED_FORWARD: f32 = 0.05;
/// How fast the trim is learned from the angle error, 1/s³: the angle error falls with 2 s.
pub const TRIM_GAIN_PER_S3: f32 = 200.0;
/// Largest trim, rad/s² per m/s² of thrust: a centre of mass off by 5 mm, or rotors that differ by 15 %.
pub const TRIM_BOUND: f32 = 2.0;
/// The trim is learned while no rate above this is asked for, rad/s: elsewhere the angle error is that of the turn.
pub const TRIM_CALM_RADPS: f32 = 0.5;
/// And with no less thrust than this, m/s²: a vehicle that lands or has not lifted learns nothing.
pub const TRIM_THRUST_MIN_MPS2: f32 = 7.0;

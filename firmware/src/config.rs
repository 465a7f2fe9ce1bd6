//! Every number that describes the vehicle or sets a limit of the flight logic, with its unit and its reason.

pub mod control;

use mintime_shared::messages::{BoardTelemetry, REQUEST_AGE_MS};
pub use mintime_shared::vehicle::{MOTOR_COUNT, VehicleConfig};

/// What the board can do. What it cannot do blocks arming.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Capabilities {
    /// A gyro was found and configured.
    pub gyro: bool,
    /// Motor outputs exist.
    pub motors: bool,
}

/// What a board says of itself, [`crate::vehicle::Vehicle::set_board_status`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BoardStatus {
    /// What it can do by now.
    pub capabilities: Capabilities,
    /// A driver has not finished its set-up: what is missing among the capabilities may still come, so arming waits.
    pub starting: bool,
    /// How it does, for telemetry.
    pub telemetry: BoardTelemetry,
    /// How its store does.
    pub store: StoreStatus,
}

/// How a board's store in flash does.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct StoreStatus {
    /// There is one; without, what the vehicle is told lives until it is switched off.
    pub present: bool,
    /// It is at work: flash stalls, ticks will be missed.
    pub busy: bool,
    /// Ticket of the last job it finished, [`crate::keeping::Job::ticket`]; 0 before the first.
    pub finished: u32,
    /// Whether that job failed.
    pub failed: bool,
}

/// Firmware version: major, minor, patch.
pub const FIRMWARE_VERSION: [u8; 3] = [
    decimal(env!("CARGO_PKG_VERSION_MAJOR")),
    decimal(env!("CARGO_PKG_VERSION_MINOR")),
    decimal(env!("CARGO_PKG_VERSION_PATCH")),
];

/// Parses a version number at compile time.
#[expect(clippy::indexing_slicing, reason = "evaluated by the compiler only")]
const fn decimal(text: &str) -> u8 {
    let bytes = text.as_bytes();
    let mut value = 0;
    let mut i = 0;
    while i < bytes.len() {
        value = value * 10 + (bytes[i] - b'0');
        i += 1;
    }
    value
}

/// A setpoint is fresh for this long, µs. Hosts stream at 100 Hz or more; this bridges nine lost ones.
pub const SETPOINT_FRESH_US: u64 = 100_000;
/// Specific force in a recovery, as a part of gravity: sinks at 1 m/s after a second, 2 m/s after two.
pub const RECOVERY_FORCE: f32 = 0.9;
/// How fast the thrust of a recovery is adjusted to the specific force measured, 1/s: ten times slower than the rotors.
pub const RECOVERY_GAIN_PER_S: f32 = 3.0;
/// Range of that adjustment: a thrust map may be a fifth off, and on the ground the thrust must go down visibly.
pub const RECOVERY_RANGE: (f32, f32) = (0.5, 1.2);
/// Least part of the thrust to sink with that a recovery begins with: too little to lift what stands on the ground, even
/// with a thrust map a fifth off, and near enough not to fall.
pub const RECOVERY_START: f32 = 0.8;
/// A vehicle that was never asked for this part of its weight since arming stands where it was armed: even a thrust map a
/// fifth off does not make it fly.
pub const LIFTED_FORCE: f32 = 0.75;
/// So long a recovery takes its thrust as it is, s: rotors that came from full thrust have settled.
pub const RECOVERY_SETTLES_S: f32 = 0.15;
/// A recovering vehicle that keeps its specific force with this part of the thrust stands on something: less than a thrust
/// map a fifth off explains, ...
pub const RECOVERY_STANDS: f32 = 0.75;
/// ... if it does so for this long, s.
pub const RECOVERY_STANDS_S: f32 = 0.2;
/// Cosine of the tilt beyond which a recovery turns the vehicle upright first, 60 degrees.
pub const RECOVERY_UPRIGHT_COS: f32 = 0.5;
/// Thrust while it does, m/s²: enough for torque, too little to push it far.
pub const RECOVERY_LOW_THRUST_MPS2: f32 = 3.0;
/// The start gate on board: largest angle between the thrust axis and that of the table's start, rad. The host's gate is finer;
/// this one keeps out a vehicle that is not where anybody thinks.
pub const GATE_TILT_RAD: f32 = 0.12;
/// Its cosine.
pub const GATE_TILT_COS: f32 = 0.992_808_6;
/// Likewise, largest body rate, rad/s.
pub const GATE_RATE_RADPS: f32 = 0.6;
/// Cosine of the largest tilt at which the motors may be started (15 degrees): level ground, with the accelerometer's own
/// error.
pub const ARMING_TILT_COS: f32 = 0.966;
/// Battery below its critical voltage for this many ticks (0.2 s) is no dip.
pub const BATTERY_SAG_TICKS: u32 = 160;
/// Rotors at their limit for this many ticks in a row (150 ms) in a maneuver: longer than any reversal.
pub const SATURATED_TICKS: u32 = 120;
/// Rotors that give less than this part of the thrust asked for are at their limit.
pub const SATURATED_LIFT: f32 = 0.95;
/// Samples lost in one maneuver that end it.
pub const LOST_SAMPLES_ABORT: u32 = 24;
/// Armed and idle for longer than this disarms, µs.
pub const ARMED_IDLE_US: u64 = 30_000_000;
/// A setpoint above this thrust per mass takes off from the armed state, m/s².
pub const LIFT_THRUST_MPS2: f32 = 1.0;

/// Samples may be missing for this many ticks (10 ms) before the motors stop.
pub const GYRO_MISSING_TICKS: u32 = 8;
/// The very same sample for this many ticks (30 ms) while another rate is asked for: frozen.
pub const GYRO_FROZEN_TICKS: u32 = 24;
/// What counts as another rate, rad/s: a few times the gyro's noise.
pub const GYRO_FROZEN_DEMAND_RADPS: f32 = 0.02;
/// Rates above this are at the end of the gyro's range, rad/s (2000 degrees/s are 34.9).
pub const GYRO_SATURATION_RADPS: f32 = 34.5;
/// This many saturated samples in a row stop the motors.
pub const GYRO_SATURATED_TICKS: u32 = 4;
/// Ticks over which the bias is averaged, 0.5 s.
pub const CALIBRATION_TICKS: u32 = 400;
/// Largest spread of the rates for which the vehicle counts as still, rad/s: ten times the gyro's noise.
pub const STILL_SPREAD_RADPS: f32 = 0.06;
/// Largest credible bias, rad/s (the sensor's data sheet bounds it at 0.5 degrees/s; aged ones show more).
pub const BIAS_MAX_RADPS: f32 = 0.1;

/// Rate error that counts as not following, rad/s, ...
pub const RUNAWAY_ERROR_RADPS: f32 = 8.0;
/// ... when it lasts this many ticks (100 ms). A full reversal between bangs takes about half of that.
pub const RUNAWAY_TICKS: u32 = 80;
/// Angle error in the maneuver's plane, expected less flown, at which a maneuver is given up, rad. A reversal at full rate on a healthy vehicle
/// stays below 0.4. Below [`INTEGRAL_BOUND_RAD`], or it could never be reached.
pub const ENVELOPE_PITCH_RAD: f32 = 0.8;
/// Angle error out of the maneuver's plane, or in yaw, at which a maneuver is given up, rad.
pub const ENVELOPE_LATERAL_RAD: f32 = 0.6;
/// A tick later than this many periods is late.
pub const LATE_PERIODS: f32 = 1.5;
/// The same, µs.
pub const LATE_US: u64 = (LATE_PERIODS * mintime_shared::replay::TICK_PERIOD_US as f32) as u64;
/// An interval between ticks that ends a maneuver, µs: eight ticks blind.
pub const LATE_ABORT_US: u64 = 10_000;
/// Late ticks in one maneuver that end it.
pub const LATE_ABORT_COUNT: u32 = 40;

/// Proportional gain of the rate loop, 1/s, per axis. With rotors that respond within [`ROTOR_RESPONSE_S`] the loop is
/// well damped up to 1/(2 · response).
pub const RATE_GAIN_PER_S: [f32; 3] = [32.0, 32.0, 12.0];
/// How a healthy vehicle follows a step of the rate setpoint at best, s: about the rotors' own response. Longer turns
/// every lag into a smaller angle, shorter into an overshoot at the end of each turn.
pub const RATE_RESPONSE_S: f32 = 0.009;
/// Integral gain, 1/s²: the accumulated rate error is the angle by which the vehicle departs from its plan.
pub const RATE_INTEGRAL_PER_S2: [f32; 3] = [400.0, 400.0, 40.0];
/// Bound of the accumulated angle error, rad: what the integrator may ask for. Beyond every envelope, or a vehicle that
/// left its plan would never be seen to.
pub const INTEGRAL_BOUND_RAD: f32 = 1.0;
const _: () = assert!(INTEGRAL_BOUND_RAD > ENVELOPE_PITCH_RAD && INTEGRAL_BOUND_RAD > ENVELOPE_LATERAL_RAD);
/// Response time that rotor lag is compensated to, s. Shorter amplifies noise by lag/response.
pub const ROTOR_RESPONSE_S: f32 = 0.010;
/// Part of the rotors' range kept for yaw when roll and pitch ask for all of it.
pub const YAW_RESERVE: f32 = 0.05;
/// Longest time step the controllers believe, s: two periods; longer gaps are handled by the supervisor.
pub const CONTROL_STEP_MAX_S: f32 = 2.5e-3;

/// A request that comes again under its number within this time is a repetition, µs: longer than the longest maneuver and
/// its answer's retries, shorter than a host at 800 messages a second takes to use up all 65536 numbers.
pub const REPEATED_US: u64 = 15_000_000;

/// Shortest and longest interval of telemetry that a host may ask for, ms. What a host heard last tells how old its requests are:
/// two that are lost must not make them late.
pub const TELEMETRY_RANGE_MS: (u16, u16) = (5, 100);
const _: () = assert!(TELEMETRY_RANGE_MS.1 as u32 * 3 <= REQUEST_AGE_MS);
/// Requests that one tick takes.
pub const INBOX: usize = 4;
/// Incidents that wait to be acknowledged: five may come up with a start (two crashes, a termination, damage to the store, no
/// random numbers), and one in its run.
pub const INCIDENTS: usize = 6;
/// Messages waiting for the link. One tick adds at most [`INBOX`] answers and a telemetry.
pub const OUTBOX: usize = 8;

//! Every number that describes the vehicle or sets a limit of the flight logic, with its unit and its reason.

pub mod control;

use mintime_shared::crc32;
use mintime_shared::frames::MOTORS;
use mintime_shared::messages::{BoardTelemetry, TELEMETRY_PERIOD_US};
use mintime_shared::model::GRAVITY_MPS2;
use mintime_shared::table::PlanLimits;

/// The vehicle as its flight controller knows it. Its [`hash`](VehicleConfig::hash) names it on the link.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct VehicleConfig {
    /// Mass with battery, kg.
    pub mass_kg: f32,
    /// Moments of inertia about forward, left, up, kg m².
    pub inertia_kgm2: [f32; 3],
    /// Rotors ahead of and behind the centre of mass by this, m.
    pub arm_forward_m: f32,
    /// Rotors left and right of the centre of mass by this, m.
    pub arm_left_m: f32,
    /// Reaction torque over thrust of a rotor, m.
    pub torque_per_thrust_m: f32,
    /// Thrust of one rotor at full throttle and nominal voltage, N.
    pub rotor_thrust_max_n: f32,
    /// Thrust of one rotor at idle, N: rotors never stop in flight.
    pub rotor_thrust_idle_n: f32,
    /// Time constant with which a rotor's speed follows its throttle, s.
    pub rotor_lag_s: f32,
    /// Battery voltage at which the thrust above was measured, V.
    pub battery_nominal_v: f32,
    /// Voltage below which arming and maneuvers are refused, V.
    pub battery_low_v: f32,
    /// Highest collective thrust per mass that a table may plan with, m/s². Below what the rotors give, so that torque
    /// is left for attitude at full planned thrust.
    pub plan_thrust_max_mps2: f32,
    /// Highest body rate that a table may plan with, rad/s. The gyro measures up to 34.9.
    pub plan_rate_max_radps: f32,
    /// Share of the thrust that grows with the throttle itself, the rest with its square, 0 to 1: 0 for controllers of
    /// speed, more for those of voltage. See [`crate::mixer::throttle_of_speed`].
    pub thrust_linear_share: f32,
    /// By how much the battery's voltage falls for each newton of collective thrust, V/N: for the time between two
    /// measurements of it. 0 believes the last one.
    pub sag_v_per_n: f32,
    /// To which output line the motor at each place of the frame is wired: places as in [`MOTORS`], lines from 0.
    pub outputs: [u8; MOTOR_COUNT],
    /// Propellers turn the other way round than [`MOTORS`] says ("props out").
    pub reversed: bool,
}

impl VehicleConfig {
    /// The reference vehicle: the published parameters of the Agilicious quadrotor (Foehn et al., Science Robotics
    /// 2022, doi 10.1126/scirobotics.abl6259), a 5-inch frame of the class that the reference flight controller is
    /// made for, on a 4S battery.
    pub const REFERENCE: Self = Self {
        mass_kg: 0.752,
        inertia_kgm2: [2.5e-3, 2.1e-3, 4.3e-3],
        arm_forward_m: 0.075,
        arm_left_m: 0.10,
        torque_per_thrust_m: 0.022,
        rotor_thrust_max_n: 8.5,
        rotor_thrust_idle_n: 0.035,
        rotor_lag_s: 0.033,
        battery_nominal_v: 14.8,
        battery_low_v: 14.0,
        plan_thrust_max_mps2: 30.0,
        plan_rate_max_radps: 15.0,
        thrust_linear_share: 0.0,
        sag_v_per_n: 0.0,
        outputs: [0, 1, 2, 3],
        reversed: false,
    };

    /// Whether a measured battery voltage can be one: beyond, the sense wire is off. False for NaN.
    pub fn is_plausible_battery(&self, volts: f32) -> bool {
        volts > 0.6 * self.battery_nominal_v && volts < 1.4 * self.battery_nominal_v
    }

    /// Whether every output line drives one motor, and the thrust map has an inverse. False for NaN.
    pub fn is_sound(&self) -> bool {
        let used = self
            .outputs
            .iter()
            .fold(0_u32, |lines, line| lines | 1_u32.checked_shl(u32::from(*line)).unwrap_or(0));
        used == (1 << MOTOR_COUNT) - 1
            && (0.0..=1.0).contains(&self.thrust_linear_share)
            && (0.0..=1.0).contains(&self.sag_v_per_n)
    }

    /// What a table may plan with, [`mintime_shared::table::PlanLimits`].
    pub fn plan_limits(&self) -> PlanLimits {
        PlanLimits {
            thrust_min_mps2: self.rotor_thrust_idle_n * MOTOR_COUNT as f32 / self.mass_kg,
            thrust_max_mps2: self.plan_thrust_max_mps2,
            rate_max_radps: self.plan_rate_max_radps,
            gravity_mps2: GRAVITY_MPS2 as f32,
        }
    }

    /// Identifies this configuration: CRC-32 over all fields in order. Never zero, which means "any vehicle".
    pub fn hash(&self) -> u32 {
        let [jx, jy, jz] = self.inertia_kgm2;
        let fields = [
            self.mass_kg,
            jx,
            jy,
            jz,
            self.arm_forward_m,
            self.arm_left_m,
            self.torque_per_thrust_m,
            self.rotor_thrust_max_n,
            self.rotor_thrust_idle_n,
            self.rotor_lag_s,
            self.battery_nominal_v,
            self.battery_low_v,
            self.plan_thrust_max_mps2,
            self.plan_rate_max_radps,
            self.thrust_linear_share,
            self.sag_v_per_n,
            f32::from(u8::from(self.reversed)),
            // Its bytes only: no arithmetic touches it.
            f32::from_bits(u32::from_le_bytes(self.outputs)),
        ];
        let mut bytes = [0; 18 * 4];
        for (slot, field) in bytes.chunks_exact_mut(4).zip(fields) {
            slot.copy_from_slice(&field.to_le_bytes());
        }
        crc32(&bytes).max(1)
    }
}

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
}

/// Rotors on this vehicle.
pub const MOTOR_COUNT: usize = MOTORS.len();
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
/// Motors stop when no setpoint came for this long, µs: what a person takes to see a falling vehicle and step back.
pub const LINK_DEAD_US: u64 = 1_500_000;
/// Collective thrust while the link is lost, as a part of gravity: sinks gently.
pub const LINK_LOST_THRUST: f32 = 0.95;
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

/// A trigger that comes again under its number within this time is a repetition, µs: longer than the longest maneuver and
/// its answer's retries, shorter than a host at 800 messages a second takes to use up all 65536 numbers.
pub const REPEATED_TRIGGER_US: u64 = 15_000_000;

/// Interval of telemetry, µs.
pub const TELEMETRY_US: u64 = TELEMETRY_PERIOD_US;
/// Requests that one tick takes.
pub const INBOX: usize = 4;
/// Messages waiting for the link. One tick adds at most [`INBOX`] answers and a telemetry.
pub const OUTBOX: usize = 8;

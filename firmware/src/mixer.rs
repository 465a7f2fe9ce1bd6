//! From collective thrust and angular acceleration to throttles.
//!
//! Where the rotors cannot give everything, attitude wins over thrust: roll and pitch torque first, then collective
//! thrust as near as the remaining range allows, then yaw in what is left. A vehicle that keeps its attitude at too
//! little thrust sinks; one that loses its attitude falls.

use mintime_shared::frames::MOTORS;
use mintime_shared::model::GRAVITY_MPS2;
use mintime_shared::real::{at_least, at_most, sqrt};

use crate::config::{MOTOR_COUNT, ROTOR_RESPONSE_S, SATURATED_LIFT, VehicleConfig, YAW_RESERVE};

/// What the rate controller asks of the airframe.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Demand {
    /// Collective thrust per mass, m/s².
    pub thrust_mps2: f32,
    /// Angular acceleration about forward, left, up, rad/s².
    pub acceleration_radps2: [f32; 3],
}

/// What the mixer makes of a demand.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Mixed {
    /// Thrust of each rotor, N, within what it can give.
    pub thrusts_n: [f32; MOTOR_COUNT],
    /// What of the demand is in it.
    pub saturation: Saturation,
}

/// Which parts of a demand the rotors could not give, and what they give instead.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Saturation {
    /// Less angular acceleration than asked for about forward, left, up.
    pub axes: [bool; 3],
    /// Another collective thrust than asked for.
    pub thrust: bool,
    /// Angular acceleration given, rad/s².
    pub achieved_radps2: [f32; 3],
    /// Collective thrust per mass given, m/s².
    pub achieved_mps2: f32,
}

impl Saturation {
    /// Whether the rotors are at their limit in what a maneuver lives on: roll, pitch and lift, of which `asked_mps2` was
    /// wanted. That torque costs some thrust, lifts it above the least, or leaves yaw behind is part of a healthy flight.
    pub fn is_limit(&self, asked_mps2: f32) -> bool {
        let [roll, pitch, _] = self.axes;
        roll || pitch || self.achieved_mps2 < SATURATED_LIFT * asked_mps2
    }
}

/// Thrust of each rotor, N: [`mix`] without its report.
pub fn rotor_thrusts(config: &VehicleConfig, demand: &Demand) -> [f32; MOTOR_COUNT] {
    mix(config, demand).thrusts_n
}

/// From a demand to the thrust of each rotor, and what was left out.
///
/// Non-finite demands count as zero torque and hover thrust; the caller filters them, this keeps the output finite.
pub fn mix(config: &VehicleConfig, demand: &Demand) -> Mixed {
    mix_below(config, demand, config.rotor_thrust_max_n)
}

/// The same with no rotor above `high_n`, which is no lower than its idle thrust.
pub fn mix_below(config: &VehicleConfig, demand: &Demand, high_n: f32) -> Mixed {
    let (low, high) = (config.rotor_thrust_idle_n, high_n);
    let range = high - low;
    let finite = |v: f32, otherwise: f32| if v.is_finite() { v } else { otherwise };
    let [jx, jy, jz] = config.inertia_kgm2;
    let [ax, ay, az] = demand.acceleration_radps2.map(|a| finite(a, 0.0));
    // A rotor at (x, y) with thrust f gives the torque (y f, −x f, ±κ f).
    let yaw_arm_m = if config.reversed { -config.torque_per_thrust_m } else { config.torque_per_thrust_m };
    let roll = jx * ax / (4.0 * config.arm_left_m);
    let pitch = jy * ay / (4.0 * config.arm_forward_m);
    let yaw_wanted = jz * az / (4.0 * yaw_arm_m);

    // Roll and pitch take the range less the reserve for yaw, scaled down together where they ask for more.
    let attitude_range = range * (1.0 - YAW_RESERVE);
    let spread = 2.0 * (roll.abs() + pitch.abs());
    let attitude_scale = if spread > attitude_range { attitude_range / spread } else { 1.0 };
    let (roll, pitch) = (roll * attitude_scale, pitch * attitude_scale);
    let half_spread = roll.abs() + pitch.abs();

    // Collective thrust moves to where roll and pitch fit.
    let hover = GRAVITY_MPS2 as f32;
    let wanted = config.mass_kg * finite(demand.thrust_mps2, hover) / 4.0;
    let collective = at_most(at_least(wanted, low + half_spread), high - half_spread);

    // Yaw takes what is left on the tighter side, and at least the reserve: collective gives way to it.
    let room = at_least(at_most(collective - half_spread - low, high - half_spread - collective), 0.0);
    let reserve = 0.5 * at_most(range - 2.0 * half_spread, range * YAW_RESERVE);
    let yaw_bound = at_least(room, reserve);
    let yaw = at_most(at_least(yaw_wanted, -yaw_bound), yaw_bound);
    let collective =
        at_most(at_least(collective, low + half_spread + yaw.abs()), high - half_spread - yaw.abs());

    let thrusts_n = MOTORS.map(|place| {
        let thrust = collective + f32::from(place.left) * roll - f32::from(place.forward) * pitch
            + f32::from(place.yaw) * yaw;
        at_most(at_least(thrust, low), high)
    });
    let less = attitude_scale < 1.0;
    let saturation = Saturation {
        axes: [less && ax != 0.0, less && ay != 0.0, yaw != yaw_wanted],
        thrust: collective != wanted,
        achieved_radps2: [ax * attitude_scale, ay * attitude_scale, yaw * 4.0 * yaw_arm_m / jz],
        achieved_mps2: 4.0 * collective / config.mass_kg,
    };
    Mixed { thrusts_n, saturation }
}

/// Throttle, 0 to 1, for a rotor speed, as a share of the speed at full throttle and the present voltage.
///
/// The thrust map is T = T_max · ((1 − a) u² + a u) · (V/V_ref)², with a the [`VehicleConfig::thrust_linear_share`];
/// thrust goes with the square of the speed. With a = 0 the speed *is* the throttle.
pub fn throttle_of_speed(linear_share: f32, speed: f32) -> f32 {
    if linear_share == 0.0 {
        return speed;
    }
    // The root of the quadratic in the form that does not cancel, and that ends in u = y for a = 1.
    let y = speed * speed;
    2.0 * y / (linear_share + sqrt(linear_share * linear_share + 4.0 * (1.0 - linear_share) * y))
}

/// The inverse of [`throttle_of_speed`].
pub fn speed_of_throttle(linear_share: f32, throttle: f32) -> f32 {
    if linear_share == 0.0 {
        return throttle;
    }
    sqrt(((1.0 - linear_share) * throttle + linear_share) * throttle)
}

/// What each output line gets, from what the motor at each place of the frame shall get: the one place where wiring
/// matters. Lines to which no motor is wired stay at zero: see [`VehicleConfig::check`].
pub fn to_outputs(config: &VehicleConfig, by_place: [f32; MOTOR_COUNT]) -> [f32; MOTOR_COUNT] {
    let mut lines = [0.0; MOTOR_COUNT];
    for (value, line) in by_place.into_iter().zip(config.outputs) {
        if let Some(slot) = lines.get_mut(usize::from(line)) {
            *slot = value;
        }
    }
    lines
}

/// Turns rotor thrusts into throttles: the inverse thrust map, battery compensation, and rotor-lag compensation.
///
/// A rotor follows its throttle with a lag of some 30 ms, longer than many a bang. A model of the rotor's speed runs
/// along; the throttle overshoots so that the model reaches the wanted speed within [`ROTOR_RESPONSE_S`]. The model is
/// first order and bounded, so a wrong time constant costs accuracy, not stability.
#[derive(Clone, Copy, Debug, Default)]
pub struct RotorDrive {
    /// Modelled rotor speeds over the speed at full throttle and nominal voltage.
    speed: [f32; MOTOR_COUNT],
    /// The last voltage measured, V, and the collective thrust modelled when it first came, N.
    measured: Option<(f32, f32)>,
}

impl RotorDrive {
    /// Rotors at rest.
    pub const fn new() -> Self {
        Self { speed: [0.0; MOTOR_COUNT], measured: None }
    }

    /// Motors off: the model spins down with them.
    pub fn rest(&mut self, config: &VehicleConfig, dt_s: f32) -> [f32; MOTOR_COUNT] {
        self.follow(config, [0.0; MOTOR_COUNT], dt_s);
        [0.0; MOTOR_COUNT]
    }

    /// Throttles, 0..1, for the given thrusts, N. `battery_v` is `None` where it is not known.
    pub fn throttles(
        &mut self,
        config: &VehicleConfig,
        thrusts_n: [f32; MOTOR_COUNT],
        battery_v: Option<f32>,
        dt_s: f32,
    ) -> [f32; MOTOR_COUNT] {
        self.throttles_below(config, thrusts_n, battery_v, dt_s, config.rotor_thrust_max_n)
    }

    /// The same with no rotor told to turn faster than for `high_n`, not even for a moment, to get where it shall be sooner.
    /// `high_n` is no lower than the idle thrust, as for [`mix_below`].
    pub fn throttles_below(
        &mut self,
        config: &VehicleConfig,
        thrusts_n: [f32; MOTOR_COUNT],
        battery_v: Option<f32>,
        dt_s: f32,
        high_n: f32,
    ) -> [f32; MOTOR_COUNT] {
        let idle = sqrt(config.rotor_thrust_idle_n / config.rotor_thrust_max_n);
        let high = at_most(sqrt(high_n / config.rotor_thrust_max_n), 1.0);
        let share = config.thrust_linear_share;
        let lead = at_least(config.rotor_lag_s / ROTOR_RESPONSE_S, 1.0);
        let mut command = [0.0; MOTOR_COUNT];
        for ((slot, thrust), speed) in command.iter_mut().zip(thrusts_n).zip(self.speed) {
            let wanted = sqrt(at_least(thrust / config.rotor_thrust_max_n, 0.0));
            *slot = at_most(at_least(speed + lead * (wanted - speed), idle), high);
        }
        let compensation = config.battery_nominal_v / self.voltage_now(config, battery_v);
        let throttles =
            command.map(|c| throttle_of_speed(share, at_most(at_least(c * compensation, idle), 1.0)));
        // The model follows what the rotors really get: a sagged battery cannot give full speed.
        self.follow(config, throttles.map(|t| speed_of_throttle(share, t) / compensation), dt_s);
        throttles
    }

    /// The throttle at which a rotor comes to give `thrust_n`.
    pub fn throttle_of(&mut self, config: &VehicleConfig, thrust_n: f32, battery_v: Option<f32>) -> f32 {
        let compensation = config.battery_nominal_v / self.voltage_now(config, battery_v);
        let speed = sqrt(thrust_n / config.rotor_thrust_max_n) * compensation;
        throttle_of_speed(config.thrust_linear_share, at_most(speed, 1.0))
    }

    /// The battery's voltage now, V: the last one measured, less what it has sagged since by the thrust that has grown.
    fn voltage_now(&mut self, config: &VehicleConfig, battery_v: Option<f32>) -> f32 {
        // An implausible voltage (sense wire off) is not compensated for.
        let Some(measured_v) = battery_v.filter(|v| config.is_plausible_battery(*v)) else {
            self.measured = None;
            return config.battery_nominal_v;
        };
        if config.sag_v_per_n == 0.0 {
            return measured_v;
        }
        let thrust_n = self.speed.iter().fold(0.0, |sum, s| sum + s * s) * config.rotor_thrust_max_n;
        // A voltage that differs from the last is a new measurement.
        let then_n = match self.measured {
            Some((last_v, then_n)) if last_v == measured_v => then_n,
            _ => thrust_n,
        };
        self.measured = Some((measured_v, then_n));
        let now_v = measured_v - config.sag_v_per_n * (thrust_n - then_n);
        if config.is_plausible_battery(now_v) { now_v } else { measured_v }
    }

    fn follow(&mut self, config: &VehicleConfig, command: [f32; MOTOR_COUNT], dt_s: f32) {
        let blend = (dt_s / config.rotor_lag_s).clamp(0.0, 1.0);
        for (speed, command) in self.speed.iter_mut().zip(command) {
            *speed += blend * (command - *speed);
        }
    }
}

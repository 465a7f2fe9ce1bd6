//! The vehicle as its flight controller and its planner know it: the vehicle file.
//!
//! It is written to the vehicle once, kept there in flash, and its [hash](VehicleConfig::hash) stands in every table, so
//! that a table made for one vehicle is not flown by another.

use serde::{Deserialize, Serialize};

use crate::checksum::crc32;
use crate::frames::MOTORS;
use crate::messages::Setpoint;
use crate::model::GRAVITY_MPS2;
use crate::table::PlanLimits;

/// Rotors on a vehicle.
pub const MOTOR_COUNT: usize = MOTORS.len();

/// The numbers that describe a vehicle.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
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
    /// Share a of the thrust that grows with the throttle u itself, the rest with its square: T/T_max = (1 − a) u² + a u.
    /// 0 for controllers of speed, more for those of voltage.
    pub thrust_linear_share: f32,
    /// Time constant with which a rotor's speed follows its throttle, s.
    pub rotor_lag_s: f32,
    /// Battery voltage at which the thrust above was measured, V.
    pub battery_nominal_v: f32,
    /// Voltage below which arming and maneuvers are refused, V.
    pub battery_low_v: f32,
    /// Voltage below which a maneuver is given up, V.
    pub battery_critical_v: f32,
    /// How far the battery's voltage falls for each newton of collective thrust, V/N: for the time between two measurements
    /// of it. 0 believes the last one.
    pub sag_v_per_n: f32,
    /// Highest collective thrust per mass that a table may plan with, m/s². Below what the rotors give, so that torque
    /// is left for attitude at full planned thrust.
    pub plan_thrust_max_mps2: f32,
    /// Highest body rate that a table may plan with, rad/s. The gyro measures up to 34.9.
    pub plan_rate_max_radps: f32,
    /// Which output each rotor's speed controller hangs on: rotors in the order of [`MOTORS`], outputs from 0.
    pub outputs: [u8; MOTOR_COUNT],
    /// Propellers turn the other way round than [`MOTORS`] says.
    pub reversed: bool,
}

/// Why a vehicle file is unusable.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, thiserror::Error)]
pub enum VehicleError {
    /// A number is NaN or infinite.
    #[error("a number is not finite")]
    NotFinite,
    /// Mass outside 0.02 to 20 kg.
    #[error("the mass is not between 0.02 and 20 kg")]
    Mass,
    /// Inertia not positive, or one axis above the sum of the others, which no body has.
    #[error(
        "the moments of inertia are not those of a body: each above zero, none above the sum of the other two"
    )]
    Inertia,
    /// Arms or torque ratio out of range.
    #[error("arms must be 0.01 to 1 m long, reaction torque over thrust 0.001 to 0.2 m")]
    Geometry,
    /// Rotor thrusts out of order, or too little to hover with torque in reserve.
    #[error(
        "rotor thrusts: above 0 and below the maximum at idle, four rotors at most a quarter of the weight at idle and at least \
         1.3 times the weight at the maximum"
    )]
    Thrust,
    /// Thrust map or lag out of range.
    #[error("the thrust map's linear part must be 0 to 1, the rotor lag 0.001 to 0.2 s")]
    Rotor,
    /// Voltages out of order.
    #[error("voltages must be 2 < critical < low < 1.2 · nominal < 62, sag 0 to 1 V/N")]
    Battery,
    /// Plan limits beyond the rotors or the gyro.
    #[error(
        "plan limits: thrust above gravity, at most 100 m/s² and within the rotors with torque in reserve, rate 0.5 to 30 rad/s"
    )]
    PlanLimits,
    /// Two rotors on one output, or an output that is none.
    #[error("the outputs must be 0, 1, 2, 3 in some order")]
    Outputs,
}

/// Angular acceleration about roll and pitch that must be left at both thrust limits of a plan, rad/s²: what the rate
/// loop asks for where the vehicle is 0.4 rad/s away from its plan.
pub const TORQUE_RESERVE_RADPS2: f32 = 15.0;

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
        thrust_linear_share: 0.0,
        rotor_lag_s: 0.033,
        battery_nominal_v: 14.8,
        battery_low_v: 14.0,
        battery_critical_v: 12.4,
        sag_v_per_n: 0.0,
        plan_thrust_max_mps2: 30.0,
        plan_rate_max_radps: 15.0,
        outputs: [0, 1, 2, 3],
        reversed: false,
    };

    /// Whether these numbers are those of a vehicle that can fly.
    ///
    /// # Errors
    /// The first reason in the order of [`VehicleError`].
    pub fn check(&self) -> Result<(), VehicleError> {
        use VehicleError as E;
        let [jx, jy, jz] = self.inertia_kgm2;
        let ensure = |holds: bool, error: E| if holds { Ok(()) } else { Err(error) };
        ensure(self.numbers().iter().all(|n| n.is_finite()), E::NotFinite)?;
        ensure((0.02..=20.0).contains(&self.mass_kg), E::Mass)?;
        let positive = jx > 0.0 && jy > 0.0 && jz > 0.0;
        ensure(positive && jx <= jy + jz && jy <= jz + jx && jz <= (jx + jy) * 1.01, E::Inertia)?;
        let arm = 0.01..=1.0;
        let ratio = (0.001..=0.2).contains(&self.torque_per_thrust_m);
        ensure(arm.contains(&self.arm_forward_m) && arm.contains(&self.arm_left_m) && ratio, E::Geometry)?;
        let weight_n = self.mass_kg * GRAVITY_MPS2 as f32;
        let lift_n = self.rotor_thrust_max_n * MOTOR_COUNT as f32;
        // At idle nothing lifts, not even on a full battery: that is as far as arming goes by itself.
        let idle_n = self.rotor_thrust_idle_n * MOTOR_COUNT as f32;
        let idle = self.rotor_thrust_idle_n > 0.0
            && self.rotor_thrust_idle_n < self.rotor_thrust_max_n
            && idle_n <= 0.25 * weight_n;
        ensure(idle && lift_n >= 1.3 * weight_n, E::Thrust)?;
        let lag = (0.001..=0.2).contains(&self.rotor_lag_s);
        ensure((0.0..=1.0).contains(&self.thrust_linear_share) && lag, E::Rotor)?;
        let rising = 2.0 < self.battery_critical_v
            && self.battery_critical_v < self.battery_low_v
            && self.battery_low_v < 1.2 * self.battery_nominal_v
            && 1.2 * self.battery_nominal_v < 62.0;
        ensure(rising && (0.0..=1.0).contains(&self.sag_v_per_n), E::Battery)?;
        let limits = self.plan_limits();
        let thrust = self.plan_thrust_max_mps2 > GRAVITY_MPS2 as f32
            && self.plan_thrust_max_mps2 <= Setpoint::THRUST_MAX_MPS2
            && self.plan_thrust_max_mps2 <= self.thrust_available_mps2(self.battery_nominal_v)
            && limits.thrust_min_mps2 < GRAVITY_MPS2 as f32;
        ensure(thrust && (0.5..=30.0).contains(&self.plan_rate_max_radps), E::PlanLimits)?;
        let mut seen = [false; MOTOR_COUNT];
        for output in self.outputs {
            let slot = seen.get_mut(usize::from(output)).ok_or(E::Outputs)?;
            ensure(!*slot, E::Outputs)?;
            *slot = true;
        }
        Ok(())
    }

    /// Whether a measured battery voltage can be one: beyond, the sense wire is off. False for NaN.
    pub fn is_plausible_battery(&self, volts: f32) -> bool {
        volts > 0.6 * self.battery_nominal_v && volts < 1.4 * self.battery_nominal_v
    }

    /// Thrust per rotor that must be left, up and down, for [`TORQUE_RESERVE_RADPS2`] about the dearer axis, N.
    fn rotor_reserve_n(&self) -> f32 {
        let [jx, jy, _] = self.inertia_kgm2;
        let per_rotor = |inertia: f32, arm: f32| TORQUE_RESERVE_RADPS2 * inertia / (MOTOR_COUNT as f32 * arm);
        let (roll, pitch) = (per_rotor(jx, self.arm_left_m), per_rotor(jy, self.arm_forward_m));
        if roll > pitch { roll } else { pitch }
    }

    /// Highest collective thrust per mass at a battery voltage, with torque in reserve, m/s².
    pub fn thrust_available_mps2(&self, volts: f32) -> f32 {
        let part = volts / self.battery_nominal_v;
        let rotor_n = self.rotor_thrust_max_n * part * part - self.rotor_reserve_n();
        rotor_n * MOTOR_COUNT as f32 / self.mass_kg
    }

    /// What a table may plan with, [`PlanLimits`]: at least four rotors at idle with torque in reserve, at most what the
    /// vehicle file allows.
    pub fn plan_limits(&self) -> PlanLimits {
        let least_n = self.rotor_thrust_idle_n + self.rotor_reserve_n();
        PlanLimits {
            thrust_min_mps2: least_n * MOTOR_COUNT as f32 / self.mass_kg,
            thrust_max_mps2: self.plan_thrust_max_mps2,
            rate_max_radps: self.plan_rate_max_radps,
            gravity_mps2: GRAVITY_MPS2 as f32,
        }
    }

    fn numbers(&self) -> [f32; 17] {
        let [jx, jy, jz] = self.inertia_kgm2;
        [
            self.mass_kg,
            jx,
            jy,
            jz,
            self.arm_forward_m,
            self.arm_left_m,
            self.torque_per_thrust_m,
            self.rotor_thrust_max_n,
            self.rotor_thrust_idle_n,
            self.thrust_linear_share,
            self.rotor_lag_s,
            self.battery_nominal_v,
            self.battery_low_v,
            self.battery_critical_v,
            self.sag_v_per_n,
            self.plan_thrust_max_mps2,
            self.plan_rate_max_radps,
        ]
    }

    /// Identifies this vehicle: CRC-32 over all fields in order. Never zero, which means "any vehicle".
    pub fn hash(&self) -> u32 {
        let mut bytes = [0; 17 * 4 + MOTOR_COUNT + 1];
        let (numbers, rest) = bytes.split_at_mut(17 * 4);
        for (slot, number) in numbers.chunks_exact_mut(4).zip(self.numbers()) {
            slot.copy_from_slice(&number.to_le_bytes());
        }
        let flags = self.outputs.into_iter().chain([u8::from(self.reversed)]);
        for (slot, flag) in rest.iter_mut().zip(flags) {
            *slot = flag;
        }
        crc32(&bytes).max(1)
    }
}

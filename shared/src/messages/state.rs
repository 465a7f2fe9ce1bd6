//! What the supervisor may be doing, why a flight ended, and what blocks arming.

use serde::{Deserialize, Serialize};

/// What the supervisor is doing.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum FlightState {
    /// Just switched on: drivers at work on their set-up. Motors off.
    #[default]
    Boot,
    /// Learning the gyro's bias or scale. Motors off.
    Calibrating,
    /// Motors off.
    Disarmed,
    /// Motors idle, waiting for setpoints; or off, waiting for a motor test.
    Armed,
    /// Following the host's setpoints.
    Tracking,
    /// Replaying a maneuver.
    Maneuver,
    /// On its own: levelling, then sinking, for a bounded time.
    Recovery,
    /// Down after a recovery. Motors off.
    Landed,
    /// Motors off after an emergency. Final: only a person's acknowledgement leads out of it.
    Terminated,
}

impl FlightState {
    /// All states, in the order of their numbers on the wire.
    pub const ALL: [Self; 9] = [
        Self::Boot,
        Self::Calibrating,
        Self::Disarmed,
        Self::Armed,
        Self::Tracking,
        Self::Maneuver,
        Self::Recovery,
        Self::Landed,
        Self::Terminated,
    ];

    /// The state with this number on the wire.
    pub fn from_index(index: u32) -> Option<Self> {
        Self::ALL.get(index as usize).copied()
    }

    /// Whether the motors may turn.
    pub const fn motors_on(self) -> bool {
        matches!(self, Self::Armed | Self::Tracking | Self::Maneuver | Self::Recovery)
    }

    /// Whether the vehicle may be in the air.
    pub const fn airborne(self) -> bool {
        matches!(self, Self::Tracking | Self::Maneuver | Self::Recovery)
    }
}

/// Why a maneuver or a flight ended otherwise than planned. The order is the order of severity: when several apply,
/// the greatest is reported and acted on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize, thiserror::Error)]
pub enum AbortReason {
    /// Armed, but nothing flew for too long.
    #[error("armed but idle for 30 s, so the motors were switched off: arm again when ready")]
    IdleTimeout,
    /// The battery's voltage fell below what a flight needs.
    #[error("the battery sagged below its critical voltage: land and charge it")]
    BatterySag,
    /// The rotors were at their limit for too long.
    #[error("the motors were at their limit for too long: plan with less thrust, or check the battery")]
    MotorsSaturated,
    /// The vehicle turned otherwise than planned, beyond the envelope.
    #[error(
        "the vehicle's rotation left the planned envelope: check propellers, motor order and gyro mounting"
    )]
    OffPlan,
    /// Too many samples of the gyro were missing.
    #[error("too many gyro samples were lost in the maneuver: check the gyro's wiring")]
    LostSamples,
    /// Ticks came too late for too long.
    #[error("control ticks came too late: the flight controller is overloaded or the gyro's clock is off")]
    LateTicks,
    /// Setpoints stopped in flight.
    #[error("setpoints from the host stopped coming: check the link")]
    LinkLost,
    /// Nothing at all was heard of the host.
    #[error("the host fell silent: check the link and the program that flies")]
    HeartbeatLost,
    /// Rates far from the setpoint with full control effort: not controllable.
    #[error(
        "the vehicle did not follow its controls (runaway): check motor order, propellers and gyro mounting"
    )]
    Runaway,
    /// Samples at the end of the gyro's range.
    #[error("the gyro saturated: the vehicle turned faster than it can measure")]
    GyroSaturated,
    /// The same sample again and again.
    #[error("the gyro is frozen: the same sample keeps coming")]
    GyroFrozen,
    /// No samples.
    #[error("the gyro stopped delivering samples: check its wiring")]
    GyroMissing,
    /// The vehicle's clock ran backwards.
    #[error("the vehicle's clock ran backwards: a hardware fault, do not fly this flight controller")]
    Clock,
    /// The kill switch's receiver fell silent.
    #[error("the kill switch's radio was lost: check transmitter, receiver and distance")]
    KillLost,
    /// The kill switch.
    #[error("the kill switch was pressed")]
    KillSwitch,
    /// An emergency stop from the host.
    #[error("emergency stop by the host")]
    EmergencyStop,
}

impl AbortReason {
    /// All reasons, the least grave first.
    pub const ALL: [Self; 16] = [
        Self::IdleTimeout,
        Self::BatterySag,
        Self::MotorsSaturated,
        Self::OffPlan,
        Self::LostSamples,
        Self::LateTicks,
        Self::LinkLost,
        Self::HeartbeatLost,
        Self::Runaway,
        Self::GyroSaturated,
        Self::GyroFrozen,
        Self::GyroMissing,
        Self::Clock,
        Self::KillLost,
        Self::KillSwitch,
        Self::EmergencyStop,
    ];
}

/// What the kill switch says. It hangs on a radio of its own, not on the computer.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum KillSwitch {
    /// No receiver was ever heard.
    #[default]
    Absent,
    /// It was heard and is silent now.
    Lost,
    /// It says stop.
    Stop,
    /// It lets the motors turn.
    Run,
}

/// Reasons that block arming, as bits.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ArmingBlock(pub u32);

impl ArmingBlock {
    /// The board has no gyro, or its driver found none.
    pub const NO_GYRO: Self = Self(1 << 0);
    /// The board cannot drive motors.
    pub const NO_MOTORS: Self = Self(1 << 1);
    /// No gyro sample for some ticks.
    pub const GYRO_SILENT: Self = Self(1 << 2);
    /// The gyro's bias is not known yet.
    pub const NOT_CALIBRATED: Self = Self(1 << 3);
    /// The vehicle is moving.
    pub const MOVING: Self = Self(1 << 4);
    /// The battery's voltage is not known.
    pub const BATTERY_UNKNOWN: Self = Self(1 << 5);
    /// The battery is too low.
    pub const BATTERY_LOW: Self = Self(1 << 6);
    /// The kill switch says stop.
    pub const KILL_SWITCH: Self = Self(1 << 7);
    /// Ticks are late.
    pub const LATE_TICKS: Self = Self(1 << 8);
    /// Stopped by an emergency, not acknowledged.
    pub const TERMINATED: Self = Self(1 << 9);
    /// The gyro repeats one sample.
    pub const GYRO_FROZEN: Self = Self(1 << 10);
    /// The board is still setting up its gyro or arming its speed controllers.
    pub const STARTING: Self = Self(1 << 11);
    /// An incident of this run or the one before is not acknowledged.
    pub const INCIDENT: Self = Self(1 << 12);
    /// No kill switch was ever heard, and the settings do not waive it.
    pub const NO_KILL_SWITCH: Self = Self(1 << 13);
    /// The kill switch's radio is silent.
    pub const KILL_LOST: Self = Self(1 << 14);
    /// The vehicle does not stand upright.
    pub const TILTED: Self = Self(1 << 15);
    /// The vehicle has not been told what it is.
    pub const NO_VEHICLE: Self = Self(1 << 16);
    /// Flash is being written.
    pub const STORING: Self = Self(1 << 17);
    /// Down after a recovery, not disarmed.
    pub const LANDED: Self = Self(1 << 18);
    /// The vehicle file was damaged in flash and not written anew: an older one may be in force.
    pub const DAMAGED_VEHICLE: Self = Self(1 << 19);
    /// So were the settings, the kill switch's channel among them.
    pub const DAMAGED_SETTINGS: Self = Self(1 << 20);
    /// So was the pairing key: anybody may be listened to.
    pub const DAMAGED_PAIRING: Self = Self(1 << 21);

    /// Each bit with the sentence that says what to do.
    pub const REASONS: [(Self, &'static str); 22] = [
        (Self::NO_GYRO, "no gyro on this board"),
        (Self::NO_MOTORS, "no motor outputs on this board"),
        (Self::GYRO_SILENT, "the gyro delivers no samples"),
        (Self::NOT_CALIBRATED, "the gyro is not calibrated yet: keep the vehicle still for a second"),
        (Self::MOVING, "the vehicle is moving: put it down"),
        (Self::BATTERY_UNKNOWN, "the battery voltage is unknown: check the sense wire"),
        (Self::BATTERY_LOW, "the battery is low: charge it"),
        (Self::KILL_SWITCH, "the kill switch says stop: release it"),
        (Self::LATE_TICKS, "control ticks are late"),
        (
            Self::TERMINATED,
            "stopped after an emergency: find out why, then `mintime vehicle PORT acknowledge`",
        ),
        (Self::GYRO_FROZEN, "the gyro repeats one sample: check its wiring"),
        (Self::STARTING, "gyro and speed controllers are still starting: wait some seconds"),
        (
            Self::INCIDENT,
            "an incident waits to be read: `mintime vehicle PORT status`, then `mintime vehicle PORT acknowledge`",
        ),
        (
            Self::NO_KILL_SWITCH,
            "no kill switch: connect a CRSF receiver to USART2 RX, or, on the bench only, cap the thrust by the setting \
             bench_thrust_mps2",
        ),
        (Self::KILL_LOST, "the kill switch's radio is silent: switch the transmitter on"),
        (Self::TILTED, "the vehicle does not stand upright: put it on level ground"),
        (
            Self::NO_VEHICLE,
            "the vehicle does not know its mass and motors: `mintime vehicle PORT params --file`",
        ),
        (Self::STORING, "flash is being written: wait a second"),
        (Self::LANDED, "down after a recovery: disarm first"),
        (
            Self::DAMAGED_VEHICLE,
            "the vehicle file was damaged in flash: write it again, `mintime vehicle PORT params --file`",
        ),
        (
            Self::DAMAGED_SETTINGS,
            "the settings were damaged in flash: look at each and write them again, `mintime vehicle PORT params`",
        ),
        (
            Self::DAMAGED_PAIRING,
            "the pairing key was damaged in flash: pair anew with `mintime vehicle PORT pair`, or without a key `pair --remove`",
        ),
    ];

    /// No reason.
    pub const fn none() -> Self {
        Self(0)
    }

    /// Adds a reason where a condition holds.
    #[must_use]
    pub const fn when(self, reason: Self, condition: bool) -> Self {
        if condition { Self(self.0 | reason.0) } else { self }
    }

    /// Whether a reason is among them.
    pub const fn contains(self, reason: Self) -> bool {
        self.0 & reason.0 != 0
    }
}

impl core::fmt::Display for ArmingBlock {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        let mut first = true;
        for (reason, text) in Self::REASONS {
            if self.contains(reason) {
                f.write_str(if first { "" } else { "; " })?;
                f.write_str(text)?;
                first = false;
            }
        }
        if first { f.write_str("no reason") } else { Ok(()) }
    }
}

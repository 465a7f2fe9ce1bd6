//! Why a request was not carried out.

use serde::{Deserialize, Serialize};

use super::{ArmingBlock, FlightState};
use crate::settings::SettingsError;
use crate::table::TableError;
use crate::vehicle::VehicleError;

/// Why a request was not carried out. Nothing has changed then.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, thiserror::Error)]
pub enum Refusal {
    /// Another protocol version.
    #[error(
        "vehicle and host speak different protocol versions: flash the firmware of this version of mintime"
    )]
    ProtocolVersion,
    /// Not while the motors turn.
    #[error("refused while the motors turn: disarm first")]
    MotorsOn,
    /// Not in this state.
    #[error("refused in the state {0:?}")]
    WrongState(FlightState),
    /// Not armed, or not kept, for these reasons: bits of [`ArmingBlock`].
    #[error("refused: {}", ArmingBlock(*.0))]
    ArmingBlocked(u32),
    /// The table is unusable.
    #[error("the table is refused: {0}")]
    Table(TableError),
    /// Nothing was staged, or something else.
    #[error("the staged table is not the one named: upload it again")]
    NotStaged,
    /// No table, or another one, is committed.
    #[error("the committed table is not the one named: upload and commit it first")]
    NotCommitted,
    /// Setpoints are not fresh, so nobody would catch the vehicle after the maneuver.
    #[error("trigger refused without fresh setpoints: nobody would catch the vehicle after the maneuver")]
    StaleSetpoint,
    /// Too little charge left for a maneuver.
    #[error("trigger refused: the battery is low or its voltage unknown, land and charge it")]
    BatteryLow,
    /// A number is NaN or infinite.
    #[error("a number is not finite: send finite body rates and thrust")]
    NotFinite,
    /// No such record.
    #[error("there is no record at that index")]
    NoRecord,
    /// A number beyond what any vehicle does.
    #[error(
        "a number is out of range: body rates to 35 rad/s, thrust 0 to 100 m/s², motor tests to 15 % and 2 s"
    )]
    OutOfRange,
    /// The battery cannot give the table's thrust at its present voltage.
    #[error("trigger refused: at its present voltage the battery cannot give the planned thrust, charge it")]
    BatteryThrust,
    /// The vehicle does not stand or hover as the table's start wants it.
    #[error(
        "trigger refused outside the start gate: the vehicle's tilt or rates are not those of the table's start"
    )]
    OutsideGate,
    /// A chunk that does not join the ones before.
    #[error("a chunk is missing before this one: go on at byte {expected}")]
    Gap {
        /// First byte that is missing.
        expected: u16,
    },
    /// The vehicle file is unusable.
    #[error("the vehicle file is refused: {0}")]
    Vehicle(VehicleError),
    /// The settings are unusable.
    #[error("the settings are refused: {0}")]
    Settings(SettingsError),
    /// No table of that name.
    #[error("no table of that name is stored: list them with `mintime vehicle PORT tables`")]
    NoSuchTable,
    /// No room for another table.
    #[error("the vehicle stores eight tables and all places are taken: delete one first")]
    StoreFull,
    /// Flash could not be written.
    #[error("the vehicle's flash could not be written: it may be worn out, do not rely on what it stores")]
    StoreFailed,
    /// That is not the incident that waits.
    #[error("no such incident waits: read the status again")]
    NoSuchIncident,
    /// The kill switch says stop, or is lost.
    #[error("the kill switch says stop or is not heard: release it first")]
    KillSwitch,
    /// A pairing key is set and the message does not carry its seal, or an old one.
    #[error("the vehicle is paired and this message is not sealed with its key: give the key with --key")]
    NotSealed,
    /// A guided calibration did not work out.
    #[error("the calibration failed: {0}")]
    Calibration(CalibrationError),
    /// Setpoints do not act on a vehicle armed for a motor test, nor motor tests on one armed for flight.
    #[error("armed for something else: disarm, then arm for this")]
    OtherPurpose,
    /// What may turn a motor came too late, or from a host that has not heard the vehicle: [`super::REQUEST_AGE_MS`].
    #[error(
        "the request is older than 0.3 s, or its host does not hear the vehicle: the link holds messages back, mend or replace it"
    )]
    Late,
}

/// Why guided turns say nothing of the gyro's scale. Nothing has changed; begin again.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, thiserror::Error)]
pub enum CalibrationError {
    /// No such axis, no turns or too many.
    #[error(
        "give axis 0, 1 or 2 (forward, left, up) and 1 to 4 whole turns, or -1 to -4 for the other direction"
    )]
    Turns,
    /// It never stood still.
    #[error("the vehicle did not stand still: put it down against an edge, let go, and begin again")]
    NotStill,
    /// It was never turned.
    #[error("the vehicle was not turned: begin again and turn it within 20 s")]
    NotTurned,
    /// Turned the other way round.
    #[error(
        "turned in the wrong direction: begin again and turn it the other way, or give the turns with a minus sign"
    )]
    WrongDirection,
    /// Turned faster than the gyro measures.
    #[error("turned too fast for the gyro: begin again and take a second or more for each turn")]
    TooFast,
    /// Not finished in time.
    #[error("the turns took too long, and the bias drifts meanwhile: begin again and finish within 30 s")]
    TooSlow,
    /// Turned further than asked for.
    #[error("turned further than asked for: begin again and count the turns")]
    TooFar,
    /// Another axis has turned too.
    #[error(
        "the vehicle did not end as it began: turn it about one axis only and put it back against the same edge"
    )]
    Wobble,
    /// The bias changed meanwhile.
    #[error("the gyro's bias has drifted: let the board warm up for some minutes and begin again")]
    BiasDrift,
    /// The scale is off by more than a working gyro's.
    #[error("the scale is off by more than 5 %: check the number of turns and that it ends as it began")]
    Implausible,
    /// The gyro gave no samples for a while.
    #[error("the gyro fell silent during the turns: check its wiring and power, and begin again")]
    SamplesLost,
}

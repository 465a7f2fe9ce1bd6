//! The interface between host and vehicle: every message, in one place.
//!
//! | request | answer | when it is allowed |
//! |---|---|---|
//! | [`Request::Identify`] | [`Reply::Identity`] | always |
//! | [`Request::Status`] | [`Reply::Status`] | always |
//! | [`Request::StageTable`] | [`Reply::Staged`] | motors off; the staged bytes replace earlier staged ones |
//! | [`Request::CommitTable`] | [`Reply::Committed`] | motors off; checks the whole table, then replaces the old one |
//! | [`Request::ReadTable`] | [`Reply::Table`] | always; the committed bytes |
//! | [`Request::Arm`] | [`Reply::Done`] | disarmed and nothing blocks it |
//! | [`Request::Disarm`] | [`Reply::Done`] | always; motors off, and it clears a stop unless the kill switch is on |
//! | [`Request::EmergencyStop`] | [`Reply::Done`] | always; motors off until a `Disarm` clears it |
//! | [`Request::Setpoint`] | none | acts when armed; ignored otherwise |
//! | [`Request::Trigger`] | [`Reply::Done`] | flying on fresh setpoints with that very table committed |
//! | [`Request::ReadRecord`] | [`Reply::Record`] | not during a maneuver |
//!
//! Besides answers the vehicle sends [`Telemetry`] every [`TELEMETRY_PERIOD_US`] without being asked. A request that
//! is not carried out is answered by [`Reply::Refused`] with a [`Refusal`], and changes nothing. Requests say what
//! shall be (“armed”), not what to do, so asking twice is harmless; a trigger repeated under one number fires once. An
//! answer carries its request's number.
//!
//! Each frame begins with [`PROTOCOL_VERSION`]; [`crate::framing`] turns messages into bytes. Byte layout is postcard's,
//! fields in the order of declaration. SI units and radians throughout.

use heapless::Vec;
use serde::{Deserialize, Serialize};

use crate::table::{MAX_TABLE_BYTES, TableError};

/// Raised with every change of a message.
pub const PROTOCOL_VERSION: u8 = 2;
/// Most bytes of a record chunk: [`RECORDS_PER_CHUNK`] ticks.
pub const MAX_CHUNK_BYTES: usize = RECORDS_PER_CHUNK * RECORD_BYTES;
/// Ticks in one record chunk.
pub const RECORDS_PER_CHUNK: usize = 12;
/// Bytes of one recorded tick.
pub const RECORD_BYTES: usize = 20;
/// Telemetry interval, µs.
pub const TELEMETRY_PERIOD_US: u64 = 20_000;

/// Host to vehicle.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Uplink {
    /// [`PROTOCOL_VERSION`] of the sender. A version that changes the requests it has in common with this one makes them
    /// unreadable; one that does not is told so.
    pub version: u8,
    /// Chosen by the host; the answer repeats it.
    pub number: u16,
    /// What is asked.
    pub request: Request,
}

/// A [`Downlink`] about to be sent: the same bytes, without a copy of the message.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct DownlinkRef<'a> {
    /// [`PROTOCOL_VERSION`].
    pub version: u8,
    /// What is said.
    pub message: &'a Message,
}

/// Vehicle to host.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Downlink {
    /// [`PROTOCOL_VERSION`] of the sender.
    pub version: u8,
    /// What is said.
    pub message: Message,
}

/// What a vehicle sends.
#[allow(clippy::large_enum_variant, reason = "no allocator to box with; a message lives for one queue slot")]
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Message {
    /// The answer to the request with this number.
    Reply {
        /// The request's number.
        number: u16,
        /// The answer.
        reply: Reply,
    },
    /// Unasked, periodically.
    Telemetry(Telemetry),
}

/// What a host asks.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Request {
    /// Who are you?
    Identify,
    /// How are you?
    Status,
    /// Hold these bytes for a commit.
    StageTable(Vec<u8, MAX_TABLE_BYTES>),
    /// Make the staged table the one to fly, if it is this one.
    CommitTable {
        /// Its checksum, [`crate::table::ManeuverTable::checksum`].
        checksum: u32,
    },
    /// Read the committed table back.
    ReadTable,
    /// Be armed: motors turn at idle.
    Arm,
    /// Be disarmed: motors off.
    Disarm,
    /// Motors off now, whatever happens, until disarmed.
    EmergencyStop,
    /// Fly these body rates and this thrust until the next setpoint.
    Setpoint(Setpoint),
    /// Fly the committed table, if it is this one, from the next tick.
    Trigger {
        /// Its checksum.
        checksum: u32,
    },
    /// Send recorded ticks from this index on.
    ReadRecord {
        /// Index of the first tick wanted.
        first: u32,
    },
}

/// Body rates and thrust, as the host streams them.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Setpoint {
    /// Body rates about forward, left, up ([`crate::frames`]), rad/s.
    pub rates_radps: [f32; 3],
    /// Collective thrust per mass, m/s².
    pub thrust_mps2: f32,
}

impl Setpoint {
    /// Highest body rate that makes sense, rad/s: the end of the gyro's range.
    pub const RATE_MAX_RADPS: f32 = 35.0;
    /// Highest thrust per mass that makes sense, m/s².
    pub const THRUST_MAX_MPS2: f32 = 100.0;

    /// Within what makes sense. False for NaN.
    pub fn is_in_range(&self) -> bool {
        self.rates_radps.iter().all(|r| r.abs() <= Self::RATE_MAX_RADPS)
            && (0.0..=Self::THRUST_MAX_MPS2).contains(&self.thrust_mps2)
    }

    /// All numbers finite.
    pub fn is_finite(&self) -> bool {
        self.rates_radps.iter().all(|r| r.is_finite()) && self.thrust_mps2.is_finite()
    }
}

/// What a vehicle answers.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Reply {
    /// To `Identify`.
    Identity(Identity),
    /// To `Status`.
    Status(Telemetry),
    /// The staged bytes are held.
    Staged {
        /// Their number.
        length: u16,
    },
    /// The table is the one to fly now.
    Committed {
        /// Its duration, s.
        duration_s: f32,
    },
    /// The committed bytes; empty where there are none.
    Table(Vec<u8, MAX_TABLE_BYTES>),
    /// Recorded ticks.
    Record(RecordChunk),
    /// It is so.
    Done,
    /// It was not done, and nothing has changed.
    Refused(Refusal),
}

/// Who a vehicle is.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Identity {
    /// Firmware version: major, minor, patch.
    pub firmware_version: [u8; 3],
    /// Layout of tables it takes, [`crate::table::SCHEMA_HASH`].
    pub table_schema: u32,
    /// Hash of its configuration: mass, geometry, rotors, gains.
    pub vehicle: u32,
    /// Highest thrust per mass that a table may ask for, m/s².
    pub thrust_max_mps2: f32,
    /// Highest body rate that a table may ask for, rad/s.
    pub rate_max_radps: f32,
}

/// What the supervisor is doing.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum FlightState {
    /// Motors off.
    #[default]
    Disarmed,
    /// Motors idle, waiting for setpoints.
    Armed,
    /// Following the host's setpoints.
    Flying,
    /// Replaying a maneuver.
    Maneuver,
    /// Setpoints are late: rates zero, sinking gently.
    LinkLost,
    /// Motors off after an emergency; a `Disarm` clears it.
    Stopped,
}

impl FlightState {
    /// All states, in the order of their numbers on the wire.
    pub const ALL: [Self; 6] =
        [Self::Disarmed, Self::Armed, Self::Flying, Self::Maneuver, Self::LinkLost, Self::Stopped];

    /// The state with this number on the wire.
    pub fn from_index(index: u32) -> Option<Self> {
        Self::ALL.get(index as usize).copied()
    }

    /// Whether the motors may turn.
    pub fn motors_on(self) -> bool {
        !matches!(self, Self::Disarmed | Self::Stopped)
    }
}

/// Why a maneuver or a flight ended otherwise than planned. The order is the order of severity: when several apply,
/// the greatest is reported and acted on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize, thiserror::Error)]
pub enum AbortReason {
    /// Armed, but nothing flew for too long.
    #[error("armed but idle for 30 s, so the motors were switched off: arm again when ready")]
    IdleTimeout,
    /// The vehicle turned otherwise than planned, beyond the envelope.
    #[error(
        "the vehicle's rotation left the planned envelope: check propellers, motor order and gyro mounting"
    )]
    OffPlan,
    /// Ticks came too late for too long.
    #[error("control ticks came too late: the flight controller is overloaded or the gyro's clock is off")]
    LateTicks,
    /// Setpoints stopped in flight.
    #[error("setpoints from the host stopped coming: check the link")]
    LinkLost,
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
    /// The kill switch.
    #[error("the kill switch was pressed")]
    KillSwitch,
    /// An emergency stop from the host.
    #[error("emergency stop by the host")]
    EmergencyStop,
}

/// Why a request was not carried out.
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
    /// Not armed, for these reasons: bits of [`ArmingBlock`].
    #[error("arming is refused: {}", ArmingBlock(*.0))]
    ArmingBlocked(u16),
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
    /// A setpoint beyond what any vehicle does.
    #[error("a setpoint is out of range: body rates to 35 rad/s, thrust 0 to 100 m/s²")]
    OutOfRange,
}

/// Reasons that block arming, as bits.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ArmingBlock(pub u16);

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
    /// The kill switch is on.
    pub const KILL_SWITCH: Self = Self(1 << 7);
    /// Ticks are late.
    pub const LATE_TICKS: Self = Self(1 << 8);
    /// The gyro repeats one sample.
    pub const GYRO_FROZEN: Self = Self(1 << 10);
    /// Stopped by an emergency, not cleared.
    pub const STOPPED: Self = Self(1 << 9);
    /// The board is still setting up its gyro or arming its speed controllers.
    pub const STARTING: Self = Self(1 << 11);

    /// Each bit with the sentence that says what to do.
    pub const REASONS: [(Self, &'static str); 12] = [
        (Self::NO_GYRO, "no gyro on this board"),
        (Self::NO_MOTORS, "no motor outputs on this board"),
        (Self::GYRO_SILENT, "the gyro delivers no samples"),
        (Self::NOT_CALIBRATED, "the gyro is not calibrated yet: keep the vehicle still for a second"),
        (Self::MOVING, "the vehicle is moving: put it down"),
        (Self::BATTERY_UNKNOWN, "the battery voltage is unknown: check the sense wire"),
        (Self::BATTERY_LOW, "the battery is low: charge it"),
        (Self::KILL_SWITCH, "the kill switch is on: release it"),
        (Self::LATE_TICKS, "control ticks are late"),
        (Self::GYRO_FROZEN, "the gyro repeats one sample: check its wiring"),
        (Self::STOPPED, "stopped after an emergency: disarm to clear it"),
        (Self::STARTING, "gyro and speed controllers are still starting: wait some seconds"),
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

/// How a vehicle is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Telemetry {
    /// The vehicle's clock, µs.
    pub time_us: u64,
    /// What the supervisor is doing.
    pub state: FlightState,
    /// What blocks arming: bits of [`ArmingBlock`].
    pub arming_block: u16,
    /// The last abort since arming.
    pub abort: Option<AbortReason>,
    /// Checksum of the committed table, 0 for none.
    pub table: u32,
    /// Time into the maneuver, or the time flown of the last one, s.
    pub maneuver_s: f32,
    /// Whether the last maneuver ran to its end.
    pub maneuver_complete: bool,
    /// Ticks of the last maneuver.
    pub maneuver_ticks: u32,
    /// Ticks that the clock says are missing between them.
    pub maneuver_missed_ticks: u32,
    /// Battery, V; 0 where unknown.
    pub battery_v: f32,
    /// Body rates, bias removed, rad/s.
    pub rates_radps: [f32; 3],
    /// Control ticks since power-up.
    pub ticks: u32,
    /// Ticks that came more than half a period late, since power-up.
    pub late_ticks: u32,
    /// Ticks without a gyro sample, since power-up.
    pub missing_samples: u32,
    /// Longest interval between two ticks since arming, µs.
    pub worst_interval_us: u32,
    /// Received frames that were not messages.
    pub link_errors: u32,
    /// Ticks in the recorder.
    pub recorded: u32,
    /// What the board measures of itself; `None` where the flight logic runs on no board.
    pub board: Option<BoardTelemetry>,
}

/// How a flight controller board does. Times are of the processor's cycle counter.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct BoardTelemetry {
    /// Why the gyro could not be set up, if so.
    pub gyro_fault: Option<GyroFault>,
    /// From the gyro's data-ready edge to the end of the last bit that the motors get for it, latest tick, ns.
    pub latency_ns: u32,
    /// The shortest such time since arming (since power-up before the first arming), ns; 0 before the first.
    pub latency_min_ns: u32,
    /// The longest; less the shortest it is the jitter, peak to peak, ns.
    pub latency_max_ns: u32,
    /// Longest run of a control tick since power-up, link work included, ns.
    pub tick_max_ns: u32,
    /// Periods without a control tick since power-up, counted from time.
    pub missed_ticks: u32,
    /// Part of the last second that the processor was awake, ‰.
    pub load_permille: u16,
    /// Deepest use of the stack since power-up, bytes.
    pub stack_used_bytes: u16,
    /// Motor frames that were not sent in time or not in full, since power-up.
    pub motor_errors: u32,
    /// Data-ready edges whose sample could not be read or was no measurement, since power-up.
    pub gyro_errors: u32,
    /// Data-ready edges that came too soon after the one before, since power-up.
    pub spurious_edges: u32,
}

/// Why a board's gyro could not be set up.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, thiserror::Error)]
pub enum GyroFault {
    /// The bus moved no byte within its time.
    #[error("the gyro's bus does not work")]
    Bus,
    /// This is not the identity of the chip that the board has; 0 or 255: nobody answers.
    #[error("another chip than expected answers, or none: identity {0:#04x}")]
    Identity(u8),
    /// The chip did not take its configuration file; what it says of itself.
    #[error("the gyro refused its configuration file: status {0:#04x}")]
    Configuration(u8),
    /// A register does not hold what was written to it; its address.
    #[error("the gyro's register {0:#04x} does not hold what was written")]
    Register(u8),
    /// The chip reports an error of its own.
    #[error("the gyro reports an error: {0:#04x}")]
    Chip(u8),
}

/// A run of recorded ticks.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct RecordChunk {
    /// Index of the first tick here.
    pub first: u32,
    /// Ticks in the whole record.
    pub total: u32,
    /// [`RECORD_BYTES`] a tick.
    pub bytes: Vec<u8, MAX_CHUNK_BYTES>,
}

/// One recorded tick of a maneuver, 20 bytes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RecordedTick {
    /// Since the previous recorded tick, µs (0 for the first; saturates at 65 ms).
    pub interval_us: u16,
    /// Gyro, bias removed, rad/s about forward, left, up; `None` where the sample was missing.
    pub gyro_radps: Option<[f32; 3]>,
    /// Commanded rate of turn in the maneuver's plane, rad/s.
    pub rate_radps: f32,
    /// Commanded thrust per mass, m/s².
    pub thrust_mps2: f32,
    /// Throttles of the four motors, 0..1.
    pub throttle: [f32; 4],
}

impl RecordedTick {
    /// rad/s per count: ±2000 degrees/s, the gyro's range, in 16 bits.
    const RATE_LSB: f32 = 35.0 / 32767.0;
    /// m/s² per count: up to 65.5.
    const THRUST_LSB: f32 = 1.0e-3;
    const THROTTLE_LSB: f32 = 1.0 / 65535.0;
    /// A gyro value that no sample has.
    const MISSING: i16 = i16::MIN;

    /// Packs the tick: interval, gyro ×3, rate (i16 each), thrust, throttle ×4 (u16 each), little-endian. `as`
    /// saturates and turns NaN into zero.
    pub fn to_bytes(&self) -> [u8; RECORD_BYTES] {
        let rate = |v: f32| (libm::roundf(v / Self::RATE_LSB) as i16).max(-i16::MAX).to_le_bytes();
        let unsigned = |v: f32, lsb: f32| (libm::roundf(v / lsb) as u16).to_le_bytes();
        let [gx, gy, gz] = self.gyro_radps.map_or([Self::MISSING.to_le_bytes(); 3], |g| g.map(rate));
        let [a, b, c, d] = self.throttle.map(|t| unsigned(t, Self::THROTTLE_LSB));
        let thrust = unsigned(self.thrust_mps2, Self::THRUST_LSB);
        let words = [self.interval_us.to_le_bytes(), gx, gy, gz, rate(self.rate_radps), thrust, a, b, c, d];
        let mut bytes = [0; RECORD_BYTES];
        for (slot, word) in bytes.chunks_exact_mut(2).zip(words) {
            slot.copy_from_slice(&word);
        }
        bytes
    }

    /// Unpacks a tick.
    pub fn from_bytes(bytes: &[u8; RECORD_BYTES]) -> Self {
        let mut words = [[0; 2]; RECORD_BYTES / 2];
        for (word, pair) in words.iter_mut().zip(bytes.chunks_exact(2)) {
            word.copy_from_slice(pair);
        }
        let [interval, gx, gy, gz, rate, thrust, a, b, c, d] = words;
        let signed = |w: [u8; 2]| i16::from_le_bytes(w);
        let gyro = [signed(gx), signed(gy), signed(gz)];
        let throttle = [a, b, c, d].map(|w| f32::from(u16::from_le_bytes(w)) * Self::THROTTLE_LSB);
        Self {
            interval_us: u16::from_le_bytes(interval),
            gyro_radps: (!gyro.contains(&Self::MISSING)).then(|| gyro.map(|v| f32::from(v) * Self::RATE_LSB)),
            rate_radps: f32::from(signed(rate)) * Self::RATE_LSB,
            thrust_mps2: f32::from(u16::from_le_bytes(thrust)) * Self::THRUST_LSB,
            throttle,
        }
    }
}

//! The interface between host and vehicle: every message, in one place.
//!
//! | request | answer | when it is allowed |
//! |---|---|---|
//! | [`Request::Identify`] | [`Reply::Identity`] | always |
//! | [`Request::Status`] | [`Reply::Status`] | always |
//! | [`Request::Heartbeat`] | none | always; the host is there |
//! | [`Request::SetTelemetry`] | [`Reply::Done`] | always; the status stream's interval |
//! | [`Request::Stage`] | [`Reply::Staged`] | motors off; a chunk of a table |
//! | [`Request::CommitTable`] | [`Reply::Committed`] | motors off; checks the staged table whole, then replaces the old one |
//! | [`Request::ReadTable`] | [`Reply::Table`] | always; the committed bytes from an offset on |
//! | [`Request::ListTables`] | [`Reply::Tables`] | always; what is stored by name |
//! | [`Request::StoreTable`] | [`Reply::Done`], [`Reply::Pending`] | motors off; keeps the committed table by name |
//! | [`Request::LoadTable`] | [`Reply::Committed`] | motors off; checks a stored table and commits it |
//! | [`Request::DeleteTable`] | [`Reply::Done`], [`Reply::Pending`] | motors off |
//! | [`Request::ReadVehicle`], [`Request::ReadSettings`] | [`Reply::Vehicle`], [`Reply::Settings`] | always |
//! | [`Request::WriteVehicle`], [`Request::WriteSettings`], [`Request::Pair`] | [`Reply::Done`], [`Reply::Pending`] | motors off; checked, in force at once, kept in flash |
//! | [`Request::Calibrate`] | [`Reply::Done`] | disarmed; learns the gyro's bias anew |
//! | [`Request::CalibrateScale`] | [`Reply::Done`], [`Reply::Pending`] | disarmed; guided turns about one axis |
//! | [`Request::Arm`] | [`Reply::Done`] | disarmed and nothing blocks it |
//! | [`Request::Disarm`] | [`Reply::Done`] | always but when terminated; motors off |
//! | [`Request::EmergencyStop`] | [`Reply::Done`] | always; motors off until acknowledged |
//! | [`Request::Acknowledge`] | [`Reply::Done`] | motors off; that very incident |
//! | [`Request::Setpoint`] | none | acts when armed for flight; ignored otherwise |
//! | [`Request::Trigger`] | [`Reply::Done`] | tracking fresh setpoints inside the start gate with that very table committed |
//! | [`Request::TestMotor`] | [`Reply::Done`] | armed for a motor test |
//! | [`Request::Record`] | [`Reply::Done`] | tracking; a maneuver begins a record by itself |
//! | [`Request::ReadRecord`] | [`Reply::Record`] | not during a maneuver |
//! | [`Request::ReadEvents`] | [`Reply::Events`] | always |
//!
//! Besides answers the vehicle sends [`Telemetry`] every [`TELEMETRY_PERIOD_US`] without being asked. A request that
//! is not carried out is answered by [`Reply::Refused`] with a [`Refusal`], and changes nothing. [`Reply::Pending`] says
//! that it is under way: ask again under the same number. Requests say what shall be (“armed”), not what to do, so asking
//! twice is harmless; a trigger repeated under one number fires once. An answer carries its request's number.
//!
//! Each frame begins with [`PROTOCOL_VERSION`]; [`crate::framing`] turns messages into bytes, [`crate::seal`] seals them
//! where host and vehicle are paired. Byte layout is postcard's, fields in the order of declaration. SI units and radians
//! throughout.

mod clock;
mod event;
mod record;
mod refusal;
mod state;
mod telemetry;
mod uplink;

pub use clock::milliseconds;
pub use event::{EVENTS, EVENTS_PER_CHUNK, Event, EventChunk, Happening};
pub use record::{MAX_CHUNK_BYTES, RECORD_BYTES, RECORDS_PER_CHUNK, RecordChunk, RecordedTick, record_flags};
pub use refusal::{CalibrationError, Refusal};
pub use state::{AbortReason, ArmingBlock, FlightState, KillSwitch};
pub use telemetry::{BoardTelemetry, GyroFault, Incident, IncidentCause, TELEMETRY_PERIOD_US, Telemetry};

use heapless::{String, Vec};
use serde::{Deserialize, Serialize};

use crate::seal::PairingKey;
use crate::settings::Settings;
use crate::table::MAX_TABLE_BYTES;
use crate::vehicle::VehicleConfig;

/// Raised with every change of a message.
pub const PROTOCOL_VERSION: u8 = 4;
/// What may turn a motor is obeyed up to this age, ms: from when the vehicle said what the host heard last to when the request
/// arrives. Telemetry every 20 ms and bursts of 50 ms lost each way need 150.
pub const REQUEST_AGE_MS: u32 = 300;
/// Most bytes of a table in one chunk.
pub const STAGE_CHUNK_BYTES: usize = 128;
/// Tables that a vehicle stores by name.
pub const STORED_TABLES: usize = 8;

/// Name of a stored table: 1 to 16 bytes of UTF-8.
pub type TableName = String<16>;

/// Host to vehicle.
#[derive(Clone, Debug, PartialEq)]
pub struct Uplink {
    /// [`PROTOCOL_VERSION`] of the sender. A version that changes the requests it has in common with this one makes them
    /// unreadable; one that does not is told so.
    pub version: u8,
    /// Chosen by the host; the answer repeats it.
    pub number: u16,
    /// What is asked.
    pub request: Request,
    /// The vehicle's clock as the host heard it last, [`Telemetry::clock_ms`]; 0 where it has heard none. It tells how old the
    /// request is at most. On the line only where the request [is timed](Request::is_timed); elsewhere 0 is read.
    pub heard_ms: u32,
}

impl Uplink {
    /// Whether the request, if it is timed, is at most [`REQUEST_AGE_MS`] old at this time of the vehicle's clock, µs. One that
    /// claims to have heard what the vehicle has not said yet is not: it was meant for an earlier start.
    pub fn is_recent(&self, now_us: u64) -> bool {
        !self.request.is_timed() || milliseconds(now_us).wrapping_sub(self.heard_ms) <= REQUEST_AGE_MS
    }
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

/// What a vehicle is armed for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum Purpose {
    /// To fly: the motors idle, setpoints lift.
    #[default]
    Flight,
    /// To turn one motor after the other, propellers off: the motors stand until they are tested.
    MotorTest,
}

/// What a host asks.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Request {
    /// Who are you?
    Identify,
    /// How are you?
    Status,
    /// I am here.
    Heartbeat,
    /// Send telemetry this often.
    SetTelemetry {
        /// Interval, ms; 5 to 1000.
        period_ms: u16,
    },
    /// Hold these bytes for a commit.
    Stage {
        /// Bytes of the whole table.
        total: u16,
        /// Where these begin in it; 0 begins anew.
        offset: u16,
        /// The bytes.
        bytes: Vec<u8, STAGE_CHUNK_BYTES>,
    },
    /// Make the staged table the one to fly, if it is this one.
    CommitTable {
        /// Its checksum, [`crate::table::ManeuverTable::checksum`].
        checksum: u32,
    },
    /// Read the committed table back.
    ReadTable,
    /// What is stored?
    ListTables,
    /// Keep the committed table, if it is this one.
    StoreTable {
        /// Under this name; a table of the same name is replaced.
        name: TableName,
        /// Its checksum.
        checksum: u32,
    },
    /// Make a stored table the one to fly.
    LoadTable {
        /// Its name.
        name: TableName,
    },
    /// Forget a stored table.
    DeleteTable {
        /// Its name.
        name: TableName,
    },
    /// What are you?
    ReadVehicle,
    /// Be this vehicle.
    WriteVehicle(VehicleConfig),
    /// How are you set?
    ReadSettings,
    /// Be set so.
    WriteSettings(Settings),
    /// From now on take only what is sealed with this key; `None` takes everything again.
    Pair(Option<PairingKey>),
    /// Learn the gyro's bias anew.
    Calibrate,
    /// Learn the gyro's scale from whole turns by hand.
    CalibrateScale {
        /// Body axis: 0 forward, 1 left, 2 up.
        axis: u8,
        /// Whole turns, right-handed about the axis; 0 gives up.
        turns: i8,
    },
    /// Be armed: motors turn at idle.
    Arm(Purpose),
    /// Be disarmed: motors off.
    Disarm,
    /// Motors off now, whatever happens, until acknowledged.
    EmergencyStop,
    /// I have read of this incident.
    Acknowledge {
        /// Its number.
        incident: u16,
    },
    /// Fly these body rates and this thrust until the next setpoint.
    Setpoint {
        /// Grows by one with each; one that is not newer than the last is dropped.
        sequence: u16,
        /// What to fly.
        setpoint: Setpoint,
    },
    /// Fly the committed table, if it is this one, from the next tick.
    Trigger {
        /// Its checksum.
        checksum: u32,
    },
    /// Turn one motor, the others stand.
    TestMotor {
        /// Rotor, 0..3 in the order of [`crate::frames::MOTORS`].
        motor: u8,
        /// Throttle, 0..[`MOTOR_TEST_THROTTLE_MAX`].
        throttle: f32,
        /// For this long, ms; at most [`MOTOR_TEST_MS_MAX`].
        duration_ms: u16,
    },
    /// Record from now on until the memory is full.
    Record,
    /// Send recorded ticks from this index on.
    ReadRecord {
        /// Index of the first tick wanted.
        first: u32,
    },
    /// Send events from this number on.
    ReadEvents {
        /// Number of the first event wanted.
        first: u32,
    },
}

impl Request {
    /// Whether it may bring about that a motor turns, or goes on turning: then the vehicle wants to know how old it is.
    pub fn is_timed(&self) -> bool {
        matches!(
            self,
            Self::Heartbeat
                | Self::Arm(_)
                | Self::Setpoint { .. }
                | Self::Trigger { .. }
                | Self::TestMotor { .. }
        )
    }
}

/// Highest throttle of a motor test.
pub const MOTOR_TEST_THROTTLE_MAX: f32 = 0.15;
/// Longest motor test, ms.
pub const MOTOR_TEST_MS_MAX: u16 = 2000;

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
        /// Bytes held so far, from the table's beginning on.
        length: u16,
    },
    /// The table is the one to fly now.
    Committed {
        /// Its checksum.
        checksum: u32,
        /// Its duration, s.
        duration_s: f32,
    },
    /// The committed bytes; empty where there are none.
    Table(Vec<u8, MAX_TABLE_BYTES>),
    /// What is stored.
    Tables(Vec<StoredTable, STORED_TABLES>),
    /// To `ReadVehicle`; `None` where it does not know.
    Vehicle(Option<VehicleConfig>),
    /// To `ReadSettings`.
    Settings(Settings),
    /// Recorded ticks.
    Record(RecordChunk),
    /// Events.
    Events(EventChunk),
    /// It is so.
    Done,
    /// It is under way: ask again.
    Pending,
    /// It was not done, and nothing has changed.
    Refused(Refusal),
}

/// A stored table.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct StoredTable {
    /// Its name.
    pub name: TableName,
    /// Its checksum.
    pub checksum: u32,
    /// Its duration, s.
    pub duration_s: f32,
}

/// Who a vehicle is.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Identity {
    /// Firmware version: major, minor, patch.
    pub firmware_version: [u8; 3],
    /// Layout of tables it takes, [`crate::table::SCHEMA_HASH`].
    pub table_schema: u32,
    /// Hash of its vehicle file; 0 where it knows none.
    pub vehicle: u32,
    /// New with every start: what seals are made for.
    pub session: u32,
    /// Whether requests must be sealed. `Identify` itself need not.
    pub paired: bool,
    /// Counter of the last seal that was taken in this session; 0 where there was none. The next one must be above it.
    pub last_counter: u32,
    /// [`crate::seal::vouch`] for it, where there is a key: no stranger can make a host use its counters up.
    pub last_counter_mac: u64,
    /// Lowest thrust per mass that a table may ask for, m/s².
    pub thrust_min_mps2: f32,
    /// Highest thrust per mass that a table may ask for, m/s².
    pub thrust_max_mps2: f32,
    /// Highest body rate that a table may ask for, rad/s.
    pub rate_max_radps: f32,
}

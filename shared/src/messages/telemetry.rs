//! What a vehicle says of itself.

use serde::{Deserialize, Serialize};

use super::{AbortReason, FlightState, KillSwitch};

/// Telemetry interval unless the host asks for another, µs.
pub const TELEMETRY_PERIOD_US: u64 = 20_000;

/// How a vehicle is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Telemetry {
    /// The vehicle's clock, µs.
    pub time_us: u64,
    /// What the supervisor is doing.
    pub state: FlightState,
    /// What blocks arming: bits of [`super::ArmingBlock`].
    pub arming_block: u32,
    /// The last abort since arming.
    pub abort: Option<AbortReason>,
    /// What waits to be acknowledged, if anything does.
    pub incident: Option<Incident>,
    /// The kill switch.
    pub kill: KillSwitch,
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
    /// World-up in body axes as the vehicle's own attitude estimate has it: [0, 0, 1] is level.
    pub up_body: [f32; 3],
    /// Control ticks since power-up.
    pub ticks: u32,
    /// Ticks that came more than half a period late, since power-up.
    pub late_ticks: u32,
    /// Ticks without a gyro sample, since power-up.
    pub missing_samples: u32,
    /// Longest interval between two ticks since arming, µs.
    pub worst_interval_us: u32,
    /// Received frames that were not messages, or not sealed as they must be.
    pub link_errors: u32,
    /// Setpoints that never came or came too late, by their sequence numbers, since arming.
    pub setpoints_lost: u32,
    /// Ticks in the recorder.
    pub recorded: u32,
    /// Number of the newest event; events are numbered from 1.
    pub events: u32,
    /// What the board measures of itself; `None` where the flight logic runs on no board.
    pub board: Option<BoardTelemetry>,
}

impl Telemetry {
    /// The vehicle's clock as [`super::Uplink::heard_ms`] tells it back.
    pub fn clock_ms(&self) -> u32 {
        super::milliseconds(self.time_us)
    }
}

/// Something that a person must know of before the motors turn again.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Incident {
    /// Its name for [`super::Request::Acknowledge`]; grows with each.
    pub number: u16,
    /// What it was.
    pub cause: IncidentCause,
}

/// What happened.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, thiserror::Error)]
pub enum IncidentCause {
    /// The supervisor stopped the motors for good.
    #[error("terminated: {0}")]
    Terminated(AbortReason),
    /// The last run ended in a panic; line of the source.
    #[error("the firmware panicked at line {0}: please report it")]
    Panic(u32),
    /// The processor met something it cannot do; program counter and fault status (CFSR).
    #[error("hard fault at {pc:#010x}, CFSR {cfsr:#010x}: please report it")]
    HardFault {
        /// Address of the instruction.
        pc: u32,
        /// Configurable fault status register.
        cfsr: u32,
    },
    /// The stack ran over.
    #[error("stack overflow: please report it")]
    StackOverflow,
    /// The crystal stopped.
    #[error("the crystal stopped: do not fly this flight controller")]
    ClockLost,
    /// An interrupt nobody handles; its number.
    #[error("unexpected interrupt {0}: please report it")]
    UnexpectedInterrupt(u32),
    /// A peripheral refused its set-up, or to work on; which one.
    #[error("a peripheral refused its set-up, or to work on (step {0}): please report it")]
    SetUp(u32),
    /// The supply fell.
    #[error("the supply fell (brown-out): check battery, wiring and regulator")]
    BrownOut,
    /// The watchdog fired.
    #[error("the watchdog reset the flight controller: a part of the firmware stood still")]
    Watchdog,
    /// What is stored in flash could not be read.
    #[error(
        "the store in flash was damaged and has been formatted: upload vehicle, settings and tables again"
    )]
    StoreDamaged,
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
    /// Periods in which data-ready edges came too soon after the one before, since power-up.
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

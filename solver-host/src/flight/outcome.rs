//! What a flight is given, what it brings back, and why it may not take place.

use mintime_shared::messages::{
    AbortReason, BoardTelemetry, FlightState, Identity, RecordedTick, Refusal, Setpoint,
};
use mintime_shared::table::{ManeuverTable, TableError};
use mintime_shared::vehicle::VehicleConfig;
use nalgebra::Vector3;

use super::client::ClientError;
use super::connection::{ConnectionError, Phase, Pose, describe};

/// What to fly and where.
#[derive(Clone, Debug)]
pub struct FlightPlan {
    /// The table to upload.
    pub table: ManeuverTable,
    /// Where the maneuver starts, world frame, m.
    pub start_m: Vector3<f64>,
    /// What the vehicle is, to be told where it does not know; `None` for a real one, which nobody but a person tells.
    pub vehicle: Option<VehicleConfig>,
    /// Heading of the plane in which the maneuver is to end, rad.
    pub heading_rad: f64,
}

impl FlightPlan {
    /// A maneuver in the plane that its table names.
    pub fn new(table: ManeuverTable, start_m: Vector3<f64>, vehicle: Option<VehicleConfig>) -> Self {
        let heading_rad = f64::from(table.heading_rad);
        Self { table, start_m, vehicle, heading_rad }
    }

    /// The same, to end in the plane of another heading, rad: a learned table's own makes up for an askew gyro.
    #[must_use]
    pub fn along(self, heading_rad: f64) -> Self {
        Self { heading_rad, ..self }
    }

    /// Where the maneuver should end, world frame, m.
    pub fn end_m(&self) -> Vector3<f64> {
        let (start, end) = (self.table.start, self.table.end);
        let along = f64::from(end.x - start.x);
        let heading = self.heading_rad;
        self.start_m + Vector3::new(along * heading.cos(), along * heading.sin(), f64::from(end.z - start.z))
    }
}

/// Why a flight did not take place or was not seen to its end.
#[derive(Debug, thiserror::Error)]
pub enum FlightError {
    /// The vehicle refused, or did not answer.
    #[error("{during}: {source}")]
    Client {
        /// What was being done.
        during: &'static str,
        /// What came back.
        source: ClientError,
    },
    /// Line or cameras failed.
    #[error(transparent)]
    Connection(#[from] ConnectionError),
    /// The table does not suit the vehicle.
    #[error("{0}")]
    Table(#[from] TableError),
    /// The table read back is not the one sent.
    #[error("the table read back from the vehicle differs from the one sent: try again, check the line")]
    ReadBack,
    /// The vehicle is not ready to arm.
    #[error("the vehicle does not become ready: {0}")]
    NotReady(Refusal),
    /// The vehicle left the expected state.
    #[error("the vehicle is {} instead of {during}{}", describe(*.state), .reason.map(|r| format!(": {r}")).unwrap_or_default())]
    Lost {
        /// What it should have been doing.
        during: &'static str,
        /// What it is doing.
        state: FlightState,
        /// Why, as it says.
        reason: Option<AbortReason>,
    },
}

/// How a flight went.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// The maneuver was flown to its end and the vehicle caught.
    Completed,
    /// The vehicle broke the maneuver off.
    Aborted,
    /// The gate never opened, or the vehicle refused the trigger; it was landed.
    NotTriggered,
    /// The maneuver was flown to its end but the vehicle was not caught.
    NotCaught,
}

impl Outcome {
    /// One word.
    pub fn name(self) -> &'static str {
        match self {
            Self::Completed => "completed",
            Self::Aborted => "aborted",
            Self::NotTriggered => "not-triggered",
            Self::NotCaught => "not-caught",
        }
    }
}

/// What a flight brought back.
#[derive(Clone, Debug)]
pub struct FlightResult {
    /// How it went.
    pub outcome: Outcome,
    /// Why it went otherwise than planned, in words.
    pub reason: Option<String>,
    /// Who flew.
    pub identity: Identity,
    /// Duration flown, s: T if the maneuver ran to its end.
    pub flown_duration_s: f64,
    /// The vehicle's record: the first of its ticks, as many as its memory holds.
    pub record: Vec<RecordedTick>,
    /// Control ticks of the maneuver.
    pub ticks: u32,
    /// Ticks that are missing between them by the vehicle's clock.
    pub missed_ticks: u32,
    /// What the board said of itself last; `None` where the flight logic runs on no board.
    pub board: Option<BoardTelemetry>,
}

/// What the host saw at one pose, and what it said to it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sight {
    /// The pose; its attitude levelled once the vehicle is in the air.
    pub pose: Pose,
    /// Where the flight is.
    pub phase: Phase,
    /// The setpoint that was sent when it arrived; `None` while the vehicle stands.
    pub setpoint: Option<Setpoint>,
    /// Since when the vehicle replays, s on the clock of the poses; `None` where it does not.
    pub maneuver_since_s: Option<f64>,
    /// The battery's voltage as the newest telemetry has it, V.
    pub battery_v: Option<f32>,
    /// Telemetry messages so far: another number means that the voltage is new.
    pub telemetry_count: u64,
}

/// Told about the flight as it goes.
pub trait Witness {
    /// A new phase began at this time, s.
    fn phase(&mut self, phase: Phase, now_s: f64);
    /// Something worth a line.
    fn event(&mut self, now_s: f64, text: &str);
    /// A pose came and was answered.
    fn saw(&mut self, _sight: &Sight) {}
}

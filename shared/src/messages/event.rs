//! The event log: what happened, in order, in a ring of [`EVENTS`].

use heapless::Vec;
use serde::{Deserialize, Serialize};

use super::{AbortReason, FlightState, IncidentCause, Refusal};

/// Events that a vehicle remembers.
pub const EVENTS: usize = 64;
/// Events in one answer.
pub const EVENTS_PER_CHUNK: usize = 12;

/// One event.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Event {
    /// The vehicle's clock, ms.
    pub time_ms: u32,
    /// What happened.
    pub what: Happening,
}

/// What happened.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum Happening {
    /// The vehicle was switched on, or reset.
    Started,
    /// An incident came up.
    Incident(IncidentCause),
    /// It was acknowledged.
    Acknowledged(u16),
    /// The supervisor went here.
    Entered(FlightState),
    /// For this reason.
    Aborted(AbortReason),
    /// A request was refused.
    Refused(Refusal),
    /// A table was committed.
    Committed(u32),
    /// Something was written to flash.
    Stored,
    /// The gyro's bias was learned anew.
    Calibrated,
}

/// A run of events.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct EventChunk {
    /// Number of the first event here; older ones are forgotten.
    pub first: u32,
    /// Number of the newest event there is; 0 for none.
    pub newest: u32,
    /// The events in order.
    pub events: Vec<Event, EVENTS_PER_CHUNK>,
}

//! Learning from flight to flight: what the end of one flight corrects in the table of the next.

mod history;

pub use history::{
    ANGLE_TOLERANCE_RAD, FlightEntry, HISTORY_FILE, History, HistoryError, IdentifiedResponse,
    POSITION_TOLERANCE_M, StateError, TABLE_FILE, VELOCITY_TOLERANCE_MPS, check_folder,
};

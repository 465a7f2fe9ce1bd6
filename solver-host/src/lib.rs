//! solver
pub mod flight_log;
pub mod report;

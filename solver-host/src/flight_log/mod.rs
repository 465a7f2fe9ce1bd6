//! The flight log: what was planned, what was flown and what the vehicle recorded, as plain data and as an MCAP file.
//!
//! The data types are filled by whoever flies; [`write_mcap`] turns them into a file that Foxglove and every other
//! MCAP reader opens without a plug-in: messages are JSON with JSON schemas. All times are virtual: nanoseconds from
//! the start of the flight. No wall clock is read, so the same data gives the same bytes.
//!
//! | topic | schema | message |
//! |---|---|---|
//! | `/tf` | `foxglove.FrameTransform` | true pose of the body (frame `vehicle`) in the frame `world` |
//! | `/truth` | `mintime.Truth` | phase, true motion in space and in the plane |
//! | `/mocap` | `foxglove.PoseInFrame` | what motion capture measured |
//! | `/gyro` | `mintime.BodyRates` | what the vehicle's gyro delivered |
//! | `/setpoint` | `mintime.Setpoint` | body rates and thrust that the rate controller was asked for |
//! | `/motors` | `mintime.Motors` | the four throttles, motors 1 to 4 |
//! | `/battery` | `mintime.Battery` | voltage |
//! | `/plan` | `mintime.Plan` | the planned maneuver, relative to its start, at the time it was flown |
//! | `/record` | `mintime.Record` | the vehicle's own record, downloaded after the flight |
//! | `/events` | `foxglove.Log` | what happened, in words |
//!
//! The header is the metadata record `mintime`; the raw maneuver table is the attachment `maneuver-table.bin`.
//! Numbers that are not finite are written as JSON `null`.

mod data;
mod messages;
mod output;
mod schemas;
mod write;

pub use data::{
    EventLevel, FlightLog, FlightSample, LogEvent, LogHeader, MocapSample, PlannedSample, RecordSample, Truth,
};
pub use output::{OutputError, check_writable, write_whole};
pub use write::{HEADING, LogError, METADATA, TABLE_ATTACHMENT, write_mcap};

#[cfg(test)]
mod tests;

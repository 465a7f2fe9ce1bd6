//! Minimum-time quadrotor maneuvers: computed, verified against the minimum principle, packed into a table, uploaded
//! and flown.
//!
//! ```text
//! request ─→ solver ─→ verified extremal ─→ pack ─→ table ─→ flight: upload, hover, trigger, catch, land, download
//!                                                                │
//!                                        mission (truth against plan) ─→ flight_log, report
//! ```

pub mod flight;
pub mod flight_log;
pub mod mission;
pub mod pack;
pub mod report;
pub mod solver;

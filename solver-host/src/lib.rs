//! Minimum-time quadrotor maneuvers: computed, verified against the minimum principle, packed into a table, uploaded
//! and flown.

pub mod flight;
pub mod flight_log;
pub mod mission;
pub mod pack;
pub mod report;
pub mod solver;

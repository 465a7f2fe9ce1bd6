//! Minimum-time quadrotor maneuvers: computed, verified against the minimum principle, packed into a table, uploaded
//! and flown.
//!
//! ```text
//! request ─→ solver ─→ verified extremal ─→ pack ─→ table ─→ flight: upload, hover, trigger, catch, land, download
//!                                                                │
//!                                        mission (truth against plan) ─→ flight_log, report, page
//!                                        learning (cameras against plan) ─→ the next table
//! ```
//!
//! Without the feature `std` only [`solver`] and [`pack`] are left, for targets with no operating system.
#![cfg_attr(not(feature = "std"), no_std)]

#[cfg(feature = "std")]
pub mod benchmark;
#[cfg(feature = "std")]
pub mod design;
#[cfg(feature = "std")]
pub mod drawing;
#[cfg(feature = "std")]
pub mod figures;
#[cfg(feature = "std")]
pub mod firmware_image;
#[cfg(feature = "std")]
pub mod flight;
#[cfg(feature = "std")]
pub mod flight_log;
#[cfg(feature = "std")]
pub mod identification;
#[cfg(feature = "std")]
pub mod learning;
#[cfg(feature = "std")]
pub mod mission;
#[cfg(feature = "std")]
pub mod motion_capture;
pub mod pack;
#[cfg(feature = "std")]
pub mod page;
#[cfg(feature = "std")]
pub mod parallel;
#[cfg(feature = "std")]
pub mod port;
#[cfg(feature = "std")]
pub mod report;
pub mod solver;
#[cfg(feature = "std")]
pub mod vehicle;

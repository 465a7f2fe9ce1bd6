//! The flight logic of mintime: no hardware, no allocation, no panic, tested on the host.
//!
//! Sensor samples and requests go in once a tick, throttles and messages come out: [`flight`]. The board binary of
//! this package adds clocks, pins and interrupts around it.
//!
//! ```text
//! serial bytes ─→ link ─→ inbox ─┐                                 ┌─→ outbox ─→ link ─→ serial bytes
//!                                ├─→ requests ─→ supervisor        │
//! gyro sample ──→ gyro ──────────┤        (states, transitions) ───┤
//! battery, kill switch ──────────┘                │                └─→ recorder
//!                                       player / host setpoint
//!                                                 ↓
//!                                rate control ─→ mixer ─→ rotor drive ─→ throttles
//! ```
#![no_std]
#![cfg_attr(
    not(test),
    deny(clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::indexing_slicing)
)]

pub mod attitude;
pub mod bmi270;
pub mod calibration;
mod conditions;
pub mod config;
pub mod dshot;
mod entering;
mod events;
pub mod flight;
pub mod gyro;
mod incidents;
pub mod keeping;
pub mod link;
pub mod low_pass;
mod memory;
pub mod mixer;
pub mod pacing;
pub mod player;
pub mod rate_control;
pub mod receiver;
pub mod recorder;
mod recovery;
mod requests;
mod sensing;
mod steering;
pub mod store;
pub mod supervisor;
mod tables;
pub mod vehicle;
pub mod watch;

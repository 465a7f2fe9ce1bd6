//! What a mintime host and a mintime vehicle must agree on, and nothing else.
#![no_std]
#![cfg_attr(
    not(test),
    deny(clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::indexing_slicing)
)]

#[cfg(test)]
extern crate std;

mod checksum;
pub mod frames;
pub mod framing;
pub mod messages;
pub mod minimum_principle;
pub mod model;
pub mod motion;
pub mod plane;
pub mod real;
pub mod replay;
pub mod seal;
pub mod settings;
mod stuffing;
pub mod table;
pub mod vehicle;

pub use checksum::crc32;

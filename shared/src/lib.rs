//! What a mintime host and a mintime vehicle must agree on, and nothing else.
#![no_std]
#![cfg_attr(not(test), deny(clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::indexing_slicing))]

#[cfg(test)]
extern crate std;

pub mod frames;
pub mod minimum_principle;
pub mod model;
pub mod motion;
pub mod real;

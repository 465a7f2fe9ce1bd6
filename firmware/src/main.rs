//! The board binary: starts the STM32F405, keeps the control tick, the serial link and the watchdog going, and leaves
//! every decision to the flight logic in the library.
//!
//! # Deadlines
//!
//! | what | every | must finish within | bounded by | when missed |
//! |---|---|---|---|---|
//! | control tick | 1250 µs | 1250 µs | the flight logic is one bounded function; link work per tick is capped in bytes | counted, later ticks keep their times |
//! | received bytes leave the DMA ring | ≤ 2 ms | 11 ms | ring of 1024 bytes at 92 bytes a millisecond | overrun counted, the damaged frame is dropped by its checksum |
//! | one burst on the wire | – | 20 ms | 256 bytes take 2.8 ms | burst given up, counted |
//! | supervision: check-ins, battery, LED | 20 ms | 64 ms | no waits inside | the watchdog resets the board |
//! | start-up, clocks included | once | 349 ms | – | the watchdog resets the board |
//!
//! The watchdog times are for the fastest internal oscillator the data sheet allows (47 kHz); see `board::watchdog`.
//!
//! # What runs where
//!
//! `board::facts` lists the interrupt priorities. The control tick runs in an interrupt of its own above the link,
//! so an upload cannot delay it by more than one critical section (a copy of at most 128 bytes). It alone owns the
//! vehicle; bytes travel to and from it through two pipes, so nothing else is shared but counters.
#![cfg_attr(target_os = "none", no_std, no_main)]
#![deny(clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::indexing_slicing)]

#[cfg(target_os = "none")]
mod board;

#[cfg(not(target_os = "none"))]
fn main() {
    println!("This is the firmware of a flight controller; on a computer it does nothing.");
    println!("Build it for the board with: cargo firmware");
    println!("Build it and load it through a debug probe with: cargo flash");
}

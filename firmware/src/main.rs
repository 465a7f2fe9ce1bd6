//! The board binary: starts the STM32F405, keeps the control tick, the serial link and the watchdog going, and leaves
//! every decision to the flight logic in the library.
//!
//! # Deadlines
//!
//! | what | every | must finish within | bounded by | when missed |
//! |---|---|---|---|---|
//! | motors' frame is ready after the gyro's edge | 1250 µs | 72 µs | one burst of 14 bytes, the part of the flight logic that the motors wait for; no wait without a bound | sent at once, counted among the motor errors |
//! | gyro's edge to the end of the motors' frame | 1250 µs | 100 µs | begins 72 µs after the edge by a timer, lasts 27 | measured and reported |
//! | control tick | 1250 µs | 1250 µs | the flight logic is one bounded function; link work per tick is capped in bytes | counted, later ticks keep their times |
//! | no edge from the gyro | – | 1875 µs | a timer | the flight logic runs without a sample |
//! | motors' frame is finished | 1250 µs | the next tick | a DMA stream and its interrupt | counted, timer and stream reset; eight in a row with the motors on end the run |
//! | received bytes leave the DMA ring | 1.25 ms | 11 ms | the control tick takes 128 bytes, a little more than the line brings | the damaged frames are dropped by their checksum |
//! | one burst on the wire | – | 10 ms | 256 bytes take 2.8 ms | burst given up, counted |
//! | supervision: check-ins, battery, LED | 20 ms | 64 ms | no waits inside | the watchdog resets the board |
//! | start-up, clocks included | once | 349 ms | – | the watchdog resets the board |
//! | set-up of the gyro, a try | once | 300 ms | each step has its own bound; beside everything else | tried again, four times; then arming is refused and telemetry says why |
//!
//! The watchdog times are for the fastest internal oscillator the data sheet allows (47 kHz); see `board::watchdog`.
//!
//! # What runs where
//!
//! `board::facts` lists the interrupt priorities. The control tick runs in an interrupt of its own above the link,
//! so an upload cannot delay it by more than one critical section (a copy of at most 256 bytes, or one line into the
//! debug log). It alone owns the vehicle, gyro and motors; it takes received bytes from a ring that DMA
//! fills and gives bytes to be sent to a pipe, so nothing else is shared but counters. Two handlers outrank it, and
//! critical sections too: one stamps the gyro's edge, pends the tick and closes the line until the next edge may come, one
//! stops the motors' timer at the end of a frame.
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

//! The commands of `mintime`: arguments in, text or JSON out.

mod fly;
mod numbers;
mod progress;
mod recording;
mod summary;

use std::process::ExitCode;

use clap::Subcommand;

/// What to do.
#[derive(Subcommand)]
pub(crate) enum Command {
    /// Compute a minimum-time maneuver and fly it, from hover to hover.
    ///
    /// The maneuver goes from rest to rest at level attitude. It is verified against Pontryagin's minimum principle before
    /// anything is sent to a vehicle; then it is uploaded, the vehicle hovers, flies it with gyro feedback only, is caught
    /// and landed, and its record is downloaded and compared with truth. The exit status is 0 only if it was flown to its
    /// end and the vehicle caught.
    Fly(fly::Fly),
}

impl Command {
    pub(crate) fn run(self) -> ExitCode {
        match self {
            Self::Fly(fly) => fly.run(),
        }
    }
}

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
    Fly(fly::Fly),
}

impl Command {
    pub(crate) fn run(self) -> ExitCode {
        match self {
            Self::Fly(fly) => fly.run(),
        }
    }
}

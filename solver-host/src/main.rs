//! The `mintime` command.

mod commands;

use std::process::ExitCode;

use clap::Parser;

/// Minimum-time quadrotor maneuvers: computed, verified against Pontryagin's minimum principle, packed into a table of
/// switching times, uploaded to a flight controller and flown.
///
/// All numbers are SI units and radians: m, m/s, m/s², rad/s, s. x points along the maneuver's plane, z up.
#[derive(Parser)]
#[command(name = "mintime", version, arg_required_else_help = true)]
struct Arguments {
    #[command(subcommand)]
    command: commands::Command,
}

fn main() -> ExitCode {
    outlive_file_limits();
    Arguments::parse().command.run()
}

/// A file that may not grow is told in a sentence, as a full disk is. The signal's default would end the program, in flight perhaps.
fn outlive_file_limits() {
    #[cfg(unix)]
    {
        let seen = std::sync::Arc::new(std::sync::atomic::AtomicBool::new(false));
        // Where that is not allowed the default stays.
        let _ = signal_hook::flag::register(signal_hook::consts::SIGXFSZ, seen);
    }
}

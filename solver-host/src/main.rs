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
    Arguments::parse().command.run()
}

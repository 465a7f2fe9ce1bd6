//! The commands of `mintime`: arguments in, text or JSON out.

mod answer;
mod batch;
mod benchmark;
mod design;
#[cfg(test)]
mod documented;
mod explain;
mod figures;
mod fly;
mod keyboard;
mod learn;
mod learn_statistics;
mod limits;
mod live;
mod numbers;
mod progress;
mod recording;
mod seen;
mod solve;
mod stop;
mod summary;
mod sweep;
mod table;
mod vehicle;
mod virtual_board;

use std::process::ExitCode;

use clap::Subcommand;

/// What to do.
#[derive(Subcommand)]
pub(crate) enum Command {
    /// Measure a flight, or a controller, against the fastest maneuver between the same two states: T / T*.
    ///
    /// The log is an MCAP of `mintime fly`, or a CSV with the columns t_s, x_m, z_m and theta_rad; velocities, y and a
    /// quaternion are read if they are there (docs/benchmarking.md).
    Benchmark(Box<benchmark::Benchmark>),
    /// Study how T depends on greatest and least thrust and on the body rate, and which of them buys the most.
    Design(design::Design),
    /// Draw the paper's figures again, corrected, and the map T(x, z): SVG, PNG and CSV.
    Figures(figures::Figures),
    /// Compute a minimum-time maneuver and fly it, from hover to hover.
    ///
    /// The maneuver goes from rest to rest at level attitude. It is verified against Pontryagin's minimum principle before
    /// anything is sent to a vehicle; then it is uploaded, the vehicle hovers, flies it with gyro feedback only, is caught
    /// and landed, and its record is downloaded and compared with truth. The exit status is 0 only if it was flown to its
    /// end and the vehicle caught.
    Fly(fly::Fly),
    /// Fly a maneuver again and again, and correct it by where each flight ended.
    ///
    /// Identifies the vehicle's thrust in hover, plans with it, and flies. What motion capture sees at the end of a flight
    /// corrects the durations and the arcs of the next table, until two flights in a row end where they should. Then what
    /// was learned is flown a few times more. The history and the best table are kept after every flight. The exit status
    /// is 0 only if it was learned.
    Learn(learn::Learn),
    /// Learn the paper's maneuvers on many simulated vehicles, and tell how well that works.
    LearnStatistics(learn_statistics::LearnStatistics),
    /// Compute the minimum-time maneuver between two states, or many of them.
    ///
    /// Any start and end state, any limits. Every answer is verified against Pontryagin's minimum principle by an
    /// integrator of its own; what cannot be verified is not returned.
    Solve(solve::Solve),
    /// Compute maneuvers over a range of displacements, as CSV.
    Sweep(sweep::Sweep),
    /// Explain a maneuver table.
    Show(table::TableFile),
    /// Stop a vehicle's motors now, whatever it is doing.
    ///
    /// Sends emergency stops until the vehicle confirms one. The exit status is 0 only then.
    Stop(stop::Stop),
    /// Talk to a vehicle on the bench: identity, parameters, tables, calibration, motor test, record, events; or identify it in flight.
    Vehicle(vehicle::Vehicle),
    /// Run the firmware image on an emulated flight controller behind a serial port, in real time.
    ///
    /// The airframe stands on the ground and obeys its motors. Any program that speaks the protocol (docs/protocol.md) can
    /// talk to it through the pseudo-terminal whose name is printed.
    VirtualBoard(virtual_board::VirtualBoard),
    /// Check a maneuver table again: it must arrive when replayed, and be the fastest for its turns.
    Verify(table::TableFile),
}

impl Command {
    pub(crate) fn run(self) -> ExitCode {
        match self {
            Self::Benchmark(benchmark) => benchmark.run(),
            Self::Design(design) => design.run(),
            Self::Figures(figures) => figures.run(),
            Self::Fly(fly) => fly.run(),
            Self::Learn(learn) => learn.run(),
            Self::LearnStatistics(statistics) => statistics.run(),
            Self::Solve(solve) => solve.run(),
            Self::Sweep(sweep) => sweep.run(),
            Self::Show(file) => file.show(),
            Self::Stop(stop) => stop.run(),
            Self::Vehicle(vehicle) => vehicle.run(),
            Self::Verify(file) => file.verify(),
            Self::VirtualBoard(board) => board.run(),
        }
    }
}

/// Prints a line. Whoever closed the pipe has read enough: that is no error. A full disk is, and ends the command.
fn print(text: &str) {
    use std::io::Write as _;
    let mut out = std::io::stdout().lock();
    let written =
        out.write_all(text.as_bytes()).and_then(|()| out.write_all(b"\n")).and_then(|()| out.flush());
    if let Err(error) = written
        && error.kind() != std::io::ErrorKind::BrokenPipe
    {
        eprintln!("mintime: the output could not be written ({error})");
        std::process::exit(1);
    }
}

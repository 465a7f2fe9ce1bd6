//! `mintime vehicle PORT …`: a vehicle on the bench.

mod calibrate;
mod identify;
mod keep;
mod motors;
mod record;
mod status;

use std::error::Error;
use std::path::PathBuf;
use std::process::ExitCode;

use clap::{Args, Subcommand};
use mintime::vehicle::{PortLink, Session, read_key};
use serde_json::{Value, json};

use super::print;

/// What a port is called.
pub(crate) const PORT_HELP: &str = "Where the vehicle is: a serial device (/dev/ttyUSB0, COM3; add ?baud=NUMBER for other \
                                    than 921600), tcp:HOST:PORT or udp:HOST:PORT";

/// Arguments of `mintime vehicle`.
#[derive(Args)]
#[command(
    after_help = "Examples:\n  mintime vehicle /dev/ttyUSB0 identity\n  mintime vehicle /dev/ttyUSB0 params --file quad.json\n  \
                  mintime vehicle tcp:192.168.4.1:5760 status --json\n\nOnly `identify` makes a \
                  vehicle fly. Only it and `test-motors` turn motors; take the propellers off for the latter."
)]
pub(crate) struct Vehicle {
    #[arg(help = PORT_HELP)]
    port: String,
    /// The pairing key, where the vehicle is paired: a file with 32 hexadecimal digits
    #[arg(long, value_name = "FILE", global = true)]
    key: Option<PathBuf>,
    /// Print JSON instead of text
    #[arg(long, global = true)]
    json: bool,
    #[command(subcommand)]
    action: Action,
}

/// What to do with it.
#[derive(Subcommand)]
enum Action {
    /// Who it is: firmware, protocol, vehicle file, limits
    Identity,
    /// Find out in flight what it is: thrust, rotor lag, battery sag, by hovering and hopping. It flies!
    Identify(Box<identify::Identify>),
    /// How it is: state, what blocks arming, battery, rates, errors
    Status,
    /// Read or write the vehicle file (mass, motors, battery, limits), or with --settings the flight controller's settings
    Params(keep::Params),
    /// Upload a maneuver table, check it on the vehicle and read it back
    Upload(keep::Upload),
    /// List, store, load and delete the tables that the vehicle keeps by name
    Tables(keep::Tables),
    /// Calibrate the gyro: its bias at rest, or its scale by whole turns by hand
    Calibrate(calibrate::Calibrate),
    /// Turn one motor after the other, slowly, to check order and direction. Propellers off!
    TestMotors(motors::TestMotors),
    /// Download the last flight record
    Record(record::Record),
    /// What happened since power-up, in order
    Events,
    /// Measure the link (round trip, loss) and the board (latency, jitter, load)
    Measure(status::Measure),
    /// Pair host and vehicle, so that the vehicle obeys nobody else, or undo it
    Pair(keep::Pair),
    /// Confirm that you have read of the incident that `status` shows; only then can the vehicle be armed again
    Acknowledge,
}

/// What a command has to say: as JSON, and as text.
type Said = Result<(Value, String), Box<dyn Error>>;

/// A session over a port.
type Bench = Session<PortLink>;

impl Vehicle {
    pub(crate) fn run(&self) -> ExitCode {
        report(self.json, self.act())
    }

    fn act(&self) -> Said {
        if let Action::Identify(identify) = &self.action {
            return identify.run(&self.port, self.key.as_deref());
        }
        let mut bench = open(&self.port, self.key.as_deref())?;
        let bench = &mut bench;
        match &self.action {
            // It has seen to its port itself.
            Action::Identity | Action::Identify(_) => status::identity(bench),
            Action::Status => status::status(bench),
            Action::Params(params) => params.run(bench),
            Action::Upload(upload) => upload.run(bench),
            Action::Tables(tables) => tables.run(bench),
            Action::Calibrate(calibrate) => calibrate.run(bench),
            Action::TestMotors(motors) => motors.run(bench),
            Action::Record(record) => record.run(bench),
            Action::Events => record::events(bench),
            Action::Measure(measure) => measure.run(bench),
            Action::Pair(pair) => pair.run(bench),
            Action::Acknowledge => status::acknowledge(bench),
        }
    }
}

/// Opens the port and asks who is there.
fn open(port: &str, key: Option<&std::path::Path>) -> Result<Bench, Box<dyn Error>> {
    let key = key.map(read_key).transpose()?;
    Ok(Session::begin(PortLink::open(port)?, key)?)
}

/// As JSON by way of text: what is kept in 32 bits has its few digits there, and not those of its 64-bit neighbour.
fn to_json(value: &impl serde::Serialize) -> Result<Value, serde_json::Error> {
    serde_json::from_str(&serde_json::to_string(value)?)
}

/// Prints an answer or an error, and turns it into the exit status.
pub(crate) fn report(as_json: bool, said: Said) -> ExitCode {
    match said {
        Ok((value, text)) => {
            print(&if as_json { format!("{value:#}") } else { text });
            ExitCode::SUCCESS
        }
        Err(error) => {
            if as_json {
                print(&json!({ "error": error.to_string() }).to_string());
            }
            eprintln!("mintime: {error}");
            ExitCode::FAILURE
        }
    }
}

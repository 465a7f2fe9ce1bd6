//! What a page shows, as plain data. Serialised it is the JSON of the page's element `data`.

use mintime_shared::model::{Limits, Segment, State};
use serde::Serialize;

use super::bytes::TableBytes;
use super::certificate::Laws;
use super::health::Counter;
use super::learning::Learning;
use super::series::{CameraSeries, FlightSeries, PlanSeries, RecordSeries};

/// Everything a page shows. Times are s from the beginning of the maneuver, or of the flight where it never began; SI units;
/// numbers that are not finite are `null`.
#[derive(Clone, Debug, Serialize)]
pub struct Page {
    /// One line, e.g. `Minimum-time maneuver to x = 5 m, z = 5 m`.
    pub title: String,
    /// Lines below the title.
    pub subtitle: Vec<String>,
    /// How it went, in a word, e.g. `completed`.
    pub outcome: String,
    /// Why it went otherwise than planned, in words.
    pub reason: Option<String>,
    /// Flown to its end, caught and landed.
    pub success: bool,
    /// Whether the maneuver began; if not there is nothing to compare with the plan.
    pub began: bool,
    /// What the flown curves are: `true`, or `seen by the cameras`.
    pub flown_is: &'static str,
    /// The numbers that matter most.
    pub facts: Vec<Fact>,
    /// Duration T of the plan, s.
    pub duration_s: f64,
    /// Limits it was planned with.
    pub limits: Limits<f64>,
    /// Where the table's numbers come from: `extremal`, `retimed` or `learned`. A learned one misses its end in the model, to
    /// reach it in the world.
    pub origin: &'static str,
    /// Where it is to end.
    pub target: State<f64>,
    /// Its inputs, durations in s.
    pub segments: Vec<Segment<f64>>,
    /// The plan over time.
    pub plan: PlanSeries,
    /// The flight over time.
    pub flight: FlightSeries,
    /// What motion capture measured, where the flight itself is not that.
    pub cameras: Option<CameraSeries>,
    /// The vehicle's own record.
    pub record: Option<RecordSeries>,
    /// Phases of the flight.
    pub phases: Vec<Span>,
    /// What happened, in order of time.
    pub events: Vec<Moment>,
    /// The minimum principle, law by law; `None` for a table from a file.
    pub certificate: Option<Laws>,
    /// The maneuver table.
    pub table: TableBytes,
    /// How fast and how loaded the flight controller was.
    pub timings: Vec<Timing>,
    /// What was counted that should not happen.
    pub counters: Vec<Counter>,
    /// Who flew what with which software.
    pub identity: Vec<Fact>,
    /// What repeated flights taught.
    pub learning: Option<Learning>,
}

/// A label and what it says.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Fact {
    /// What.
    pub label: String,
    /// How much, with unit.
    pub value: String,
}

impl Fact {
    pub(super) fn new(label: &str, value: impl Into<String>) -> Self {
        Self { label: label.to_owned(), value: value.into() }
    }
}

/// A part of the time axis with a name.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Span {
    /// Its name.
    pub name: String,
    /// From, s.
    pub from_s: f64,
    /// To, s.
    pub to_s: f64,
}

/// How serious what happened is, and who says it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Kind {
    /// The normal course, as the host sees it.
    Info,
    /// A line of the firmware's log.
    Firmware,
    /// Unusual; the flight goes on.
    Warning,
    /// The flight could not go on as asked.
    Error,
}

/// Something that happened.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Moment {
    /// When, s.
    pub t_s: f64,
    /// One sentence.
    pub text: String,
    /// What kind.
    pub kind: Kind,
}

/// A time or a load that was measured.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Timing {
    /// What.
    pub label: &'static str,
    /// Lower and upper end: emulated with the fastest processor that its documentation allows, and with the slowest. Both the
    /// same where it does not depend on that.
    pub range: [f64; 2],
    /// Its unit.
    pub unit: &'static str,
    /// Digits that mean something.
    pub digits: usize,
    /// Whether it is a figure of the emulator, not of a flight controller of silicon.
    pub emulated: bool,
    /// What it means.
    pub meaning: &'static str,
}

//! A progress line on the terminal, and the flight's events for its log.

use std::time::Duration;

use indicatif::{ProgressBar, ProgressStyle};
use mintime::flight::{Phase, Witness};
use mintime::flight_log::{EventLevel, LogEvent};

/// Shows what is going on and keeps what happened. The line goes to stderr, and only to a terminal.
pub(crate) struct Progress {
    line: ProgressBar,
    pub(crate) events: Vec<LogEvent>,
    /// How many of them there were when the last flight began.
    before_flight: usize,
}

impl Progress {
    pub(crate) fn new() -> Self {
        let line = ProgressBar::new_spinner();
        line.set_style(
            ProgressStyle::with_template("{spinner} {msg}")
                .unwrap_or_else(|_| ProgressStyle::default_spinner()),
        );
        line.enable_steady_tick(Duration::from_millis(100));
        Self { line, events: Vec::new(), before_flight: 0 }
    }

    pub(crate) fn say(&self, text: impl Into<String>) {
        self.line.set_message(text.into());
    }

    /// Says something that may take minutes, so also where there is no terminal to show a line that changes.
    pub(crate) fn announce(&self, text: &str) {
        if self.line.is_hidden() {
            eprintln!("mintime: {text}");
        }
        self.say(text);
    }

    /// Says something that stays, above the line that changes.
    pub(crate) fn line(&self, text: &str) {
        self.voice().line(text);
    }

    /// Somebody else who may do so.
    pub(crate) fn voice(&self) -> Voice {
        Voice(self.line.clone())
    }

    pub(crate) fn finish(&self) {
        self.line.finish_and_clear();
    }

    /// What happened in the last flight, of several.
    pub(crate) fn last_flight(&mut self) -> Vec<LogEvent> {
        self.events.split_off(self.before_flight.min(self.events.len()))
    }

    fn note(&mut self, now_s: f64, text: &str) {
        let time_ns = (now_s * 1e9).round() as u64;
        self.events.push(LogEvent { time_ns, text: text.to_owned(), level: EventLevel::Info });
    }
}

/// Says things that stay, above the progress line where there is one.
#[derive(Clone)]
pub(crate) struct Voice(ProgressBar);

impl Voice {
    pub(crate) fn line(&self, text: &str) {
        if self.0.is_hidden() {
            eprintln!("mintime: {text}");
        } else {
            self.0.println(text);
        }
    }
}

impl Witness for Progress {
    fn phase(&mut self, phase: Phase, now_s: f64) {
        if phase == Phase::Prepare {
            self.before_flight = self.events.len();
        }
        let text = match phase {
            Phase::Prepare => "identifying the vehicle, uploading the table",
            Phase::TakeOff => "taking off",
            Phase::Hover => "hovering, waiting for the gate",
            Phase::Maneuver => "flying the maneuver",
            Phase::Catch => "catching the vehicle",
            Phase::Land => "landing",
            Phase::Download => "downloading the flight record",
        };
        self.say(format!("{text} ({now_s:.1} s)"));
        self.note(now_s, text);
    }

    fn event(&mut self, now_s: f64, text: &str) {
        self.note(now_s, text);
    }
}

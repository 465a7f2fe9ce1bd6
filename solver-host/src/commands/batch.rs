//! Many requests from a file of JSON lines, answered in order, on all cores.

use std::fmt::Write as _;
use std::path::Path;

use mintime::solver::{Request, Turns};
use mintime_shared::model::{Limits, State};
use serde::de::Error as _;
use serde::{Deserialize, Deserializer};
use serde_json::{Value, json};

use super::answer::answer;

/// One line: a request. `turns` may be left out or null for the fastest.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Line {
    name: String,
    from: [f64; 5],
    to: [f64; 5],
    thrust: [f64; 2],
    rate: f64,
    gravity: f64,
    #[serde(default)]
    turns: Option<Winding>,
}

/// A number of turns, or `any`.
enum Winding {
    Exactly(i32),
    Any,
}

impl<'de> Deserialize<'de> for Winding {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let value = Value::deserialize(deserializer)?;
        let whole =
            value.as_i64().map(|k| i32::try_from(k).unwrap_or(if k < 0 { i32::MIN } else { i32::MAX }));
        match (whole, value.as_str()) {
            (Some(k), _) => Ok(Self::Exactly(k)),
            (None, Some("any")) => Ok(Self::Any),
            _ => Err(D::Error::custom("turns must be a whole number or \"any\"")),
        }
    }
}

impl Line {
    fn request(&self) -> Request {
        let [thrust_min_mps2, thrust_max_mps2] = self.thrust;
        Request {
            from: State::from_array(self.from),
            to: State::from_array(self.to),
            limits: Limits {
                thrust_min_mps2,
                thrust_max_mps2,
                rate_max_radps: self.rate,
                gravity_mps2: self.gravity,
            },
            turns: match self.turns {
                Some(Winding::Exactly(k)) => Turns::Exactly(k),
                Some(Winding::Any) | None => Turns::Any,
            },
        }
    }
}

/// All answers, one a line, and how many of them are errors.
pub(crate) struct Answers {
    pub(crate) text: String,
    pub(crate) failed: usize,
}

/// Answers every line of a file.
pub(crate) fn answer_file(path: &Path) -> Result<Answers, String> {
    let text = std::fs::read_to_string(path)
        .map_err(|e| format!("{} cannot be read ({e}): give a file of JSON lines", path.display()))?;
    // Some editors begin a file with a byte order mark.
    let text = text.trim_start_matches('\u{feff}');
    let lines: Vec<(usize, &str)> = text.lines().enumerate().filter(|(_, l)| !l.trim().is_empty()).collect();
    let workers = std::thread::available_parallelism().map_or(1, usize::from);
    let share = lines.len().div_ceil(workers).max(1);
    let answered: Vec<(String, bool)> = std::thread::scope(|scope| {
        let threads: Vec<_> = lines
            .chunks(share)
            .map(|chunk| scope.spawn(|| chunk.iter().map(|(i, line)| guarded(*i, line)).collect::<Vec<_>>()))
            .collect();
        // Nothing panics outside `guarded`.
        threads.into_iter().flat_map(|t| t.join().unwrap_or_default()).collect()
    });
    let failed = answered.iter().filter(|(_, good)| !good).count() + (lines.len() - answered.len());
    let mut out = String::new();
    for (line, _) in answered {
        // Writing to a string does not fail.
        let _ = writeln!(out, "{line}");
    }
    Ok(Answers { text: out, failed })
}

/// [`answer_line`], and where it panics, which would be a defect, an error for this line instead of none for all.
fn guarded(index: usize, line: &str) -> (String, bool) {
    std::panic::catch_unwind(|| answer_line(index, line)).unwrap_or_else(|_| {
        (
            failure(
                &name_in(line).unwrap_or_else(|| format!("line {}", index + 1)),
                "the solver failed on this line: please report it",
            ),
            false,
        )
    })
}

/// One line's answer, and whether it is one.
fn answer_line(index: usize, line: &str) -> (String, bool) {
    let parsed: Line = match serde_json::from_str(line) {
        Ok(parsed) => parsed,
        Err(error) => {
            let name = name_in(line).unwrap_or_else(|| format!("line {}", index + 1));
            // The parser counts lines too, but within this one.
            let text = error.to_string();
            let reason = text.split(" at line ").next().unwrap_or(&text);
            let column =
                if error.column() > 0 { format!(" (column {})", error.column()) } else { String::new() };
            return (
                failure(&name, &format!("line {} is not a request: {reason}{column}", index + 1)),
                false,
            );
        }
    };
    let solved = answer(&parsed.request(), Some(parsed.name.clone()));
    match solved.map(|s| serde_json::to_string(&s.answer)) {
        Ok(Ok(text)) => (text, true),
        Ok(Err(error)) => (failure(&parsed.name, &error.to_string()), false),
        Err(error) => (failure(&parsed.name, &error.to_string()), false),
    }
}

/// The `name` of a line, as far as it can be read: also where the rest is not JSON.
fn name_in(line: &str) -> Option<String> {
    if let Ok(value) = serde_json::from_str::<Value>(line) {
        return value["name"].as_str().map(str::to_owned);
    }
    let after = line.split_once("\"name\"")?.1.trim_start().strip_prefix(':')?.trim_start();
    // The first value of what follows, whatever comes after it.
    serde_json::Deserializer::from_str(after).into_iter::<String>().next()?.ok()
}

fn failure(name: &str, error: &str) -> String {
    json!({ "name": name, "error": error }).to_string()
}

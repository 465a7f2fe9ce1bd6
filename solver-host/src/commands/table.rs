//! `mintime show` and `mintime verify`: what a table file says, and whether it is true.

use std::error::Error;
use std::io::Read as _;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::Args;
use mintime::pack::{REPLAY_ANGLE_RAD, REPLAY_POSITION_M, REPLAY_VELOCITY_MPS, replay};
use mintime::solver::{Request, Turns, solve};
use mintime_shared::model::State;
use mintime_shared::table::{ANY_VEHICLE, Kind, ManeuverTable};
use serde_json::{Value, json};

use super::answer::{rate_word, thrust_word};
use super::print;

/// A table from `f32` numbers may be this much slower than the exact optimum, relative.
const ROUNDING: f64 = 1.0e-6;
/// A table's end angle is rounded to `f32`: turns are whole within this, rad.
const ANGLE_ROUNDING_RAD: f64 = 1.0e-4;

/// Arguments of `mintime show` and `mintime verify`.
#[derive(Args)]
pub(crate) struct TableFile {
    /// The table file
    file: PathBuf,
    /// Print JSON instead of text
    #[arg(long)]
    json: bool,
}

/// Reads a table file's bytes: a little more than any table has, so that a wrong file is refused by its length and not
/// swallowed whole.
pub(crate) fn read_bytes(path: &Path) -> Result<Vec<u8>, String> {
    let failed =
        |e: std::io::Error| format!("{} cannot be read ({e}): give a readable table file", path.display());
    let mut bytes = Vec::new();
    std::fs::File::open(path).map_err(failed)?.take(4096).read_to_end(&mut bytes).map_err(failed)?;
    Ok(bytes)
}

impl TableFile {
    pub(crate) fn show(&self) -> ExitCode {
        self.report(|table, bytes| (describe(table, bytes), true))
    }

    pub(crate) fn verify(&self) -> ExitCode {
        self.report(|table, _| check(table))
    }

    /// Reads the table, prints what `look` makes of it, and turns its verdict into the exit status.
    fn report(&self, look: impl Fn(&ManeuverTable, usize) -> (Value, bool)) -> ExitCode {
        match self.read() {
            Ok((table, bytes)) => {
                let (value, good) = look(&table, bytes);
                if self.json {
                    print(&format!("{value:#}"));
                } else {
                    print_plain(&value);
                }
                if good { ExitCode::SUCCESS } else { ExitCode::FAILURE }
            }
            Err(error) => {
                if self.json {
                    print(&json!({ "error": error.to_string() }).to_string());
                }
                eprintln!("mintime: {error}");
                ExitCode::FAILURE
            }
        }
    }

    fn read(&self) -> Result<(ManeuverTable, usize), Box<dyn Error>> {
        let bytes = read_bytes(&self.file)?;
        let table = ManeuverTable::decode(&bytes).map_err(|e| format!("{}: {e}", self.file.display()))?;
        Ok((table, bytes.len()))
    }
}

/// Everything that a table says.
fn describe(table: &ManeuverTable, bytes: usize) -> Value {
    let kind = match table.kind {
        Kind::Extremal => "extremal",
        Kind::Retimed => "retimed",
        Kind::Learned => "learned",
    };
    let vehicle =
        if table.vehicle == ANY_VEHICLE { "any".to_owned() } else { format!("{:08x}", table.vehicle) };
    let segments: Vec<Value> = table
        .segments()
        .map(|s| {
            json!({
                "duration_s": s.duration,
                "rate": rate_word(s.inputs.rate),
                "thrust": thrust_word(s.inputs.thrust),
            })
        })
        .collect();
    json!({
        "kind": kind,
        "vehicle": vehicle,
        "table_bytes": bytes,
        "checksum": format!("{:08x}", table.checksum()),
        "duration_s": table.duration_s(),
        "limits": {
            "thrust_mps2": [table.limits.thrust_min_mps2, table.limits.thrust_max_mps2],
            "rate_radps": table.limits.rate_max_radps,
            "gravity_mps2": table.limits.gravity_mps2,
        },
        "heading_rad": table.heading_rad,
        "from": table.start.to_array(),
        "to": table.end.to_array(),
        "arcs": table.arcs.map(|a| json!({ "width_s": a.width_s, "peak_s": a.peak_s })),
        "segments": segments,
    })
}

/// Replays the table and solves its request again. `false` where it misses its end or is not the fastest.
fn check(table: &ManeuverTable) -> (Value, bool) {
    let end = table.end.cast::<f64>();
    let miss = replay(table, table.start.cast()).minus(end);
    let arrives = miss.x.hypot(miss.z) <= REPLAY_POSITION_M
        && miss.vx.hypot(miss.vz) <= REPLAY_VELOCITY_MPS
        && miss.theta.abs() <= REPLAY_ANGLE_RAD;
    // Rounding to f32 must not turn a whole number of turns into an odd angle.
    let turns = (end.theta / core::f64::consts::TAU).round();
    let rest = end.theta - turns * core::f64::consts::TAU;
    let whole = rest.abs() <= ANGLE_ROUNDING_RAD;
    let theta = if whole { 0.0 } else { end.theta };
    let k = if whole { turns as i32 } else { 0 };
    // What was rounded to f32 was a decimal number: 9.81, not 9.8100004.
    let decimal = |v: f64| (v as f32).to_string().parse().unwrap_or(v);
    let clean = |s: State<f64>| State::from_array(s.to_array().map(decimal));
    let mut limits = table.limits.cast::<f64>();
    for value in [
        &mut limits.thrust_min_mps2,
        &mut limits.thrust_max_mps2,
        &mut limits.rate_max_radps,
        &mut limits.gravity_mps2,
    ] {
        *value = decimal(*value);
    }
    let request = Request {
        from: clean(table.start.cast()),
        to: State { theta, ..clean(end) },
        limits,
        turns: Turns::Exactly(k),
    };
    let duration_s = f64::from(table.duration_s());
    let solved = solve(&request);
    let optimum_s = solved.as_ref().ok().map(|s| s.extremal.duration_s());
    let optimal = optimum_s.is_some_and(|t| duration_s <= t * (1.0 + ROUNDING));
    let verified = arrives && optimal;
    let value = json!({
        "verified": verified,
        "duration_s": duration_s,
        "turns": k,
        "replay_error": miss.to_array(),
        "replay_arrives": arrives,
        "optimal_duration_s": optimum_s,
        "optimal": optimal,
        "certificate": solved.as_ref().ok().map(|s| s.certificate),
        "reason": solved.err().map(|e| e.to_string()),
    });
    (value, verified)
}

/// A JSON object as aligned lines.
fn print_plain(value: &Value) {
    let Some(fields) = value.as_object() else {
        return;
    };
    for (name, field) in fields {
        match field {
            Value::Null => {}
            Value::Array(items) if items.iter().any(Value::is_object) => {
                for (i, item) in items.iter().enumerate() {
                    print(&format!("{:<20} {}", if i == 0 { name } else { "" }, plain(item)));
                }
            }
            other => print(&format!("{name:<20} {}", plain(other))),
        }
    }
}

fn plain(value: &Value) -> String {
    match value {
        Value::String(text) => text.clone(),
        Value::Array(items) => items.iter().map(plain).collect::<Vec<_>>().join(", "),
        Value::Object(fields) => {
            fields.iter().map(|(k, v)| format!("{k} {}", plain(v))).collect::<Vec<_>>().join(", ")
        }
        other => other.to_string(),
    }
}

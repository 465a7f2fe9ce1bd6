//! The flight record and the event log.

use std::path::PathBuf;

use clap::Args;
use mintime_shared::messages::{Happening, RecordedTick, record_flags};
use serde_json::json;

use super::super::solve::write_bytes;
use super::{Bench, Said};

/// Arguments of `record`.
#[derive(Args)]
pub(super) struct Record {
    /// Where to write it: CSV, one line a control tick
    #[arg(short, long, value_name = "FILE.csv")]
    output: PathBuf,
}

impl Record {
    pub(super) fn run(&self, bench: &mut Bench) -> Said {
        let record = bench.record()?;
        if record.is_empty() {
            return Err("the vehicle has no record: it begins one with each maneuver".into());
        }
        write_bytes(&self.output, csv(&record).as_bytes())?;
        let time_s = record.iter().map(|t| f64::from(t.interval_us) * 1e-6).sum::<f64>();
        let missing = record.iter().filter(|t| t.gyro_radps.is_none()).count();
        let late = record.iter().filter(|t| t.flags & record_flags::LATE != 0).count();
        let text = format!(
            "{} ticks over {time_s:.3} s in {}; {missing} without a sample, {late} late",
            record.len(),
            self.output.display()
        );
        let value = json!({
            "ticks": record.len(),
            "time_s": time_s,
            "missing_samples": missing,
            "late_ticks": late,
            "file": self.output,
        });
        Ok((value, text))
    }
}

/// SI units; empty where a sample is missing.
fn csv(record: &[RecordedTick]) -> String {
    let mut text = String::from(
        "time_s,roll_rate_radps,pitch_rate_radps,yaw_rate_radps,commanded_rate_radps,commanded_thrust_mps2,throttle_1,\
         throttle_2,throttle_3,throttle_4,late,saturated,host_fresh,maneuver\n",
    );
    let mut time_us = 0_u64;
    for tick in record {
        time_us += u64::from(tick.interval_us);
        let gyro = match tick.gyro_radps {
            Some([x, y, z]) => format!("{x:.5},{y:.5},{z:.5}"),
            None => ",,".to_owned(),
        };
        let [a, b, c, d] = tick.throttle;
        let flag = |bit| u8::from(tick.flags & bit != 0);
        text += &format!(
            "{:.6},{gyro},{:.5},{:.3},{a:.4},{b:.4},{c:.4},{d:.4},{},{},{},{}\n",
            time_us as f64 * 1e-6,
            tick.rate_radps,
            tick.thrust_mps2,
            flag(record_flags::LATE),
            flag(record_flags::SATURATED),
            flag(record_flags::HOST_FRESH),
            flag(record_flags::MANEUVER),
        );
    }
    text
}

pub(super) fn events(bench: &mut Bench) -> Said {
    let events = bench.events()?;
    let list: Vec<_> = events
        .iter()
        .map(|(number, e)| json!({ "number": number, "time_s": f64::from(e.time_ms) * 1e-3, "what": words(&e.what) }))
        .collect();
    let lines: Vec<_> = events
        .iter()
        .map(|(number, e)| format!("{number:5} {:10.3} s  {}", f64::from(e.time_ms) * 1e-3, words(&e.what)))
        .collect();
    let text = if lines.is_empty() { "no events".to_owned() } else { lines.join("\n") };
    Ok((json!({ "events": list }), text))
}

fn words(what: &Happening) -> String {
    match what {
        Happening::Started => "started".to_owned(),
        Happening::Incident(cause) => format!("incident: {cause}"),
        Happening::Acknowledged(number) => format!("incident {number} acknowledged"),
        Happening::Entered(state) => format!("now {state:?}"),
        Happening::Aborted(reason) => format!("because {reason}"),
        Happening::Refused(refusal) => format!("refused: {refusal}"),
        Happening::Committed(checksum) => format!("table {checksum:#010x} committed"),
        Happening::Stored => "written to flash".to_owned(),
        Happening::Calibrated => "gyro bias learned".to_owned(),
    }
}

//! Who a vehicle is, how it is, and how well the link works.

use clap::Args;
use mintime::vehicle::Spread;
use mintime_shared::messages::{ArmingBlock, KillSwitch, PROTOCOL_VERSION, Request, Telemetry};
use serde_json::{Value, json};

use super::{Bench, Said};

pub(super) fn identity(bench: &mut Bench) -> Said {
    let id = *bench.identity();
    let [major, minor, patch] = id.firmware_version;
    let value = json!({
        "firmware_version": format!("{major}.{minor}.{patch}"),
        "protocol_version": PROTOCOL_VERSION,
        "table_schema": format!("{:#010x}", id.table_schema),
        "vehicle_hash": format!("{:#010x}", id.vehicle),
        "session": id.session,
        "paired": id.paired,
        "limits": {
            "thrust_min_mps2": super::to_json(&id.thrust_min_mps2)?,
            "thrust_max_mps2": super::to_json(&id.thrust_max_mps2)?,
            "rate_max_radps": super::to_json(&id.rate_max_radps)?,
        },
    });
    let known = if id.vehicle == 0 {
        "has no vehicle file yet: write one with `params --file`".to_owned()
    } else {
        format!("vehicle {:#010x}", id.vehicle)
    };
    let text = format!(
        "mintime firmware {major}.{minor}.{patch}, protocol {PROTOCOL_VERSION}, {known}\n\
         plans with {:.2} to {:.2} m/s² of thrust and up to {:.2} rad/s; {}",
        id.thrust_min_mps2,
        id.thrust_max_mps2,
        id.rate_max_radps,
        if id.paired { "paired" } else { "not paired" },
    );
    Ok((value, text))
}

pub(super) fn status(bench: &mut Bench) -> Said {
    let status = bench.status()?;
    Ok((full(&status)?, text(&status)))
}

pub(super) fn acknowledge(bench: &mut Bench) -> Said {
    let Some(incident) = bench.status()?.incident else {
        return Ok((json!({ "acknowledged": null }), "nothing waits to be acknowledged".to_owned()));
    };
    bench.tell("acknowledging", Request::Acknowledge { incident: incident.number })?;
    let mut text = format!("acknowledged incident {}: {}", incident.number, incident.cause);
    let next = bench.status()?.incident;
    if let Some(next) = next {
        text += &format!("\nincident {} waits next: {} (`acknowledge` again)", next.number, next.cause);
    }
    let next = next.map(|next| json!({ "number": next.number, "cause": next.cause.to_string() }));
    Ok((json!({ "acknowledged": incident.number, "cause": incident.cause.to_string(), "next": next }), text))
}

/// What blocks arming, each reason with what to do.
fn blocks(status: &Telemetry) -> Vec<&'static str> {
    let block = ArmingBlock(status.arming_block);
    ArmingBlock::REASONS.iter().filter(|(bit, _)| block.contains(*bit)).map(|(_, text)| *text).collect()
}

/// All of the telemetry, and its numbers in words.
fn full(status: &Telemetry) -> Result<Value, serde_json::Error> {
    let mut value = super::to_json(status)?;
    if let Some(map) = value.as_object_mut() {
        map.insert("ready_to_arm".into(), (status.arming_block == 0).into());
        map.insert("arming_blocked_by".into(), blocks(status).into());
        map.insert("abort_reason".into(), status.abort.map(|a| a.to_string()).into());
        map.insert("incident_cause".into(), status.incident.map(|i| i.cause.to_string()).into());
        map.insert("table".into(), format!("{:#010x}", status.table).into());
    }
    Ok(value)
}

fn text(status: &Telemetry) -> String {
    let mut lines = vec![format!("state       {:?}", status.state)];
    if let Some(incident) = status.incident {
        lines.push(format!(
            "incident    {}: {} (`acknowledge` when you know why)",
            incident.number, incident.cause
        ));
    }
    lines.extend(status.abort.map(|abort| format!("last abort  {abort}")));
    match blocks(status)[..] {
        [] => lines.push("arming      nothing blocks it".to_owned()),
        ref reasons => lines.extend(reasons.iter().map(|reason| format!("not armable {reason}"))),
    }
    let kill = match status.kill {
        KillSwitch::Absent => "no receiver was ever heard",
        KillSwitch::Lost => "lost",
        KillSwitch::Stop => "stop",
        KillSwitch::Run => "run",
    };
    lines.push(format!("kill switch {kill}"));
    lines.push(format!("battery     {:.2} V", status.battery_v));
    let [x, y, z] = status.rates_radps;
    lines.push(format!("rates       {x:+.3} {y:+.3} {z:+.3} rad/s (forward, left, up)"));
    let tilt_rad = status.up_body[2].clamp(-1.0, 1.0).acos();
    lines.push(format!("tilt        {tilt_rad:.3} rad"));
    lines.push(match status.table {
        0 => "table       none".to_owned(),
        table => format!("table       {table:#010x}"),
    });
    lines.push(format!(
        "ticks       {}, of which {} late; {} gyro samples missing; {} damaged frames",
        status.ticks, status.late_ticks, status.missing_samples, status.link_errors
    ));
    lines.push(format!("record      {} ticks; {} events", status.recorded, status.events));
    lines.extend(status.board.map(|board| {
        let fault = board.gyro_fault.map(|f| format!("; {f}")).unwrap_or_default();
        format!(
            "board       gyro to motors {:.1} µs ({:.1} to {:.1}), load {:.1} %{fault}",
            f64::from(board.latency_ns) * 1e-3,
            f64::from(board.latency_min_ns) * 1e-3,
            f64::from(board.latency_max_ns) * 1e-3,
            f64::from(board.load_permille) * 0.1,
        )
    }));
    lines.join("\n")
}

/// Arguments of `measure`.
#[derive(Args)]
pub(super) struct Measure {
    /// For how long, s
    #[arg(long, value_name = "S", default_value_t = 5.0)]
    seconds: f64,
}

impl Measure {
    pub(super) fn run(&self, bench: &mut Bench) -> Said {
        if !(self.seconds > 0.0 && self.seconds <= 3600.0) {
            return Err("--seconds must be between 0 and 3600".into());
        }
        let m = bench.measure(self.seconds)?;
        let board = m.telemetry.board;
        let value = json!({
            "asked": m.asked,
            "repeated": m.repeated,
            "unanswered": m.unanswered,
            "round_trip_ms": m.round_trip_ms,
            "telemetry_interval_ms": m.telemetry_ms,
            "telemetry_hz": m.telemetry_hz,
            "damaged_frames": { "at_host": m.damaged.0, "at_vehicle": m.damaged.1 },
            "latency_us": board.map(|b| f64::from(b.latency_ns) * 1e-3),
            "jitter_us": board.map(|b| f64::from(b.latency_max_ns - b.latency_min_ns.min(b.latency_max_ns)) * 1e-3),
            "load": board.map(|b| f64::from(b.load_permille) * 1e-3),
            "late_ticks": m.telemetry.late_ticks,
            "worst_interval_us": m.telemetry.worst_interval_us,
        });
        let spread = |s: Option<Spread>| {
            s.map_or("not measured".to_owned(), |s| {
                format!(
                    "{:.2} ms median, {:.2} to {:.2}, 99 % below {:.2}",
                    s.median, s.least, s.greatest, s.p99
                )
            })
        };
        let part = 100.0 * f64::from(m.repeated) / f64::from(m.asked.max(1));
        let mut text = format!(
            "round trip  {}\nlost        {} of {} requests sent again ({part:.2} %), {} unanswered; damaged frames {} here, \
             {} there\ntelemetry   {:.1} a second, interval {}",
            spread(m.round_trip_ms),
            m.repeated,
            m.asked,
            m.unanswered,
            m.damaged.0,
            m.damaged.1,
            m.telemetry_hz,
            spread(m.telemetry_ms),
        );
        if let Some(b) = board {
            let jitter = b.latency_max_ns.saturating_sub(b.latency_min_ns);
            text += &format!(
                "\nboard       gyro to motors {:.1} µs, jitter {:.1} µs peak to peak, load {:.1} %",
                f64::from(b.latency_ns) * 1e-3,
                f64::from(jitter) * 1e-3,
                f64::from(b.load_permille) * 0.1
            );
        }
        Ok((value, text))
    }
}

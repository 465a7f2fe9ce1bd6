//! What `mintime fly` prints: a page for a person, or JSON.

use std::path::Path;

use mintime::mission::{Flown, PROTOCOL, PlanarError};
use mintime_shared::table::Kind;
use serde_json::{Value, json};

use super::recording::{structure, target};

/// The JSON answer. Field names are part of the interface.
pub(crate) fn json(flown: &Flown, log: Option<&Path>, report: Option<&Path>, page: Option<&Path>) -> Value {
    let identity = flown.flight.as_ref().ok().map(|r| r.identity);
    let flight = flown.flight.as_ref().ok();
    let path = |p: Option<&Path>| p.map(|p| p.display().to_string());
    json!({
        "maneuver": {
            "duration_s": f64::from(flown.prepared.table.duration_s()),
            "turns": flown.turns(),
            "heading_rad": flown.heading_rad(),
            "table_bytes": flown.prepared.bytes.len(),
            "verified": flown.prepared.solution.as_ref().is_some_and(|s| s.certificate.verified),
        },
        "vehicle": {
            "kind": flown.vehicle,
            "image_sha256": flown.emulated.as_ref().map(|e| &e.image_sha256),
            "image_path": flown.emulated.as_ref().map(|e| e.image_path.display().to_string()),
            "flash_bytes": flown.emulated.as_ref().map(|e| e.flash_bytes),
            "ram_bytes": flown.emulated.as_ref().map(|e| e.ram_bytes),
            "firmware_version": identity.map(|i| version(i.firmware_version)),
            "protocol_version": PROTOCOL,
        },
        "flight": {
            "outcome": flown.outcome(),
            "abort_reason": flown.reason(),
            "ticks": flight.map_or(0, |r| r.ticks),
            "missed_ticks": flight.map_or(0, |r| r.missed_ticks),
            "flown_duration_s": flight.map_or(0.0, |r| r.flown_duration_s),
            "start_error": flown.start_error(),
            "final_error": flown.final_error(),
            "real_time_factor": flown.emulated.as_ref().map(|e| e.real_time_factor),
            "tick_instructions": flown.emulated.as_ref().map(|e| e.board.tick_instructions),
            "latency_us": flown.emulated.as_ref().map(|e| e.latency_us),
            "jitter_us": flown.emulated.as_ref().map(|e| e.jitter_us),
            "load": flown.emulated.as_ref().map(|e| e.board.load),
            "motor_errors": flight.and_then(|r| r.board).map(|b| b.motor_errors),
            "gyro_errors": flight.and_then(|r| r.board).map(|b| b.gyro_errors),
            "firmware_bugs": flown.emulated.as_ref().map(|e| &e.board.bugs),
        },
        "virtual_time_s": flown.virtual_time_s,
        "wall_time_s": flown.wall_time_s,
        "log": path(log),
        "report": path(report),
        "page": path(page),
    })
}

fn version([major, minor, patch]: [u8; 3]) -> String {
    format!("{major}.{minor}.{patch}")
}

/// The page for a person.
pub(crate) fn text(flown: &Flown, firmware_log: bool, files: &[&Path]) -> String {
    let prepared = &flown.prepared;
    let table = &prepared.table;
    let extent = &prepared.extent;
    let mut lines = vec![
        format!(
            "maneuver   {}: T = {:.4} s, turns {}, {}",
            target(prepared),
            table.duration_s(),
            flown.turns(),
            if prepared.solution.is_some() {
                "verified against the minimum principle"
            } else {
                "from a table file, not verified"
            },
        ),
        format!("segments   {} (s)", structure(prepared)),
        format!("table      {} bytes", prepared.bytes.len()),
        format!(
            "path       x {:.2}..{:.2} m, z {:.2}..{:.2} m, peak speed {:.2} m/s{}, {:.2} m more to catch",
            extent.x_m.0,
            extent.x_m.1,
            extent.z_m.0,
            extent.z_m.1,
            extent.peak_speed_mps,
            if table.kind == Kind::Learned { " (of the model, not of the flight)" } else { "" },
            extent.catch_distance_m(),
        ),
    ];
    match &flown.flight {
        Ok(r) => {
            lines.push(format!(
                "vehicle    {}, firmware {}, protocol {PROTOCOL}{}",
                match flown.vehicle {
                    "virtual" => "virtual: the firmware image on an emulated flight controller",
                    other => other,
                },
                version(r.identity.firmware_version),
                flown
                    .emulated
                    .as_ref()
                    .map(|e| format!(", image {}", &e.image_sha256[..12]))
                    .unwrap_or_default(),
            ));
            lines.extend(flown.emulated.as_ref().map(|e| {
                let path = e.image_path.display();
                format!("image      {path}: {} bytes of flash, {} of RAM", e.flash_bytes, e.ram_bytes)
            }));
            lines.push(format!(
                "flight     {}: {:.4} s flown, {} ticks, {} missed{}",
                flown.outcome(),
                r.flown_duration_s,
                r.ticks,
                r.missed_ticks,
                flown.reason().map(|w| format!("; {w}")).unwrap_or_default(),
            ));
        }
        Err(error) => lines.push(format!("flight     lost: {error}")),
    }
    lines.extend(flown.start_error().map(|e| format!("start      {}", error_line(&e))));
    lines.extend(flown.final_error().map(|e| format!("end error  {}", error_line(&e))));
    if let Some(e) = &flown.emulated {
        let ([a, b], [c, d]) = (e.latency_us, e.jitter_us);
        lines.push(format!(
            "emulated   gyro to motors {a:.1} to {b:.1} µs, jitter {c:.2} to {d:.2} µs, {:.0} instructions a tick, load {:.1} %",
            e.board.tick_instructions,
            100.0 * e.board.load,
        ));
        let shown = if firmware_log { &e.board.log[..] } else { &[] };
        lines
            .extend(shown.iter().map(|(ns, line)| format!("log        {:8.3} s  {line}", *ns as f64 * 1e-9)));
        lines.extend(e.board.bugs.iter().map(|bug| format!("bug        {bug}")));
    }
    lines.push(format!("time       {:.1} s of flight in {:.2} s", flown.virtual_time_s, flown.wall_time_s));
    lines.extend(files.iter().map(|f| format!("wrote      {}", f.display())));
    lines.join("\n")
}

fn error_line(e: &PlanarError) -> String {
    format!(
        "x {:+.4} m, z {:+.4} m, vx {:+.4} m/s, vz {:+.4} m/s, pitch {:+.4} rad, pitch rate {:+.2} rad/s, \
         out of the plane {:+.4} m",
        e.x_m, e.z_m, e.vx_mps, e.vz_mps, e.theta_rad, e.pitch_rate_radps, e.y_m
    )
}

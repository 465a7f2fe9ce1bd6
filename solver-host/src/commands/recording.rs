//! What a flown mission leaves in files: the log and the picture.

use mintime::flight_log::{EventLevel, FlightLog, HEADING, LogEvent, LogHeader, PlannedSample, RecordSample};
use mintime::mission::{Flown, Mission, Prepared};
use mintime::report::{FlownSample, ReportData};
use mintime_shared::model::{RateMode, Segment, ThrustLevel};
use mintime_shared::replay::Plan;

/// Step of the planned samples, s.
const PLAN_STEP_S: f64 = 1.25e-3;
/// The picture shows this much of the flight before the maneuver, s, ...
const BEFORE_S: f64 = 0.1;
/// ... and after it.
const AFTER_S: f64 = 0.4;

/// The planned maneuver, sampled; from the extremal where there is one, else from the table.
pub(crate) fn planned(prepared: &Prepared) -> Vec<PlannedSample> {
    let plan = Plan::new(&prepared.table);
    let duration_s = f64::from(plan.duration_s());
    let steps = (duration_s / PLAN_STEP_S).ceil() as usize;
    let sample = |i: usize| {
        let t_s = (i as f64 * PLAN_STEP_S).min(duration_s);
        match &prepared.solution {
            Some(solution) => {
                let e = &solution.extremal;
                PlannedSample {
                    t_s,
                    state: e.state_at(t_s),
                    rate_radps: e.rate_at(t_s),
                    thrust_mps2: e.thrust_at(t_s),
                    phi_r: e.phi_r_at(t_s),
                    phi_t: e.phi_t_at(t_s),
                }
            }
            None => {
                let t = t_s as f32;
                // At the very end what was commanded until then: beyond it there is nothing.
                let from = t.min(plan.duration_s() - 1.0e-4).max(0.0);
                let (angle, impulse) = plan.integrals(from, from + 1.0e-4);
                PlannedSample {
                    t_s,
                    state: plan.state_at(t).cast(),
                    rate_radps: f64::from(angle) * 1.0e4,
                    thrust_mps2: f64::from(impulse) * 1.0e4,
                    phi_r: f64::NAN,
                    phi_t: f64::NAN,
                }
            }
        }
    };
    (0..=steps).map(sample).collect()
}

/// The flight log.
pub(crate) fn log(mission: &Mission, flown: &Flown, mut events: Vec<LogEvent>) -> FlightLog {
    let logged = flown.emulated.iter().flat_map(|e| &e.board.log);
    events.extend(logged.map(|(time_ns, line)| LogEvent {
        time_ns: *time_ns,
        text: format!("firmware: {line}"),
        level: EventLevel::Info,
    }));
    // The firmware's lines among the flight's own, in the order of time.
    events.sort_by_key(|event| event.time_ns);
    events.push(verdict(flown));
    let table = &flown.prepared.table;
    let mut facts = vec![(HEADING.to_owned(), flown.heading_rad().to_string())];
    if let Ok(result) = &flown.flight {
        facts.push(("outcome".to_owned(), result.outcome.name().to_owned()));
        let [major, minor, patch] = result.identity.firmware_version;
        facts.push(("firmware_version".to_owned(), format!("{major}.{minor}.{patch}")));
    }
    let mut t_us = 0_u32;
    let record = flown.flight.as_ref().map_or(&[][..], |r| &r.record).iter().map(|tick| {
        t_us = t_us.saturating_add(u32::from(tick.interval_us));
        RecordSample {
            t_us,
            gyro_radps: tick.gyro_radps.unwrap_or([f32::NAN; 3]),
            commanded_rate_radps: tick.rate_radps,
            commanded_thrust_mps2: tick.thrust_mps2,
            throttle: tick.throttle,
        }
    });
    FlightLog {
        header: LogHeader {
            mintime_version: env!("CARGO_PKG_VERSION").to_owned(),
            seed: mission.seed,
            plant: mission.plant.name.clone(),
            vehicle: flown.vehicle.to_owned(),
            from: table.start.cast(),
            to: table.end.cast(),
            duration_s: f64::from(table.duration_s()),
            turns: flown.turns(),
            table: flown.prepared.bytes.clone(),
            maneuver_start_ns: flown.trace.start_ns,
            facts,
        },
        planned: planned(&flown.prepared),
        samples: flown.trace.samples.clone(),
        events,
        record: record.collect(),
    }
}

/// The last event: how it went, and why.
fn verdict(flown: &Flown) -> LogEvent {
    let time_ns = (flown.virtual_time_s * 1e9).round() as u64;
    let reason = flown.reason().map(|r| format!(": {r}")).unwrap_or_default();
    let level = if flown.is_success() { EventLevel::Info } else { EventLevel::Error };
    LogEvent { time_ns, text: format!("{}{reason}", flown.outcome()), level }
}

/// What the picture shows.
pub(crate) fn report(mission: &Mission, flown: &Flown) -> ReportData {
    let table = &flown.prepared.table;
    let duration_s = f64::from(table.duration_s());
    let mut facts = vec![
        ("T".to_owned(), format!("{duration_s:.4} s")),
        ("turns".to_owned(), flown.turns().to_string()),
        ("segments".to_owned(), table.segments().len().to_string()),
        ("table".to_owned(), format!("{} bytes", flown.prepared.bytes.len())),
    ];
    let speed = flown.peak_speed_mps();
    facts.extend(speed.map(|(name, speed_mps)| (name.to_owned(), format!("{speed_mps:.2} m/s"))));
    if let Some(e) = flown.final_error() {
        facts.push(("end error, position".to_owned(), format!("{:.3} m", e.x_m.hypot(e.z_m))));
        facts.push(("end error, velocity".to_owned(), format!("{:.3} m/s", e.vx_mps.hypot(e.vz_mps))));
        facts.push(("end error, pitch".to_owned(), format!("{:.4} rad", e.theta_rad).replace('-', "−")));
    }
    let outcome = flown.outcome();
    ReportData {
        title: format!("Minimum-time maneuver to {}", target(&flown.prepared)),
        subtitle: [Some(format!(
            "T = {duration_s:.4} s; flown {}: {outcome}",
            match flown.vehicle {
                "real" => "on the real vehicle, as the cameras saw it".to_owned(),
                kind => format!("on the {kind} vehicle, plant {}, seed {}", mission.plant.name, mission.seed),
            }
        ))]
        .into_iter()
        .chain([flown.reason()])
        .flatten()
        .collect(),
        planned: planned(&flown.prepared),
        flown: FlownSample::of_flight(flown, (BEFORE_S, AFTER_S)),
        segments: table
            .segments()
            .map(|s| Segment { inputs: s.inputs, duration: f64::from(s.duration) })
            .collect(),
        limits: table.limits.cast(),
        facts,
    }
}

/// Where a maneuver leads, from its start: in its plane, and in three dimensions where that is not straight ahead.
pub(crate) fn target(prepared: &Prepared) -> String {
    let table = &prepared.table;
    let (x, z) = (table.end.x - table.start.x, table.end.z - table.start.z);
    let heading_rad = prepared.heading_rad;
    if heading_rad == 0.0 {
        return format!("x = {x} m, z = {z} m");
    }
    let (sin, cos) = heading_rad.sin_cos();
    let (ahead, left) = (f64::from(x) * cos, f64::from(x) * sin);
    format!("x = {ahead:.3} m, y = {left:.3} m, z = {z} m (heading {heading_rad:.4} rad)")
}

/// The structure of a table in one line: `+max 0.051 s, singular max 0.724 s, ...`.
pub(crate) fn structure(prepared: &Prepared) -> String {
    let words = prepared.table.segments().map(|s| {
        let rate = match s.inputs.rate {
            RateMode::Plus => "+",
            RateMode::Minus => "-",
            RateMode::Singular => "s",
        };
        let thrust = match s.inputs.thrust {
            ThrustLevel::Min => "min",
            ThrustLevel::Max => "max",
        };
        format!("{rate}{thrust} {:.4}", s.duration)
    });
    words.collect::<Vec<_>>().join(", ")
}

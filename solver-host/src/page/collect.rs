//! A flight as a page.

use super::bytes::{TableBytes, origin};
use super::certificate::Laws;
use super::data::{Fact, Kind, Moment, Page, Span, Timing};
use super::health::counters;
use super::learning::Learning;
use super::series::{CameraSeries, Coordinates, FlightSeries, PlanSeries, RecordSeries};
use crate::flight_log::{EventLevel, FlightLog, FlightSample, LogEvent};
use crate::mission::{EmulatedFlight, Flown, PROTOCOL, PlanFrame};
use crate::report::ReportData;

/// The firmware's own log lines begin with this among the events.
const FIRMWARE_LINE: &str = "firmware: ";

/// What a page is made of.
#[derive(Clone, Debug)]
pub struct Sources<'a> {
    /// What the picture shows: title, plan, segments, limits.
    pub picture: &'a ReportData,
    /// The flight log.
    pub log: &'a FlightLog,
    /// The flight.
    pub flown: &'a Flown,
    /// What this and earlier flights taught, if they are a series.
    pub learning: Option<Learning>,
}

impl Page {
    /// Everything that a page shows of a flight.
    pub fn collect(sources: Sources<'_>) -> Self {
        let Sources { picture, log, flown, learning } = sources;
        let frame = PlanFrame::of(flown);
        let coordinates = Coordinates { frame, heading_rad: flown.heading_rad() };
        let real = flown.vehicle == "real";
        let record = flown.flight.as_ref().ok().map(|r| r.record.as_slice()).unwrap_or_default();
        let mut flight = FlightSeries::new(&log.samples, &coordinates);
        if real {
            // What the host asks for is not what the vehicle commands in a maneuver: that is in its record.
            (flight.rate_command, flight.thrust_command) = (None, None);
        }
        Self {
            title: picture.title.clone(),
            subtitle: picture.subtitle.clone(),
            outcome: flown.outcome().to_owned(),
            reason: flown.reason(),
            success: flown.is_success(),
            began: frame.is_some(),
            flown_is: if real { "seen by the cameras" } else { "true" },
            facts: facts(flown),
            duration_s: f64::from(flown.prepared.table.duration_s()),
            limits: picture.limits,
            origin: origin(&flown.prepared.table),
            target: flown.prepared.table.end.cast(),
            segments: picture.segments.clone(),
            plan: PlanSeries::new(&picture.planned),
            flight,
            cameras: if real { None } else { CameraSeries::new(&log.samples, &coordinates) },
            record: frame.and_then(|_| RecordSeries::new(record, &coordinates)),
            phases: phases(&log.samples, &coordinates),
            events: log.events.iter().map(|e| moment(e, &coordinates)).collect(),
            certificate: flown.prepared.solution.as_ref().map(Laws::of),
            table: TableBytes::new(&flown.prepared.table, &flown.prepared.bytes),
            timings: timings(flown),
            counters: counters(flown),
            identity: identity(log, flown),
            learning,
        }
    }
}

/// The numbers that matter most.
fn facts(flown: &Flown) -> Vec<Fact> {
    let prepared = &flown.prepared;
    let mut facts = vec![
        Fact::new("duration T", format!("{:.4} s", prepared.table.duration_s())),
        Fact::new(
            "certificate",
            match (&prepared.solution, origin(&prepared.table)) {
                (Some(_), _) => "verified",
                (None, "learned") => "none: learned",
                (None, _) => "not with the file",
            },
        ),
        Fact::new("table", format!("{} bytes", prepared.bytes.len())),
        Fact::new("full turns", flown.turns().to_string()),
    ];
    let speed = flown.peak_speed_mps();
    facts.extend(speed.map(|(name, speed_mps)| Fact::new(name, format!("{speed_mps:.2} m/s"))));
    if let Some(e) = flown.final_error() {
        facts.push(Fact::new("end error, position", format!("{:.3} m", e.x_m.hypot(e.z_m))));
        facts.push(Fact::new("end error, velocity", format!("{:.3} m/s", e.vx_mps.hypot(e.vz_mps))));
        facts.push(Fact::new("end error, pitch", format!("{:.4} rad", e.theta_rad.abs())));
    }
    facts
}

/// A phase lasts from its first sample to the first of the next.
fn phases(samples: &[FlightSample], coordinates: &Coordinates) -> Vec<Span> {
    let mut phases: Vec<Span> = Vec::new();
    for sample in samples {
        let t_s = coordinates.since_s(sample.time_ns);
        match phases.last_mut() {
            Some(last) if last.name == sample.phase => last.to_s = t_s,
            last => {
                if let Some(last) = last {
                    last.to_s = t_s;
                }
                phases.push(Span { name: sample.phase.clone(), from_s: t_s, to_s: t_s });
            }
        }
    }
    phases
}

fn moment(event: &LogEvent, coordinates: &Coordinates) -> Moment {
    let line = event.text.strip_prefix(FIRMWARE_LINE);
    let says = |level: &str| line.is_some_and(|l| l.split(' ').nth(1) == Some(level));
    let kind = match event.level {
        EventLevel::Error => Kind::Error,
        EventLevel::Warning => Kind::Warning,
        _ if says("ERROR") => Kind::Error,
        _ if says("WARN") => Kind::Warning,
        _ if line.is_some() => Kind::Firmware,
        _ => Kind::Info,
    };
    Moment { t_s: coordinates.since_s(event.time_ns), text: event.text.clone(), kind }
}

/// What was measured of the flight controller: by the emulator, or by the board itself.
fn timings(flown: &Flown) -> Vec<Timing> {
    match (&flown.emulated, flown.flight.as_ref().ok().and_then(|r| r.board)) {
        (Some(e), _) => emulated_timings(e),
        (None, Some(board)) => {
            let us = |ns: u32| f64::from(ns) * 1e-3;
            let own = |label, range, unit, digits, meaning| Timing {
                label,
                range,
                unit,
                digits,
                emulated: false,
                meaning,
            };
            vec![
                own(
                    "gyro to motors",
                    [us(board.latency_min_ns), us(board.latency_max_ns)],
                    "µs",
                    1,
                    "data ready to the last bit for the motors: shortest and longest since arming, as the board measures it",
                ),
                own(
                    "longest tick",
                    [us(board.tick_max_ns); 2],
                    "µs",
                    1,
                    "longest run of a control tick since power-up, link work included",
                ),
                own(
                    "load",
                    [f64::from(board.load_permille) * 0.1; 2],
                    "%",
                    1,
                    "part of the last second that the processor was awake",
                ),
                own(
                    "stack",
                    [f64::from(board.stack_used_bytes); 2],
                    "bytes",
                    0,
                    "deepest use since power-up",
                ),
            ]
        }
        (None, None) => Vec::new(),
    }
}

fn emulated_timings(e: &EmulatedFlight) -> Vec<Timing> {
    let figure =
        |label, range, unit, digits, meaning| Timing { label, range, unit, digits, emulated: true, meaning };
    vec![
        figure(
            "gyro to motors",
            e.latency_us,
            "µs",
            1,
            "latency: data ready to the end of the last motor's frame, median",
        ),
        figure("jitter", e.jitter_us, "µs", 2, "distance from that median which 99.9 % of the ticks keep"),
        figure(
            "instructions",
            [e.board.tick_instructions; 2],
            "a tick",
            0,
            "of a control tick, mean; known only once",
        ),
        figure(
            "load",
            [e.board.load * 100.0; 2],
            "%",
            1,
            "part of the time that the processor was awake, with the slower timing",
        ),
        figure(
            "real-time factor",
            [e.real_time_factor; 2],
            "",
            2,
            "virtual time over wall time: how fast this machine emulated",
        ),
    ]
}

/// Who flew what with which software.
fn identity(log: &FlightLog, flown: &Flown) -> Vec<Fact> {
    let mut identity = vec![
        Fact::new("mintime", log.header.mintime_version.clone()),
        Fact::new(
            "vehicle",
            match flown.vehicle {
                "virtual" => "virtual: the firmware image on an emulated flight controller",
                "hosted" => "hosted: the flight logic in the host's process",
                "real" => "real, seen by motion capture",
                other => other,
            },
        ),
    ];
    if flown.vehicle != "real" {
        identity.push(Fact::new("simulated airframe", log.header.plant.clone()));
        identity.push(Fact::new("seed", log.header.seed.to_string()));
    }
    if let Ok(result) = &flown.flight {
        let id = &result.identity;
        let [major, minor, patch] = id.firmware_version;
        identity.extend([
            Fact::new("firmware", format!("{major}.{minor}.{patch}, protocol {PROTOCOL}")),
            Fact::new("vehicle file", format!("{:08x}", id.vehicle)),
            Fact::new("session", format!("{:08x}{}", id.session, if id.paired { ", paired" } else { "" })),
        ]);
    }
    if let Some(e) = &flown.emulated {
        identity.extend([
            Fact::new("image, SHA-256", e.image_sha256.clone()),
            Fact::new("image, size", format!("{} bytes of flash, {} of RAM", e.flash_bytes, e.ram_bytes)),
        ]);
    }
    identity.extend([
        Fact::new("table, CRC-32", format!("{:08x}", flown.prepared.table.checksum())),
        Fact::new("time", format!("{:.1} s of flight in {:.2} s", flown.virtual_time_s, flown.wall_time_s)),
    ]);
    identity
}

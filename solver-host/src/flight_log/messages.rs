//! The messages of a flight log: which sample goes to which topic at which time, and its JSON.

use mintime_shared::model::State;
use serde::Serialize;

use super::data::{EventLevel, FlightLog, FlightSample, LogEvent, PlannedSample, RecordSample};
use super::schemas::Topic;

/// Name of the fixed frame.
const WORLD: &str = "world";
/// Name of the body frame.
const VEHICLE: &str = "vehicle";

/// One message before it is written: time in ns, topic, and what it is made from.
#[derive(Clone, Copy)]
pub(super) struct Message<'a> {
    pub(super) time_ns: u64,
    pub(super) topic: Topic,
    source: Source<'a>,
}

#[derive(Clone, Copy)]
enum Source<'a> {
    Sample(&'a FlightSample),
    Planned(&'a PlannedSample),
    Record(&'a RecordSample),
    Event(&'a LogEvent),
}

/// All messages of a log in order of time, then topic.
pub(super) fn messages(log: &FlightLog) -> Vec<Message<'_>> {
    let start_ns = log.header.maneuver_start_ns.unwrap_or(0);
    let mut all = Vec::with_capacity(log.samples.len() * 7 + log.planned.len() + log.record.len());
    for sample in &log.samples {
        let mut push =
            |topic| all.push(Message { time_ns: sample.time_ns, topic, source: Source::Sample(sample) });
        push(Topic::Tf);
        push(Topic::Truth);
        if sample.mocap.is_some() {
            push(Topic::Mocap);
        }
        if sample.gyro_radps.is_some() {
            push(Topic::Gyro);
        }
        push(Topic::Setpoint);
        // Of a real vehicle the host knows only what the cameras see and telemetry says.
        if sample.throttle.iter().all(|t| t.is_finite()) {
            push(Topic::Motors);
        }
        if sample.battery_v.is_finite() {
            push(Topic::Battery);
        }
    }
    all.extend(log.planned.iter().map(|planned| {
        // A cast from a float saturates, and NaN becomes 0: no plan can make this overflow.
        let after_start_ns = (planned.t_s * 1e9).round() as u64;
        let time_ns = start_ns.saturating_add(after_start_ns);
        Message { time_ns, topic: Topic::Plan, source: Source::Planned(planned) }
    }));
    all.extend(log.record.iter().map(|record| {
        let time_ns = start_ns.saturating_add(u64::from(record.t_us) * 1000);
        Message { time_ns, topic: Topic::Record, source: Source::Record(record) }
    }));
    all.extend(log.events.iter().map(|event| Message {
        time_ns: event.time_ns,
        topic: Topic::Events,
        source: Source::Event(event),
    }));
    // Stable: samples of one topic at one time keep their order.
    all.sort_by_key(|message| (message.time_ns, message.topic));
    all
}

impl Message<'_> {
    /// The message as JSON. Numbers that are not finite become `null`.
    pub(super) fn json(&self) -> serde_json::Result<Vec<u8>> {
        match self.source {
            Source::Sample(sample) => sample_json(self.topic, sample),
            Source::Planned(planned) => serde_json::to_vec(&Plan {
                t_s: planned.t_s,
                state: planned.state,
                rate_radps: planned.rate_radps,
                thrust_mps2: planned.thrust_mps2,
                phi_r: planned.phi_r,
                phi_t: planned.phi_t,
            }),
            Source::Record(record) => serde_json::to_vec(&Record {
                t_us: record.t_us,
                gyro: record.gyro_radps.into(),
                commanded_rate_radps: record.commanded_rate_radps,
                commanded_thrust_mps2: record.commanded_thrust_mps2,
                throttle: record.throttle,
            }),
            Source::Event(event) => serde_json::to_vec(&Log {
                timestamp: event.time_ns.into(),
                level: match event.level {
                    EventLevel::Debug => 1,
                    EventLevel::Info => 2,
                    EventLevel::Warning => 3,
                    EventLevel::Error => 4,
                },
                message: &event.text,
                name: "mintime",
                file: "",
                line: 0,
            }),
        }
    }
}

fn sample_json(topic: Topic, sample: &FlightSample) -> serde_json::Result<Vec<u8>> {
    let truth = &sample.truth;
    match topic {
        Topic::Tf => serde_json::to_vec(&FrameTransform {
            timestamp: sample.time_ns.into(),
            parent_frame_id: WORLD,
            child_frame_id: VEHICLE,
            translation: truth.position_m.into(),
            rotation: truth.attitude_wxyz.into(),
        }),
        Topic::Mocap => {
            let seen = sample.mocap.unwrap_or_default();
            serde_json::to_vec(&PoseInFrame {
                timestamp: seen.captured_ns.into(),
                frame_id: WORLD,
                pose: Pose { position: seen.position_m.into(), orientation: seen.attitude_wxyz.into() },
            })
        }
        Topic::Gyro => serde_json::to_vec(&Rates::from(sample.gyro_radps.unwrap_or_default())),
        Topic::Setpoint => serde_json::to_vec(&Setpoint {
            rates: sample.setpoint_radps.into(),
            thrust_mps2: sample.setpoint_thrust_mps2,
        }),
        Topic::Motors => serde_json::to_vec(&Motors { throttle: sample.throttle }),
        Topic::Battery => serde_json::to_vec(&Battery { voltage_v: sample.battery_v }),
        Topic::Truth | Topic::Plan | Topic::Record | Topic::Events => serde_json::to_vec(&TruthMessage {
            phase: &sample.phase,
            position_m: truth.position_m.into(),
            velocity_mps: truth.velocity_mps.into(),
            attitude: truth.attitude_wxyz.into(),
            body_rates: truth.body_rates_radps.into(),
            thrust_mps2: truth.thrust_mps2,
            planar: truth.planar,
        }),
    }
}

#[derive(Serialize)]
struct Time {
    sec: u64,
    nsec: u64,
}

impl From<u64> for Time {
    fn from(ns: u64) -> Self {
        Self { sec: ns / 1_000_000_000, nsec: ns % 1_000_000_000 }
    }
}

#[derive(Serialize)]
struct Vector {
    x: f64,
    y: f64,
    z: f64,
}

impl From<[f64; 3]> for Vector {
    fn from([x, y, z]: [f64; 3]) -> Self {
        Self { x, y, z }
    }
}

#[derive(Serialize)]
struct Quaternion {
    x: f64,
    y: f64,
    z: f64,
    w: f64,
}

impl From<[f64; 4]> for Quaternion {
    /// From the order (w, x, y, z).
    fn from([w, x, y, z]: [f64; 4]) -> Self {
        Self { x, y, z, w }
    }
}

#[derive(Serialize)]
struct Rates<T> {
    roll_radps: T,
    pitch_radps: T,
    yaw_radps: T,
}

impl<T> From<[T; 3]> for Rates<T> {
    fn from([roll_radps, pitch_radps, yaw_radps]: [T; 3]) -> Self {
        Self { roll_radps, pitch_radps, yaw_radps }
    }
}

#[derive(Serialize)]
struct FrameTransform {
    timestamp: Time,
    parent_frame_id: &'static str,
    child_frame_id: &'static str,
    translation: Vector,
    rotation: Quaternion,
}

#[derive(Serialize)]
struct PoseInFrame {
    timestamp: Time,
    frame_id: &'static str,
    pose: Pose,
}

#[derive(Serialize)]
struct Pose {
    position: Vector,
    orientation: Quaternion,
}

#[derive(Serialize)]
struct TruthMessage<'a> {
    phase: &'a str,
    position_m: Vector,
    velocity_mps: Vector,
    attitude: Quaternion,
    body_rates: Rates<f64>,
    thrust_mps2: f64,
    planar: State<f64>,
}

#[derive(Serialize)]
struct Setpoint {
    rates: Rates<f32>,
    thrust_mps2: f32,
}

#[derive(Serialize)]
struct Motors {
    throttle: [f32; 4],
}

#[derive(Serialize)]
struct Battery {
    voltage_v: f32,
}

#[derive(Serialize)]
struct Plan {
    t_s: f64,
    state: State<f64>,
    rate_radps: f64,
    thrust_mps2: f64,
    phi_r: f64,
    phi_t: f64,
}

#[derive(Serialize)]
struct Record {
    t_us: u32,
    gyro: Rates<f32>,
    commanded_rate_radps: f32,
    commanded_thrust_mps2: f32,
    throttle: [f32; 4],
}

#[derive(Serialize)]
struct Log<'a> {
    timestamp: Time,
    level: u8,
    message: &'a str,
    name: &'static str,
    file: &'static str,
    line: u32,
}

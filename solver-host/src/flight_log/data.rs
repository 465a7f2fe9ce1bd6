//! What a flight leaves behind, as plain data. Axes and signs are those of [`mintime_shared::frames`].

use mintime_shared::model::State;

/// A whole flight: facts, plan, samples, events and the vehicle's own record.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FlightLog {
    /// Facts about the flight as a whole.
    pub header: LogHeader,
    /// The planned maneuver, in order of time.
    pub planned: Vec<PlannedSample>,
    /// The flight as the simulator knows it, or as the cameras saw a real one, in order of time.
    pub samples: Vec<FlightSample>,
    /// What happened, in order of time.
    pub events: Vec<LogEvent>,
    /// The record downloaded from the vehicle, in order of time.
    pub record: Vec<RecordSample>,
}

/// Facts about a flight that do not depend on where its files went.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LogHeader {
    /// Version of mintime that flew.
    pub mintime_version: String,
    /// Seed of every random number in the flight.
    pub seed: u64,
    /// Which simulated plant was flown, e.g. `nominal`.
    pub plant: String,
    /// Which kind of vehicle flew, e.g. `hosted`.
    pub vehicle: String,
    /// Planned state at the start of the maneuver, SI units.
    pub from: State<f64>,
    /// Planned state at its end, SI units.
    pub to: State<f64>,
    /// Planned duration T of the maneuver, s.
    pub duration_s: f64,
    /// Full turns of the maneuver, positive towards +x.
    pub turns: i32,
    /// The maneuver table as it was uploaded.
    pub table: Vec<u8>,
    /// When the maneuver began, ns of virtual time; `None` if it never did. Places `/plan` and `/record` in time.
    pub maneuver_start_ns: Option<u64>,
    /// Further facts as (name, value). A name used twice keeps its last value.
    pub facts: Vec<(String, String)>,
}

/// The plan at one instant.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PlannedSample {
    /// Time from the start of the maneuver, s.
    pub t_s: f64,
    /// Planned state, SI units.
    pub state: State<f64>,
    /// Planned pitch rate, rad/s.
    pub rate_radps: f64,
    /// Planned collective thrust per mass, m/s².
    pub thrust_mps2: f64,
    /// Switching function Φ_R of the pitch rate, dimensionless: the rate is at +limit where it is negative. NaN where
    /// there is none, as in a learned maneuver.
    pub phi_r: f64,
    /// Switching function Φ_T of the thrust, dimensionless: the thrust is at its maximum where it is negative. NaN
    /// where there is none.
    pub phi_t: f64,
}

/// The flight at one instant, as the simulator knows it; of a real vehicle, as the cameras saw it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FlightSample {
    /// Virtual time from the start of the flight, ns.
    pub time_ns: u64,
    /// Phase of the flight, e.g. `hover`, `maneuver`, `catch`.
    pub phase: String,
    /// True motion; of a real vehicle that which the cameras saw, NaN where they see nothing.
    pub truth: Truth,
    /// Roll, pitch and yaw rate as the gyro delivered them, rad/s; `None` if there was no sample.
    pub gyro_radps: Option<[f32; 3]>,
    /// Commanded roll, pitch and yaw rate, rad/s.
    pub setpoint_radps: [f32; 3],
    /// Commanded collective thrust per mass, m/s².
    pub setpoint_thrust_mps2: f32,
    /// Throttle of motors 1 to 4, 0 to 1; NaN where it is not known.
    pub throttle: [f32; 4],
    /// Battery voltage, V; NaN where it is not known.
    pub battery_v: f32,
    /// A motion capture measurement, if one arrived at this instant.
    pub mocap: Option<MocapSample>,
}

/// True motion of the vehicle.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Truth {
    /// Position of the centre of mass in the world frame, m.
    pub position_m: [f64; 3],
    /// Its velocity in the world frame, m/s.
    pub velocity_mps: [f64; 3],
    /// Attitude, body to world, as a unit quaternion (w, x, y, z).
    pub attitude_wxyz: [f64; 4],
    /// Roll, pitch and yaw rate in the body frame, rad/s.
    pub body_rates_radps: [f64; 3],
    /// Collective thrust per mass, m/s².
    pub thrust_mps2: f64,
    /// The same motion in the maneuver's plane, SI units, θ unwrapped.
    pub planar: State<f64>,
}

/// A pose as motion capture measured it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct MocapSample {
    /// When the cameras looked, ns; the sample's own time is when the pose arrived.
    pub captured_ns: u64,
    /// Position in the world frame, m.
    pub position_m: [f64; 3],
    /// Attitude, body to world, as a unit quaternion (w, x, y, z).
    pub attitude_wxyz: [f64; 4],
}

/// One tick of the vehicle's own record.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct RecordSample {
    /// Time since the record's first tick by the vehicle's own clock, µs.
    pub t_us: u32,
    /// Measured roll, pitch and yaw rate, rad/s.
    pub gyro_radps: [f32; 3],
    /// Commanded pitch rate, rad/s.
    pub commanded_rate_radps: f32,
    /// Commanded collective thrust per mass, m/s².
    pub commanded_thrust_mps2: f32,
    /// Throttle of motors 1 to 4, 0 to 1.
    pub throttle: [f32; 4],
}

/// Something that happened.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct LogEvent {
    /// Virtual time from the start of the flight, ns.
    pub time_ns: u64,
    /// One sentence.
    pub text: String,
    /// How serious.
    pub level: EventLevel,
}

/// How serious an event is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum EventLevel {
    /// Detail for developers.
    Debug,
    /// The normal course.
    #[default]
    Info,
    /// Unusual; the flight goes on.
    Warning,
    /// The flight could not go on as asked.
    Error,
}

//! The hosted vehicle: the flight logic in this process, in closed loop with the simulator, in virtual time.
//!
//! The same library that the flight controller runs is fed sensor samples and serial bytes and drives the simulated
//! motors. Bytes travel at the pace of the serial line. Truth is logged on the side.

use mintime_firmware::config::{Capabilities, VehicleConfig};
use mintime_firmware::flight::TickInput;
use mintime_firmware::gyro::ImuSample;
use mintime_firmware::vehicle::Vehicle;
use mintime_shared::messages::{FlightState, RECORD_BYTES};
use mintime_shared::replay::TICK_PERIOD_US;
use mintime_simulator::{Command, Event, Simulator, SimulatorError, Start, Truth, VehicleParameters};
use nalgebra::{Quaternion, UnitQuaternion, Vector3};

use super::connection::{Connection, ConnectionError, Phase, Pose};
use crate::flight_log::{FlightSample, MocapSample, Truth as LoggedTruth};

/// Bytes a second on a line of 921600 baud: ten bits a byte.
const LINE_BYTES_PER_S: u64 = 92_160;
/// Ticks that the vehicle's recorder holds: 4 s at 800 Hz.
const RECORD_TICKS: usize = 3200;
/// From the gyro's data-ready edge until the motors have their command, ns: the board's budget.
const LATENCY_NS: u64 = 100_000;
/// Nominal tick, ns.
const TICK_NS: u64 = TICK_PERIOD_US as u64 * 1000;
/// Without a sample for this long after the last tick the flight logic runs without one, ns: the board's timer.
const SAMPLE_TIMEOUT_NS: u64 = TICK_NS * 3 / 2;
/// Outside a maneuver every so many ticks are logged: 100 Hz.
const CALM_LOG_EVERY: u32 = 8;
/// Every tick is logged for this long after a maneuver, ns.
const LOG_AFTER_NS: u64 = 400_000_000;
/// No pose for this long means that motion capture has stopped, ns.
const POSE_TIMEOUT_NS: u64 = 1_000_000_000;

/// What truth says about the maneuver.
#[derive(Clone, Debug, Default)]
pub struct Trace {
    /// Samples of the whole flight, dense around the maneuver.
    pub samples: Vec<FlightSample>,
    /// When the maneuver began, ns.
    pub start_ns: Option<u64>,
    /// Truth then.
    pub start: Option<Truth>,
    /// Truth when the table's duration had passed, had it not been cut short.
    pub end: Option<Truth>,
    /// Truth at the end of the flight.
    pub last: Option<Truth>,
}

/// A flight controller in this process and a simulated airframe around it.
#[derive(Debug)]
pub struct HostedVehicle {
    simulator: Simulator,
    vehicle: Vehicle<Vec<[u8; RECORD_BYTES]>>,
    /// The planning model takes its commands at once.
    latency_ns: u64,
    heading_rad: f64,
    maneuver_ns: u64,
    to_vehicle: std::collections::VecDeque<u8>,
    to_host: Vec<u8>,
    phase: Phase,
    last_tick_ns: u64,
    /// When the board's timer runs the flight logic without a sample, ns.
    timeout_ns: u64,
    ticks: u32,
    dense_until_ns: u64,
    trace: Trace,
}

impl HostedVehicle {
    /// A vehicle on the ground at `ground_z_m` below the origin of the world, level and at rest.
    ///
    /// `maneuver_s` is the duration after whose passing truth is noted.
    ///
    /// # Errors
    /// [`SimulatorError`] for impossible parameters.
    pub fn new(
        parameters: &VehicleParameters,
        seed: u64,
        ground_z_m: f64,
        heading_rad: f64,
        maneuver_s: f64,
    ) -> Result<Self, SimulatorError> {
        let start = Start { heading_rad, ..Start::default() };
        let ideal = parameters.model == mintime_simulator::Model::Planning;
        let capabilities = Capabilities { gyro: true, motors: true };
        let record = vec![[0; RECORD_BYTES]; RECORD_TICKS];
        Ok(Self {
            simulator: Simulator::new(parameters, seed, ground_z_m, start)?,
            vehicle: Vehicle::new(VehicleConfig::REFERENCE, capabilities, record),
            latency_ns: if ideal { 0 } else { LATENCY_NS },
            heading_rad,
            maneuver_ns: (maneuver_s * 1e9).round() as u64,
            to_vehicle: std::collections::VecDeque::new(),
            to_host: Vec::new(),
            phase: Phase::default(),
            last_tick_ns: 0,
            timeout_ns: SAMPLE_TIMEOUT_NS,
            ticks: 0,
            dense_until_ns: 0,
            trace: Trace::default(),
        })
    }

    /// Virtual time, ns.
    pub fn now_ns(&self) -> u64 {
        self.simulator.now_ns()
    }

    /// The simulated world, to break something in it.
    pub fn simulator_mut(&mut self) -> &mut Simulator {
        &mut self.simulator
    }

    /// What has been logged, with the truth of this instant.
    pub fn into_trace(mut self) -> Trace {
        self.trace.last = Some(self.simulator.truth());
        self.trace
    }

    /// One control tick of the vehicle, with a sample or because none came in time.
    fn tick(&mut self, time_ns: u64, sample: Option<&mintime_simulator::ImuSample>) {
        self.timeout_ns = time_ns + if sample.is_some() { SAMPLE_TIMEOUT_NS } else { TICK_NS };
        let interval_ns = time_ns - core::mem::replace(&mut self.last_tick_ns, time_ns);
        let budget = (interval_ns.saturating_mul(LINE_BYTES_PER_S) / 1_000_000_000) as usize;
        let arriving = budget.min(self.to_vehicle.len());
        let bytes: Vec<u8> = self.to_vehicle.drain(..arriving).collect();
        self.vehicle.receive(&bytes);

        let before = self.vehicle.state();
        let imu = sample.map(|s| ImuSample { gyro_radps: s.rates_radps, accel_mps2: s.specific_force_mps2 });
        let battery_v = Some(self.simulator.battery_v());
        let input = TickInput { now_us: time_ns / 1000, imu, battery_v, kill: false };
        let output = self.vehicle.tick(&input);

        let mut out = vec![0; budget];
        let sent = self.vehicle.transmit(&mut out);
        self.to_host.extend_from_slice(&out[..sent]);

        if self.latency_ns > 0 {
            self.simulator.advance_to(time_ns + self.latency_ns);
        }
        let state = self.vehicle.state();
        if state == FlightState::Maneuver && before != FlightState::Maneuver {
            self.trace.start_ns = Some(time_ns);
            self.trace.start = Some(self.simulator.truth());
            self.trace.end = None;
            self.dense_until_ns = time_ns + self.maneuver_ns + LOG_AFTER_NS;
        }
        self.simulator.apply(Command {
            throttle: output.throttle.unwrap_or_default(),
            rates_radps: output.setpoint.rates_radps,
            thrust_mps2: output.setpoint.thrust_mps2,
        });

        self.ticks = self.ticks.wrapping_add(1);
        if time_ns < self.dense_until_ns || self.ticks.is_multiple_of(CALM_LOG_EVERY) {
            self.trace.samples.push(FlightSample {
                time_ns,
                phase: self.phase.name().to_owned(),
                truth: self.logged_truth(),
                gyro_radps: sample.map(|s| s.rates_radps),
                setpoint_radps: output.setpoint.rates_radps,
                setpoint_thrust_mps2: output.setpoint.thrust_mps2,
                throttle: output.throttle.unwrap_or_default(),
                battery_v: self.simulator.battery_v(),
                mocap: None,
            });
        }
    }

    fn logged_truth(&self) -> LoggedTruth {
        let truth = self.simulator.truth();
        LoggedTruth {
            position_m: truth.position_m,
            velocity_mps: truth.velocity_mps,
            attitude_wxyz: truth.attitude,
            body_rates_radps: truth.rates_radps,
            thrust_mps2: truth.thrust_mps2,
            planar: truth.planar(self.heading_rad),
        }
    }

    /// Stops at the instant at which the maneuver's duration has passed, to note truth.
    fn note_end(&mut self) {
        let Some(end_ns) = self.trace.start_ns.map(|start| start + self.maneuver_ns) else {
            return;
        };
        if self.trace.end.is_none() && self.simulator.next_event_time_ns() > end_ns {
            self.simulator.advance_to(end_ns);
            self.trace.end = Some(self.simulator.truth());
        }
    }
}

impl Connection for HostedVehicle {
    fn next_pose(&mut self) -> Result<Pose, ConnectionError> {
        let deadline_ns = self.simulator.now_ns() + POSE_TIMEOUT_NS;
        loop {
            self.note_end();
            if self.simulator.next_event_time_ns() > self.timeout_ns {
                let time_ns = self.timeout_ns;
                self.simulator.advance_to(time_ns);
                self.tick(time_ns, None);
                if time_ns > deadline_ns {
                    return Err(ConnectionError::NoPose);
                }
                continue;
            }
            let (time_ns, event) = self.simulator.next_event().ok_or(ConnectionError::NoPose)?;
            match event {
                Event::Gyro(sample) => self.tick(time_ns, Some(&sample)),
                Event::MotionCapture(pose) => {
                    let [w, x, y, z] = pose.attitude;
                    if let Some(last) = self.trace.samples.last_mut() {
                        last.mocap = Some(MocapSample {
                            captured_ns: pose.captured_ns,
                            position_m: pose.position_m,
                            attitude_wxyz: pose.attitude,
                        });
                    }
                    return Ok(Pose {
                        captured_s: pose.captured_ns as f64 * 1e-9,
                        arrived_s: time_ns as f64 * 1e-9,
                        position_m: Vector3::from(pose.position_m),
                        attitude: UnitQuaternion::from_quaternion(Quaternion::new(w, x, y, z)),
                    });
                }
            }
            if time_ns > deadline_ns {
                return Err(ConnectionError::NoPose);
            }
        }
    }

    fn send(&mut self, bytes: &[u8]) -> Result<(), ConnectionError> {
        self.to_vehicle.extend(bytes);
        Ok(())
    }

    fn receive(&mut self, into: &mut Vec<u8>) -> Result<(), ConnectionError> {
        into.append(&mut self.to_host);
        Ok(())
    }

    fn enter(&mut self, phase: Phase) {
        self.phase = phase;
    }
}

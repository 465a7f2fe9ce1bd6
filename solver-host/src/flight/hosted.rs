//! The hosted vehicle: the flight logic in this process, in closed loop with the simulator, in virtual time.
//!
//! The same library that the flight controller runs is fed sensor samples and serial bytes and drives the simulated
//! motors. Bytes travel at the pace of the serial line. Truth is logged on the side.

use std::collections::VecDeque;

use mintime_firmware::config::{Capabilities, VehicleConfig};
use mintime_firmware::flight::TickInput;
use mintime_firmware::gyro::ImuSample;
use mintime_firmware::vehicle::Vehicle;
use mintime_shared::messages::{KillSwitch, RECORD_BYTES};
use mintime_shared::replay::TICK_PERIOD_US;
use mintime_simulator::{Event, Simulator, SimulatorError};

use super::connection::{Connection, ConnectionError, Phase, Pose};
use super::world::{POSE_TIMEOUT_NS, Scene, Tick, Trace, World, is_planning_model};

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

/// A flight controller in this process and a simulated airframe around it.
#[derive(Debug)]
pub struct HostedVehicle {
    world: World,
    vehicle: Vehicle<Vec<[u8; RECORD_BYTES]>>,
    /// The planning model takes its commands at once.
    latency_ns: u64,
    to_vehicle: VecDeque<u8>,
    to_host: Vec<u8>,
    last_tick_ns: u64,
    /// When the board's timer runs the flight logic without a sample, ns.
    timeout_ns: u64,
}

impl HostedVehicle {
    /// A vehicle that was just switched on.
    ///
    /// # Errors
    /// [`SimulatorError`] for impossible parameters.
    pub fn new(scene: &Scene<'_>) -> Result<Self, SimulatorError> {
        Self::told(scene, &VehicleConfig::REFERENCE)
    }

    /// The same with another vehicle file: what it was told that it is, whatever the scene makes of it.
    ///
    /// # Errors
    /// [`SimulatorError`] for impossible parameters.
    pub fn told(scene: &Scene<'_>, config: &VehicleConfig) -> Result<Self, SimulatorError> {
        let capabilities = Capabilities { gyro: true, motors: true };
        let record = vec![[0; RECORD_BYTES]; RECORD_TICKS];
        Ok(Self {
            world: World::new(scene)?,
            vehicle: Vehicle::new(Some(*config), capabilities, record),
            latency_ns: if is_planning_model(scene.parameters) { 0 } else { LATENCY_NS },
            to_vehicle: VecDeque::new(),
            to_host: Vec::new(),
            last_tick_ns: 0,
            timeout_ns: SAMPLE_TIMEOUT_NS,
        })
    }

    /// Virtual time, ns.
    pub fn now_ns(&self) -> u64 {
        self.world.simulator.now_ns()
    }

    /// The simulated world, to break something in it.
    pub fn simulator_mut(&mut self) -> &mut Simulator {
        &mut self.world.simulator
    }

    /// What has been logged, with the truth of this instant.
    pub fn into_trace(self) -> Trace {
        self.world.into_trace()
    }

    /// One control tick of the vehicle, with a sample or because none came in time.
    fn tick(&mut self, time_ns: u64, sample: Option<&mintime_simulator::ImuSample>) {
        self.timeout_ns = time_ns + if sample.is_some() { SAMPLE_TIMEOUT_NS } else { TICK_NS };
        let interval_ns = time_ns - core::mem::replace(&mut self.last_tick_ns, time_ns);
        let budget = (interval_ns.saturating_mul(LINE_BYTES_PER_S) / 1_000_000_000) as usize;
        let arriving = budget.min(self.to_vehicle.len());
        let bytes: Vec<u8> = self.to_vehicle.drain(..arriving).collect();
        self.vehicle.receive(&bytes);

        let imu = sample.map(|s| ImuSample { gyro_radps: s.rates_radps, accel_mps2: s.specific_force_mps2 });
        let battery_v = Some(self.world.simulator.battery_v());
        let input = TickInput { now_us: time_ns / 1000, imu, battery_v, kill: KillSwitch::Run };
        let output = self.vehicle.tick(&input);

        let mut out = vec![0; budget];
        let sent = self.vehicle.transmit(&mut out);
        self.to_host.extend_from_slice(&out[..sent]);

        if self.latency_ns > 0 {
            self.world.simulator.advance_to(time_ns + self.latency_ns);
        }
        let tick = Tick {
            time_ns,
            sample,
            state: self.vehicle.state(),
            setpoint: output.setpoint,
            throttle: output.throttle.unwrap_or_default(),
        };
        self.world.command(&tick);
        self.world.log(&tick);
    }
}

impl Connection for HostedVehicle {
    fn next_pose(&mut self) -> Result<Pose, ConnectionError> {
        let deadline_ns = self.now_ns() + POSE_TIMEOUT_NS;
        loop {
            self.world.note_end();
            if self.world.simulator.next_event_time_ns() > self.timeout_ns {
                let time_ns = self.timeout_ns;
                self.world.simulator.advance_to(time_ns);
                self.tick(time_ns, None);
                if time_ns > deadline_ns {
                    return Err(ConnectionError::NoPose);
                }
                continue;
            }
            let (time_ns, event) = self.world.simulator.next_event().ok_or(ConnectionError::NoPose)?;
            match event {
                Event::Gyro(sample) => self.tick(time_ns, Some(&sample)),
                Event::MotionCapture(pose) => return Ok(self.world.pose(time_ns, &pose)),
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
        self.world.enter(phase);
    }
}

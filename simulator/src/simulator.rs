//! The interface: time, commands in, sensor events out.

use core::ops::Range;
use std::collections::VecDeque;

use nalgebra::{Quaternion, UnitQuaternion, Vector3};

use crate::{
    clock::NS_PER_S,
    fault::{Fault, FaultError, Faults},
    imu::{ImuSample, ImuSensor},
    motion_capture::{Cameras, PoseSample},
    parameters::{ParameterError, VehicleParameters},
    plant::Plant,
    truth::Truth,
};

/// Longest step of the integration, ns. With a quarter of a millisecond, rotor lags of tens of milliseconds and body
/// rates of tens of rad/s leave the fourth-order method an error far below that of every sensor.
const STEP_NS: u64 = 250_000;

/// Positions beyond this, m, leave the millimetre no room in the arithmetic that follows.
const POSITION_MAX_M: f64 = 1e6;

/// What the flight controller asks of the vehicle, held until the next command.
///
/// The rigid body obeys only `throttle`. The planning model obeys only `rates_radps` and `thrust_mps2`, except that all
/// throttles at zero mean motors off. Whatever is not a number counts as zero, whatever is out of range is cut off.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Command {
    /// Throttle of motors 1 to 4, 0 to 1.
    pub throttle: [f32; 4],
    /// Commanded body rates about the body axes x (forward), y (left), z (up), rad/s.
    pub rates_radps: [f32; 3],
    /// Commanded collective thrust per mass, m/s².
    pub thrust_mps2: f32,
}

impl Command {
    /// Motors off.
    pub const OFF: Self = Self { throttle: [0.0; 4], rates_radps: [0.0; 3], thrust_mps2: 0.0 };
}

/// Where the vehicle stands at time zero: at rest and level.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Start {
    /// Position in the world, m.
    pub x_m: f64,
    /// Position in the world, m.
    pub y_m: f64,
    /// Height above the ground, m: 0 stands on it, above 0 is let go in the air.
    pub height_m: f64,
    /// Heading of the body x axis, rad from world x towards world y.
    pub heading_rad: f64,
}

/// Something a sensor says.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Event {
    /// The gyro's data-ready edge, with what the chip then holds.
    Gyro(ImuSample),
    /// A pose arrives from the motion capture.
    MotionCapture(PoseSample),
}

/// Why a simulation cannot start.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum SimulatorError {
    /// The vehicle cannot exist.
    #[error(transparent)]
    Parameters(#[from] ParameterError),
    /// The start or the ground is not a usable place.
    #[error(
        "the start is not usable: give finite numbers below a million metres, with a height of zero or above"
    )]
    Start,
}

/// A vehicle in flight, its sensors, and true time, in nanoseconds from zero.
///
/// Everything is deterministic: the same parameters, seed and sequence of calls give the same bytes.
#[derive(Clone, Debug)]
pub struct Simulator {
    now_ns: u64,
    plant: Plant,
    imu: ImuSensor,
    cameras: Cameras,
    faults: Faults,
    /// What the sensors have said and nobody has fetched yet, by time.
    events: VecDeque<(u64, Event)>,
}

impl Simulator {
    /// A vehicle at rest. All that is *drawn* in [`VehicleParameters`] comes from the seed.
    ///
    /// # Errors
    /// [`SimulatorError`] if the vehicle cannot exist or the start is not a usable place.
    pub fn new(
        parameters: &VehicleParameters,
        seed: u64,
        ground_z_m: f64,
        start: Start,
    ) -> Result<Self, SimulatorError> {
        parameters.validate()?;
        let Start { x_m, y_m, height_m, heading_rad } = start;
        let usable = [x_m, y_m, height_m, heading_rad, ground_z_m].iter().all(|v| v.abs() <= POSITION_MAX_M);
        if !usable || height_m < 0.0 {
            return Err(SimulatorError::Start);
        }
        let plant = Plant::new(
            parameters,
            seed,
            ground_z_m,
            Vector3::new(x_m, y_m, ground_z_m + height_m),
            heading_rad,
        );
        let imu = ImuSensor::new(parameters, seed, plant.specific_force());
        let cameras = Cameras::new(parameters, seed);
        Ok(Self { now_ns: 0, plant, imu, cameras, faults: Faults::default(), events: VecDeque::new() })
    }

    /// Draws the noise of gyro, accelerometer and cameras from another seed from now on: another flight of the same vehicle,
    /// whose own errors stay what they are.
    pub fn redraw_noise(&mut self, seed: u64) {
        self.imu.redraw_noise(seed);
        self.cameras.redraw_noise(seed);
    }

    /// True time, ns.
    pub fn now_ns(&self) -> u64 {
        self.now_ns
    }

    /// When the next event comes, ns of true time; `u64::MAX` if none ever will.
    pub fn next_event_time_ns(&self) -> u64 {
        let queued = self.events.front().map_or(u64::MAX, |(time, _)| *time);
        queued.min(self.imu.next_ns(&self.faults)).min(self.cameras.next_ns().1)
    }

    /// Advances to the next event and returns it with its time, ns; an event that [`advance_to`](Self::advance_to) has
    /// already passed comes first. `None` only where faults keep every sensor silent for ever.
    pub fn next_event(&mut self) -> Option<(u64, Event)> {
        let time = self.next_event_time_ns();
        if time == u64::MAX {
            return None;
        }
        self.advance_to(time);
        self.events.pop_front()
    }

    /// Advances true time. Events on the way wait for [`next_event`](Self::next_event). A time in the past does nothing.
    pub fn advance_to(&mut self, time_ns: u64) {
        loop {
            let sample = self.imu.next_ns(&self.faults);
            let (frame, arrival) = self.cameras.next_ns();
            if sample.min(frame) > time_ns {
                break;
            }
            if sample <= frame {
                self.integrate_to(sample);
                let reading = self.imu.sample(sample, &self.faults);
                self.queue(sample, Event::Gyro(reading));
            } else {
                self.integrate_to(frame);
                let (position, attitude) = (self.plant.position(), self.plant.attitude());
                let pose = self.cameras.take(frame, position, attitude, &self.faults);
                self.queue(arrival, Event::MotionCapture(pose));
            }
        }
        self.integrate_to(time_ns);
    }

    /// Takes a command, in force from now on.
    pub fn apply(&mut self, command: Command) {
        self.plant.apply(&command);
    }

    /// Holds the vehicle in an attitude, body to world as (w, x, y, z), and lets it go, at rest. Only in the air makes it
    /// sense. What is no rotation is level.
    pub fn let_go(&mut self, [w, x, y, z]: [f64; 4]) {
        let quaternion = Quaternion::new(w, x, y, z);
        let attitude = UnitQuaternion::try_new(quaternion, 1e-6).filter(|q| q.norm().is_finite());
        self.plant.let_go(attitude.unwrap_or_default());
    }

    /// Breaks something during a span of true time, ns; `u64::MAX` as its end is for ever. The past cannot be changed: a
    /// window that has begun acts from now on.
    ///
    /// # Errors
    /// [`FaultError`] for a rotor that does not exist.
    pub fn inject(&mut self, fault: Fault, when_ns: Range<u64>) -> Result<(), FaultError> {
        self.faults.add(fault, when_ns)?;
        self.imu.plan(&self.faults);
        self.cameras.plan(&self.faults);
        Ok(())
    }

    /// The true state of the vehicle.
    pub fn truth(&self) -> Truth {
        self.plant.truth(self.now_ns)
    }

    /// Battery voltage under load as an ideal voltmeter reads it, V.
    pub fn battery_v(&self) -> f32 {
        self.plant.battery_v() as f32
    }

    fn queue(&mut self, time_ns: u64, event: Event) {
        let place = self.events.partition_point(|(time, _)| *time <= time_ns);
        self.events.insert(place, (time_ns, event));
    }

    /// Moves vehicle and sensors on, in steps that never cross a multiple of [`STEP_NS`].
    fn integrate_to(&mut self, time_ns: u64) {
        while self.now_ns < time_ns {
            let grid = (self.now_ns / STEP_NS + 1).saturating_mul(STEP_NS);
            let end = time_ns.min(grid).min(self.faults.next_rotor_change_ns(self.now_ns));
            let step_s = (end - self.now_ns) as f64 / NS_PER_S;
            let dead = self.faults.dead_rotors(self.now_ns);
            self.now_ns = end;
            self.plant.step(step_s, end, dead);
            self.imu.advance(self.plant.rates(), self.plant.specific_force(), self.plant.rotors(), step_s);
        }
    }
}

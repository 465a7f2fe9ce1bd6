//! The physical vehicle: a six-degree-of-freedom quadrotor with rotor lag, drag and a sagging battery, seen through an
//! imperfect gyro and a late, noisy motion capture system.
//!
//! The axes, signs and motor numbers are those of [`mintime_shared::frames`]. True time runs in nanoseconds from zero.
//! A [`Simulator`] takes [`Command`]s and gives [`Event`]s; between them it integrates:
//!
//! ```
//! use mintime_simulator::{Command, Event, Simulator, Start, VehicleParameters};
//!
//! let vehicle = VehicleParameters::nominal();
//! let mut simulator = Simulator::new(&vehicle, 1, 0.0, Start::default())?;
//! let throttle = vehicle.throttle(12.0, f64::from(simulator.battery_v())) as f32;
//! while let Some((time_ns, event)) = simulator.next_event()
//!     && time_ns < 300_000_000
//! {
//!     if let Event::Gyro(sample) = event {
//!         // A flight controller would look at `sample` here.
//!         simulator.apply(Command { throttle: [throttle; 4], ..Command::OFF });
//!     }
//! }
//! assert!(simulator.truth().position_m[2] > 0.0);
//! # Ok::<(), mintime_simulator::SimulatorError>(())
//! ```
//!
//! Every imperfection has its own random stream, drawn from one seed: silencing one leaves the others as they were.

mod clock;
mod fault;
mod filter;
mod imu;
mod motion_capture;
mod noise;
mod parameters;
mod planning;
mod plant;
mod power;
mod rigid_body;
mod simulator;
mod truth;

pub use fault::{Fault, FaultError};
pub use imu::ImuSample;
pub use motion_capture::PoseSample;
pub use parameters::{
    Accelerometer, Battery, Body, Drag, Esc, Ground, Gyro, Imu, Model, MotionCapture, ParameterError, Rotors,
    STANDARD_GRAVITY_MPS2, VehicleParameters,
};
pub use simulator::{Command, Event, Simulator, SimulatorError, Start};
pub use truth::{Contact, Truth};

//! What a flight needs of the world: a serial line to a vehicle, and motion capture that watches it.

use mintime_shared::messages::FlightState;
use mintime_shared::seal::PairingKey;
use nalgebra::{UnitQuaternion, Vector3};

use super::seal_counter::SealsUsedUp;
use crate::motion_capture::CaptureError;
use crate::port::PortError;

/// A pose as motion capture delivers it. World frame as in [`mintime_shared::frames`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose {
    /// When the cameras looked, s.
    pub captured_s: f64,
    /// When the pose arrived, s, on the same clock.
    pub arrived_s: f64,
    /// Position of the centre of mass, m.
    pub position_m: Vector3<f64>,
    /// Attitude, body to world.
    pub attitude: UnitQuaternion<f64>,
}

/// Where a flight is, for logs and progress.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Phase {
    /// Identifying, uploading.
    #[default]
    Prepare,
    /// From the ground to the start.
    TakeOff,
    /// Waiting for the gate.
    Hover,
    /// The vehicle replays.
    Maneuver,
    /// Back under position control.
    Catch,
    /// Down to the ground.
    Land,
    /// Downloading the record.
    Download,
}

impl Phase {
    /// One word.
    pub fn name(self) -> &'static str {
        match self {
            Self::Prepare => "prepare",
            Self::TakeOff => "take-off",
            Self::Hover => "hover",
            Self::Maneuver => "maneuver",
            Self::Catch => "catch",
            Self::Land => "land",
            Self::Download => "download",
        }
    }
}

/// Why the line or the cameras gave nothing.
#[derive(Debug, thiserror::Error)]
pub enum ConnectionError {
    /// Motion capture stopped.
    #[error("motion capture delivers no poses: check the cameras and whether the vehicle is in view")]
    NoPose,
    /// Motion capture repeats itself.
    #[error("motion capture repeats one pose: the cameras' server has stopped tracking, restart it")]
    FrozenPose,
    /// Motion capture on a real vehicle failed.
    #[error(transparent)]
    Capture(#[from] CaptureError),
    /// The port failed.
    #[error(transparent)]
    Port(#[from] PortError),
    /// No pose, but none is due: before take-off, or while the maneuver hides the vehicle from the cameras. The host says
    /// that it is there and waits on.
    #[error("the cameras do not see the vehicle yet")]
    Blind,
    /// A person pressed a key.
    #[error("stopped by a key: the motors were switched off")]
    Stopped,
    /// The virtual board came to a halt.
    #[error("the virtual board has stopped: {0}")]
    Board(String),
    /// The vehicle is paired, and there is no seal any more that it would take.
    #[error(transparent)]
    Seals(#[from] SealsUsedUp),
    /// The serial line failed.
    #[error("the serial line failed: {0}")]
    Line(#[from] std::io::Error),
}

/// Bytes to a vehicle and back.
pub trait Line {
    /// Puts bytes on the line.
    ///
    /// # Errors
    /// [`ConnectionError`].
    fn send(&mut self, bytes: &[u8]) -> Result<(), ConnectionError>;
    /// Appends what has arrived since the last call.
    ///
    /// # Errors
    /// [`ConnectionError`].
    fn receive(&mut self, into: &mut Vec<u8>) -> Result<(), ConnectionError>;
}

impl<C: Connection> Line for C {
    fn send(&mut self, bytes: &[u8]) -> Result<(), ConnectionError> {
        Connection::send(self, bytes)
    }

    fn receive(&mut self, into: &mut Vec<u8>) -> Result<(), ConnectionError> {
        Connection::receive(self, into)
    }
}

/// A vehicle within reach. Time passes only in [`next_pose`](Self::next_pose).
pub trait Connection {
    /// Waits for the next pose.
    ///
    /// # Errors
    /// [`ConnectionError::NoPose`] where none comes.
    fn next_pose(&mut self) -> Result<Pose, ConnectionError>;
    /// Puts bytes on the line.
    ///
    /// # Errors
    /// [`ConnectionError::Line`].
    fn send(&mut self, bytes: &[u8]) -> Result<(), ConnectionError>;
    /// Appends what has arrived since the last call.
    ///
    /// # Errors
    /// [`ConnectionError::Line`].
    fn receive(&mut self, into: &mut Vec<u8>) -> Result<(), ConnectionError>;
    /// The key that vehicle and host share, where they are paired.
    fn key(&self) -> Option<PairingKey> {
        None
    }
    /// Told where the flight is.
    fn enter(&mut self, phase: Phase);
}

/// A vehicle's state in words for messages.
pub(crate) fn describe(state: FlightState) -> &'static str {
    match state {
        FlightState::Boot => "starting",
        FlightState::Calibrating => "calibrating",
        FlightState::Disarmed => "disarmed",
        FlightState::Armed => "armed",
        FlightState::Tracking => "flying",
        FlightState::Maneuver => "in a maneuver",
        FlightState::Recovery => "coming down on its own",
        FlightState::Landed => "down after a recovery",
        FlightState::Terminated => "stopped",
    }
}

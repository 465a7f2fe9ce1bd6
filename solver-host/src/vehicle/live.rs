//! A flight in the room: a port to the vehicle and motion capture that watches it, in real time.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

use mintime_shared::seal::PairingKey;

use super::link::{Link as _, PortLink};
use crate::flight::{Connection, ConnectionError, Line as _, Phase, Pose};
use crate::motion_capture::{Capture, Volume};

/// Motion capture is waited for in pieces of this, so that a key is heeded soon.
const LOOK: Duration = Duration::from_millis(10);
/// Before take-off the cameras may take this long to see the vehicle, s.
const PATIENCE_S: f64 = 5.0;
/// After the maneuver's duration a pose is due within this, s.
const BLIND_AFTER_S: f64 = 0.2;

/// What a live flight is told.
#[derive(Clone, Debug, Default)]
pub struct LiveOptions {
    /// Duration of the maneuver, s: for so long, and a moment longer, the cameras may lose the vehicle.
    pub maneuver_s: f64,
    /// Set by whoever wants to stop the flight.
    pub stop: Arc<AtomicBool>,
    /// The key that vehicle and host share.
    pub key: Option<PairingKey>,
}

/// A real vehicle and the cameras.
///
/// Where poses end, [`next_pose`](Connection::next_pose) ends with the reason. The flight then stops streaming setpoints,
/// and the vehicle levels, descends and switches off by itself.
#[derive(Debug)]
pub struct LiveVehicle {
    link: PortLink,
    capture: Capture,
    options: LiveOptions,
    phase: Phase,
    entered_s: f64,
    stopped: bool,
}

impl LiveVehicle {
    /// Both must use the link's clock: open the capture with [`PortLink::began`].
    pub fn new(link: PortLink, capture: Capture, options: LiveOptions) -> Self {
        let entered_s = link.now_s();
        Self { link, capture, options, phase: Phase::Prepare, entered_s, stopped: false }
    }

    /// The link, for somebody else: the flight is over.
    pub fn into_link(self) -> PortLink {
        self.link
    }

    /// The next maneuver takes so long, s: for so long, and a moment longer, the cameras may lose the vehicle.
    pub fn expect_maneuver(&mut self, duration_s: f64) {
        self.options.maneuver_s = duration_s;
    }

    /// Where the vehicle may be from now on.
    pub fn confine(&mut self, room: Volume) {
        self.capture.confine(room);
    }

    fn in_the_air(&self) -> bool {
        matches!(self.phase, Phase::TakeOff | Phase::Hover | Phase::Maneuver | Phase::Catch | Phase::Land)
    }

    /// Until when on the link's clock nobody minds that there is no pose.
    fn patient_until_s(&self) -> f64 {
        let allowed_s = match self.phase {
            Phase::Prepare | Phase::Download => PATIENCE_S,
            Phase::Maneuver => self.options.maneuver_s + BLIND_AFTER_S,
            _ => 0.0,
        };
        self.entered_s + allowed_s
    }
}

impl Connection for LiveVehicle {
    fn next_pose(&mut self) -> Result<Pose, ConnectionError> {
        loop {
            if self.options.stop.load(Ordering::Relaxed) && !self.stopped {
                // Once: what follows, the emergency stop itself, needs time to pass.
                self.stopped = true;
                return Err(ConnectionError::Stopped);
            }
            if let Some(pose) = self.capture.next(LOOK, self.in_the_air())? {
                return Ok(pose);
            }
            // What the vehicle says meanwhile is kept.
            self.link.wait(0.0)?;
            if let Some(error) = self.capture.trouble() {
                let due = self.link.now_s() > self.patient_until_s();
                return Err(if due { error.into() } else { ConnectionError::Blind });
            }
        }
    }

    fn send(&mut self, bytes: &[u8]) -> Result<(), ConnectionError> {
        self.link.send(bytes)
    }

    fn receive(&mut self, into: &mut Vec<u8>) -> Result<(), ConnectionError> {
        self.link.receive(into)
    }

    fn key(&self) -> Option<PairingKey> {
        self.options.key
    }

    fn enter(&mut self, phase: Phase) {
        self.phase = phase;
        self.entered_s = self.link.now_s();
    }
}

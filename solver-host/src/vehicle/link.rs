//! A line with a clock of its own.

use std::time::{Duration, Instant};

use crate::flight::{ConnectionError, Line};
use crate::port::{Port, PortError};

/// A write that takes longer than this has failed. A setpoint older than that is worth nothing.
const WRITE_TIMEOUT: Duration = Duration::from_millis(100);

/// Most pieces that are read at once.
const MOST_READS: usize = 64;

/// Where time passes while one waits for an answer.
pub trait Link: Line {
    /// Time on this link's clock, s.
    fn now_s(&self) -> f64;
    /// Lets time pass, at most this much, s; less where something arrives.
    ///
    /// # Errors
    /// [`ConnectionError`].
    fn wait(&mut self, at_most_s: f64) -> Result<(), ConnectionError>;
}

/// A port and the computer's clock.
#[derive(Debug)]
pub struct PortLink {
    port: Port,
    began: Instant,
    arrived: Vec<u8>,
}

impl PortLink {
    /// Opens a port.
    ///
    /// # Errors
    /// [`PortError`].
    pub fn open(spec: &str) -> Result<Self, PortError> {
        Ok(Self { port: Port::open(spec)?, began: Instant::now(), arrived: Vec::new() })
    }

    /// When its clock stood at zero.
    pub fn began(&self) -> Instant {
        self.began
    }
}

impl Line for PortLink {
    fn send(&mut self, bytes: &[u8]) -> Result<(), ConnectionError> {
        Ok(self.port.write(bytes, WRITE_TIMEOUT)?)
    }

    fn receive(&mut self, into: &mut Vec<u8>) -> Result<(), ConnectionError> {
        into.append(&mut self.arrived);
        // A datagram a call: what waits must not age here. No more than any line brings in the time of a pose.
        for _ in 0..MOST_READS {
            if self.port.read(into, Duration::ZERO)? == 0 {
                break;
            }
        }
        Ok(())
    }
}

impl Link for PortLink {
    fn now_s(&self) -> f64 {
        self.began.elapsed().as_secs_f64()
    }

    fn wait(&mut self, at_most_s: f64) -> Result<(), ConnectionError> {
        self.port.read(&mut self.arrived, Duration::from_secs_f64(at_most_s.max(0.0)))?;
        Ok(())
    }
}

//! Serial devices: 8 data bits, no parity, one stop bit, no flow control.

use std::io::{ErrorKind, Result};
use std::time::Duration;

use serial2::SerialPort;

use super::error::{self, PortError};

/// An open serial device that no other `mintime` has open.
#[derive(Debug)]
pub(super) struct Serial {
    port: SerialPort,
}

/// Names of the connected devices; empty where the system cannot tell.
pub(super) fn devices() -> Vec<String> {
    let mut found: Vec<_> = SerialPort::available_ports()
        .unwrap_or_default()
        .iter()
        .map(|path| path.display().to_string())
        .collect();
    found.sort();
    found
}

impl Serial {
    pub(super) fn open(path: &str, baud: u32) -> std::result::Result<Self, PortError> {
        let name = || path.to_owned();
        // Settings are 8N1 without flow control wherever only a baud rate is given.
        let port = SerialPort::open(path, baud).map_err(|source| match source.kind() {
            ErrorKind::NotFound => PortError::NoSuchDevice { port: name(), available: devices() },
            ErrorKind::PermissionDenied => PortError::Permission { port: name() },
            ErrorKind::ResourceBusy => PortError::Busy { port: name() },
            // Not a terminal.
            _ if cfg!(unix) && source.raw_os_error() == Some(25) => {
                PortError::NotSerial { port: name(), available: devices() }
            }
            ErrorKind::IsADirectory => PortError::NotSerial { port: name(), available: devices() },
            _ => error::in_use(path, source),
        })?;
        lock(&port, path)?;
        // Nothing of an earlier conversation. A line that cannot discard has nothing to discard.
        let _ = port.discard_input_buffer();
        Ok(Self { port })
    }

    pub(super) fn read(&mut self, into: &mut [u8], timeout: Duration) -> Result<usize> {
        self.port.set_read_timeout(timeout)?;
        match self.port.read(into)? {
            // Ready to be read and empty: hung up.
            0 => Err(ErrorKind::UnexpectedEof.into()),
            count => Ok(count),
        }
    }

    pub(super) fn write(&mut self, bytes: &[u8], timeout: Duration) -> Result<usize> {
        self.port.set_write_timeout(timeout.max(Duration::from_millis(1)))?;
        self.port.write(bytes)
    }
}

/// Two programs that read from one line each get half of every answer.
#[cfg(unix)]
fn lock(port: &SerialPort, path: &str) -> std::result::Result<(), PortError> {
    use rustix::fs::{FlockOperation, flock};
    match flock(port, FlockOperation::NonBlockingLockExclusive) {
        Err(rustix::io::Errno::WOULDBLOCK) => Err(PortError::Busy { port: path.to_owned() }),
        // A file system without locks has no other way to tell.
        _ => Ok(()),
    }
}

/// The system opens a serial device once.
#[cfg(not(unix))]
fn lock(_: &SerialPort, _: &str) -> std::result::Result<(), PortError> {
    Ok(())
}

//! Why a port cannot be used, and what to do about it.

use std::io::ErrorKind;

/// Why bytes do not flow. Every text says what to do.
#[derive(Debug, thiserror::Error)]
pub enum PortError {
    /// Not the name of a port.
    #[error(
        "{spec:?} names no port ({reason}): give a serial device such as /dev/ttyUSB0 or COM3, tcp:HOST:PORT or \
         udp:HOST:PORT"
    )]
    Name {
        /// What was given.
        spec: String,
        /// What is wrong with it.
        reason: &'static str,
    },
    /// The device is not there.
    #[error("{port}: there is no such device; {}", found(.available))]
    NoSuchDevice {
        /// Which.
        port: String,
        /// Serial devices that are there.
        available: Vec<String>,
    },
    /// It is there, but is no serial device.
    #[error("{port} is not a serial device: {}", found(.available))]
    NotSerial {
        /// Which.
        port: String,
        /// Serial devices that are there.
        available: Vec<String>,
    },
    /// The user may not open it.
    #[error(
        "{port}: permission denied; on Linux join the group that owns serial ports (`sudo usermod -aG dialout $USER`, on some \
         systems `uucp`) and log in again"
    )]
    Permission {
        /// Which.
        port: String,
    },
    /// Somebody else has it.
    #[error("{port} is in use by another program: end that one first")]
    Busy {
        /// Which.
        port: String,
    },
    /// Nobody listens at the far end.
    #[error("{port}: the connection was refused; start what should listen there, or check the port number")]
    Refused {
        /// Which.
        port: String,
    },
    /// The far end cannot be reached.
    #[error("{port} cannot be reached ({source}): check the name, the address and the network")]
    Unreachable {
        /// Which.
        port: String,
        /// What the system said.
        source: std::io::Error,
    },
    /// It worked and is gone.
    #[error("{port} has vanished: check the plug, the cable and the power at the far end")]
    Vanished {
        /// Which.
        port: String,
    },
    /// It takes no more bytes.
    #[error("{port} took no bytes for {waited_ms} ms: the far end has stopped reading, or the line is held")]
    Stalled {
        /// Which.
        port: String,
        /// How long was waited, ms.
        waited_ms: u128,
    },
    /// Something else.
    #[error("{port} failed: {source}")]
    Failed {
        /// Which.
        port: String,
        /// What the system said.
        source: std::io::Error,
    },
}

/// Serial devices in words.
fn found(available: &[String]) -> String {
    if available.is_empty() {
        return "no serial device is connected: plug one in, and check that the cable carries data"
            .to_owned();
    }
    format!("connected are {}", available.join(", "))
}

/// What the system said while bytes should flow.
pub(super) fn in_use(port: &str, source: std::io::Error) -> PortError {
    // Linux tells of an unplugged adapter as an input/output error or as a missing device.
    const UNPLUGGED: [i32; 3] = [5, 6, 19];
    let port = port.to_owned();
    match source.kind() {
        ErrorKind::ConnectionRefused => PortError::Refused { port },
        ErrorKind::ConnectionReset
        | ErrorKind::ConnectionAborted
        | ErrorKind::BrokenPipe
        | ErrorKind::NotConnected
        | ErrorKind::UnexpectedEof
        | ErrorKind::NotFound => PortError::Vanished { port },
        ErrorKind::HostUnreachable | ErrorKind::NetworkUnreachable | ErrorKind::NetworkDown => {
            PortError::Unreachable { port, source }
        }
        _ if cfg!(unix) && source.raw_os_error().is_some_and(|code| UNPLUGGED.contains(&code)) => {
            PortError::Vanished { port }
        }
        _ => PortError::Failed { port, source },
    }
}

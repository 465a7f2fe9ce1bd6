//! A line of bytes to a vehicle: a serial device, a TCP connection or UDP datagrams.
//!
//! Reading never waits longer than it is told to, writing gives up at its deadline, and everything that can go wrong is a
//! [`PortError`] that says what to do. What the bytes mean is of no concern here.

mod error;
mod serial;
mod spec;

use std::io::{ErrorKind, Read as _, Write as _};
use std::net::{SocketAddr, TcpStream, ToSocketAddrs as _, UdpSocket};
use std::time::{Duration, Instant};

pub use error::PortError;
pub use spec::{DEFAULT_BAUD, PortSpec};

/// A TCP connection is waited for this long.
const CONNECT_TIMEOUT: Duration = Duration::from_secs(3);
/// A datagram peer that refuses is believed when nothing has come from it for this long: one that restarts refuses, too.
const REFUSAL_PATIENCE: Duration = Duration::from_millis(500);
/// Most bytes of a datagram: what fits an Ethernet frame.
const MAX_DATAGRAM: usize = 1_400;

/// What carries the bytes.
#[derive(Debug)]
enum Transport {
    Serial(serial::Serial),
    Tcp(TcpStream),
    Udp { socket: UdpSocket, heard: Instant },
}

/// An open port.
#[derive(Debug)]
pub struct Port {
    name: String,
    transport: Transport,
    buffer: Vec<u8>,
}

/// Names of the serial devices that are connected.
pub fn serial_devices() -> Vec<String> {
    serial::devices()
}

impl Port {
    /// Opens a port by its name, as [`PortSpec`] reads it.
    ///
    /// # Errors
    /// [`PortError`].
    pub fn open(spec: &str) -> Result<Self, PortError> {
        let spec: PortSpec = spec.parse()?;
        let name = spec.to_string();
        let transport = match &spec {
            PortSpec::Serial { path, baud } => Transport::Serial(serial::Serial::open(path, *baud)?),
            PortSpec::Tcp { address } => Transport::Tcp(connect(&name, address)?),
            PortSpec::Udp { address } => {
                let socket = datagrams(&name, address)?;
                Transport::Udp { socket, heard: Instant::now() }
            }
        };
        Ok(Self { name, transport, buffer: vec![0; 4096] })
    }

    /// What it is called.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Appends what arrives within `timeout`; returns as soon as there is something. Zero asks for what is there already.
    ///
    /// # Errors
    /// [`PortError`]; that nothing came is none.
    pub fn read(&mut self, into: &mut Vec<u8>, timeout: Duration) -> Result<usize, PortError> {
        // A socket's shortest timeout is a tick of the system's clock, up to 10 ms: too long for a flight that only looks.
        let look = timeout.is_zero();
        let wait = (!look).then_some(timeout);
        let result = match &mut self.transport {
            Transport::Serial(serial) => serial.read(&mut self.buffer, timeout),
            Transport::Tcp(stream) => {
                let ready = stream.set_nonblocking(look).and_then(|()| stream.set_read_timeout(wait));
                match ready.and_then(|()| stream.read(&mut self.buffer)) {
                    Ok(0) => Err(ErrorKind::UnexpectedEof.into()),
                    result => result,
                }
            }
            Transport::Udp { socket, heard } => {
                let ready = socket.set_nonblocking(look).and_then(|()| socket.set_read_timeout(wait));
                let result = ready.and_then(|()| socket.recv(&mut self.buffer));
                if result.is_ok() {
                    *heard = Instant::now();
                }
                forgive(result, *heard)
            }
        };
        match result {
            Ok(count) => {
                into.extend_from_slice(&self.buffer[..count.min(self.buffer.len())]);
                Ok(count)
            }
            Err(error) if is_silence(error.kind()) => Ok(0),
            Err(error) => Err(error::in_use(&self.name, error)),
        }
    }

    /// Writes all of it, or gives up at the deadline.
    ///
    /// # Errors
    /// [`PortError::Stalled`] at the deadline, or what the line has to say.
    pub fn write(&mut self, bytes: &[u8], timeout: Duration) -> Result<(), PortError> {
        let began = Instant::now();
        let mut rest = bytes;
        while !rest.is_empty() {
            let left = timeout.saturating_sub(began.elapsed()).max(Duration::from_micros(1));
            let result = match &mut self.transport {
                Transport::Serial(serial) => serial.write(rest, left),
                Transport::Tcp(stream) => stream
                    .set_nonblocking(false)
                    .and_then(|()| stream.set_write_timeout(Some(left)))
                    .and_then(|()| stream.write(rest)),
                Transport::Udp { socket, heard } => {
                    let datagram = &rest[..rest.len().min(MAX_DATAGRAM)];
                    let ready =
                        socket.set_nonblocking(false).and_then(|()| socket.set_write_timeout(Some(left)));
                    let result = ready.and_then(|()| socket.send(datagram));
                    match forgive(result, *heard) {
                        // As lost as any datagram.
                        Ok(0) => Ok(datagram.len()),
                        result => result,
                    }
                }
            };
            match result {
                Ok(0) => return Err(PortError::Vanished { port: self.name.clone() }),
                Ok(count) => rest = rest.get(count..).unwrap_or_default(),
                Err(error) if is_silence(error.kind()) => {}
                Err(error) => return Err(error::in_use(&self.name, error)),
            }
            if !rest.is_empty() && began.elapsed() >= timeout {
                return Err(PortError::Stalled { port: self.name.clone(), waited_ms: timeout.as_millis() });
            }
        }
        Ok(())
    }
}

/// Nothing yet, as systems say it.
fn is_silence(kind: ErrorKind) -> bool {
    matches!(kind, ErrorKind::WouldBlock | ErrorKind::TimedOut | ErrorKind::Interrupted)
}

/// A refused datagram counts as lost while the peer was heard a moment ago.
fn forgive(result: std::io::Result<usize>, heard: Instant) -> std::io::Result<usize> {
    match result {
        Err(e)
            if matches!(e.kind(), ErrorKind::ConnectionRefused | ErrorKind::ConnectionReset)
                && heard.elapsed() < REFUSAL_PATIENCE =>
        {
            Ok(0)
        }
        result => result,
    }
}

/// Addresses behind a name; at least one.
fn resolve(name: &str, address: &str) -> Result<Vec<SocketAddr>, PortError> {
    let unreachable = |source| PortError::Unreachable { port: name.to_owned(), source };
    let found: Vec<_> = address.to_socket_addrs().map_err(unreachable)?.collect();
    if found.is_empty() {
        return Err(unreachable(std::io::Error::other("the name has no address")));
    }
    Ok(found)
}

/// The first address that answers.
fn connect(name: &str, address: &str) -> Result<TcpStream, PortError> {
    let mut last = None;
    for address in resolve(name, address)? {
        match TcpStream::connect_timeout(&address, CONNECT_TIMEOUT) {
            Ok(stream) => {
                // Setpoints are small and must not wait for company.
                stream.set_nodelay(true).map_err(|e| error::in_use(name, e))?;
                return Ok(stream);
            }
            Err(error) => last = Some(error),
        }
    }
    match last {
        Some(e) if e.kind() == ErrorKind::ConnectionRefused => {
            Err(PortError::Refused { port: name.to_owned() })
        }
        source => Err(PortError::Unreachable {
            port: name.to_owned(),
            source: source.unwrap_or_else(|| ErrorKind::NotFound.into()),
        }),
    }
}

/// A socket that talks with one address only.
fn datagrams(name: &str, address: &str) -> Result<UdpSocket, PortError> {
    let address = resolve(name, address)?.swap_remove(0);
    let any: SocketAddr = if address.is_ipv4() {
        ([0, 0, 0, 0], 0).into()
    } else {
        (std::net::Ipv6Addr::UNSPECIFIED, 0).into()
    };
    let open = || {
        let socket = UdpSocket::bind(any)?;
        socket.connect(address)?;
        Ok(socket)
    };
    open().map_err(|source| PortError::Unreachable { port: name.to_owned(), source })
}

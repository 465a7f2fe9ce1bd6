//! What a port is called: `/dev/ttyUSB0?baud=921600`, `tcp:HOST:PORT`, `udp:HOST:PORT`.

use super::error::PortError;

/// Baud rate of a vehicle's line.
pub const DEFAULT_BAUD: u32 = 921_600;

/// A port by name.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum PortSpec {
    /// A serial device.
    Serial {
        /// Its path, or `COM3`.
        path: String,
        /// Bits a second.
        baud: u32,
    },
    /// A TCP connection, to a bridge on the vehicle or to an emulator.
    Tcp {
        /// `HOST:PORT`.
        address: String,
    },
    /// UDP datagrams from and to one address.
    Udp {
        /// `HOST:PORT`.
        address: String,
    },
}

impl core::str::FromStr for PortSpec {
    type Err = PortError;

    fn from_str(spec: &str) -> Result<Self, PortError> {
        let wrong = |reason| PortError::Name { spec: spec.to_owned(), reason };
        if let Some(address) = spec.strip_prefix("tcp:") {
            return Ok(Self::Tcp { address: checked(address).map_err(wrong)? });
        }
        if let Some(address) = spec.strip_prefix("udp:") {
            return Ok(Self::Udp { address: checked(address).map_err(wrong)? });
        }
        let (path, options) = spec.split_once('?').map_or((spec, None), |(path, o)| (path, Some(o)));
        if path.is_empty() {
            return Err(wrong("the name is empty"));
        }
        let baud = match options {
            None => DEFAULT_BAUD,
            Some(options) => {
                let digits = options.strip_prefix("baud=").ok_or(wrong("the only option is ?baud=NUMBER"))?;
                let baud = digits.parse().map_err(|_| wrong("the baud rate is not a whole number"))?;
                if !(1_200..=12_000_000).contains(&baud) {
                    return Err(wrong("the baud rate must lie between 1200 and 12000000"));
                }
                baud
            }
        };
        Ok(Self::Serial { path: path.to_owned(), baud })
    }
}

/// `HOST:PORT` with a port that is a number other than zero.
fn checked(address: &str) -> Result<String, &'static str> {
    let (host, port) = address.rsplit_once(':').ok_or("the port number is missing")?;
    if host.is_empty() {
        return Err("the host is missing");
    }
    match port.parse::<u16>() {
        Ok(0) | Err(_) => Err("the port number must lie between 1 and 65535"),
        Ok(_) => Ok(address.to_owned()),
    }
}

impl core::fmt::Display for PortSpec {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match self {
            Self::Serial { path, baud: DEFAULT_BAUD } => f.write_str(path),
            Self::Serial { path, baud } => write!(f, "{path}?baud={baud}"),
            Self::Tcp { address } => write!(f, "tcp:{address}"),
            Self::Udp { address } => write!(f, "udp:{address}"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_read_and_written_back() {
        for name in
            ["/dev/ttyUSB0", "COM3", "/dev/ttyACM1?baud=115200", "tcp:localhost:5760", "udp:[::1]:14550"]
        {
            let spec: PortSpec = name.parse().expect(name);
            assert_eq!(spec.to_string(), name);
        }
        let spec: PortSpec = "/dev/ttyUSB0".parse().expect("a device");
        assert_eq!(spec, PortSpec::Serial { path: "/dev/ttyUSB0".into(), baud: 921_600 });
    }

    #[test]
    fn names_that_cannot_be_meant_are_refused() {
        for name in [
            "",
            "tcp:",
            "tcp:host",
            "tcp::80",
            "udp:host:0",
            "udp:host:70000",
            "/dev/x?",
            "/dev/x?speed=1",
            "x?baud=",
            "x?baud=0",
            "x?baud=99999999999",
            "?baud=9600",
        ] {
            let error = name.parse::<PortSpec>().expect_err(name);
            assert!(matches!(error, PortError::Name { .. }), "{name}: {error}");
        }
    }
}

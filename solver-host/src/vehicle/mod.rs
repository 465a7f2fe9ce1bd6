//! A vehicle on the bench or in the room: what one asks it and tells it besides flying.

mod link;
mod live;
mod measure;
mod session;

pub use link::{Link, PortLink};
pub use live::{LiveOptions, LiveVehicle};
pub use measure::{Measurement, Spread};
pub use session::{Session, SessionError};

use mintime_shared::seal::PairingKey;

/// Why a pairing key cannot be read.
#[derive(Debug, thiserror::Error)]
pub enum KeyError {
    /// The file cannot be read.
    #[error("{path} cannot be read ({source}): give the file that `mintime vehicle PORT pair` has written")]
    Read {
        /// Its path.
        path: String,
        /// What the system said.
        source: std::io::Error,
    },
    /// No key in it.
    #[error("a pairing key is 32 hexadecimal digits on one line: make one with `mintime vehicle PORT pair`")]
    Content,
}

/// Reads a key: 16 bytes in hexadecimal.
///
/// # Errors
/// [`KeyError::Content`].
pub fn parse_key(text: &str) -> Result<PairingKey, KeyError> {
    let digits = text.trim().as_bytes();
    let mut key = PairingKey::default();
    if digits.len() != 2 * key.len() {
        return Err(KeyError::Content);
    }
    for (byte, pair) in key.iter_mut().zip(digits.chunks_exact(2)) {
        let digit = |d: u8| char::from(d).to_digit(16).ok_or(KeyError::Content);
        // Two digits of four bits.
        *byte = pair.iter().try_fold(0, |sum, d| Ok::<_, KeyError>(sum << 4 | digit(*d)? as u8))?;
    }
    Ok(key)
}

/// Reads a key from a file.
///
/// # Errors
/// [`KeyError`].
pub fn read_key(path: &std::path::Path) -> Result<PairingKey, KeyError> {
    let read = |source| KeyError::Read { path: path.display().to_string(), source };
    parse_key(&std::fs::read_to_string(path).map_err(read)?)
}

/// A key in hexadecimal.
pub fn key_text(key: &PairingKey) -> String {
    key.iter().map(|byte| format!("{byte:02x}")).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keys_are_read_as_they_are_written() {
        let key: PairingKey = core::array::from_fn(|i| (i * 37 + 200) as u8);
        assert_eq!(parse_key(&format!(" {}\n", key_text(&key))).expect("a key"), key);
        for text in ["", "00", &"0".repeat(31), &"0".repeat(33), &"g".repeat(32), &"é".repeat(16)] {
            assert!(parse_key(text).is_err(), "{text}");
        }
    }
}

//! Framing: how a message becomes bytes on a serial line and back.
//!
//! A frame is `COBS( postcard(message) ‖ CRC-32 little-endian ) ‖ 0x00`. COBS removes every zero from the content, so a
//! zero always ends a frame and a receiver finds its feet again after any noise. The checksum is verified before a
//! single field is parsed. Every length is bounded: a frame that grows past [`MAX_FRAME_BYTES`] is dropped whole.

use serde::{Serialize, de::DeserializeOwned};

use crate::{checksum, stuffing};

/// Longest frame on the wire, closing zero included: the largest message is a table upload or a record chunk of
/// [`crate::messages::MAX_CHUNK_BYTES`], with header, checksum and COBS overhead.
pub const MAX_FRAME_BYTES: usize = 280;

/// Why received bytes are not a message.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum FrameError {
    /// More bytes than any frame has before a zero came.
    #[error("frame too long: noise, or another protocol on the line")]
    TooLong,
    /// Too short to hold a checksum.
    #[error("frame too short: truncated")]
    TooShort,
    /// The COBS code does not add up.
    #[error("frame is not COBS: truncated, or noise")]
    Encoding,
    /// The checksum does not match.
    #[error("frame checksum mismatch: bytes were changed on the way")]
    Checksum,
    /// The checksum holds but the content does not parse: another protocol version.
    #[error("frame content does not parse: the other side speaks another protocol version")]
    Content,
}

/// A frame ready to be sent.
#[derive(Clone, Debug)]
pub struct Frame {
    bytes: [u8; MAX_FRAME_BYTES],
    length: usize,
}

impl Frame {
    /// The bytes on the wire, closing zero included.
    pub fn as_bytes(&self) -> &[u8] {
        self.bytes.get(..self.length).unwrap_or_default()
    }
}

/// Encodes one message.
///
/// # Errors
/// [`FrameError::TooLong`] where the message does not fit a frame; no message of this protocol is that long.
pub fn encode<M: Serialize>(message: &M) -> Result<Frame, FrameError> {
    let mut frame = Frame::new();
    frame.fill(message)?;
    Ok(frame)
}

impl Frame {
    /// Nothing yet.
    pub const fn new() -> Self {
        Self { bytes: [0; MAX_FRAME_BYTES], length: 0 }
    }

    /// Nothing again.
    pub const fn clear(&mut self) {
        self.length = 0;
    }

    /// Becomes the frame of a message, in place; empty where there is an error.
    ///
    /// # Errors
    /// As [`encode`].
    pub fn fill<M: Serialize>(&mut self, message: &M) -> Result<(), FrameError> {
        self.fill_sealed(message, |_| [])
    }

    /// The same, with what `seal` makes of the content behind it, [`crate::seal`].
    ///
    /// # Errors
    /// As [`encode`].
    pub fn fill_sealed<M: Serialize, const N: usize>(
        &mut self,
        message: &M,
        seal: impl FnOnce(&[u8]) -> [u8; N],
    ) -> Result<(), FrameError> {
        self.clear();
        // The first byte is the code's.
        let content = self.bytes.get_mut(1..).ok_or(FrameError::TooLong)?;
        let bare = postcard::to_slice(message, content).map_err(|_| FrameError::TooLong)?.len();
        let tail = seal(content.get(..bare).unwrap_or_default());
        let body = bare + N;
        content.get_mut(bare..body).ok_or(FrameError::TooLong)?.copy_from_slice(&tail);
        let length = checksum::append(content, body).ok_or(FrameError::TooLong)?;
        let coded = stuffing::encode(&mut self.bytes, length).ok_or(FrameError::TooLong)?;
        self.length = coded + 1;
        Ok(())
    }
}

impl Default for Frame {
    fn default() -> Self {
        Self::new()
    }
}

/// Cuts a stream of bytes, arriving in any pieces, into messages.
#[derive(Clone, Debug)]
pub struct Decoder {
    buffer: [u8; MAX_FRAME_BYTES],
    length: usize,
    overflowed: bool,
}

impl Default for Decoder {
    fn default() -> Self {
        Self::new()
    }
}

impl Decoder {
    /// An empty decoder.
    pub const fn new() -> Self {
        Self { buffer: [0; MAX_FRAME_BYTES], length: 0, overflowed: false }
    }

    /// Takes one byte. `Some` where it ends a frame: the message, or why there is none. Empty frames (two zeros in a
    /// row) are idle filling and say nothing.
    pub fn push<M: DeserializeOwned>(&mut self, byte: u8) -> Option<Result<M, FrameError>> {
        Some(self.push_content(byte)?.and_then(parse))
    }

    /// The same, but the frame's content as it is: its checksum holds, nothing in it has been looked at.
    pub fn push_content(&mut self, byte: u8) -> Option<Result<&[u8], FrameError>> {
        self.next_content(&mut [byte].as_slice())
    }

    /// The same with many bytes: takes what there is up to the end of the next frame, and leaves in `bytes` what came behind
    /// it. `None` where they end before a frame does.
    pub fn next_content(&mut self, bytes: &mut &[u8]) -> Option<Result<&[u8], FrameError>> {
        loop {
            let Some(end) = bytes.iter().position(|byte| *byte == 0) else {
                self.append(bytes);
                *bytes = &[];
                return None;
            };
            self.append(bytes.get(..end).unwrap_or_default());
            *bytes = bytes.get(end + 1..).unwrap_or_default();
            if self.length > 0 {
                break;
            }
        }
        let length = core::mem::take(&mut self.length);
        if core::mem::take(&mut self.overflowed) {
            return Some(Err(FrameError::TooLong));
        }
        self.buffer.get_mut(..length).map(decode)
    }

    /// Adds bytes of the frame under way.
    fn append(&mut self, bytes: &[u8]) {
        let room = self.buffer.get_mut(self.length..).unwrap_or_default();
        match room.get_mut(..bytes.len()) {
            Some(room) => {
                room.copy_from_slice(bytes);
                self.length += bytes.len();
            }
            // It ends in an error, whatever stands in the buffer.
            None => (self.length, self.overflowed) = (self.buffer.len(), true),
        }
    }
}

/// The content of one frame, without its closing zero, decoded in place.
fn decode(coded: &mut [u8]) -> Result<&[u8], FrameError> {
    let content = stuffing::decode(coded).ok_or(FrameError::Encoding)?;
    let (body, intact) = checksum::split(content).ok_or(FrameError::TooShort)?;
    if intact { Ok(body) } else { Err(FrameError::Checksum) }
}

/// The message in a frame's content, with nothing left over.
///
/// # Errors
/// [`FrameError::Content`].
pub fn parse<M: DeserializeOwned>(content: &[u8]) -> Result<M, FrameError> {
    let mut deserializer = postcard::Deserializer::from_bytes(content);
    let message = M::deserialize(&mut deserializer).map_err(|_| FrameError::Content)?;
    if deserializer.finalize().is_ok_and(<[u8]>::is_empty) { Ok(message) } else { Err(FrameError::Content) }
}

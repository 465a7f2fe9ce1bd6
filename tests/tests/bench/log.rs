//! Reads what the firmware logs through a debug probe: defmt's frames, as far as tests need them.
//!
//! A frame is the number of its text, the time (8 bytes) and the arguments, packed with the reverse zero-compressing COBS
//! and ended by a zero. The texts are the names of symbols, as JSON; the number is the symbol's value.

use std::collections::HashMap;

/// What a log says, in order.
pub(crate) struct Log {
    frames: Vec<Vec<u8>>,
    texts: HashMap<u16, String>,
}

impl Log {
    /// From the raw bytes and the symbols of the image.
    pub(crate) fn new(raw: &[u8], symbols: &[(String, u32)]) -> Self {
        let text = |name: &str| {
            let json: serde_json::Value = serde_json::from_str(name).ok()?;
            json.get("tag")?.as_str()?.starts_with("defmt").then_some(())?;
            Some(json.get("data")?.as_str()?.to_owned())
        };
        let number = |value: u32| u16::try_from(value).ok();
        let texts = symbols.iter().filter_map(|(n, v)| Some((number(*v)?, text(n)?))).collect();
        // Frames that a reset cut in two decode to nothing.
        let frames = raw.split(|b| *b == 0).filter(|f| !f.is_empty()).filter_map(unpack).collect();
        Self { frames, texts }
    }

    /// The texts logged.
    pub(crate) fn texts(&self) -> Vec<&str> {
        self.frames.iter().filter_map(|f| self.text_at(f, 0)).collect()
    }

    /// Causes of the resets before each start.
    pub(crate) fn reset_causes(&self) -> Vec<&str> {
        let named = |frame: &Vec<u8>| {
            let rest = self.arguments(frame, "mintime firmware {=str}, reset by {}")?;
            let length = u32::from_le_bytes(*rest.first_chunk()?) as usize;
            self.variant(rest.get(4 + length..)?)
        };
        self.frames.iter().filter_map(named).collect()
    }

    /// Kinds of the crashes reported at each start.
    pub(crate) fn crashes(&self) -> Vec<&str> {
        // The first field of the crash is its kind; the number before it is that of the crash's own text.
        let named =
            |frame: &Vec<u8>| self.variant(self.arguments(frame, "the last run crashed: {}")?.get(2..)?);
        self.frames.iter().filter_map(named).collect()
    }

    fn text_at(&self, bytes: &[u8], at: usize) -> Option<&str> {
        let number = u16::from_le_bytes(*bytes.get(at..)?.first_chunk()?);
        self.texts.get(&number).map(String::as_str)
    }

    fn arguments<'a>(&self, frame: &'a [u8], text: &str) -> Option<&'a [u8]> {
        (self.text_at(frame, 0)? == text).then(|| frame.get(10..))?
    }

    /// The variant of an enumeration: the number of its text, which names all of them, and which it is.
    fn variant(&self, bytes: &[u8]) -> Option<&str> {
        self.text_at(bytes, 0)?.split('|').nth(usize::from(*bytes.get(2)?))
    }
}

/// Undoes the packing of one frame, which is read from its end.
fn unpack(frame: &[u8]) -> Option<Vec<u8>> {
    let mut out = Vec::new();
    let mut rest = frame.iter().rev().copied();
    while let Some(code) = rest.next() {
        match code {
            0 => return None,
            1..=0x7F => {
                for bit in (0..7).rev() {
                    out.push(if code >> bit & 1 == 0 { rest.next()? } else { 0 });
                }
            }
            0x80..=0xFE => {
                out.push(0);
                for _ in 0..(code & 0x7F) + 7 {
                    out.push(rest.next()?);
                }
            }
            0xFF => {
                for _ in 0..134 {
                    out.push(rest.next()?);
                }
            }
        }
    }
    out.reverse();
    Some(out)
}

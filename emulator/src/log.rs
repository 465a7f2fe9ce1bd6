//! What a program logs: defmt frames where its image says so, plain text otherwise.
#[cfg(feature = "defmt")]
use std::sync::Arc;

#[cfg(feature = "defmt")]
use defmt_decoder::{DecodeError, Encoding, Frame, Table};

/// Turns the bytes of [`read_rtt`](crate::Machine::read_rtt) into lines.
#[derive(Clone, Debug, Default)]
pub struct Log {
    #[cfg(feature = "defmt")]
    table: Option<Arc<Table>>,
    /// Bytes of a frame that has not ended yet.
    #[cfg(feature = "defmt")]
    pending: Vec<u8>,
}

impl Log {
    /// A log for the program in `elf`. One without defmt's section, or of a version this decoder does not know, is
    /// taken to log text.
    #[cfg(feature = "defmt")]
    pub fn new(elf: &[u8]) -> Self {
        Self { table: Table::parse(elf).ok().flatten().map(Arc::new), pending: Vec::new() }
    }

    /// A log of text, whatever the program: the feature `defmt` is off.
    #[cfg(not(feature = "defmt"))]
    pub fn new(_: &[u8]) -> Self {
        Self::default()
    }

    /// The lines that are complete with these bytes; a frame that makes no sense becomes text.
    #[cfg(feature = "defmt")]
    pub fn decode(&mut self, bytes: &[u8]) -> String {
        let Some(table) = &self.table else { return String::from_utf8_lossy(bytes).into_owned() };
        self.pending.extend_from_slice(bytes);
        let mut lines = String::new();
        let consumed = match table.encoding() {
            Encoding::Rzcobs => framed(table, &self.pending, &mut lines),
            _ => unframed(table, &self.pending, &mut lines),
        };
        self.pending.drain(..consumed);
        lines
    }

    /// The bytes as text.
    #[cfg(not(feature = "defmt"))]
    pub fn decode(&mut self, bytes: &[u8]) -> String {
        String::from_utf8_lossy(bytes).into_owned()
    }
}

/// Frames that end in a zero byte; how many bytes they took.
#[cfg(feature = "defmt")]
fn framed(table: &Table, bytes: &[u8], lines: &mut String) -> usize {
    let mut consumed = 0;
    for frame in bytes.split_inclusive(|byte| *byte == 0).filter(|frame| frame.ends_with(&[0])) {
        consumed += frame.len();
        if frame == [0] {
            continue;
        }
        let mut decoder = table.new_stream_decoder();
        decoder.received(frame);
        match decoder.decode() {
            Ok(frame) => push(&frame, lines),
            Err(_) => push_text(frame, lines),
        }
    }
    consumed
}

/// Frames one after another with nothing between them.
#[cfg(feature = "defmt")]
fn unframed(table: &Table, bytes: &[u8], lines: &mut String) -> usize {
    let mut consumed = 0;
    while let Some(rest) = bytes.get(consumed..)
        && !rest.is_empty()
    {
        match table.decode(rest) {
            Ok((frame, length)) => {
                push(&frame, lines);
                consumed += length.max(1);
            }
            Err(DecodeError::UnexpectedEof) => break,
            Err(DecodeError::Malformed) => {
                // Nothing marks where the next frame starts.
                push_text(rest, lines);
                return bytes.len();
            }
        }
    }
    consumed
}

#[cfg(feature = "defmt")]
fn push(frame: &Frame<'_>, lines: &mut String) {
    lines.push_str(&frame.display(false).to_string());
    lines.push('\n');
}

#[cfg(feature = "defmt")]
fn push_text(bytes: &[u8], lines: &mut String) {
    lines.push_str(&String::from_utf8_lossy(bytes));
    lines.push('\n');
}

#[cfg(test)]
mod tests {
    use super::Log;

    #[test]
    fn without_defmt_it_is_text() {
        assert_eq!(Log::new(b"not an ELF").decode(b"hello"), "hello");
        assert_eq!(Log::default().decode(&[0xFF, b'x']), "\u{FFFD}x");
    }
}

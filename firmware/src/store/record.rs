//! How a value lies in flash: a header word, the value in whole words, a checksum over both, and the confirmation that all of
//! it was written.

use mintime_shared::crc32;

use super::{VALUE_BYTES, WORD};

/// The word before a value: key, length, whether the key is removed, and a checksum of these, so that a length cut short is
/// not believed.
#[derive(Clone, Copy)]
pub(super) struct RecordHeader {
    /// The key's number.
    pub(super) code: u8,
    /// Of the value, bytes.
    pub(super) length: usize,
    /// The key has no value any more.
    pub(super) removed: bool,
}

impl RecordHeader {
    const REMOVED: u32 = 1 << 17;
    const CHECK_SHIFT: u32 = 18;

    pub(super) fn word(self) -> u32 {
        let plain =
            u32::from(self.code) | (self.length as u32) << 8 | if self.removed { Self::REMOVED } else { 0 };
        plain | crc32(&plain.to_le_bytes()) << Self::CHECK_SHIFT
    }

    pub(super) fn from_word(word: u32) -> Option<Self> {
        let length = (word >> 8 & 0x1FF) as usize;
        let header = Self { code: word as u8, length, removed: word & Self::REMOVED != 0 };
        (length <= VALUE_BYTES && header.word() == word).then_some(header)
    }

    /// Bytes of the whole record.
    pub(super) fn record_bytes(self) -> usize {
        bytes_in_flash(self.length)
    }
}

const fn bytes_in_flash(length: usize) -> usize {
    WORD + length.next_multiple_of(WORD) + 2 * WORD
}

/// Header word and value, as its checksum sees them.
pub(super) struct Record {
    pub(super) bytes: [u8; WORD + VALUE_BYTES],
    /// Of the value, bytes.
    pub(super) length: usize,
}

impl Record {
    pub(super) fn new(header: RecordHeader, value: &[u8]) -> Self {
        let mut bytes = [0xFF; WORD + VALUE_BYTES];
        let (head, body) = bytes.split_at_mut(WORD);
        head.copy_from_slice(&header.word().to_le_bytes());
        for (slot, byte) in body.iter_mut().zip(value) {
            *slot = *byte;
        }
        Self { bytes, length: value.len().min(VALUE_BYTES) }
    }

    pub(super) fn checksum(&self) -> u32 {
        crc32(self.bytes.get(..WORD + self.length).unwrap_or_default())
    }

    pub(super) fn value(&self) -> &[u8] {
        self.bytes.get(WORD..WORD + self.length).unwrap_or_default()
    }

    /// Bytes of the whole record.
    pub(super) fn bytes_in_flash(&self) -> usize {
        bytes_in_flash(self.length)
    }

    /// In the order in which they are programmed; the confirmation comes behind them.
    pub(super) fn words(&self) -> impl Iterator<Item = u32> + '_ {
        let used = WORD + self.length.next_multiple_of(WORD);
        let words = self.bytes.as_chunks::<WORD>().0.iter().take(used / WORD);
        words.map(|word| u32::from_le_bytes(*word)).chain([self.checksum()])
    }
}

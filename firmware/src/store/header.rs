//! What stands at the beginning of a sector, and what can be told from one that does not add up.

use mintime_shared::crc32;

use super::WORD;

/// Magic number of the layout, generation, checksum of both, confirmation, and whether it is given up.
pub(super) const HEADER_BYTES: usize = 5 * WORD;
/// Place of the confirmation.
pub(super) const CONFIRMATION: usize = 3 * WORD;
/// Place of the word that says that the sector is given up.
pub(super) const GIVEN_UP: usize = 4 * WORD;
/// A confirmation, and the other words that say yes.
pub(super) const YES: u32 = 0;

const MAGIC: u32 = u32::from_le_bytes(*b"KEPT");
/// Bits of the magic number that may be wrong in a header that was one.
const MAGIC_FLIPS: u32 = 4;
/// Magic numbers of earlier layouts, whose headers began with the same three words.
const EARLIER: [u32; 2] = [u32::from_le_bytes(*b"MTS1"), u32::from_le_bytes(*b"MTS2")];

// No header of an earlier layout is a damaged one of this.
const _: () = assert!((EARLIER[0] ^ MAGIC).count_ones() > 2 * MAGIC_FLIPS);
const _: () = assert!((EARLIER[1] ^ MAGIC).count_ones() > 2 * MAGIC_FLIPS);

/// Whether a word says [`YES`]: most of it does, for bits may have flipped.
pub(super) const fn says_yes(word: u32) -> bool {
    word.count_zeros() > 16
}

/// The header of a sector, whole or not.
#[derive(Clone, Copy)]
pub(super) struct SectorHeader {
    magic: u32,
    generation: u32,
    check: u32,
    pub(super) confirmed: bool,
    given_up: bool,
}

impl SectorHeader {
    /// As read.
    pub(super) const fn from_words(words: [u32; HEADER_BYTES / WORD]) -> Self {
        let [magic, generation, check, confirmation, given_up] = words;
        let (confirmed, given_up) = (says_yes(confirmation), says_yes(given_up));
        Self { magic, generation, check, confirmed, given_up }
    }

    /// What makes a sector live, in the order in which it is programmed.
    pub(super) fn words_of(generation: u32) -> [u32; 3] {
        [MAGIC, generation, check_of(MAGIC, generation)]
    }

    /// The generation, if the header is whole.
    pub(super) fn generation(self) -> Option<u32> {
        (self.magic == MAGIC && self.check == check_of(MAGIC, self.generation)).then_some(self.generation)
    }

    /// Whether this, which is not whole or not the latest, was one that would count now, `live` being the generation that does;
    /// or is one of an earlier layout, whose values cannot be read any more.
    pub(super) fn was_live(self, live: Option<u32>) -> bool {
        if EARLIER.contains(&self.magic) && self.check == check_of(self.magic, self.generation) {
            return true;
        }
        let is_of = |n: u32| self.check == check_of(MAGIC, n);
        if let Some(live) = live {
            // The one left behind by the last move, though one of its words may be wrong.
            let (before, after) = (live.wrapping_sub(1), live.saturating_add(1));
            let left_behind = is_of(before) || self.generation == before && !is_of(after);
            if left_behind || self.generation < live && is_of(self.generation) {
                return false;
            }
        }
        // One that is being written is not confirmed, one that is being erased is given up.
        (self.magic ^ MAGIC).count_ones() <= MAGIC_FLIPS && self.confirmed && !self.given_up
    }
}

fn check_of(magic: u32, generation: u32) -> u32 {
    let mut bytes = [0; 2 * WORD];
    let (first, second) = bytes.split_at_mut(WORD);
    first.copy_from_slice(&magic.to_le_bytes());
    second.copy_from_slice(&generation.to_le_bytes());
    crc32(&bytes)
}

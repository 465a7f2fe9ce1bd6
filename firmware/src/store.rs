//! What outlives a reset and a new firmware: a few values in two sectors of flash, safe against a power cut at any moment.
//!
//! Records are appended to the *live* sector, the latest one of a key counts. When the sector is full, what is alive moves
//! into the other sector, which becomes live with its header, written behind all else. A record counts by its checksum, also
//! written behind it. So every write has one word that decides it, and before that word the old value stands: at no time is
//! the only copy of anything being erased.
//!
//! Behind that word comes one more, the *confirmation*, which decides nothing. What does not add up and is confirmed was whole
//! once: it is damaged, and [`Store::damage`] tells it. What is not confirmed was cut short; what is whole all the same counts,
//! and the next write moves it and confirms it. A sector that is given up says so in a word of its own before its header
//! falls, so that this is not taken for damage either.
//!
//! Damage outlives a move: a *mark*, a confirmed record that never adds up, stands for each damaged key until that very key is
//! written anew.
//!
//! The sector to move into is erased each time, whatever it reads as: cells of an erase cut short may read blank and not
//! stay so. The sector left behind keeps its older copies until then; its number of generation is lower, so it never counts
//! while the other one does.
//!
//! (`sequential-storage`, the well-known crate for this, was weighed and left out. It takes an erased page by two marker
//! words; an erase cut short that leaves both of them standing makes its repair erase the good page of two and rebuild it
//! from the broken one. `tests/tests/other_store.rs` shows it.)
//!
//! A read scans a sector, 4096 words, twice at most; a write does so four times, with a move fifteen times. It takes up to 68
//! words of programming, a move 790 and an erase.

mod flash;
mod header;
mod key;
mod order;
mod record;

pub use flash::{Flash, FlashFault, Sector};
use header::{CONFIRMATION, GIVEN_UP, HEADER_BYTES, SectorHeader, YES, says_yes};
pub use key::{Key, TABLES};
pub use order::{Done, Order};
use record::{Record, RecordHeader};

/// Bytes of each of the two sectors.
pub const SECTOR_BYTES: usize = 16 * 1024;
/// Bytes of the longest value.
pub const VALUE_BYTES: usize = 256;

/// Bytes of a word, the smallest that is written.
const WORD: usize = 4;
/// Header word, value, checksum, confirmation.
const RECORD_BYTES: usize = WORD + VALUE_BYTES + 2 * WORD;
/// An erased word.
const BLANK: u32 = u32::MAX;

// All keys at full length fit into half a sector: a move always makes room.
const _: () = assert!(HEADER_BYTES + (Key::ALL.len() + 1) * RECORD_BYTES < SECTOR_BYTES / 2);

/// Why a value was not read or written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StoreError {
    /// The flash failed.
    Flash(FlashFault),
    /// A value to be written is longer than [`VALUE_BYTES`].
    TooLong,
    /// A value that was read does not fit into the buffer; its length.
    Buffer(usize),
    /// Freshly erased flash does not hold what is written to it.
    WornOut,
}

impl StoreError {
    /// In words.
    pub const fn text(self) -> &'static str {
        match self {
            Self::Flash(FlashFault::Place) => "outside the store",
            Self::Flash(FlashFault::Locked) => "flash stays locked",
            Self::Flash(FlashFault::Busy) => "flash stays busy",
            Self::Flash(FlashFault::Refused(_)) => "flash raised an error flag",
            Self::TooLong => "too long",
            Self::Buffer(_) => "longer than it may be",
            Self::WornOut => "flash is worn out",
        }
    }
}

impl From<FlashFault> for StoreError {
    fn from(fault: FlashFault) -> Self {
        Self::Flash(fault)
    }
}

/// Where a walk through a sector's records ended.
struct Walk {
    /// Where the next record goes; the sector's end where no more may be appended.
    end: usize,
    /// Behind the last word that was looked at as the beginning of a record.
    looked_at: usize,
}

/// Which keys are damaged.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Damage {
    /// A bit for the code of each.
    codes: u32,
}

impl Damage {
    /// None of them.
    pub const NONE: Self = Self { codes: 0 };
    /// All of them.
    #[expect(clippy::indexing_slicing, reason = "evaluated by the compiler only")]
    pub const ALL: Self = {
        let (mut codes, mut n) = (0, 0);
        while n < Key::ALL.len() {
            codes |= 1 << Key::ALL[n].code();
            n += 1;
        }
        Self { codes }
    };

    fn set_code(&mut self, code: u8, damaged: bool) {
        // Codes of keys are below 32.
        let bit = 1_u32.checked_shl(code.into()).unwrap_or(0);
        self.codes = if damaged { self.codes | bit } else { self.codes & !bit };
    }

    /// Says of a key whether it is.
    pub fn set(&mut self, key: Key, damaged: bool) {
        self.set_code(key.code(), damaged);
    }

    /// Whether there is any.
    pub const fn is_any(self) -> bool {
        self.codes != 0
    }

    /// Whether this key is.
    pub const fn of(self, key: Key) -> bool {
        self.codes >> key.code() & 1 != 0
    }
}

/// The values. Keeps nothing in RAM: what counts is found in flash each time.
#[derive(Clone, Debug)]
pub struct Store<F> {
    flash: F,
}

impl<F: Flash> Store<F> {
    /// Whatever the flash holds, valid or not.
    pub const fn new(flash: F) -> Self {
        Self { flash }
    }

    /// The flash beneath.
    pub const fn flash(&mut self) -> &mut F {
        &mut self.flash
    }

    /// Copies the value of `key` to the beginning of `into` and answers its length, or none where there is no value.
    ///
    /// # Errors
    /// [`StoreError::Buffer`], [`StoreError::Flash`].
    #[inline(never)]
    pub fn read(&mut self, key: Key, into: &mut [u8]) -> Result<Option<usize>, StoreError> {
        let Some((sector, _)) = self.live()? else { return Ok(None) };
        let Some(record) = self.latest(sector, key)? else { return Ok(None) };
        let value = record.value();
        let target = into.get_mut(..value.len()).ok_or(StoreError::Buffer(value.len()))?;
        target.copy_from_slice(value);
        Ok(Some(value.len()))
    }

    /// For which keys [`Self::read`] may not answer what was written last, because flash has changed by itself: a later value,
    /// or all that follows in the sector, or the whole sector cannot be read. Writing a key mends it, for that key. A write cut
    /// short is no damage.
    ///
    /// # Errors
    /// [`StoreError::Flash`].
    #[inline(never)]
    pub fn damage(&mut self) -> Result<Damage, StoreError> {
        let live = self.live()?;
        let lost = self.was_live(Sector::First, live)? || self.was_live(Sector::Second, live)?;
        let mut damage = if lost { Damage::ALL } else { Damage::NONE };
        let Some((sector, _)) = live else { return Ok(damage) };
        let walk = self.walk(sector, |store, offset, header| {
            let whole = store.record(sector, offset, header)?.is_some();
            if whole || store.is_confirmed(sector, offset, header)? {
                damage.set_code(header.code, !whole);
            }
            Ok(())
        })?;
        Ok(if lost || !self.is_blank(sector, walk.looked_at)? { Damage::ALL } else { damage })
    }

    fn is_confirmed(
        &mut self,
        sector: Sector,
        offset: usize,
        header: RecordHeader,
    ) -> Result<bool, StoreError> {
        Ok(says_yes(self.word(sector, offset + header.record_bytes() - WORD)?))
    }

    /// Where the next record goes in the live sector; none where its header, or a record that is whole, is not confirmed.
    #[inline(never)]
    fn confirmed_end(&mut self, live: Sector) -> Result<Option<usize>, StoreError> {
        let mut confirmed = self.header(live)?.confirmed;
        let walk = self.walk(live, |store, offset, header| {
            confirmed &=
                store.is_confirmed(live, offset, header)? || store.record(live, offset, header)?.is_none();
            Ok(())
        })?;
        Ok(confirmed.then_some(walk.end))
    }

    /// Whether a sector that does not count did, and would now if it were not damaged.
    fn was_live(&mut self, sector: Sector, live: Option<(Sector, u32)>) -> Result<bool, StoreError> {
        let counts = live.is_some_and(|(live, _)| live == sector);
        Ok(!counts && self.header(sector)?.was_live(live.map(|(_, generation)| generation)))
    }

    /// Gives `key` a new value. Nothing is written where it has that value already. Where this ends early, by a power cut or
    /// an error, the old value or the new one stands.
    ///
    /// # Errors
    /// [`StoreError::TooLong`], [`StoreError::Flash`], [`StoreError::WornOut`].
    pub fn write(&mut self, key: Key, value: &[u8]) -> Result<(), StoreError> {
        if value.len() > VALUE_BYTES {
            return Err(StoreError::TooLong);
        }
        let header = RecordHeader { code: key.code(), length: value.len(), removed: false };
        self.put(key, &Record::new(header, value), Some(value))
    }

    /// Takes the value of `key` away, with the same safety.
    ///
    /// # Errors
    /// [`StoreError::Flash`], [`StoreError::WornOut`].
    pub fn remove(&mut self, key: Key) -> Result<(), StoreError> {
        let header = RecordHeader { code: key.code(), length: 0, removed: true };
        self.put(key, &Record::new(header, &[]), None)
    }

    /// Takes all values away. Where this ends early each key has its value or none.
    ///
    /// # Errors
    /// [`StoreError::Flash`].
    pub fn format(&mut self) -> Result<(), StoreError> {
        // What is stale must not come to life again: it goes first. Then the live header falls, so that no half-erased
        // sector counts.
        let live = self.live()?.map_or(Sector::First, |(sector, _)| sector);
        self.clear(live.other())?;
        self.clear(live)
    }

    /// Erases a sector. Its header falls before, or it could stand in what an erase cut short leaves.
    fn clear(&mut self, sector: Sector) -> Result<(), StoreError> {
        self.give_up(sector)?;
        self.flash.erase(sector)?;
        Ok(())
    }

    /// From now on a sector counts no more, and never did.
    fn give_up(&mut self, sector: Sector) -> Result<(), StoreError> {
        self.flash.program(sector, GIVEN_UP, YES)?;
        self.flash.program(sector, 0, 0)?;
        Ok(())
    }

    /// The sector that counts, and its generation.
    #[inline(never)]
    fn live(&mut self) -> Result<Option<(Sector, u32)>, StoreError> {
        let mut live: Option<(Sector, u32)> = None;
        for sector in Sector::BOTH {
            if let Some(generation) = self.generation(sector)?
                && live.is_none_or(|(_, best)| generation > best)
            {
                live = Some((sector, generation));
            }
        }
        Ok(live)
    }

    /// The generation of a sector, if its header is whole.
    fn generation(&mut self, sector: Sector) -> Result<Option<u32>, StoreError> {
        Ok(self.header(sector)?.generation())
    }

    #[inline(never)]
    fn header(&mut self, sector: Sector) -> Result<SectorHeader, StoreError> {
        let mut words = [0; HEADER_BYTES / WORD];
        for (n, word) in words.iter_mut().enumerate() {
            *word = self.word(sector, n * WORD)?;
        }
        Ok(SectorHeader::from_words(words))
    }

    /// Whether nothing is written from `offset` on.
    fn is_blank(&mut self, sector: Sector, offset: usize) -> Result<bool, StoreError> {
        let mut piece = [0; 16 * WORD];
        for at in (offset..SECTOR_BYTES).step_by(piece.len()) {
            let size = piece.len().min(SECTOR_BYTES - at);
            let piece = piece.get_mut(..size).unwrap_or_default();
            self.flash.read(sector, at, piece)?;
            if piece.iter().any(|byte| *byte != 0xFF) {
                return Ok(false);
            }
        }
        Ok(true)
    }

    fn word(&mut self, sector: Sector, offset: usize) -> Result<u32, StoreError> {
        let mut word = [0; WORD];
        self.flash.read(sector, offset, &mut word)?;
        Ok(u32::from_le_bytes(word))
    }

    /// Walks through the records and shows each to `visit`. Behind one whose length cannot be believed nothing is read and
    /// nothing more is written.
    fn walk(
        &mut self,
        sector: Sector,
        mut visit: impl FnMut(&mut Self, usize, RecordHeader) -> Result<(), StoreError>,
    ) -> Result<Walk, StoreError> {
        let mut walk = Walk { end: HEADER_BYTES, looked_at: HEADER_BYTES };
        // A record takes three words at least.
        for _ in 0..SECTOR_BYTES / (3 * WORD) {
            if walk.end + 3 * WORD > SECTOR_BYTES {
                break;
            }
            walk.looked_at = walk.end + WORD;
            let word = self.word(sector, walk.end)?;
            if word == BLANK {
                return Ok(walk);
            }
            let header = RecordHeader::from_word(word);
            let Some(header) = header.filter(|h| walk.end + h.record_bytes() <= SECTOR_BYTES) else {
                break;
            };
            visit(self, walk.end, header)?;
            walk.end += header.record_bytes();
            walk.looked_at = walk.end;
        }
        walk.end = SECTOR_BYTES;
        Ok(walk)
    }

    /// The record at `offset`, if it is whole.
    #[inline(never)]
    fn record(
        &mut self,
        sector: Sector,
        offset: usize,
        header: RecordHeader,
    ) -> Result<Option<Record>, StoreError> {
        let mut record = Record::new(header, &[]);
        record.length = header.length;
        let value = record.bytes.get_mut(WORD..WORD + header.length).unwrap_or_default();
        self.flash.read(sector, offset + WORD, value)?;
        let check = self.word(sector, offset + header.record_bytes() - 2 * WORD)?;
        Ok((check == record.checksum()).then_some(record))
    }

    /// The latest good record of a key, unless it says that the key is removed. One whose value is damaged is passed over.
    #[inline(never)]
    fn latest(&mut self, sector: Sector, key: Key) -> Result<Option<Record>, StoreError> {
        let mut latest = None;
        self.walk(sector, |store, offset, header| {
            if header.code == key.code() && store.record(sector, offset, header)?.is_some() {
                latest = Some((offset, header));
            }
            Ok(())
        })?;
        match latest {
            Some((offset, header)) if !header.removed => self.record(sector, offset, header),
            _ => Ok(None),
        }
    }

    /// Whether `key` has this value. Apart, as [`Self::begin`] is, so that no two records lie on the stack of a write.
    #[inline(never)]
    fn holds(&mut self, sector: Sector, key: Key, value: Option<&[u8]>) -> Result<bool, StoreError> {
        Ok(self.latest(sector, key)?.as_ref().map(Record::value) == value)
    }

    /// Appends `record`, in the live sector or, where it does not fit, after a move.
    #[inline(never)]
    fn put(&mut self, key: Key, record: &Record, value: Option<&[u8]>) -> Result<(), StoreError> {
        let found = self.live()?;
        let Some((live, generation)) = found else {
            let damage = self.damage()?;
            if value.is_none() && !damage.of(key) {
                return Ok(());
            }
            // What says that there is damage stands until its marks do.
            let lost = self.was_live(Sector::First, None)?;
            let begin = if lost { Sector::Second } else { Sector::First };
            self.begin(begin, 1, None, damage, key, record)?;
            return self.give_up(begin.other());
        };
        // Where a cut has left something unconfirmed the move makes it good.
        if let Some(mut end) = self.confirmed_end(live)? {
            if self.holds(live, key, value)? && !self.damage()?.of(key) {
                return Ok(());
            }
            let mut marked = true;
            // A sector that was live is damaged: it must not be told for ever, nor be forgotten.
            if self.was_live(live.other(), found)? {
                for key in Key::ALL {
                    marked &= self.mark(live, &mut end, key)?;
                }
                if marked {
                    self.give_up(live.other())?;
                }
            }
            if marked && self.append(live, end, record)?.is_some() {
                return Ok(());
            }
        }
        let damage = self.damage()?;
        self.begin(live.other(), generation.saturating_add(1), Some(live), damage, key, record)
    }

    /// Writes down at `end` that a key is damaged; answers whether there was room.
    fn mark(&mut self, sector: Sector, end: &mut usize, key: Key) -> Result<bool, StoreError> {
        let header = RecordHeader { code: key.code(), length: 0, removed: true };
        let mark = Record::new(header, &[]);
        if *end + mark.bytes_in_flash() > SECTOR_BYTES {
            return Ok(false);
        }
        for word in [header.word(), !mark.checksum(), YES] {
            self.flash.program(sector, *end, word)?;
            *end += WORD;
        }
        Ok(true)
    }

    /// Programs `record` and reads it again: where the next one goes, or none if there is no room or it does not hold.
    #[inline(never)]
    fn append(
        &mut self,
        sector: Sector,
        offset: usize,
        record: &Record,
    ) -> Result<Option<usize>, StoreError> {
        let bytes = record.bytes_in_flash();
        if offset + bytes > SECTOR_BYTES {
            return Ok(None);
        }
        for (n, word) in record.words().enumerate() {
            self.flash.program(sector, offset + n * WORD, word)?;
        }
        for (n, word) in record.words().enumerate() {
            if self.word(sector, offset + n * WORD)? != word {
                return Ok(None);
            }
        }
        self.flash.program(sector, offset + bytes - WORD, YES)?;
        Ok(Some(offset + bytes))
    }

    /// Makes `sector` live: erases it, takes over what is alive in `from` and what is damaged, adds `record` for `key`, and
    /// writes the header.
    #[inline(never)]
    fn begin(
        &mut self,
        sector: Sector,
        generation: u32,
        from: Option<Sector>,
        damage: Damage,
        key: Key,
        record: &Record,
    ) -> Result<(), StoreError> {
        self.clear(sector)?;
        let mut end = HEADER_BYTES;
        for other in Key::ALL.into_iter().filter(|other| other.code() != key.code()) {
            let kept = from.map(|from| self.latest(from, other)).transpose()?.flatten();
            if let Some(kept) = kept {
                end = self.append(sector, end, &kept)?.ok_or(StoreError::WornOut)?;
            }
            if damage.of(other) {
                self.mark(sector, &mut end, other)?;
            }
        }
        self.append(sector, end, record)?.ok_or(StoreError::WornOut)?;
        for (n, word) in SectorHeader::words_of(generation).into_iter().enumerate() {
            self.flash.program(sector, n * WORD, word)?;
        }
        if self.generation(sector)? != Some(generation) {
            return Err(StoreError::WornOut);
        }
        self.flash.program(sector, CONFIRMATION, YES)?;
        Ok(())
    }
}

#[cfg(test)]
mod tests;

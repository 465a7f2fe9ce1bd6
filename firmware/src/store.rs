//! What outlives a reset and a new firmware: a few values in two sectors of flash, safe against a power cut at any moment.
//!
//! Records are appended to the *live* sector, the latest one of a key counts. When the sector is full, what is alive moves
//! into the other sector, which becomes live with its header, written last. A record counts by its checksum, also written
//! last. So every write has one word that decides it, and before that word the old value stands: at no time is the only copy
//! of anything being erased.
//!
//! The sector to move into is erased each time, whatever it reads as: cells of an erase cut short may read blank and not
//! stay so. The sector left behind keeps its older copies until then; its number of generation is lower, so it never counts
//! while the other one does.
//!
//! (`sequential-storage`, the well-known crate for this, was weighed and left out. It takes an erased page by two marker
//! words; an erase cut short that leaves both of them standing makes its repair erase the good page of two and rebuild it
//! from the broken one.)
//!
//! Every call scans at most one sector: 16 KiB, 4096 words. A write takes up to 67 words of programming, a move 670 and an
//! erase.

mod order;
mod record;

use mintime_shared::crc32;
pub use order::{Done, Order};
use record::{Record, RecordHeader};

/// Bytes of each of the two sectors.
pub const SECTOR_BYTES: usize = 16 * 1024;
/// Bytes of the longest value.
pub const VALUE_BYTES: usize = 256;
/// Tables that are kept.
pub const TABLES: u8 = 8;

/// Bytes of a word, the smallest that is written.
const WORD: usize = 4;
/// Magic number and version of the layout ("MTS1"), generation, checksum of both.
const HEADER_BYTES: usize = 3 * WORD;
const MAGIC: u32 = u32::from_le_bytes(*b"MTS1");
/// Header word, value, checksum.
const RECORD_BYTES: usize = WORD + VALUE_BYTES + WORD;
/// An erased word.
const BLANK: u32 = u32::MAX;

// All keys at full length fit into half a sector: a move always makes room.
const _: () = assert!(HEADER_BYTES + (Key::ALL.len() + 1) * RECORD_BYTES < SECTOR_BYTES / 2);

/// One of the two sectors.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sector {
    /// At the lower address.
    First,
    /// Behind it.
    Second,
}

impl Sector {
    const BOTH: [Self; 2] = [Self::First, Self::Second];

    const fn other(self) -> Self {
        match self {
            Self::First => Self::Second,
            Self::Second => Self::First,
        }
    }
}

/// The flash beneath: two sectors that are read by bytes, programmed by words (bits only fall) and erased whole.
pub trait Flash {
    /// Reads.
    ///
    /// # Errors
    /// [`FlashFault`].
    fn read(&mut self, sector: Sector, offset: usize, into: &mut [u8]) -> Result<(), FlashFault>;
    /// Programs the word at `offset`, a multiple of four.
    ///
    /// # Errors
    /// [`FlashFault`].
    fn program(&mut self, sector: Sector, offset: usize, word: u32) -> Result<(), FlashFault>;
    /// Makes all of a sector 0xFF.
    ///
    /// # Errors
    /// [`FlashFault`].
    fn erase(&mut self, sector: Sector) -> Result<(), FlashFault>;
}

/// The flash did not do what it was asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FlashFault {
    /// Beyond the end of a sector, or no multiple of a word.
    Place,
    /// It could not be unlocked.
    Locked,
    /// It was busy for too long.
    Busy,
    /// It raised an error flag; the status register.
    Refused(u32),
}

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

/// What a value is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Key {
    /// The vehicle's parameters.
    Vehicle,
    /// How the board behaves: receiver, limits.
    Settings,
    /// The key that host and vehicle share.
    Pairing,
    /// A maneuver table, 0 to [`TABLES`] − 1; higher numbers are kept as the highest.
    Table(u8),
}

impl Key {
    /// Every key.
    pub const ALL: [Self; 11] = [
        Self::Vehicle,
        Self::Settings,
        Self::Pairing,
        Self::Table(0),
        Self::Table(1),
        Self::Table(2),
        Self::Table(3),
        Self::Table(4),
        Self::Table(5),
        Self::Table(6),
        Self::Table(7),
    ];

    /// Its number in flash, which never changes its meaning.
    pub const fn code(self) -> u8 {
        match self {
            Self::Vehicle => 1,
            Self::Settings => 2,
            Self::Pairing => 3,
            Self::Table(n) if n < TABLES => 16 + n,
            Self::Table(_) => 16 + TABLES - 1,
        }
    }
}

/// What a scan of a sector found.
struct Scan {
    /// The latest good record of the key asked for.
    latest: Option<(usize, RecordHeader)>,
    /// Where the next record goes; the sector's end where no more may be appended.
    end: usize,
}

/// The values. Keeps nothing in RAM: what counts is found in flash each time.
#[derive(Debug)]
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
        self.flash.erase(live.other())?;
        self.flash.program(live, 0, 0)?;
        self.flash.erase(live)?;
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
        let [magic, generation, check] =
            [self.word(sector, 0)?, self.word(sector, WORD)?, self.word(sector, 2 * WORD)?];
        let valid = magic == MAGIC && check == header_check(generation);
        Ok(valid.then_some(generation))
    }

    fn word(&mut self, sector: Sector, offset: usize) -> Result<u32, StoreError> {
        let mut word = [0; WORD];
        self.flash.read(sector, offset, &mut word)?;
        Ok(u32::from_le_bytes(word))
    }

    /// Walks through the records. One whose value is damaged is passed over; behind one whose length cannot be believed
    /// nothing is read and nothing more is written.
    #[inline(never)]
    fn scan(&mut self, sector: Sector, key: Key) -> Result<Scan, StoreError> {
        let mut found = Scan { latest: None, end: HEADER_BYTES };
        // A record takes two words at least.
        for _ in 0..SECTOR_BYTES / (2 * WORD) {
            if found.end + 2 * WORD > SECTOR_BYTES {
                break;
            }
            let word = self.word(sector, found.end)?;
            if word == BLANK {
                return Ok(found);
            }
            let header = RecordHeader::from_word(word);
            let Some(header) = header.filter(|h| found.end + h.record_bytes() <= SECTOR_BYTES) else {
                break;
            };
            if header.code == key.code() && self.record(sector, found.end, header)?.is_some() {
                found.latest = Some((found.end, header));
            }
            found.end += header.record_bytes();
        }
        found.end = SECTOR_BYTES;
        Ok(found)
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
        let check = self.word(sector, offset + header.record_bytes() - WORD)?;
        Ok((check == record.checksum()).then_some(record))
    }

    /// The latest record of a key, unless it says that the key is removed.
    #[inline(never)]
    fn latest(&mut self, sector: Sector, key: Key) -> Result<Option<Record>, StoreError> {
        match self.scan(sector, key)?.latest {
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
        let Some((live, generation)) = self.live()? else {
            if value.is_none() {
                return Ok(());
            }
            return self.begin(Sector::First, 1, None, key, record);
        };
        if self.holds(live, key, value)? {
            return Ok(());
        }
        let end = self.scan(live, key)?.end;
        if self.append(live, end, record)?.is_some() {
            return Ok(());
        }
        self.begin(live.other(), generation.saturating_add(1), Some(live), key, record)
    }

    /// Programs `record` and reads it again: where the next one goes, or none if there is no room or it does not hold.
    #[inline(never)]
    fn append(
        &mut self,
        sector: Sector,
        offset: usize,
        record: &Record,
    ) -> Result<Option<usize>, StoreError> {
        let bytes = WORD + record.length.next_multiple_of(WORD) + WORD;
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
        Ok(Some(offset + bytes))
    }

    /// Makes `sector` live: erases it, takes over what is alive in `from`, adds `record` for `key`, and writes the header.
    #[inline(never)]
    fn begin(
        &mut self,
        sector: Sector,
        generation: u32,
        from: Option<Sector>,
        key: Key,
        record: &Record,
    ) -> Result<(), StoreError> {
        self.flash.erase(sector)?;
        let mut end = HEADER_BYTES;
        if let Some(from) = from {
            for other in Key::ALL.into_iter().filter(|other| other.code() != key.code()) {
                if let Some(kept) = self.latest(from, other)? {
                    end = self.append(sector, end, &kept)?.ok_or(StoreError::WornOut)?;
                }
            }
        }
        self.append(sector, end, record)?.ok_or(StoreError::WornOut)?;
        let header = [MAGIC, generation, header_check(generation)];
        for (n, word) in header.into_iter().enumerate() {
            self.flash.program(sector, n * WORD, word)?;
        }
        if self.generation(sector)? == Some(generation) { Ok(()) } else { Err(StoreError::WornOut) }
    }
}

fn header_check(generation: u32) -> u32 {
    let mut bytes = [0; 2 * WORD];
    let (magic, number) = bytes.split_at_mut(WORD);
    magic.copy_from_slice(&MAGIC.to_le_bytes());
    number.copy_from_slice(&generation.to_le_bytes());
    crc32(&bytes)
}

#[cfg(test)]
mod tests;

//! The flash beneath the store.

/// One of the two sectors.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sector {
    /// At the lower address.
    First,
    /// Behind it.
    Second,
}

impl Sector {
    pub(super) const BOTH: [Self; 2] = [Self::First, Self::Second];

    pub(super) const fn other(self) -> Self {
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

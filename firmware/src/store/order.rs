//! What the flight logic wants kept, on its way to whoever may write flash.

use heapless::Vec;

use super::{Flash, Key, Store, StoreError, VALUE_BYTES};

/// A change of the store.
#[derive(Clone, Debug, PartialEq, Eq)]
#[expect(clippy::large_enum_variant, reason = "there is no allocation, and one order at a time")]
pub enum Order {
    /// A new value.
    Write(Key, Vec<u8, VALUE_BYTES>),
    /// No value any more.
    Remove(Key),
    /// No values at all.
    Format,
}

impl Order {
    /// To write `value`.
    ///
    /// # Errors
    /// [`StoreError::TooLong`].
    pub fn write(key: Key, value: &[u8]) -> Result<Self, StoreError> {
        Vec::from_slice(value).map(|value| Self::Write(key, value)).map_err(|_| StoreError::TooLong)
    }

    /// Does it.
    ///
    /// # Errors
    /// [`StoreError`].
    pub fn carry_out<F: Flash>(&self, store: &mut Store<F>) -> Result<(), StoreError> {
        match self {
            Self::Write(key, value) => store.write(*key, value),
            Self::Remove(key) => store.remove(*key),
            Self::Format => store.format(),
        }
    }
}

/// What became of an order.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Done {
    /// The number it was given.
    pub number: u32,
    /// Whether it is in flash.
    pub result: Result<(), StoreError>,
}

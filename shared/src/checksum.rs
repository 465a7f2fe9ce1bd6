//! CRC-32 (ISO-HDLC, the one of zip and Ethernet), used by the table, the frames and the identity hashes.

use crc::{CRC_32_ISO_HDLC, Crc, Table};

/// A byte at a time, with a table of 1 KiB: sixteen at a time would take 16 KiB of the vehicle's flash.
const CRC32: Crc<u32, Table<1>> = Crc::<u32, Table<1>>::new(&CRC_32_ISO_HDLC);

/// CRC-32 of bytes.
pub const fn crc32(bytes: &[u8]) -> u32 {
    CRC32.checksum(bytes)
}

/// Appends the checksum of the first `length` bytes, little-endian. Returns the new length, or `None` where the
/// buffer is too small.
pub(crate) fn append(buffer: &mut [u8], length: usize) -> Option<usize> {
    let checksum = crc32(buffer.get(..length)?).to_le_bytes();
    buffer.get_mut(length..length + checksum.len())?.copy_from_slice(&checksum);
    Some(length + checksum.len())
}

/// Splits bytes into what precedes the checksum and whether the checksum holds. `None` where there is no room for one.
pub(crate) fn split(bytes: &[u8]) -> Option<(&[u8], bool)> {
    let (body, tail) = bytes.split_last_chunk::<4>()?;
    Some((body, crc32(body) == u32::from_le_bytes(*tail)))
}

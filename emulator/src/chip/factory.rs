//! What the factory wrote into system memory: the chip's identity, the size of its flash and calibration values (RM0090
//! section 39; DS8626, temperature sensor and internal reference).

use std::ops::Range;

/// Where all of it lies.
pub(super) const BYTES: Range<u32> = 0x1FFF_7A10..0x1FFF_7A30;
/// For messages.
pub(super) const NAME: &str = "the factory's data";

/// Coordinates on the wafer, its number, and its lot as text: any chip's would do.
const IDENTITY: [u8; 12] = [0x2A, 0x00, 0x31, 0x00, 0x0E, b'1', b'7', b'9', b'6', b'3', b'3', b'8'];
/// KiB.
const FLASH_KIB: u16 = (crate::memory::FLASH_BYTES >> 10) as u16;
/// At 3.3 V: the internal reference of 1.21 V, and the temperature sensor at 30 and 110 °C, 0.76 V at 25 °C and 2.5 mV/K.
const CALIBRATION: [u16; 3] = [1502, 959, 1207];

/// Reads up to four bytes.
pub(super) fn read(offset: u32, bytes: usize) -> u32 {
    let mut content = [0xFF; 32];
    content[..12].copy_from_slice(&IDENTITY);
    content[0x12..0x14].copy_from_slice(&FLASH_KIB.to_le_bytes());
    for (place, value) in content[0x1A..].chunks_exact_mut(2).zip(CALIBRATION) {
        place.copy_from_slice(&value.to_le_bytes());
    }
    content.iter().skip(offset as usize).take(bytes).rev().fold(0, |word, &byte| word << 8 | u32::from(byte))
}

//! COBS in place. Up to 253 bytes it moves nothing: behind one more byte in front, the content stands as it is, but for its
//! zeros, each of which tells how far it is to the next. The library, which goes byte by byte, does what is longer.

/// Content from which on COBS may put a byte in between.
const LONG: usize = 254;
/// A code that stands for 254 bytes without a zero behind them.
const CHAIN: u8 = 0xFF;

/// Turns the content in `bytes[1..=length]` into its code in `bytes[..coded]`, followed by the zero that ends a frame; answers
/// `coded`. `None` where there is no room for both.
pub(crate) fn encode(bytes: &mut [u8], length: usize) -> Option<usize> {
    let coded = if length < LONG { encode_short(bytes, length)? } else { encode_long(bytes, length)? };
    *bytes.get_mut(coded)? = 0;
    Some(coded)
}

fn encode_short(bytes: &mut [u8], length: usize) -> Option<usize> {
    let mut code = bytes.get_mut(..=length)?.iter_mut();
    let mut group = code.next()?;
    let mut rest = code.into_slice();
    while let Some(zero) = rest.iter().position(|byte| *byte == 0) {
        // Less than 254.
        *group = zero as u8 + 1;
        let (_, from_zero) = rest.split_at_mut_checked(zero)?;
        (group, rest) = from_zero.split_first_mut()?;
    }
    *group = rest.len() as u8 + 1;
    Some(length + 1)
}

/// Apart, for the room on the stack.
#[inline(never)]
fn encode_long(bytes: &mut [u8], length: usize) -> Option<usize> {
    let mut content = [0; crate::framing::MAX_FRAME_BYTES];
    let content = content.get_mut(..length)?;
    content.copy_from_slice(bytes.get(1..=length)?);
    // Room for the zero as well.
    let room = cobs::max_encoding_length(length) < bytes.len();
    // Behind a last group of 254 bytes the encoder leaves the beginning of an empty one.
    room.then(|| cobs::encode(content, bytes))
}

/// The content of a code, which holds no zero. `None` where it does not add up.
pub(crate) fn decode(coded: &mut [u8]) -> Option<&[u8]> {
    let (mut next, mut chained) = (0, false);
    while let Some(&code) = coded.get(next) {
        chained |= code == CHAIN;
        // At least one, or this would not end.
        next += usize::from(code.max(1));
    }
    if chained {
        let length = cobs::decode_in_place(coded).ok()?;
        return coded.get(..length);
    }
    if next != coded.len() {
        return None;
    }
    next = 0;
    while let Some(code) = coded.get_mut(next) {
        next += usize::from(core::mem::take(code).max(1));
    }
    coded.get(1..)
}

#[cfg(test)]
mod tests {
    use std::vec::Vec;

    use proptest::prelude::*;

    use super::*;
    use crate::framing::MAX_FRAME_BYTES;

    fn content() -> impl Strategy<Value = Vec<u8>> {
        // Zeros often, now and then, and never.
        let byte = prop_oneof![Just(0), any::<u8>(), 1..=u8::MAX];
        prop_oneof![
            prop::collection::vec(byte, 1..=276),
            prop::collection::vec(any::<u8>(), 1..=276),
            prop::collection::vec(1..=u8::MAX, 240..=276),
        ]
    }

    /// What the library makes of it.
    fn library(content: &[u8]) -> Vec<u8> {
        let mut coded = std::vec![0; cobs::max_encoding_length(content.len())];
        let length = cobs::encode(content, &mut coded);
        coded.truncate(length);
        coded
    }

    proptest! {
        #[test]
        fn it_is_the_librarys_code(content in content()) {
            let mut bytes = [0xAA; MAX_FRAME_BYTES];
            bytes[1..=content.len()].copy_from_slice(&content);
            let length = encode(&mut bytes, content.len()).expect("room");
            prop_assert_eq!(&bytes[..length], &library(&content)[..]);
            prop_assert_eq!(bytes[length], 0);
            prop_assert_eq!(decode(&mut bytes[..length]), Some(&content[..]));
        }

        #[test]
        fn any_code_is_read_as_the_library_reads_it(mut coded in prop::collection::vec(
            prop_oneof![4 => 1..=u8::MAX, 2 => 1..6_u8, 1 => Just(CHAIN)], 1..280,
        )) {
            let mut other = coded.clone();
            let expected = cobs::decode_in_place(&mut other).ok().map(|length| &other[..length]);
            prop_assert_eq!(decode(&mut coded), expected);
        }
    }

    #[test]
    fn without_room_there_is_no_code() {
        for (room, length) in [(0, 0), (1, 0), (5, 4), (255, 254), (10, 10), (10, 300)] {
            let coded = encode(&mut std::vec![7; room], length);
            assert_eq!(coded, None, "{length} in {room}");
        }
        assert_eq!(encode(&mut [7; 2], 0), Some(1));
        assert_eq!(encode(&mut [7; 6], 4), Some(5));
    }
}

//! Arbitrary contents in sound frames into a vehicle that flies.
#![no_main]

libfuzzer_sys::fuzz_target!(|data: &[u8]| {
    mintime_tests::fuzz::past_checksum(data);
});

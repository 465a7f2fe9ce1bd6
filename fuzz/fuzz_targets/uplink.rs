//! Bytes from the serial line into a vehicle that flies.
#![no_main]

libfuzzer_sys::fuzz_target!(|data: &[u8]| {
    mintime_tests::fuzz::uplink(data);
});

//! Bytes from the receiver of the kill switch.
#![no_main]

libfuzzer_sys::fuzz_target!(|data: &[u8]| mintime_tests::fuzz::receiver(data));

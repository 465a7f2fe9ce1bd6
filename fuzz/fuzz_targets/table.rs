//! Bytes as a maneuver table, and the replay of what passes for one.
#![no_main]

libfuzzer_sys::fuzz_target!(|data: &[u8]| mintime_tests::fuzz::table(data));

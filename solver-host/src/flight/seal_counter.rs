//! Counters of seals: above every earlier one, of this program and of those beside it.
//!
//! They follow the computer's clock, so that programs of one computer may come, go and run side by side without a word. Where
//! the clock has been set back, or another computer's is ahead, the vehicle tells the last counter it took, and they go on
//! above that. The counter has 32 bits: the clock's part of it begins anew every [`EPOCH`] counts, 99 days; who is above it then
//! counts on by one a seal, in a part of the numbers that no clock comes to.

use std::time::{SystemTime, UNIX_EPOCH};

/// Counts of the clock, 1/s: more than one program seals.
const RATE_HZ: f64 = 500.0;
/// Numbers above those of the clock: fifteen hours of seals at 300 a second, for a vehicle that meets the end of an epoch.
const RESERVE: u64 = 1 << 24;
/// Counts of the clock until it begins anew.
const EPOCH: u64 = (1 << 32) - RESERVE;

/// A vehicle takes no seal any more that anybody can make.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("the vehicle has taken the last of its counters of seals: switch it off and on")]
pub struct SealsUsedUp;

/// The counter of the last seal.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct SealCounter {
    last: u32,
}

impl SealCounter {
    /// The counter of the next seal at a time, s since 1970.
    ///
    /// # Errors
    /// [`SealsUsedUp`] where there is none above the last.
    pub(super) fn next(&mut self, unix_s: f64) -> Result<u32, SealsUsedUp> {
        let by_clock = (counts(unix_s) % EPOCH) as u32;
        self.last = self.last.checked_add(1).ok_or(SealsUsedUp)?.max(by_clock);
        Ok(self.last)
    }

    /// Goes on above this one.
    pub(super) fn exceed(&mut self, last: u32) {
        self.last = self.last.max(last);
    }
}

/// Time since 1970, s.
pub(super) fn now_s() -> f64 {
    SystemTime::now().duration_since(UNIX_EPOCH).map_or(0.0, |since| since.as_secs_f64())
}

fn counts(unix_s: f64) -> u64 {
    (unix_s * RATE_HZ) as u64
}

#[cfg(test)]
mod tests {
    use mintime_shared::seal::{PairingKey, open, seal};

    use super::*;

    const KEY: PairingKey = [7; 16];
    /// The end of an epoch, in April 2025.
    const END_S: f64 = 204.0 * EPOCH as f64 / RATE_HZ;

    /// As a vehicle takes them.
    fn taken(last: &mut u32, counter: u32) -> bool {
        let sealed = [&b"request"[..], &seal(&KEY, 1, counter, b"request")].concat();
        let opened = open(&KEY, 1, *last, &sealed);
        *last = opened.map_or(*last, |(_, counter)| counter);
        opened.is_some()
    }

    #[test]
    fn a_program_goes_on_over_the_end_of_an_epoch() {
        let (mut counter, mut last) = (SealCounter::default(), 0);
        // 300 requests a second for a minute before and an hour after it, on a clock that has been set back by a second once.
        for step in 0..300 * 3660 {
            let unix_s = END_S - 60.0 + f64::from(step) / 300.0 - if step > 10_000 { 1.0 } else { 0.0 };
            let next = counter.next(unix_s).expect("there are more");
            assert!(taken(&mut last, next), "{next} behind {last} at {}", unix_s - END_S);
        }
    }

    #[test]
    fn programs_follow_each_other_within_an_epoch() {
        let mut last = 0;
        for program in 0..1000 {
            let mut counter = SealCounter::default();
            for request in 0..200 {
                let unix_s = END_S + 100.0 * f64::from(program) + f64::from(request) / 300.0;
                assert!(taken(&mut last, counter.next(unix_s).expect("there are more")));
            }
        }
    }

    /// Told the vehicle's last counter, a program is heard whatever its clock says: at the end of an epoch, or set back a year.
    #[test]
    fn a_program_goes_on_above_the_vehicle() {
        let mut last = 0;
        let before = SealCounter::default().next(END_S - 0.01).expect("there are more");
        assert!(u64::from(before) > EPOCH - 10 && taken(&mut last, before));
        for unix_s in [END_S + 0.01, END_S + 3600.0, END_S - 3e7, 0.0] {
            let mut counter = SealCounter::default();
            assert!(!taken(&mut last, counter.next(unix_s).expect("there are more")), "{unix_s}");
            counter.exceed(last);
            assert!(taken(&mut last, counter.next(unix_s).expect("there are more")), "{unix_s}");
        }
        // What it hears of an older time takes nothing back.
        let mut counter = SealCounter { last: 70 };
        counter.exceed(50);
        assert_eq!(counter.next(0.0), Ok(71));
    }

    #[test]
    fn the_last_number_is_not_used_twice() {
        let mut counter = SealCounter { last: u32::MAX - 1 };
        assert_eq!(counter.next(END_S), Ok(u32::MAX));
        assert_eq!(counter.next(END_S), Err(SealsUsedUp));
        assert_eq!(counter.next(END_S + 1000.0), Err(SealsUsedUp));
        // A clock before 1970 counts as 1970.
        assert_eq!(SealCounter::default().next(-1.0), Ok(1));
    }
}

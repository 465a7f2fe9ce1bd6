//! Counters of seals: above every earlier one, of this program and of those before it.
//!
//! They follow the computer's clock, so that programs may come and go. The counter has 32 bits and so begins anew every
//! [`EPOCH`] counts, 99 days. A program that is under way then goes on above, in a part of the numbers that no clock comes to;
//! one that begins later, with a vehicle that has been on since before, is refused: [`SealCounter::is_young`] tells why.

use std::time::{SystemTime, UNIX_EPOCH};

/// Counts of the clock, 1/s.
const RATE_HZ: f64 = 500.0;
/// Numbers above those of the clock: nine hours of seals at the clock's rate, for a program that meets the end of an epoch.
const RESERVE: u64 = 1 << 24;
/// Counts of the clock until it begins anew.
const EPOCH: u64 = (1 << 32) - RESERVE;
/// A vehicle that has been on since before the epoch began has been on for this long at most, s.
const LONGEST_SESSION_S: f64 = 86_400.0;

/// A vehicle takes no seal any more that this computer can make.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error(
    "the counter of seals has begun anew today, as it does every 99 days, and the vehicle has heard a higher one: switch the \
     vehicle off and on; if that does not help, give the key that it is paired with"
)]
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

    /// Whether the clock began anew so short a time ago that a vehicle may have heard higher counters in this session.
    pub(super) fn is_young(unix_s: f64) -> bool {
        ((counts(unix_s) % EPOCH) as f64) < LONGEST_SESSION_S * RATE_HZ
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

    /// The one case that is refused, and that it is explained.
    #[test]
    fn a_program_that_begins_behind_the_end_is_young() {
        let mut last = 0;
        let before = SealCounter::default().next(END_S - 0.01).expect("there are more");
        assert!(u64::from(before) > EPOCH - 10 && taken(&mut last, before));
        assert!(!SealCounter::is_young(END_S - 0.01));
        let after = SealCounter::default().next(END_S + 0.01).expect("there are more");
        assert!(after < 10 && !taken(&mut last, after));
        assert!(SealCounter::is_young(END_S + 0.01));
        assert!(SealCounter::is_young(END_S + LONGEST_SESSION_S - 0.01));
        assert!(!SealCounter::is_young(END_S + LONGEST_SESSION_S + 0.01));
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

//! Counters of seals: above every earlier one, of this program and of those beside it.
//!
//! They follow the computer's clock, so that programs of one computer may come, go and run side by side without a word; where two
//! seal in the same instant one of them seals again. Where the clock has been set back, or another computer's is ahead, the
//! vehicle tells the last counter it took, and this clock is put forward by as much. The counter has 32 bits: the clock begins
//! anew every [`EPOCH`] counts, 99 days; who is above it then goes on in a part of the numbers that no clock comes to.

use std::time::{SystemTime, UNIX_EPOCH};

/// Counts of the clock, 1/s: more than one program seals.
const RATE_HZ: f64 = 500.0;
/// Numbers above those of the clock: nine hours of it, for a vehicle that meets the end of an epoch.
const RESERVE: u64 = 1 << 24;
/// Counts of the clock until it begins anew.
const EPOCH: u64 = (1 << 32) - RESERVE;

/// What a stop goes ahead of the clock, counts: ten seconds. Whatever other programs seal while it is on its way, it counts.
const STOP_AHEAD: u32 = 5000;

/// Longest time from a question to its answer that is believed, s.
pub(super) const LONGEST_TRIP_S: f64 = 1.0;

/// A vehicle takes no seal any more that anybody can make.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("the vehicle has taken the last of its counters of seals: switch it off and on")]
pub struct SealsUsedUp;

/// The counter of the last seal.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct SealCounter {
    last: u32,
    /// What this clock was put forward by, or back, counts.
    ahead: i64,
}

impl SealCounter {
    /// The counter of the next seal at a time, s since 1970.
    ///
    /// # Errors
    /// [`SealsUsedUp`] where there is none above the last.
    pub(super) fn next(&mut self, unix_s: f64) -> Result<u32, SealsUsedUp> {
        self.last = self.last.checked_add(1).ok_or(SealsUsedUp)?.max(self.by_clock(unix_s));
        Ok(self.last)
    }

    /// The next seal is a stop's.
    pub(super) fn hurry(&mut self, unix_s: f64) {
        self.last = self.last.max(self.by_clock(unix_s)).saturating_add(STOP_AHEAD);
    }

    /// A seal was refused, and this one the vehicle took last; it was asked so long ago, s. Where that was ahead of this clock
    /// then, the clock is put forward by the difference: who seals beside this program is met, not overtaken. Where the two agree
    /// a seal of the other one came shortly before, as it may each time: a little forward.
    pub(super) fn catch_up(&mut self, last: u32, ago_s: f64, unix_s: f64) {
        const LITTLE: i64 = 2;
        const AGREE: i64 = -10;
        self.ahead = self.ahead.saturating_add(match self.behind(last, ago_s, unix_s) {
            behind if behind > 0 => behind,
            AGREE.. => LITTLE,
            _ => 0,
        });
    }

    /// The same at the beginning of a session: also a clock that is ahead is set by the vehicle, or what was sealed by it would
    /// shut out who is at work there.
    pub(super) fn meet(&mut self, last: u32, ago_s: f64, unix_s: f64) {
        const FAR: i64 = RATE_HZ as i64;
        let behind = self.behind(last, ago_s, unix_s);
        if behind > 0 || behind < -FAR && last > 0 {
            self.ahead = self.ahead.saturating_add(behind);
        }
        self.last = last;
    }

    /// Counts that this clock was behind another one.
    fn behind(&self, last: u32, ago_s: f64, unix_s: f64) -> i64 {
        // A time that is no number is none.
        let ago_s = if ago_s > 0.0 { ago_s.min(LONGEST_TRIP_S) } else { 0.0 };
        i64::from(last) - i64::from(self.by_clock(unix_s - ago_s))
    }

    fn by_clock(&self, unix_s: f64) -> u32 {
        // Within 32 bits.
        self.ahead.saturating_add((counts(unix_s) % EPOCH) as i64).clamp(0, i64::from(u32::MAX)) as u32
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
    fn a_program_catches_up_with_the_vehicle() {
        let mut last = 0;
        let before = SealCounter::default().next(END_S - 0.01).expect("there are more");
        assert!(u64::from(before) > EPOCH - 10 && taken(&mut last, before));
        for unix_s in [END_S + 0.2, END_S + 3600.0, END_S - 3e7, 10.0] {
            let mut counter = SealCounter::default();
            assert!(!taken(&mut last, counter.next(unix_s).expect("there are more")), "{unix_s}");
            counter.catch_up(last, 0.1, unix_s);
            assert!(taken(&mut last, counter.next(unix_s).expect("there are more")), "{unix_s}");
        }
    }

    /// What is heard of a time that this clock has passed changes nothing: who is told so often runs away from nobody.
    #[test]
    fn a_clock_that_is_right_is_not_put_forward() {
        let mut counter = SealCounter::default();
        let now = counter.next(END_S + 100.0).expect("there are more");
        for ago_s in [0.0, f64::NAN, -3.0] {
            counter.catch_up(now - 11, ago_s, END_S + 100.0);
        }
        counter.catch_up(now - 261, 0.5, END_S + 100.0);
        counter.catch_up(now - 511, 1e9, END_S + 100.0);
        assert_eq!(counter.next(END_S + 100.0), Ok(now + 1));
        assert_eq!(counter.next(END_S + 101.0), Ok(now + 500));
        // Two that seal in step: each time a little.
        counter.catch_up(now + 500, 0.0, END_S + 101.0);
        assert_eq!(counter.next(END_S + 101.0), Ok(now + 502));
    }

    /// Two clocks that differ by a day, in either direction, meet: hardly any seal of who was there first is refused.
    #[test]
    fn clocks_that_differ_meet() {
        for differ_s in [86_400.0, -86_400.0, 5.0, -5.0, 0.0] {
            let (mut first, mut other, mut last) = (SealCounter::default(), SealCounter::default(), 0);
            let (mut heard, mut told, mut answered) = (0, 0, 0);
            // What the vehicle's counter was 40 ms ago, when it was asked.
            let mut earlier = [0; 4];
            for step in 0..6000_u32 {
                let unix_s = END_S + 1e5 + f64::from(step) * 0.01;
                heard += u32::from(taken(&mut last, first.next(unix_s).expect("there are more")));
                let its_s = unix_s + differ_s + 0.005;
                let asked = earlier[step as usize % 4];
                earlier[step as usize % 4] = last;
                if step == 50 {
                    other.meet(asked, 0.04, its_s);
                }
                if step > 50 && step % 5 == 3 {
                    if taken(&mut last, other.next(its_s).expect("there are more")) {
                        answered += 1;
                    } else {
                        told += 1;
                        other.catch_up(asked, 0.04, its_s);
                    }
                }
            }
            assert!(heard > 5900, "{differ_s}: {heard} of 6000 heard");
            assert!(answered > 1150 && told < 10, "{differ_s}: {answered} answered, told {told} times");
        }
    }

    #[test]
    fn a_stop_is_ahead_of_whoever_is_at_work() {
        let (mut flight, mut stop, mut last) = (SealCounter::default(), SealCounter::default(), 0);
        for step in 0..900 {
            taken(&mut last, flight.next(END_S + 50.0 + f64::from(step) * 0.01).expect("there are more"));
        }
        // Made before the flight went on for nine seconds.
        stop.hurry(END_S + 50.0);
        assert!(taken(&mut last, stop.next(END_S + 50.0).expect("there are more")));
    }

    #[test]
    fn the_last_number_is_not_used_twice() {
        let mut counter = SealCounter { last: u32::MAX - 1, ahead: 0 };
        assert_eq!(counter.next(END_S), Ok(u32::MAX));
        assert_eq!(counter.next(END_S), Err(SealsUsedUp));
        assert_eq!(counter.next(END_S + 1000.0), Err(SealsUsedUp));
        // A clock before 1970 counts as 1970.
        assert_eq!(SealCounter::default().next(-1.0), Ok(1));
        // Put forward beyond all numbers it ends there.
        let mut counter = SealCounter { last: 0, ahead: i64::MAX };
        counter.hurry(END_S);
        assert_eq!(counter.next(END_S), Err(SealsUsedUp));
    }
}

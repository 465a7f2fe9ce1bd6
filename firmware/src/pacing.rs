//! When a tick runs: at each data-ready edge of the gyro, and by a timer where the edge stays away.
//!
//! No clock and no hardware: a board tells of edges and of its timer's firing and asks how long to wait, and for how long
//! behind an edge it need not listen to others. Every tick is later than the one before or at the same time, whatever order
//! the two events are served in. Only a clock that runs backwards by more than a period is passed on as it is: the flight
//! logic must see that.

use mintime_shared::replay::TICK_PERIOD_US;

/// Nominal period, µs. Intervals are worked out in 32 bits: the vehicle divides 64 by a long routine.
const PERIOD_US: u64 = TICK_PERIOD_US as u64;
/// An edge is waited for this long after the one before, µs.
const EDGE_TIMEOUT_US: u64 = PERIOD_US * 3 / 2;
/// The gyro's clock and the vehicle's differ by no more than this, percent: the gyro's own is off by up to three.
const CLOCK_ERROR_PERCENT: u32 = 5;
/// An edge that comes before this part of the gyro's own period is noise on the line, percent. Were it taken for a tick, it
/// would find an old sample, and the true edge behind it would count as the noise.
const EDGE_MIN_PERCENT: u32 = 85;
/// Beyond this part of it the edge before was not the last one, percent.
const EDGE_MAX_PERCENT: u32 = 115;
/// How finely the period is kept, parts of a microsecond, and how many edges it is the mean of.
const SMOOTHING: u32 = 16;

/// Decides which events are ticks.
#[derive(Clone, Copy, Debug)]
pub struct Pacer {
    last_edge_us: Option<u64>,
    /// From edge to edge by the vehicle's clock, 1/[`SMOOTHING`] µs.
    period: u32,
    last_tick_us: u64,
    deadline_us: u64,
    missed: u32,
    spurious: u32,
}

impl Pacer {
    /// Starts at this time, without a gyro yet: the first tick is due a period later.
    pub const fn new(now_us: u64) -> Self {
        Self {
            last_edge_us: None,
            period: TICK_PERIOD_US * SMOOTHING,
            last_tick_us: now_us,
            deadline_us: now_us + PERIOD_US,
            missed: 0,
            spurious: 0,
        }
    }

    /// An edge came at this time. The time of the tick it starts, or `None` where it came too soon to be one.
    pub fn edge(&mut self, at_us: u64) -> Option<u64> {
        self.look_at_clock(at_us);
        if let Some(last_us) = self.last_edge_us {
            let interval = bounded(at_us.saturating_sub(last_us)).saturating_mul(SMOOTHING);
            if interval < self.least_interval() {
                self.spurious = self.spurious.saturating_add(1);
                return None;
            }
            if interval <= self.period * EDGE_MAX_PERCENT / 100 {
                const SLOWEST: u32 = TICK_PERIOD_US * SMOOTHING * (100 + CLOCK_ERROR_PERCENT) / 100;
                const FASTEST: u32 = TICK_PERIOD_US * SMOOTHING * (100 - CLOCK_ERROR_PERCENT) / 100;
                let mean = (self.period * (SMOOTHING - 1) + interval) / SMOOTHING;
                self.period = mean.clamp(FASTEST, SLOWEST);
            }
        }
        self.last_edge_us = Some(at_us);
        self.deadline_us = at_us.saturating_add(EDGE_TIMEOUT_US);
        // The timer may have been served just before an edge that came first.
        Some(self.tick(at_us.max(self.last_tick_us)))
    }

    /// The timer fired. The time of the tick without a sample, or `None` where an edge came in between.
    pub fn timer(&mut self, now_us: u64) -> Option<u64> {
        self.look_at_clock(now_us);
        // By division, not by counting: after a halt the gap may be of any length.
        let late_us = now_us.checked_sub(self.deadline_us)?;
        let phase_us = u64::from(bounded(late_us) % TICK_PERIOD_US);
        self.deadline_us = now_us.saturating_sub(phase_us).saturating_add(PERIOD_US);
        Some(self.tick(now_us.max(self.last_tick_us)))
    }

    /// The timer shall fire this long from now unless an edge comes first, µs: never later than after one and a half
    /// periods, whatever the clock says.
    pub fn delay_us(&self, now_us: u64) -> u64 {
        self.deadline_us.saturating_sub(now_us).min(EDGE_TIMEOUT_US)
    }

    /// An edge may be a tick's again so long from now, µs; one before that is noise, and a board does well not to listen to
    /// the line. Never longer than a period, whatever the clock says.
    pub fn deaf_us(&self, now_us: u64) -> u64 {
        let Some(last_us) = self.last_edge_us else { return 0 };
        let least_us = u64::from(self.least_interval().div_ceil(SMOOTHING));
        last_us.saturating_add(least_us).saturating_sub(now_us).min(PERIOD_US)
    }

    /// Counts noise that came, if any did, while the board did not listen.
    pub const fn note_noise(&mut self, noisy: bool) {
        self.spurious = self.spurious.saturating_add(noisy as u32);
    }

    /// Periods without a tick so far. A tick up to three quarters of a period late is late, not missed.
    pub const fn missed(&self) -> u32 {
        self.missed
    }

    /// Edges that came too soon; of those that a board did not listen to, one a period.
    pub const fn spurious(&self) -> u32 {
        self.spurious
    }

    /// From an edge to the next one at least, 1/[`SMOOTHING`] µs.
    const fn least_interval(&self) -> u32 {
        self.period * EDGE_MIN_PERCENT / 100
    }

    /// Begins anew where the clock has run backwards.
    fn look_at_clock(&mut self, now_us: u64) {
        if now_us.saturating_add(PERIOD_US) < self.last_tick_us {
            let (missed, spurious) = (self.missed, self.spurious);
            *self = Self { deadline_us: now_us, missed, spurious, ..Self::new(now_us) };
        }
    }

    fn tick(&mut self, now_us: u64) -> u64 {
        let interval_us = bounded(now_us.saturating_sub(self.last_tick_us));
        let periods = interval_us.saturating_add(TICK_PERIOD_US / 4) / TICK_PERIOD_US;
        self.missed = self.missed.saturating_add(periods.saturating_sub(1));
        self.last_tick_us = now_us;
        now_us
    }
}

/// A time in 32 bits, or what is left of it: 71 minutes.
fn bounded(time_us: u64) -> u32 {
    u32::try_from(time_us).unwrap_or(u32::MAX)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// Runs a timer beside the pacer until the given time and returns its ticks.
    fn run_timer(pacer: &mut Pacer, until_us: u64) -> Vec<u64> {
        let mut ticks = Vec::new();
        while pacer.deadline_us <= until_us {
            ticks.extend(pacer.timer(pacer.deadline_us));
        }
        ticks
    }

    extern crate std;
    use std::vec::Vec;

    #[test]
    fn without_a_gyro_the_timer_ticks_every_period() {
        let mut pacer = Pacer::new(100);
        assert_eq!(run_timer(&mut pacer, 5_200), [1_350, 2_600, 3_850, 5_100]);
        assert_eq!(pacer.missed(), 0);
    }

    #[test]
    fn a_late_edge_is_replaced_after_one_and_a_half_periods_and_then_every_period() {
        let mut pacer = Pacer::new(0);
        assert_eq!(pacer.edge(1_000), Some(1_000));
        assert_eq!(run_timer(&mut pacer, 6_000), [2_875, 4_125, 5_375]);
        assert_eq!(pacer.edge(6_100), Some(6_100));
        assert_eq!(pacer.deadline_us, 7_975);
        assert_eq!(pacer.missed(), 0);
    }

    #[test]
    fn a_timer_that_fires_beside_an_edge_is_no_tick() {
        let mut pacer = Pacer::new(0);
        pacer.edge(1_000);
        assert_eq!(pacer.timer(1_001), None);
        assert_eq!(pacer.timer(2_874), None);
        assert_eq!(pacer.timer(2_875), Some(2_875));
    }

    /// The edge came first, the timer was served first: time does not run backwards.
    #[test]
    fn an_edge_served_late_is_not_before_the_last_tick() {
        let mut pacer = Pacer::new(0);
        pacer.edge(1_000);
        assert_eq!(pacer.timer(2_876), Some(2_876));
        assert_eq!(pacer.edge(2_874), Some(2_876));
    }

    #[test]
    fn an_edge_too_soon_is_counted_and_moves_nothing() {
        let mut pacer = Pacer::new(0);
        pacer.edge(1_000);
        assert_eq!(pacer.edge(1_700), None);
        assert_eq!(pacer.edge(2_062), None);
        assert_eq!(pacer.deadline_us, 2_875);
        assert_eq!(pacer.edge(2_063), Some(2_063));
        assert_eq!(pacer.spurious(), 2);
    }

    #[test]
    fn an_edge_counts_again_when_the_line_is_opened() {
        let mut pacer = Pacer::new(0);
        assert_eq!(pacer.deaf_us(0), 0);
        pacer.edge(1_000);
        assert_eq!(pacer.deaf_us(1_100), 963);
        pacer.note_noise(true);
        pacer.note_noise(false);
        assert_eq!((pacer.deaf_us(2_063), pacer.deaf_us(3_000)), (0, 0));
        assert_eq!((pacer.edge(2_063), pacer.spurious()), (Some(2_063), 1));
    }

    #[test]
    fn a_clock_that_runs_backwards_is_passed_on_and_does_not_stop_the_ticks() {
        let mut pacer = Pacer::new(0);
        pacer.edge(100_000);
        assert_eq!(pacer.edge(50_000), Some(50_000));
        assert_eq!(pacer.edge(51_250), Some(51_250));
        pacer.edge(100_000);
        assert_eq!(pacer.delay_us(30_000), EDGE_TIMEOUT_US);
        assert_eq!(pacer.timer(30_000 + EDGE_TIMEOUT_US), Some(30_000 + EDGE_TIMEOUT_US));
        assert!(pacer.delay_us(30_000 + EDGE_TIMEOUT_US) <= PERIOD_US);
    }

    #[test]
    fn missed_ticks_are_counted_from_time() {
        let mut pacer = Pacer::new(0);
        pacer.edge(1_250);
        pacer.edge(3_750);
        assert_eq!(pacer.missed(), 1);
        // A halt of a second.
        assert_eq!(pacer.timer(1_003_750), Some(1_003_750));
        assert_eq!(pacer.missed(), 800);
        assert!(pacer.deadline_us > 1_003_750 && pacer.deadline_us <= 1_005_000);
    }

    proptest! {
        /// Whatever happens and in whatever order it is served: ticks never run backwards, there are never more than the
        /// edges and the timer allow, and the next deadline is ahead.
        #[test]
        fn time_runs_forwards(events in prop::collection::vec((any::<bool>(), 0_u64..4_000, 0_u64..30), 1..200)) {
            let mut pacer = Pacer::new(0);
            let (mut now, mut last) = (0, 0);
            for (is_edge, wait, age) in events {
                now += wait;
                let tick = if is_edge { pacer.edge(now - age.min(now)) } else { pacer.timer(now) };
                if let Some(tick) = tick {
                    prop_assert!(tick >= last && tick <= now);
                    last = tick;
                    prop_assert!(pacer.deadline_us > now);
                    prop_assert!(pacer.deadline_us <= now + EDGE_TIMEOUT_US);
                }
            }
        }

        /// A gyro whose clock is off by up to five percent, with jitter, needs no help of the timer.
        #[test]
        fn a_healthy_gyro_gives_every_tick(period in 1_188_u64..=1_312, jitter in prop::collection::vec(0_u64..50, 1..200)) {
            let mut pacer = Pacer::new(0);
            for (index, jitter) in (1_u64..).zip(jitter) {
                let at = index * period + jitter;
                prop_assert!(index == 1 || pacer.deadline_us > at);
                prop_assert_eq!(pacer.edge(at), Some(at));
            }
            prop_assert_eq!(pacer.missed() + pacer.spurious(), 0);
        }

        /// Who listens only as long as he is told to hears no edge that would be dropped, and each that would not.
        #[test]
        fn the_line_is_opened_when_edges_count(waits in prop::collection::vec(1_000_u64..2_000, 1..200)) {
            let (mut pacer, mut now) = (Pacer::new(0), 0);
            for wait in waits {
                now += wait;
                pacer.edge(now);
                let opens = pacer.deaf_us(now);
                prop_assert!(opens <= PERIOD_US);
                prop_assert_eq!(pacer.edge(now + opens - 1), None);
                now += opens;
                prop_assert_eq!(pacer.edge(now), Some(now));
            }
        }

        /// Noise in the first four fifths of a period is told from the gyro's own edges, whatever its clock.
        #[test]
        fn noise_between_the_edges_is_no_tick(
            period in 1_188_u64..=1_312,
            noise in prop::collection::vec((any::<bool>(), 0_u64..800), 1..200),
        ) {
            let mut pacer = Pacer::new(0);
            let mut spurious = 0;
            for (index, (noisy, part)) in (1_u64..).zip(noise) {
                let at = index * period;
                prop_assert_eq!(pacer.edge(at), Some(at));
                if noisy {
                    prop_assert_eq!(pacer.edge(at + period * part / 1000), None);
                    spurious += 1;
                }
            }
            prop_assert_eq!((pacer.missed(), pacer.spurious()), (0, spurious));
        }

        /// Noise just before a true edge takes its place once; the edge after it is a tick again.
        #[test]
        fn noise_before_an_edge_costs_that_edge_only(period in 1_188_u64..=1_312, part in 880_u64..999) {
            let mut pacer = Pacer::new(0);
            for index in 1..40 {
                prop_assert_eq!(pacer.edge(index * period), Some(index * period));
            }
            let noise = 39 * period + period * part / 1000;
            prop_assert_eq!(pacer.edge(noise), Some(noise));
            prop_assert_eq!(pacer.edge(40 * period), None);
            for index in 41..80 {
                prop_assert_eq!(pacer.edge(index * period), Some(index * period));
            }
            prop_assert_eq!((pacer.missed(), pacer.spurious()), (0, 1));
        }
    }
}

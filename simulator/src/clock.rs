//! Periodic instants of a clock that may run fast or slow.

/// Nanoseconds in a second.
pub(crate) const NS_PER_S: f64 = 1e9;

/// The instants `first + n × period`, rounded to nanoseconds of true time.
#[derive(Clone, Debug)]
pub(crate) struct Clock {
    first_ns: f64,
    period_ns: f64,
    /// Number of the next instant.
    next: u64,
}

impl Clock {
    /// A clock of `rate_hz`, whose first instant comes after `phase` of a period (above 0, at most 1).
    pub(crate) fn new(rate_hz: f64, phase: f64) -> Self {
        let period_ns = NS_PER_S / rate_hz;
        Self { first_ns: phase * period_ns, period_ns, next: 0 }
    }

    /// The time of instant `n`: no error accumulates, and a float holds a hundred days of nanoseconds exactly.
    fn at(&self, n: u64) -> u64 {
        libm::round(self.first_ns + n as f64 * self.period_ns) as u64
    }

    /// The next instant.
    pub(crate) fn next_ns(&self) -> u64 {
        self.at(self.next)
    }

    /// Moves on by one instant.
    pub(crate) fn tick(&mut self) {
        self.next += 1;
    }

    /// Moves on to the first instant that is not before a time.
    pub(crate) fn skip_to(&mut self, time_ns: u64) {
        let n = libm::floor((time_ns as f64 - self.first_ns) / self.period_ns) as u64;
        self.next = self.next.max(n);
        // The quotient is rounded down: one instant on, or two where it was rounded badly.
        while self.next_ns() < time_ns {
            self.next += 1;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn instants_do_not_drift() {
        let mut clock = Clock::new(300.0, 1.0);
        for _ in 0..3_000_000 {
            clock.tick();
        }
        // 3,000,001 periods of 1/300 s.
        assert_eq!(clock.next_ns(), 10_000_003_333_333);
    }

    #[test]
    fn skips_to_the_first_instant_not_before_a_time() {
        let mut clock = Clock::new(800.0, 1.0);
        for (time, next) in [(0, 1_250_000), (2_500_000, 2_500_000), (2_500_001, 3_750_000), (1, 3_750_000)] {
            clock.skip_to(time);
            assert_eq!(clock.next_ns(), next);
        }
    }
}

//! From the capture's clock to the host's.
//!
//! A pose is on its way for an unknown time of which only the excess over the shortest seen can be told. So the offset
//! between the clocks is the least of "arrived less captured" over the last seconds: a packet that was held up cannot make
//! the pose look younger or older than it is. Forgetting what is older follows clocks that drift apart.

/// The least offset is taken over one to two of these, s. At 50 ppm a clock drifts 0.5 ms in that time.
const WINDOW_S: f64 = 5.0;

/// Maps times of one clock to the other.
#[derive(Clone, Debug, Default)]
pub struct CaptureClock {
    /// Where the present window began, on the host's clock.
    began_s: Option<f64>,
    present_s: Option<f64>,
    before_s: Option<f64>,
    latency_s: f64,
}

impl CaptureClock {
    /// `latency_s` is the shortest time from the picture until the pose is here: exposure, computing, network. It cannot be
    /// learned from the stamps.
    pub fn new(latency_s: f64) -> Self {
        Self { latency_s, ..Self::default() }
    }

    /// When, on the host's clock, the cameras looked.
    pub fn captured_s(&mut self, t_s: f64, arrived_s: f64) -> f64 {
        let offset_s = arrived_s - t_s;
        if self.began_s.is_none_or(|began| arrived_s - began >= WINDOW_S) {
            self.began_s = Some(arrived_s);
            self.before_s = self.present_s.take();
        }
        let present_s = self.present_s.map_or(offset_s, |least| least.min(offset_s));
        self.present_s = Some(present_s);
        let least_s = self.before_s.map_or(present_s, |before| before.min(present_s));
        t_s + least_s - self.latency_s
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn jitter_does_not_reach_the_time_of_capture() {
        let mut clock = CaptureClock::new(0.004);
        for i in 0..4000u32 {
            let t = f64::from(i) * 0.005;
            // 0 to 20 ms late, now and then not at all.
            let late = f64::from(i * 7919 % 41) * 0.0005;
            let captured = clock.captured_s(t - 1e5, t + late);
            if i > 100 {
                assert!((captured - (t - 0.004)).abs() < 1e-6, "{i}: {captured} of {t}");
            }
        }
    }

    #[test]
    fn a_drifting_clock_is_followed() {
        for ppm in [-100.0, 100.0] {
            let mut clock = CaptureClock::new(0.0);
            for i in 0..40_000u32 {
                let now = f64::from(i) * 0.005;
                let captured = clock.captured_s(now * (1.0 + ppm * 1e-6), now);
                assert!((captured - now).abs() < 1.1e-3, "{ppm} ppm after {now} s: {captured}");
            }
        }
    }

    proptest! {
        #[test]
        fn a_pose_is_never_captured_after_it_arrived(late in proptest::collection::vec(0.0..0.2f64, 1..300)) {
            let mut clock = CaptureClock::new(0.0);
            for (i, late) in late.iter().enumerate() {
                let t = i as f64 * 0.25;
                let captured = clock.captured_s(t, t + late);
                prop_assert!(captured <= t + late + 1e-9);
                prop_assert!(captured >= t - 1e-9);
            }
        }
    }
}

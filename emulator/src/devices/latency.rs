//! How long after a gyro sample the motors have their commands.

/// Times from a data-ready edge to the end of the last bit of the motor frames that follow it.
#[derive(Clone, Debug, Default)]
pub struct Latency {
    /// The edge that waits for frames, and when each motor's came (ns).
    open: Option<(u64, [Option<u64>; 4])>,
    samples_ns: Vec<u32>,
    missed: u32,
}

/// Samples kept: an hour and a quarter at 800 Hz.
const MOST_SAMPLES: usize = 3_600_000;

/// A summary of [`Latency`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LatencySummary {
    /// Edges that all four motors followed.
    pub count: usize,
    /// Edges that another edge overtook.
    pub missed: u32,
    /// Shortest (ns).
    pub min_ns: u32,
    /// Half are shorter (ns).
    pub median_ns: u32,
    /// 99.9 % are shorter (ns).
    pub p999_ns: u32,
    /// Longest (ns).
    pub max_ns: u32,
    /// 99.9 % lie closer to the median than this (ns).
    pub jitter_p999_ns: u32,
    /// Farthest from the median (ns).
    pub jitter_max_ns: u32,
}

impl Latency {
    /// The gyro says that data are ready.
    pub fn edge(&mut self, ns: u64) {
        if self.open.replace((ns, [None; 4])).is_some() {
            self.missed += 1;
        }
    }

    /// The last bit of a frame for `motor` (0..=3) ended; the frame began at `start_ns`.
    pub fn frame(&mut self, motor: usize, start_ns: u64, end_ns: u64) {
        let Some((edge_ns, ends)) = &mut self.open else { return };
        if start_ns < *edge_ns {
            return;
        }
        let Some(end) = ends.get_mut(motor) else { return };
        end.get_or_insert(end_ns);
        if let [Some(a), Some(b), Some(c), Some(d)] = *ends {
            let latency = a.max(b).max(c).max(d) - *edge_ns;
            if self.samples_ns.len() < MOST_SAMPLES {
                self.samples_ns.push(u32::try_from(latency).unwrap_or(u32::MAX));
            }
            self.open = None;
        }
    }

    /// Forgets everything measured so far.
    pub fn clear(&mut self) {
        *self = Self { samples_ns: std::mem::take(&mut self.samples_ns), ..Self::default() };
        self.samples_ns.clear();
    }

    /// Every latency so far, in order of time (ns).
    pub fn samples_ns(&self) -> &[u32] {
        &self.samples_ns
    }

    /// The summary; none before the first complete pair.
    pub fn summary(&self) -> Option<LatencySummary> {
        let mut sorted = self.samples_ns.clone();
        sorted.sort_unstable();
        let (&min_ns, &max_ns) = (sorted.first()?, sorted.last()?);
        let median_ns = quantile(&sorted, 0.5);
        let mut distance: Vec<u32> = sorted.iter().map(|sample| sample.abs_diff(median_ns)).collect();
        distance.sort_unstable();
        Some(LatencySummary {
            count: sorted.len(),
            missed: self.missed,
            min_ns,
            median_ns,
            p999_ns: quantile(&sorted, 0.999),
            max_ns,
            jitter_p999_ns: quantile(&distance, 0.999),
            jitter_max_ns: distance.last().copied().unwrap_or(0),
        })
    }
}

/// The smallest value that at least the part `share` does not exceed.
fn quantile(sorted: &[u32], share: f64) -> u32 {
    let rank = (share * sorted.len() as f64).ceil() as usize;
    sorted.get(rank.saturating_sub(1).min(sorted.len().saturating_sub(1))).copied().unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::Latency;

    #[test]
    fn the_last_motor_counts_and_overtaken_edges_are_missed() {
        let mut latency = Latency::default();
        latency.edge(1_000);
        latency.frame(0, 900, 1_500);
        for motor in 0..4 {
            latency.frame(motor, 2_000, 3_000 + motor as u64);
        }
        latency.edge(10_000);
        latency.edge(20_000);
        for motor in 0..4 {
            latency.frame(motor, 20_500, 23_003);
        }
        let summary = latency.summary().unwrap();
        assert_eq!((summary.count, summary.missed), (2, 1));
        assert_eq!((summary.min_ns, summary.max_ns), (2_003, 3_003));
    }
}

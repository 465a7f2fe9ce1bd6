//! Fastest maneuvers along a line of requests, refined to where their structure changes.

use crate::parallel;
use crate::solver::sweep::Structure;
use crate::solver::{Extremal, Request, SolveError, solve, solve_from};

/// Durations that differ by less than this, relative, are the same.
const SAME: f64 = 1e-10;

/// Whether a maneuver is to be preferred to another between the same two states: it is faster or, equally fast, has more
/// segments. Just after a piece has appeared it gains less than can be told, and the maneuver without it is still accepted.
pub(crate) fn beats(one: &Extremal, other: &Extremal) -> bool {
    let gain = 1.0 - one.duration_s() / other.duration_s();
    gain > SAME || (gain > -SAME && one.segments.len() > other.segments.len())
}

/// Structures that last no longer than this many tolerances are rounding.
const ROUNDING: f64 = 3.0;

/// One maneuver of a family.
#[derive(Clone, Debug)]
pub(crate) struct Sample {
    /// The family's parameter.
    pub(crate) at: f64,
    pub(crate) extremal: Extremal,
    pub(crate) structure: Structure,
}

/// A family of requests with one parameter.
pub(crate) struct Family<R> {
    /// The request at a parameter.
    pub(crate) request: R,
    /// How a maneuver's structure is named.
    pub(crate) name: fn(&Extremal) -> Structure,
}

impl<R: Fn(f64) -> Request + Sync> Family<R> {
    pub(crate) fn sample(&self, at: f64, extremal: Extremal) -> Sample {
        Sample { at, structure: (self.name)(&extremal), extremal }
    }

    /// The fastest of the branches of two neighbours. They are good enough only between maneuvers that are known to be
    /// the fastest.
    fn between(&self, a: &Sample, b: &Sample, at: f64) -> Result<Sample, SolveError> {
        let request = (self.request)(at);
        let one = solve_from(&a.extremal, &request)?.extremal;
        let other = solve_from(&b.extremal, &request)?.extremal;
        let best = if beats(&other, &one) { other } else { one };
        Ok(self.sample(at, best))
    }

    /// All changes of structure between two samples, each as the samples on its two sides, at most `tolerance` apart or a
    /// few where the structure changes in two places at once.
    pub(crate) fn changes(
        &self,
        a: &Sample,
        b: &Sample,
        tolerance: f64,
    ) -> Result<Vec<(Sample, Sample)>, SolveError> {
        let mut found = Vec::new();
        self.bisect(a, b, tolerance, &mut found)?;
        let mut lasting: Vec<(Sample, Sample)> = Vec::new();
        for (before, after) in found {
            match lasting.last_mut() {
                // Where two parts of a structure change at once, rounding tears them apart.
                Some(last) if before.at - last.1.at <= ROUNDING * tolerance => last.1 = after,
                _ => lasting.push((before, after)),
            }
            lasting.pop_if(|last| last.0.structure == last.1.structure);
        }
        Ok(lasting)
    }

    fn bisect(
        &self,
        a: &Sample,
        b: &Sample,
        tolerance: f64,
        found: &mut Vec<(Sample, Sample)>,
    ) -> Result<(), SolveError> {
        if a.structure == b.structure {
            return Ok(());
        }
        let middle = 0.5 * (a.at + b.at);
        if (b.at - a.at).abs() <= tolerance || middle == a.at || middle == b.at {
            found.push((a.clone(), b.clone()));
            return Ok(());
        }
        let m = self.between(a, b, middle)?;
        self.bisect(a, &m, tolerance, found)?;
        self.bisect(&m, b, tolerance, found)
    }

    /// The fastest maneuvers at the parameters given, which rise, and on both sides of every change of structure.
    pub(crate) fn sweep(&self, parameters: &[f64], tolerance: f64) -> Result<Vec<Sample>, SolveError> {
        let solved = parallel::map(
            parameters,
            |&at| solve(&(self.request)(at)).map(|solution| self.sample(at, solution.extremal)),
            |_| {},
        );
        let mut samples = solved.into_iter().collect::<Result<Vec<_>, _>>()?;
        // A cold look may miss the fastest maneuver; a neighbour that found it shows the way.
        for i in 1..samples.len() {
            self.learn(&mut samples, i, i - 1);
        }
        for i in (1..samples.len()).rev() {
            self.learn(&mut samples, i - 1, i);
        }
        let refine = |pair: &(Sample, Sample)| self.changes(&pair.0, &pair.1, tolerance);
        let pairs: Vec<(Sample, Sample)> =
            samples.iter().cloned().zip(samples.iter().skip(1).cloned()).collect();
        let mut refined = Vec::new();
        for (found, sample) in parallel::map(&pairs, refine, |_| {}).into_iter().zip(&samples) {
            refined.push(sample.clone());
            refined.extend(found?.into_iter().flat_map(|(a, b)| [a, b]));
        }
        refined.extend(samples.pop());
        refined.dedup_by(|b, a| a.at == b.at);
        Ok(refined)
    }

    fn learn(&self, samples: &mut [Sample], pupil: usize, teacher: usize) {
        let (p, t) = (&samples[pupil], &samples[teacher]);
        if p.structure == t.structure {
            return;
        }
        if let Ok(other) = solve_from(&t.extremal, &(self.request)(p.at))
            && beats(&other.extremal, &p.extremal)
        {
            samples[pupil] = self.sample(p.at, other.extremal);
        }
    }
}

/// Where the structure changes along refined samples: between the two on its sides.
pub(crate) fn changes_of(samples: &[Sample]) -> Vec<(f64, &Sample, &Sample)> {
    samples
        .windows(2)
        .filter_map(|pair| match pair {
            [a, b] if a.structure != b.structure => Some((0.5 * (a.at + b.at), a, b)),
            _ => None,
        })
        .collect()
}

/// Multiples of a step, from the first to the last.
pub(crate) fn steps(first: u32, last: u32, per_unit: f64) -> Vec<f64> {
    (first..=last).map(|i| f64::from(i) / per_unit).collect()
}

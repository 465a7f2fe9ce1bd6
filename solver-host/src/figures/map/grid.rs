//! Fastest maneuvers on a grid of displacements, and where between its points their structure changes.

use crate::figures::line::{Family, Sample, beats};
use crate::parallel;
use crate::solver::sweep::Structure;
use crate::solver::{Extremal, Request, SolveError, solve, solve_from};

/// The first column stands this far from x = 0, m: at 0 every maneuver ties with its mirror image.
pub(super) const OFF_AXIS_M: f64 = 1e-4;
/// Changes of structure are found to this, m.
pub(super) const TOLERANCE_M: f64 = 1e-4;
/// A point of the plane, m.
pub(super) type Place = (f64, f64);

/// A change of structure on the way from one grid point to the next.
#[derive(Clone, Copy, Debug)]
pub(super) struct Crossing {
    pub(super) at: Place,
    /// Structures before and after, as indices.
    pub(super) from: usize,
    pub(super) to: usize,
}

/// A grid point.
#[derive(Clone, Debug)]
pub(super) struct Node {
    pub(super) extremal: Extremal,
    pub(super) structure: usize,
}

/// The grid.
pub(super) struct Grid {
    pub(super) xs: Vec<f64>,
    pub(super) zs: Vec<f64>,
    /// Row by row, from the lowest z.
    pub(super) nodes: Vec<Node>,
    /// All structures seen.
    pub(super) structures: Vec<Structure>,
    /// Changes to the right of each node, and above it; from the node outwards.
    pub(super) right: Vec<Vec<Crossing>>,
    pub(super) above: Vec<Vec<Crossing>>,
}

fn request((x_m, z_m): Place) -> Request {
    Request::rest_to_rest(x_m, z_m)
}

/// Even coordinates from 0 to the end; `first` stands for 0.
fn coordinates(first: f64, end: f64, intervals: usize) -> Vec<f64> {
    let at = |i: usize| if i == 0 { first } else { end * i as f64 / intervals as f64 };
    (0..=intervals).map(at).collect()
}

impl Grid {
    /// The quadrant from the origin to (x, z), with so many intervals along each.
    pub(super) fn new(end: Place, intervals: (usize, usize)) -> Result<Self, SolveError> {
        let xs = coordinates(OFF_AXIS_M, end.0, intervals.0);
        let zs = coordinates(0.0, end.1, intervals.1);
        let places: Vec<Place> = zs.iter().flat_map(|&z| xs.iter().map(move |&x| (x, z))).collect();
        let solved = parallel::map(&places, |&place| Ok(solve(&request(place))?.extremal), |_| {});
        let mut extremals = solved.into_iter().collect::<Result<Vec<Extremal>, SolveError>>()?;
        learn(&mut extremals, &places, xs.len());

        let mut structures = Vec::new();
        let mut index = |structure: &Structure| {
            structures.iter().position(|s| s == structure).unwrap_or_else(|| {
                structures.push(structure.clone());
                structures.len() - 1
            })
        };
        let samples: Vec<Sample> = extremals
            .into_iter()
            .map(|extremal| Sample { at: 0.0, structure: extremal.structure(), extremal })
            .collect();
        let columns = xs.len();
        let ways: Vec<(usize, usize)> = (0..samples.len())
            .flat_map(|i| {
                let right = ((i + 1) % columns != 0).then_some((i, i + 1));
                let above = (i + columns < samples.len()).then_some((i, i + columns));
                right.into_iter().chain(above)
            })
            .collect();
        let found = parallel::map(
            &ways,
            |&(a, b)| crossings((&samples[a], &samples[b]), (places[a], places[b])),
            |_| {},
        );
        let nodes: Vec<Node> = samples
            .iter()
            .map(|s| Node { structure: index(&s.structure), extremal: s.extremal.clone() })
            .collect();
        let (mut right, mut above) = (vec![Vec::new(); nodes.len()], vec![Vec::new(); nodes.len()]);
        for ((a, b), found) in ways.into_iter().zip(found) {
            let side = if b == a + 1 { &mut right } else { &mut above };
            side[a] = found?
                .into_iter()
                .map(|(at, from, to)| Crossing { at, from: index(&from), to: index(&to) })
                .collect();
        }
        Ok(Self { xs, zs, nodes, structures, right, above })
    }

    /// T at a node, s.
    pub(super) fn duration_s(&self, node: usize) -> f64 {
        self.nodes[node].extremal.duration_s()
    }

    pub(super) fn place(&self, node: usize) -> Place {
        (self.xs[node % self.xs.len()], self.zs[node / self.xs.len()])
    }
}

/// A cold look may miss the fastest maneuver; a neighbour that found it shows the way, until nothing changes.
fn learn(extremals: &mut [Extremal], places: &[Place], columns: usize) {
    const ROUNDS: usize = 8;
    for _ in 0..ROUNDS {
        let look = |&i: &usize| {
            let here = &extremals[i];
            let neighbours = [
                (i % columns != 0).then(|| i.wrapping_sub(1)),
                ((i + 1) % columns != 0).then_some(i + 1),
                i.checked_sub(columns),
                (i + columns < extremals.len()).then_some(i + columns),
            ];
            let better = neighbours
                .into_iter()
                .flatten()
                .filter(|&n| extremals[n].structure() != here.structure())
                .filter_map(|n| solve_from(&extremals[n], &request(places[i])).ok())
                .map(|solution| solution.extremal)
                .reduce(|a, b| if beats(&b, &a) { b } else { a })?;
            beats(&better, here).then_some((i, better))
        };
        let all: Vec<usize> = (0..extremals.len()).collect();
        let improved: Vec<_> = parallel::map(&all, look, |_| {}).into_iter().flatten().collect();
        if improved.is_empty() {
            return;
        }
        for (i, better) in improved {
            extremals[i] = better;
        }
    }
}

/// Changes on the straight way between two places.
fn crossings(
    (a, b): (&Sample, &Sample),
    (from, to): (Place, Place),
) -> Result<Vec<(Place, Structure, Structure)>, SolveError> {
    let length_m = (to.0 - from.0).hypot(to.1 - from.1);
    let at = |part: f64| (from.0 + (to.0 - from.0) * part, from.1 + (to.1 - from.1) * part);
    let family = Family { request: |part: f64| request(at(part)), name: Extremal::structure };
    let end = Sample { at: 1.0, ..b.clone() };
    let found = family.changes(a, &end, TOLERANCE_M / length_m)?;
    Ok(found
        .into_iter()
        .map(|(before, after)| (at(0.5 * (before.at + after.at)), before.structure, after.structure))
        .collect())
}

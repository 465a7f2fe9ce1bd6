//! From a grid with changes of structure on its edges to regions with sharp outlines.
//!
//! Within each cell the changes on its four edges are joined by straight lines: two and two where that can be done without
//! crossing, the shortest way; else, where three structures meet, all in one point. Lines have their ends exactly where the
//! structure changes and are as long as a cell, so they follow curves closely.

use std::collections::{BTreeMap, BTreeSet};

use super::grid::{Crossing, Grid, Place};

/// Points of the plane, by number: so that outlines of neighbours meet exactly.
#[derive(Default)]
struct Points(Vec<Place>);

impl Points {
    fn add(&mut self, place: Place) -> usize {
        self.0.push(place);
        self.0.len() - 1
    }
}

/// What the grid is divided into.
pub(super) struct Division {
    /// Closed outlines of each structure's region, holes among them.
    pub(super) regions: Vec<Vec<Vec<Place>>>,
    /// Lines between regions: the structures on both sides, and the line.
    pub(super) borders: Vec<(usize, usize, Vec<Place>)>,
}

/// A part of a cell's rim with one structure on it, from one change to the next.
struct Arc {
    structure: usize,
    points: Vec<usize>,
}

/// The regions of all structures.
pub(super) fn divide(grid: &Grid) -> Division {
    let columns = grid.xs.len();
    let mut points = Points((0..grid.nodes.len()).map(|n| grid.place(n)).collect());
    let mut number = |side: &[Vec<Crossing>]| -> Vec<Vec<(usize, usize, usize)>> {
        let mut numbered = |c: &Crossing| (points.add(c.at), c.from, c.to);
        side.iter().map(|crossings| crossings.iter().map(&mut numbered).collect()).collect()
    };
    let (right, above) = (number(&grid.right), number(&grid.above));
    let backwards = |crossings: &[(usize, usize, usize)]| -> Vec<(usize, usize, usize)> {
        crossings.iter().rev().map(|&(point, from, to)| (point, to, from)).collect()
    };

    let mut edges: BTreeMap<(usize, usize), usize> = BTreeMap::new();
    for node in 0..grid.nodes.len() {
        if (node + 1) % columns == 0 || node + columns >= grid.nodes.len() {
            continue;
        }
        let corners = [node, node + 1, node + columns + 1, node + columns];
        let sides = [
            right[node].clone(),
            above[node + 1].clone(),
            backwards(&right[node + columns]),
            backwards(&above[node]),
        ];
        for (structure, outline) in cell(&mut points, corners, &sides, |n| grid.nodes[n].structure) {
            for (i, &from) in outline.iter().enumerate() {
                let to = outline[(i + 1) % outline.len()];
                // What two pieces of one structure share is no outline.
                if edges.get(&(to, from)) == Some(&structure) {
                    edges.remove(&(to, from));
                } else {
                    edges.insert((from, to), structure);
                }
            }
        }
    }
    let regions = (0..grid.structures.len())
        .map(|structure| {
            let own = edges.iter().filter(|(_, s)| **s == structure).map(|(edge, _)| *edge);
            chains(own.collect()).into_iter().map(|chain| places(&points, &chain)).collect()
        })
        .collect();
    let mut between: BTreeMap<(usize, usize), Vec<(usize, usize)>> = BTreeMap::new();
    for (&(from, to), &here) in &edges {
        if let Some(&there) = edges.get(&(to, from))
            && here < there
        {
            between.entry((here, there)).or_default().push((from, to));
        }
    }
    let borders = between
        .into_iter()
        .flat_map(|((a, b), edges)| chains(edges).into_iter().map(move |chain| (a, b, chain)))
        .map(|(a, b, chain)| (a, b, places(&points, &chain)))
        .collect();
    Division { regions, borders }
}

fn places(points: &Points, chain: &[usize]) -> Vec<Place> {
    chain.iter().map(|&i| points.0[i]).collect()
}

/// The pieces of one cell, each with its structure. Corners and sides run around the cell.
fn cell(
    points: &mut Points,
    corners: [usize; 4],
    sides: &[Vec<(usize, usize, usize)>; 4],
    structure_at: impl Fn(usize) -> usize,
) -> Vec<(usize, Vec<usize>)> {
    let first = structure_at(corners[0]);
    let mut arcs = vec![Arc { structure: first, points: Vec::new() }];
    let mut changes = Vec::new();
    for (corner, side) in corners.into_iter().zip(sides) {
        if let Some(arc) = arcs.last_mut() {
            arc.points.push(corner);
        }
        for &(point, from, to) in side {
            if let Some(arc) = arcs.last_mut() {
                arc.points.push(point);
            }
            changes.push((point, from.min(to), from.max(to)));
            arcs.push(Arc { structure: to, points: vec![point] });
        }
    }
    // The last arc goes on as the first.
    if changes.is_empty() {
        return vec![(first, corners.to_vec())];
    }
    if let Some(last) = arcs.pop() {
        let head = std::mem::take(&mut arcs[0].points);
        arcs[0].points = last.points.into_iter().chain(head).collect();
    }
    // Arc i now ends at change i and begins at the one before.
    match pairing(points, &changes) {
        Some(partner) => joined(&arcs, &partner),
        None => {
            let count = changes.len() as f64;
            let sum = changes.iter().map(|c| points.0[c.0]).fold((0.0, 0.0), |s, p| (s.0 + p.0, s.1 + p.1));
            let centre = points.add((sum.0 / count, sum.1 / count));
            arcs.into_iter()
                .map(|arc| (arc.structure, arc.points.into_iter().chain([centre]).collect()))
                .collect()
        }
    }
}

/// Pieces bounded by arcs and by the lines that join each change with its partner.
fn joined(arcs: &[Arc], partner: &[usize]) -> Vec<(usize, Vec<usize>)> {
    let mut left: BTreeSet<usize> = (0..arcs.len()).collect();
    let mut pieces = Vec::new();
    while let Some(start) = left.pop_first() {
        let mut outline = arcs[start].points.clone();
        let mut arc = (partner[start] + 1) % arcs.len();
        while arc != start && left.remove(&arc) {
            outline.extend(&arcs[arc].points);
            arc = (partner[arc] + 1) % arcs.len();
        }
        pieces.push((arcs[start].structure, outline));
    }
    pieces
}

/// What a line along the cell's own edge costs, m: it would cut off nothing, and hide a stripe through the cell.
const ALONG_THE_RIM: f64 = 1e3;

/// The shortest way to join changes between the same two structures in pairs, without crossing. `None` where there is no
/// such way.
fn pairing(points: &Points, changes: &[(usize, usize, usize)]) -> Option<Vec<usize>> {
    /// More changes on one cell than this are joined in one point.
    const MOST: usize = 8;
    if changes.len() > MOST {
        return None;
    }
    let indices: Vec<usize> = (0..changes.len()).collect();
    let (_, pairs) = shortest(points, changes, &indices)?;
    let mut partner = vec![0; changes.len()];
    for (a, b) in pairs {
        (partner[a], partner[b]) = (b, a);
    }
    Some(partner)
}

type Pairs = Vec<(usize, usize)>;

fn shortest(points: &Points, changes: &[(usize, usize, usize)], open: &[usize]) -> Option<(f64, Pairs)> {
    let Some((&a, rest)) = open.split_first() else { return Some((0.0, Vec::new())) };
    let mut best: Option<(f64, Pairs)> = None;
    // A partner with an even number of others in between leaves both sides joinable.
    for (position, &b) in rest.iter().enumerate().step_by(2) {
        let ((p, a0, a1), (q, b0, b1)) = (changes[a], changes[b]);
        if (a0, a1) != (b0, b1) {
            continue;
        }
        let (p, q) = (points.0[p], points.0[q]);
        let inside = shortest(points, changes, &rest[..position]);
        let outside = shortest(points, changes, &rest[position + 1..]);
        if let (Some(inside), Some(outside)) = (inside, outside) {
            let rim = if p.0 == q.0 || p.1 == q.1 { ALONG_THE_RIM } else { 0.0 };
            let length = (p.0 - q.0).hypot(p.1 - q.1) + rim + inside.0 + outside.0;
            if best.as_ref().is_none_or(|(least, _)| length < *least) {
                best = Some((length, [vec![(a, b)], inside.1, outside.1].concat()));
            }
        }
    }
    best
}

/// Directed edges joined to chains, as long as they go; closed ones end where they begin.
pub(super) fn chains(edges: Vec<(usize, usize)>) -> Vec<Vec<usize>> {
    let mut next: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
    let mut arrivals: BTreeMap<usize, usize> = BTreeMap::new();
    for (from, to) in edges {
        next.entry(from).or_default().push(to);
        *arrivals.entry(to).or_default() += 1;
    }
    let mut chains = Vec::new();
    let walk = |next: &mut BTreeMap<usize, Vec<usize>>, start: usize| {
        let mut chain = vec![start];
        let mut here = start;
        while let Some(to) = next.get_mut(&here).and_then(Vec::pop) {
            chain.push(to);
            here = to;
            if here == start {
                break;
            }
        }
        chain
    };
    // First those that begin somewhere, then loops.
    let open: Vec<usize> = next
        .iter()
        .flat_map(|(from, to)| {
            let surplus = to.len().saturating_sub(arrivals.get(from).copied().unwrap_or(0));
            std::iter::repeat_n(*from, surplus)
        })
        .collect();
    for start in open {
        chains.push(walk(&mut next, start));
    }
    while let Some(start) = next.iter().find(|(_, to)| !to.is_empty()).map(|(from, _)| *from) {
        chains.push(walk(&mut next, start));
    }
    chains
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn chains_use_every_edge_once() {
        let edges = vec![(1, 2), (2, 3), (7, 8), (8, 9), (9, 7), (3, 4)];
        assert_eq!(chains(edges), [vec![1, 2, 3, 4], vec![7, 8, 9, 7]]);
    }

    fn unit_square() -> Points {
        Points(vec![(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)])
    }

    fn area(points: &Points, outline: &[usize]) -> f64 {
        let cross = |i: usize| {
            let (a, b) = (points.0[outline[i]], points.0[outline[(i + 1) % outline.len()]]);
            a.0 * b.1 - b.0 * a.1
        };
        0.5 * (0..outline.len()).map(cross).sum::<f64>()
    }

    #[test]
    fn a_cell_is_divided_without_gaps_along_the_shortest_lines() {
        // Structure 1 in a diagonal stripe, 0 in two corners.
        let mut points = unit_square();
        let at = [(0.4, 0.0), (0.6, 0.0), (1.0, 0.4), (1.0, 0.6)].map(|p| points.add(p));
        let sides = [vec![(at[0], 1, 0), (at[1], 0, 1)], vec![(at[2], 1, 0), (at[3], 0, 1)], vec![], vec![]];
        let pieces = cell(&mut points, [0, 1, 2, 3], &sides, |_| 1);
        let of = |structure: usize| -> f64 {
            pieces.iter().filter(|p| p.0 == structure).map(|p| area(&points, &p.1)).sum()
        };
        assert_eq!(pieces.len(), 3);
        assert!((of(0) - (0.5 * 0.36 - 0.5 * 0.16)).abs() < 1e-12, "{}", of(0));
        assert!((of(0) + of(1) - 1.0).abs() < 1e-12);
    }

    #[test]
    fn three_structures_meet_in_one_point() {
        let mut points = unit_square();
        let at = [(0.5, 0.0), (1.0, 0.5), (0.0, 0.5)].map(|p| points.add(p));
        let sides = [vec![(at[0], 0, 1)], vec![(at[1], 1, 2)], vec![], vec![(at[2], 2, 0)]];
        let pieces = cell(&mut points, [0, 1, 2, 3], &sides, |n| [0, 1, 2, 2][n]);
        assert_eq!(pieces.iter().map(|p| p.0).collect::<Vec<_>>(), [0, 1, 2]);
        let whole: f64 = pieces.iter().map(|p| area(&points, &p.1)).sum();
        assert!((whole - 1.0).abs() < 1e-12);
        assert!(pieces.iter().all(|p| p.1.contains(&(points.0.len() - 1))));
    }
}

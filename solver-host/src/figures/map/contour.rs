//! Lines of constant T through a grid, by linear interpolation along its edges.

use std::collections::BTreeMap;

use super::grid::{Grid, Place};
use super::outline::chains;

/// The lines where T has this value, s.
pub(super) fn lines(grid: &Grid, level_s: f64) -> Vec<Vec<Place>> {
    let columns = grid.xs.len();
    let mut points: Vec<Place> = Vec::new();
    let mut on_edge: BTreeMap<(usize, usize), usize> = BTreeMap::new();
    let mut crossing = |a: usize, b: usize| -> Option<usize> {
        let (ta, tb) = (grid.duration_s(a), grid.duration_s(b));
        if (ta < level_s) == (tb < level_s) {
            return None;
        }
        let edge = (a.min(b), a.max(b));
        Some(*on_edge.entry(edge).or_insert_with(|| {
            let (p, q) = (grid.place(a), grid.place(b));
            let part = (level_s - ta) / (tb - ta);
            points.push((p.0 + (q.0 - p.0) * part, p.1 + (q.1 - p.1) * part));
            points.len() - 1
        }))
    };
    let mut pieces = Vec::new();
    for node in 0..grid.nodes.len() {
        if (node + 1) % columns == 0 || node + columns >= grid.nodes.len() {
            continue;
        }
        let corners = [node, node + 1, node + columns + 1, node + columns];
        // T rises away from the origin, so a line that enters a cell leaves it on one other edge.
        let low = corners.map(|c| grid.duration_s(c) < level_s);
        let mut ends = [None; 2];
        for i in 0..4 {
            let (a, b) = (i, (i + 1) % 4);
            if let Some(point) = crossing(corners[a], corners[b]) {
                // Below the level on the left of the direction of travel.
                ends[usize::from(low[b])] = Some(point);
            }
        }
        if let [Some(from), Some(to)] = ends {
            pieces.push((from, to));
        }
    }
    chains(pieces).into_iter().map(|chain| chain.into_iter().map(|i| points[i]).collect()).collect()
}

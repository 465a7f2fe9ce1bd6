//! What a search keeps: the best maneuver of each winding, and its mirror image where the problem is its own.

use core::f64::consts::TAU;

use super::super::structure::Candidate;
use super::{Found, Search, TIE};

impl Search<'_> {
    /// Keeps the best of each winding; of two that are equally fast the simpler one.
    pub(super) fn add(&mut self, candidate: Candidate, turns: i32, duration: f64) {
        if !(duration.is_finite() && duration > 0.0) {
            return;
        }
        let as_good = |f: &Found| {
            let pieces = f.candidate.pieces.len();
            let limit = if candidate.pieces.len() < pieces { 1.0 + TIE } else { 1.0 - TIE };
            f.turns == turns && duration >= f.duration * limit
        };
        if self.found.iter().any(as_good) {
            return;
        }
        if !(self.verified)(&candidate, turns) {
            // As good as lost: somewhere near there may be one that passes.
            self.refused = self.refused.min(duration);
            let _ = self.lost.push((turns, duration));
            return;
        }
        let found = Found { candidate, turns, duration };
        if let Some(same) = self.found.iter_mut().find(|f| f.turns == turns) {
            *same = found;
        } else {
            // A full list means twelve windings: the others cannot win any more.
            let _ = self.found.push(found);
        }
    }

    /// Where the problem is its own mirror image, so are its solutions.
    pub(super) fn add_mirror_images(&mut self) {
        let Some(sum) = self.problem.mirror_sum() else { return };
        for index in 0..self.found.len() {
            let mut image = self.found[index].clone();
            image.candidate.mirror();
            image.turns = sum - image.turns;
            if image.turns == self.found[index].turns {
                // Of two mirror images with the same winding, the one that turns towards +θ first.
                if self.found[index].candidate.pieces.first().is_some_and(|p| p.sign() < 0.0) {
                    self.found[index] = image;
                }
            } else if self.turns.is_none_or(|k| k == image.turns) {
                self.add(image.candidate, image.turns, image.duration);
            }
        }
    }

    /// Fastest first; of ties the smaller net turn, then the positive one.
    pub(super) fn sort(&mut self) {
        let base = self.problem.turn();
        let net = |f: &Found| base + f64::from(f.turns) * TAU;
        self.found.sort_unstable_by(|a, b| {
            if (a.duration - b.duration).abs() > TIE * a.duration.max(b.duration) {
                return a.duration.total_cmp(&b.duration);
            }
            let (x, y) = (net(a), net(b));
            if (x.abs() - y.abs()).abs() > 1e-9 { x.abs().total_cmp(&y.abs()) } else { y.total_cmp(&x) }
        });
    }
}

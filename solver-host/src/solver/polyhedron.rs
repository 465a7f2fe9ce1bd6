//! The point nearest to zero of a polyhedron in the space of c, by the dual active-set method of Goldfarb and Idnani (1983):
//! the laws of the minimum principle along a given trajectory are linear in c.

use super::dense::gauss;

/// offset + row·c ≥ 0 with some room, or = 0.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Law {
    pub(crate) row: [f64; 4],
    pub(crate) offset: f64,
    pub(crate) equal: bool,
    /// The room it may be asked to keep, relative.
    pub(crate) room: f64,
}

/// A law as a half space with a normal of length one: normal·c ≥ bound.
#[derive(Clone, Copy)]
struct Half {
    normal: [f64; 4],
    bound: f64,
    equal: bool,
    multiplier: f64,
}

/// Violations up to this, relative to a normal of length one, are rounding.
const ROUNDING: f64 = 1e-13;
/// What is left of a normal outside the span of the active ones, below which it lies in it.
const DEPENDENT: f64 = 1e-18;
/// Changes of the active set.
const CHANGES: usize = 200;

/// The least c that keeps all laws, with `room` times the room of each. `None` where there is none.
pub(crate) fn least_costate(laws: &[Law], room: f64) -> Option<[f64; 4]> {
    let mut c = [0.0; 4];
    let mut active: heapless::Vec<Half, 4> = heapless::Vec::new();
    for _ in 0..CHANGES {
        // Equations first, then the worst inequality.
        let Some(mut new) = laws.iter().filter_map(|law| half(law, room, &c)).min_by(|a, b| {
            b.equal
                .cmp(&a.equal)
                .then((dot(&a.normal, &c) - a.bound).total_cmp(&(dot(&b.normal, &c) - b.bound)))
        }) else {
            return Some(c);
        };
        add(&mut c, &mut active, &mut new)?;
    }
    None
}

/// The violated half space of a law; of an equation the side that is violated.
fn half(law: &Law, room: f64, c: &[f64; 4]) -> Option<Half> {
    let norm = libm::sqrt(dot(&law.row, &law.row));
    if norm == 0.0 {
        return None;
    }
    let sign = if law.equal && dot(&law.row, c) + law.offset > 0.0 { -1.0 } else { 1.0 };
    let normal = law.row.map(|r| sign * r / norm);
    let keep = if law.equal { 0.0 } else { room * law.room };
    let bound = -sign * law.offset / norm + keep;
    let violated = dot(&normal, c) < bound - ROUNDING;
    violated.then_some(Half { normal, bound, equal: law.equal, multiplier: 0.0 })
}

/// Moves c onto a violated half space, keeping the active ones active as long as their multipliers allow.
fn add(c: &mut [f64; 4], active: &mut heapless::Vec<Half, 4>, new: &mut Half) -> Option<()> {
    for _ in 0..CHANGES {
        let shares = shares(active, &new.normal)?;
        let mut direction = new.normal;
        for (h, share) in active.iter().zip(shares) {
            direction.iter_mut().zip(h.normal).for_each(|(d, n)| *d -= share * n);
        }
        let square = dot(&direction, &direction);
        let full =
            if square > DEPENDENT { (new.bound - dot(&new.normal, c)) / square } else { f64::INFINITY };
        let mut partial = (f64::INFINITY, 0);
        for (i, (h, share)) in active.iter().zip(shares).enumerate() {
            if !h.equal && share > 0.0 && h.multiplier / share < partial.0 {
                partial = (h.multiplier / share, i);
            }
        }
        let length = full.min(partial.0);
        if length.is_infinite() {
            return None;
        }
        if full.is_finite() {
            c.iter_mut().zip(direction).for_each(|(c, d)| *c += length * d);
        }
        for (h, share) in active.iter_mut().zip(shares) {
            h.multiplier -= length * share;
        }
        new.multiplier += length;
        if full <= partial.0 {
            return active.push(*new).ok();
        }
        active.swap_remove(partial.1);
    }
    None
}

/// How a normal divides among the active ones: the least-squares coefficients.
fn shares(active: &[Half], normal: &[f64; 4]) -> Option<[f64; 4]> {
    let mut m = [[0.0; 5]; 4];
    for (i, row) in m.iter_mut().enumerate() {
        let Some(a) = active.get(i) else {
            row[i] = 1.0;
            continue;
        };
        for (value, b) in row.iter_mut().zip(active) {
            *value = dot(&a.normal, &b.normal);
        }
        row[4] = dot(&a.normal, normal);
    }
    gauss(&mut m)
}

fn dot(a: &[f64; 4], b: &[f64; 4]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn law(row: [f64; 4], offset: f64, equal: bool) -> Law {
        Law { row, offset, equal, room: 0.0 }
    }

    #[test]
    fn the_nearest_point_of_a_wedge_is_found() {
        // x ≥ 1, x + y = 3, y ≤ 1: the nearest point is (2, 1), not (1.5, 1.5).
        let laws = [
            law([1.0, 0.0, 0.0, 0.0], -1.0, false),
            law([1.0, 1.0, 0.0, 0.0], -3.0, true),
            law([0.0, -1.0, 0.0, 0.0], 1.0, false),
        ];
        let c = least_costate(&laws, 0.0).expect("not empty");
        assert!(c.iter().zip([2.0, 1.0, 0.0, 0.0]).all(|(a, b)| (a - b).abs() < 1e-12), "{c:?}");
    }

    #[test]
    fn an_empty_polyhedron_has_no_point() {
        let laws = [law([1.0, 0.0, 2.0, 0.0], -1.0, false), law([-1.0, 0.0, -2.0, 0.0], -1.0, false)];
        assert_eq!(least_costate(&laws, 0.0), None);
    }

    #[test]
    fn active_laws_that_no_longer_bind_are_dropped() {
        // The first law to be added pushes one way, the worse ones after it the other.
        let laws = [
            law([1.0, 1.0, 0.0, 0.0], -4.0, false),
            law([1.0, -1.0, 0.0, 0.0], -2.0, false),
            law([1.0, 0.0, 0.0, 0.0], -5.0, false),
            law([0.0, 1.0, 0.0, 0.0], -0.5, false),
        ];
        let c = least_costate(&laws, 0.0).expect("not empty");
        assert!(c.iter().zip([5.0, 0.5, 0.0, 0.0]).all(|(a, b)| (a - b).abs() < 1e-12), "{c:?}");
    }
}

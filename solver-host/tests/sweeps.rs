//! Where the structure changes along the paper's two sweeps (Fig. 3 and Fig. 5), by bisection.

use mintime::solver::sweep::change;
use mintime::solver::{Extremal, Request, solve};

fn horizontal(x_m: f64) -> Request {
    Request::rest_to_rest(x_m, 0.0)
}

fn vertical(z_m: f64) -> Request {
    Request::rest_to_rest(0.0, z_m)
}

fn assert_change<P: PartialEq>(
    name: &str,
    expected_m: f64,
    family: fn(f64) -> Request,
    property: fn(&Extremal) -> P,
) {
    let found = change(family, property, (0.9 * expected_m, 1.1 * expected_m), 1e-4)
        .expect("solves")
        .unwrap_or_else(|| panic!("{name}: no change near {expected_m} m"));
    assert!((found - expected_m).abs() < 1e-3, "{name}: at {found} m, expected {expected_m} m");
}

#[test]
fn horizontal_structure_changes() {
    assert_change("arcs appear", 1.423, horizontal, |e| e.shape().arcs);
    assert_change("thrust always at maximum", 2.394, horizontal, |e| e.shape().low_thrust == 0);
    assert_change("arcs merge", 7.717, horizontal, |e| e.shape().arcs);
}

#[test]
fn vertical_structure_changes() {
    assert_change("the flip wins", 2.9554, vertical, |e| e.shape().turns);
    assert_change("an arc upside down", 6.268, vertical, |e| e.shape().arcs);
}

#[test]
fn between_the_changes_the_structure_stays() {
    for (from, to) in [(0.3, 1.4), (1.5, 2.35), (2.45, 7.6), (7.8, 15.0)] {
        let shape = solve(&horizontal(from)).expect("solves").extremal.shape();
        for i in 1..=20 {
            let x = from + (to - from) * f64::from(i) / 20.0;
            assert_eq!(solve(&horizontal(x)).expect("solves").extremal.shape(), shape, "{x} m");
        }
    }
}

/// Below the flip the paper's maneuvers keep θ = 0: full thrust, then least thrust. They satisfy the first-order
/// conditions only, and wiggling the pitch while the thrust is low is faster at every height.
#[test]
fn vertical_maneuvers_beat_the_papers_below_its_flip() {
    for (z_m, paper_s, ours_s) in
        [(1.0, 0.650_604, 0.644_659), (2.0, 0.920_093, 0.901_996), (2.4, 1.007_911, 0.981_482)]
    {
        // Straight up with 20 then 1 m/s² against gravity: both phases cover z, and the speeds meet.
        let (up, down): (f64, f64) = (20.0 - 9.81, 9.81 - 1.0);
        let straight_s = (2.0 * z_m * (up + down) / (up * down)).sqrt();
        assert!((straight_s - paper_s).abs() < 1e-6);
        let t = solve(&vertical(z_m)).expect("solves").extremal.duration_s();
        assert!((t - ours_s).abs() < 1e-6 && t < straight_s, "{z_m} m: {t}");
    }
}

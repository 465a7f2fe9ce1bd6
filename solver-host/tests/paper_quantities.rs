//! The paper's own residuals vanish on extremals, and do not where the maneuver is spoilt.

use mintime::solver::paper::Condition;
use mintime::solver::{Extremal, Request, solve};

fn extremals() -> Vec<Extremal> {
    [(5.0, 5.0), (0.1, 0.0), (1.5, 0.0), (15.0, 0.0), (0.0, 2.0), (0.0, 10.0), (1.0, -2.0), (10.0, -5.0)]
        .into_iter()
        .map(|(x, z)| solve(&Request::rest_to_rest(x, z)).expect("solves").extremal)
        .collect()
}

#[test]
fn residuals_vanish_and_least_squares_finds_c() {
    for extremal in extremals() {
        let e = extremal.explain();
        assert!(e.p_res < 1e-20 && e.bvp_residual < 1e-20, "{} {}", e.p_res, e.bvp_residual);
        assert!(e.rows.len() >= 4);
        for row in &e.rows {
            let value: f64 = row.a.iter().zip(extremal.costate.to_array()).map(|(a, c)| a * c).sum();
            assert!((value - row.r).abs() < 1e-10, "{row:?}: {value}");
        }
        assert!(e.c_res < 1e-19 && e.c_res_least_squares < 1e-16);
        let c = e.c_least_squares.expect("c is determined");
        for (a, b) in c.iter().zip(extremal.costate.to_array()) {
            assert!((a - b).abs() < 1e-6, "{c:?} {:?}", extremal.costate);
        }
    }
}

#[test]
fn arcs_have_both_their_conditions_at_both_ends() {
    let e = solve(&Request::rest_to_rest(15.0, 0.0)).expect("solves").extremal.explain();
    let count = |c: Condition| e.rows.iter().filter(|r| r.condition == c).count();
    assert_eq!(count(Condition::RateSwitch), 2);
    assert_eq!(count(Condition::ArcEdge), 2);
    assert_eq!(count(Condition::RateIntegral), 3);
    assert_eq!(count(Condition::ThrustSwitch), 0);
}

#[test]
fn a_spoilt_maneuver_shows_in_every_residual() {
    for mut extremal in extremals() {
        extremal.segments[0].duration *= 1.05;
        let e = extremal.explain();
        assert!(e.p_res > 1e-6, "{}", e.p_res);
        assert!(e.bvp_residual > 1e-6, "{}", e.bvp_residual);
        assert!(e.c_res > 1e-9, "{}", e.c_res);
    }
}

//! The design study: derivatives against differences, a law of similarity, and refusals.

use mintime::design::{DesignError, Parameter, Question, Range, Study};
use mintime::solver::{Request, Turns, solve};
use mintime_shared::model::{Limits, LimitsError};

const PLACES: [(f64, f64); 4] = [(5.0, 5.0), (3.0, 0.0), (0.5, 4.0), (2.0, -3.0)];

fn question(parameters: Vec<(Parameter, Range)>) -> Question {
    Question { displacements: PLACES.to_vec(), limits: Limits::TABLE_I, turns: Turns::Any, parameters }
}

fn usual() -> Study {
    let all = Parameter::ALL.map(|p| (p, p.usual_range(&Limits::TABLE_I)));
    question(all.to_vec()).study().expect("a study")
}

#[test]
fn derivatives_agree_with_differences() {
    let h = 1e-4;
    let around = |p: Parameter| {
        let value = p.of(&Limits::TABLE_I);
        (p, Range { low: value - h, high: value + h, count: 3 })
    };
    let study = question(Parameter::ALL.map(around).to_vec()).study().expect("a study");
    for m in &study.maneuvers {
        for curve in &m.curves {
            let [low, middle, high] = [0, 1, 2].map(|i| curve.points[i].outcome.clone().expect("solves"));
            let difference = (high.duration_s - low.duration_s) / (2.0 * h);
            let what = format!("({}, {}) {:?}", m.x_m, m.z_m, curve.parameter);
            assert!((difference - middle.derivative).abs() < 1e-7, "{what}: {difference} {middle:?}");
            assert!((curve.here.derivative - middle.derivative).abs() < 1e-9, "{what}");
            let value = curve.parameter.of(&Limits::TABLE_I);
            assert!((middle.elasticity - middle.derivative * value / middle.duration_s).abs() < 1e-9);
        }
    }
}

/// By eq. (3) ω T is a function of ω² times the displacement, thrusts and gravity fixed: 2 d ln T/d ln distance =
/// 1 + d ln T/d ln ω. The left side is found by differences of T alone.
#[test]
fn the_rates_elasticity_follows_from_similarity() {
    let study = usual();
    for m in &study.maneuvers {
        let h = 1e-5;
        let at = |k: f64| {
            let request = Request::rest_to_rest(k * m.x_m, k * m.z_m);
            solve(&request).expect("solves").extremal.duration_s().ln()
        };
        let by_distance = (at(1.0 + h) - at(1.0 - h)) / (2.0 * h);
        let curve = m.curves.iter().find(|c| c.parameter == Parameter::Rate).expect("varied");
        let wanted = 2.0 * by_distance - 1.0;
        assert!((curve.here.elasticity - wanted).abs() < 1e-6, "{} {wanted}", curve.here.elasticity);
    }
}

#[test]
fn more_of_a_limit_never_hurts() {
    for m in &usual().maneuvers {
        for curve in &m.curves {
            let found: Vec<_> = curve.points.iter().map(|p| p.outcome.as_ref().expect("solves")).collect();
            assert!(found.len() > 20);
            for pair in found.windows(2) {
                let change = pair[1].duration_s - pair[0].duration_s;
                let better = if curve.parameter == Parameter::MinThrust { -change } else { change };
                assert!(better < 1e-9, "({}, {}) {:?}: {pair:?}", m.x_m, m.z_m, curve.parameter);
            }
        }
        assert!(m.buys_most().is_some());
    }
}

#[test]
fn values_that_no_vehicle_can_hover_with_are_named_and_not_drawn() {
    let range = Range { low: 8.0, high: 12.0, count: 5 };
    let study = question(vec![(Parameter::MaxThrust, range)]).study().expect("a study");
    let points = &study.maneuvers[0].curves[0].points;
    let text = |i: usize| points[i].outcome.as_ref().expect_err("no maneuver").to_string();
    assert!(points[2..].iter().all(|p| p.outcome.is_ok()), "10 to 12 m/s² lift");
    assert!(text(0).contains("cannot hover: raise it") && text(1).contains("cannot hover"));
    let (svg, csv) = (study.svg(), study.csv());
    assert!(!svg.contains("NaN") && csv.contains("cannot hover"));
    let sink = Range { low: 9.0, high: 11.0, count: 3 };
    let study = question(vec![(Parameter::MinThrust, sink)]).study().expect("a study");
    let points = &study.maneuvers[0].curves[0].points;
    assert!(points[0].outcome.is_ok() && points[1].outcome.is_err() && points[2].outcome.is_err());
}

#[test]
fn what_cannot_be_studied_is_refused_with_a_reason() {
    let range = Range { low: 5.0, high: 15.0, count: 11 };
    let good = question(vec![(Parameter::Rate, range)]);
    let heavy = Limits { thrust_max_mps2: 9.0, ..Limits::TABLE_I };
    let refused = Question { limits: heavy, ..good.clone() }.study();
    assert!(matches!(refused, Err(DesignError::Limits(LimitsError::CannotLift))));
    let here = Question { displacements: vec![(0.0, 0.0)], ..good.clone() }.study();
    assert!(here.expect_err("nothing to fly").to_string().contains("nothing to fly"));
    for displacements in [Vec::new(), vec![(1.0, 0.0); 7]] {
        let refused = Question { displacements, ..good.clone() }.study();
        assert!(matches!(refused, Err(DesignError::Maneuvers(_))));
    }
    for range in [
        Range { low: 15.0, high: 5.0, count: 11 },
        Range { low: 5.0, high: 15.0, count: 1 },
        Range { low: f64::NAN, high: 15.0, count: 11 },
    ] {
        let refused = Question { parameters: vec![(Parameter::Rate, range)], ..good.clone() }.study();
        assert!(matches!(refused, Err(DesignError::Range)));
    }
}

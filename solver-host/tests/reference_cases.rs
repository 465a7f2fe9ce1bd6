//! The 24 reference maneuvers, computed by an independent solver.

use mintime::solver::{Request, Solution, Turns, solve};
use mintime_shared::model::{Limits, RateMode, State, ThrustLevel};
use serde::Deserialize;

const CASES: &str = include_str!("../../tests/data/reference_cases.json");

#[derive(Deserialize)]
struct File {
    cases: Vec<Case>,
}

#[derive(Deserialize)]
struct Case {
    name: String,
    x0: [f64; 5],
    #[serde(rename = "xT")]
    x_end: [f64; 5],
    limits: CaseLimits,
    #[serde(rename = "T_seconds")]
    t_seconds: f64,
    turns: i32,
    c: [f64; 4],
    p5_0: f64,
    segments: Vec<CaseSegment>,
    #[serde(rename = "T_by_turns")]
    t_by_turns: std::collections::BTreeMap<String, f64>,
}

#[derive(Deserialize)]
struct CaseLimits {
    f_min: f64,
    f_max: f64,
    omega_max: f64,
    g: f64,
}

#[derive(Deserialize)]
struct CaseSegment {
    #[serde(rename = "u_R")]
    u_r: String,
    #[serde(rename = "u_T")]
    u_t: String,
    duration_s: f64,
}

fn cases() -> Vec<Case> {
    let cases = serde_json::from_str::<File>(CASES).expect("reference data parses").cases;
    assert_eq!(cases.len(), 24);
    cases
}

impl Case {
    fn solve(&self, turns: Turns) -> Solution {
        let request = Request {
            from: State::from_array(self.x0),
            to: State::from_array(self.x_end),
            limits: Limits {
                thrust_min_mps2: self.limits.f_min,
                thrust_max_mps2: self.limits.f_max,
                rate_max_radps: self.limits.omega_max,
                gravity_mps2: self.limits.g,
            },
            turns,
        };
        solve(&request).unwrap_or_else(|e| panic!("{} {turns:?}: {e}", self.name))
    }
}

/// +1 where the answer is the reference, −1 where it is its mirror image.
fn mirrored(case: &Case, answer: &Solution) -> f64 {
    let first = &case.segments[0].u_r;
    let ours = answer.extremal.segments[0].inputs.rate;
    if (first == "+") == (ours == RateMode::Plus) { 1.0 } else { -1.0 }
}

#[test]
fn durations_agree_to_a_billionth() {
    for case in cases() {
        let answer = case.solve(Turns::Any);
        let t = answer.extremal.duration_s();
        assert!((t / case.t_seconds - 1.0).abs() < 1e-9, "{}: {t} against {}", case.name, case.t_seconds);
        assert!(answer.certificate.verified);
        assert!(answer.certificate.lower_bound_s <= t * (1.0 + 1e-9), "{}", case.name);
    }
}

#[test]
fn structures_are_identical_up_to_mirror_image() {
    for case in cases() {
        let answer = case.solve(Turns::Any);
        let sign = mirrored(&case, &answer);
        let segments = &answer.extremal.segments;
        assert_eq!(segments.len(), case.segments.len(), "{}", case.name);
        for (ours, theirs) in segments.iter().zip(&case.segments) {
            let rate = match (ours.inputs.rate, sign > 0.0) {
                (RateMode::Plus, true) | (RateMode::Minus, false) => "+",
                (RateMode::Minus, true) | (RateMode::Plus, false) => "-",
                (RateMode::Singular, _) => "s",
            };
            let thrust = match ours.inputs.thrust {
                ThrustLevel::Min => "min",
                ThrustLevel::Max => "max",
            };
            assert_eq!((rate, thrust), (theirs.u_r.as_str(), theirs.u_t.as_str()), "{}", case.name);
            assert!((ours.duration - theirs.duration_s).abs() < 1e-7, "{}", case.name);
        }
    }
}

#[test]
fn costates_agree_to_a_millionth_up_to_mirror_image() {
    for case in cases() {
        let answer = case.solve(Turns::Any);
        let sign = mirrored(&case, &answer);
        let [c1, c2, c3, c4] = answer.extremal.costate.to_array();
        let ours = [sign * c1, sign * c2, c3, c4, sign * answer.extremal.phi_r0];
        let [d1, d2, d3, d4] = case.c;
        for (a, b) in ours.iter().zip([d1, d2, d3, d4, case.p5_0]) {
            assert!((a - b).abs() < 1e-6, "{}: {ours:?} against {:?} {}", case.name, case.c, case.p5_0);
        }
    }
}

#[test]
fn every_winding_is_at_least_as_fast_as_the_reference() {
    for case in cases() {
        for (turns, t_reference) in &case.t_by_turns {
            let k: i32 = turns.parse().expect("a winding");
            let answer = case.solve(Turns::Exactly(k));
            let t = answer.extremal.duration_s();
            assert_eq!(answer.extremal.turns, k);
            assert!(t <= t_reference * (1.0 + 1e-9), "{} k = {k}: {t} against {t_reference}", case.name);
        }
    }
}

#[test]
fn the_winner_has_the_reference_winding_up_to_mirror_image() {
    for case in cases() {
        let answer = case.solve(Turns::Any);
        let tie = case.t_by_turns.get(&answer.extremal.turns.to_string());
        assert!(
            answer.extremal.turns == case.turns
                || tie.is_some_and(|t| (t / case.t_seconds - 1.0).abs() < 1e-9),
            "{}: {}",
            case.name,
            answer.extremal.turns
        );
    }
}

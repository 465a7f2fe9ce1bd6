//! The solver against a direct method that shares nothing with it: feasible maneuvers, integrated exactly, whose
//! durations no optimum may exceed (`benches/golden_upper_bounds.py`).

use mintime::solver::{Request, Turns, solve};
use mintime_shared::model::{Limits, State};
use serde::Deserialize;

#[derive(Deserialize)]
struct Golden {
    name: String,
    from: [f64; 5],
    to: [f64; 5],
    thrust: [f64; 2],
    rate: f64,
    gravity: f64,
    #[serde(rename = "T_upper_s")]
    upper_s: f64,
    end_residual: [f64; 5],
}

impl Golden {
    fn request(&self) -> Request {
        let [thrust_min_mps2, thrust_max_mps2] = self.thrust;
        Request {
            from: State::from_array(self.from),
            to: State::from_array(self.to),
            limits: Limits {
                thrust_min_mps2,
                thrust_max_mps2,
                rate_max_radps: self.rate,
                gravity_mps2: self.gravity,
            },
            turns: Turns::Any,
        }
    }
}

/// Relative excess over an upper bound that is the direct method's own tolerance.
const SAME: f64 = 1.0e-6;
/// How much slower than the direct method a single answer may be: another local optimum.
const WORST: f64 = 0.02;
/// Part of the requests on which the solver is at least as fast.
const AS_FAST: f64 = 0.99;

#[test]
fn no_answer_is_slower_than_what_a_direct_method_finds() {
    let golden: Vec<Golden> = include_str!("../data/golden/upper_bounds.jsonl")
        .lines()
        .map(|line| serde_json::from_str(line).expect("golden data parses"))
        .collect();
    assert_eq!(golden.len(), 200);
    let mut as_fast = 0;
    for case in &golden {
        // A bound that does not reach its end bounds nothing.
        assert!(case.end_residual.iter().all(|r| r.abs() < 1e-7), "{}", case.name);
        let solution = solve(&case.request()).unwrap_or_else(|e| panic!("{}: {e}", case.name));
        let excess = solution.extremal.duration_s() / case.upper_s - 1.0;
        assert!(excess <= WORST, "{}: {excess:e} slower", case.name);
        if excess <= SAME {
            as_fast += 1;
        } else {
            println!("{}: {excess:e} slower than {} s", case.name, case.upper_s);
        }
        // Nor may the golden data be wrong: nothing beats the rigorous lower bound.
        assert!(case.upper_s >= solution.certificate.lower_bound_s, "{}", case.name);
    }
    println!("{as_fast} of {} at least as fast", golden.len());
    assert!(f64::from(as_fast) >= AS_FAST * golden.len() as f64, "{as_fast} of {}", golden.len());
}

//! Warm solves: a sweep where every maneuver starts from its neighbour, and what the check alone costs.
//! `cargo bench -p mintime --bench warm`.

use std::hint::black_box;
use std::time::Instant;

use mintime::solver::{Request, Solution, solve, solve_from, verify};

/// Metres between neighbours.
const STEP_M: f64 = 0.05;
const COUNT: u32 = 200;

fn main() {
    let mut warm = Vec::new();
    let mut check = Vec::new();
    let mut evaluations = 0;
    let mut before: Solution = solve(&Request::rest_to_rest(3.0, 2.0)).expect("solves");
    for i in 1..=COUNT {
        let request = Request::rest_to_rest(3.0 + STEP_M * f64::from(i), 2.0);
        let mut answer = None;
        warm.push(fastest(|| answer = solve_from(black_box(&before.extremal), black_box(&request)).ok()));
        let Some(solution) = answer else {
            println!("{request:?} did not solve");
            continue;
        };
        evaluations += solution.evaluations;
        check.push(fastest(|| {
            black_box(verify(black_box(&solution.extremal)));
        }));
        before = solution;
    }
    for (name, times) in [("warm solve", &mut warm), ("verify", &mut check)] {
        times.sort_by(f64::total_cmp);
        let at = |q: f64| times[((times.len() - 1) as f64 * q) as usize];
        println!("{name:12} median {:6.1} µs  p90 {:6.1} µs  worst {:6.1} µs", at(0.5), at(0.9), at(1.0));
    }
    println!("{:.1} evaluations a warm solve", f64::from(evaluations) / f64::from(COUNT));
}

/// Fastest of a few runs, µs: the work is deterministic, what the scheduler adds is not.
fn fastest(mut work: impl FnMut()) -> f64 {
    (0..5)
        .map(|_| {
            let clock = Instant::now();
            work();
            clock.elapsed().as_secs_f64() * 1e6
        })
        .fold(f64::INFINITY, f64::min)
}

//! Cold solves of the 2,000 random requests: success and time per class, for the fastest winding (`solve`) and for all
//! windings (`solve_all_windings`, what the command does). `cargo bench -p mintime --bench cold`.
//!
//! Times are the best of three (of one for all windings); above 10 ms it is the processor time.

#[path = "../tests/requests/mod.rs"]
mod requests;

use std::time::{Duration, Instant};

use mintime::solver::{Request, Solution, SolveError, solve, solve_all_windings};
use requests::{CLASSES, requests};

fn main() {
    let list = requests();
    println!(
        "{:12} {:>5} {:>8} {:>10} {:>10} {:>10} {:>10} {:>12}",
        "class", "n", "verified", "median µs", "p90 µs", "p99 µs", "worst µs", "evaluations"
    );
    let (mut all, mut each) = (Vec::new(), Vec::new());
    for (class, _) in CLASSES {
        let (mut times, mut all_times) = (Vec::new(), Vec::new());
        let mut verified = 0;
        let mut evaluations = 0;
        for (_, request) in list.iter().filter(|(c, _)| *c == class) {
            // A solve is deterministic, what the scheduler adds is not.
            let answer = solve(request);
            times.push(fastest(3, request, solve));
            all_times.push(fastest(1, request, solve_all_windings));
            match answer {
                Ok(solution) => {
                    verified += 1;
                    evaluations += solution.evaluations;
                    if std::env::var_os("MINTIME_PRINT").is_some() {
                        println!(
                            "{:.12} {} {request:?}",
                            solution.extremal.duration_s(),
                            solution.extremal.turns
                        );
                    }
                }
                Err(error) => println!("{class:?} {request:?}: {error}"),
            }
        }
        row(&format!("{class:?}"), verified, evaluations, &mut times);
        all.append(&mut times);
        each.push((format!("{class:?}"), all_times));
    }
    row("all", 0, 0, &mut all);
    println!(
        "\nall windings\n{:12} {:>5} {:>10} {:>10} {:>10} {:>10}",
        "class", "n", "median µs", "p90 µs", "p99 µs", "worst µs"
    );
    let everything = each.iter().flat_map(|(_, times)| times.iter().copied()).collect();
    each.push(("all".to_owned(), everything));
    for (name, mut times) in each {
        let [median, p90, p99, worst] = quantiles(&mut times);
        println!("{name:12} {:5} {median:10.1} {p90:10.1} {p99:10.1} {worst:10.1}", times.len());
    }
}

/// Time of the fastest of `rounds` runs.
fn fastest(rounds: u32, request: &Request, solver: fn(&Request) -> Result<Solution, SolveError>) -> Duration {
    let time = |_| {
        let (clock, cpu) = (Instant::now(), cpu_time());
        let answer = solver(request);
        let wall = clock.elapsed();
        std::hint::black_box(&answer);
        // On a busy machine a long solve is interrupted every time: count what it ran. The kernel's count is coarse, so
        // short ones go by the wall clock.
        match (cpu, cpu_time()) {
            (Some(a), Some(b)) if wall > COARSE => wall.min(b.saturating_sub(a)),
            _ => wall,
        }
    };
    (0..rounds).map(time).min().unwrap_or_default()
}

/// Solves longer than this are timed by the processor time they took.
const COARSE: Duration = Duration::from_millis(10);

/// Processor time of this thread so far, where the system tells.
fn cpu_time() -> Option<Duration> {
    let text = std::fs::read_to_string("/proc/thread-self/schedstat").ok()?;
    Some(Duration::from_nanos(text.split_whitespace().next()?.parse().ok()?))
}

/// Median, p90, p99 and the worst, µs.
fn quantiles(times: &mut [Duration]) -> [f64; 4] {
    times.sort_unstable();
    [0.5, 0.9, 0.99, 1.0].map(|q| times[((times.len() - 1) as f64 * q) as usize].as_secs_f64() * 1e6)
}

fn row(name: &str, verified: u32, evaluations: u32, times: &mut [Duration]) {
    let [median, p90, p99, worst] = quantiles(times);
    println!(
        "{name:12} {:5} {verified:8} {median:10.1} {p90:10.1} {p99:10.1} {worst:10.1} {:12.1}",
        times.len(),
        f64::from(evaluations) / f64::from(verified.max(1)),
    );
}

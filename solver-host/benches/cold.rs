//! Cold solves of the 2,000 random requests: success and time per class. `cargo bench -p mintime --bench cold`.

#[path = "../tests/requests/mod.rs"]
mod requests;

use std::time::{Duration, Instant};

use mintime::solver::solve;
use requests::{CLASSES, requests};

fn main() {
    let list = requests();
    println!(
        "{:12} {:>5} {:>8} {:>10} {:>10} {:>10} {:>10} {:>12}",
        "class", "n", "verified", "median µs", "p90 µs", "p99 µs", "worst µs", "evaluations"
    );
    let mut all = Vec::new();
    for (class, _) in CLASSES {
        let mut times = Vec::new();
        let mut verified = 0;
        let mut evaluations = 0;
        for (_, request) in list.iter().filter(|(c, _)| *c == class) {
            // The fastest of three: a solve is deterministic, what the scheduler adds is not.
            let mut answer = solve(request);
            let time = (0..3)
                .map(|_| {
                    let (clock, cpu) = (Instant::now(), cpu_time());
                    answer = solve(request);
                    let wall = clock.elapsed();
                    // On a busy machine a long solve is interrupted every time: count what it ran. The kernel's
                    // count is coarse, so short ones go by the wall clock.
                    match (cpu, cpu_time()) {
                        (Some(a), Some(b)) if wall > COARSE => wall.min(b.saturating_sub(a)),
                        _ => wall,
                    }
                })
                .min();
            times.push(time.unwrap_or_default());
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
    }
    row("all", 0, 0, &mut all);
}

/// Solves longer than this are timed by the processor time they took.
const COARSE: Duration = Duration::from_millis(10);

/// Processor time of this thread so far, where the system tells.
fn cpu_time() -> Option<Duration> {
    let text = std::fs::read_to_string("/proc/thread-self/schedstat").ok()?;
    Some(Duration::from_nanos(text.split_whitespace().next()?.parse().ok()?))
}

fn row(name: &str, verified: u32, evaluations: u32, times: &mut [Duration]) {
    times.sort_unstable();
    let at = |q: f64| times[((times.len() - 1) as f64 * q) as usize].as_secs_f64() * 1e6;
    println!(
        "{name:12} {:5} {verified:8} {:10.1} {:10.1} {:10.1} {:10.1} {:12.1}",
        times.len(),
        at(0.5),
        at(0.9),
        at(0.99),
        at(1.0),
        f64::from(evaluations) / f64::from(verified.max(1)),
    );
}

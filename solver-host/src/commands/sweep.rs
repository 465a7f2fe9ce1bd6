//! `mintime sweep`: the paper's figures and more, as CSV.

use std::error::Error;
use std::fmt::Write as _;
use std::io::IsTerminal as _;
use std::path::PathBuf;
use std::process::ExitCode;

use clap::{Args, Subcommand};
use indicatif::{ProgressBar, ProgressStyle};
use mintime::flight_log::check_writable;
use mintime::parallel;
use mintime::solver::{Request, Solution, SolveError, solve};
use mintime_shared::model::{GRAVITY_MPS2, Limits, State};

use super::answer::{rate_word, thrust_word};
use super::limits::PlanArguments;
use super::solve::write_text;
use super::{numbers, print};

/// Arguments of `mintime sweep`.
#[derive(Args)]
pub(crate) struct Sweep {
    #[command(subcommand)]
    kind: Kind,
}

/// Which displacements.
#[derive(Subcommand)]
enum Kind {
    /// Purely horizontal displacements: the paper's Fig. 3
    Horizontal(Line),
    /// Purely vertical displacements: the paper's Fig. 5
    Vertical(Line),
    /// A map T(x, z)
    Map(Map),
}

#[derive(Args)]
struct Line {
    /// First, last and step of the displacement, m
    #[arg(long, value_name = "FIRST,LAST,STEP", value_parser = numbers::list::<3>, allow_hyphen_values = true)]
    range: Option<[f64; 3]>,
    #[command(flatten)]
    common: Common,
}

#[derive(Args)]
struct Map {
    /// First and last x, m
    #[arg(long, value_name = "FIRST,LAST", value_parser = numbers::list::<2>, allow_hyphen_values = true,
          default_value = "-15,15")]
    x: [f64; 2],
    /// First and last z, m
    #[arg(long, value_name = "FIRST,LAST", value_parser = numbers::list::<2>, allow_hyphen_values = true,
          default_value = "-10,10")]
    z: [f64; 2],
    /// Points along x and z
    #[arg(long, value_name = "NX,NZ", value_parser = numbers::list::<2>, default_value = "300,200")]
    points: [f64; 2],
    #[command(flatten)]
    common: Common,
}

#[derive(Args)]
struct Common {
    #[command(flatten)]
    plan: PlanArguments,
    /// Gravity, m/s²
    #[arg(long, value_name = "G", value_parser = numbers::finite, allow_hyphen_values = true,
          default_value_t = GRAVITY_MPS2)]
    gravity: f64,
    /// Where to write the CSV; standard output without it
    #[arg(short = 'o', long = "output", value_name = "FILE.csv")]
    output: Option<PathBuf>,
    /// Print a summary as JSON (with -o)
    #[arg(long, requires = "output")]
    json: bool,
}

/// Most points of a sweep: beyond it a typing error is likelier than patience.
const MOST_POINTS: f64 = 4.0e6;

impl Sweep {
    pub(crate) fn run(self) -> ExitCode {
        let (points, common) = match &self.kind {
            Kind::Horizontal(line) => (line.points([0.1, 15.0, 0.1], |d| (d, 0.0)), &line.common),
            Kind::Vertical(line) => (line.points([0.1, 10.0, 0.1], |d| (0.0, d)), &line.common),
            Kind::Map(map) => (map.points(), &map.common),
        };
        points.map_err(Box::from).and_then(|points| common.sweep(&points)).unwrap_or_else(
            |error: Box<dyn Error>| {
                if common.json {
                    print(&serde_json::json!({ "error": error.to_string() }).to_string());
                }
                eprintln!("mintime: {error}");
                ExitCode::FAILURE
            },
        )
    }
}

impl Line {
    fn points(&self, default: [f64; 3], place: fn(f64) -> (f64, f64)) -> Result<Vec<(f64, f64)>, String> {
        let [first, last, step] = self.range.unwrap_or(default);
        let count = ((last - first) / step + 1e-9).floor() + 1.0;
        if !(1.0..=MOST_POINTS).contains(&count) {
            return Err(format!(
                "--range {first},{last},{step} has no points, or too many: check its signs and step"
            ));
        }
        Ok((0..count as u64).map(|i| place(first + i as f64 * step)).collect())
    }
}

impl Map {
    fn points(&self) -> Result<Vec<(f64, f64)>, String> {
        let [nx, nz] = self.points;
        if nx < 1.0 || nz < 1.0 || nx.fract() != 0.0 || nz.fract() != 0.0 || nx * nz > MOST_POINTS {
            return Err("--points needs two whole numbers above zero, four million points at most".to_owned());
        }
        let at = |[first, last]: [f64; 2], i: u64, n: f64| {
            if n > 1.0 { first + (last - first) * i as f64 / (n - 1.0) } else { first }
        };
        let column = |j: u64| (0..nx as u64).map(move |i| (at(self.x, i, nx), at(self.z, j, nz)));
        Ok((0..nz as u64).flat_map(column).collect())
    }
}

/// How one point went.
enum Point {
    Solved(Box<Solution>),
    /// The origin itself: T = 0.
    Here,
    Failed(SolveError),
}

impl Common {
    fn sweep(&self, points: &[(f64, f64)]) -> Result<ExitCode, Box<dyn Error>> {
        self.output.as_deref().map(check_writable).transpose()?;
        let limits = self.plan.limits(self.gravity);
        limits.validate()?;
        let clock = std::time::Instant::now();
        let solved = self.solve_all(points, limits);
        let wall_time_s = clock.elapsed().as_secs_f64();
        let failed = solved.iter().filter(|p| matches!(p, Point::Failed(_))).count();
        let csv = csv(points, &solved);
        match &self.output {
            None => print(csv.trim_end()),
            Some(path) => {
                write_text(path, &csv)?;
                if self.json {
                    let summary = serde_json::json!({
                        "points": points.len(), "failed": failed, "wall_time_s": wall_time_s, "output": path,
                    });
                    print(&format!("{summary:#}"));
                } else {
                    print(&format!(
                        "{} points, {failed} without answer, {wall_time_s:.2} s: {}",
                        points.len(),
                        path.display()
                    ));
                }
            }
        }
        if failed > 0 {
            eprintln!("mintime: {failed} points have no verified answer; their lines say why");
            return Ok(ExitCode::FAILURE);
        }
        Ok(ExitCode::SUCCESS)
    }

    /// Solves all points on all cores, with a bar on a terminal.
    fn solve_all(&self, points: &[(f64, f64)], limits: Limits<f64>) -> Vec<Point> {
        let bar = ProgressBar::new(points.len() as u64);
        if !std::io::stderr().is_terminal() {
            bar.set_draw_target(indicatif::ProgressDrawTarget::hidden());
        }
        if let Ok(style) = ProgressStyle::with_template("{bar:40} {pos}/{len} points, {eta} left") {
            bar.set_style(style);
        }
        let solved =
            parallel::map(points, |point| self.solve_point(*point, limits), |done| bar.inc(done as u64));
        bar.finish_and_clear();
        solved
    }

    fn solve_point(&self, (x, z): (f64, f64), limits: Limits<f64>) -> Point {
        let request =
            Request { from: State::origin(), to: State::at_rest(x, z), limits, turns: self.plan.turns };
        match solve(&request) {
            Ok(solution) => Point::Solved(Box::new(solution)),
            Err(SolveError::AlreadyThere) => Point::Here,
            Err(error) => Point::Failed(error),
        }
    }
}

/// One line a point: displacement, duration, turns, structure, and the times of all switches.
fn csv(points: &[(f64, f64)], solved: &[Point]) -> String {
    let mut out = String::from("x_m,z_m,duration_s,turns,structure,switch_times_s\n");
    for ((x, z), point) in points.iter().zip(solved) {
        // Writing to a string does not fail.
        let _ = match point {
            Point::Here => writeln!(out, "{x},{z},0,0,,"),
            Point::Failed(error) => writeln!(out, "{x},{z},,,\"{error}\","),
            Point::Solved(solution) => {
                let extremal = &solution.extremal;
                let words = extremal
                    .segments
                    .iter()
                    .map(|s| format!("{}{}", rate_word(s.inputs.rate), thrust_word(s.inputs.thrust)));
                let mut t = 0.0;
                let times = extremal.segments.iter().map(|s| {
                    t += s.duration;
                    t.to_string()
                });
                let (words, times) =
                    (words.collect::<Vec<_>>().join(" "), times.collect::<Vec<_>>().join(" "));
                writeln!(out, "{x},{z},{},{},{words},{times}", extremal.duration_s(), extremal.turns)
            }
        };
    }
    out
}

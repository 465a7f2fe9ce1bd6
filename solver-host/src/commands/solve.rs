//! `mintime solve`: a maneuver between any two states, or a file of them.

use std::error::Error;
use std::fmt::Write as _;
use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::Args;
use mintime::flight_log::{OutputError, check_writable, write_whole};
use mintime::solver::{Extremal, Request};
use mintime_shared::model::{GRAVITY_MPS2, State};
use mintime_shared::table::MAX_TABLE_BYTES;

use super::answer::{Answer, Solved, answer};
use super::explain::explain;
use super::fly::distinct;
use super::limits::PlanArguments;
use super::{batch, numbers, print};

/// Arguments of `mintime solve`.
#[derive(Args)]
#[command(
    after_help = "Examples:\n  mintime solve --to 5,5\n  mintime solve --from 0,3,0,-1,0.5 --to 4,1 --json\n  \
                        mintime solve --to 0,0 --turns 1 -o flip.table --trajectory flip.csv --sample-hz 1000\n  \
                        mintime solve --batch requests.jsonl -o answers.jsonl"
)]
pub(crate) struct Solve {
    /// Start state: m, m/s, m, m/s, rad
    #[arg(long, value_name = "X,VX,Z,VZ,THETA", value_parser = numbers::state, allow_hyphen_values = true,
          default_value = "0,0,0,0,0")]
    from: State<f64>,
    /// End: a position to come to rest at, level, or a whole state. Angles count as given, unwrapped
    #[arg(long, value_name = "X,Z | X,VX,Z,VZ,THETA", value_parser = numbers::state, allow_hyphen_values = true,
          required_unless_present = "batch")]
    to: Option<State<f64>>,
    #[command(flatten)]
    plan: PlanArguments,
    /// Gravity, m/s²
    #[arg(long, value_name = "G", value_parser = numbers::finite, allow_hyphen_values = true,
          default_value_t = GRAVITY_MPS2)]
    gravity: f64,
    /// Write the maneuver table (or, with --batch, the answers) to this file
    #[arg(short = 'o', long = "output", value_name = "FILE")]
    output: Option<PathBuf>,
    /// Write the trajectory as CSV: time, states, inputs and switching functions
    #[arg(long, value_name = "FILE.csv", conflicts_with = "batch")]
    trajectory: Option<PathBuf>,
    /// Samples a second in the trajectory; its last line is the end
    #[arg(long, value_name = "N", value_parser = numbers::positive, allow_hyphen_values = true,
          default_value = "800", requires = "trajectory")]
    sample_hz: f64,
    /// Answer a file of requests, one JSON object a line, like
    /// {"name":"a","from":[0,0,0,0,0],"to":[5,0,5,0,0],"thrust":[1,20],"rate":10,"gravity":9.81}; only "turns" (a whole
    /// number, or "any") may be left out
    #[arg(long, value_name = "FILE.jsonl",
          conflicts_with_all = ["to", "from", "thrust_per_mass", "max_body_rate", "gravity", "turns"])]
    batch: Option<PathBuf>,
    /// Print the paper's own quantities for this maneuver, step by step
    #[arg(long, conflicts_with_all = ["batch", "json"])]
    explain: bool,
    /// Print JSON instead of text
    #[arg(long)]
    json: bool,
}

/// Most lines of a trajectory.
const MOST_SAMPLES: f64 = 4.0e6;

impl Solve {
    pub(crate) fn run(self) -> ExitCode {
        let done = match &self.batch {
            Some(path) => self.solve_batch(path),
            None => self.solve_one().map(|()| ExitCode::SUCCESS),
        };
        done.unwrap_or_else(|error| {
            if self.json {
                print(&serde_json::json!({ "error": error.to_string() }).to_string());
            }
            eprintln!("mintime: {error}");
            ExitCode::FAILURE
        })
    }

    fn solve_batch(&self, path: &Path) -> Result<ExitCode, Box<dyn Error>> {
        distinct([Some(&path.to_owned()), self.output.as_ref()])?;
        self.output.as_deref().map(check_writable).transpose()?;
        let answers = batch::answer_file(path)?;
        match &self.output {
            Some(output) => write_text(output, &answers.text)?,
            None => print(answers.text.trim_end()),
        }
        if answers.failed > 0 {
            eprintln!("mintime: {} requests have no answer; their lines say why", answers.failed);
            return Ok(ExitCode::FAILURE);
        }
        Ok(ExitCode::SUCCESS)
    }

    fn request(&self) -> Request {
        Request {
            from: self.from,
            to: self.to.unwrap_or(self.from),
            limits: self.plan.limits(self.gravity),
            turns: self.plan.turns,
        }
    }

    fn solve_one(&self) -> Result<(), Box<dyn Error>> {
        distinct([self.output.as_ref(), self.trajectory.as_ref()])?;
        for file in [&self.output, &self.trajectory].into_iter().flatten() {
            check_writable(file)?;
        }
        let Solved { answer, maneuver } = answer(&self.request(), None)?;
        if let Some((solution, table)) = &maneuver {
            if let Some(path) = &self.output {
                let mut bytes = [0; MAX_TABLE_BYTES];
                let length = table.clone()?.encode(&mut bytes)?;
                write_bytes(path, &bytes[..length])?;
            }
            if let Some(path) = &self.trajectory {
                let samples = solution.extremal.duration_s() * self.sample_hz;
                if samples > MOST_SAMPLES {
                    return Err(format!(
                        "--sample-hz {} gives {samples:.0} lines: ask for fewer than {MOST_SAMPLES}",
                        self.sample_hz
                    )
                    .into());
                }
                write_text(path, &trajectory(&solution.extremal, self.sample_hz))?;
            }
        } else if self.output.is_some() || self.trajectory.is_some() {
            return Err(
                "start and end are the same state (T = 0), so there is no table and no trajectory".into()
            );
        }
        if self.explain {
            if let Some((solution, _)) = &maneuver {
                print(&explain(&solution.extremal));
            }
        } else if self.json {
            print(&format!("{:#}", serde_json::to_value(&answer)?));
        } else {
            print(&page(&answer));
            if let Some((_, Err(error))) = &maneuver {
                print(&format!("           no table: {error}"));
            }
        }
        Ok(())
    }
}

/// The trajectory as CSV. Columns: t, x, vx, z, vz, theta, pitch rate, thrust per mass, Φ_R, Φ_T.
fn trajectory(extremal: &Extremal, sample_hz: f64) -> String {
    let duration_s = extremal.duration_s();
    let mut out = String::from("t_s,x_m,vx_mps,z_m,vz_mps,theta_rad,rate_radps,thrust_mps2,phi_r,phi_t\n");
    // The end is a line of its own, a whole number of periods or not.
    let samples = (duration_s * sample_hz).ceil() as u64;
    for t in (0..samples).map(|i| i as f64 / sample_hz).chain([duration_s]) {
        let State { x, vx, z, vz, theta } = extremal.state_at(t);
        let (rate, thrust) = (extremal.rate_at(t), extremal.thrust_at(t));
        let (phi_r, phi_t) = (extremal.phi_r_at(t), extremal.phi_t_at(t));
        // Writing to a string does not fail.
        let _ = writeln!(out, "{t},{x},{vx},{z},{vz},{theta},{rate},{thrust},{phi_r},{phi_t}");
    }
    out
}

/// The answer for a person.
pub(crate) fn page(answer: &Answer) -> String {
    if answer.segments.is_empty() {
        return "T = 0: start and end are the same state, there is nothing to fly".to_owned();
    }
    let c = &answer.certificate;
    let mut lines = vec![
        format!("T          {:.9} s, turns {}", answer.duration_s, answer.turns),
        format!(
            "verified   {}{}; lower bound {:.6} s",
            if c.verified { "yes" } else { "no" },
            if c.degenerate { ", degenerate (the costate is not unique)" } else { "" },
            c.lower_bound_s
        ),
        format!(
            "           max |H| {:.1e}, control laws {:.1e}, Kelley margin {:.3}, largest |u_R| on arcs {:.3}",
            c.hamiltonian, c.control_law, c.kelley, c.singular_rate_max
        ),
        format!("           end error {:.1e} (m, m/s, m, m/s, rad)", Scientific(&c.final_state_error)),
    ];
    lines.extend(answer.costate.map(|c| format!("costate    c = {c:.9?} (dimensionless)")));
    lines.push("segments   duration (s)   pitch rate   thrust".to_owned());
    for s in &answer.segments {
        lines.push(format!("           {:<14.9} {:<12} {}", s.duration_s, s.rate, s.thrust));
    }
    for a in &answer.alternatives {
        lines.push(format!("also       turns {}: {:.9} s", a.turns, a.duration_s));
    }
    for k in &answer.unsolved {
        lines.push(format!("unsolved   turns {k}: no verified maneuver found, though it could be faster"));
    }
    lines.push(format!("table      {} bytes", answer.table_bytes));
    lines.push(format!("time       {:.3} ms", answer.solve_time_s * 1e3));
    lines.join("\n")
}

/// Numbers in scientific notation, separated by commas.
struct Scientific<'a>(&'a [f64]);

impl core::fmt::LowerExp for Scientific<'_> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        for (i, value) in self.0.iter().enumerate() {
            f.write_str(if i == 0 { "" } else { ", " })?;
            value.fmt(f)?;
        }
        Ok(())
    }
}

/// Writes text as a whole file.
pub(crate) fn write_text(path: &Path, text: &str) -> Result<(), OutputError> {
    write_bytes(path, text.as_bytes())
}

/// Writes bytes as a whole file.
pub(crate) fn write_bytes(path: &Path, bytes: &[u8]) -> Result<(), OutputError> {
    write_whole::<OutputError>(path, |file| {
        file.write_all(bytes).map_err(|source| OutputError::Interrupted { path: path.to_owned(), source })
    })
}

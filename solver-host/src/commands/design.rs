//! `mintime design`: which of the vehicle's limits buys the most.

use std::error::Error;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::{Args, ValueEnum};
use mintime::design::{Curve, Maneuver, Parameter, Point, Question, Range, Study, check_picture};
use mintime::flight_log::check_writable;
use mintime_shared::model::GRAVITY_MPS2;
use serde_json::{Value, json};

use super::limits::PlanArguments;
use super::solve::write_text;
use super::{numbers, print};

/// Arguments of `mintime design`.
#[derive(Args)]
#[command(after_help = "Examples:\n  mintime design --to 5,5 --to 3,0 --to 0,4 -o design.svg\n  \
                        mintime design --to 5,5 --vary rate --over 4:30:105 -o rate.csv\n  \
                        mintime design --to 2,0 --thrust-per-mass 2,15 --max-body-rate 6 --json")]
pub(crate) struct Design {
    /// A displacement to fly from rest to rest, m; up to six of them
    #[arg(long, value_name = "X,Z", value_parser = numbers::list::<2>, allow_hyphen_values = true, required = true)]
    to: Vec<[f64; 2]>,
    /// Vary only these limits
    #[arg(long, value_enum, value_delimiter = ',')]
    vary: Vec<Vary>,
    /// First and last value and how many, in the unit of the one limit that is varied; without it a range around the
    /// vehicle's value
    #[arg(long, value_name = "FIRST:LAST:COUNT", value_parser = over, requires = "vary")]
    over: Option<Range>,
    #[command(flatten)]
    plan: PlanArguments,
    /// Gravity, m/s²
    #[arg(long, value_name = "G", value_parser = numbers::finite, allow_hyphen_values = true,
          default_value_t = GRAVITY_MPS2)]
    gravity: f64,
    /// Write the picture or the points to this file, by its ending; may be given again
    #[arg(short = 'o', long = "output", value_name = "FILE.svg|.png|.csv")]
    output: Vec<PathBuf>,
    /// Print JSON instead of text
    #[arg(long)]
    json: bool,
}

/// A limit to vary.
#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Vary {
    /// Greatest collective thrust per mass, m/s²
    MaxThrust,
    /// Least collective thrust per mass, m/s²
    MinThrust,
    /// Greatest body rate, rad/s
    Rate,
}

impl From<Vary> for Parameter {
    fn from(vary: Vary) -> Self {
        match vary {
            Vary::MaxThrust => Self::MaxThrust,
            Vary::MinThrust => Self::MinThrust,
            Vary::Rate => Self::Rate,
        }
    }
}

/// Parses `FIRST:LAST:COUNT`.
fn over(text: &str) -> Result<Range, String> {
    let parts: Vec<&str> = text.split(':').collect();
    let [low, high, count] = parts.as_slice() else {
        return Err("three numbers separated by colons are needed, like 12:40:57".to_owned());
    };
    let count = count.trim().parse().map_err(|_| format!("`{count}` is not a whole number of points"))?;
    Ok(Range { low: numbers::finite(low)?, high: numbers::finite(high)?, count })
}

impl Design {
    pub(crate) fn run(self) -> ExitCode {
        self.study().map_or_else(
            |error| {
                if self.json {
                    print(&json!({ "error": error.to_string() }).to_string());
                }
                eprintln!("mintime: {error}");
                ExitCode::FAILURE
            },
            |written| if written { ExitCode::SUCCESS } else { ExitCode::FAILURE },
        )
    }

    fn question(&self) -> Result<Question, String> {
        let limits = self.plan.limits(self.gravity);
        let mut parameters: Vec<Parameter> = Parameter::ALL.to_vec();
        if !self.vary.is_empty() {
            parameters.retain(|p| self.vary.iter().any(|v| Parameter::from(*v) == *p));
        }
        if self.over.is_some() && parameters.len() != 1 {
            return Err("--over is about one limit: name just one with --vary".to_owned());
        }
        let range = |parameter: Parameter| self.over.unwrap_or_else(|| parameter.usual_range(&limits));
        Ok(Question {
            displacements: self.to.iter().map(|[x, z]| (*x, *z)).collect(),
            limits,
            turns: self.plan.turns,
            parameters: parameters.into_iter().map(|p| (p, range(p))).collect(),
        })
    }

    /// Whether all was written.
    fn study(&self) -> Result<bool, Box<dyn Error>> {
        for path in &self.output {
            if is_csv(path) { check_writable(path)? } else { check_picture(path).map_err(with_csv)? }
        }
        let question = self.question()?;
        question.limits.validate()?;
        let clock = std::time::Instant::now();
        let study = question.study()?;
        let wall_time_s = clock.elapsed().as_secs_f64();
        let mut written = Vec::new();
        let mut failed = Vec::new();
        for path in &self.output {
            let outcome: Result<(), Box<dyn Error>> = if is_csv(path) {
                write_text(path, &study.csv()).map_err(Into::into)
            } else {
                study.write_picture(path).map_err(Into::into)
            };
            match outcome {
                Ok(()) => written.push(path.clone()),
                Err(error) => failed.push(error),
            }
        }
        // The answer comes first, whatever became of the files.
        if self.json {
            print(&format!("{:#}", summary(&study, &written, wall_time_s)));
        } else {
            print(&text(&study, &written));
        }
        for error in &failed {
            eprintln!("mintime: {error}");
        }
        Ok(failed.is_empty())
    }
}

fn is_csv(path: &Path) -> bool {
    path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("csv"))
}

/// The refusal of an ending, for a command that knows one more.
fn with_csv(error: mintime::drawing::PictureError) -> String {
    match error {
        mintime::drawing::PictureError::UnknownFormat { path } => {
            format!("{} ends in none of .svg, .png and .csv: choose one of these endings", path.display())
        }
        other => other.to_string(),
    }
}

/// Points without a maneuver, and the first reason.
fn missing(points: &[Point]) -> Option<(usize, String)> {
    let mut errors = points.iter().filter_map(|p| p.outcome.as_ref().err());
    let first = errors.next()?.to_string();
    Some((1 + errors.count(), first))
}

/// The study for a person.
fn text(study: &Study, files: &[PathBuf]) -> String {
    let mut lines = Vec::new();
    for m in &study.maneuvers {
        lines.push(format!("x = {} m, z = {} m: T = {:.6} s", m.x_m, m.z_m, m.duration_s));
        lines.push(
            "    limit        value          dT/dlimit          10 % better saves   elasticity".to_owned(),
        );
        for c in &m.curves {
            let (p, here) = (c.parameter, &c.here);
            let value = p.of(&study.limits);
            lines.push(format!(
                "    {:<12} {:<14} {:<18} {:<19} {:+.4}",
                p.name(),
                format!("{value} {}", p.unit()),
                format!("{:+.3} ms/({})", here.derivative * 1e3, p.unit()),
                format!("{:.2} ms", 0.1 * value * here.derivative.abs() * 1e3),
                here.elasticity,
            ));
        }
        lines.extend(
            m.buys_most()
                .filter(|_| m.curves.len() > 1)
                .map(|c| format!("    {} buys the most", c.parameter.name())),
        );
        for c in &m.curves {
            lines.extend(missing(&c.points).map(|(count, reason)| {
                format!(
                    "    {} of {} values of {} have no maneuver; the first: {reason}",
                    count,
                    c.points.len(),
                    c.parameter.name()
                )
            }));
        }
    }
    lines.extend(files.iter().map(|f| format!("wrote {}", f.display())));
    lines.join("\n")
}

/// The study for a program.
fn summary(study: &Study, files: &[PathBuf], wall_time_s: f64) -> Value {
    let point = |p: &Point| match &p.outcome {
        Ok(found) => json!({ "value": p.value, "found": found }),
        Err(error) => json!({ "value": p.value, "error": error.to_string() }),
    };
    let curve = |c: &Curve| {
        json!({
            "parameter": c.parameter,
            "unit": c.parameter.unit(),
            "value": c.parameter.of(&study.limits),
            "here": c.here,
            "points": c.points.iter().map(point).collect::<Vec<_>>(),
        })
    };
    let maneuver = |m: &Maneuver| {
        json!({
            "x_m": m.x_m,
            "z_m": m.z_m,
            "duration_s": m.duration_s,
            "buys_most": m.buys_most().map(|c| c.parameter),
            "curves": m.curves.iter().map(curve).collect::<Vec<_>>(),
        })
    };
    json!({
        "limits": study.limits,
        "maneuvers": study.maneuvers.iter().map(maneuver).collect::<Vec<_>>(),
        "files": files,
        "wall_time_s": wall_time_s,
    })
}

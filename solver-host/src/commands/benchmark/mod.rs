//! `mintime benchmark`: the score T / T* of a flight log, of the linear controller, and its map.

mod page;

use std::error::Error;
use std::io::IsTerminal as _;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::{Args, ValueEnum};
use indicatif::{ProgressBar, ProgressStyle};
use mintime::benchmark::{
    Arrival, Gains, Goal, Grid, Rules, Score, Tolerance, map_linear, read, score, score_linear,
};
use mintime::flight_log::check_writable;
use mintime::report::{self, ReportError, benchmark as pictures};
use mintime_shared::model::GRAVITY_MPS2;

use super::fly::distinct;
use super::limits::PlanArguments;
use super::solve::write_text;
use super::{numbers, print};

/// Arguments of `mintime benchmark`.
#[derive(Args)]
#[command(
    after_help = "Examples:\n  mintime benchmark flight.mcap -o score.svg\n  mintime benchmark flight.csv --from 0,1 --to 5,6\n  \
                  mintime benchmark flight.csv --from 0,0,1 --to 3,4,6 --arrival first --json\n  \
                  mintime benchmark --controller linear --to 5,5\n  mintime benchmark --controller linear --map -o map.png"
)]
pub(crate) struct Benchmark {
    /// The flight log
    #[arg(value_name = "LOG", required_unless_present = "controller", conflicts_with = "controller")]
    log: Option<PathBuf>,
    /// Fly this controller on the planning model instead of reading a log
    #[arg(long, value_enum)]
    controller: Option<Controller>,
    /// Start in the log's world: at rest at a position in the x-z plane or in space, or a planar state with its motion. Without
    /// --from and --to: the maneuver that the log declares, or its only two hovers
    #[arg(long, value_name = "X,Z | X,Y,Z | X,VX,Z,VZ,THETA", value_parser = goal, allow_hyphen_values = true,
          requires = "to", conflicts_with = "controller")]
    from: Option<Goal>,
    /// End, likewise; of a controller the displacement from rest to rest
    #[arg(long, value_name = "X,Z | X,Y,Z | X,VX,Z,VZ,THETA", value_parser = goal, allow_hyphen_values = true)]
    to: Option<Goal>,
    /// Look only at this part of the log, s by its own clock
    #[arg(long, value_name = "T0,T1", value_parser = numbers::list::<2>, allow_hyphen_values = true,
          conflicts_with = "controller")]
    between: Option<[f64; 2]>,
    #[command(flatten)]
    measure: Measure,
    /// Gains of the linear controller: natural frequency (rad/s) and damping ratio of the horizontal loop, the same of the
    /// vertical loop, pitch gain (1/s), largest pitch (rad)
    #[arg(long, value_name = "WX,DX,WZ,DZ,K,PITCH", value_parser = numbers::list::<6>, allow_hyphen_values = true,
          requires = "controller")]
    gains: Option<[f64; 6]>,
    /// Map the controller's score over displacements from rest to rest
    #[arg(long, requires_all = ["controller", "output"], conflicts_with = "to")]
    map: bool,
    /// First and last x of the map, m
    #[arg(long, value_name = "FIRST,LAST", value_parser = numbers::list::<2>, allow_hyphen_values = true,
          default_value = "0,15")]
    x: [f64; 2],
    /// First and last z of the map, m
    #[arg(long, value_name = "FIRST,LAST", value_parser = numbers::list::<2>, allow_hyphen_values = true,
          default_value = "-8,8")]
    z: [f64; 2],
    /// Points of the map along x and z
    #[arg(long, value_name = "NX,NZ", value_parser = numbers::list::<2>, default_value = "61,65")]
    points: [f64; 2],
    #[command(flatten)]
    plan: PlanArguments,
    /// Gravity, m/s²
    #[arg(long, value_name = "G", value_parser = numbers::finite, allow_hyphen_values = true,
          default_value_t = GRAVITY_MPS2)]
    gravity: f64,
    /// Write a picture (.svg, .png), or the numbers behind it (.csv)
    #[arg(short = 'o', long = "output", value_name = "FILE")]
    output: Option<PathBuf>,
    /// Print JSON instead of text
    #[arg(long)]
    json: bool,
}

/// Controllers that can be flown.
#[derive(Clone, Copy, ValueEnum)]
enum Controller {
    /// Linear feedback of position and velocity, pitch by a proportional law
    Linear,
}

/// What counts as being in a state, and as a flight between two.
#[derive(Args)]
struct Measure {
    /// How near counts as being at a position, m
    #[arg(long, value_name = "M", value_parser = numbers::positive, allow_hyphen_values = true, default_value = "0.05")]
    tolerance_position: f64,
    /// How near counts as having a velocity, m/s
    #[arg(long, value_name = "MPS", value_parser = numbers::positive, allow_hyphen_values = true, default_value = "0.15")]
    tolerance_velocity: f64,
    /// How near counts as having an attitude, rad
    #[arg(long, value_name = "RAD", value_parser = numbers::positive, allow_hyphen_values = true, default_value = "0.05")]
    tolerance_angle: f64,
    /// When the flight has arrived: once it stays within tolerance, or when it first is; by default `settle` for an end at
    /// rest, `first` for one in motion
    #[arg(long, value_enum)]
    arrival: Option<ArrivalChoice>,
    /// How long it must stay, and how long a hover lasts at least, s
    #[arg(long, value_name = "S", value_parser = numbers::positive, allow_hyphen_values = true, default_value = "0.3")]
    dwell: f64,
    /// Longest time without samples within the flight, s
    #[arg(long, value_name = "S", value_parser = numbers::positive, allow_hyphen_values = true, default_value = "0.1")]
    largest_gap: f64,
    /// How far a flight in space may leave the vertical plane through its two states, m
    #[arg(long, value_name = "M", value_parser = numbers::positive, allow_hyphen_values = true, default_value = "0.25")]
    out_of_plane: f64,
    /// How far motion and attitude may contradict each other: acceleration that neither the thrust in the
    /// plane nor drag explains, m/s² rms
    #[arg(long, value_name = "MPS2", value_parser = numbers::positive, allow_hyphen_values = true, default_value = "6")]
    across: f64,
}

#[derive(Clone, Copy, ValueEnum)]
enum ArrivalChoice {
    /// It stays within tolerance for --dwell
    Settle,
    /// It is within tolerance
    First,
}

/// Parses a state of a log: a position in the x-z plane or in space to be at rest at, or a planar state.
fn goal(text: &str) -> Result<Goal, String> {
    match text.split(',').count() {
        2 => numbers::list(text).map(|[x, z]| Goal::hover([x, 0.0, z])),
        3 => numbers::list(text).map(Goal::hover),
        5 => numbers::state(text).map(Goal::planar),
        count => Err(format!("2, 3 or 5 numbers separated by commas are needed, {count} were given")),
    }
}

/// Most points of a map: beyond it a typing error is likelier than patience.
const MOST_POINTS: f64 = 1.0e5;

impl Benchmark {
    pub(crate) fn run(self) -> ExitCode {
        self.answer().unwrap_or_else(|error| {
            if self.json {
                print(&serde_json::json!({ "error": error.to_string() }).to_string());
            }
            eprintln!("mintime: {error}");
            ExitCode::FAILURE
        })
    }

    fn answer(&self) -> Result<ExitCode, Box<dyn Error>> {
        if distinct([self.log.as_ref(), self.output.as_ref()]).is_err() {
            return Err("the output would replace the log: give it a name of its own".into());
        }
        if let Some(path) = &self.output {
            if is_csv(path) { check_writable(path)? } else { report::check(path)? }
        }
        let rules = self.rules();
        rules.validate()?;
        match (&self.log, self.controller) {
            (Some(path), _) => {
                let mut flight = read(path)?;
                if let Some([from_s, to_s]) = self.between {
                    flight = flight.window(from_s, to_s)?;
                }
                let name = path.file_name().unwrap_or(path.as_os_str()).to_string_lossy();
                let score = score(&flight, self.from.zip(self.to), &rules).inspect_err(|_| {
                    // What the reader met may be why there is no score.
                    flight.remarks.iter().for_each(|remark| eprintln!("mintime: note: {remark}"));
                })?;
                Ok(self.show(&score, &name, None))
            }
            (None, Some(Controller::Linear)) if self.map => self.map(&rules),
            (None, _) => {
                let gains = self.gains();
                let Some([x_m, z_m]) = self.to.and_then(|to| to.planar_rest()) else {
                    return Err(
                        "a controller needs --to X,Z, a displacement from rest to rest, or --map".into()
                    );
                };
                let score = score_linear(&gains, &rules, x_m, z_m)?;
                Ok(self.show(&score, "linear controller", Some(&gains)))
            }
        }
    }

    fn rules(&self) -> Rules {
        let measure = &self.measure;
        Rules {
            limits: self.plan.limits(self.gravity),
            turns: self.plan.turns,
            tolerance: Tolerance {
                position_m: measure.tolerance_position,
                velocity_mps: measure.tolerance_velocity,
                angle_rad: measure.tolerance_angle,
            },
            arrival: measure.arrival.map(|choice| match choice {
                ArrivalChoice::Settle => Arrival::Settle(measure.dwell),
                ArrivalChoice::First => Arrival::First,
            }),
            dwell_s: measure.dwell,
            largest_gap_s: measure.largest_gap,
            out_of_plane_m: measure.out_of_plane,
            across_mps2: measure.across,
        }
    }

    fn gains(&self) -> Gains {
        self.gains.map_or_else(Gains::default, |[wx, dx, wz, dz, k, pitch]| Gains {
            horizontal_radps: wx,
            horizontal_damping: dx,
            vertical_radps: wz,
            vertical_damping: dz,
            pitch_per_s: k,
            pitch_max_rad: pitch,
        })
    }

    fn show(&self, score: &Score, name: &str, gains: Option<&Gains>) -> ExitCode {
        let written = self.write(
            || page::csv(score),
            |path| {
                let title = format!("{name}: T / T* = {:.3}", score.score);
                pictures::write_score(score, &title, &[page::subtitle(score)], path)
            },
        );
        let output = self.output.as_deref().filter(|_| written.is_ok());
        print(&if self.json {
            format!("{:#}", page::json(score, self.log.as_deref(), gains, output))
        } else {
            page::text(score, output)
        });
        told(written)
    }

    /// Writes the output, if one was asked for: what it is asked for decides the ending.
    fn write(
        &self,
        csv: impl Fn() -> String,
        picture: impl Fn(&Path) -> Result<(), ReportError>,
    ) -> Result<(), Box<dyn Error>> {
        match &self.output {
            Some(path) if is_csv(path) => Ok(write_text(path, &csv())?),
            Some(path) => Ok(picture(path)?),
            None => Ok(()),
        }
    }

    fn map(&self, rules: &Rules) -> Result<ExitCode, Box<dyn Error>> {
        let [nx, nz] = self.points;
        if nx < 1.0 || nz < 1.0 || nx.fract() != 0.0 || nz.fract() != 0.0 || nx * nz > MOST_POINTS {
            return Err(
                "--points needs two whole numbers above zero, a hundred thousand points at most".into()
            );
        }
        if self.x[0] > self.x[1] || self.z[0] > self.z[1] {
            return Err("--x and --z need their lower end first".into());
        }
        let gains = self.gains();
        let grid = Grid::even(self.x, self.z, [nx as usize, nz as usize]);
        let bar = ProgressBar::new(grid.len() as u64);
        if !std::io::stderr().is_terminal() {
            bar.set_draw_target(indicatif::ProgressDrawTarget::hidden());
        }
        if let Ok(style) = ProgressStyle::with_template("{bar:40} {pos}/{len} points, {eta} left") {
            bar.set_style(style);
        }
        let clock = std::time::Instant::now();
        let map = map_linear(&gains, rules, grid, |done| bar.inc(done as u64))?;
        let wall_time_s = clock.elapsed().as_secs_f64();
        bar.finish_and_clear();
        let summary = page::MapSummary::new(&map, wall_time_s);
        let written = self.write(
            || map.csv(),
            |path| {
                let title = "Linear feedback against the fastest maneuver, from rest to rest";
                pictures::write_map(&map, title, &page::map_subtitle(&gains, rules, &summary), path)
            },
        );
        let output = self.output.as_deref().filter(|_| written.is_ok());
        print(&if self.json { format!("{:#}", summary.json(&gains, output)) } else { summary.text(output) });
        let kept = told(written);
        if summary.failed > 0 {
            eprintln!("mintime: {} points have no score; in a .csv their lines say why", summary.failed);
            return Ok(ExitCode::FAILURE);
        }
        Ok(kept)
    }
}

fn is_csv(path: &Path) -> bool {
    path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("csv"))
}

/// Tells what could not be written, after the answer.
fn told(written: Result<(), Box<dyn Error>>) -> ExitCode {
    match written {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("mintime: {error}");
            ExitCode::FAILURE
        }
    }
}

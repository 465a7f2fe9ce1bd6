//! `mintime learn-statistics`: how well learning works, over many simulated vehicles.

use std::error::Error;
use std::path::PathBuf;
use std::process::ExitCode;

use clap::Args;
use mintime::flight_log::check_writable;
use mintime::learning::{
    ANGLE_TOLERANCE_RAD, Budget, Case, DURATION_MAX, MANEUVERS, POSITION_TOLERANCE_M, StatisticsPlan,
    THRUST_ERROR, VELOCITY_TOLERANCE_MPS, statistics,
};
use mintime::mission::VehicleChoice;
use serde_json::json;

use super::fly::{VehicleKind, firmware};
use super::print;
use super::progress::Progress;
use super::solve::write_bytes;

/// Arguments of `mintime learn-statistics`.
#[derive(Args)]
#[command(
    after_help = "Examples:\n  mintime learn-statistics --vehicle hosted\n  mintime learn-statistics --vehicle virtual \
                        --vehicles 4 --scatter 0 --gradient 0 -o learning.json"
)]
pub(crate) struct LearnStatistics {
    /// What flies: `hosted` or `virtual`
    #[arg(long, value_name = "virtual|hosted", default_value = "hosted")]
    vehicle: VehicleKind,
    /// Number of vehicles; their seeds are 1, 2, 3 and so on, their thrust evenly spread
    #[arg(long, value_name = "N", default_value_t = 20, value_parser = clap::value_parser!(u32).range(1..=1000))]
    vehicles: u32,
    /// Flights that teach, at most
    #[arg(long, value_name = "N", default_value_t = 10, value_parser = clap::value_parser!(u32).range(1..=200))]
    flights: u32,
    /// Flights of what was learned
    #[arg(long, value_name = "N", default_value_t = 5, value_parser = clap::value_parser!(u32).range(1..=200))]
    repeats: u32,
    /// Identical flights, to see what scatters; 0 for none
    #[arg(long, value_name = "N", default_value_t = 10, value_parser = clap::value_parser!(u32).range(0..=200))]
    scatter: u32,
    /// Flights of each of the two plain rules that learning is compared with, at most; 0 for none
    #[arg(long, value_name = "N", default_value_t = 20, value_parser = clap::value_parser!(u32).range(0..=200))]
    gradient: u32,
    /// Vehicles that learn at the same time
    #[arg(long, value_name = "N", default_value_t = 2, value_parser = clap::value_parser!(u32).range(1..=64))]
    threads: u32,
    /// The image that the virtual flight controller runs; built from the sources if not given
    #[arg(long, value_name = "FILE.elf")]
    firmware: Option<PathBuf>,
    /// Write everything, flight by flight, to this file
    #[arg(short, long, value_name = "FILE.json")]
    output: Option<PathBuf>,
    /// Print JSON instead of text
    #[arg(long)]
    json: bool,
}

impl LearnStatistics {
    pub(crate) fn run(self) -> ExitCode {
        match self.fly() {
            Ok(()) => ExitCode::SUCCESS,
            Err(error) => {
                if self.json {
                    print(&json!({ "error": error.to_string() }).to_string());
                }
                eprintln!("mintime: {error}");
                ExitCode::FAILURE
            }
        }
    }

    fn fly(&self) -> Result<(), Box<dyn Error>> {
        self.output.as_deref().map(check_writable).transpose()?;
        let progress = Progress::new();
        let choice = match (&self.vehicle, &self.firmware) {
            (VehicleKind::Hosted, None) => VehicleChoice::Hosted,
            (VehicleKind::Virtual, path) => {
                let image = firmware(path.as_deref(), &progress)?;
                VehicleChoice::Virtual { image, both_timings: false }
            }
            (VehicleKind::Hosted, Some(_)) => {
                return Err("the hosted vehicle runs no image: leave out --firmware".into());
            }
            (VehicleKind::Port(_), _) => {
                return Err("statistics are made with simulated vehicles: give `hosted` or `virtual`".into());
            }
        };
        let plan = StatisticsPlan {
            choice,
            vehicles: self.vehicles,
            budget: Budget { flights: self.flights, repeats: self.repeats },
            scatter: self.scatter,
            gradient_flights: self.gradient,
            threads: self.threads,
        };
        let voice = progress.voice();
        progress.say("learning");
        let cases = statistics(&plan, |case| voice.line(&line(case)));
        progress.finish();
        if let Some(path) = &self.output {
            write_bytes(path, format!("{:#}\n", json!(cases)).as_bytes())?;
        }
        if self.json {
            print(&format!("{:#}", json!({ "cases": cases, "maneuvers": summaries(&cases) })));
        } else {
            print(&table(&cases));
        }
        Ok(())
    }
}

/// One case on one line.
fn line(case: &Case) -> String {
    let flights = case.history.as_ref().map_or(0, |h| h.flights.len());
    let [position_m, velocity_mps, angle_rad] = case.mean.unwrap_or([f64::NAN; 3]);
    let [distance_m, speed_mps] = case.mean_in_space.unwrap_or([f64::NAN; 2]);
    format!(
        "{}, vehicle {:2} (thrust {:.3}): {} after {flights} flights, T/T* {:.3}, repeats {position_m:.4} m, \
         {velocity_mps:.4} m/s, {angle_rad:.4} rad, in space {distance_m:.4} m, {speed_mps:.4} m/s; {}",
        case.maneuver,
        case.seed,
        case.strength,
        if case.success { "good" } else { "NOT GOOD" },
        case.duration_ratio().unwrap_or(f64::NAN),
        case.reason
    )
}

/// What the cases of one maneuver have in common.
#[derive(serde::Serialize)]
struct Summary {
    maneuver: &'static str,
    vehicles: usize,
    good: usize,
    /// Good in space, too.
    good_in_space: usize,
    /// Median and most flights until learning ended.
    flights: [f64; 2],
    /// Median and most flights until one ended within the tolerances; infinite where none did.
    first_within: [f64; 2],
    /// Greatest over the vehicles of the repeats' mean distance, speed and angle.
    worst_mean: [f64; 3],
    /// The same of distance and speed in space.
    worst_in_space: [f64; 2],
    /// Root of the mean square over the vehicles of the scatter's distance, speed and angle.
    scatter: Option<[f64; 3]>,
    /// Greatest duration over the optimum.
    duration_ratio: f64,
    /// Vehicles that plain policy gradient brings within the tolerances, and its median of the least error, in tolerances.
    gradient: Option<(usize, f64)>,
    /// The same for steps by the ideal model's inverse, with the median of the flights needed.
    inverse: Option<(usize, f64)>,
}

fn summaries(cases: &[Case]) -> Vec<Summary> {
    MANEUVERS.iter().map(|maneuver| summary(maneuver.2, cases)).collect()
}

fn summary(maneuver: &'static str, cases: &[Case]) -> Summary {
    let cases: Vec<&Case> = cases.iter().filter(|case| case.maneuver == maneuver).collect();
    let histories = || cases.iter().filter_map(|case| case.history.as_ref());
    let first = |h: &mintime::learning::History| {
        let within =
            |f: &mintime::learning::FlightEntry| f.final_error.is_some_and(|e| e.in_tolerances() <= 1.0);
        h.flights.iter().position(within).map_or(f64::INFINITY, |i| (i + 1) as f64)
    };
    let worst = |i: usize| cases.iter().map(|c| c.mean.map_or(f64::INFINITY, |m| m[i])).fold(0.0, f64::max);
    let scatters: Vec<[f64; 3]> = cases.iter().filter_map(|case| case.scatter).collect();
    let rms = |i: usize| (scatters.iter().map(|s| s[i] * s[i]).sum::<f64>() / scatters.len() as f64).sqrt();
    let gradients: Vec<_> = cases.iter().filter_map(|case| case.gradient.as_ref()).collect();
    let inverses: Vec<_> = cases.iter().filter_map(|case| case.inverse.as_ref()).collect();
    let arrived =
        |rules: &[&mintime::learning::RuleResult]| rules.iter().filter(|r| r.flights.is_some()).count();
    Summary {
        maneuver,
        vehicles: cases.len(),
        good: cases.iter().filter(|case| case.success).count(),
        good_in_space: cases.iter().filter(|case| case.success_in_space).count(),
        flights: median_and_most(histories().map(|h| h.flights.len() as f64).collect()),
        first_within: median_and_most(histories().map(first).collect()),
        worst_mean: [worst(0), worst(1), worst(2)],
        worst_in_space: [0, 1].map(|i| {
            cases.iter().map(|c| c.mean_in_space.map_or(f64::INFINITY, |m| m[i])).fold(0.0, f64::max)
        }),
        scatter: (!scatters.is_empty()).then(|| [rms(0), rms(1), rms(2)]),
        duration_ratio: cases.iter().filter_map(|c| c.duration_ratio()).fold(0.0, f64::max),
        gradient: (!gradients.is_empty())
            .then(|| (arrived(&gradients), median_and_most(gradients.iter().map(|g| g.best).collect())[0])),
        inverse: (!inverses.is_empty()).then(|| {
            let needed = |r: &&mintime::learning::RuleResult| r.flights.map_or(f64::INFINITY, f64::from);
            (arrived(&inverses), median_and_most(inverses.iter().map(needed).collect())[0])
        }),
    }
}

fn median_and_most(mut values: Vec<f64>) -> [f64; 2] {
    values.sort_by(f64::total_cmp);
    let at = |i: usize| values.get(i).copied().unwrap_or(f64::NAN);
    [at(values.len() / 2), at(values.len().saturating_sub(1))]
}

/// The page for a person, in Markdown.
fn table(cases: &[Case]) -> String {
    let mut lines = vec![
        format!(
            "Thrust ± {:.0} %; good: mean of the repeats within {POSITION_TOLERANCE_M} m, {VELOCITY_TOLERANCE_MPS} m/s, \
             {ANGLE_TOLERANCE_RAD} rad, and T at most {DURATION_MAX} T*. Flights: median, most.",
            THRUST_ERROR * 100.0
        ),
        String::new(),
        "| maneuver | good | in space, too | flights until learned | until first within | worst mean of the repeats | in space | scatter, rms | \
         T/T* at most | policy gradient | fixed inverse |"
            .to_owned(),
        "|---|---|---|---|---|---|---|---|---|---|---|".to_owned(),
    ];
    // Infinite where none arrived.
    let count = |flights: f64| if flights.is_finite() { format!("{flights}") } else { "never".to_owned() };
    let three = |[p, v, a]: [f64; 3]| format!("{:.1} cm, {v:.3} m/s, {a:.4} rad", p * 100.0);
    for s in summaries(cases) {
        lines.push(format!(
            "| {} | {} of {} | {} | {}, {} | {}, {} | {} | {:.1} cm, {:.3} m/s | {} | {:.3} | {} | {} |",
            s.maneuver,
            s.good,
            s.vehicles,
            s.good_in_space,
            count(s.flights[0]),
            count(s.flights[1]),
            count(s.first_within[0]),
            count(s.first_within[1]),
            three(s.worst_mean),
            s.worst_in_space[0] * 100.0,
            s.worst_in_space[1],
            s.scatter.map_or_else(|| "–".to_owned(), three),
            s.duration_ratio,
            s.gradient.map_or_else(
                || "–".to_owned(),
                |(n, best)| format!("{n} of {}; best {best:.1} tolerances", s.vehicles)
            ),
            s.inverse.map_or_else(
                || "–".to_owned(),
                |(n, f)| format!("{n} of {}; {} flights", s.vehicles, count(f))
            ),
        ));
    }
    lines.join("\n")
}

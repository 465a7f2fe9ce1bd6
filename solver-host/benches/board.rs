//! How fast the virtual board runs: whole flights of the firmware image in closed loop, with pessimistic timing of the
//! processor on one core, and with both timings beside each other on two.
//!
//! `cargo bench -p mintime --bench board`; with `--profile dev` as `cargo test` and `cargo run` build it.

use mintime::firmware_image::FirmwareImage;
use mintime::flight::{Phase, Witness};
use mintime::mission::{Mission, PlantChoice, Source, VehicleChoice, fly_mission, prepare};
use mintime::solver::Turns;
use mintime_shared::model::{Limits, State};

/// Flights of each kind.
const FLIGHTS: usize = 5;
/// Control ticks a second.
const TICKS_HZ: f64 = 800.0;

struct Unseen;

impl Witness for Unseen {
    fn phase(&mut self, _: Phase, _: f64) {}
    fn event(&mut self, _: f64, _: &str) {}
}

fn median(mut of: Vec<f64>) -> f64 {
    of.sort_by(f64::total_cmp);
    of.get(of.len() / 2).copied().unwrap_or(f64::NAN)
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let image = FirmwareImage::build(&mut |what| eprintln!("{what}"))?;
    let source = Source::Solve {
        to: State::at_rest(5.0, 5.0),
        limits: Limits::TABLE_I,
        turns: Turns::Any,
        heading_rad: 0.0,
    };
    let plant = PlantChoice::from_argument("nominal")?;
    let mission = Mission { source, plant, seed: 1, room: None };
    for both_timings in [false, true] {
        let vehicle = VehicleChoice::Virtual { image: image.clone(), both_timings };
        let (mut factors, mut rates) = (Vec::new(), Vec::new());
        for _ in 0..FLIGHTS {
            let prepared = prepare(&mission.source, None)?;
            let flown = fly_mission(&mission, prepared, &vehicle, &mut Unseen)?;
            let emulated = flown.emulated.ok_or("not emulated")?;
            factors.push(emulated.real_time_factor);
            rates.push(emulated.real_time_factor * TICKS_HZ * emulated.board.tick_instructions * 1e-6);
        }
        let what = if both_timings { "both timings, two cores" } else { "one timing, one core" };
        println!("{what}: {factors:.1?} times real time");
        println!(
            "{what}: median {:.1} times real time, {:.0} million emulated instructions a second",
            median(factors),
            median(rates)
        );
    }
    Ok(())
}

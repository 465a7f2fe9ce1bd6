//! How fast the virtual board runs: one flight of the firmware image on one core, with pessimistic timing of the processor.
//!
//! `cargo bench -p mintime --bench board`

use mintime::firmware_image::FirmwareImage;
use mintime::flight::{Phase, Witness};
use mintime::mission::{Mission, PlantChoice, Source, VehicleChoice, fly_mission, prepare};
use mintime::solver::Turns;
use mintime_shared::model::{Limits, State};

/// Flights; the fastest counts, for others may use the machine too.
const FLIGHTS: usize = 5;
/// Control ticks a second.
const TICKS_HZ: f64 = 800.0;

struct Unseen;

impl Witness for Unseen {
    fn phase(&mut self, _: Phase, _: f64) {}
    fn event(&mut self, _: f64, _: &str) {}
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let image = FirmwareImage::build(&mut |what| eprintln!("{what}"))?;
    let vehicle = VehicleChoice::Virtual { image, both_timings: false };
    let source = Source::Solve {
        to: State::at_rest(5.0, 5.0),
        limits: Limits::TABLE_I,
        turns: Turns::Any,
        heading_rad: 0.0,
    };
    let plant = PlantChoice::from_argument("nominal")?;
    let mission = Mission { source, plant, seed: 1, room: None };
    let mut best: Option<(f64, f64)> = None;
    for _ in 0..FLIGHTS {
        let prepared = prepare(&mission.source, None)?;
        let flown = fly_mission(&mission, prepared, &vehicle, &mut Unseen)?;
        let emulated = flown.emulated.ok_or("not emulated")?;
        let (factor, instructions) = (emulated.real_time_factor, emulated.board.tick_instructions);
        println!("{:.1} s of flight, {factor:.1} times real time", flown.virtual_time_s);
        if best.is_none_or(|(fastest, _)| factor > fastest) {
            best = Some((factor, factor * TICKS_HZ * instructions));
        }
    }
    if let Some((factor, rate)) = best {
        println!(
            "best: {factor:.1} times real time, {:.0} million emulated instructions a second",
            rate * 1e-6
        );
    }
    Ok(())
}

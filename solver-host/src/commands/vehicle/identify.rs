//! What a vehicle is, from how it flies.

use std::error::Error;
use std::io::BufRead as _;
use std::path::{Path, PathBuf};

use clap::Args;
use emulator::core::Timing;
use mintime::flight::{HopFlight, HopPlan, HostedVehicle, Scene, VirtualVehicle, fly_hops};
use mintime::flight_log::check_writable;
use mintime::identification::{self, Identified, identify};
use mintime::mission::{PlantChoice, Room};
use mintime::vehicle::{LiveOptions, PortLink, Session, read_key};
use mintime_shared::vehicle::VehicleConfig;
use serde_json::{Value, json};

use super::super::fly::firmware;
use super::super::live::MocapArguments;
use super::super::numbers;
use super::super::progress::Progress;
use super::super::solve::write_bytes;
use super::{Said, keep, to_json};

/// What a person has to type before the vehicle is told.
const SENTENCE: &str = "write it";

/// Arguments of `identify`.
#[derive(Args)]
#[command(
    after_help = "The vehicle takes off where it stands, hovers, makes short hops and lands; it needs half a meter around its \
                  hover and calm air. Try it first: `mintime vehicle hosted identify`.\n\nExamples:\n  mintime vehicle hosted \
                  identify --seed 3\n  mintime vehicle /dev/ttyUSB0 identify --mocap udp:0.0.0.0:5005 --room \
                  -1,1,-1,1,-1.2,1 -o quad.json --apply"
)]
pub(super) struct Identify {
    #[command(flatten)]
    eyes: MocapArguments,
    /// Free space around the point of the hover, m; the hover is above the vehicle by -ZMIN. Needed for a real vehicle
    #[arg(long, value_name = "XMIN,XMAX,YMIN,YMAX,ZMIN,ZMAX", value_parser = numbers::room, allow_hyphen_values = true)]
    room: Option<Room>,
    /// Height of the hover, m, where no --room says it
    #[arg(long, value_name = "M", default_value_t = 1.2, conflicts_with = "room")]
    height: f64,
    /// Length of the hover, s
    #[arg(long, value_name = "S", default_value_t = 8.0)]
    hover: f64,
    /// Number of hops
    #[arg(long, value_name = "N", default_value_t = 12)]
    hops: u32,
    /// Height of the thrust steps, m/s²
    #[arg(long, value_name = "M/S2", default_value_t = 2.0)]
    step: f64,
    /// Write the corrected vehicle file here
    #[arg(short, long, value_name = "FILE.json")]
    output: Option<PathBuf>,
    /// Write it to the vehicle, after asking
    #[arg(long)]
    apply: bool,
    /// The vehicle file that a simulated vehicle is told; the reference vehicle's if not given
    #[arg(long, value_name = "FILE.json")]
    file: Option<PathBuf>,
    /// The simulated airframe: `nominal`, or a TOML file (see docs/vehicles.md)
    #[arg(long, value_name = "nominal|FILE.toml", default_value = "nominal")]
    plant: String,
    /// Seed of everything random in the simulation
    #[arg(long, default_value_t = 1)]
    seed: u64,
    /// The image that the virtual flight controller runs; built from the sources if not given
    #[arg(long, value_name = "FILE.elf")]
    firmware: Option<PathBuf>,
}

impl Identify {
    pub(super) fn run(&self, port: &str, key: Option<&Path>) -> Said {
        // Everything that can be refused is refused before anything flies.
        self.output.as_deref().map(check_writable).transpose()?;
        let height_m = self.room.map_or(self.height, |room| -room.z_m.0);
        let plan = HopPlan {
            height_m,
            hover_s: self.hover,
            hops: self.hops,
            step_mps2: self.step,
            ..HopPlan::default()
        };
        identification::check(&plan, self.room.as_ref())?;
        let mut progress = Progress::new();
        let outcome = match port {
            "hosted" | "virtual" => self.simulated(port, &plan, &mut progress),
            _ => self.real(port, key, &plan, &mut progress),
        };
        progress.finish();
        let (found, session) = outcome?;
        let file = to_json(&found.vehicle)?;
        if let Some(path) = &self.output {
            write_bytes(path, format!("{file:#}\n").as_bytes())?;
        }
        let applied = match session {
            Some(mut session) if self.apply => {
                confirm(&found)?;
                session.set_vehicle(&found.vehicle)?;
                true
            }
            _ => false,
        };
        Ok((self.value(&found, file, applied), self.text(&found, applied)))
    }

    fn simulated(&self, kind: &str, plan: &HopPlan, progress: &mut Progress) -> Flown {
        if self.eyes.are_given() {
            return Err("--mocap is for a real vehicle: a simulated one brings its own cameras".into());
        }
        if self.apply {
            return Err(
                "a simulated vehicle is gone after the flight: keep what is found with -o FILE.json".into()
            );
        }
        let told = match &self.file {
            Some(path) => serde_json::from_value(keep::read_json(path)?)
                .map_err(|e| format!("{}: not a vehicle file: {e}", path.display()))?,
            None => VehicleConfig::REFERENCE,
        };
        told.check()?;
        let plan = HopPlan { vehicle: Some(told), ..*plan };
        let plant = PlantChoice::from_argument(&self.plant)?;
        let scene = Scene {
            parameters: &plant.parameters,
            seed: self.seed,
            ground_z_m: 0.0,
            heading_rad: 0.0,
            maneuver_s: 0.0,
        };
        let flight: HopFlight = if kind == "hosted" {
            if self.firmware.is_some() {
                return Err("the hosted vehicle runs no image: leave out --firmware, or use `virtual`".into());
            }
            fly_hops(&mut HostedVehicle::told(&scene, &told)?, &plan, progress)?
        } else {
            let image = firmware(self.firmware.as_deref(), progress)?;
            fly_hops(&mut VirtualVehicle::new(&scene, image.elf(), Timing::Pessimistic)?, &plan, progress)?
        };
        Ok((identify(&flight, &told)?, None))
    }

    fn real(&self, port: &str, key: Option<&Path>, plan: &HopPlan, progress: &mut Progress) -> Flown {
        if self.firmware.is_some() || self.file.is_some() {
            return Err(
                "a real vehicle has its firmware and its file already: leave out --firmware and --file"
                    .into(),
            );
        }
        let room = self.eyes.check(self.room)?;
        let key = key.map(read_key).transpose()?;
        let mut session = Session::begin(PortLink::open(port)?, key)?;
        let file = session.vehicle()?.ok_or(
            "the vehicle does not know what it is: write a first file with `mintime vehicle PORT params --file`, as near \
             as you know it; what is found corrects it",
        )?;
        let options = LiveOptions { key, ..LiveOptions::default() };
        let mut watched = self.eyes.watch(session.into_link(), options, &room)?;
        let flight = fly_hops(&mut watched.vehicle, plan, progress);
        let link = watched.into_link();
        let found = identify(&flight?, &file)?;
        let session = if self.apply { Some(Session::begin(link, key)?) } else { None };
        Ok((found, session))
    }

    fn value(&self, found: &Identified, vehicle: Value, applied: bool) -> Value {
        json!({
            "thrust_scale": found.thrust_scale,
            "thrust_scale_std": found.thrust_scale_std,
            "step_scale": found.step_scale,
            "step_scale_std": found.step_scale_std,
            "lag_s": found.lag_s,
            "lag_std_s": found.lag_std_s,
            "dead_time_s": found.dead_time_s,
            "dead_time_std_s": found.dead_time_std_s,
            "response_s": found.response_s,
            "damping_per_s": found.damping_per_s,
            "sag_v_per_n": found.sag_v_per_n.map(|(sag, _)| sag),
            "sag_std_v_per_n": found.sag_v_per_n.map(|(_, std)| std),
            "residual_m": found.residual_m,
            "hover_s": found.hover_s,
            "hops": found.hops,
            "poses": found.poses,
            "vehicle": vehicle,
            "file": self.output,
            "applied": applied,
        })
    }

    fn text(&self, found: &Identified, applied: bool) -> String {
        let ms = |s: f64| s * 1e3;
        let mut lines = vec![
            format!(
                "thrust      {:.4} ± {:.4} of what the vehicle file says, in hover; {:.3} ± {:.3} of each change",
                found.thrust_scale, found.thrust_scale_std, found.step_scale, found.step_scale_std
            ),
            format!(
                "rotor lag   {:.1} ± {:.1} ms; behind the firmware's lead {:.1} ms are left of it",
                ms(found.lag_s),
                ms(found.lag_std_s),
                ms(found.response_s)
            ),
            format!("dead time   {:.1} ± {:.1} ms", ms(found.dead_time_s), ms(found.dead_time_std_s)),
            match found.sag_v_per_n {
                Some((sag, std)) => format!("battery sag {sag:.4} ± {std:.4} V/N"),
                None => "battery sag not seen".to_owned(),
            },
            format!(
                "measured    {:.0} s of hover, {} hops, {} poses; the model leaves {:.2} mm",
                found.hover_s,
                found.hops,
                found.poses,
                found.residual_m * 1e3
            ),
            format!(
                "vehicle     rotor_thrust_max_n {:.3}, rotor_lag_s {:.4}, sag_v_per_n {:.4}",
                found.vehicle.rotor_thrust_max_n, found.vehicle.rotor_lag_s, found.vehicle.sag_v_per_n
            ),
        ];
        if (found.step_scale - found.thrust_scale).abs() > 0.05 + 3.0 * found.step_scale_std {
            lines.push(
                "mind        changes of thrust have another scale than thrust itself: thrust_linear_share in the vehicle file \
                 may be wrong"
                    .to_owned(),
            );
        }
        lines.extend(self.output.as_ref().map(|path| format!("wrote       {}", path.display())));
        if applied {
            lines.push(
                "applied     the vehicle knows it now; tables made for it before are refused".to_owned(),
            );
        }
        lines.join("\n")
    }
}

/// What was found, and the vehicle to tell it to.
type Flown = Result<(Identified, Option<Session<PortLink>>), Box<dyn Error>>;

/// Asks a person.
fn confirm(found: &Identified) -> Result<(), Box<dyn Error>> {
    eprintln!(
        "mintime: rotor_thrust_max_n {:.3}, rotor_lag_s {:.4}, sag_v_per_n {:.4}: to tell the vehicle, type: {SENTENCE}",
        found.vehicle.rotor_thrust_max_n, found.vehicle.rotor_lag_s, found.vehicle.sag_v_per_n
    );
    let mut line = String::new();
    std::io::stdin().lock().read_line(&mut line)?;
    if line.trim() == SENTENCE {
        return Ok(());
    }
    Err(format!("the vehicle keeps its file: that was not \"{SENTENCE}\"").into())
}

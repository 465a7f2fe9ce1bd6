//! `mintime learn`: from flight to flight towards the planned end.

mod real;
mod words;

use std::error::Error;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::Args;
use mintime::flight::HopPlan;
use mintime::flight::fly_hops;
use mintime::identification::{self, identify};
use mintime::learning::{
    Budget, Flyer, History, HistoryError, IdentifiedResponse, Learned, LearningPlan, Observer, PlanError,
    Response, SimulatedFlyer, SimulatedVehicle, Target, check_folder, hop_plan, keep_old, plan,
};
use mintime::mission::{Flown, Mission, PlantChoice, Room, Source, VehicleChoice, check_plant, prepare_for};
use mintime::page::{self, Page, Sources};
use mintime_shared::model::{GRAVITY_MPS2, Limits, State};
use mintime_shared::table::{MAX_TABLE_BYTES, ManeuverTable};
use mintime_shared::vehicle::VehicleConfig;
use serde_json::json;

use super::fly::{VehicleKind, firmware};
use super::limits::PlanArguments;
use super::live::LiveArguments;
use super::numbers::{self, Displacement};
use super::print;
use super::progress::{Progress, Voice};
use super::recording;
use super::table::read_bytes;
use real::RealFlyer;

/// Name of the page in the campaign's folder.
const PAGE_FILE: &str = "learning.html";

/// Arguments of `mintime learn`.
#[derive(Args)]
#[command(
    after_help = "Examples:\n  mintime learn --to 5,5 --vehicle hosted\n  mintime learn --to 0,4 --flights 8 --seed 3 --json\n  \
                        mintime learn --to learned/5-5-virtual/best.table\n  mintime learn --to 2,1,1 --vehicle /dev/ttyUSB0 \
                        --mocap udp:0.0.0.0:5005 --room -4,6,-4,4,-3,6"
)]
pub(crate) struct Learn {
    /// What to learn: a displacement, m, ahead and up or ahead, to the left and up; or a table file, to learn it or to go on
    /// learning it
    #[arg(long, value_name = "X,Z|X,Y,Z|TABLE", allow_hyphen_values = true)]
    to: String,
    #[command(flatten)]
    plan: PlanArguments,
    /// What flies: `virtual` (the firmware image on an emulated flight controller), `hosted` (the flight logic in this process,
    /// twenty times as fast), or the port of a real vehicle: a serial device, tcp:HOST:PORT or udp:HOST:PORT
    #[arg(long, value_name = "virtual|hosted|PORT", default_value = "virtual")]
    vehicle: VehicleKind,
    /// Flights that teach, at most
    #[arg(long, value_name = "N", default_value_t = 10, value_parser = clap::value_parser!(u32).range(1..=200))]
    flights: u32,
    /// Flights of what was learned
    #[arg(long, value_name = "N", default_value_t = 5, value_parser = clap::value_parser!(u32).range(0..=200))]
    repeats: u32,
    #[command(flatten)]
    live: LiveArguments,
    /// The image that the virtual flight controller runs; built from the sources if not given
    #[arg(long, value_name = "FILE.elf")]
    firmware: Option<PathBuf>,
    /// The simulated airframe: `nominal`, `ideal`, or a TOML file (see docs/vehicles.md)
    #[arg(long, value_name = "ideal|nominal|FILE.toml", default_value = "nominal")]
    plant: String,
    /// Seed of the simulated vehicle's errors; the noise of each flight comes from the flight's number, too
    #[arg(long, default_value_t = 1)]
    seed: u64,
    /// Free space around the start, m; ZMIN is the floor. See `mintime fly --help`. Needed for a real vehicle
    #[arg(long, value_name = "XMIN,XMAX[,YMIN,YMAX],ZMIN,ZMAX", value_parser = numbers::room, allow_hyphen_values = true)]
    room: Option<Room>,
    /// Where to keep the history and the best table, after every flight; learned/MANEUVER-VEHICLE if not given
    #[arg(short, long, value_name = "FOLDER")]
    output: Option<PathBuf>,
    /// Where to write the page to look at in a browser: the learning curve, and the last flight with its animation and plots;
    /// learning.html in the folder if not given
    #[arg(long, value_name = "FILE.html")]
    page: Option<PathBuf>,
    /// Print JSON instead of text
    #[arg(long)]
    json: bool,
}

impl Learn {
    pub(crate) fn run(self) -> ExitCode {
        match self.learn() {
            Ok(learned) => {
                if learned {
                    ExitCode::SUCCESS
                } else {
                    ExitCode::FAILURE
                }
            }
            Err(error) => {
                if self.json {
                    let text = error.to_string();
                    // Nothing was flown; the fields are there all the same.
                    let none = json!({
                        "error": text, "converged": false, "reason": text, "planned_duration_s": null,
                        "learned_duration_s": null, "optimum_duration_s": null, "flights": [], "repeats": [],
                    });
                    print(&none.to_string());
                }
                eprintln!("mintime: {error}");
                ExitCode::FAILURE
            }
        }
    }

    /// Whether it was learned.
    fn learn(&self) -> Result<bool, Box<dyn Error>> {
        // Everything that can be refused is refused before anything flies.
        let (target, maneuver) = self.target()?;
        let folder = self.output.clone().unwrap_or_else(|| self.folder(&maneuver));
        check_folder(&folder)?;
        let page = self.page.clone().unwrap_or_else(|| folder.join(PAGE_FILE));
        page::check(&page)?;
        let mut progress = Progress::new();
        let mut campaign = Campaign { learn: self, target, maneuver, folder, kept: Ok(()), last: None };
        let learned = match &self.vehicle {
            VehicleKind::Port(port) => campaign.real(port, &mut progress),
            _ => campaign.simulated(&mut progress),
        };
        progress.finish();
        let learned = learned?;
        let written =
            campaign.last.as_ref().map(|last| self.write(&learned.history, last, &mut progress, &page));
        let page = matches!(written, Some(Ok(()))).then_some(page.as_path());
        if self.json {
            let kept =
                campaign.kept.as_ref().map(|()| campaign.folder.as_path()).map_err(ToString::to_string);
            print(&format!("{:#}", words::value(&learned, kept, page)));
        } else {
            print(&words::text(&learned, campaign.kept.is_ok().then_some(campaign.folder.as_path()), page));
        }
        // The answer has been printed whole: what could not be kept is told beside it.
        if let Err(error) = &campaign.kept {
            eprintln!("mintime: {error}");
        }
        if let Some(Err(error)) = &written {
            eprintln!("mintime: {error}");
        }
        if !learned.history.converged {
            eprintln!("mintime: {}", learned.stop);
        }
        Ok(learned.history.converged && campaign.kept.is_ok() && !matches!(written, Some(Err(_))))
    }

    /// Writes the page: what was learned, and the last flight.
    fn write(
        &self,
        history: &History,
        last: &Flown,
        progress: &mut Progress,
        path: &Path,
    ) -> Result<(), Box<dyn Error>> {
        let mission = Mission {
            source: Source::Learned { bytes: last.prepared.bytes.clone(), heading_rad: history.heading_rad },
            plant: PlantChoice::from_argument(&self.plant)?,
            seed: self.seed,
            room: self.room,
        };
        let log = recording::log(&mission, last, progress.last_flight());
        let picture = recording::report(&mission, last);
        let learning = Some(history.into());
        Ok(page::write(
            &Page::collect(Sources { picture: &picture, log: &log, flown: last, learning }),
            path,
        )?)
    }

    /// What to learn, and its name.
    fn target(&self) -> Result<(Target, String), Box<dyn Error>> {
        match numbers::displacement(&self.to) {
            Ok(Displacement { along_m, up_m, heading_rad }) => {
                let limits = self.plan.limits(GRAVITY_MPS2);
                let (to, turns) = (State::at_rest(along_m, up_m), self.plan.turns);
                let name = self.to.replace(',', "-").replace(' ', "");
                Ok((Target::Solve { to, limits, turns, heading_rad }, name))
            }
            Err(error) => {
                let path = Path::new(&self.to);
                if !path.exists() && self.to.contains(',') {
                    return Err(error.into());
                }
                let table = ManeuverTable::decode(&read_bytes(path)?)?;
                // What was learned before goes on under its name, and in the plane that was asked for.
                let before = History::beside(path, &table);
                let heading_rad = before.as_ref().map_or(f64::from(table.heading_rad), |h| h.heading_rad);
                let stem = || path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
                Ok((
                    Target::Table { table: Box::new(table), heading_rad },
                    before.map_or_else(stem, |h| h.maneuver),
                ))
            }
        }
    }

    fn folder(&self, maneuver: &str) -> PathBuf {
        let plain =
            |text: &str| text.replace(|c: char| !c.is_ascii_alphanumeric() && c != '.' && c != '-', "_");
        Path::new("learned").join(format!("{}-{}", plain(maneuver), plain(self.vehicle.name())))
    }
}

/// One campaign, and where it is kept.
struct Campaign<'a> {
    learn: &'a Learn,
    target: Target,
    maneuver: String,
    folder: PathBuf,
    /// Whether the last flight's history is on disk.
    kept: Result<(), HistoryError>,
    /// The last flight that took place.
    last: Option<Flown>,
}

impl Campaign<'_> {
    fn simulated(&mut self, progress: &mut Progress) -> Result<Learned, Box<dyn Error>> {
        let learn = self.learn;
        if learn.live.are_given() {
            return Err("--mocap is for a real vehicle: name its port with --vehicle PORT".into());
        }
        let choice = match (&learn.vehicle, &learn.firmware) {
            (VehicleKind::Hosted, None) => VehicleChoice::Hosted,
            (VehicleKind::Hosted, Some(_)) => {
                return Err(
                    "the hosted vehicle runs no image: leave out --firmware, or learn with --vehicle virtual"
                        .into(),
                );
            }
            (_, path) => {
                let image = firmware(path.as_deref(), progress)?;
                VehicleChoice::Virtual { image, both_timings: false }
            }
        };
        let plant = PlantChoice::from_argument(&learn.plant)?;
        check_plant(&plant.parameters, &self.limits())?;
        let (seed, room) = (learn.seed, learn.room);
        self.foresee(&VehicleConfig::REFERENCE, room.as_ref())?;
        let mut vehicle =
            SimulatedVehicle { choice, plant, seed, room, response: Response::IDEAL, heading_rad: 0.0 };
        progress.line("hovering and hopping: what is the vehicle?");
        let found = vehicle.identify(progress)?;
        let plan = self.plan(&VehicleConfig::REFERENCE, &found, room.as_ref(), progress)?;
        vehicle.response = plan.response;
        vehicle.heading_rad = plan.heading_rad;
        let voice = progress.voice();
        let mut flyer = SimulatedFlyer { vehicle: &vehicle, witness: progress, last: None };
        let learned = self.teach(&plan, found, &mut flyer, voice);
        self.last = flyer.last;
        Ok(learned)
    }

    fn real(&mut self, port: &str, progress: &mut Progress) -> Result<Learned, Box<dyn Error>> {
        let learn = self.learn;
        if learn.firmware.is_some() {
            return Err("a real vehicle has its firmware already: leave out --firmware".into());
        }
        let (mut watched, config, room) = learn.live.watch(port, learn.room)?;
        let hops = HopPlan { height_m: -room.z_m.0, ..hop_plan() };
        identification::check(&hops, Some(&room))?;
        self.foresee(&config, Some(&room))?;
        progress.line("hovering and hopping: what is the vehicle?");
        let flight = fly_hops(&mut watched.vehicle, &hops, progress)?;
        let found = (&identify(&flight, &config)?).into();
        let plan = self.plan(&config, &found, Some(&room), progress)?;
        let voice = progress.voice();
        let mut flyer = RealFlyer {
            watched,
            config,
            room,
            response: plan.response,
            heading_rad: plan.heading_rad,
            progress,
            last: None,
        };
        let learned = self.teach(&plan, found, &mut flyer, voice);
        self.last = flyer.last;
        Ok(learned)
    }

    /// Limits that are asked for.
    fn limits(&self) -> Limits<f64> {
        match &self.target {
            Target::Solve { limits, .. } => *limits,
            Target::Table { table, .. } => table.limits.cast(),
        }
    }

    /// Refuses before anything flies what a vehicle as its file says could not learn here.
    fn foresee(&self, config: &VehicleConfig, room: Option<&Room>) -> Result<(), Box<dyn Error>> {
        match plan(&self.target, config, &IdentifiedResponse::of_file(config)) {
            Ok(plan) => Ok(prepare_for(&source(&plan), room, config).map(|_| ())?),
            // It may be stronger than its file says.
            Err(PlanError::Weak { .. }) => Ok(()),
            Err(error) => Err(error.into()),
        }
    }

    /// Plans, and sees to it that the first flight fits the room.
    fn plan(
        &self,
        config: &VehicleConfig,
        found: &IdentifiedResponse,
        room: Option<&Room>,
        progress: &Progress,
    ) -> Result<LearningPlan, Box<dyn Error>> {
        progress.line(&format!(
            "thrust {:.4} ± {:.4} of what the vehicle file says, rotors answer in {:.1} ms",
            found.thrust_scale,
            found.thrust_scale_std,
            found.response_s * 1e3
        ));
        let plan = plan(&self.target, config, found)?;
        prepare_for(&source(&plan), room, config)?;
        progress.line(&format!(
            "planned {:.4} s (optimum {:.4} s), rehearsed {:.4} s",
            plan.planned_duration_s,
            plan.optimum_duration_s,
            plan.table.duration_s()
        ));
        Ok(plan)
    }

    fn teach(
        &mut self,
        plan: &LearningPlan,
        found: IdentifiedResponse,
        flyer: &mut impl Flyer,
        voice: Voice,
    ) -> Learned {
        let learn = self.learn;
        let seed = (!matches!(learn.vehicle, VehicleKind::Port(_))).then_some(learn.seed);
        let mut history = History::of(&self.maneuver, learn.vehicle.name(), seed);
        history.identified = Some(found);
        let budget = Budget { flights: learn.flights, repeats: learn.repeats };
        let mut keeper = Keeper { folder: &self.folder, voice, kept: Ok(()), seen: 0, shelved: false };
        let learned = mintime::learning::learn(plan, history, budget, flyer, &mut keeper);
        self.kept = keeper.kept;
        learned
    }
}

/// What is flown first.
fn source(plan: &LearningPlan) -> Source {
    Source::Learned { bytes: bytes(&plan.table), heading_rad: plan.heading_rad }
}

/// A table's bytes.
fn bytes(table: &ManeuverTable) -> Vec<u8> {
    let mut buffer = [0; MAX_TABLE_BYTES];
    // The buffer holds every table.
    let length = table.encode(&mut buffer).unwrap_or(0);
    buffer[..length].to_vec()
}

/// Keeps the history after every flight, and tells how it went.
struct Keeper<'a> {
    folder: &'a Path,
    voice: Voice,
    /// Whether the last history is on disk.
    kept: Result<(), HistoryError>,
    /// Flights that have been told of.
    seen: usize,
    /// Whether what an earlier campaign left has made room: not before there is something new to keep.
    shelved: bool,
}

impl Keeper<'_> {
    fn keep(&mut self, history: &History, table: &ManeuverTable) -> Result<(), HistoryError> {
        if !self.shelved {
            keep_old(self.folder)?;
            self.shelved = true;
        }
        history.save(self.folder, &bytes(table))
    }
}

impl Observer for Keeper<'_> {
    fn flown(&mut self, history: &History, table: &ManeuverTable) {
        let count = history.flights.len() + history.repeats.len();
        if count > self.seen {
            self.seen = count;
            self.voice.line(&words::newest(history));
        }
        let kept = self.keep(history, table);
        // A disk that is full now may not be so after the next flight; the history grows on in memory.
        if let (Ok(()), Err(error)) = (&self.kept, &kept) {
            self.voice.line(&format!("{error}; flying on, and trying again after the next flight"));
        }
        self.kept = kept;
    }
}

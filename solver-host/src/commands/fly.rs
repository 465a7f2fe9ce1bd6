//! `mintime fly`: from a request to a flown maneuver.

use std::error::Error;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::Args;
use mintime::firmware_image::{FirmwareImage, FirmwareImageError};
use mintime::flight_log::{LogEvent, check_writable, write_mcap};
use mintime::learning::History;
use mintime::mission::{self, Flown, Mission, PlantChoice, Prepared, Room, Source, VehicleChoice};
use mintime::page::{self, Page, Sources};
use mintime::report;
use mintime_shared::model::{GRAVITY_MPS2, State};
use mintime_shared::table::{LinkPolicy, ManeuverTable};

use super::limits::PlanArguments;
use super::live::LiveArguments;
use super::numbers::{self, Displacement};
use super::print;
use super::progress::Progress;
use super::solve::write_bytes;
use super::table::read_bytes;
use super::{recording, summary};

/// Arguments of `mintime fly`.
#[derive(Args)]
#[command(
    after_help = "Examples:\n  mintime fly --to 5,5\n  mintime fly --to 0,3 --plant ideal --report flip.png\n  \
                        mintime fly --to -3,4 --room -8,4,-4,9 --json\n  mintime fly --to 3,4,5"
)]
pub(crate) struct Fly {
    /// Displacement to fly, m: ahead and up, or ahead, to the left and up. The vehicle need not yaw
    #[arg(long, value_name = "X,Z|X,Y,Z", value_parser = numbers::displacement, allow_hyphen_values = true,
          required_unless_present = "table")]
    to: Option<Displacement>,
    /// Fly this table file instead of computing a maneuver
    #[arg(long, value_name = "FILE", conflicts_with_all = ["to", "thrust_per_mass", "max_body_rate", "turns"])]
    table: Option<PathBuf>,
    /// Write the maneuver table to this file
    #[arg(long, value_name = "FILE")]
    save_table: Option<PathBuf>,
    #[command(flatten)]
    plan: PlanArguments,
    /// What flies: `virtual` (the very firmware image that gets flashed, on an emulated flight controller), `hosted` (the
    /// flight logic in this process: no image needed, twenty times as fast), or the port of a real vehicle: a serial device,
    /// tcp:HOST:PORT or udp:HOST:PORT
    #[arg(long, value_name = "virtual|hosted|PORT", default_value = "virtual")]
    vehicle: VehicleKind,
    #[command(flatten)]
    live: LiveArguments,
    /// The image that the virtual flight controller runs; built from the sources if not given
    #[arg(long, value_name = "FILE.elf")]
    firmware: Option<PathBuf>,
    /// The simulated airframe: `ideal` (the planning model itself), `nominal` (lag, drag, noise, wrong scales), or a
    /// TOML file (see docs/vehicles.md)
    #[arg(long, value_name = "ideal|nominal|FILE.toml", default_value = "nominal")]
    plant: String,
    /// Seed of everything random in the simulation
    #[arg(long, default_value_t = 1)]
    seed: u64,
    /// Free space around the start, m; ZMIN is the floor. The planned path and the distance to catch the vehicle must
    /// fit. Four numbers are along the maneuver's plane and up, six along the vehicle's nose, to its left and up
    #[arg(long, value_name = "XMIN,XMAX[,YMIN,YMAX],ZMIN,ZMAX", value_parser = numbers::room, allow_hyphen_values = true)]
    room: Option<Room>,
    /// What the vehicle does where the link is lost in the maneuver: fly it to its end, or level at once and sink. A table
    /// from a file keeps what it says
    #[arg(long, value_enum, default_value_t = OnLinkLoss::Finish)]
    on_link_loss: OnLinkLoss,
    /// Where to write the flight log (MCAP; opens in Foxglove)
    #[arg(long, value_name = "FILE.mcap", default_value = "flight.mcap")]
    log: PathBuf,
    /// Where to write the picture, SVG or PNG by its ending
    #[arg(long, value_name = "FILE.svg|FILE.png", default_value = "flight.svg")]
    report: PathBuf,
    /// Where to write the page to look at in a browser: animated flight, plots, certificate, bytes, timings, faults
    #[arg(long, value_name = "FILE.html", default_value = "flight.html")]
    page: PathBuf,
    /// Print what the firmware logs, too (it is in the flight log in any case)
    #[arg(long)]
    firmware_log: bool,
    /// Print JSON instead of text
    #[arg(long)]
    json: bool,
}

/// What becomes of a maneuver whose host falls silent.
#[derive(Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
enum OnLinkLoss {
    Finish,
    Abandon,
}

/// What can fly.
#[derive(Clone, PartialEq, Eq)]
pub(crate) enum VehicleKind {
    Virtual,
    Hosted,
    Port(String),
}

impl VehicleKind {
    /// As it was given.
    pub(crate) fn name(&self) -> &str {
        match self {
            Self::Virtual => "virtual",
            Self::Hosted => "hosted",
            Self::Port(port) => port,
        }
    }
}

impl From<&str> for VehicleKind {
    fn from(text: &str) -> Self {
        match text {
            "virtual" => Self::Virtual,
            "hosted" => Self::Hosted,
            port => Self::Port(port.to_owned()),
        }
    }
}

impl Fly {
    pub(crate) fn run(self) -> ExitCode {
        match self.fly() {
            Ok(true) => ExitCode::SUCCESS,
            Ok(false) => ExitCode::FAILURE,
            Err(error) => {
                if self.json {
                    print(&serde_json::json!({ "error": error.to_string() }).to_string());
                }
                eprintln!("mintime: {error}");
                ExitCode::FAILURE
            }
        }
    }

    fn mission(&self) -> Result<Mission, Box<dyn Error>> {
        let source = match (&self.table, self.to) {
            (Some(path), _) => from_file(path)?,
            (None, to) => {
                let Displacement { along_m, up_m, heading_rad } = to.unwrap_or_default();
                let limits = self.plan.limits(GRAVITY_MPS2);
                let (to, turns) = (State::at_rest(along_m, up_m), self.plan.turns);
                Source::Solve { to, limits, turns, heading_rad }
            }
        };
        let room = self.room;
        Ok(Mission { source, plant: PlantChoice::from_argument(&self.plant)?, seed: self.seed, room })
    }

    fn vehicle(&self, progress: &Progress) -> Result<VehicleChoice, Box<dyn Error>> {
        Ok(match (&self.vehicle, &self.firmware) {
            (VehicleKind::Hosted, None) => VehicleChoice::Hosted,
            (VehicleKind::Hosted, Some(_)) => {
                return Err(
                    "the hosted vehicle runs no image: leave out --firmware, or fly with --vehicle virtual"
                        .into(),
                );
            }
            (_, path) => {
                let image = firmware(path.as_deref(), progress)?;
                VehicleChoice::Virtual { image, both_timings: true }
            }
        })
    }

    fn fly_simulated(&self, mission: &Mission, progress: &mut Progress) -> Result<Flown, Box<dyn Error>> {
        if self.live.are_given() {
            return Err("--mocap is for a real vehicle: name its port with --vehicle PORT".into());
        }
        progress.say("computing the maneuver");
        let mut prepared = mission::prepare(&mission.source, mission.room.as_ref())?;
        self.set_link_policy(&mut prepared)?;
        self.save(&prepared)?;
        let vehicle = self.vehicle(progress)?;
        Ok(mission::fly_mission(mission, prepared, &vehicle, progress)?)
    }

    fn fly_real(
        &self,
        port: &str,
        mission: &Mission,
        progress: &mut Progress,
    ) -> Result<Flown, Box<dyn Error>> {
        if self.firmware.is_some() {
            return Err("a real vehicle has its firmware already: leave out --firmware".into());
        }
        progress.say("asking the vehicle what it is, computing the maneuver");
        let mut live = self.live.prepare(port, mission)?;
        self.set_link_policy(live.prepared_mut())?;
        self.save(live.prepared())?;
        self.live.fly(live, progress)
    }

    fn set_link_policy(&self, prepared: &mut Prepared) -> Result<(), Box<dyn Error>> {
        if self.table.is_none() {
            prepared.set_link_policy(match self.on_link_loss {
                OnLinkLoss::Finish => LinkPolicy::Finish,
                OnLinkLoss::Abandon => LinkPolicy::Abandon,
            })?;
        }
        Ok(())
    }

    fn save(&self, prepared: &Prepared) -> Result<(), Box<dyn Error>> {
        if let Some(path) = &self.save_table {
            write_bytes(path, &prepared.bytes)?;
        }
        Ok(())
    }

    /// Whether it was flown to its end and caught.
    fn fly(&self) -> Result<bool, Box<dyn Error>> {
        // Everything that can be refused is refused before anything flies.
        distinct([Some(&self.log), Some(&self.report), Some(&self.page), self.save_table.as_ref()])?;
        check_writable(&self.log)?;
        report::check(&self.report)?;
        page::check(&self.page)?;
        self.save_table.as_deref().map(check_writable).transpose()?;
        let mission = self.mission()?;

        let mut progress = Progress::new();
        let flown = match &self.vehicle {
            VehicleKind::Port(port) => self.fly_real(port, &mission, &mut progress),
            _ => self.fly_simulated(&mission, &mut progress),
        }
        .inspect_err(|_| progress.finish())?;

        progress.say("writing the log, the picture and the page");
        let written = self.write(&mission, &flown, std::mem::take(&mut progress.events));
        progress.finish();
        // The flight is over: what it says is printed, whatever became of the files.
        let [log, report, page] = written.each_ref().map(|file| file.as_deref().ok());
        if self.json {
            print(&format!("{:#}", summary::json(&flown, log, report, page)));
        } else {
            let files: Vec<&Path> = [log, report, page].into_iter().flatten().collect();
            print(&summary::text(&flown, self.firmware_log, &files));
        }
        let mut complete = true;
        for error in written.iter().filter_map(|file| file.as_ref().err()) {
            eprintln!("mintime: {error}");
            complete = false;
        }
        if !flown.is_success() {
            let reason = flown.reason().map(|r| format!(": {r}")).unwrap_or_default();
            eprintln!("mintime: {}{reason}", flown.outcome());
        }
        Ok(flown.is_success() && complete)
    }

    /// Writes what the flight leaves: log, picture, page. What cannot be written does not keep the others from it.
    fn write(
        &self,
        mission: &Mission,
        flown: &Flown,
        events: Vec<LogEvent>,
    ) -> [Result<PathBuf, Box<dyn Error>>; 3] {
        let log = recording::log(mission, flown, events);
        let picture = recording::report(mission, flown);
        let page = Page::collect(Sources { picture: &picture, log: &log, flown, learning: None });
        [
            write_mcap(&log, &self.log).map(|()| self.log.clone()).map_err(Into::into),
            report::write(&picture, &self.report).map(|()| self.report.clone()).map_err(Into::into),
            page::write(&page, &self.page).map(|()| self.page.clone()).map_err(Into::into),
        ]
    }
}

/// The image named, or the one built from the sources.
pub(super) fn firmware(
    path: Option<&Path>,
    progress: &Progress,
) -> Result<FirmwareImage, FirmwareImageError> {
    match path {
        Some(path) => FirmwareImage::read(path),
        None => FirmwareImage::build(&mut |text| progress.announce(text)),
    }
}

/// A path without links and detours; of a file that does not exist yet, that of its folder.
fn true_path(path: &Path) -> PathBuf {
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let in_folder = || Some(folder.canonicalize().ok()?.join(path.file_name()?));
    path.canonicalize().ok().or_else(in_folder).unwrap_or_else(|| path.to_owned())
}

/// Refuses to write two outputs to one file.
pub(super) fn distinct<const N: usize>(paths: [Option<&PathBuf>; N]) -> Result<(), String> {
    let true_paths: Vec<_> = paths.into_iter().flatten().map(|path| true_path(path)).collect();
    for (i, path) in true_paths.iter().enumerate() {
        if true_paths[..i].contains(path) {
            return Err(format!("{} is named for two outputs: give each a file of its own", path.display()));
        }
    }
    Ok(())
}

/// A table from a file. One that was learned is flown in the plane for which it was, where its history lies beside it.
fn from_file(path: &Path) -> Result<Source, Box<dyn Error>> {
    let bytes = read_bytes(path)?;
    let learned = ManeuverTable::decode(&bytes).ok().and_then(|table| History::beside(path, &table));
    Ok(match learned {
        Some(history) => Source::Learned { bytes, heading_rad: history.heading_rad },
        None => Source::Table(bytes),
    })
}

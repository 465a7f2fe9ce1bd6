//! From a request to a flown maneuver: solve, pack, check the room, fly, compare with truth.

mod flown;
mod peak_speed;
mod plan_frame;
mod room;

use std::path::{Path, PathBuf};
use std::time::Instant;

pub use flown::{Flown, PlanarError, rate_in_plane};
pub use plan_frame::PlanFrame;
pub use room::{CATCH_DISTANCE_M, CATCH_TIME_S, Extent, Room};

use emulator::core::Timing;
use mintime_firmware::config::VehicleConfig;
use mintime_shared::messages::PROTOCOL_VERSION;
use mintime_shared::model::{Limits, LimitsError, State};
use mintime_shared::replay::Plan;
use mintime_shared::table::{LinkPolicy, MAX_TABLE_BYTES, ManeuverTable, TableError};
use mintime_simulator::{Model, ParameterError, Simulator, SimulatorError, VehicleParameters};
use nalgebra::Vector3;

use crate::firmware_image::FirmwareImage;
use crate::flight::{
    BoardReport, FlightError, FlightPlan, FlightResult, HostedVehicle, Phase, Scene, Trace,
    VirtualBoardError, VirtualVehicle, Witness, fly,
};
use crate::pack::{PackError, pack};
use crate::solver::{Request, Solution, SolveError, Turns, solve};

/// Thrust that the rotors must give over what is planned, so that attitude keeps authority at full thrust.
pub const THRUST_MARGIN: f64 = 1.15;
/// Gravity of plan and plant may differ by this, m/s².
const GRAVITY_TOLERANCE_MPS2: f64 = 0.05;

/// Where the maneuver comes from.
#[derive(Clone, Debug)]
pub enum Source {
    /// Solve this, from rest at the origin.
    Solve {
        /// End.
        to: State<f64>,
        /// Limits.
        limits: Limits<f64>,
        /// Windings.
        turns: Turns,
        /// Heading of the plane to fly it in, rad from the vehicle's forward axis to the left.
        heading_rad: f64,
    },
    /// Fly these bytes.
    Table(Vec<u8>),
    /// Fly these bytes, learned for the plane of a heading, rad, which may differ from their own by what an askew gyro needs.
    Learned {
        /// The table.
        bytes: Vec<u8>,
        /// The heading.
        heading_rad: f64,
    },
}

/// The airframe to simulate.
#[derive(Clone, Debug)]
pub struct PlantChoice {
    /// What it is called in logs.
    pub name: String,
    /// Its parameters.
    pub parameters: VehicleParameters,
}

/// Why a plant file cannot be used.
#[derive(Debug, thiserror::Error)]
pub enum PlantError {
    /// The file cannot be read.
    #[error("{path} cannot be read ({source}): give `ideal`, `nominal` or a readable TOML file")]
    Read {
        /// Its path.
        path: String,
        /// What the system said.
        source: std::io::Error,
    },
    /// The file's content is unusable.
    #[error("{path}: {source}")]
    Content {
        /// Its path.
        path: String,
        /// What is wrong.
        source: ParameterError,
    },
}

impl PlantChoice {
    /// `ideal`, `nominal`, or the path of a TOML file.
    ///
    /// # Errors
    /// [`PlantError`].
    pub fn from_argument(argument: &str) -> Result<Self, PlantError> {
        let parameters = match argument {
            "ideal" => VehicleParameters::ideal(),
            "nominal" => VehicleParameters::nominal(),
            path => {
                let text = std::fs::read_to_string(Path::new(path))
                    .map_err(|source| PlantError::Read { path: path.to_owned(), source })?;
                VehicleParameters::from_toml(&text)
                    .map_err(|source| PlantError::Content { path: path.to_owned(), source })?
            }
        };
        Ok(Self { name: argument.to_owned(), parameters })
    }
}

/// What flies.
#[derive(Clone, Debug)]
pub enum VehicleChoice {
    /// The flight logic in this process.
    Hosted,
    /// A firmware image on the virtual board.
    Virtual {
        /// What runs on it.
        image: FirmwareImage,
        /// Fly a twin beside it, on another processor core, whose emulated processor is as fast as can be: for both ends of
        /// every figure that depends on it. The twin's flight is not reported.
        both_timings: bool,
    },
}

impl VehicleChoice {
    /// Its name in logs and answers.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Hosted => "hosted",
            Self::Virtual { .. } => "virtual",
        }
    }
}

/// What the emulator measured on the flying board. Pairs are (optimistic, pessimistic) about the processor's timing; NaN
/// where it was not measured.
#[derive(Clone, Debug)]
pub struct EmulatedFlight {
    /// SHA-256 of the image, hexadecimal.
    pub image_sha256: String,
    /// Where the image was read from.
    pub image_path: PathBuf,
    /// Bytes of flash that it takes.
    pub flash_bytes: usize,
    /// Bytes of main memory that its statics take.
    pub ram_bytes: usize,
    /// Virtual time over wall time.
    pub real_time_factor: f64,
    /// Data ready to the end of the last motor frame, median, µs.
    pub latency_us: [f64; 2],
    /// Distance from the median that 99.9 % keep, µs.
    pub jitter_us: [f64; 2],
    /// What else was measured, in pessimistic timing.
    pub board: BoardReport,
}

/// All that a mission needs to know.
#[derive(Clone, Debug)]
pub struct Mission {
    /// Where the maneuver comes from.
    pub source: Source,
    /// The airframe.
    pub plant: PlantChoice,
    /// Seed of all that is random.
    pub seed: u64,
    /// Free space, if it is limited.
    pub room: Option<Room>,
}

/// Why a mission was not flown, or not to its end.
#[derive(Debug, thiserror::Error)]
pub enum MissionError {
    /// No maneuver.
    #[error(transparent)]
    Solve(#[from] SolveError),
    /// No table.
    #[error(transparent)]
    Pack(#[from] PackError),
    /// The table's bytes cannot be flown.
    #[error(transparent)]
    Table(#[from] TableError),
    /// Limits with which nothing can be flown.
    #[error(transparent)]
    Limits(#[from] LimitsError),
    /// The path does not fit.
    #[error(
        "the path does not fit the room: {side} the start {needed_m:.2} m are needed (with {catch_m:.2} m to catch the \
         vehicle) and {free_m:.2} m are free; choose a nearer target, lower limits or a larger room"
    )]
    Room {
        /// Which side.
        side: &'static str,
        /// Free there, m.
        free_m: f64,
        /// Needed there, m.
        needed_m: f64,
        /// Of which to catch the vehicle, m.
        catch_m: f64,
    },
    /// The room's numbers are in the wrong order.
    #[error(
        "the room is empty: give XMIN,XMAX,ZMIN,ZMAX or XMIN,XMAX,YMIN,YMAX,ZMIN,ZMAX, with each minimum below zero and each maximum \
         above"
    )]
    EmptyRoom,
    /// The simulated world has another gravity than planned with.
    #[error(
        "the plant's gravity is {plant_mps2} m/s², the maneuver is planned with {planned_mps2} m/s²: use one of them"
    )]
    PlantGravity {
        /// The plant's.
        plant_mps2: f64,
        /// The plan's.
        planned_mps2: f64,
    },
    /// The simulated vehicle is too weak for the plan.
    #[error(
        "the plant gives {available_mps2:.1} m/s² of thrust at full throttle and the plan asks for {planned_mps2:.1} m/s²: at \
         least {THRUST_MARGIN} times the plan is needed, or nothing is left for attitude; plan with less"
    )]
    PlantThrust {
        /// At full throttle and nominal voltage.
        available_mps2: f64,
        /// Planned.
        planned_mps2: f64,
    },
    /// The table starts in motion or tilted: nobody can hover there.
    #[error(
        "the maneuver does not start at rest and level, so it cannot be flown from a hover: make one that does"
    )]
    NotFromRest,
    /// The simulation cannot start.
    #[error(transparent)]
    Simulator(#[from] SimulatorError),
    /// The virtual board cannot be set up.
    #[error(transparent)]
    Board(#[from] VirtualBoardError),
    /// The flight failed.
    #[error("{0}")]
    Flight(#[from] FlightError),
}

/// A maneuver ready to fly.
#[derive(Clone, Debug)]
pub struct Prepared {
    /// The table.
    pub table: ManeuverTable,
    /// Its bytes.
    pub bytes: Vec<u8>,
    /// The verified extremal behind it; `None` for a table from a file.
    pub solution: Option<Solution>,
    /// Space that its path takes.
    pub extent: Extent,
    /// Heading of the plane that it is to be in, rad from the world's x axis, where the nose points.
    pub heading_rad: f64,
}

impl Prepared {
    /// What the vehicle shall do where the link is lost on the way.
    ///
    /// # Errors
    /// None that a prepared table can have.
    pub fn set_link_policy(&mut self, link: LinkPolicy) -> Result<(), TableError> {
        self.table.link = link;
        let mut buffer = [0; MAX_TABLE_BYTES];
        let length = self.table.encode(&mut buffer)?;
        self.bytes = buffer[..length].to_vec();
        Ok(())
    }
}

/// The protocol version that this host speaks.
pub const PROTOCOL: u8 = PROTOCOL_VERSION;

/// Solves or reads the maneuver, packs it and checks that it can be flown in the room.
///
/// # Errors
/// [`MissionError`]; nothing has moved.
pub fn prepare(source: &Source, room: Option<&Room>) -> Result<Prepared, MissionError> {
    prepare_for(source, room, &VehicleConfig::REFERENCE)
}

/// The same for a given vehicle.
///
/// # Errors
/// [`MissionError`]; nothing has moved.
pub fn prepare_for(
    source: &Source,
    room: Option<&Room>,
    config: &VehicleConfig,
) -> Result<Prepared, MissionError> {
    let (table, solution) = match source {
        Source::Solve { to, limits, turns, heading_rad } => {
            // The solver takes limits that cannot sink; a vehicle that must hover first cannot.
            limits.validate()?;
            let request = Request { from: State::origin(), to: *to, limits: *limits, turns: *turns };
            let solution = solve(&request)?;
            (pack(&solution.extremal, config.hash(), *heading_rad)?, Some(solution))
        }
        Source::Table(bytes) | Source::Learned { bytes, .. } => (ManeuverTable::decode(bytes)?, None),
    };
    let heading_rad = match source {
        Source::Learned { heading_rad, .. } => *heading_rad,
        Source::Solve { .. } | Source::Table(_) => f64::from(table.heading_rad),
    };
    let table = table.assigned_to(config.hash(), &config.plan_limits())?;
    let State { vx, vz, theta, .. } = table.start;
    if vx != 0.0 || vz != 0.0 || theta != 0.0 {
        return Err(MissionError::NotFromRest);
    }
    let mut buffer = [0; MAX_TABLE_BYTES];
    let length = table.encode(&mut buffer)?;
    let extent = Extent::of(&Plan::new(&table));
    if let Some(room) = room {
        let holds_the_start = |(low, high): (f64, f64)| low < 0.0 && high > 0.0;
        if ![Some(room.x_m), room.y_m, Some(room.z_m)].into_iter().flatten().all(holds_the_start) {
            return Err(MissionError::EmptyRoom);
        }
        // Where it is to go, and where its own heading leads: what a history says of a learned table may be wrong.
        extent.check(room, heading_rad)?;
        extent.check(room, f64::from(table.heading_rad))?;
    }
    Ok(Prepared { bytes: buffer[..length].to_vec(), table, solution, extent, heading_rad })
}

/// Whether a simulated airframe can be expected to fly a plan within these limits at all.
///
/// # Errors
/// [`MissionError::PlantGravity`], [`MissionError::PlantThrust`].
pub fn check_plant(plant: &VehicleParameters, planned: &Limits<f64>) -> Result<(), MissionError> {
    if (plant.gravity_mps2 - planned.gravity_mps2).abs() > GRAVITY_TOLERANCE_MPS2 {
        return Err(MissionError::PlantGravity {
            plant_mps2: plant.gravity_mps2,
            planned_mps2: planned.gravity_mps2,
        });
    }
    let available_mps2 = plant.thrust_mps2(1.0, plant.esc.nominal_v);
    if plant.model == Model::RigidBody && available_mps2 < THRUST_MARGIN * planned.thrust_max_mps2 {
        return Err(MissionError::PlantThrust { available_mps2, planned_mps2: planned.thrust_max_mps2 });
    }
    Ok(())
}

/// Flies a prepared maneuver.
///
/// # Errors
/// [`MissionError::Simulator`], [`MissionError::Board`] and what the plant rules out. A flight that fails is not an error
/// here: see [`Flown::flight`].
pub fn fly_mission(
    mission: &Mission,
    prepared: Prepared,
    vehicle: &VehicleChoice,
    witness: &mut impl Witness,
) -> Result<Flown, MissionError> {
    fly_again(mission, 0, prepared, vehicle, witness)
}

/// Flies a prepared maneuver as one of several flights of the same vehicle: the number decides the noise, and nothing else.
///
/// # Errors
/// Those of [`fly_mission`], which flies number 0.
pub fn fly_again(
    mission: &Mission,
    number: u32,
    prepared: Prepared,
    vehicle: &VehicleChoice,
    witness: &mut impl Witness,
) -> Result<Flown, MissionError> {
    check_plant(&mission.plant.parameters, &prepared.table.limits.cast())?;
    let floor_m = mission
        .room
        .map_or_else(|| prepared.extent.z_m.0 - prepared.extent.catch_distance_m(), |room| room.z_m.0);
    let scene = Scene {
        parameters: &mission.plant.parameters,
        seed: mission.seed,
        ground_z_m: floor_m,
        heading_rad: prepared.heading_rad,
        maneuver_s: f64::from(prepared.table.duration_s()),
    };
    let plan = FlightPlan::new(prepared.table.clone(), Vector3::zeros(), Some(VehicleConfig::REFERENCE))
        .along(prepared.heading_rad);
    let clock = Instant::now();
    let (flight, trace, virtual_time_s, emulated) = match vehicle {
        VehicleChoice::Hosted => {
            let mut vehicle = HostedVehicle::new(&scene)?;
            draw_noise(vehicle.simulator_mut(), mission.seed, number);
            let flight = fly(&mut vehicle, &plan, witness);
            let virtual_time_s = vehicle.now_ns() as f64 * 1e-9;
            (flight, vehicle.into_trace(), virtual_time_s, None)
        }
        VehicleChoice::Virtual { image, both_timings } => {
            fly_virtual(&scene, number, &plan, image, *both_timings, witness)?
        }
    };
    Ok(Flown {
        prepared,
        flight,
        vehicle: vehicle.name(),
        emulated,
        trace,
        virtual_time_s,
        wall_time_s: clock.elapsed().as_secs_f64(),
    })
}

/// The noise of a flight of a vehicle: that of its own seed for number 0.
pub(crate) fn draw_noise(simulator: &mut Simulator, seed: u64, number: u32) {
    if number > 0 {
        simulator.redraw_noise(seed ^ u64::from(number) << 32);
    }
}

type FlownBoard = (Result<FlightResult, FlightError>, Trace, f64, Option<EmulatedFlight>);

/// Flies on the virtual board, with pessimistic timing.
fn fly_virtual(
    scene: &Scene<'_>,
    number: u32,
    plan: &FlightPlan,
    image: &FirmwareImage,
    both_timings: bool,
    witness: &mut impl Witness,
) -> Result<FlownBoard, MissionError> {
    let board = |timing| {
        let mut vehicle = VirtualVehicle::new(scene, image.elf(), timing)?;
        draw_noise(vehicle.simulator_mut(), scene.seed, number);
        Ok::<_, VirtualBoardError>(vehicle)
    };
    let mut vehicle = board(Timing::Pessimistic)?;
    let twin = both_timings.then(|| board(Timing::Optimistic)).transpose()?;
    let (flight, wall_s, optimistic) = std::thread::scope(|scope| {
        let twin = twin.map(|mut twin| {
            scope.spawn(move || {
                // Its outcome is nobody's business: only its timing is.
                let _ = fly(&mut twin, plan, &mut Unseen);
                twin.report()
            })
        });
        let clock = Instant::now();
        let flight = fly(&mut vehicle, plan, witness);
        let wall_s = clock.elapsed().as_secs_f64();
        // A twin that panicked is a defect, and no reason to print less.
        let optimistic =
            twin.map(|twin| twin.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic)));
        (flight, wall_s, optimistic.unwrap_or_default())
    });
    let virtual_time_s = vehicle.now_ns() as f64 * 1e-9;
    let mut board = vehicle.report();
    // What goes wrong only where the processor is fast is as wrong.
    for bug in &optimistic.bugs {
        if !board.bugs.contains(bug) {
            board.bugs.push(bug.clone());
        }
    }
    let us = |pick: fn((u32, u32)) -> u32| {
        [&optimistic, &board].map(|r| r.latency_ns.map_or(f64::NAN, |l| f64::from(pick(l)) * 1e-3))
    };
    let emulated = EmulatedFlight {
        image_sha256: image.sha256(),
        image_path: image.path().to_owned(),
        flash_bytes: image.flash_bytes(),
        ram_bytes: image.ram_bytes(),
        real_time_factor: virtual_time_s / wall_s,
        latency_us: us(|(median, _)| median),
        jitter_us: us(|(_, jitter)| jitter),
        board,
    };
    Ok((flight, vehicle.into_trace(), virtual_time_s, Some(emulated)))
}

/// A witness that looks away.
pub(crate) struct Unseen;

impl Witness for Unseen {
    fn phase(&mut self, _: Phase, _: f64) {}
    fn event(&mut self, _: f64, _: &str) {}
}

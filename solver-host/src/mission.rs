//! From a request to a flown maneuver: solve, pack, check the room, fly, compare with truth.

mod peak_speed;
mod plan_frame;

use std::path::{Path, PathBuf};
use std::time::Instant;

pub use plan_frame::PlanFrame;

use emulator::core::Timing;
use mintime_firmware::config::VehicleConfig;
use mintime_shared::messages::PROTOCOL_VERSION;
use mintime_shared::model::{Limits, LimitsError, State};
use mintime_shared::replay::Plan;
use mintime_shared::table::{LinkPolicy, MAX_TABLE_BYTES, ManeuverTable, TableError};
use mintime_simulator::{Model, ParameterError, Simulator, SimulatorError, Truth, VehicleParameters};
use nalgebra::Vector3;

use crate::firmware_image::FirmwareImage;
use crate::flight::{
    BoardReport, FlightError, FlightPlan, FlightResult, HostedVehicle, Outcome, Phase, Scene, Trace,
    VirtualBoardError, VirtualVehicle, Witness, fly,
};
use crate::pack::{PackError, pack};
use crate::solver::{Request, Solution, SolveError, Turns, solve};

/// Free space around the planned path that catching the vehicle may take, m: this, ...
pub const CATCH_DISTANCE_M: f64 = 1.0;
/// ... plus this for each m/s of the path's peak speed, s. Drag and lag of a vehicle that has not learned its maneuver
/// leave it with a part of that speed.
pub const CATCH_TIME_S: f64 = 0.25;
/// Thrust that the rotors must give over what is planned, so that attitude keeps authority at full thrust.
pub const THRUST_MARGIN: f64 = 1.15;
/// Gravity of plan and plant may differ by this, m/s².
const GRAVITY_TOLERANCE_MPS2: f64 = 0.05;
/// Step at which the path is sampled for its extent, s.
const PATH_STEP_S: f64 = 1.0e-3;

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

/// Free space, relative to the start of the maneuver, m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Room {
    /// Behind the start (negative) and ahead of it: along the maneuver's plane, or along the vehicle's nose where `y_m`
    /// is given.
    pub x_m: (f64, f64),
    /// To the right of the start (negative) and to the left of it, seen along the nose; `None` where sideways space is no
    /// matter.
    pub y_m: Option<(f64, f64)>,
    /// Below the start (negative: the floor) and above it.
    pub z_m: (f64, f64),
}

/// What a planned path needs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extent {
    /// Least and greatest x, m.
    pub x_m: (f64, f64),
    /// Least and greatest z, m.
    pub z_m: (f64, f64),
    /// Greatest speed, m/s.
    pub peak_speed_mps: f64,
}

impl Extent {
    /// Of a plan, relative to its start.
    fn of(plan: &Plan) -> Self {
        let start = plan.state_at(0.0);
        let steps = (f64::from(plan.duration_s()) / PATH_STEP_S).ceil() as usize;
        let mut extent = Self { x_m: (0.0, 0.0), z_m: (0.0, 0.0), peak_speed_mps: 0.0 };
        for i in 0..=steps {
            let s = plan.state_at(((i as f64 * PATH_STEP_S) as f32).min(plan.duration_s()));
            let (x, z) = (f64::from(s.x - start.x), f64::from(s.z - start.z));
            extent.x_m = (extent.x_m.0.min(x), extent.x_m.1.max(x));
            extent.z_m = (extent.z_m.0.min(z), extent.z_m.1.max(z));
            extent.peak_speed_mps = extent.peak_speed_mps.max(f64::from(s.vx).hypot(f64::from(s.vz)));
        }
        extent
    }

    /// Space to catch the vehicle in, m.
    pub fn catch_distance_m(&self) -> f64 {
        CATCH_DISTANCE_M + CATCH_TIME_S * self.peak_speed_mps
    }

    /// Whether path and catch distance fit.
    fn check(&self, room: &Room, heading_rad: f64) -> Result<(), MissionError> {
        let catch = self.catch_distance_m();
        let seen_along = |part: f64| {
            let (a, b) = (self.x_m.0 * part, self.x_m.1 * part);
            (a.min(b), a.max(b))
        };
        let (sin, cos) = heading_rad.sin_cos();
        let (x_m, y_m) =
            if room.y_m.is_some() { (seen_along(cos), seen_along(sin)) } else { (self.x_m, (0.0, 0.0)) };
        let y_free = room.y_m.unwrap_or((f64::NEG_INFINITY, f64::INFINITY));
        let sides = [
            ("behind", -room.x_m.0, -x_m.0),
            ("ahead of", room.x_m.1, x_m.1),
            ("to the right of", -y_free.0, -y_m.0),
            ("to the left of", y_free.1, y_m.1),
            ("below", -room.z_m.0, -self.z_m.0),
            ("above", room.z_m.1, self.z_m.1),
        ];
        for (side, free_m, path_m) in sides {
            let needed_m = path_m + catch;
            if free_m < needed_m {
                return Err(MissionError::Room { side, free_m, needed_m, catch_m: catch });
            }
        }
        Ok(())
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

/// A flown mission.
#[derive(Debug)]
pub struct Flown {
    /// What was flown.
    pub prepared: Prepared,
    /// How it went; an error for a flight that was lost.
    pub flight: Result<FlightResult, FlightError>,
    /// What flew: its name.
    pub vehicle: &'static str,
    /// What the emulator measured, where it ran the vehicle.
    pub emulated: Option<EmulatedFlight>,
    /// What was logged on the side.
    pub trace: Trace,
    /// Virtual time that the flight took, s.
    pub virtual_time_s: f64,
    /// Wall time that flying took, s.
    pub wall_time_s: f64,
}

/// Truth less plan, at one instant, in the maneuver's plane and across it. SI units.
#[derive(Clone, Copy, Debug, Default, PartialEq, serde::Serialize)]
pub struct PlanarError {
    /// Position along the heading.
    pub x_m: f64,
    /// Velocity along the heading.
    pub vx_mps: f64,
    /// Height.
    pub z_m: f64,
    /// Vertical velocity.
    pub vz_mps: f64,
    /// Pitch angle.
    pub theta_rad: f64,
    /// Pitch rate. Plans begin at rest and end turning, often at the limit.
    pub pitch_rate_radps: f64,
    /// Position out of the plane, to the left of the heading.
    pub y_m: f64,
    /// Velocity out of the plane.
    pub vy_mps: f64,
}

/// Rate of turn in the plane of a heading in the body frame, rad/s.
pub fn rate_in_plane([roll, pitch, _]: [f64; 3], heading_rad: f64) -> f64 {
    pitch * heading_rad.cos() - roll * heading_rad.sin()
}

impl PlanarError {
    fn new(
        difference: State<f64>,
        [y_m, vy_mps]: [f64; 2],
        truth: &Truth,
        planned_rate_radps: f64,
        heading_rad: f64,
    ) -> Self {
        let State { x, vx, z, vz, theta } = difference;
        let pitch_rate_radps = rate_in_plane(truth.rates_radps, heading_rad) - planned_rate_radps;
        Self { x_m: x, vx_mps: vx, z_m: z, vz_mps: vz, theta_rad: theta, pitch_rate_radps, y_m, vy_mps }
    }
}

impl Flown {
    /// Truth when the maneuver began less the planned start at the hover point. `None` if it never began.
    pub fn start_error(&self) -> Option<PlanarError> {
        let truth = self.trace.start.as_ref()?;
        let planned = self.prepared.table.start.cast::<f64>();
        let origin = State { x: planned.x, z: planned.z, ..State::origin() };
        let heading_rad = self.heading_rad();
        let difference = truth.planar(heading_rad).minus(planned.minus(origin));
        Some(PlanarError::new(difference, truth.across(heading_rad), truth, 0.0, heading_rad))
    }

    /// Truth when the table's time had passed less the planned end, positions relative to the true start.
    pub fn final_error(&self) -> Option<PlanarError> {
        let heading_rad = self.heading_rad();
        let (start, end) = (self.trace.start.as_ref()?, self.trace.end.as_ref()?);
        let table = &self.prepared.table;
        let began = start.planar(heading_rad);
        let planned = table.end.cast::<f64>();
        let from = table.start.cast::<f64>();
        // θ counts from where the vehicle's own turn counter stood at the start, in whole turns.
        let turn = core::f64::consts::TAU;
        let counted = ((began.theta - from.theta) / turn).round() * turn;
        let flown = end.planar(heading_rad);
        let relative = State {
            x: flown.x - began.x - (planned.x - from.x),
            vx: flown.vx - planned.vx,
            z: flown.z - began.z - (planned.z - from.z),
            vz: flown.vz - planned.vz,
            theta: flown.theta - counted - planned.theta,
        };
        let ([y0, _], [y, vy]) = (start.across(heading_rad), end.across(heading_rad));
        Some(PlanarError::new(relative, [y - y0, vy], end, self.final_rate_radps(), heading_rad))
    }

    /// How it went, in one word: that of [`FlightResult::outcome`], `lost` for a flight that failed, `crashed` where the
    /// vehicle hit the ground, whatever it reported itself.
    pub fn outcome(&self) -> &'static str {
        match &self.flight {
            _ if self.crashed() => "crashed",
            Ok(result) => result.outcome.name(),
            Err(_) => "lost",
        }
    }

    /// Why it went otherwise than planned, in words.
    pub fn reason(&self) -> Option<String> {
        let told = match &self.flight {
            Ok(result) => result.reason.clone(),
            Err(error) => Some(error.to_string()),
        };
        if !self.crashed() {
            return told;
        }
        Some(format!("the vehicle hit the ground{}", told.map(|t| format!("; {t}")).unwrap_or_default()))
    }

    /// Flown to the end, caught and landed.
    pub fn is_success(&self) -> bool {
        !self.crashed() && self.flight.as_ref().is_ok_and(|r| r.outcome == Outcome::Completed)
    }

    fn crashed(&self) -> bool {
        self.trace.last.as_ref().is_some_and(|truth| truth.crashed)
    }

    /// Pitch rate at which the plan ends, rad/s: it is still turning.
    fn final_rate_radps(&self) -> f64 {
        let plan = Plan::new(&self.prepared.table);
        let (end_s, step_s) = (plan.duration_s(), 1.0e-4);
        f64::from(plan.integrals((end_s - step_s).max(0.0), end_s).0 / step_s.min(end_s))
    }

    /// Heading of the plane that the maneuver is to be in, rad from the world's x axis, where the nose points.
    pub fn heading_rad(&self) -> f64 {
        self.prepared.heading_rad
    }

    /// Full turns of the maneuver.
    pub fn turns(&self) -> i32 {
        let table = &self.prepared.table;
        self.prepared.solution.as_ref().map_or_else(
            || ((table.end.theta - table.start.theta) / core::f32::consts::TAU).round() as i32,
            |s| s.extremal.turns,
        )
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
    table.check_for(config.hash(), &config.plan_limits())?;
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
        extent.check(room, heading_rad)?;
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

//! From a request to a flown maneuver: solve, pack, check the room, fly, compare with truth.

use std::path::Path;
use std::time::Instant;

use mintime_firmware::config::VehicleConfig;
use mintime_shared::messages::PROTOCOL_VERSION;
use mintime_shared::model::{Limits, LimitsError, State};
use mintime_shared::replay::Plan;
use mintime_shared::table::{MAX_TABLE_BYTES, ManeuverTable, TableError};
use mintime_simulator::{ParameterError, SimulatorError, Truth, VehicleParameters};
use nalgebra::Vector3;

use crate::flight::{FlightError, FlightPlan, FlightResult, HostedVehicle, Trace, Witness, fly};
use crate::pack::{PackError, pack};
use crate::solver::{Request, Solution, SolveError, Turns, solve};

/// Free space around the planned path that catching the vehicle may take, m: this, ...
pub const CATCH_DISTANCE_M: f64 = 1.0;
/// ... plus this for each m/s of the path's peak speed, s. Drag and lag of a vehicle that has not learned its maneuver
/// leave it with a part of that speed.
pub const CATCH_TIME_S: f64 = 0.25;
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
    },
    /// Fly these bytes.
    Table(Vec<u8>),
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
    /// Behind the start (negative) and ahead of it.
    pub x_m: (f64, f64),
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
    fn check(&self, room: &Room) -> Result<(), MissionError> {
        let catch = self.catch_distance_m();
        let sides = [
            ("behind", -room.x_m.0, -self.x_m.0),
            ("ahead", room.x_m.1, self.x_m.1),
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
    /// The table starts in motion or tilted: nobody can hover there.
    #[error(
        "the maneuver does not start at rest and level, so it cannot be flown from a hover: make one that does"
    )]
    NotFromRest,
    /// The simulation cannot start.
    #[error(transparent)]
    Simulator(#[from] SimulatorError),
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
}

/// A flown mission.
#[derive(Debug)]
pub struct Flown {
    /// What was flown.
    pub prepared: Prepared,
    /// How it went; an error for a flight that was lost.
    pub flight: Result<FlightResult, FlightError>,
    /// What was logged on the side.
    pub trace: Trace,
    /// Virtual time that the flight took, s.
    pub virtual_time_s: f64,
    /// Wall time that solving and flying took, s.
    pub wall_time_s: f64,
}

/// Truth less plan, at one instant, in the maneuver's plane. SI units.
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
    /// Pitch rate of the vehicle: the plan ends at rest.
    pub pitch_rate_radps: f64,
}

impl PlanarError {
    fn new(difference: State<f64>, truth: &Truth) -> Self {
        let State { x, vx, z, vz, theta } = difference;
        let [_, pitch_rate_radps, _] = truth.rates_radps;
        Self { x_m: x, vx_mps: vx, z_m: z, vz_mps: vz, theta_rad: theta, pitch_rate_radps }
    }
}

impl Flown {
    /// Truth when the maneuver began less the planned start at the hover point. `None` if it never began.
    pub fn start_error(&self) -> Option<PlanarError> {
        let truth = self.trace.start.as_ref()?;
        let planned = self.prepared.table.start.cast::<f64>();
        let origin = State { x: planned.x, z: planned.z, ..State::origin() };
        Some(PlanarError::new(truth.planar(self.heading_rad()).minus(planned.minus(origin)), truth))
    }

    /// Truth when the table's time had passed less the planned end, positions relative to the true start.
    pub fn final_error(&self) -> Option<PlanarError> {
        let (start, end) = (self.trace.start.as_ref()?, self.trace.end.as_ref()?);
        let table = &self.prepared.table;
        let began = start.planar(self.heading_rad());
        let planned = table.end.cast::<f64>();
        let from = table.start.cast::<f64>();
        // θ counts from where the vehicle's own turn counter stood at the start, in whole turns.
        let turn = core::f64::consts::TAU;
        let counted = ((began.theta - from.theta) / turn).round() * turn;
        let flown = end.planar(self.heading_rad());
        let relative = State {
            x: flown.x - began.x - (planned.x - from.x),
            vx: flown.vx - planned.vx,
            z: flown.z - began.z - (planned.z - from.z),
            vz: flown.vz - planned.vz,
            theta: flown.theta - counted - planned.theta,
        };
        Some(PlanarError::new(relative, end))
    }

    /// Heading of the maneuver's plane, rad.
    pub fn heading_rad(&self) -> f64 {
        f64::from(self.prepared.table.heading_rad)
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
    let config = VehicleConfig::REFERENCE;
    let (table, solution) = match source {
        Source::Solve { to, limits, turns } => {
            // The solver takes limits that cannot sink; a vehicle that must hover first cannot.
            limits.validate()?;
            let request = Request { from: State::origin(), to: *to, limits: *limits, turns: *turns };
            let solution = solve(&request)?;
            (pack(&solution.extremal, config.hash(), 0.0)?, Some(solution))
        }
        Source::Table(bytes) => (ManeuverTable::decode(bytes)?, None),
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
        extent.check(room)?;
    }
    Ok(Prepared { bytes: buffer[..length].to_vec(), table, solution, extent })
}

/// Flies a prepared maneuver on the hosted vehicle.
///
/// # Errors
/// [`MissionError::Simulator`]. A flight that fails is not an error here: see [`Flown::flight`].
pub fn fly_hosted(
    mission: &Mission,
    prepared: Prepared,
    witness: &mut impl Witness,
) -> Result<Flown, MissionError> {
    let clock = Instant::now();
    let floor_m = mission
        .room
        .map_or_else(|| prepared.extent.z_m.0 - prepared.extent.catch_distance_m(), |room| room.z_m.0);
    let heading_rad = f64::from(prepared.table.heading_rad);
    let duration_s = f64::from(prepared.table.duration_s());
    let mut vehicle =
        HostedVehicle::new(&mission.plant.parameters, mission.seed, floor_m, heading_rad, duration_s)?;
    let plan = FlightPlan { table: prepared.table.clone(), start_m: Vector3::zeros() };
    let flight = fly(&mut vehicle, &plan, witness);
    let virtual_time_s = vehicle.now_ns() as f64 * 1e-9;
    Ok(Flown {
        prepared,
        flight,
        trace: vehicle.into_trace(),
        virtual_time_s,
        wall_time_s: clock.elapsed().as_secs_f64(),
    })
}

//! What a campaign of flights has seen so far: the file that is kept, and what a report is made of.

use std::io::Write as _;
use std::path::{Path, PathBuf};

use mintime_shared::table::{MAX_TABLE_BYTES, ManeuverTable};
use serde::{Deserialize, Serialize};

use super::parameters::HEADING_MAX_RAD;
use crate::flight_log::{OutputError, write_whole};

/// Name of the history in its folder.
pub const HISTORY_FILE: &str = "history.json";
/// Name of the best table so far in its folder.
pub const TABLE_FILE: &str = "best.table";

/// Position error at the end that is good enough, m.
pub const POSITION_TOLERANCE_M: f64 = 0.05;
/// Velocity error at the end that is good enough, m/s.
pub const VELOCITY_TOLERANCE_MPS: f64 = 0.15;
/// Angle error at the end that is good enough, rad.
pub const ANGLE_TOLERANCE_RAD: f64 = 0.05;

/// A state less the planned one, in the maneuver's plane. SI units.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct StateError {
    /// Position along the heading, m.
    pub x_m: f64,
    /// Velocity along the heading, m/s.
    pub vx_mps: f64,
    /// Height, m.
    pub z_m: f64,
    /// Vertical velocity, m/s.
    pub vz_mps: f64,
    /// Pitch angle, rad.
    pub theta_rad: f64,
}

impl StateError {
    /// As (x, vx, z, vz, θ).
    pub fn to_array(self) -> [f64; 5] {
        [self.x_m, self.vx_mps, self.z_m, self.vz_mps, self.theta_rad]
    }

    /// From (x, vx, z, vz, θ).
    pub fn from_array([x_m, vx_mps, z_m, vz_mps, theta_rad]: [f64; 5]) -> Self {
        Self { x_m, vx_mps, z_m, vz_mps, theta_rad }
    }

    /// Distance, m.
    pub fn position_m(&self) -> f64 {
        self.x_m.hypot(self.z_m)
    }

    /// Speed, m/s.
    pub fn velocity_mps(&self) -> f64 {
        self.vx_mps.hypot(self.vz_mps)
    }

    /// The largest of distance, speed and angle, each in units of its tolerance: at most 1 is good enough.
    pub fn in_tolerances(&self) -> f64 {
        (self.position_m() / POSITION_TOLERANCE_M)
            .max(self.velocity_mps() / VELOCITY_TOLERANCE_MPS)
            .max(self.theta_rad.abs() / ANGLE_TOLERANCE_RAD)
    }

    /// Component by component.
    #[must_use]
    pub fn minus(&self, other: &Self) -> Self {
        let (a, b) = (self.to_array(), other.to_array());
        Self::from_array(core::array::from_fn(|i| a[i] - b[i]))
    }
}

/// Motion out of the maneuver's plane, which is that of the heading asked for. SI units.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Across {
    /// Position to the left of the heading, from the start, m.
    pub y_m: f64,
    /// Velocity, m/s.
    pub vy_mps: f64,
}

/// One flight of a campaign.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct FlightEntry {
    /// `completed`, `aborted`, `not-triggered`, `not-caught` or `lost`.
    pub outcome: String,
    /// Why it went otherwise than planned.
    pub reason: Option<String>,
    /// Duration of the table that was flown, s.
    pub duration_s: f64,
    /// When the maneuver began, motion capture's state less the planned start.
    pub start_error: Option<StateError>,
    /// When the table's duration had passed, motion capture's state less the planned end; positions count from where the
    /// maneuver began. `None` where the flight did not come so far.
    pub final_error: Option<StateError>,
    /// The same less what the start's error explains: what the correction works on.
    pub systematic_error: Option<StateError>,
    /// How far out of the maneuver's plane it ended. `None` as for `final_error`.
    #[serde(default)]
    pub across: Option<Across>,
    /// `across.y_m` less what the start explains: what the heading is corrected by, m.
    #[serde(default)]
    pub systematic_across_m: Option<f64>,
    /// The final error by the simulator's truth; `None` on a real vehicle.
    pub true_final_error: Option<StateError>,
    /// `across` by the simulator's truth.
    #[serde(default)]
    pub true_across: Option<Across>,
    /// Whether the Jacobian was computed afresh, about this flight's table, for the correction that follows it.
    pub relinearised: bool,
    /// The table's bytes, hexadecimal.
    pub table: String,
}

/// What the vehicle turned out to be before the first flight.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct IdentifiedResponse {
    /// True over commanded thrust.
    pub thrust_scale: f64,
    /// Its standard error.
    pub thrust_scale_std: f64,
    /// Time constant of the rotors' speed, s.
    pub rotor_lag_s: f64,
    /// What the firmware's lead leaves of it, s.
    pub response_s: f64,
}

/// A campaign: everything that was planned, flown and learned.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct History {
    /// The maneuver in words.
    pub maneuver: String,
    /// What flies: `hosted`, `virtual` or a port.
    pub vehicle: String,
    /// Seed of a simulated vehicle.
    pub seed: Option<u64>,
    /// What hover and hops said of it; `None` where it was not asked.
    pub identified: Option<IdentifiedResponse>,
    /// Heading of the plane that is asked for, rad. That of a learned table differs by what an askew gyro makes up for.
    #[serde(default)]
    pub heading_rad: f64,
    /// Duration of the maneuver planned for this vehicle, s.
    pub planned_duration_s: f64,
    /// Duration of the best table so far, s.
    pub learned_duration_s: f64,
    /// Least duration within the limits asked for, of a vehicle without lag or drag, s.
    pub optimum_duration_s: f64,
    /// Whether the final error came within the tolerances and stayed there.
    pub converged: bool,
    /// Why learning ended; `None` while it is under way.
    pub reason: Option<String>,
    /// Flights that taught, in order.
    pub flights: Vec<FlightEntry>,
    /// Which of them flew the best table, from 0.
    pub best: Option<usize>,
    /// Flights of the best table, after learning.
    pub repeats: Vec<FlightEntry>,
}

/// Why a history cannot be kept or read.
#[derive(Debug, thiserror::Error)]
pub enum HistoryError {
    /// The folder cannot be made.
    #[error("the folder {} cannot be made ({source}): choose another with --output", folder.display())]
    Folder {
        /// The folder.
        folder: PathBuf,
        /// What the system said.
        source: std::io::Error,
    },
    /// A file in it cannot be written. The one before it is as it was.
    #[error("{0}; what was kept before is as it was")]
    Output(#[from] OutputError),
    /// A history cannot be read.
    #[error("{} cannot be read ({source}): give the folder that `mintime learn` has written", path.display())]
    Read {
        /// Its path.
        path: PathBuf,
        /// What the system said.
        source: std::io::Error,
    },
    /// A history is none.
    #[error("{} is no history of flights: {source}", path.display())]
    Content {
        /// Its path.
        path: PathBuf,
        /// What is wrong.
        source: serde_json::Error,
    },
}

impl History {
    /// One in which nothing has been flown.
    pub fn of(maneuver: &str, vehicle: &str, seed: Option<u64>) -> Self {
        Self {
            maneuver: maneuver.to_owned(),
            vehicle: vehicle.to_owned(),
            seed,
            identified: None,
            heading_rad: 0.0,
            planned_duration_s: 0.0,
            learned_duration_s: 0.0,
            optimum_duration_s: 0.0,
            converged: false,
            reason: None,
            flights: Vec::new(),
            best: None,
            repeats: Vec::new(),
        }
    }

    /// Writes the history and the best table into a folder, each as a whole: whatever fails, the old file stays.
    ///
    /// # Errors
    /// [`HistoryError`].
    pub fn save(&self, folder: &Path, best_table: &[u8]) -> Result<(), HistoryError> {
        make_folder(folder)?;
        let text = format!("{:#}\n", serde_json::json!(self));
        write(&folder.join(TABLE_FILE), best_table)?;
        write(&folder.join(HISTORY_FILE), text.as_bytes())
    }

    /// Reads the history in a folder.
    ///
    /// # Errors
    /// [`HistoryError`].
    pub fn load(folder: &Path) -> Result<Self, HistoryError> {
        let path = folder.join(HISTORY_FILE);
        let text =
            std::fs::read(&path).map_err(|source| HistoryError::Read { path: path.clone(), source })?;
        serde_json::from_slice(&text).map_err(|source| HistoryError::Content { path, source })
    }

    /// The history in which a table was learned: that in the table's own folder, if a flight in it flew this very table.
    pub fn beside(path: &Path, table: &ManeuverTable) -> Option<Self> {
        let bytes = hexadecimal(table);
        let history = Self::load(path.parent().unwrap_or(Path::new(""))).ok()?;
        let off_rad = history.heading_rad - f64::from(table.heading_rad);
        // No campaign has turned a table further.
        let credible = off_rad.abs() <= HEADING_MAX_RAD + 1.0e-6;
        (credible && history.flights.iter().any(|flight| flight.table == bytes)).then_some(history)
    }
}

/// A table's bytes, as a history keeps them.
pub(super) fn hexadecimal(table: &ManeuverTable) -> String {
    let mut buffer = [0; MAX_TABLE_BYTES];
    // The buffer holds every table.
    let length = table.encode(&mut buffer).unwrap_or(0);
    buffer[..length].iter().map(|byte| format!("{byte:02x}")).collect()
}

/// Makes a folder and sees to it that the history can be written there, before anything flies.
///
/// # Errors
/// [`HistoryError`].
pub fn check_folder(folder: &Path) -> Result<(), HistoryError> {
    make_folder(folder)?;
    crate::flight_log::check_writable(&folder.join(HISTORY_FILE))?;
    Ok(crate::flight_log::check_writable(&folder.join(TABLE_FILE))?)
}

/// Gives an earlier history in a folder another name, and an earlier table likewise: a campaign replaces nobody's work.
///
/// # Errors
/// [`HistoryError`].
pub fn keep_old(folder: &Path) -> Result<(), HistoryError> {
    let named = |stem: &str, number: u32, ending: &str| folder.join(format!("{stem}-{number}.{ending}"));
    let free = |n: &u32| !named("history", *n, "json").exists() && !named("best", *n, "table").exists();
    let Some(number) = (1..=u32::MAX).find(free) else { return Ok(()) };
    for (from, to) in [
        (folder.join(HISTORY_FILE), named("history", number, "json")),
        (folder.join(TABLE_FILE), named("best", number, "table")),
    ] {
        if from.exists() {
            let failed = |source| OutputError::Interrupted { path: to.clone(), source };
            std::fs::rename(&from, &to).map_err(failed)?;
        }
    }
    Ok(())
}

fn make_folder(folder: &Path) -> Result<(), HistoryError> {
    std::fs::create_dir_all(folder)
        .map_err(|source| HistoryError::Folder { folder: folder.to_owned(), source })
}

fn write(path: &Path, bytes: &[u8]) -> Result<(), HistoryError> {
    write_whole(path, |file| {
        let interrupted = |source| OutputError::Interrupted { path: path.to_owned(), source };
        file.write_all(bytes).map_err(interrupted)
    })
    .map_err(|error: OutputError| HistoryError::Output(error))
}

//! Benchmarking: how much slower a flight is than the fastest possible one between the same two states.
//!
//! ```text
//! CSV, MCAP ─→ flight ─→ find: departure, arrival ─→ plausible ─→ plane ─→ T* by the solver ─→ score = T / T*
//!                ↑
//! linear: a feedback controller on the planning model
//! ```
//!
//! The score is that of Hehn, Ritz and D'Andrea, "Performance benchmarking of quadrotor systems using time-optimal
//! control", Autonomous Robots 33:69-88, 2012, doi 10.1007/s10514-012-9282-3. T* is computed between the states in which
//! the vehicle really departed and arrived: every piece of a fastest maneuver is a fastest maneuver, so a flight along
//! one scores 1 whatever the tolerances.
//!
//! ```
//! use mintime::benchmark::{Gains, Rules, score_linear};
//!
//! let score = score_linear(&Gains::default(), &Rules::default(), 5.0, 5.0)?;
//! assert!(score.score > 1.0 && score.optimal.certificate.verified);
//! # Ok::<(), mintime::benchmark::BenchmarkError>(())
//! ```

mod builder;
mod columns;
mod csv_log;
mod error;
mod find;
mod flight;
mod linear;
mod map;
mod mcap_log;
mod plausible;
mod read_error;
mod score;

use std::path::Path;

pub use csv_log::read_csv;
pub use error::{BenchmarkError, Candidate, Nearest, Which};
pub use find::{Arrival, Goal, Leg, Tolerance, find_leg, hovers};
pub use flight::{Declared, FIT_HALF_S, Flight, Remark, Sample};
pub use linear::{Gains, LONGEST_S, STEP_S, as_flight, fly, fly_linear, score_linear};
pub use map::{Cell, Grid, ScoreMap, map_linear};
pub use mcap_log::read_mcap;
pub use read_error::ReadError;
pub use score::{Rules, Score, score};

/// Reads a flight log: MCAP of `mintime fly` by its first bytes, anything else as CSV.
///
/// # Errors
/// [`ReadError`].
pub fn read(path: &Path) -> Result<Flight, ReadError> {
    let file = |source| ReadError::File { path: path.to_owned(), source };
    if !std::fs::metadata(path).map_err(file)?.is_file() {
        return Err(ReadError::NotAFile { path: path.to_owned() });
    }
    let bytes = std::fs::read(path).map_err(file)?;
    if bytes.is_empty() {
        return Err(ReadError::Empty);
    }
    if bytes.starts_with(mcap_log::MAGIC) {
        return read_mcap(&bytes);
    }
    match path.extension() {
        Some(ending) if ending.eq_ignore_ascii_case("mcap") => Err(ReadError::NotMcap),
        _ => read_csv(&bytes),
    }
}

impl Flight {
    /// The part of a flight between two times, s by its own clock.
    ///
    /// # Errors
    /// [`BenchmarkError::Window`] where fewer than two samples are left.
    pub fn window(&self, from_s: f64, to_s: f64) -> Result<Self, BenchmarkError> {
        let inside = self.samples().iter().filter(|s| (from_s..=to_s).contains(&s.t_s)).copied();
        let (first_s, last_s) = self.span_s();
        let part = Self::new(inside.collect()).ok_or(BenchmarkError::Window { first_s, last_s })?;
        let declared = self.declared.filter(|d| (from_s..=to_s).contains(&d.start_s));
        Ok(Self { remarks: self.remarks.clone(), declared, ..part })
    }
}

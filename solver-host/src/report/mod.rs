//! The flight report: one picture of a maneuver, planned against flown, as SVG or PNG.

mod data;

pub use crate::flight_log::{OutputError, PlannedSample};
pub use data::{FlownSample, ReportData};

use std::path::{Path, PathBuf};

/// Why a report was not written.
#[derive(Debug, thiserror::Error)]
pub enum ReportError {
    /// The file cannot be written.
    #[error(transparent)]
    Output(#[from] OutputError),
    /// The file's ending names no format.
    #[error("{} ends neither in .svg nor in .png: choose one of these endings", path.display())]
    UnknownFormat {
        /// The path as given.
        path: PathBuf,
    },
    /// The picture could not be turned into pixels.
    #[error("the picture could not be drawn as PNG ({reason}): write an .svg file instead")]
    Rendering {
        /// What the renderer said.
        reason: String,
    },
}

/// Checks that a report can be written to `path` (format and folder), without creating it: call it before the flight.
///
/// # Errors
/// What [`write`] would return, as far as it can be known beforehand.
pub fn check(_path: &Path) -> Result<(), ReportError> {
    Ok(())
}

/// The picture as SVG text.
pub fn render(_data: &ReportData) -> String {
    String::new()
}

/// Writes the picture to `path`, as SVG or PNG by the file's ending. The file appears only when it is whole.
///
/// # Errors
/// [`ReportError`]: unknown ending, a path that cannot be written to, a full disk.
pub fn write(_data: &ReportData, _path: &Path) -> Result<(), ReportError> {
    Ok(())
}

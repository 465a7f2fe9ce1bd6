//! The flight report: one picture of a maneuver, planned against flown, as SVG or PNG.
//!
//! The path in the vertical plane, both axes to one scale, with the vehicle drawn along it as in the paper's Fig. 1
//! and 4; pitch, pitch rate, thrust per mass and position over time as in its Fig. 6 and 7, with limits, segments,
//! singular arcs and switching functions; and a small table of facts. [`render`] is a pure function of the data: same
//! data, same text.

pub mod benchmark;
mod data;
mod layout;
mod page;
mod path_panel;
mod quantities;
mod time_panel;
mod vehicle;
mod view;

use std::path::Path;

use crate::drawing::file;
pub use crate::drawing::{PNG_SCALE, PictureError as ReportError};
pub use crate::flight_log::{OutputError, PlannedSample};
pub use data::{FlownSample, ReportData};

/// Checks that a report can be written to `path` (ending and folder), without creating it: call it before the flight.
///
/// # Errors
/// What [`write()`] would return, as far as it can be known beforehand.
pub fn check(path: &Path) -> Result<(), ReportError> {
    file::check(path)
}

/// The picture as SVG text, 1280 units wide and as high as it needs.
///
/// Samples whose time or state is not finite, or beyond any flight, are left out; so are single rates, thrusts and
/// switching functions. Nothing planned or nothing flown gives a picture without them.
pub fn render(data: &ReportData) -> String {
    page::draw(data)
}

/// Writes the picture to `path`, as SVG or PNG by the file's ending. The file appears only when it is whole. A PNG has
/// [`PNG_SCALE`] pixels per unit of the SVG.
///
/// # Errors
/// [`ReportError`]: unknown ending, a path that cannot be written to, a full disk.
pub fn write(data: &ReportData, path: &Path) -> Result<(), ReportError> {
    file::write(&render(data), path)
}

#[cfg(test)]
mod tests;

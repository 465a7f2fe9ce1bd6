//! The flight report: one picture of a maneuver, planned against flown, as SVG or PNG.
//!
//! The path in the vertical plane, both axes to one scale, with the vehicle drawn along it as in the paper's Fig. 1
//! and 4; pitch, pitch rate, thrust per mass and position over time as in its Fig. 6 and 7, with limits, segments,
//! singular arcs and switching functions; and a small table of facts. [`render`] is a pure function of the data: same
//! data, same text.
//!
//! The SVG asks for common sans-serif fonts by name. The PNG is drawn with Noto Sans, embedded from the crate
//! `ttf-noto-sans` (the font is licensed under Apache-2.0, Copyright 2012 Google Inc.; the crate carries the licence
//! text), and with no font of the machine, so that it looks the same everywhere and works where there are none. A
//! font of our own strokes would have saved 400 kB and cost legibility, kerning and every letter we forgot.

mod axis;
pub mod benchmark;
mod data;
mod layout;
mod page;
mod path_panel;
mod png;
mod quantities;
mod style;
mod svg;
mod time_panel;
mod vehicle;
mod view;

use std::io::Write as _;
use std::path::{Path, PathBuf};

pub use crate::flight_log::{OutputError, PlannedSample};
use crate::flight_log::{check_writable, write_whole};
pub use data::{FlownSample, ReportData};
pub use png::PNG_SCALE;

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

#[derive(Clone, Copy)]
enum Format {
    Svg,
    Png,
}

impl Format {
    fn of(path: &Path) -> Result<Self, ReportError> {
        match path.extension() {
            Some(ending) if ending.eq_ignore_ascii_case("svg") => Ok(Self::Svg),
            Some(ending) if ending.eq_ignore_ascii_case("png") => Ok(Self::Png),
            _ => Err(ReportError::UnknownFormat { path: path.to_owned() }),
        }
    }
}

/// Checks that a report can be written to `path` (ending and folder), without creating it: call it before the flight.
///
/// # Errors
/// What [`write()`] would return, as far as it can be known beforehand.
pub fn check(path: &Path) -> Result<(), ReportError> {
    Format::of(path)?;
    Ok(check_writable(path)?)
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
    save(render(data), path)
}

/// Writes SVG text to `path`, as SVG or PNG by the file's ending.
fn save(svg: String, path: &Path) -> Result<(), ReportError> {
    let format = Format::of(path)?;
    let bytes = match format {
        Format::Svg => svg.into_bytes(),
        Format::Png => png::encode(&svg)?,
    };
    write_whole::<OutputError>(path, |file| {
        file.write_all(&bytes).map_err(|source| OutputError::Interrupted { path: path.to_owned(), source })
    })?;
    Ok(())
}

#[cfg(test)]
mod tests;

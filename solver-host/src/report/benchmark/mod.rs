//! Pictures of benchmarks: a flight beside the fastest maneuver, and a map of scores.

mod map;
mod score;

use std::path::Path;

use super::ReportError;
use crate::benchmark::{Score, ScoreMap};
use crate::drawing::file;

/// The picture of a score: path, position and pitch of the flight and of the fastest maneuver, as SVG text.
pub fn render_score(score: &Score, title: &str, subtitle: &[String]) -> String {
    score::draw(score, title, subtitle)
}

/// Writes [`render_score`] to a file, SVG or PNG by its ending.
///
/// # Errors
/// Those of [`super::write()`].
pub fn write_score(score: &Score, title: &str, subtitle: &[String], path: &Path) -> Result<(), ReportError> {
    file::write(&render_score(score, title, subtitle), path)
}

/// The picture of a map of scores, as SVG text.
pub fn render_map(map: &ScoreMap, title: &str, subtitle: &[String]) -> String {
    map::draw(map, title, subtitle)
}

/// Writes [`render_map`] to a file, SVG or PNG by its ending.
///
/// # Errors
/// Those of [`super::write()`].
pub fn write_map(map: &ScoreMap, title: &str, subtitle: &[String], path: &Path) -> Result<(), ReportError> {
    file::write(&render_map(map, title, subtitle), path)
}

#[cfg(test)]
mod tests;

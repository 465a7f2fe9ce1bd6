//! Pictures of benchmarks: a flight beside the fastest maneuver, and a map of scores.

mod map;
mod plot;
mod score;

use std::path::Path;

use super::ReportError;
use crate::benchmark::{Score, ScoreMap};
use crate::drawing::file;
use crate::drawing::style::{FONT, INK, MARGIN, MUTED, TEXT_SIZE, TITLE_SIZE, WIDTH};
use crate::drawing::svg::{Rect, Svg, TextStyle, escape, fit, px};

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

/// Title and subtitle. Returns where the panels may begin.
fn header(svg: &mut Svg, title: &str, subtitle: &[String]) -> f64 {
    let width = WIDTH - 2.0 * MARGIN;
    let mut y = MARGIN + 20.0;
    svg.text((MARGIN, y), &fit(title, TITLE_SIZE, width), TextStyle::new(TITLE_SIZE, INK).bold());
    for line in subtitle {
        y += 25.0;
        svg.text((MARGIN, y), &fit(line, TEXT_SIZE, width), TextStyle::new(TEXT_SIZE, MUTED));
    }
    y
}

/// The page around its content.
fn page(title: &str, subtitle: &[String], height: f64, content: Svg) -> String {
    let mut page = Svg::default();
    let (w, h) = (px(WIDTH), px(height));
    page.raw(&format!(
        r#"<svg xmlns="http://www.w3.org/2000/svg" width="{w}" height="{h}" viewBox="0 0 {w} {h}" font-family="{FONT}" role="img">"#
    ));
    page.raw(&format!("<title>{}</title>", escape(title)));
    page.raw(&format!("<desc>{}</desc>", escape(&subtitle.join(" "))));
    page.rect(&Rect { x: 0.0, y: 0.0, width: WIDTH, height }, "fill=\"#ffffff\"");
    page.raw(&content.finish());
    page.raw("</svg>");
    page.finish()
}

#[cfg(test)]
mod tests;

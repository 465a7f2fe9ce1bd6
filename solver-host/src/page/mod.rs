//! The page: a flight as one self-contained HTML file, to look at in any browser, without a network.
//!
//! [`Page::collect`] takes what a flight left behind, [`render`] makes the text of the page, [`write()`] writes it. What can
//! be said in tables stands in the HTML and needs no script; curves and the animation are drawn by the script from the data
//! that the page carries as JSON in its element `data`. The sources of the front end are the files of `front/`. A content
//! security policy forbids the page to load or send anything, and to run any script but its own.
//!
//! | module | what |
//! |---|---|
//! | `data`, `columns` | the page's data, and how series of numbers are stored in it |
//! | `collect`, `series` | a flight as these data |
//! | `certificate`, `bytes` | the minimum principle law by law; the maneuver table byte by byte |
//! | `learning` | what repeated flights taught, where somebody says so |
//! | `html`, `sections` | the parts of the page that are tables |

mod bytes;
mod certificate;
mod collect;
mod columns;
mod data;
mod health;
mod html;
mod learning;
mod sections;
mod series;

use std::io::Write as _;
use std::path::{Path, PathBuf};

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use sha2::{Digest as _, Sha256};

pub use crate::flight_log::OutputError;
use crate::flight_log::{check_writable, write_whole};
pub use bytes::{TableBytes, TableField};
pub use certificate::{Law, Laws};
pub use collect::Sources;
pub use columns::Column;
pub use data::{Fact, Kind, Moment, Page, Span, Timing};
pub use health::Counter;
pub use learning::{Component, Learning, LearningFlight};
pub use series::{CameraSeries, FlightSeries, PlanSeries, RecordSeries};

/// Why a page was not written.
#[derive(Debug, thiserror::Error)]
pub enum PageError {
    /// The file cannot be written.
    #[error(transparent)]
    Output(#[from] OutputError),
    /// A browser would not know the file for a page.
    #[error("{} does not end in .html: choose this ending", path.display())]
    UnknownFormat {
        /// The path as given.
        path: PathBuf,
    },
}

/// The frame of the page; `{{name}}` is replaced.
const TEMPLATE: &str = include_str!("front/page.html");
const STYLE: &str = include_str!("front/page.css");
/// Runs before anything is drawn.
const THEME: &str = include_str!("front/theme.js");
/// Runs when all is there; the parts share one scope.
const SCRIPT: &str = concat!(
    "\"use strict\";\n(() => {\n",
    include_str!("front/data.js"),
    include_str!("front/panels.js"),
    include_str!("front/scale.js"),
    include_str!("front/plot.js"),
    include_str!("front/gestures.js"),
    include_str!("front/scene.js"),
    include_str!("front/player.js"),
    include_str!("front/timeline.js"),
    include_str!("front/bytes.js"),
    include_str!("front/learning.js"),
    include_str!("front/self-test.js"),
    include_str!("front/main.js"),
    "})();\n"
);

/// Checks that a page can be written to `path` (ending and folder), without creating it: call it before the flight.
///
/// # Errors
/// What [`write()`] would return, as far as it can be known beforehand.
pub fn check(path: &Path) -> Result<(), PageError> {
    if !path.extension().is_some_and(|e| e.eq_ignore_ascii_case("html") || e.eq_ignore_ascii_case("htm")) {
        return Err(PageError::UnknownFormat { path: path.to_owned() });
    }
    Ok(check_writable(path)?)
}

/// The page as text. The same data give the same text.
pub fn render(page: &Page) -> String {
    // Within JSON `<` stands in strings only, where it may be written otherwise: so nothing ends the element early.
    let data = serde_json::to_string(page).unwrap_or_default().replace('<', "\\u003c");
    html::fill(TEMPLATE, |name| match name {
        "policy" => format!(
            "default-src 'none'; style-src 'unsafe-inline'; script-src {} {}; img-src data:; base-uri 'none'; form-action 'none'",
            source(THEME),
            source(SCRIPT)
        ),
        "title" => html::escape(&page.title),
        "style" => STYLE.to_owned(),
        "theme" => THEME.to_owned(),
        "script" => SCRIPT.to_owned(),
        "data" => data.clone(),
        section => sections::render(section, page),
    })
}

/// Writes the page to `path`. The file appears only when it is whole.
///
/// # Errors
/// [`PageError`]: unknown ending, a path that cannot be written to, a full disk.
pub fn write(page: &Page, path: &Path) -> Result<(), PageError> {
    check(path)?;
    let text = render(page);
    write_whole::<OutputError>(path, |file| {
        file.write_all(text.as_bytes())
            .map_err(|source| OutputError::Interrupted { path: path.to_owned(), source })
    })?;
    Ok(())
}

/// A script as the content security policy names it: by its hash.
fn source(script: &str) -> String {
    format!("'sha256-{}'", STANDARD.encode(Sha256::digest(script)))
}

#[cfg(test)]
mod tests;

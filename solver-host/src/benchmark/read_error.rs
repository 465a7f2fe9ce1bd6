//! Why a log could not be read. Each sentence says where and what to do.

use std::io;
use std::path::PathBuf;

/// Why a flight log could not be read.
#[derive(Debug, thiserror::Error)]
pub enum ReadError {
    /// The file cannot be opened or read.
    #[error("{} cannot be read ({source})", path.display())]
    File {
        /// The path as given.
        path: PathBuf,
        /// What the system said.
        source: io::Error,
    },
    /// Not a regular file.
    #[error("{} is not a regular file: give a flight log, .mcap or .csv", path.display())]
    NotAFile {
        /// The path as given.
        path: PathBuf,
    },
    /// Nothing in it.
    #[error("the log is empty: it holds no samples")]
    Empty,
    /// Text in an encoding other than UTF-8.
    #[error("the log is text in UTF-16: save it as UTF-8")]
    Utf16,
    /// Named `.mcap`, but not one.
    #[error("the log does not begin like an MCAP file: it is damaged, or something else")]
    NotMcap,
    /// Readable as MCAP, but with no pose.
    #[error(
        "the log holds no readable messages on the topic /truth of `mintime fly`{}: of other vehicles, give a CSV with the \
         columns t_s, x_m, z_m and theta_rad", found.as_ref().map(|f| format!(" ({f})")).unwrap_or_default()
    )]
    NoTruth {
        /// Why reading ended early, if it did.
        found: Option<String>,
    },
    /// A message that is not what its schema says.
    #[error(
        "message {message} of /truth cannot be understood ({reason}): the log is damaged, or of another version"
    )]
    Message {
        /// Its number, from 1.
        message: usize,
        /// What the parser said.
        reason: String,
    },
    /// A needed column is missing.
    #[error("the log has no column {expected}: its header reads `{found}`{hint}")]
    MissingColumn {
        /// The documented name.
        expected: String,
        /// The header as it stands.
        found: String,
        /// What else might help.
        hint: &'static str,
    },
    /// A column whose unit is missing or unknown.
    #[error("the column `{found}` does not say its unit: call it {expected} (known units: {units})")]
    NoUnit {
        /// The header's cell.
        found: String,
        /// The documented name.
        expected: String,
        /// The units known.
        units: String,
    },
    /// Two columns for one quantity.
    #[error("both columns `{first}` and `{second}` hold {expected}: remove or rename one")]
    TwoColumns {
        /// The one.
        first: String,
        /// The other.
        second: String,
        /// The documented name.
        expected: String,
    },
    /// A cell that holds no finite number.
    #[error(
        "line {line}: `{text}` in the column {column} is not a finite number: correct or remove the line"
    )]
    NotANumber {
        /// Line, from 1.
        line: u64,
        /// The column's header.
        column: String,
        /// What stands there.
        text: String,
    },
    /// A line with too few or too many cells, not at the end.
    #[error("line {line} has {found} cells where the header has {expected}: the log is damaged there")]
    Ragged {
        /// Line, from 1.
        line: u64,
        /// Cells in it.
        found: usize,
        /// Columns.
        expected: usize,
    },
    /// Time that does not grow.
    #[error(
        "{place}: time goes from {before_s} s to {now_s} s: samples must be in order of time, one at a time; sort the log \
         and remove repeated lines"
    )]
    Order {
        /// `line 7` or `message 7`.
        place: String,
        /// Time of the sample before, s.
        before_s: f64,
        /// Time of this one, s.
        now_s: f64,
    },
    /// A quaternion far from unit length.
    #[error(
        "{place}: the quaternion's length is {length}, not 1: the columns are qw, qx, qy, qz, body to world"
    )]
    NotAUnit {
        /// `line 7` or `message 7`.
        place: String,
        /// Its length.
        length: f64,
    },
    /// Numbers beyond any flight.
    #[error("{place}: {what} is beyond any flight: check the unit in the column's name")]
    Beyond {
        /// `line 7` or `message 7`.
        place: String,
        /// Which quantity.
        what: &'static str,
    },
    /// A single sample is no flight.
    #[error("the log holds {0} sample(s): at least two are needed")]
    TooShort(usize),
}

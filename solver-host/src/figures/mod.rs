//! The figures of the paper, computed and drawn again, each with the numbers behind it; and a map that it does not have.
//!
//! Ritz, Hehn, Lupashin, D'Andrea, "Quadrocopter Performance Benchmarking Using Optimal Control". Where a figure of the
//! paper is not optimal, the paper's own curve stands beside ours, dashed and in vermilion: see `docs/figures.md`.
//!
//! Every figure is a picture and a table of numbers (CSV). Computing ([`Figure::draw`]) writes nothing; the same program
//! gives the same bytes.

mod bands;
mod fig1;
mod fig3;
mod fig4;
mod fig5;
mod fig6;
mod fig7;
mod level;
mod line;
mod map;
mod path;
mod samples;
mod table1;
mod time_chart;

use std::fmt;
use std::io::Write as _;
use std::path::{Path, PathBuf};

use crate::drawing::{PictureError, file};
use crate::flight_log::{OutputError, write_whole};
use crate::learning::{IdentifyError, PlanError, StopReason};
use crate::mission::MissionError;
use crate::solver::SolveError;

/// A figure of the paper, or the map.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Figure {
    /// Vertical maneuvers, drawn along their paths.
    Fig1,
    /// T and the switching times of horizontal maneuvers.
    Fig3,
    /// Horizontal maneuvers, drawn along their paths.
    Fig4,
    /// T and the switching times of vertical maneuvers.
    Fig5,
    /// Inputs, states and switching functions of the maneuver to (5 m, 5 m).
    Fig6,
    /// The same maneuver flown: before learning, and after.
    Fig7,
    /// The model's parameters.
    Table1,
    /// T(x, z), with the lines where the structure changes. Not in the paper.
    Map,
}

impl Figure {
    /// All of them, in the order of the paper.
    pub const ALL: [Self; 8] =
        [Self::Table1, Self::Fig1, Self::Fig3, Self::Fig4, Self::Fig5, Self::Fig6, Self::Fig7, Self::Map];

    /// Its name, and that of its files.
    pub fn name(self) -> &'static str {
        match self {
            Self::Fig1 => "fig1",
            Self::Fig3 => "fig3",
            Self::Fig4 => "fig4",
            Self::Fig5 => "fig5",
            Self::Fig6 => "fig6",
            Self::Fig7 => "fig7",
            Self::Table1 => "table1",
            Self::Map => "map",
        }
    }

    /// Computes and draws it: from a fraction of a second to several seconds (the map).
    ///
    /// # Errors
    /// [`FigureError`]: none with the solver as it is.
    pub fn draw(self) -> Result<Drawn, FigureError> {
        let content = match self {
            Self::Fig1 => fig1::draw()?,
            Self::Fig3 => fig3::draw()?,
            Self::Fig4 => fig4::draw()?,
            Self::Fig5 => fig5::draw()?,
            Self::Fig6 => fig6::draw()?,
            Self::Fig7 => fig7::draw()?,
            Self::Table1 => table1::draw(),
            Self::Map => map::draw()?,
        };
        Ok(Drawn { figure: self, content })
    }
}

/// Why there is no figure.
#[derive(Debug, thiserror::Error)]
pub enum FigureError {
    /// A maneuver was not solved.
    #[error(transparent)]
    Solve(#[from] SolveError),
    /// A flight was refused.
    #[error(transparent)]
    Mission(#[from] MissionError),
    /// A flight did not reach its end.
    #[error("the simulated flight of Fig. 7 ended early ({0}), so there is nothing to draw")]
    Flight(String),
    /// The simulated vehicle was not identified.
    #[error(transparent)]
    Identify(#[from] IdentifyError),
    /// The simulated vehicle cannot fly the maneuver that it shall learn.
    #[error(transparent)]
    Plan(#[from] PlanError),
    /// Learning did not come to its end.
    #[error(
        "the simulated vehicle of Fig. 7 has not learned its maneuver ({0}), so there is nothing to draw"
    )]
    NotLearned(StopReason),
}

/// A number that a figure shows.
#[derive(Clone, Debug, PartialEq)]
pub struct Number {
    /// What it is, in a few words.
    pub what: String,
    /// In `unit`.
    pub value: f64,
    /// SI.
    pub unit: &'static str,
}

impl Number {
    fn new(what: impl Into<String>, value: f64, unit: &'static str) -> Self {
        Self { what: what.into(), value, unit }
    }
}

impl fmt::Display for Number {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { what, value, unit } = self;
        // What has no unit and no decimals is a count.
        if unit.is_empty() && value.fract() == 0.0 {
            return write!(f, "{what} {value}");
        }
        write!(f, "{what} {value:.6} {unit}")
    }
}

/// What a figure consists of.
#[derive(Clone, Debug)]
pub(crate) struct Content {
    pub(crate) title: String,
    pub(crate) svg: String,
    /// Tables: what is added to the figure's name, and CSV.
    pub(crate) tables: Vec<(&'static str, String)>,
    pub(crate) numbers: Vec<Number>,
}

/// A figure, drawn but not yet written.
#[derive(Clone, Debug)]
pub struct Drawn {
    figure: Figure,
    content: Content,
}

impl Drawn {
    /// Which it is.
    pub fn figure(&self) -> Figure {
        self.figure
    }

    /// Its title.
    pub fn title(&self) -> &str {
        &self.content.title
    }

    /// The picture, as SVG.
    pub fn svg(&self) -> &str {
        &self.content.svg
    }

    /// The tables behind the picture, each with its name and as CSV: a header with units, one row a sample.
    pub fn tables(&self) -> impl Iterator<Item = (String, &str)> {
        let name = self.figure.name();
        self.content.tables.iter().map(move |(more, csv)| (format!("{name}{more}"), csv.as_str()))
    }

    /// The numbers one would quote.
    pub fn numbers(&self) -> &[Number] {
        &self.content.numbers
    }

    /// Writes `NAME.svg`, `NAME.png` and the tables, `NAME.csv` the first of them, into a folder that exists, each of them whole or not at all; files of
    /// these names are replaced.
    ///
    /// # Errors
    /// [`PictureError`]: a folder that cannot be written to, a full disk.
    pub fn write(&self, folder: &Path) -> Result<Vec<PathBuf>, PictureError> {
        let mut written = Vec::new();
        for ending in ["svg", "png"] {
            let path = folder.join(self.figure.name()).with_extension(ending);
            file::write(self.svg(), &path)?;
            written.push(path);
        }
        for (name, csv) in self.tables() {
            let path = folder.join(name).with_extension("csv");
            write_whole::<OutputError>(&path, |out| {
                let failed = |source| OutputError::Interrupted { path: path.clone(), source };
                out.write_all(csv.as_bytes()).map_err(failed)
            })?;
            written.push(path);
        }
        Ok(written)
    }
}

//! Colours and sizes of all pictures, in one place. Blue-black, vermilion and green are apart for every kind of colour
//! vision (Okabe and Ito's palette) and in grey; lengths are SVG units, one pixel at the size of the SVG.

/// Width of the picture.
pub(crate) const WIDTH: f64 = 1280.0;
/// Margin around everything.
pub(crate) const MARGIN: f64 = 28.0;
/// From the left edge of a plot to the left edge of its axis label.
pub(crate) const AXIS_LEFT: f64 = 62.0;
/// From the lower edge of a plot with a labelled axis to the lower edge of its axis label.
pub(crate) const AXIS_BELOW: f64 = 46.0;
/// Height of the strip above a time panel that names phases or inputs.
pub(crate) const STRIP: f64 = 20.0;
/// Height of one row of the table of facts.
pub(crate) const ROW: f64 = 26.0;

/// Text, and everything planned.
pub(crate) const INK: &str = "#16263a";
/// Secondary text.
pub(crate) const MUTED: &str = "#526272";
/// Grid lines.
pub(crate) const GRID: &str = "#e4e9ee";
/// Frames of plots.
pub(crate) const FRAME: &str = "#a9b4bf";
/// Limits.
pub(crate) const LIMIT: &str = "#7b8896";
/// Planned vehicles behind flown ones.
pub(crate) const GHOST: &str = "#b4bfca";
/// Everything flown.
pub(crate) const FLOWN: &str = "#d55e00";
/// Flown before anything was learned.
pub(crate) const UNLEARNED: &str = "#0072b2";
/// Switching functions.
pub(crate) const SWITCHING: &str = "#009e73";
/// Background of singular arcs.
pub(crate) const SINGULAR: &str = "#fbefc4";
/// Thrust of vehicles drawn in hair lines.
pub(crate) const THRUST: &str = "#56b4e9";
/// As in the paper, where that is not optimal.
pub(crate) const PAPER: &str = FLOWN;
/// Background of turning forward at the limit.
pub(crate) const FORWARD: &str = "#cfe2f3";
/// Background of turning back at the limit.
pub(crate) const BACK: &str = "#f4d6cc";
/// Background of full thrust.
pub(crate) const FULL: &str = "#e3e8ee";
/// Background of least thrust.
pub(crate) const LEAST: &str = "#bfe3d5";
/// Cells of a strip, in turn.
pub(crate) const CELLS: [&str; 2] = ["#e3e8ee", "#f3f5f8"];

/// Font families, the one embedded for PNG first.
pub(crate) const FONT: &str = "'Noto Sans', 'Segoe UI', 'Helvetica Neue', Arial, sans-serif";
/// Size of the title.
pub(crate) const TITLE_SIZE: f64 = 28.0;
/// Size of axis labels, legend and table.
pub(crate) const TEXT_SIZE: f64 = 16.0;
/// Size of tick labels and strips.
pub(crate) const SMALL_SIZE: f64 = 14.0;

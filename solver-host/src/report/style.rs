//! Colours and sizes of the report, in one place. Blue-black, vermilion and green are apart for every kind of colour
//! vision (Okabe and Ito's palette) and in grey; lengths are SVG units, one pixel at the size of the SVG.

/// Width of the picture.
pub(super) const WIDTH: f64 = 1280.0;
/// Margin around everything.
pub(super) const MARGIN: f64 = 28.0;
/// From the left edge of a plot to the left edge of its axis label.
pub(super) const AXIS_LEFT: f64 = 62.0;
/// From the lower edge of a plot with a labelled axis to the lower edge of its axis label.
pub(super) const AXIS_BELOW: f64 = 46.0;
/// Height of the strip above a time panel that names phases or inputs.
pub(super) const STRIP: f64 = 20.0;
/// Height of one row of the table of facts.
pub(super) const ROW: f64 = 26.0;

/// Text, and everything planned.
pub(super) const INK: &str = "#16263a";
/// Secondary text.
pub(super) const MUTED: &str = "#526272";
/// Grid lines.
pub(super) const GRID: &str = "#e4e9ee";
/// Frames of plots.
pub(super) const FRAME: &str = "#a9b4bf";
/// Limits.
pub(super) const LIMIT: &str = "#7b8896";
/// Planned vehicles behind flown ones.
pub(super) const GHOST: &str = "#b4bfca";
/// Everything flown.
pub(super) const FLOWN: &str = "#d55e00";
/// Switching functions.
pub(super) const SWITCHING: &str = "#009e73";
/// Background of singular arcs.
pub(super) const SINGULAR: &str = "#fbefc4";
/// Cells of a strip, in turn.
pub(super) const CELLS: [&str; 2] = ["#e3e8ee", "#f3f5f8"];

/// Font families, the one embedded for PNG first.
pub(super) const FONT: &str = "'Noto Sans', 'Segoe UI', 'Helvetica Neue', Arial, sans-serif";
/// Size of the title.
pub(super) const TITLE_SIZE: f64 = 28.0;
/// Size of axis labels, legend and table.
pub(super) const TEXT_SIZE: f64 = 16.0;
/// Size of tick labels and strips.
pub(super) const SMALL_SIZE: f64 = 14.0;

//! Devices on a board, outside the chip.

mod battery;
mod bmi270;
mod dshot;
mod latency;

pub use battery::Battery;
pub use bmi270::{Bmi270, Defect, Upload};
pub use dshot::{CommandEntry, DshotEsc, FrameEnd};
pub use latency::{Latency, LatencySummary};

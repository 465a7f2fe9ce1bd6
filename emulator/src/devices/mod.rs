//! Devices on a board, outside the chip.

mod battery;
mod bmi270;
mod crsf;
mod dshot;
mod latency;

pub use battery::Battery;
pub use bmi270::{Bmi270, Defect, Upload};
pub use crsf::{CRSF_BAUD, CRSF_HIGH, CRSF_LOW, CRSF_MIDDLE, CrsfDefect, CrsfReceiver};
pub use dshot::{CommandEntry, DshotEsc, FrameEnd};
pub use latency::{Latency, LatencySummary};

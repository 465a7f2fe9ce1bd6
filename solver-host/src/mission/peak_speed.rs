//! How fast a maneuver is.

use mintime_shared::table::Kind;

use super::{Flown, PlanFrame};

impl Flown {
    /// The greatest speed in the maneuver's plane, m/s, and whose it is: the plan's; of a learned table, with which the model goes
    /// elsewhere, the flight's while the table's time lasted. `None` where that was not flown or not seen.
    pub fn peak_speed_mps(&self) -> Option<(&'static str, f64)> {
        if self.prepared.table.kind != Kind::Learned {
            return Some(("peak speed, planned", self.prepared.extent.peak_speed_mps));
        }
        let frame = PlanFrame::of(self)?;
        let maneuver = 0.0..=f64::from(self.prepared.table.duration_s());
        let during = self.trace.samples.iter().filter(|s| maneuver.contains(&frame.since_s(s.time_ns)));
        let speeds = during.map(|s| s.truth.planar.vx.hypot(s.truth.planar.vz));
        Some(("peak speed, flown", speeds.filter(|speed_mps| speed_mps.is_finite()).reduce(f64::max)?))
    }
}

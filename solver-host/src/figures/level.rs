//! Vertical maneuvers as the paper flies them below its flip: level all the way, full thrust and then least thrust.
//!
//! They satisfy the first-order conditions of the minimum principle, but the phase at least thrust is a singular arc with
//! Φ_T > 0 and fails Kelley's condition: turning a little while the thrust is low is faster at every height.

use mintime_shared::model::{Limits, State};

/// A climb without pitch.
#[derive(Clone, Copy, Debug)]
pub(crate) struct LevelClimb {
    /// Height, m; above zero.
    pub(crate) z_m: f64,
    pub(crate) limits: Limits<f64>,
}

impl LevelClimb {
    /// Accelerations of the two phases, up and down, m/s².
    fn accelerations(&self) -> (f64, f64) {
        let gravity = self.limits.gravity_mps2;
        (self.limits.thrust_max_mps2 - gravity, gravity - self.limits.thrust_min_mps2)
    }

    /// When the thrust is switched off, s.
    pub(crate) fn switch_s(&self) -> f64 {
        let (up, down) = self.accelerations();
        (2.0 * self.z_m * down / (up * (up + down))).sqrt()
    }

    /// T, s.
    pub(crate) fn duration_s(&self) -> f64 {
        let (up, down) = self.accelerations();
        (2.0 * self.z_m * (up + down) / (up * down)).sqrt()
    }

    /// The state at a time from 0 to T.
    pub(crate) fn state_at(&self, t_s: f64) -> State<f64> {
        let (up, down) = self.accelerations();
        if t_s <= self.switch_s() {
            return State { z: 0.5 * up * t_s * t_s, vz: up * t_s, ..State::origin() };
        }
        let left_s = self.duration_s() - t_s;
        State { z: self.z_m - 0.5 * down * left_s * left_s, vz: down * left_s, ..State::origin() }
    }

    /// The thrust per mass at a time from 0 to T, m/s².
    pub(crate) fn thrust_at(&self, t_s: f64) -> f64 {
        if t_s < self.switch_s() { self.limits.thrust_max_mps2 } else { self.limits.thrust_min_mps2 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_arrives_at_rest_and_is_continuous() {
        let climb = LevelClimb { z_m: 2.4, limits: Limits::TABLE_I };
        let end = climb.state_at(climb.duration_s());
        assert!((end.z - 2.4).abs() < 1e-12 && end.vz.abs() < 1e-12);
        let t = climb.switch_s();
        let (before, after) = (climb.state_at(t), climb.state_at(t + 1e-12));
        assert!((before.z - after.z).abs() < 1e-9 && (before.vz - after.vz).abs() < 1e-9);
        // The paper's own numbers.
        for (z_m, t_s) in [(1.0, 0.650_604), (2.0, 0.920_093), (2.4, 1.007_911)] {
            assert!((LevelClimb { z_m, ..climb }.duration_s() - t_s).abs() < 1e-6);
        }
    }
}

//! Where a flight is on its plan: time from the maneuver's beginning, position from its true start.

use mintime_shared::model::State;

use super::Flown;

/// Turns what was logged into the plan's coordinates.
#[derive(Clone, Copy, Debug)]
pub struct PlanFrame {
    /// When the maneuver began, ns of the flight's clock.
    start_ns: u64,
    /// Where it began, in the maneuver's plane, its angle in whole turns.
    origin: State<f64>,
    /// Where the plan begins.
    from: State<f64>,
}

impl PlanFrame {
    /// Of a flight. `None` where its maneuver never began.
    pub fn of(flown: &Flown) -> Option<Self> {
        let start_ns = flown.trace.start_ns?;
        // Of a real vehicle nobody knows the truth: it began where the cameras saw it then.
        let truth = flown.trace.start.as_ref().map(|start| start.planar(flown.heading_rad()));
        let seen = || flown.trace.samples.iter().find(|s| s.time_ns >= start_ns).map(|s| s.truth.planar);
        let began = truth.or_else(seen)?;
        let turn = core::f64::consts::TAU;
        let origin = State { theta: (began.theta / turn).round() * turn, ..began };
        Some(Self { start_ns, origin, from: flown.prepared.table.start.cast() })
    }

    /// Time from the beginning of the maneuver, s; negative before it.
    pub fn since_s(&self, time_ns: u64) -> f64 {
        (time_ns as f64 - self.start_ns as f64) * 1e-9
    }

    /// A state in the maneuver's plane, as the plan counts it.
    pub fn state(&self, planar: State<f64>) -> State<f64> {
        State {
            x: planar.x - self.origin.x + self.from.x,
            z: planar.z - self.origin.z + self.from.z,
            theta: planar.theta - self.origin.theta,
            ..planar
        }
    }
}

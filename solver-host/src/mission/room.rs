//! The space that a maneuver needs, and the space that there is.

use mintime_shared::replay::Plan;

use super::MissionError;

/// Free space around the planned path that catching the vehicle may take, m: this, ...
pub const CATCH_DISTANCE_M: f64 = 1.0;
/// ... plus this for each m/s of the path's peak speed, s. Drag and lag of a vehicle that has not learned its maneuver
/// leave it with a part of that speed.
pub const CATCH_TIME_S: f64 = 0.25;
/// Step at which the path is sampled for its extent, s.
const PATH_STEP_S: f64 = 1.0e-3;

/// Free space, relative to the start of the maneuver, m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Room {
    /// Behind the start (negative) and ahead of it: along the maneuver's plane, or along the vehicle's nose where `y_m`
    /// is given.
    pub x_m: (f64, f64),
    /// To the right of the start (negative) and to the left of it, seen along the nose; `None` where sideways space is no
    /// matter.
    pub y_m: Option<(f64, f64)>,
    /// Below the start (negative: the floor) and above it.
    pub z_m: (f64, f64),
}

/// What a planned path needs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extent {
    /// Least and greatest x, m.
    pub x_m: (f64, f64),
    /// Least and greatest z, m.
    pub z_m: (f64, f64),
    /// Greatest speed, m/s.
    pub peak_speed_mps: f64,
}

impl Extent {
    /// Of a plan, relative to its start.
    pub(super) fn of(plan: &Plan) -> Self {
        let start = plan.state_at(0.0);
        let steps = (f64::from(plan.duration_s()) / PATH_STEP_S).ceil() as usize;
        let mut extent = Self { x_m: (0.0, 0.0), z_m: (0.0, 0.0), peak_speed_mps: 0.0 };
        for i in 0..=steps {
            let s = plan.state_at(((i as f64 * PATH_STEP_S) as f32).min(plan.duration_s()));
            let (x, z) = (f64::from(s.x - start.x), f64::from(s.z - start.z));
            extent.x_m = (extent.x_m.0.min(x), extent.x_m.1.max(x));
            extent.z_m = (extent.z_m.0.min(z), extent.z_m.1.max(z));
            extent.peak_speed_mps = extent.peak_speed_mps.max(f64::from(s.vx).hypot(f64::from(s.vz)));
        }
        extent
    }

    /// Space to catch the vehicle in, m.
    pub fn catch_distance_m(&self) -> f64 {
        CATCH_DISTANCE_M + CATCH_TIME_S * self.peak_speed_mps
    }

    /// Whether path and catch distance fit.
    pub(super) fn check(&self, room: &Room, heading_rad: f64) -> Result<(), MissionError> {
        let catch = self.catch_distance_m();
        let seen_along = |part: f64| {
            let (a, b) = (self.x_m.0 * part, self.x_m.1 * part);
            (a.min(b), a.max(b))
        };
        let (sin, cos) = heading_rad.sin_cos();
        let (x_m, y_m) =
            if room.y_m.is_some() { (seen_along(cos), seen_along(sin)) } else { (self.x_m, (0.0, 0.0)) };
        let y_free = room.y_m.unwrap_or((f64::NEG_INFINITY, f64::INFINITY));
        let sides = [
            ("behind", -room.x_m.0, -x_m.0),
            ("ahead of", room.x_m.1, x_m.1),
            ("to the right of", -y_free.0, -y_m.0),
            ("to the left of", y_free.1, y_m.1),
            ("below", -room.z_m.0, -self.z_m.0),
            ("above", room.z_m.1, self.z_m.1),
        ];
        for (side, free_m, path_m) in sides {
            let needed_m = path_m + catch;
            if free_m < needed_m {
                return Err(MissionError::Room { side, free_m, needed_m, catch_m: catch });
            }
        }
        Ok(())
    }
}

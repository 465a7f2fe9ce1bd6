//! When a maneuver began on the cameras' clock: the turn that the gyro measured, laid on the turn that they saw.

use mintime_shared::messages::RecordedTick;
use nalgebra::{SMatrix, SVector};

use super::{ObservationError, PlanarPose};
use crate::mission::rate_in_plane;

/// Fewest poses that time the start.
const TIMING_POSES_MIN: usize = 20;
/// How much later than the vehicle turns its gyro says so, s: the chip's low-pass filter.
const GYRO_DELAY_S: f64 = 0.8e-3;
/// The host knows the start to this, s: a line, a few poses.
const START_RANGE_S: f64 = 0.05;
/// Largest root of the mean square that timing may leave, rad.
const TIMING_RESIDUAL_MAX_RAD: f64 = 0.05;

/// The angle that the gyro says the vehicle has turned by, in the maneuver's plane.
pub(super) struct Turned {
    /// Time since the first tick, s; rate, rad/s; angle, rad.
    nodes: Vec<(f64, f64, f64)>,
}

impl Turned {
    pub(super) fn new(
        record: &[RecordedTick],
        heading_rad: f64,
        duration_s: f64,
    ) -> Result<Self, ObservationError> {
        let mut nodes: Vec<(f64, f64, f64)> = Vec::with_capacity(record.len());
        let mut time_s = 0.0;
        for tick in record {
            time_s += f64::from(tick.interval_us) * 1e-6;
            // Ticks without a sample are bridged.
            let Some(gyro) = tick.gyro_radps else { continue };
            let rate = rate_in_plane(gyro.map(f64::from), heading_rad);
            let angle = nodes.last().map_or(0.0, |(t, r, a)| a + 0.5 * (r + rate) * (time_s - t));
            nodes.push((time_s, rate, angle));
        }
        let recorded_s = nodes.last().map_or(0.0, |n| n.0);
        // The last tick comes up to a period before T; missing ones are bridged.
        if recorded_s < duration_s - 0.01 {
            return Err(ObservationError::Record { recorded_s, duration_s });
        }
        Ok(Self { nodes })
    }

    /// Rate and angle at a time since the start of what the vehicle did: what its gyro says a moment later.
    fn at(&self, since_s: f64) -> (f64, f64) {
        let time_s = since_s + GYRO_DELAY_S;
        let after = self.nodes.partition_point(|n| n.0 <= time_s);
        let (Some(a), b) = (self.nodes.get(after.saturating_sub(1)), self.nodes.get(after)) else {
            return (0.0, 0.0);
        };
        let dt = time_s - a.0;
        let slope = b.map_or(0.0, |b| (b.1 - a.1) / (b.0 - a.0).max(1e-6));
        let before = if after == 0 { 0.0 } else { slope };
        (a.1 + before * dt, a.2 + a.1 * dt + 0.5 * before * dt * dt)
    }

    pub(super) fn angle_at(&self, since_s: f64) -> f64 {
        self.at(since_s).1
    }
}

/// When a maneuver began, and how the gyro's angle becomes the cameras'.
pub(super) struct Timing {
    pub(super) began_s: f64,
    pub(super) offset_rad: f64,
    pub(super) scale: f64,
    pub(super) residual_rad: f64,
}

/// Lays the gyro's turn on the cameras'.
pub(super) fn time_start(
    poses: &[PlanarPose],
    turned: &Turned,
    about_s: f64,
    duration_s: f64,
) -> Result<Timing, ObservationError> {
    let mut timing = Timing { began_s: about_s, offset_rad: 0.0, scale: 1.0, residual_rad: f64::INFINITY };
    for _ in 0..30 {
        let since = |p: &PlanarPose| p.time_s - timing.began_s;
        let used: Vec<_> = poses.iter().filter(|p| (0.0..duration_s).contains(&since(p))).collect();
        if used.len() < TIMING_POSES_MIN {
            let (poses, needed) = (used.len(), TIMING_POSES_MIN);
            return Err(ObservationError::Poses { during: "in the maneuver", poses, needed });
        }
        let mut normal = SMatrix::<f64, 3, 3>::zeros();
        let mut right = SVector::<f64, 3>::zeros();
        let mut squares = 0.0;
        for pose in &used {
            let (rate, angle) = turned.at(since(pose));
            let residual = pose.theta_rad - timing.offset_rad - timing.scale * angle;
            let row = SVector::<f64, 3>::new(1.0, angle, -timing.scale * rate);
            normal += row * row.transpose();
            right += row * residual;
            squares += residual * residual;
        }
        timing.residual_rad = (squares / used.len() as f64).sqrt();
        let Some(change) = normal.lu().solve(&right) else { break };
        timing.offset_rad += change[0];
        timing.scale += change[1];
        timing.began_s += change[2].clamp(-0.01, 0.01);
        if (timing.began_s - about_s).abs() > START_RANGE_S || change[2].abs() < 1e-7 {
            break;
        }
    }
    let credible = (timing.began_s - about_s).abs() <= START_RANGE_S && (timing.scale - 1.0).abs() < 0.2;
    if !credible || timing.residual_rad > TIMING_RESIDUAL_MAX_RAD || timing.residual_rad.is_nan() {
        return Err(ObservationError::Timing { residual_rad: timing.residual_rad });
    }
    Ok(timing)
}

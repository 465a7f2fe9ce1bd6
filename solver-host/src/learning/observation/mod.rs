//! Start and end of a maneuver as motion capture saw them, at the right instant.
//!
//! A vehicle may turn at 10 rad/s when a maneuver ends: 5 ms are 0.05 rad. Neither does the host know to the millisecond when
//! the vehicle began, nor need the cameras' clock and latency be known so well. But the vehicle's record holds what its gyro
//! measured from the first tick on, and the cameras saw the same turn: the time at which the one lies on the other is the start.
//!
//! ```text
//! θ_cameras(t) ≈ o + s Γ(t − t₀)     Γ = ∫ gyro in the plane;  o, s, t₀ by least squares over the maneuver
//! p_cameras(t) ≈ p_T + v_T σ + b σ²/2 + ∬ a     σ = t − t₀ − T, over the last moments
//! ```
//!
//! with a the acceleration that the recorded thrust makes in the attitude seen, and b what it leaves out.

mod pull;
mod timing;

use mintime_shared::messages::RecordedTick;
use mintime_shared::replay::Plan;
use mintime_shared::table::ManeuverTable;
use nalgebra::{DMatrix, DVector, Vector3};

use super::history::{Across, StateError};
use super::model::Response;
use crate::flight::{HEADING_RAD, Phase, Pose, Sight, Witness};
use pull::Pull;
use timing::{Turned, time_start};

/// The start is the mean of this long before it, s: the gate has just held for longer.
const START_WINDOW_S: f64 = 0.08;
/// The end is fitted over this long before it, s, ...
const END_WINDOW_S: f64 = 0.08;
/// ... and this long after it, s: rotors do not answer at once.
const END_AFTER_S: f64 = 0.003;
/// Fewest poses in a window.
const POSES_MIN: usize = 8;

/// Start and end of a flown maneuver.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Observed {
    /// When it began, motion capture's state less the planned start.
    pub start_error: StateError,
    /// When the table's duration had passed, motion capture's state less the planned end; positions count from the start.
    pub final_error: StateError,
    /// Motion out of the plane then.
    pub across: Across,
    /// What of `across.y_m` the start explains: a speed, a tilt, a nose that points elsewhere, m.
    pub across_from_start_m: f64,
    /// When it began, s on the cameras' clock.
    pub began_s: f64,
    /// What timing left, rad, root of the mean square.
    pub timing_residual_rad: f64,
}

/// Why a maneuver's start and end are not known.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum ObservationError {
    /// It never began.
    #[error("the vehicle did not begin the maneuver")]
    NotFlown,
    /// The record does not cover it.
    #[error(
        "the vehicle's record covers {recorded_s:.2} s of a maneuver of {duration_s:.2} s: its memory is too small for it"
    )]
    Record {
        /// Recorded, s.
        recorded_s: f64,
        /// Needed, s.
        duration_s: f64,
    },
    /// The cameras did not see enough.
    #[error(
        "the cameras saw {poses} poses {during}, {needed} are needed: see that they cover the whole path"
    )]
    Poses {
        /// When.
        during: &'static str,
        /// Seen.
        poses: usize,
        /// Needed.
        needed: usize,
    },
    /// Gyro and cameras disagree.
    #[error(
        "gyro and cameras disagree by {residual_rad:.3} rad about the turn: check the heading of the markers and the cameras' clock"
    )]
    Timing {
        /// Root of the mean square, rad.
        residual_rad: f64,
    },
}

/// A witness that keeps the poses around a maneuver, and hands everything on.
#[derive(Debug)]
pub struct Eyes<'a, W> {
    witness: &'a mut W,
    poses: Vec<Pose>,
    began_s: Option<f64>,
}

impl<'a, W: Witness> Eyes<'a, W> {
    /// Has seen nothing yet.
    pub fn new(witness: &'a mut W) -> Self {
        Self { witness, poses: Vec::new(), began_s: None }
    }

    /// Start and end of the maneuver that was flown, for the plane of a heading, rad.
    ///
    /// # Errors
    /// [`ObservationError`].
    pub fn observed(
        &self,
        table: &ManeuverTable,
        start_m: Vector3<f64>,
        heading_rad: f64,
        record: &[RecordedTick],
        response: &Response,
    ) -> Result<Observed, ObservationError> {
        let about_s = self.began_s.ok_or(ObservationError::NotFlown)?;
        observe(&Seen { poses: &self.poses, about_s, start_m, heading_rad, record }, table, response)
    }
}

impl<W: Witness> Witness for Eyes<'_, W> {
    fn phase(&mut self, phase: Phase, now_s: f64) {
        self.witness.phase(phase, now_s);
    }

    fn event(&mut self, now_s: f64, text: &str) {
        self.witness.event(now_s, text);
    }

    fn saw(&mut self, sight: &Sight) {
        if matches!(sight.phase, Phase::Hover | Phase::Maneuver | Phase::Catch) {
            self.poses.push(sight.pose);
        }
        if let Some(since_s) = sight.maneuver_since_s {
            self.began_s.get_or_insert(since_s);
        }
        self.witness.saw(sight);
    }
}

/// What is known of a flight.
#[derive(Clone, Copy, Debug)]
pub struct Seen<'a> {
    /// Poses from before the maneuver until after it, levelled.
    pub poses: &'a [Pose],
    /// When the host believes that it began, s.
    pub about_s: f64,
    /// Where it should have begun, world frame, m.
    pub start_m: Vector3<f64>,
    /// Heading of the plane that is asked for, rad; the table's own may make up for an askew gyro.
    pub heading_rad: f64,
    /// The vehicle's record.
    pub record: &'a [RecordedTick],
}

/// A pose in the maneuver's plane; y is the way out of it, to the left of the heading.
#[derive(Clone, Copy, Debug)]
struct PlanarPose {
    time_s: f64,
    x_m: f64,
    y_m: f64,
    z_m: f64,
    theta_rad: f64,
    /// Tilt out of the plane, to the left.
    lean_rad: f64,
    /// Where the nose points, off its heading to the left.
    yaw_rad: f64,
}

/// Start and end of a flight.
///
/// # Errors
/// [`ObservationError`].
pub fn observe(
    seen: &Seen<'_>,
    table: &ManeuverTable,
    response: &Response,
) -> Result<Observed, ObservationError> {
    let heading_rad = seen.heading_rad;
    let duration_s = f64::from(Plan::new(table).duration_s());
    let turned = Turned::new(seen.record, f64::from(table.heading_rad), duration_s)?;
    let poses = planar(seen.poses, heading_rad);
    let timing = time_start(&poses, &turned, seen.about_s, duration_s)?;
    let (began_s, end_s) = (timing.began_s, timing.began_s + duration_s);

    let before = within(&poses, began_s - START_WINDOW_S, began_s, "just before the maneuver")?;
    let start = |value: fn(&PlanarPose) -> f64| line_at(&before, began_s, value);
    let ((x0, vx0), (y0, vy0), (z0, vz0)) = (start(|p| p.x_m), start(|p| p.y_m), start(|p| p.z_m));
    let mean = |value: fn(&PlanarPose) -> f64| before.iter().map(value).sum::<f64>() / before.len() as f64;
    let theta0 = mean(|p| p.theta_rad);

    let last = within(&poses, end_s - END_WINDOW_S, end_s + END_AFTER_S, "at the end of the maneuver")?;
    let theta = |since_s: f64| timing.offset_rad + timing.scale * turned.angle_at(since_s);
    let left = last.iter().map(|p| p.theta_rad - theta(p.time_s - began_s)).sum::<f64>() / last.len() as f64;
    let theta_end = theta(duration_s) + left;
    let pull = Pull::new(seen.record, response, duration_s, &|since_s| theta(since_s) + left);
    let (x, vx) = end_of(&last, end_s, |p| p.x_m, |sigma| pull.at(sigma)[0]);
    let (z, vz) = end_of(&last, end_s, |p| p.z_m, |sigma| pull.at(sigma)[1]);
    let (y, vy) = end_of(&last, end_s, |p| p.y_m, |_| 0.0);

    let (sin, cos) = heading_rad.sin_cos();
    let (from, to) = (table.start.cast::<f64>(), table.end.cast::<f64>());
    Ok(Observed {
        start_error: StateError {
            x_m: x0 - (seen.start_m.x * cos + seen.start_m.y * sin),
            vx_mps: vx0 - from.vx,
            z_m: z0 - seen.start_m.z,
            vz_mps: vz0 - from.vz,
            theta_rad: theta0 - from.theta,
        },
        final_error: StateError {
            x_m: x - x0 - (to.x - from.x),
            vx_mps: vx - to.vx,
            z_m: z - z0 - (to.z - from.z),
            vz_mps: vz - to.vz,
            theta_rad: theta_end - to.theta,
        },
        across: Across { y_m: y - y0, vy_mps: vy },
        across_from_start_m: across_from_start(vy0, mean(|p| p.lean_rad), mean(|p| p.yaw_rad), table),
        began_s,
        timing_residual_rad: timing.residual_rad,
    })
}

/// What of an error at the end comes from the start: a speed drifts, a tilt turns the whole path.
///
/// δx = δẋ T + δθ (Δz + gT²/2), δz = δż T − δθ Δx, δẋ = δẋ + δθ (Δż + gT), δż = δż − δθ Δẋ, δθ = δθ, with Δ the planned change over
/// the maneuver. Positions count from the start.
pub fn effect_of_start(start: &StateError, table: &ManeuverTable) -> StateError {
    let duration_s = f64::from(table.duration_s());
    let gravity = f64::from(table.limits.gravity_mps2);
    let gain = table.end.cast::<f64>().minus(table.start.cast());
    let tilt = start.theta_rad;
    StateError {
        x_m: start.vx_mps * duration_s + tilt * (gain.z + gravity * duration_s * duration_s / 2.0),
        vx_mps: start.vx_mps + tilt * (gain.vz + gravity * duration_s),
        z_m: start.vz_mps * duration_s - tilt * gain.x,
        vz_mps: start.vz_mps - tilt * gain.vx,
        theta_rad: tilt,
    }
}

/// What of the way out of the plane comes from the start, m: a speed drifts, a lean falls as a tilt in the plane does, and a nose that
/// points elsewhere takes the whole path with it.
fn across_from_start(vy_mps: f64, lean_rad: f64, yaw_rad: f64, table: &ManeuverTable) -> f64 {
    let duration_s = f64::from(table.duration_s());
    let gain = table.end.cast::<f64>().minus(table.start.cast());
    let fallen_m = gain.z + f64::from(table.limits.gravity_mps2) * duration_s * duration_s / 2.0;
    vy_mps * duration_s + lean_rad * fallen_m + yaw_rad * gain.x
}

/// Poses in the plane, with θ unwrapped.
fn planar(poses: &[Pose], heading_rad: f64) -> Vec<PlanarPose> {
    let (sin, cos) = heading_rad.sin_cos();
    let along = |v: &Vector3<f64>| v.x * cos + v.y * sin;
    let turn = core::f64::consts::TAU;
    let mut last = 0.0_f64;
    poses
        .iter()
        .map(|pose| {
            let up = pose.attitude * Vector3::z();
            let wrapped = along(&up).atan2(up.z);
            last = wrapped + turn * ((last - wrapped) / turn).round();
            let at = &pose.position_m;
            let y_m = at.y * cos - at.x * sin;
            let lean_rad = (up.y * cos - up.x * sin).asin();
            let nose = pose.attitude * Vector3::x();
            let yaw_rad = nose.y.atan2(nose.x) - HEADING_RAD;
            let time_s = pose.captured_s;
            PlanarPose { time_s, x_m: along(at), y_m, z_m: at.z, theta_rad: last, lean_rad, yaw_rad }
        })
        .collect()
}

/// The poses between two times.
fn within(
    poses: &[PlanarPose],
    from_s: f64,
    to_s: f64,
    during: &'static str,
) -> Result<Vec<PlanarPose>, ObservationError> {
    let found: Vec<_> = poses.iter().filter(|p| (from_s..=to_s).contains(&p.time_s)).copied().collect();
    if found.len() < POSES_MIN {
        return Err(ObservationError::Poses { during, poses: found.len(), needed: POSES_MIN });
    }
    Ok(found)
}

/// Value at a time, and slope, of the straight line through poses.
fn line_at(poses: &[PlanarPose], at_s: f64, value: fn(&PlanarPose) -> f64) -> (f64, f64) {
    let design = DMatrix::from_fn(poses.len(), 2, |i, j| (poses[i].time_s - at_s).powi(j as i32));
    let values = DVector::from_iterator(poses.len(), poses.iter().map(value));
    least_squares(&design, &values).map_or((f64::NAN, f64::NAN), |c| (c[0], c[1]))
}

/// Value and slope at the end: a parabola through what the known acceleration leaves.
fn end_of(
    poses: &[PlanarPose],
    end_s: f64,
    value: fn(&PlanarPose) -> f64,
    known: impl Fn(f64) -> f64,
) -> (f64, f64) {
    let sigma = |i: usize| poses[i].time_s - end_s;
    let design = DMatrix::from_fn(poses.len(), 3, |i, j| sigma(i).powi(j as i32));
    let values = DVector::from_fn(poses.len(), |i, _| value(&poses[i]) - known(sigma(i)));
    least_squares(&design, &values).map_or((f64::NAN, f64::NAN), |c| (c[0], c[1]))
}

fn least_squares(design: &DMatrix<f64>, values: &DVector<f64>) -> Option<DVector<f64>> {
    design.clone().svd(true, true).solve(values, 1e-12).ok()
}

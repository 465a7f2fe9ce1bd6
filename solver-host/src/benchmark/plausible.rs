//! Whether a flight can be what it says it is: units and signs that were confused show in physics.

use std::f64::consts::FRAC_PI_2;

use nalgebra::Vector3;

use super::error::BenchmarkError;
use super::flight::{Remark, Sample, along};
use super::score::Rules;

/// Time over which accelerations are taken, s: twice that over which velocities are fitted.
const WINDOW_S: f64 = 0.04;
/// Logged velocities may be off by this factor from positions and times.
const VELOCITY_FACTOR: f64 = 1.5;
/// A motion may ask for this many times the largest thrust before it is refused: limits are often given low.
const THRUST_FACTOR: f64 = 2.0;
/// Acceleration across the thrust from which on a log is remarked on, m/s² rms, beside what drag explains.
const REMARKED_MPS2: f64 = 2.0;
/// Drag of a quadrotor's rotors over its speed, 1/s: 0.2 to 0.5 in the literature.
const DRAG_PER_S: f64 = 0.4;

/// Refuses motions that are no planar quadrotor's in the plane of this heading; `derived` says that the velocities are the
/// positions' own.
pub(super) fn check(
    samples: &[Sample],
    heading_rad: f64,
    rules: &Rules,
    derived: bool,
) -> Result<Option<Remark>, BenchmarkError> {
    let limits = &rules.limits;
    if !derived {
        velocities(samples)?;
    }
    let windows = windows(samples, limits.gravity_mps2);
    let largest = windows.iter().max_by(|a, b| a.thrust_mps2.norm().total_cmp(&b.thrust_mps2.norm()));
    if let Some(window) = largest
        && window.thrust_mps2.norm() > THRUST_FACTOR * limits.thrust_max_mps2
    {
        return Err(BenchmarkError::Thrust {
            t_s: window.t_s,
            thrust_mps2: window.thrust_mps2.norm(),
            limit_mps2: limits.thrust_max_mps2,
        });
    }
    // The planning model accelerates in its plane and along the thrust only: what is left of the axis there explains it.
    let aside = along(heading_rad + FRAC_PI_2);
    let planar = |axis: Vector3<f64>| (axis - aside * axis.dot(&aside)).try_normalize(1e-9).unwrap_or(axis);
    let across_mps2 = rms(&windows, planar);
    let squares: f64 = samples.iter().map(|s| s.velocity_mps.norm_squared()).sum();
    let drag_mps2 = DRAG_PER_S * (squares / samples.len().max(1) as f64).sqrt();
    if across_mps2 <= REMARKED_MPS2.min(rules.across_mps2) + drag_mps2 {
        return Ok(None);
    }
    let opposite = rms(&windows, |axis| planar(Vector3::new(-axis.x, -axis.y, axis.z)));
    let mirrored = opposite < 0.5 * across_mps2;
    let most_mps2 = rules.across_mps2 + drag_mps2;
    if across_mps2 > most_mps2 {
        return Err(BenchmarkError::Across { across_mps2, most_mps2, mirrored });
    }
    Ok(Some(Remark::Misaligned { across_mps2, mirrored }))
}

/// Distances by velocity against distances by position.
fn velocities(samples: &[Sample]) -> Result<(), BenchmarkError> {
    let (mut by_velocity, mut by_position) = (0.0, 0.0);
    let mut travelled = Vector3::zeros();
    let mut begin = 0;
    for (i, pair) in samples.windows(2).enumerate() {
        let [a, b] = pair else { continue };
        travelled += (a.velocity_mps + b.velocity_mps) * (0.5 * (b.t_s - a.t_s));
        if b.t_s - samples[begin].t_s >= WINDOW_S || i + 2 == samples.len() {
            by_velocity += travelled.norm();
            by_position += (b.position_m - samples[begin].position_m).norm();
            travelled = Vector3::zeros();
            begin = i + 1;
        }
    }
    let ratio = by_velocity / by_position;
    if by_position > 0.0 && !(1.0 / VELOCITY_FACTOR..=VELOCITY_FACTOR).contains(&ratio) {
        return Err(BenchmarkError::Velocities { ratio });
    }
    Ok(())
}

/// A short time with what the motion asks for on average.
struct Window {
    t_s: f64,
    /// Acceleration without gravity.
    thrust_mps2: Vector3<f64>,
    axis: Vector3<f64>,
}

fn windows(samples: &[Sample], gravity_mps2: f64) -> Vec<Window> {
    let mut windows = Vec::new();
    let mut begin = 0;
    for (end, last) in samples.iter().enumerate() {
        let first = &samples[begin];
        let span = last.t_s - first.t_s;
        if span < WINDOW_S {
            continue;
        }
        let inside = &samples[begin..=end];
        let axis: Vector3<f64> = inside.iter().map(|s| s.thrust_axis).sum();
        windows.push(Window {
            t_s: 0.5 * (first.t_s + last.t_s),
            thrust_mps2: (last.velocity_mps - first.velocity_mps) / span + Vector3::z() * gravity_mps2,
            axis: axis.try_normalize(1e-9).unwrap_or(first.thrust_axis),
        });
        begin = end;
    }
    windows
}

/// Root mean square of the thrust across the axes.
fn rms(windows: &[Window], axis: impl Fn(Vector3<f64>) -> Vector3<f64>) -> f64 {
    let square = |w: &Window| w.thrust_mps2.cross(&axis(w.axis)).norm_squared();
    (windows.iter().map(square).sum::<f64>() / windows.len().max(1) as f64).sqrt()
}

//! Thrust scale from hover: the vehicle weighs what it weighs.
//!
//! Over a window in which the vertical speed changes by Δv, true thrust along the vertical is g + Δv/Δt on average; the mean
//! of the commands times the cosine of the tilt is what the vehicle file thinks it is. Windows of a second each give a
//! scale of their own, and their scatter the standard error.

use mintime_shared::model::GRAVITY_MPS2;
use nalgebra::Vector3;

use super::{HOVER_MIN_S, IdentificationError};
use crate::flight::Sight;

/// Length of a window, s: longer than the position loop's memory, so that windows are nearly independent.
const WINDOW_S: f64 = 1.0;
/// Speed at a window's edge comes from a straight line through the poses within this of it, s.
const EDGE_S: f64 = 0.1;
/// Farthest from its mean place in hover, m.
const DRIFT_MAX_M: f64 = 0.15;
/// Greatest mean tilt, rad: the wind that it takes moves the vertical force, too.
const TILT_MAX_RAD: f64 = 0.12;
/// Fewest poses a window needs.
const POSES_MIN: usize = 20;

/// What hover says.
#[derive(Clone, Copy, Debug)]
pub(super) struct Hover {
    /// True over commanded thrust.
    pub(super) scale: f64,
    /// Standard error.
    pub(super) scale_std: f64,
    /// Time that was used, s.
    pub(super) duration_s: f64,
}

pub(super) fn measure(sights: &[&Sight], (from_s, to_s): (f64, f64)) -> Result<Hover, IdentificationError> {
    let windows = ((to_s - from_s) / WINDOW_S).floor();
    if windows < HOVER_MIN_S - 1.0 {
        return Err(IdentificationError::ShortHover { hover_s: to_s - from_s });
    }
    let hovering: Vec<_> =
        sights.iter().filter(|s| (from_s..=to_s).contains(&s.pose.captured_s)).copied().collect();
    check_calm(&hovering)?;
    let scales = (0..windows as u32)
        .map(|i| window(sights, from_s + f64::from(i) * WINDOW_S))
        .collect::<Result<Vec<_>, _>>()?;
    let count = scales.len() as f64;
    let scale = scales.iter().sum::<f64>() / count;
    let scatter = scales.iter().map(|s| (s - scale).powi(2)).sum::<f64>() / (count - 1.0);
    Ok(Hover { scale, scale_std: (scatter / count).sqrt(), duration_s: windows * WINDOW_S })
}

fn check_calm(hovering: &[&Sight]) -> Result<(), IdentificationError> {
    let needed = POSES_MIN;
    if hovering.len() < needed {
        return Err(IdentificationError::Poses { poses: hovering.len() as u32, needed: needed as u32 });
    }
    let count = hovering.len() as f64;
    let place = hovering.iter().map(|s| s.pose.position_m).sum::<Vector3<f64>>() / count;
    let drift_m = hovering.iter().map(|s| (s.pose.position_m - place).norm()).fold(0.0, f64::max);
    if drift_m > DRIFT_MAX_M {
        return Err(IdentificationError::Drift { drift_m });
    }
    let up = hovering.iter().map(|s| s.pose.attitude * Vector3::z()).sum::<Vector3<f64>>();
    let tilt_rad = up.angle(&Vector3::z());
    if tilt_rad > TILT_MAX_RAD {
        return Err(IdentificationError::Lean { tilt_rad });
    }
    Ok(())
}

/// True over commanded thrust in the window that begins at a time.
fn window(sights: &[&Sight], from_s: f64) -> Result<f64, IdentificationError> {
    let within = |s: &&&Sight| (from_s..from_s + WINDOW_S).contains(&s.pose.captured_s);
    let commands: Vec<f64> = sights
        .iter()
        .filter(within)
        .filter_map(|s| Some(f64::from(s.setpoint?.thrust_mps2) * (s.pose.attitude * Vector3::z()).z))
        .collect();
    if commands.len() < POSES_MIN {
        return Err(IdentificationError::Poses { poses: commands.len() as u32, needed: POSES_MIN as u32 });
    }
    let gained_mps = speed_at(sights, from_s + WINDOW_S) - speed_at(sights, from_s);
    let mean_mps2 = commands.iter().sum::<f64>() / commands.len() as f64;
    Ok((GRAVITY_MPS2 + gained_mps / WINDOW_S) / mean_mps2)
}

/// Vertical speed by a straight line through the poses around a time, m/s.
fn speed_at(sights: &[&Sight], at_s: f64) -> f64 {
    let near = || sights.iter().filter(|s| (s.pose.captured_s - at_s).abs() <= EDGE_S);
    let count = near().count().max(1) as f64;
    let t = near().map(|s| s.pose.captured_s).sum::<f64>() / count;
    let z = near().map(|s| s.pose.position_m.z).sum::<f64>() / count;
    let (mut tz, mut tt) = (0.0, 0.0);
    for s in near() {
        let dt = s.pose.captured_s - t;
        tz += dt * (s.pose.position_m.z - z);
        tt += dt * dt;
    }
    if tt > 0.0 { tz / tt } else { 0.0 }
}

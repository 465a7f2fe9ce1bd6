//! What a vehicle is, from how it flies: thrust scale, rotor lag and battery sag from a hover and short hops.
//!
//! ```text
//! fly_hops ─→ poses, commands ─┬─→ hover: what command carries the weight ─→ thrust scale
//!                              ├─→ response: the path of each hop        ─→ rotor lag, dead time, gain
//!                              └─→ battery: voltage over thrust          ─→ sag
//! ```
//!
//! The theory is in `docs/identification.md`.

mod battery;
mod error;
mod hover;
mod response;
mod rotor;

pub use error::IdentificationError;

use mintime_firmware::config::ROTOR_RESPONSE_S;
use mintime_shared::vehicle::{VehicleConfig, VehicleError};

use crate::flight::{HopFlight, HopPlan, Sight};
use crate::mission::Room;

/// Shortest hover that says anything, s.
pub const HOVER_MIN_S: f64 = 4.0;
/// Fewest hops.
pub const HOPS_MIN: u32 = 4;
/// Lowest hover, m: below, the ground's cushion carries a part of the vehicle.
pub const HEIGHT_MIN_M: f64 = 0.6;
/// Free space around the hover, m: the hop, what a wrong thrust scale adds to it, and the vehicle itself.
pub const FREE_M: f64 = 0.5;

/// Standard error of the thrust scale that is good enough.
const SCALE_STD_MAX: f64 = 5.0e-3;
/// Standard error of the rotor lag that is good enough, s.
const LAG_STD_MAX_S: f64 = 3.0e-3;
/// What the model leaves of the hops' path that is good enough, m, root of the mean square.
const RESIDUAL_MAX_M: f64 = 3.0e-3;
/// A sag counts where it is this many standard errors above zero.
const SIGNIFICANT: f64 = 4.0;

/// What was found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Identified {
    /// True thrust over commanded thrust, in hover.
    pub thrust_scale: f64,
    /// Its standard error.
    pub thrust_scale_std: f64,
    /// The same from the steps of the hops: a thrust map of the wrong shape has another scale for changes than for the whole.
    pub step_scale: f64,
    /// Its standard error.
    pub step_scale_std: f64,
    /// Time constant of the rotors' speed, s.
    pub lag_s: f64,
    /// Its standard error, s.
    pub lag_std_s: f64,
    /// From a setpoint's sending to the first response, less what the cameras' times are late, s.
    pub dead_time_s: f64,
    /// Its standard error, s.
    pub dead_time_std_s: f64,
    /// Time constant that is left of the lag behind the lead of the firmware, s: what position control sees.
    pub response_s: f64,
    /// Damping of vertical motion by the rotors' own wind, 1/s.
    pub damping_per_s: f64,
    /// How far the battery's voltage falls for each newton, V/N, with its standard error; `None` where telemetry shows none.
    pub sag_v_per_n: Option<(f64, f64)>,
    /// What the model leaves of the hops' path, m, root of the mean square.
    pub residual_m: f64,
    /// Hover measured, s.
    pub hover_s: f64,
    /// Hops used.
    pub hops: u32,
    /// Poses used.
    pub poses: u32,
    /// The vehicle file that fits.
    pub vehicle: VehicleConfig,
}

/// Whether a flight can say anything, before it takes place. `room` is seen from the point of the hover.
///
/// # Errors
/// [`IdentificationError`]; nothing has moved.
pub fn check(plan: &HopPlan, room: Option<&Room>) -> Result<(), IdentificationError> {
    use IdentificationError as E;
    if !(HOVER_MIN_S..=120.0).contains(&plan.hover_s) {
        return Err(E::ShortHover { hover_s: plan.hover_s });
    }
    if !(HOPS_MIN..=100).contains(&plan.hops) {
        return Err(E::FewHops { hops: plan.hops });
    }
    if !(0.5..=4.0).contains(&plan.step_mps2) || !(0.05..=0.25).contains(&plan.pulse_s) {
        return Err(E::Step);
    }
    if plan.height_m < HEIGHT_MIN_M || !plan.height_m.is_finite() {
        return Err(E::Low { height_m: plan.height_m });
    }
    if let Some(room) = room {
        let sideways = room.y_m.unwrap_or((f64::NEG_INFINITY, f64::INFINITY));
        let free_m = [-room.x_m.0, room.x_m.1, -sideways.0, sideways.1, room.z_m.1];
        if let Some(free_m) = free_m.into_iter().find(|free| *free < FREE_M || free.is_nan()) {
            return Err(E::Room { free_m });
        }
    }
    Ok(())
}

/// What a flight says about the vehicle, given the vehicle file it flew with.
///
/// # Errors
/// [`IdentificationError`] where the data do not suffice, and what to do about it.
pub fn identify(flight: &HopFlight, file: &VehicleConfig) -> Result<Identified, IdentificationError> {
    let sights: Vec<&Sight> = flight.sights.iter().filter(|s| s.setpoint.is_some()).collect();
    let hover = hover::measure(&sights, flight.hover_s)?;
    let fit = response::fit(&sights, &flight.hops, file)?;
    if hover.scale_std > SCALE_STD_MAX {
        return Err(IdentificationError::ScaleUncertain { std: hover.scale_std });
    }
    if fit.residual_m > RESIDUAL_MAX_M {
        return Err(IdentificationError::Residual { residual_m: fit.residual_m });
    }
    if fit.lag_std_s > LAG_STD_MAX_S {
        return Err(IdentificationError::LagUncertain { std_s: fit.lag_std_s });
    }
    let sag = battery::sag(&sights, &flight.hops, &fit, file)
        .filter(|(sag, std)| *sag > SIGNIFICANT * std && *sag < 1.0);
    let vehicle = corrected(file, hover.scale, fit.lag_s, sag.map(|(sag, _)| sag))?;
    let lead = f64::from(file.rotor_lag_s / ROTOR_RESPONSE_S).max(1.0);
    Ok(Identified {
        thrust_scale: hover.scale,
        thrust_scale_std: hover.scale_std,
        step_scale: fit.scale,
        step_scale_std: fit.scale_std,
        lag_s: fit.lag_s,
        lag_std_s: fit.lag_std_s,
        dead_time_s: fit.dead_time_s,
        dead_time_std_s: fit.dead_time_std_s,
        response_s: f64::from(file.rotor_lag_s) / lead + fit.lag_s - f64::from(file.rotor_lag_s),
        damping_per_s: fit.damping_per_s,
        sag_v_per_n: sag,
        residual_m: fit.residual_m,
        hover_s: hover.duration_s,
        hops: fit.hops,
        poses: fit.poses,
        vehicle,
    })
}

/// The vehicle file with what was found. Scale is thrust over mass: it is the thrust that is corrected, for scales weigh
/// better than anybody knows a propeller.
fn corrected(
    file: &VehicleConfig,
    scale: f64,
    lag_s: f64,
    sag_v_per_n: Option<f64>,
) -> Result<VehicleConfig, VehicleError> {
    let scale = scale as f32;
    let mut vehicle = VehicleConfig {
        rotor_thrust_max_n: file.rotor_thrust_max_n * scale,
        // The throttle at idle stays what it was.
        rotor_thrust_idle_n: file.rotor_thrust_idle_n * scale,
        rotor_lag_s: lag_s as f32,
        sag_v_per_n: sag_v_per_n.map_or(file.sag_v_per_n, |sag| sag as f32),
        ..*file
    };
    // A weaker vehicle must not be planned with more than it has.
    let available = vehicle.thrust_available_mps2(vehicle.battery_nominal_v);
    if available.is_finite() && vehicle.plan_thrust_max_mps2 > available {
        vehicle.plan_thrust_max_mps2 = available;
    }
    vehicle.check()?;
    Ok(vehicle)
}

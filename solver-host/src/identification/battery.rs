//! Battery sag: how far the voltage falls for each newton, from telemetry during the hops.
//!
//! Within a hop the open-circuit voltage is constant; what the voltage does is −s F, with F the thrust that the rotors give
//! then. A regression over all hops, each with a voltage of its own. Telemetry is late by some milliseconds, and boards may
//! smooth what they measure: a slow filter makes the sag look smaller than it is, never larger.

use mintime_shared::vehicle::{MOTOR_COUNT, VehicleConfig};

use super::response::{Fit, Observed};
use super::rotor::{Drive, at};
use crate::flight::{Hop, Sight};

/// Fewest messages from all hops together.
const MESSAGES_MIN: usize = 40;

/// Sag, V/N, with its standard error; `None` where telemetry says nothing.
pub(super) fn sag(sights: &[&Sight], hops: &[Hop], fit: &Fit, file: &VehicleConfig) -> Option<(f64, f64)> {
    let drive = Drive::new(file);
    let mass_kg = f64::from(file.mass_kg);
    let mut pairs: Vec<(f64, f64)> = Vec::new();
    let mut groups = 0.0;
    for hop in hops {
        let Some(observed) = Observed::new(sights, hop) else { continue };
        let nodes = observed.motion(&drive, fit.lag_s);
        let mut own: Vec<(f64, f64)> = Vec::new();
        let news = sights.windows(2).filter_map(|pair| match pair {
            [a, b] if b.telemetry_count > a.telemetry_count => {
                Some((b.pose.arrived_s, f64::from(b.battery_v?)))
            }
            _ => None,
        });
        for (time_s, volts) in news.filter(|(t, _)| (observed.began_s - 0.1..observed.end_s).contains(t)) {
            let node = at(&nodes, time_s - fit.dead_time_s)?;
            own.push((mass_kg * fit.scale * node.acceleration_mps2, volts));
        }
        let count = own.len().max(1) as f64;
        let mean = own.iter().fold((0.0, 0.0), |sum, p| (sum.0 + p.0 / count, sum.1 + p.1 / count));
        pairs.extend(own.iter().map(|p| (p.0 - mean.0, p.1 - mean.1)));
        groups += 1.0;
    }
    if pairs.len() < MESSAGES_MIN {
        return None;
    }
    let (ff, fv) = pairs.iter().fold((0.0, 0.0), |sum, p| (sum.0 + p.0 * p.0, sum.1 + p.0 * p.1));
    // Without any change of thrust there is nothing to learn.
    let moved =
        ff / pairs.len() as f64 > (1e-3 * f64::from(file.rotor_thrust_max_n) * MOTOR_COUNT as f64).powi(2);
    let slope = fv / ff;
    let squares = pairs.iter().map(|p| (p.1 - slope * p.0).powi(2)).sum::<f64>();
    let free = pairs.len() as f64 - groups - 1.0;
    // A converter that shows one and the same value proves no sag; it has no scatter either.
    let varies = pairs.iter().any(|p| p.1 != 0.0);
    (moved && varies && free > 0.0).then(|| (-slope, (squares / free / ff).sqrt()))
}

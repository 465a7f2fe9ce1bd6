//! What the commanded thrust does to the path around a maneuver's end.

use mintime_shared::messages::RecordedTick;

use super::super::model::Response;
use super::END_WINDOW_S;

/// Step of the double integration of the acceleration, s.
const STEP_S: f64 = 0.5e-3;

/// The way that the known acceleration makes around the end: zero, with its slope, at the end.
pub(super) struct Pull {
    /// Ways at multiples of [`STEP_S`], backwards from the end and forwards from it.
    before: Vec<[f64; 2]>,
    after: Vec<[f64; 2]>,
}

impl Pull {
    pub(super) fn new(
        record: &[RecordedTick],
        response: &Response,
        duration_s: f64,
        theta: &dyn Fn(f64) -> f64,
    ) -> Self {
        let thrust = lagged_thrust(record, response);
        let acceleration = |since_s: f64| {
            let index = (since_s / STEP_S).round().max(0.0) as usize;
            let force = response.thrust_scale * thrust.get(index).or(thrust.last()).copied().unwrap_or(0.0);
            let (sin, cos) = theta(since_s).sin_cos();
            [force * sin, force * cos]
        };
        let integrate = |direction: f64| {
            let (mut way, mut speed) = ([0.0; 2], [0.0; 2]);
            let mut ways = vec![way];
            for i in 0..(2.0 * END_WINDOW_S / STEP_S) as u32 {
                // The middle of the step stands for all of it.
                let at = acceleration(duration_s + direction * STEP_S * (f64::from(i) + 0.5));
                for axis in 0..2 {
                    way[axis] += STEP_S * (speed[axis] + 0.5 * STEP_S * at[axis]);
                    speed[axis] += STEP_S * at[axis];
                }
                ways.push(way);
            }
            ways
        };
        Self { before: integrate(-1.0), after: integrate(1.0) }
    }

    /// Way along x and z at a time from the end, m.
    pub(super) fn at(&self, sigma_s: f64) -> [f64; 2] {
        let ways = if sigma_s < 0.0 { &self.before } else { &self.after };
        let place = sigma_s.abs() / STEP_S;
        let index = (place.floor() as usize).min(ways.len() - 2);
        let part = place - index as f64;
        core::array::from_fn(|axis| ways[index][axis] * (1.0 - part) + ways[index + 1][axis] * part)
    }
}

/// Thrust per mass that the recorded commands make of rotors with a lag, at multiples of [`STEP_S`], m/s².
fn lagged_thrust(record: &[RecordedTick], response: &Response) -> Vec<f64> {
    let keep = if response.thrust_lag_s > 0.0 { (-STEP_S / response.thrust_lag_s).exp() } else { 0.0 };
    let mut thrust = record.first().map_or(0.0, |t| f64::from(t.thrust_mps2));
    let mut values = vec![thrust];
    let mut until_s = 0.0;
    for (tick, next) in record.iter().zip(record.iter().skip(1).map(Some).chain([None])) {
        until_s += next.map_or(STEP_S, |n| f64::from(n.interval_us) * 1e-6);
        while (values.len() as f64) * STEP_S <= until_s {
            thrust = f64::from(tick.thrust_mps2) + (thrust - f64::from(tick.thrust_mps2)) * keep;
            values.push(thrust);
        }
    }
    values
}

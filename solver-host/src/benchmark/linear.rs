//! A linear feedback controller to benchmark, and the planning model that it flies.
//!
//! The cascade that most position controllers are, and that the journal version of the paper benchmarks one of: the
//! position loops are springs and dampers that ask for accelerations; these become a pitch angle and a thrust; a
//! proportional law turns to that angle. Everything saturates at the limits of the vehicle. In small motions each axis
//! is a linear system.

use mintime_shared::model::{Limits, State};
use mintime_shared::motion::{advance, bang};
use serde::Serialize;

use super::error::BenchmarkError;
use super::find::{Arrival, Goal, Tolerance};
use super::flight::{Flight, Sample};
use super::read_error::ReadError;
use super::score::{Rules, Score, durations, score};

/// Gains of the linear controller. All above zero.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Gains {
    /// Natural frequency of the horizontal loop, rad/s.
    pub horizontal_radps: f64,
    /// Its damping ratio.
    pub horizontal_damping: f64,
    /// Natural frequency of the vertical loop, rad/s.
    pub vertical_radps: f64,
    /// Its damping ratio.
    pub vertical_damping: f64,
    /// Gain of the pitch loop, 1/s: pitch rate per error of the pitch.
    pub pitch_per_s: f64,
    /// Largest pitch that the horizontal loop may ask for, rad, below a quarter turn.
    pub pitch_max_rad: f64,
}

impl Default for Gains {
    /// Tuned as docs/benchmarking.md says.
    fn default() -> Self {
        Self {
            horizontal_radps: 2.7,
            horizontal_damping: 0.9,
            vertical_radps: 5.0,
            vertical_damping: 1.0,
            pitch_per_s: 18.0,
            pitch_max_rad: 1.45,
        }
    }
}

impl Gains {
    /// Checks the gains.
    ///
    /// # Errors
    /// [`BenchmarkError::NotPositive`].
    pub fn validate(&self) -> Result<(), BenchmarkError> {
        for (value, name) in [
            (self.horizontal_radps, "the horizontal natural frequency"),
            (self.horizontal_damping, "the horizontal damping ratio"),
            (self.vertical_radps, "the vertical natural frequency"),
            (self.vertical_damping, "the vertical damping ratio"),
            (self.pitch_per_s, "the gain of the pitch loop"),
            (self.pitch_max_rad, "the largest pitch"),
        ] {
            if !(value.is_finite() && value > 0.0) {
                return Err(BenchmarkError::NotPositive(name));
            }
        }
        if self.pitch_max_rad >= core::f64::consts::FRAC_PI_2 {
            return Err(BenchmarkError::PitchTooLarge);
        }
        Ok(())
    }

    /// The inputs that lead from a state to rest at (`x_m`, `z_m`): pitch rate (rad/s) and thrust per mass (m/s²).
    pub fn control(&self, limits: &Limits<f64>, state: &State<f64>, x_m: f64, z_m: f64) -> (f64, f64) {
        let spring = |frequency: f64, damping: f64, error: f64, velocity: f64| {
            frequency * frequency * error - 2.0 * damping * frequency * velocity
        };
        let ax = spring(self.horizontal_radps, self.horizontal_damping, x_m - state.x, state.vx);
        let az = spring(self.vertical_radps, self.vertical_damping, z_m - state.z, state.vz);
        let up = (az + limits.gravity_mps2).clamp(limits.thrust_min_mps2, limits.thrust_max_mps2);
        let pitch = ax.atan2(up).clamp(-self.pitch_max_rad, self.pitch_max_rad);
        let rate =
            (self.pitch_per_s * (pitch - state.theta)).clamp(-limits.rate_max_radps, limits.rate_max_radps);
        // Whatever the pitch is on its way, the vertical part of the thrust is what was asked for.
        let thrust = up / state.theta.cos().max(self.pitch_max_rad.cos());
        (rate, thrust.clamp(limits.thrust_min_mps2, limits.thrust_max_mps2))
    }
}

/// Time between two decisions of a controller, s. Short beside every time constant: at 1 kHz nothing changes in the third
/// decimal of a score.
pub const STEP_S: f64 = 1e-3;

/// A controller is given up after this long, s.
pub const LONGEST_S: f64 = 60.0;

/// Flies the planning model, eq. (2), exactly under inputs held for `step_s`: `control` says pitch rate (rad/s) and
/// thrust per mass (m/s²) at each time and state; `done` ends the flight.
pub fn fly(
    limits: &Limits<f64>,
    from: State<f64>,
    step_s: f64,
    mut control: impl FnMut(f64, &State<f64>) -> (f64, f64),
    mut done: impl FnMut(f64, &State<f64>) -> bool,
) -> Vec<(f64, State<f64>)> {
    let mut flown = vec![(0.0, from)];
    let mut state = from;
    let steps = (LONGEST_S / step_s) as u32;
    for i in 0..steps {
        let (rate, thrust) = control(f64::from(i) * step_s, &state);
        let turn = bang(rate, step_s);
        state = advance(state, thrust, limits.gravity_mps2, step_s, &turn);
        let t_s = f64::from(i + 1) * step_s;
        flown.push((t_s, state));
        if done(t_s, &state) {
            break;
        }
    }
    flown
}

/// A flight of the planning model as a log.
///
/// # Errors
/// [`BenchmarkError::Read`] where it is no flight: fewer than two samples, or numbers that are not finite.
pub fn as_flight(flown: &[(f64, State<f64>)]) -> Result<Flight, BenchmarkError> {
    let samples: Vec<Sample> = flown.iter().map(|(t_s, state)| Sample::planar(*t_s, *state, 0.0)).collect();
    let count = samples.len();
    Flight::new(samples).ok_or(BenchmarkError::Read(ReadError::TooShort(count)))
}

/// The flight of the linear controller from rest at the origin to rest at a place, until it has settled there.
///
/// # Errors
/// [`BenchmarkError::NotPositive`], [`BenchmarkError::PitchTooLarge`], [`BenchmarkError::Limits`],
/// [`BenchmarkError::NeverArrives`].
pub fn fly_linear(gains: &Gains, rules: &Rules, x_m: f64, z_m: f64) -> Result<Flight, BenchmarkError> {
    gains.validate()?;
    rules.validate()?;
    let limits = &rules.limits;
    let goal = State::at_rest(x_m, z_m);
    let mut arrived_s = None;
    let mut settled = false;
    let flown = fly(
        limits,
        State::origin(),
        STEP_S,
        |_, state| gains.control(limits, state, x_m, z_m),
        |t_s, state| {
            arrived_s = within(state, &goal, &rules.tolerance).then(|| arrived_s.unwrap_or(t_s));
            settled = arrived_s.is_some_and(|arrived_s| t_s - arrived_s > rules.dwell_s + STEP_S);
            settled
        },
    );
    if settled {
        as_flight(&flown)
    } else {
        Err(BenchmarkError::NeverArrives { x_m, z_m, within_s: LONGEST_S })
    }
}

fn within(state: &State<f64>, goal: &State<f64>, tolerance: &Tolerance) -> bool {
    let off = state.minus(*goal);
    off.x.hypot(off.z) <= tolerance.position_m
        && off.vx.hypot(off.vz) <= tolerance.velocity_mps
        && off.theta.abs() <= tolerance.angle_rad
}

/// The score of the linear controller from rest at the origin to rest at a place (m), once it has settled there.
///
/// # Errors
/// Those of [`fly_linear`] and [`score`].
pub fn score_linear(gains: &Gains, rules: &Rules, x_m: f64, z_m: f64) -> Result<Score, BenchmarkError> {
    score(&fly_linear(gains, rules, x_m, z_m)?, Some(ends(x_m, z_m)), &settling(rules))
}

/// T_controller and T* (s) of [`score_linear`].
pub(super) fn durations_linear(
    gains: &Gains,
    rules: &Rules,
    x_m: f64,
    z_m: f64,
) -> Result<(f64, f64), BenchmarkError> {
    durations(&fly_linear(gains, rules, x_m, z_m)?, ends(x_m, z_m), &settling(rules))
}

fn ends(x_m: f64, z_m: f64) -> (Goal, Goal) {
    (Goal::hover([0.0; 3]), Goal::hover([x_m, 0.0, z_m]))
}

fn settling(rules: &Rules) -> Rules {
    Rules { arrival: Some(Arrival::Settle(rules.dwell_s)), ..*rules }
}

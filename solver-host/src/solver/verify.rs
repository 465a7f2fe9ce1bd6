//! The independent check of an extremal: the augmented system (21) integrated numerically with a right-hand side of its
//! own, and every law watched on a fine grid. Nothing here uses the closed forms that the solver works with.
//!
//! The integrator is a Taylor series method: eq. (21) is built from products, quotients and sine and cosine, so its
//! Taylor coefficients follow from recurrences to any order, which is both faster and more accurate here than a
//! Runge-Kutta rule. It restarts at every switch.

use core::f64::consts::TAU;

use mintime_shared::model::{RateMode, Segment, State, ThrustLevel};
use serde::{Deserialize, Serialize};

use super::extremal::Extremal;
use super::problem::Problem;
use super::relax::{lower_bound_near, relax};

/// What the independent check found. Dimensionless numbers are those of eq. (3)-(7), H = 0 with the constant 1.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Certificate {
    /// All of the below within tolerance.
    pub verified: bool,
    /// The maneuver begins or ends on a singular arc, or its multiplier is (nearly) abnormal, or c = 0 (it takes exactly
    /// |Δθ|/ω_max), so that the costate or the thrust is not unique. It is an extremal all the same.
    pub degenerate: bool,
    /// Integrated minus demanded end state: m, m/s, m, m/s, rad.
    pub final_state_error: [f64; 5],
    /// Largest |H|, dimensionless.
    pub hamiltonian: f64,
    /// Worst violation of the control laws (16) and (20), dimensionless: how far a switching function is on the wrong
    /// side of zero.
    pub control_law: f64,
    /// Least Kelley margin −Φ_T on the singular arcs, dimensionless, at least zero on an extremal; 0 without arcs.
    pub kelley: f64,
    /// Largest |u_R| on the singular arcs, dimensionless, at most 1.
    pub singular_rate_max: f64,
    /// Shortest segment, s.
    pub min_segment_s: f64,
    /// No maneuver between these states can be faster, s: infinite-rate relaxation and |Δθ|/ω_max.
    pub lower_bound_s: f64,
}

/// Largest final-state error, relative to what the inputs can do in the time: u_max T² for positions, u_max T for
/// velocities, 1 rad for the angle.
pub const FINAL_STATE_TOLERANCE: f64 = 1e-10;
/// Largest |H| and control law violation, relative to the size of the costate.
pub const LAW_TOLERANCE: f64 = 1e-9;
/// Excess of |u_R| over 1 on an arc that is rounding.
pub const RATE_TOLERANCE: f64 = 1e-9;
/// Angle of a bang that does nothing, rad: a maneuver that begins with one and goes on with an arc begins on the arc.
const IDLE: f64 = 1e-5;
/// |c| beyond which the multiplier of the cost is as good as zero.
const ABNORMAL: f64 = 1e4;

/// What a certificate's numbers may be at most for this extremal.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Tolerances {
    /// Of [`Certificate::final_state_error`]: m, m/s, m, m/s, rad.
    pub final_state: [f64; 5],
    /// Of [`Certificate::hamiltonian`], [`Certificate::control_law`] and −[`Certificate::kelley`], dimensionless.
    pub law: f64,
}

impl Tolerances {
    /// Those that [`verify()`] applies: relative to what the inputs can do in the time, and to the size of the costate.
    pub fn of(extremal: &Extremal) -> Self {
        let t_s = extremal.duration_s();
        let speed = extremal.limits.thrust_max_mps2 * t_s;
        let distance = speed * t_s;
        Self {
            final_state: [distance, speed, distance, speed, 1.0].map(|size| FINAL_STATE_TOLERANCE * size),
            law: LAW_TOLERANCE * costate_size(extremal),
        }
    }
}

/// What dimensionless numbers of an extremal are relative to.
fn costate_size(extremal: &Extremal) -> f64 {
    1.0 + extremal.costate.to_array().iter().fold(0.0_f64, |m, c| m.max(c.abs()))
}

/// Order of the Taylor series: at half a radian a step the first term left out is below 1e-16.
const ORDER: usize = 14;
/// Longest step, in units of 1/ω_max.
const LONGEST_STEP: f64 = 0.5;
/// Longest step on an arc, relative to the radius of convergence of eq. (15).
const RADIUS_FRACTION: f64 = 0.125;
/// Most steps in all: more than twice what the longest maneuver that is solved takes at the least.
const MOST_STEPS: u32 = 50_000;
/// Steps between two looks at whether it was cancelled: some tens of microseconds.
const STEPS_UNASKED: u32 = 64;
/// Points per step at which the laws are checked, its end included: one every twelfth of a radian at most.
const GRID: usize = 6;

/// Checks an extremal. Takes any [`Extremal`], from this solver or not; it does not fail, it reports.
///
/// The work is bounded: a maneuver of more than about 50,000 steps of half a radian is not verified.
pub fn verify(extremal: &Extremal) -> Certificate {
    // Nobody cancels, so there is one.
    verify_cancellable(extremal, &|| false).unwrap_or_default()
}

/// [`verify()`], `None` soon after it is cancelled.
pub(crate) fn verify_cancellable(extremal: &Extremal, cancelled: &dyn Fn() -> bool) -> Option<Certificate> {
    let limits = &extremal.limits;
    let (rate, gravity) = (limits.rate_max_radps, limits.gravity_mps2);
    let (length_m, velocity_mps) = (gravity / (rate * rate), gravity / rate);
    // Only the displacement and the attitude matter: far from the origin or after many turns nothing is different.
    let whole_turns = libm::round(extremal.from.theta / TAU) * TAU;
    let start = [
        0.0,
        extremal.from.vx / velocity_mps,
        0.0,
        extremal.from.vz / velocity_mps,
        extremal.from.theta - whole_turns,
        extremal.phi_r0,
    ];
    let mut run = Integration {
        c: extremal.costate.to_array(),
        t: 0.0,
        y: start,
        hamiltonian: 0.0,
        control_law: 0.0,
        kelley: f64::INFINITY,
        singular_rate: 0.0,
        steps: 0,
        cancelled,
    };
    let mut shortest = f64::INFINITY;
    let mut finite = true;
    for segment in &extremal.segments {
        let duration = segment.duration * rate;
        shortest = shortest.min(segment.duration);
        finite &= duration.is_finite();
        let u_t = match segment.inputs.thrust {
            ThrustLevel::Min => limits.thrust_min_mps2 / gravity,
            ThrustLevel::Max => limits.thrust_max_mps2 / gravity,
        };
        if finite && duration > 0.0 {
            run.segment(segment.inputs.rate, segment.inputs.thrust, u_t, duration)?;
        }
    }
    let end = extremal.end();
    let displaced = State { x: end.x - extremal.from.x, z: end.z - extremal.from.z, ..end };
    let demanded = State { theta: displaced.theta - whole_turns, ..displaced };
    let reached = [
        run.y[0] * length_m,
        run.y[1] * velocity_mps,
        run.y[2] * length_m,
        run.y[3] * velocity_mps,
        run.y[4],
    ];
    let target = demanded.to_array();
    let final_state_error: [f64; 5] = core::array::from_fn(|i| reached[i] - target[i]);

    let Tolerances { final_state, law } = Tolerances::of(extremal);
    let arrives = final_state_error.iter().zip(final_state).all(|(e, most)| e.abs() <= most);
    let kelley = if run.kelley.is_finite() { run.kelley } else { 0.0 };
    let verified = finite
        && !extremal.segments.is_empty()
        && arrives
        && run.hamiltonian <= law
        && run.control_law <= law
        && kelley >= -law
        && run.singular_rate <= 1.0 + RATE_TOLERANCE
        && shortest > 0.0;
    let idle = |s: &&Segment<f64>| s.inputs.rate != RateMode::Singular && s.duration * rate < IDLE;
    let on_arc = |s: Option<&Segment<f64>>| s.is_some_and(|s| s.inputs.rate == RateMode::Singular);
    let degenerate = on_arc(extremal.segments.iter().find(|s| !idle(s)))
        || on_arc(extremal.segments.iter().rev().find(|s| !idle(s)))
        || costate_size(extremal) > ABNORMAL
        || run.c == [0.0; 4];
    let problem = Problem::new(extremal.from, extremal.to, limits, extremal.turns);
    let relaxed_s = lower_bound_near(&problem, run.c, extremal.duration_s() * rate)
        .or_else(|| relax(&problem).map(|r| r.lower_bound))
        .map_or(0.0, |bound| bound / rate);
    Some(Certificate {
        verified,
        degenerate,
        final_state_error,
        hamiltonian: run.hamiltonian,
        control_law: run.control_law,
        kelley,
        singular_rate_max: run.singular_rate,
        min_segment_s: shortest,
        lower_bound_s: relaxed_s.max(problem.turn().abs() / rate),
    })
}

/// 1/(k + 1).
const INVERSES: Series = {
    let mut values = [1.0; ORDER + 1];
    let mut k = 0;
    while k <= ORDER {
        values[k] = 1.0 / (k + 1) as f64;
        k += 1;
    }
    values
};

type Series = [f64; ORDER + 1];

/// State of the integration, (x, ẋ, z, ż, θ, Φ_R), and the worst values seen.
struct Integration<'a> {
    c: [f64; 4],
    t: f64,
    y: [f64; 6],
    hamiltonian: f64,
    control_law: f64,
    kelley: f64,
    singular_rate: f64,
    steps: u32,
    cancelled: &'a dyn Fn() -> bool,
}

impl Integration<'_> {
    /// `None` where it was cancelled.
    fn segment(&mut self, mode: RateMode, level: ThrustLevel, u_t: f64, duration: f64) -> Option<()> {
        let end = self.t + duration;
        let mut left = duration;
        self.watch_entry(mode, level, u_t);
        while left > 0.0 {
            let longest = match mode {
                RateMode::Singular => LONGEST_STEP.min(RADIUS_FRACTION * self.radius()),
                _ => LONGEST_STEP,
            };
            // Equal steps over what is left, so that no tiny last one remains.
            let h = left / libm::ceil(left / longest).max(1.0);
            if !h.is_finite() || h <= 0.0 || longest < 1e-6 || self.steps >= MOST_STEPS {
                // p runs through zero: not an arc of any extremal. Or it takes too long to tell.
                self.singular_rate = f64::INFINITY;
                return Some(());
            }
            if self.steps % STEPS_UNASKED == STEPS_UNASKED - 1 && (self.cancelled)() {
                return None;
            }
            self.steps += 1;
            self.step(mode, level, u_t, h);
            left -= h;
            if left < 1e-12 * duration {
                break;
            }
        }
        self.t = end;
        Some(())
    }

    /// Radius of convergence of eq. (15) about the present time: the distance to its complex poles.
    fn radius(&self) -> f64 {
        let [c1, c2, c3, c4] = self.c;
        let (p2, p4) = (c2 - c1 * self.t, c4 - c3 * self.t);
        libm::sqrt((p2 * p2 + p4 * p4) / (c1 * c1 + c3 * c3).max(f64::MIN_POSITIVE))
    }

    fn step(&mut self, mode: RateMode, level: ThrustLevel, u_t: f64, h: f64) {
        let [c1, c2, c3, c4] = self.c;
        let t = self.t;
        // u_R(t + τ) as a series in τ, eq. (16) and (15).
        let mut rate: Series = [0.0; ORDER + 1];
        match mode {
            RateMode::Plus => rate[0] = 1.0,
            RateMode::Minus => rate[0] = -1.0,
            RateMode::Singular => {
                let q2 = c1 * c1 + c3 * c3;
                let q1 = 2.0 * q2 * t - 2.0 * (c1 * c2 + c3 * c4);
                let q0 = q2 * t * t - 2.0 * (c1 * c2 + c3 * c4) * t + c2 * c2 + c4 * c4;
                let (r1, r2) = (q1 / q0, q2 / q0);
                rate[0] = (c2 * c3 - c1 * c4) / q0;
                rate[1] = -r1 * rate[0];
                for k in 2..=ORDER {
                    rate[k] = -(r1 * rate[k - 1] + r2 * rate[k - 2]);
                }
            }
        }
        let singular = mode == RateMode::Singular;
        let mut sin: Series = [0.0; ORDER + 1];
        let mut cos: Series = [0.0; ORDER + 1];
        let mut y = [[0.0; ORDER + 1]; 6];
        for (series, value) in y.iter_mut().zip(self.y) {
            series[0] = value;
        }
        (sin[0], cos[0]) = libm::sincos(self.y[4]);
        let (a, b) = (c1 * t - c2, c4 - c3 * t);
        for k in 0..ORDER {
            let inverse = INVERSES[k];
            y[4][k + 1] = rate[k] * inverse;
            let (mut s, mut c) = (rate[0] * cos[k], -rate[0] * sin[k]);
            if singular {
                let earlier = cos[..k].iter().zip(&sin[..k]).rev();
                for (u, (co, si)) in rate[1..=k].iter().zip(earlier) {
                    s += u * co;
                    c -= u * si;
                }
            }
            sin[k + 1] = s * inverse;
            cos[k + 1] = c * inverse;
            y[0][k + 1] = y[1][k] * inverse;
            y[1][k + 1] = u_t * sin[k] * inverse;
            y[2][k + 1] = y[3][k] * inverse;
            y[3][k + 1] = (u_t * cos[k] - if k == 0 { 1.0 } else { 0.0 }) * inverse;
            let drift = if k > 0 { c1 * cos[k - 1] - c3 * sin[k - 1] } else { 0.0 };
            y[5][k + 1] = u_t * (a * cos[k] + b * sin[k] + drift) * inverse;
        }
        let taus: [f64; GRID] = core::array::from_fn(|i| h * (i + 1) as f64 / GRID as f64);
        let vx = horner(&y[1], &taus);
        let vz = horner(&y[3], &taus);
        let phi_r = horner(&y[5], &taus);
        let s = horner(&sin, &taus);
        let c = horner(&cos, &taus);
        let u_r = if singular { horner(&rate, &taus) } else { [rate[0]; GRID] };
        for i in 0..GRID {
            let (p2, p4) = (c2 - c1 * (t + taus[i]), c4 - c3 * (t + taus[i]));
            self.watch(mode, level, u_t, p4, [vx[i], vz[i], phi_r[i], u_r[i], p2 * s[i] + p4 * c[i]]);
        }
        let last = GRID - 1;
        let [x, z, theta] = [horner(&y[0], &[h])[0], horner(&y[2], &[h])[0], horner(&y[4], &[h])[0]];
        self.y = [x, vx[last], z, vz[last], theta, phi_r[last]];
        self.t += h;
    }
}

impl Integration<'_> {
    /// Checks the laws where a segment begins: right after a switch with the new inputs.
    fn watch_entry(&mut self, mode: RateMode, level: ThrustLevel, u_t: f64) {
        let [c1, c2, c3, c4] = self.c;
        let (p2, p4) = (c2 - c1 * self.t, c4 - c3 * self.t);
        let u_r = match mode {
            RateMode::Plus => 1.0,
            RateMode::Minus => -1.0,
            RateMode::Singular => (c2 * c3 - c1 * c4) / (p2 * p2 + p4 * p4),
        };
        let [_, vx, _, vz, theta, phi_r] = self.y;
        let (s, c) = libm::sincos(theta);
        self.watch(mode, level, u_t, p4, [vx, vz, phi_r, u_r, p2 * s + p4 * c]);
    }

    /// Checks the laws at one point: (ẋ, ż, Φ_R, u_R, Φ_T) there, and p4.
    fn watch(&mut self, mode: RateMode, level: ThrustLevel, u_t: f64, p4: f64, at: [f64; 5]) {
        let [vx, vz, phi_r, u_r, phi_t] = at;
        let h = 1.0 + self.c[0] * vx + u_t * phi_t + self.c[2] * vz - p4 + phi_r * u_r;
        self.hamiltonian = worst(self.hamiltonian, h.abs());
        let rate_violation = match mode {
            RateMode::Plus => phi_r,
            RateMode::Minus => -phi_r,
            RateMode::Singular => phi_r.abs(),
        };
        let thrust_violation = match level {
            ThrustLevel::Max => phi_t,
            ThrustLevel::Min => -phi_t,
        };
        self.control_law = worst(worst(self.control_law, rate_violation), thrust_violation);
        if mode == RateMode::Singular {
            self.kelley = if -phi_t < self.kelley || phi_t.is_nan() { -phi_t } else { self.kelley };
            self.singular_rate = worst(self.singular_rate, u_r.abs());
        }
    }
}

/// The larger of two; NaN wins, so that nothing hides it.
fn worst(a: f64, b: f64) -> f64 {
    if b > a || b.is_nan() { b } else { a }
}

/// A series at several points.
#[inline]
fn horner<const N: usize>(series: &Series, at: &[f64; N]) -> [f64; N] {
    let mut sums = [series[ORDER]; N];
    for coefficient in series[..ORDER].iter().rev() {
        for i in 0..N {
            sums[i] = sums[i] * at[i] + coefficient;
        }
    }
    sums
}

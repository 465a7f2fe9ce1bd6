//! Rotor lag, dead time and gain from the paths of the hops, by least squares.
//!
//! The height of the vehicle in hop i is modelled as
//!
//! ```text
//! z(t) = z_i + v_i t + b_i t²/2 + k p(t − d; τ) − β ∫ p(t − d; τ) dt
//! ```
//!
//! with p the motion that the commands make of rotors with lag τ. What hops have in common is k, the gain, β, the damping by
//! the rotors' own wind, τ and d, the dead time; each has a start z_i, v_i and an acceleration b_i that nobody asked for: what
//! is wrong with the hover thrust, a breeze. Gauss-Newton: all but τ and d is linear.
//!
//! Standard errors come from how much hops disagree (each hop's gradient of the sum of squares is one independent piece), or
//! from the residual, whichever is larger: cameras' errors are seldom white, and ticks fall where they like.

use mintime_shared::vehicle::VehicleConfig;
use nalgebra::{DMatrix, DVector, SMatrix, SVector, Vector3};

use super::rotor::{Command, Drive, Node, at};
use super::{HOPS_MIN, IdentificationError};
use crate::flight::{Hop, Sight};

/// The rotors are modelled from this long before a hop, s: they have settled by then.
const BEFORE_S: f64 = 0.35;
/// Poses count from this long before it, s, ...
const LOOK_BEFORE_S: f64 = 0.10;
/// ... until this long after it, s.
const LOOK_AFTER_S: f64 = 0.25;
/// Fewest poses of a hop.
const POSES_MIN: usize = 30;
/// Range in which a lag is looked for, s.
const LAG_RANGE_S: (f64, f64) = (0.002, 0.15);
/// Range in which a dead time is looked for, s: cameras' clocks may be off either way.
const DEAD_RANGE_S: (f64, f64) = (-0.03, 0.10);
/// Largest change of either in one iteration, s.
const STEP_MAX_S: f64 = 0.010;
const ITERATIONS: u32 = 40;
/// Converged, s.
const CONVERGED_S: f64 = 1.0e-6;
/// Difference by which the derivative for the lag is taken, s.
const LAG_DIFFERENCE_S: f64 = 1.0e-4;
/// Unknowns that hops have in common: lag, dead time, gain, damping.
const COMMON: usize = 4;
/// Unknowns of each hop.
const OWN: usize = 3;

/// What the hops say.
#[derive(Clone, Copy, Debug)]
pub(super) struct Fit {
    pub(super) lag_s: f64,
    pub(super) lag_std_s: f64,
    pub(super) dead_time_s: f64,
    pub(super) dead_time_std_s: f64,
    pub(super) scale: f64,
    pub(super) scale_std: f64,
    pub(super) damping_per_s: f64,
    pub(super) residual_m: f64,
    pub(super) hops: u32,
    pub(super) poses: u32,
}

/// A hop's commands and what the cameras saw of it.
pub(super) struct Observed {
    pub(super) commands: Vec<Command>,
    /// Mean vertical command before the hop, m/s².
    pub(super) base_mps2: f64,
    pub(super) began_s: f64,
    pub(super) end_s: f64,
    /// Time and height.
    heights: Vec<(f64, f64)>,
}

impl Observed {
    pub(super) fn new(sights: &[&Sight], hop: &Hop) -> Option<Self> {
        let (from_s, end_s) = (hop.began_s - BEFORE_S, hop.ended_s + LOOK_AFTER_S);
        let commands: Vec<Command> = sights
            .iter()
            .filter(|s| (from_s..end_s).contains(&s.pose.arrived_s))
            .filter_map(|s| {
                Some(Command {
                    time_s: s.pose.arrived_s,
                    thrust_mps2: f64::from(s.setpoint?.thrust_mps2),
                    upright: (s.pose.attitude * Vector3::z()).z,
                })
            })
            .collect();
        let before = || commands.iter().filter(|c| c.time_s < hop.began_s);
        let base_mps2 = before().map(|c| c.thrust_mps2).sum::<f64>() / before().count().max(1) as f64;
        let heights: Vec<_> = sights
            .iter()
            .map(|s| (s.pose.captured_s, s.pose.position_m.z))
            .filter(|(t, _)| (hop.began_s - LOOK_BEFORE_S..end_s).contains(t))
            .collect();
        let seen_before = commands.first().is_some_and(|c| c.time_s < hop.began_s - LOOK_BEFORE_S - 0.15);
        (seen_before && heights.len() >= POSES_MIN).then_some(Self {
            commands,
            base_mps2,
            began_s: hop.began_s,
            end_s,
            heights,
        })
    }

    pub(super) fn motion(&self, drive: &Drive, lag_s: f64) -> Vec<Node> {
        // Beyond the last pose by as much as a dead time may be negative.
        drive.motion(&self.commands, self.base_mps2, self.end_s - DEAD_RANGE_S.0, lag_s)
    }
}

/// The normal equations of one hop: common unknowns, then its own.
type HopNormal = (SMatrix<f64, { COMMON + OWN }, { COMMON + OWN }>, SVector<f64, { COMMON + OWN }>);

/// One iteration's normal equations.
struct Normal {
    matrix: DMatrix<f64>,
    gradient: DVector<f64>,
    by_hop: Vec<HopNormal>,
    squares: f64,
    poses: u32,
}

/// Where the unknown number `j` of a hop stands among all.
fn column(hop: usize, j: usize) -> usize {
    if j < COMMON { j } else { j + OWN * hop }
}

pub(super) fn fit(sights: &[&Sight], hops: &[Hop], file: &VehicleConfig) -> Result<Fit, IdentificationError> {
    let observed: Vec<_> = hops.iter().filter_map(|hop| Observed::new(sights, hop)).collect();
    let count = observed.len() as u32;
    if count < HOPS_MIN {
        return Err(IdentificationError::FewHops { hops: count });
    }
    let drive = Drive::new(file);
    let mut common = [f64::from(file.rotor_lag_s), 0.004, 1.0, 0.0];
    for _ in 0..ITERATIONS {
        let normal = linearise(&observed, &drive, common);
        let change = solve(&normal)?;
        // All that is linear is found anew each time; only lag and dead time move by steps.
        let step = |i: usize| change[i].clamp(-STEP_MAX_S, STEP_MAX_S);
        let moved = [step(0), step(1)];
        common = [
            (common[0] + moved[0]).clamp(LAG_RANGE_S.0, LAG_RANGE_S.1),
            (common[1] + moved[1]).clamp(DEAD_RANGE_S.0, DEAD_RANGE_S.1),
            common[2] + change[2],
            common[3] + change[3],
        ];
        if moved.iter().all(|m| m.abs() < CONVERGED_S) {
            return result(&observed, &drive, common);
        }
    }
    Err(IdentificationError::NoLag)
}

/// Residuals and their derivatives. Each hop's own unknowns are measured from zero: what is left is what they must explain.
fn linearise(observed: &[Observed], drive: &Drive, common: [f64; COMMON]) -> Normal {
    let [lag_s, dead_s, scale, damping] = common;
    let size = COMMON + OWN * observed.len();
    let mut normal = Normal {
        matrix: DMatrix::zeros(size, size),
        gradient: DVector::zeros(size),
        by_hop: Vec::with_capacity(observed.len()),
        squares: 0.0,
        poses: 0,
    };
    for (i, hop) in observed.iter().enumerate() {
        let nodes = hop.motion(drive, lag_s);
        let nearby = hop.motion(drive, lag_s + LAG_DIFFERENCE_S);
        // From the hop's own mean, so that the numbers are small.
        let mean_m = hop.heights.iter().map(|h| h.1).sum::<f64>() / hop.heights.len() as f64;
        let (mut matrix, mut gradient) = HopNormal::default();
        for (time_s, height_m) in &hop.heights {
            let (Some(n), Some(m)) = (at(&nodes, time_s - dead_s), at(&nearby, time_s - dead_s)) else {
                continue;
            };
            let t = time_s - hop.began_s;
            let row = SVector::from([
                scale * (m.position_m - n.position_m) / LAG_DIFFERENCE_S,
                damping * n.position_m - scale * n.velocity_mps,
                n.position_m,
                -n.area_ms,
                1.0,
                t,
                t * t / 2.0,
            ]);
            let residual = height_m - mean_m - scale * n.position_m + damping * n.area_ms;
            matrix += row * row.transpose();
            gradient += row * residual;
            normal.squares += residual * residual;
            normal.poses += 1;
        }
        for j in 0..COMMON + OWN {
            normal.gradient[column(i, j)] += gradient[j];
            for k in 0..COMMON + OWN {
                normal.matrix[(column(i, j), column(i, k))] += matrix[(j, k)];
            }
        }
        normal.by_hop.push((matrix, gradient));
    }
    normal
}

fn solve(normal: &Normal) -> Result<DVector<f64>, IdentificationError> {
    let factors = normal.matrix.clone().cholesky().ok_or(IdentificationError::NoLag)?;
    Ok(factors.solve(&normal.gradient))
}

fn result(observed: &[Observed], drive: &Drive, common: [f64; COMMON]) -> Result<Fit, IdentificationError> {
    let normal = linearise(observed, drive, common);
    let change = solve(&normal)?;
    let inverse = normal.matrix.clone().try_inverse().ok_or(IdentificationError::NoLag)?;
    // What is left once each hop's own unknowns have explained their part.
    let squares = (normal.squares - change.dot(&normal.gradient)).max(0.0);
    let size = normal.gradient.len();
    let free = f64::from(normal.poses) - size as f64;
    let white = &inverse * (squares / free.max(1.0));
    // Each hop's gradient at the solution.
    let count = observed.len() as f64;
    let mut between = DMatrix::zeros(size, size);
    for (i, (matrix, gradient)) in normal.by_hop.iter().enumerate() {
        let found = SVector::from_fn(|j, _| change[column(i, j)]);
        let rest = gradient - matrix * found;
        let mut spread = DVector::zeros(size);
        for j in 0..COMMON + OWN {
            spread[column(i, j)] = rest[j];
        }
        between += &spread * spread.transpose();
    }
    let scattered = &inverse * between * &inverse * (count / (count - 1.0));
    let std = |j: usize| white[(j, j)].max(scattered[(j, j)]).max(0.0).sqrt();
    let [lag_s, dead_time_s, scale, damping_per_s] = common;
    let at_bound = |v: f64, (low, high): (f64, f64)| v <= low || v >= high;
    if at_bound(lag_s, LAG_RANGE_S) || at_bound(dead_time_s, DEAD_RANGE_S) {
        return Err(IdentificationError::NoLag);
    }
    Ok(Fit {
        lag_s,
        lag_std_s: std(0),
        dead_time_s,
        dead_time_std_s: std(1),
        scale,
        scale_std: std(2),
        damping_per_s,
        residual_m: (squares / f64::from(normal.poses.max(1))).sqrt(),
        hops: observed.len() as u32,
        poses: normal.poses,
    })
}

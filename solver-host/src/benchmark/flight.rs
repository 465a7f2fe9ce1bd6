//! A flight as any log tells it: samples in order of time, interpolated between, and velocities from positions where a
//! log has none.

use std::fmt;

use mintime_shared::model::{Limits, State};
use nalgebra::{Matrix3, Vector3};

/// The vehicle at one instant, in the log's world frame: z up, axes and signs as in [`mintime_shared::frames`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample {
    /// Time by the log's clock, s.
    pub t_s: f64,
    /// Position, m.
    pub position_m: Vector3<f64>,
    /// Velocity, m/s.
    pub velocity_mps: Vector3<f64>,
    /// Direction of the thrust, a unit vector: the body's z axis.
    pub thrust_axis: Vector3<f64>,
}

impl Sample {
    /// A planar state in the vertical plane of a heading (rad from x towards y) through the origin.
    pub fn planar(t_s: f64, state: State<f64>, heading_rad: f64) -> Self {
        let along = along(heading_rad);
        let in_plane = |horizontal: f64, up: f64| along * horizontal + Vector3::z() * up;
        let (sin, cos) = state.theta.sin_cos();
        Self {
            t_s,
            position_m: in_plane(state.x, state.z),
            velocity_mps: in_plane(state.vx, state.vz),
            thrust_axis: in_plane(sin, cos),
        }
    }

    /// The sample in the plane of a heading, with x and z counted from `origin`, and the pitch within half a turn.
    pub(super) fn in_plane(&self, origin: Vector3<f64>, heading_rad: f64) -> State<f64> {
        let along = along(heading_rad);
        let from_origin = self.position_m - origin;
        State {
            x: from_origin.dot(&along),
            vx: self.velocity_mps.dot(&along),
            z: from_origin.z,
            vz: self.velocity_mps.z,
            theta: self.thrust_axis.dot(&along).atan2(self.thrust_axis.z),
        }
    }

    /// The state between two samples: the cubic through both positions and velocities, the rest linear.
    fn between(&self, later: &Self, t_s: f64) -> Self {
        let span = later.t_s - self.t_s;
        let u = if span > 0.0 { ((t_s - self.t_s) / span).clamp(0.0, 1.0) } else { 0.0 };
        let (u2, u3) = (u * u, u * u * u);
        let position_m = self.position_m * (2.0 * u3 - 3.0 * u2 + 1.0)
            + self.velocity_mps * (span * (u3 - 2.0 * u2 + u))
            + later.position_m * (3.0 * u2 - 2.0 * u3)
            + later.velocity_mps * (span * (u3 - u2));
        let axis = self.thrust_axis.lerp(&later.thrust_axis, u);
        Self {
            t_s,
            position_m,
            velocity_mps: self.velocity_mps.lerp(&later.velocity_mps, u),
            thrust_axis: axis.try_normalize(1e-9).unwrap_or(self.thrust_axis),
        }
    }
}

/// The horizontal unit vector of a heading.
pub(super) fn along(heading_rad: f64) -> Vector3<f64> {
    let (sin, cos) = heading_rad.sin_cos();
    Vector3::new(cos, sin, 0.0)
}

/// The maneuver that a log of `mintime fly` says it holds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Declared {
    /// When the maneuver began by the log's clock, s.
    pub start_s: f64,
    /// Planned displacement in the plane: end minus start.
    pub displacement: State<f64>,
    /// Heading of the plane, rad from x towards y.
    pub heading_rad: f64,
    /// Limits it was planned with; `None` of a learned one, whose table holds commands: what it takes of a vehicle to make
    /// the planned thrust.
    pub limits: Option<Limits<f64>>,
}

/// What a reader did beyond reading, and what a user should know about a result.
#[derive(Clone, Debug, PartialEq)]
pub enum Remark {
    /// The file ends before it should; what was whole has been read.
    Cut {
        /// What was found at the end.
        found: String,
        /// The last time that could be read, s.
        last_s: f64,
    },
    /// The last line of a CSV file has no line break: it may have lost digits.
    NoLineBreak,
    /// The log has no velocities; they were derived from positions.
    VelocitiesDerived,
    /// Samples without a pose were left out.
    Unseen {
        /// How many.
        samples: usize,
    },
    /// Motion and attitude contradict each other, but not so much that they are refused.
    Misaligned {
        /// Root mean square of the acceleration across the thrust, in the plane and out of it, m/s².
        across_mps2: f64,
        /// Whether the opposite sign of the pitch would fit much better.
        mirrored: bool,
    },
    /// The flight is faster than the optimum for the limits given.
    FasterThanOptimal,
    /// The log was planned with other limits.
    OtherLimits(Limits<f64>),
}

impl fmt::Display for Remark {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Cut { found, last_s } => {
                write!(f, "the file is cut ({found}); everything up to {last_s:.3} s was whole and has been read")
            }
            Self::NoLineBreak => {
                f.write_str("the last line has no line break at its end: if the file is cut, its last number may be too")
            }
            Self::VelocitiesDerived => {
                f.write_str("the log has no velocities: they were derived from the positions by a smooth fit")
            }
            Self::Unseen { samples } => write!(f, "{samples} samples hold no pose and were left out"),
            Self::Misaligned { across_mps2, mirrored: true } => write!(
                f,
                "the motion accelerates {across_mps2:.1} m/s² (rms) across the vehicle's thrust, and much less with \
                 the opposite sign of the pitch: theta must be positive nose-down, towards +x"
            ),
            Self::Misaligned { across_mps2, mirrored: false } => write!(
                f,
                "the motion accelerates {across_mps2:.1} m/s² (rms) across the vehicle's thrust in the plane of the maneuver, more \
                 than drag explains: check the units of time, position and angle"
            ),
            Self::FasterThanOptimal => f.write_str(
                "the flight is faster than the fastest possible: the vehicle can do more than the limits given say \
                 (--thrust-per-mass, --max-body-rate), or the log's times are wrong",
            ),
            Self::OtherLimits(limits) => write!(
                f,
                "the log's maneuver was planned with --thrust-per-mass {},{} --max-body-rate {}: T* is for the limits \
                 given here",
                limits.thrust_min_mps2, limits.thrust_max_mps2, limits.rate_max_radps
            ),
        }
    }
}

/// A flight: at least two samples, times strictly increasing, everything finite.
#[derive(Clone, Debug, PartialEq)]
pub struct Flight {
    pub(super) samples: Vec<Sample>,
    /// What the reader did beyond reading.
    pub remarks: Vec<Remark>,
    /// The maneuver that the log says it holds, if it says so.
    pub declared: Option<Declared>,
}

impl Flight {
    /// A flight from samples; `None` unless there are at least two, all finite and in strict order of time.
    pub fn new(samples: Vec<Sample>) -> Option<Self> {
        let finite = |s: &Sample| {
            let vectors = [s.position_m, s.velocity_mps, s.thrust_axis];
            s.t_s.is_finite() && vectors.iter().all(|v| v.iter().all(|n| n.is_finite()))
        };
        let whole = samples.len() >= 2
            && samples.iter().all(finite)
            && samples.windows(2).all(|pair| matches!(pair, [a, b] if a.t_s < b.t_s));
        whole.then_some(Self { samples, remarks: Vec::new(), declared: None })
    }

    /// The samples in order of time.
    pub fn samples(&self) -> &[Sample] {
        &self.samples
    }

    /// First and last time, s.
    pub fn span_s(&self) -> (f64, f64) {
        let time = |sample: Option<&Sample>| sample.map_or(0.0, |s| s.t_s);
        (time(self.samples.first()), time(self.samples.last()))
    }

    /// The vehicle at a time, interpolated; beyond the ends the nearest sample.
    pub fn at(&self, t_s: f64) -> Sample {
        let after = self.samples.partition_point(|s| s.t_s <= t_s).clamp(1, self.samples.len() - 1);
        self.samples[after - 1].between(&self.samples[after], t_s)
    }

    /// The interval between the samples around a time, s.
    pub(super) fn interval_at(&self, t_s: f64) -> f64 {
        let after = self.samples.partition_point(|s| s.t_s <= t_s).clamp(1, self.samples.len() - 1);
        self.samples[after].t_s - self.samples[after - 1].t_s
    }

    /// The flight between two times, s, with interpolated ends.
    pub(super) fn between(&self, from_s: f64, to_s: f64) -> Vec<Sample> {
        let inside = self.samples.iter().filter(|s| s.t_s > from_s && s.t_s < to_s).copied();
        std::iter::once(self.at(from_s)).chain(inside).chain([self.at(to_s)]).collect()
    }
}

/// Half of the time over which a velocity is fitted, s: 20 ms is short beside the 50 to 700 ms segments of a maneuver and
/// long beside the noise of cameras at 200 Hz and more.
pub const FIT_HALF_S: f64 = 0.02;

/// Replaces all velocities by those of parabolas, fitted by least squares to the positions within [`FIT_HALF_S`] of each
/// sample, and to two neighbours on each side at least.
pub(super) fn derive_velocities(samples: &mut [Sample]) {
    let fitted: Vec<Vector3<f64>> = (0..samples.len())
        .map(|i| {
            let now = samples[i].t_s;
            let near = |s: &Sample| (s.t_s - now).abs() <= FIT_HALF_S * (1.0 + 1e-9);
            let before = samples[..i].iter().rev().take_while(|s| near(s)).count().max(2).min(i);
            let after = samples[i + 1..].iter().take_while(|s| near(s)).count().max(2);
            let last = (i + after).min(samples.len() - 1);
            slope(&samples[i - before..=last], now)
        })
        .collect();
    for (sample, velocity_mps) in samples.iter_mut().zip(fitted) {
        sample.velocity_mps = velocity_mps;
    }
}

/// The slope at `now` of the parabola (of the line, through two samples) that fits the positions best.
fn slope(near: &[Sample], now: f64) -> Vector3<f64> {
    let reach = near.iter().map(|s| (s.t_s - now).abs()).fold(0.0, f64::max);
    let (Some(first), Some(last)) = (near.first(), near.last()) else { return Vector3::zeros() };
    if near.len() > 2 && reach > 0.0 {
        let mut normal = Matrix3::zeros();
        let mut right = [Vector3::zeros(); 3];
        for sample in near {
            let u = (sample.t_s - now) / reach;
            let row = Vector3::new(1.0, u, u * u);
            normal += row * row.transpose();
            // Differences keep the digits of positions far from the origin.
            let position = sample.position_m - first.position_m;
            for (sum, value) in right.iter_mut().zip(position.iter()) {
                *sum += row * *value;
            }
        }
        if let Some(inverse) = normal.try_inverse() {
            return Vector3::from(right.map(|r| (inverse * r).y / reach));
        }
    }
    (last.position_m - first.position_m) / (last.t_s - first.t_s)
}

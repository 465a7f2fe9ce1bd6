//! Finding a flight between two states in a log: when it left the first, when it arrived at the second.

use mintime_shared::model::State;
use nalgebra::Vector3;

use super::error::{BenchmarkError, Candidate, Nearest, Which};
use super::flight::{Flight, Sample};

/// How near counts as being in a state. All above zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tolerance {
    /// Position, m.
    pub position_m: f64,
    /// Velocity, m/s.
    pub velocity_mps: f64,
    /// Angle between the thrust axes, rad.
    pub angle_rad: f64,
}

impl Default for Tolerance {
    /// 5 cm, 15 cm/s, 0.05 rad.
    fn default() -> Self {
        Self { position_m: 0.05, velocity_mps: 0.15, angle_rad: 0.05 }
    }
}

/// When a flight has arrived.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Arrival {
    /// The first instant within tolerance from which the state stays within it for this long, s: the settling time.
    Settle(f64),
    /// The first instant within tolerance: the state is passed, as with an end in motion.
    First,
}

/// A state to look for, in the log's world.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Goal {
    pub(super) sample: Sample,
}

impl Goal {
    /// At rest and level at a place, m.
    pub fn hover(position_m: [f64; 3]) -> Self {
        Self {
            sample: Sample {
                t_s: 0.0,
                position_m: position_m.into(),
                velocity_mps: Vector3::zeros(),
                thrust_axis: Vector3::z(),
            },
        }
    }

    /// A planar state in the x-z plane.
    pub fn planar(state: State<f64>) -> Self {
        Self { sample: Sample::planar(0.0, state, 0.0) }
    }

    /// Its place (x, z), m, if it is a rest in the x-z plane.
    pub fn planar_rest(&self) -> Option<[f64; 2]> {
        let Sample { position_m, velocity_mps, thrust_axis, .. } = self.sample;
        let rest = velocity_mps == Vector3::zeros() && thrust_axis == Vector3::z() && position_m.y == 0.0;
        rest.then_some([position_m.x, position_m.z])
    }

    /// How far a sample is, as parts of the tolerance: at most 1 is within it.
    fn distance(&self, sample: &Sample, tolerance: &Tolerance) -> f64 {
        let off = self.off(sample);
        (off.position_m / tolerance.position_m)
            .max(off.velocity_mps / tolerance.velocity_mps)
            .max(off.angle_rad / tolerance.angle_rad)
    }

    fn off(&self, sample: &Sample) -> Tolerance {
        let goal = &self.sample;
        Tolerance {
            position_m: (sample.position_m - goal.position_m).norm(),
            velocity_mps: (sample.velocity_mps - goal.velocity_mps).norm(),
            // The arcus cosine loses small angles.
            angle_rad: goal
                .thrust_axis
                .cross(&sample.thrust_axis)
                .norm()
                .atan2(goal.thrust_axis.dot(&sample.thrust_axis)),
        }
    }
}

/// A flight between two states: when it left the one and arrived at the other, s by the log's clock.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Leg {
    /// The last instant within tolerance of the start.
    pub departure_s: f64,
    /// The instant of arrival at the end.
    pub arrival_s: f64,
}

impl Leg {
    /// From departure to arrival, s.
    pub fn duration_s(&self) -> f64 {
        self.arrival_s - self.departure_s
    }
}

/// A time within tolerance of a state, s.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Visit {
    from_s: f64,
    to_s: f64,
}

/// Parts of a sampling interval that are looked at: a fast vehicle passes through a tolerance between two samples.
const PARTS: u32 = 4;
/// Halvings of a part until its crossing is found: far below a nanosecond.
const HALVINGS: u32 = 50;

/// All times within tolerance of a state.
fn visits(flight: &Flight, goal: &Goal, tolerance: &Tolerance) -> Vec<Visit> {
    let inside = |t_s: f64| goal.distance(&flight.at(t_s), tolerance) <= 1.0;
    let mut visits: Vec<Visit> = Vec::new();
    let (first_s, last_s) = flight.span_s();
    let mut open = inside(first_s).then_some(first_s);
    let mut before = (first_s, open.is_some());
    for pair in flight.samples().windows(2) {
        let [a, b] = pair else { continue };
        for part in 1..=PARTS {
            let t_s = if part == PARTS {
                b.t_s
            } else {
                a.t_s + (b.t_s - a.t_s) * f64::from(part) / f64::from(PARTS)
            };
            let now = (t_s, inside(t_s));
            if now.1 != before.1 {
                let (mut low, mut high) = (before.0, t_s);
                for _ in 0..HALVINGS {
                    let middle = 0.5 * (low + high);
                    if inside(middle) == before.1 { low = middle } else { high = middle }
                }
                // Of the two the one that is within tolerance.
                match open.take() {
                    Some(from_s) => visits.push(Visit { from_s, to_s: low }),
                    None => open = Some(high),
                }
            }
            before = now;
        }
    }
    visits.extend(open.map(|from_s| Visit { from_s, to_s: last_s }));
    visits
}

/// The one flight between two states in a log.
///
/// It departs at the last instant within tolerance of the start before it arrives at the end.
///
/// # Errors
/// [`BenchmarkError`]: the states are too near each other, one is never reached, the log ends before the end has been held,
/// or there are several such flights.
pub fn find_leg(
    flight: &Flight,
    start: &Goal,
    end: &Goal,
    tolerance: &Tolerance,
    arrival: Arrival,
) -> Result<Leg, BenchmarkError> {
    if start.distance(&end.sample, tolerance) <= 2.0 {
        return Err(BenchmarkError::SameStates);
    }
    let starts = visits(flight, start, tolerance);
    if starts.is_empty() {
        return Err(BenchmarkError::NeverThere(nearest(flight, start, tolerance, Which::Start)));
    }
    let ends = visits(flight, end, tolerance);
    if ends.is_empty() {
        return Err(BenchmarkError::NeverThere(nearest(flight, end, tolerance, Which::End)));
    }
    let (_, last_s) = flight.span_s();
    let mut legs = Vec::new();
    let mut left_early = false;
    let mut cut_short = None;
    for (i, visit) in starts.iter().enumerate() {
        let next_start_s = starts.get(i + 1).map_or(f64::INFINITY, |next| next.from_s);
        let after = ends.iter().filter(|e| e.from_s > visit.to_s && e.from_s < next_start_s);
        for end in after {
            let held = match arrival {
                Arrival::First => true,
                Arrival::Settle(dwell_s) => end.to_s - end.from_s >= dwell_s,
            };
            if held {
                legs.push(Leg { departure_s: visit.to_s, arrival_s: end.from_s });
                break;
            }
            left_early = true;
            cut_short = (end.to_s >= last_s).then_some(end.from_s).or(cut_short);
        }
    }
    match (&legs[..], arrival) {
        ([leg], _) => Ok(*leg),
        ([], Arrival::Settle(dwell_s)) if left_early => {
            Err(BenchmarkError::NotHeld { dwell_s, arrived_s: cut_short, last_s })
        }
        ([], _) => Err(BenchmarkError::NeverAfter),
        _ => Err(BenchmarkError::SeveralLegs(legs)),
    }
}

/// Where a flight came nearest to a state.
fn nearest(flight: &Flight, goal: &Goal, tolerance: &Tolerance, which: Which) -> Nearest {
    let distance = |s: &&Sample| goal.distance(s, tolerance);
    let best = flight.samples().iter().min_by(|a, b| distance(a).total_cmp(&distance(b)));
    let (t_s, off) = best.map_or((0.0, *tolerance), |s| (s.t_s, goal.off(s)));
    Nearest { which, t_s, off }
}

/// The hovers of a log, at rest and level within tolerance for at least `dwell_s`: where the vehicle was at the end of
/// each. Standing on the ground looks the same.
pub fn hovers(flight: &Flight, tolerance: &Tolerance, dwell_s: f64) -> Vec<Candidate> {
    let still = |s: &Sample| {
        let level = s.thrust_axis.cross(&Vector3::z()).norm().atan2(s.thrust_axis.z);
        s.velocity_mps.norm() <= tolerance.velocity_mps && level <= tolerance.angle_rad
    };
    flight
        .samples()
        .chunk_by(|a, b| still(a) == still(b))
        .filter_map(|run| {
            let (first, last) = (run.first()?, run.last()?);
            if !still(first) || last.t_s - first.t_s < dwell_s {
                return None;
            }
            let settled: Vec<&Sample> = run.iter().filter(|s| s.t_s >= last.t_s - dwell_s).collect();
            let sum: Vector3<f64> = settled.iter().map(|s| s.position_m).sum();
            Some(Candidate { from_s: first.t_s, to_s: last.t_s, position_m: sum / settled.len() as f64 })
        })
        .collect()
}

//! The score: how long a flight took, over the time of the fastest maneuver between the same two states.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use mintime_shared::model::{Limits, State};
use nalgebra::Vector3;

use super::error::BenchmarkError;
use super::find::{Arrival, Goal, Leg, Tolerance, find_leg, hovers};
use super::flight::{Flight, Remark, Sample, along};
use super::plausible;
use crate::solver::{Request, Solution, SolveError, Turns, solve, solve_all_windings};

/// How a flight is measured.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rules {
    /// Limits of the vehicle: T* is for these.
    pub limits: Limits<f64>,
    /// Windings that the fastest maneuver may take.
    pub turns: Turns,
    /// What counts as being in a state.
    pub tolerance: Tolerance,
    /// What counts as arriving. `None`: an end at rest must be held for `dwell_s`, any other is passed.
    pub arrival: Option<Arrival>,
    /// How long a rest must last to count as one, s.
    pub dwell_s: f64,
    /// Largest time between two samples within the flight, s.
    pub largest_gap_s: f64,
    /// Largest distance from the vertical plane through the two states, m.
    pub out_of_plane_m: f64,
    /// Largest acceleration that the thrust does not explain, across it in the plane and out of the plane, m/s² rms.
    pub across_mps2: f64,
}

impl Default for Rules {
    /// The paper's Table I, any winding, 0.3 s at rest (as long as `mintime fly` asks for), gaps up to 0.1 s, 0.25 m beside the plane,
    /// 6 m/s² across the thrust.
    fn default() -> Self {
        Self {
            limits: Limits::TABLE_I,
            turns: Turns::Any,
            tolerance: Tolerance::default(),
            arrival: None,
            dwell_s: 0.3,
            largest_gap_s: 0.1,
            out_of_plane_m: 0.25,
            across_mps2: 6.0,
        }
    }
}

impl Rules {
    /// Checks the numbers.
    ///
    /// # Errors
    /// [`BenchmarkError::NotPositive`], [`BenchmarkError::Limits`].
    pub fn validate(&self) -> Result<(), BenchmarkError> {
        let tolerance = &self.tolerance;
        let dwell_s = match self.arrival {
            Some(Arrival::Settle(dwell_s)) => dwell_s,
            _ => self.dwell_s,
        };
        for (value, name) in [
            (tolerance.position_m, "the tolerance of position"),
            (tolerance.velocity_mps, "the tolerance of velocity"),
            (tolerance.angle_rad, "the tolerance of angle"),
            (dwell_s, "the dwell time"),
            (self.largest_gap_s, "the largest gap"),
            (self.out_of_plane_m, "the distance out of the plane"),
            (self.across_mps2, "the acceleration across the thrust"),
        ] {
            if !(value.is_finite() && value > 0.0) {
                return Err(BenchmarkError::NotPositive(name));
            }
        }
        Ok(self.limits.validate()?)
    }
}

/// A flight measured against the fastest maneuver.
#[derive(Clone, Debug)]
pub struct Score {
    /// When it left the start and arrived at the end, by the log's clock.
    pub leg: Leg,
    /// T_controller: from departure to arrival, s.
    pub duration_s: f64,
    /// The longer of the sampling intervals in which departure and arrival lie, s: they are interpolated within these.
    pub resolution_s: f64,
    /// Heading of the vertical plane in the log's world, rad from x towards y.
    pub heading_rad: f64,
    /// Largest distance from that plane, m.
    pub out_of_plane_m: f64,
    /// The flight in the plane from departure to arrival: time from departure (s) and state, positions counted from
    /// the nominal start, pitch unwrapped.
    pub flown: Vec<(f64, State<f64>)>,
    /// The fastest maneuver from the state at departure to the state at arrival, with its certificate.
    pub optimal: Solution,
    /// T_controller / T*, with T* between the states at departure and arrival.
    pub score: f64,
    /// T* between the nominal states, s, if there is one.
    pub nominal_duration_s: Option<f64>,
    /// T_controller / T* with T* between the nominal states.
    pub nominal_score: Option<f64>,
    /// What the reader and the checks have to say.
    pub remarks: Vec<Remark>,
}

/// The score of a flight between two states; without them, between those its log declares, or between its only two
/// hovers.
///
/// # Errors
/// [`BenchmarkError`]: see there.
pub fn score(flight: &Flight, ends: Option<(Goal, Goal)>, rules: &Rules) -> Result<Score, BenchmarkError> {
    let piece = Piece::of(flight, ends, rules)?;
    let optimal = solve_all_windings(&piece.actual)?;
    let nominal_duration_s = match solve_all_windings(&piece.nominal) {
        Ok(solution) => Some(solution.extremal.duration_s()),
        Err(SolveError::NotVerified { .. }) => None,
        Err(error) => return Err(error.into()),
    };
    let Piece { leg, heading_rad, out_of_plane_m, flown, implausible, .. } = piece;
    let duration_s = leg.duration_s();
    let score = duration_s / optimal.extremal.duration_s();
    let mut remarks = flight.remarks.clone();
    remarks.extend(implausible);
    if score < 1.0 - FASTER {
        remarks.push(Remark::FasterThanOptimal);
    }
    let planned = flight.declared.and_then(|declared| declared.limits);
    remarks.extend(planned.filter(|planned| differ(planned, &rules.limits)).map(Remark::OtherLimits));
    Ok(Score {
        leg,
        duration_s,
        resolution_s: flight.interval_at(leg.departure_s).max(flight.interval_at(leg.arrival_s)),
        heading_rad,
        out_of_plane_m,
        flown,
        score,
        nominal_score: nominal_duration_s.map(|t| duration_s / t),
        nominal_duration_s,
        optimal,
        remarks,
    })
}

/// T_controller and T* (s) of a flight between two states, and nothing else of its [`score`].
pub(super) fn durations(
    flight: &Flight,
    ends: (Goal, Goal),
    rules: &Rules,
) -> Result<(f64, f64), BenchmarkError> {
    let piece = Piece::of(flight, Some(ends), rules)?;
    Ok((piece.leg.duration_s(), solve(&piece.actual)?.extremal.duration_s()))
}

/// The part of a log that is measured, found and checked.
struct Piece {
    leg: Leg,
    heading_rad: f64,
    out_of_plane_m: f64,
    flown: Vec<(f64, State<f64>)>,
    /// From the state at departure to the state at arrival.
    actual: Request,
    /// From start to end as asked for.
    nominal: Request,
    implausible: Option<Remark>,
}

impl Piece {
    fn of(flight: &Flight, ends: Option<(Goal, Goal)>, rules: &Rules) -> Result<Self, BenchmarkError> {
        rules.validate()?;
        let (start, end) = match ends {
            Some(ends) => ends,
            None => find_ends(flight, rules)?,
        };
        let rest = end.sample.velocity_mps.norm() <= rules.tolerance.velocity_mps;
        let default = if rest { Arrival::Settle(rules.dwell_s) } else { Arrival::First };
        let leg = find_leg(flight, &start, &end, &rules.tolerance, rules.arrival.unwrap_or(default))?;
        check_gaps(flight, leg, rules.largest_gap_s)?;
        let samples = flight.between(leg.departure_s, leg.arrival_s);
        let origin = start.sample.position_m;
        let heading_rad = heading(&start, &end, &samples, &rules.tolerance);
        let derived = flight.remarks.contains(&Remark::VelocitiesDerived);
        let implausible = plausible::check(&samples, heading_rad, rules, derived)?;
        let aside = |s: &Sample| (s.position_m - origin).dot(&along(heading_rad + FRAC_PI_2)).abs();
        let farthest = samples.iter().map(|s| (aside(s), s.t_s)).max_by(|a, b| a.0.total_cmp(&b.0));
        let (out_of_plane_m, t_s) = farthest.unwrap_or_default();
        if out_of_plane_m > rules.out_of_plane_m {
            return Err(BenchmarkError::OutOfPlane {
                out_m: out_of_plane_m,
                t_s,
                most_m: rules.out_of_plane_m,
            });
        }

        let flown = in_plane(&samples, leg.departure_s, origin, heading_rad);
        let state = |sample: Option<&(f64, State<f64>)>| sample.map_or_else(State::origin, |s| s.1);
        let request = |from, to| Request { from, to, limits: rules.limits, turns: rules.turns };
        let goal = |goal: &Goal| goal.sample.in_plane(origin, heading_rad);
        Ok(Self {
            leg,
            heading_rad,
            out_of_plane_m,
            actual: request(state(flown.first()), state(flown.last())),
            nominal: request(goal(&start), goal(&end)),
            flown,
            implausible,
        })
    }
}

/// How much below 1 a score may be before it is remarked on: the noise of a good log.
const FASTER: f64 = 0.005;

/// A table carries its limits in single precision.
fn differ(a: &Limits<f64>, b: &Limits<f64>) -> bool {
    let numbers = |l: &Limits<f64>| [l.thrust_min_mps2, l.thrust_max_mps2, l.rate_max_radps, l.gravity_mps2];
    numbers(a).iter().zip(numbers(b)).any(|(a, b)| (a - b).abs() > 1e-5 * b.abs())
}

/// The two states, where nobody has named them.
fn find_ends(flight: &Flight, rules: &Rules) -> Result<(Goal, Goal), BenchmarkError> {
    if let Some(declared) = flight.declared {
        let (_, last_s) = flight.span_s();
        if last_s <= declared.start_s {
            return Err(BenchmarkError::EndsBefore { last_s, start_s: declared.start_s });
        }
        let begin = flight.at(declared.start_s);
        let displacement = Sample::planar(0.0, declared.displacement, declared.heading_rad).position_m;
        let place = |position_m: Vector3<f64>| Goal::hover(position_m.into());
        return Ok((place(begin.position_m), place(begin.position_m + displacement)));
    }
    let found = hovers(flight, &rules.tolerance, rules.dwell_s);
    match &found[..] {
        [start, end] => Ok((Goal::hover(start.position_m.into()), Goal::hover(end.position_m.into()))),
        _ => Err(BenchmarkError::Ambiguous(found)),
    }
}

/// No two neighbouring samples around or within the leg are too far apart.
fn check_gaps(flight: &Flight, leg: Leg, largest_s: f64) -> Result<(), BenchmarkError> {
    let gap = flight.samples().windows(2).find_map(|pair| match pair {
        [a, b] if b.t_s > leg.departure_s && a.t_s < leg.arrival_s && b.t_s - a.t_s > largest_s => {
            Some((a.t_s, b.t_s))
        }
        _ => None,
    });
    match gap {
        Some((from_s, to_s)) => Err(BenchmarkError::Gap { from_s, to_s, largest_s }),
        None => Ok(()),
    }
}

/// The heading of the vertical plane through both states, within a quarter turn of x; for a vertical flight that of the
/// plane in which the vehicle tilts.
fn heading(start: &Goal, end: &Goal, samples: &[Sample], tolerance: &Tolerance) -> f64 {
    let displacement = end.sample.position_m - start.sample.position_m;
    let (mut x, mut y) = (displacement.x, displacement.y);
    if x.hypot(y) <= 4.0 * tolerance.position_m {
        // The direction of the largest second moment.
        let moment = |f: fn(&Vector3<f64>) -> f64| samples.iter().map(|s| f(&s.thrust_axis)).sum::<f64>();
        let (xx, xy, yy) = (moment(|a| a.x * a.x), moment(|a| a.x * a.y), moment(|a| a.y * a.y));
        let angle = 0.5 * (2.0 * xy).atan2(xx - yy);
        (y, x) = angle.sin_cos();
    }
    let heading = y.atan2(x);
    if heading > FRAC_PI_2 {
        heading - PI
    } else if heading <= -FRAC_PI_2 {
        heading + PI
    } else {
        heading
    }
}

/// The samples as planar states with unwrapped pitch.
fn in_plane(
    samples: &[Sample],
    departure_s: f64,
    origin: Vector3<f64>,
    heading_rad: f64,
) -> Vec<(f64, State<f64>)> {
    let mut before: Option<f64> = None;
    samples
        .iter()
        .map(|sample| {
            let mut state = sample.in_plane(origin, heading_rad);
            if let Some(theta) = before {
                state.theta += ((theta - state.theta) / TAU).round() * TAU;
            }
            before = Some(state.theta);
            (sample.t_s - departure_s, state)
        })
        .collect()
}

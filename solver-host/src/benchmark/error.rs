//! Why a flight has no score. Each sentence says what to do.

use mintime_shared::model::LimitsError;
use nalgebra::Vector3;

use super::find::{Leg, Tolerance};
use super::read_error::ReadError;
use crate::solver::SolveError;

/// Which of the two states.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Which {
    /// The start.
    Start,
    /// The end.
    End,
}

/// Where a flight came nearest to a state.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Nearest {
    /// To which.
    pub which: Which,
    /// When, s by the log's clock.
    pub t_s: f64,
    /// How far it was then.
    pub off: Tolerance,
}

/// A time at rest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Candidate {
    /// Its first instant, s.
    pub from_s: f64,
    /// Its last, s.
    pub to_s: f64,
    /// Where, m.
    pub position_m: Vector3<f64>,
}

/// Why a flight has no score.
#[derive(Debug, thiserror::Error)]
pub enum BenchmarkError {
    /// The log could not be read.
    #[error(transparent)]
    Read(#[from] ReadError),
    /// A number that must be above zero is not.
    #[error("{0} must be a finite number above zero")]
    NotPositive(&'static str),
    /// A controller that may tip over.
    #[error("the largest pitch of the controller must be below a quarter turn, 1.57 rad")]
    PitchTooLarge,
    /// Limits that cannot be planned with.
    #[error("{0}")]
    Limits(#[from] LimitsError),
    /// Start and end cannot be told apart.
    #[error(
        "start and end are less than two tolerances apart, so leaving the one cannot be told from arriving at the other: \
         choose other states or tighter tolerances"
    )]
    SameStates,
    /// A state that the log never reaches.
    #[error("{}", never_there(.0))]
    NeverThere(Nearest),
    /// Both states occur, but not the one after the other.
    #[error("the log holds both states, but the end never after the start: exchange --from and --to?")]
    NeverAfter,
    /// The end is reached but not held.
    #[error("{}", not_held(*.dwell_s, *.arrived_s, *.last_s))]
    NotHeld {
        /// How long it must be held, s.
        dwell_s: f64,
        /// When the end was reached for the last time, if the log ended there; s.
        arrived_s: Option<f64>,
        /// When the log ends, s.
        last_s: f64,
    },
    /// More than one flight from start to end.
    #[error("the log holds several flights between these states: {}; choose one with --between", legs(.0))]
    SeveralLegs(Vec<Leg>),
    /// Not exactly two hovers.
    #[error("{}", ambiguous(.0))]
    Ambiguous(Vec<Candidate>),
    /// The log ends before the maneuver that it declares.
    #[error(
        "the log ends at {last_s:.3} s, before its maneuver began at {start_s:.3} s: there is no flight to measure in it"
    )]
    EndsBefore {
        /// When the log ends, s.
        last_s: f64,
        /// When the maneuver began, s.
        start_s: f64,
    },
    /// Nothing in the window asked for.
    #[error("the log lasts from {first_s} s to {last_s} s: --between must leave at least two samples of it")]
    Window {
        /// First time of the log, s.
        first_s: f64,
        /// Last time, s.
        last_s: f64,
    },
    /// A hole in the flight.
    #[error(
        "between {from_s:.4} s and {to_s:.4} s, within the flight, the log has no samples for {:.3} s: more than \
         {largest_s} s hide too much of the motion (--largest-gap)", to_s - from_s
    )]
    Gap {
        /// Its begin, s.
        from_s: f64,
        /// Its end, s.
        to_s: f64,
        /// The largest allowed, s.
        largest_s: f64,
    },
    /// The flight leaves the vertical plane through start and end.
    #[error(
        "the flight leaves the vertical plane through its two states by {out_m:.3} m at {t_s:.3} s, more than {most_m} m: it \
         cannot be compared with a planar maneuver (--out-of-plane)"
    )]
    OutOfPlane {
        /// How far, m.
        out_m: f64,
        /// When, s.
        t_s: f64,
        /// The most allowed, m.
        most_m: f64,
    },
    /// Velocity columns that are not the derivative of the positions.
    #[error(
        "the log's velocities are {ratio:.3e} times what its positions and times say: check the units of time, position and \
         velocity, or leave the velocities out to have them derived"
    )]
    Velocities {
        /// Logged over derived.
        ratio: f64,
    },
    /// Motion that no vehicle with the limits given can do, by far.
    #[error(
        "at {t_s:.3} s the motion asks for a thrust per mass of {thrust_mps2:.0} m/s², where the limit given is \
         {limit_mps2} m/s²: check the units of time and position, or the limits (--thrust-per-mass)"
    )]
    Thrust {
        /// When, s.
        t_s: f64,
        /// What the motion asks for, m/s².
        thrust_mps2: f64,
        /// The limit, m/s².
        limit_mps2: f64,
    },
    /// Motion that the thrust, in the plane of the maneuver, does not explain.
    #[error("{}", across(*.across_mps2, *.most_mps2, *.mirrored))]
    Across {
        /// Root mean square of the acceleration across the thrust, in the plane and out of it, m/s².
        across_mps2: f64,
        /// The most allowed, m/s².
        most_mps2: f64,
        /// Whether the opposite sign of the pitch would fit much better.
        mirrored: bool,
    },
    /// There is no T*.
    #[error("the fastest maneuver between the two states could not be computed: {0}")]
    Solve(#[from] SolveError),
    /// The built-in controller does not arrive.
    #[error(
        "the controller does not come to rest at x = {x_m} m, z = {z_m} m within {within_s} s: choose other gains"
    )]
    NeverArrives {
        /// Displacement, m.
        x_m: f64,
        /// Displacement, m.
        z_m: f64,
        /// How long it was flown, s.
        within_s: f64,
    },
}

fn never_there(nearest: &Nearest) -> String {
    let Nearest { which, t_s, off } = nearest;
    let (name, option) = match which {
        Which::Start => ("start", "--from"),
        Which::End => ("end", "--to"),
    };
    format!(
        "the log is never within tolerance of the {name} state: it comes nearest at {t_s:.3} s, where it is {:.3} m, {:.3} m/s \
         and {:.3} rad off; choose another {option}, or wider tolerances (--tolerance-position, -velocity, -angle)",
        off.position_m, off.velocity_mps, off.angle_rad
    )
}

fn not_held(dwell_s: f64, arrived_s: Option<f64>, last_s: f64) -> String {
    match arrived_s {
        Some(t) => format!(
            "the log ends at {last_s:.3} s, {:.3} s after the arrival, and so does not show that the end is held for \
             {dwell_s} s: give --arrival first, or a shorter --dwell",
            last_s - t
        ),
        None => format!(
            "the end state is passed but never held for {dwell_s} s: give --arrival first to count the first passage, or a \
             shorter --dwell, or wider tolerances"
        ),
    }
}

fn across(across_mps2: f64, most_mps2: f64, mirrored: bool) -> String {
    let cure = if mirrored {
        "with the opposite sign of the pitch it is much less, so theta must be made positive nose-down, towards +x"
    } else {
        "check the units of time, position and angle, and that the flight stays in one vertical plane"
    };
    format!(
        "the motion accelerates {across_mps2:.1} m/s² (rms) across the vehicle's thrust in the plane of the maneuver, more than \
         {most_mps2:.1} m/s², drag included: a quadrotor accelerates along its thrust, so T / T* would mean nothing; {cure} (--across allows more)"
    )
}

fn legs(legs: &[Leg]) -> String {
    list(legs, |leg| format!("{:.3} s to {:.3} s", leg.departure_s, leg.arrival_s))
}

fn ambiguous(found: &[Candidate]) -> String {
    let place = |c: &Candidate| {
        let [x, y, z] = [c.position_m.x, c.position_m.y, c.position_m.z];
        format!("{x:.3},{y:.3},{z:.3} m from {:.3} s to {:.3} s", c.from_s, c.to_s)
    };
    match found {
        [] => "the log holds no times at rest: give the states with --from and --to".to_owned(),
        [one] => format!(
            "the log holds one time at rest only ({}): give the states with --from and --to",
            place(one)
        ),
        _ => format!(
            "the log holds {} times at rest: {}; choose with --from and --to, or --between",
            found.len(),
            list(found, place)
        ),
    }
}

/// The first eight, and how many more.
fn list<T>(items: &[T], text: impl Fn(&T) -> String) -> String {
    const MOST: usize = 8;
    let shown = items.iter().take(MOST).map(text).collect::<Vec<_>>().join(", ");
    match items.len().saturating_sub(MOST) {
        0 => shown,
        more => format!("{shown} and {more} more"),
    }
}

//! A campaign: fly, see where it ended, correct, fly again; and in the end fly what was learned a few times more.

use mintime_shared::table::{ManeuverTable, TableError};
use nalgebra::DMatrix;

use super::correction::{CorrectionError, Limit, correct_within};
use super::history::{Across, FlightEntry, History, POSITION_TOLERANCE_M, StateError, hexadecimal};
use super::model::Response;
use super::observation::{Observed, effect_of_start};
use super::parameters::{Parameters, TURNED_FROM_M};
use super::plan::LearningPlan;

/// Learned: this near the end, in tolerances, ...
pub const LEARNED: f64 = 0.6;
/// ... in so many flights in a row.
const LEARNED_FLIGHTS: u32 = 2;
/// Within the tolerances a part of the error is chance: a correction takes this part of it away.
const GAIN_WITHIN: f64 = 0.5;
/// Flights without progress after which it is given up, ...
const STALLED_FLIGHTS: u32 = 5;
/// ... where progress is to come this much nearer than ever before.
const PROGRESS: f64 = 0.9;
/// A correction whose table no vehicle takes is halved so many times at most.
const HALVINGS: u32 = 5;
/// Flights in a row that may fail before it is given up.
const FAILED_FLIGHTS: u32 = 2;
/// A flight that ends this many times farther away than the best so far is a step too far.
const TOO_FAR: f64 = 1.5;

/// A flight that was seen to its end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Flown {
    /// What motion capture saw.
    pub observed: Observed,
    /// The final error by the simulator's truth.
    pub true_final_error: Option<StateError>,
    /// How far out of the plane it ended by the simulator's truth.
    pub true_across: Option<Across>,
    /// `completed` or `not-caught`.
    pub outcome: &'static str,
}

/// A flight that teaches nothing.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum FlightFailure {
    /// It was landed, but the maneuver was not flown or not to its end, or not seen: the next one may be.
    #[error("{reason}")]
    Broken {
        /// `aborted`, `not-triggered` or `not-seen`.
        outcome: &'static str,
        /// Why.
        reason: String,
    },
    /// The vehicle or the link is lost, a person stopped it, or the table cannot be flown here: there is no next one.
    #[error("{reason}")]
    Lost {
        /// Why.
        reason: String,
    },
}

/// Something that can fly tables.
pub trait Flyer {
    /// Flies a table, from take-off to landing. Flights are numbered from 1, repeats included.
    ///
    /// # Errors
    /// [`FlightFailure`].
    fn fly(&mut self, table: &ManeuverTable, number: u32) -> Result<Flown, FlightFailure>;
}

/// Told of a campaign as it goes.
pub trait Observer {
    /// A flight is over, or learning has ended. `table` is the best so far.
    fn flown(&mut self, history: &History, table: &ManeuverTable);
}

/// How much to fly.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Budget {
    /// Flights that teach, at most.
    pub flights: u32,
    /// Flights of what was learned.
    pub repeats: u32,
}

/// Why learning ended.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum StopReason {
    /// It worked.
    #[error("learned: {LEARNED_FLIGHTS} flights in a row ended within {LEARNED} of the tolerances")]
    Converged,
    /// No more flights.
    #[error(
        "the flights are used up; the best ended {best:.1} tolerances away: allow more flights, or look at what scatters"
    )]
    FlightsUsedUp {
        /// The least error, in tolerances; infinite where no flight was seen to its end.
        best: f64,
    },
    /// No progress.
    #[error(
        "it does not converge: {STALLED_FLIGHTS} flights brought nothing a tenth better, {best:.1} tolerances were the best; plan with lower limits, \
         and see that battery, propellers and cameras are as they were when it was identified"
    )]
    NotConverging {
        /// The least error, in tolerances.
        best: f64,
    },
    /// The Jacobian has lost a direction.
    #[error(transparent)]
    Correction(#[from] CorrectionError),
    /// The correction makes a table that no vehicle takes.
    #[error(
        "the next correction would make a table that the vehicle refuses: {0}; the best table is kept. Another maneuver may have more \
         freedom"
    )]
    Table(#[from] TableError),
    /// Flights fail.
    #[error("{FAILED_FLIGHTS} flights in a row were not flown to their end; the last one: {0}")]
    Broken(String),
    /// The vehicle is lost.
    #[error("flying had to end: {0}")]
    Lost(String),
}

/// What a campaign leaves.
#[derive(Clone, Debug)]
pub struct Learned {
    /// What was flown.
    pub history: History,
    /// The best table.
    pub table: ManeuverTable,
    /// Why learning ended.
    pub stop: StopReason,
}

/// Up to this error the end moves with the parameters in a straight line, nearly, in tolerances.
const STRAIGHT: f64 = 3.0;
/// An error that says something of drag, in tolerances.
const DRAG_SHOWS: f64 = 3.0;

/// One try: parameters, and the way to the next ones.
struct Learner<'a> {
    plan: &'a LearningPlan,
    response: Response,
    parameters: Parameters,
    jacobian: DMatrix<f64>,
    best: Option<Best>,
    last: Option<f64>,
    within: u32,
    stalled: u32,
    /// Part of the correction that is believed; less after a step too far.
    trust: f64,
}

/// A table that misses by more than this many tolerances is not flown again for its statistics: known to miss, it would
/// only miss again, perhaps the room.
const WORTH_REPEATING: f64 = 3.0;

/// Where a flight ended, less what its start explains.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Miss {
    /// In the plane.
    error: StateError,
    /// Out of it, to the left, m; zero where no heading would change that.
    across_m: f64,
}

impl Miss {
    /// The largest of distance, speed and angle, each in units of its tolerance.
    fn in_tolerances(&self) -> f64 {
        let distance_m = self.error.position_m().hypot(self.across_m);
        self.error.in_tolerances().max(distance_m / POSITION_TOLERANCE_M)
    }
}

struct Best {
    parameters: Parameters,
    miss: Miss,
    table: ManeuverTable,
    flight: usize,
}

/// Learns a maneuver. The history tells what to call it; its plan's numbers, flights and repeats are filled in. Whatever
/// happens on the way is a [`StopReason`].
pub fn learn(
    plan: &LearningPlan,
    mut history: History,
    budget: Budget,
    flyer: &mut impl Flyer,
    observer: &mut impl Observer,
) -> Learned {
    history.heading_rad = plan.heading_rad;
    history.planned_duration_s = plan.planned_duration_s;
    history.optimum_duration_s = plan.optimum_duration_s;
    history.learned_duration_s = f64::from(plan.table.duration_s());
    let parameters = Parameters::of(&plan.table);
    let jacobian = plan.response.linearised(&plan.table, &parameters).1;
    let mut learner = Learner {
        plan,
        response: plan.response,
        parameters,
        jacobian,
        best: None,
        last: None,
        within: 0,
        stalled: 0,
        trust: 1.0,
    };
    let stop = learner.teach(&mut history, budget.flights, flyer, observer);
    let near = learner.best.as_ref().is_some_and(|best| best.miss.in_tolerances() <= WORTH_REPEATING);
    let table = learner.best.map_or_else(|| plan.table.clone(), |best| best.table);
    history.converged = stop == StopReason::Converged;
    history.reason = Some(stop.to_string());
    observer.flown(&history, &table);
    if near && !matches!(stop, StopReason::Lost(_)) {
        for repeat in 1..=budget.repeats {
            let number = history.flights.len() as u32 + repeat;
            let flown = flyer.fly(&table, number);
            let lost = matches!(flown, Err(FlightFailure::Lost { .. }));
            history.repeats.push(entry(&table, &flown));
            observer.flown(&history, &table);
            if lost {
                break;
            }
        }
    }
    Learned { history, table, stop }
}

impl Learner<'_> {
    fn teach(
        &mut self,
        history: &mut History,
        flights: u32,
        flyer: &mut impl Flyer,
        observer: &mut impl Observer,
    ) -> StopReason {
        let mut failed = 0;
        for number in 1..=flights {
            let table = match self.parameters.into_table(&self.plan.table) {
                Ok(table) => table,
                Err(error) => return StopReason::Table(error),
            };
            let flown = flyer.fly(&table, number);
            let mut stop = match &flown {
                Ok(flown) => {
                    failed = 0;
                    self.take(flown, &table, history.flights.len())
                }
                Err(FlightFailure::Lost { reason }) => Some(StopReason::Lost(reason.clone())),
                Err(FlightFailure::Broken { reason, .. }) => {
                    failed += 1;
                    self.last = None;
                    self.back();
                    (failed >= FAILED_FLIGHTS).then(|| StopReason::Broken(reason.clone()))
                }
            };
            history.flights.push(entry(&table, &flown));
            if stop.is_none() && number < flights {
                let relinearised = self.linearise(history);
                if let Some(entry) = history.flights.last_mut() {
                    entry.relinearised = relinearised;
                }
                stop = self.correct(history).err().map(StopReason::Correction);
            }
            if let Some(best) = &self.best {
                history.best = Some(best.flight);
                history.learned_duration_s = f64::from(best.table.duration_s());
            }
            let kept = self.best.as_ref().map_or(&self.plan.table, |best| &best.table);
            observer.flown(history, kept);
            if let Some(stop) = stop {
                return stop;
            }
        }
        let best = self.best.as_ref().map_or(f64::INFINITY, |best| best.miss.in_tolerances());
        StopReason::FlightsUsedUp { best }
    }

    /// Takes the end of a flight into account. `Some` where that ends the campaign.
    fn take(&mut self, flown: &Flown, table: &ManeuverTable, flight: usize) -> Option<StopReason> {
        let miss = self.miss(systematic(flown, table), systematic_across_m(flown));
        let far = miss.in_tolerances();
        let before = self.best.as_ref().map_or(f64::INFINITY, |best| best.miss.in_tolerances());
        self.stalled = if far < PROGRESS * before { 0 } else { self.stalled + 1 };
        if far < before {
            let (parameters, table) = (self.parameters.clone(), table.clone());
            self.best = Some(Best { parameters, miss, table, flight });
        }
        self.within = if far <= LEARNED { self.within + 1 } else { 0 };
        if self.within >= LEARNED_FLIGHTS {
            return Some(StopReason::Converged);
        }
        let best = far.min(before);
        (self.stalled >= STALLED_FLIGHTS).then_some(StopReason::NotConverging { best })
    }

    /// Computes the Jacobian afresh where the last correction did not halve the error, where the error is so large that the
    /// maneuver bends on the way, and where the first flight has said what drag there is. Whether it did.
    fn linearise(&mut self, history: &History) -> bool {
        let Some(error) = history.flights.last().and_then(|f| f.systematic_error) else { return false };
        let far = error.in_tolerances();
        let first = self.response == self.plan.response && far > DRAG_SHOWS;
        if first {
            self.response = self.response.with_drag_of(&self.plan.table, &self.parameters, &error);
        }
        let halved = self.last.is_none_or(|last| far <= 0.5 * last);
        let fresh = first || far > STRAIGHT || (!halved && far > 1.0);
        self.last = Some(far);
        match &self.best {
            Some(best) if far > TOO_FAR * best.miss.error.in_tolerances().max(1.0) => self.back(),
            _ => self.trust = (2.0 * self.trust).min(1.0),
        }
        if !fresh {
            return false;
        }
        self.jacobian = self.response.linearised(&self.plan.table, &self.parameters).1;
        true
    }

    /// The parameters of the next flight.
    fn correct(&mut self, history: &History) -> Result<(), CorrectionError> {
        let last = history.flights.last();
        let last = last.and_then(|f| Some(self.miss(f.systematic_error?, f.systematic_across_m?)));
        // After a step too far it starts again from the best.
        let Miss { error, across_m } = match (&self.best, last) {
            (Some(best), _) if best.parameters == self.parameters => best.miss,
            (_, Some(last)) => last,
            _ => return Ok(()),
        };
        let rate_max = f64::from(self.plan.table.limits.rate_max_radps);
        let gain = if error.in_tolerances() <= 1.0 { GAIN_WITHIN } else { self.trust };
        let step = |limit: Option<&Limit>| {
            let correction = correct_within(&self.jacobian, &error, &self.parameters, rate_max, limit)?;
            // As far as a vehicle takes the table.
            let moved =
                |n: u32| self.parameters.moved(&(&correction.change * (gain * 0.5_f64.powi(n as i32))));
            let taken = (0..=HALVINGS).map(moved).find(|moved| moved.into_table(&self.plan.table).is_ok());
            Ok::<_, CorrectionError>((taken, moved(HALVINGS)))
        };
        let (taken, shortest) = step(None)?;
        // Arcs that would turn too fast are held at their limit, and the other numbers do without.
        let held = || step(Some(&Limit::of_arcs(&self.parameters, &self.plan.table)?)).ok()?.0;
        let next = taken.or_else(held).unwrap_or(shortest);
        let turn = if across_m.abs() <= POSITION_TOLERANCE_M { GAIN_WITHIN } else { 1.0 };
        self.parameters = next.turned(turn * across_m, self.along_m(), self.plan.heading_rad);
        Ok(())
    }

    fn miss(&self, error: StateError, across_m: f64) -> Miss {
        Miss { error, across_m: if self.along_m().abs() < TURNED_FROM_M { 0.0 } else { across_m } }
    }

    /// How far the maneuver goes along its heading, m.
    fn along_m(&self) -> f64 {
        f64::from(self.plan.table.end.x - self.plan.table.start.x)
    }

    /// Back to the best parameters, to go on from there with half the step.
    fn back(&mut self) {
        if let Some(best) = &self.best {
            self.trust *= 0.5;
            self.parameters = best.parameters.clone();
        }
    }
}

/// The error at the end less what the start explains.
fn systematic(flown: &Flown, table: &ManeuverTable) -> StateError {
    flown.observed.final_error.minus(&effect_of_start(&flown.observed.start_error, table))
}

/// The way out of the plane less what the start explains, m.
fn systematic_across_m(flown: &Flown) -> f64 {
    flown.observed.across.y_m - flown.observed.across_from_start_m
}

fn entry(table: &ManeuverTable, flown: &Result<Flown, FlightFailure>) -> FlightEntry {
    let seen = flown.as_ref().ok();
    let (outcome, reason) = match flown {
        Ok(flown) => (flown.outcome, None),
        Err(FlightFailure::Broken { outcome, reason }) => (*outcome, Some(reason.clone())),
        Err(FlightFailure::Lost { reason }) => ("lost", Some(reason.clone())),
    };
    FlightEntry {
        outcome: outcome.to_owned(),
        reason,
        duration_s: f64::from(table.duration_s()),
        start_error: seen.map(|f| f.observed.start_error),
        final_error: seen.map(|f| f.observed.final_error),
        systematic_error: seen.map(|f| systematic(f, table)),
        across: seen.map(|f| f.observed.across),
        systematic_across_m: seen.map(systematic_across_m),
        true_final_error: seen.and_then(|f| f.true_final_error),
        true_across: seen.and_then(|f| f.true_across),
        relinearised: false,
        table: hexadecimal(table),
    }
}

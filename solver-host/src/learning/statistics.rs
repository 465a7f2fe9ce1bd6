//! How well learning works: many simulated vehicles, the maneuvers of the paper, and plain policy gradient beside it.

use std::sync::Mutex;
use std::sync::atomic::{AtomicU32, Ordering};

use mintime_shared::model::{Limits, State};
use mintime_shared::table::ManeuverTable;
use mintime_shared::vehicle::VehicleConfig;
use mintime_simulator::VehicleParameters;
use serde::Serialize;

use super::campaign::{Budget, Flyer, Learned, Observer, learn};
use super::history::{ANGLE_TOLERANCE_RAD, Across, FlightEntry, History, StateError};
use super::model::Response;
use super::plain::{Rule, RuleResult, learn_plainly};
use super::plan::{Target, plan};
use super::simulated::{SimulatedFlyer, SimulatedVehicle, Unseen};
use crate::mission::{PlantChoice, VehicleChoice};
use crate::solver::Turns;

/// Error of the vehicles' thrust, as a part of it: evenly spread between minus and plus this.
pub const THRUST_ERROR: f64 = 0.10;
/// Longest learned duration that is good enough, over the optimum.
pub const DURATION_MAX: f64 = 1.20;

/// The maneuvers: displacement, m, and name.
pub const MANEUVERS: [(f64, f64, &str); 4] =
    [(5.0, 5.0, "(5, 5)"), (3.0, 0.0, "3 m dash"), (15.0, 0.0, "15 m dash"), (0.0, 4.0, "4 m flip")];

/// What to fly.
#[derive(Clone, Debug)]
pub struct StatisticsPlan {
    /// What flies.
    pub choice: VehicleChoice,
    /// Number of vehicles; their seeds are 1, 2, 3 and so on.
    pub vehicles: u32,
    /// Flights that teach, at most, and repeats.
    pub budget: Budget,
    /// Flights of one table, to see what scatters; 0 for none.
    pub scatter: u32,
    /// Flights of each plain rule, at most; 0 for none.
    pub gradient_flights: u32,
    /// Campaigns that run at the same time.
    pub threads: u32,
}

/// One vehicle and one maneuver.
#[derive(Clone, Debug, Serialize)]
pub struct Case {
    /// The maneuver.
    pub maneuver: String,
    /// The vehicle's seed.
    pub seed: u64,
    /// Its thrust over what its file says.
    pub strength: f64,
    /// The campaign; `None` where nothing could be planned, and `reason` says why.
    pub history: Option<History>,
    /// Why learning ended.
    pub reason: String,
    /// Mean over the repeats of distance (m), speed (m/s) and angle (rad) from the planned end, in the maneuver's plane, by truth.
    pub mean: Option<[f64; 3]>,
    /// The first two of them in space.
    pub mean_in_space: Option<[f64; 2]>,
    /// Whether `mean` is within the tolerances, with a duration of at most [`DURATION_MAX`] optima.
    pub success: bool,
    /// Whether it is with `mean_in_space`, too.
    pub success_in_space: bool,
    /// Root of the mean square, about their mean, of distance (m), speed (m/s) and angle (rad) at the end of identical flights.
    pub scatter: Option<[f64; 3]>,
    /// The same maneuver by plain policy gradient.
    pub gradient: Option<RuleResult>,
    /// The same by steps of a fixed inverse.
    pub inverse: Option<RuleResult>,
}

impl Case {
    /// Learned duration over the optimum.
    pub fn duration_ratio(&self) -> Option<f64> {
        self.history.as_ref().map(|h| h.learned_duration_s / h.optimum_duration_s)
    }
}

/// An airframe with all of the simulator's errors and another thrust.
pub fn airframe(strength: f64) -> PlantChoice {
    let mut parameters = VehicleParameters::nominal();
    parameters.rotors.thrust_coefficient_ns2 *= strength;
    PlantChoice { name: format!("nominal, thrust {strength:.3}"), parameters }
}

/// The thrust of vehicle `index` (from 0) of so many, over what its file says.
pub fn strength(index: u32, vehicles: u32) -> f64 {
    let part = if vehicles > 1 { f64::from(index) / f64::from(vehicles - 1) } else { 0.5 };
    1.0 + THRUST_ERROR * (2.0 * part - 1.0)
}

/// The maneuver that is learned, with the limits of the paper's Table I.
pub fn target((x_m, z_m, _): (f64, f64, &str)) -> Target {
    Target::Solve {
        to: State::at_rest(x_m, z_m),
        limits: Limits::TABLE_I,
        turns: Turns::Any,
        heading_rad: 0.0,
    }
}

/// Flies everything. `seen` is told of each case as it is done, in no order; the answer is in order.
pub fn statistics(plan: &StatisticsPlan, seen: impl Fn(&Case) + Sync) -> Vec<Case> {
    let next = AtomicU32::new(0);
    let cases = Mutex::new(Vec::new());
    std::thread::scope(|scope| {
        for _ in 0..plan.threads.max(1) {
            scope.spawn(|| {
                loop {
                    let index = next.fetch_add(1, Ordering::Relaxed);
                    if index >= plan.vehicles {
                        break;
                    }
                    for case in of_vehicle(plan, index, &seen) {
                        if let Ok(mut cases) = cases.lock() {
                            cases.push(case);
                        }
                    }
                }
            });
        }
    });
    let mut cases = cases.into_inner().unwrap_or_default();
    let place = |case: &Case| MANEUVERS.iter().position(|m| m.2 == case.maneuver);
    cases.sort_by_key(|case| (place(case), case.seed));
    cases
}

fn of_vehicle(plan: &StatisticsPlan, index: u32, seen: &impl Fn(&Case)) -> Vec<Case> {
    let strength = strength(index, plan.vehicles);
    let mut vehicle = SimulatedVehicle {
        choice: plan.choice.clone(),
        plant: airframe(strength),
        seed: u64::from(index) + 1,
        room: None,
        response: Response::IDEAL,
        heading_rad: 0.0,
    };
    let found = vehicle.identify(&mut Unseen);
    MANEUVERS
        .iter()
        .map(|maneuver| {
            let mut case = Case {
                maneuver: maneuver.2.to_owned(),
                seed: vehicle.seed,
                strength,
                history: None,
                reason: String::new(),
                mean: None,
                mean_in_space: None,
                success: false,
                success_in_space: false,
                scatter: None,
                gradient: None,
                inverse: None,
            };
            match &found {
                Ok(found) => {
                    vehicle.response = Response::identified(found);
                    learn_one(plan, &vehicle, &target(*maneuver), found, &mut case);
                }
                Err(error) => case.reason = error.to_string(),
            }
            seen(&case);
            case
        })
        .collect()
}

fn learn_one(
    statistics: &StatisticsPlan,
    vehicle: &SimulatedVehicle,
    target: &Target,
    found: &super::history::IdentifiedResponse,
    case: &mut Case,
) {
    let plan = match plan(target, &VehicleConfig::REFERENCE, found) {
        Ok(plan) => plan,
        Err(error) => {
            case.reason = error.to_string();
            return;
        }
    };
    let mut unseen = Unseen;
    let mut flyer = SimulatedFlyer { vehicle, witness: &mut unseen, last: None };
    let mut history = History::of(&case.maneuver, vehicle.choice.name(), Some(vehicle.seed));
    history.identified = Some(*found);
    let Learned { history, table, stop } = learn(&plan, history, statistics.budget, &mut flyer, &mut Silent);
    case.reason = stop.to_string();
    (case.mean, case.mean_in_space) = means(&history.repeats).unzip();
    let good = case.mean.is_some_and(within) && history.converged;
    case.history = Some(history);
    case.success = good && case.duration_ratio().is_some_and(|r| r <= DURATION_MAX);
    case.success_in_space = case.success && case.mean_in_space.is_some_and(|[p, v]| within([p, v, 0.0]));
    case.scatter = scatter(&table, statistics.scatter, &mut flyer);
    if statistics.gradient_flights > 0 {
        let flights = statistics.gradient_flights;
        case.gradient = learn_plainly(Rule::PolicyGradient, target, &mut flyer, flights).ok();
        case.inverse = learn_plainly(Rule::FixedInverse, target, &mut flyer, flights).ok();
    }
}

/// Whether distance, speed and angle are within the tolerances.
fn within([position_m, velocity_mps, angle_rad]: [f64; 3]) -> bool {
    use super::history::{POSITION_TOLERANCE_M, VELOCITY_TOLERANCE_MPS};
    position_m <= POSITION_TOLERANCE_M
        && velocity_mps <= VELOCITY_TOLERANCE_MPS
        && angle_rad <= ANGLE_TOLERANCE_RAD
}

/// Means over flights: distance, speed and angle from the planned end in the maneuver's plane; distance and speed in space. `None`
/// where a flight did not get there.
fn means(flights: &[FlightEntry]) -> Option<([f64; 3], [f64; 2])> {
    let ends: Vec<(StateError, Across)> = flights
        .iter()
        .map(|f| f.true_final_error.zip(f.true_across).or(f.final_error.zip(f.across)))
        .collect::<Option<_>>()?;
    let count = ends.len() as f64;
    let of = |part: fn(&(StateError, Across)) -> f64| ends.iter().map(part).sum::<f64>() / count;
    (count > 0.0).then(|| {
        let plane =
            [of(|(e, _)| e.position_m()), of(|(e, _)| e.velocity_mps()), of(|(e, _)| e.theta_rad.abs())];
        let distance_m = of(|(e, across)| e.position_m().hypot(across.y_m));
        let speed_mps = of(|(e, across)| e.velocity_mps().hypot(across.vy_mps));
        (plane, [distance_m, speed_mps])
    })
}

/// Scatter of identical flights about their mean. They have other numbers, and so other noise, than all flights before.
fn scatter(table: &ManeuverTable, flights: u32, flyer: &mut impl Flyer) -> Option<[f64; 3]> {
    let ends: Vec<[f64; 5]> = (0..flights)
        .filter_map(|i| {
            let flown = flyer.fly(table, 1000 + i).ok()?;
            Some(flown.true_final_error.unwrap_or(flown.observed.final_error).to_array())
        })
        .collect();
    let count = ends.len() as f64;
    if ends.len() < 2 {
        return None;
    }
    let variance = |i: usize| {
        let mean = ends.iter().map(|e| e[i]).sum::<f64>() / count;
        ends.iter().map(|e| (e[i] - mean).powi(2)).sum::<f64>() / (count - 1.0)
    };
    Some([(variance(0) + variance(2)).sqrt(), (variance(1) + variance(3)).sqrt(), variance(4).sqrt()])
}

/// Watches and keeps nothing.
struct Silent;

impl Observer for Silent {
    fn flown(&mut self, _: &History, _: &ManeuverTable) {}
}

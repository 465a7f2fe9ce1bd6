//! Learning: the model's derivatives against another integrator, the correction on vehicles that are known, campaigns that
//! cannot succeed, and simulated vehicles that do.

use mintime::learning::{
    Across, Budget, CorrectionError, FlightFailure, Flown, Flyer, History, IdentifiedResponse, Learned,
    Observed, Observer, Parameters, PlanError, Response, SimulatedFlyer, SimulatedVehicle, StateError,
    StatisticsPlan, StopReason, Target, Unseen, airframe, correct, effect_of_start, learn, plan, statistics,
    target,
};
use mintime::mission::VehicleChoice;
use mintime::pack::pack;
use mintime::solver::{Request, Turns, solve};
use mintime_shared::model::{Inputs, Limits, RateMode, Segment, State, ThrustLevel};
use mintime_shared::table::{ANY_VEHICLE, Kind, LinkPolicy, ManeuverTable, TableHeader};
use mintime_shared::vehicle::VehicleConfig;
use nalgebra::DVector;

const MANEUVERS: [(f64, f64); 4] = [(5.0, 5.0), (3.0, 0.0), (15.0, 0.0), (0.0, 4.0)];
const SLUGGISH: Response =
    Response { thrust_scale: 0.93, thrust_lag_s: 0.012, rate_lag_s: 0.011, drag_per_s: 0.4 };
const AS_FILE: IdentifiedResponse =
    IdentifiedResponse { thrust_scale: 1.0, thrust_scale_std: 0.0, rotor_lag_s: 0.033, response_s: 0.010 };

fn table(x: f64, z: f64) -> ManeuverTable {
    let solution = solve(&Request::rest_to_rest(x, z)).expect("a maneuver");
    pack(&solution.extremal, ANY_VEHICLE, 0.0).expect("a table")
}

fn to(x: f64, z: f64) -> Target {
    let limits = Limits::TABLE_I;
    Target::Solve { to: State::at_rest(x, z), limits, turns: Turns::Any, heading_rad: 0.0 }
}

/// The model once more, written another way: lags by their exact exponentials, everything else by the rule of the midpoint, in
/// steps of 5 µs.
fn end_by_small_steps(response: &Response, table: &ManeuverTable, parameters: &Parameters) -> [f64; 5] {
    let limits = table.limits.cast::<f64>();
    let (mut x, mut vx, mut z, mut vz) = (0.0_f64, 0.0, 0.0, 0.0);
    let (mut theta, mut omega) = (0.0_f64, 0.0);
    let mut force = limits.gravity_mps2 / response.thrust_scale;
    let own = table.arcs.map(|a| (f64::from(a.width_s), f64::from(a.peak_s)));
    let (width, peak) = parameters.arc.or(own).unwrap_or((1.0, 0.0));
    let mut began = 0.0;
    for (segment, duration) in table.segments().zip(&parameters.durations_s) {
        let steps = (duration / 5.0e-6).ceil();
        let h = duration / steps;
        for i in 0..steps as u64 {
            let t = began + (i as f64 + 0.5) * h;
            let rate = match segment.inputs.rate {
                RateMode::Plus => limits.rate_max_radps,
                RateMode::Minus => -limits.rate_max_radps,
                RateMode::Singular => width / (width * width + (t - peak).powi(2)),
            };
            let thrust = limits.thrust(segment.inputs.thrust);
            let half = |is: f64, wished: f64, lag: f64| {
                if lag == 0.0 { wished } else { wished + (is - wished) * (-0.5 * h / lag).exp() }
            };
            let (omega_mid, force_mid) =
                (half(omega, rate, response.rate_lag_s), half(force, thrust, response.thrust_lag_s));
            (omega, force) =
                (half(omega_mid, rate, response.rate_lag_s), half(force_mid, thrust, response.thrust_lag_s));
            let (sin, cos) = (theta + 0.5 * h * omega_mid).sin_cos();
            let given = response.thrust_scale * force_mid;
            let along = vx * cos - vz * sin;
            let drag = response.drag_per_s * (given / limits.gravity_mps2).sqrt() * along;
            let (ax, az) = (given * sin - drag * cos, given * cos + drag * sin - limits.gravity_mps2);
            x += h * (vx + 0.5 * h * ax);
            z += h * (vz + 0.5 * h * az);
            vx += h * ax;
            vz += h * az;
            theta += h * omega_mid;
        }
        began += duration;
    }
    [x, vx, z, vz, theta]
}

#[test]
fn the_jacobian_is_that_of_another_integrator_by_finite_differences() {
    for (dx, dz) in MANEUVERS {
        let table = table(dx, dz);
        let parameters = Parameters::of(&table);
        for response in [Response::IDEAL, SLUGGISH] {
            let (end, jacobian) = response.linearised(&table, &parameters);
            let other = end_by_small_steps(&response, &table, &parameters);
            for (a, b) in end.to_array().into_iter().zip(other) {
                assert!((a - b).abs() < 2e-4, "({dx}, {dz}): {end:?} {other:?}");
            }
            for j in 0..parameters.count() {
                let step = 1e-4 * parameters.scales()[j] / 0.02;
                let moved = |by: f64| {
                    let mut change = DVector::zeros(parameters.count());
                    change[j] = by;
                    end_by_small_steps(&response, &table, &parameters.moved(&change))
                };
                let (up, down) = (moved(step), moved(-step));
                for i in 0..5 {
                    let difference = (up[i] - down[i]) / (2.0 * step);
                    let exact = jacobian[(i, j)];
                    assert!(
                        (exact - difference).abs() < 2e-3 * (1.0 + difference.abs()),
                        "({dx}, {dz}), row {i}, column {j}: {exact} {difference}"
                    );
                }
            }
        }
    }
}

#[test]
fn the_ideal_model_ends_where_the_plan_ends() {
    for (dx, dz) in MANEUVERS {
        let table = table(dx, dz);
        let miss = Response::IDEAL.end(&table, &Parameters::of(&table)).minus(table.end.cast());
        assert!(miss.to_array().iter().all(|v| v.abs() < 1e-4), "({dx}, {dz}): {miss:?}");
    }
}

#[test]
fn a_start_that_is_off_moves_the_end_as_predicted() {
    let table = table(5.0, 5.0);
    let parameters = Parameters::of(&table);
    let start = StateError { x_m: 0.0, vx_mps: 0.01, z_m: 0.0, vz_mps: -0.02, theta_rad: 1e-3 };
    let predicted = effect_of_start(&start, &table);
    let mut other = table.clone();
    other.start = State { vx: 0.01, vz: -0.02, theta: 1e-3, ..table.start };
    let moved =
        Response::IDEAL.end(&other, &parameters).minus(Response::IDEAL.end(&table, &parameters)).to_array();
    for (a, b) in predicted.to_array().into_iter().zip(moved) {
        assert!((a - b).abs() < 1e-4, "{predicted:?} {moved:?}");
    }
    // The figure of the theory: 14.8 m/rad, and the drift of the speed.
    assert!((predicted.x_m - 0.0148 - 0.0141).abs() < 2e-4, "{predicted:?}");
}

#[test]
fn five_directions_are_moved_by_every_maneuver_of_the_paper() {
    for (dx, dz) in MANEUVERS {
        let table = table(dx, dz);
        let parameters = Parameters::of(&table);
        let jacobian = SLUGGISH.linearised(&table, &parameters).1;
        let error = StateError { x_m: 0.01, ..StateError::default() };
        let correction = correct(&jacobian, &error, &parameters, 10.0).expect("rank 5");
        assert_eq!(correction.singular_values.len(), 5);
        assert!(correction.condition() < 200.0, "({dx}, {dz}): {}", correction.condition());
        // A full step solves the linear model.
        let left = &jacobian * &correction.change + DVector::from_column_slice(&error.to_array());
        assert!(correction.damping > 0.0 || left.amax() < 1e-9, "({dx}, {dz}): {left}");
    }
}

#[test]
fn corrections_of_the_right_model_converge_quadratically() {
    let table = table(5.0, 5.0);
    let mut parameters = Parameters::of(&table);
    let mut ends = Vec::new();
    for _ in 0..7 {
        let (end, jacobian) = SLUGGISH.linearised(&table, &parameters);
        let error = StateError::from_array(end.minus(table.end.cast()).to_array());
        ends.push(error.in_tolerances());
        parameters = parameters.moved(&correct(&jacobian, &error, &parameters, 10.0).expect("rank 5").change);
    }
    assert!(ends[0] > 10.0 && *ends.last().expect("seven") < 1e-6, "{ends:?}");
    // Once near, an error is at most some part of the square of the one before.
    let near: Vec<_> = ends.windows(2).filter(|w| (1e-5..1.0).contains(&w[0])).collect();
    assert!(!near.is_empty() && near.iter().all(|w| w[1] < 0.5 * w[0] * w[0] + 1e-8), "{ends:?}");
}

fn of_segments(segments: &[(RateMode, ThrustLevel, f32)]) -> ManeuverTable {
    let header = TableHeader {
        vehicle: ANY_VEHICLE,
        kind: Kind::Learned,
        link: LinkPolicy::Finish,
        limits: Limits::TABLE_I.cast(),
        heading_rad: 0.0,
        start: State::origin(),
        end: State::origin(),
    };
    let segments = segments
        .iter()
        .map(|&(rate, thrust, duration)| Segment { inputs: Inputs { rate, thrust }, duration });
    ManeuverTable::new(header, None, segments).expect("a table")
}

#[test]
fn too_few_numbers_are_refused_and_so_are_numbers_that_do_the_same() {
    use RateMode::{Minus, Plus};
    use ThrustLevel::{Max, Min};
    let refused = |table: &ManeuverTable| {
        let parameters = Parameters::of(table);
        let jacobian = Response::IDEAL.linearised(table, &parameters).1;
        correct(&jacobian, &StateError { x_m: 0.1, ..StateError::default() }, &parameters, 10.0)
            .expect_err("refused")
    };
    let four = of_segments(&[(Plus, Max, 0.1), (Minus, Max, 0.1), (Minus, Min, 0.1), (Plus, Max, 0.1)]);
    assert_eq!(refused(&four), CorrectionError::TooFew { parameters: 4 });
    let same = of_segments(&[(Plus, Max, 0.015); 6]);
    assert!(matches!(refused(&same), CorrectionError::Rank { parameters: 6, rank } if rank < 5));
    let error = refused(&four).to_string();
    assert!(error.contains("4 numbers") && error.contains("learn one with more"), "{error}");
}

#[test]
fn no_correction_takes_a_segment_or_an_arc_beyond_its_bounds() {
    for (dx, dz) in MANEUVERS {
        let table = table(dx, dz);
        let parameters = Parameters::of(&table);
        let jacobian = Response::IDEAL.linearised(&table, &parameters).1;
        for i in 0..5 {
            for size in [-5.0, -0.5, 0.5, 5.0] {
                let mut error = [0.0; 5];
                error[i] = size;
                let Ok(found) = correct(&jacobian, &StateError::from_array(error), &parameters, 10.0) else {
                    continue;
                };
                let moved = parameters.moved(&found.change);
                assert!(moved.durations_s.iter().all(|d| *d > 1.2e-3), "({dx}, {dz}): {moved:?}");
                // An arc that is flown through its peak stays slower than the limit there.
                let slow = |width: f64| 1.0 / width.abs() <= 10.0;
                let was = parameters.arc.is_none_or(|(width, _)| slow(width));
                assert!(!was || moved.arc.is_none_or(|(width, _)| slow(width)), "({dx}, {dz}): {moved:?}");
            }
        }
    }
}

/// A vehicle in two lines: its flights end where a model says, or do not take place.
struct Scripted<F>(F);

impl<F: FnMut(&ManeuverTable, u32) -> Result<StateError, FlightFailure>> Flyer for Scripted<F> {
    fn fly(&mut self, table: &ManeuverTable, number: u32) -> Result<Flown, FlightFailure> {
        (self.0)(table, number).map(|final_error| Flown {
            observed: Observed {
                start_error: StateError::default(),
                final_error,
                across: Across::default(),
                across_from_start_m: 0.0,
                began_s: 0.0,
                timing_residual_rad: 0.0,
            },
            true_final_error: None,
            true_across: None,
            outcome: "completed",
        })
    }
}

#[derive(Default)]
struct Watching(Vec<(usize, Option<usize>)>);

impl Observer for Watching {
    fn flown(&mut self, history: &History, _: &ManeuverTable) {
        self.0.push((history.flights.len() + history.repeats.len(), history.best));
    }
}

fn campaign(
    fly: impl FnMut(&ManeuverTable, u32) -> Result<StateError, FlightFailure>,
) -> (mintime::learning::Learned, Watching) {
    let plan = plan(&to(5.0, 5.0), &VehicleConfig::REFERENCE, &AS_FILE).expect("a plan");
    let mut watching = Watching::default();
    let budget = Budget { flights: 10, repeats: 3 };
    let history = History::of("5,5", "scripted", None);
    (learn(&plan, history, budget, &mut Scripted(fly), &mut watching), watching)
}

fn end_on(response: &Response, table: &ManeuverTable) -> StateError {
    let end = response.end(table, &Parameters::of(table));
    StateError::from_array(end.minus(table.end.cast()).to_array())
}

#[test]
fn a_vehicle_that_differs_from_the_model_is_learned() {
    let (learned, watching) = campaign(|table, _| Ok(end_on(&SLUGGISH, table)));
    assert_eq!(learned.stop, StopReason::Converged, "{:?}", learned.history);
    assert!(learned.history.converged && learned.history.flights.len() <= 8);
    assert_eq!(learned.history.repeats.len(), 3);
    assert!(learned.history.repeats.iter().all(|r| r.final_error.is_some_and(|e| e.in_tolerances() < 0.6)));
    assert_eq!(learned.table.kind, Kind::Learned);
    assert!((f64::from(learned.table.duration_s()) - learned.history.learned_duration_s).abs() < 1e-6);
    // Told after each flight, and once when learning ended.
    assert_eq!(watching.0.len(), learned.history.flights.len() + 1 + 3);
}

#[test]
fn a_vehicle_that_does_not_answer_corrections_is_given_up_with_its_best_table() {
    let mut count = 0;
    let (learned, _) = campaign(|_, _| {
        count += 1;
        // The second flight happens to be the best.
        Ok(StateError { x_m: if count == 2 { 0.4 } else { 0.5 }, ..StateError::default() })
    });
    assert!(matches!(learned.stop, StopReason::NotConverging { .. }), "{:?}", learned.stop);
    assert!(!learned.history.converged && learned.history.best == Some(1));
    let reason = learned.history.reason.expect("a reason");
    assert!(reason.contains("does not converge") && reason.contains("8.0 tolerances"), "{reason}");
    assert!(learned.history.flights.len() < 10);
}

#[test]
fn flights_that_break_off_twice_in_a_row_end_it_and_a_lost_vehicle_flies_no_repeats() {
    let broken = || FlightFailure::Broken { outcome: "aborted", reason: "it left its envelope".to_owned() };
    let (learned, _) = campaign(|_, _| Err(broken()));
    assert_eq!(learned.stop, StopReason::Broken("it left its envelope".to_owned()));
    assert_eq!((learned.history.flights.len(), learned.history.repeats.len()), (2, 0));
    // One alone is flown over.
    let (learned, _) =
        campaign(|table, number| if number == 2 { Err(broken()) } else { Ok(end_on(&SLUGGISH, table)) });
    assert_eq!(learned.stop, StopReason::Converged);
    assert_eq!(learned.history.flights[1].outcome, "aborted");
    let (learned, _) = campaign(|table, number| match number {
        1 | 2 => Ok(end_on(&SLUGGISH, table)),
        _ => Err(FlightFailure::Lost { reason: "the battery came off".to_owned() }),
    });
    assert_eq!(learned.stop, StopReason::Lost("the battery came off".to_owned()));
    assert!(learned.history.repeats.is_empty() && learned.history.best.is_some());
}

#[test]
fn a_vehicle_without_thrust_is_refused_before_it_flies() {
    let weak = IdentifiedResponse { thrust_scale: 0.25, ..AS_FILE };
    let error = plan(&to(5.0, 5.0), &VehicleConfig::REFERENCE, &weak).expect_err("refused");
    assert!(matches!(error, PlanError::Weak { .. }), "{error}");
    assert!(error.to_string().contains("cannot fly the maneuver"), "{error}");
}

#[test]
fn commands_make_up_for_the_thrust_and_stay_below_the_vehicle_s_share() {
    for scale in [0.9, 1.1] {
        let found = IdentifiedResponse { thrust_scale: scale, ..AS_FILE };
        let plan = plan(&to(5.0, 5.0), &VehicleConfig::REFERENCE, &found).expect("a plan");
        assert!((f64::from(plan.table.limits.thrust_max_mps2) * scale - 20.0).abs() < 1e-4);
        assert!((plan.planned_duration_s - plan.optimum_duration_s).abs() < 1e-5);
        assert!(end_on(&plan.response, &plan.table).in_tolerances() < 0.02);
    }
    // A vehicle that cannot give 20 m/s² is planned with what it has.
    let file = VehicleConfig { plan_thrust_max_mps2: 18.0, ..VehicleConfig::REFERENCE };
    let plan = plan(&to(5.0, 5.0), &file, &AS_FILE).expect("a plan");
    assert!(plan.table.limits.thrust_max_mps2 <= 18.0 && plan.planned_duration_s > plan.optimum_duration_s);
}

#[test]
fn motion_capture_and_gyro_see_the_end_as_it_was() {
    let vehicle = SimulatedVehicle {
        choice: VehicleChoice::Hosted,
        plant: airframe(0.95),
        seed: 4,
        room: None,
        response: Response::identified(&AS_FILE),
        heading_rad: 0.0,
    };
    for (dx, dz) in MANEUVERS {
        let plan = plan(&to(dx, dz), &VehicleConfig::REFERENCE, &AS_FILE).expect("a plan");
        let mut unseen = Unseen;
        let flown = SimulatedFlyer { vehicle: &vehicle, witness: &mut unseen, last: None }
            .fly(&plan.table, 1)
            .expect("flown to its end");
        let truth = flown.true_final_error.expect("simulated");
        let off = flown.observed.final_error.minus(&truth);
        assert!(off.position_m() < 2e-3, "({dx}, {dz}): {off:?}");
        let across = flown.true_across.expect("simulated");
        assert!(
            (flown.observed.across.y_m - across.y_m).abs() < 2e-3 && across.y_m != 0.0,
            "({dx}, {dz}): {flown:?}"
        );
        assert!(off.velocity_mps() < 0.05, "({dx}, {dz}): {off:?}");
        assert!(off.theta_rad.abs() < 5e-3, "({dx}, {dz}): {off:?}");
        assert!(flown.observed.start_error.theta_rad.abs() < 3e-3, "{flown:?}");
    }
}

/// A vehicle that answers as the model does and whose nose is not where its gyro has it.
struct Askew {
    response: Response,
    by_rad: f64,
}

impl Flyer for Askew {
    fn fly(&mut self, table: &ManeuverTable, _: u32) -> Result<Flown, FlightFailure> {
        let off_rad = f64::from(table.heading_rad) - 0.3 + self.by_rad;
        let along_m = f64::from(table.end.x - table.start.x);
        Ok(Flown {
            observed: Observed {
                start_error: StateError::default(),
                final_error: end_on(&self.response, table),
                // 2 cm of it are the start's.
                across: Across { y_m: along_m * off_rad + 0.02, vy_mps: 0.0 },
                across_from_start_m: 0.02,
                began_s: 0.0,
                timing_residual_rad: 0.0,
            },
            true_final_error: None,
            true_across: None,
            outcome: "completed",
        })
    }
}

#[test]
fn the_heading_makes_up_for_an_askew_gyro_where_the_way_is_long_enough() {
    let learned = |dx: f64, dz: f64, by_rad: f64| {
        let target = Target::Solve {
            to: State::at_rest(dx, dz),
            limits: Limits::TABLE_I,
            turns: Turns::Any,
            heading_rad: 0.3,
        };
        let plan = plan(&target, &VehicleConfig::REFERENCE, &AS_FILE).expect("a plan");
        let mut vehicle = Askew { response: plan.response, by_rad };
        let history = History::of("askew", "scripted", None);
        learn(&plan, history, Budget { flights: 10, repeats: 1 }, &mut vehicle, &mut Watching::default())
    };
    for (dx, dz) in [(5.0, 5.0), (15.0, 0.0), (-3.0, 0.0)] {
        let Learned { history, table, stop } = learned(dx, dz, 0.04);
        assert_eq!(stop, StopReason::Converged, "({dx}, {dz})");
        assert_eq!(history.heading_rad, 0.3);
        assert!((f64::from(table.heading_rad) - 0.26).abs() < 0.005, "({dx}, {dz}): {}", table.heading_rad);
        let repeat = history.repeats[0].systematic_across_m.expect("seen");
        assert!(repeat.abs() < 0.03, "({dx}, {dz}): {repeat}");
    }
    // A way straight up is turned by nothing, and does not wait for it.
    let Learned { table, stop, .. } = learned(0.0, 4.0, 0.04);
    assert_eq!((stop, table.heading_rad), (StopReason::Converged, 0.3));
    // So far askew no gyro sits.
    let Learned { table, stop, .. } = learned(5.0, 5.0, 0.2);
    assert!(matches!(stop, StopReason::NotConverging { .. }), "{stop:?}");
    assert!((f64::from(table.heading_rad) - 0.3).abs() < 0.1 + 1e-6);
}

/// Their arc is at its rate limit after the rehearsal already: it is held there.
#[test]
fn verticals_without_a_turn_are_learned() {
    for (dz, seed) in [(2.0, 1), (-2.0, 2), (1.5, 1)] {
        let mut vehicle = SimulatedVehicle {
            choice: VehicleChoice::Hosted,
            plant: airframe(1.0),
            seed,
            room: None,
            response: Response::IDEAL,
            heading_rad: 0.0,
        };
        let found = vehicle.identify(&mut Unseen).expect("enough data");
        let plan = plan(&to(0.0, dz), &VehicleConfig::REFERENCE, &found).expect("a plan");
        vehicle.response = plan.response;
        let mut unseen = Unseen;
        let mut flyer = SimulatedFlyer { vehicle: &vehicle, witness: &mut unseen, last: None };
        let history = History::of("vertical", "hosted", Some(seed));
        let budget = Budget { flights: 12, repeats: 2 };
        let Learned { history, stop, .. } =
            learn(&plan, history, budget, &mut flyer, &mut Watching::default());
        assert_eq!(stop, StopReason::Converged, "{dz}");
        assert!(history.learned_duration_s <= 1.2 * history.optimum_duration_s, "{dz}: {history:?}");
        for repeat in &history.repeats {
            let truth = repeat.true_final_error.expect("flown to its end");
            assert!(truth.in_tolerances() <= 1.0, "{dz}: {truth:?}");
        }
    }
}

#[test]
fn two_vehicles_learn_the_four_maneuvers() {
    let plan = StatisticsPlan {
        choice: VehicleChoice::Hosted,
        vehicles: 2,
        budget: Budget { flights: 10, repeats: 5 },
        scatter: 0,
        gradient_flights: 0,
        threads: 2,
    };
    let cases = statistics(&plan, |_| {});
    assert_eq!(cases.len(), 8);
    for case in &cases {
        let text = format!("{} {}: {} {:?}", case.maneuver, case.seed, case.reason, case.mean);
        assert!(case.success, "{text}");
        assert!(case.duration_ratio().is_some_and(|ratio| ratio < 1.1), "{text}");
    }
    // The same again is the same again.
    let again = statistics(&StatisticsPlan { threads: 1, ..plan }, |_| {});
    assert_eq!(
        cases.iter().map(|c| c.mean).collect::<Vec<_>>(),
        again.iter().map(|c| c.mean).collect::<Vec<_>>()
    );
    assert!(matches!(target((1.0, 2.0, "")), Target::Solve { .. }));
}

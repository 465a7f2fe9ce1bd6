//! The score T / T*: of fastest maneuvers, of delayed ones, and of the linear controller, each against an oracle.

use std::f64::consts::PI;

use mintime::benchmark::{
    Arrival, BenchmarkError, Flight, Gains, Goal, Remark, Rules, Sample, Score, Tolerance, as_flight, fly,
    fly_linear, score, score_linear,
};
use mintime::solver::{Extremal, Request, solve};
use mintime_shared::model::{Limits, State};

fn fastest(from: State<f64>, to: State<f64>) -> Extremal {
    solve(&Request { from, to, ..Request::rest_to_rest(0.0, 0.0) }).expect("a maneuver").extremal
}

/// The maneuver as samples at a rate, after `before_s` at its start and before `after_s` at its end.
fn sampled(extremal: &Extremal, hz: f64, before_s: f64, after_s: f64) -> Vec<(f64, State<f64>)> {
    let duration_s = extremal.duration_s();
    let count = ((before_s + duration_s + after_s) * hz).ceil() as u32;
    (0..=count)
        .map(|i| {
            let t_s = f64::from(i) / hz;
            (t_s, extremal.state_at((t_s - before_s).clamp(0.0, duration_s)))
        })
        .collect()
}

fn goals(from: State<f64>, to: State<f64>) -> Option<(Goal, Goal)> {
    Some((Goal::planar(from), Goal::planar(to)))
}

fn measured(flown: &[(f64, State<f64>)], from: State<f64>, to: State<f64>, rules: &Rules) -> Score {
    score(&as_flight(flown).expect("a flight"), goals(from, to), rules).expect("a score")
}

/// By Bellman's principle the piece between the two tolerances is the fastest between its own ends.
#[test]
fn a_fastest_maneuver_scores_one() {
    let moving = (State::from_array([0.0, 3.0, 0.0, -1.0, 0.5]), State::at_rest(4.0, 1.0));
    let onwards = (State::origin(), State::from_array([4.0, 3.0, 2.0, 1.0, -0.4]));
    let rest = [(5.0, 5.0), (3.0, 0.0), (0.0, 4.0), (-3.0, 4.0), (1.0, -2.0), (12.0, 0.0)]
        .map(|(x, z)| (State::origin(), State::at_rest(x, z)));
    for (from, to) in rest.into_iter().chain([moving, onwards]) {
        let extremal = fastest(from, to);
        let arrival = (to.vx != 0.0).then_some(Arrival::First);
        let after_s = if to.vx == 0.0 { 1.0 } else { 0.0 };
        for (hz, bound) in [(800.0, 1e-4), (200.0, 1e-3)] {
            let flown = sampled(&extremal, hz, 0.0, after_s);
            let result = measured(&flown, from, to, &Rules { arrival, ..Rules::default() });
            assert!((result.score - 1.0).abs() < bound, "{to:?} at {hz} Hz: {}", result.score);
            assert!(result.optimal.certificate.verified);
            assert!(result.duration_s <= extremal.duration_s() + 2.0 / hz, "{to:?}");
            assert_eq!(result.remarks, [], "{to:?}");
            // The tolerances cut a little off at both ends, so that T is below T* of the nominal states.
            let nominal = result.nominal_duration_s.expect("a maneuver");
            assert!((nominal - extremal.duration_s()).abs() < 1e-9);
            assert!(result.nominal_score.is_some_and(|s| s < 1.0 + bound && s > 0.8), "{to:?}");
        }
    }
}

/// Two fastest maneuvers with a rest between them take as long as both and the rest; where it stood before it left does
/// not count.
#[test]
fn a_rest_on_the_way_counts_and_one_before_it_does_not() {
    let (middle, end) = (State::at_rest(3.0, 2.0), State::at_rest(5.0, -1.0));
    let first = fastest(State::origin(), middle);
    let second = fastest(middle, end);
    let tolerance = Tolerance { position_m: 1e-4, velocity_mps: 1e-3, angle_rad: 1e-3 };
    let rules = Rules { tolerance, ..Rules::default() };
    for (before_s, rest_s) in [(0.0, 0.0), (0.7, 0.0), (0.0, 0.25), (1.0, 1.5)] {
        let mut flown = sampled(&first, 1000.0, before_s, rest_s);
        let begin_s = before_s + first.duration_s() + rest_s;
        flown.retain(|(t_s, _)| *t_s < begin_s);
        flown.extend(sampled(&second, 1000.0, 0.0, 1.0).into_iter().map(|(t_s, s)| (begin_s + t_s, s)));
        let result = measured(&flown, State::origin(), end, &rules);
        let expected_s = first.duration_s() + rest_s + second.duration_s();
        // Within the tolerances the vehicle turns for 0.1 ms at each end.
        assert!((result.duration_s - expected_s).abs() < 2.1e-4, "{} {expected_s}", result.duration_s);
        let whole_s = fastest(State::origin(), end).duration_s();
        let bound = 2.1e-4 * (1.0 + expected_s / whole_s) / whole_s;
        assert!((result.score - expected_s / whole_s).abs() < bound, "{before_s} {rest_s}: {}", result.score);
    }
}

#[test]
fn settling_counts_what_the_first_passage_does_not() {
    let (end, beyond) = (State::at_rest(3.0, 0.0), State::at_rest(3.5, 0.0));
    let (out, back) = (fastest(State::origin(), beyond), fastest(beyond, end));
    let mut flown = sampled(&out, 1000.0, 0.0, 0.0);
    flown.retain(|(t_s, _)| *t_s < out.duration_s());
    let begin_s = out.duration_s();
    flown.extend(sampled(&back, 1000.0, 0.0, 1.0).into_iter().map(|(t_s, s)| (begin_s + t_s, s)));
    let settled = measured(&flown, State::origin(), end, &Rules::default());
    assert!(
        (settled.duration_s - out.duration_s() - back.duration_s()).abs() < 0.1,
        "{}",
        settled.duration_s
    );
    // It passes the end too fast and too low to count as being there: wide tolerances let it.
    let tolerance = Tolerance { position_m: 0.4, velocity_mps: 50.0, angle_rad: 4.0 };
    let rules = Rules { tolerance, arrival: Some(Arrival::First), ..Rules::default() };
    let passed = measured(&flown, State::origin(), end, &rules);
    assert!(passed.duration_s < out.duration_s() && passed.duration_s < settled.duration_s);
    assert!((passed.score - 1.0).abs() < 1e-3, "a piece of a fastest maneuver: {}", passed.score);
}

/// The same flight in a plane of any heading, anywhere, is the same flight.
#[test]
fn the_plane_is_found_wherever_it_stands() {
    for (x, z) in [(5.0, 5.0), (-3.0, 1.0), (0.0, 4.0)] {
        let extremal = fastest(State::origin(), State::at_rest(x, z));
        let flown = sampled(&extremal, 400.0, 0.1, 1.0);
        let mut scores = Vec::new();
        for heading_rad in [0.0, 0.4, PI / 2.0, 2.0, PI, -2.5, -0.1] {
            let place = [3.0, -7.0, 1.5];
            let samples: Vec<Sample> = flown
                .iter()
                .map(|(t_s, state)| {
                    let mut sample = Sample::planar(*t_s, *state, heading_rad);
                    sample.position_m += nalgebra::Vector3::from(place);
                    sample
                })
                .collect();
            let last = samples.last().expect("samples").position_m;
            let ends = Some((Goal::hover(place), Goal::hover(last.into())));
            let flight = Flight::new(samples).expect("a flight");
            let result = score(&flight, ends, &Rules::default()).expect("a score");
            assert!(result.out_of_plane_m < 1e-9, "{heading_rad}: {}", result.out_of_plane_m);
            let turned = (result.heading_rad - heading_rad) / PI;
            assert!((turned - turned.round()).abs() < 1e-9, "{heading_rad}: {}", result.heading_rad);
            scores.push(result.score);
        }
        assert!(scores.iter().all(|s| (s - scores[0]).abs() < 1e-7), "{x},{z}: {scores:?}");
    }
}

#[test]
fn a_flight_out_of_its_plane_is_refused() {
    let extremal = fastest(State::origin(), State::at_rest(5.0, 0.0));
    let samples = sampled(&extremal, 400.0, 0.0, 1.0).into_iter().map(|(t_s, state)| {
        let mut sample = Sample::planar(t_s, state, 0.0);
        sample.position_m.y = 0.4 * (PI * state.x / 5.0).sin();
        sample.velocity_mps.y = 0.4 * PI / 5.0 * (PI * state.x / 5.0).cos() * state.vx;
        sample
    });
    let flight = Flight::new(samples.collect()).expect("a flight");
    let ends = goals(State::origin(), State::at_rest(5.0, 0.0));
    // It leaves and arrives too fast sideways for the usual tolerance.
    let tolerance = Tolerance { velocity_mps: 0.5, ..Tolerance::default() };
    let rules = Rules { tolerance, ..Rules::default() };
    let refused = score(&flight, ends, &rules);
    assert!(
        matches!(refused, Err(BenchmarkError::OutOfPlane { out_m, .. }) if (out_m - 0.4).abs() < 1e-3),
        "{refused:?}"
    );
    assert!(score(&flight, ends, &Rules { out_of_plane_m: 0.41, ..rules }).is_ok());
}

/// The simulator of the linear controller, steered by the fastest maneuver's own inputs, scores 1.
#[test]
fn the_fastest_controller_scores_one_in_the_simulator() {
    for (x, z) in [(5.0, 5.0), (3.0, 0.0), (0.0, 4.0), (8.0, -4.0)] {
        let extremal = fastest(State::origin(), State::at_rest(x, z));
        let duration_s = extremal.duration_s();
        let step_s = 2e-4;
        let hover = Limits::TABLE_I.gravity_mps2;
        let flown = fly(
            &Limits::TABLE_I,
            State::origin(),
            step_s,
            |t_s, _| {
                let middle = t_s + 0.5 * step_s;
                if middle < duration_s {
                    (extremal.rate_at(middle), extremal.thrust_at(middle))
                } else {
                    (0.0, hover)
                }
            },
            |t_s, _| t_s > duration_s + 1.0,
        );
        let end = State { theta: 0.0, ..State::at_rest(x, z) };
        let result = measured(&flown, State::origin(), end, &Rules::default());
        // A switch within a step is a step late at most.
        assert!((result.score - 1.0).abs() < 1e-3, "{x},{z}: {}", result.score);
    }
}

/// Straight up and slightly: a spring and a damper, whose motion every textbook gives. One step of delay is all that is
/// left between the two.
#[test]
fn the_vertical_loop_is_the_textbook_second_order_system() {
    let rules = Rules::default();
    for damping in [0.5, 0.8, 1.0] {
        let gains = Gains { vertical_damping: damping, vertical_radps: 4.0, ..Gains::default() };
        let height = 0.2;
        let flight = fly_linear(&gains, &rules, 0.0, height).expect("it arrives");
        let w = gains.vertical_radps;
        for sample in flight.samples() {
            let t = sample.t_s;
            let decay = (-damping * w * t).exp();
            let left = if damping < 1.0 {
                let wd = w * (1.0 - damping * damping).sqrt();
                decay * ((wd * t).cos() + damping * w / wd * (wd * t).sin())
            } else {
                decay * (1.0 + w * t)
            };
            let expected = height * (1.0 - left);
            assert!((sample.position_m.z - expected).abs() < 2e-3 * height, "{damping}, {t}: {expected}");
            assert!(sample.position_m.x.abs() < 1e-12 && sample.thrust_axis.x.abs() < 1e-12);
        }
    }
}

/// Sideways and slightly: a linear system of third order, ẍ = g θ, θ̇ = k (a/g − θ), a = ω²(x_T − x) − 2ζω ẋ; its motion by the
/// exponential of its matrix.
#[test]
fn the_horizontal_loop_is_linear_in_small_motions() {
    let gains =
        Gains { horizontal_radps: 3.0, horizontal_damping: 0.9, pitch_per_s: 15.0, ..Gains::default() };
    let tolerance = Tolerance { position_m: 1e-4, velocity_mps: 1e-3, angle_rad: 1e-3 };
    let rules = Rules { tolerance, ..Rules::default() };
    let (w, d, k, g) = (3.0, 0.9, 15.0, 9.81);
    let motion = nalgebra::Matrix3::new(0.0, 1.0, 0.0, 0.0, 0.0, g, -k * w * w / g, -2.0 * k * d * w / g, -k);
    let distance = 0.02;
    let flight = fly_linear(&gains, &rules, distance, 0.0).expect("it arrives");
    for sample in flight.samples().iter().step_by(10) {
        // From the deviation at the start; the end is the origin of the linear system.
        let left = (motion * sample.t_s).exp() * nalgebra::Vector3::new(-distance, 0.0, 0.0);
        let off = sample.position_m.x - distance - left.x;
        assert!(off.abs() < 5e-3 * distance, "{}: {} {}", sample.t_s, sample.position_m.x, distance + left.x);
    }
}

#[test]
fn the_linear_controller_is_slower_everywhere_and_symmetric() {
    let gains = Gains::default();
    let rules = Rules::default();
    for (x, z) in [(5.0, 5.0), (5.0, 0.0), (0.0, 3.0), (2.0, -3.0), (12.0, 1.0)] {
        let right = score_linear(&gains, &rules, x, z).expect("a score");
        assert!(right.score > 1.2, "{x},{z}: {}", right.score);
        assert_eq!(right.remarks, []);
        let left = score_linear(&gains, &rules, -x, z).expect("a score");
        assert!((left.score - right.score).abs() < 1e-6, "{x},{z}: {} {}", left.score, right.score);
    }
}

#[test]
fn gains_and_rules_that_make_no_sense_are_refused() {
    let rules = Rules::default();
    for gains in [
        Gains { horizontal_radps: 0.0, ..Gains::default() },
        Gains { vertical_damping: f64::NAN, ..Gains::default() },
        Gains { pitch_max_rad: 1.6, ..Gains::default() },
    ] {
        assert!(score_linear(&gains, &rules, 1.0, 1.0).is_err(), "{gains:?}");
    }
    let unstable = Gains { horizontal_radps: 40.0, pitch_per_s: 1.0, ..Gains::default() };
    let refused = score_linear(&unstable, &rules, 5.0, 0.0);
    assert!(matches!(refused, Err(BenchmarkError::NeverArrives { .. })), "{refused:?}");
    let bad = Rules { dwell_s: -1.0, ..rules };
    assert!(matches!(score_linear(&Gains::default(), &bad, 1.0, 1.0), Err(BenchmarkError::NotPositive(_))));
    let near = score_linear(&Gains::default(), &rules, 0.05, 0.0);
    assert!(matches!(near, Err(BenchmarkError::SameStates)), "{near:?}");
}

#[test]
fn a_flight_beyond_the_limits_is_told() {
    let strong = Limits { thrust_max_mps2: 25.0, ..Limits::TABLE_I };
    let request = Request { limits: strong, ..Request::rest_to_rest(5.0, 0.0) };
    let extremal = solve(&request).expect("a maneuver").extremal;
    let flown = sampled(&extremal, 400.0, 0.0, 1.0);
    let result = measured(&flown, State::origin(), State::at_rest(5.0, 0.0), &Rules::default());
    assert!(result.score < 0.95 && result.remarks == [Remark::FasterThanOptimal], "{:?}", result.remarks);
}

/// T of the reference maneuver of the default gains, 5 m ahead and 5 m up; infinite where it overshoots by more than the
/// tolerance.
fn reference_s(gains: &Gains) -> f64 {
    let rules = Rules::default();
    let most = 5.0 + rules.tolerance.position_m;
    match fly_linear(gains, &rules, 5.0, 5.0) {
        Ok(flight) if flight.samples().iter().all(|s| s.position_m.x <= most && s.position_m.z <= most) => {
            let ends = goals(State::origin(), State::at_rest(5.0, 5.0));
            score(&flight, ends, &rules).expect("a score").duration_s
        }
        _ => f64::INFINITY,
    }
}

/// The default gains are tuned: none of them, and no two of them together, can be moved by 2, 5 or 10 % to be faster by
/// more than 1 %.
#[test]
fn the_default_gains_are_a_minimum_of_the_reference_maneuver() {
    let tuned = Gains::default();
    let best_s = reference_s(&tuned);
    assert!((best_s - 1.74).abs() < 0.01, "{best_s}");
    let change = |gains: &mut Gains, which: usize, factor: f64| {
        let gain = match which {
            0 => &mut gains.horizontal_radps,
            1 => &mut gains.horizontal_damping,
            2 => &mut gains.vertical_radps,
            3 => &mut gains.vertical_damping,
            4 => &mut gains.pitch_per_s,
            _ => &mut gains.pitch_max_rad,
        };
        *gain *= factor;
    };
    let factors = [0.9, 0.95, 0.98, 1.02, 1.05, 1.1];
    for (a, b) in (0..6).flat_map(|a| (a..6).map(move |b| (a, b))) {
        for (fa, fb) in factors.iter().flat_map(|fa| factors.map(|fb| (*fa, fb))) {
            let mut gains = tuned;
            change(&mut gains, a, fa);
            if a != b {
                change(&mut gains, b, fb);
            }
            if gains.pitch_max_rad < 1.55 {
                let t = reference_s(&gains);
                assert!(t > 0.99 * best_s, "{t} with {gains:?}");
            }
        }
    }
}

//! What must hold for every request: symmetries of the problem, and T growing along sweeps.

mod requests;

use mintime::solver::{Request, SolveError, Turns, solve, solve_all_windings};
use mintime_shared::model::{Limits, State};
use requests::{Class, requests};

/// Relative agreement of two durations that must be equal.
const EQUAL: f64 = 1e-9;

fn duration(request: &Request) -> f64 {
    solve(request).unwrap_or_else(|e| panic!("{request:?}: {e}")).extremal.duration_s()
}

fn assert_equal(request: &Request, a: f64, b: f64) {
    assert!((a - b).abs() <= EQUAL * a.max(b), "{request:?}: {a} against {b}");
}

/// Every n-th request of some classes.
fn sample(classes: &[Class], step: usize) -> Vec<Request> {
    requests().into_iter().filter(|(c, _)| classes.contains(c)).map(|(_, r)| r).step_by(step).collect()
}

fn mirrored(s: State<f64>) -> State<f64> {
    State { x: -s.x, vx: -s.vx, theta: -s.theta, ..s }
}

fn backwards(s: State<f64>) -> State<f64> {
    State { vx: -s.vx, vz: -s.vz, ..s }
}

#[test]
fn a_mirrored_request_takes_as_long() {
    for request in sample(&[Class::RestToRest, Class::Moving, Class::Limits, Class::UpsideDown], 5) {
        let image = Request { from: mirrored(request.from), to: mirrored(request.to), ..request };
        assert_equal(&request, duration(&request), duration(&image));
    }
}

#[test]
fn a_request_run_backwards_takes_as_long_for_each_winding() {
    for request in sample(&[Class::RestToRest, Class::Limits], 25) {
        for k in [-1, 0, 1] {
            let forth = Request { turns: Turns::Exactly(k), ..request };
            // The winding belongs to the end; run backwards it is the start that carries it.
            let back = Request {
                from: backwards(request.to),
                to: backwards(request.from),
                turns: Turns::Exactly(-k),
                ..request
            };
            assert_equal(&forth, duration(&forth), duration(&back));
        }
    }
}

#[test]
fn a_request_run_backwards_takes_as_long() {
    for request in sample(&[Class::Moving, Class::Limits, Class::UpsideDown], 4) {
        let back = Request { from: backwards(request.to), to: backwards(request.from), ..request };
        assert_equal(&request, duration(&request), duration(&back));
    }
}

#[test]
fn no_winding_asked_for_is_faster_than_the_fastest() {
    for request in sample(&[Class::RestToRest, Class::Moving, Class::Limits, Class::UpsideDown], 11) {
        let any = duration(&request);
        let nearest = request.nearest_turns();
        for k in nearest - 2..=nearest + 2 {
            match solve(&Request { turns: Turns::Exactly(k), ..request }) {
                Ok(fixed) => assert!(fixed.extremal.duration_s() >= any * (1.0 - EQUAL), "{request:?} {k}"),
                Err(error) => {
                    assert!(matches!(error, SolveError::NotVerified { .. }), "{request:?} {k}: {error}");
                }
            }
        }
    }
}

/// Two that were once missed by a wide margin: the maneuver is so short that the turning rules it.
#[test]
fn short_maneuvers_take_the_winding_that_is_fastest() {
    let up_side_down = Request {
        from: State { vx: -1.0, ..State::origin() },
        to: State { vz: -1.0, theta: core::f64::consts::PI, ..State::origin() },
        ..Request::rest_to_rest(0.0, 0.0)
    };
    assert!((duration(&up_side_down) - 0.6359).abs() < 1e-4);
    let slow_to_turn = Request {
        from: State::from_array([0.0, 2.7717484777479555, 0.0, 5.184734124072264, -0.04319691594559094]),
        to: State::from_array([
            3.079021327672999,
            2.3097764519446002,
            0.8400517150792179,
            -2.5929989387902914,
            -1.1836090705894722,
        ]),
        limits: Limits {
            thrust_min_mps2: 3.419124447461917,
            thrust_max_mps2: 14.994859480727223,
            rate_max_radps: 3.7939045351738345,
            ..Limits::TABLE_I
        },
        turns: Turns::Any,
    };
    assert!((duration(&slow_to_turn) - 1.4861).abs() < 1e-4);
}

#[test]
fn all_windings_are_those_that_are_solved_one_by_one() {
    for request in sample(&[Class::RestToRest, Class::Moving, Class::Limits, Class::UpsideDown], 60) {
        let all = solve_all_windings(&request).unwrap_or_else(|e| panic!("{request:?}: {e}"));
        assert!(all.unsolved.is_empty(), "{request:?}: {:?}", all.unsolved);
        for other in &all.alternatives {
            assert!(other.duration_s >= all.extremal.duration_s() * (1.0 - EQUAL), "{request:?}");
            if let Ok(fixed) = solve(&Request { turns: Turns::Exactly(other.turns), ..request }) {
                assert!(
                    other.duration_s <= fixed.extremal.duration_s() * (1.0 + EQUAL),
                    "{request:?} {other:?}"
                );
            }
        }
    }
}

/// Whole turns of the start's angle and a displaced origin change the winding's number and nothing else.
#[test]
fn only_differences_of_angles_and_positions_count() {
    let moved = |s: State<f64>, turns: f64| State {
        x: s.x + 1e7,
        z: s.z - 1e7,
        theta: s.theta + turns * core::f64::consts::TAU,
        ..s
    };
    let here =
        Request { from: State { vx: 1.0, theta: 0.5, ..State::origin() }, ..Request::rest_to_rest(4.0, 2.0) };
    let near = solve_all_windings(&here).expect("solved");
    for (start, end) in [(1, 0), (0, -3), (16, 0), (-100, 250)] {
        let request =
            Request { from: moved(here.from, f64::from(start)), to: moved(here.to, f64::from(end)), ..here };
        let far = solve_all_windings(&request).expect("solved");
        assert_equal(&request, near.extremal.duration_s(), far.extremal.duration_s());
        assert_eq!(far.extremal.turns, near.extremal.turns + start - end);
        assert_eq!(far.alternatives.len(), near.alternatives.len());
        for (a, b) in near.alternatives.iter().zip(&far.alternatives) {
            assert!((a.duration_s - b.duration_s).abs() < EQUAL, "{a:?} {b:?}");
            let again = solve(&Request { turns: Turns::Exactly(b.turns), ..request }).expect("solved");
            assert_equal(&request, b.duration_s, again.extremal.duration_s());
        }
    }
}

#[test]
fn eight_turns_either_way_are_found() {
    for (x, z) in [(0.0, 0.0), (2.0, 1.0)] {
        for k in [-8, -7, -5, 5, 7, 8] {
            let request = Request { turns: Turns::Exactly(k), ..Request::rest_to_rest(x, z) };
            let back = Request { turns: Turns::Exactly(-k), ..Request::rest_to_rest(-x, z) };
            assert_equal(&request, duration(&request), duration(&back));
        }
    }
}

#[test]
fn at_rest_both_signs_of_both_displacements_take_as_long() {
    for request in sample(&[Class::RestToRest], 20) {
        let (x, z) = (request.to.x, request.to.z);
        for k in [-1, 0, 1] {
            let with =
                |x, z, k| duration(&Request { turns: Turns::Exactly(k), ..Request::rest_to_rest(x, z) });
            let t = with(x, z, k);
            assert_equal(&request, t, with(x, -z, k));
            assert_equal(&request, t, with(-x, z, -k));
        }
    }
}

#[test]
fn time_and_length_scale_by_equation_3() {
    for request in sample(&[Class::RestToRest, Class::Moving], 20) {
        for factor in [0.31, 2.7] {
            // The same dimensionless problem at another rate limit: T ω stays, lengths go with 1/ω², speeds with 1/ω.
            let scaled = |s: State<f64>| State {
                x: s.x / (factor * factor),
                vx: s.vx / factor,
                z: s.z / (factor * factor),
                vz: s.vz / factor,
                theta: s.theta,
            };
            let limits = Limits { rate_max_radps: factor * request.limits.rate_max_radps, ..request.limits };
            let other = Request { from: scaled(request.from), to: scaled(request.to), limits, ..request };
            assert_equal(&request, duration(&request), factor * duration(&other));
        }
    }
}

#[test]
fn t_grows_along_the_axes() {
    for axis in [(1.0, 0.0), (0.0, 1.0), (0.0, -1.0)] {
        let mut before = 0.0;
        for i in 1..=150 {
            let d = 0.1 * f64::from(i);
            let t = duration(&Request::rest_to_rest(axis.0 * d, axis.1 * d));
            assert!(t > before, "{axis:?} {d}: {t} after {before}");
            before = t;
        }
    }
}

#[test]
fn better_limits_are_never_slower() {
    for request in sample(&[Class::RestToRest, Class::Moving], 25) {
        let t = duration(&request);
        let l = request.limits;
        for limits in [
            Limits { thrust_min_mps2: 0.9 * l.thrust_min_mps2, ..l },
            Limits { thrust_max_mps2: 1.05 * l.thrust_max_mps2, ..l },
            Limits { rate_max_radps: 1.05 * l.rate_max_radps, ..l },
        ] {
            let better = duration(&Request { limits, ..request });
            assert!(better <= t * (1.0 + EQUAL), "{request:?} {limits:?}: {better} after {t}");
        }
    }
}

/// Near hover the dynamics are homogeneous for short times: tilt scales with T, the horizontal velocity with T².
#[test]
fn tiny_corrections_take_as_long_as_their_scaling_says() {
    let rest = State { x: 0.0, vx: 0.0, z: 0.0, vz: 0.0, theta: 0.0 };
    let from = |start: State<f64>| Request { from: start, ..Request::rest_to_rest(0.0, 0.0) };
    // T over tilt tends to 2.6633e-1 s/rad at 10 rad/s, T²/v to 0.10865 s²·s/m; corrections are of first order in T.
    let (mut last_tilt, mut last_stop) = (0.0, 0.0);
    for exponent in 2..=6 {
        let small = 10.0_f64.powi(-exponent);
        let tilt = duration(&from(State { theta: small, ..rest })) / small;
        let stop = duration(&from(State { vx: small, ..rest })).powi(2) / small;
        let change = 20.0 * small.sqrt();
        assert!(
            last_tilt == 0.0 || (tilt / last_tilt - 1.0).abs() < change,
            "{small} rad: {tilt} {last_tilt}"
        );
        assert!(
            last_stop == 0.0 || (stop / last_stop - 1.0).abs() < change,
            "{small} m/s: {stop} {last_stop}"
        );
        (last_tilt, last_stop) = (tilt, stop);
    }
    assert!(
        (last_tilt - 0.266_334).abs() < 1e-5 && (last_stop - 0.108_645).abs() < 1e-4,
        "{last_tilt} {last_stop}"
    );
}

/// A vehicle whose least thrust lifts it cannot hover, but it has fastest maneuvers.
#[test]
fn a_vehicle_that_cannot_hover_is_solved_or_refused_with_a_reason() {
    let mut solved = 0;
    for (i, request) in sample(&[Class::RestToRest, Class::Moving], 20).into_iter().enumerate() {
        let thrust_min_mps2 = 9.81 + 0.1 * i as f64;
        let limits = Limits { thrust_min_mps2, ..request.limits };
        match solve(&Request { limits, ..request }) {
            Ok(solution) => {
                assert!(solution.certificate.verified);
                solved += 1;
            }
            Err(SolveError::NotVerified { .. }) => {}
            Err(error) => panic!("{request:?}: {error}"),
        }
    }
    assert!(solved >= 35, "{solved} of 50");
}

//! Derivatives of T against finite differences of T itself, followed along the maneuver's own branch.

use mintime::solver::{Extremal, Request, Turns, solve, solve_from};
use mintime_shared::model::{Limits, State};

fn requests() -> Vec<Request> {
    let table = |from: [f64; 5], to: [f64; 5], limits: Limits<f64>| Request {
        from: State::from_array(from),
        to: State::from_array(to),
        limits,
        turns: Turns::Any,
    };
    let weak = Limits { thrust_min_mps2: 2.0, thrust_max_mps2: 15.0, rate_max_radps: 6.0, ..Limits::TABLE_I };
    vec![
        Request::rest_to_rest(5.0, 5.0),
        Request::rest_to_rest(1.0, -2.0),
        Request::rest_to_rest(0.7, 4.0),
        table([0.0, 3.0, 0.0, -1.0, 0.5], [4.0, 0.0, 1.0, 0.0, 0.0], Limits::TABLE_I),
        table([0.0, -2.0, 0.0, 1.5, -0.8], [3.0, 1.0, -2.0, 2.0, 0.4], weak),
    ]
}

/// T of the neighbour on the same branch after a change of the request.
fn shifted(base: &Extremal, request: &Request, change: impl Fn(&mut Request)) -> f64 {
    let mut request = Request { turns: Turns::Exactly(base.turns), ..*request };
    change(&mut request);
    solve_from(base, &request).expect("a neighbour solves").extremal.duration_s()
}

fn check(name: &str, base: &Extremal, request: &Request, exact: f64, change: impl Fn(&mut Request, f64)) {
    let h = 1e-5;
    let difference =
        (shifted(base, request, |r| change(r, h)) - shifted(base, request, |r| change(r, -h))) / (2.0 * h);
    assert!((exact - difference).abs() < 1e-7 * (1.0 + exact.abs()), "{name}: {exact} against {difference}");
}

#[test]
fn derivatives_of_t_agree_with_finite_differences() {
    for request in requests() {
        let base = solve(&request).expect("solves").extremal;
        let s = base.sensitivities();
        for i in 0..5 {
            check("from", &base, &request, s.from[i], |r, h| {
                let mut a = r.from.to_array();
                a[i] += h;
                r.from = State::from_array(a);
            });
            check("to", &base, &request, s.to[i], |r, h| {
                let mut a = r.to.to_array();
                a[i] += h;
                r.to = State::from_array(a);
            });
        }
        check("F_min", &base, &request, s.thrust_min, |r, h| r.limits.thrust_min_mps2 += h);
        check("F_max", &base, &request, s.thrust_max, |r, h| r.limits.thrust_max_mps2 += h);
        check("ω_max", &base, &request, s.rate_max, |r, h| r.limits.rate_max_radps += h);
        assert!(s.thrust_min >= 0.0 && s.thrust_max <= 0.0 && s.rate_max <= 0.0);
    }
}

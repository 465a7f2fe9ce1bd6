//! The closed-form motion against an integrator that knows nothing of it.

use mintime_shared::minimum_principle::Costate;
use mintime_shared::model::State;
use mintime_shared::motion::{Arc, advance, bang, singular};
use mintime_tests::reference_cases;
use proptest::prelude::*;

/// Classical Runge-Kutta on eq. (4) with a given rate.
fn integrate(
    start: State<f64>,
    thrust: f64,
    gravity: f64,
    rate: impl Fn(f64) -> f64,
    tau: f64,
) -> State<f64> {
    let f = |t: f64, s: [f64; 5]| [s[1], thrust * s[4].sin(), s[3], thrust * s[4].cos() - gravity, rate(t)];
    let steps = 4000;
    let h = tau / f64::from(steps);
    let mut s = start.to_array();
    let along = |s: [f64; 5], k: [f64; 5], h: f64| std::array::from_fn::<f64, 5, _>(|i| s[i] + h * k[i]);
    for i in 0..steps {
        let t = f64::from(i) * h;
        let k1 = f(t, s);
        let k2 = f(t + h / 2.0, along(s, k1, h / 2.0));
        let k3 = f(t + h / 2.0, along(s, k2, h / 2.0));
        let k4 = f(t + h, along(s, k3, h));
        s = std::array::from_fn(|i| s[i] + h / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]));
    }
    State::from_array(s)
}

fn close(a: State<f64>, b: State<f64>, tolerance: f64) -> bool {
    a.minus(b).to_array().iter().all(|d| d.abs() <= tolerance)
}

fn state() -> impl Strategy<Value = State<f64>> {
    prop::array::uniform5(-3.0..3.0).prop_map(State::from_array)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn bang_arcs_match_an_integrator(start in state(), rate in -12.0..12.0, thrust in 0.0..30.0, tau in 1e-6..1.5) {
        for rate in [rate, 0.0, rate * 1e-3, rate * 1e-7] {
            let exact = advance(start, thrust, 9.81, tau, &bang(rate, tau));
            let numeric = integrate(start, thrust, 9.81, |_| rate, tau);
            prop_assert!(close(exact, numeric, 2e-10), "{exact:?} {numeric:?}");
        }
    }

    #[test]
    fn singular_arcs_match_an_integrator(
        start in state(), rate in -8.0..8.0, drift in -8.0..8.0, scale in -6..1_i32, thrust in 0.0..30.0, tau in 1e-6..1.5,
    ) {
        let scale = 10f64.powi(scale);
        let arc = Arc { rate: rate * scale, drift: drift * scale };
        // Keep |u_R| within ten times a usual limit: steeper peaks are no arcs, and the integrator resolves no more.
        prop_assume!(arc.peak_rate(tau) < 50.0);
        let exact = advance(start, thrust, 9.81, tau, &singular(arc, tau));
        let numeric = integrate(start, thrust, 9.81, |t| arc.rate_at(t), tau);
        prop_assert!(close(exact, numeric, 5e-9), "{exact:?} {numeric:?}");
    }

    #[test]
    fn an_arc_can_be_cut_anywhere(start in state(), rate in -5.0..5.0, drift in -5.0..5.0, tau in 1e-3..1.5, cut in 0.0..1.0) {
        let arc = Arc { rate, drift };
        prop_assume!(arc.peak_rate(tau) < 50.0);
        let first = cut * tau;
        let middle = advance(start, 2.0, 1.0, first, &singular(arc, first));
        let rest = tau - first;
        let end = advance(middle, 2.0, 1.0, rest, &singular(arc.advanced(first), rest));
        let whole = advance(start, 2.0, 1.0, tau, &singular(arc, tau));
        prop_assert!(close(end, whole, 1e-10), "{end:?} {whole:?}");
        prop_assert!((arc.advanced(first).rate_at(rest) - arc.rate_at(tau)).abs() <= 1e-9 * (1.0 + arc.rate_at(tau).abs()));
    }
}

#[test]
fn the_singular_rate_is_the_derivative_of_the_singular_angle() {
    let c = Costate { c1: -0.0466, c2: -0.4211, c3: -0.0806, c4: -0.7511 };
    for t in [0.0f64, 1.0, 5.0, 9.0, 14.0] {
        let h = 1e-5;
        let slope = (c.singular_angle(t + h) - c.singular_angle(t - h)) / (2.0 * h);
        assert!((slope - c.singular_rate(t)).abs() < 1e-8, "{t}: {slope} {}", c.singular_rate(t));
        let (here, there) = (c.singular_rate(t), c.arc(2.0).rate_at(t - 2.0));
        assert!((there - here).abs() < 1e-12 * here.abs(), "{t}: {there} {here}");
        // The Kelley branch: the thrust switching function is negative there, and its rate of change is that of p5.
        assert!(c.phi_t(t, c.singular_angle(t)) < 0.0);
        assert!(c.phi_r_rate(t, c.singular_angle(t), 2.0).abs() < 1e-14);
    }
}

/// The reference maneuvers arrive where they say, and H = 0 all along: an oracle that shares no code with this one.
#[test]
fn reference_maneuvers_arrive_and_keep_the_hamiltonian_at_zero() {
    for case in reference_cases() {
        let scale = case.limits.scale();
        let range = case.limits.dimensionless();
        let mut state = scale.to_dimensionless(case.from);
        let mut t = 0.0;
        for segment in &case.segments {
            let tau = segment.duration / scale.time_s;
            let turn = match segment.inputs.rate.sign() {
                Some(sign) => bang(sign, tau),
                None => singular(case.costate.arc(t), tau),
            };
            let u_t = range.thrust(segment.inputs.thrust);
            let h = case.costate.rate_free_hamiltonian(t, &state, u_t);
            assert!(h >= -1e-7, "{}: law (16) at the switch at {t}: {h}", case.name);
            if segment.inputs.rate.sign::<f64>().is_none() {
                assert!(h.abs() < 1e-7, "{}: Φ_R on the arc: {h}", case.name);
            }
            state = advance(state, u_t, 1.0, tau, &turn);
            t += tau;
        }
        let miss = scale.to_si(state).minus(case.to);
        assert!(miss.to_array().iter().all(|d| d.abs() < 1e-7), "{}: {miss:?}", case.name);
    }
}

/// An arc that begins beside the origin of p, where 2 artanh(y) has y round to 1 in `f32`: finite, and what `f64` says.
#[test]
fn an_arc_that_begins_beside_the_origin_is_finite() {
    for drift in [-1.0e3_f32, -1.0e5, -1.0e6, -2.4e7, -1.0e9, -1.0e12] {
        for rate in [0.0_f32, 1.0e-24, -1.0e-9, 1.0] {
            for step in 1..=200 {
                let tau = 0.01 * step as f32;
                let coarse = singular(Arc { rate, drift }, tau);
                let fine = singular(Arc { rate: f64::from(rate), drift: f64::from(drift) }, f64::from(tau));
                for (coarse, fine) in [
                    (coarse.velocity_along, fine.velocity_along),
                    (coarse.velocity_across, fine.velocity_across),
                    (coarse.position_along, fine.position_along),
                    (coarse.position_across, fine.position_across),
                ] {
                    let apart = (f64::from(coarse) - fine).abs();
                    assert!(apart < 1.0e-3 * f64::from(tau), "{rate} {drift} {tau}: {coarse} {fine}");
                }
            }
        }
    }
}

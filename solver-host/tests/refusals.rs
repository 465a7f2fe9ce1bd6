//! What cannot be solved is refused at once, and what takes long can be cancelled.

use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use mintime::solver::{
    LONGEST_RAD, Request, SolveError, Turns, solve, solve_all_windings_cancellable, solve_cancellable,
    solve_thoroughly, verify,
};
use mintime_shared::model::{Limits, State};

/// Far more than it takes, so that a busy machine does not matter.
const AT_ONCE: Duration = Duration::from_secs(2);

#[test]
fn maneuvers_of_hours_are_refused_at_once() {
    let rate = |rate_max_radps| Limits { rate_max_radps, ..Limits::TABLE_I };
    let at = |vx: f64| State { vx, ..State::origin() };
    let requests = [
        Request { from: at(1e5), ..Request::rest_to_rest(0.0, 0.0) },
        Request::rest_to_rest(1e9, 0.0),
        Request::rest_to_rest(1e300, -1e308),
        Request { limits: rate(1e5), ..Request::rest_to_rest(5.0, 5.0) },
        Request { limits: rate(1e300), ..Request::rest_to_rest(5.0, 5.0) },
    ];
    for request in requests {
        let clock = Instant::now();
        let error = solve(&request).expect_err("too long");
        assert!(matches!(error, SolveError::TooLong { .. }), "{request:?}: {error}");
        assert!(error.to_string().len() < 200, "{error}");
        assert!(clock.elapsed() < AT_ONCE, "{request:?}: {:?}", clock.elapsed());
    }
}

#[test]
fn the_longest_maneuvers_that_are_not_refused_are_solved() {
    for share in [0.05, 0.5, 0.99] {
        let rate_max_radps = share * LONGEST_RAD / 1.4;
        let limits = Limits { rate_max_radps, ..Limits::TABLE_I };
        let solution = solve(&Request { limits, ..Request::rest_to_rest(5.0, 5.0) });
        assert!(solution.as_ref().is_ok_and(|s| s.certificate.verified), "{rate_max_radps}: {solution:?}");
    }
}

#[test]
fn checking_takes_no_longer_however_long_the_maneuver() {
    let mut extremal = solve(&Request::rest_to_rest(5.0, 5.0)).expect("solved").extremal;
    for segment in &mut extremal.segments {
        segment.duration *= 1e12;
    }
    let clock = Instant::now();
    assert!(!verify(&extremal).verified);
    assert!(clock.elapsed() < AT_ONCE, "{:?}", clock.elapsed());
}

#[test]
fn what_is_cancelled_ends_soon_and_says_so() {
    let limits = Limits { rate_max_radps: 0.9 * LONGEST_RAD / 4.0, ..Limits::TABLE_I };
    let long = Request { limits, ..Request::rest_to_rest(40.0, 3.0) };
    let turning = Request { turns: Turns::Exactly(8), ..Request::rest_to_rest(3.0, 1.0) };
    let solvers = [solve_cancellable, solve_all_windings_cancellable, solve_thoroughly];
    for request in [long, turning, Request::rest_to_rest(5.0, 5.0)] {
        for solver in solvers {
            let cancelled = solver(&request, &AtomicBool::new(true));
            assert!(matches!(cancelled, Err(SolveError::Cancelled { .. })), "{request:?}: {cancelled:?}");
        }
        let cancel = AtomicBool::new(false);
        std::thread::scope(|scope| {
            let work = scope.spawn(|| solve_thoroughly(&request, &cancel).map(|s| s.evaluations));
            std::thread::sleep(Duration::from_millis(1));
            cancel.store(true, Ordering::Relaxed);
            let clock = Instant::now();
            let done = work.join().expect("no panic");
            assert!(matches!(done, Ok(_) | Err(SolveError::Cancelled { .. })), "{done:?}");
            assert!(clock.elapsed() < AT_ONCE, "{:?}", clock.elapsed());
        });
    }
}

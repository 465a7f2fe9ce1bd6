//! Weak vehicles: little thrust beyond hover and low body rates, where paths of the search die most easily. A stronger
//! vehicle can fly whatever a weaker one can, so T falls as F_max grows: a check that needs no reference durations.

use mintime::solver::{Request, Turns, solve};
use mintime_shared::model::{GRAVITY_MPS2, Limits};

/// F_max over gravity, weakest first.
const STRENGTHS: [f64; 7] = [1.15, 1.21, 1.28, 1.33, 1.41, 1.52, 1.7];
/// Displacements, m.
const DISPLACEMENTS: [(f64, f64); 6] =
    [(0.42, -0.03), (1.0, 0.0), (2.0, 0.0), (2.0, 0.05), (2.31, 0.0), (2.31, 0.17)];
/// Greatest body rates, rad/s.
const RATES: [f64; 4] = [3.0, 4.0, 6.0, 9.0];
/// Least thrusts per mass, m/s².
const LEAST: [f64; 3] = [0.5, 2.0, 6.0];

fn request((dx, dz): (f64, f64), thrust: (f64, f64), rate: f64) -> Request {
    let limits = Limits {
        thrust_min_mps2: thrust.0,
        thrust_max_mps2: thrust.1,
        rate_max_radps: rate,
        gravity_mps2: GRAVITY_MPS2,
    };
    Request { limits, ..Request::rest_to_rest(dx, dz) }
}

#[test]
fn a_stronger_vehicle_is_never_slower() {
    for displacement in DISPLACEMENTS {
        for rate in RATES {
            for least in LEAST {
                let mut weaker_s = f64::INFINITY;
                for strength in STRENGTHS {
                    let request = request(displacement, (least, strength * GRAVITY_MPS2), rate);
                    let t = solve(&request).expect("solved").extremal.duration_s();
                    assert!(t <= weaker_s * (1.0 + 1e-9), "{request:?}: {t} s, weaker {weaker_s} s");
                    weaker_s = t;
                }
            }
        }
    }
}

#[test]
fn the_fastest_lies_near_its_lower_bound_with_and_without_a_winding_asked_for() {
    for turns in [Turns::Any, Turns::Exactly(0)] {
        let weak = Request { turns, ..request((2.0, 0.0), (2.0, 13.0), 4.0) };
        let solution = solve(&weak).expect("solved");
        let (t, bound) = (solution.extremal.duration_s(), solution.certificate.lower_bound_s);
        assert_eq!(solution.extremal.turns, 0);
        // The bound is 0.923 s; vehicles of 12 and 14 m/s² take 1.155 s and 1.082 s.
        assert!(t < 1.155 && t > 1.082 && t < 2.0 * bound, "{t} s, bound {bound} s");
    }
}

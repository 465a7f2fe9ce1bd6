//! The 2,000 random requests: verified or refused with a reason, class by class.

mod requests;

use mintime::solver::{SolveError, solve};
use requests::{CLASSES, Class, SEED, requests};

/// Least fraction of each class that must be solved and verified.
fn demanded(class: Class) -> f64 {
    match class {
        Class::RestToRest | Class::Vertical | Class::Horizontal => 1.0,
        Class::Moving | Class::Limits | Class::Tiny | Class::UpsideDown => 0.995,
    }
}

#[test]
fn every_class_is_solved_and_verified() {
    let list = requests();
    assert_eq!(list.len(), 2000, "seed {SEED}");
    for (class, count) in CLASSES {
        let mut verified = 0;
        for (_, request) in list.iter().filter(|(c, _)| *c == class) {
            match solve(request) {
                Ok(solution) => {
                    let t = solution.extremal.duration_s();
                    assert!(solution.certificate.verified);
                    assert!(t >= solution.certificate.lower_bound_s * (1.0 - 1e-9), "{request:?}");
                    assert!(solution.alternatives.iter().all(|a| a.duration_s >= t * (1.0 - 1e-9)));
                    verified += 1;
                }
                Err(error) => {
                    assert!(matches!(error, SolveError::NotVerified { .. }), "{request:?}: {error}");
                    println!("{class:?} {request:?}: {error}");
                }
            }
        }
        let fraction = f64::from(verified) / count as f64;
        assert!(fraction >= demanded(class), "{class:?}: {verified} of {count}");
    }
}

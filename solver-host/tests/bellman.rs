//! Bellman's principle: every piece of a fastest maneuver is a fastest maneuver. So from any state of an optimum to any
//! later one the solver must find exactly the time between them: more, and it has missed the piece; less, and the whole
//! was not the optimum. Short pieces have fewer free numbers than end conditions, so this is also the test of those.

mod requests;

use mintime::solver::{Request, SolveError, Turns, solve};
use requests::requests;

/// Cuts, as fractions of the duration.
const CUTS: [f64; 9] = [0.0, 0.02, 0.11, 0.29, 0.47, 0.68, 0.86, 0.97, 1.0];
/// Relative agreement of durations that must be equal.
const EQUAL: f64 = 1e-8;

#[test]
fn every_piece_of_a_fastest_maneuver_is_a_fastest_maneuver() {
    let (mut pieces, mut slower, mut faster, mut refused) = (0, 0, 0, 0);
    for (class, request) in requests().into_iter().step_by(20) {
        let Ok(whole) = solve(&request) else { continue };
        let whole = whole.extremal;
        let duration = whole.duration_s();
        for (i, begin) in CUTS.iter().enumerate() {
            for end in &CUTS[i + 1..] {
                let (from, to) = (whole.state_at(begin * duration), whole.state_at(end * duration));
                let expected = (end - begin) * duration;
                let piece = Request { from, to, turns: Turns::Any, ..request };
                pieces += 1;
                match solve(&piece) {
                    Ok(found) => {
                        let t = found.extremal.duration_s();
                        if t > expected * (1.0 + EQUAL) {
                            slower += 1;
                            println!("{class:?} {begin}..{end}: {t} instead of {expected} {piece:?}");
                        } else if t < expected * (1.0 - EQUAL) {
                            faster += 1;
                            println!(
                                "FASTER {class:?} {begin}..{end}: {t} instead of {expected} {request:?}"
                            );
                        }
                    }
                    Err(SolveError::NotVerified { .. }) => {
                        refused += 1;
                        println!("REFUSED {class:?} {begin}..{end}: {piece:?}");
                    }
                    Err(error) => panic!("{piece:?}: {error}"),
                }
            }
        }
    }
    println!("{pieces} pieces: {slower} slower, {faster} faster, {refused} refused");
    assert_eq!((slower, faster, refused), (0, 0, 0));
}

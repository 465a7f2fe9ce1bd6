//! One flight as the tests of the benchmark read it, as CSV and as MCAP: a fastest maneuver between two hovers.
#![allow(dead_code, reason = "each test uses a part of it")]

use std::fmt::Write as _;
use std::fs;

use mintime::benchmark::{Flight, Goal, Rules, Score, score};
use mintime::flight_log::{FlightLog, FlightSample, Truth, write_mcap};
use mintime::solver::{Extremal, Request, solve};
use mintime_shared::model::State;

pub(crate) const RATE_HZ: f64 = 400.0;

pub(crate) fn maneuver() -> Extremal {
    solve(&Request::rest_to_rest(4.0, 1.0)).expect("a maneuver").extremal
}

/// A maneuver with half a second of hover before and 0.7 s after it: time and state.
pub(crate) fn flight() -> Vec<(f64, State<f64>)> {
    let extremal = maneuver();
    let count = ((extremal.duration_s() + 1.2) * RATE_HZ) as u32;
    let at = |i: u32| f64::from(i) / RATE_HZ;
    (0..count).map(|i| (at(i), extremal.state_at(at(i) - 0.5))).collect()
}

pub(crate) fn csv() -> String {
    let mut text = String::from("t_s,x_m,vx_mps,z_m,vz_mps,theta_rad\n");
    for (t_s, State { x, vx, z, vz, theta }) in flight() {
        let _ = writeln!(text, "{t_s},{x},{vx},{z},{vz},{theta}");
    }
    text
}

/// The same flight as `mintime fly` logs it.
pub(crate) fn log() -> FlightLog {
    let sample = |(t_s, planar): (f64, State<f64>)| {
        let (sin, cos) = (0.5 * planar.theta).sin_cos();
        FlightSample {
            time_ns: (t_s * 1e9).round() as u64,
            truth: Truth {
                position_m: [planar.x, 0.0, planar.z],
                velocity_mps: [planar.vx, 0.0, planar.vz],
                attitude_wxyz: [cos, 0.0, sin, 0.0],
                planar,
                ..Truth::default()
            },
            ..FlightSample::default()
        }
    };
    FlightLog { samples: flight().into_iter().map(sample).collect(), ..FlightLog::default() }
}

pub(crate) fn mcap() -> Vec<u8> {
    written(&log())
}

/// A log's bytes.
pub(crate) fn written(log: &FlightLog) -> Vec<u8> {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("flight.mcap");
    write_mcap(log, &path).expect("written");
    fs::read(path).expect("readable")
}

pub(crate) fn measured(flight: &Flight) -> Score {
    let ends = Some((Goal::hover([0.0; 3]), Goal::hover([4.0, 0.0, 1.0])));
    score(flight, ends, &Rules::default()).expect("a score")
}

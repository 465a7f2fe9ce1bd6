//! Reading logs: both kinds say the same of the same flight, units are converted, and every bad file ends in a sentence.

use std::fmt::Write as _;
use std::fs;
use std::path::Path;

use mintime::benchmark::{
    BenchmarkError, Flight, Goal, ReadError, Remark, Rules, Score, read, read_csv, read_mcap, score,
};
use mintime::flight_log::{FlightLog, FlightSample, Truth, write_mcap};
use mintime::solver::{Extremal, Request, solve};
use mintime_shared::model::State;
use proptest::prelude::*;

const RATE_HZ: f64 = 400.0;

fn maneuver() -> Extremal {
    solve(&Request::rest_to_rest(4.0, 1.0)).expect("a maneuver").extremal
}

/// A maneuver with half a second of hover before and 0.7 s after it: time and state.
fn flight() -> Vec<(f64, State<f64>)> {
    let extremal = maneuver();
    let count = ((extremal.duration_s() + 1.2) * RATE_HZ) as u32;
    let at = |i: u32| f64::from(i) / RATE_HZ;
    (0..count).map(|i| (at(i), extremal.state_at(at(i) - 0.5))).collect()
}

fn csv() -> String {
    let mut text = String::from("t_s,x_m,vx_mps,z_m,vz_mps,theta_rad\n");
    for (t_s, State { x, vx, z, vz, theta }) in flight() {
        let _ = writeln!(text, "{t_s},{x},{vx},{z},{vz},{theta}");
    }
    text
}

/// The same flight as `mintime fly` logs it.
fn log() -> FlightLog {
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

fn mcap() -> Vec<u8> {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("flight.mcap");
    write_mcap(&log(), &path).expect("written");
    fs::read(path).expect("readable")
}

fn measured(flight: &Flight) -> Score {
    let ends = Some((Goal::hover([0.0; 3]), Goal::hover([4.0, 0.0, 1.0])));
    score(flight, ends, &Rules::default()).expect("a score")
}

#[test]
fn both_readers_tell_of_the_same_flight() {
    let (from_csv, from_mcap) = (read_csv(csv().as_bytes()).expect("CSV"), read_mcap(&mcap()).expect("MCAP"));
    assert_eq!((&from_csv.remarks, &from_mcap.remarks), (&vec![], &vec![]));
    assert_eq!(from_csv.samples().len(), from_mcap.samples().len());
    for (a, b) in from_csv.samples().iter().zip(from_mcap.samples()) {
        assert!((a.t_s - b.t_s).abs() < 1e-9);
        for (a, b) in
            [(a.position_m, b.position_m), (a.velocity_mps, b.velocity_mps), (a.thrust_axis, b.thrust_axis)]
        {
            assert!((a - b).norm() < 1e-12, "{a} {b}");
        }
    }
    let (a, b) = (measured(&from_csv), measured(&from_mcap));
    assert!((a.score - b.score).abs() < 1e-8 && (a.score - 1.0).abs() < 5e-4, "{} {}", a.score, b.score);
}

/// The trajectory that `mintime solve --trajectory` writes is a log, and so is a flight with nobody saying where it goes.
#[test]
fn the_only_two_hovers_are_found() {
    let flight = read_csv(csv().as_bytes()).expect("CSV");
    let found = score(&flight, None, &Rules { dwell_s: 0.45, ..Rules::default() }).expect("two hovers");
    assert!((found.score - measured(&flight).score).abs() < 1e-6);
    let rules = Rules { dwell_s: 0.65, ..Rules::default() };
    let Err(BenchmarkError::Ambiguous(found)) = score(&flight, None, &rules) else {
        panic!("one hover only")
    };
    assert_eq!(found.len(), 1);
    assert!((found[0].position_m - nalgebra::Vector3::new(4.0, 0.0, 1.0)).norm() < 1e-6);
}

#[test]
fn spelling_order_units_and_separators_do_not_matter() {
    let expected = measured(&read_csv(csv().as_bytes()).expect("CSV")).score;
    let mut windows = String::from(
        "\u{feff}# measured µ by hand\r\n\r\nbattery;Time [ms];X [mm];Z (cm);THETA_deg;VX [km/h];vz_mm_s\r\n",
    );
    let mut tabs = String::from("theta_rad\tz_m\tx_m\tt_us\tnote\n#\tcomment\n");
    let mut quaternion = String::from("time_ns, qw, qx, qy, qz, x_m, y_m, z_m\n");
    for (t, State { x, vx, z, vz, theta }) in flight() {
        let comma = |v: f64| format!("{v}").replace('.', ",");
        let cells = [t * 1e3, x * 1e3, z * 1e2, theta.to_degrees(), vx * 3.6, vz * 1e3].map(comma);
        let _ = write!(windows, "11,1;{}\r\n", cells.join(";"));
        let _ = writeln!(tabs, "{theta}\t{z}\t{x}\t{}\tsteady", t * 1e6);
        let (sin, cos) = (0.5 * theta).sin_cos();
        let _ = writeln!(quaternion, "{}, {cos}, 0, {sin}, 0, {x}, 0, {z}", t * 1e9);
    }
    for (text, derived) in [(windows, false), (tabs, true), (quaternion, true)] {
        let flight = read_csv(text.as_bytes()).unwrap_or_else(|e| panic!("{e}: {}", &text[..200]));
        assert_eq!(flight.remarks == [Remark::VelocitiesDerived], derived);
        assert_eq!(flight.remarks.is_empty(), !derived);
        let score = measured(&flight).score;
        // A parabola over 40 ms rounds the corners of the velocity.
        assert!((score - expected).abs() < if derived { 0.01 } else { 1e-6 }, "{score} {expected}");
    }
}

/// Derived velocities against the true ones: exact for constant acceleration, near for a maneuver.
#[test]
fn velocities_are_derived_from_positions() {
    let mut fall = String::from("t_s,x_m,z_m,theta_rad\n");
    let mut t = 0.0;
    for i in 0..60 {
        t += if i % 7 == 0 { 0.013 } else { 0.004 };
        let _ = writeln!(fall, "{t},{},{},0", 1e3 + 2.0 * t, 100.0 - 0.5 * 9.81 * t * t);
    }
    for sample in read_csv(fall.as_bytes()).expect("CSV").samples() {
        let off = sample.velocity_mps - nalgebra::Vector3::new(2.0, 0.0, -9.81 * sample.t_s);
        assert!(off.norm() < 1e-8, "{}: {off}", sample.t_s);
    }
    let mut text = String::from("t_s,x_m,z_m,theta_rad\n");
    for (t, State { x, z, theta, .. }) in flight() {
        let _ = writeln!(text, "{t},{x},{z},{theta}");
    }
    let derived = read_csv(text.as_bytes()).expect("CSV");
    let worst = derived.samples().iter().zip(flight()).map(|(sample, (_, state))| {
        (sample.velocity_mps.x - state.vx).hypot(sample.velocity_mps.z - state.vz)
    });
    // Where the thrust turns or jumps, within half the fit.
    let worst = worst.fold(0.0, f64::max);
    assert!(worst < 0.5 * 20.0 * 0.02, "{worst}");
}

fn refused(text: &str) -> String {
    let error = read_csv(text.as_bytes()).expect_err(text).to_string();
    assert!(error.len() > 20 && !error.contains("Error"), "{error}");
    error
}

#[test]
fn each_bad_csv_is_told_apart() {
    let head = "t_s,x_m,z_m,theta_rad\n";
    let good = "0,0,0,0\n0.01,0,0,0\n";
    for (text, part) in [
        (String::new(), "empty"),
        ("# nothing\n\n".to_owned(), "empty"),
        (head.to_owned(), "no samples"),
        (format!("{head}0,0,0,0\n"), "at least two"),
        ("\u{0}\u{1}garbage".to_owned(), "no column t_s"),
        ("x_m,z_m,theta_rad\n0,0,0\n".to_owned(), "no column t_s"),
        ("t_s,x_m,theta_rad\n0,0,0\n".to_owned(), "no column z_m"),
        ("t_s,x_m,z_m\n0,0,0\n".to_owned(), "no column theta_rad"),
        ("t_s,x_m,y_m,z_m,theta_rad\n".to_owned(), "quaternion"),
        ("t_s,x_m,z_m,qw,qx,qy\n".to_owned(), "no column qz"),
        ("t_s,x_m,z_m,theta_rad,vx_mps\n".to_owned(), "no column vz_mps"),
        ("t,x,z,theta\n0,0,0,0\n".to_owned(), "`t` does not say its unit: call it t_s"),
        ("t_s,x_ft,z_m,theta_rad\n0,0,0,0\n".to_owned(), "`x_ft` does not say"),
        ("t_s,x_m,x_mm,z_m,theta_rad\n".to_owned(), "both columns `x_m` and `x_mm`"),
        (format!("{head}{good}0.02,nan,0,0\n0.03,0,0,0\n"), "line 4: `nan` in the column x_m"),
        (format!("{head}{good}0.02,0,inf,0\n"), "line 4: `inf` in the column z_m"),
        (format!("{head}{good}0.02,0,,0\n0.03,0,0,0\n"), "line 4: `` in the column z_m"),
        (format!("#\n\n{head}{good}#\n\n0.02,0,0,1e400\n"), "line 8: `1e400`"),
        (
            format!("#\r\n\r\n{head}{good}#\r\n\r\n0.02,0,0,x\r\n")
                .replace("\n", "\r\n")
                .replace("\r\r", "\r"),
            "line 8: `x`",
        ),
        (format!("{head}{good}0.02,0\n0.03,0,0,0\n"), "line 4 has 2 cells where the header has 4"),
        (format!("{head}{good}0.02,0,0,0,7\n0.03,0,0,0\n"), "line 4 has 5 cells"),
        (format!("{head}{good}0.005,0,0,0\n"), "line 4: time goes from 0.01 s to 0.005 s"),
        (format!("{head}{good}0.01,0,0,0\n0.02,0,0,0\n"), "line 4: time goes from 0.01 s to 0.01 s"),
        (format!("{head}0,1e6,0,0\n1,1e6,0,0\n"), "line 2: the position is beyond"),
        (
            "t_s,x_m,z_m,qw,qx,qy,qz\n0,0,0,0.5,0,0,0\n1,0,0,1,0,0,0\n".to_owned(),
            "line 2: the quaternion's length is 0.5",
        ),
        ("t_s,x_m,z_m,theta_rad\n0,0,0,\"0\n1,0,0,0\n".to_owned(), "line 2: `\"0`"),
    ] {
        let error = refused(&text);
        assert!(error.contains(part), "{text:?}: {error}");
    }
    assert!(matches!(read_csv(b"\xff\xfet\0"), Err(ReadError::Utf16)));
}

#[test]
fn a_cut_csv_is_read_as_far_as_it_is_whole() {
    let text = csv();
    let whole = read_csv(text.as_bytes()).expect("CSV").samples().len();
    let last_line = text.trim_end().rfind('\n').expect("lines") + 1;
    for cut in last_line + 1..text.len() {
        let flight = read_csv(&text.as_bytes()[..cut]).unwrap_or_else(|e| panic!("{cut}: {e}"));
        let complete = flight.remarks == [Remark::NoLineBreak];
        assert!(complete || matches!(flight.remarks[..], [Remark::Cut { .. }]), "{:?}", flight.remarks);
        assert_eq!(flight.samples().len(), if complete { whole } else { whole - 1 });
        assert!((measured(&flight).score - 1.0).abs() < 5e-4);
    }
}

#[test]
fn a_cut_mcap_is_read_as_far_as_it_is_whole() {
    let bytes = mcap();
    let whole = read_mcap(&bytes).expect("MCAP").samples().len();
    let mut before = 0;
    for part in 1..40 {
        match read_mcap(&bytes[..bytes.len() * part / 40]) {
            Ok(flight) => {
                let count = flight.samples().len();
                assert!(count >= before && count <= whole);
                let cut = flight.remarks.iter().any(|r| matches!(r, Remark::Cut { .. }));
                assert!(cut || count == whole, "{part}: {:?}", flight.remarks);
                before = count;
            }
            Err(error) => {
                assert!(
                    before == 0
                        && matches!(error, ReadError::NoTruth { found: Some(_) } | ReadError::TooShort(_))
                );
            }
        }
    }
    assert!(before > whole / 2, "{before} of {whole}");
    // Cut near its end it still holds the flight.
    let nearly = read_mcap(&bytes[..bytes.len() - 1000]).expect("MCAP");
    assert!((measured(&nearly).score - 1.0).abs() < 5e-4);
}

/// A wrong bit in a chunk: nothing of that chunk is believed.
#[test]
fn a_damaged_mcap_is_not_believed() {
    let bytes = mcap();
    let place = bytes.len() / 2;
    for bit in 0..8 {
        let mut damaged = bytes.clone();
        damaged[place] ^= 1 << bit;
        match read_mcap(&damaged) {
            Ok(flight) => assert!(matches!(flight.remarks[..], [Remark::Cut { .. }]), "{:?}", flight.remarks),
            Err(error) => assert!(matches!(error, ReadError::NoTruth { .. }), "{error}"),
        }
    }
}

#[test]
fn files_that_are_no_logs_are_told_apart() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = |name: &str, bytes: &[u8]| {
        let path = folder.path().join(name);
        fs::write(&path, bytes).expect("written");
        path
    };
    assert!(matches!(read(&file("empty.mcap", b"")), Err(ReadError::Empty)));
    assert!(matches!(read(&file("text.mcap", csv().as_bytes())), Err(ReadError::NotMcap)));
    assert!(matches!(read(folder.path()), Err(ReadError::NotAFile { .. })));
    assert!(matches!(read(Path::new("/nowhere/at/all.csv")), Err(ReadError::File { .. })));
    // The first bytes decide, not the name.
    assert!(read(&file("a.csv", &mcap())).is_ok());
    assert!(read(&file("a.txt", csv().as_bytes())).is_ok());
    let mut empty = FlightLog::default();
    let path = folder.path().join("none.mcap");
    write_mcap(&empty, &path).expect("written");
    assert!(matches!(read(&path), Err(ReadError::NoTruth { found: None })));
    // A vehicle that the cameras do not see for a while.
    empty.samples = log().samples;
    for sample in empty.samples.iter_mut().skip(50).step_by(2) {
        sample.truth.position_m = [f64::NAN; 3];
    }
    write_mcap(&empty, &path).expect("written");
    let flight = read(&path).expect("a log");
    assert!(
        matches!(flight.remarks[..], [Remark::Unseen { samples }] if samples > 100),
        "{:?}",
        flight.remarks
    );
    assert!((measured(&flight).score - 1.0).abs() < 2e-3);
}

fn scaled(time: f64, length: f64, speed: f64, angle: f64) -> Result<Score, BenchmarkError> {
    let mut text = String::from("t_s,x_m,vx_mps,z_m,vz_mps,theta_rad\n");
    for (t, State { x, vx, z, vz, theta }) in flight() {
        let _ = writeln!(
            text,
            "{},{},{},{},{},{}",
            t * time,
            x * length,
            vx * speed,
            z * length,
            vz * speed,
            theta * angle
        );
    }
    let rules = Rules { largest_gap_s: 1e9, dwell_s: 0.3 * time.min(1.0), ..Rules::default() };
    let ends = Some((Goal::hover([0.0; 3]), Goal::hover([4.0 * length, 0.0, length])));
    score(&read_csv(text.as_bytes()).expect("CSV"), ends, &rules)
}

/// Units that a header gets wrong show in physics.
#[test]
fn confused_units_are_told() {
    assert!(scaled(1.0, 1.0, 1.0, 1.0).is_ok_and(|s| s.remarks.is_empty()));
    // Time in ms or µs, called s; the reverse; positions in mm or cm, called m.
    for (time, length) in [(1e3, 1.0), (1e6, 1.0), (1e-3, 1.0), (1.0, 1e3), (1.0, 100.0)] {
        let refused = scaled(time, length, 1.0, 1.0);
        assert!(matches!(refused, Err(BenchmarkError::Velocities { .. })), "{time} {length}: {refused:?}");
    }
    // Without velocities to contradict: consistent, and beyond any vehicle.
    for (time, length) in [(0.1, 1.0), (1.0, 100.0)] {
        let refused = scaled(time, length, length / time, 1.0);
        let thrust = matches!(refused, Err(BenchmarkError::Thrust { .. }));
        assert!(
            thrust || matches!(refused, Err(BenchmarkError::NeverThere(_))),
            "{time} {length}: {refused:?}"
        );
    }
    // The pitch of aeroplanes, nose up.
    let mirrored = scaled(1.0, 1.0, 1.0, -1.0).expect("a score");
    let told = mirrored.remarks.iter().any(|r| matches!(r, Remark::Misaligned { mirrored: true, .. }));
    assert!(told, "{:?}", mirrored.remarks);
    // Time stretched a hundredfold, with the velocities that belong to it: a vehicle that tilts and does not move.
    let slow = scaled(100.0, 1.0, 0.01, 1.0).expect("a score");
    let told = slow.remarks.iter().any(|r| matches!(r, Remark::Misaligned { mirrored: false, .. }));
    assert!(told, "{:?}", slow.remarks);
}

#[test]
fn states_that_do_not_occur_are_told_with_the_nearest() {
    let flight = read_csv(csv().as_bytes()).expect("CSV");
    let rules = Rules::default();
    let (start, end) = (Goal::hover([0.0; 3]), Goal::hover([4.0, 0.0, 1.0]));
    let never = score(&flight, Some((start, Goal::hover([4.3, 0.0, 1.0]))), &rules).expect_err("not there");
    assert!(never.to_string().contains("0.300 m"), "{never}");
    let exchanged = score(&flight, Some((end, start)), &rules).expect_err("the wrong way round");
    assert!(exchanged.to_string().contains("exchange"), "{exchanged}");
    // A tenth of a second after the arrival the log ends.
    let early = flight.window(0.0, 0.6 + maneuver().duration_s()).expect("a window");
    let cut = score(&early, Some((start, end)), &rules).map(|s| s.leg.arrival_s);
    assert!(matches!(cut, Err(BenchmarkError::NotHeld { arrived_s: Some(_), .. })), "{cut:?}");
    assert!(matches!(flight.window(9.0, 10.0), Err(BenchmarkError::Window { .. })));
    let same = score(&flight, Some((start, Goal::hover([0.05, 0.0, 0.0]))), &rules);
    assert!(matches!(same, Err(BenchmarkError::SameStates)));
}

#[test]
fn gaps_and_repeated_flights_are_told() {
    let mut text = String::from("t_s,x_m,vx_mps,z_m,vz_mps,theta_rad\n");
    let mut holed = text.clone();
    let (_, last) = *flight().last().expect("samples");
    let duration_s = flight().len() as f64 / RATE_HZ;
    for round in 0..2 {
        for (t, State { x, vx, z, vz, theta }) in flight() {
            let line = format!("{},{x},{vx},{z},{vz},{theta}\n", t + 2.0 * duration_s * f64::from(round));
            text += &line;
            if round == 0 && !(1.0..1.12).contains(&t) {
                holed += &line;
            }
        }
        // Carried back by hand, slowly.
        for i in 0..200 {
            let t = duration_s * (1.0 + f64::from(i) / 200.0 + 2.0 * f64::from(round));
            let part = 1.0 - f64::from(i) / 200.0;
            text += &format!("{t},{},{},{},{},0\n", last.x * part, -0.5, last.z * part, 0.0);
        }
    }
    let ends = Some((Goal::hover([0.0; 3]), Goal::hover([4.0, 0.0, 1.0])));
    let flight = read_csv(text.as_bytes()).expect("CSV");
    let Err(BenchmarkError::SeveralLegs(legs)) = score(&flight, ends, &Rules::default()) else {
        panic!("two flights")
    };
    assert_eq!(legs.len(), 2);
    for leg in legs {
        let part = flight.window(leg.departure_s - 0.1, leg.arrival_s + 0.6).expect("a window");
        assert!((measured(&part).score - 1.0).abs() < 5e-4);
    }
    let holed = read_csv(holed.as_bytes()).expect("CSV");
    let refused = score(&holed, ends, &Rules::default());
    assert!(matches!(refused, Err(BenchmarkError::Gap { .. })), "{refused:?}");
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 300, failure_persistence: None, ..ProptestConfig::default() })]

    /// Whatever happens to a file: a score or a sentence.
    #[test]
    fn no_damage_makes_a_reader_panic(
        mcap_file in any::<bool>(),
        cut in 0.0..1.2_f64,
        flips in prop::collection::vec((0.0..1.0_f64, 0_u8..8), 0..6),
        moves in prop::collection::vec((0.0..1.0_f64, 0.0..1.0_f64, 1_usize..200), 0..3),
    ) {
        let mut bytes = if mcap_file { mcap() } else { csv().into_bytes() };
        bytes.truncate((cut * bytes.len() as f64) as usize);
        let length = bytes.len();
        let place = |part: f64| (part * length as f64) as usize;
        for (part, bit) in flips {
            if let Some(byte) = bytes.get_mut(place(part)) {
                *byte ^= 1 << bit;
            }
        }
        for (from, to, count) in moves {
            let (from, to) = (place(from), place(to));
            if from + count <= length && to + count <= length {
                let part = bytes[from..from + count].to_vec();
                bytes[to..to + count].copy_from_slice(&part);
            }
        }
        let read = if mcap_file { read_mcap(&bytes) } else { read_csv(&bytes) };
        match read {
            Ok(flight) => {
                prop_assert!(flight.samples().windows(2).all(|p| p[0].t_s < p[1].t_s));
                let ends = Some((Goal::hover([0.0; 3]), Goal::hover([4.0, 0.0, 1.0])));
                if let Err(error) = score(&flight, ends, &Rules::default()) {
                    prop_assert!(error.to_string().len() > 20);
                }
            }
            Err(error) => prop_assert!(error.to_string().len() > 20),
        }
    }

    /// Lines in any order but the right one are refused with their number.
    #[test]
    fn exchanged_lines_are_refused(a in 1_usize..400, b in 1_usize..400) {
        let text = csv();
        let mut lines: Vec<&str> = text.lines().collect();
        lines.swap(a, b);
        let read = read_csv(format!("{}\n", lines.join("\n")).as_bytes());
        prop_assert_eq!(matches!(read, Err(ReadError::Order { .. })), a != b);
    }
}

//! Reading logs: both kinds say the same of the same flight, units are converted, and every bad file ends in a sentence.

mod logged;

use std::fmt::Write as _;
use std::fs;
use std::path::Path;

use logged::{csv, flight, log, maneuver, mcap, measured, written};
use mintime::benchmark::{BenchmarkError, Goal, ReadError, Remark, Rules, read, read_csv, read_mcap, score};
use mintime::flight_log::{FlightLog, write_mcap};
use mintime::pack::pack;
use mintime_shared::model::{Limits, State};
use mintime_shared::table::{Kind, MAX_TABLE_BYTES};
use proptest::prelude::*;

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

/// A log of other limits than those given is remarked on. A learned table's limits are commands, and say nothing of them.
#[test]
fn the_limits_of_a_plan_are_told_and_those_of_a_learned_table_are_not() {
    let planned = pack(&maneuver(), 0, 0.0).expect("it fits");
    for (kind, told) in [(Kind::Extremal, true), (Kind::Learned, false)] {
        let mut table = planned.clone();
        table.kind = kind;
        let mut bytes = [0; MAX_TABLE_BYTES];
        let length = table.encode(&mut bytes).expect("room");
        let mut log = log();
        log.header.table = bytes[..length].to_vec();
        log.header.maneuver_start_ns = Some(500_000_000);
        let flight = read_mcap(&written(&log)).expect("MCAP");
        let stronger = Limits { thrust_max_mps2: 25.0, ..Limits::TABLE_I };
        let remarks =
            score(&flight, None, &Rules { limits: stronger, ..Rules::default() }).expect("a score").remarks;
        let other = remarks
            .iter()
            .any(|r| matches!(r, Remark::OtherLimits(limits) if limits.thrust_max_mps2 == 20.0));
        assert_eq!(other, told, "{remarks:?}");
        assert!(score(&flight, None, &Rules::default()).expect("a score").remarks.is_empty());
    }
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

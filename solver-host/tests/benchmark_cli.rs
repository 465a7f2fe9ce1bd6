//! `mintime benchmark` from end to end: flights of `mintime fly`, trajectories of `mintime solve`, the controller, its map.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

use serde_json::Value;

fn mintime(folder: &Path, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_mintime"))
        .args(arguments)
        .current_dir(folder)
        .output()
        .expect("it starts")
}

fn answer(folder: &Path, arguments: &[&str]) -> Value {
    let output = mintime(folder, &[arguments, &["--json"]].concat());
    assert!(output.status.success(), "{arguments:?}: {}", String::from_utf8_lossy(&output.stderr));
    serde_json::from_slice(&output.stdout).expect("JSON")
}

fn number(answer: &Value, path: &str) -> f64 {
    answer.pointer(path).and_then(Value::as_f64).unwrap_or_else(|| panic!("no {path} in {answer}"))
}

fn refusal(folder: &Path, arguments: &[&str]) -> String {
    let output = mintime(folder, arguments);
    assert!(!output.status.success(), "{arguments:?} succeeded");
    let text = String::from_utf8(output.stderr).expect("text");
    assert!(!text.contains("panicked") && text.trim().lines().count() >= 1, "{text}");
    text
}

/// The planning model flies the plan, and so scores 1; the vehicle with lag and drag misses, is caught, and takes longer.
#[test]
fn a_flight_is_scored_from_its_log() {
    let folder = tempfile::tempdir().expect("a folder");
    let here = folder.path();
    for (to, heading_rad) in [("5,5", 0.0), ("3,4,5", 4f64.atan2(3.0))] {
        let fly = ["fly", "--to", to, "--vehicle", "hosted", "--plant"];
        answer(here, &[&fly[..], &["ideal", "--log", "flight.mcap", "--report", "r.svg"]].concat());
        let score = answer(here, &["benchmark", "flight.mcap", "-o", "score.png"]);
        // Truth is logged every 1.25 ms; the flight itself is off by a tenth of a millisecond's worth of motion.
        assert!((number(&score, "/score") - 1.0).abs() < 5e-4, "{score}");
        assert!((number(&score, "/optimal/duration_s") - number(&score, "/duration_s")).abs() < 1e-3);
        assert!((number(&score, "/heading_rad") - heading_rad).abs() < 1e-2, "{score}");
        assert_eq!(score.pointer("/optimal/certificate/verified"), Some(&Value::Bool(true)));
        assert_eq!(score["remarks"], Value::Array(vec![]));
        assert!(fs::read(here.join("score.png")).expect("a picture").starts_with(b"\x89PNG"));
    }
    answer(here, &["fly", "--to", "5,5", "--vehicle", "hosted", "--log", "flight.mcap", "--report", "r.svg"]);
    let caught = answer(here, &["benchmark", "flight.mcap"]);
    assert!((1.5..4.0).contains(&number(&caught, "/score")), "{caught}");

    // Cut before the maneuver, and cut after the catch.
    let log = fs::read(here.join("flight.mcap")).expect("a log");
    fs::write(here.join("cut.mcap"), &log[..log.len() / 20]).expect("written");
    let text = refusal(here, &["benchmark", "cut.mcap"]);
    assert!(text.contains("before its maneuver began") && text.contains("the file is cut"), "{text}");
    fs::write(here.join("cut.mcap"), &log[..log.len() * 3 / 4]).expect("written");
    let cut = answer(here, &["benchmark", "cut.mcap"]);
    assert_eq!(cut["score"], caught["score"]);
    assert!(cut["remarks"][0].as_str().is_some_and(|note| note.contains("is cut")), "{cut}");

    // The same flight as CSV: what the command writes it reads, and finds the same score.
    answer(here, &["benchmark", "flight.mcap", "-o", "flown.csv"]);
    let (from, to) = (caught["from"].clone(), caught["to"].clone());
    let state = |s: &Value| {
        ["x", "vx", "z", "vz", "theta"].map(|n| number(s, &format!("/{n}")).to_string()).join(",")
    };
    // Its samples begin and end in the states found: next to them it leaves and arrives.
    let (from, to) = (state(&from), state(&to));
    let fine = ["--tolerance-position", "1e-3", "--tolerance-velocity", "1e-2", "--tolerance-angle", "1e-2"];
    let again = answer(
        here,
        &[&["benchmark", "flown.csv", "--from", &from, "--to", &to, "--arrival", "first"], &fine[..]]
            .concat(),
    );
    assert!((number(&again, "/score") - number(&caught, "/score")).abs() < 0.02, "{again}");
}

#[test]
fn a_trajectory_of_the_solver_is_a_log() {
    let folder = tempfile::tempdir().expect("a folder");
    let here = folder.path();
    let motion = ["--from", "0,3,0,-1,0.5", "--to", "4,2,1,0,0"];
    let solved = answer(here, &[&["solve"], &motion[..], &["--trajectory", "path.csv"]].concat());
    let score = answer(here, &[&["benchmark", "path.csv"], &motion[..]].concat());
    assert!((number(&score, "/score") - 1.0).abs() < 1e-4, "{score}");
    let nominal = number(&score, "/nominal/duration_s");
    assert!((nominal - number(&solved, "/duration_s")).abs() < 1e-9);
}

#[test]
fn the_linear_controller_has_scores_and_a_map() {
    let folder = tempfile::tempdir().expect("a folder");
    let here = folder.path();
    let linear = ["benchmark", "--controller", "linear"];
    let one = answer(here, &[&linear[..], &["--to", "5,5", "-o", "one.svg"]].concat());
    assert!((1.2..1.3).contains(&number(&one, "/score")), "{one}");
    let slow = answer(here, &[&linear[..], &["--to", "5,5", "--gains", "1,1,2,1,10,0.5"]].concat());
    assert!(number(&slow, "/score") > number(&one, "/score") + 0.5);

    let region = ["--map", "--x", "-5,5", "--z", "-5,5", "--points", "3,3"];
    let map = answer(here, &[&linear[..], &region, &["-o", "map.csv"]].concat());
    assert_eq!((map["points"].as_u64(), map["failed"].as_u64()), (Some(9), Some(0)));
    let csv = fs::read_to_string(here.join("map.csv")).expect("a map");
    let rows: Vec<Vec<&str>> = csv.lines().skip(1).map(|line| line.split(',').collect()).collect();
    assert_eq!(rows.len(), 9);
    let corner: f64 = rows[8][4].parse().expect("a score");
    assert!((corner - number(&one, "/score")).abs() < 1e-9, "{corner}");
    assert_eq!(rows[4][..5], ["0", "0", "0", "0", ""]);
    for (left, right) in [(0, 2), (3, 5), (6, 8)] {
        let score = |row: usize| rows[row][4].parse::<f64>().expect("a score");
        assert!((score(left) - score(right)).abs() < 1e-6, "{left}");
    }
    answer(here, &[&linear[..], &region, &["-o", "map.png"]].concat());
    assert!(fs::read(here.join("map.png")).expect("a picture").starts_with(b"\x89PNG"));
}

#[test]
fn what_cannot_be_done_is_refused_and_the_log_stays() {
    let folder = tempfile::tempdir().expect("a folder");
    let here = folder.path();
    let log = "t_s,x_m,z_m,theta_rad\n0,0,0,0\n0.01,0,0,0\n";
    fs::write(here.join("log.csv"), log).expect("written");
    fs::create_dir(here.join("detour")).expect("a folder");
    #[cfg(unix)]
    std::os::unix::fs::symlink("log.csv", here.join("link.csv")).expect("a link");
    let given = fs::read_dir(here).expect("readable").count();
    for (arguments, part) in [
        (vec!["benchmark"], "LOG"),
        (vec!["benchmark", "none.csv"], "none.csv cannot be read"),
        (vec!["benchmark", "log.csv"], "no times at rest"),
        (vec!["benchmark", "log.csv", "--from", "0,0", "--to", "1,1"], "never within tolerance of the end"),
        (vec!["benchmark", "log.csv", "--from", "0,0"], "--to"),
        (vec!["benchmark", "log.csv", "-o", "log.csv"], "replace the log"),
        (vec!["benchmark", "log.csv", "-o", "./detour/../log.csv"], "replace the log"),
        #[cfg(unix)]
        (vec!["benchmark", "log.csv", "-o", "link.csv"], "replace the log"),
        (vec!["benchmark", "log.csv", "-o", "x.pdf"], ".svg"),
        (vec!["benchmark", "log.csv", "--between", "5,6"], "--between"),
        (vec!["benchmark", "log.csv", "--to", "1,2,3,4", "--from", "0,0"], "2, 3 or 5 numbers"),
        (vec!["benchmark", "log.csv", "--tolerance-angle", "0"], "above zero"),
        (vec!["benchmark", "log.csv", "--thrust-per-mass", "1,9"], "cannot hover"),
        (vec!["benchmark", "--controller", "linear"], "--to X,Z"),
        (vec!["benchmark", "--controller", "linear", "--to", "1,1,1"], "--to X,Z"),
        (vec!["benchmark", "--controller", "linear", "--map"], "--output"),
        (
            vec!["benchmark", "--controller", "linear", "--to", "1,1", "--gains", "1,1,1,1,1,2"],
            "quarter turn",
        ),
        (
            vec!["benchmark", "--controller", "linear", "--map", "--x", "3,1", "-o", "m.csv"],
            "lower end first",
        ),
        (vec!["benchmark", "--controller", "linear", "--map", "--points", "0,1", "-o", "m.csv"], "--points"),
    ] {
        let text = refusal(here, &arguments);
        assert!(text.contains(part), "{arguments:?}: {text}");
    }
    assert_eq!(fs::read_to_string(here.join("log.csv")).expect("still there"), log);
    assert_eq!(fs::read_dir(here).expect("readable").count(), given, "files were left");
}

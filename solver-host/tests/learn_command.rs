//! `mintime learn` as a person or a script uses it.

use std::path::Path;
use std::process::{Command, Output};

use serde_json::Value;

fn mintime(folder: &Path, arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_mintime"));
    command.args(arguments).current_dir(folder).output().expect("it starts")
}

fn json(output: &Output) -> Value {
    serde_json::from_slice(&output.stdout)
        .unwrap_or_else(|e| panic!("{e}: {}", String::from_utf8_lossy(&output.stderr)))
}

fn read(folder: &Path, name: &str) -> Vec<u8> {
    std::fs::read(folder.join(name)).unwrap_or_else(|e| panic!("{name}: {e}"))
}

#[test]
fn it_learns_keeps_what_it_learned_and_learns_on_from_there() {
    let folder = tempfile::tempdir().expect("a folder");
    let to = ["learn", "--to", "0,4", "--vehicle", "hosted", "--seed", "3", "--json"];
    let output = mintime(folder.path(), &to);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let answer = json(&output);
    assert_eq!(answer["converged"], true);
    for duration in ["planned_duration_s", "learned_duration_s", "optimum_duration_s"] {
        assert!((1.1..1.4).contains(&answer[duration].as_f64().expect("a number")), "{duration}: {answer}");
    }
    assert!(answer["reason"].as_str().expect("a text").contains("learned"));
    let flights = answer["flights"].as_array().expect("flights");
    assert!((2..=10).contains(&flights.len()));
    assert!(flights.iter().all(|f| f["start_error"]["theta_rad"].is_f64()));
    let repeats = answer["repeats"].as_array().expect("repeats");
    assert_eq!(repeats.len(), 5);
    for repeat in repeats {
        let error = &repeat["final_error"];
        let at = |name: &str| error[name].as_f64().expect("a number");
        assert!(at("x_m").hypot(at("z_m")) < 0.05 && at("theta_rad").abs() < 0.05, "{error}");
        assert!(at("vx_mps").hypot(at("vz_mps")) < 0.15, "{error}");
    }
    let progress = String::from_utf8_lossy(&output.stderr);
    assert!(progress.contains("flight 1:") && progress.contains("repeat 5:"), "{progress}");

    // What was printed is what was kept, and the table is one that flies.
    let kept: Value =
        serde_json::from_slice(&read(folder.path(), "learned/0-4-hosted/history.json")).expect("JSON");
    assert_eq!(kept["flights"], answer["flights"]);
    assert_eq!(kept["repeats"], answer["repeats"]);
    let table = "learned/0-4-hosted/best.table";
    assert!(mintime(folder.path(), &["show", table]).status.success());
    let flown =
        mintime(folder.path(), &["fly", "--table", table, "--vehicle", "hosted", "--seed", "3", "--json"]);
    let x = json(&flown).pointer("/flight/final_error/x_m").and_then(Value::as_f64).expect("an error");
    assert!(x.abs() < 0.06, "{x}");

    // From the table it goes on; the earlier history stays.
    let on = [
        "learn",
        "--to",
        table,
        "--vehicle",
        "hosted",
        "--seed",
        "3",
        "--output",
        "learned/0-4-hosted",
        "--json",
    ];
    let before = read(folder.path(), "learned/0-4-hosted/history.json");
    let best = read(folder.path(), table);
    let output = mintime(folder.path(), &on);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    assert_eq!(json(&output)["flights"].as_array().expect("flights").len(), 2);
    assert_eq!(read(folder.path(), "learned/0-4-hosted/history-1.json"), before);
    assert_eq!(read(folder.path(), "learned/0-4-hosted/best-1.table"), best);
}

#[cfg(unix)]
#[test]
fn a_full_disk_costs_neither_the_answer_nor_what_was_kept() {
    let folder = tempfile::tempdir().expect("a folder");
    let arguments = "learn --to 0,4 --vehicle hosted --flights 2 --repeats 0 --output kept --json";
    let first = mintime(folder.path(), &arguments.split(' ').collect::<Vec<_>>());
    assert_eq!(json(&first)["flights"].as_array().expect("flights").len(), 2);
    let before = read(folder.path(), "kept/history.json");
    // No file may hold a byte: what a full disk does.
    let script = format!("ulimit -f 0; exec {} {arguments}", env!("CARGO_BIN_EXE_mintime"));
    let output =
        Command::new("sh").args(["-c", &script]).current_dir(folder.path()).output().expect("it starts");
    assert!(!output.status.success());
    let told = String::from_utf8_lossy(&output.stderr);
    assert!(told.contains("check the free space of the disk") && told.contains("as it was"), "{told}");
    assert!(!told.contains("panicked"), "{told}");
    let answer = json(&output);
    assert_eq!(answer["flights"].as_array().expect("flights").len(), 2);
    assert!(answer["flights"][1]["table"].as_str().expect("the table").len() > 100);
    // It names no files that hold something else.
    assert!(answer["table"].is_null() && answer["history"].is_null(), "{answer}");
    assert!(answer["error"].as_str().is_some_and(|error| error.contains("as it was")), "{answer}");
    assert_eq!(read(folder.path(), "kept/history-1.json"), before);
}

#[test]
fn what_cannot_be_learned_is_refused_in_a_sentence() {
    let folder = tempfile::tempdir().expect("a folder");
    std::fs::write(folder.path().join("weak.toml"), "[rotors]\nthrust_coefficient_ns2 = 0.6e-6")
        .expect("written");
    std::fs::write(folder.path().join("no.table"), "nothing").expect("written");
    std::fs::write(folder.path().join("file"), "").expect("written");
    for (arguments, told) in [
        (&["--to", "5,5,5,5"][..], "numbers"),
        (&["--to", "no.table"], "not a maneuver table"),
        (&["--to", "nowhere.table"], "cannot be read"),
        (&["--to", "5,5", "--mocap", "-"], "is for a real vehicle"),
        (&["--to", "5,5", "--plant", "weak.toml"], "thrust"),
        (&["--to", "5,5", "--output", "file/folder"], "cannot be made"),
        (&["--to", "5,5", "--thrust-per-mass", "1,5"], "cannot hover"),
        (&["--to", "5,5", "--room", "-1,1,-1,1"], "does not fit the room"),
    ] {
        let all: Vec<&str> =
            ["learn", "--vehicle", "hosted", "--json"].iter().chain(arguments).copied().collect();
        let output = mintime(folder.path(), &all);
        let text = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(!output.status.success() && text.contains(told), "{arguments:?}: {text}");
        assert!(!text.contains("panicked"), "{text}");
        let answer = json(&output);
        assert_eq!(answer["converged"], false, "{arguments:?}");
        assert!(answer["reason"].as_str().is_some_and(|reason| reason.contains(told)), "{answer}");
    }
}

/// A table that lies in the folder without a history is somebody's work, too; and a campaign that never flew takes nothing away.
#[test]
fn what_was_kept_makes_room_for_something_new_only() {
    let folder = tempfile::tempdir().expect("a folder");
    std::fs::create_dir(folder.path().join("kept")).expect("a folder");
    std::fs::write(folder.path().join("kept/best.table"), "of an earlier day").expect("written");
    std::fs::write(folder.path().join("weak.toml"), "[rotors]\nthrust_coefficient_ns2 = 0.6e-6")
        .expect("written");
    let learn = ["learn", "--to", "0,4", "--vehicle", "hosted", "--output", "kept", "--json"];
    let weak = mintime(folder.path(), &[&learn[..], &["--plant", "weak.toml"]].concat());
    assert!(!weak.status.success());
    assert_eq!(read(folder.path(), "kept/best.table"), b"of an earlier day");

    // One flight ends too far away to be worth a repeat.
    let output = mintime(folder.path(), &[&learn[..], &["--flights", "1"]].concat());
    let answer = json(&output);
    assert_eq!(answer["flights"].as_array().expect("flights").len(), 1);
    assert!(answer["repeats"].as_array().expect("repeats").is_empty(), "{answer}");
    assert_eq!(read(folder.path(), "kept/best-1.table"), b"of an earlier day");
    assert!(read(folder.path(), "kept/best.table").len() > 50);
}

/// The plane that a history names is believed as far as a campaign turns one, no further.
#[test]
fn a_learned_table_flies_in_the_plane_of_a_credible_history() {
    let folder = tempfile::tempdir().expect("a folder");
    let learn = ["learn", "--to", "3,0", "--vehicle", "hosted", "--repeats", "0", "--output", "kept"];
    assert!(mintime(folder.path(), &learn).status.success());
    let heading_rad = |told: f64| {
        let path = folder.path().join("kept/history.json");
        let mut history: serde_json::Value =
            serde_json::from_slice(&std::fs::read(&path).expect("a history")).expect("JSON");
        history["heading_rad"] = told.into();
        std::fs::write(&path, history.to_string()).expect("writable");
        let fly = ["fly", "--table", "kept/best.table", "--vehicle", "hosted", "--json"];
        json(&mintime(folder.path(), &fly))["maneuver"]["heading_rad"].as_f64().expect("a number")
    };
    assert_eq!(heading_rad(0.0), 0.0);
    let own = heading_rad(2.0);
    assert!(own != 2.0 && own != 0.0 && own.abs() < 0.1, "{own}");
}

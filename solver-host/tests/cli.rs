//! The command as a person or a script uses it.

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

fn json(output: &Output) -> Value {
    serde_json::from_slice(&output.stdout)
        .unwrap_or_else(|e| panic!("{e}: {}", String::from_utf8_lossy(&output.stdout)))
}

fn assert_success(output: &Output) {
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
}

/// The refusal: exit status, one sentence on stderr, no files.
fn refusal(arguments: &[&str]) -> String {
    let folder = tempfile::tempdir().expect("a folder");
    let output = mintime(folder.path(), arguments);
    assert!(!output.status.success(), "{arguments:?} succeeded");
    let written = std::fs::read_dir(folder.path()).expect("readable").count();
    assert_eq!(written, 0, "{arguments:?} left files");
    let text = String::from_utf8(output.stderr).expect("text");
    assert!(!text.contains("panicked"), "{arguments:?}: {text}");
    text
}

#[test]
fn fly_json_has_the_fields_of_the_interface() {
    let folder = tempfile::tempdir().expect("a folder");
    let output = mintime(folder.path(), &["fly", "--to", "5,5", "--json"]);
    assert_success(&output);
    let answer = json(&output);
    let at = |path: &str| answer.pointer(path).unwrap_or_else(|| panic!("no {path}")).clone();
    assert!((at("/maneuver/duration_s").as_f64().expect("a number") - 1.41122).abs() < 1e-5);
    assert_eq!(at("/maneuver/turns"), 0);
    assert!(at("/maneuver/table_bytes").as_u64().expect("a count") <= 128);
    assert_eq!(at("/maneuver/verified"), true);
    assert_eq!(at("/vehicle/kind"), "hosted");
    assert_eq!(at("/vehicle/firmware_version"), env!("CARGO_PKG_VERSION"));
    assert_eq!(at("/vehicle/protocol_version"), 1);
    assert_eq!(at("/flight/outcome"), "completed");
    assert_eq!(at("/flight/abort_reason"), Value::Null);
    assert!(at("/flight/ticks").as_u64().expect("a count") > 1100);
    assert_eq!(at("/flight/missed_ticks"), 0);
    assert!((at("/flight/flown_duration_s").as_f64().expect("a number") - 1.41122).abs() < 1e-4);
    for error in ["start_error", "final_error"] {
        for field in ["x_m", "vx_mps", "z_m", "vz_mps", "theta_rad", "pitch_rate_radps"] {
            assert!(at(&format!("/flight/{error}/{field}")).is_f64(), "{error}.{field}");
        }
    }
    assert!(at("/virtual_time_s").as_f64() > Some(5.0));
    assert!(at("/wall_time_s").is_f64());
    assert_eq!((at("/log"), at("/report")), ("flight.mcap".into(), "flight.svg".into()));
    for file in ["flight.mcap", "flight.svg"] {
        assert!(folder.path().join(file).is_file(), "{file}");
    }
}

#[test]
fn one_seed_gives_one_log_byte_by_byte_and_another_seed_another() {
    let folder = tempfile::tempdir().expect("a folder");
    let fly = |seed: &str, log: &str| {
        let arguments = ["fly", "--to", "0,3", "--seed", seed, "--log", log, "--report", "r.png"];
        assert_success(&mintime(folder.path(), &arguments));
        std::fs::read(folder.path().join(log)).expect("a log")
    };
    let first = fly("3", "a.mcap");
    assert!(first == fly("3", "b.mcap"), "two flights of one seed differ");
    assert!(first != fly("4", "c.mcap"), "two seeds give one flight");
    assert!(std::fs::read(folder.path().join("r.png")).expect("a picture").starts_with(b"\x89PNG"));
}

#[test]
fn a_saved_table_flies_again_and_a_damaged_one_does_not() {
    let folder = tempfile::tempdir().expect("a folder");
    let saved = ["fly", "--to", "-3,4", "--plant", "ideal", "--save-table", "t.bin"];
    assert_success(&mintime(folder.path(), &saved));
    let output = mintime(folder.path(), &["fly", "--table", "t.bin", "--plant", "ideal", "--json"]);
    assert_success(&output);
    assert_eq!(json(&output).pointer("/maneuver/verified"), Some(&Value::Bool(false)));

    let mut bytes = std::fs::read(folder.path().join("t.bin")).expect("a table");
    bytes[40] ^= 1;
    std::fs::write(folder.path().join("t.bin"), &bytes).expect("writable");
    let output = mintime(folder.path(), &["fly", "--table", "t.bin", "--json"]);
    assert!(!output.status.success());
    assert!(json(&output)["error"].as_str().expect("a sentence").contains("corrupt"));
    let output = mintime(folder.path(), &["fly", "--table", "missing.bin"]);
    assert!(String::from_utf8_lossy(&output.stderr).contains("missing.bin"));
}

#[test]
fn bad_input_is_refused_in_one_sentence_before_anything_moves() {
    let cases: [(&[&str], &str); 17] = [
        (&["fly", "--to", "nan,5"], "not finite"),
        (&["fly", "--to", "5,inf"], "not finite"),
        (&["fly", "--to", "5"], "2 numbers"),
        (&["fly", "--to", "five,5"], "not a number"),
        (&["fly", "--to", "5,5", "--thrust-per-mass", "9.81,20"], "cannot hover"),
        (&["fly", "--to", "5,5", "--thrust-per-mass", "1,9"], "cannot hover"),
        (&["fly", "--to", "5,5", "--thrust-per-mass", "20,1"], "below the maximum"),
        (&["fly", "--to", "5,5", "--thrust-per-mass", "-1,20"], "above zero"),
        (&["fly", "--to", "5,5", "--thrust-per-mass", "1,80"], "more thrust"),
        (&["fly", "--to", "5,5", "--max-body-rate", "0"], "above zero"),
        (&["fly", "--to", "5,5", "--max-body-rate", "-3"], "above zero"),
        (&["fly", "--to", "0,0"], "T = 0"),
        (&["fly", "--to", "5,5", "--room", "-1,9,-4,9"], "behind"),
        (&["fly", "--to", "5,5", "--room", "nan,9,-4,9"], "not finite"),
        (&["fly", "--to", "5,5", "--plant", "no-such.toml"], "no-such.toml"),
        (&["fly", "--to", "5,5", "--log", "no/such/folder.mcap"], "no/such"),
        (&["fly", "--to", "5,5", "--report", "picture.gif"], ".svg"),
    ];
    for (arguments, expected) in cases {
        let text = refusal(arguments);
        assert!(text.contains(expected), "{arguments:?}: {text}");
    }
}

#[test]
fn the_help_names_every_option_with_its_unit() {
    let folder = tempfile::tempdir().expect("a folder");
    let text = String::from_utf8(mintime(folder.path(), &["fly", "--help"]).stdout).expect("text");
    for word in
        ["--to", "--seed", "--vehicle", "--plant", "--room", "--log", "--report", "--json", "m/s²", "rad/s"]
    {
        assert!(text.contains(word), "{word} missing");
    }
}

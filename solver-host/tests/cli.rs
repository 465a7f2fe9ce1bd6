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
    assert_eq!(at("/vehicle/kind"), "virtual");
    assert_eq!(at("/vehicle/image_sha256").as_str().expect("a text").len(), 64);
    assert!(at("/vehicle/image_path").as_str().expect("a text").ends_with("mintime-firmware"));
    for size in ["flash_bytes", "ram_bytes"] {
        assert!(at(&format!("/vehicle/{size}")).as_u64().expect("a count") > 10_000, "{size}");
    }
    for errors in ["motor_errors", "gyro_errors"] {
        assert!(at(&format!("/flight/{errors}")).is_u64(), "{errors}");
    }
    assert_eq!(at("/vehicle/firmware_version"), env!("CARGO_PKG_VERSION"));
    assert_eq!(at("/vehicle/protocol_version"), mintime_shared::messages::PROTOCOL_VERSION);
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
    for (field, least, most) in
        [("real_time_factor", 0.1, 1e3), ("tick_instructions", 1e3, 2e4), ("load", 0.02, 0.15)]
    {
        let value = at(&format!("/flight/{field}")).as_f64().expect("a number");
        assert!((least..most).contains(&value), "{field}: {value}");
    }
    for field in ["latency_us", "jitter_us"] {
        let pair = at(&format!("/flight/{field}"));
        let [optimistic, pessimistic] = [0, 1].map(|i| pair[i].as_f64().expect("a number"));
        assert!(optimistic >= 0.0 && pessimistic < 120.0, "{field}: {pair}");
    }
    assert_eq!(at("/flight/firmware_bugs"), serde_json::json!([]));
    assert!(at("/virtual_time_s").as_f64() > Some(5.0));
    assert!(at("/wall_time_s").is_f64());
    assert_eq!((at("/log"), at("/report")), ("flight.mcap".into(), "flight.svg".into()));
    assert_eq!(at("/page"), "flight.html");
    for file in ["flight.mcap", "flight.svg", "flight.html"] {
        assert!(folder.path().join(file).is_file(), "{file}");
    }
}

#[test]
fn one_seed_gives_one_log_byte_by_byte_and_another_seed_another() {
    let folder = tempfile::tempdir().expect("a folder");
    let fly = |seed: &str, log: &str| {
        let arguments = ["fly", "--vehicle", "hosted", "--to", "0,3", "--seed", seed, "--log", log];
        assert_success(&mintime(folder.path(), &[&arguments[..], &["--report", "r.png"]].concat()));
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
    let saved = ["fly", "--vehicle", "hosted", "--to", "-3,4", "--plant", "ideal", "--save-table", "t.bin"];
    assert_success(&mintime(folder.path(), &saved));
    let output = mintime(
        folder.path(),
        &["fly", "--vehicle", "hosted", "--table", "t.bin", "--plant", "ideal", "--json"],
    );
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
    let cases: [(&[&str], &str); 23] = [
        (&["fly", "--to", "nan,5"], "not finite"),
        (&["fly", "--to", "5,inf"], "not finite"),
        (&["fly", "--to", "5"], "or 2: ahead and up"),
        (&["fly", "--to", "five,5"], "not a number"),
        (&["fly", "--to", "5,5", "--thrust-per-mass", "9.81,20"], "cannot hover"),
        (&["fly", "--to", "5,5", "--thrust-per-mass", "1,9"], "cannot hover"),
        (&["fly", "--to", "5,5", "--thrust-per-mass", "20,1"], "below the maximum"),
        (&["fly", "--to", "5,5", "--thrust-per-mass", "-1,20"], "above zero"),
        (&["fly", "--to", "5,5", "--thrust-per-mass", "1,80"], "plan within its limits"),
        (&["fly", "--to", "5,5", "--max-body-rate", "0"], "above zero"),
        (&["fly", "--to", "5,5", "--max-body-rate", "-3"], "above zero"),
        (&["fly", "--to", "0,0"], "T = 0"),
        (&["fly", "--to", "5,5", "--room", "-1,9,-4,9"], "behind"),
        (&["fly", "--to", "5,5", "--room", "nan,9,-4,9"], "not finite"),
        (&["fly", "--to", "5,5", "--plant", "no-such.toml"], "no-such.toml"),
        (&["fly", "--to", "5,5", "--log", "no/such/folder.mcap"], "no/such"),
        (&["fly", "--to", "5,5", "--report", "picture.gif"], ".svg"),
        (&["fly", "--to", "5,5", "--log", "a.svg", "--report", "./a.svg"], "two outputs"),
        (&["fly", "--to", "5,5", "--firmware", "no-such.elf"], "no-such.elf"),
        (&["fly", "--to", "5,5", "--firmware", "."], "cargo firmware"),
        (&["fly", "--to", "5,5", "--vehicle", "hosted", "--firmware", "x.elf"], "no image"),
        (&["virtual-board", "--firmware", "no-such.elf"], "no-such.elf"),
        (&["virtual-board", "--seconds", "-1"], "positive"),
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

#[test]
fn solve_json_has_the_fields_of_the_interface() {
    let folder = tempfile::tempdir().expect("a folder");
    let arguments = ["solve", "--from", "0,3,0,-1,0.5", "--to", "4,1", "--json", "-o", "m.table"];
    let output = mintime(folder.path(), &arguments);
    assert_success(&output);
    let answer = json(&output);
    let at = |path: &str| answer.pointer(path).unwrap_or_else(|| panic!("no {path}")).clone();
    assert!((at("/duration_s").as_f64().expect("a number") - 0.920_986_637_638_280_3).abs() < 1e-9);
    assert_eq!(at("/turns"), 0);
    assert_eq!(at("/segments/1/rate"), "singular");
    assert_eq!(at("/segments/5/thrust"), "min");
    assert!(at("/segments/0/duration_s").is_f64());
    assert_eq!(at("/costate").as_array().expect("a list").len(), 4);
    for field in
        ["hamiltonian", "control_law", "kelley", "singular_rate_max", "min_segment_s", "lower_bound_s"]
    {
        assert!(at(&format!("/certificate/{field}")).is_f64(), "{field}");
    }
    assert_eq!((at("/certificate/verified"), at("/certificate/degenerate")), (true.into(), false.into()));
    assert_eq!(at("/certificate/final_state_error").as_array().expect("a list").len(), 5);
    assert!(at("/alternatives").is_array());
    assert!(at("/solve_time_s").is_f64());
    let length = std::fs::metadata(folder.path().join("m.table")).expect("a table").len();
    assert_eq!(at("/table_bytes"), length);
}

/// Every winding that could have won is told, fastest first; the durations are those of an independent solver.
#[test]
fn the_windings_that_lost_are_told() {
    let folder = tempfile::tempdir().expect("a folder");
    let alternatives = |arguments: &[&str]| {
        let output = mintime(folder.path(), arguments);
        assert_success(&output);
        let list = json(&output)["alternatives"].as_array().expect("a list").clone();
        let pair =
            |a: &Value| (a["turns"].as_i64().expect("turns"), a["duration_s"].as_f64().expect("a number"));
        list.iter().map(pair).collect::<Vec<_>>()
    };
    let found = alternatives(&["solve", "--to", "5,5", "--json"]);
    assert_eq!(found.iter().map(|a| a.0).collect::<Vec<_>>(), [1, -1, 2, -2]);
    assert!((found[0].1 - 1.467_593_165_8).abs() < 1e-9 && (found[1].1 - 1.582_428_571_3).abs() < 1e-9);
    // A mirror image ties; a flip is hardly slower than none.
    let found = alternatives(&["solve", "--to", "0,3", "--json"]);
    assert_eq!(found.iter().map(|a| a.0).collect::<Vec<_>>(), [-1, 0]);
    assert_eq!(alternatives(&["solve", "--to", "5,5", "--turns", "1", "--json"]), []);
}

#[test]
fn a_trajectory_begins_at_the_start_and_ends_at_the_end() {
    let folder = tempfile::tempdir().expect("a folder");
    let arguments = ["solve", "--to", "-3,4", "--trajectory", "t.csv", "--sample-hz", "333"];
    assert_success(&mintime(folder.path(), &arguments));
    let text = std::fs::read_to_string(folder.path().join("t.csv")).expect("a file");
    let mut lines = text.lines();
    assert_eq!(lines.next(), Some("t_s,x_m,vx_mps,z_m,vz_mps,theta_rad,rate_radps,thrust_mps2,phi_r,phi_t"));
    let rows: Vec<Vec<f64>> =
        lines.map(|l| l.split(',').map(|v| v.parse().expect("a number")).collect()).collect();
    let (first, last) = (&rows[0], &rows[rows.len() - 1]);
    assert!(first[..6].iter().all(|v| *v == 0.0));
    assert!((last[1] + 3.0).abs() < 1e-9 && (last[3] - 4.0).abs() < 1e-9, "{last:?}");
    assert!(rows.windows(2).all(|w| w[0][0] < w[1][0]), "time runs forwards");
    // The control laws (16) and (20), sample by sample.
    for row in &rows {
        let (rate, thrust, phi_r, phi_t) = (row[6], row[7], row[8], row[9]);
        assert!(rate * phi_r <= 1e-9 && (thrust - 10.5) * phi_t <= 1e-9, "{row:?}");
    }
}

#[test]
fn a_batch_is_answered_line_by_line_in_order() {
    let folder = tempfile::tempdir().expect("a folder");
    let line = |name: &str, to: &str, extra: &str| {
        format!(
            r#"{{"name":"{name}","from":[0,0,0,0,0],"to":{to},"thrust":[1,20],"rate":10,"gravity":9.81{extra}}}"#
        )
    };
    let good = [
        line("a", "[5,0,5,0,0]", ""),
        line("b", "[0,0,4,0,0]", r#","turns":-1"#),
        line("same", "[0,0,0,0,0]", ""),
        line("c", "[3,0,0,0,0]", r#","turns":null"#),
    ];
    std::fs::write(folder.path().join("good.jsonl"), good.join("\n")).expect("writable");
    let output = mintime(folder.path(), &["solve", "--batch", "good.jsonl", "-o", "answers.jsonl"]);
    assert_success(&output);
    let text = std::fs::read_to_string(folder.path().join("answers.jsonl")).expect("answers");
    let answers: Vec<Value> = text.lines().map(|l| serde_json::from_str(l).expect("JSON")).collect();
    let names: Vec<_> = answers.iter().map(|a| a["name"].as_str().expect("a name")).collect();
    assert_eq!(names, ["a", "b", "same", "c"]);
    assert_eq!(answers[1]["turns"], -1);
    assert_eq!(answers[2]["duration_s"], 0.0);
    assert!((answers[3]["duration_s"].as_f64().expect("a number") - 0.898_702_917_9).abs() < 1e-9);

    let bad = [
        line("a", "[5,0,5,0,0]", ""),
        "{".to_owned(),
        line("n", "[5,0,5,0]", ""),
        line("x", "[1,0,1,0,0]", r#","turn":1"#),
        line("t", "[1,0,1,0,0]", r#","turns":0.5"#),
        r#"{"name":"cut","from":[0,0"#.to_owned(),
    ];
    std::fs::write(folder.path().join("bad.jsonl"), bad.join("\n")).expect("writable");
    let output = mintime(folder.path(), &["solve", "--batch", "bad.jsonl"]);
    assert!(!output.status.success());
    let text = String::from_utf8(output.stdout).expect("text");
    let answers: Vec<Value> = text.lines().map(|l| serde_json::from_str(l).expect("JSON")).collect();
    assert_eq!(answers.len(), 6);
    assert!(answers[0]["duration_s"].is_f64());
    for (i, name) in [(1, "line 2"), (2, "n"), (3, "x"), (4, "t"), (5, "cut")] {
        assert_eq!(answers[i]["name"], name);
        assert!(
            answers[i]["error"].as_str().expect("a sentence").contains("not a request"),
            "{}",
            answers[i]
        );
        assert_eq!(answers[i]["error"].to_string().matches("line ").count(), 1, "{}", answers[i]);
    }
    let turns = answers[4]["error"].to_string();
    assert!(turns.contains("a whole number or") && !turns.contains("untagged"), "{turns}");
}

#[test]
fn nothing_to_fly_says_which_winding_it_is() {
    let folder = tempfile::tempdir().expect("a folder");
    let full = "0,0,0,0,6.283185307179586";
    let output = mintime(folder.path(), &["solve", "--to", full, "--json"]);
    let answer: Value = serde_json::from_slice(&output.stdout).expect("JSON");
    assert_eq!((&answer["duration_s"], &answer["turns"]), (&Value::from(0.0), &Value::from(-1)));
    let output = mintime(folder.path(), &["solve", "--to", full, "--turns", "0", "--json"]);
    let flip: Value = serde_json::from_slice(&output.stdout).expect("JSON");
    assert!(flip["duration_s"].as_f64().is_some_and(|t| t > 0.9), "{flip}");
}

#[test]
fn tables_are_shown_and_verified() {
    let folder = tempfile::tempdir().expect("a folder");
    for (to, turns) in [("5,5", "any"), ("0,4", "any"), ("15,0", "any"), ("0,0", "1"), ("1,-2", "-1")] {
        assert_success(&mintime(folder.path(), &["solve", "--to", to, "--turns", turns, "-o", "m.table"]));
        let output = mintime(folder.path(), &["show", "m.table", "--json"]);
        assert_success(&output);
        assert_eq!(json(&output)["kind"], "extremal");
        let output = mintime(folder.path(), &["verify", "m.table", "--json"]);
        assert_success(&output);
        assert_eq!(json(&output)["verified"], true, "{to}");
    }
    std::fs::write(folder.path().join("noise"), [7; 100]).expect("writable");
    for command in ["show", "verify"] {
        let output = mintime(folder.path(), &[command, "noise"]);
        assert!(!output.status.success());
        assert!(String::from_utf8_lossy(&output.stderr).contains("corrupt"));
    }
}

#[test]
fn sweeps_write_a_line_for_every_point() {
    let folder = tempfile::tempdir().expect("a folder");
    let lines = |arguments: &[&str]| {
        let output = mintime(folder.path(), arguments);
        assert_success(&output);
        String::from_utf8(output.stdout).expect("text").lines().map(str::to_owned).collect::<Vec<_>>()
    };
    let horizontal = lines(&["sweep", "horizontal"]);
    assert_eq!(horizontal.len(), 151);
    assert!(horizontal[150].starts_with("15,0,1.8958423"), "{}", horizontal[150]);
    let vertical = lines(&["sweep", "vertical", "--range", "-1,1,0.5"]);
    assert_eq!(vertical.len(), 6);
    assert_eq!(vertical[3], "0,0,0,0,,");
    assert_eq!(lines(&["sweep", "map", "--points", "7,5"]).len(), 36);
    let text = refusal(&["sweep", "map", "--points", "0,5"]);
    assert!(text.contains("--points"), "{text}");
    let text = refusal(&["sweep", "horizontal", "--range", "1,2,-1"]);
    assert!(text.contains("--range"), "{text}");
}

#[test]
fn solve_refuses_bad_input_in_one_sentence() {
    let cases: [(&[&str], &str); 8] = [
        (&["solve", "--to", "1,2,3"], "numbers separated by commas"),
        (&["solve", "--to", "nan,2"], "not finite"),
        (&["solve", "--to", "5,5", "--gravity", "0"], "gravity"),
        (&["solve", "--to", "5,5", "--thrust-per-mass", "5,4"], "below the maximum"),
        (&["solve", "--to", "5,5", "--turns", "99"], "turns"),
        (&["solve", "--to", "5,5", "--sample-hz", "0"], "above zero"),
        (&["solve", "--to", "0,0", "-o", "x.table"], "no table"),
        (&["solve", "--batch", "none.jsonl"], "none.jsonl"),
    ];
    for (arguments, expected) in cases {
        let text = refusal(arguments);
        assert!(text.contains(expected), "{arguments:?}: {text}");
    }
}

#[test]
fn a_table_for_another_gravity_is_not_flown() {
    let folder = tempfile::tempdir().expect("a folder");
    let moon = ["solve", "--gravity", "1.62", "--to", "5,5", "--thrust-per-mass", "1,20", "-o", "moon.table"];
    assert_success(&mintime(folder.path(), &moon));
    let output = mintime(folder.path(), &["fly", "--table", "moon.table"]);
    assert!(!output.status.success());
    assert!(String::from_utf8_lossy(&output.stderr).contains("gravity"));
}

/// `mintime ... | head` is no error.
#[test]
fn a_closed_pipe_is_no_panic() {
    use std::process::Stdio;
    let mut child = Command::new(env!("CARGO_BIN_EXE_mintime"))
        .args(["sweep", "horizontal"])
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("it starts");
    drop(child.stdout.take());
    let output = child.wait_with_output().expect("it ends");
    assert!(!String::from_utf8_lossy(&output.stderr).contains("panicked"));
}

/// A vehicle that cannot sink still has fastest maneuvers; only a table for it there is not.
#[test]
fn limits_that_cannot_hover_are_solved_but_not_packed() {
    let folder = tempfile::tempdir().expect("a folder");
    let climb = ["solve", "--to", "0,0,1,3,0", "--thrust-per-mass", "12,20", "--json"];
    let output = mintime(folder.path(), &climb);
    assert_success(&output);
    assert_eq!(
        (&json(&output)["certificate"]["verified"], &json(&output)["table_bytes"]),
        (&true.into(), &0.into())
    );
    let text = refusal(&["solve", "--to", "0,0,1,3,0", "--thrust-per-mass", "12,20", "-o", "t.table"]);
    assert!(text.contains("cannot hover"), "{text}");
}

/// Straight up at full thrust: one singular arc, its costate not unique, as fast as the lower bound.
#[test]
fn a_straight_push_is_its_own_lower_bound() {
    let folder = tempfile::tempdir().expect("a folder");
    let output =
        mintime(folder.path(), &["solve", "--to", "0,0,1.27375,5.095,0", "--json", "-o", "up.table"]);
    assert_success(&output);
    let answer = json(&output);
    let certificate = &answer["certificate"];
    assert!((answer["duration_s"].as_f64().expect("a number") - 0.5).abs() < 1e-12);
    assert!((certificate["lower_bound_s"].as_f64().expect("a number") - 0.5).abs() < 1e-6);
    assert_eq!((&certificate["verified"], &certificate["degenerate"]), (&true.into(), &true.into()));
    assert_success(&mintime(folder.path(), &["verify", "up.table"]));
}

/// A serial program talks to the virtual vehicle through the pseudo-terminal.
#[cfg(unix)]
#[test]
fn the_virtual_board_answers_on_a_serial_port() {
    use std::io::{BufRead as _, BufReader, Read as _, Write as _};
    use std::time::Instant;

    use mintime::flight::{Client, Connection, ConnectionError, Phase, Pose};
    use mintime_shared::messages::{Reply, Request};

    struct SerialPort(std::fs::File);

    impl Connection for SerialPort {
        fn next_pose(&mut self) -> Result<Pose, ConnectionError> {
            Err(ConnectionError::NoPose)
        }

        fn send(&mut self, bytes: &[u8]) -> Result<(), ConnectionError> {
            Ok(self.0.write_all(bytes)?)
        }

        fn receive(&mut self, into: &mut Vec<u8>) -> Result<(), ConnectionError> {
            // Telemetry comes all the time, so this does not wait long.
            let mut bytes = [0; 256];
            let count = self.0.read(&mut bytes)?;
            into.extend_from_slice(&bytes[..count]);
            Ok(())
        }

        fn enter(&mut self, _: Phase) {}
    }

    let folder = tempfile::tempdir().expect("a folder");
    let link = folder.path().join("vehicle");
    // Left behind by a board that was killed: it leads nowhere.
    std::os::unix::fs::symlink(folder.path().join("gone"), &link).expect("a link");
    let mut board = std::process::Command::new(env!("CARGO_BIN_EXE_mintime"))
        .args(["virtual-board", "--seconds", "20", "--link"])
        .arg(&link)
        .stdout(std::process::Stdio::piped())
        .spawn()
        .expect("the command");
    let mut line = String::new();
    BufReader::new(board.stdout.take().expect("piped")).read_line(&mut line).expect("a line");
    assert_eq!(line.trim(), format!("serial port {}", link.display()));

    let mut port = SerialPort(std::fs::File::options().read(true).write(true).open(&link).expect("a port"));
    let mut client = Client::default();
    let begun = Instant::now();
    client.ask(&mut port, Request::Identify, 0.0).expect("sent");
    let answer = loop {
        let now_s = begun.elapsed().as_secs_f64();
        assert!(now_s < 15.0, "no answer");
        if let Some(reply) = client.poll(&mut port, now_s).expect("a line that works") {
            break reply;
        }
    };
    let refused = |link: &std::path::Path| {
        let link = link.to_str().expect("a name");
        let output = mintime(folder.path(), &["virtual-board", "--seconds", "1", "--link", link]);
        assert!(!output.status.success());
        String::from_utf8(output.stderr).expect("text")
    };
    assert!(refused(&link).contains("is used by another virtual board"));
    assert!(refused(&folder.path().join("no/vehicle")).contains("does not exist"));
    board.kill().expect("running");
    board.wait().expect("ended");
    assert!(
        matches!(answer, Reply::Identity(identity) if identity.firmware_version == [0, 1, 0]),
        "{answer:?}"
    );
}

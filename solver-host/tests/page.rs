//! The page that `mintime fly` writes: what it says is what was flown, and no flight is lost where it cannot be written.

use std::path::Path;
use std::process::{Command, Output};

use serde_json::Value;

fn fly(folder: &Path, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_mintime"))
        .args(["fly", "--vehicle", "hosted", "--to", "3,2"])
        .args(arguments)
        .current_dir(folder)
        .output()
        .expect("it starts")
}

fn page(folder: &Path, file: &str) -> (String, Value) {
    let text = std::fs::read_to_string(folder.join(file)).expect("a page");
    let (_, rest) = text.split_once(r#"<script type="application/json" id="data">"#).expect("data");
    let data = serde_json::from_str(rest.split_once("</script>").expect("an end").0).expect("JSON");
    (text, data)
}

/// A column of the page's data: base64, read by hand.
fn column(data: &Value, path: &str) -> Vec<f32> {
    let text = data.pointer(path).and_then(Value::as_str).unwrap_or_else(|| panic!("no {path}"));
    let digit = |c: u8| match c {
        b'A'..=b'Z' => u32::from(c - b'A'),
        b'a'..=b'z' => u32::from(c - b'a') + 26,
        b'0'..=b'9' => u32::from(c - b'0') + 52,
        b'+' => 62,
        b'/' => 63,
        _ => panic!("{c} is no digit"),
    };
    let digits: Vec<u32> = text.bytes().filter(|c| *c != b'=').map(digit).collect();
    let bytes: Vec<u8> = digits
        .chunks(4)
        .flat_map(|four| {
            let word = four.iter().fold(0, |word, d| word << 6 | d) << (6 * (4 - four.len()));
            word.to_be_bytes()[1..four.len()].to_vec()
        })
        .collect();
    bytes.as_chunks::<4>().0.iter().map(|b| f32::from_le_bytes(*b)).collect()
}

fn at(times: &[f32], values: &[f32], t: f32) -> f32 {
    let after = times.partition_point(|s| *s < t).clamp(1, times.len() - 1);
    let part = (t - times[after - 1]) / (times[after] - times[after - 1]);
    values[after - 1] + (values[after] - values[after - 1]) * part
}

/// A key number of the page.
fn fact(data: &Value, label: &str) -> Option<String> {
    let facts = data["facts"].as_array().expect("a list");
    let found = facts.iter().find(|fact| fact["label"] == label)?;
    Some(found["value"].as_str().expect("text").to_owned())
}

/// The greatest speed that a page's curves show while its maneuver lasted, m/s, with two decimals as its key numbers.
fn peak_speed(data: &Value, source: &str) -> String {
    let [t, vx, vz] = ["t", "vx", "vz"].map(|name| column(data, &format!("/{source}/{name}")));
    let duration_s = data["duration_s"].as_f64().expect("T") as f32;
    let during = t.iter().zip(vx.iter().zip(&vz)).filter(|(t, _)| (0.0..=duration_s).contains(*t));
    format!("{:.2} m/s", during.map(|(_, (vx, vz))| vx.hypot(*vz)).fold(0.0, f32::max))
}

#[test]
fn the_page_says_what_was_flown() {
    let folder = tempfile::tempdir().expect("a folder");
    let output = fly(folder.path(), &["--json"]);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let answer: Value = serde_json::from_slice(&output.stdout).expect("JSON");
    assert_eq!(answer["page"], "flight.html");
    let (text, data) = page(folder.path(), "flight.html");
    assert!(text.len() < 1_500_000);
    assert_eq!(data["success"], true);
    let duration_s = answer.pointer("/maneuver/duration_s").and_then(Value::as_f64).expect("T");
    assert_eq!(data["duration_s"].as_f64(), Some(duration_s));

    // The end error that the command prints, from the page's curves.
    let t = duration_s as f32;
    for (name, field) in
        [("x", "x_m"), ("vx", "vx_mps"), ("z", "z_m"), ("vz", "vz_mps"), ("theta", "theta_rad")]
    {
        let times = column(&data, "/flight/t");
        let flown = at(&times, &column(&data, &format!("/flight/{name}")), t);
        let planned = *column(&data, &format!("/plan/{name}")).last().expect("samples");
        let error = answer
            .pointer(&format!("/flight/final_error/{field}"))
            .and_then(Value::as_f64)
            .expect("a number");
        // Samples are 1.25 ms apart; the end lies between two.
        assert!(
            (f64::from(flown - planned) - error).abs() < 2e-3,
            "{name}: {flown} − {planned}, not {error}"
        );
    }
    assert_eq!(fact(&data, "peak speed, planned"), Some(peak_speed(&data, "plan")));
    assert_eq!(fact(&data, "peak speed, flown"), None);
    let pitch_rad =
        answer.pointer("/flight/final_error/theta_rad").and_then(Value::as_f64).expect("a number");
    assert_eq!(fact(&data, "end error, pitch"), Some(format!("{:.4} rad", pitch_rad.abs())));
    // Cameras see what truth is, with their noise.
    let (times, seen) = (column(&data, "/cameras/t"), column(&data, "/cameras/x"));
    let (true_times, true_x) = (column(&data, "/flight/t"), column(&data, "/flight/x"));
    for (t, x) in times.iter().zip(&seen).filter(|(t, _)| (0.0..1.0).contains(*t)) {
        assert!((x - at(&true_times, &true_x, *t)).abs() < 0.02, "at {t} s");
    }
    // The record is the vehicle's own, tick by tick at 800 Hz.
    let ticks = answer.pointer("/flight/ticks").and_then(Value::as_u64).expect("a count");
    let times = column(&data, "/record/t");
    assert_eq!(times.len() as u64, ticks);
    assert!((f64::from(*times.last().expect("ticks")) - duration_s).abs() < 5e-3);
    // All numbers stand there without a script, too.
    for number in ["verified", "Hamiltonian", "control ticks missed", "taking off", "CRC-32"] {
        assert!(text.contains(number), "{number}");
    }
}

#[test]
fn the_page_of_what_was_learned_has_every_flight() {
    let folder = tempfile::tempdir().expect("a folder");
    let output = Command::new(env!("CARGO_BIN_EXE_mintime"))
        .args(["learn", "--to", "2,1", "--vehicle", "hosted", "--flights", "4", "--repeats", "1", "--json"])
        .args(["-o", "learned"])
        .current_dir(folder.path())
        .output()
        .expect("it starts");
    let answer: Value = serde_json::from_slice(&output.stdout).expect("JSON");
    assert_eq!(answer["page"], "learned/learning.html", "{answer:#}");
    let (_, data) = page(folder.path(), "learned/learning.html");
    let flown = ["flights", "repeats"].map(|key| answer[key].as_array().expect("a list").clone()).concat();
    let shown = data.pointer("/learning/flights").and_then(Value::as_array).expect("a list");
    assert_eq!(shown.len(), flown.len());
    for (shown, flown) in shown.iter().zip(&flown) {
        let part = |key: &str| {
            flown.pointer(&format!("/final_error/{key}")).and_then(Value::as_f64).expect("a number")
        };
        let expected =
            [part("x_m").hypot(part("z_m")), part("vx_mps").hypot(part("vz_mps")), part("theta_rad").abs()];
        let errors: Vec<f64> = serde_json::from_value(shown["errors"].clone()).expect("numbers");
        assert!(
            errors.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-12),
            "{errors:?}, not {expected:?}"
        );
    }
    // What the model would do in the plan's stead is no speed of this maneuver.
    assert_eq!(fact(&data, "peak speed, planned"), None);
    assert_eq!(fact(&data, "peak speed, flown"), Some(peak_speed(&data, "flight")));
    // The flight that is shown is the last one: one flight, from its beginning to its end.
    assert_eq!(data["success"], true);
    let texts: Vec<_> =
        data["events"].as_array().expect("a list").iter().map(|e| e["text"].clone()).collect();
    assert_eq!(texts.iter().filter(|t| *t == "taking off").count(), 1, "{texts:?}");
    assert!(column(&data, "/flight/t").is_sorted());
}

#[test]
fn a_page_that_is_none_is_refused_before_anything_flies() {
    let folder = tempfile::tempdir().expect("a folder");
    for (arguments, word) in [
        (["--page", "flight.pdf"], ".html"),
        (["--page", "none/flight.html"], "does not exist"),
        (["--page", "flight.svg.html/"], "does not exist"),
    ] {
        let output = fly(folder.path(), &arguments);
        assert!(!output.status.success());
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(said.contains(word), "{said}");
    }
    let output = fly(folder.path(), &["--page", "one.html", "--log", "one.html"]);
    assert!(String::from_utf8_lossy(&output.stderr).contains("two outputs"));
    assert_eq!(std::fs::read_dir(folder.path()).expect("readable").count(), 0);
}

/// A disk that is full for large files: the picture still fits.
#[cfg(unix)]
#[test]
fn a_full_disk_takes_the_page_and_not_the_flight() {
    let folder = tempfile::tempdir().expect("a folder");
    std::fs::write(folder.path().join("flight.html"), "the page before").expect("writable");
    let output = Command::new("sh")
        .args(["-c", "ulimit -f 128; exec \"$0\" fly --vehicle hosted --to 3,2 --json"])
        .arg(env!("CARGO_BIN_EXE_mintime"))
        .current_dir(folder.path())
        .output()
        .expect("it starts");
    assert!(!output.status.success());
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(said.contains("flight.html could not be written"), "{said}");
    let answer: Value = serde_json::from_slice(&output.stdout).expect("what was flown, all the same");
    assert_eq!(answer.pointer("/flight/outcome"), Some(&Value::from("completed")));
    assert_eq!((&answer["page"], &answer["report"]), (&Value::Null, &Value::from("flight.svg")));
    let before = std::fs::read_to_string(folder.path().join("flight.html")).expect("still there");
    assert_eq!(before, "the page before");
    let left: Vec<_> =
        std::fs::read_dir(folder.path()).expect("readable").flatten().map(|e| e.file_name()).collect();
    assert_eq!(left.len(), 2, "{left:?}");
}

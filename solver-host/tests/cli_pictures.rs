//! `mintime figures` and `mintime design` as a person or a script uses them.

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
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    serde_json::from_slice(&output.stdout).expect("JSON")
}

/// The sentence of a refusal.
fn refusal(folder: &Path, arguments: &[&str]) -> String {
    let output = mintime(folder, arguments);
    assert!(!output.status.success(), "{arguments:?} succeeded");
    let text = String::from_utf8(output.stderr).expect("text");
    assert!(!text.contains("panicked"), "{arguments:?}: {text}");
    text
}

#[test]
fn figures_are_written_into_a_new_folder_and_over_old_ones() {
    let folder = tempfile::tempdir().expect("a folder");
    let arguments = ["figures", "-o", "a/new/folder", "--only", "table1,fig6", "--json"];
    let answer = json(&mintime(folder.path(), &arguments));
    let figures = answer["figures"].as_array().expect("figures");
    let names: Vec<&str> = figures.iter().filter_map(|f| f["name"].as_str()).collect();
    assert_eq!(names, ["table1", "fig6"]);
    let t = &figures[1]["numbers"][0];
    assert_eq!((t["what"].as_str(), t["unit"].as_str()), (Some("T ="), Some("s")));
    assert!((t["value"].as_f64().expect("a number") - 1.411_220_050_3).abs() < 1e-9);
    let new = folder.path().join("a/new/folder");
    for name in ["table1.svg", "table1.png", "table1.csv", "fig6.svg", "fig6.png", "fig6.csv"] {
        assert!(std::fs::metadata(new.join(name)).expect("a file").len() > 300, "{name}");
    }
    let once = std::fs::read(new.join("fig6.csv")).expect("a file");
    std::fs::write(new.join("fig6.csv"), "old").expect("writable");
    assert!(mintime(folder.path(), &["figures", "-o", "a/new/folder", "--only", "fig6"]).status.success());
    assert!(std::fs::read(new.join("fig6.csv")).expect("a file") == once);
    assert_eq!(std::fs::read_dir(&new).expect("readable").count(), 6, "nothing else is left behind");
}

#[test]
fn a_folder_that_cannot_be_written_to_is_refused_before_anything_is_computed() {
    let folder = tempfile::tempdir().expect("a folder");
    std::fs::write(folder.path().join("file"), "").expect("writable");
    assert!(
        refusal(folder.path(), &["figures", "-o", "file"])
            .contains("file is no folder: give the name of one")
    );
    assert!(refusal(folder.path(), &["figures", "-o", "file/below"]).contains("choose another"));
    assert!(refusal(folder.path(), &["figures", "-o", ""]).contains("a value is required"));
    assert!(refusal(folder.path(), &["figures", "-o", "x", "--only", "fig2"]).contains("fig1"));
    // Nobody creates files there, not even the superuser.
    #[cfg(target_os = "linux")]
    assert!(
        refusal(folder.path(), &["figures", "-o", "/proc"])
            .contains("no file can be created in the folder /proc")
    );
}

/// A limit on the size of files fails a write in its middle, as a full disk does.
#[cfg(unix)]
#[test]
fn a_write_that_fails_leaves_the_old_file() {
    let folder = tempfile::tempdir().expect("a folder");
    let old = folder.path().join("table1.png");
    std::fs::write(&old, "old").expect("writable");
    let script = format!("ulimit -f 32; exec {} figures -o . --only table1", env!("CARGO_BIN_EXE_mintime"));
    let output =
        Command::new("sh").args(["-c", &script]).current_dir(folder.path()).output().expect("it starts");
    let text = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(!output.status.success() && text.contains("check the free space of the disk"), "{text}");
    assert_eq!(std::fs::read_to_string(&old).expect("a file"), "old");
    let left: Vec<_> = std::fs::read_dir(folder.path()).expect("readable").flatten().collect();
    assert_eq!(left.len(), 2, "the finished picture and the old one: {left:?}");
}

#[test]
fn design_prints_and_writes_what_it_found() {
    let folder = tempfile::tempdir().expect("a folder");
    let arguments =
        ["design", "--to", "5,5", "--to", "-2,1", "-o", "d.svg", "-o", "d.csv", "-o", "d.png", "--json"];
    let answer = json(&mintime(folder.path(), &arguments));
    let maneuver = &answer["maneuvers"][0];
    assert!((maneuver["duration_s"].as_f64().expect("a number") - 1.411_220_050_3).abs() < 1e-9);
    assert_eq!(maneuver["buys_most"], "max-thrust");
    let curves = maneuver["curves"].as_array().expect("curves");
    assert_eq!(curves.len(), 3);
    for (curve, name) in curves.iter().zip(["max-thrust", "min-thrust", "rate"]) {
        assert_eq!(curve["parameter"], name);
        assert!(
            curve["here"]["elasticity"].is_f64() && curve["points"].as_array().expect("points").len() > 20
        );
    }
    for name in ["d.svg", "d.csv", "d.png"] {
        assert!(std::fs::metadata(folder.path().join(name)).expect("a file").len() > 3000, "{name}");
    }
    let text = mintime(folder.path(), &["design", "--to", "5,5", "--vary", "rate", "--over", "4:20:9"]);
    let text = String::from_utf8(text.stdout).expect("text");
    assert!(
        text.contains("T = 1.411220 s") && text.contains("rate") && !text.contains("max-thrust"),
        "{text}"
    );
}

#[test]
fn design_names_values_that_cannot_fly_and_refuses_vehicles_that_cannot() {
    let folder = tempfile::tempdir().expect("a folder");
    let at = folder.path();
    let output = mintime(at, &["design", "--to", "5,5", "--vary", "max-thrust", "--over", "8:20:13"]);
    assert!(output.status.success());
    let text = String::from_utf8(output.stdout).expect("text");
    assert!(
        text.contains("2 of 13 values of max-thrust have no maneuver") && text.contains("cannot hover"),
        "{text}"
    );

    for (arguments, sentence) in [
        (&["--to", "5,5", "--thrust-per-mass", "10,20"][..], "cannot hover or sink"),
        (&["--to", "5,5", "--thrust-per-mass", "1,9"], "cannot hover: raise it"),
        (&["--to", "0,0"], "nothing to fly"),
        (&["--to", "5,5", "--vary", "rate,max-thrust", "--over", "4:20:9"], "--over is about one limit"),
        (&["--to", "5,5", "--over", "4:20:9"], "--vary"),
        (&["--to", "5,5", "--vary", "rate", "--over", "20:4:9"], "a first value below its last"),
        (&["--to", "5,5", "--vary", "rate", "--over", "4:20"], "like 12:40:57"),
        (&["--to", "5,5", "-o", "d.pdf"], "none of .svg, .png and .csv"),
        (&["--to", "5,5", "-o", "no/d.svg"], "does not exist"),
    ] {
        let text = refusal(at, &[&["design"], arguments].concat());
        assert!(text.contains(sentence), "{arguments:?}: {text}");
    }
    let seven = ["--to", "1,0"].repeat(7);
    assert!(refusal(at, &[&["design"][..], &seven].concat()).contains("one to 6 maneuvers"));
    assert_eq!(std::fs::read_dir(at).expect("readable").count(), 0);
}

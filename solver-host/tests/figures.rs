//! The figures against the reference maneuvers, the closed forms, and the promises of their files.

use std::collections::BTreeMap;
use std::sync::LazyLock;

use mintime::figures::{Drawn, Figure};
use mintime::learning::{ANGLE_TOLERANCE_RAD, POSITION_TOLERANCE_M, VELOCITY_TOLERANCE_MPS};
use mintime::solver::sweep::solve_beside;
use mintime::solver::{Request, solve};
use resvg::tiny_skia::Pixmap;
use resvg::usvg::roxmltree::Document;
use serde::Deserialize;

const CASES: &str = include_str!("../../tests/data/reference_cases.json");

#[derive(Deserialize)]
struct File {
    cases: Vec<Case>,
}

#[derive(Deserialize)]
struct Case {
    name: String,
    #[serde(rename = "xT")]
    end: [f64; 5],
    #[serde(rename = "T_seconds")]
    duration_s: f64,
    segments: Vec<Segment>,
}

#[derive(Deserialize)]
struct Segment {
    #[serde(rename = "u_R")]
    rate: String,
    #[serde(rename = "u_T")]
    thrust: String,
    duration_s: f64,
}

impl Case {
    fn structure(&self, mirrored: bool) -> String {
        let rate = |r: &str| match (r, mirrored) {
            ("+", true) => "-".to_owned(),
            ("-", true) => "+".to_owned(),
            (r, _) => r.to_owned(),
        };
        let words = self.segments.iter().map(|s| format!("{}{}", rate(&s.rate), s.thrust));
        words.collect::<Vec<_>>().join(" ")
    }

    fn switch_times_s(&self) -> Vec<f64> {
        let mut t_s = 0.0;
        let times = self.segments.iter().map(|s| {
            t_s += s.duration_s;
            t_s
        });
        times.collect()
    }
}

/// The reference maneuvers from rest at the origin whose names begin so.
fn cases(prefix: &str) -> Vec<Case> {
    let cases = serde_json::from_str::<File>(CASES).expect("reference data parses").cases;
    let found: Vec<Case> = cases.into_iter().filter(|c| c.name.starts_with(prefix)).collect();
    assert!(!found.is_empty(), "{prefix}");
    found
}

static ALL: LazyLock<Vec<Drawn>> =
    LazyLock::new(|| Figure::ALL.iter().map(|f| f.draw().expect("draws")).collect());

fn drawn(figure: Figure) -> &'static Drawn {
    ALL.iter().find(|d| d.figure() == figure).expect("drawn")
}

type Row = BTreeMap<String, String>;

fn parse(csv: &str) -> Vec<Row> {
    let mut lines = csv.lines();
    let header: Vec<&str> = lines.next().expect("a header").split(',').collect();
    let row = |line: &str| {
        let cells: Vec<&str> = line.split(',').collect();
        assert_eq!(cells.len(), header.len(), "{line}");
        header.iter().zip(cells).map(|(name, cell)| ((*name).to_owned(), cell.to_owned())).collect()
    };
    lines.map(row).collect()
}

fn table(figure: Figure, name: &str) -> Vec<Row> {
    let found = drawn(figure).tables().find(|(own, _)| own == name).expect("a table").1;
    parse(found)
}

fn number(row: &Row, column: &str) -> f64 {
    row[column].parse().unwrap_or_else(|e| panic!("{column}: {} {e}", row[column]))
}

fn times_s(row: &Row) -> Vec<f64> {
    row["switch_times_s"].split(' ').map(|t| t.parse().expect("a time")).collect()
}

/// The row at a displacement.
fn row_at<'a>(rows: &'a [Row], place: &[(&str, f64)]) -> &'a Row {
    let near = |row: &&Row| place.iter().all(|(column, at)| (number(row, column) - at).abs() < 1e-9);
    rows.iter().find(near).unwrap_or_else(|| panic!("no row at {place:?}"))
}

fn assert_agrees(case: &Case, row: &Row) {
    let t_s = number(row, "duration_s");
    assert!((t_s / case.duration_s - 1.0).abs() < 1e-6, "{}: {t_s}", case.name);
    let own = &row["structure"];
    assert!([case.structure(false), case.structure(true)].contains(own), "{}: {own}", case.name);
    for (ours, theirs) in times_s(row).into_iter().zip(case.switch_times_s()) {
        assert!((ours - theirs).abs() < 1e-6, "{}: {ours} against {theirs}", case.name);
    }
}

#[test]
fn fig_3_and_4_agree_with_the_reference() {
    let rows = table(Figure::Fig3, "fig3");
    for case in cases("horizontal_") {
        assert_agrees(&case, row_at(&rows, &[("x_m", case.end[0])]));
    }
    let paths = table(Figure::Fig4, "fig4");
    for case in cases("horizontal_").iter().filter(|c| [3.0, 9.0, 15.0].contains(&c.end[0])) {
        let own = paths.iter().rfind(|r| number(r, "x_to_m") == case.end[0]).expect("a path");
        assert!((number(own, "t_s") / case.duration_s - 1.0).abs() < 1e-6, "{}", case.name);
        assert!((number(own, "x_m") - case.end[0]).abs() < 1e-9 && number(own, "z_m").abs() < 1e-9);
    }
}

#[test]
fn fig_5_and_1_agree_with_the_reference() {
    let rows = table(Figure::Fig5, "fig5");
    for case in cases("vertical_").iter().filter(|c| c.end[2] > 0.0) {
        assert_agrees(case, row_at(&rows, &[("z_m", case.end[2])]));
    }
    let paths = table(Figure::Fig1, "fig1");
    for (name, z_m) in [("2 m", 2.0), ("6 m", 6.0)] {
        let case = cases("vertical_").into_iter().find(|c| c.end[2] == z_m).expect("a case");
        let end = paths.iter().rfind(|r| r["maneuver"] == name).expect("a path");
        assert!((number(end, "t_s") / case.duration_s - 1.0).abs() < 1e-6, "{name}");
        assert!((number(end, "z_m") - z_m).abs() < 1e-9 && number(end, "x_m").abs() < 1e-9, "{name}");
    }
}

/// Places where the structure changes from one row to the next: (place, before, after).
fn changes(rows: &[Row], column: &str) -> Vec<f64> {
    rows.windows(2)
        .filter(|pair| pair[0]["structure"] != pair[1]["structure"])
        .map(|pair| {
            let (a, b) = (number(&pair[0], column), number(&pair[1], column));
            assert!(b - a < 1e-3, "a change is found between {a} and {b} only");
            0.5 * (a + b)
        })
        .collect()
}

#[test]
fn structures_change_where_they_should() {
    let horizontal = changes(&table(Figure::Fig3, "fig3"), "x_m");
    assert_eq!(horizontal.len(), 3, "{horizontal:?}");
    for (found, expected) in horizontal.iter().zip([1.423, 2.394, 7.717]) {
        assert!((found - expected).abs() < 1e-3, "{found} against {expected}");
    }
    let vertical = changes(&table(Figure::Fig5, "fig5"), "z_m");
    for expected in [2.955_44, 6.267_4] {
        assert!(vertical.iter().any(|z| (z - expected).abs() < 2e-4), "{vertical:?} lacks {expected}");
    }
}

/// The paper's own branch of the verticals: the closed form, slower than the optimum everywhere, and faster than the flip
/// up to just above 2.5 m, where the paper lets the flip begin.
#[test]
fn fig_5_shows_both_branches() {
    let (up, down): (f64, f64) = (20.0 - 9.81, 9.81 - 1.0);
    for row in table(Figure::Fig5, "fig5") {
        let (z_m, t_s, level_s) =
            (number(&row, "z_m"), number(&row, "duration_s"), number(&row, "level_as_in_paper_s"));
        assert!((level_s - (2.0 * z_m * (up + down) / (up * down)).sqrt()).abs() < 1e-12);
        assert!(t_s < level_s, "{z_m} m");
        let (none_s, one_s) = (number(&row, "without_turn_s"), number(&row, "with_one_turn_s"));
        assert!((t_s - none_s.min(one_s)).abs() < 1e-9, "{z_m} m: {t_s} of {none_s}, {one_s}");
        if (z_m - 2.955_44).abs() > 1e-4 {
            assert_eq!(row["turns"] == "0", z_m < 2.955_44, "{z_m} m");
        }
        assert_eq!(level_s < one_s, z_m < 2.508, "{z_m} m");
    }
}

#[test]
fn fig_6_obeys_the_control_laws() {
    let rows = table(Figure::Fig6, "fig6");
    for row in &rows {
        let (rate, thrust) = (number(row, "rate_radps"), number(row, "thrust_mps2"));
        let (phi_r, phi_t) = (number(row, "phi_r"), number(row, "phi_t"));
        if phi_r.abs() > 1e-5 {
            assert!((rate + 10.0 * phi_r.signum()).abs() < 1e-9, "{row:?}");
        }
        if phi_t.abs() > 1e-5 {
            assert!((thrust - if phi_t < 0.0 { 20.0 } else { 1.0 }).abs() < 1e-9, "{row:?}");
        }
    }
    let case = cases("general_5_5").remove(0);
    let end = rows.last().expect("rows");
    assert!((number(end, "t_s") / case.duration_s - 1.0).abs() < 1e-6);
    for (column, wanted) in [("x_m", 5.0), ("vx_mps", 0.0), ("z_m", 5.0), ("vz_mps", 0.0), ("theta_rad", 0.0)]
    {
        assert!((number(end, column) - wanted).abs() < 1e-8, "{column}");
    }
    // Both sides of every switch are there.
    for t_s in &case.switch_times_s()[..case.segments.len() - 1] {
        assert_eq!(rows.iter().filter(|r| (number(r, "t_s") - t_s).abs() < 1e-7).count(), 2, "{t_s}");
    }
}

/// Before learning it comes near, no more; learned it ends where it was planned to end, as near as learning promises.
#[test]
fn fig_7_is_the_same_maneuver_flown() {
    let rows = table(Figure::Fig7, "fig7");
    let of = |which: &str| -> Vec<&Row> { rows.iter().filter(|r| r["which"] == which).collect() };
    let at = |rows: &[&Row], t_s: f64, column: &str| {
        let after = rows.partition_point(|r| number(r, "t_s") < t_s);
        let (a, b) = (rows[after - 1], rows[after]);
        let part = (t_s - number(a, "t_s")) / (number(b, "t_s") - number(a, "t_s"));
        number(a, column) + part * (number(b, column) - number(a, column))
    };
    let place =
        |rows: &[&Row], t_s: f64, to: f64| (at(rows, t_s, "x_m") - to).hypot(at(rows, t_s, "z_m") - to);
    let speed = |rows: &[&Row], t_s: f64| at(rows, t_s, "vx_mps").hypot(at(rows, t_s, "vz_mps"));
    let (planned, unlearned, learned) = (of("planned"), of("unlearned"), of("learned"));
    let end = planned.last().expect("a plan");
    assert!((number(end, "x_m") - 5.0).abs() < 1e-8 && (number(end, "z_m") - 5.0).abs() < 1e-8);
    for flown in [&unlearned, &learned] {
        assert!(place(flown, 0.0, 0.0) < 0.01 && speed(flown, 0.0) < 0.05);
    }
    let quoted =
        |what: &str| drawn(Figure::Fig7).numbers().iter().find(|n| n.what == what).expect(what).value;
    let (planned_s, learned_s) = (quoted("planned T ="), quoted("learned T ="));
    assert!((number(end, "t_s") - planned_s).abs() < 1e-9);
    assert!(learned_s > planned_s && learned_s < 1.04 * planned_s, "{learned_s}");
    let miss_m = place(&unlearned, planned_s, 5.0);
    assert!((0.1..2.0).contains(&miss_m), "{miss_m} m");
    assert!((miss_m - quoted("first flight, position error at T")).abs() < 2e-3, "{miss_m}");
    let (miss_m, miss_mps) = (place(&learned, learned_s, 5.0), speed(&learned, learned_s));
    assert!(miss_m < POSITION_TOLERANCE_M, "{miss_m} m");
    assert!(miss_mps < VELOCITY_TOLERANCE_MPS, "{miss_mps} m/s");
    assert!(at(&learned, learned_s, "theta_rad").abs() < ANGLE_TOLERANCE_RAD);
    assert!((miss_m - quoted("learned flight, position error at T")).abs() < 2e-3, "{miss_m}");
    assert!((1.0..=10.0).contains(&quoted("flights that taught:")));
}

#[test]
fn the_map_agrees_with_the_reference_and_with_its_mirror_images() {
    let rows = table(Figure::Map, "map");
    for (name, place) in [("general_5_5", (5.0, 5.0)), ("general_2_3", (2.0, 3.0))] {
        let case = cases(name).remove(0);
        assert_agrees(&case, row_at(&rows, &[("x_m", place.0), ("z_m", place.1)]));
    }
    // Below the start: the same duration, flown backwards.
    for (name, place) in [("general_1_-2", (1.0, 2.0)), ("general_10_-5", (10.0, 5.0))] {
        let case = cases(name).remove(0);
        let row = row_at(&rows, &[("x_m", place.0), ("z_m", place.1)]);
        assert!((number(row, "duration_s") / case.duration_s - 1.0).abs() < 1e-6, "{name}");
    }
    for row in rows.iter().step_by(311) {
        let (x, z, t_s) = (number(row, "x_m"), number(row, "z_m"), number(row, "duration_s"));
        for (x, z) in [(-x, z), (x, -z), (-x, -z)] {
            let mirrored = solve(&Request::rest_to_rest(x, z)).expect("solves").extremal.duration_s();
            assert!((mirrored / t_s - 1.0).abs() < 1e-9, "({x}, {z}): {mirrored} against {t_s}");
        }
    }
}

/// A point whose fastest maneuver was missed would stand above its neighbours.
#[test]
fn the_map_has_no_wrong_points() {
    let rows = table(Figure::Map, "map");
    let (columns, lines) = (151, 101);
    let t_s = |i: usize, j: usize| number(&rows[j * columns + i], "duration_s");
    for j in 1..lines - 1 {
        for i in 1..columns - 1 {
            let here = t_s(i, j);
            // A minimum of smooth branches has kinks that bend down, never up.
            for (before, after) in [(t_s(i - 1, j), t_s(i + 1, j)), (t_s(i, j - 1), t_s(i, j + 1))] {
                let bend = before + after - 2.0 * here;
                // A branch bends up by its lines of equal T, about circles: less far out.
                let radius_m = 0.1 * (i as f64).hypot(j as f64);
                assert!(bend < 6e-3 / radius_m.powf(1.5), "({i}, {j}): T bends up by {bend} s");
            }
        }
    }
}

/// Lines of the map stand where maneuvers solved from cold change their structure.
#[test]
fn the_structure_changes_across_the_maps_lines() {
    let rows = table(Figure::Map, "map-borders");
    let near = |place: (f64, f64)| {
        rows.iter().any(|r| (number(r, "x_m") - place.0).hypot(number(r, "z_m") - place.1) < 1e-3)
    };
    for place in [(7.7167, 0.0), (0.0, 2.9554), (0.0, 6.2674)] {
        assert!(near(place), "no line ends at {place:?}");
    }
    let on_grid = |v: f64, step: f64| (v / step - (v / step).round()).abs() < 1e-9;
    let (mut tried, mut agreed) = (0, 0);
    for row in rows.iter().step_by(11) {
        let (x, z) = (number(row, "x_m"), number(row, "z_m"));
        // Points on vertical grid lines of the whole chart were found by going up along them.
        if x < 0.5 || !on_grid(x, 0.1) || on_grid(z, 0.1) || z < 0.01 {
            continue;
        }
        tried += 1;
        let side = |dz: f64| solve(&Request::rest_to_rest(x, z + dz)).expect("solves").extremal;
        let (below, above) = (side(-5e-3), side(5e-3));
        let above = solve_beside(&below, &Request::rest_to_rest(x, z + 5e-3)).map_or(above, |s| s.extremal);
        let names = [&row["structure_on_one_side"], &row["structure_on_other"]].map(String::clone);
        let found = [below.structure().to_string(), above.structure().to_string()];
        let swapped = [found[1].clone(), found[0].clone()];
        agreed += usize::from(found == names || swapped == names);
    }
    assert!(tried >= 20, "{tried}");
    assert!(agreed as f64 >= 0.9 * f64::from(tried), "{agreed} of {tried}");
}

#[test]
fn tables_are_complete_and_finite() {
    let texts = ["maneuver", "which", "structure", "parameter", "unit", "description", "switch_times_s"];
    for drawn in ALL.iter() {
        for (name, csv) in drawn.tables() {
            let rows = parse(csv);
            assert!(rows.len() >= 8, "{name}");
            for row in &rows {
                for (column, cell) in row {
                    if texts.iter().any(|t| column.starts_with(t)) {
                        assert!(!cell.is_empty() || column == "unit", "{name}: {column}");
                    } else {
                        assert!(number(row, column).is_finite(), "{name}: {column} = {cell}");
                    }
                }
            }
        }
        assert!(drawn.numbers().iter().all(|n| n.value.is_finite()), "{}", drawn.title());
    }
}

#[test]
fn pictures_are_sound_and_not_empty() {
    let folder = tempfile::tempdir().expect("a folder");
    for drawn in ALL.iter() {
        let document = Document::parse(drawn.svg()).expect("XML");
        let root = document.root_element();
        for node in document.descendants() {
            for attribute in node.attributes() {
                let value = attribute.value();
                assert!(!value.contains("NaN") && !value.contains("inf"), "{}={value}", attribute.name());
            }
            let text = node.text().unwrap_or_default();
            assert!(!text.contains("NaN") && !text.contains('?') && !text.contains('…'), "{text}");
        }
        let width = |node: &str| root.attribute(node).expect("a size").parse::<f32>().expect("a number");
        let files = drawn.write(folder.path()).expect("writes");
        assert_eq!(files.len(), 2 + drawn.tables().count());
        let picture = Pixmap::decode_png(&std::fs::read(&files[1]).expect("a file")).expect("a PNG");
        assert!((picture.width() as f32 - 2.0 * width("width")).abs() <= 1.0);
        assert!((picture.height() as f32 - 2.0 * width("height")).abs() <= 1.0);
        let drawn_on = picture.pixels().iter().filter(|p| p.red() < 200).count();
        assert!(drawn_on > picture.pixels().len() / 100, "{}", drawn.title());
    }
}

/// Texts stay on the page: no label begins left of it, above it or below it.
#[test]
fn texts_stay_on_the_page() {
    for drawn in ALL.iter() {
        let document = Document::parse(drawn.svg()).expect("XML");
        let root = document.root_element();
        let size =
            ["width", "height"].map(|n| root.attribute(n).expect("a size").parse::<f64>().expect("a number"));
        for text in document.descendants().filter(|n| n.has_tag_name("text")) {
            let [x, y] =
                ["x", "y"].map(|n| text.attribute(n).expect("a place").parse::<f64>().expect("a number"));
            assert!(
                x >= 0.0 && x <= size[0] && y > 0.0 && y <= size[1],
                "{:?} of {}",
                text.text(),
                drawn.title()
            );
        }
    }
}

#[test]
fn the_same_figure_twice_is_the_same_bytes() {
    for figure in [Figure::Table1, Figure::Fig3, Figure::Fig7] {
        let again = figure.draw().expect("draws");
        assert!(again.svg() == drawn(figure).svg(), "{}", figure.name());
        assert!(again.tables().eq(drawn(figure).tables()), "{}", figure.name());
    }
}

/// What the comparisons above look at is what the command leaves in its folder.
#[test]
fn the_command_writes_all_of_them() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut command = std::process::Command::new(env!("CARGO_BIN_EXE_mintime"));
    let output =
        command.args(["figures", "-o", "figures"]).current_dir(folder.path()).output().expect("it starts");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let read = |name: String| std::fs::read(folder.path().join("figures").join(&name)).expect(&name);
    let mut files = 0;
    for drawn in ALL.iter() {
        let name = drawn.figure().name();
        assert!(read(format!("{name}.svg")) == drawn.svg().as_bytes(), "{name}");
        assert!(read(format!("{name}.png")).starts_with(b"\x89PNG"), "{name}");
        files += 2;
        for (table, csv) in drawn.tables() {
            assert!(read(format!("{table}.csv")) == csv.as_bytes(), "{table}");
            files += 1;
        }
    }
    assert_eq!(std::fs::read_dir(folder.path().join("figures")).expect("a folder").count(), files);
}

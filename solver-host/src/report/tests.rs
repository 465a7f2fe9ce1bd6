//! Pictures are well-formed, complete, the same every time, and survive any data.

mod maneuvers;

use std::fs;
use std::path::PathBuf;

use maneuvers::{DASH, DIAGONAL, FLIP, Maneuver, SHORT};
use mintime_shared::model::{Limits, State};
use proptest::prelude::*;
use resvg::tiny_skia::Pixmap;
use resvg::usvg::roxmltree::{Document, Node};

use super::*;
use crate::drawing::png;

const ALL: [Maneuver; 4] = [DIAGONAL, FLIP, DASH, SHORT];

fn without_flight(maneuver: &Maneuver) -> ReportData {
    ReportData { flown: Vec::new(), ..maneuver.report() }
}

fn of_class<'a>(document: &'a Document<'a>, class: &str) -> Vec<Node<'a, 'a>> {
    document.descendants().filter(|node| node.attribute("class") == Some(class)).collect()
}

fn texts<'a>(node: Node<'a, 'a>) -> Vec<&'a str> {
    node.descendants().filter(|n| n.has_tag_name("text")).filter_map(|n| n.text()).collect()
}

fn number(node: &Node<'_, '_>, name: &str) -> f64 {
    node.attribute(name).unwrap().parse().unwrap()
}

/// Well-formed, drawable, and no number that is none.
fn assert_sound(svg: &str) {
    let document = Document::parse(svg).unwrap();
    for node in document.descendants() {
        for attribute in node.attributes() {
            let value = attribute.value();
            assert!(!value.contains("NaN") && !value.contains("inf"), "{}={value}", attribute.name());
        }
    }
    png::parse(svg).unwrap();
}

#[test]
fn every_picture_has_its_parts() {
    for maneuver in ALL {
        let data = maneuver.report();
        let svg = render(&data);
        assert_sound(&svg);
        let document = Document::parse(&svg).unwrap();
        for class in ["path", "pitch", "rate", "thrust", "position", "facts"] {
            assert_eq!(of_class(&document, class).len(), 1, "{class}");
        }
        let vehicles =
            |class| of_class(&document, class)[0].descendants().filter(|n| n.has_tag_name("use")).count();
        assert!(vehicles("planned-vehicles") >= 8);
        assert_eq!(vehicles("planned-vehicles"), vehicles("flown-vehicles"));
        assert_eq!(of_class(&document, "planned").len(), 5, "pitch, rate, thrust, x and z");
        assert_eq!(of_class(&document, "flown").len(), 5);
        assert_eq!(of_class(&document, "switching").len(), 2);
        let all = texts(document.root_element());
        for text in
            ["start", "end", "hover", "maneuver", "catch", "pitch θ (rad)", "time t (s)", "planned", "flown"]
        {
            assert!(all.contains(&text), "{text}");
        }
        assert!(
            data.facts
                .iter()
                .all(|(label, value)| all.contains(&label.as_str()) && all.contains(&value.as_str()))
        );
    }
}

#[test]
fn segments_and_singular_arcs_are_marked() {
    let svg = render(&without_flight(&DIAGONAL));
    let document = Document::parse(&svg).unwrap();
    assert_eq!(of_class(&document, "singular").len(), 4 * 2, "two arcs in each of four panels");
    let inputs = |class: &str, names: &[&str]| -> Vec<String> {
        let all = texts(of_class(&document, class)[0]);
        all.into_iter().filter(|text| names.contains(text)).map(str::to_owned).collect()
    };
    assert_eq!(inputs("rate", &["+", "−", "s"]), ["+", "s", "−", "s", "+"]);
    assert_eq!(inputs("thrust", &["max", "min"]), ["max", "min"]);
}

#[test]
fn both_axes_of_the_path_have_one_scale() {
    let svg = render(&without_flight(&DIAGONAL));
    let document = Document::parse(&svg).unwrap();
    let ends: Vec<Node<'_, '_>> = document.descendants().filter(|n| n.has_tag_name("circle")).collect();
    let across = number(&ends[1], "cx") - number(&ends[0], "cx");
    let up = number(&ends[0], "cy") - number(&ends[1], "cy");
    assert!((across - up).abs() < 0.05, "5 m across is {across}, 5 m up is {up}");
    assert!(across > 300.0);
}

#[test]
fn a_vehicle_that_flies_off_does_not_shrink_the_plan() {
    let mut data = DIAGONAL.report();
    for sample in &mut data.flown {
        sample.state.z -= 40.0 * sample.t_s.max(0.0).powi(2);
        sample.state.theta += 100.0 * sample.t_s;
    }
    let svg = render(&data);
    assert_sound(&svg);
    let document = Document::parse(&svg).unwrap();
    let ends: Vec<Node<'_, '_>> = document.descendants().filter(|n| n.has_tag_name("circle")).collect();
    assert!(number(&ends[1], "cx") - number(&ends[0], "cx") > 150.0);
}

#[test]
fn samples_that_are_not_finite_are_left_out() {
    let clean = without_flight(&FLIP);
    let mut data = clean.clone();
    let broken = |state: State<f64>, t_s: f64| PlannedSample {
        t_s,
        state,
        rate_radps: f64::NAN,
        thrust_mps2: f64::INFINITY,
        phi_r: f64::NAN,
        phi_t: f64::NAN,
    };
    data.planned.insert(7, broken(State { x: f64::NAN, ..State::origin() }, 0.1));
    data.planned.insert(100, broken(State { z: 1e300, ..State::origin() }, 0.2));
    data.planned.push(broken(State::origin(), f64::NEG_INFINITY));
    assert!(render(&data) == render(&clean));
}

#[test]
fn nothing_planned_or_nothing_flown_is_still_a_picture() {
    let data = DASH.report();
    let flown_only = ReportData { planned: Vec::new(), segments: Vec::new(), ..data.clone() };
    let nothing = ReportData {
        title: String::new(),
        subtitle: Vec::new(),
        planned: Vec::new(),
        flown: Vec::new(),
        segments: Vec::new(),
        facts: Vec::new(),
        ..data
    };
    let hovering = PlannedSample { thrust_mps2: 9.81, ..PlannedSample::default() };
    let one_instant = ReportData { planned: vec![hovering], ..nothing.clone() };
    for data in [flown_only, nothing, one_instant] {
        assert_sound(&render(&data));
    }
}

#[test]
fn texts_are_only_texts() {
    let mut data = without_flight(&SHORT);
    data.title = "<script>&\"'\u{0}\u{1b}]]>".to_owned();
    data.facts = vec![("a".repeat(500), "ä語\u{ffff}".repeat(200))];
    let svg = render(&data);
    assert_sound(&svg);
    let document = Document::parse(&svg).unwrap();
    assert!(!document.descendants().any(|n| n.has_tag_name("script")));
    assert!(texts(document.root_element()).contains(&"<script>&\"']]>"));
}

#[test]
fn switches_are_upright_whatever_the_last_bits_of_their_times() {
    let mut data = without_flight(&SHORT);
    for (i, sample) in data.planned.iter_mut().enumerate() {
        sample.t_s += if i % 2 == 0 { 1e-13 } else { -1e-13 };
    }
    let svg = render(&data);
    let document = Document::parse(&svg).unwrap();
    let thrust = of_class(&document, "thrust")[0];
    let curve = thrust.descendants().find(|n| n.attribute("class") == Some("planned")).unwrap();
    let corners: Vec<Vec<f64>> = curve
        .attribute("points")
        .unwrap()
        .split(' ')
        .map(|point| point.split(',').map(|v| v.parse().unwrap()).collect())
        .collect();
    assert_eq!(corners.len(), 10, "four switches: {corners:?}");
    for pair in corners.windows(2) {
        let steps = (pair[1][0] - pair[0][0], pair[1][1] - pair[0][1]);
        assert!(steps.0.abs() < 0.05 || steps.1.abs() < 0.05, "{pair:?} is oblique");
    }
}

#[test]
fn same_data_same_picture() {
    assert!(render(&DIAGONAL.report()) == render(&DIAGONAL.report()));
    let svg = render(&SHORT.report());
    assert!(png::encode(&svg).unwrap() == png::encode(&svg).unwrap());
}

#[test]
fn a_png_has_its_size_and_its_text() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("flip.PNG");
    let data = FLIP.report();
    write(&data, &path).unwrap();
    let picture = Pixmap::decode_png(&fs::read(&path).unwrap()).unwrap();
    let svg = render(&data);
    let document = Document::parse(&svg).unwrap();
    for (name, pixels) in [("width", picture.width()), ("height", picture.height())] {
        let stated = number(&document.root_element(), name) * f64::from(PNG_SCALE);
        assert!((stated - f64::from(pixels)).abs() <= 1.0, "{name}: {stated} stated, {pixels} pixels");
    }
    let dark = |x0: u32, y0: u32, x1: u32, y1: u32| -> usize {
        (y0..y1)
            .flat_map(|y| (x0..x1).map(move |x| (x, y)))
            .filter(|(x, y)| picture.pixel(*x, *y).is_some_and(|p| p.red() < 100 && p.alpha() == 255))
            .count()
    };
    assert!(dark(56, 40, 1200, 110) > 2000, "the title is drawn though the machine's fonts are not used");
    let drawn =
        picture.pixels().iter().filter(|p| p.red() != 255 || p.green() != 255 || p.blue() != 255).count();
    assert!(drawn > picture.pixels().len() / 50);
}

#[test]
fn the_ending_names_the_format() {
    let folder = tempfile::tempdir().unwrap();
    let data = without_flight(&SHORT);
    let svg = folder.path().join("a.svg");
    check(&svg).unwrap();
    assert!(!svg.exists(), "a check creates nothing");
    write(&data, &svg).unwrap();
    assert!(fs::read_to_string(&svg).unwrap() == render(&data));
    for name in ["report", "report.jpg", "report.svg.gz", ".svg"] {
        let path = folder.path().join(name);
        let error = write(&data, &path).unwrap_err();
        assert!(matches!(error, ReportError::UnknownFormat { .. }));
        assert!(error.to_string().contains(".png"));
        assert_eq!(check(&path).unwrap_err().to_string(), error.to_string());
    }
    let missing = folder.path().join("no/report.svg");
    assert!(matches!(check(&missing), Err(ReportError::Output(OutputError::NoFolder { .. }))));
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
}

#[test]
fn ticks_are_at_nice_numbers() {
    use crate::drawing::axis::{Range, nice_step, tick_label, ticks};
    assert_eq!(nice_step(10.0, 5.0), 2.0);
    assert_eq!(nice_step(0.011, 5.0), 0.005);
    assert_eq!(nice_step(400.0, 5.0), 100.0);
    let labels: Vec<String> =
        ticks(Range { low: -0.21, high: 0.4 }, 0.2).into_iter().map(|v| tick_label(v, 0.2)).collect();
    assert_eq!(labels, ["−0.2", "0", "0.2", "0.4"]);
}

/// Every picture is written, in both formats. To look at them: `MINTIME_REPORT_DIR=/some/folder cargo test -p mintime pictures`.
#[test]
fn all_pictures_are_written() {
    let scratch = tempfile::tempdir().unwrap();
    let folder = std::env::var_os("MINTIME_REPORT_DIR").map_or(scratch.path().to_owned(), PathBuf::from);
    for (maneuver, name) in ALL.into_iter().zip(["diagonal", "flip", "dash", "short"]) {
        for (report, name) in
            [(maneuver.report(), name.to_owned()), (without_flight(&maneuver), format!("{name}-plan"))]
        {
            for ending in ["png", "svg"] {
                let path = folder.join(&name).with_extension(ending);
                write(&report, &path).unwrap();
                assert!(std::fs::metadata(&path).unwrap().len() > 10_000, "{}", path.display());
            }
        }
    }
}

fn any_state() -> impl Strategy<Value = State<f64>> {
    prop_oneof![
        prop::array::uniform5(prop::num::f64::ANY),
        prop::array::uniform5(-20.0..20.0),
        prop::array::uniform5(-1e-9..1e-9),
        prop::array::uniform5(-1e7..1e7),
    ]
    .prop_map(State::from_array)
}

fn any_number() -> impl Strategy<Value = f64> {
    prop_oneof![prop::num::f64::ANY, -3.0..3.0, -1e7..1e7]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn any_data_is_a_picture(
        planned in prop::collection::vec((any_number(), any_state(), prop::array::uniform4(any_number())), 0..12),
        flown in prop::collection::vec((any_number(), any_state(), any_number(), "\\PC{0,6}"), 0..12),
        limits in prop::array::uniform4(any_number()),
        durations in prop::collection::vec(any_number(), 0..6),
        title in any::<String>(),
        facts in 0_usize..30,
    ) {
        let [thrust_min_mps2, thrust_max_mps2, rate_max_radps, gravity_mps2] = limits;
        let mut segments = DIAGONAL.segments();
        for (segment, duration) in segments.iter_mut().zip(durations) {
            segment.duration = duration;
        }
        let data = ReportData {
            title,
            subtitle: Vec::new(),
            planned: planned
                .into_iter()
                .map(|(t_s, state, [rate_radps, thrust_mps2, phi_r, phi_t])| {
                    PlannedSample { t_s, state, rate_radps, thrust_mps2, phi_r, phi_t }
                })
                .collect(),
            flown: flown
                .into_iter()
                .map(|(t_s, state, rate_radps, phase)| {
                    FlownSample { t_s, state, rate_radps, thrust_mps2: rate_radps, phase }
                })
                .collect(),
            segments,
            limits: Limits { thrust_min_mps2, thrust_max_mps2, rate_max_radps, gravity_mps2 },
            facts: vec![("label".to_owned(), "value".to_owned()); facts],
        };
        assert_sound(&render(&data));
    }
}

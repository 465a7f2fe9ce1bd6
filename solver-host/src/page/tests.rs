use mintime_shared::model::{Inputs, Limits, RateMode, Segment, State, ThrustLevel};
use mintime_shared::table::MAX_TABLE_BYTES;
use serde_json::Value;

use super::bytes::GROUPS;
use super::*;
use crate::flight_log::PlannedSample;
use crate::pack::pack;
use crate::solver::{Request, Solution, solve, verify};

/// A table, its bytes and what stands behind it.
fn packed() -> (TableBytes, Vec<u8>, Solution, mintime_shared::table::ManeuverTable) {
    let solution = solve(&Request::rest_to_rest(5.0, 5.0)).expect("solvable");
    let table = pack(&solution.extremal, 0x1234_5678, 0.25).expect("it fits");
    let mut buffer = [0; MAX_TABLE_BYTES];
    let length = table.encode(&mut buffer).expect("room");
    let bytes = buffer[..length].to_vec();
    (TableBytes::new(&table, &bytes), bytes, solution, table)
}

fn column(n: usize, step: f64) -> Column {
    (0..n).map(|i| (i as f64 * step).sin()).collect()
}

/// A page with so many samples of each kind.
fn page_of(planned: usize, flown: usize, seen: usize, recorded: usize) -> Page {
    let (table, _, solution, _) = packed();
    let samples: Vec<PlannedSample> =
        (0..planned).map(|i| PlannedSample { t_s: i as f64 * 1.25e-3, ..PlannedSample::default() }).collect();
    let many = |n| column(n, 1.0e-3);
    Page {
        title: "Minimum-time maneuver to x = 5 m, z = 5 m".to_owned(),
        subtitle: vec!["T = 1.4112 s; flown on the virtual vehicle: completed".to_owned()],
        outcome: "completed".to_owned(),
        reason: None,
        success: true,
        began: true,
        flown_is: "true",
        facts: vec![Fact::new("duration T", "1.4112 s")],
        duration_s: 1.4112,
        limits: Limits::TABLE_I,
        origin: "extremal",
        target: State::at_rest(5.0, 5.0),
        segments: vec![Segment {
            inputs: Inputs { rate: RateMode::Plus, thrust: ThrustLevel::Max },
            duration: 1.4112,
        }],
        plan: PlanSeries::new(&samples),
        flight: FlightSeries {
            t: many(flown),
            x: many(flown),
            z: many(flown),
            vx: many(flown),
            vz: many(flown),
            theta: many(flown),
            rate: Some(many(flown)),
            thrust: Some(many(flown)),
            gyro: Some(many(flown)),
            rate_command: Some(many(flown)),
            thrust_command: Some(many(flown)),
            motors: Some([many(flown), many(flown), many(flown), many(flown)]),
            battery: Some(many(flown)),
        },
        cameras: Some(CameraSeries { t: many(seen), x: many(seen), z: many(seen) }),
        record: Some(RecordSeries {
            t: many(recorded),
            gyro: many(recorded),
            rate_command: many(recorded),
            thrust_command: many(recorded),
            motors: [many(recorded), many(recorded), many(recorded), many(recorded)],
        }),
        phases: vec![Span { name: "maneuver".to_owned(), from_s: 0.0, to_s: 1.4112 }],
        events: vec![Moment { t_s: 0.0, text: "flying the maneuver".to_owned(), kind: Kind::Info }],
        certificate: Some(Laws::of(&solution)),
        table,
        timings: vec![Timing {
            label: "gyro to motors",
            range: [98.0, 98.3],
            unit: "µs",
            digits: 1,
            emulated: true,
            meaning: "latency",
        }],
        counters: vec![Counter { label: "control ticks missed", count: 0, of: 1148 }],
        identity: vec![Fact::new("mintime", "0.1.0")],
        learning: None,
    }
}

fn data(text: &str) -> Value {
    let (_, rest) = text.split_once(r#"<script type="application/json" id="data">"#).expect("data");
    serde_json::from_str(rest.split_once("</script>").expect("an end").0).expect("JSON")
}

#[test]
fn nothing_that_comes_from_outside_becomes_markup_or_script() {
    let evil =
        "</script><script>alert(1)</script><!-- <img src=x onerror=alert(2)> & \"quoted\" 'too' {{data}}";
    let mut page = page_of(10, 10, 10, 10);
    page.title = evil.to_owned();
    page.subtitle = vec![evil.to_owned()];
    page.outcome = evil.to_owned();
    page.reason = Some(evil.to_owned());
    page.facts = vec![Fact::new(evil, evil)];
    page.identity = vec![Fact::new(evil, evil)];
    page.events[0].text = evil.to_owned();
    page.phases[0].name = evil.to_owned();
    page.learning = Some(Learning {
        components: vec![Component { name: evil.to_owned(), unit: evil.to_owned(), tolerance: 0.05 }],
        flights: vec![LearningFlight {
            label: evil.to_owned(),
            errors: vec![0.01],
            duration_s: 1.4,
            note: evil.to_owned(),
        }],
        verdict: evil.to_owned(),
    });
    let text = render(&page);
    let count = |part: &str| text.matches(part).count();
    // The theme, the data, the script: no other.
    assert_eq!((count("<script"), count("</script")), (3, 3));
    assert_eq!(count("<img"), 0);
    assert_eq!(count("<!--"), 0);
    let back = data(&text);
    assert_eq!(back["title"], evil);
    assert_eq!(back["events"][0]["text"], evil);
    assert_eq!(back["learning"]["flights"][0]["note"], evil);
}

#[test]
fn the_page_loads_nothing_and_runs_only_its_own_scripts() {
    let text = render(&page_of(100, 100, 100, 100));
    let addresses: Vec<_> =
        text.match_indices("://").map(|(at, _)| &text[at.saturating_sub(5)..at + 25]).collect();
    assert!(addresses.iter().all(|a| a.contains("http://www.w3.org/2000/svg")), "{addresses:?}");
    for loading in
        [" src=", "@import", "url(http", "fetch(", "XMLHttpRequest", "WebSocket", "import(", "<link"]
    {
        assert!(!text.contains(loading), "{loading}");
    }
    let links: Vec<_> = text.match_indices("href=\"").map(|(at, _)| &text[at + 6..at + 7]).collect();
    assert!(!links.is_empty() && links.iter().all(|first| *first == "#"));
    // The policy names exactly the scripts that stand there.
    assert!(text.contains("default-src 'none'"));
    for part in text.split("<script>").skip(1) {
        let script = part.split_once("</script>").expect("an end").0;
        assert!(text.contains(&source(script)), "a script that the policy does not name");
    }
    assert_eq!(text.matches("'sha256-").count(), 2);
}

#[test]
fn numbers_that_are_not_finite_are_null_in_json_and_a_dash_for_people() {
    let mut page = page_of(10, 10, 10, 10);
    page.timings[0].range = [f64::NAN, 98.3];
    page.duration_s = f64::INFINITY;
    let text = render(&page);
    let back = data(&text);
    assert_eq!(back["timings"][0]["range"][0], Value::Null);
    assert_eq!(back["duration_s"], Value::Null);
    assert!(text.contains("[–, 98.3] µs"));
    // In a column NaN stands for them, and one that has nothing else is left out.
    let column: Column = [1.0, f64::NEG_INFINITY, 1.0e300, -2.5].into_iter().collect();
    let bits: Vec<_> = column.values().iter().map(|v| v.is_finite()).collect();
    assert_eq!(bits, [true, false, false, true]);
    assert_eq!([f64::NAN; 3].into_iter().collect::<Column>().if_any(), None);
}

#[test]
fn a_column_is_its_numbers_little_endian_in_base64() {
    let column: Column = [0.0, 1.0, -2.5].into_iter().collect();
    assert_eq!(serde_json::to_string(&column).expect("serialisable"), "\"AAAAAAAAgD8AACDA\"");
}

#[test]
fn the_longest_flight_stays_within_a_megabyte_and_a_half() {
    // A maneuver of 10 s at 800 Hz, 30 s around it at 100 Hz, cameras at 200 Hz, a full record.
    let text = render(&page_of(8001, 8400 + 3000, 8000, 3276));
    assert!(text.len() < 1_500_000, "{} bytes", text.len());
    assert!(!text.contains("{{"), "a placeholder is left");
}

#[test]
fn a_thinned_plan_keeps_both_its_ends() {
    let samples: Vec<PlannedSample> = (0..8001)
        .map(|i| PlannedSample { t_s: f64::from(i) * 1.25e-3, ..PlannedSample::default() })
        .collect();
    let plan = PlanSeries::new(&samples);
    assert!(plan.t.values().len() <= 3001);
    assert_eq!(plan.t.values().first(), Some(&0.0));
    assert_eq!(plan.t.values().last(), Some(&10.0));
}

#[test]
fn the_fields_cover_the_table_and_say_what_it_says() {
    let (explained, bytes, _, table) = packed();
    let mut at = 0;
    for field in &explained.fields {
        assert_eq!(field.offset, at, "{}", field.name);
        assert!(field.length > 0 && field.group < GROUPS.len());
        at += field.length;
    }
    assert_eq!(at, bytes.len());
    assert_eq!(explained.hex.len(), 2 * bytes.len());
    let value = |name: &str| {
        let field = explained.fields.iter().find(|f| f.name == name);
        field.unwrap_or_else(|| panic!("no {name}")).value.clone()
    };
    assert_eq!(value("vehicle"), "12345678");
    assert_eq!(value("checksum"), format!("{:08x}", table.checksum()));
    assert_eq!(value("highest thrust"), "20 m/s²");
    assert_eq!(value("heading"), "0.25 rad");
    assert_eq!(value("end: x"), "5 m");
    assert_eq!(value("segments"), table.segments().len().to_string());
    let arcs = table.arcs.expect("this one has arcs");
    assert_eq!(value("arcs: peak"), format!("{} s", arcs.peak_s));
    for (i, segment) in table.segments().enumerate() {
        assert_eq!(value(&format!("segment {}: duration", i + 1)), format!("{} s", segment.duration));
    }
}

#[test]
fn a_table_without_arcs_is_covered_too() {
    let request = Request { to: State::at_rest(0.0, 2.0), ..Request::rest_to_rest(0.0, 2.0) };
    let solution = solve(&request).expect("solvable");
    let table = pack(&solution.extremal, 0, 0.0).expect("it fits");
    let mut buffer = [0; MAX_TABLE_BYTES];
    let length = table.encode(&mut buffer).expect("room");
    let explained = TableBytes::new(&table, &buffer[..length]);
    let last = explained.fields.last().expect("fields");
    assert_eq!(last.offset + last.length, length);
    assert_eq!(explained.fields.iter().any(|f| f.name == "arcs: width"), table.arcs.is_some());
    assert_eq!(explained.fields[1].value, "any vehicle");
}

#[test]
fn the_laws_hold_exactly_where_the_certificate_says_so() {
    for (x, z) in [(5.0, 5.0), (0.0, 3.0), (-3.0, 4.0), (8.0, 0.0)] {
        let solution = solve(&Request::rest_to_rest(x, z)).expect("solvable");
        let laws = Laws::of(&solution);
        assert!(laws.verified);
        assert!(laws.laws.iter().all(|law| law.holds), "{laws:?}");

        // Wrong costate: the motion arrives, the principle does not hold.
        let mut wrong = solution.clone();
        wrong.extremal.costate.c1 *= 1.01;
        wrong.certificate = verify(&wrong.extremal);
        // Wrong duration: it does not arrive.
        let mut short = solution.clone();
        short.extremal.segments[0].duration *= 0.99;
        short.certificate = verify(&short.extremal);
        for broken in [wrong, short] {
            let laws = Laws::of(&broken);
            assert!(!laws.verified);
            assert!(laws.laws.iter().any(|law| !law.holds), "{laws:?}");
        }
    }
}

#[test]
fn numbers_for_people_keep_four_digits() {
    for (value, text) in [
        (0.0, "0"),
        (-0.046_604_355, "−0.04660"),
        (1.411_220, "1.411"),
        (12345.6, "12346"),
        (1.07e-14, "1.07·10⁻¹⁴"),
        (-2.5e7, "−2.50·10⁷"),
        (f64::NAN, "–"),
    ] {
        assert_eq!(html::number(value), text);
    }
}

#[test]
fn only_a_page_is_written_to_and_only_as_a_whole() {
    let folder = tempfile::tempdir().expect("a folder");
    let page = page_of(10, 10, 10, 10);
    let error = write(&page, &folder.path().join("flight.pdf")).expect_err("no page");
    assert!(error.to_string().contains(".html"), "{error}");
    let error = write(&page, &folder.path().join("none/flight.html")).expect_err("no folder");
    assert!(error.to_string().contains("does not exist"), "{error}");
    let path = folder.path().join("flight.html");
    write(&page, &path).expect("writable");
    assert_eq!(std::fs::read_to_string(&path).expect("a page"), render(&page));
    assert_eq!(std::fs::read_dir(folder.path()).expect("readable").count(), 1);
}

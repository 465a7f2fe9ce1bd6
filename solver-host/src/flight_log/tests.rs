//! A written log is read back with an independent reader; paths that cannot be written are refused, and say why.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use mintime_shared::model::State;
use proptest::prelude::*;
use serde_json::Value;

use super::*;

const START_NS: u64 = 2_000_000_000;

fn small_flight() -> FlightLog {
    let state = |x| State { x, vx: 0.5, z: 1.0, vz: -0.25, theta: 0.1 };
    let truth = |x: f64| Truth {
        position_m: [x, 0.01, 1.0],
        velocity_mps: [0.5, 0.0, -0.25],
        attitude_wxyz: [0.8, 0.0, 0.6, 0.0],
        body_rates_radps: [0.0, 3.0, 0.0],
        thrust_mps2: 19.5,
        planar: state(x),
    };
    let sample = |i: u64| FlightSample {
        time_ns: START_NS + i * 1_250_000,
        phase: if i < 3 { "hover" } else { "maneuver" }.to_owned(),
        truth: truth(i as f64),
        gyro_radps: (i != 4).then_some([0.125, -0.1, 0.0]),
        setpoint_radps: [0.0, 10.0, 0.0],
        setpoint_thrust_mps2: 20.0,
        throttle: [0.1, 0.2, 0.3, 0.4],
        battery_v: 11.5,
        mocap: i.is_multiple_of(2).then_some(MocapSample {
            captured_ns: START_NS,
            position_m: [1.0, 2.0, 3.0],
            attitude_wxyz: [1.0, 0.0, 0.0, 0.0],
        }),
    };
    FlightLog {
        header: LogHeader {
            mintime_version: "1.2.3".to_owned(),
            seed: 7,
            plant: "nominal".to_owned(),
            vehicle: "hosted".to_owned(),
            from: State::origin(),
            to: State::at_rest(5.0, 5.0),
            duration_s: 1.4112,
            turns: -1,
            table: vec![0x00, 0xab, 0xff],
            maneuver_start_ns: Some(START_NS),
            facts: vec![("heading_deg".to_owned(), "90".to_owned())],
        },
        planned: (0..4)
            .map(|i| PlannedSample {
                t_s: f64::from(i) * 1e-3,
                state: state(0.0),
                rate_radps: 10.0,
                thrust_mps2: 1.0,
                phi_r: -0.5,
                phi_t: if i == 0 { f64::NAN } else { 0.25 },
            })
            .collect(),
        samples: (0..10).map(sample).collect(),
        events: vec![
            LogEvent { time_ns: 0, text: "armed".to_owned(), level: EventLevel::Info },
            LogEvent { time_ns: START_NS, text: "triggered \"now\"".to_owned(), level: EventLevel::Warning },
        ],
        record: vec![
            RecordSample { t_us: 0, gyro_radps: [0.0, 0.5, 0.0], ..RecordSample::default() },
            RecordSample { t_us: 1250, commanded_thrust_mps2: 20.0, ..RecordSample::default() },
        ],
    }
}

/// Every message as (topic, log time, JSON), in the order of the file.
fn read(bytes: &[u8]) -> Vec<(String, u64, Value)> {
    mcap::MessageStream::new(bytes)
        .unwrap()
        .map(|message| {
            let message = message.unwrap();
            assert_eq!(message.channel.message_encoding, "json");
            let schema = message.channel.schema.clone().unwrap();
            assert_eq!(schema.encoding, "jsonschema");
            let schema: Value = serde_json::from_slice(&schema.data).unwrap();
            let value: Value = serde_json::from_slice(&message.data).unwrap();
            assert_fits(&schema, &value);
            (message.channel.topic.clone(), message.log_time, value)
        })
        .collect()
}

/// The part of JSON schema that the log uses: required properties, their types, nothing that is not described.
fn assert_fits(schema: &Value, value: &Value) {
    match schema["type"].as_str() {
        Some("object") => {
            let properties = schema["properties"].as_object().unwrap();
            let value = value.as_object().unwrap();
            for name in schema["required"].as_array().into_iter().flatten() {
                assert!(value.contains_key(name.as_str().unwrap()), "{name} is missing in {value:?}");
            }
            for (name, part) in value {
                assert_fits(properties.get(name).unwrap_or_else(|| panic!("{name} is in no schema")), part);
            }
        }
        Some("array") => {
            value.as_array().unwrap().iter().for_each(|item| assert_fits(&schema["items"], item));
        }
        Some("number") => assert!(value.is_number() || value.is_null(), "{value} is no number"),
        Some("integer") => assert!(value.is_u64(), "{value} is no integer"),
        Some("string") => assert!(value.is_string(), "{value} is no string"),
        _ => assert!(schema["oneOf"].as_array().unwrap().iter().any(|one| one["const"] == *value)),
    }
}

#[test]
fn what_is_written_can_be_read() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("flight.mcap");
    let log = small_flight();
    write_mcap(&log, &path).unwrap();
    let bytes = fs::read(&path).unwrap();
    let messages = read(&bytes);

    let mut counts = BTreeMap::new();
    for (topic, _, _) in &messages {
        *counts.entry(topic.as_str()).or_insert(0) += 1;
    }
    let expected = [
        ("/tf", 10),
        ("/truth", 10),
        ("/mocap", 5),
        ("/gyro", 9),
        ("/setpoint", 10),
        ("/motors", 10),
        ("/battery", 10),
        ("/plan", 4),
        ("/record", 2),
        ("/events", 2),
    ];
    assert_eq!(counts, BTreeMap::from(expected));
    assert!(messages.windows(2).all(|pair| pair[0].1 <= pair[1].1), "messages are in order of time");

    let of = |wanted: &str| -> Vec<&(String, u64, Value)> {
        messages.iter().filter(|(topic, _, _)| topic == wanted).collect()
    };
    let (_, time, tf) = of("/tf")[3];
    assert_eq!(*time, log.samples[3].time_ns);
    assert_eq!(tf["timestamp"], serde_json::json!({"sec": 2, "nsec": 3_750_000}));
    assert_eq!(tf["translation"], serde_json::json!({"x": 3.0, "y": 0.01, "z": 1.0}));
    assert_eq!(tf["rotation"], serde_json::json!({"w": 0.8, "x": 0.0, "y": 0.6, "z": 0.0}));
    assert_eq!(of("/truth")[3].2["phase"], "maneuver");
    assert_eq!(of("/truth")[3].2["planar"]["x"], 3.0);
    assert_eq!(of("/gyro")[0].2["roll_radps"], 0.125);
    let (_, time, plan) = of("/plan")[2];
    assert_eq!(*time, START_NS + 2_000_000);
    assert_eq!(plan["phi_t"], 0.25);
    assert_eq!(of("/plan")[0].2["phi_t"], Value::Null, "NaN is null");
    assert_eq!(of("/record")[1].1, START_NS + 1_250_000);
    assert_eq!(of("/events")[1].2["message"], "triggered \"now\"");
    assert_eq!(of("/events")[1].2["level"], 3);
}

#[test]
fn header_and_table_are_in_the_file() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("flight.mcap");
    write_mcap(&small_flight(), &path).unwrap();
    let bytes = fs::read(&path).unwrap();
    let summary = mcap::Summary::read(&bytes).unwrap().unwrap();
    let metadata = mcap::read::metadata(&bytes, &summary.metadata_indexes[0]).unwrap();
    assert_eq!(metadata.name, METADATA);
    assert_eq!(metadata.metadata["seed"], "7");
    assert_eq!(metadata.metadata["to"], "[5.0, 0.0, 5.0, 0.0, 0.0]");
    assert_eq!(metadata.metadata["turns"], "-1");
    assert_eq!(metadata.metadata["table_hex"], "00abff");
    assert_eq!(metadata.metadata["heading_deg"], "90");
    let table = mcap::read::attachment(&bytes, &summary.attachment_indexes[0]).unwrap();
    assert_eq!((table.name.as_str(), table.data.as_ref()), (TABLE_ATTACHMENT, &[0x00, 0xab, 0xff][..]));
}

#[test]
fn every_documented_topic_is_announced_even_in_an_empty_log() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("empty.mcap");
    write_mcap(&FlightLog::default(), &path).unwrap();
    let bytes = fs::read(&path).unwrap();
    assert!(read(&bytes).is_empty());
    let summary = mcap::Summary::read(&bytes).unwrap().unwrap();
    assert_eq!(summary.channels.len(), 10);
    assert!(summary.attachment_indexes.is_empty());
}

#[test]
fn same_data_same_bytes() {
    let folder = tempfile::tempdir().unwrap();
    let [a, b] = ["a.mcap", "b.mcap"].map(|name| folder.path().join(name));
    write_mcap(&small_flight(), &a).unwrap();
    write_mcap(&small_flight(), &b).unwrap();
    assert!(fs::read(a).unwrap() == fs::read(b).unwrap());
}

#[test]
fn an_existing_log_is_replaced_and_nothing_else_is_left() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("flight.mcap");
    fs::write(&path, "old").unwrap();
    check_writable(&path).unwrap();
    assert_eq!(fs::read(&path).unwrap(), b"old", "a check changes nothing");
    write_mcap(&small_flight(), &path).unwrap();
    assert!(!read(&fs::read(&path).unwrap()).is_empty());
    assert_eq!(names(folder.path()), ["flight.mcap"]);
}

#[test]
fn a_failure_half_way_leaves_the_old_file() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("flight.mcap");
    fs::write(&path, "old").unwrap();
    let result = write_whole::<OutputError>(&path, |file| {
        std::io::Write::write_all(file, b"half").unwrap();
        Err(OutputError::NoName { path: path.clone() })
    });
    assert!(result.is_err());
    assert_eq!(fs::read(&path).unwrap(), b"old");
    assert_eq!(names(folder.path()), ["flight.mcap"]);
}

#[test]
fn paths_that_cannot_be_written_are_refused_with_a_sentence() {
    let folder = tempfile::tempdir().unwrap();
    let refuse = |path: &Path| {
        let before = check_writable(path).unwrap_err();
        let after = write_mcap(&small_flight(), path).unwrap_err().to_string();
        assert_eq!(before.to_string(), after, "the check says beforehand what the write would say");
        assert!(after.contains(&path.display().to_string()), "{after}");
        before
    };
    assert!(matches!(refuse(folder.path()), OutputError::IsFolder { .. }));
    assert!(matches!(refuse(&folder.path().join("no/such/flight.mcap")), OutputError::NoFolder { .. }));
    assert!(matches!(check_writable(Path::new("")), Err(OutputError::NoName { .. })));
    assert!(matches!(refuse(&folder.path().join("results/")), OutputError::NoFolder { .. }));

    let file = folder.path().join("file");
    fs::write(&file, "").unwrap();
    assert!(matches!(refuse(&file.join("flight.mcap")), OutputError::NoFolder { .. }));
    let mut permissions = fs::metadata(&file).unwrap().permissions();
    permissions.set_readonly(true);
    fs::set_permissions(&file, permissions).unwrap();
    assert!(matches!(refuse(&file), OutputError::FileReadOnly { .. }));
    assert_eq!(names(folder.path()), ["file"]);
}

#[cfg(unix)]
#[test]
fn devices_are_not_replaced_and_links_are_followed() {
    assert!(matches!(check_writable(Path::new("/dev/null")), Err(OutputError::NotAFile { .. })));
    let folder = tempfile::tempdir().unwrap();
    let [target, link] = ["target.mcap", "link.mcap"].map(|name| folder.path().join(name));
    fs::write(&target, "").unwrap();
    std::os::unix::fs::symlink(&target, &link).unwrap();
    write_mcap(&small_flight(), &link).unwrap();
    assert!(fs::symlink_metadata(&link).unwrap().is_symlink());
    assert!(!fs::read(&target).unwrap().is_empty());
}

fn names(folder: &Path) -> Vec<String> {
    let mut names: Vec<String> = fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    names
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    /// Whatever the numbers and texts, the file can be read and is in order of time.
    #[test]
    fn any_data_gives_a_readable_file(
        times in prop::collection::vec(any::<u64>(), 0..20),
        value in prop::num::f64::ANY,
        small in prop::num::f32::ANY,
        start in prop::option::of(any::<u64>()),
        text in ".{0,40}",
    ) {
        let log = FlightLog {
            header: LogHeader {
                maneuver_start_ns: start,
                duration_s: value,
                facts: vec![(text.clone(), text.clone()), (text.clone(), String::new())],
                ..LogHeader::default()
            },
            planned: vec![PlannedSample { t_s: value, phi_r: value, ..PlannedSample::default() }],
            samples: times
                .iter()
                .map(|&time_ns| FlightSample {
                    time_ns,
                    phase: text.clone(),
                    truth: Truth { position_m: [value; 3], ..Truth::default() },
                    gyro_radps: Some([small; 3]),
                    ..FlightSample::default()
                })
                .collect(),
            events: vec![LogEvent { time_ns: times.len() as u64, text, level: EventLevel::Error }],
            record: vec![RecordSample { t_us: u32::MAX, ..RecordSample::default() }],
        };
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("any.mcap");
        write_mcap(&log, &path).unwrap();
        let messages = read(&fs::read(&path).unwrap());
        prop_assert_eq!(messages.len(), times.len() * 6 + 3);
        prop_assert!(messages.windows(2).all(|pair| pair[0].1 <= pair[1].1));
    }
}

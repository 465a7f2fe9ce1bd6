//! A vehicle at the other end of a line, good or bad, through the real client and the real command.

mod served;

use std::io::Write as _;
use std::process::{Command, Output, Stdio};
use std::time::Duration;

use mintime::flight::ClientError;
use mintime::pack::pack;
use mintime::port::{Port, PortError};
use mintime::solver::{Request, solve};
use mintime::vehicle::{PortLink, Session, SessionError};
use mintime_shared::messages::{FlightState, Happening, IncidentCause, PROTOCOL_VERSION, Purpose, Refusal};
use mintime_shared::table::{ANY_VEHICLE, MAX_TABLE_BYTES, ManeuverTable, TableError};
use mintime_shared::vehicle::VehicleConfig;
use serde_json::Value;
use served::{By, Faults, Served};

const GOOD: Faults =
    Faults { loss: 0.0, twice: 0.0, held_up: Duration::ZERO, burst: Duration::ZERO, delay: Duration::ZERO };
/// A radio on a bad day.
const BAD: Faults = Faults {
    loss: 0.15,
    twice: 0.1,
    held_up: Duration::from_millis(12),
    burst: Duration::ZERO,
    delay: Duration::ZERO,
};
/// Wi-Fi that saves power.
const BURSTS: Faults = Faults { loss: 0.05, burst: Duration::from_millis(50), ..GOOD };

fn table() -> ManeuverTable {
    let solution = solve(&Request::rest_to_rest(3.0, 2.0)).expect("a maneuver");
    pack(&solution.extremal, ANY_VEHICLE, 0.0).expect("a table")
}

/// All that is asked on the bench.
fn converse(port: &str) {
    let mut session = Session::begin(PortLink::open(port).expect("a port"), None).expect("a vehicle");
    assert_eq!(session.identity().vehicle, VehicleConfig::REFERENCE.hash());
    assert_eq!(session.vehicle().expect("it answers"), Some(VehicleConfig::REFERENCE));

    let heavier = VehicleConfig { mass_kg: 0.8, ..VehicleConfig::REFERENCE };
    session.set_vehicle(&heavier).expect("written to flash");
    assert_eq!(session.identity().vehicle, heavier.hash());
    let mut settings = session.settings().expect("it answers");
    settings.kill_channel = 7;
    session.set_settings(&settings).expect("written to flash");

    let table = table();
    let (checksum, duration_s) = session.upload(&table).expect("uploaded and read back");
    assert!((duration_s - table.duration_s()).abs() < 1e-6);
    // It was for any vehicle, and is this one's own now; what is another's is not uploaded.
    let made_for = |vehicle| {
        let mut table = table.clone();
        table.vehicle = vehicle;
        table
    };
    let flown = ManeuverTable::decode(&session.read_table().expect("it answers")).expect("a table");
    assert_eq!((flown.checksum(), &flown), (checksum, &made_for(heavier.hash())));
    let refused = session.upload(&made_for(VehicleConfig::REFERENCE.hash())).expect_err("of a lighter one");
    assert!(matches!(refused, SessionError::Table(TableError::OtherVehicle)), "{refused}");
    for name in ["hop", "an-exact-16-byte"] {
        session.store(name, checksum).expect("stored");
    }
    let names: Vec<_> = session.tables().expect("a list").iter().map(|t| t.name.to_string()).collect();
    assert_eq!(names, ["hop", "an-exact-16-byte"]);
    assert_eq!(session.load("hop").expect("loaded").0, checksum);
    session.delete("hop").expect("deleted");
    assert_eq!(session.tables().expect("a list").len(), 1);
    let refused = session.load("hop").expect_err("it is gone");
    assert!(matches!(
        refused,
        SessionError::Client { source: ClientError::Refused(Refusal::NoSuchTable), .. }
    ));

    let events = session.events().expect("a list");
    assert!(events.windows(2).all(|w| w[1].0 == w[0].0 + 1), "{events:?}");
    assert!(events.iter().any(|(_, e)| e.what == Happening::Committed(checksum)), "{events:?}");
    assert!(session.record().expect("an answer").is_empty());
}

#[test]
fn a_whole_conversation_over_tcp() {
    converse(&Served::new(By::Tcp, GOOD).port);
}

#[cfg(unix)]
#[test]
fn a_whole_conversation_over_a_serial_port() {
    converse(&Served::new(By::Pty, GOOD).port);
}

#[test]
fn a_whole_conversation_over_a_bad_radio() {
    converse(&Served::new(By::Udp, BAD).port);
}

#[test]
fn a_whole_conversation_in_bursts() {
    converse(&Served::new(By::Udp, BURSTS).port);
}

#[cfg(unix)]
#[test]
fn a_serial_port_that_loses_frames() {
    converse(&Served::new(By::Pty, Faults { loss: 0.1, twice: 0.05, ..GOOD }).port);
}

#[test]
fn a_paired_vehicle_listens_to_its_key_only() {
    for faults in [GOOD, BAD] {
        let served = Served::new(By::Udp, faults);
        let open = |key| Session::begin(PortLink::open(&served.port).expect("a port"), key);
        let (key, other) = ([7; 16], [8; 16]);
        open(None).expect("a vehicle").pair(Some(key)).expect("paired");
        assert!(matches!(open(None), Err(SessionError::KeyWanted)));
        let error = open(Some(other)).expect("it says who it is").status().expect_err("another key");
        assert!(
            matches!(error, SessionError::Client { source: ClientError::Refused(Refusal::NotSealed), .. }),
            "{error}"
        );
        // One program after the other, each beginning its counter anew.
        for _ in 0..3 {
            open(Some(key)).expect("it says who it is").status().expect("sealed");
        }
        open(Some(key)).expect("it says who it is").pair(None).expect("unpaired");
        open(None).expect("a vehicle").status().expect("unsealed");
    }
}

fn mintime(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_mintime")).args(arguments).output().expect("it starts")
}

fn json(output: &Output) -> Value {
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    serde_json::from_slice(&output.stdout).expect("JSON")
}

/// What a command says on stderr when it fails.
fn failure(output: &Output) -> String {
    assert!(!output.status.success(), "{}", String::from_utf8_lossy(&output.stdout));
    let text = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(!text.contains("panicked"), "{text}");
    text
}

#[test]
fn the_commands_of_the_bench() {
    let served = Served::new(By::Tcp, GOOD);
    let folder = tempfile::tempdir().expect("a folder");
    let path = |name: &str| folder.path().join(name).display().to_string();
    let vehicle =
        |arguments: &[&str]| mintime(&[&["vehicle", &served.port][..], arguments, &["--json"]].concat());

    assert_eq!(json(&vehicle(&["identity"]))["protocol_version"], PROTOCOL_VERSION);
    assert!(json(&vehicle(&["status"]))["arming_blocked_by"].is_array());
    json(&vehicle(&["params", "--save", &path("quad.json")]));
    let text = std::fs::read_to_string(path("quad.json")).expect("saved").replace("0.752", "0.76");
    std::fs::write(path("quad.json"), text).expect("written");
    assert_eq!(json(&vehicle(&["params", "--file", &path("quad.json")]))["mass_kg"], 0.76);
    assert_eq!(json(&vehicle(&["params", "--set", "reversed=true"]))["reversed"], true);
    assert_eq!(json(&vehicle(&["params", "--settings", "--set", "kill_channel=8"]))["kill_channel"], 8);
    assert!(failure(&vehicle(&["params", "--set", "mass=1"])).contains("there are arm_forward_m"));
    assert!(failure(&vehicle(&["params", "--set", "mass_kg=1000"])).contains("0.02 and 20 kg"));

    let mut buffer = [0; MAX_TABLE_BYTES];
    let length = table().encode(&mut buffer).expect("it fits");
    std::fs::write(path("hop.table"), &buffer[..length]).expect("written");
    assert_eq!(json(&vehicle(&["upload", &path("hop.table"), "--name", "hop"]))["name"], "hop");
    assert_eq!(json(&vehicle(&["tables"]))["tables"][0]["committed"], true);
    assert_eq!(json(&vehicle(&["tables", "delete", "hop"]))["tables"], serde_json::json!([]));
    assert!(json(&vehicle(&["events"]))["events"].as_array().is_some_and(|e| !e.is_empty()));
    let measured = json(&vehicle(&["measure", "--seconds", "0.5"]));
    assert!(measured["round_trip_ms"]["median"].as_f64().is_some_and(|ms| ms < 50.0), "{measured}");
    assert!(measured["telemetry_hz"].as_f64().is_some_and(|hz| (20.0..60.0).contains(&hz)), "{measured}");
    assert!(failure(&vehicle(&["record", "-o", &path("record.csv")])).contains("no record"));
    assert!(failure(&vehicle(&["test-motors"])).contains("no motor was turned"));
    assert_eq!(json(&vehicle(&["calibrate", "bias"]))["calibrated"], "bias");

    assert_eq!(json(&vehicle(&["pair", "--new", &path("key")]))["paired"], true);
    assert!(failure(&vehicle(&["status"])).contains("--key"));
    json(&vehicle(&["status", "--key", &path("key")]));
    assert!(failure(&mintime(&["stop", &served.port, "--tries", "3"])).contains("not confirmed"));
    assert_eq!(json(&mintime(&["stop", &served.port, "--key", &path("key"), "--json"]))["stopped"], true);
    let status = json(&vehicle(&["status", "--key", &path("key")]));
    assert_eq!(status["state"], "Terminated");
    // Another one waits behind it, and is told.
    served.with_hands(|hands| hands.report = Some(IncidentCause::Watchdog));
    std::thread::sleep(Duration::from_millis(50));
    let acknowledge = || json(&vehicle(&["acknowledge", "--key", &path("key")]));
    let first = acknowledge();
    assert_eq!(first["cause"], status["incident_cause"]);
    assert_eq!(first["next"]["cause"], IncidentCause::Watchdog.to_string());
    assert_eq!(json(&vehicle(&["status", "--key", &path("key")]))["state"], "Disarmed");
    let second = acknowledge();
    assert_eq!(second["acknowledged"], first["next"]["number"]);
    assert_eq!(second["next"], Value::Null);
    assert_eq!(acknowledge()["acknowledged"], Value::Null);
    assert_eq!(json(&vehicle(&["pair", "--remove", "--key", &path("key")]))["paired"], false);
}

/// The command, with somebody who types.
fn mintime_told(arguments: &[&str], typed: &str) -> Output {
    let mut child = Command::new(env!("CARGO_BIN_EXE_mintime"))
        .args(arguments)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("it starts");
    child.stdin.take().expect("piped").write_all(typed.as_bytes()).expect("it listens");
    child.wait_with_output().expect("it ends")
}

/// A vehicle that has calibrated its gyro after power-up.
fn ready(by: By) -> Served {
    let served = Served::new(by, GOOD);
    let mut session = Session::begin(PortLink::open(&served.port).expect("a port"), None).expect("a vehicle");
    for _ in 0..100 {
        let status = session.status().expect("it answers");
        if status.state == FlightState::Disarmed && status.arming_block == 0 {
            return served;
        }
        session.listen(0.1).expect("it listens");
    }
    panic!("it never became ready");
}

#[test]
fn the_gyros_scale_is_found_by_whole_turns() {
    /// What this gyro makes of a turn.
    const ERROR: f32 = 1.02;
    let served = ready(By::Tcp);
    // Two turns to the left at 5 rad/s, as the gyro feels them, when the command has long been waiting: longer altogether
    // than flash is waited for.
    let turn_rad = 2.0 * core::f32::consts::TAU;
    let ticks = (turn_rad / 5.0 * 800.0).round();
    served.with_hands(|hands| hands.turn = Some((8000, ERROR * turn_rad * 800.0 / ticks, ticks as u32)));
    let arguments = ["vehicle", &served.port, "calibrate", "scale", "up", "--turns", "2", "--json"];
    let answer = json(&mintime_told(&arguments, "\n"));
    let scale = answer["gyro_scale"][2].as_f64().expect("a number");
    assert!((scale * f64::from(ERROR) - 1.0).abs() < 2e-3, "{answer}");
    assert_eq!(answer["before"][2], 1.0);
    // Nobody there to press Enter.
    assert!(failure(&mintime_told(&arguments, "")).contains("nobody pressed Enter"));
}

#[test]
fn motors_turn_one_by_one_once_the_props_are_off() {
    let served = ready(By::Tcp);
    let test = |typed: &str, more: &[&str]| {
        let arguments = ["vehicle", &served.port, "test-motors", "--seconds", "0.3", "--json"];
        mintime_told(&[&arguments[..], more].concat(), typed)
    };
    assert!(failure(&test("props are on\n", &[])).contains("no motor was turned"));
    assert_eq!(served.with_hands(|hands| hands.throttle), [0.0; 4]);

    let answer = json(&test("props are off\n", &["--motor", "2", "--throttle", "0.08"]));
    assert_eq!(answer["turned"], serde_json::json!([2]));
    let throttle = served.with_hands(|hands| hands.throttle);
    assert!((throttle[1] - 0.08).abs() < 1e-3, "{throttle:?}");
    assert!([0, 2, 3].iter().all(|i| throttle[*i] < 0.01), "{throttle:?}");

    // It shook; it must have rested for a window before it is armed again.
    std::thread::sleep(Duration::from_millis(1500));
    let answer = json(&test("props are off\n", &[]));
    assert_eq!(answer["turned"], serde_json::json!([1, 2, 3, 4]));
    assert!(served.with_hands(|hands| hands.throttle).iter().all(|t| *t > 0.05));
    let mut session = Session::begin(PortLink::open(&served.port).expect("a port"), None).expect("a vehicle");
    assert_eq!(session.status().expect("it answers").state, FlightState::Disarmed);
}

#[test]
fn a_stop_gets_through_a_bad_radio_and_says_so() {
    let served = Served::new(By::Udp, BAD);
    let mut session = Session::begin(PortLink::open(&served.port).expect("a port"), None).expect("a vehicle");
    session.listen(1.5).expect("it listens");
    session
        .tell("arming", mintime_shared::messages::Request::Arm(Purpose::Flight))
        .expect("nothing blocks it");
    drop(session);
    let stopped = json(&mintime(&["stop", &served.port, "--json"]));
    assert!(stopped["tries"].as_u64().is_some_and(|n| n <= 30), "{stopped}");
    let mut session = Session::begin(PortLink::open(&served.port).expect("a port"), None).expect("a vehicle");
    assert_eq!(session.status().expect("it answers").state, FlightState::Terminated);
}

#[test]
fn ports_that_are_none_are_told_apart() {
    let open = |spec: &str| Port::open(spec).expect_err(spec);
    let missing = open("/dev/no-such-port");
    assert!(matches!(missing, PortError::NoSuchDevice { .. }), "{missing}");
    let free = std::net::TcpListener::bind("127.0.0.1:0").expect("a port").local_addr().expect("bound");
    assert!(matches!(open(&format!("tcp:{free}")), PortError::Refused { .. }));
    assert!(matches!(open("nowhere?speed=1"), PortError::Name { .. }));
    #[cfg(unix)]
    {
        assert!(matches!(open("/dev/null"), PortError::NotSerial { .. }));
        let served = Served::new(By::Pty, GOOD);
        let _first = Port::open(&served.port).expect("free");
        assert!(matches!(open(&served.port), PortError::Busy { .. }));
    }
    let text = failure(&mintime(&["vehicle", &format!("tcp:{free}"), "status"]));
    assert!(text.contains("refused"), "{text}");
}

#[test]
fn a_vehicle_that_vanishes_is_missed() {
    let mut served = Served::new(By::Tcp, GOOD);
    let mut session = Session::begin(PortLink::open(&served.port).expect("a port"), None).expect("a vehicle");
    session.status().expect("it answers");
    served.vanish();
    let error = session.listen(1.0).expect_err("nobody is there").to_string();
    assert!(error.contains("has vanished"), "{error}");

    // Datagrams do not tell; silence does.
    let mut served = Served::new(By::Udp, GOOD);
    let mut session = Session::begin(PortLink::open(&served.port).expect("a port"), None).expect("a vehicle");
    served.vanish();
    let error = session.status().expect_err("nobody is there").to_string();
    assert!(error.contains("does not answer") || error.contains("refused"), "{error}");
}

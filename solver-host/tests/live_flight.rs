//! A real vehicle as the command sees one: a port and poses by network, both in real time. The vehicle behind them is the
//! flight logic with a simulated airframe.

use std::io::{Read as _, Write as _};
use std::net::{TcpListener, TcpStream, UdpSocket};
use std::process::{Command, Output};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

use mintime::flight::{Connection as _, HostedVehicle, Scene};
use mintime_simulator::VehicleParameters;
use serde_json::Value;

/// Real time needs a processor: one flight after the other.
static ALONE: Mutex<()> = Mutex::new(());

/// A room with a vehicle on its floor and cameras.
struct World {
    port: String,
    mocap: String,
    ended: Arc<AtomicBool>,
    thread: Option<JoinHandle<f64>>,
}

impl World {
    /// The cameras lose the vehicle for good after this long in the air, s.
    fn new(blind_after_s: f64) -> Self {
        let listener = TcpListener::bind("127.0.0.1:0").expect("a port");
        listener.set_nonblocking(true).expect("possible");
        let port = format!("tcp:{}", listener.local_addr().expect("bound"));
        // A port that was free a moment ago.
        let mocap = UdpSocket::bind("127.0.0.1:0").and_then(|s| s.local_addr()).expect("a port").to_string();
        let ended = Arc::new(AtomicBool::new(false));
        let (end, to) = (Arc::clone(&ended), mocap.clone());
        let thread = Some(std::thread::spawn(move || serve(&listener, &to, blind_after_s, &end)));
        Self { port, mocap: format!("udp:{mocap}"), ended, thread }
    }

    /// Speed at which it came down on the floor, at most, m/s.
    fn end(mut self) -> f64 {
        self.ended.store(true, Ordering::Relaxed);
        self.thread.take().expect("once").join().expect("it served")
    }

    fn fly(&self, folder: &std::path::Path, more: &[&str]) -> Output {
        let arguments = [
            "fly",
            "--to",
            "1.5,1",
            "--vehicle",
            &self.port,
            "--mocap",
            &self.mocap,
            "--room",
            "-4,6,-4,4,-3,6",
            "--json",
        ];
        Command::new(env!("CARGO_BIN_EXE_mintime"))
            .args(arguments)
            .args(more)
            .current_dir(folder)
            .output()
            .expect("it starts")
    }

    fn status(&self) -> Value {
        let output = Command::new(env!("CARGO_BIN_EXE_mintime"))
            .args(["vehicle", &self.port, "status", "--json"])
            .output()
            .expect("it starts");
        serde_json::from_slice(&output.stdout).expect("JSON")
    }
}

fn serve(listener: &TcpListener, mocap: &str, blind_after_s: f64, ended: &AtomicBool) -> f64 {
    let parameters = VehicleParameters::nominal();
    let scene =
        Scene { parameters: &parameters, seed: 3, ground_z_m: 0.0, heading_rad: 0.0, maneuver_s: 0.0 };
    let mut vehicle = HostedVehicle::new(&scene).expect("a vehicle");
    let cameras = UdpSocket::bind("127.0.0.1:0").expect("a port");
    let mut stream: Option<TcpStream> = None;
    let began = Instant::now();
    let (mut in_the_air_s, mut last, mut fastest_mps) = (0.0, None, 0.0_f64);
    let mut bytes = vec![0; 4096];
    let mut next = Duration::ZERO;
    while !ended.load(Ordering::Relaxed) {
        // What the host says to the last pose is there when the next one is due; it acts from the last one on.
        std::thread::sleep((began + next).saturating_duration_since(Instant::now()));
        if let Ok((new, _)) = listener.accept() {
            new.set_nonblocking(true).expect("possible");
            new.set_nodelay(true).expect("possible");
            stream = Some(new);
        }
        if let Some(count) = stream.as_mut().and_then(|s| s.read(&mut bytes).ok()) {
            vehicle.send(&bytes[..count]).expect("it takes bytes");
        }
        let pose = vehicle.next_pose().expect("the simulated cameras never fail");
        next = Duration::from_secs_f64(pose.arrived_s + 0.005);
        let mut out = Vec::new();
        vehicle.receive(&mut out).expect("it gives bytes");
        if let Some(stream) = &mut stream {
            let _ = stream.write(&out);
        }
        let (p, q) = (pose.position_m, pose.attitude.quaternion());
        if let Some((z, t)) = last.replace((p.z, pose.captured_s))
            && p.z < 0.15
        {
            fastest_mps = fastest_mps.max((z - p.z) / (pose.captured_s - t));
        }
        in_the_air_s += if p.z > 0.5 { 0.005 } else { 0.0 };
        if in_the_air_s < blind_after_s {
            // The capture has a clock of its own.
            let line = serde_json::json!({
                "t": pose.captured_s + 1000.0,
                "position_m": [p.x, p.y, p.z],
                "attitude_wxyz": [q.w, q.i, q.j, q.k],
                "name": "quad",
            });
            let _ = cameras.send_to(line.to_string().as_bytes(), mocap);
        }
    }
    fastest_mps
}

fn json(output: &Output) -> Value {
    serde_json::from_slice(&output.stdout)
        .unwrap_or_else(|e| panic!("{e}: {}", String::from_utf8_lossy(&output.stderr)))
}

#[test]
fn a_real_vehicle_flies_its_maneuver_and_lands() {
    let _alone = ALONE.lock().unwrap_or_else(PoisonError::into_inner);
    let world = World::new(f64::INFINITY);
    let folder = tempfile::tempdir().expect("a folder");
    let output = world.fly(folder.path(), &["--mocap-name", "quad"]);
    let answer = json(&output);
    assert_eq!(answer["flight"]["outcome"], "completed", "{answer:#}");
    assert_eq!(answer["vehicle"]["kind"], "real");
    assert!(output.status.success());
    assert!(folder.path().join("flight.mcap").is_file());
    // What the cameras saw is in the picture.
    let picture = std::fs::read_to_string(folder.path().join("flight.svg")).expect("a picture");
    assert!(picture.contains("flown-vehicles") && picture.contains("as the cameras saw it"), "{picture}");
    // So it is in the page, with the vehicle's own record: of gyro and throttles nobody else knows.
    let page = std::fs::read_to_string(folder.path().join("flight.html")).expect("a page");
    let (_, data) = page.split_once(r#"id="data">"#).expect("data");
    let data: Value = serde_json::from_str(data.split_once("</script>").expect("an end").0).expect("JSON");
    assert_eq!(data["flown_is"], "seen by the cameras");
    assert!(data["record"]["gyro"].as_str().is_some_and(|column| column.len() > 1000));
    let unknown = ["motors", "gyro", "rate_command", "thrust_command"];
    assert!(unknown.iter().all(|name| data["flight"].get(name).is_none()), "{}", data["flight"]);
    assert_eq!(world.status()["state"], "Disarmed");
    world.end();
}

#[test]
fn a_vehicle_that_the_cameras_lose_comes_down_by_itself() {
    let _alone = ALONE.lock().unwrap_or_else(PoisonError::into_inner);
    let world = World::new(2.0);
    let folder = tempfile::tempdir().expect("a folder");
    let answer = json(&world.fly(folder.path(), &[]));
    assert_eq!(answer["flight"]["outcome"], "lost", "{answer:#}");
    assert!(
        answer["flight"]["abort_reason"].as_str().is_some_and(|r| r.contains("no pose for")),
        "{answer:#}"
    );
    let state = world.status()["state"].clone();
    assert!(state == "Landed" || state == "Terminated", "{state}");
    let fastest_mps = world.end();
    eprintln!("touched down at {fastest_mps:.2} m/s at most");
}

#[test]
fn without_eyes_or_walls_nothing_flies() {
    let _alone = ALONE.lock().unwrap_or_else(PoisonError::into_inner);
    let world = World::new(f64::INFINITY);
    let folder = tempfile::tempdir().expect("a folder");
    let refused = |arguments: &[&str]| {
        let output = Command::new(env!("CARGO_BIN_EXE_mintime"))
            .args([&["fly", "--to", "1.5,1"], arguments].concat())
            .current_dir(folder.path())
            .output()
            .expect("it starts");
        assert!(!output.status.success());
        String::from_utf8_lossy(&output.stderr).into_owned()
    };
    assert!(refused(&["--vehicle", &world.port]).contains("--mocap"));
    let eyes = ["--vehicle", &world.port, "--mocap", &world.mocap];
    assert!(refused(&eyes).contains("--room with six numbers"));
    assert!(refused(&[&eyes[..], &["--room", "-1,1,-1,1,-1,1"]].concat()).contains("does not fit the room"));
    assert!(refused(&["--mocap", "-"]).contains("--vehicle PORT"));
    let state = world.status()["state"].clone();
    assert!(state == "Calibrating" || state == "Disarmed", "{state}");
    world.end();
}

#[test]
fn a_real_vehicle_is_identified_flies_what_it_learns_and_flies_back() {
    let _alone = ALONE.lock().unwrap_or_else(PoisonError::into_inner);
    let world = World::new(f64::INFINITY);
    let folder = tempfile::tempdir().expect("a folder");
    let output = Command::new(env!("CARGO_BIN_EXE_mintime"))
        .args(["learn", "--to", "1,0.5", "--vehicle", &world.port, "--mocap", &world.mocap])
        .args(["--room", "-4,6,-4,4,-3,6", "--flights", "2", "--repeats", "0", "--output", "kept", "--json"])
        .current_dir(folder.path())
        .output()
        .expect("it starts");
    let answer = json(&output);
    let flights = answer["flights"].as_array().unwrap_or_else(|| panic!("{answer:#}"));
    assert_eq!(flights.len(), 2, "{answer:#}");
    for flight in flights {
        // The second flight began where the first one did.
        let at = |name: &str| flight["start_error"][name].as_f64().unwrap_or_else(|| panic!("{answer:#}"));
        assert!(
            at("x_m").abs() < 0.05 && at("z_m").abs() < 0.05 && at("theta_rad").abs() < 5e-3,
            "{answer:#}"
        );
        let x = flight["final_error"]["x_m"].as_f64().expect("a number");
        assert!(x.abs() < 1.0 && flight["true_final_error"].is_null(), "{answer:#}");
    }
    assert!(folder.path().join("kept/history.json").is_file());
    assert_eq!(world.status()["state"], "Disarmed");
    world.end();
}

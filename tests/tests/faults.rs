//! Whole flights in which something breaks: how each ends, and how soon the motors stand still.

use core::ops::Range;

use mintime::flight::{
    Client, ClientError, Connection, ConnectionError, FlightError, FlightPlan, FlightResult, HostedVehicle,
    Outcome, Phase, Pose, Scene, Trace, Witness, fly,
};
use mintime::flight_log::FlightSample;
use mintime_shared::framing::encode;
use mintime_shared::messages::{
    AbortReason, ArmingBlock, FlightState, PROTOCOL_VERSION, Purpose, Refusal, Reply, Request,
    STAGE_CHUNK_BYTES, Setpoint, Uplink,
};
use mintime_shared::table::{MAX_TABLE_BYTES, ManeuverTable};
use mintime_shared::vehicle::VehicleConfig;
use mintime_simulator::{Fault, VehicleParameters};
use mintime_tests::reference_cases;
use nalgebra::Vector3;

const MS: u64 = 1_000_000;
/// Fault windows that never end.
const FOR_EVER: u64 = u64::MAX;
/// The ground, m below the start.
const GROUND_M: f64 = -1.5;

struct Silent;

impl Witness for Silent {
    fn phase(&mut self, _: Phase, _: f64) {}
    fn event(&mut self, _: f64, _: &str) {}
}

fn table_of(name: &str) -> ManeuverTable {
    reference_cases().into_iter().find(|c| c.name == name).expect("the case exists").table()
}

fn plan_of(table: ManeuverTable) -> FlightPlan {
    FlightPlan::new(table, Vector3::zeros(), Some(VehicleConfig::REFERENCE))
}

fn hosted(parameters: &VehicleParameters, seed: u64, table: &ManeuverTable) -> HostedVehicle {
    let (heading, duration) = (f64::from(table.heading_rad), f64::from(table.duration_s()));
    HostedVehicle::new(&scene(parameters, seed, heading, duration)).expect("sound parameters")
}

fn scene(parameters: &VehicleParameters, seed: u64, heading_rad: f64, maneuver_s: f64) -> Scene<'_> {
    Scene { parameters, seed, ground_z_m: GROUND_M, heading_rad, maneuver_s }
}

/// Bytes that go wrong on the line, by a small generator of its own (xorshift), so that a seed repeats itself.
struct Noise {
    state: u64,
    /// One byte in so many is flipped, dropped or doubled.
    one_in: u64,
}

impl Noise {
    fn draw(&mut self) -> u64 {
        self.state ^= self.state << 13;
        self.state ^= self.state >> 7;
        self.state ^= self.state << 17;
        self.state
    }

    fn corrupt(&mut self, bytes: &[u8]) -> Vec<u8> {
        let mut out = Vec::new();
        for &byte in bytes {
            if !(self.draw() >> 8).is_multiple_of(self.one_in) {
                out.push(byte);
                continue;
            }
            match self.draw() >> 8 & 3 {
                0 => {}
                1 => out.extend([byte, byte]),
                _ => out.push(byte ^ 1 << (self.draw() >> 8 & 7)),
            }
        }
        out
    }
}

/// A hosted vehicle in which something breaks at a phase of the flight, on a line that may be bad.
struct Breaking {
    vehicle: HostedVehicle,
    /// In which phase, what, and when from the phase's beginning, ns.
    plan: Vec<(Phase, Fault, Range<u64>)>,
    noise: Option<Noise>,
    /// When the last fault planned began, ns.
    broken_ns: Option<u64>,
}

impl Breaking {
    fn new(vehicle: HostedVehicle) -> Self {
        Self { vehicle, plan: Vec::new(), noise: None, broken_ns: None }
    }
}

impl Connection for Breaking {
    fn next_pose(&mut self) -> Result<Pose, ConnectionError> {
        self.vehicle.next_pose()
    }

    fn send(&mut self, bytes: &[u8]) -> Result<(), ConnectionError> {
        match &mut self.noise {
            Some(noise) => self.vehicle.send(&noise.corrupt(bytes)),
            None => self.vehicle.send(bytes),
        }
    }

    fn receive(&mut self, into: &mut Vec<u8>) -> Result<(), ConnectionError> {
        let mut bytes = Vec::new();
        self.vehicle.receive(&mut bytes)?;
        match &mut self.noise {
            Some(noise) => into.extend(noise.corrupt(&bytes)),
            None => into.extend(bytes),
        }
        Ok(())
    }

    fn enter(&mut self, phase: Phase) {
        let now = self.vehicle.now_ns();
        for (_, fault, when) in self.plan.iter().filter(|(p, ..)| *p == phase) {
            let window = now + when.start..now.saturating_add(when.end);
            self.broken_ns = Some(window.start);
            self.vehicle.simulator_mut().inject(*fault, window).expect("the fault exists");
        }
        self.vehicle.enter(phase);
    }
}

/// How a flight went in which something broke.
struct Broken {
    result: Result<FlightResult, FlightError>,
    trace: Trace,
    /// When it broke, ns.
    broken_ns: u64,
}

impl Broken {
    /// From the fault until the motors stood still for good, s.
    fn motors_off_after_s(&self) -> f64 {
        let turning = self.trace.samples.iter().rev().find(|s| turning(s));
        turning.map_or(0.0, |s| s.time_ns.saturating_sub(self.broken_ns) as f64 * 1e-9)
    }

    fn lost(&self) -> (FlightState, Option<AbortReason>) {
        match &self.result {
            Err(FlightError::Lost { state, reason, .. }) => (*state, *reason),
            other => panic!("not lost: {other:?}"),
        }
    }

    fn completed(&self) -> &FlightResult {
        let result = self.result.as_ref().expect("a flight to its end");
        assert_eq!(result.outcome, Outcome::Completed, "{:?}", result.reason);
        let last = self.trace.last.as_ref().expect("truth");
        assert!(last.on_ground && !last.crashed);
        result
    }
}

fn turning(sample: &FlightSample) -> bool {
    sample.throttle.iter().any(|t| *t > 0.0)
}

/// Flies with the given faults, then watches the wreck for three seconds: the motors must stand still.
fn broken(
    parameters: &VehicleParameters,
    table: &ManeuverTable,
    plan: &[(Phase, Fault, Range<u64>)],
) -> Broken {
    let mut rig = Breaking { plan: plan.to_vec(), ..Breaking::new(hosted(parameters, 3, table)) };
    finish(&mut rig, table)
        .map(|(result, end_ns)| {
            let broken_ns = rig.broken_ns.expect("the fault came");
            let trace = rig.vehicle.into_trace();
            let after = trace.samples.iter().filter(|s| s.time_ns > end_ns);
            assert!(after.clone().count() > 100, "nobody watched");
            assert!(!after.into_iter().any(turning), "motors turn after the flight: {result:?}");
            Broken { result, trace, broken_ns }
        })
        .expect("time goes on")
}

/// Flies and watches. `None` where no time passes any more.
fn finish(rig: &mut Breaking, table: &ManeuverTable) -> Option<(Result<FlightResult, FlightError>, u64)> {
    let result = fly(rig, &plan_of(table.clone()), &mut Silent);
    // An emergency stop that is on its way at the end has the time of one answer to arrive.
    let end_ns = rig.vehicle.now_ns() + 20 * MS;
    while rig.vehicle.now_ns() < end_ns + 3000 * MS {
        let before = rig.vehicle.now_ns();
        let _ = rig.vehicle.next_pose();
        if rig.vehicle.now_ns() == before {
            return None;
        }
    }
    Some((result, end_ns))
}

fn nominal() -> VehicleParameters {
    VehicleParameters::nominal()
}

// ---------------------------------------------------------------------------------------------------------- the gyro

#[test]
fn a_gyro_that_falls_silent_stops_the_motors_within_15_ms() {
    for (parameters, model) in [(nominal(), "nominal"), (VehicleParameters::ideal(), "ideal")] {
        for (phase, delay) in [(Phase::TakeOff, 800), (Phase::Hover, 1000), (Phase::Maneuver, 500)] {
            let flight = broken(
                &parameters,
                &table_of("general_5_5"),
                &[(phase, Fault::ImuSilent, delay * MS..FOR_EVER)],
            );
            assert_eq!(flight.lost(), (FlightState::Terminated, Some(AbortReason::GyroMissing)), "{phase:?}");
            let off = flight.motors_off_after_s();
            assert!(off < 0.015, "{model}, {phase:?}: {off} s");
        }
    }
}

/// Up to seven samples in a row are flown without, wherever they fall.
#[test]
fn a_few_missing_samples_change_little() {
    let table = table_of("general_5_5");
    let whole = broken(&nominal(), &table, &[(Phase::Maneuver, Fault::ImuSilent, 0..0)]);
    let end_of = |flight: &Broken| flight.trace.end.as_ref().expect("it ended").planar(0.0);
    for (at, samples) in [(100, 2), (500, 4), (800, 7), (1200, 7)] {
        // A little short of so many periods: one sample more or less falls into the window by where it begins.
        let window = at * MS..at * MS + samples * 1250 * 1000 - 400_000;
        let flight = broken(&nominal(), &table, &[(Phase::Maneuver, Fault::ImuSilent, window)]);
        let result = flight.completed();
        let missing = result.record.iter().filter(|t| t.gyro_radps.is_none()).count() as u64;
        assert!((samples - 1..=samples).contains(&missing), "{missing} of {samples}");
        let change = end_of(&flight).minus(end_of(&whole));
        assert!(change.x.hypot(change.z) < 0.1, "{samples} at {at} ms: {change:?}");
    }
}

#[test]
fn a_gyro_that_freezes_is_noticed() {
    let hover =
        broken(&nominal(), &table_of("general_5_5"), &[(Phase::Hover, Fault::ImuStuck, 1000 * MS..FOR_EVER)]);
    assert_eq!(hover.lost(), (FlightState::Terminated, Some(AbortReason::GyroFrozen)));
    assert!(hover.motors_off_after_s() < 0.5, "{} s", hover.motors_off_after_s());
    // In the fast turn of (5, 5), in the middle of its slow arc, at its end.
    for (delay, within_s) in [(900, 0.1), (400, 0.5), (1250, 0.1)] {
        let flight = broken(
            &nominal(),
            &table_of("general_5_5"),
            &[(Phase::Maneuver, Fault::ImuStuck, delay * MS..FOR_EVER)],
        );
        assert_eq!(flight.lost().0, FlightState::Terminated, "{delay} ms");
        assert!(flight.motors_off_after_s() < within_s, "{delay} ms: {} s", flight.motors_off_after_s());
    }
}

#[test]
fn a_gyro_of_the_wrong_sign_stops_the_motors() {
    for (phase, delay) in [(Phase::Hover, 1000), (Phase::Maneuver, 300), (Phase::Maneuver, 900)] {
        let flight = broken(
            &nominal(),
            &table_of("general_5_5"),
            &[(phase, Fault::GyroReversed, delay * MS..FOR_EVER)],
        );
        let (state, reason) = flight.lost();
        assert_eq!(state, FlightState::Terminated, "{phase:?}");
        assert!(
            matches!(reason, Some(AbortReason::Runaway | AbortReason::GyroSaturated)),
            "{phase:?}: {reason:?}"
        );
        assert!(flight.motors_off_after_s() < 0.6, "{phase:?}: {} s", flight.motors_off_after_s());
    }
}

/// From the very start: it is armed in good faith, and noticed before it flies far.
#[test]
fn a_gyro_mounted_the_wrong_way_round_does_not_get_far() {
    let flight =
        broken(&nominal(), &table_of("general_5_5"), &[(Phase::Prepare, Fault::GyroReversed, 0..FOR_EVER)]);
    assert_eq!(flight.lost().0, FlightState::Terminated);
    let highest = flight.trace.samples.iter().map(|s| s.truth.position_m[2]).fold(f64::MIN, f64::max);
    assert!(highest < GROUND_M + 1.0, "{highest} m");
}

/// Before it was ever armed: it is not.
#[test]
fn a_vehicle_without_gyro_samples_is_not_armed() {
    let flight =
        broken(&nominal(), &table_of("general_5_5"), &[(Phase::Prepare, Fault::ImuSilent, 0..FOR_EVER)]);
    let Err(FlightError::NotReady(Refusal::ArmingBlocked(bits))) = flight.result else {
        panic!("{:?}", flight.result);
    };
    let block = ArmingBlock(bits);
    assert!(
        block.contains(ArmingBlock::GYRO_SILENT) && block.contains(ArmingBlock::NOT_CALIBRATED),
        "{block}"
    );
    assert!(!flight.trace.samples.iter().any(turning));
}

// ---------------------------------------------------------------------------------------------------------- rotors

#[test]
fn a_dead_rotor_stops_the_motors() {
    for rotor in 0..4 {
        for (phase, delay) in
            [(Phase::TakeOff, 100), (Phase::Hover, 1000), (Phase::Maneuver, 300), (Phase::Land, 300)]
        {
            let flight = broken(
                &nominal(),
                &table_of("general_5_5"),
                &[(phase, Fault::RotorDead(rotor), delay * MS..FOR_EVER)],
            );
            let (state, reason) = flight.lost();
            assert_eq!(state, FlightState::Terminated, "{phase:?}, rotor {rotor}");
            assert!(
                matches!(reason, Some(AbortReason::Runaway | AbortReason::GyroSaturated)),
                "{phase:?}, rotor {rotor}: {reason:?}"
            );
            let off = flight.motors_off_after_s();
            assert!(off < 0.35, "{phase:?}, rotor {rotor}: {off} s");
        }
    }
}

// ---------------------------------------------------------------------------------------------------- motion capture

#[test]
fn without_cameras_the_motors_stop_within_a_second_and_a_fifth() {
    for (phase, delay) in [(Phase::Hover, 1000), (Phase::Maneuver, 200), (Phase::Catch, 300)] {
        let flight = broken(
            &nominal(),
            &table_of("horizontal_1"),
            &[(phase, Fault::MotionCaptureSilent, delay * MS..FOR_EVER)],
        );
        let error = flight.result.as_ref().expect_err("no cameras, no flight");
        assert!(matches!(error, FlightError::Connection(ConnectionError::NoPose)), "{phase:?}: {error}");
        assert!(flight.motors_off_after_s() < 1.2, "{phase:?}: {} s", flight.motors_off_after_s());
    }
}

/// Poses that repeat themselves are no poses: a host that steers by them drives the vehicle away.
#[test]
fn frozen_cameras_stop_the_motors_within_a_second_and_a_fifth() {
    for (phase, delay) in [
        (Phase::TakeOff, 500),
        (Phase::Hover, 500),
        (Phase::Maneuver, 200),
        (Phase::Catch, 300),
        (Phase::Land, 500),
    ] {
        let flight = broken(
            &nominal(),
            &table_of("horizontal_1"),
            &[(phase, Fault::MotionCaptureFrozen, delay * MS..FOR_EVER)],
        );
        assert!(flight.result.is_err(), "{phase:?}: {:?}", flight.result);
        assert!(flight.motors_off_after_s() < 1.2, "{phase:?}: {} s", flight.motors_off_after_s());
    }
}

/// Whatever the cameras do, the flight ends, and its motors with it.
#[test]
fn a_flight_by_frozen_cameras_ends() {
    for phase in [Phase::TakeOff, Phase::Hover, Phase::Maneuver, Phase::Catch, Phase::Land] {
        let fault = (phase, Fault::MotionCaptureFrozen, 200 * MS..FOR_EVER);
        // `broken` itself watches the motors afterwards.
        let flight = broken(&nominal(), &table_of("horizontal_1"), &[fault]);
        assert!(flight.motors_off_after_s() < 120.0, "{phase:?}: {} s", flight.motors_off_after_s());
    }
}

/// Cameras that look away for a moment: setpoints grow stale, the vehicle sinks, and is taken up again.
#[test]
fn a_blink_of_the_cameras_is_survived() {
    for blink_ms in [50, 90] {
        for fault in [Fault::MotionCaptureSilent, Fault::MotionCaptureFrozen] {
            let flight = broken(
                &nominal(),
                &table_of("horizontal_1"),
                &[(Phase::Maneuver, fault, 100 * MS..(100 + blink_ms) * MS)],
            );
            flight.completed();
        }
    }
}

// ---------------------------------------------------------------------------------------------------------- the line

/// A bad line: the flight is flown all the same, or ends with a reason and standing motors.
#[test]
fn a_bad_line_costs_time_or_the_flight_but_nothing_else() {
    let table = table_of("horizontal_1");
    let mut completed = 0;
    for (seed, one_in) in [(1, 3000), (2, 1000), (3, 400), (4, 100), (5, 40), (6, 15), (7, 5)] {
        let noise = Some(Noise { state: 0x9e37_79b9_7f4a_7c15 ^ seed, one_in });
        let mut rig = Breaking { noise, ..Breaking::new(hosted(&nominal(), seed, &table)) };
        let result = fly(&mut rig, &plan_of(table.clone()), &mut Silent);
        match &result {
            // So many setpoints lost that it never hovered calmly enough: landed again.
            Ok(flight) if flight.outcome == Outcome::NotTriggered => assert!(flight.reason.is_some()),
            Ok(flight) => {
                assert_eq!(flight.outcome, Outcome::Completed, "1 in {one_in}: {:?}", flight.reason);
                // The record that came over this line is whole.
                let seconds: f64 = flight.record.iter().map(|t| f64::from(t.interval_us) * 1e-6).sum();
                assert!((seconds - f64::from(table.duration_s())).abs() < 3e-3, "{seconds}");
                completed += 1;
            }
            Err(error) => assert!(
                matches!(
                    error,
                    FlightError::Client { source: ClientError::Silent, .. } | FlightError::Lost { .. }
                ),
                "1 in {one_in}: {error}"
            ),
        }
        // The host gives up trying at last; the vehicle's own timeouts must not need it.
        let end_ns = rig.vehicle.now_ns() + 1700 * MS;
        while rig.vehicle.now_ns() < end_ns + 1000 * MS {
            rig.vehicle.next_pose().expect("cameras work");
        }
        let trace = rig.vehicle.into_trace();
        assert!(!trace.samples.iter().any(|s| s.time_ns > end_ns && turning(s)), "1 in {one_in}: {result:?}");
    }
    assert!(completed >= 3, "only {completed} of the good lines brought a flight home");
}

/// A vehicle on the bench, by hand through the real client.
struct ByHand {
    vehicle: HostedVehicle,
    client: Client,
    now_s: f64,
}

impl ByHand {
    fn new(parameters: &VehicleParameters, heading_rad: f64) -> Self {
        let vehicle = HostedVehicle::new(&scene(parameters, 5, heading_rad, 1.0)).expect("sound parameters");
        Self { vehicle, client: Client::default(), now_s: 0.0 }
    }

    fn step(&mut self) -> Option<Result<Reply, Refusal>> {
        self.now_s = self.vehicle.next_pose().expect("cameras work").arrived_s;
        match self.client.poll(&mut self.vehicle, self.now_s) {
            Ok(reply) => reply.map(Ok),
            Err(ClientError::Refused(refusal)) => Some(Err(refusal)),
            Err(error) => panic!("{error}"),
        }
    }

    fn ask(&mut self, request: Request) -> Result<Reply, Refusal> {
        self.client.ask(&mut self.vehicle, request, self.now_s).expect("the line works");
        loop {
            if let Some(answer) = self.step() {
                return answer;
            }
        }
    }

    fn wait(&mut self, seconds: f64) {
        let until = self.now_s + seconds;
        while self.now_s < until {
            self.step();
        }
    }

    fn fly(&mut self, setpoint: Setpoint, seconds: f64) {
        let until = self.now_s + seconds;
        while self.now_s < until {
            self.client.stream(&mut self.vehicle, setpoint).expect("the line works");
            self.step();
        }
    }

    fn telemetry(&mut self) -> mintime_shared::messages::Telemetry {
        match self.ask(Request::Status) {
            Ok(Reply::Status(telemetry)) => telemetry,
            other => panic!("{other:?}"),
        }
    }

    fn armed(parameters: &VehicleParameters, heading_rad: f64) -> Self {
        let mut hand = Self::new(parameters, heading_rad);
        hand.wait(1.5);
        hand.commit(&table_of("horizontal_1"));
        assert_eq!(hand.ask(Request::Arm(Purpose::Flight)), Ok(Reply::Done));
        hand
    }

    fn commit(&mut self, table: &ManeuverTable) {
        for request in chunks_of(table) {
            let staged = self.ask(request);
            assert!(matches!(staged, Ok(Reply::Staged { .. })), "{staged:?}");
        }
        let committed = self.ask(Request::CommitTable { checksum: table.checksum() });
        assert!(matches!(committed, Ok(Reply::Committed { .. })), "{committed:?}");
    }
}

fn bytes_of(table: &ManeuverTable) -> heapless::Vec<u8, MAX_TABLE_BYTES> {
    let mut buffer = [0; MAX_TABLE_BYTES];
    let length = table.encode(&mut buffer).expect("it fits");
    heapless::Vec::from_slice(&buffer[..length]).expect("it fits")
}

fn chunks_of(table: &ManeuverTable) -> Vec<Request> {
    let bytes = bytes_of(table);
    let pieces = bytes.chunks(STAGE_CHUNK_BYTES).enumerate();
    let stage = |(n, piece): (usize, &[u8])| Request::Stage {
        total: bytes.len() as u16,
        offset: (n * STAGE_CHUNK_BYTES) as u16,
        bytes: heapless::Vec::from_slice(piece).expect("a chunk"),
    };
    pieces.map(stage).collect()
}

/// What a bad host or a bad cable may send to an armed vehicle: each is counted or refused, and nothing changes.
#[test]
fn bad_input_on_the_line_changes_nothing() {
    let mut hand = ByHand::armed(&nominal(), 0.0);
    let before = hand.telemetry();
    assert_eq!((before.state, before.link_errors), (FlightState::Armed, 0));
    let table = hand.ask(Request::ReadTable);
    assert_eq!(table, Ok(Reply::Table(bytes_of(&table_of("horizontal_1")))));

    let stop = Uplink { version: PROTOCOL_VERSION, number: 1, request: Request::EmergencyStop, heard_ms: 0 };
    let frame = encode(&stop).expect("it fits").as_bytes().to_vec();
    // Every truncation of an emergency stop, closed by a zero: not one is taken for one.
    for length in 1..frame.len() - 1 {
        hand.vehicle.send(&[&frame[..length], &[0]].concat()).expect("the line works");
    }
    // A frame of noise, a frame far too long, and one of another protocol.
    let mut noise = Noise { state: 77, one_in: 2 };
    let bytes: Vec<u8> = (0..3000).map(|_| (noise.draw() >> 20) as u8).collect();
    hand.vehicle.send(&bytes).expect("the line works");
    hand.vehicle.send(&[0]).expect("the line works");
    hand.vehicle.send(&[vec![0x55; 2000], vec![0]].concat()).expect("the line works");
    let foreign = encode(&Uplink { version: PROTOCOL_VERSION + 1, ..stop }).expect("it fits");
    hand.vehicle.send(foreign.as_bytes()).expect("the line works");
    hand.wait(0.3);
    let after = hand.telemetry();
    assert_eq!((after.state, after.abort, after.table), (FlightState::Armed, None, before.table));
    assert!(after.link_errors as usize >= frame.len() - 2 + 2, "{} errors", after.link_errors);

    // An upload while armed.
    let other = table_of("general_5_5");
    assert_eq!(hand.ask(chunks_of(&other)[0].clone()), Err(Refusal::MotorsOn));
    assert_eq!(hand.ask(Request::CommitTable { checksum: other.checksum() }), Err(Refusal::MotorsOn));
    assert_eq!(hand.ask(Request::ReadTable), table);
    let bad = Setpoint { rates_radps: [f32::NAN, 0.0, 0.0], thrust_mps2: 15.0 };
    assert_eq!(hand.ask(Request::Setpoint { sequence: u16::MAX, setpoint: bad }), Err(Refusal::NotFinite));
    assert_eq!(hand.telemetry().state, FlightState::Armed);
    let last = hand.vehicle.into_trace().last.expect("truth");
    assert!(last.on_ground && last.contacts == 0);
}

// ---------------------------------------------------------------------------------------------------- axes and signs

/// Each axis through setpoint, throttle, airframe and gyro, on both models.
#[test]
fn every_axis_has_one_sign_from_end_to_end() {
    // Louder motors (1 to 4: rear right, front right, rear left, front left) for a positive rate.
    let louder = [[false, false, true, true], [true, false, true, false], [true, false, false, true]];
    for (parameters, rigid) in [(nominal(), true), (VehicleParameters::ideal(), false)] {
        for axis in 0..3 {
            for sign in [1.0, -1.0f32] {
                let mut hand = ByHand::armed(&parameters, 0.0);
                hand.fly(Setpoint { rates_radps: [0.0; 3], thrust_mps2: 11.0 }, 1.0);
                let mut rates_radps = [0.0; 3];
                rates_radps[axis] = sign;
                hand.fly(Setpoint { rates_radps, thrust_mps2: 10.0 }, 0.3);
                let trace = hand.vehicle.into_trace();
                let turn: Vec<&FlightSample> =
                    trace.samples.iter().filter(|s| s.setpoint_radps[axis] == sign).collect();
                assert!(turn.len() > 20, "{}", turn.len());
                if rigid {
                    let first = turn[0].throttle;
                    let mean = first.iter().sum::<f32>() / 4.0;
                    let want = louder[axis].map(|l| l == (sign > 0.0));
                    assert_eq!(first.map(|t| t > mean), want, "axis {axis}, {sign}: {first:?}");
                }
                let last = turn[turn.len() - 1];
                let gyro = last.gyro_radps.expect("a sample");
                for i in 0..3 {
                    let want = if i == axis { f64::from(sign) } else { 0.0 };
                    assert!((last.truth.body_rates_radps[i] - want).abs() < 0.3, "axis {axis}: {last:?}");
                    assert!((f64::from(gyro[i]) - want).abs() < 0.4, "axis {axis}: {gyro:?}");
                }
                // What it does to the airframe in the world: roll right goes right (−y), nose down forward (+x),
                // yaw left turns the nose towards +y.
                let (from, to) = (turn[0].truth.velocity_mps, last.truth.velocity_mps);
                let [_, towards_y, ahead] = [0.0, to[1] - from[1], to[0] - from[0]];
                let sign = f64::from(sign);
                match axis {
                    0 => assert!(-sign * towards_y > 0.2 && ahead.abs() < 0.2, "{from:?} {to:?}"),
                    1 => {
                        assert!(sign * ahead > 0.2 && towards_y.abs() < 0.2, "{from:?} {to:?}");
                        assert!(sign * last.truth.planar.theta > 0.2, "{:?}", last.truth.planar);
                    }
                    _ => {
                        let [w, _, _, z] = last.truth.attitude_wxyz;
                        let heading = 2.0 * z.atan2(w);
                        assert!(sign * heading > 0.2, "{heading}");
                    }
                }
            }
        }
    }
}

/// Rate of turn in the plane of a heading, by the right-hand rule about the axis to its left.
fn in_plane([roll, pitch, _]: [f64; 3], heading: f64) -> f64 {
    pitch * heading.cos() - roll * heading.sin()
}

/// A maneuver in +x moves along the heading that the table states, whichever it is, and the vehicle does not yaw there.
#[test]
fn a_maneuver_goes_where_its_heading_points() {
    for heading_rad in [0.0f32, 1.0, -2.5, -2.356_194_5, 1.570_796_4] {
        for parameters in [nominal(), VehicleParameters::ideal()] {
            let mut table = table_of("horizontal_3");
            table.heading_rad = heading_rad;
            let mut vehicle = hosted(&parameters, 2, &table);
            let result = fly(&mut vehicle, &plan_of(table.clone()), &mut Silent).expect("a flight");
            assert_eq!(result.outcome, Outcome::Completed, "{:?}", result.reason);
            let trace = vehicle.into_trace();
            let (start, end) = (trace.start.expect("it began"), trace.end.expect("it ended"));
            let heading = f64::from(heading_rad);
            let moved = [end.position_m[0] - start.position_m[0], end.position_m[1] - start.position_m[1]];
            let along = moved[0] * heading.cos() + moved[1] * heading.sin();
            let across = moved[1] * heading.cos() - moved[0] * heading.sin();
            assert!((along - 3.0).abs() < 0.8 && across.abs() < 0.5, "{heading}: {moved:?}");
            // Tipped towards the heading first, and the gyro saw it about the axis to the left of it.
            let began = trace.start_ns.expect("it began");
            let early: Vec<&FlightSample> = trace
                .samples
                .iter()
                .filter(|s| (began + 60 * MS..began + 120 * MS).contains(&s.time_ns))
                .collect();
            assert!(!early.is_empty());
            for s in early {
                let asked = in_plane(s.setpoint_radps.map(f64::from), heading);
                assert!(asked > 0.0 || s.truth.planar.theta > 0.3, "{s:?}");
                assert!(s.truth.planar.theta > 0.1, "{s:?}");
            }
            let record: f64 = result
                .record
                .iter()
                .take(120)
                .filter_map(|t| {
                    t.gyro_radps
                        .map(|g| in_plane(g.map(f64::from), heading) * f64::from(t.interval_us) * 1e-6)
                })
                .sum();
            // The nose has stayed where it was.
            assert!(start.heading_rad().abs() < 0.02, "{}", start.heading_rad());
            assert!(record > 0.5, "{record} rad by the gyro");
        }
    }
}

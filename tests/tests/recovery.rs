//! A vehicle whose host falls silent in the air: it levels, sinks, and stops its motors on the ground or when its time is
//! over, by its own sensors.

use mintime::flight::{
    Connection, ConnectionError, FlightPlan, HostedVehicle, Phase, Pose, Scene, Trace, Witness, fly,
};
use mintime::flight_log::FlightSample;
use mintime_shared::framing::{Decoder, encode};
use mintime_shared::messages::{Downlink, FlightState, Message, PROTOCOL_VERSION, Request, Uplink};
use mintime_shared::settings::Settings;
use mintime_shared::table::ManeuverTable;
use mintime_shared::vehicle::VehicleConfig;
use mintime_simulator::VehicleParameters;
use mintime_tests::reference_cases;
use nalgebra::{Quaternion, UnitQuaternion, Vector3};

const MS: u64 = 1_000_000;
/// What a recovery may be longer than it was set to, s.
const LATE_S: f64 = 0.2;
/// Higher than this nothing stands on the ground, m.
const TOUCHING_M: f64 = 0.15;
/// A setpoint is flown for this long, and telemetry is as old as this at most, s.
const FRESH_S: f64 = 0.1;

struct Silent;

impl Witness for Silent {
    fn phase(&mut self, _: Phase, _: f64) {}
    fn event(&mut self, _: f64, _: &str) {}
}

/// A line that is cut, behind setpoints that tip the vehicle if so wanted.
struct Cut {
    vehicle: HostedVehicle,
    /// In which phase, and how long after its beginning, ns.
    when: (Phase, u64),
    /// About forward and left, rad/s, in the last 50 ms and for as long as the last setpoint stays fresh.
    tips_radps: [f32; 2],
    cut_ns: Option<u64>,
    /// Told to the vehicle before all else.
    settings: Option<Settings>,
    to_vehicle: Decoder,
    to_host: Decoder,
    /// When which state was told of first, ns.
    states: Vec<(u64, FlightState)>,
}

impl Connection for Cut {
    fn next_pose(&mut self) -> Result<Pose, ConnectionError> {
        self.vehicle.next_pose()
    }

    fn send(&mut self, bytes: &[u8]) -> Result<(), ConnectionError> {
        if let Some(settings) = self.settings.take() {
            let request = Request::WriteSettings(settings);
            let uplink = Uplink { version: PROTOCOL_VERSION, number: u16::MAX, request, heard_ms: 0 };
            self.vehicle.send(encode(&uplink).expect("it fits").as_bytes())?;
        }
        let now_ns = self.vehicle.now_ns();
        for byte in bytes {
            let Some(Ok(mut uplink)) = self.to_vehicle.push::<Uplink>(*byte) else { continue };
            let cut_ns = self.cut_ns.unwrap_or(u64::MAX);
            if now_ns >= cut_ns {
                continue;
            }
            if let Request::Setpoint { setpoint, .. } = &mut uplink.request
                && now_ns + 50 * MS >= cut_ns
                && self.tips_radps != [0.0; 2]
            {
                setpoint.rates_radps[..2].copy_from_slice(&self.tips_radps);
            }
            self.vehicle.send(encode(&uplink).expect("it fits").as_bytes())?;
        }
        Ok(())
    }

    fn receive(&mut self, into: &mut Vec<u8>) -> Result<(), ConnectionError> {
        let from = into.len();
        self.vehicle.receive(into)?;
        for byte in &into[from..] {
            if let Some(Ok(Downlink { message: Message::Telemetry(told), .. })) = self.to_host.push(*byte)
                && self.states.last().is_none_or(|(_, last)| *last != told.state)
            {
                self.states.push((self.vehicle.now_ns(), told.state));
            }
        }
        Ok(())
    }

    fn enter(&mut self, phase: Phase) {
        if phase == self.when.0 {
            self.cut_ns = Some(self.vehicle.now_ns() + self.when.1);
        }
        self.vehicle.enter(phase);
    }
}

/// What became of it.
struct Recovered {
    trace: Trace,
    ground_m: f64,
    /// How long it may last, s.
    most_s: f64,
    began_ns: u64,
    /// What it ended as, and when, ns.
    end: FlightState,
    end_ns: u64,
}

fn table_of(name: &str) -> ManeuverTable {
    reference_cases().into_iter().find(|case| case.name == name).expect("the case exists").table()
}

/// A vehicle whose thrust is this much more than it was told.
fn stronger(by: f64) -> VehicleParameters {
    let mut parameters = VehicleParameters::nominal();
    parameters.rotors.thrust_coefficient_ns2 *= 1.0 + by;
    parameters
}

/// Flies over a ground so far below the maneuver's start until the line is cut, and watches what follows.
fn cut(
    parameters: &VehicleParameters,
    name: &str,
    height_m: f64,
    when: (Phase, u64),
    tips_radps: [f32; 2],
) -> Recovered {
    cut_with(Settings::DEFAULT, parameters, name, height_m, when, tips_radps)
}

fn cut_with(
    settings: Settings,
    parameters: &VehicleParameters,
    name: &str,
    height_m: f64,
    when: (Phase, u64),
    tips_radps: [f32; 2],
) -> Recovered {
    let table = table_of(name);
    let scene = Scene {
        parameters,
        seed: 3,
        ground_z_m: -height_m,
        heading_rad: 0.0,
        maneuver_s: f64::from(table.duration_s()),
    };
    let mut line = Cut {
        vehicle: HostedVehicle::new(&scene).expect("sound parameters"),
        when,
        tips_radps,
        cut_ns: None,
        settings: Some(settings),
        to_vehicle: Decoder::new(),
        to_host: Decoder::new(),
        states: Vec::new(),
    };
    let plan = FlightPlan::new(table, Vector3::zeros(), Some(VehicleConfig::REFERENCE));
    let result = fly(&mut line, &plan, &mut Silent);
    let cut_ns = line.cut_ns.unwrap_or_else(|| panic!("the phase never came: {result:?}"));
    while line.vehicle.now_ns() < cut_ns + 7000 * MS {
        line.next_pose().expect("the cameras see it");
        line.receive(&mut Vec::new()).expect("a line");
    }
    let at = line.states.iter().rposition(|(_, state)| *state == FlightState::Recovery);
    let at = at.unwrap_or_else(|| panic!("no recovery: {:?}", line.states));
    let (began_ns, _) = line.states[at];
    let (end_ns, end) = *line.states.get(at + 1).expect("it ended");
    Recovered {
        trace: line.vehicle.into_trace(),
        ground_m: -height_m,
        most_s: f64::from(settings.recovery_ms) * 1e-3,
        began_ns,
        end,
        end_ns,
    }
}

fn tilt_rad(sample: &FlightSample) -> f64 {
    let [w, x, y, z] = sample.truth.attitude_wxyz;
    let attitude = UnitQuaternion::from_quaternion(Quaternion::new(w, x, y, z));
    (attitude * Vector3::z()).z.clamp(-1.0, 1.0).acos()
}

impl Recovered {
    fn height_m(&self, sample: &FlightSample) -> f64 {
        sample.truth.position_m[2] - self.ground_m
    }

    /// While its motors turned in the recovery.
    fn samples(&self) -> impl Iterator<Item = &FlightSample> {
        let turning = |s: &&FlightSample| s.throttle.iter().any(|t| *t > 0.0);
        self.trace.samples.iter().filter(|s| s.time_ns >= self.began_ns).take_while(turning)
    }

    /// The last sample with turning motors.
    fn last(&self) -> &FlightSample {
        self.samples().last().expect("it recovered")
    }

    /// What holds of every recovery.
    fn check(&self, story: &str) {
        let lasted_s = (self.end_ns - self.began_ns) as f64 * 1e-9;
        assert!(lasted_s < self.most_s + LATE_S, "{story}: {lasted_s} s");
        assert!(matches!(self.end, FlightState::Landed | FlightState::Terminated), "{story}: {:?}", self.end);
        let last_m = self.height_m(self.last());
        if self.end == FlightState::Landed {
            assert!(last_m < TOUCHING_M, "{story}: landed at {last_m} m after {lasted_s} s");
        } else {
            assert!(lasted_s > self.most_s - FRESH_S, "{story}: given up after {lasted_s} s");
        }
        // Nothing turns again.
        let after = self.trace.samples.iter().filter(|s| s.time_ns > self.end_ns);
        assert!(after.clone().count() > 100, "nobody watched");
        assert!(
            !after.into_iter().any(|s| s.throttle.iter().any(|t| *t > 0.0)),
            "{story}: motors turn again"
        );
    }

    /// Level from half a second on.
    fn check_level(&self, story: &str) {
        let late = self.samples().filter(|s| s.time_ns >= self.began_ns + 500 * MS);
        let worst = late.map(tilt_rad).fold(0.0, f64::max);
        assert!(worst < 0.3, "{story}: {worst} rad");
    }

    fn check_sink(&self, story: &str) {
        let mut speeds = self.samples().map(|s| -s.truth.velocity_mps[2]);
        let first = speeds.next().expect("it recovered").max(0.0);
        let fastest = speeds.fold(f64::MIN, f64::max);
        // A maneuver may leave it on its way down.
        assert!(fastest - first < 3.0, "{story}: {fastest} m/s, {first} m/s at the beginning");
        assert!(fastest > 0.2, "{story}: it does not sink, {fastest} m/s");
    }
}

#[test]
fn a_hover_is_levelled_and_sinks() {
    for by in [-0.1, 0.0, 0.1] {
        let story = format!("{by}");
        let hover = cut(&stronger(by), "general_5_5", 3.0, (Phase::Hover, 1000 * MS), [0.0; 2]);
        hover.check(&story);
        hover.check_level(&story);
        hover.check_sink(&story);
    }
}

#[test]
fn near_the_ground_it_stands_and_knows() {
    // As it is by default it is sure in time from a hand's breadth; from higher up where it has the time.
    let longer = Settings { recovery_ms: 3500, ..Settings::DEFAULT };
    for (settings, height_m) in [(Settings::DEFAULT, 0.2), (Settings::DEFAULT, 0.8), (longer, 0.8)] {
        for by in [-0.1, 0.0, 0.1] {
            let story = format!("{height_m} m, {} ms, {by}", settings.recovery_ms);
            let when = (Phase::Hover, 1000 * MS);
            let hover = cut_with(settings, &stronger(by), "general_5_5", height_m, when, [0.0; 2]);
            println!("{story}: {:?} after {} s", hover.end, (hover.end_ns - hover.began_ns) as f64 * 1e-9);
            hover.check(&story);
            hover.check_level(&story);
            let in_time = height_m < 0.5 || settings == longer;
            assert!(hover.end == FlightState::Landed || !in_time, "{story}: {:?}", hover.end);
            assert!(hover.height_m(hover.last()) < 0.02, "{story}: {:?}", hover.last());
            let last = hover.trace.last.as_ref().expect("truth");
            assert!(last.on_ground && !last.crashed, "{story}");
        }
    }
}

#[test]
fn the_end_of_a_maneuver_is_not_taken_for_the_ground() {
    for (name, by) in [
        ("vertical_3", 0.0),
        ("vertical_6", 0.0),
        ("vertical_6", -0.1),
        ("vertical_6", 0.1),
        ("general_5_5", 0.0),
        ("general_5_5", -0.1),
        ("general_5_5", 0.1),
    ] {
        // On the way, so that it recovers as soon as the maneuver is over; and with the host there for a moment.
        for when in [(Phase::Maneuver, 500 * MS), (Phase::Catch, 0), (Phase::Catch, 150 * MS)] {
            let story = format!("{name}, {by}, {when:?}");
            let flight = cut(&stronger(by), name, 3.0, when, [0.0; 2]);
            flight.check(&story);
            flight.check_level(&story);
            flight.check_sink(&story);
        }
    }
}

#[test]
fn thirty_degrees_of_tilt_are_righted() {
    for (tips_radps, by) in
        [([0.0, 3.5], 0.0), ([0.0, 3.5], -0.1), ([-3.5, 0.0], 0.1), ([2.5, -2.5], 0.0), ([2.5, 2.5], 0.1)]
    {
        let story = format!("{tips_radps:?}, {by}");
        let tipped = cut(&stronger(by), "general_5_5", 3.0, (Phase::Hover, 1000 * MS), tips_radps);
        let first = tilt_rad(tipped.samples().next().expect("it recovered"));
        assert!((0.4..0.7).contains(&first), "{story}: {first} rad");
        tipped.check(&story);
        tipped.check_level(&story);
        tipped.check_sink(&story);
    }
}

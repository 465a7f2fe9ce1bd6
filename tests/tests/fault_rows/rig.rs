//! A virtual vehicle with a small host, brought into each phase once and forked from there.

use std::sync::{Arc, Mutex};

use emulator::boards::MotorUpdate;
use emulator::core::Timing;
use mintime::flight::{
    Calmness, Client, ClientError, Connection, ConnectionError, Estimator, Line, Reference, Scene,
    VirtualVehicle, control,
};
use mintime_shared::messages::{FlightState, Refusal, Reply, Request, STAGE_CHUNK_BYTES, Telemetry};
use mintime_shared::model::GRAVITY_MPS2;
use mintime_shared::table::ManeuverTable;
use mintime_simulator::VehicleParameters;
use mintime_tests::reference_cases;
use nalgebra::Vector3;

use crate::bench::{Board, image};

pub(crate) const MS: u64 = 1_000_000;
/// The ground, m below the start.
pub(super) const GROUND_M: f64 = -1.5;
/// A speed controller stops its motor after this long without a frame.
const SIGNAL_TIMEOUT_NS: u64 = 100 * MS;
/// Thrust is changed by this in a hop, m/s², ...
const HOP_STEP_MPS2: f32 = 2.0;
/// ... for so long in either direction.
const HOP_PULSE_NS: u64 = 150 * MS;
/// An answer takes no longer than this, ms: a write to flash and the start after a reset included.
const ANSWER_MS: u64 = 3000;

/// What the host does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Host {
    /// Nothing.
    Silent,
    /// It says that it is there.
    Beats,
    /// It holds the vehicle at the start.
    Flies,
    /// The same, but for a hop that began then, ns: thrust open-loop, more and then less.
    Hops(u64),
}

impl Host {
    /// The thrust of a hop, where it is in one.
    fn hop_mps2(self, now_ns: u64) -> Option<f32> {
        let Self::Hops(began_ns) = self else { return None };
        let half = now_ns.saturating_sub(began_ns) / HOP_PULSE_NS;
        let step_mps2 = [HOP_STEP_MPS2, -HOP_STEP_MPS2].get(half as usize)?;
        Some(GRAVITY_MPS2 as f32 + step_mps2)
    }
}

/// What becomes of bytes on their way to the vehicle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Damage {
    None,
    /// One message in three has a bit flipped.
    FlippedBits,
    /// One message in three misses a byte.
    LostBytes,
    /// Arbitrary bytes, noisy ones and breaks between the messages.
    Noise,
    /// As many bytes as the line carries.
    FullLoad,
}

/// The line to the vehicle.
struct Wire<'a> {
    vehicle: &'a mut VirtualVehicle,
    damage: Damage,
    random: &'a mut u64,
}

impl Line for Wire<'_> {
    fn send(&mut self, bytes: &[u8]) -> Result<(), ConnectionError> {
        let mut bytes = bytes.to_vec();
        let struck = draw(self.random).is_multiple_of(3);
        let place = draw(self.random) as usize;
        match self.damage {
            Damage::FlippedBits if struck => {
                let bit = place % (bytes.len() * 8);
                bytes[bit / 8] ^= 1 << (bit % 8);
            }
            Damage::LostBytes if struck => {
                bytes.remove(place % bytes.len());
            }
            _ => {}
        }
        Connection::send(self.vehicle, &bytes)
    }

    fn receive(&mut self, into: &mut Vec<u8>) -> Result<(), ConnectionError> {
        Connection::receive(self.vehicle, into)
    }
}

pub(crate) fn draw(state: &mut u64) -> u64 {
    *state ^= *state << 13;
    *state ^= *state >> 7;
    *state ^= *state << 17;
    *state >> 24
}

pub(crate) struct Rig {
    pub(crate) vehicle: VirtualVehicle,
    pub(crate) client: Client,
    pub(crate) host: Host,
    pub(crate) damage: Damage,
    /// Done with each pose.
    pub(crate) every_pose: Option<fn(&mut Board)>,
    pub(crate) random: u64,
    symbols: Arc<Vec<(String, u32)>>,
    estimator: Estimator,
    pub(super) calmness: Calmness,
    pub(super) height_m: f64,
    pub(super) table: ManeuverTable,
    frames: Arc<Mutex<Vec<MotorUpdate>>>,
}

impl Rig {
    pub(super) fn new() -> Self {
        let table =
            reference_cases().into_iter().find(|c| c.name == "horizontal_1").expect("the case").table();
        let scene = Scene {
            parameters: &VehicleParameters::nominal(),
            seed: 21,
            ground_z_m: GROUND_M,
            heading_rad: 0.0,
            maneuver_s: f64::from(table.duration_s()),
        };
        let elf = image().elf();
        Self {
            vehicle: VirtualVehicle::new(&scene, elf, Timing::Pessimistic).expect("the image loads"),
            client: Client::default(),
            host: Host::Beats,
            damage: Damage::None,
            every_pose: None,
            random: 0x1234_5678_9ABC_DEF1,
            symbols: Arc::new(emulator::machine::symbols(elf).expect("symbols")),
            estimator: Estimator::new(),
            calmness: Calmness::Grounded,
            height_m: GROUND_M,
            table,
            frames: Arc::default(),
        }
    }

    /// A copy that goes on by itself; motor frames are counted from now on.
    pub(super) fn fork(&self) -> Self {
        let mut vehicle = self.vehicle.fork();
        let frames = Arc::new(Mutex::new(Vec::new()));
        let seen = Arc::clone(&frames);
        vehicle.observe_motors(move |update| seen.lock().expect("nobody panics").push(*update));
        Self {
            vehicle,
            client: self.client.clone(),
            symbols: Arc::clone(&self.symbols),
            estimator: self.estimator.clone(),
            table: self.table.clone(),
            frames,
            ..*self
        }
    }

    /// The board.
    pub(crate) fn board(&mut self) -> &mut Board {
        self.vehicle.machine_mut()
    }

    /// Address of the one symbol that is called so, or whose mangled name has all of these parts.
    pub(crate) fn symbol(&self, parts: &[&str]) -> u32 {
        let exact = self.symbols.iter().find(|(name, _)| parts == [name.as_str()]);
        let mut found = self.symbols.iter().filter(|(name, _)| parts.iter().all(|part| name.contains(part)));
        match (exact, found.next(), found.next()) {
            (Some((_, address)), ..) | (None, Some((_, address)), None) => *address,
            other => panic!("{parts:?}: {other:?}"),
        }
    }

    /// Addresses of all symbols whose mangled names have all of these parts.
    pub(crate) fn symbols_with(&self, parts: &[&str]) -> Vec<u32> {
        let found = self.symbols.iter().filter(|(name, _)| parts.iter().all(|part| name.contains(part)));
        found.map(|(_, address)| *address & !1).collect()
    }

    /// The state that the last tick ended in.
    pub(crate) fn state(&self) -> FlightState {
        self.vehicle.states().last().map_or(FlightState::Boot, |(_, state)| *state)
    }

    /// It stands on the ground, lifted by nobody.
    pub(super) fn assert_stands(&mut self) {
        let height_m = self.vehicle.simulator_mut().truth().position_m[2] - GROUND_M;
        assert!(height_m.abs() < 0.01, "{height_m} m");
    }

    pub(crate) fn bugs(&self) -> Vec<String> {
        self.vehicle.report().bugs
    }

    fn now_s(&self) -> f64 {
        self.vehicle.now_ns() as f64 * 1e-9
    }

    /// One pose; where none comes the host does what it does in flight: it stops the motors, and streams no more.
    pub(crate) fn step(&mut self) -> Option<Result<Reply, Refusal>> {
        let pose = match self.vehicle.next_pose() {
            Ok(pose) => pose,
            Err(ConnectionError::NoPose) => {
                self.host = Host::Silent;
                self.begin(Request::EmergencyStop);
                return None;
            }
            Err(error) => panic!("{error}"),
        };
        let now_s = self.now_s();
        let estimate = self.estimator.update(&pose, self.calmness);
        if let Some(act) = self.every_pose {
            act(self.vehicle.machine_mut());
        }
        self.spoil();
        let hop_mps2 = self.host.hop_mps2(self.vehicle.now_ns());
        let mut wire = Wire { vehicle: &mut self.vehicle, damage: self.damage, random: &mut self.random };
        match self.host {
            Host::Silent => {}
            Host::Beats => self.client.heartbeat(&mut wire).expect("a line"),
            Host::Flies | Host::Hops(_) => {
                let reference = Reference::hold(Vector3::new(0.0, 0.0, self.height_m), 0.0);
                let mut setpoint = control(&estimate, &reference);
                if let Some(thrust_mps2) = hop_mps2 {
                    setpoint.thrust_mps2 = thrust_mps2;
                }
                self.client.stream(&mut wire, setpoint).expect("a line");
                self.estimator.note_command(now_s, setpoint);
            }
        }
        match self.client.poll(&mut wire, now_s) {
            Ok(None) | Err(ClientError::Silent) => None,
            Ok(Some(reply)) => Some(Ok(reply)),
            Err(ClientError::Refused(refusal)) => Some(Err(refusal)),
            Err(error) => panic!("{error}"),
        }
    }

    /// Puts onto the line what nobody meant.
    fn spoil(&mut self) {
        let chip = &mut self.vehicle.machine_mut().peripherals;
        let ns = chip.clock().ns(chip.now());
        match self.damage {
            Damage::Noise => {
                let bytes: Vec<u8> = (0..30).map(|_| draw(&mut self.random) as u8).collect();
                chip.link_send(ns, &bytes);
                chip.serial_send_noisy(1, ns, 0x55);
                chip.serial_break(1, ns, 300_000);
            }
            Damage::FullLoad => {
                // 92 bytes a millisecond, 5 ms to the next pose, and a frame of the host's.
                let room = 430_usize.saturating_sub(chip.serial_queued(1));
                let mut bytes = Vec::new();
                while bytes.len() < room {
                    bytes.extend(load_frame());
                }
                bytes.truncate(room);
                bytes.push(0);
                chip.link_send(ns, &bytes);
            }
            Damage::None | Damage::FlippedBits | Damage::LostBytes => {}
        }
    }

    pub(crate) fn pass_ms(&mut self, ms: u64) {
        let end = self.vehicle.now_ns() + ms * MS;
        while self.vehicle.now_ns() < end {
            self.step();
        }
    }

    /// Asks and waits for the answer. The line is whole for it.
    #[allow(clippy::needless_pass_by_value, reason = "requests are made where they are asked")]
    pub(crate) fn ask(&mut self, request: Request) -> Result<Reply, Refusal> {
        let end = self.vehicle.now_ns() + ANSWER_MS * MS;
        while self.vehicle.now_ns() < end {
            self.begin(request.clone());
            // The client gives up after ten tries, half a second; a board that starts needs longer.
            for _ in 0..100 {
                if let Some(answer) = self.step() {
                    return answer;
                }
            }
        }
        panic!("{request:?}: no answer");
    }

    /// Asks and does not wait.
    pub(crate) fn begin(&mut self, request: Request) {
        let now_s = self.now_s();
        let mut wire = Wire { vehicle: &mut self.vehicle, damage: Damage::None, random: &mut self.random };
        self.client.ask(&mut wire, request, now_s).expect("a line");
    }

    pub(crate) fn status(&mut self) -> Telemetry {
        match self.ask(Request::Status) {
            Ok(Reply::Status(telemetry)) => telemetry,
            other => panic!("{other:?}"),
        }
    }

    /// When the last motor of those that turned since the fork stood still, by what its speed controller was told or missed,
    /// ns; `None` while one turns.
    pub(crate) fn stopped_ns(&self) -> Option<u64> {
        let frames = self.frames.lock().expect("nobody panics");
        let now_ns = self.vehicle.now_ns();
        let stopped = |motor: usize| {
            let mut own = frames.iter().filter(|u| u.motor == motor).peekable();
            let mut stopped_ns = 0;
            while let Some(frame) = own.next() {
                if frame.value != 0 {
                    let next_ns = own.peek().map_or(u64::MAX, |next| next.ns);
                    stopped_ns = next_ns.min(frame.ns + SIGNAL_TIMEOUT_NS);
                }
            }
            stopped_ns
        };
        let last_ns = (0..4).map(stopped).max().unwrap_or(0);
        (last_ns <= now_ns).then_some(last_ns)
    }

    /// Whether a motor was told to turn after this time.
    pub(crate) fn turned_after(&self, ns: u64) -> bool {
        self.frames.lock().expect("nobody panics").iter().any(|u| u.ns > ns && u.value != 0)
    }

    /// Whether a motor was ever told to turn since the fork.
    pub(crate) fn ever_turned(&self) -> bool {
        self.turned_after(0)
    }
}

/// A frame that costs the vehicle much: a chunk of a table, refused while the motors turn.
fn load_frame() -> Vec<u8> {
    use mintime_shared::framing::Frame;
    use mintime_shared::messages::{PROTOCOL_VERSION, Uplink};
    let bytes = heapless::Vec::from_slice(&[0x5A; STAGE_CHUNK_BYTES]).expect("a chunk");
    let request = Request::Stage { total: 300, offset: 0, bytes };
    let mut frame = Frame::new();
    frame.fill(&Uplink { version: PROTOCOL_VERSION, number: 0xFFFF, request, heard_ms: 0 }).expect("it fits");
    frame.as_bytes().to_vec()
}

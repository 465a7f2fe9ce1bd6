//! The test bench: the image that gets flashed, on the virtual board, in a flight in which something breaks.
#![allow(dead_code, reason = "each test binary uses a part")]

pub(crate) mod log;
pub(crate) mod stopping;

use std::hash::Hasher;
use std::sync::{Arc, Mutex, OnceLock};

use emulator::boards::{MotorUpdate, SpeedyBeeF405V3};
use emulator::chip::{Chip, Pin};
use emulator::core::Timing;
use emulator::{Machine, Stop};
use mintime::firmware_image::FirmwareImage;
use mintime::flight::{
    Client, Connection, ConnectionError, FlightError, FlightPlan, FlightResult, Outcome, Phase, Pose, Scene,
    VirtualVehicle, Witness, fly,
};
use mintime_shared::messages::{AbortReason, ArmingBlock, FlightState, Refusal, Reply, Request, Telemetry};
use mintime_shared::table::ManeuverTable;
use mintime_shared::vehicle::VehicleConfig;
use mintime_simulator::VehicleParameters;
use mintime_tests::reference_cases;
use nalgebra::Vector3;

/// The virtual board's insides.
pub(crate) type Board = Machine<Chip<SpeedyBeeF405V3>>;

/// The motors' lines.
pub(crate) const MOTOR_PINS: [Pin; 4] =
    [Pin::new('B', 6), Pin::new('B', 7), Pin::new('B', 8), Pin::new('B', 9)];

const MS: u64 = 1_000_000;
/// The ground, m below the start.
const GROUND_M: f64 = -1.0;
/// An answer takes no longer than this many poses.
const ANSWER_POSES: u32 = 100;

/// The image, built once a test binary.
pub(crate) fn image() -> &'static FirmwareImage {
    static IMAGE: OnceLock<FirmwareImage> = OnceLock::new();
    IMAGE.get_or_init(|| FirmwareImage::build(&mut |_| {}).expect("the firmware builds"))
}

/// Something done to the board at a point of the flight.
type Act = Box<dyn FnMut(&mut VirtualVehicle)>;

/// A board that flies.
pub(crate) struct Bench {
    pub(crate) vehicle: VirtualVehicle,
    table: ManeuverTable,
    symbols: Vec<(String, u32)>,
    motors: Arc<Mutex<Vec<MotorUpdate>>>,
    planned: Vec<(Phase, u64, Act)>,
    due: Vec<(u64, Act)>,
    /// When the last act was done, ns.
    pub(crate) broken_ns: Option<u64>,
    /// What the firmware wrote into its log.
    pub(crate) logged: Vec<String>,
    link: std::hash::DefaultHasher,
    client: Client,
}

impl Bench {
    /// A board just switched on, with `elf` in its flash.
    pub(crate) fn new(elf: &[u8], seed: u64) -> Self {
        let table =
            reference_cases().into_iter().find(|c| c.name == "horizontal_1").expect("the case").table();
        let scene = Scene {
            parameters: &VehicleParameters::nominal(),
            seed,
            ground_z_m: GROUND_M,
            heading_rad: f64::from(table.heading_rad),
            maneuver_s: f64::from(table.duration_s()),
        };
        let mut vehicle = VirtualVehicle::new(&scene, elf, Timing::Pessimistic).expect("the image loads");
        let motors = Arc::new(Mutex::new(Vec::new()));
        let seen = Arc::clone(&motors);
        vehicle.observe_motors(move |update| seen.lock().expect("nobody panics").push(*update));
        Self {
            vehicle,
            table,
            symbols: emulator::machine::symbols(elf).expect("symbols"),
            motors,
            planned: Vec::new(),
            due: Vec::new(),
            broken_ns: None,
            logged: Vec::new(),
            link: std::hash::DefaultHasher::new(),
            client: Client::default(),
        }
    }

    /// The image as it is flashed.
    pub(crate) fn real(seed: u64) -> Self {
        Self::new(image().elf(), seed)
    }

    /// Does something to the board before it runs.
    #[must_use]
    pub(crate) fn at_power_up(mut self, act: impl FnOnce(&mut Board)) -> Self {
        act(self.vehicle.machine_mut());
        self
    }

    /// Does something so long after a phase has begun.
    #[must_use]
    pub(crate) fn then(
        mut self,
        phase: Phase,
        delay_ms: u64,
        act: impl FnMut(&mut VirtualVehicle) + 'static,
    ) -> Self {
        self.planned.push((phase, delay_ms * MS, Box::new(act)));
        self
    }

    /// The board.
    pub(crate) fn board(&mut self) -> &mut Board {
        self.vehicle.machine_mut()
    }

    /// Address of the one symbol that is called so, or whose mangled name has this part.
    pub(crate) fn symbol(&self, part: &str) -> u32 {
        let exact = self.symbols.iter().find(|(name, _)| name == part);
        let mut found = self.symbols.iter().filter(|(name, _)| name.contains(part));
        match (exact, found.next(), found.next()) {
            (Some((_, address)), ..) | (None, Some((_, address)), None) => *address,
            other => panic!("{part}: {other:?}"),
        }
    }

    /// Flies a metre sideways, from the ground to the ground.
    pub(crate) fn fly(&mut self) -> Result<FlightResult, FlightError> {
        let plan = FlightPlan::new(self.table.clone(), Vector3::zeros(), Some(VehicleConfig::REFERENCE));
        fly(self, &plan, &mut Silent)
    }

    /// Lets time pass.
    pub(crate) fn pass_ms(&mut self, ms: u64) {
        let end = self.vehicle.now_ns() + ms * MS;
        while self.vehicle.now_ns() < end {
            self.next_pose().expect("time goes on");
        }
    }

    /// Asks and waits for the answer.
    pub(crate) fn ask(&mut self, request: &Request) -> Reply {
        let mut client = std::mem::take(&mut self.client);
        let now_s = |bench: &Self| bench.vehicle.now_ns() as f64 * 1e-9;
        client.ask(self, request.clone(), now_s(self)).expect("a line");
        for _ in 0..ANSWER_POSES {
            self.next_pose().expect("time goes on");
            let now_s = now_s(self);
            match client.poll(self, now_s) {
                Ok(None) => {}
                Ok(Some(reply)) => {
                    self.client = client;
                    return reply;
                }
                Err(mintime::flight::ClientError::Refused(refusal)) => {
                    self.client = client;
                    return Reply::Refused(refusal);
                }
                Err(error) => panic!("{request:?}: {error}"),
            }
        }
        panic!("{request:?}: no answer");
    }

    /// What the board says of itself.
    pub(crate) fn status(&mut self) -> Telemetry {
        match self.ask(&Request::Status) {
            Reply::Status(telemetry) => telemetry,
            other => panic!("{other:?}"),
        }
    }

    /// Flies; it must go well.
    pub(crate) fn assert_flies(&mut self) -> FlightResult {
        let result = self.fly().unwrap_or_else(|error| panic!("{error}; {:?}", self.bugs()));
        assert_eq!(result.outcome, Outcome::Completed, "{:?}", result.reason);
        result
    }

    /// Flies; arming must be refused for these reasons among others, and no motor has turned.
    pub(crate) fn assert_not_armed(&mut self, reason: ArmingBlock) -> ArmingBlock {
        let result = self.fly();
        let Err(FlightError::NotReady(Refusal::ArmingBlocked(bits))) = result else {
            panic!("{result:?}");
        };
        let block = ArmingBlock(bits);
        assert_eq!(block.0 & reason.0, reason.0, "{block}");
        assert!(!self.ever_turned());
        block
    }

    /// Flies; the vehicle must be lost in this way.
    pub(crate) fn assert_lost(&mut self) -> (FlightState, Option<AbortReason>) {
        match self.fly() {
            Err(FlightError::Lost { state, reason, .. }) => (state, reason),
            other => panic!("not lost: {other:?}"),
        }
    }

    /// The vehicle is back, disarmed, and says why.
    pub(crate) fn assert_is_back(&mut self, cause: &str, crashes: &[&str]) {
        self.pass_ms(300);
        let log = self.log();
        assert_eq!(log.reset_causes(), ["PowerOn", cause]);
        assert_eq!(log.crashes(), crashes);
        assert!(!self.status().state.motors_on());
        let after = self.last_turning_ns().expect("it flew");
        assert!(self.vehicle.now_ns() > after + 200_000_000);
    }

    /// What the firmware has logged so far.
    pub(crate) fn log(&self) -> log::Log {
        log::Log(self.logged.clone())
    }

    /// Mistakes that the emulator saw.
    pub(crate) fn bugs(&self) -> Vec<String> {
        self.vehicle.report().bugs
    }

    /// The emulator saw this mistake.
    pub(crate) fn assert_bug(&self, part: &str) {
        assert!(self.bugs().iter().any(|bug| bug.contains(part)), "{:?}", self.bugs());
    }

    /// All frames that the motors got.
    pub(crate) fn frames(&self) -> Vec<MotorUpdate> {
        self.motors.lock().expect("nobody panics").clone()
    }

    /// Whether a motor ever turned.
    pub(crate) fn ever_turned(&self) -> bool {
        self.last_turning_ns().is_some()
    }

    /// When a motor last got a throttle, ns.
    pub(crate) fn last_turning_ns(&self) -> Option<u64> {
        self.frames().iter().rev().find(|u| u.value != 0).map(|u| u.ns)
    }

    /// From the act until the first stop frame after the last throttle, ms.
    pub(crate) fn stopped_after_ms(&self) -> f64 {
        let broken = self.broken_ns.expect("it broke");
        let frames = self.frames();
        let last = frames.iter().rposition(|u| u.value != 0).expect("it flew");
        let stop = frames.get(last + 1).expect("a stop frame");
        (stop.ns as f64 - broken as f64) * 1e-6
    }

    /// Hash of all that came over the link.
    pub(crate) fn link_hash(&self) -> u64 {
        self.link.finish()
    }

    /// Hash of all motor frames with their times.
    pub(crate) fn motor_hash(&self) -> u64 {
        let mut hash = std::hash::DefaultHasher::new();
        for update in self.frames() {
            hash.write_u64(update.ns);
            hash.write_usize(update.motor);
            hash.write_u16(update.value);
        }
        hash.finish()
    }
}

impl Connection for Bench {
    fn next_pose(&mut self) -> Result<Pose, ConnectionError> {
        let now = self.vehicle.now_ns();
        let due = |(at, _): &mut (u64, Act)| *at <= now;
        for (_, mut act) in self.due.extract_if(.., due).collect::<Vec<_>>() {
            act(&mut self.vehicle);
            self.broken_ns = Some(now);
        }
        let pose = self.vehicle.next_pose();
        let lines = self.vehicle.take_log();
        self.logged.extend(lines.into_iter().map(|(_, line)| line));
        pose
    }

    fn send(&mut self, bytes: &[u8]) -> Result<(), ConnectionError> {
        self.vehicle.send(bytes)
    }

    fn receive(&mut self, into: &mut Vec<u8>) -> Result<(), ConnectionError> {
        let before = into.len();
        self.vehicle.receive(into)?;
        self.link.write(&into[before..]);
        Ok(())
    }

    fn enter(&mut self, phase: Phase) {
        let now = self.vehicle.now_ns();
        for (_, delay, act) in self.planned.extract_if(.., |(p, ..)| *p == phase) {
            self.due.push((now + delay, act));
        }
        self.vehicle.enter(phase);
    }
}

struct Silent;

impl Witness for Silent {
    fn phase(&mut self, _: Phase, _: f64) {}
    fn event(&mut self, _: f64, _: &str) {}
}

/// Runs the board until its processor is awake, some microseconds at most a tick.
pub(crate) fn wake(board: &mut Board) {
    for _ in 0..10_000 {
        if !board.core.is_asleep() {
            return;
        }
        let until = board.time() + 200;
        assert_eq!(board.run_until(until), Stop::ReachedTime);
    }
    panic!("it sleeps for ever");
}

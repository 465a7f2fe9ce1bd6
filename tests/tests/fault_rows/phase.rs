//! The phases in which faults strike, and how a vehicle is brought into them.

use std::sync::{Mutex, OnceLock};

use mintime::flight::Calmness;
use mintime_shared::messages::{FlightState, Purpose, Request, STAGE_CHUNK_BYTES};
use mintime_shared::settings::Settings;
use mintime_shared::table::{LinkPolicy, MAX_TABLE_BYTES};
use mintime_shared::vehicle::VehicleConfig;

use super::rig::{GROUND_M, Host, Rig};
use super::store::KEPT_SETTINGS;

/// Height over the ground of the low hover, m.
const LOW_M: f64 = 0.2;
/// Speed of the climb to the hover, m/s.
const CLIMB_MPS: f64 = 0.8;

/// How the vehicle is set where it has no kill switch.
const BENCH_SETTINGS: Settings =
    Settings { bench_thrust_mps2: Settings::BENCH_THRUST_MAX_MPS2, ..KEPT_SETTINGS };
/// Before a vehicle is turned by hand it is seen to stand still, ms.
const STILL_MS: u64 = 1200;
/// The hand turns it so fast, rad/s.
const HAND_RADPS: f64 = 2.0;
const PHASES_COUNT: usize = Phase::Hop as usize + 1;

/// Where a fault strikes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Phase {
    /// Just switched on, the gyro not set up yet.
    Boot,
    /// Set up, the gyro's bias not known yet.
    Calibrating,
    /// Ready to be armed.
    Disarmed,
    /// On the ground, idling.
    Armed,
    /// In the hover, 1.5 m above the ground.
    Tracking,
    /// The same, 0.2 m above the ground.
    Low,
    /// A tenth of a second into a maneuver.
    Maneuver,
    /// The same, by a table that wants the maneuver given up where the link is lost.
    Abandon,
    /// A tenth of a second after the setpoints stopped.
    Recovery,
    /// Down after a recovery.
    Landed,
    /// Stopped by its host while idling.
    Terminated,
    /// A quarter of a second into the test of a motor.
    MotorTest,
    /// Without a kill switch, its thrust capped, told to lift all the same.
    Bench,
    /// Turned by hand, for the scale of its gyro.
    Turned,
    /// In the hover, in the first half of a hop.
    Hop,
}

impl Phase {
    /// As the document calls it.
    pub(crate) const fn name(self) -> &'static str {
        match self {
            Self::Boot => "`Boot`",
            Self::Calibrating => "`Calibrating`",
            Self::Disarmed => "`Disarmed`",
            Self::Armed => "`Armed`",
            Self::Tracking => "`Tracking`",
            Self::Low => "`Tracking`, 0.2 m up",
            Self::Maneuver => "`Maneuver`",
            Self::Abandon => "`Maneuver` with `Abandon`",
            Self::Recovery => "`Recovery`",
            Self::Landed => "`Landed`",
            Self::Terminated => "`Terminated`",
            Self::MotorTest => "`Armed`, a motor tested",
            Self::Bench => "`Tracking` on the bench",
            Self::Turned => "`Disarmed`, turned by hand",
            Self::Hop => "`Tracking`, in a hop",
        }
    }

    pub(crate) fn state(self) -> FlightState {
        match self {
            Self::Boot => FlightState::Boot,
            Self::Calibrating => FlightState::Calibrating,
            Self::Disarmed | Self::Turned => FlightState::Disarmed,
            Self::Armed | Self::MotorTest => FlightState::Armed,
            Self::Tracking | Self::Low | Self::Bench | Self::Hop => FlightState::Tracking,
            Self::Maneuver | Self::Abandon => FlightState::Maneuver,
            Self::Recovery => FlightState::Recovery,
            Self::Landed => FlightState::Landed,
            Self::Terminated => FlightState::Terminated,
        }
    }
}

impl Rig {
    /// A fresh vehicle in this phase.
    pub(crate) fn in_phase(phase: Phase) -> Self {
        static PHASES: [OnceLock<Mutex<Rig>>; PHASES_COUNT] = [const { OnceLock::new() }; PHASES_COUNT];
        let rig = PHASES[phase as usize].get_or_init(|| Mutex::new(Self::brought_into(phase)));
        rig.lock().expect("nobody panics with it").fork()
    }

    fn brought_into(phase: Phase) -> Self {
        let mut rig = match phase {
            Phase::Boot | Phase::Disarmed | Phase::Bench => Self::new(),
            Phase::Calibrating => Self::in_phase(Phase::Boot),
            Phase::Armed | Phase::Abandon | Phase::MotorTest | Phase::Turned => {
                Self::in_phase(Phase::Disarmed)
            }
            Phase::Tracking => Self::in_phase(Phase::Armed),
            Phase::Low | Phase::Maneuver | Phase::Recovery | Phase::Hop => Self::in_phase(Phase::Tracking),
            Phase::Landed => Self::in_phase(Phase::Low),
            Phase::Terminated => Self::in_phase(Phase::Armed),
        };
        rig.go_on(phase);
        assert_eq!(rig.state(), phase.state());
        assert_eq!(rig.bugs(), [""; 0]);
        rig
    }

    /// From the phase before into this one.
    fn go_on(&mut self, phase: Phase) {
        match phase {
            Phase::Boot => self.pass_ms(50),
            Phase::Calibrating => self.pass_ms(150),
            Phase::Disarmed => self.prepare(KEPT_SETTINGS),
            Phase::Armed => {
                self.ask(Request::Arm(Purpose::Flight)).expect("nothing blocks arming");
                self.pass_ms(300);
            }
            Phase::Tracking => {
                self.host = Host::Flies;
                let steps = (GROUND_M.abs() / CLIMB_MPS / 0.005) as u32;
                for step in 0..steps {
                    self.height_m = GROUND_M * (1.0 - f64::from(step) / f64::from(steps));
                    if step == 100 {
                        self.calmness = Calmness::Calm;
                    }
                    self.step();
                }
                self.height_m = 0.0;
                self.pass_ms(1500);
            }
            Phase::Low => {
                for step in 0..300_u32 {
                    self.height_m = (GROUND_M + LOW_M) * f64::from(step) / 300.0;
                    self.step();
                }
                self.pass_ms(700);
            }
            Phase::Maneuver => {
                let checksum = self.table.checksum();
                self.ask(Request::Trigger { checksum }).expect("a hover inside the gate");
                self.calmness = Calmness::Agile;
                self.pass_ms(100);
            }
            Phase::Abandon => {
                self.table.link = LinkPolicy::Abandon;
                self.commit();
                for phase in [Phase::Armed, Phase::Tracking, Phase::Maneuver] {
                    self.go_on(phase);
                }
            }
            Phase::Recovery => {
                self.host = Host::Beats;
                self.pass_ms(200);
            }
            Phase::Landed => {
                self.host = Host::Beats;
                self.pass_ms(2500);
            }
            Phase::Terminated => {
                self.ask(Request::EmergencyStop).expect("it stops");
                self.pass_ms(300);
            }
            Phase::MotorTest => {
                self.ask(Request::Arm(Purpose::MotorTest)).expect("nothing blocks arming");
                let test = Request::TestMotor { motor: 1, throttle: 0.1, duration_ms: 2000 };
                self.ask(test).expect("it turns");
                self.pass_ms(250);
            }
            Phase::Bench => {
                let board = self.board();
                board.peripherals.set_receiver(&mut board.memory, None);
                self.prepare(BENCH_SETTINGS);
                self.go_on(Phase::Armed);
                (self.host, self.height_m) = (Host::Flies, 0.0);
                self.pass_ms(500);
                self.assert_stands();
            }
            Phase::Turned => {
                self.begin(Request::CalibrateScale { axis: 2, turns: 1 });
                self.pass_ms(STILL_MS);
                // It goes on without being asked how it does.
                self.ask(Request::Status).expect("it answers");
                self.board().peripherals.board_mut().gyro.hand_radps[2] = HAND_RADPS;
                self.pass_ms(1000);
            }
            Phase::Hop => {
                self.host = Host::Hops(self.vehicle.now_ns());
                self.pass_ms(50);
            }
        }
    }

    fn prepare(&mut self, settings: Settings) {
        self.pass_ms(100);
        self.ask(Request::WriteVehicle(VehicleConfig::REFERENCE)).expect("it keeps what it is");
        self.ask(Request::WriteSettings(settings)).expect("it keeps how it is set");
        self.commit();
        let ready = |rig: &Self| rig.client.telemetry().is_some_and(|t| t.arming_block == 0);
        for _ in 0..2000 {
            if ready(self) {
                break;
            }
            self.step();
        }
        assert!(ready(self), "{:?}", self.client.telemetry());
    }

    /// Uploads and commits its table.
    fn commit(&mut self) {
        let mut buffer = [0; MAX_TABLE_BYTES];
        let length = self.table.encode(&mut buffer).expect("a table");
        for (index, chunk) in buffer[..length].chunks(STAGE_CHUNK_BYTES).enumerate() {
            let bytes = heapless::Vec::from_slice(chunk).expect("a chunk");
            let (total, offset) = (length as u16, (index * STAGE_CHUNK_BYTES) as u16);
            self.ask(Request::Stage { total, offset, bytes }).expect("staged");
        }
        let checksum = self.table.checksum();
        self.ask(Request::CommitTable { checksum }).expect("committed");
    }
}

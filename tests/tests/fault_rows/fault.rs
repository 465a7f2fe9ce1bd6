//! What breaks, and how it is broken on the virtual board.

use emulator::bus::Peripherals;
use emulator::devices::{CrsfDefect, Defect};
use mintime_shared::messages::Request;
use mintime_simulator::Fault as Broken;

use super::rig::{Damage, Host, MS, Rig};
use super::sabotage::{
    NOWHERE, break_gyro, go_to, kill_task, lose_frame_ends, lose_tick, panic_at, ring, run_instead,
    stray_edges,
};
use super::store::decay_store;

/// What breaks in the simulated world heals after this long.
const WINDOW_MS: u64 = 400;
/// But for a gyro that is frozen long enough to be told at rest, ...
const FROZEN_MS: u64 = 1000;
/// ... and cameras that are silent for longer than a host waits for a pose.
const CAMERAS_MS: u64 = 1300;

/// A fault.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(clippy::enum_variant_names, reason = "a hard fault is called that")]
pub(crate) enum Fault {
    GyroSilent,
    GyroFrozen,
    GyroFrozenLong,
    GyroSaturated,
    GyroReversed,
    BusHigh,
    BusLow,
    BusLoose,
    NoisyEdges,
    Ringing10,
    Ringing5,
    Ringing1,
    RingingSilent,
    FlippedBits,
    LostBytes,
    LineNoise,
    FullLoad,
    LinkCut,
    SetpointsStop,
    CamerasSilent,
    DeadMotor,
    DeadSignal,
    FrameEndsLost,
    BatterySag,
    SenseLost,
    LsiSlow,
    LsiFast,
    Stall,
    TickDead,
    TickDeadLsiSlow,
    TickDeadLsiFast,
    SupervisionDead,
    LinkTaskDead,
    TasksHang,
    StackOverflow,
    Panic,
    HardFault,
    DoubleFault,
    StrayInterrupt,
    CrystalLost,
    BrownOut,
    Reset,
    PowerCut,
    CutInWrite,
    CutInErase,
    StoreDecays,
    KillPressed,
    RadioSilent,
    RadioNoisy,
    RadioLost,
    EmergencyStop,
    Disarm,
}

impl Fault {
    /// As the document calls it.
    pub(crate) const fn name(self) -> &'static str {
        match self {
            Self::GyroSilent => "gyro silent for 0.4 s",
            Self::GyroFrozen => "gyro frozen for 0.4 s",
            Self::GyroFrozenLong => "gyro frozen for 1 s",
            Self::GyroSaturated => "gyro: an axis at the end of its range",
            Self::GyroReversed => "gyro: an axis with the wrong sign",
            Self::BusHigh => "gyro bus stuck high",
            Self::BusLow => "gyro bus stuck low",
            Self::BusLoose => "gyro bus: every fifth read fails",
            Self::NoisyEdges => "edges on the data-ready line",
            Self::Ringing10 => "data-ready line rings every 10 µs",
            Self::Ringing5 => "data-ready line rings every 5 µs",
            Self::Ringing1 => "data-ready line rings every 1 µs",
            Self::RingingSilent => "data-ready line rings, gyro silent for 0.4 s",
            Self::FlippedBits => "link: a bit flipped in a third of the frames",
            Self::LostBytes => "link: a byte lost from a third of the frames",
            Self::LineNoise => "link: noise and breaks between the frames",
            Self::FullLoad => "link: 100 % load",
            Self::LinkCut => "link cut, or host dead",
            Self::SetpointsStop => "host alive, no setpoints",
            Self::CamerasSilent => "motion capture silent for 1.3 s",
            Self::DeadMotor => "motor 1 dead",
            Self::DeadSignal => "signal wire of motor 1 off",
            Self::FrameEndsLost => "motor outputs: the end of no frame is seen",
            Self::BatterySag => "battery below critical",
            Self::SenseLost => "battery sense wire off",
            Self::LsiSlow => "watchdog's oscillator at 17 kHz",
            Self::LsiFast => "watchdog's oscillator at 47 kHz",
            Self::Stall => "processor stalled for 15 ms",
            Self::TickDead => "control tick dead",
            Self::TickDeadLsiSlow => "control tick dead, watchdog at 17 kHz",
            Self::TickDeadLsiFast => "control tick dead, watchdog at 47 kHz",
            Self::SupervisionDead => "supervision dead",
            Self::LinkTaskDead => "link task dead",
            Self::TasksHang => "thread mode hangs",
            Self::StackOverflow => "stack overflow",
            Self::Panic => "panic",
            Self::HardFault => "jump to nowhere",
            Self::DoubleFault => "fault in the fault handler",
            Self::StrayInterrupt => "interrupt that nobody handles",
            Self::CrystalLost => "crystal stops for 10 ms",
            Self::BrownOut => "supply at 2.8 V for 2 ms",
            Self::Reset => "reset by the pin or a probe",
            Self::PowerCut => "controller's power cut",
            Self::CutInWrite => "power cut while flash is written",
            Self::CutInErase => "power cut while flash is erased",
            Self::StoreDecays => "a bit flipped in the store, then a reset",
            Self::KillPressed => "kill switch pressed",
            Self::RadioSilent => "kill switch's receiver silent",
            Self::RadioNoisy => "kill switch's line: a bit flipped in each frame",
            Self::RadioLost => "kill switch's radio at link quality 0",
            Self::EmergencyStop => "emergency stop by the host",
            Self::Disarm => "disarmed by the host",
        }
    }

    /// What the emulator rightly says of it.
    pub(crate) const fn expected_bug(self) -> Option<&'static str> {
        match self {
            Self::DoubleFault => Some("lock-up"),
            // The bit on the wire.
            Self::CrystalLost => Some("no rate of DShot"),
            Self::StackOverflow => Some("nothing lies at 0x1fff"),
            Self::GyroSilent | Self::RingingSilent => Some("BMI270: samples come every"),
            _ => None,
        }
    }

    /// Breaks it. Returns since when it is broken, ns.
    pub(super) fn inject(self, rig: &mut Rig) -> u64 {
        let now = rig.vehicle.now_ns();
        let in_world = |rig: &mut Rig, broken, until_ns| {
            rig.vehicle.simulator_mut().inject(broken, now..until_ns).expect("the fault exists");
        };
        let window_ns = now + WINDOW_MS * MS;
        match self {
            Self::GyroSilent => in_world(rig, Broken::ImuSilent, window_ns),
            Self::GyroFrozen => in_world(rig, Broken::ImuStuck, window_ns),
            Self::GyroFrozenLong => in_world(rig, Broken::ImuStuck, now + FROZEN_MS * MS),
            Self::GyroSaturated => break_gyro(rig, Some(Defect::Railed(0))),
            Self::GyroReversed => break_gyro(rig, Some(Defect::ReversedAxis(1))),
            Self::BusHigh => break_gyro(rig, Some(Defect::Absent)),
            Self::BusLow => break_gyro(rig, Some(Defect::StuckLow)),
            Self::BusLoose => break_gyro(rig, Some(Defect::Loose(5))),
            Self::NoisyEdges => rig.every_pose = Some(stray_edges),
            Self::Ringing10 => ring(rig, Some(10_000)),
            Self::Ringing5 => ring(rig, Some(5_000)),
            Self::Ringing1 => ring(rig, Some(1_000)),
            Self::RingingSilent => {
                in_world(rig, Broken::ImuSilent, window_ns);
                ring(rig, Some(1_000));
            }
            Self::FlippedBits => rig.damage = Damage::FlippedBits,
            Self::LostBytes => rig.damage = Damage::LostBytes,
            Self::LineNoise => rig.damage = Damage::Noise,
            Self::FullLoad => rig.damage = Damage::FullLoad,
            Self::LinkCut => rig.host = Host::Silent,
            Self::SetpointsStop => rig.host = Host::Beats,
            Self::CamerasSilent => in_world(rig, Broken::MotionCaptureSilent, now + CAMERAS_MS * MS),
            Self::DeadMotor => in_world(rig, Broken::RotorDead(0), u64::MAX),
            Self::DeadSignal => rig.board().peripherals.board_mut().escs[0].torn_off = true,
            Self::FrameEndsLost => lose_frame_ends(rig),
            Self::BatterySag => rig.board().peripherals.board_mut().battery.divider = 15.4,
            Self::SenseLost => rig.board().peripherals.board_mut().battery.divider = f64::INFINITY,
            Self::LsiSlow => rig.board().peripherals.set_lsi_hz(17_000),
            Self::LsiFast => rig.board().peripherals.set_lsi_hz(47_000),
            Self::Stall => {
                let board = rig.board();
                board.memory.flash_interface.busy_until =
                    board.time() + board.peripherals.clock().cycles_for(15 * MS);
            }
            Self::TickDead => lose_tick(rig),
            Self::TickDeadLsiSlow => {
                rig.board().peripherals.set_lsi_hz(17_000);
                // Until the watchdog has been petted at that speed.
                rig.pass_ms(50);
                lose_tick(rig);
                return rig.vehicle.now_ns();
            }
            Self::TickDeadLsiFast => {
                rig.board().peripherals.set_lsi_hz(47_000);
                rig.pass_ms(50);
                lose_tick(rig);
                return rig.vehicle.now_ns();
            }
            Self::SupervisionDead => kill_task(rig, "5board11supervision3run"),
            Self::LinkTaskDead => kill_task(rig, "5board4link8transmit"),
            // b .
            Self::TasksHang => {
                run_instead(rig, &[], &[0xE7FE]);
                return rig.vehicle.now_ns();
            }
            // push {r0-r7, lr}; b back
            Self::StackOverflow => {
                run_instead(rig, &[], &[0xB5FF, 0xE7FD]);
                return rig.vehicle.now_ns();
            }
            Self::Panic => {
                panic_at(rig);
                return rig.vehicle.now_ns();
            }
            Self::HardFault => {
                go_to(rig, NOWHERE, &[]);
                return rig.vehicle.now_ns();
            }
            Self::DoubleFault => {
                let handler = rig.symbol(&["HardFault"]) & !1;
                // udf #0
                rig.board().memory.place(handler, &[0x00, 0xDE]).expect("flash");
                go_to(rig, NOWHERE, &[]);
                return rig.vehicle.now_ns();
            }
            // The window watchdog's: pend it and switch it on. str r1, [r0]; str r1, [r2]; b .
            Self::StrayInterrupt => {
                run_instead(rig, &[0xE000_E200, 1, 0xE000_E100], &[0x6001, 0x6011, 0xE7FE]);
                return rig.vehicle.now_ns();
            }
            Self::CrystalLost => {
                let board = rig.board();
                board.peripherals.fail_crystal(&mut board.memory, board.core.cycle, true);
                rig.pass_ms(10);
                let board = rig.board();
                board.peripherals.fail_crystal(&mut board.memory, board.core.cycle, false);
            }
            Self::BrownOut => {
                rig.board().peripherals.set_supply_v(2.8);
                let later = rig.vehicle.now_ns() + 2 * MS;
                rig.vehicle.advance_to(later).expect("time goes on");
                rig.board().peripherals.set_supply_v(3.3);
            }
            Self::Reset => rig.board().peripherals.request_reset(),
            Self::PowerCut => {
                let board = rig.board();
                board.peripherals.cut_power(&mut board.memory, 0x1234_5678);
            }
            Self::CutInWrite | Self::CutInErase => {}
            Self::StoreDecays => {
                decay_store(rig);
                rig.board().peripherals.request_reset();
            }
            Self::KillPressed => rig.vehicle.set_kill_switch(true),
            Self::RadioSilent => rig.vehicle.with_receiver(|r| r.defect = CrsfDefect::Silent),
            Self::RadioNoisy => rig.vehicle.with_receiver(|r| r.defect = CrsfDefect::FlippedBit),
            Self::RadioLost => rig.vehicle.with_receiver(|r| r.link_quality = 0),
            Self::EmergencyStop => rig.begin(Request::EmergencyStop),
            Self::Disarm => rig.begin(Request::Disarm),
        }
        now
    }

    /// Mends what can be mended from outside.
    pub(crate) fn mend(self, rig: &mut Rig) {
        match self {
            Self::GyroSaturated | Self::GyroReversed | Self::BusHigh | Self::BusLow | Self::BusLoose => {
                break_gyro(rig, None);
            }
            Self::NoisyEdges => rig.every_pose = None,
            Self::Ringing10 | Self::Ringing5 | Self::Ringing1 | Self::RingingSilent => ring(rig, None),
            Self::FlippedBits | Self::LostBytes | Self::LineNoise | Self::FullLoad => {
                rig.damage = Damage::None;
            }
            Self::LinkCut | Self::SetpointsStop => rig.host = Host::Flies,
            Self::DeadSignal => rig.board().peripherals.board_mut().escs[0].torn_off = false,
            Self::BatterySag | Self::SenseLost => rig.board().peripherals.board_mut().battery.divider = 11.0,
            Self::KillPressed => rig.vehicle.set_kill_switch(false),
            Self::RadioSilent | Self::RadioNoisy => {
                rig.vehicle.with_receiver(|r| r.defect = CrsfDefect::None);
            }
            Self::RadioLost => rig.vehicle.with_receiver(|r| r.link_quality = 100),
            _ => {}
        }
    }

    /// So long after it where it shows in telemetry only, ms.
    pub(crate) const fn shows_after_ms(self) -> u64 {
        match self {
            Self::GyroFrozenLong => 700,
            _ => 0,
        }
    }

    /// Whether the power is cut in the middle of a write or an erase, and then which.
    pub(crate) const fn cuts_store(self) -> Option<bool> {
        match self {
            Self::CutInWrite => Some(false),
            Self::CutInErase => Some(true),
            _ => None,
        }
    }
}

//! What breaks, and how it is broken on the virtual board.

use emulator::bus::Peripherals;
use emulator::chip::Pin;
use emulator::devices::{CrsfDefect, Defect};
use mintime_shared::messages::{Reply, Request};
use mintime_shared::settings::Settings;
use mintime_shared::vehicle::VehicleConfig;
use mintime_simulator::Fault as Broken;

use super::rig::{Damage, Host, MS, Rig, draw};
use crate::bench::Board;

/// RAM that the firmware does not use.
const SPARE_RAM: u32 = 0x2001_F000;
/// Nothing lies there.
const NOWHERE: u32 = 0x3000_0000;
/// The store's first sector.
const STORE: u32 = 0x0800_4000;
const STORE_BYTES: u32 = 16 * 1024;
/// The gyro's data-ready pin.
const DATA_READY: Pin = Pin::new('C', 4);
/// Where the firmware is made to panic.
const PANIC_LINE: u32 = 77;
/// Settings that the vehicle has been told before anything breaks.
pub(super) const KEPT_SETTINGS: Settings = Settings { gyro_cutoff_hz: 149.0, ..Settings::DEFAULT };
/// A task begins with at most this many bytes of what the executor knows of it, where its code is among them.
const TASK_HEADER_BYTES: u32 = 64;
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
            Self::GyroSilent => Some("BMI270: samples come every"),
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
                let board = rig.board();
                let cells = board.memory.peek(STORE, STORE_BYTES).expect("flash");
                // The last value ends before its checksum and its confirmation.
                let end = cells.iter().rposition(|byte| *byte != 0xFF).expect("records") + 1;
                let decayed = cells[end - 12] ^ 1;
                board.memory.place(STORE + end as u32 - 12, &[decayed]).expect("flash");
                board.peripherals.request_reset();
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
            Self::Ringing10 | Self::Ringing5 | Self::Ringing1 => ring(rig, None),
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

fn break_gyro(rig: &mut Rig, defect: Option<Defect>) {
    rig.board().peripherals.board_mut().gyro.defect = defect;
}

/// Edges on the line without end, so long from one to the next.
fn ring(rig: &mut Rig, period_ns: Option<u64>) {
    let now_ns = rig.vehicle.now_ns();
    let Board { peripherals, memory, .. } = rig.board();
    peripherals.ring_data_ready(memory, now_ns, period_ns);
}

/// Three pulses on the line between two samples.
fn stray_edges(board: &mut Board) {
    for pulse in 0..6 {
        let level = pulse % 2 == 0;
        let Board { peripherals, memory, .. } = board;
        peripherals.with_board(memory, |_, effects| effects.levels.push((DATA_READY, Some(level))));
        let until = board.time() + board.peripherals.clock().cycles_for(20_000);
        board.run_until(until);
    }
}

/// One word of RAM lost: the control tick finds nothing to run.
fn lose_tick(rig: &mut Rig) {
    let handle = rig.symbol(&["5board7control6HANDLE"]);
    // While a tick runs it is not there.
    while rig.board().core.exception_number() != 0 {
        let later = rig.vehicle.now_ns() + 500;
        rig.vehicle.advance_to(later).expect("time goes on");
    }
    rig.board().memory.place(handle, &[0; 4]).expect("RAM");
}

/// The handler at the end of the motors' stream does its work, but for telling that it was there.
fn lose_frame_ends(rig: &mut Rig) {
    const MOTOR_TIMER_REQUESTS: u32 = 0x4000_080C;
    const STREAM_FLAGS: u32 = 0x4002_600C;
    const STREAM_6: u32 = 0x3D_0000;
    const STREAM_6_INTERRUPT: u32 = 17;
    // ldr r0, requests; movs r1, #0; str r1, [r0]; ldr r0, flags; ldr r1, stream; str r1, [r0]; bx lr
    let code: [u16; 8] = [0x4803, 0x2100, 0x6001, 0x4803, 0x4903, 0x6001, 0x4770, 0xBF00];
    let mut bytes: Vec<u8> = code.iter().flat_map(|half| half.to_le_bytes()).collect();
    bytes.extend([MOTOR_TIMER_REQUESTS, STREAM_FLAGS, STREAM_6].iter().flat_map(|word| word.to_le_bytes()));
    let vector = rig.symbol(&["__INTERRUPTS"]) + 4 * STREAM_6_INTERRUPT;
    let memory = &mut rig.board().memory;
    memory.place(SPARE_RAM, &bytes).expect("RAM");
    memory.place(vector, &(SPARE_RAM | 1).to_le_bytes()).expect("flash");
}

/// One word of RAM lost: a task's code is not found any more, and it never runs again.
fn kill_task(rig: &mut Rig, name: &str) {
    let codes = rig.symbols_with(&["TaskStorage", "4poll"]);
    let task = rig.symbol(&[name, "4POOL"]);
    let board = rig.board();
    // bx lr
    board.memory.place(SPARE_RAM, &[0x70, 0x47]).expect("RAM");
    let words = board.memory.peek(task, TASK_HEADER_BYTES).expect("RAM").as_chunks().0.iter();
    let is_code = |word: &[u8; 4]| codes.contains(&(u32::from_le_bytes(*word) & !1));
    let places: Vec<u32> =
        (task..).step_by(4).zip(words).filter(|(_, w)| is_code(w)).map(|(at, _)| at).collect();
    let [at] = places[..] else { panic!("{name}: {places:x?}") };
    board.memory.place(at, &(SPARE_RAM | 1).to_le_bytes()).expect("RAM");
}

/// Makes thread mode go on with these instructions, registers set, interrupts on.
fn run_instead(rig: &mut Rig, registers: &[u32], code: &[u16]) {
    // cpsie i
    let code = [0xB662].iter().chain(code);
    let bytes: Vec<u8> = code.flat_map(|half| half.to_le_bytes()).collect();
    rig.board().memory.place(SPARE_RAM, &bytes).expect("RAM");
    go_to(rig, SPARE_RAM, registers);
}

/// Makes thread mode go on there, as soon as it is awake.
fn go_to(rig: &mut Rig, address: u32, registers: &[u32]) {
    for _ in 0..100_000 {
        let core = &mut rig.board().core;
        if !core.is_asleep() && core.exception_number() == 0 {
            for (number, value) in (0..).zip(registers) {
                core.set_register(number, *value);
            }
            core.set_register(15, address);
            return;
        }
        let later = rig.vehicle.now_ns() + 500;
        rig.vehicle.advance_to(later).expect("time goes on");
    }
    panic!("no thread mode");
}

/// Calls what a failed check of a bound calls: index, length, and where it stands in the source.
fn panic_at(rig: &mut Rig) {
    let at = rig.symbol(&["panic_bounds_check"]) & !1;
    let (file, location) = (SPARE_RAM + 0x100, SPARE_RAM + 0x200);
    let words = [file, 8, PANIC_LINE, 1];
    let bytes: Vec<u8> = words.iter().flat_map(|word: &u32| word.to_le_bytes()).collect();
    let board = rig.board();
    board.memory.place(file, b"fault.rs").expect("RAM");
    board.memory.place(location, &bytes).expect("RAM");
    go_to(rig, at, &[3, 2, location]);
}

/// Cuts the power in a write to the store, or in the erase that makes room in it. Returns the vehicle file that was asked to
/// be kept last and the one confirmed before.
pub(super) fn cut_store(rig: &mut Rig, in_erase: bool) -> [VehicleConfig; 2] {
    let mut confirmed = VehicleConfig::REFERENCE;
    for round in 1..600_u16 {
        let mass_kg = VehicleConfig::REFERENCE.mass_kg + 1e-4 * f32::from(round);
        let wanted = VehicleConfig { mass_kg, ..VehicleConfig::REFERENCE };
        rig.begin(Request::WriteVehicle(wanted));
        for _ in 0..4000 {
            // An erase takes a quarter of a second, a word 16 µs.
            let (step_ns, at_work_ns) = if in_erase { (MS, 5 * MS) } else { (10_000, 1_000) };
            let later = rig.vehicle.now_ns() + step_ns;
            rig.vehicle.advance_to(later).expect("time goes on");
            let board = rig.board();
            let left = board.memory.flash_interface.busy_until.saturating_sub(board.time());
            if left >= board.peripherals.clock().cycles_for(at_work_ns) {
                let noise = draw(&mut rig.random);
                let board = rig.board();
                board.peripherals.cut_power(&mut board.memory, noise);
                return [wanted, confirmed];
            }
            if !in_erase {
                continue;
            }
            match rig.step() {
                Some(answer) => {
                    assert_eq!(answer, Ok(Reply::Done));
                    confirmed = wanted;
                    break;
                }
                // Sooner than the client would.
                None => rig.begin(Request::WriteVehicle(wanted)),
            }
        }
    }
    panic!("flash was never at work");
}

/// What was kept is what was confirmed or what was being written, and all else is untouched.
pub(super) fn check_store(rig: &mut Rig, [wanted, confirmed]: [VehicleConfig; 2]) {
    match rig.ask(Request::ReadVehicle) {
        Ok(Reply::Vehicle(Some(found))) => assert!(found == wanted || found == confirmed, "{found:?}"),
        other => panic!("{other:?}"),
    }
    assert_eq!(rig.ask(Request::ReadSettings), Ok(Reply::Settings(KEPT_SETTINGS)));
}

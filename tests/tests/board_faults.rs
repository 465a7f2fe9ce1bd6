//! Faults of the board, on the very image that gets flashed: how each ends, and how soon the motors stand still.

mod bench;

use std::cell::Cell;
use std::rc::Rc;

use bench::stopping::{Stopped, stopped};
use bench::{Bench, Board, wake};
use emulator::devices::Defect;
use mintime::flight::{Outcome, Phase};
use mintime_shared::messages::{AbortReason, ArmingBlock, FlightState, GyroFault};
use mintime_simulator::Fault;

/// Into the hover of each flight that breaks there, ms.
const IN_HOVER_MS: u64 = 300;
/// RAM that the firmware does not use.
const SPARE_RAM: u32 = 0x2001_F000;
/// Nothing lies there.
const NOWHERE: u32 = 0x3000_0000;

// -------------------------------------------------------------------------------------------------------- the gyro

/// Whatever is wrong with the sensor is told by name.
#[test]
fn a_gyro_that_cannot_be_set_up_is_not_armed() {
    for (defect, fault) in [
        (Defect::Absent, GyroFault::Identity(0xFF)),
        (Defect::Identity(0x68), GyroFault::Identity(0x68)),
        (Defect::Configuration, GyroFault::Configuration(2)),
        (Defect::StuckRegister(0x43), GyroFault::Register(0x43)),
        (Defect::Error(4), GyroFault::Chip(4)),
    ] {
        let mut bench =
            Bench::real(1).at_power_up(|board| board.peripherals.board_mut().gyro.defect = Some(defect));
        bench.assert_not_armed(ArmingBlock::NO_GYRO);
        let telemetry = bench.status();
        assert_eq!(telemetry.board.and_then(|b| b.gyro_fault), Some(fault), "{defect:?}");
        assert_eq!(telemetry.state, FlightState::Terminated, "{defect:?}");
        assert!(bench.log().says("no gyro; arming is refused"), "{:?}", bench.log().0);
    }
}

/// The edge stays away; the timer runs the ticks that count the silence.
#[test]
fn a_gyro_that_falls_silent_in_flight_stops_the_motors() {
    let mut bench = Bench::real(2).then(Phase::Hover, IN_HOVER_MS, |vehicle| {
        let now = vehicle.now_ns();
        vehicle.simulator_mut().inject(Fault::ImuSilent, now..u64::MAX).expect("the fault exists");
    });
    assert_eq!(bench.assert_lost(), (FlightState::Terminated, Some(AbortReason::GyroMissing)));
    let after_ms = bench.stopped_after_ms();
    println!("silent gyro: motors off after {after_ms:.2} ms");
    // One and a half periods and seven more, less what had passed of the first; then one frame.
    assert!(after_ms < 12.0, "{after_ms} ms");
    bench.pass_ms(200);
    let telemetry = bench.status();
    assert!(telemetry.board.is_some_and(|b| b.missed_ticks == 0), "{telemetry:?}");
    assert!(telemetry.missing_samples > 100, "{telemetry:?}");
    assert_eq!(bench.log().reset_causes(), ["PowerOn"]);
}

// ----------------------------------------------------------------------------------------------------- the battery

fn cut_sense_wire(board: &mut Board) {
    board.peripherals.board_mut().battery.divider = f64::INFINITY;
}

#[test]
fn a_battery_that_is_not_seen_is_not_armed() {
    let mut bench = Bench::real(3).at_power_up(cut_sense_wire);
    bench.assert_not_armed(ArmingBlock::BATTERY_UNKNOWN);
}

/// The vehicle flies on by the last voltage, and refuses the maneuver.
#[test]
fn a_battery_lost_from_sight_in_flight_is_no_reason_to_fall() {
    let mut bench =
        Bench::real(3).then(Phase::Hover, IN_HOVER_MS, |vehicle| cut_sense_wire(vehicle.machine_mut()));
    let result = bench.fly().expect("a flight to its end");
    assert_eq!(result.outcome, Outcome::NotTriggered);
    assert!(result.reason.as_ref().is_some_and(|r| r.contains("battery")), "{:?}", result.reason);
}

// ------------------------------------------------------------------------------------------------------ the watchdog

/// Flies until the board resets itself; answers after how many ms the speed controllers had their first stop frame.
fn reset_in_flight(mut bench: Bench, cause: &str, crashes: &[&str]) -> f64 {
    let (state, _) = bench.assert_lost();
    assert_eq!(state, FlightState::Boot);
    let after_ms = bench.stopped_after_ms();
    bench.assert_is_back(cause, crashes);
    after_ms
}

/// One word of RAM lost: the control tick finds nothing to run. Only the watchdog sees it, at any speed of its oscillator,
/// and a healthy board it leaves alone at every speed.
#[test]
fn a_control_tick_that_stops_ends_in_a_reset() {
    for (lsi_hz, least_ms, most_ms) in [(17_000, 150.0, 205.0), (32_000, 70.0, 125.0), (47_000, 40.0, 95.0)] {
        let bench = Bench::real(4).at_power_up(|board| board.peripherals.set_lsi_hz(lsi_hz));
        let handle = bench.symbol("5board7control6HANDLE");
        let bench = bench.then(Phase::Hover, IN_HOVER_MS, move |vehicle| {
            vehicle.machine_mut().memory.place(handle, &[0; 4]).expect("RAM");
        });
        let after_ms = reset_in_flight(bench, "Watchdog", &["Watchdog"]);
        println!("control tick stopped, LSI {lsi_hz} Hz: motors off after {after_ms:.1} ms");
        assert!((least_ms..most_ms).contains(&after_ms), "{lsi_hz}: {after_ms} ms");
    }
}

#[test]
fn the_watchdog_leaves_a_healthy_board_alone() {
    for lsi_hz in [17_000, 47_000] {
        let mut bench = Bench::real(5).at_power_up(|board| board.peripherals.set_lsi_hz(lsi_hz));
        bench.assert_flies();
        assert_eq!(bench.log().reset_causes(), ["PowerOn"], "{lsi_hz} Hz");
    }
}

/// Interrupts go on and the motors with them; nobody pets the watchdog.
#[test]
fn tasks_that_hang_end_in_a_reset() {
    let bench = Bench::real(4).then(Phase::Hover, IN_HOVER_MS, |vehicle| {
        // b .
        run_instead(vehicle.machine_mut(), &[], &[0xE7FE]);
    });
    let after_ms = reset_in_flight(bench, "Watchdog", &["Watchdog"]);
    println!("tasks hang: motors off after {after_ms:.1} ms");
    assert!((40.0..125.0).contains(&after_ms), "{after_ms} ms");
}

/// Makes thread mode go on with these instructions, registers set, interrupts on.
fn run_instead(board: &mut Board, registers: &[u32], code: &[u16]) {
    // cpsie i
    let code = [0xB662].iter().chain(code);
    let bytes: Vec<u8> = code.flat_map(|half| half.to_le_bytes()).collect();
    board.memory.place(SPARE_RAM, &bytes).expect("RAM");
    for _ in 0..10_000 {
        wake(board);
        if board.core.exception_number() == 0 {
            for (number, value) in (0..).zip(registers) {
                board.core.set_register(number, *value);
            }
            board.core.set_register(15, SPARE_RAM);
            return;
        }
        let until = board.time() + 100;
        board.run_until(until);
    }
    panic!("no thread mode");
}

// ------------------------------------------------------------------------------------------------------------ crashes

/// Does something bad to the board in the hover; it must stop the motors within a millisecond, and come back.
fn crash(kind: &str, mut act: impl FnMut(&mut Board) + 'static) -> Stopped {
    let seen = Rc::new(Cell::new(Stopped::default()));
    let noted = Rc::clone(&seen);
    let bench = Bench::real(6).then(Phase::Hover, IN_HOVER_MS, move |vehicle| {
        wake(vehicle.machine_mut());
        act(vehicle.machine_mut());
        noted.set(stopped(vehicle));
    });
    reset_in_flight(bench, "Software", &[kind]);
    let seen = seen.get();
    println!("{kind}: {seen:?}");
    assert!(seen.told_ms.is_some_and(|ms| ms < 0.5), "{seen:?}");
    assert!(seen.reset_ms.is_some_and(|ms| ms < 1.0), "{seen:?}");
    assert!(seen.low_ms.is_some_and(|ms| ms < 1.0), "{seen:?}");
    seen
}

#[test]
fn a_jump_to_nowhere_stops_the_motors_within_a_millisecond() {
    crash("HardFault", |board| board.core.set_register(15, NOWHERE));
}

/// Whatever handler it hits.
#[test]
fn an_access_to_nowhere_stops_the_motors_within_a_millisecond() {
    crash("HardFault", |board| {
        // ldr r0, [r0]; b .
        run_instead(board, &[NOWHERE], &[0x6800, 0xE7FE]);
    });
}

/// An interrupt that nobody expects, whose line stays high.
#[test]
fn a_stuck_interrupt_stops_the_motors_within_a_millisecond() {
    crash("UnexpectedInterrupt", |board| {
        // The window watchdog's: pend it and switch it on. str r1, [r0]; str r1, [r2]; b .
        run_instead(board, &[0xE000_E200, 1, 0xE000_E100], &[0x6001, 0x6011, 0xE7FE]);
    });
}

/// A word of code that rots stays rotten: the board crashes whenever it gets there, and never turns a motor again.
#[test]
fn a_rotten_word_of_code_keeps_the_motors_off() {
    let bench = Bench::real(7);
    let handler = bench.symbol("EXTI4") & !1;
    let mut bench = bench.then(Phase::Hover, IN_HOVER_MS, move |vehicle| {
        // udf #0
        vehicle.machine_mut().memory.place(handler, &[0x00, 0xDE]).expect("flash");
    });
    assert_eq!(bench.assert_lost().0, FlightState::Boot);
    let after_ms = bench.stopped_after_ms();
    println!("rotten code: motors off after {after_ms:.2} ms");
    // The handler runs at the next edge.
    assert!(after_ms < 1.25 + 0.5, "{after_ms} ms");
    let last = bench.last_turning_ns();
    bench.pass_ms(1000);
    let log = bench.log();
    let crashes = log.crashes();
    assert!(crashes.len() > 3 && crashes.iter().all(|kind| *kind == "HardFault"), "{crashes:?}");
    assert_eq!(bench.last_turning_ns(), last);
}

// ---------------------------------------------------------------------------------------------------------- power-up

/// What RAM holds when power comes on is nobody's business.
#[test]
fn memory_at_power_up_changes_nothing() {
    let run = |fill: &mut dyn FnMut() -> u8| {
        let mut bench = Bench::real(8).at_power_up(|board| {
            let memory = &mut board.memory;
            memory.sram.iter_mut().chain(&mut memory.ccm).for_each(|byte| *byte = fill());
        });
        bench.pass_ms(1500);
        assert_eq!(bench.log().crashes(), [""; 0]);
        (bench.motor_hash(), bench.link_hash(), format!("{:?}", bench.status()))
    };
    let blank = run(&mut || 0);
    assert_eq!(run(&mut || 0xFF), blank);
    for seed in [1_u64, 2, 3] {
        let mut state = seed;
        assert_eq!(run(&mut || (xorshift(&mut state) >> 32) as u8), blank, "seed {seed}");
    }
}

fn xorshift(state: &mut u64) -> u64 {
    *state ^= *state << 13;
    *state ^= *state >> 7;
    *state ^= *state << 17;
    *state
}

/// Bytes on the link and frames on the motors' lines, to the nanosecond.
#[test]
fn a_seed_repeats_itself_to_the_byte() {
    let run = |seed| {
        let mut bench = Bench::real(seed);
        bench.assert_flies();
        (bench.motor_hash(), bench.link_hash())
    };
    let (first, again, other) = (run(9), run(9), run(10));
    assert_eq!(first, again);
    assert!(first.0 != other.0 && first.1 != other.1);
}

// ------------------------------------------------------------------------------------------------------------ the link

/// A second of noise, noisy bytes and breaks on the line of a board that stands: nothing turns, nothing hangs.
#[test]
fn noise_on_the_line_moves_no_motor() {
    let mut bench = Bench::real(11);
    bench.pass_ms(4000);
    let mut state = 1;
    for _ in 0..50 {
        let chip = &mut bench.board().peripherals;
        let ns = chip.clock().ns(chip.now());
        let bytes: Vec<u8> = (0..1500).map(|_| (xorshift(&mut state) >> 32) as u8).collect();
        chip.link_send(ns, &bytes);
        chip.serial_send_noisy(1, ns, 0x55);
        chip.serial_break(1, ns, 300_000);
        bench.pass_ms(20);
    }
    bench.pass_ms(100);
    let telemetry = bench.status();
    assert_eq!(telemetry.state, FlightState::Disarmed);
    assert!(telemetry.link_errors > 50, "{telemetry:?}");
    assert!(!bench.ever_turned());
    assert_eq!(bench.log().reset_causes(), ["PowerOn"]);
}

/// The same in flight, in bursts between the host's frames: it flies on.
#[test]
fn noise_on_the_line_does_not_end_a_flight() {
    let mut bench = Bench::real(12);
    for burst in 0..100 {
        let mut state = 77 + burst;
        bench = bench.then(Phase::Hover, burst * 30, move |vehicle| {
            let chip = &mut vehicle.machine_mut().peripherals;
            let ns = chip.clock().ns(chip.now());
            let bytes: Vec<u8> = (0..200).map(|_| (xorshift(&mut state) >> 32) as u8).collect();
            chip.link_send(ns, &bytes);
            chip.serial_send_noisy(1, ns, 0x55);
            chip.serial_break(1, ns, 150_000);
        });
    }
    let result = bench.assert_flies();
    assert_eq!(result.missed_ticks, 0);
    let telemetry = bench.status();
    assert!(telemetry.link_errors > 50, "{telemetry:?}");
    assert_eq!(bench.bugs(), [""; 0]);
}

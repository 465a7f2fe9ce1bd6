//! What is left when the program can do nothing more, and what the manual leaves open: on the very image that gets flashed.

mod bench;

use std::cell::Cell;
use std::rc::Rc;

use bench::stopping::{Stopped, stopped};
use bench::{Bench, Board, wake};
use emulator::chip::clock::Rates;
use mintime::flight::{Phase, VirtualVehicle};
use mintime_shared::messages::FlightState;

/// Into the hover of each flight that breaks there, ms.
const IN_HOVER_MS: u64 = 300;
/// Nothing lies there.
const NOWHERE: u32 = 0x3000_0000;

/// The processor locks up, and only the watchdog is left: it bites at its own time, at any speed of its oscillator. Nobody
/// sends a frame meanwhile, and the lines rest low.
#[test]
fn a_fault_in_the_fault_handler_ends_in_a_reset() {
    for (lsi_hz, least_ms, most_ms) in [(17_000, 130.0, 177.0), (32_000, 50.0, 95.0), (47_000, 20.0, 65.0)] {
        let bench = Bench::real(6).at_power_up(|board| board.peripherals.set_lsi_hz(lsi_hz));
        let handler = bench.symbol("HardFault") & !1;
        let noted = Rc::new(Cell::new(None));
        let seen = Rc::clone(&noted);
        let mut bench = bench.then(Phase::Hover, IN_HOVER_MS, move |vehicle| {
            let board = vehicle.machine_mut();
            wake(board);
            // udf #0
            board.memory.place(handler, &[0x00, 0xDE]).expect("flash");
            board.core.set_register(15, NOWHERE);
            seen.set(locked_up(board));
        });
        assert_eq!(bench.assert_lost().0, FlightState::Boot);
        let (reset_ms, low) = noted.get().expect("a reset");
        println!("fault in the fault handler, LSI {lsi_hz} Hz: reset after {reset_ms:.1} ms");
        assert!((least_ms..most_ms).contains(&reset_ms), "{lsi_hz}: {reset_ms} ms");
        assert!(low, "the lines were low");
        bench.assert_bug("lock-up");
        bench.assert_bug("it began with");
        bench.assert_is_back("Watchdog", &["Watchdog"]);
    }
}

/// Runs the board alone until the chip is reset: after how many ms, and whether from a frame's length on nothing came on
/// the motors' lines.
fn locked_up(board: &mut Board) -> Option<(f64, bool)> {
    let clock = |board: &Board| board.peripherals.clock().ns(board.time());
    let start = clock(board);
    let last_bits = |board: &Board| board.peripherals.motors(clock(board)).map(|motor| motor.last_bit_ns);
    let mut settled = None;
    while clock(board) < start + 300_000_000 {
        let until = board.time() + board.peripherals.clock().cycles_for(20_000);
        board.run_until(until);
        if board.peripherals.clock().rates() == Rates::RESET {
            return Some(((clock(board) - start) as f64 * 1e-6, settled == Some(last_bits(board))));
        }
        if clock(board) > start + 200_000 {
            settled.get_or_insert(last_bits(board));
        }
    }
    None
}

/// Valid frames that each speed controller has had.
fn frames(board: &Board) -> [u64; 4] {
    board.peripherals.board().escs.each_ref().map(|esc| esc.frames)
}

/// Breaks a copy of the vehicle every ten microseconds of a tick, and sees how it stops and how many frames it sends
/// meanwhile.
fn broken_at_each_moment(
    vehicle: &VirtualVehicle,
    act: impl Fn(&mut Board),
    mut check: impl FnMut(u64, Stopped, [u64; 4]),
) {
    /// A frame and its empty bits.
    const FRAME_US: u64 = 30;
    const STEP_US: u64 = 10;
    let mut stretched = 0;
    for moment_us in (0..1250).step_by(STEP_US as usize) {
        let mut vehicle = vehicle.fork();
        let moment_ns = vehicle.now_ns() + moment_us * 1000;
        vehicle.advance_to(moment_ns).expect("time goes on");
        let board = vehicle.machine_mut();
        let before = frames(board);
        act(board);
        let seen = stopped(&mut vehicle);
        let after = frames(vehicle.machine_mut());
        let bugs = vehicle.report().bugs;
        assert!(bugs.iter().all(|bug| bug.contains("no rate of DShot")), "{moment_us} µs: {bugs:?}");
        stretched += u64::from(!bugs.is_empty());
        check(moment_us, seen, std::array::from_fn(|motor| after[motor] - before[motor]));
    }
    // While a frame was on the wire: its bit is stretched.
    assert!(stretched <= FRAME_US.div_ceil(STEP_US), "{stretched} moments");
}

/// The chip goes on with its internal oscillator, ten times too slow, and the firmware brings it back to speed by that:
/// wherever in a tick it happens each speed controller gets its four stop frames, and no frame besides.
#[test]
fn a_crystal_that_stops_at_any_moment_stops_the_motors_within_a_millisecond() {
    let mut bench = Bench::real(6).then(Phase::Hover, IN_HOVER_MS, |vehicle| {
        let mut latest_ms = [0.0_f64; 3];
        broken_at_each_moment(vehicle, lose_crystal, |moment_us, seen, frames| {
            assert!(seen.told_ms.is_some_and(|ms| ms < 0.5), "{moment_us} µs: {seen:?}");
            assert!(seen.reset_ms.is_some_and(|ms| ms < 1.0), "{moment_us} µs: {seen:?}");
            assert!(seen.low_ms.is_some_and(|ms| ms < 1.0), "{moment_us} µs: {seen:?}");
            assert_eq!(frames, [4; 4], "{moment_us} µs");
            for (latest, ms) in latest_ms.iter_mut().zip([seen.told_ms, seen.reset_ms, seen.low_ms]) {
                *latest = latest.max(ms.unwrap_or(f64::NAN));
            }
        });
        println!("crystal: told, reset, low after {latest_ms:.2?} ms at the latest");
        lose_crystal(vehicle.machine_mut());
        stopped(vehicle);
        // It comes back, or nobody would hear of the vehicle again.
        let board = vehicle.machine_mut();
        board.peripherals.fail_crystal(&mut board.memory, board.core.cycle, false);
    });
    assert_eq!(bench.assert_lost().0, FlightState::Boot);
    bench.assert_is_back("Software", &["ClockLost"]);
}

fn lose_crystal(board: &mut Board) {
    board.peripherals.fail_crystal(&mut board.memory, board.core.cycle, true);
}

/// Nothing brings the chip back to speed: the lines are low all the same, and no frame comes at a rate that is none.
#[test]
fn a_crystal_and_a_pll_that_are_lost_leave_low_lines() {
    let mut bench = Bench::real(6).then(Phase::Hover, IN_HOVER_MS, |vehicle| {
        let lose_both = |board: &mut Board| {
            board.peripherals.set_pll_dead(true);
            lose_crystal(board);
        };
        broken_at_each_moment(vehicle, lose_both, |moment_us, seen, frames| {
            assert!(seen.low_ms.is_some_and(|ms| ms < 5.0), "{moment_us} µs: {seen:?}");
            assert_eq!(frames, [0; 4], "{moment_us} µs");
        });
    });
    bench.assert_flies();
}

/// What the manual does not say of a timer's requests for DMA: whether one outlives its enable bit, and whether enabling them
/// makes one where the update's flag stands.
#[test]
fn a_flight_goes_well_whatever_the_manual_leaves_open() {
    for (sticky, standing) in [(true, false), (false, true), (true, true)] {
        let mut bench = Bench::real(1).at_power_up(|board| {
            board.peripherals.set_sticky_timer_requests(sticky);
            board.peripherals.set_standing_timer_requests(standing);
        });
        bench.assert_flies();
        let board = bench.status().board.expect("a board");
        assert_eq!(
            (board.motor_errors, bench.bugs()),
            (0, Vec::new()),
            "sticky {sticky}, standing {standing}"
        );
    }
}

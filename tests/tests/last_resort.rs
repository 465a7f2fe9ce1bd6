//! What is left when the program can do nothing more, and what the manual leaves open: on the very image that gets flashed.

mod bench;

use std::cell::Cell;
use std::rc::Rc;

use bench::{Bench, Board, wake};
use emulator::chip::clock::Rates;
use mintime::flight::Phase;
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

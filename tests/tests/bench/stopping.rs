//! How the motors are stopped by a board that ends its run.

use emulator::chip::clock::Rates;
use mintime::flight::VirtualVehicle;

use super::{Board, MOTOR_PINS};

/// After the fault, ms: when every speed controller was told to stop, when the chip was reset (its pins float then, and
/// bring no pulses), and when the firmware began to hold the lines low again.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Stopped {
    pub(crate) told_ms: Option<f64>,
    pub(crate) reset_ms: Option<f64>,
    pub(crate) low_ms: Option<f64>,
}

/// Runs the board alone for ten milliseconds, looking at the motors every ten microseconds.
pub(crate) fn stopped(vehicle: &mut VirtualVehicle) -> Stopped {
    let board = vehicle.machine_mut();
    let clock = |board: &Board| board.peripherals.clock().ns(board.time());
    let start = clock(board);
    let mut seen = Stopped::default();
    while clock(board) < start + 10_000_000 {
        let until = board.time() + board.peripherals.clock().cycles_for(10_000);
        board.run_until(until);
        let ms = (clock(board) - start) as f64 * 1e-6;
        let chip = &board.peripherals;
        if chip.motors(clock(board)).iter().all(|motor| motor.throttle.unwrap_or(0.0) == 0.0) {
            seen.told_ms.get_or_insert(ms);
        }
        if chip.clock().rates() == Rates::RESET {
            seen.reset_ms.get_or_insert(ms);
            if MOTOR_PINS.iter().all(|pin| chip.driven_level(*pin) == Some(false)) {
                seen.low_ms.get_or_insert(ms);
            }
        }
    }
    seen
}

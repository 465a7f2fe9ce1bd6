//! Supervision: pets the watchdog, reads the battery, blinks, measures load and stack, and reports once a second. Thread mode, every 20 ms.

use core::sync::atomic::{AtomicU16, AtomicU32, Ordering};

use embassy_stm32::gpio::{Output, Speed};
use embassy_stm32::{Peri, peripherals};
use embassy_time::{Duration, Ticker};

use super::battery::{self, Battery};
use super::idle::LoadMeter;
use super::{control, facts, link, stack, watchdog};

const PERIOD: Duration = Duration::from_millis(20);
/// Rounds between two reports: one second.
const ROUNDS_PER_REPORT: u32 = 50;
/// Rounds per change of the LED: once a second in good health, five times after a crash.
const BLINK_HEALTHY: u32 = 25;
const BLINK_CRASHED: u32 = 5;

/// The processor's load over the last second, ‰.
pub(super) static LOAD_PERMILLE: AtomicU16 = AtomicU16::new(0);
/// Deepest use of the stack so far, bytes.
pub(super) static STACK_USED_BYTES: AtomicU32 = AtomicU32::new(0);

/// Runs for ever. `crashed` chooses the fast blink that says: the last run ended in a crash.
#[embassy_executor::task]
pub(super) async fn run(mut battery: Battery, mut led: Output<'static>, crashed: bool) {
    let blink = if crashed { BLINK_CRASHED } else { BLINK_HEALTHY };
    let mut ticker = Ticker::every(PERIOD);
    let mut round: u32 = 0;
    let mut load = LoadMeter::new();
    loop {
        ticker.next().await;
        watchdog::pet_if_all_alive();
        battery.sample();

        let lit = (round / blink).is_multiple_of(2);
        led.set_level(if lit { facts::LED_ON } else { facts::LED_OFF });
        if round.is_multiple_of(ROUNDS_PER_REPORT) {
            LOAD_PERMILLE.store(load.permille(), Ordering::Relaxed);
            STACK_USED_BYTES.store(stack::used_bytes(), Ordering::Relaxed);
            report();
        }
        round = round.wrapping_add(1);
    }
}

/// In pieces: while one line is written into the log the control tick waits.
fn report() {
    let board = control::telemetry();
    let us = |ns: u32| ns / 1000;
    defmt::info!(
        "ticks {=u32}, missed {=u32}, longest {=u32} us, gyro to motors {=u32} to {=u32} us",
        control::TICKS.load(Ordering::Relaxed),
        board.missed_ticks,
        us(board.tick_max_ns),
        us(board.latency_min_ns),
        us(board.latency_max_ns),
    );
    defmt::info!(
        "load {=u16} permille, stack {=u16} B, battery {} V",
        board.load_permille,
        board.stack_used_bytes,
        battery::voltage(),
    );
    defmt::info!(
        "errors: gyro {=u32}, edges {=u32}, motors {=u32}, link in {=u32} out {=u32}",
        board.gyro_errors,
        board.spurious_edges,
        board.motor_errors,
        link::RECEIVE_ERRORS.load(Ordering::Relaxed),
        link::TRANSMIT_ERRORS.load(Ordering::Relaxed),
    );
}

/// The LED, dark.
pub(super) fn led(pin: Peri<'static, peripherals::PC8>) -> Output<'static> {
    Output::new(pin, facts::LED_OFF, Speed::Low)
}

//! Supervision: pets the watchdog, reads the battery, blinks, and reports once a second. Thread mode, every 20 ms.

use core::sync::atomic::Ordering;

use embassy_stm32::gpio::{Output, Speed};
use embassy_stm32::{Peri, peripherals};
use embassy_time::{Duration, Ticker};

use super::battery::{self, Battery};
use super::{control, facts, link, stack, watchdog};

const PERIOD: Duration = Duration::from_millis(20);
/// Rounds between two reports: one second.
const ROUNDS_PER_REPORT: u32 = 50;
/// Rounds per change of the LED: once a second in good health, five times after a crash.
const BLINK_HEALTHY: u32 = 25;
const BLINK_CRASHED: u32 = 5;

/// Runs for ever. `crashed` chooses the fast blink that says: the last run ended in a crash.
#[embassy_executor::task]
pub(super) async fn run(mut battery: Battery, mut led: Output<'static>, crashed: bool) {
    let blink = if crashed { BLINK_CRASHED } else { BLINK_HEALTHY };
    let mut ticker = Ticker::every(PERIOD);
    let mut round: u32 = 0;
    loop {
        ticker.next().await;
        watchdog::pet_if_all_alive();
        battery.sample();

        let lit = (round / blink).is_multiple_of(2);
        led.set_level(if lit { facts::LED_ON } else { facts::LED_OFF });
        if round.is_multiple_of(ROUNDS_PER_REPORT) {
            report();
        }
        round = round.wrapping_add(1);
    }
}

fn report() {
    defmt::info!(
        "ticks {=u32}, missed {=u32}, worst late {=u32} us, worst run {=u32} us, battery {} V, link errors in {=u32} out {=u32}, stack used {=u32} B",
        control::TICKS.load(Ordering::Relaxed),
        control::MISSED_TICKS.load(Ordering::Relaxed),
        control::WORST_LATENESS_US.load(Ordering::Relaxed),
        control::WORST_RUN_US.load(Ordering::Relaxed),
        battery::voltage(),
        link::RECEIVE_ERRORS.load(Ordering::Relaxed),
        link::TRANSMIT_ERRORS.load(Ordering::Relaxed),
        stack::used_bytes(),
    );
}

/// The LED, dark.
pub(super) fn led(pin: Peri<'static, peripherals::PC8>) -> Output<'static> {
    Output::new(pin, facts::LED_OFF, Speed::Low)
}

//! The control tick: 800 times a second the flight logic, in an interrupt of its own.
//!
//! Deadline: 1250 µs after the tick is due. Order within a tick: flight logic and motors first, so that their delay
//! does not depend on the link; then at most [`BYTES_PER_TICK`] bytes each way, a little more than the line can carry.
//! A tick that comes late is counted and the following ones keep their times: the flight logic takes time from the
//! clock, never from counting ticks.

use core::sync::atomic::{AtomicU32, Ordering};

use embassy_executor::InterruptExecutor;
use embassy_stm32::interrupt;
use embassy_stm32::interrupt::InterruptExt;
use embassy_time::{Duration, Instant, Timer};
use mintime_firmware::flight::TickInput;

use mintime_shared::replay::TICK_PERIOD_US;

use super::facts::CONTROL_PRIORITY;
use super::link::{INBOX, OUTBOX};
use super::watchdog::{self, Party};
use super::{battery, fault, vehicle};

/// Period of the control tick: 800 Hz, the gyro's native rate.
const PERIOD: Duration = Duration::from_micros(TICK_PERIOD_US as u64);
/// Link bytes moved per tick and direction. The line carries 115.2 in a tick.
const BYTES_PER_TICK: usize = 128;

/// Ticks run.
pub(super) static TICKS: AtomicU32 = AtomicU32::new(0);
/// Ticks skipped because the one before was still running or the tick came a whole period late.
pub(super) static MISSED_TICKS: AtomicU32 = AtomicU32::new(0);
/// Longest time from a tick's due time to its start [µs].
pub(super) static WORST_LATENESS_US: AtomicU32 = AtomicU32::new(0);
/// Longest run of a tick, link work included [µs].
pub(super) static WORST_RUN_US: AtomicU32 = AtomicU32::new(0);

static EXECUTOR: InterruptExecutor = InterruptExecutor::new();

/// The interrupt that the executor pends by software. Its peripheral (I2C3) is not in use.
#[allow(unsafe_code)]
#[interrupt]
unsafe fn I2C3_ER() {
    // SAFETY: called from the interrupt that `start` was given, which unmasks it only after the executor exists.
    unsafe { EXECUTOR.on_interrupt() }
}

/// Starts the control tick.
pub(super) fn start() {
    interrupt::I2C3_ER.set_priority(CONTROL_PRIORITY);
    let spawner = EXECUTOR.start(interrupt::I2C3_ER);
    match run() {
        Ok(task) => spawner.spawn(task),
        Err(_) => fault::set_up_failed(line!()),
    }
}

#[embassy_executor::task]
async fn run() {
    let vehicle = vehicle::take();
    let mut bytes = [0; BYTES_PER_TICK];
    let mut due = Instant::now() + PERIOD;
    loop {
        Timer::at(due).await;
        let now = Instant::now();

        // No gyro or motor driver yet: the flight logic sees no sample and refuses to arm; its command goes nowhere.
        let input =
            TickInput { now_us: now.as_micros(), imu: None, battery_v: battery::voltage(), kill: false };
        let _motors = vehicle.tick(&input);

        let room = OUTBOX.free_capacity().min(bytes.len());
        let sent = vehicle.transmit(bytes.get_mut(..room).unwrap_or_default());
        // One writer, and the room was just measured: nothing is cut short. The second write is for the wrap.
        let mut rest = bytes.get(..sent.min(room)).unwrap_or_default();
        while let Ok(taken) = OUTBOX.try_write(rest)
            && taken < rest.len()
        {
            rest = rest.get(taken..).unwrap_or_default();
        }

        let received = INBOX.try_read(&mut bytes).unwrap_or(0);
        vehicle.receive(bytes.get(..received).unwrap_or_default());

        watchdog::check_in(Party::Control);
        TICKS.fetch_add(1, Ordering::Relaxed);
        let end = Instant::now();
        keep_worst(&WORST_LATENESS_US, now.saturating_duration_since(due));
        keep_worst(&WORST_RUN_US, end.saturating_duration_since(now));

        due += PERIOD;
        if due <= end {
            // By division, not by counting: after a halt the gap may be of any length.
            let missed = (end - due).as_ticks() / PERIOD.as_ticks() + 1;
            due += Duration::from_ticks(missed.saturating_mul(PERIOD.as_ticks()));
            MISSED_TICKS.fetch_add(u32::try_from(missed).unwrap_or(u32::MAX), Ordering::Relaxed);
        }
    }
}

fn keep_worst(worst: &AtomicU32, time: Duration) {
    worst.fetch_max(u32::try_from(time.as_micros()).unwrap_or(u32::MAX), Ordering::Relaxed);
}

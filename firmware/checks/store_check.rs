//! The store on the chip, alone: looks at what each key holds, then writes for ever, and leaves in RAM what it saw.
//!
//! Each value is its number, then bytes that follow from key and number: whoever reads it knows whether it is one.
#![no_std]
#![no_main]
#![deny(clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::indexing_slicing)]

#[path = "../src/board/critical.rs"]
mod critical;
#[path = "../src/board/flash.rs"]
mod flash;
#[allow(dead_code, reason = "no tasks here that check in with it")]
#[path = "../src/board/watchdog.rs"]
mod watchdog;

use core::sync::atomic::{AtomicU32, Ordering::Relaxed};

use cortex_m::peripheral::DWT;
use defmt_rtt as _;
use embassy_stm32::pac;
use flash::StoreFlash;
use mintime_firmware::store::{Key, Order, Store};

const KEYS: usize = Key::ALL.len();

/// What the test reads.
#[repr(C)]
struct Report {
    /// 1 once the keys have been looked at, 2 once something failed.
    stage: AtomicU32,
    /// Values that were none, or calls that failed.
    bad: AtomicU32,
    /// Number of each key's value at the start, 0 for none.
    found: [AtomicU32; KEYS],
    /// Number of each key's value as far as it has been confirmed.
    confirmed: [AtomicU32; KEYS],
    /// Cycles of the latest write without an erase, and of the latest one with.
    write_cycles: AtomicU32,
    move_cycles: AtomicU32,
    /// Writes, and those that took an erase.
    writes: AtomicU32,
    moves: AtomicU32,
}

#[allow(unsafe_code, reason = "the name by which the test finds it")]
#[unsafe(no_mangle)]
static REPORT: Report = Report {
    stage: AtomicU32::new(0),
    bad: AtomicU32::new(0),
    found: [const { AtomicU32::new(0) }; KEYS],
    confirmed: [const { AtomicU32::new(0) }; KEYS],
    write_cycles: AtomicU32::new(0),
    move_cycles: AtomicU32::new(0),
    writes: AtomicU32::new(0),
    moves: AtomicU32::new(0),
};

/// Cycles that only a write with an erase takes, at the 16 MHz of the internal oscillator.
const ERASE_CYCLES: u32 = 2_000_000;

/// The value of number `n`: between 104 and 256 bytes.
fn value(key: usize, n: u32) -> ([u8; 256], usize) {
    let mut bytes = [0; 256];
    for (at, byte) in bytes.iter_mut().enumerate() {
        *byte = (n as u8).wrapping_mul(31) ^ (at as u8).wrapping_mul(7) ^ key as u8;
    }
    for (byte, part) in bytes.iter_mut().zip(n.to_le_bytes()) {
        *byte = part;
    }
    (bytes, 104 + (n as usize * 13) % 153)
}

fn fail() -> ! {
    REPORT.bad.fetch_add(1, Relaxed);
    REPORT.stage.store(2, Relaxed);
    loop {
        watchdog::check_in(watchdog::Party::Control);
        watchdog::check_in(watchdog::Party::LinkTransmit);
        watchdog::pet_if_all_alive();
    }
}

#[cortex_m_rt::entry]
fn start() -> ! {
    watchdog::start();
    pac::FLASH.acr().modify(|w| {
        w.set_icen(true);
        w.set_dcen(true);
    });
    if let Some(mut core) = cortex_m::Peripherals::take() {
        core.DCB.enable_trace();
        core.DWT.enable_cycle_counter();
    }
    let mut store = Store::new(StoreFlash::new(|| true));
    let mut buffer = [0; 256];
    let mut next = 1;
    for (key, found) in REPORT.found.iter().enumerate() {
        let Some(&name) = Key::ALL.get(key) else { fail() };
        match store.read(name, &mut buffer) {
            Ok(None) => {}
            Ok(Some(length)) => {
                let n = buffer.first_chunk().map_or(0, |head| u32::from_le_bytes(*head));
                let (expected, expected_length) = value(key, n);
                if buffer.get(..length) != expected.get(..expected_length) {
                    fail();
                }
                found.store(n, Relaxed);
                next = next.max(n + 1);
            }
            Err(_) => fail(),
        }
    }
    REPORT.stage.store(1, Relaxed);
    for n in next.. {
        let key = n as usize % KEYS;
        let (Some(&name), Some(confirmed)) = (Key::ALL.get(key), REPORT.confirmed.get(key)) else { fail() };
        let (bytes, length) = value(key, n);
        let Ok(order) = Order::write(name, bytes.get(..length).unwrap_or_default()) else { fail() };
        if watchdog::lengthen().is_err() {
            fail();
        }
        let begin = DWT::cycle_count();
        let result = order.carry_out(&mut store);
        let took = DWT::cycle_count().wrapping_sub(begin);
        if result.is_err() || watchdog::shorten().is_err() {
            fail();
        }
        confirmed.store(n, Relaxed);
        REPORT.writes.fetch_add(1, Relaxed);
        if took > ERASE_CYCLES {
            REPORT.moves.fetch_add(1, Relaxed);
            REPORT.move_cycles.store(took, Relaxed);
        } else {
            REPORT.write_cycles.store(took, Relaxed);
        }
        if store.read(name, &mut buffer) != Ok(Some(length)) || buffer.get(..length) != bytes.get(..length) {
            fail();
        }
    }
    fail()
}

#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    fail()
}

//! The one vehicle of this board, and the memory it records into.
#![allow(unsafe_code)]

use core::cell::UnsafeCell;
use core::mem::MaybeUninit;
use core::sync::atomic::{AtomicBool, Ordering};

use mintime_firmware::config::Capabilities;
use mintime_firmware::vehicle::Vehicle;
use mintime_firmware::watch::Watch;
use mintime_shared::messages::RECORD_BYTES;
use static_cell::StaticCell;

use super::fault;

/// Length of the flight record: 4 s at 800 Hz, 64,000 of the 65,536 bytes of core-coupled memory.
const RECORD_TICKS: usize = 3200;

/// What this board can do at power-up. The control tick says more as the drivers come up.
const CAPABILITIES: Capabilities = Capabilities { gyro: false, motors: false };

type Record = [[u8; RECORD_BYTES]; RECORD_TICKS];

/// The flight logic with its link, recording into [`RECORD`].
pub(super) type BoardVehicle = Vehicle<&'static mut [[u8; RECORD_BYTES]]>;

struct RecordMemory(UnsafeCell<MaybeUninit<Record>>);
// SAFETY: only `take` touches it, and only once.
unsafe impl Sync for RecordMemory {}

/// In core-coupled memory: fast, large, and out of reach of DMA, which the record never needs.
#[unsafe(link_section = ".ccm.record")]
static RECORD: RecordMemory = RecordMemory(UnsafeCell::new(MaybeUninit::uninit()));
static RECORD_TAKEN: AtomicBool = AtomicBool::new(false);
static VEHICLE: StaticCell<BoardVehicle> = StaticCell::new();

/// Builds the vehicle. A second call ends the run.
pub(super) fn take() -> &'static mut BoardVehicle {
    if RECORD_TAKEN.swap(true, Ordering::AcqRel) {
        fault::set_up_failed(line!());
    }
    // SAFETY: the flag above lets one caller through, so this is the only reference. Start-up leaves this memory as it
    // was, so it is written before it is read.
    let record = unsafe {
        let memory = RECORD.0.get();
        memory.write_bytes(0, 1);
        (*memory).assume_init_mut()
    };
    VEHICLE.init_with(|| Vehicle::new(None, CAPABILITIES, record))
}

struct WatchCell(UnsafeCell<Watch>);
// SAFETY: only `watch` touches it, and only once.
unsafe impl Sync for WatchCell {}

/// What the last control tick got and gave, for a debug probe. Its name is [`mintime_firmware::watch::WATCH_SYMBOL`].
#[unsafe(no_mangle)]
static MINTIME_WATCH: WatchCell = WatchCell(UnsafeCell::new(Watch::new()));
static WATCH_TAKEN: AtomicBool = AtomicBool::new(false);

/// The place for the last control tick. A second call ends the run.
pub(super) fn watch() -> &'static mut Watch {
    if WATCH_TAKEN.swap(true, Ordering::AcqRel) {
        fault::set_up_failed(line!());
    }
    // SAFETY: the flag above lets one caller through, so this is the only reference.
    unsafe { &mut *MINTIME_WATCH.0.get() }
}

//! The store at work: the control tick hands over one order at a time, thread mode carries it out.
//!
//! An erase stops the processor for up to half a second, so the control tick may hand over an order only while the motors
//! are off, and may let nobody arm while [`busy`] says so. From [`submit`] on that is the case, up to the tick in which the
//! answer can be taken.
//!
//! Times, at the longest: an order waits for thread mode to be free (a millisecond); writing takes 68 words of 0.1 ms, in the
//! quiet part of the ticks, so twice that; once in a hundred writes or so a sector is erased and refilled, 0.5 s and 0.14 s.
//! The watchdog's timeout is lengthened for each order and set back after it. Time stands still during an erase ([`super::flash`]): ticks neither run late nor count
//! as missed, the board's clock is behind by that much afterwards.

use core::cell::{Cell, RefCell};
use core::sync::atomic::{AtomicBool, Ordering};

use cortex_m::peripheral::DWT;
use embassy_sync::blocking_mutex::Mutex;
use embassy_sync::blocking_mutex::raw::CriticalSectionRawMutex;
use embassy_sync::signal::Signal;
use mintime_firmware::store::{Damage, Done, FlashFault, Key, Order, Store, StoreError, VALUE_BYTES};

use super::facts::{CORE_MHZ, MOTOR_TIMER};
use super::flash::StoreFlash;
use super::{fault, tick_source, watchdog};

/// The store of this board.
pub(super) type BoardStore = Store<StoreFlash>;

/// Set from the moment an order is handed over until it is done.
static BUSY: AtomicBool = AtomicBool::new(false);
/// The order under way, with its number.
static PENDING: Mutex<CriticalSectionRawMutex, RefCell<Option<(u32, Order)>>> =
    Mutex::new(RefCell::new(None));
/// What became of the last one, until somebody takes it.
static DONE: Mutex<CriticalSectionRawMutex, Cell<Option<Done>>> = Mutex::new(Cell::new(None));
/// Wakes the task.
static WAKE: Signal<CriticalSectionRawMutex, ()> = Signal::new();

/// Another order is under way; come again when [`take_done`] has answered.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Occupied;

/// Opens the store, for reading at start-up and then for [`run`]. Once.
pub(super) fn open() -> BoardStore {
    Store::new(StoreFlash::new(quiet))
}

/// Whether the control tick and its motors' frame are over and the next ones are not near. With the motors off, too: a frame
/// spoilt means three seconds until the speed controllers count as armed again.
fn quiet() -> bool {
    let since_edge_us = DWT::cycle_count().wrapping_sub(tick_source::edge_cycles()) / CORE_MHZ;
    let near = since_edge_us < 250 || (1000..1400).contains(&since_edge_us);
    !near && !MOTOR_TIMER.cr1().read().cen()
}

/// Hands every value that is there to `take`, by its key. At start-up, before [`run`] owns the store; takes 6 ms. What cannot
/// be read is left out. Returns which keys could not be read, may not have the value written last, or were not taken.
#[inline(never)]
pub(super) fn each(store: &mut BoardStore, mut take: impl FnMut(Key, &[u8]) -> bool) -> Damage {
    let mut value = [0; VALUE_BYTES];
    let mut damage = store.damage().unwrap_or(Damage::ALL);
    for key in Key::ALL {
        let taken = match store.read(key, &mut value) {
            Ok(Some(length)) => take(key, value.get(..length).unwrap_or_default()),
            Ok(None) => true,
            Err(_) => false,
        };
        if !taken {
            damage.set(key, true);
        }
    }
    if damage.is_any() {
        defmt::error!("kept: some of it is damaged");
    }
    damage
}

/// Hands over an order; its answer comes back under the same `number`. From the control tick, with the motors off: the
/// processor may stand still for half a second, any time from now on until [`busy`] is false.
///
/// # Errors
///
/// [`Occupied`].
pub(super) fn submit(number: u32, order: Order) -> Result<(), Occupied> {
    if BUSY.load(Ordering::Acquire) {
        return Err(Occupied);
    }
    let placed = PENDING.lock(|pending| {
        pending.try_borrow_mut().map(|mut slot| *slot = Some((number, order))).map_err(|_| Occupied)
    });
    if placed.is_ok() {
        BUSY.store(true, Ordering::Release);
        WAKE.signal(());
    }
    placed
}

/// Whether an order is under way: nobody may arm. From the control tick.
pub(super) fn busy() -> bool {
    BUSY.load(Ordering::Acquire)
}

/// What became of the last order, once. From the control tick.
pub(super) fn take_done() -> Option<Done> {
    DONE.lock(Cell::take)
}

/// Carries out orders for ever.
#[embassy_executor::task]
pub(super) async fn run(mut store: BoardStore) {
    loop {
        WAKE.wait().await;
        let order = PENDING.lock(|pending| pending.try_borrow_mut().ok().and_then(|mut slot| slot.take()));
        let Some((number, order)) = order else { continue };
        let result = with_time(|| order.carry_out(&mut store));
        if let Err(error) = result {
            defmt::warn!("the store: order {=u32} failed: {=str}", number, error.text());
        }
        DONE.lock(|done| done.set(Some(Done { number, result })));
        BUSY.store(false, Ordering::Release);
    }
}

/// Runs `work` under a watchdog that allows for an erase.
fn with_time(work: impl FnOnce() -> Result<(), StoreError>) -> Result<(), StoreError> {
    let result = if watchdog::lengthen().is_ok() { work() } else { Err(StoreError::Flash(FlashFault::Busy)) };
    // A watchdog that cannot be made strict again is none; the motors are off, so start afresh.
    if watchdog::shorten().is_err() {
        fault::set_up_failed(line!());
    }
    result
}

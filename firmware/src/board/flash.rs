//! The two sectors of flash that hold the store, by the registers of the flash interface (RM0090 section 3).
//!
//! While flash is programmed or erased every access to it waits, instructions included: the processor stands still for up
//! to 0.1 ms a word and 0.5 s a sector. So whoever calls this has the motors off, and the watchdog's timeout lengthened.
//!
//! Every wait is bounded by the cycle counter, which goes on counting. The flash is locked whenever no operation is under
//! way, and no address outside the two sectors can be reached.
#![allow(unsafe_code)]

use core::ptr;

use cortex_m::peripheral::DWT;
use embassy_stm32::pac::flash::regs::Sr;
use embassy_stm32::pac::flash::vals::Psize;
use embassy_stm32::pac::{FLASH, RCC, TIM5};
use mintime_firmware::store::{Flash, FlashFault, SECTOR_BYTES, Sector};

/// The keys that unlock the control register (RM0090 section 3.6.1).
const KEYS: [u32; 2] = [0x4567_0123, 0xCDEF_89AB];
/// Sector 1 begins here; sector 2 follows. `memory.x` keeps the program out of both.
const STORE_ADDRESS: usize = 0x0800_4000;
/// Longest wait for the end of an operation, cycles: 1.2 s at 168 MHz. The longest one is an erase, 0.5 s by words and 0.8
/// by bytes (DS8626, flash memory programming).
const BUSY_CYCLES: u32 = 168_000_000 / 5 * 6;

/// Longest wait for a quiet moment, cycles: 3 ms at 168 MHz, more than two control ticks.
const QUIET_CYCLES: u32 = 168 * 3000;

/// The store's flash. There is one.
#[derive(Debug)]
pub(super) struct StoreFlash {
    quiet: fn() -> bool,
}

impl StoreFlash {
    /// Takes it over. Once. `quiet` is asked with interrupts off whether nothing will need the processor for the next 0.1 ms:
    /// where a motors' frame or the tick before it waits for a word being programmed, it comes late.
    pub(super) const fn new(quiet: fn() -> bool) -> Self {
        Self { quiet }
    }

    /// Runs an operation with interrupts off, in a quiet moment if one comes soon.
    #[inline(never)]
    fn when_quiet(&self, operation: impl Fn() -> Result<(), FlashFault>) -> Result<(), FlashFault> {
        let begin = DWT::cycle_count();
        loop {
            let late = DWT::cycle_count().wrapping_sub(begin) > QUIET_CYCLES;
            let result = cortex_m::interrupt::free(|_| (late || (self.quiet)()).then(&operation));
            if let Some(result) = result {
                return result;
            }
        }
    }
}

impl Flash for StoreFlash {
    #[inline(never)]
    fn read(&mut self, sector: Sector, offset: usize, into: &mut [u8]) -> Result<(), FlashFault> {
        let from = place(sector, offset, into.len())? as *const u8;
        for (n, byte) in into.iter_mut().enumerate() {
            // SAFETY: inside the store's sectors, as `place` checked; volatile, because the content changes behind the
            // compiler's back.
            *byte = unsafe { ptr::read_volatile(from.add(n)) };
        }
        Ok(())
    }

    fn program(&mut self, sector: Sector, offset: usize, word: u32) -> Result<(), FlashFault> {
        let place = place(sector, offset, 4)?;
        if !offset.is_multiple_of(4) {
            return Err(FlashFault::Place);
        }
        self.when_quiet(|| {
            unlocked(|| {
                FLASH.cr().write(|w| {
                    w.set_psize(Psize::PSIZE32);
                    w.set_pg(true);
                });
                // SAFETY: inside the store's sectors and aligned; flash takes the write as a command, no memory of the
                // program changes.
                unsafe { ptr::write_volatile(place as *mut u32, word) };
                cortex_m::asm::dsb();
                wait()
            })
        })
    }

    /// Nothing else could run meanwhile, and the clock stands still, because it would lose count of its
    /// rounds (65 ms) if nobody answered its interrupt for longer than half of one.
    fn erase(&mut self, sector: Sector) -> Result<(), FlashFault> {
        let number = match sector {
            Sector::First => 1,
            Sector::Second => 2,
        };
        let command = |start: bool| {
            FLASH.cr().write(|w| {
                w.set_psize(Psize::PSIZE32);
                w.set_ser(true);
                w.set_snb(number);
                w.set_strt(start);
            });
        };
        self.when_quiet(|| {
            unlocked(|| {
                let running = RCC.apb1enr().read().tim5en() && TIM5.cr1().read().cen();
                if running {
                    TIM5.cr1().modify(|w| w.set_cen(false));
                }
                command(false);
                command(true);
                cortex_m::asm::dsb();
                let result = wait();
                if running {
                    TIM5.cr1().modify(|w| w.set_cen(true));
                }
                result
            })
        })
    }
}

/// Address of `bytes` bytes of a sector.
fn place(sector: Sector, offset: usize, bytes: usize) -> Result<usize, FlashFault> {
    let end = offset.checked_add(bytes).ok_or(FlashFault::Place)?;
    if end > SECTOR_BYTES {
        return Err(FlashFault::Place);
    }
    let first = match sector {
        Sector::First => STORE_ADDRESS,
        Sector::Second => STORE_ADDRESS + SECTOR_BYTES,
    };
    Ok(first + offset)
}

/// Runs an operation on unlocked flash with no error flag set; locks it and renews the caches whatever came of it.
fn unlocked(operation: impl FnOnce() -> Result<(), FlashFault>) -> Result<(), FlashFault> {
    wait_until_idle()?;
    clear_errors();
    if FLASH.cr().read().lock() {
        for key in KEYS {
            FLASH.keyr().write_value(key);
        }
    }
    if FLASH.cr().read().lock() {
        return Err(FlashFault::Locked);
    }
    let result = operation();
    // Where flash is still busy its control register must not be written.
    if !FLASH.sr().read().bsy() {
        FLASH.cr().write(|w| w.set_lock(true));
    }
    renew_caches();
    result
}

/// Waits for the end of an operation and looks at what it says.
fn wait() -> Result<(), FlashFault> {
    wait_until_idle()?;
    let status = FLASH.sr().read();
    if status.wrperr() || status.pgaerr() || status.pgperr() || status.pgserr() || status.operr() {
        clear_errors();
        return Err(FlashFault::Refused(status.0));
    }
    Ok(())
}

fn wait_until_idle() -> Result<(), FlashFault> {
    let begin = DWT::cycle_count();
    loop {
        if !FLASH.sr().read().bsy() {
            return Ok(());
        }
        if DWT::cycle_count().wrapping_sub(begin) > BUSY_CYCLES {
            return Err(FlashFault::Busy);
        }
    }
}

/// Writing ones clears them.
fn clear_errors() {
    let mut flags = Sr(0);
    flags.set_eop(true);
    flags.set_operr(true);
    flags.set_wrperr(true);
    flags.set_pgaerr(true);
    flags.set_pgperr(true);
    flags.set_pgserr(true);
    FLASH.sr().write_value(flags);
}

/// Empties both caches, which may hold what was there before (RM0090 section 3.5.2); they can be emptied only while they are
/// off. Leaves them as they were.
fn renew_caches() {
    let before = FLASH.acr().read();
    let mut off = before;
    off.set_icen(false);
    off.set_dcen(false);
    FLASH.acr().write_value(off);
    let mut reset = off;
    reset.set_icrst(true);
    reset.set_dcrst(true);
    FLASH.acr().write_value(reset);
    FLASH.acr().write_value(off);
    FLASH.acr().write_value(before);
}

//! Panics, faults and resets: motors off first, the reason kept in RAM across the reset, then a reset.
//!
//! A reset is the one state every part of the board agrees on: pins float, speed controllers disarm. Nothing is logged
//! from inside a handler, because the logger itself may be what failed; the next start reports the reason.
#![allow(unsafe_code)]

use core::cell::UnsafeCell;
use core::mem::{self, MaybeUninit};
use core::panic::PanicInfo;
use core::{ptr, slice};

use cortex_m::peripheral::SCB;
use cortex_m_rt::exception;
use embassy_stm32::pac;
use mintime_shared::messages::AbortReason;

use super::motors;

/// Marks a crash record as written by this firmware ("MTCR").
const MAGIC: u32 = 0x4D54_4352;
/// Bytes kept of the name of the file that panicked.
const FILE_BYTES: usize = 32;

/// Crashes that are kept at most.
pub(super) const CRASH_COUNT: usize = 2;

/// What ended a run.
#[derive(Clone, Copy, PartialEq, Eq, defmt::Format)]
#[repr(u32)]
pub(super) enum Kind {
    /// A panic in Rust code.
    Panic = 1,
    /// The processor met an access or instruction it cannot do; a stack overflow ends here.
    HardFault = 2,
    /// The crystal stopped.
    ClockLost = 3,
    /// An interrupt nobody handles.
    UnexpectedInterrupt = 4,
    /// A peripheral refused its set-up, or to work on.
    SetUp = 5,
    /// The chip's supply fell.
    BrownOut = 6,
    /// The watchdog fired.
    Watchdog = 7,
    /// The stack left its memory.
    StackOverflow = 8,
    /// The flight logic stopped the motors for good; the run went on.
    Terminated = 9,
}

impl Kind {
    fn from_word(word: u32) -> Option<Self> {
        [
            Self::Panic,
            Self::HardFault,
            Self::ClockLost,
            Self::UnexpectedInterrupt,
            Self::SetUp,
            Self::BrownOut,
            Self::Watchdog,
            Self::StackOverflow,
            Self::Terminated,
        ]
        .into_iter()
        .find(|kind| *kind as u32 == word)
    }
}

/// The record in RAM that no start-up code clears. Words only, so that any bit pattern is a valid value.
#[derive(Clone, Copy)]
#[repr(C)]
struct Record {
    magic: u32,
    kind: u32,
    /// Address of the instruction that faulted, or the interrupt's number.
    pc: u32,
    lr: u32,
    /// Fault status registers (ARMv7-M architecture, B3.2.15 and B3.2.16).
    cfsr: u32,
    hfsr: u32,
    address: u32,
    /// Where the panic was raised; of a termination the place of its reason in [`AbortReason::ALL`].
    line: u32,
    file: [u8; FILE_BYTES],
    /// Crashes since power came on.
    count: u32,
    /// Of all before it.
    check: u32,
}

impl Record {
    const fn new(kind: Kind) -> Self {
        Self {
            magic: MAGIC,
            kind: kind as u32,
            pc: 0,
            lr: 0,
            cfsr: 0,
            hfsr: 0,
            address: 0,
            line: 0,
            file: [0; FILE_BYTES],
            count: 0,
            check: 0,
        }
    }

    /// FNV-1a over everything but the check itself: RAM after power-on is noise and must not pass for a crash.
    #[inline(never)]
    fn checksum(&self) -> u32 {
        // SAFETY: words and bytes without padding between them, all of them before the last.
        let bytes =
            unsafe { slice::from_raw_parts(ptr::from_ref(self).cast::<u8>(), mem::offset_of!(Self, check)) };
        bytes.iter().fold(0x811C_9DC5, |hash, byte| (hash ^ u32::from(*byte)).wrapping_mul(0x0100_0193))
    }
}

/// A crash that nobody has acknowledged, as reported at start-up.
#[derive(Clone, Copy, defmt::Format)]
pub(super) struct Crash {
    pub(super) kind: Kind,
    pub(super) pc: u32,
    pub(super) lr: u32,
    pub(super) cfsr: u32,
    pub(super) hfsr: u32,
    pub(super) address: u32,
    pub(super) line: u32,
    /// End of the file's name, padded with zeros.
    pub(super) file: [u8; FILE_BYTES],
    /// Crashes since power came on, this one included; of the first also what it was counted for.
    pub(super) count: u32,
}

/// Room for one record.
struct Kept(UnsafeCell<MaybeUninit<Record>>);
// SAFETY: start-up reads and writes it before anything else runs, the control tick after that, and what ends the run, with
// interrupts off. Only the last may come in between, and it does not return: there is never more than one access that
// matters, and a record that is half one and half the other fails its check.
unsafe impl Sync for Kept {}

impl Kept {
    const fn new() -> Self {
        Self(UnsafeCell::new(MaybeUninit::uninit()))
    }

    /// What is kept, acknowledged or not.
    #[inline(never)]
    fn read(&self) -> Option<Record> {
        // SAFETY: every field is an integer, so whatever the RAM holds is a valid record; volatile, because the compiler
        // must not reason about memory that was never written by this run.
        let record = unsafe { ptr::read_volatile(self.0.get().cast::<Record>()) };
        (record.magic == MAGIC && record.check == record.checksum()).then_some(record)
    }

    #[inline(never)]
    fn write(&self, mut record: Record) {
        record.check = record.checksum();
        // SAFETY: see above; the pointer is that of a static of this type.
        unsafe { ptr::write_volatile(self.0.get().cast::<Record>(), record) }
    }

    /// What is kept and nobody has acknowledged.
    fn waiting(&self) -> Option<Record> {
        self.read().filter(|record| record.kind != 0)
    }

    /// A person has read of it. Its count stays, so that repeated crashes are seen.
    fn forget(&self) {
        if let Some(record) = self.read() {
            self.write(Record { kind: 0, ..record });
        }
    }
}

/// Crashes that wait to be acknowledged: the first, which is the cause, and the latest behind it.
#[unsafe(link_section = ".uninit.crash")]
static CRASHES: [Kept; CRASH_COUNT] = [const { Kept::new() }; CRASH_COUNT];
/// Why the flight logic stopped the motors for good. By itself, so that neither a crash nor this displaces the other.
#[unsafe(link_section = ".uninit.termination")]
static TERMINATION: Kept = Kept::new();

/// Motors told to stop, their lines low. First of all, whatever ends the run: registers only.
fn stop_motors() {
    cortex_m::interrupt::disable();
    motors::shut_down();
}

/// Ends the run, whose motors have been stopped: the reason kept, reset.
fn end(record: Record) -> ! {
    keep(record);
    SCB::sys_reset()
}

/// Keeps how a run ended, behind what waits to be acknowledged: the first of several crashes is the cause, and what the others
/// may follow from. There are two places, so the latest takes that of the one before it.
#[inline(never)]
fn keep(record: Record) {
    let [first, latest] = &CRASHES;
    let record = Record { count: crash_count().saturating_add(1), ..record };
    match (first.waiting(), latest.waiting()) {
        (None, None) => first.write(record),
        (Some(_), _) => latest.write(record),
        (None, Some(earlier)) => {
            first.write(earlier);
            latest.write(record);
        }
    }
}

/// Crashes since power came on.
fn crash_count() -> u32 {
    CRASHES.iter().filter_map(Kept::read).fold(0, |most, record| most.max(record.count))
}

/// Keeps what tells no more than its kind. Where a crash that tells more waits, or one of this very kind, that stays and is
/// counted.
fn keep_plain(kind: Kind) {
    let stays = |earlier: &Record| {
        let waits = Kind::from_word(earlier.kind);
        waits == Some(kind) || !matches!(waits, Some(Kind::Watchdog | Kind::BrownOut))
    };
    let waiting = || CRASHES.iter().filter_map(|kept| Some((kept, kept.waiting()?)));
    match waiting().find(|(_, earlier)| stays(earlier)) {
        Some((kept, earlier)) => kept.write(Record { count: crash_count().saturating_add(1), ..earlier }),
        None => keep(Record::new(kind)),
    }
}

/// Ends the run because a peripheral refused its set-up, or to work on; `step` tells which.
pub(super) fn set_up_failed(step: u32) -> ! {
    stop_motors();
    end(Record { line: step, ..Record::new(Kind::SetUp) })
}

/// Ends the run because the chip's supply falls. From a handler of the highest priority: registers and the record only.
pub(super) fn brown_out() -> ! {
    stop_motors();
    keep_plain(Kind::BrownOut);
    SCB::sys_reset()
}

/// How runs ended that crashed, as far as nobody has acknowledged it: each in its place, the earlier first.
pub(super) fn kept() -> [Option<Crash>; CRASH_COUNT] {
    CRASHES.each_ref().map(|kept| {
        let record = kept.read()?;
        Some(Crash {
            kind: Kind::from_word(record.kind)?,
            pc: record.pc,
            lr: record.lr,
            cfsr: record.cfsr,
            hfsr: record.hfsr,
            address: record.address,
            line: record.line,
            file: record.file,
            count: record.count,
        })
    })
}

/// Keeps a reset that left no record of its own: its cause is told once, and another reset may come before it is read.
pub(super) fn note_reset(cause: ResetCause) {
    let kind = match cause {
        ResetCause::Watchdog | ResetCause::WindowWatchdog => Kind::Watchdog,
        ResetCause::BrownOut => Kind::BrownOut,
        _ => return,
    };
    keep_plain(kind);
}

/// A person has read of the crash in this place.
pub(super) fn forget(place: usize) {
    if let Some(kept) = CRASHES.get(place) {
        kept.forget();
    }
}

/// Keeps why the motors were stopped for good, or that a person has read of it. From the control tick: 5 µs.
#[inline(never)]
pub(super) fn keep_termination(reason: Option<AbortReason>) {
    match reason {
        // In the order of their numbers.
        Some(reason) => TERMINATION.write(Record { line: reason as u32, ..Record::new(Kind::Terminated) }),
        None => TERMINATION.forget(),
    }
}

/// Why an earlier run stopped the motors for good, if nobody has acknowledged it.
pub(super) fn kept_termination() -> Option<AbortReason> {
    let record = TERMINATION.read().filter(|record| record.kind == Kind::Terminated as u32)?;
    AbortReason::ALL.get(record.line as usize).copied()
}

/// Why the chip was reset, as the clock controller tells it (RM0090 section 7.3.21).
#[derive(Clone, Copy, PartialEq, Eq, defmt::Format)]
pub(super) enum ResetCause {
    PowerOn,
    BrownOut,
    /// The reset pin only.
    Pin,
    Software,
    Watchdog,
    WindowWatchdog,
    LowPower,
    Unknown,
}

/// Reads the cause of the last reset and clears it for the next. Most specific first: every reset also pulls the pin.
pub(super) fn take_reset_cause() -> ResetCause {
    let csr = pac::RCC.csr().read();
    pac::RCC.csr().modify(|w| w.set_rmvf(true));
    if csr.porrstf() {
        ResetCause::PowerOn
    } else if csr.borrstf() {
        ResetCause::BrownOut
    } else if csr.wdgrstf() {
        ResetCause::Watchdog
    } else if csr.wwdgrstf() {
        ResetCause::WindowWatchdog
    } else if csr.lpwrrstf() {
        ResetCause::LowPower
    } else if csr.sftrstf() {
        ResetCause::Software
    } else if csr.padrstf() {
        ResetCause::Pin
    } else {
        ResetCause::Unknown
    }
}

#[panic_handler]
fn panic(info: &PanicInfo<'_>) -> ! {
    stop_motors();
    let mut record = Record::new(Kind::Panic);
    if let Some(location) = info.location() {
        record.line = location.line();
        // The end of the path tells more than its beginning.
        let name = location.file().as_bytes();
        let tail = name.get(name.len().saturating_sub(FILE_BYTES)..).unwrap_or(name);
        for (kept, byte) in record.file.iter_mut().zip(tail) {
            *kept = *byte;
        }
    }
    end(record)
}

/// Entry of the hard fault.
///
/// A stack overflow arrives here with a stack pointer below RAM, where the first push of any compiled function would
/// lock the processor up. So the stack pointer is reset before any Rust code runs; the old one is handed on.
#[unsafe(naked)]
#[unsafe(no_mangle)]
#[unsafe(link_section = ".HardFault.entry")]
#[allow(non_snake_case)]
unsafe extern "C" fn HardFault() -> ! {
    core::arch::naked_asm!(
        "mrs r0, msp",
        "ldr r1, =_stack_start",
        "msr msp, r1",
        "ldr r2, ={stopped}",
        "bx r2",
        ".ltorg",
        stopped = sym hard_fault,
    )
}

unsafe extern "C" {
    static _stack_start: u32;
    static _stack_end: u32;
}

/// Second half of the hard fault, on a fresh stack. `frame` is where the processor stacked its registers.
extern "C" fn hard_fault(frame: u32) -> ! {
    stop_motors();
    // SAFETY: a peripheral that every Cortex-M has; nothing else runs any more.
    let scb = unsafe { &*SCB::PTR };
    let mut record = Record {
        cfsr: scb.cfsr.read(),
        hfsr: scb.hfsr.read(),
        address: scb.bfar.read(),
        ..Record::new(Kind::HardFault)
    };
    // The stacked registers are r0..r3, r12, lr, pc, xpsr; they are there unless the stack itself overflowed.
    let lowest = &raw const _stack_end as u32;
    let highest = &raw const _stack_start as u32;
    if frame >= lowest && frame.saturating_add(32) <= highest {
        let word = |offset: u32| {
            // SAFETY: inside the stack, as just checked, and aligned: the processor aligns its frames.
            unsafe { ptr::read_volatile((frame + offset) as *const u32) }
        };
        record.lr = word(20);
        record.pc = word(24);
    } else {
        record.kind = Kind::StackOverflow as u32;
    }
    end(record)
}

/// The clock monitor's interrupt: the crystal stopped and the chip runs on its internal oscillator.
#[exception]
unsafe fn NonMaskableInt() -> ! {
    stop_motors();
    end(Record::new(Kind::ClockLost))
}

/// Any interrupt that nobody handles; keeps its number.
#[exception]
unsafe fn DefaultHandler(number: i16) -> ! {
    stop_motors();
    end(Record { pc: u32::from(number.unsigned_abs()), ..Record::new(Kind::UnexpectedInterrupt) })
}

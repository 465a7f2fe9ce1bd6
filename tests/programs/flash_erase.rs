//! Erases a sector of flash that it has read before, and reads it again: without emptying the data cache, or (built with
//! `--cfg flush`) as the reference manual asks for (RM0090 section 3.5.2). No crate and no start-up code.
#![no_std]
#![no_main]

use core::ptr::{read_volatile, write_volatile};

const ACR: *mut u32 = 0x4002_3C00 as *mut u32;
const KEYR: *mut u32 = 0x4002_3C04 as *mut u32;
const SR: *mut u32 = 0x4002_3C0C as *mut u32;
const CR: *mut u32 = 0x4002_3C10 as *mut u32;
/// Sector 2.
const VICTIM: *const u32 = 0x0800_8000 as *const u32;
/// Where the test finds what was read: before and after the erase, and whether it is done.
const RESULT: *mut u32 = 0x2000_0000 as *mut u32;

#[used]
#[unsafe(link_section = ".vectors")]
static VECTORS: (u32, extern "C" fn() -> !) = (0x2001_0000, start);

#[unsafe(no_mangle)]
extern "C" fn start() -> ! {
    // SAFETY: registers of the flash interface and memory that nobody else uses.
    unsafe {
        // Both caches.
        write_volatile(ACR, 1 << 9 | 1 << 10);
        write_volatile(RESULT, read_volatile(VICTIM));
        write_volatile(KEYR, 0x4567_0123);
        write_volatile(KEYR, 0xCDEF_89AB);
        write_volatile(CR, 1 << 1 | 2 << 3 | 2 << 8);
        write_volatile(CR, 1 << 16 | 1 << 1 | 2 << 3 | 2 << 8);
        while read_volatile(SR) & 1 << 16 != 0 {}
        write_volatile(CR, 1 << 31);
        if cfg!(flush) {
            write_volatile(ACR, 0);
            write_volatile(ACR, 1 << 11 | 1 << 12);
            write_volatile(ACR, 1 << 9 | 1 << 10);
        }
        write_volatile(RESULT.add(1), read_volatile(VICTIM));
        write_volatile(RESULT.add(2), 1);
    }
    loop {}
}

#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    loop {}
}

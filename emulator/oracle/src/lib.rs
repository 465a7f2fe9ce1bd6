//! Start-up, semihosting and hashing for the test programs.
#![no_std]

use core::{arch::global_asm, fmt::Write};

// Reset: .data and .bss, FPU on; then `main`.
global_asm!(
    ".section .text.reset, \"ax\"",
    ".global reset",
    ".thumb_func",
    "reset:",
    "ldr r0, =0xE000ED88",
    "ldr r1, =0x00F00000",
    "str r1, [r0]",
    "dsb",
    "isb",
    "ldr r0, =__sdata",
    "ldr r1, =__edata",
    "ldr r2, =__sidata",
    "1: cmp r0, r1",
    "bhs 2f",
    "ldr r3, [r2], #4",
    "str r3, [r0], #4",
    "b 1b",
    "2: ldr r0, =__sbss",
    "ldr r1, =__ebss",
    "movs r2, #0",
    "3: cmp r0, r1",
    "bhs 4f",
    "str r2, [r0], #4",
    "b 3b",
    "4: bl main",
    "b .",
    ".ltorg",
);

/// Asks the host (semihosting).
pub fn host(operation: u32, argument: *const u32) -> u32 {
    let result;
    // SAFETY: the request only reads what `argument` points to.
    unsafe {
        core::arch::asm!("bkpt 0xAB", inout("r0") operation => result, in("r1") argument, options(nostack));
    }
    result
}

/// Ends the program.
pub fn exit(code: u32) -> ! {
    let block = [0x2_0026, code];
    host(0x20, block.as_ptr());
    loop {
        core::hint::spin_loop();
    }
}

/// Text to the host.
pub struct Host;

impl Write for Host {
    fn write_str(&mut self, text: &str) -> core::fmt::Result {
        for byte in text.bytes() {
            let cell = u32::from(byte);
            host(3, &cell);
        }
        Ok(())
    }
}

/// FNV-1a over words.
pub struct Hash(pub u32);

impl Default for Hash {
    fn default() -> Self {
        Self(0x811C_9DC5)
    }
}

impl Hash {
    /// Takes one word in.
    pub fn add(&mut self, word: u32) {
        self.0 = (self.0 ^ word).wrapping_mul(0x0100_0193).rotate_left(5);
    }

    /// Prints `name hash`.
    pub fn print(&self, name: &str) {
        let _ = writeln!(Host, "{name} {:08x}", self.0);
    }
}

#[panic_handler]
fn panic(info: &core::panic::PanicInfo<'_>) -> ! {
    let _ = writeln!(Host, "panic: {info}");
    exit(99)
}

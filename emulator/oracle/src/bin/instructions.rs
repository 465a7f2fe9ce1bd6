//! Every instruction form on many operands; one hash a group.
//!
//! A case is copied into a slot between code that loads all registers and flags and code that stores them.
#![no_std]
#![no_main]

use core::{
    arch::{asm, global_asm},
    ptr::{addr_of, addr_of_mut},
};
use oracle::{Hash, exit};

global_asm!(".section .vectors, \"a\"", ".word __stack", ".word reset", ".fill 14, 4, 0");
global_asm!(include_str!("../groups.s"), options(raw));

// State: r0..r12, lr, APSR, FPSCR, s0..s31. `run_case` takes it from and leaves it at `STATE`.
global_asm!(
    ".section .ramcode, \"awx\"",
    ".balign 8",
    ".global run_case",
    ".thumb_func",
    "run_case:",
    "push {{r4-r11, lr}}",
    "vpush {{s16-s31}}",
    "ldr.w r0, 9f",
    "ldr r1, [r0, #60]",
    "add r2, r0, #64",
    "vldmia r2, {{s0-s31}}",
    "vmsr fpscr, r1",
    "ldr r1, [r0, #56]",
    "msr apsr_nzcvqg, r1",
    "ldr lr, [r0, #52]",
    "ldm r0, {{r0-r12}}",
    "b.w slot",
    ".balign 4",
    "9: .word STATE",
    ".balign 8",
    ".global slot",
    "slot:",
    ".space 64",
    "push {{r0}}",
    "ldr.w r0, 8f",
    "str lr, [r0, #52]",
    "add.w r0, r0, #4",
    "stm r0, {{r1-r12}}",
    "pop {{r2}}",
    "str r2, [r0, #-4]",
    "mrs r1, apsr",
    "str r1, [r0, #52]",
    "vmrs r1, fpscr",
    "str r1, [r0, #56]",
    "add.w r0, r0, #60",
    "vstmia r0, {{s0-s31}}",
    "mov.w r1, #0",
    "vmsr fpscr, r1",
    "vpop {{s16-s31}}",
    "pop {{r4-r11, pc}}",
    ".balign 4",
    "8: .word STATE",
);

unsafe extern "C" {
    fn run_case();
    static mut slot: [u16; 32];
    static groups: [Group; 1000];
}

#[repr(C)]
struct Group {
    name: *const u8,
    length: usize,
    cases: *const u16,
}

#[unsafe(no_mangle)]
static mut STATE: [u32; 48] = [0; 48];
static mut BUFFER: [u32; 64] = [0; 64];

const INTEGERS: [u32; 16] = [
    0, 1, 2, 0x7FFF_FFFF, 0x8000_0000, 0x8000_0001, 0xFFFF_FFFF, 0xFFFF_FFFE, 0x7FFF, 0x8000, 0xFFFF, 0x7F80_FF80,
    0x8000_8000, 0x7FFF_7FFF, 0x0001_FFFF, 31,
];

const FLOATS: [u32; 40] = [
    0, 0x8000_0000, 1, 0x8000_0001, 0x007F_FFFF, 0x0080_0000, 0x8080_0000, 0x0080_0001, 0x00FF_FFFF, 0x3F80_0000,
    0xBF80_0000, 0x3F80_0001, 0x3F7F_FFFF, 0x7F7F_FFFF, 0xFF7F_FFFF, 0x7F80_0000, 0xFF80_0000, 0x7FC0_0000,
    0x7FC1_2345, 0xFFC0_0001, 0x7F80_0001, 0xFFA0_0000, 0x4F00_0000, 0x4EFF_FFFF, 0xCF00_0000, 0x4F80_0000,
    0x3F00_0000, 0xBF00_0000, 0x3FC0_0000, 0x4020_0000, 0x477F_E000, 0x477F_F000, 0x3880_0000, 0x3300_0000, 0x3300_0001,
    0x3200_0000, 0x7C00_FC00, 0x7E01_7C01, 0x03FF_0001, 0x1A80_0000,
];

struct Random(u32);

impl Random {
    fn next(&mut self) -> u32 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 17;
        self.0 ^= self.0 << 5;
        self.0.wrapping_mul(0x9E37_79B1)
    }

    fn integer(&mut self) -> u32 {
        let pick = self.next() >> 8;
        if pick & 16 == 0 { INTEGERS[(pick & 15) as usize] } else { self.next() }
    }

    fn float(&mut self) -> u32 {
        let (pick, raw) = (self.next() >> 8, self.next());
        match pick & 3 {
            0 => FLOATS[(pick >> 4) as usize % FLOATS.len()],
            // About one.
            1 => raw & 0x80FF_FFFF | 0x3F00_0000,
            // Near the ends of the range of halves and of integers.
            2 => raw & 0x87FF_FFFF | 0x3800_0000 + (pick & 0x300) << 18,
            _ => raw,
        }
    }
}

#[unsafe(no_mangle)]
extern "C" fn main() -> ! {
    let mut random = Random(0x1234_5678);
    let mut index = 0;
    loop {
        // SAFETY: the table ends with a null name; everything runs on one thread.
        unsafe {
            let group = &*(addr_of!(groups).cast::<Group>()).add(index);
            if group.name.is_null() {
                exit(0);
            }
            index += 1;
            let name = core::str::from_utf8_unchecked(core::slice::from_raw_parts(group.name, group.length));
            let mut hash = Hash::default();
            let float = name.starts_with('v');
            let mut case = group.cases;
            while *case != 0xFFFF {
                let length = usize::from(*case);
                for n in 0..32 {
                    let halfword = if n < length { *case.add(2 + n) } else { 0xBF00 };
                    addr_of_mut!(slot).cast::<u16>().add(n).write_volatile(halfword);
                }
                asm!("dsb", "isb");
                case = case.add((2 + length).next_multiple_of(2));
                for round in 0..if float { 96 } else { 40 } {
                    set_up(&mut random, float, round);
                    run_case();
                    for word in *addr_of!(STATE) {
                        hash.add(word);
                    }
                    if name.contains("store") || name.contains("memory") || matches!(name, "dual" | "multiple" | "exclusive") {
                        for word in *addr_of!(BUFFER) {
                            hash.add(word);
                        }
                    }
                }
            }
            hash.print(name);
        }
    }
}

unsafe fn set_up(random: &mut Random, float: bool, round: u32) {
    // SAFETY: one thread; nobody else holds these.
    unsafe {
        let (state, buffer) = (&mut *addr_of_mut!(STATE), &mut *addr_of_mut!(BUFFER));
        for register in &mut state[..14] {
            *register = random.integer();
        }
        state[7] = addr_of!(*buffer).addr() as u32 + 128;
        state[8] = random.next() >> 27;
        state[14] = random.next() & 0xF80F_0000;
        // Rounding modes, FZ, DN and AHP in every combination over the rounds; flags clear, or all but Inexact clear.
        let modes = (round & 31) << 22;
        state[15] = if float { modes | (round >> 5 & 1) << 4 | random.next() & 0xF000_0000 } else { 0 };
        if round >= 64 {
            state[15] = 0x10;
        }
        for register in &mut state[16..] {
            *register = random.float();
        }
        for word in buffer {
            *word = random.next();
        }
    }
}

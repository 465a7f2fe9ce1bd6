//! Exceptions: every scenario logs what its handlers see; one hash a scenario.
#![no_std]
#![no_main]
#![allow(static_mut_refs, reason = "one thread; handlers and thread share these on purpose")]

use core::arch::{asm, global_asm};
use oracle::{Hash, exit};

global_asm!(
    ".section .vectors, \"a\"",
    ".global vectors",
    "vectors:",
    ".word __stack",
    ".word reset",
    ".rept 46",
    ".word generic",
    ".endr",
    ".section .text.generic, \"ax\"",
    ".thumb_func",
    "generic:",
    "mov r0, sp",
    "tst lr, #4",
    "it ne",
    "mrsne r0, psp",
    "mov r1, lr",
    "push {{r4, lr}}",
    "bl handle",
    "pop {{r4, lr}}",
    "bx r0",
    // A second handler, for a table elsewhere: notes that it ran, no more.
    ".thumb_func",
    ".global other",
    "other:",
    "ldr r0, =OTHER",
    "ldr r1, [r0]",
    "adds r1, #1",
    "str r1, [r0]",
    "bx lr",
    ".ltorg",
);

unsafe extern "C" {
    static vectors: [u32; 48];
    fn other();
}

/// What a handler does besides logging.
type Action = fn(&mut [u32]);

#[unsafe(no_mangle)]
static mut OTHER: u32 = 0;
static mut LOG: Hash = Hash(0);
static mut ACTIONS: [Option<Action>; 48] = [None; 48];
static mut RETURN: u32 = 0;
#[repr(align(256))]
struct Table([u32; 48]);
static mut TABLE: Table = Table([0; 48]);

fn log(word: u32) {
    unsafe { LOG.add(word) }
}

fn read(address: u32) -> u32 {
    unsafe { (address as *const u32).read_volatile() }
}

fn write(address: u32, value: u32) {
    unsafe {
        (address as *mut u32).write_volatile(value);
        asm!("dsb", "isb");
    }
}

const ICSR: u32 = 0xE000_ED04;
const AIRCR: u32 = 0xE000_ED0C;
const CCR: u32 = 0xE000_ED14;
const SHCSR: u32 = 0xE000_ED24;
const CFSR: u32 = 0xE000_ED28;
const HFSR: u32 = 0xE000_ED2C;
const BFAR: u32 = 0xE000_ED38;
const CPACR: u32 = 0xE000_ED88;
const FPCCR: u32 = 0xE000_EF34;

#[unsafe(no_mangle)]
unsafe extern "C" fn handle(frame: *mut u32, link: u32) -> u32 {
    let number = read(ICSR) & 0x1FF;
    log(0x1000_0000 | number);
    log(link);
    log(frame.addr() as u32);
    // Bits of EPSR and APSR as stacked, and where to.
    let words = unsafe { core::slice::from_raw_parts_mut(frame, 8) };
    log(words[6]);
    log(words[7]);
    log(read(ICSR) & 0x0000_0800);
    log(read(SHCSR));
    if (3..=6).contains(&number) {
        let (cfsr, hfsr) = (read(CFSR), read(HFSR));
        log(cfsr);
        log(hfsr);
        if cfsr & 0x8000 != 0 {
            log(read(BFAR));
        }
        write(CFSR, cfsr);
        write(HFSR, hfsr);
    }
    if let Some(action) = unsafe { ACTIONS[number as usize] } {
        action(words);
    }
    log(0x2000_0000 | number);
    // An action may ask for another way back; handlers nested in it do not.
    match unsafe { core::ptr::replace(&raw mut RETURN, 0) } {
        0 => link,
        other => other,
    }
}

/// Goes on after the instruction that faulted.
fn skip(frame: &mut [u32]) {
    let first = unsafe { (frame[6] as *const u16).read_volatile() };
    frame[6] += if first >= 0xE800 { 4 } else { 2 };
    // The next condition of an IT block is not ours to keep.
    frame[7] &= !0x0600_FC00;
}

/// Goes on where the call came from.
fn return_to_caller(frame: &mut [u32]) {
    frame[6] = frame[5] & !1;
    frame[7] |= 1 << 24;
}

fn on(exception: usize, action: Action) {
    unsafe { ACTIONS[exception] = Some(action) };
}

fn pend(irq: u32) {
    write(0xE000_E200, 1 << irq);
}

fn priority(exception: u32, level: u8) {
    let address = if exception >= 16 { 0xE000_E400 + exception - 16 } else { 0xE000_ED14 + exception };
    unsafe {
        (address as *mut u8).write_volatile(level);
        asm!("dsb", "isb");
    }
}

fn mask(set: bool) {
    unsafe {
        if set {
            asm!("cpsid i");
        } else {
            asm!("cpsie i", "isb");
        }
    }
}

fn basepri(level: u32) {
    unsafe { asm!("msr basepri, {}", "isb", in(reg) level) };
}

fn scenario(name: &str, body: fn()) {
    unsafe {
        LOG = Hash::default();
        ACTIONS = [None; 48];
    }
    for exception in (4..7).chain([11, 12, 14, 15]).chain(16..48) {
        priority(exception, 0x80);
    }
    write(0xE000_E100, u32::MAX);
    write(SHCSR, 0x7_0000);
    write(CCR, 0x200);
    write(AIRCR, 0x05FA_0000);
    write(CPACR, 0x00F0_0000);
    body();
    write(0xE000_E280, u32::MAX);
    unsafe {
        asm!("mrs {0}, control", "bic {0}, #4", "msr control, {0}", "isb", out(reg) _);
        LOG.print(name);
    }
}

fn nesting() {
    priority(16, 0x80);
    priority(17, 0x40);
    priority(18, 0x80);
    priority(19, 0x20);
    on(16, |_| {
        pend(1);
        log(1);
        pend(2);
        log(2);
    });
    on(17, |_| {
        pend(2);
        pend(3);
        log(3);
    });
    pend(0);
    log(4);
}

fn order() {
    for (irq, level) in [(0, 0x80), (1, 0x40), (2, 0x40), (3, 0xC0), (4, 0x20), (5, 0x80), (6, 0xF0), (7, 0)] {
        priority(16 + irq, level);
    }
    mask(true);
    write(0xE000_E200, 0xFF);
    write(ICSR, 1 << 28 | 1 << 26);
    log(read(ICSR) & 0x005F_F800);
    log(read(0xE000_E200));
    mask(false);
    log(read(0xE000_E200));
}

fn basepri_levels() {
    for n in 0..8 {
        priority(16 + n, (n as u8) << 5);
    }
    for level in [0x80, 0x20, 0x60, 0x10, 0xF0] {
        basepri(level);
        write(0xE000_E200, 0xFF);
        log(read(0xE000_E200));
        basepri(0);
        log(read(0xE000_E200));
    }
}

fn groups() {
    for group in 0..8 {
        write(AIRCR, 0x05FA_0000 | group << 8);
        log(read(AIRCR) & 0x700);
        priority(16, 0xF0);
        priority(17, 0xE0);
        priority(18, 0x70);
        priority(19, 0x30);
        on(16, |_| {
            pend(1);
            pend(2);
        });
        on(18, |_| pend(3));
        pend(0);
        basepri(0x70);
        write(0xE000_E200, 15);
        basepri(0);
    }
}

fn faultmask() {
    unsafe { asm!("cpsid f") };
    pend(0);
    write(ICSR, 1 << 31);
    log(5);
    let value: u32;
    unsafe { asm!("mrs {}, faultmask", out(reg) value) };
    log(value);
    unsafe { asm!("cpsie f", "isb") };
    // A handler that sets FAULTMASK loses it on return.
    on(16, |_| unsafe { asm!("cpsid f") });
    pend(0);
    let value: u32;
    unsafe { asm!("mrs {}, faultmask", out(reg) value) };
    log(value);
}

fn system_calls() {
    priority(11, 0x60);
    priority(14, 0xF0);
    priority(15, 0x40);
    on(11, |_| {
        write(ICSR, 1 << 28);
        write(ICSR, 1 << 26);
        log(6);
    });
    on(16, |_| unsafe { asm!("svc 3") });
    unsafe { asm!("svc 1") };
    pend(0);
    // In an IT block, with flags that show in the frame.
    unsafe { asm!("movs r0, #0", "itte eq", "svceq 7", "moveq r0, #1", "movne r0, #2", out("r0") _) };
    // SVC that cannot preempt: HardFault.
    mask(true);
    unsafe { asm!("svc 2") };
    mask(false);
}

fn systick() {
    on(15, |_| write(0xE000_E010, 0));
    write(0xE000_E014, 5000);
    write(0xE000_E018, 0);
    write(0xE000_E010, 7);
    unsafe { asm!("wfi") };
    log(read(0xE000_E014));
    // The flag clears by reading.
    write(0xE000_E010, 5);
    while read(0xE000_E010) & 0x1_0000 == 0 {}
    write(0xE000_E010, 0);
    log(read(0xE000_E010));
    log(u32::from(read(0xE000_E018) <= 5000));
}

fn faulting_instructions() {
    unsafe {
        asm!("udf #0");
        asm!("udf.w #0");
        asm!("sdiv r0, r0, r1", in("r1") 0, inout("r0") 5_u32 => _);
        asm!("adr r0, 1f", "adds r0, #2", "ldm r0, {{r1, r2}}", "b 2f", ".balign 4", "1: .word 1, 2, 3", "2:",
            out("r0") _, out("r1") _, out("r2") _);
        asm!("ldrd r2, r3, [sp, #-4]", "sub r0, sp, #6", "ldrd r2, r3, [r0]", "ldrex r2, [r0]", "ldr r2, [r0]",
            out("r0") _, out("r2") _, out("r3") _);
    }
    write(CCR, 0x218);
    unsafe {
        asm!("sdiv r0, r0, r1", in("r1") 0, inout("r0") 5_u32 => _);
        asm!("udiv r0, r0, r1", in("r1") 0, inout("r0") 5_u32 => _);
        asm!("sub r0, sp, #6", "ldr r2, [r0]", "ldrh r2, [r0, #1]", "str r2, [r0]", out("r0") _, out("r2") _);
        asm!("ldr r0, [r1]", in("r1") 0x9000_0000_u32, out("r0") _);
        asm!("str r0, [r1]", in("r1") 0x9000_0010_u32, out("r0") _);
        asm!("ldr r0, [r1], #4", inout("r1") 0x9000_0000_u32 => _, out("r0") _);
        asm!("ittt al", "ldral r0, [r1]", "moval r0, #1", "moval r0, #2", in("r1") 0x9000_0000_u32, out("r0") _);
    }
    write(CPACR, 0);
    unsafe { asm!("vmov r0, s0", "vadd.f32 s0, s0, s0", out("r0") _) };
    write(CPACR, 0x00F0_0000);
    unsafe { asm!("cdp p0, #1, c2, c3, c4, #0", "mcr p5, #1, r0, c1, c2, #3") };
}

fn faults() {
    for exception in [3, 4, 5, 6] {
        on(exception, skip);
    }
    faulting_instructions();
    // All of them as HardFault.
    write(SHCSR, 0);
    faulting_instructions();
    // Enabled, but at no higher priority than the handler they occur in.
    write(SHCSR, 0x7_0000);
    on(16, |_| faulting_instructions());
    pend(0);
    // At a higher one.
    for exception in [4, 5, 6] {
        priority(exception, 0x40);
    }
    pend(0);
}

fn strange_targets() {
    for exception in [3, 4, 5, 6] {
        on(exception, return_to_caller);
    }
    for enabled in [0x7_0000, 0] {
        write(SHCSR, enabled);
        unsafe {
            asm!("blx r0", in("r0") 0x2000_0000_u32, out("lr") _);
            asm!("blx r0", in("r0") 0xE000_0001_u32, out("lr") _);
            asm!("blx r0", in("r0") 0x4000_0001_u32, out("lr") _);
        }
    }
}

fn floats() {
    for mode in [0xC000_0000, 0x8000_0000, 0] {
        write(FPCCR, mode);
        on(16, |_| log(read(FPCCR) & 1));
        on(17, |_| unsafe {
            asm!("vmov s0, {0}", "vmov s15, {0}", "vmov s16, {0}", "vmsr fpscr, {1}", in(reg) 0x1234_5678, in(reg) 0x0080_0000,
                out("s0") _, out("s15") _);
            log(read(FPCCR) & 1);
            pend(2);
        });
        on(18, |_| unsafe {
            asm!("vmov s3, {0}", in(reg) 0x8765_4321_u32, out("s3") _);
            log(read(FPCCR) & 1);
        });
        priority(18, 0x20);
        for _ in 0..2 {
            for irq in 0..3 {
                pend(irq);
                let (first, last, status, control): (u32, u32, u32, u32);
                unsafe {
                    asm!("mrs {0}, control", out(reg) control);
                    asm!("vmov s0, {4}", "vmov s15, {5}", "vmsr fpscr, {6}", "str {3}, [{7}]", "dsb", "isb",
                        "vmov {0}, s0", "vmov {1}, s15", "vmrs {2}, fpscr", out(reg) first, out(reg) last,
                        out(reg) status, in(reg) 1_u32 << irq, in(reg) 0x1111, in(reg) 0x2222, in(reg) 0x8000_0010_u32,
                        in(reg) 0xE000_E200_u32, out("s0") _, out("s15") _);
                }
                for word in [first, last, status & 0xF7C0_009F, control] {
                    log(word);
                }
            }
        }
        unsafe { asm!("mrs {0}, control", "bic {0}, #4", "msr control, {0}", "isb", out(reg) _) };
    }
    write(FPCCR, 0xC000_0000);
}

fn alignment() {
    for ccr in [0x200, 0] {
        write(CCR, ccr);
        unsafe {
            asm!("svc 0", "sub sp, #4", "svc 0", "sub sp, #8", "svc 0", "add sp, #12");
            // With floating-point state a frame is aligned whatever STKALIGN says (B1.5.7); QEMU 7.2 does not.
            if ccr != 0 {
                asm!("vmov.f32 s0, #1.0", "sub sp, #4", "svc 0", "add sp, #4", out("s0") _);
            }
            asm!("mrs {0}, control", "bic {0}, #4", "msr control, {0}", "isb", out(reg) _);
        }
    }
}

fn unprivileged() {
    for exception in [3, 5, 6] {
        on(exception, skip);
    }
    on(11, |frame| {
        log(frame[0]);
        unsafe { asm!("mrs {0}, control", "bic {0}, #1", "msr control, {0}", out(reg) _) };
    });
    let (value, control): (u32, u32);
    unsafe {
        asm!("ldr r0, =__process_stack", "msr psp, r0", "movs r0, #2", "msr control, r0", "isb", "push {{r0, r1}}",
            "movs r0, #3", "msr control, r0", "isb",
            // Neither system registers nor masks are ours now.
            "ldr r1, =0xE000ED08", "ldr r2, [r1]", "cpsid i", "cpsid f", "movs r3, #0x40", "msr basepri, r3",
            "msr msp, r3", "mrs r3, primask", "mrs r2, control", "mov r0, r2", "svc 1",
            "pop {{r0, r1}}", "mrs r3, control", "movs r0, #0", "msr control, r0", "isb", "mrs r1, psp",
            out("r0") _, out("r1") value, out("r2") _, out("r3") control);
    }
    log(value);
    log(control);
}

fn exclusive() {
    let mut cell = 5_u32;
    for interrupted in [false, true] {
        let status: u32;
        unsafe {
            if interrupted {
                asm!("ldrex {0}, [{1}]", "svc 0", "strex {0}, {2}, [{1}]", out(reg) status, in(reg) &mut cell, in(reg) 9);
            } else {
                asm!("ldrex {0}, [{1}]", "strex {0}, {2}, [{1}]", out(reg) status, in(reg) &mut cell, in(reg) 7);
            }
        }
        log(status);
        log(cell);
    }
}

fn bad_returns() {
    on(6, |frame| {
        unsafe { RETURN = 0xFFFF_FFF9 };
        log(frame[0]);
    });
    on(3, |_| unsafe { RETURN = 0xFFFF_FFF9 });
    for enabled in [0x7_0000, 0] {
        write(SHCSR, enabled);
        on(16, |_| unsafe { RETURN = 0xFFFF_FFF1 });
        pend(0);
        on(16, |_| unsafe { RETURN = 0xFFFF_FFF3 });
        pend(0);
    }
}

fn sleeping() {
    mask(true);
    pend(0);
    unsafe { asm!("wfi") };
    log(read(0xE000_E200));
    mask(false);
    unsafe { asm!("sev", "wfe") };
    log(7);
    // An exception is an event.
    pend(1);
    unsafe { asm!("wfe") };
    log(8);
}

fn registers() {
    for offset in [0xE100_u32, 0xE180, 0xE200, 0xE280, 0xE300] {
        log(read(0xE000_0000 + offset));
    }
    write(0xE000_E180, 0x0F0F_0F0F);
    log(read(0xE000_E100));
    mask(true);
    write(0xE000_E200, 0x0000_FFFF);
    log(read(0xE000_E280));
    write(0xE000_E280, 0x0000_F0F0);
    log(read(0xE000_E200));
    mask(false);
    write(0xE000_E410, 0x1234_5678);
    log(read(0xE000_E410) & 0xF0F0_F0F0);
    priority(33, 0xAB);
    log(read(0xE000_E410) & 0xF0F0_F0F0);
    for offset in [0xED18_u32, 0xED1C, 0xED20] {
        write(0xE000_0000 + offset, 0x1020_3040);
        log(read(0xE000_0000 + offset) & 0xF0F0_F0F0);
    }
    write(0xE000_EF00, 3);
    log(read(0xE000_EF44));
    write(AIRCR, 0x1234_0700);
    log(read(AIRCR));
    write(0xE000_E100, u32::MAX);
    log(9);
}

fn vector_table() {
    unsafe {
        TABLE.0 = vectors;
        TABLE.0[20] = other as *const () as u32;
        write(0xE000_ED08, (&raw const TABLE).addr() as u32);
        pend(4);
        pend(5);
        write(0xE000_ED08, 0);
        pend(4);
        log(OTHER);
    }
}

#[unsafe(no_mangle)]
extern "C" fn main() -> ! {
    scenario("nesting", nesting);
    scenario("order", order);
    scenario("basepri", basepri_levels);
    scenario("groups", groups);
    scenario("faultmask", faultmask);
    scenario("system_calls", system_calls);
    scenario("systick", systick);
    scenario("faults", faults);
    scenario("strange_targets", strange_targets);
    scenario("floats", floats);
    scenario("alignment", alignment);
    scenario("unprivileged", unprivileged);
    scenario("exclusive", exclusive);
    scenario("bad_returns", bad_returns);
    scenario("sleeping", sleeping);
    scenario("registers", registers);
    scenario("vector_table", vector_table);
    exit(0)
}

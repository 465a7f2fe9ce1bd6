//! What QEMU cannot answer for: timing, caches, sleep, lock-up, determinism. Programs stand as machine code with
//! their assembly above.
use emulator::{
    Machine, NoPeripherals, Stop,
    bus::{Access, AccessError, Cycle, NEVER, Peripherals},
    core::{Fault, Timing},
    memory::Memory,
};

// udf #0
const UDF: &[u16] = &[0xDE00];
// 1: wfi; b 1b
const SLEEP: &[u16] = &[0xBF30, 0xE7FD];
// ldr r0, =0x08001000; ldr r1, [r0]; ldr r2, =0x40000000; movs r3, #1; str r3, [r2]; ldr r4, [r0]; movs r3,
// #2; str r3, [r2]; ldr r5, [r0]; bkpt #1
const STALE_READ: &[u16] = &[
    0x4805, 0x6801, 0xF04F, 0x4280, 0x2301, 0x6013, 0x6804, 0x2302, 0x6013, 0x6805, 0xBE01, 0x0000, 0x1000,
    0x0800,
];
// ldr r0, =0x08001001; ldr r2, =0x40000000; blx r0; movs r3, #1; str r3, [r2]; blx r0; bkpt #1
const STALE_FETCH: &[u16] = &[0x4803, 0xF04F, 0x4280, 0x4780, 0x2301, 0x6013, 0x4780, 0xBE01, 0x1001, 0x0800];
// ldr r2, =0x40000000; movs r3, #3; str r3, [r2]; nop; bkpt #1
const STALL: &[u16] = &[0xF04F, 0x4280, 0x2303, 0x6013, 0xBF00, 0xBE01];
// ldr r0, =0xE000E100; movs r1, #1; str r1, [r0]; ldr r2, =0x40000000; movs r3, #4; str r3, [r2]; nop; bkpt
// #1
const LEVEL: &[u16] =
    &[0x4804, 0x2101, 0x6001, 0xF04F, 0x4280, 0x2304, 0x6013, 0xBF00, 0xBE01, 0x0000, 0xE100, 0xE000];
// adds r7, #1; cmp r7, #3; bne 1f; ldr r2, =0x40000000; movs r3, #5; str r3, [r2]; 1: bx lr
const LEVEL_HANDLER: &[u16] = &[0x3701, 0x2F03, 0xD103, 0xF04F, 0x4280, 0x2305, 0x6013, 0x4770];
// ldr r0, =0x20000100; movs r1, #0; str r1, [r0]; ldr r2, =0x22002014; movs r3, #1; str r3, [r2]; ldr r4,
// [r0]; ldr r5, [r2]; bkpt #1
const BIT_BAND: &[u16] = &[
    0x4804, 0x2100, 0x6001, 0x4A04, 0x2301, 0x6013, 0x6804, 0x6815, 0xBE01, 0x0000, 0x0100, 0x2000, 0x2014,
    0x2200,
];
// ldr r0, =0xE000ED24; ldr r1, =0x70000; str r1, [r0]; ldr r0, =0x90000000; msr psp, r0; movs r0, #2; msr
// control, r0; isb; svc 0; bkpt #1
const STACKING: &[u16] = &[
    0x4807, 0xF44F, 0x21E0, 0x6001, 0xF04F, 0x4010, 0xF380, 0x8809, 0x2002, 0xF380, 0x8814, 0xF3BF, 0x8F6F,
    0xDF00, 0xBE01, 0x0000, 0xED24, 0xE000,
];
// ldr r0, =0xE000ED0C; ldr r1, =0x05FA0004; str r1, [r0]; b .
const RESET: &[u16] = &[0x4801, 0x4902, 0x6001, 0xE7FE, 0xED0C, 0xE000, 0x0004, 0x05FA];
// ldr r0, =0xE000EDFC; ldr r1, =0x01000000; str r1, [r0]; ldr r0, =0xE0001000; ldr r1, [r0]; adds r1, #1;
// str r1, [r0]; ldr r2, [r0, #4]; nop; nop; nop; nop; ldr r3, [r0, #4]; bkpt #1
const CYCCNT: &[u16] = &[
    0x4807, 0xF04F, 0x7180, 0x6001, 0x4806, 0x6801, 0x3101, 0x6001, 0x6842, 0xBF00, 0xBF00, 0xBF00, 0xBF00,
    0x6843, 0xBE01, 0x0000, 0xEDFC, 0xE000, 0x1000, 0xE000,
];
// ldr r0, =0xE000E010; ldr r1, =999999; str r1, [r0, #4]; movs r1, #0; str r1, [r0, #8]; movs r1, #7; str
// r1, [r0]; wfe; wfe; bkpt #1
const SYSTICK_WFE: &[u16] = &[
    0x4804, 0x4905, 0x6041, 0x2100, 0x6081, 0x2107, 0x6001, 0xBF20, 0xBF20, 0xBE01, 0xE010, 0xE000, 0x423F,
    0x000F,
];
// adds r7, #1; bx lr
const COUNT: &[u16] = &[0x3701, 0x4770];

const MIX: &[u8] = include_bytes!("../oracle/elf/mix.elf");

/// Does what the value written to 0x4000_0000 says.
#[derive(Default)]
struct Stub {
    lines: u128,
    reset: bool,
    resets: u32,
}

impl Peripherals for Stub {
    fn read(&mut self, _: &mut Memory, access: Access) -> Result<u32, AccessError> {
        Err(AccessError::NotEmulated(access.address, "nothing"))
    }

    fn write(&mut self, memory: &mut Memory, access: Access, value: u32) -> Result<(), AccessError> {
        match (access.address, value) {
            (0x4000_0000, 1) => memory.program_flash(0x1000, &[0, 0x20]),
            (0x4000_0000, 2) => {
                memory.flash_interface.flush_data_cache();
                memory.flash_interface.flush_instruction_cache();
            }
            (0x4000_0000, 3) => memory.flash_interface.busy_until = access.at + 100_000,
            (0x4000_0000, 4) => self.lines = 1,
            (0x4000_0000, 5) => self.lines = 0,
            _ => return Err(AccessError::Nothing(access.address)),
        }
        Ok(())
    }

    fn next_event(&self) -> Cycle {
        NEVER
    }

    fn advance(&mut self, _: &mut Memory, _: Cycle) {}

    fn interrupt_lines(&self) -> u128 {
        self.lines
    }

    fn take_reset(&mut self) -> bool {
        std::mem::take(&mut self.reset)
    }

    fn reset(&mut self, _: &mut Memory, _: Cycle) {
        self.resets += 1;
    }

    fn request_reset(&mut self) {
        self.reset = true;
    }
}

/// A machine that starts with `code`; `handlers` by exception number.
fn machine(timing: Timing, code: &[u16], handlers: &[(usize, &[u16])]) -> Machine<Stub> {
    let mut image = vec![0_u8; 0x100];
    image[..4].copy_from_slice(&0x2000_8000_u32.to_le_bytes());
    let mut append = |vector: usize, code: &[u16]| {
        image.resize(image.len().next_multiple_of(4), 0);
        let entry = (0x0800_0000 + image.len() as u32) | 1;
        image[4 * vector..4 * vector + 4].copy_from_slice(&entry.to_le_bytes());
        image.extend(code.iter().flat_map(|halfword| halfword.to_le_bytes()));
    };
    append(1, code);
    for (vector, code) in handlers {
        append(*vector, code);
    }
    let mut machine = Machine::new(Stub::default(), timing, 1);
    machine.stop_at_breakpoints = true;
    machine.stop_at_lockups = true;
    machine.memory.flash_interface.instruction_cache = true;
    machine.memory.flash_interface.data_cache = true;
    machine.load_binary(0x0800_0000, &image).expect("it fits");
    machine
}

fn run_to_breakpoint(machine: &mut Machine<Stub>) {
    let stop = machine.run_until(100_000_000);
    assert!(matches!(stop, Stop::Breakpoint { code: 1, .. }), "{stop}");
}

#[test]
fn a_fault_in_hard_fault_locks_up() {
    let stop = machine(Timing::Optimistic, UDF, &[(3, UDF)]).run_until(1000);
    let Stop::Lockup { pc, fault, cfsr, hfsr, .. } = stop else { panic!("{stop}") };
    assert_eq!((pc, fault), (0x0800_0104, Fault::Undefined));
    assert_eq!((cfsr, hfsr), (1 << 16, 1 << 30));
}

#[test]
fn an_empty_vector_table_locks_up() {
    let mut machine = Machine::new(NoPeripherals::default(), Timing::Optimistic, 1);
    machine.stop_at_lockups = true;
    let stop = machine.run_until(1000);
    assert!(matches!(stop, Stop::Lockup { .. }), "{stop}");
}

#[test]
fn sleep_costs_nothing() {
    let mut machine = machine(Timing::Optimistic, SLEEP, &[]);
    let year = 168_000_000 * 86_400 * 365;
    assert_eq!(machine.run_until(year), Stop::ReachedTime);
    assert_eq!(machine.time(), year);
    assert!(machine.core.counters.instructions < 3);
    assert!(machine.core.clocked() < 10);
}

#[test]
fn systick_ends_sleep_to_the_cycle() {
    let mut machine = machine(Timing::Optimistic, SYSTICK_WFE, &[(15, COUNT)]);
    // The first WFE waits for SysTick, whose entry and return are events for the second.
    run_to_breakpoint(&mut machine);
    assert_eq!(machine.core.register(7), 1);
    assert!((1_000_000..1_000_100).contains(&machine.time()), "{}", machine.time());
    assert!(machine.core.clocked() < 100);
}

#[test]
fn a_cached_line_of_changed_flash_reads_as_before() {
    let mut machine = machine(Timing::Optimistic, STALE_READ, &[]);
    machine.memory.place(0x0800_1000, &0x1234_5678_u32.to_le_bytes());
    run_to_breakpoint(&mut machine);
    assert_eq!(machine.core.register(1), 0x1234_5678);
    assert_eq!(machine.core.register(4), 0x1234_5678);
    assert_eq!(machine.core.register(5), 0x1234_0000);
    assert_eq!(machine.memory.bugs.len(), 1);
    assert!(machine.memory.bugs[0].what.contains("DCRST"), "{:?}", machine.memory.bugs);
}

#[test]
fn without_the_data_cache_nothing_is_stale() {
    let mut machine = machine(Timing::Optimistic, STALE_READ, &[]);
    machine.memory.flash_interface.data_cache = false;
    machine.memory.place(0x0800_1000, &0x1234_5678_u32.to_le_bytes());
    run_to_breakpoint(&mut machine);
    assert_eq!(machine.core.register(4), 0x1234_0000);
    assert!(machine.memory.bugs.is_empty());
}

#[test]
fn instructions_that_change_after_they_ran_are_reported() {
    for timing in [Timing::Optimistic, Timing::Pessimistic] {
        let mut machine = machine(timing, STALE_FETCH, &[]);
        // movs r0, #255 / bx lr; programming makes it movs r0, #0.
        machine.memory.place(0x0800_1000, &[0xFF, 0x21, 0x70, 0x47]);
        run_to_breakpoint(&mut machine);
        assert_eq!(machine.core.register(1), 0xFF);
        assert_eq!(machine.core.register(0) & 0xFF, 0);
        assert_eq!(machine.memory.bugs.len(), 1, "{:?}", machine.memory.bugs);
        assert!(machine.memory.bugs[0].what.contains("ICRST"));
    }
}

#[test]
fn busy_flash_stalls_the_core() {
    let mut machine = machine(Timing::Optimistic, STALL, &[]);
    run_to_breakpoint(&mut machine);
    assert!((100_000..100_020).contains(&machine.time()), "{}", machine.time());
}

#[test]
fn a_line_still_high_on_return_pends_again() {
    let mut machine = machine(Timing::Optimistic, LEVEL, &[(16, LEVEL_HANDLER)]);
    run_to_breakpoint(&mut machine);
    assert_eq!(machine.core.register(7), 3);
    assert_eq!(machine.core.counters.exceptions, 3);
}

#[test]
fn bits_have_addresses() {
    let mut machine = machine(Timing::Optimistic, BIT_BAND, &[]);
    run_to_breakpoint(&mut machine);
    // 0x2200_2014 is bit 5 of 0x2000_0100.
    assert_eq!((machine.core.register(4), machine.core.register(5)), (1 << 5, 1));
}

#[test]
fn a_stack_outside_memory_is_a_bus_fault_of_stacking() {
    let mut machine = machine(Timing::Optimistic, STACKING, &[(5, &[0xBE01]), (11, COUNT)]);
    run_to_breakpoint(&mut machine);
    assert_eq!(machine.core.exception_number(), 5);
}

#[test]
fn a_reset_asked_for_happens() {
    let mut machine = machine(Timing::Optimistic, RESET, &[]);
    assert_eq!(machine.run_until(1000), Stop::ReachedTime);
    assert!(machine.peripherals.resets > 10);
}

#[test]
fn cycles_are_counted() {
    let mut machine = machine(Timing::Optimistic, CYCCNT, &[]);
    run_to_breakpoint(&mut machine);
    // Four NOPs between two loads.
    assert_eq!(machine.core.register(3) - machine.core.register(2), 6);
}

/// Cycles and instructions of the compiled mix.
fn mix(timing: Timing, latency: u8, caches: bool, prefetch: bool) -> (u64, u64) {
    let mut machine = Machine::new(NoPeripherals::default(), timing, 1);
    machine.memory.flash_interface.latency = latency;
    machine.memory.flash_interface.instruction_cache = caches;
    machine.memory.flash_interface.data_cache = caches;
    machine.memory.flash_interface.prefetch = prefetch;
    machine.load_elf(MIX).expect("it loads");
    assert_eq!(machine.run_until(2_000_000_000), Stop::Exit(0));
    (machine.time(), machine.core.counters.instructions)
}

#[test]
fn pessimism_costs() {
    let optimistic = mix(Timing::Optimistic, 5, true, true);
    let cached = mix(Timing::Pessimistic, 5, true, true);
    let prefetched = mix(Timing::Pessimistic, 5, false, true);
    let bare = mix(Timing::Pessimistic, 5, false, false);
    assert_eq!(optimistic.1, bare.1);
    assert!(optimistic.0 < cached.0 && cached.0 < prefetched.0 && prefetched.0 < bare.0);
    // Wait states count in the pessimistic figure alone.
    assert_eq!(optimistic.0, mix(Timing::Optimistic, 0, false, false).0);
    assert!(mix(Timing::Pessimistic, 0, false, false).0 < bare.0);
    // About one and a half cycles an instruction, as compiled code has on this core.
    let per_instruction = optimistic.0 as f64 / optimistic.1 as f64;
    assert!((1.0..2.0).contains(&per_instruction), "{per_instruction}");
}

#[test]
fn the_same_seed_gives_the_same_bytes() {
    let run = |seed, slice: u64| {
        let mut machine = Machine::new(NoPeripherals::default(), Timing::Pessimistic, seed);
        machine.memory.flash_interface.latency = 5;
        machine.load_elf(MIX).expect("it loads");
        while machine.run_until(machine.time() + slice) == Stop::ReachedTime {}
        let registers: Vec<u32> = (0..16).map(|n| machine.core.register(n)).collect();
        (registers, machine.time(), machine.core.counters, machine.memory.sram, machine.memory.ccm)
    };
    let whole = run(3, u64::MAX / 2);
    assert!(whole == run(3, u64::MAX / 2));
    // However often one looks.
    assert!(whole == run(3, 777));
    assert!(whole.3 != run(4, u64::MAX / 2).3);
}

#[test]
fn images_that_fit_nowhere_are_refused() {
    let mut machine = Machine::new(NoPeripherals::default(), Timing::Optimistic, 1);
    assert!(machine.load_binary(0x0810_0000 - 2, &[0; 4]).is_err());
    assert!(machine.load_elf(b"not an ELF").is_err());
}

#[test]
fn noise_as_code_never_panics() {
    let mut machine = machine(Timing::Pessimistic, UDF, &[]);
    machine.stop_at_breakpoints = false;
    let mut state = 1_u64;
    for _ in 0..200 {
        let mut image: Vec<u8> = (0..4096)
            .flat_map(|_| {
                state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
                (state >> 32).to_le_bytes()[..4].to_vec()
            })
            .collect();
        // A stack in the middle of RAM, and vectors to anywhere in the image.
        for (n, vector) in image[..4 * 98].chunks_exact_mut(4).enumerate() {
            let entry = if n == 0 { 0x2000_8000 } else { 0x0800_0200 + 138 * n as u32 + 1 };
            vector.copy_from_slice(&entry.to_le_bytes());
        }
        machine.load_binary(0x0800_0000, &image).expect("it fits");
        machine.memory.place(0x2000_7000, &image[0x400..0x2400]);
        for start in 0..150_u32 {
            let reset = 0x0800_0200 + 102 * start + 1;
            machine.load_binary(0x0800_0004, &reset.to_le_bytes()).expect("it fits");
            match machine.run_until(machine.time() + 2000) {
                Stop::ReachedTime | Stop::Lockup { .. } | Stop::Exit(_) => {}
                other => panic!("{other}"),
            }
        }
        machine.output.clear();
    }
    assert!(machine.core.counters.instructions > 200_000);
}

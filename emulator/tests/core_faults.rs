//! Faults, lock-up, stalls and exceptions that come at an awkward moment. Programs stand as machine code with their
//! assembly above.
use emulator::{
    Machine, Stop,
    bus::{Access, AccessError, Cycle, NEVER, Peripherals},
    chip::{BareBoard, Chip},
    core::{Fault, Timing},
    memory::Memory,
};

// ldr r0, =0x40023874; ldr r1, [r0]; lsls r1, r1, #2; bmi 2f; ldr r0, =0x40003000; ldr r1, =0xCCCC; str r1, [r0]
// ldr r0, =0x40023C04; ldr r1, =0x45670123; str r1, [r0]; ldr r1, =0xCDEF89AB; str r1, [r0]; movs r1, #0x2A
// str r1, [r0, #12]; ldr r1, =0x1002A; str r1, [r0, #12]; 1: b 1b; 2: bkpt #1
/// Starts the watchdog, unless it was it that caused the reset, and erases sector 5 by bytes, which takes 2 s.
const ERASE: &[u16] = &[
    0x4809, 0x6801, 0x0089, 0xD40D, 0x4808, 0xF64C, 0x41CC, 0x6001, 0x4807, 0x4908, 0x6001, 0x4908, 0x6001,
    0x212A, 0x60C1, 0x4907, 0x60C1, 0xE7FE, 0xBE01, 0xBF00, 0x3874, 0x4002, 0x3000, 0x4000, 0x3C04, 0x4002,
    0x0123, 0x4567, 0x89AB, 0xCDEF, 0x002A, 0x0001,
];
// ldr r0, =0x40023874; ldr r1, [r0]; lsls r1, r1, #2; bmi 2f; ldr r0, =0x40003000; ldr r1, =0xCCCC; str r1, [r0]
// ldr r0, =0x40005400; ldr r1, [r0]; 2: bkpt #1
/// Starts the watchdog likewise and reads a register of I2C1.
const I2C: &[u16] = &[
    0x4805, 0x6801, 0x0089, 0xD405, 0x4804, 0xF64C, 0x41CC, 0x6001, 0x4803, 0x6801, 0xBE01, 0xBF00, 0x3874,
    0x4002, 0x3000, 0x4000, 0x5400, 0x4000,
];
// udf #0
const UDF: &[u16] = &[0xDE00];
// b .
const HANG: &[u16] = &[0xE7FE];
// mov r2, sp; svc 0; bkpt #2
const CALL: &[u16] = &[0x466A, 0xDF00, 0xBE02];
// ldr r0, [sp, #28]; adds r0, #5; str r0, [sp, #28]; bx lr
const SPOIL_FRAME: &[u16] = &[0x9807, 0x3005, 0x9007, 0x4770];
// mov r4, sp; mov r5, lr; bkpt #1
const LOOK: &[u16] = &[0x466C, 0x4675, 0xBE01];
// ldr r0, =0xE000ED1C; movs r1, #0xF0; lsls r1, r1, #24; str r1, [r0]; ldr r0, =0xE000E100; movs r1, #1
// str r1, [r0]; movs r4, #0; movs r6, #0; nop; movs r6, #1; svc 0; b .
const LATE: &[u16] = &[
    0x4806, 0x21F0, 0x0609, 0x6001, 0x4805, 0x2101, 0x6001, 0x2400, 0x2600, 0xBF00, 0x2601, 0xDF00, 0xE7FE,
    0xBF00, 0xED1C, 0xE000, 0xE100, 0xE000,
];
// movs r4, #1; bx lr
const CALLED: &[u16] = &[0x2401, 0x4770];
// mov r5, lr; bkpt #1
const LINK: &[u16] = &[0x4675, 0xBE01];
// movw r0, #20000; ldr r1, =2f; 1: eor r2, r1, #0x08000000; blx r2; subs r0, #1; bne 1b; bkpt #1; 2: bx lr
const ALIASES: &[u16] = &[
    0xF644, 0x6020, 0x4904, 0xF081, 0x6200, 0x4790, 0x3801, 0xD1FA, 0xBE01, 0xBF00, 0x4770, 0xBF00, 0x0115,
    0x0800,
];

/// An image that starts with `code`; `handlers` by exception number.
fn image(code: &[u16], handlers: &[(usize, &[u16])]) -> Vec<u8> {
    let mut image = vec![0_u8; 0x100];
    image[..4].copy_from_slice(&0x2000_8000_u32.to_le_bytes());
    for (vector, code) in [(1, code)].iter().chain(handlers) {
        image.resize(image.len().next_multiple_of(4), 0);
        let entry = (0x0800_0000 + image.len() as u32) | 1;
        image[4 * vector..4 * vector + 4].copy_from_slice(&entry.to_le_bytes());
        image.extend(code.iter().flat_map(|halfword| halfword.to_le_bytes()));
    }
    image
}

fn machine<P: Peripherals>(peripherals: P, code: &[u16], handlers: &[(usize, &[u16])]) -> Machine<P> {
    let mut machine = Machine::new(peripherals, Timing::Pessimistic, 1);
    machine.stop_at_breakpoints = true;
    machine.load_binary(0x0800_0000, &image(code, handlers)).expect("it fits");
    machine
}

fn chip() -> Chip<BareBoard> {
    Chip::new(BareBoard::default())
}

fn stops_at<P: Peripherals>(machine: &mut Machine<P>, breakpoint: u8) {
    let stop = machine.run_until(200_000_000);
    assert!(matches!(stop, Stop::Breakpoint { code, .. } if code == breakpoint), "{stop}");
}

/// Milliseconds at 16 MHz.
fn ms(cycles: Cycle) -> f64 {
    cycles as f64 / 16_000.0
}

/// The erase stalls the core for 2 s, and the watchdog bites after 512 ms.
#[test]
fn a_watchdog_bites_at_its_time_in_the_middle_of_an_erase() {
    let mut machine = machine(chip(), ERASE, &[]);
    assert_eq!(machine.run_until(1_600_000), Stop::ReachedTime);
    assert!(machine.time() < 1_600_010, "{}", machine.time());
    stops_at(&mut machine, 1);
    assert!((512.0..512.1).contains(&ms(machine.time())), "{} ms", ms(machine.time()));
    let sector = &machine.memory.flash[0x2_0000..0x4_0000];
    let blank = sector.iter().filter(|byte| **byte == 0xFF).count();
    assert!(blank < 0x1000, "an erase cut short leaves garbage, not {blank} blank bytes");
    assert!(machine.memory.flash[..0x100].starts_with(&0x2000_8000_u32.to_le_bytes()));
}

/// Time goes on in a lock-up, until the watchdog ends it.
#[test]
fn a_lock_up_lasts_until_the_watchdog_bites() {
    let mut machine = machine(chip(), I2C, &[(3, UDF)]);
    assert_eq!(machine.run_until(1_600_000), Stop::ReachedTime);
    let asleep = machine.core.counters.asleep;
    stops_at(&mut machine, 1);
    assert!((512.0..512.1).contains(&ms(machine.time())), "{} ms", ms(machine.time()));
    assert_eq!((asleep, machine.core.counters.asleep), (0, 0));
    let bug = machine.memory.bugs.last().expect("a bug");
    for part in
        ["lock-up", "undefined instruction", "it began with", "0x40005400 (I2C1, which is not emulated)"]
    {
        assert!(bug.what.contains(part), "{}", bug.what);
    }
}

#[test]
fn a_lock_up_that_is_to_stop_tells_how_it_began() {
    let mut machine = machine(chip(), I2C, &[(3, UDF)]);
    machine.stop_at_lockups = true;
    let stop = machine.run_until(1_000_000);
    let Stop::Lockup { fault, chain, .. } = &stop else { panic!("{stop}") };
    assert_eq!(*fault, Fault::Undefined);
    assert_eq!(chain.iter().map(|fault| fault.fault).collect::<Vec<_>>(), [Fault::DataBus, Fault::Undefined]);
}

/// As most handlers end.
#[test]
fn a_fault_stands_while_its_handler_does() {
    let mut machine = machine(chip(), I2C, &[(3, HANG)]);
    assert_eq!(machine.standing_fault(), None);
    assert_eq!(machine.run_until(1_000_000), Stop::ReachedTime);
    let fault = machine.standing_fault().expect("a fault");
    assert_eq!((fault.fault, fault.address), (Fault::DataBus, 0x4000_5400));
    assert!(machine.memory.bugs.iter().any(|bug| bug.what == "I2C1 at 0x40005400 is not emulated"));
}

/// The frame names a handler to return to, in a return to thread mode (B1.5.8): the fault finds the stack as it was.
#[test]
fn a_return_that_is_refused_leaves_the_stack_as_it_was() {
    let mut machine = machine(chip(), CALL, &[(3, LOOK), (11, SPOIL_FRAME)]);
    stops_at(&mut machine, 1);
    let register = |n| machine.core.register(n);
    assert_eq!(machine.last_fault.as_ref().map(|_| ()), None, "a fault of a return is not an instruction's");
    assert_eq!(register(4), register(2) - 0x20);
    assert_eq!(register(5), 0xFFFF_FFF9);
}

/// Raises its line at a time.
struct Line {
    at: Cycle,
    up: bool,
}

impl Peripherals for Line {
    fn read(&mut self, _: &mut Memory, access: Access) -> Result<u32, AccessError> {
        Err(AccessError::Nothing(access.address))
    }
    fn write(&mut self, _: &mut Memory, access: Access, _: u32) -> Result<(), AccessError> {
        Err(AccessError::Nothing(access.address))
    }
    fn next_event(&self) -> Cycle {
        if self.up { NEVER } else { self.at }
    }
    fn advance(&mut self, _: &mut Memory, now: Cycle) {
        self.up |= now >= self.at;
    }
    fn interrupt_lines(&self) -> u128 {
        self.up.into()
    }
    fn take_reset(&mut self) -> bool {
        false
    }
    fn reset(&mut self, _: &mut Memory, _: Cycle) {}
    fn request_reset(&mut self) {}
}

/// It goes first, and returns to the thread, not to a handler that has not begun.
#[test]
fn an_interrupt_that_comes_during_the_stacking_goes_first() {
    let mut late = 0;
    for at in 0..120 {
        let mut machine = machine(Line { at, up: false }, LATE, &[(11, CALLED), (16, LINK)]);
        stops_at(&mut machine, 1);
        let [called, link, calling] = [4, 5, 6].map(|n| machine.core.register(n));
        // Interrupted before the handler's first instruction, if at all.
        assert!(link == 0xFFFF_FFF9 || called == 1, "{at}: {link:#x}");
        late += u32::from(link == 0xFFFF_FFF9 && calling == 1 && called == 0);
    }
    // The stacking takes 12 cycles and 8 more for the other bus master, the two instructions before it one or two each.
    assert!((12..=26).contains(&late), "{late}");
}

/// What was decoded for one alias of flash stays while the program runs in the other.
#[test]
fn calls_between_the_two_aliases_of_flash_are_quick() {
    let begun = std::time::Instant::now();
    let mut machine = machine(chip(), ALIASES, &[]);
    stops_at(&mut machine, 1);
    assert!(machine.core.counters.instructions > 5 * 20_000);
    // Some milliseconds; decoding a mebibyte anew each time takes a minute.
    assert!(begun.elapsed().as_secs_f64() < 10.0, "{:?}", begun.elapsed());
}

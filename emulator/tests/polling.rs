//! Loops that wait for a peripheral are passed over turn by turn: that must not show in anything but the reads saved.
use emulator::{
    Machine, Stop,
    bus::{Access, AccessError, Cycle, NEVER, Peripherals},
    core::Timing,
    memory::Memory,
};

// ldr r1, =0x40000004; 0: movw r0, #401; 1: subs r0, #1; beq.w 2f; ldr r6, [r1, #-4]; lsls r4, r6, #25; bmi.w 2f; lsls
// r4, r6, #31; beq 1b; 2: add r8, r0; str r0, [r1]; b 0b
const BOUNDED: &[u16] = &[
    0x4908, 0xF240, 0x1091, 0x3801, 0xF000, 0x8007, 0xF851, 0x6C04, 0x0674, 0xF100, 0x8002, 0x07F4, 0xD0F5,
    0x4480, 0x6008, 0xE7F0, 0xBF00, 0x0000, 0x0004, 0x4000,
];
// mov r1, #0x40000000; 0: ldr r6, [r1]; cmp r6, #3; bne 0b; str r0, [r1, #4]; add r8, r6; b 0b
const UNBOUNDED: &[u16] = &[0xF04F, 0x4180, 0x680E, 0x2E03, 0xD1FC, 0x6048, 0x44B0, 0xE7F9];
// mov r1, #0x40000000; 0: ldr r6, [r1]; lsrs r0, r6, #1; subs r0, #1; bmi 0b; str r0, [r1, #4]; 1: ldr r6, [r1]; lsrs
// r3, r6, #1; bcs 2f; adds r5, #1; b 1b; 2: str r0, [r1, #4]; b 0b
const COUNTING: &[u16] = &[
    0xF04F, 0x4180, 0x680E, 0x0870, 0x3801, 0xD4FB, 0x6048, 0x680E, 0x0873, 0xD201, 0x3501, 0xE7FA, 0x6048,
    0xE7F3,
];

/// A flag that rises some time after it has been cleared: at 0x4000_0000 it is read, by a write behind it cleared.
struct Flag {
    rests: bool,
    raised: bool,
    due: Cycle,
    reads: u32,
    noise: u32,
}

impl Peripherals for Flag {
    fn read(&mut self, memory: &mut Memory, access: Access) -> Result<u32, AccessError> {
        self.advance(memory, access.at);
        self.reads += 1;
        Ok(if self.raised { 3 } else { 0 })
    }

    fn write(&mut self, _: &mut Memory, access: Access, _: u32) -> Result<(), AccessError> {
        self.noise = self.noise.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        // Now and then later than the bounded loop waits.
        let most = if self.noise & 0x70 == 0 { 10_000 } else { 400 };
        (self.raised, self.due) = (false, access.at + Cycle::from(1 + (self.noise >> 8) % most));
        Ok(())
    }

    fn next_event(&self) -> Cycle {
        self.due
    }

    fn advance(&mut self, _: &mut Memory, now: Cycle) {
        if self.due <= now {
            (self.raised, self.due) = (true, NEVER);
        }
    }

    fn interrupt_lines(&self) -> u128 {
        0
    }

    fn wait_states(&self, _: u32) -> Cycle {
        5
    }

    fn rests(&self, address: u32, _: Cycle) -> bool {
        self.rests && address == 0x4000_0000
    }

    fn take_reset(&mut self) -> bool {
        false
    }

    fn reset(&mut self, _: &mut Memory, _: Cycle) {}

    fn request_reset(&mut self) {}
}

fn machine(code: &[u16], timing: Timing, rests: bool) -> Machine<Flag> {
    let mut image = vec![0_u8; 0x100];
    image[..4].copy_from_slice(&0x2000_8000_u32.to_le_bytes());
    image[4..8].copy_from_slice(&0x0800_0101_u32.to_le_bytes());
    image.extend(code.iter().flat_map(|halfword| halfword.to_le_bytes()));
    let flag = Flag { rests, raised: false, due: 300, reads: 0, noise: 1 };
    let mut machine = Machine::new(flag, timing, 1);
    let interface = &mut machine.memory.flash_interface;
    (interface.latency, interface.prefetch, interface.instruction_cache) = (5, true, true);
    machine.load_binary(0x0800_0000, &image).expect("it fits");
    machine
}

/// Runs `code` with and without a register that is known to rest, in steps of any length: nothing differs but the number of
/// reads, which it answers: with, without.
fn reads(code: &[u16], timing: Timing) -> (u32, u32) {
    let (mut passing, mut running) = (machine(code, timing, true), machine(code, timing, false));
    let mut limit = 0;
    for step in 0..3000_u64 {
        limit += 1 + step * step * 7919 % 1500;
        for machine in [&mut passing, &mut running] {
            assert_eq!(machine.run_until(limit), Stop::ReachedTime);
        }
        let state = |machine: &Machine<Flag>| {
            let registers: Vec<u32> = (0..16).map(|number| machine.core.register(number)).collect();
            (machine.time(), machine.core.counters, registers, machine.core.xpsr())
        };
        assert_eq!(state(&passing), state(&running), "up to {limit}");
    }
    (passing.peripherals.reads, running.peripherals.reads)
}

#[test]
fn a_wait_that_is_passed_over_leaves_the_same_as_one_that_is_run() {
    for timing in [Timing::Optimistic, Timing::Pessimistic] {
        for code in [BOUNDED, UNBOUNDED] {
            let (passing, running) = reads(code, timing);
            assert!(passing < running / 2, "{timing:?}: {passing} of {running}");
        }
    }
}

#[test]
fn a_loop_that_does_more_than_wait_is_run() {
    for timing in [Timing::Optimistic, Timing::Pessimistic] {
        let (passing, running) = reads(COUNTING, timing);
        assert_eq!(passing, running, "{timing:?}");
    }
}

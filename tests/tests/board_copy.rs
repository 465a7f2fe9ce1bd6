//! The image's own routine for copying memory, on the virtual board, against what it is to do.

use emulator::boards::SpeedyBeeF405V3;
use emulator::chip::Chip;
use emulator::core::Timing;
use emulator::{Machine, Stop};
use mintime::firmware_image::FirmwareImage;

/// Main RAM that the test has for itself: the image does not run.
const AREA: u32 = 0x2001_0000;
const AREA_BYTES: usize = 1024;
/// Where the routine returns to: a breakpoint.
const RETURN: u32 = 0x2001_8000;
const BREAKPOINT: [u8; 2] = [0x01, 0xBE];
/// What registers that a routine must leave alone hold.
const KEPT: u32 = 0x5AFE_0000;

#[test]
fn every_length_and_alignment_is_copied_and_nothing_else_is_touched() {
    let image = FirmwareImage::build(&mut |_| {}).expect("the firmware builds");
    let mut machine = Machine::new(Chip::new(SpeedyBeeF405V3::new()), Timing::Pessimistic, 1);
    machine.load_elf(image.elf()).expect("an image");
    machine.stop_at_breakpoints = true;
    machine.memory.place(RETURN, &BREAKPOINT).expect("RAM");
    let names = ["memcpy", "__aeabi_memcpy", "__aeabi_memcpy4", "__aeabi_memcpy8"];
    let entries = names.map(|name| emulator::machine::symbol_address(image.elf(), name));
    let entry = entries[0].expect("it is in the image") & !1;
    assert!(entries.iter().flatten().all(|other| other & !1 == entry), "{entries:x?}");

    let before: Vec<u8> = (0..AREA_BYTES).map(|n| (n * 37 + n / 256) as u8).collect();
    let aligned = [(0, 0), (0, 4), (4, 0)];
    let places = (0..4).flat_map(|to| (0..4).map(move |from| (to, from))).chain(aligned);
    for (to, from) in places {
        for length in (0..150).chain([255, 256, 257, 300]) {
            let (to, from) = (to + 16, from + 516);
            machine.memory.place(AREA, &before).expect("RAM");
            for register in 4..=11 {
                machine.core.set_register(register, KEPT + u32::from(register));
            }
            machine.core.set_register(0, AREA + to as u32);
            machine.core.set_register(1, AREA + from as u32);
            machine.core.set_register(2, length as u32);
            machine.core.set_register(14, RETURN | 1);
            machine.core.set_register(15, entry);
            let begun = machine.time();
            let stop = machine.run_until(begun + 20_000);
            assert_eq!(stop, Stop::Breakpoint { pc: RETURN, code: 1 }, "{to} {from} {length}");
            let took = machine.time() - begun;
            // Six cycles a byte is what the compiler's routine takes for what is misaligned.
            assert!(took <= 150 + 4 * length as u64, "{took} cycles for {length} bytes");

            let mut expected = before.clone();
            expected.copy_within(from..from + length, to);
            assert_eq!(
                machine.memory.peek(AREA, AREA_BYTES as u32),
                Some(&expected[..]),
                "{to} {from} {length}"
            );
            assert_eq!(machine.core.register(0), AREA + to as u32);
            for register in 4..=11 {
                assert_eq!(machine.core.register(register), KEPT + u32::from(register));
            }
        }
    }
}

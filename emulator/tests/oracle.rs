//! The core against QEMU: the programs of `oracle/` must print the hashes QEMU printed (see `oracle/check.sh`).
use emulator::{Machine, NoPeripherals, Stop, core::Timing};

fn agrees(elf: &[u8], expected: &str, timing: Timing) {
    let mut machine = Machine::new(NoPeripherals::default(), timing, 7);
    machine.load_elf(elf).expect("a committed image loads");
    assert_eq!(machine.run_until(4_000_000_000), Stop::Exit(0), "last fault {:x?}", machine.last_fault);
    let actual = String::from_utf8_lossy(&machine.output);
    let wanted: Vec<&str> = expected.lines().filter(|line| !line.starts_with('#')).collect();
    assert_eq!(actual.lines().collect::<Vec<_>>(), wanted);
    // What the programs do on purpose to see a fault.
    let meant = ["at 0x9000001", "at 0x9000000", "unprivileged code"];
    machine.memory.bugs.retain(|bug| !meant.iter().any(|part| bug.what.contains(part)));
    assert!(machine.memory.bugs.is_empty(), "{:?}", machine.memory.bugs);
}

#[test]
fn every_instruction_form() {
    agrees(
        include_bytes!("../oracle/elf/instructions.elf"),
        include_str!("../oracle/expected/instructions.txt"),
        Timing::Optimistic,
    );
}

#[test]
fn exceptions() {
    for timing in [Timing::Optimistic, Timing::Pessimistic] {
        agrees(
            include_bytes!("../oracle/elf/exceptions.elf"),
            include_str!("../oracle/expected/exceptions.txt"),
            timing,
        );
    }
}

#[test]
fn compiled_code() {
    for timing in [Timing::Optimistic, Timing::Pessimistic] {
        agrees(include_bytes!("../oracle/elf/mix.elf"), include_str!("../oracle/expected/mix.txt"), timing);
    }
}

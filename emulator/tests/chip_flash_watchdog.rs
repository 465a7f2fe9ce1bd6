//! Flash memory and the watchdogs.

mod rig;

use emulator::bus::{Access, Peripherals, Width};
use emulator::chip::BareBoard;
use emulator::memory::FLASH_BASE;
use rig::*;

const KEYR: u32 = FLASH + 4;
const SR: u32 = FLASH + 0xC;
const CR: u32 = FLASH + 0x10;

fn unlocked() -> Rig<BareBoard> {
    let mut rig = bare();
    rig.start_clocks();
    rig.write(KEYR, 0x4567_0123);
    rig.write(KEYR, 0xCDEF_89AB);
    rig
}

#[test]
fn an_erase_takes_its_time_and_stalls_the_flash() {
    let mut rig = unlocked();
    rig.memory.program_flash(0x8000, &[0x12; 64]);
    let generation = rig.memory.flash_interface.generation;
    let start = rig.ns();
    // Sector 2, by words.
    rig.write(CR, 1 << 1 | 2 << 3 | 2 << 8);
    rig.set(CR, 1 << 16);
    assert_eq!(rig.read(SR) >> 16, 1);
    let until = rig.memory.flash_interface.busy_until;
    let took = rig.chip.clock().ns(until) - start;
    assert!((250 * MS..251 * MS).contains(&took), "{took}");
    assert!(rig.memory.flash_interface.generation > generation);
    rig.pass(took - MS);
    assert_eq!(rig.read(SR) >> 16, 1);
    rig.pass(MS);
    assert_eq!(rig.read(SR) >> 16, 0);
    assert!(rig.memory.flash[0x8000..0xC000].iter().all(|&byte| byte == 0xFF));
    rig.assert_no_bugs();
}

#[test]
fn a_reset_during_an_erase_leaves_garbage() {
    let mut rig = unlocked();
    rig.memory.program_flash(0x2_0000, &[0; 64]);
    rig.write(CR, 1 << 1 | 5 << 3 | 2 << 8);
    rig.set(CR, 1 << 16);
    rig.pass(500 * MS);
    let at = rig.at;
    rig.chip.request_reset();
    assert!(rig.chip.take_reset());
    rig.chip.reset(&mut rig.memory, at);
    rig.pass(5000 * MS);
    let sector = &rig.memory.flash[0x2_0000..0x4_0000];
    assert!(sector.iter().any(|&byte| byte != 0xFF) && sector[..64] != [0; 64]);
    assert!(rig.memory.flash_interface.busy_until <= at);
    assert_eq!(rig.read(CR) >> 31, 1, "locked again");
}

#[test]
fn programming_needs_its_set_up_and_only_clears_bits() {
    let mut rig = unlocked();
    rig.write(FLASH_BASE + 0x100, 0x1234_5678);
    assert_eq!(rig.read(SR) & 0x80, 0x80);
    assert!(rig.has_bug("FLASH_CR.PG is off"));
    rig.write(SR, 0xF3);
    rig.write(CR, 1 | 2 << 8);
    rig.write(FLASH_BASE + 0x100, 0x1234_5678);
    rig.wait_for(0xE004_2000, 0x413);
    rig.pass(16 * US);
    assert_eq!(rig.memory.flash[0x100..0x104], 0x1234_5678_u32.to_le_bytes());
    assert_eq!(rig.read(SR), 0);
    let access = Access { at: rig.at + 10, address: FLASH_BASE + 0x104, width: Width::Half, pc: 0 };
    rig.chip.write(&mut rig.memory, access, 0).unwrap();
    assert_eq!(rig.read(SR) & 0x40, 0x40, "another width than PSIZE");
    assert_eq!(rig.memory.flash[0x104], 0xFF);
}

#[test]
fn a_wrong_key_locks_until_the_next_reset() {
    let mut rig = bare();
    rig.write(KEYR, 0x1234);
    rig.write(KEYR, 0x4567_0123);
    rig.write(KEYR, 0xCDEF_89AB);
    assert_eq!(rig.read(CR) >> 31, 1);
    assert!(rig.has_bug("wrong key"));
}

#[test]
fn caches_are_reset_only_while_they_are_off() {
    let mut rig = bare();
    rig.write(FLASH, 1 << 10);
    assert!(rig.memory.flash_interface.data_cache);
    rig.write(FLASH, 1 << 10 | 1 << 12);
    assert!(rig.has_bug("DCRST is set while the data cache is on"));
    rig.memory.bugs.clear();
    rig.write(FLASH, 0);
    rig.write(FLASH, 1 << 12);
    rig.write(FLASH, 1 << 10);
    rig.assert_no_bugs();
}

/// Starts the watchdog as the firmware does and answers when it bites [ns].
fn bite(lsi_hz: u32, petted: bool) -> u64 {
    let mut rig = bare();
    rig.chip.set_lsi_hz(lsi_hz);
    rig.write(IWDG, 0x5555);
    rig.write(IWDG, 0xCCCC);
    rig.write(IWDG, 0x5555);
    rig.write(IWDG + 8, 750);
    rig.start_clocks();
    if petted {
        rig.write(IWDG, 0xAAAA);
    }
    let start = rig.ns();
    loop {
        rig.pass(10 * US);
        if rig.chip.take_reset() {
            break;
        }
        assert!(rig.ns() < 3_000 * MS, "it never bites");
    }
    let elapsed = rig.ns() - start;
    let at = rig.at;
    rig.chip.reset(&mut rig.memory, at);
    assert_eq!(rig.read(RCC + 0x74) >> 29 & 1, 1, "the reason is kept");
    rig.assert_no_bugs();
    elapsed
}

#[test]
fn the_watchdog_bites_by_its_own_slow_or_fast_clock() {
    // 751 counts of four cycles.
    for (hz, expected_us) in [(17_000, 176_706), (32_000, 93_875), (47_000, 63_915)] {
        let us = bite(hz, true) / 1000;
        assert!((expected_us..expected_us + 25).contains(&us), "{hz}: {us}");
    }
    // Unpetted it counts from 4095, across the change of clocks.
    let us = bite(32_000, false) / 1000;
    assert!((509_000..=512_000).contains(&us), "{us}");
}

#[test]
fn a_petted_watchdog_stays_quiet_and_a_locked_one_keeps_its_reload() {
    let mut rig = bare();
    rig.write(IWDG, 0xCCCC);
    rig.write(IWDG + 8, 10);
    assert!(rig.has_bug("without 0x5555"));
    for _ in 0..100 {
        rig.pass(20 * MS);
        rig.write(IWDG, 0xAAAA);
        assert!(!rig.chip.take_reset());
    }
    assert_eq!(rig.read(IWDG + 8), 0xFFF);
    rig.write(IWDG, 0x5555);
    rig.write(IWDG + 8, 100);
    assert_eq!(rig.read(IWDG + 0xC), 2, "on its way into the other clock domain");
    rig.pass(MS);
    assert_eq!(rig.read(IWDG + 0xC), 0);
}

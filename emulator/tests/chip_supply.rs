//! The voltage detector, the random number generator, a watchdog whose speed changes, power cuts.

mod rig;

use emulator::bus::Peripherals;
use emulator::chip::RngDefect;
use emulator::memory::FLASH_BASE;
use rig::*;

const RNG: u32 = 0x5006_0800;
const PVD_IRQ: u32 = 1;
const PVDO: u32 = 1 << 2;

#[test]
fn a_falling_supply_raises_the_detectors_interrupt() {
    let mut rig = bare();
    rig.start_clocks();
    // PLS 7, PVDE; line 16 rising.
    rig.set(PWR, 7 << 5 | 1 << 4);
    rig.write(EXTI + 0x08, 1 << 16);
    rig.write(EXTI, 1 << 16);
    rig.chip.set_supply_v(2.95);
    assert!(!rig.irq(PVD_IRQ) && rig.read(PWR + 4) & PVDO == 0);
    rig.chip.set_supply_v(2.85);
    assert!(rig.irq(PVD_IRQ) && rig.read(PWR + 4) & PVDO != 0);
    rig.write(EXTI + 0x14, 1 << 16);
    assert!(!rig.irq(PVD_IRQ));
    // Hysteresis, and no rising edge on the way back.
    rig.chip.set_supply_v(2.95);
    assert_ne!(rig.read(PWR + 4) & PVDO, 0);
    rig.chip.set_supply_v(3.3);
    assert!(!rig.irq(PVD_IRQ) && rig.read(PWR + 4) & PVDO == 0);
    rig.assert_no_bugs();
}

#[test]
fn the_detector_off_or_at_a_lower_level_says_nothing() {
    let mut rig = bare();
    rig.start_clocks();
    rig.write(EXTI + 0x08, 1 << 16);
    rig.write(EXTI, 1 << 16);
    rig.chip.set_supply_v(2.0);
    assert!(!rig.irq(PVD_IRQ) && rig.read(PWR + 4) & PVDO == 0);
    rig.chip.set_supply_v(2.4);
    // PLS 2: 2.3 V.
    rig.set(PWR, 2 << 5 | 1 << 4);
    assert!(!rig.irq(PVD_IRQ) && rig.read(PWR + 4) & PVDO == 0);
    rig.set(PWR, 7 << 5);
    assert!(rig.irq(PVD_IRQ), "switched on where the supply is low already");
}

fn numbers(seed: u64) -> Vec<u32> {
    let mut rig = bare();
    rig.start_clocks();
    rig.chip.seed_rng(seed);
    assert_eq!(rig.read(RNG + 8), 0, "not on yet");
    rig.write(RNG, 1 << 2);
    assert_eq!(rig.read(RNG + 4), 0, "40 cycles of 48 MHz");
    (0..4)
        .map(|_| {
            rig.wait_for(RNG + 4, 1);
            rig.read(RNG + 8)
        })
        .collect()
}

#[test]
fn random_numbers_follow_from_the_seed() {
    assert_eq!(numbers(1), numbers(1));
    assert_ne!(numbers(1), numbers(2));
    let mut all = numbers(3);
    all.dedup();
    assert_eq!(all.len(), 4);
}

#[test]
fn a_broken_generator_says_so_or_stays_silent() {
    for (defect, status) in
        [(RngDefect::Seed, 1 << 2 | 1 << 6), (RngDefect::Clock, 1 << 1 | 1 << 5), (RngDefect::Silent, 0)]
    {
        let mut rig = bare();
        rig.start_clocks();
        rig.chip.set_rng_defect(defect);
        rig.write(RNG, 1 << 2);
        rig.pass(MS);
        assert_eq!(rig.read(RNG + 4), status, "{defect:?}");
        assert_eq!(rig.read(RNG + 8), 0);
    }
}

/// From 94 ms to 2 s and back, as for an erase.
#[test]
fn a_watchdog_is_lengthened_and_shortened() {
    let mut rig = bare();
    let timeout = |rig: &mut Rig<_>, prescaler, reload| {
        rig.write(IWDG, 0x5555);
        rig.write(IWDG + 4, prescaler);
        rig.write(IWDG + 8, reload);
        assert_eq!(rig.read(IWDG + 0xC) & 2, 2);
        // Five cycles of 32 kHz behind a divider of 16 at most.
        rig.pass(3 * MS);
        assert_eq!(rig.read(IWDG + 0xC), 0);
        rig.write(IWDG, 0xAAAA);
    };
    rig.write(IWDG, 0xCCCC);
    timeout(&mut rig, 0, 750);
    rig.pass(90 * MS);
    assert!(!rig.chip.take_reset());
    timeout(&mut rig, 2, 4095);
    rig.pass(2_040 * MS);
    assert!(!rig.chip.take_reset(), "2.048 s");
    timeout(&mut rig, 0, 750);
    rig.pass(93 * MS);
    assert!(!rig.chip.take_reset());
    rig.pass(2 * MS);
    assert!(rig.chip.take_reset(), "strict again");
    rig.assert_no_bugs();
}

/// Some bits of the word have fallen, none has risen, and the chip starts anew with its power-on flag.
#[test]
fn a_power_cut_within_a_word_leaves_some_of_its_bits() {
    let mut seen = Vec::new();
    for noise in 0..20_u64 {
        let mut rig = bare();
        rig.start_clocks();
        rig.write(FLASH + 4, 0x4567_0123);
        rig.write(FLASH + 4, 0xCDEF_89AB);
        rig.write(FLASH + 0x10, 1 | 2 << 8);
        rig.write(FLASH_BASE + 0x4000, 0x1234_5678);
        rig.chip.cut_power(&mut rig.memory, noise.wrapping_mul(0x9E37_79B9_7F4A_7C15));
        assert!(rig.chip.take_reset());
        let at = rig.at;
        rig.chip.reset(&mut rig.memory, at);
        let word = u32::from_le_bytes(rig.memory.flash[0x4000..0x4004].try_into().expect("a word"));
        assert_eq!(word & 0x1234_5678, 0x1234_5678);
        assert_eq!(rig.read(RCC + 0x74) >> 27 & 1, 1, "power-on");
        seen.push(word);
    }
    seen.sort_unstable();
    seen.dedup();
    assert!(seen.len() > 15, "{seen:x?}");
}

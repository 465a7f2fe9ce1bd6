//! Nothing that firmware does may bring the emulator down, stop time, or depend on anything but the inputs.

mod rig;

use emulator::boards::SpeedyBeeF405V3;
use emulator::bus::{Access, Peripherals, Width};
use rig::*;

/// SplitMix64.
struct Noise(u64);

impl Noise {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    fn below(&mut self, limit: u64) -> u64 {
        self.next() % limit
    }

    /// A register value: few bits, many bits, or an address.
    fn value(&mut self) -> u32 {
        match self.below(4) {
            0 => self.next() as u32,
            1 => 1 << self.below(32),
            2 => (self.next() & self.next() & self.next()) as u32,
            _ => 0x2000_0000 + self.below(0x2_0000) as u32,
        }
    }
}

const BLOCKS: [u32; 30] = [
    RCC,
    FLASH,
    PWR,
    GPIOA,
    GPIOB,
    GPIOC,
    SYSCFG,
    EXTI,
    TIM2,
    TIM4,
    TIM5,
    USART1,
    SPI1,
    ADC,
    DMA1,
    DMA2,
    0x4001_0000,
    0x4000_1400,
    0x4001_4000,
    0x4000_2800,
    0x4000_2C00,
    0x4002_3000,
    0x4002_4000,
    0x5006_0800,
    0xE004_2000,
    0x4000_4400,
    0x4000_3800,
    0x4001_2100,
    0x4000_1000,
    0x4001_1400,
];

/// Hammers the chip; answers what became of it, as a hash.
fn hammer(seed: u64, accesses: u32) -> u64 {
    let mut noise = Noise(seed);
    let mut rig: Rig<SpeedyBeeF405V3> = speedybee();
    rig.start_clocks();
    let mut hash = 0_u64;
    let mut sample_ns = 0;
    for _ in 0..accesses {
        let block = BLOCKS[noise.below(BLOCKS.len() as u64) as usize];
        let reach = if block == ADC || noise.below(20) == 0 { 0x400 } else { 0x100 };
        let width = [Width::Word, Width::Word, Width::Half, Width::Byte][noise.below(4) as usize];
        let offset = noise.below(reach) as u32 & if width == Width::Word { !3 } else { !1 };
        let address =
            if noise.below(200) == 0 { 0x0800_0000 + noise.value() % 0x10_0000 } else { block + offset };
        rig.at += noise.below(64);
        let access = Access { at: rig.at, address: address & !3 | offset & 3, width, pc: 0x0800_0000 };
        if noise.below(3) == 0 {
            let value = rig.chip.read(&mut rig.memory, access).unwrap_or(0);
            hash = hash.rotate_left(5) ^ u64::from(value);
        } else {
            let mut value = noise.value();
            // Let the gates mostly stay open, the resets released and the watchdogs asleep.
            if block == RCC && (0x10..0x68).contains(&offset) && noise.below(8) != 0 {
                value = if offset < 0x30 { 0 } else { u32::MAX };
            }
            let _ = rig.chip.write(&mut rig.memory, access, value);
        }
        match noise.below(2000) {
            0 => {
                let now = rig.ns();
                rig.chip.set_host_baud(1, 1 << noise.below(24));
                rig.chip.serial_send(1, now, b"some bytes");
                rig.chip.serial_break(6, now, noise.below(1_000_000));
            }
            1 => {
                sample_ns = rig.ns().max(sample_ns) + noise.below(2 * MS);
                let Rig { chip, memory, .. } = &mut rig;
                chip.imu_sample(memory, sample_ns, [f64::NAN, 1e9, -3.0], [0.0, f64::INFINITY, 1.0]);
            }
            2 => rig.pass(noise.below(3 * MS)),
            3 => {
                let dead = noise.below(2) == 0;
                rig.chip.fail_crystal(&mut rig.memory, rig.at, dead);
            }
            _ => {}
        }
        if rig.chip.take_reset() {
            let at = rig.at;
            rig.chip.reset(&mut rig.memory, at);
            rig.chip.fail_crystal(&mut rig.memory, at, false);
            rig.memory.bugs.clear();
            rig.start_clocks();
        }
        rig.memory.bugs.truncate(100);
        hash = hash.rotate_left(1) ^ rig.chip.interrupt_lines() as u64;
    }
    let now = rig.chip.now();
    rig.chip.advance(&mut rig.memory, now);
    assert!(rig.chip.next_event() > rig.chip.now(), "nothing due is left undone");
    hash
}

#[test]
fn random_accesses_are_survived_and_repeatable() {
    for seed in 0..420 {
        let first = hammer(seed, 20_000);
        if seed < 4 {
            assert_eq!(first, hammer(seed, 20_000), "seed {seed}");
        }
    }
}

//! Clocks, gates, resets, ports and external interrupts.

mod rig;

use emulator::boards::SpeedyBeeF405V3;
use emulator::bus::{AccessError, Peripherals};
use emulator::chip::{Board, Effects, Pin, Pulse, SpiWord};
use rig::*;

#[test]
fn the_clocks_start_as_the_hal_starts_them() {
    let mut rig = bare();
    assert_eq!(rig.read(RCC) & 3, 3);
    assert_eq!(rig.read(RCC + 0x74) & 0x0E00_0000, 0x0E00_0000);
    let before = rig.ns();
    rig.start_clocks();
    // A crystal takes 2 ms and the PLL 200 µs.
    assert!((2_200_000..2_300_000).contains(&(rig.ns() - before)), "{}", rig.ns());
    let rates = rig.chip.clock().rates();
    assert_eq!((rates.hclk_hz, rates.apb1_divider, rates.apb2_divider), (168_000_000, 4, 2));
    // Switching off: ready falls with it, and what is in use stays on.
    rig.clear(RCC, 1 << 24 | 1 << 16);
    assert_eq!(rig.read(RCC) >> 24 & 3, 3);
    rig.set(RCC, 1 << 26);
    rig.wait_for(RCC, 1 << 27);
    rig.clear(RCC, 1 << 26);
    assert_eq!(rig.read(RCC) >> 26 & 3, 0);
    rig.set(RCC + 0x74, 1);
    rig.wait_for(RCC + 0x74, 2);
    rig.set(RCC + 0x74, 1 << 24);
    assert_eq!(rig.read(RCC + 0x74) & 0xFE00_0000, 0);
    rig.assert_no_bugs();
}

#[test]
fn wait_states_too_few_and_clocks_too_fast_are_told() {
    let mut rig = bare();
    rig.start_clocks();
    rig.write(FLASH, 4);
    assert!(rig.has_bug("flash has 4 wait states at 168000000 Hz and needs 5"));
    rig.write(RCC + 0x08, 2);
    assert!(rig.has_bug("PCLK1 runs at 168000000 Hz"));
}

#[test]
fn an_unclocked_peripheral_reads_zero_takes_no_write_and_is_told() {
    let mut rig = bare();
    rig.write(USART1 + 0x08, 0x5B);
    assert_eq!(rig.read(USART1), 0);
    assert!(rig.has_bug("USART1 is read while its clock is off (RCC_APB2ENR bit 4)"), "{:?}", rig.bugs());
    rig.write(RCC + 0x44, 1 << 4);
    assert_eq!(rig.read(USART1), 0xC0);
    assert_eq!(rig.read(USART1 + 0x08), 0);
    rig.write(USART1 + 0x08, 0x5B);
    rig.write(RCC + 0x24, 1 << 4);
    rig.write(RCC + 0x24, 0);
    assert_eq!(rig.read(USART1 + 0x08), 0);
    assert_eq!(rig.memory.bugs.len(), 2);
}

#[test]
fn what_is_not_there_says_so() {
    let mut rig = bare();
    assert_eq!(rig.try_read(0x4000_5400), Err(AccessError::NotEmulated(0x4000_5400, "I2C1")));
    assert_eq!(rig.try_read(0x4002_7000), Err(AccessError::Nothing(0x4002_7000)));
    assert_eq!(rig.read(0xE004_2000) & 0xFFF, 0x413);
}

#[test]
fn a_dead_crystal_raises_the_monitor_and_the_chip_goes_on() {
    let mut rig = bare();
    rig.start_clocks();
    rig.set(RCC, 1 << 19);
    // The chip was last looked at some time ago.
    let ns = rig.ns();
    rig.at += 168 * 1000;
    let Rig { chip, memory, at, .. } = &mut rig;
    chip.fail_crystal(memory, *at, true);
    assert!((1_000_000..1_000_010).contains(&(rig.ns() - ns)), "{}", rig.ns() - ns);
    assert!(rig.chip.nmi());
    assert_eq!(rig.chip.clock().rates().hclk_hz, 16_000_000);
    assert_eq!(rig.read(RCC + 0x0C) & 0x80, 0x80);
    rig.write(RCC + 0x0C, 1 << 23);
    assert!(!rig.chip.nmi());
    rig.assert_no_bugs();
}

/// The way back to speed without the crystal, RM0090 section 7.2.3, and a PLL that does not go along.
#[test]
fn the_pll_runs_from_the_internal_oscillator_unless_it_is_dead() {
    for dead in [false, true] {
        let mut rig = bare();
        rig.start_clocks();
        rig.set(RCC, 1 << 19);
        rig.chip.set_pll_dead(dead);
        let Rig { chip, memory, at, .. } = &mut rig;
        chip.fail_crystal(memory, *at, true);
        // 16 MHz / 8 × 168 / 2; the source is bit 22.
        let value = rig.read(RCC + 4);
        rig.write(RCC + 4, value & !(1 << 22 | 0x3F) | 8);
        rig.set(RCC, 1 << 24);
        rig.pass(400 * US);
        assert_eq!(rig.read(RCC) >> 25 & 1, u32::from(!dead));
        if !dead {
            rig.set(RCC + 8, 2);
            assert_eq!(rig.chip.clock().rates().hclk_hz, 168_000_000);
        }
        rig.assert_no_bugs();
    }
}

#[test]
fn a_port_mixes_what_it_drives_with_what_it_sees() {
    let mut rig = bare();
    rig.write(RCC + 0x30, 7);
    rig.write(GPIOC, 1 << 16 | 1 << 10);
    rig.write(GPIOC + 0x18, 1 << 8);
    assert_eq!(rig.read(GPIOC + 0x10), 1 << 8);
    rig.write_half(GPIOC + 0x1A, 1 << 8);
    assert_eq!(rig.read(GPIOC + 0x10), 0);
    rig.write(GPIOC + 0x0C, 1 << 4);
    assert_eq!(rig.read(GPIOC + 0x10), 1 << 2);
    // Open drain: a one lets go.
    rig.write(GPIOC + 0x04, 1 << 8);
    rig.write(GPIOC + 0x14, 1 << 8);
    assert_eq!(rig.chip.driven_level(Pin::new('C', 8)), None);
    assert_eq!(rig.read(GPIOC + 0x10), 1 << 2);
    assert_eq!(rig.read(GPIOA), 0xA800_0000);
}

/// Drives PC4 high at a given time.
struct EdgeAt(u64);

impl Board for EdgeAt {
    fn crystal_hz(&self) -> Option<u32> {
        Some(8_000_000)
    }
    fn output(&mut self, _: u64, _: Pin, _: Option<bool>, _: &mut Effects) {}
    fn pulse(&mut self, _: u64, _: Pin, _: Pulse, _: &mut Effects) {}
    fn spi(&mut self, _: u64, _: u8, _: SpiWord, _: &mut Effects) -> u16 {
        0xFFFF
    }
    fn analog_v(&mut self, _: u64, _: Pin) -> f64 {
        1.65
    }
    fn next_event_ns(&self) -> u64 {
        self.0
    }
    fn advance(&mut self, ns: u64, effects: &mut Effects) {
        if ns >= self.0 {
            self.0 = u64::MAX;
            effects.levels.push((Pin::new('C', 4), Some(true)));
        }
    }
}

#[test]
fn an_edge_arrives_in_its_cycle_and_stays_pending_until_cleared() {
    let mut rig = Rig::new(EdgeAt(5 * MS + 1234));
    rig.start_clocks();
    rig.write(SYSCFG + 0x0C, 2);
    rig.write(EXTI + 0x08, 1 << 4);
    rig.write(EXTI, 1 << 4);
    let due = rig.chip.next_event();
    assert_eq!(due, rig.chip.clock().cycle(5 * MS + 1234));
    rig.chip.advance(&mut rig.memory, due - 1);
    assert!(!rig.irq(10));
    rig.chip.advance(&mut rig.memory, due);
    assert!(rig.irq(10));
    rig.at = due;
    assert_eq!(rig.read(EXTI + 0x14), 1 << 4);
    rig.write(EXTI, 0);
    assert!(!rig.irq(10));
    rig.write(EXTI, 1 << 4);
    assert!(rig.irq(10));
    rig.write(EXTI + 0x14, 1 << 4);
    assert!(!rig.irq(10));
    rig.write(EXTI + 0x10, 1 << 4);
    assert!(rig.irq(10));
    rig.assert_no_bugs();
}

#[test]
fn a_line_that_listens_to_another_port_hears_nothing() {
    let mut rig = Rig::new(EdgeAt(5 * MS));
    rig.start_clocks();
    rig.write(SYSCFG + 0x0C, 1);
    rig.write(EXTI + 0x08, 1 << 4);
    rig.write(EXTI, 1 << 4);
    rig.pass(6 * MS);
    assert_eq!(rig.read(EXTI + 0x14), 0);
}

#[test]
fn the_converter_takes_its_time_and_reads_half_scale() {
    let mut rig = Rig::new(EdgeAt(u64::MAX));
    rig.start_clocks();
    rig.mode(GPIOC, 0, 3);
    rig.write(ADC + 0x304, 1 << 16);
    rig.write(ADC + 0x0C, 7);
    rig.write(ADC + 0x34, 10);
    rig.write(ADC + 0x08, 1);
    rig.pass(4 * US);
    rig.write(ADC + 0x08, 1 | 1 << 30);
    let start = rig.at;
    rig.wait_for(ADC, 2);
    // 492 cycles of 21 MHz.
    assert!((492 * 8..492 * 8 + 16).contains(&(rig.at - start)), "{}", rig.at - start);
    assert_eq!(rig.read(ADC + 0x4C), 2048);
    assert_eq!(rig.read(ADC) & 2, 0);
    rig.assert_no_bugs();
}

#[test]
fn the_converter_feeds_its_stream_and_no_other() {
    let mut rig = Rig::new(EdgeAt(u64::MAX));
    rig.start_clocks();
    rig.mode(GPIOC, 0, 3);
    rig.write(ADC + 0x34, 10);
    rig.write(ADC + 0x08, 1 | 1 << 8);
    rig.pass(4 * US);
    let buffer = 0x2000_0100;
    // Halves, memory increments; stream 4 channel 0 is the converter's, stream 1 is nobody's.
    rig.stream(DMA2, 1, 1 << 10 | 1 << 11 | 1 << 13, 1, ADC + 0x4C, buffer + 8);
    rig.start_stream(DMA2, 1);
    assert!(rig.has_bug("no peripheral asks on DMA2 stream 1 channel 0"));
    rig.stream(DMA2, 4, 1 << 10 | 1 << 11 | 1 << 13, 1, ADC + 0x4C, buffer);
    rig.start_stream(DMA2, 4);
    rig.set(ADC + 0x08, 1 << 30);
    rig.pass(100 * US);
    assert_eq!(rig.get(buffer, 2), [0x00, 0x08]);
    assert_eq!(rig.stream_flags(DMA2, 4), 0x30);
    assert!(rig.stream_on(DMA2, 1) && !rig.stream_on(DMA2, 4));
}

#[test]
fn a_reset_of_the_core_keeps_its_cause_and_lets_the_pins_go() {
    let mut rig = Rig::new(SpeedyBeeF405V3::new());
    rig.start_clocks();
    rig.mode(GPIOC, 8, 1);
    assert!(rig.chip.led());
    rig.write(RCC + 0x74, 1 << 24);
    rig.chip.request_reset();
    assert!(rig.chip.take_reset() && !rig.chip.take_reset());
    let at = rig.at;
    rig.chip.reset(&mut rig.memory, at);
    assert!(!rig.chip.led());
    assert_eq!(rig.read(RCC + 0x74) & 0xFE00_0000, 1 << 28 | 1 << 26);
    assert_eq!(rig.chip.clock().rates().hclk_hz, 16_000_000);
    assert_eq!(rig.read(RCC + 0x30), 0x0010_0000);
}

/// RM0090 sections 12.2.3 and 39.
#[test]
fn events_pass_by_the_pending_register_and_the_factory_left_its_words() {
    let mut rig = bare();
    rig.start_clocks();
    rig.write(EXTI + 4, 1 << 4);
    rig.write(EXTI + 0x10, 1 << 4);
    assert!(emulator::bus::Peripherals::take_event(&mut rig.chip));
    assert!(!emulator::bus::Peripherals::take_event(&mut rig.chip));
    assert_eq!(rig.read(EXTI + 0x14), 0);

    assert_eq!(rig.read(0x1FFF_7A20) >> 16, 1024, "flash, KiB");
    let identity = [0x1FFF_7A10, 0x1FFF_7A14, 0x1FFF_7A18].map(|word| rig.read(word));
    assert!(identity.iter().all(|word| ![0, u32::MAX].contains(word)));
    assert!(rig.try_read(0x1FFF_0000).expect_err("the boot loader").to_string().contains("boot loader"));
    rig.write(PWR, 1 << 8 | 1 << 14);
    rig.write(0x4000_2808, 1 << 10);
    assert!(rig.has_bug("RTC is set to wake"), "{:?}", rig.bugs());
}

/// ES0182, "Delay after an RCC peripheral clock enabling".
#[test]
fn a_clock_takes_a_moment_to_come() {
    for (gate, bit, register, cycles) in [(0x30, 1, GPIOB + 0x14, 2), (0x40, 2, TIM4 + 0x2C, 5)] {
        for late in [false, true] {
            let mut rig = bare();
            rig.start_clocks();
            rig.clear(RCC + gate, 1 << bit);
            rig.set(RCC + gate, 1 << bit);
            // The access is four cycles later by itself.
            rig.at = rig.at + cycles - 5 + u64::from(late);
            rig.write(register, 1);
            assert_eq!(rig.has_bug("just switched on"), !late, "{register:#x}");
            assert_eq!(rig.read(register) == 1, late, "{register:#x}");
        }
    }
}

//! The memory map of the peripherals (RM0090 table 1), their clock gates and their interrupts (table 62).

use super::clock::Apb;
use super::factory;

/// A peripheral. Numbers count from zero: `Timer(3)` is TIM4.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Block {
    Timer(u8),
    Rtc,
    Wwdg,
    Iwdg,
    Spi(u8),
    Usart(u8),
    Pwr,
    Adc,
    Syscfg,
    Exti,
    Gpio(u8),
    Crc,
    Rcc,
    Flash,
    Dma(u8),
    BackupSram,
    Rng,
    Debug,
}

/// What lies at an address.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Place {
    /// A peripheral and the offset into its registers.
    Block(Block, u32),
    /// Flash memory: programming.
    FlashMemory(u32),
    /// What the factory wrote: identity, size of flash, calibration.
    Factory(u32),
    /// Something on the chip that is not emulated, by name.
    Absent(&'static str),
    /// Nothing.
    Nothing,
}

/// Finds what lies at `address`.
pub(crate) fn place(address: u32) -> Place {
    let block = match address >> 10 {
        n @ 0x10_0000..=0x10_0008 => Block::Timer((n - 0x10_0000) as u8 + 1).renumbered(),
        0x10_000A => Block::Rtc,
        0x10_000B => Block::Wwdg,
        0x10_000C => Block::Iwdg,
        0x10_000E => Block::Spi(1),
        0x10_000F => Block::Spi(2),
        n @ 0x10_0011..=0x10_0014 => Block::Usart((n - 0x10_0010) as u8),
        0x10_001C => Block::Pwr,
        0x10_0040 => Block::Timer(0),
        0x10_0041 => Block::Timer(7),
        0x10_0044 => Block::Usart(0),
        0x10_0045 => Block::Usart(5),
        0x10_0048 => Block::Adc,
        0x10_004C => Block::Spi(0),
        0x10_004E => Block::Syscfg,
        0x10_004F => Block::Exti,
        n @ 0x10_0050..=0x10_0052 => Block::Timer((n - 0x10_0050) as u8 + 8),
        n @ 0x10_0080..=0x10_0088 => Block::Gpio((n - 0x10_0080) as u8),
        0x10_008C => Block::Crc,
        0x10_008E => Block::Rcc,
        0x10_008F => Block::Flash,
        0x10_0090..=0x10_0093 => Block::BackupSram,
        0x10_0098 => Block::Dma(0),
        0x10_0099 => Block::Dma(1),
        0x14_0182 => Block::Rng,
        0x38_0108 => Block::Debug,
        0x02_0000..=0x02_03FF => return Place::FlashMemory(address & 0x000F_FFFF),
        _ if factory::BYTES.contains(&address) => return Place::Factory(address - factory::BYTES.start),
        n => return absent(n).map_or(Place::Nothing, Place::Absent),
    };
    let mask = if block == Block::BackupSram { 0xFFF } else { 0x3FF };
    Place::Block(block, address & mask)
}

/// What lies in a kibibyte of the map and is not emulated (RM0090 tables 1 and 5).
fn absent(kibibyte: u32) -> Option<&'static str> {
    Some(match kibibyte {
        0x07_FFC0..=0x07_FFDD => "system memory (the boot loader)",
        0x07_FFDE => "one-time programmable memory",
        0x07_FFF0 => "option bytes",
        0x10_000D | 0x10_0010 => "the I2S extension",
        0x10_0015 => "I2C1",
        0x10_0016 => "I2C2",
        0x10_0017 => "I2C3",
        0x10_0019 => "CAN1",
        0x10_001A => "CAN2",
        0x10_001D => "DAC",
        0x10_004B => "SDIO",
        0x10_00A0..=0x10_00A4 => "Ethernet",
        0x10_0100..=0x10_01FF => "USB OTG HS",
        0x14_0000..=0x14_00FF => "USB OTG FS",
        0x14_0140 => "DCMI",
        0x14_0180 => "CRYP",
        0x14_0181 => "HASH",
        _ => return None,
    })
}

impl Block {
    /// TIM2..TIM7 and TIM12..TIM14 lie one after the other.
    fn renumbered(self) -> Self {
        match self {
            Self::Timer(n @ 7..) => Self::Timer(n + 4),
            other => other,
        }
    }

    /// Register (0 AHB1, 1 AHB2, 2 AHB3, 3 APB1, 4 APB2) and bit of RCC that clock the block; none where it is always
    /// clocked.
    #[inline]
    pub(crate) fn gate(self) -> Option<(usize, u8)> {
        Some(match self {
            Self::Timer(0) => (4, 0),
            Self::Timer(7) => (4, 1),
            Self::Timer(n @ 1..=6) => (3, n - 1),
            Self::Timer(n @ 8..=10) => (4, n + 8),
            Self::Timer(n) => (3, n - 5),
            Self::Wwdg => (3, 11),
            Self::Spi(0) => (4, 12),
            Self::Spi(n) => (3, n + 13),
            Self::Usart(0) => (4, 4),
            Self::Usart(5) => (4, 5),
            Self::Usart(n) => (3, n + 16),
            Self::Pwr => (3, 28),
            // Each converter has a bit of its own; the common registers need any of them.
            Self::Adc => return None,
            Self::Syscfg => (4, 14),
            Self::Gpio(n) => (0, n),
            Self::Crc => (0, 12),
            Self::Dma(n) => (0, n + 21),
            Self::BackupSram => (0, 18),
            Self::Rng => (1, 6),
            Self::Rtc | Self::Iwdg | Self::Exti | Self::Rcc | Self::Flash | Self::Debug => return None,
        })
    }

    /// Name in the reference manual.
    pub(crate) fn name(self) -> String {
        match self {
            Self::Timer(n) => format!("TIM{}", n + 1),
            Self::Spi(n) => format!("SPI{}", n + 1),
            Self::Usart(n @ (3 | 4)) => format!("UART{}", n + 1),
            Self::Usart(n) => format!("USART{}", n + 1),
            Self::Gpio(n) => format!("GPIO{}", char::from(b'A' + n)),
            Self::Dma(n) => format!("DMA{}", n + 1),
            Self::Rtc => "RTC".into(),
            Self::Wwdg => "WWDG".into(),
            Self::Iwdg => "IWDG".into(),
            Self::Pwr => "PWR".into(),
            Self::Adc => "ADC".into(),
            Self::Syscfg => "SYSCFG".into(),
            Self::Exti => "EXTI".into(),
            Self::Crc => "CRC".into(),
            Self::Rcc => "RCC".into(),
            Self::Flash => "FLASH".into(),
            Self::BackupSram => "the backup SRAM".into(),
            Self::Rng => "RNG".into(),
            Self::Debug => "DBGMCU".into(),
        }
    }
}

/// Names of the clock-enable registers, by the number of [`Block::gate`].
pub(crate) const ENABLE_REGISTERS: [&str; 5] =
    ["RCC_AHB1ENR", "RCC_AHB2ENR", "RCC_AHB3ENR", "RCC_APB1ENR", "RCC_APB2ENR"];

/// Every block that a bit of RCC resets, ADC apart.
pub(crate) fn resettable() -> impl Iterator<Item = Block> {
    let some = [Block::Wwdg, Block::Pwr, Block::Syscfg, Block::Crc, Block::Rng];
    some.into_iter()
        .chain((0..14).map(Block::Timer))
        .chain((0..3).map(Block::Spi))
        .chain((0..6).map(Block::Usart))
        .chain((0..9).map(Block::Gpio))
        .chain((0..2).map(Block::Dma))
}

/// The bus a timer hangs on: TIM1, 8, 9, 10 and 11 on the fast one.
pub(crate) fn timer_bus(timer: u8) -> Apb {
    if matches!(timer, 0 | 7..=10) { Apb::Two } else { Apb::One }
}

/// The bus of a serial port: USART1 and USART6 on the fast one.
pub(crate) fn usart_bus(usart: u8) -> Apb {
    if matches!(usart, 0 | 5) { Apb::Two } else { Apb::One }
}

/// The bus of an SPI: SPI1 on the fast one.
pub(crate) fn spi_bus(spi: u8) -> Apb {
    if spi == 0 { Apb::Two } else { Apb::One }
}

const DMA_IRQS: [[u8; 8]; 2] = [[11, 12, 13, 14, 15, 16, 17, 47], [56, 57, 58, 59, 60, 68, 69, 70]];
/// Interrupt lines of a DMA controller, as bits.
pub(crate) const DMA_LINES: [u128; 2] = [lines(DMA_IRQS[0]), lines(DMA_IRQS[1])];

/// Interrupt of a DMA stream.
pub(crate) fn dma_irq(controller: usize, stream: usize) -> u8 {
    DMA_IRQS[controller & 1][stream & 7]
}

const fn lines(irqs: [u8; 8]) -> u128 {
    let (mut lines, mut stream) = (0, 0);
    while stream < irqs.len() {
        lines |= 1 << irqs[stream];
        stream += 1;
    }
    lines
}

/// Interrupt of a serial port.
pub(crate) const USART_IRQS: [u8; 6] = [37, 38, 39, 52, 53, 71];
/// Interrupt of an SPI.
pub(crate) const SPI_IRQS: [u8; 3] = [35, 36, 51];
/// Interrupts of a timer: update, capture/compare, trigger and commutation, break.
pub(crate) const TIMER_IRQS: [[u8; 4]; 14] = [
    [25, 27, 26, 24],
    [28; 4],
    [29; 4],
    [30; 4],
    [50; 4],
    [54; 4],
    [55; 4],
    [44, 46, 45, 43],
    [24; 4],
    [25; 4],
    [26; 4],
    [43; 4],
    [44; 4],
    [45; 4],
];

#[cfg(test)]
mod tests {
    use super::{Block, Place, place};

    #[test]
    fn blocks_lie_where_the_manual_says() {
        for (address, block) in [
            (0x4000_0000, Block::Timer(1)),
            (0x4000_0C24, Block::Timer(4)),
            (0x4000_1400, Block::Timer(6)),
            (0x4000_1800, Block::Timer(11)),
            (0x4000_2000, Block::Timer(13)),
            (0x4000_3000, Block::Iwdg),
            (0x4000_4400, Block::Usart(1)),
            (0x4000_5000, Block::Usart(4)),
            (0x4001_1000, Block::Usart(0)),
            (0x4001_1400, Block::Usart(5)),
            (0x4001_3000, Block::Spi(0)),
            (0x4001_3C00, Block::Exti),
            (0x4001_4800, Block::Timer(10)),
            (0x4002_0800, Block::Gpio(2)),
            (0x4002_3800, Block::Rcc),
            (0x4002_3C00, Block::Flash),
            (0x4002_6400, Block::Dma(1)),
            (0xE004_2000, Block::Debug),
        ] {
            let Place::Block(found, _) = place(address) else { panic!("{address:#x} has no block") };
            assert_eq!(found, block, "{address:#x}");
        }
        assert_eq!(place(0x4000_5400), Place::Absent("I2C1"));
        assert_eq!(place(0x1FFF_7A22), Place::Factory(0x12));
        assert_eq!(place(0x4002_7000), Place::Nothing);
        assert_eq!(Block::Timer(3).gate(), Some((3, 2)));
        assert_eq!(Block::Timer(11).gate(), Some((3, 6)));
        assert_eq!(Block::Timer(8).gate(), Some((4, 16)));
        assert_eq!(Block::Usart(1).gate(), Some((3, 17)));
        assert_eq!(Block::Spi(1).gate(), Some((3, 14)));
    }
}

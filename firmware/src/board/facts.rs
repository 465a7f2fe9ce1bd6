//! Everything that is true of this board only: pins, clocks, DMA streams, interrupts and their priorities.
//!
//! Board: SpeedyBee F405 V3 (STM32F405RG, 8 MHz crystal). Sources: its pin map as flight-controller projects publish
//! it, the data sheet DS8626 (alternate functions, table 9) and the reference manual RM0090 (DMA requests, tables 42
//! and 43). To port to another F405 board, change this file; `docs/porting.md` walks through it.
//!
//! # Pins
//!
//! | function | pins | state |
//! |---|---|---|
//! | link | USART1: PA9 TX, PA10 RX | in use |
//! | motors 1..4 | PB6, PB7, PB8, PB9 (TIM4 CH1..4) | held low; no driver yet |
//! | gyro BMI270 | SPI1: PA5 SCK, PA6 MISO, PA7 MOSI, PA4 CS; PC4 data ready | reserved; no driver yet |
//! | battery, current | PC0 (ADC1 channel 10), PC1 | battery in use |
//! | LED, beeper | PC8, PC5 | LED in use |
//! | debug probe | PA13 SWDIO, PA14 SWCLK | never touched |
//! | kill switch | none on this board | the host's stop command is the kill |
//!
//! # DMA streams
//!
//! | stream | owner |
//! |---|---|
//! | DMA2 stream 2, channel 4 | USART1 RX |
//! | DMA2 stream 7, channel 4 | USART1 TX |
//! | DMA2 streams 0 and 3 | reserved: SPI1 (gyro) |
//! | DMA2 stream 4 | reserved: ADC1 (stream 0 would collide with SPI1) |
//! | DMA1 stream 6 | reserved: TIM4 update (motor burst) |
//!
//! # Interrupt priorities (0 is the most urgent)
//!
//! | priority | interrupt | why |
//! |---|---|---|
//! | 0, 1 | reserved: gyro data ready, motor burst | must time-stamp within a microsecond |
//! | 2 | TIM5, the time driver | wakes the control tick |
//! | 3 | control tick (a software-pended interrupt) | above everything that serves the link |
//! | 6 | USART1, DMA2 | the link may wait for a tick |
//! | thread | link tasks and supervision | never urgent |

use embassy_stm32::gpio::Level;
use embassy_stm32::interrupt::{InterruptExt, Priority};
use embassy_stm32::rcc::{
    AHBPrescaler, APBPrescaler, Hse, HseMode, Pll, PllMul, PllPDiv, PllPreDiv, PllQDiv, PllSource, Sysclk,
};
use embassy_stm32::time::Hertz;
use embassy_stm32::{Peri, Peripherals, bind_interrupts, dma, interrupt, peripherals, usart};

/// Peripherals and pins by what they are for.
pub(super) struct Parts {
    pub(super) link: LinkParts,
    pub(super) battery: BatteryParts,
    pub(super) led: Peri<'static, peripherals::PC8>,
}

/// The serial port of the link.
pub(super) struct LinkParts {
    pub(super) uart: Peri<'static, peripherals::USART1>,
    pub(super) tx: Peri<'static, peripherals::PA9>,
    pub(super) rx: Peri<'static, peripherals::PA10>,
    pub(super) tx_dma: Peri<'static, peripherals::DMA2_CH7>,
    pub(super) rx_dma: Peri<'static, peripherals::DMA2_CH2>,
}

/// The converter that measures the battery.
pub(super) struct BatteryParts {
    pub(super) adc: Peri<'static, peripherals::ADC1>,
    pub(super) pin: Peri<'static, peripherals::PC0>,
}

impl Parts {
    /// Sorts the chip's peripherals into roles.
    pub(super) fn new(p: Peripherals) -> Self {
        Self {
            link: LinkParts { uart: p.USART1, tx: p.PA9, rx: p.PA10, tx_dma: p.DMA2_CH7, rx_dma: p.DMA2_CH2 },
            battery: BatteryParts { adc: p.ADC1, pin: p.PC0 },
            led: p.PC8,
        }
    }
}

bind_interrupts!(pub(super) struct Irqs {
    USART1 => usart::InterruptHandler<peripherals::USART1>;
    DMA2_STREAM7 => dma::InterruptHandler<peripherals::DMA2_CH7>;
    DMA2_STREAM2 => dma::InterruptHandler<peripherals::DMA2_CH2>;
});

/// Link speed [baud]. At 84 MHz the divider gives 923,077: 0.16 % fast, and a UART tolerates about 2 %.
pub(super) const LINK_BAUD: u32 = 921_600;

/// Level that lights the LED.
pub(super) const LED_ON: Level = Level::Low;
/// Level that darkens it.
pub(super) const LED_OFF: Level = Level::High;

/// The four motor outputs are pins 6..=9 of port B.
pub(super) const MOTOR_PORT: embassy_stm32::pac::gpio::Gpio = embassy_stm32::pac::GPIOB;
/// See [`MOTOR_PORT`].
pub(super) const MOTOR_PINS: [usize; 4] = [6, 7, 8, 9];

/// ADC1's channel on the battery pin.
pub(super) const BATTERY_CHANNEL: u8 = 10;
/// Battery volts per ADC count: 3.3 V full scale over 4095 counts, behind a divider of 11.
pub(super) const BATTERY_VOLTS_PER_COUNT: f32 = 11.0 * 3.3 / 4095.0;

/// Priority of the time driver.
const TIME_PRIORITY: Priority = Priority::P2;
/// Priority of the control tick.
pub(super) const CONTROL_PRIORITY: Priority = Priority::P3;
/// Priority of the link's interrupts.
const LINK_PRIORITY: Priority = Priority::P6;

/// 8 MHz crystal → 168 MHz core, 42 and 84 MHz buses, 48 MHz for USB and the like.
///
/// PLL: 8 MHz / 4 × 168 = 336 MHz; /2 = 168 MHz for the core, /7 = 48 MHz (RM0090 section 7.3.2).
pub(super) fn clocks() -> embassy_stm32::Config {
    let mut config = embassy_stm32::Config::default();
    config.rcc.hse = Some(Hse { freq: Hertz(8_000_000), mode: HseMode::Oscillator });
    config.rcc.pll_src = PllSource::HSE;
    config.rcc.pll = Some(Pll {
        prediv: PllPreDiv::DIV4,
        mul: PllMul::MUL168,
        divp: Some(PllPDiv::DIV2),
        divq: Some(PllQDiv::DIV7),
        divr: None,
    });
    config.rcc.sys = Sysclk::PLL1_P;
    config.rcc.ahb_pre = AHBPrescaler::DIV1;
    config.rcc.apb1_pre = APBPrescaler::DIV4;
    config.rcc.apb2_pre = APBPrescaler::DIV2;
    config.dma_interrupt_priority = LINK_PRIORITY;
    config
}

/// Gives every interrupt in use its priority; whatever is left out would have the highest.
pub(super) fn set_priorities() {
    interrupt::TIM5.set_priority(TIME_PRIORITY);
    interrupt::USART1.set_priority(LINK_PRIORITY);
    interrupt::DMA2_STREAM7.set_priority(LINK_PRIORITY);
    interrupt::DMA2_STREAM2.set_priority(LINK_PRIORITY);
}

//! Everything that is true of this board only: pins, clocks, DMA streams, interrupts and their priorities.
//!
//! Board: SpeedyBee F405 V3 (STM32F405RG, 8 MHz crystal). Sources: its pin map as flight-controller projects publish
//! it, the data sheet DS8626 (alternate functions, table 9) and the reference manual RM0090 (DMA requests, tables 42
//! and 43). To port to another F405 board, change this file; `docs/porting.md` walks through it.
//!
//! # Pins
//!
//! | function | pins |
//! |---|---|
//! | link | USART1: PA9 TX, PA10 RX |
//! | motors 1..4 | PB6, PB7, PB8, PB9: TIM4 channels 1..4 |
//! | gyro BMI270 | SPI1: PA5 SCK, PA6 MISO, PA7 MOSI, PA4 chip-select; PC4 data ready |
//! | battery | PC0 (ADC1 channel 10); the current sensor on PC1 is not used |
//! | LED | PC8; the beeper on PC5 is not used |
//! | debug probe | PA13 SWDIO, PA14 SWCLK: never touched |
//! | radio receiver, for the kill switch | USART2: PA3 RX; PA2, its TX, is not used |
//!
//! # DMA streams
//!
//! | stream | owner |
//! |---|---|
//! | DMA1 stream 5, channel 4 | USART2 RX |
//! | DMA1 stream 6, channel 2 | TIM4 update: motors. It is USART2's for sending, too, which therefore never sends |
//! | DMA2 stream 2, channel 4 | USART1 RX |
//! | DMA2 stream 7, channel 4 | USART1 TX |
//! | DMA2 stream 4 | reserved: ADC1 (its other one, stream 0, is SPI1's) |
//! | DMA2 streams 0 and 3 | free: SPI1 is polled |
//!
//! # Timers
//!
//! | timer | owner |
//! |---|---|
//! | TIM4 | motors |
//! | TIM5 | the clock and all waits (the HAL's time driver) |
//! | TIM7 | opens the gyro's data-ready line for the next edge; the control tick where that stays away |
//!
//! # Interrupt priorities (0 is the most urgent)
//!
//! | priority | interrupt | why |
//! |---|---|---|
//! | 0 | EXTI4: gyro data ready | stamps the edge and closes its line; no critical section masks it |
//! | 0 | PVD: the chip's supply falls | ends the run while the chip still works |
//! | 0 | DMA1 stream 6: motor frame done | must stop the timer within a bit, 1.67 µs |
//! | 1 | I2C3_ER, pended by software: control tick; TIM7: the same without a sample, and the gyro's line opened | above everything that serves the link |
//! | 2 | TIM5 | wakes tasks; must not lag by 32 ms |
//! | 6 | USART1, DMA2 stream 7: sending | the link may wait for a tick; receiving needs no interrupt |
//! | thread | link tasks, supervision, set-up of the gyro | never urgent |
//!
//! A critical section masks 1 and below (`board::critical`).

use embassy_stm32::gpio::Level;
use embassy_stm32::interrupt::{InterruptExt, Priority};
use embassy_stm32::pac;
use embassy_stm32::rcc::{
    AHBPrescaler, APBPrescaler, Hse, HseMode, Pll, PllMul, PllPDiv, PllPreDiv, PllQDiv, PllSource, Sysclk,
};
use embassy_stm32::time::Hertz;
use embassy_stm32::{Peri, Peripherals, bind_interrupts, dma, interrupt, peripherals, usart};

/// Peripherals and pins by what they are for.
pub(super) struct Parts {
    pub(super) link: LinkParts,
    pub(super) battery: BatteryParts,
    pub(super) gyro: GyroParts,
    pub(super) motors: MotorParts,
    pub(super) receiver: ReceiverParts,
    pub(super) late_timer: Peri<'static, peripherals::TIM7>,
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

/// The serial port of the radio receiver.
pub(super) struct ReceiverParts {
    pub(super) uart: Peri<'static, peripherals::USART2>,
    pub(super) rx: Peri<'static, peripherals::PA3>,
    pub(super) dma: Peri<'static, peripherals::DMA1_CH5>,
}

/// The converter that measures the battery.
pub(super) struct BatteryParts {
    pub(super) adc: Peri<'static, peripherals::ADC1>,
    pub(super) pin: Peri<'static, peripherals::PC0>,
}

/// The inertial sensor.
pub(super) struct GyroParts {
    pub(super) bus: GyroBusParts,
    pub(super) data_ready: Peri<'static, peripherals::PC4>,
}

/// Its bus.
pub(super) struct GyroBusParts {
    pub(super) spi: Peri<'static, peripherals::SPI1>,
    pub(super) clock: Peri<'static, peripherals::PA5>,
    pub(super) miso: Peri<'static, peripherals::PA6>,
    pub(super) mosi: Peri<'static, peripherals::PA7>,
    pub(super) select: Peri<'static, peripherals::PA4>,
}

/// What the motor outputs own. They work on registers; holding these keeps everyone else off them.
#[expect(dead_code, reason = "owned, never read")]
pub(super) struct MotorParts {
    pub(super) timer: Peri<'static, peripherals::TIM4>,
    pub(super) dma: Peri<'static, peripherals::DMA1_CH6>,
    pub(super) motor_1: Peri<'static, peripherals::PB6>,
    pub(super) motor_2: Peri<'static, peripherals::PB7>,
    pub(super) motor_3: Peri<'static, peripherals::PB8>,
    pub(super) motor_4: Peri<'static, peripherals::PB9>,
}

impl Parts {
    /// Sorts the chip's peripherals into roles.
    pub(super) fn new(p: Peripherals) -> Self {
        Self {
            link: LinkParts { uart: p.USART1, tx: p.PA9, rx: p.PA10, tx_dma: p.DMA2_CH7, rx_dma: p.DMA2_CH2 },
            battery: BatteryParts { adc: p.ADC1, pin: p.PC0 },
            gyro: GyroParts {
                bus: GyroBusParts { spi: p.SPI1, clock: p.PA5, miso: p.PA6, mosi: p.PA7, select: p.PA4 },
                data_ready: p.PC4,
            },
            motors: MotorParts {
                timer: p.TIM4,
                dma: p.DMA1_CH6,
                motor_1: p.PB6,
                motor_2: p.PB7,
                motor_3: p.PB8,
                motor_4: p.PB9,
            },
            receiver: ReceiverParts { uart: p.USART2, rx: p.PA3, dma: p.DMA1_CH5 },
            late_timer: p.TIM7,
            led: p.PC8,
        }
    }
}

bind_interrupts!(pub(super) struct Irqs {
    // Never enabled at the port; the driver unmasks it all the same.
    USART1 => usart::InterruptHandler<peripherals::USART1>;
    DMA2_STREAM7 => dma::InterruptHandler<peripherals::DMA2_CH7>;
});

/// Link speed [baud]. At 84 MHz the divider gives 923,077: 0.16 % fast, and a UART tolerates about 2 %.
pub(super) const LINK_BAUD: u32 = 921_600;

/// The link's serial port.
pub(super) const LINK_UART: pac::usart::Usart = pac::USART1;
/// Function of its pins.
pub(super) const LINK_ALTERNATE_FUNCTION: u8 = 7;
/// Controller, ...
pub(super) const LINK_DMA: pac::dma::Dma = pac::DMA2;
/// ... stream ...
pub(super) const LINK_DMA_STREAM: usize = 2;
/// ... and channel that take what it receives.
pub(super) const LINK_DMA_CHANNEL: u8 = 4;

/// The radio receiver's serial port.
pub(super) const RECEIVER_UART: pac::usart::Usart = pac::USART2;
/// Clock of its bus, Hz. For the receiver's 420,000 baud the divider is 100: exact.
pub(super) const RECEIVER_CLOCK_HZ: u32 = 42_000_000;
/// Function of its pin.
pub(super) const RECEIVER_ALTERNATE_FUNCTION: u8 = 7;
/// Controller, ...
pub(super) const RECEIVER_DMA: pac::dma::Dma = pac::DMA1;
/// ... stream ...
pub(super) const RECEIVER_DMA_STREAM: usize = 5;
/// ... and channel that take what it sends.
pub(super) const RECEIVER_DMA_CHANNEL: u8 = 4;

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

/// Timer of the motors.
pub(super) const MOTOR_TIMER: pac::timer::TimGp16 = pac::TIM4;
/// The motors' frame begins this long after the gyro's edge, whatever the tick took, µs: constant latency is worth more
/// than a few microseconds less. On the virtual board, with pessimistic timing of the processor and its buses, the frame is
/// ready before that in every tick of a flight, a maneuver's first one and a saturated link included; with 26.7 µs for the
/// frame its last bit ends at 99.3.
pub(super) const MOTOR_START_US: u32 = 72;
/// Function of the motor pins that connects them to it.
pub(super) const MOTOR_ALTERNATE_FUNCTION: u8 = 2;
/// Stream of DMA1 that serves the timer's updates, ...
pub(super) const MOTOR_DMA_STREAM: usize = 6;
/// ... and its channel.
pub(super) const MOTOR_DMA_CHANNEL: u8 = 2;
/// Where a DMA burst to the timer begins: its first compare register, counted in words.
pub(super) const MOTOR_FIRST_COMPARE: u8 = 0x34 / 4;
/// Zero-throttle frames before the motors count as ready, once the battery is there: 3 s. Speed controllers sound their
/// melody for a second or two and then want zero throttle for up to a second before they arm.
pub(super) const MOTOR_ARMING_FRAMES: u32 = 2400;

/// Function of the gyro bus's pins.
pub(super) const SPI_ALTERNATE_FUNCTION: u8 = 5;
/// The gyro's data-ready pin is number 4 ...
pub(super) const EDGE_LINE: usize = 4;
/// ... of port C, as the system configuration counts ports.
pub(super) const EDGE_PORT: u8 = 2;
/// From the axes of the gyro chip, as it is mounted, to body axes, forward-left-up: the same on this board.
pub(super) const fn to_body_axes([x, y, z]: [f32; 3]) -> [f32; 3] {
    [x, y, z]
}

/// Processor clock, MHz: what the cycle counter counts.
pub(super) const CORE_MHZ: u32 = 168;
/// Clock of the timers on the slower bus, MHz: TIM4, TIM7.
pub(super) const TIMER_MHZ: u16 = 84;

/// The interrupt that runs the control tick, pended by software. Its peripheral is not in use.
pub(super) const CONTROL_INTERRUPT: interrupt::Interrupt = interrupt::I2C3_ER;

/// Priority of what must not wait for anything.
const STAMP_PRIORITY: Priority = Priority::P0;
/// Priority of the control tick, the most urgent that a critical section masks.
const CONTROL_PRIORITY: Priority = Priority::P1;
/// Priority of the time driver.
const TIME_PRIORITY: Priority = Priority::P2;
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
    // Of every stream; `set_priorities` then raises the motors'.
    config.dma_interrupt_priority = LINK_PRIORITY;
    // Keeps the cycle counter running while the processor sleeps; it measures latencies and load.
    config.enable_debug_during_sleep = true;
    config
}

/// Makes 2 MHz for the PLL of the internal oscillator's 16, as `clocks` does of the crystal's 8.
pub(super) const PREDIV_OF_INTERNAL_OSCILLATOR: PllPreDiv = PllPreDiv::DIV8;

/// Gives every interrupt in use its priority; whatever is left out would have the highest.
pub(super) fn set_priorities() {
    interrupt::EXTI4.set_priority(STAMP_PRIORITY);
    interrupt::PVD.set_priority(STAMP_PRIORITY);
    interrupt::DMA1_STREAM6.set_priority(STAMP_PRIORITY);
    CONTROL_INTERRUPT.set_priority(CONTROL_PRIORITY);
    interrupt::TIM7.set_priority(CONTROL_PRIORITY);
    interrupt::TIM5.set_priority(TIME_PRIORITY);
    interrupt::USART1.set_priority(LINK_PRIORITY);
    interrupt::DMA2_STREAM7.set_priority(LINK_PRIORITY);
}

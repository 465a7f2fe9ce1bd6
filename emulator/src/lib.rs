//! A deterministic virtual STM32F405 that runs the ELF that gets flashed, in virtual time.
//!
//! # The path of the data
//!
//! ```text
//!            ELF ──► memory (flash, SRAM, CCM) ◄──── DMA ────┐
//!                        ▲                                   │
//!   machine: core ───────┴──► bus ──► chip: RCC, GPIO, EXTI, timers, DMA, USART, SPI, ADC, IWDG, …
//!     (ARMv7E-M + FPv4-SP)     │         │ pins, pulses, bytes
//!     NVIC, SysTick, DWT ◄─ interrupt    ▼
//!                             lines   devices: BMI270, DShot speed controllers, battery
//! ```
//!
//! One thread, one clock: time is counted in cycles of the core clock ([`bus::Cycle`]). Nothing depends on the host's
//! time, so that the same image and the same inputs give the same bytes. [`Machine`] puts the parts together; the core
//! is checked against QEMU by the programs in `oracle/`.
pub mod boards;
pub mod bus;
pub mod chip;
pub mod core;
pub mod devices;
pub mod log;
pub mod machine;
pub mod memory;

pub use machine::{Machine, NoPeripherals, Stop};

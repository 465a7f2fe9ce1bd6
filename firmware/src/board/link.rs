//! The serial link. DMA writes what the host sends into a ring, and the control tick takes it from there; what goes to the
//! host travels through a pipe and a task that has it sent by DMA.
//!
//! Deadline: the ring holds 11 ms of a saturated line and the control tick empties it every 1.25 ms. Reception is never
//! stopped and never started again: noise, a bad stop bit or an overrun spoil a frame, which its checksum shows, and are
//! counted. A driver that stops for them would have to find a moment to start in which no byte arrives, and a host that
//! talks without a pause has none.

use core::sync::atomic::{AtomicU8, AtomicU32, Ordering};

use embassy_stm32::gpio::{AfType, Flex, Pull};
use embassy_stm32::mode::Async;
use embassy_stm32::pac::dma::vals::{Dir, Pl, Size};
use embassy_stm32::usart::{self, UartTx};
use embassy_stm32::{Peri, peripherals};
use embassy_sync::blocking_mutex::raw::CriticalSectionRawMutex;
use embassy_sync::pipe::Pipe;
use embassy_time::{Duration, with_timeout};

use super::facts::{
    Irqs, LINK_ALTERNATE_FUNCTION, LINK_BAUD, LINK_DMA, LINK_DMA_CHANNEL, LINK_DMA_STREAM, LINK_UART,
    LinkParts,
};
use super::watchdog::{self, Party};

/// Bytes from the control tick, on their way to the host.
pub(super) static OUTBOX: Pipe<CriticalSectionRawMutex, 1024> = Pipe::new();

/// Times at which noise, a bad stop bit or an overrun was seen.
pub(super) static RECEIVE_ERRORS: AtomicU32 = AtomicU32::new(0);
/// Bursts that could not be sent in time.
pub(super) static TRANSMIT_ERRORS: AtomicU32 = AtomicU32::new(0);

/// 11 ms of a saturated line.
const RING_BYTES: usize = 1024;
/// In main RAM: DMA cannot reach the core-coupled memory. Atomics, because somebody else writes them.
static RING: [AtomicU8; RING_BYTES] = [const { AtomicU8::new(0) }; RING_BYTES];

/// How long the sender sleeps at most before it checks in again.
const TRANSMIT_POLL: Duration = Duration::from_millis(10);
/// Longest time for one burst: 256 bytes take 2.8 ms.
const BURST_TIMEOUT: Duration = Duration::from_millis(10);

/// Sets up the serial port, which listens from now on.
///
/// # Errors
///
/// The baud rate cannot be made from the bus clock.
pub(super) fn open(parts: LinkParts) -> Result<(Receiver, UartTx<'static, Async>), usart::ConfigError> {
    let LinkParts { uart, tx, rx, tx_dma, rx_dma } = parts;
    let mut config = usart::Config::default();
    config.baudrate = LINK_BAUD;
    let tx = UartTx::new(uart, tx, tx_dma, Irqs, config)?;
    Ok((Receiver::new(rx, rx_dma), tx))
}

/// Host → control tick.
pub(super) struct Receiver {
    _pin: Flex<'static>,
    _dma: Peri<'static, peripherals::DMA2_CH2>,
    /// Place in the ring of the next byte to be taken.
    next: usize,
}

impl Receiver {
    fn new(pin: Peri<'static, peripherals::PA10>, dma: Peri<'static, peripherals::DMA2_CH2>) -> Self {
        let mut pin = Flex::new(pin);
        // With no cable the input must rest at the idle level instead of collecting noise.
        pin.set_as_af_unchecked(LINK_ALTERNATE_FUNCTION, AfType::input(Pull::Up));
        let stream = LINK_DMA.st(LINK_DMA_STREAM);
        stream.par().write_value(LINK_UART.dr().as_ptr() as u32);
        stream.m0ar().write_value(RING.as_ptr() as u32);
        stream.ndtr().write(|w| w.set_ndt(RING_BYTES as u16));
        stream.cr().write(|w| {
            w.set_chsel(LINK_DMA_CHANNEL);
            w.set_dir(Dir::PERIPHERAL_TO_MEMORY);
            w.set_circ(true);
            w.set_minc(true);
            w.set_msize(Size::BITS8);
            w.set_psize(Size::BITS8);
            w.set_pl(Pl::HIGH);
            w.set_en(true);
        });
        LINK_UART.cr3().modify(|w| w.set_dmar(true));
        LINK_UART.cr1().modify(|w| w.set_re(true));
        Self { _pin: pin, _dma: dma, next: 0 }
    }

    /// Takes bytes that have arrived and returns how many. From the control tick.
    pub(super) fn take(&mut self, into: &mut [u8]) -> usize {
        let status = LINK_UART.sr().read();
        if status.ore() || status.ne() || status.fe() {
            RECEIVE_ERRORS.fetch_add(1, Ordering::Relaxed);
            // Status, then data, clears the flags. Where a byte waits the stream reads it, which does as well.
            if !status.rxne() {
                let _ = LINK_UART.dr().read();
            }
        }
        let left = usize::from(LINK_DMA.st(LINK_DMA_STREAM).ndtr().read().ndt());
        let written = RING_BYTES.saturating_sub(left) % RING_BYTES;
        let mut taken = 0;
        for slot in into {
            if self.next == written {
                break;
            }
            *slot = RING.get(self.next).map_or(0, |byte| byte.load(Ordering::Relaxed));
            self.next = (self.next + 1) % RING_BYTES;
            taken += 1;
        }
        taken
    }
}

/// Outbox → host.
#[embassy_executor::task]
pub(super) async fn transmit(mut tx: UartTx<'static, Async>) {
    let mut buffer = [0; 256];
    loop {
        watchdog::check_in(Party::LinkTransmit);
        let Ok(count) = with_timeout(TRANSMIT_POLL, OUTBOX.read(&mut buffer)).await else {
            continue;
        };
        let burst = buffer.get(..count).unwrap_or_default();
        if !matches!(with_timeout(BURST_TIMEOUT, tx.write(burst)).await, Ok(Ok(()))) {
            TRANSMIT_ERRORS.fetch_add(1, Ordering::Relaxed);
        }
    }
}

//! The serial link. What the host sends comes through a [ring](super::ring); what goes to the host travels through a pipe and
//! a task that has it sent by DMA.
//!
//! Deadline: the ring holds 11 ms of a saturated line and the control tick empties it every 1.25 ms.

use core::sync::atomic::{AtomicU32, Ordering};

use embassy_stm32::gpio::Flex;
use embassy_stm32::mode::Async;
use embassy_stm32::pac::dma::vals::Pl;
use embassy_stm32::usart::{self, UartTx};
use embassy_stm32::{Peri, peripherals};
use embassy_sync::blocking_mutex::raw::CriticalSectionRawMutex;
use embassy_sync::pipe::Pipe;
use embassy_time::{Duration, with_timeout};

use super::facts::{
    Irqs, LINK_ALTERNATE_FUNCTION, LINK_BAUD, LINK_DMA, LINK_DMA_CHANNEL, LINK_DMA_STREAM, LINK_UART,
    LinkParts,
};
use super::ring::{Line, Ring, RingMemory};
use super::watchdog::{self, Party};

/// Bytes from the control tick, on their way to the host.
pub(super) static OUTBOX: Pipe<CriticalSectionRawMutex, 1024> = Pipe::new();

/// Times at which noise, a bad stop bit or an overrun was seen.
pub(super) static RECEIVE_ERRORS: AtomicU32 = AtomicU32::new(0);
/// Bursts that could not be sent in time.
pub(super) static TRANSMIT_ERRORS: AtomicU32 = AtomicU32::new(0);

/// 11 ms of a saturated line.
const RING_BYTES: usize = 1024;
static RING: RingMemory<RING_BYTES> = RingMemory::new();

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
    _dma: Peri<'static, peripherals::DMA2_CH2>,
    ring: Ring<RING_BYTES>,
}

impl Receiver {
    fn new(pin: Peri<'static, peripherals::PA10>, dma: Peri<'static, peripherals::DMA2_CH2>) -> Self {
        let line = Line {
            uart: LINK_UART,
            dma: LINK_DMA,
            stream: LINK_DMA_STREAM,
            channel: LINK_DMA_CHANNEL,
            priority: Pl::HIGH,
        };
        let ring = Ring::start(line, &RING, Flex::new(pin), LINK_ALTERNATE_FUNCTION);
        Self { _dma: dma, ring }
    }

    /// Takes bytes that have arrived and returns how many. From the control tick.
    pub(super) fn take(&mut self, into: &mut [u8]) -> usize {
        let taken = self.ring.take(into);
        if taken.disturbed {
            RECEIVE_ERRORS.fetch_add(1, Ordering::Relaxed);
        }
        taken.count
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

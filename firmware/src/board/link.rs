//! The serial link: DMA moves the bytes, two pipes carry them to and from the control tick.
//!
//! Deadline: the receive ring holds 11 ms of a saturated line and is emptied at least every 2 ms. No wait in here is
//! without a bound, and both tasks check in with the watchdog every round.

use core::sync::atomic::{AtomicU32, Ordering};

use embassy_stm32::mode::Async;
use embassy_stm32::usart::{self, RingBufferedUartRx, Uart, UartTx};
use embassy_sync::blocking_mutex::raw::CriticalSectionRawMutex;
use embassy_sync::pipe::Pipe;
use embassy_time::{Duration, Timer, with_timeout};
use static_cell::ConstStaticCell;

use super::facts::{Irqs, LINK_BAUD, LinkParts};
use super::watchdog::{self, Party};

/// Bytes from the host, on their way to the control tick.
pub(super) static INBOX: Pipe<CriticalSectionRawMutex, 1024> = Pipe::new();
/// Bytes from the control tick, on their way to the host.
pub(super) static OUTBOX: Pipe<CriticalSectionRawMutex, 1024> = Pipe::new();

/// Receptions that ended in noise, a bad stop bit or an overrun.
pub(super) static RECEIVE_ERRORS: AtomicU32 = AtomicU32::new(0);
/// Bursts that could not be sent in time.
pub(super) static TRANSMIT_ERRORS: AtomicU32 = AtomicU32::new(0);

/// 11 ms of a saturated line. In main RAM: DMA cannot reach the core-coupled memory.
static RING: ConstStaticCell<[u8; 1024]> = ConstStaticCell::new([0; 1024]);

/// How long received bytes may lie in the ring while the line is busy.
const RECEIVE_POLL: Duration = Duration::from_millis(2);
/// How long the sender sleeps at most before it checks in again.
const TRANSMIT_POLL: Duration = Duration::from_millis(10);
/// Longest time for one burst: 256 bytes take 2.8 ms.
const BURST_TIMEOUT: Duration = Duration::from_millis(10);
/// Pause after a reception error, so that a line held low cannot starve the other tasks.
const ERROR_PAUSE: Duration = Duration::from_millis(1);

/// Both halves of the link, ready to run.
pub(super) struct Link {
    /// For [`receive`].
    pub(super) rx: RingBufferedUartRx<'static>,
    /// For [`transmit`].
    pub(super) tx: UartTx<'static, Async>,
}

/// Sets up the serial port.
///
/// # Errors
///
/// The baud rate cannot be made from the bus clock.
pub(super) fn open(parts: LinkParts) -> Result<Link, usart::ConfigError> {
    let mut config = usart::Config::default();
    config.baudrate = LINK_BAUD;
    // With no cable the input must rest at the idle level instead of collecting noise.
    config.rx_pull = embassy_stm32::gpio::Pull::Up;
    let uart = Uart::new(parts.uart, parts.rx, parts.tx, parts.tx_dma, parts.rx_dma, Irqs, config)?;
    let (tx, rx) = uart.split();
    Ok(Link { rx: rx.into_ring_buffered(RING.take()), tx })
}

/// Host → inbox.
#[embassy_executor::task]
pub(super) async fn receive(mut rx: RingBufferedUartRx<'static>) {
    let mut buffer = [0; 256];
    loop {
        watchdog::check_in(Party::LinkReceive);
        match with_timeout(RECEIVE_POLL, rx.read(&mut buffer)).await {
            Ok(Ok(count)) => deliver(buffer.get(..count).unwrap_or_default()).await,
            Ok(Err(_)) => {
                RECEIVE_ERRORS.fetch_add(1, Ordering::Relaxed);
                Timer::after(ERROR_PAUSE).await;
            }
            // Nothing new, or a busy line: look into the ring again.
            Err(_) => {}
        }
    }
}

/// Puts bytes into the inbox; bytes the control tick did not take within two rounds are dropped and counted.
async fn deliver(bytes: &[u8]) {
    let mut rest = bytes;
    for _ in 0..3 {
        let taken = INBOX.try_write(rest).unwrap_or(0);
        rest = rest.get(taken..).unwrap_or_default();
        if rest.is_empty() {
            return;
        }
        if taken == 0 {
            Timer::after(RECEIVE_POLL).await;
        }
    }
    RECEIVE_ERRORS.fetch_add(1, Ordering::Relaxed);
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

//! The serial link: DMA moves the bytes, two pipes carry them to and from the control tick.
//!
//! Deadline: the receive ring holds 11 ms of a saturated line and is emptied every millisecond. No wait in here is without
//! a bound, and both tasks check in with the watchdog every round.
//!
//! Reception never stops: a disturbed byte is counted and goes into the ring like any other, where the checksum of its
//! frame finds it. The HAL's ring would stop its stream at every such byte and start it again with address and counter
//! not set anew, which the reference manual does not promise to keep in step (on the virtual board it does not), and on
//! a busy line it would find an overrun at each new start and stop again.
#![allow(unsafe_code)]

use core::sync::atomic::{AtomicU8, AtomicU32, Ordering};

use embassy_stm32::mode::Async;
use embassy_stm32::pac::dma::vals::{Dir, Pl, Size};
use embassy_stm32::pac::{DMA2, USART1};
use embassy_stm32::usart::{self, Uart, UartRx, UartTx};
use embassy_sync::blocking_mutex::raw::CriticalSectionRawMutex;
use embassy_sync::pipe::Pipe;
use embassy_time::{Duration, Timer, with_timeout};

use super::facts::{Irqs, LINK_BAUD, LINK_RX_DMA_CHANNEL, LINK_RX_DMA_STREAM, LinkParts};
use super::watchdog::{self, Party};

/// Bytes from the host, on their way to the control tick.
pub(super) static INBOX: Pipe<CriticalSectionRawMutex, 1024> = Pipe::new();
/// Bytes from the control tick, on their way to the host.
pub(super) static OUTBOX: Pipe<CriticalSectionRawMutex, 1024> = Pipe::new();

/// Looks at the line that found noise, a bad stop bit or an overrun, and bytes that the control tick did not take.
pub(super) static RECEIVE_ERRORS: AtomicU32 = AtomicU32::new(0);
/// Bursts that could not be sent in time.
pub(super) static TRANSMIT_ERRORS: AtomicU32 = AtomicU32::new(0);

/// Bytes of the receive ring: 11 ms of a saturated line.
const RING_BYTES: usize = 1024;
/// In main RAM: DMA cannot reach the core-coupled memory. Atomics, because somebody else writes them.
static RING: [AtomicU8; RING_BYTES] = [const { AtomicU8::new(0) }; RING_BYTES];

/// How long received bytes lie in the ring at most, while the tasks get their turns.
const RECEIVE_POLL: Duration = Duration::from_millis(1);
/// How long the sender sleeps at most before it checks in again.
const TRANSMIT_POLL: Duration = Duration::from_millis(10);
/// Longest time for one burst: 256 bytes take 2.8 ms.
const BURST_TIMEOUT: Duration = Duration::from_millis(10);

/// Both halves of the link, ready to run.
pub(super) struct Link {
    /// For [`receive`].
    pub(super) rx: Receiver,
    /// For [`transmit`].
    pub(super) tx: UartTx<'static, Async>,
}

/// The receiving half: the stream writes into the ring for ever, the task follows it.
pub(super) struct Receiver {
    /// Owned for its pins, never used: its interrupts stay off.
    _rx: UartRx<'static, Async>,
    /// Next byte of the ring to be read.
    position: usize,
}

impl Receiver {
    /// Starts the stream.
    fn new(rx: UartRx<'static, Async>) -> Self {
        let stream = DMA2.st(LINK_RX_DMA_STREAM);
        stream.par().write_value(USART1.dr().as_ptr() as u32);
        stream.m0ar().write_value(RING.as_ptr() as u32);
        stream.ndtr().write(|w| w.set_ndt(RING_BYTES as u16));
        stream.cr().write(|w| {
            w.set_chsel(LINK_RX_DMA_CHANNEL);
            w.set_dir(Dir::PERIPHERAL_TO_MEMORY);
            w.set_circ(true);
            w.set_minc(true);
            w.set_msize(Size::BITS8);
            w.set_psize(Size::BITS8);
            w.set_pl(Pl::HIGH);
            w.set_en(true);
        });
        USART1.cr3().modify(|w| w.set_dmar(true));
        Self { _rx: rx, position: 0 }
    }

    /// Takes what has come, as much as fits.
    fn read(&mut self, into: &mut [u8]) -> usize {
        // The stream's next read of the data register clears what is seen here.
        let status = USART1.sr().read();
        if status.fe() || status.ne() || status.ore() {
            RECEIVE_ERRORS.fetch_add(1, Ordering::Relaxed);
        }
        let left = usize::from(DMA2.st(LINK_RX_DMA_STREAM).ndtr().read().ndt());
        let end = RING_BYTES.saturating_sub(left) % RING_BYTES;
        let mut count = 0;
        for slot in into {
            if self.position == end {
                break;
            }
            *slot = RING.get(self.position).map_or(0, |byte| byte.load(Ordering::Relaxed));
            self.position = (self.position + 1) % RING_BYTES;
            count += 1;
        }
        count
    }
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
    Ok(Link { rx: Receiver::new(rx), tx })
}

/// Host → inbox.
#[embassy_executor::task]
pub(super) async fn receive(mut rx: Receiver) {
    let mut buffer = [0; 256];
    loop {
        watchdog::check_in(Party::LinkReceive);
        Timer::after(RECEIVE_POLL).await;
        // A round is a quarter of the ring and 2.8 ms of the line: reading is always the faster.
        let count = rx.read(&mut buffer);
        deliver(buffer.get(..count).unwrap_or_default()).await;
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

//! The radio receiver's line, through a [ring](super::ring).
//!
//! Receiving only; nothing is ever sent, for the stream that would serve that is the motors'.

use embassy_stm32::gpio::Flex;
use embassy_stm32::pac::dma::vals::Pl;
use embassy_stm32::pac::usart::regs::Brr;
use embassy_stm32::{Peri, peripherals, rcc};
use mintime_firmware::receiver::{BAUD, KillState, KillSwitch, KillSwitchConfig};

use super::facts::{
    RECEIVER_ALTERNATE_FUNCTION, RECEIVER_CLOCK_HZ, RECEIVER_DMA, RECEIVER_DMA_CHANNEL, RECEIVER_DMA_STREAM,
    RECEIVER_UART, ReceiverParts,
};
use super::ring::{Line, Ring, RingMemory};

/// 6 ms of a line without a pause; the control tick empties it every 1.25 ms.
const RING_BYTES: usize = 256;
/// Bytes taken in a tick. The line brings 53.
const BYTES_PER_TICK: usize = 128;
static RING: RingMemory<RING_BYTES> = RingMemory::new();

/// Receiver → control tick.
pub(super) struct RadioReceiver {
    _dma: Peri<'static, peripherals::DMA1_CH5>,
    _uart: Peri<'static, peripherals::USART2>,
    ring: Ring<RING_BYTES>,
    /// What was taken last.
    bytes: [u8; BYTES_PER_TICK],
    switch: KillSwitch,
}

impl RadioReceiver {
    /// Sets up the port, which listens from now on.
    pub(super) fn new(parts: ReceiverParts, config: KillSwitchConfig) -> Self {
        let ReceiverParts { uart, rx, dma } = parts;
        rcc::enable_and_reset::<peripherals::USART2>();
        // With sixteenfold oversampling the register counts cycles of the bus clock in a bit (RM0090 section 30.3.4).
        RECEIVER_UART.brr().write_value(Brr((RECEIVER_CLOCK_HZ + BAUD / 2) / BAUD));
        let line = Line {
            uart: RECEIVER_UART,
            dma: RECEIVER_DMA,
            stream: RECEIVER_DMA_STREAM,
            channel: RECEIVER_DMA_CHANNEL,
            priority: Pl::MEDIUM,
        };
        let ring = Ring::start(line, &RING, Flex::new(rx), RECEIVER_ALTERNATE_FUNCTION);
        let switch = KillSwitch::new(config);
        Self { _dma: dma, _uart: uart, ring, bytes: [0; BYTES_PER_TICK], switch }
    }

    /// Takes what has arrived and answers what the pilot wants. From every control tick.
    pub(super) fn update(&mut self, now_us: u64) -> KillState {
        let taken = self.ring.take(&mut self.bytes);
        self.switch.update(now_us, self.bytes.get(..taken.count).unwrap_or_default())
    }

    /// Sets which switch it is. One that is already so goes on.
    pub(super) fn configure(&mut self, channel: u8, run_above_us: u16) {
        self.switch.configure(KillSwitchConfig { channel, run_above_us, ..KillSwitchConfig::DEFAULT });
    }

    /// The switch, for telemetry.
    pub(super) const fn switch(&self) -> &KillSwitch {
        &self.switch
    }
}

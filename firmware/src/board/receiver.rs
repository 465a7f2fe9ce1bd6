//! The radio receiver's line: DMA writes what it sends into a ring, and the control tick takes it from there.
//!
//! Receiving only; nothing is ever sent, for the stream that would serve that is the motors'. Noise, a bad stop bit or an
//! overrun spoil a frame, which its checksum shows; reception itself never stops.

use core::sync::atomic::{AtomicU8, Ordering};

use embassy_stm32::gpio::{AfType, Flex, Pull};
use embassy_stm32::pac::dma::vals::{Dir, Pl, Size};
use embassy_stm32::pac::usart::regs::Brr;
use embassy_stm32::{Peri, peripherals, rcc};
use mintime_firmware::receiver::{BAUD, KillState, KillSwitch, KillSwitchConfig};

use super::facts::{
    RECEIVER_ALTERNATE_FUNCTION, RECEIVER_CLOCK_HZ, RECEIVER_DMA, RECEIVER_DMA_CHANNEL, RECEIVER_DMA_STREAM,
    RECEIVER_UART, ReceiverParts,
};

/// 6 ms of a line without a pause; the control tick empties it every 1.25 ms.
const RING_BYTES: usize = 256;
/// Bytes taken in a tick. The line brings 53.
const BYTES_PER_TICK: usize = 128;
/// In main RAM: DMA cannot reach the core-coupled memory. Atomics, because somebody else writes them.
static RING: [AtomicU8; RING_BYTES] = [const { AtomicU8::new(0) }; RING_BYTES];

/// Receiver → control tick.
pub(super) struct RadioReceiver {
    _pin: Flex<'static>,
    _dma: Peri<'static, peripherals::DMA1_CH5>,
    _uart: Peri<'static, peripherals::USART2>,
    /// Place in the ring of the next byte to be taken.
    next: usize,
    config: KillSwitchConfig,
    switch: KillSwitch,
}

impl RadioReceiver {
    /// Sets up the port, which listens from now on.
    pub(super) fn new(parts: ReceiverParts, config: KillSwitchConfig) -> Self {
        let ReceiverParts { uart, rx, dma } = parts;
        rcc::enable_and_reset::<peripherals::USART2>();
        let mut pin = Flex::new(rx);
        // With no receiver the input must rest at the idle level instead of collecting noise.
        pin.set_as_af_unchecked(RECEIVER_ALTERNATE_FUNCTION, AfType::input(Pull::Up));
        let stream = RECEIVER_DMA.st(RECEIVER_DMA_STREAM);
        stream.par().write_value(RECEIVER_UART.dr().as_ptr() as u32);
        stream.m0ar().write_value(RING.as_ptr() as u32);
        stream.ndtr().write(|w| w.set_ndt(RING_BYTES as u16));
        stream.cr().write(|w| {
            w.set_chsel(RECEIVER_DMA_CHANNEL);
            w.set_dir(Dir::PERIPHERAL_TO_MEMORY);
            w.set_circ(true);
            w.set_minc(true);
            w.set_msize(Size::BITS8);
            w.set_psize(Size::BITS8);
            w.set_pl(Pl::MEDIUM);
            w.set_en(true);
        });
        // With sixteenfold oversampling the register counts cycles of the bus clock in a bit (RM0090 section 30.3.4).
        RECEIVER_UART.brr().write_value(Brr((RECEIVER_CLOCK_HZ + BAUD / 2) / BAUD));
        RECEIVER_UART.cr3().write(|w| w.set_dmar(true));
        RECEIVER_UART.cr1().write(|w| {
            w.set_ue(true);
            w.set_re(true);
        });
        Self { _pin: pin, _dma: dma, _uart: uart, next: 0, config, switch: KillSwitch::new(config) }
    }

    /// Takes what has arrived and answers what the pilot wants. From every control tick.
    pub(super) fn update(&mut self, now_us: u64) -> KillState {
        let mut bytes = [0; BYTES_PER_TICK];
        let taken = self.take(&mut bytes);
        self.switch.update(now_us, bytes.get(..taken).unwrap_or_default())
    }

    /// Sets which switch it is. One that is already so goes on.
    pub(super) fn configure(&mut self, channel: u8, run_above_us: u16) {
        let config = KillSwitchConfig { channel, run_above_us, ..KillSwitchConfig::DEFAULT };
        if self.config != config {
            self.config = config;
            self.switch = KillSwitch::new(config);
        }
    }

    /// The switch, for telemetry.
    pub(super) const fn switch(&self) -> &KillSwitch {
        &self.switch
    }

    fn take(&mut self, into: &mut [u8]) -> usize {
        let status = RECEIVER_UART.sr().read();
        // Status, then data, clears the flags. Where a byte waits the stream reads it, which does as well.
        if (status.ore() || status.ne() || status.fe()) && !status.rxne() {
            let _ = RECEIVER_UART.dr().read();
        }
        let left = usize::from(RECEIVER_DMA.st(RECEIVER_DMA_STREAM).ndtr().read().ndt());
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

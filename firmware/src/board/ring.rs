//! A serial line in, for ever: DMA writes what arrives into a ring in memory, and the control tick takes it from there.
//!
//! Reception is never stopped and never started again: noise, a bad stop bit or an overrun spoil a frame, which its checksum
//! shows. A driver that stops for them would have to find a moment to start in which no byte arrives, and a sender that talks
//! without a pause has none.

use core::sync::atomic::{AtomicU8, Ordering};

use embassy_stm32::gpio::{AfType, Flex, Pull};
use embassy_stm32::pac::dma::Dma;
use embassy_stm32::pac::dma::vals::{Dir, Pl, Size};
use embassy_stm32::pac::usart::Usart;

/// The memory of a ring: main RAM, for DMA cannot reach the core-coupled memory. Atomics, because somebody else writes them.
pub(super) struct RingMemory<const BYTES: usize>([AtomicU8; BYTES]);

impl<const BYTES: usize> RingMemory<BYTES> {
    /// Zeros.
    pub(super) const fn new() -> Self {
        Self([const { AtomicU8::new(0) }; BYTES])
    }
}

/// Who receives, and who moves the bytes.
pub(super) struct Line {
    pub(super) uart: Usart,
    pub(super) dma: Dma,
    pub(super) stream: usize,
    pub(super) channel: u8,
    pub(super) priority: Pl,
}

/// The end of a ring that is read.
pub(super) struct Ring<const BYTES: usize> {
    line: Line,
    memory: &'static RingMemory<BYTES>,
    _pin: Flex<'static>,
    /// Place of the next byte to be taken.
    next: usize,
}

/// What [`Ring::take`] found.
pub(super) struct Taken {
    /// Bytes taken.
    pub(super) count: usize,
    /// Noise, a bad stop bit or an overrun was seen since the last time.
    pub(super) disturbed: bool,
}

impl<const BYTES: usize> Ring<BYTES> {
    /// Switches reception on, for ever. The port has its clock and its speed.
    pub(super) fn start(
        line: Line,
        memory: &'static RingMemory<BYTES>,
        mut pin: Flex<'static>,
        function: u8,
    ) -> Self {
        // With nobody connected the input must rest at the idle level instead of collecting noise.
        pin.set_as_af_unchecked(function, AfType::input(Pull::Up));
        let stream = line.dma.st(line.stream);
        stream.par().write_value(line.uart.dr().as_ptr() as u32);
        stream.m0ar().write_value(memory.0.as_ptr() as u32);
        stream.ndtr().write(|w| w.set_ndt(BYTES as u16));
        stream.cr().write(|w| {
            w.set_chsel(line.channel);
            w.set_dir(Dir::PERIPHERAL_TO_MEMORY);
            w.set_circ(true);
            w.set_minc(true);
            w.set_msize(Size::BITS8);
            w.set_psize(Size::BITS8);
            w.set_pl(line.priority);
            w.set_en(true);
        });
        line.uart.cr3().modify(|w| w.set_dmar(true));
        line.uart.cr1().modify(|w| {
            w.set_ue(true);
            w.set_re(true);
        });
        Self { line, memory, _pin: pin, next: 0 }
    }

    /// Takes bytes that have arrived. Often enough that less than a ring has come since the last time.
    #[inline]
    pub(super) fn take(&mut self, into: &mut [u8]) -> Taken {
        let status = self.line.uart.sr().read();
        let disturbed = status.ore() || status.ne() || status.fe();
        // Status, then data, clears the flags. Where a byte waits the stream reads it, which does as well.
        if disturbed && !status.rxne() {
            let _ = self.line.uart.dr().read();
        }
        let left = usize::from(self.line.dma.st(self.line.stream).ndtr().read().ndt());
        let written = BYTES.saturating_sub(left) % BYTES;
        let mut count = 0;
        // Up to the end of the ring, then from its beginning.
        for _ in 0..2 {
            let end = if written < self.next { BYTES } else { written };
            let from = self.memory.0.get(self.next..end).unwrap_or_default();
            let to = into.get_mut(count..).unwrap_or_default();
            for (slot, byte) in to.iter_mut().zip(from) {
                *slot = byte.load(Ordering::Relaxed);
            }
            let taken = from.len().min(to.len());
            count += taken;
            self.next = (self.next + taken) % BYTES;
        }
        Taken { count, disturbed }
    }
}

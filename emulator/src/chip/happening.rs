//! What an event does.

use super::access::report;
use super::events::Slot;
use super::map::{self, Block};
use super::pin::{SPI_PINS, USART_RX_PINS, USART_TX_PINS, analog_pin};
use super::serial_line::SerialByte;
use super::usart::Sent;
use super::{Board, Chip, Mode, SpiWord, or_never, rcc};
use crate::bus::{Access, Cycle, Width};
use crate::memory::Memory;

/// Supply and reference of the converters (V).
const VREF_V: f64 = 3.3;
/// Highest clock of the converters (DS8626, ADC characteristics).
const ADC_LIMIT_HZ: u32 = 36_000_000;

impl<B: Board> Chip<B> {
    /// Lets the event of `slot` happen at `at`.
    pub(super) fn happen(&mut self, memory: &mut Memory, slot: Slot, at: Cycle) {
        match slot {
            Slot::Board => {
                let ns = self.clock.ns(at).max(self.board_due_ns);
                self.board_due_ns = u64::MAX;
                self.tell_board(memory, at, |board, effects| board.advance(ns, effects));
            }
            Slot::Flash => {
                self.flash.finish(memory);
                self.refresh(Block::Flash);
            }
            Slot::Iwdg => self.ask_for_reset(rcc::CSR_IWDGRSTF),
            Slot::Wwdg => {
                let divider = self.wwdg_divider();
                if self.wwdg.fire(at, divider) {
                    self.ask_for_reset(rcc::CSR_WWDGRSTF);
                } else {
                    self.events.set(Slot::Wwdg, self.wwdg.due(divider));
                }
                self.refresh(Block::Wwdg);
            }
            Slot::Timer(n) => {
                self.sync_timer(memory, n, at);
                self.pump(memory, at);
                self.timer_changed(n);
            }
            Slot::UsartTx(n) => self.byte_sent(memory, n, at),
            Slot::UsartRx(n) => self.byte_received(memory, n, at),
            Slot::UsartIdle(n) => {
                // A byte under way that began before now will look for silence again.
                if self.clock.cycle(self.serial[usize::from(n)].next_start_ns()) >= at {
                    self.usarts[usize::from(n)].idle();
                    self.refresh(Block::Usart(n));
                }
            }
            Slot::Spi(n) => self.word_exchanged(memory, n, at),
            Slot::Adc(n) => self.converted(memory, n, at),
            Slot::Dma(_) => self.pump(memory, at),
            Slot::MemoryCopy(stream) => self.copy_memory(memory, usize::from(stream), at),
        }
    }

    /// HCLK cycles per cycle of the window watchdog's clock.
    pub(super) fn wwdg_divider(&self) -> u32 {
        self.clock.apb_divider(super::clock::Apb::One)
    }

    /// Length of a conversion (cycles).
    pub(super) fn conversion_cycles(&self, n: u8) -> u64 {
        let divider = self.clock.apb_divider(super::clock::Apb::Two) * self.adc_prescaler();
        u64::from(self.adcs[usize::from(n)].conversion_cycles() * divider)
    }

    /// Whether the converters' clock is within its limit.
    pub(super) fn check_adc_clock(&self, memory: &mut Memory, access: Access) {
        let hz = self.clock.apb_hz(super::clock::Apb::Two) / self.adc_prescaler();
        if hz > ADC_LIMIT_HZ {
            report(
                memory,
                access,
                Some(format!("the ADC clock is {hz} Hz, above its limit of {ADC_LIMIT_HZ} Hz")),
            );
        }
    }

    fn adc_prescaler(&self) -> u32 {
        2 * ((self.adc_common >> 16 & 3) + 1)
    }

    fn byte_sent(&mut self, memory: &mut Memory, n: u8, at: Cycle) {
        let index = usize::from(n);
        let bus = map::usart_bus(n);
        let divider = self.clock.apb_divider(bus);
        let (sent, next) = self.usarts[index].sent(at, divider);
        self.events.set(Slot::UsartTx(n), or_never(next));
        if sent != Sent::Nothing {
            if self.routed(USART_TX_PINS[index]) {
                let baud = self.clock.apb_hz(bus) / self.usarts[index].bit_cycles();
                match sent {
                    Sent::Byte(byte) => {
                        self.serial[index].sent.push_back(SerialByte { ns: self.clock.ns(at), byte, baud });
                    }
                    Sent::Break | Sent::Nothing => self.serial[index].breaks += 1,
                }
            } else {
                let text = format!("{} sends while its TX is on no pin", Block::Usart(n).name());
                memory.report(at, 0, text);
            }
        }
        self.refresh(Block::Usart(n));
        self.pump(memory, at);
    }

    fn byte_received(&mut self, memory: &mut Memory, n: u8, at: Cycle) {
        let index = usize::from(n);
        let divider = self.clock.apb_divider(map::usart_bus(n));
        let usart = &self.usarts[index];
        let bit_cycles = u64::from(usart.bit_cycles()) * u64::from(divider);
        let frame = self.serial[index].take(self.clock.span_ns(bit_cycles), usart.word_bits());
        let clocked = Block::Usart(n).gate().is_none_or(|gate| self.rcc.enabled(gate));
        let heard = clocked && usart.has_speed() && self.routed(USART_RX_PINS[index]);
        if let Some(frame) = frame
            && heard
            && self.usarts[index].receive(frame)
        {
            // Half a stop bit, then a whole frame of silence; the next byte, if it starts sooner, moves this.
            let silence = bit_cycles / 2 + self.usarts[index].frame_cycles(divider);
            self.events.set(Slot::UsartIdle(n), at + silence);
            self.refresh(Block::Usart(n));
        }
        self.schedule_serial(n);
        self.pump(memory, at);
    }

    fn word_exchanged(&mut self, memory: &mut Memory, n: u8, at: Cycle) {
        let index = usize::from(n);
        let spi = &self.spis[index];
        let Some(value) = spi.shifting() else { return };
        let word = SpiWord {
            value,
            bits: spi.bits(),
            clock_hz: self.clock.apb_hz(map::spi_bus(n)) / spi.bit_cycles(),
            mode: spi.mode(),
            lsb_first: spi.lsb_first(),
        };
        let [sck, miso, mosi] = SPI_PINS[index];
        let mut answer = 0xFFFF;
        if self.routed(sck) && self.routed(mosi) {
            let ns = self.clock.ns(at);
            let sent = self.tell_board(memory, at, |board, effects| board.spi(ns, n + 1, word, effects));
            if self.routed(miso) {
                answer = sent;
            }
        }
        let started = self.spis[index].exchanged(answer);
        // DMA takes the word that has come before the next one can be complete.
        let access = Access { at, address: 0, width: Width::Word, pc: 0 };
        self.spi_changed(memory, n, at, access, started);
        self.pump(memory, at);
    }

    fn converted(&mut self, memory: &mut Memory, n: u8, at: Cycle) {
        let index = usize::from(n);
        let channel = self.adcs[index].channel();
        let volts = match (n, channel) {
            // Temperature sensor at 25 °C and the internal reference (DS8626), when ADC_CCR.TSVREFE is on.
            (0, 16) if self.adc_common >> 23 & 1 == 1 => 0.76,
            (0, 17) if self.adc_common >> 23 & 1 == 1 => 1.21,
            (2, 4..=9 | 14..) => 0.0,
            _ => match analog_pin(channel) {
                Some(pin) => {
                    if self.gpio[pin.port()].mode(pin.number()) != Mode::Analog {
                        memory.report(
                            at,
                            0,
                            format!("ADC{} converts {pin}, which is not set to analog", n + 1),
                        );
                    }
                    let ns = self.clock.ns(at);
                    self.tell_board(memory, at, |board, _| board.analog_v(ns, pin))
                }
                None => 0.0,
            },
        };
        let counts = (volts / VREF_V * 4095.0).round().clamp(0.0, 4095.0) as u16;
        let more = self.adcs[index].converted(counts);
        let next = more.then(|| at + self.conversion_cycles(n));
        self.events.set(Slot::Adc(n), or_never(next));
        self.refresh(Block::Adc);
        self.pump(memory, at);
    }
}

//! What happens next: one due time for each source of events, and the earliest of them ready to read.

use crate::bus::{Cycle, NEVER};

/// A source of events.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Slot {
    /// The board: sensors and whatever else has a time of its own.
    Board,
    /// End of a flash operation.
    Flash,
    /// Time-out of the independent watchdog.
    Iwdg,
    /// Time-out of the window watchdog.
    Wwdg,
    /// Something a timer must do on time.
    Timer(u8),
    /// A byte has left a serial port.
    UsartTx(u8),
    /// A byte has arrived at a serial port.
    UsartRx(u8),
    /// A line has been idle for a frame.
    UsartIdle(u8),
    /// A word has been exchanged.
    Spi(u8),
    /// A conversion is done.
    Adc(u8),
    /// A transfer from memory to memory is done (stream of DMA2).
    MemoryCopy(u8),
    /// A DMA controller is done with an item and another waits.
    Dma(u8),
}

const TIMERS: usize = 4;
const USART_TX: usize = TIMERS + 14;
const USART_RX: usize = USART_TX + 6;
const USART_IDLE: usize = USART_RX + 6;
const SPI: usize = USART_IDLE + 6;
const ADC: usize = SPI + 3;
const COPY: usize = ADC + 3;
const DMA: usize = COPY + 8;
const SLOTS: usize = DMA + 2;
const _: () = assert!(SLOTS <= 64);

impl Slot {
    fn index(self) -> usize {
        match self {
            Self::Board => 0,
            Self::Flash => 1,
            Self::Iwdg => 2,
            Self::Wwdg => 3,
            Self::Timer(n) => TIMERS + usize::from(n),
            Self::UsartTx(n) => USART_TX + usize::from(n),
            Self::UsartRx(n) => USART_RX + usize::from(n),
            Self::UsartIdle(n) => USART_IDLE + usize::from(n),
            Self::Spi(n) => SPI + usize::from(n),
            Self::Adc(n) => ADC + usize::from(n),
            Self::MemoryCopy(n) => COPY + usize::from(n),
            Self::Dma(n) => DMA + usize::from(n),
        }
    }

    fn from_index(index: usize) -> Self {
        let from = |first: usize| (index - first) as u8;
        match index {
            0 => Self::Board,
            1 => Self::Flash,
            2 => Self::Iwdg,
            3 => Self::Wwdg,
            _ if index < USART_TX => Self::Timer(from(TIMERS)),
            _ if index < USART_RX => Self::UsartTx(from(USART_TX)),
            _ if index < USART_IDLE => Self::UsartRx(from(USART_RX)),
            _ if index < SPI => Self::UsartIdle(from(USART_IDLE)),
            _ if index < ADC => Self::Spi(from(SPI)),
            _ if index < COPY => Self::Adc(from(ADC)),
            _ if index < DMA => Self::MemoryCopy(from(COPY)),
            _ => Self::Dma(from(DMA)),
        }
    }
}

/// Due times. Every source has a place of its own, so that nothing is allocated and order at equal times is fixed.
#[derive(Clone, Debug)]
pub(crate) struct Events {
    due: [Cycle; SLOTS],
    /// Which of them are not [`NEVER`], as bits.
    set: u64,
    next: Cycle,
    next_index: usize,
}

impl Events {
    pub(crate) fn new() -> Self {
        Self { due: [NEVER; SLOTS], set: 0, next: NEVER, next_index: 0 }
    }

    /// The earliest due time.
    pub(crate) fn next(&self) -> Cycle {
        self.next
    }

    /// Sets, moves or ([`NEVER`]) removes the event of a source.
    pub(crate) fn set(&mut self, slot: Slot, at: Cycle) {
        let index = slot.index();
        if self.due[index] == at {
            return;
        }
        self.due[index] = at;
        self.set = self.set & !(1 << index) | u64::from(at != NEVER) << index;
        if at < self.next {
            (self.next, self.next_index) = (at, index);
        } else if index == self.next_index || at == self.next {
            self.find_next();
        }
    }

    /// Takes the earliest event if it is due.
    pub(crate) fn pop_due(&mut self, now: Cycle) -> Option<(Slot, Cycle)> {
        if self.next > now || self.next == NEVER {
            return None;
        }
        let (index, at) = (self.next_index, self.next);
        self.due[index] = NEVER;
        self.set &= !(1 << index);
        self.find_next();
        Some((Slot::from_index(index), at))
    }

    fn find_next(&mut self) {
        (self.next, self.next_index) = (NEVER, 0);
        let mut left = self.set;
        while left != 0 {
            let index = left.trailing_zeros() as usize;
            left &= left - 1;
            if self.due[index] < self.next {
                (self.next, self.next_index) = (self.due[index], index);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Events, SLOTS, Slot};
    use crate::bus::NEVER;

    #[test]
    fn events_come_in_order_and_moved_ones_at_their_new_time() {
        let mut events = Events::new();
        events.set(Slot::Spi(1), 30);
        events.set(Slot::Timer(13), 10);
        events.set(Slot::UsartRx(5), 20);
        events.set(Slot::Timer(13), 40);
        events.set(Slot::Spi(1), NEVER);
        assert_eq!(events.next(), 20);
        assert_eq!(events.pop_due(19), None);
        assert_eq!(events.pop_due(100), Some((Slot::UsartRx(5), 20)));
        assert_eq!(events.pop_due(100), Some((Slot::Timer(13), 40)));
        assert_eq!(events.pop_due(100), None);
    }

    #[test]
    fn slots_and_indices_match() {
        for index in 0..SLOTS {
            assert_eq!(Slot::from_index(index).index(), index);
        }
    }
}

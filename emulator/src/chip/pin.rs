//! Pins, and which peripheral a pin's alternate function leads to (DS8626 table 9).

/// A pin of ports A to I.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Pin(u8);

impl Pin {
    /// Pin `number` (0..=15, taken modulo 16) of `port` ('A'..='I'; any other letter counts as 'A').
    pub const fn new(port: char, number: u8) -> Self {
        let port = port as u32;
        let index = if port >= 'A' as u32 && port <= 'I' as u32 { port - 'A' as u32 } else { 0 };
        Self((index as u8) << 4 | (number & 15))
    }

    /// By index of the port, 0 for A.
    pub(crate) const fn at(port: usize, number: usize) -> Self {
        Self(((port as u8) << 4) | (number as u8 & 15))
    }

    /// Index of the port: 0 for A.
    pub const fn port(self) -> usize {
        (self.0 >> 4) as usize
    }

    /// Number within the port.
    pub const fn number(self) -> usize {
        (self.0 & 15) as usize
    }

    /// Its bit in the port's registers.
    pub const fn bit(self) -> u16 {
        1 << (self.0 & 15)
    }
}

impl std::fmt::Display for Pin {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "P{}{}", char::from(b'A' + (self.0 >> 4)), self.number())
    }
}

impl std::fmt::Debug for Pin {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        std::fmt::Display::fmt(self, f)
    }
}

/// A pin and the alternate function on it.
pub(crate) type Route = (Pin, u8);

const fn p(port: char, number: u8, function: u8) -> Route {
    (Pin::new(port, number), function)
}

/// Timer outputs: (timer 1..=14, channel 0..=3, pin and function), ports A to E.
pub(crate) const TIMER_PINS: &[(u8, u8, Route)] = &[
    (1, 0, p('A', 8, 1)),
    (1, 1, p('A', 9, 1)),
    (1, 2, p('A', 10, 1)),
    (1, 3, p('A', 11, 1)),
    (1, 0, p('E', 9, 1)),
    (1, 1, p('E', 11, 1)),
    (1, 2, p('E', 13, 1)),
    (1, 3, p('E', 14, 1)),
    (2, 0, p('A', 0, 1)),
    (2, 1, p('A', 1, 1)),
    (2, 2, p('A', 2, 1)),
    (2, 3, p('A', 3, 1)),
    (2, 0, p('A', 5, 1)),
    (2, 0, p('A', 15, 1)),
    (2, 1, p('B', 3, 1)),
    (2, 2, p('B', 10, 1)),
    (2, 3, p('B', 11, 1)),
    (3, 0, p('A', 6, 2)),
    (3, 1, p('A', 7, 2)),
    (3, 2, p('B', 0, 2)),
    (3, 3, p('B', 1, 2)),
    (3, 0, p('B', 4, 2)),
    (3, 1, p('B', 5, 2)),
    (3, 0, p('C', 6, 2)),
    (3, 1, p('C', 7, 2)),
    (3, 2, p('C', 8, 2)),
    (3, 3, p('C', 9, 2)),
    (4, 0, p('B', 6, 2)),
    (4, 1, p('B', 7, 2)),
    (4, 2, p('B', 8, 2)),
    (4, 3, p('B', 9, 2)),
    (4, 0, p('D', 12, 2)),
    (4, 1, p('D', 13, 2)),
    (4, 2, p('D', 14, 2)),
    (4, 3, p('D', 15, 2)),
    (5, 0, p('A', 0, 2)),
    (5, 1, p('A', 1, 2)),
    (5, 2, p('A', 2, 2)),
    (5, 3, p('A', 3, 2)),
    (8, 0, p('C', 6, 3)),
    (8, 1, p('C', 7, 3)),
    (8, 2, p('C', 8, 3)),
    (8, 3, p('C', 9, 3)),
    (9, 0, p('A', 2, 3)),
    (9, 1, p('A', 3, 3)),
    (10, 0, p('B', 8, 3)),
    (11, 0, p('B', 9, 3)),
    (12, 0, p('B', 14, 9)),
    (12, 1, p('B', 15, 9)),
    (13, 0, p('A', 6, 9)),
    (14, 0, p('A', 7, 9)),
];

/// Pins that can send for serial port `index` (0 for USART1 to 5 for USART6).
pub(crate) const USART_TX_PINS: [&[Route]; 6] = [
    &[p('A', 9, 7), p('B', 6, 7)],
    &[p('A', 2, 7), p('D', 5, 7)],
    &[p('B', 10, 7), p('C', 10, 7), p('D', 8, 7)],
    &[p('A', 0, 8), p('C', 10, 8)],
    &[p('C', 12, 8)],
    &[p('C', 6, 8), p('G', 14, 8)],
];

/// Pins that can receive for serial port `index`.
pub(crate) const USART_RX_PINS: [&[Route]; 6] = [
    &[p('A', 10, 7), p('B', 7, 7)],
    &[p('A', 3, 7), p('D', 6, 7)],
    &[p('B', 11, 7), p('C', 11, 7), p('D', 9, 7)],
    &[p('A', 1, 8), p('C', 11, 8)],
    &[p('D', 2, 8)],
    &[p('C', 7, 8), p('G', 9, 8)],
];

/// SCK, MISO and MOSI of SPI `index` (0 for SPI1).
pub(crate) const SPI_PINS: [[&[Route]; 3]; 3] = [
    [&[p('A', 5, 5), p('B', 3, 5)], &[p('A', 6, 5), p('B', 4, 5)], &[p('A', 7, 5), p('B', 5, 5)]],
    [
        &[p('B', 10, 5), p('B', 13, 5), p('I', 1, 5)],
        &[p('B', 14, 5), p('C', 2, 5), p('I', 2, 5)],
        &[p('B', 15, 5), p('C', 3, 5), p('I', 3, 5)],
    ],
    [&[p('B', 3, 6), p('C', 10, 6)], &[p('B', 4, 6), p('C', 11, 6)], &[p('B', 5, 6), p('C', 12, 6)]],
];

/// Pin of an analog input of ADC1 or ADC2; ADC3 shares 0..=3 and 10..=13 (DS8626 table 7).
pub(crate) const fn analog_pin(channel: u8) -> Option<Pin> {
    match channel {
        0..=7 => Some(Pin::new('A', channel)),
        8 | 9 => Some(Pin::new('B', channel - 8)),
        10..=15 => Some(Pin::new('C', channel - 10)),
        _ => None,
    }
}

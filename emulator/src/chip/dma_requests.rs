//! Which peripheral asks on which channel of which stream (RM0090 tables 42 and 43).

/// A line on which a peripheral asks for DMA. Peripherals count from zero.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Request {
    UsartRx(u8),
    UsartTx(u8),
    SpiRx(u8),
    SpiTx(u8),
    Adc(u8),
    TimerUpdate(u8),
    TimerChannel(u8, u8),
}

use Request::{Adc, SpiRx, SpiTx, TimerChannel as Ch, TimerUpdate as Up, UsartRx as Rx, UsartTx as Tx};

type Requests = &'static [Request];
const NONE: Requests = &[];

/// Everything that can ask on `channel` of `stream`; empty where nothing emulated does.
pub(crate) fn requests(controller: usize, stream: usize, channel: u8) -> Requests {
    let tables = if controller == 0 { &DMA1 } else { &DMA2 };
    tables[usize::from(channel & 7)][stream & 7]
}

/// By channel, then stream. I2C, DAC, I2S and triggers are left out.
const DMA1: [[Requests; 8]; 8] = [
    [&[SpiRx(2)], NONE, &[SpiRx(2)], &[SpiRx(1)], &[SpiTx(1)], &[SpiTx(2)], NONE, &[SpiTx(2)]],
    [NONE, NONE, &[Up(6)], NONE, &[Up(6)], NONE, NONE, NONE],
    [&[Ch(3, 0)], NONE, NONE, &[Ch(3, 1)], NONE, NONE, &[Up(3)], &[Ch(3, 2)]],
    [NONE, &[Up(1), Ch(1, 2)], NONE, NONE, NONE, &[Ch(1, 0)], &[Ch(1, 1), Ch(1, 3)], &[Up(1), Ch(1, 3)]],
    [&[Rx(4)], &[Rx(2)], &[Rx(3)], &[Tx(2)], &[Tx(3)], &[Rx(1)], &[Tx(1)], &[Tx(4)]],
    [NONE, NONE, &[Ch(2, 3), Up(2)], NONE, &[Ch(2, 0)], &[Ch(2, 1)], NONE, &[Ch(2, 2)]],
    [&[Ch(4, 2), Up(4)], &[Ch(4, 3)], &[Ch(4, 0)], &[Ch(4, 3)], &[Ch(4, 1)], NONE, &[Up(4)], NONE],
    [NONE, &[Up(5)], NONE, NONE, &[Tx(2)], NONE, NONE, NONE],
];

const DMA2: [[Requests; 8]; 8] = [
    [
        &[Adc(0)],
        NONE,
        &[Ch(7, 0), Ch(7, 1), Ch(7, 2)],
        NONE,
        &[Adc(0)],
        NONE,
        &[Ch(0, 0), Ch(0, 1), Ch(0, 2)],
        NONE,
    ],
    [NONE, NONE, &[Adc(1)], &[Adc(1)], NONE, NONE, NONE, NONE],
    [&[Adc(2)], &[Adc(2)], NONE, NONE, NONE, NONE, NONE, NONE],
    [&[SpiRx(0)], NONE, &[SpiRx(0)], &[SpiTx(0)], NONE, &[SpiTx(0)], NONE, NONE],
    [NONE, NONE, &[Rx(0)], NONE, NONE, &[Rx(0)], NONE, &[Tx(0)]],
    [NONE, &[Rx(5)], &[Rx(5)], NONE, NONE, NONE, &[Tx(5)], &[Tx(5)]],
    [NONE, &[Ch(0, 0)], &[Ch(0, 1)], &[Ch(0, 0)], &[Ch(0, 3)], &[Up(0)], &[Ch(0, 2)], NONE],
    [NONE, &[Up(7)], &[Ch(7, 0)], &[Ch(7, 1)], &[Ch(7, 2)], NONE, NONE, &[Ch(7, 3)]],
];

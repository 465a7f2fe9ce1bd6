//! The outputs of a timer: when in a period each of them is high (RM0090 section 18.3.9).

use super::timer::Timer;
use crate::bus::Cycle;

const BDTR_MOE: u32 = 1 << 15;

/// An output period that is over.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Period {
    /// When it began.
    pub(crate) start: Cycle,
    /// When it ended.
    pub(crate) end: Cycle,
    /// It was cut short.
    pub(crate) cut: bool,
    /// Per channel: when after the start its line rose, and for how long it was high (cycles).
    pub(crate) high: [(u64, u64); 4],
}

impl Timer {
    /// What the outputs did since the period began, if the period were cut short now.
    pub(crate) fn so_far(&self, now: Cycle) -> Option<Period> {
        let start = self.period_start;
        (self.running() && now > start).then(|| Period {
            start,
            end: now,
            cut: true,
            high: self.highs(start, now),
        })
    }

    /// Ends the output period.
    pub(crate) fn cut(&mut self, now: Cycle) {
        self.period_start = now;
    }

    /// Whether the output of a channel is on.
    pub(super) fn output_on(&self, channel: usize) -> bool {
        self.ccer >> (4 * channel) & 1 == 1 && (!self.advanced || self.bdtr & BDTR_MOE != 0)
    }

    /// Bits of CCMR for a channel.
    pub(super) fn mode_bits(&self, channel: usize) -> u32 {
        self.ccmr[(channel / 2) & 1] >> (8 * (channel % 2)) & 0xFF
    }

    /// Where in a period from `start` to `end` each output was high.
    pub(super) fn highs(&self, start: Cycle, end: Cycle) -> [(u64, u64); 4] {
        let mut highs = [(0, 0); 4];
        let length = end.saturating_sub(start);
        for (channel, high) in highs.iter_mut().enumerate().take(self.channels) {
            if !self.output_on(channel) {
                continue;
            }
            let compare = (u64::from(self.ccr[channel].active) * self.tick()).min(length);
            let inverted = self.ccer >> (4 * channel + 1) & 1 == 1;
            let (before, after) = match self.mode_bits(channel) >> 4 & 7 {
                5 => (true, true),
                6 => (true, false),
                7 => (false, true),
                _ => (false, false),
            };
            *high = match (before ^ inverted, after ^ inverted) {
                (true, true) => (0, length),
                (true, false) => (0, compare),
                (false, true) => (compare, length - compare),
                (false, false) => (0, 0),
            };
        }
        highs
    }

    /// Whether any output is high at some time in the present period.
    pub(super) fn emits(&self) -> bool {
        (0..self.channels).any(|channel| {
            let inverted = self.ccer >> (4 * channel + 1) & 1 == 1;
            self.output_on(channel)
                && match self.mode_bits(channel) >> 4 & 7 {
                    6 if !inverted => self.ccr[channel].active != 0,
                    0..=4 if !inverted => false,
                    _ => true,
                }
        })
    }
}

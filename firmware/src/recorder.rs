//! Keeps one record a tick during a maneuver, in memory that the board lends.

use mintime_shared::messages::{MAX_CHUNK_BYTES, RECORD_BYTES, RecordChunk, RecordedTick};

/// A record of the last maneuver: what fits is kept, the rest of a longer one is not.
#[derive(Debug)]
pub struct Recorder<'a> {
    storage: &'a mut [[u8; RECORD_BYTES]],
    length: usize,
    last_us: Option<u64>,
}

impl<'a> Recorder<'a> {
    /// An empty record in the given memory; its old content does not matter.
    pub const fn new(storage: &'a mut [[u8; RECORD_BYTES]]) -> Self {
        Self { storage, length: 0, last_us: None }
    }

    /// Forgets the record and begins a new one.
    pub fn clear(&mut self) {
        self.length = 0;
        self.last_us = None;
    }

    /// Adds a tick; its interval is filled in from the clock.
    pub fn push(&mut self, now_us: u64, mut tick: RecordedTick) {
        let Some(slot) = self.storage.get_mut(self.length) else {
            return;
        };
        let interval = self.last_us.map_or(0, |last| now_us.saturating_sub(last));
        tick.interval_us = u16::try_from(interval).unwrap_or(u16::MAX);
        *slot = tick.to_bytes();
        self.length += 1;
        self.last_us = Some(now_us);
    }

    /// Recorded ticks.
    pub fn len(&self) -> u32 {
        // Storage is far below u32::MAX ticks.
        self.length as u32
    }

    /// Whether there is nothing.
    pub fn is_empty(&self) -> bool {
        self.length == 0
    }

    /// A run of ticks from `first` on; `None` beyond the end. An empty record has one empty chunk.
    pub fn chunk(&self, first: u32) -> Option<RecordChunk> {
        let recorded = self.storage.get(..self.length)?;
        let rest = recorded.get(usize::try_from(first).ok()?..)?;
        if rest.is_empty() && first != 0 {
            return None;
        }
        let mut bytes = heapless::Vec::new();
        for tick in rest.iter().take(MAX_CHUNK_BYTES / RECORD_BYTES) {
            bytes.extend_from_slice(tick).ok()?;
        }
        Some(RecordChunk { first, total: self.len(), bytes })
    }
}

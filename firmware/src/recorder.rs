//! Keeps one record a tick during a maneuver, in memory that the board lends.

use mintime_shared::messages::{MAX_CHUNK_BYTES, RECORD_BYTES, RecordChunk, RecordedTick};

/// Memory for a record, one slot a tick: a `&'static mut [[u8; 20]]` on a board, a `Vec` on a host.
pub trait RecordMemory: AsRef<[[u8; RECORD_BYTES]]> + AsMut<[[u8; RECORD_BYTES]]> {}
impl<M: AsRef<[[u8; RECORD_BYTES]]> + AsMut<[[u8; RECORD_BYTES]]>> RecordMemory for M {}

/// A record of the last maneuver: what fits is kept, the rest of a longer one is not.
#[derive(Debug)]
pub struct Recorder<M> {
    memory: M,
    length: usize,
    last_us: Option<u64>,
}

impl<M: RecordMemory> Recorder<M> {
    /// An empty record in the given memory; its old content does not matter.
    pub const fn new(memory: M) -> Self {
        Self { memory, length: 0, last_us: None }
    }

    /// Forgets the record and begins a new one.
    pub fn clear(&mut self) {
        self.length = 0;
        self.last_us = None;
    }

    /// Adds a tick; its interval is filled in from the clock.
    pub fn push(&mut self, now_us: u64, mut tick: RecordedTick) {
        let Some(slot) = self.memory.as_mut().get_mut(self.length) else {
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
        // Memory is far below u32::MAX ticks.
        self.length as u32
    }

    /// Whether there is nothing.
    pub fn is_empty(&self) -> bool {
        self.length == 0
    }

    /// A run of ticks from `first` on; `None` beyond the end. An empty record has one empty chunk.
    pub fn chunk(&self, first: u32) -> Option<RecordChunk> {
        let recorded = self.memory.as_ref().get(..self.length)?;
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

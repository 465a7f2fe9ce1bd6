//! The event log: the last [`EVENTS`] things that happened, numbered from 1. The first is that the vehicle was started.

use heapless::Deque;
use mintime_shared::messages::{EVENTS, EVENTS_PER_CHUNK, Event, EventChunk, Happening, milliseconds};

/// The ring.
#[derive(Debug, Default)]
pub(crate) struct EventLog {
    ring: Deque<Event, EVENTS>,
    /// Number of the newest.
    newest: u32,
}

impl EventLog {
    pub(crate) const fn new() -> Self {
        Self { ring: Deque::new(), newest: 0 }
    }

    /// Adds an event; the oldest makes room.
    #[inline(never)]
    pub(crate) fn push(&mut self, now_us: u64, what: Happening) {
        if self.newest == 0 {
            self.add(now_us, Happening::Started);
        }
        self.add(now_us, what);
    }

    fn add(&mut self, now_us: u64, what: Happening) {
        if self.ring.is_full() {
            self.ring.pop_front();
        }
        let _ = self.ring.push_back(Event { time_ms: milliseconds(now_us), what });
        self.newest = self.newest.saturating_add(1);
    }

    /// Number of the newest event; 0 for none.
    pub(crate) fn newest(&self) -> u32 {
        self.newest
    }

    /// Events from this number on, as far as they are remembered.
    #[inline(never)]
    pub(crate) fn chunk(&self, first: u32) -> EventChunk {
        // The ring is far shorter than 2³².
        let oldest = self.newest.saturating_add(1).saturating_sub(self.ring.len() as u32);
        let first = first.max(oldest);
        let skip = first.saturating_sub(oldest) as usize;
        let events = self.ring.iter().skip(skip).take(EVENTS_PER_CHUNK).copied().collect();
        EventChunk { first, newest: self.newest, events }
    }
}

//! The accelerator before flash (RM0090 section 3.5.2): which lines its two caches hold.
//!
//! Both are taken as fully associative with replacement of the least recently used line, as the manual says of the
//! instruction cache.
use crate::{
    bus::Cycle,
    memory::{FLASH_BYTES, LINE},
};

const DATA_LINES: usize = 8;
const INSTRUCTION_LINES: usize = 64;
const NONE: u32 = u32::MAX;

/// Lines of the data cache, the most recently used first.
#[derive(Clone, Debug)]
pub(super) struct DataCache {
    lines: [u32; DATA_LINES],
}

impl Default for DataCache {
    fn default() -> Self {
        Self { lines: [NONE; DATA_LINES] }
    }
}

impl DataCache {
    pub(super) fn holds(&self, line: u32) -> bool {
        self.lines.contains(&line)
    }

    /// Reads through the cache: whether it missed, and the line that had to leave (`u32::MAX`: none).
    pub(super) fn touch(&mut self, line: u32) -> (bool, u32) {
        let found = self.lines.iter().position(|held| *held == line);
        let place = found.unwrap_or(DATA_LINES - 1);
        let evicted = if found.is_none() { self.lines[place] } else { NONE };
        self.lines.copy_within(0..place, 1);
        self.lines[0] = line;
        (found.is_none(), evicted)
    }
}

/// Lines of the instruction cache with the time of their last use, and what prefetch has under way.
#[derive(Clone, Debug)]
pub(super) struct InstructionCache {
    lines: [u32; INSTRUCTION_LINES],
    used: [Cycle; INSTRUCTION_LINES],
    /// For every line of flash its place above plus one; 0: not held.
    places: Box<[u8]>,
    /// The line fetched last, and when it had arrived.
    previous: u32,
    since: Cycle,
}

impl Default for InstructionCache {
    fn default() -> Self {
        Self {
            lines: [NONE; INSTRUCTION_LINES],
            used: [0; INSTRUCTION_LINES],
            places: vec![0; (FLASH_BYTES / LINE) as usize].into(),
            previous: NONE - 1,
            since: 0,
        }
    }
}

impl InstructionCache {
    pub(super) fn fetch(
        &mut self,
        line: u32,
        now: Cycle,
        latency: u8,
        caching: bool,
        prefetching: bool,
    ) -> u64 {
        let latency = u64::from(latency);
        let sequential = line == self.previous.wrapping_add(1);
        let place = self.places.get(line as usize).copied().unwrap_or(0);
        let held =
            if caching && place != 0 { Some(usize::from(place - 1) % INSTRUCTION_LINES) } else { None };
        let wait = if held.is_some() {
            0
        } else if prefetching && sequential {
            // Its read began when the line before it arrived.
            latency.saturating_sub(now.saturating_sub(self.since))
        } else {
            latency
        };
        if let Some(place) = held {
            self.used[place] = now;
        } else if caching {
            self.replace(line, now);
        }
        self.previous = line;
        self.since = now + wait;
        wait
    }

    /// Puts `line` where the line least recently used was.
    #[cold]
    fn replace(&mut self, line: u32, now: Cycle) {
        let place = (0..INSTRUCTION_LINES).min_by_key(|&place| self.used[place]).unwrap_or(0);
        if let Some(held) = self.places.get_mut(self.lines[place] as usize) {
            *held = 0;
        }
        if let Some(held) = self.places.get_mut(line as usize) {
            *held = place as u8 + 1;
        }
        self.lines[place] = line;
        self.used[place] = now;
    }
}

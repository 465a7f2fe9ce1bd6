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

/// Lines of the instruction cache in the order of their last uses, and what prefetch has under way.
#[derive(Clone, Debug)]
pub(super) struct InstructionCache {
    lines: [u32; INSTRUCTION_LINES],
    uses: Uses,
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
            uses: Uses::new(),
            places: vec![0; (FLASH_BYTES / LINE) as usize].into(),
            previous: NONE - 1,
            since: 0,
        }
    }
}

impl InstructionCache {
    pub(super) fn holds(&self, line: u32) -> bool {
        self.places.get(line as usize).is_some_and(|place| *place != 0)
    }

    #[inline]
    pub(super) fn fetch(
        &mut self,
        line: u32,
        now: Cycle,
        latency: u8,
        caching: bool,
        prefetching: bool,
    ) -> u64 {
        let place = self.places.get(line as usize).copied().unwrap_or(0);
        let wait = if caching && place != 0 {
            self.uses.note(place - 1);
            0
        } else {
            let sequential = line == self.previous.wrapping_add(1);
            let latency = u64::from(latency);
            let wait = if prefetching && sequential {
                // Its read began when the line before it arrived.
                latency.saturating_sub(now.saturating_sub(self.since))
            } else {
                latency
            };
            if caching {
                self.replace(line);
            }
            wait
        };
        self.previous = line;
        self.since = now + wait;
        wait
    }

    /// Puts `line` where the line least recently used was.
    #[inline(never)]
    fn replace(&mut self, line: u32) {
        let place = self.uses.earliest();
        let held = &mut self.lines[usize::from(place) % INSTRUCTION_LINES];
        if let Some(old) = self.places.get_mut(*held as usize) {
            *old = 0;
        }
        if let Some(new) = self.places.get_mut(line as usize) {
            *new = place + 1;
        }
        *held = line;
        self.uses.note(place);
    }
}

/// The places of the instruction cache in the order of their last uses: a ring of links, closed by [`END`].
#[derive(Clone, Debug)]
struct Uses {
    /// By place, the one used next later and the one used next earlier. Of a size that every index fits.
    later: [u8; 256],
    earlier: [u8; 256],
}

/// Stands in the ring between the place used last and the one used longest ago.
const END: u8 = INSTRUCTION_LINES as u8;

impl Uses {
    /// As if the places had been used from the first to the last, so that they are filled in this order.
    fn new() -> Self {
        let ring =
            |step: usize| std::array::from_fn(|place| ((place + step) % (INSTRUCTION_LINES + 1)) as u8);
        Self { later: ring(1), earlier: ring(INSTRUCTION_LINES) }
    }

    /// The place used longest ago.
    fn earliest(&self) -> u8 {
        self.later[usize::from(END)]
    }

    /// `place` is used now.
    fn note(&mut self, place: u8) {
        self.join(self.earlier[usize::from(place)], self.later[usize::from(place)]);
        self.join(self.earlier[usize::from(END)], place);
        self.join(place, END);
    }

    fn join(&mut self, earlier: u8, later: u8) {
        self.later[usize::from(earlier)] = later;
        self.earlier[usize::from(later)] = earlier;
    }
}

#[cfg(test)]
mod tests {
    use super::{INSTRUCTION_LINES, InstructionCache};

    #[test]
    fn the_line_used_longest_ago_leaves() {
        let mut cache = InstructionCache::default();
        // The model: lines in the order of their last uses, the latest at the end.
        let mut model: Vec<u32> = Vec::new();
        let mut state = 1_u32;
        for _ in 0..100_000 {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            // Loops that fit and loops that do not.
            let line = if state >> 31 == 0 { state >> 8 & 31 } else { state >> 8 & 127 };
            let held = model.iter().position(|&one| one == line);
            match held {
                Some(at) => drop(model.remove(at)),
                None if model.len() == INSTRUCTION_LINES => drop(model.remove(0)),
                None => {}
            }
            model.push(line);
            let wait = cache.fetch(line, 0, 5, true, false);
            assert_eq!(wait == 0, held.is_some());
        }
    }
}

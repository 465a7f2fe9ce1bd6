//! The memories of the chip and the flash interface before them.

mod cache;

use std::ops::Range;

use crate::bus::Cycle;
use cache::{DataCache, InstructionCache};

/// Flash memory, as both of its addresses see it: 0x0800_0000 and, when booting from it, 0.
pub const FLASH_BASE: u32 = 0x0800_0000;
/// 1 MiB (STM32F405RG).
pub const FLASH_BYTES: u32 = 1 << 20;
/// SRAM1 and SRAM2, contiguous.
pub const SRAM_BASE: u32 = 0x2000_0000;
/// 128 KiB.
pub const SRAM_BYTES: u32 = 128 << 10;
/// Core-coupled memory; DMA does not reach it.
pub const CCM_BASE: u32 = 0x1000_0000;
/// 64 KiB.
pub const CCM_BYTES: u32 = 64 << 10;

/// What the core and the DMA controllers read and write without a peripheral taking part.
#[derive(Clone, Debug)]
pub struct Memory {
    /// Flash.
    pub flash: Box<[u8]>,
    /// SRAM1 and SRAM2.
    pub sram: Box<[u8]>,
    /// Core-coupled memory.
    pub ccm: Box<[u8]>,
    /// Timing and caches of flash.
    pub flash_interface: FlashInterface,
    /// Mistakes of the firmware that hardware would answer with silence or with rare failure.
    pub bugs: Vec<Bug>,
    /// Flash that changed and that the core has not yet heard of.
    changes: Vec<Range<u32>>,
    /// Flash that changed after the core had executed it: a fetch before a flush may bring the old instructions.
    suspects: Vec<Range<u32>>,
}

/// One of the memories.
enum Bank {
    Flash,
    Sram,
    Ccm,
}

/// Flash access control (RM0090 section 3.5): wait states, prefetch and the two caches. The FLASH peripheral sets it,
/// the core pays by it.
#[derive(Clone, Debug, Default)]
pub struct FlashInterface {
    /// Wait states, 0..=7.
    pub latency: u8,
    /// Prefetch buffer on.
    pub prefetch: bool,
    /// Instruction cache on (64 lines of 128 bits).
    pub instruction_cache: bool,
    /// Data cache on (8 lines of 128 bits).
    pub data_cache: bool,
    /// Until when an erase or a program operation stalls every access to flash.
    pub busy_until: Cycle,
    /// Counts changes of flash content, so that decoded instructions are thrown away.
    pub generation: u32,
    instructions: InstructionCache,
    data: DataCache,
    /// Lines of the data cache that no longer match flash, with what they hold.
    stale: Vec<(u32, [u8; LINE as usize])>,
    /// One more than the line of the last data read, if reading it again costs and changes nothing; else 0.
    recent: u32,
    /// ICRST since the last look.
    flushed: bool,
}

/// Bytes of a line of flash and of both caches: 128 bits (RM0090 section 3.5.2).
pub(crate) const LINE: u32 = 16;

/// A mistake of the firmware, with when and where.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Bug {
    /// When.
    pub at: Cycle,
    /// Instruction that did it; 0 where none did.
    pub pc: u32,
    /// What, in one sentence.
    pub what: String,
}

impl Memory {
    /// Blank flash (all ones) and RAM with the noise of power-up, made from `seed`.
    pub fn new(seed: u64) -> Self {
        // SplitMix64: any stream of bits that looks like noise will do.
        let mut state = seed;
        let mut noise = |bytes: u32| -> Box<[u8]> {
            (0..bytes / 8)
                .flat_map(|_| {
                    state = state.wrapping_add(0x9E37_79B9_7F4A_7C15);
                    let mut z = state;
                    z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
                    z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
                    (z ^ (z >> 31)).to_le_bytes()
                })
                .collect()
        };
        let (sram, ccm) = (noise(SRAM_BYTES), noise(CCM_BYTES));
        Self {
            flash: vec![0xFF; FLASH_BYTES as usize].into(),
            sram,
            ccm,
            flash_interface: FlashInterface::default(),
            bugs: Vec::new(),
            changes: Vec::new(),
            suspects: Vec::new(),
        }
    }

    /// Notes a mistake of the firmware; the same sentence from the same instruction is noted once.
    pub fn report(&mut self, at: Cycle, pc: u32, what: String) {
        if !self.bugs.iter().any(|bug| bug.pc == pc && bug.what == what) {
            self.bugs.push(Bug { at, pc, what });
        }
    }

    /// The memory that holds all of `bytes` bytes at `address`, and where in it.
    fn locate(&self, address: u32, bytes: u32) -> Option<(Bank, Range<usize>)> {
        let (bank, offset, size) = match address >> 24 {
            0x00 | 0x08 => (Bank::Flash, address & !FLASH_BASE, FLASH_BYTES),
            0x10 => (Bank::Ccm, address - CCM_BASE, CCM_BYTES),
            0x20 => (Bank::Sram, address - SRAM_BASE, SRAM_BYTES),
            _ => return None,
        };
        let end = offset.checked_add(bytes).filter(|end| *end <= size)?;
        Some((bank, offset as usize..end as usize))
    }

    /// Looks at memory as a debugger does; `None` where not all of it is memory.
    pub fn peek(&self, address: u32, bytes: u32) -> Option<&[u8]> {
        let (bank, range) = self.locate(address, bytes)?;
        match bank {
            Bank::Flash => self.flash.get(range),
            Bank::Sram => self.sram.get(range),
            Bank::Ccm => self.ccm.get(range),
        }
    }

    /// Puts bytes into memory as a debugger or programmer does; `None`, and nothing done, where not all of it is
    /// memory.
    pub fn place(&mut self, address: u32, bytes: &[u8]) -> Option<()> {
        let (bank, range) = self.locate(address, u32::try_from(bytes.len()).ok()?)?;
        match bank {
            Bank::Flash => self.overwrite_flash(range.start as u32, bytes),
            Bank::Sram => self.sram.get_mut(range)?.copy_from_slice(bytes),
            Bank::Ccm => self.ccm.get_mut(range)?.copy_from_slice(bytes),
        }
        Some(())
    }

    /// Writes flash content as the flash controller does: bits only fall. `offset` counts from the start of flash.
    pub fn program_flash(&mut self, offset: u32, bytes: &[u8]) {
        let range = self.changing(offset, bytes.len());
        for (cell, byte) in self.flash[range].iter_mut().zip(bytes) {
            *cell &= byte;
        }
    }

    /// Replaces flash content, as an erase (0xFF) or an erase cut short (garbage) does.
    pub fn overwrite_flash(&mut self, offset: u32, bytes: &[u8]) {
        let range = self.changing(offset, bytes.len());
        for (cell, byte) in self.flash[range].iter_mut().zip(bytes) {
            *cell = *byte;
        }
    }

    /// Prepares a change: cached lines keep what they hold. The range ends where flash does.
    fn changing(&mut self, offset: u32, bytes: usize) -> Range<usize> {
        let start = (offset as usize).min(self.flash.len());
        let end = (start + bytes).min(self.flash.len());
        let (first, last) = (start as u32, end as u32);
        let interface = &mut self.flash_interface;
        for line in first / LINE..last.div_ceil(LINE) {
            let at = (line * LINE) as usize;
            if interface.data_cache
                && interface.data.holds(line)
                && interface.stale_line(line * LINE).is_none()
                && let Some(Ok(content)) = self.flash.get(at..at + LINE as usize).map(TryInto::try_into)
            {
                interface.stale.push((line, content));
            }
        }
        interface.generation = interface.generation.wrapping_add(1);
        interface.recent = 0;
        match self.changes.last_mut() {
            Some(last_change) if last_change.end == first => last_change.end = last,
            _ => self.changes.push(first..last),
        }
        start..end
    }

    /// Whether flash changed since [`take_changes`](Self::take_changes).
    pub(crate) fn has_changes(&self) -> bool {
        !self.changes.is_empty()
    }

    /// What changed in flash since last asked.
    pub(crate) fn take_changes(&mut self) -> Vec<Range<u32>> {
        std::mem::take(&mut self.changes)
    }

    /// Instructions in `range` had been executed before it changed.
    pub(crate) fn suspect_fetches(&mut self, range: Range<u32>) {
        if std::mem::take(&mut self.flash_interface.flushed) {
            self.suspects.clear();
        }
        if self.flash_interface.instruction_cache {
            self.suspects.push(range);
        }
    }

    /// An instruction is fetched and decoded anew; reports those that a stale line may hold.
    pub(crate) fn check_fetch(&mut self, at: Cycle, offset: u32) {
        if std::mem::take(&mut self.flash_interface.flushed) {
            self.suspects.clear();
        }
        if self.suspects.iter().any(|range| range.contains(&offset)) {
            let pc = offset | FLASH_BASE;
            let what = "instruction changed in flash after it had run: the instruction cache may still hold the \
                        old one (ICRST missing)";
            self.report(at, pc, what.to_owned());
        }
    }
}

impl FlashInterface {
    /// ACR.ICRST: empties the instruction cache.
    pub fn flush_instruction_cache(&mut self) {
        self.instructions = InstructionCache::default();
        self.flushed = true;
    }

    /// ACR.DCRST: empties the data cache.
    pub fn flush_data_cache(&mut self) {
        self.data = DataCache::default();
        self.stale.clear();
        self.recent = 0;
    }

    /// Whether a read at `offset` needs no look at the cache.
    #[inline(always)]
    pub(crate) fn is_recent(&self, offset: u32) -> bool {
        (offset / LINE) + 1 == self.recent
    }

    /// Settings or content may have changed.
    pub(crate) fn forget_recent(&mut self) {
        self.recent = 0;
    }

    /// A data read at `offset`; whether it has to wait for flash.
    pub(crate) fn touch_data(&mut self, offset: u32) -> bool {
        let line = offset / LINE;
        if !self.data_cache {
            return true;
        }
        let (miss, evicted) = self.data.touch(line);
        if evicted != u32::MAX && !self.stale.is_empty() {
            self.stale.retain(|(stale, _)| *stale != evicted);
        }
        self.recent = if self.stale.is_empty() { line + 1 } else { 0 };
        miss
    }

    /// The old content of the line at `offset`, where the data cache holds one that no longer matches flash.
    pub(crate) fn stale_line(&self, offset: u32) -> Option<[u8; LINE as usize]> {
        let line = offset / LINE;
        self.stale.iter().find(|(stale, _)| *stale == line).map(|(_, content)| *content)
    }

    /// Whether instructions at `offset` come from the cache at once.
    pub(crate) fn holds_instructions(&self, offset: u32) -> bool {
        self.instruction_cache && self.instructions.holds(offset / LINE)
    }

    /// Instructions are fetched from `line` at `now`: cycles until they arrive.
    // Not into the interpreter's loop, which needs the host's registers.
    #[inline(never)]
    pub(crate) fn fetch(&mut self, line: u32, now: Cycle) -> u64 {
        self.instructions.fetch(line, now, self.latency, self.instruction_cache, self.prefetch)
    }
}

//! The memories of the chip and the flash interface before them.

use crate::bus::Cycle;

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
}

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
        }
    }

    /// Notes a mistake of the firmware; the same sentence from the same instruction is noted once.
    pub fn report(&mut self, at: Cycle, pc: u32, what: String) {
        if !self.bugs.iter().any(|bug| bug.pc == pc && bug.what == what) {
            self.bugs.push(Bug { at, pc, what });
        }
    }

    /// Writes flash content as the flash controller does: bits only fall. `offset` counts from the start of flash.
    pub fn program_flash(&mut self, offset: u32, bytes: &[u8]) {
        for (cell, byte) in self.flash[offset as usize..].iter_mut().zip(bytes) {
            *cell &= byte;
        }
        self.flash_interface.generation += 1;
    }

    /// Replaces flash content, as an erase (0xFF) or an erase cut short (garbage) does.
    pub fn overwrite_flash(&mut self, offset: u32, bytes: &[u8]) {
        self.flash[offset as usize..offset as usize + bytes.len()].copy_from_slice(bytes);
        self.flash_interface.generation += 1;
    }
}

impl FlashInterface {
    /// ACR.ICRST: empties the instruction cache.
    pub fn flush_instruction_cache(&mut self) {}

    /// ACR.DCRST: empties the data cache.
    pub fn flush_data_cache(&mut self) {}
}

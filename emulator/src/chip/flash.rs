//! The flash interface: access control, erasing and programming (RM0090 section 3).

use crate::bus::Cycle;
use crate::memory::Memory;

const KEYS: [u32; 2] = [0x4567_0123, 0xCDEF_89AB];
const OPTION_KEYS: [u32; 2] = [0x0819_2A3B, 0x4C5D_6E7F];

const SR_EOP: u32 = 1;
const SR_OPERR: u32 = 1 << 1;
const SR_PGPERR: u32 = 1 << 6;
const SR_PGSERR: u32 = 1 << 7;
const SR_BSY: u32 = 1 << 16;
const SR_ERRORS: u32 = 0xF0;
const CR_PG: u32 = 1;
const CR_SER: u32 = 1 << 1;
const CR_MER: u32 = 1 << 2;
const CR_STRT: u32 = 1 << 16;
const CR_EOPIE: u32 = 1 << 24;
const CR_ERRIE: u32 = 1 << 25;
const CR_LOCK: u32 = 1 << 31;
const ACR_ICEN: u32 = 1 << 9;
const ACR_DCEN: u32 = 1 << 10;
const ACR_ICRST: u32 = 1 << 11;
const ACR_DCRST: u32 = 1 << 12;

/// Time of one programming operation of any width (DS8626, flash programming: 16 µs typical).
const PROGRAM_NS: u64 = 16_000;
/// Highest HCLK without a wait state at 2.7 to 3.6 V, and the step for each further one (RM0090 table 10).
pub(crate) const HZ_PER_WAIT_STATE: u32 = 30_000_000;

/// How far an erase goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Erase {
    offset: u32,
    bytes: u32,
}

/// The registers.
#[derive(Clone, Debug)]
pub(crate) struct Flash {
    acr: u32,
    sr: u32,
    cr: u32,
    keys_seen: usize,
    /// A wrong key closes the lock until the next reset.
    locked_out: bool,
    option_keys_seen: usize,
    optcr: u32,
    erase: Option<Erase>,
    /// The programming under way: where, and what was there.
    programming: Option<(u32, Vec<u8>)>,
    busy: bool,
    /// Where erase times lie between typical (0) and longest (1).
    pub(crate) slowness: f64,
}

/// What the chip must do after a write.
#[derive(Clone, Debug, Default)]
pub(crate) struct Done {
    /// The operation that began takes this long (ns).
    pub(crate) busy_ns: Option<u64>,
    /// A mistake.
    pub(crate) bug: Option<String>,
    /// Wait states or caches may have changed.
    pub(crate) access_control: bool,
}

impl Done {
    fn bug(text: &str) -> Self {
        Self { bug: Some(text.into()), ..Self::default() }
    }
}

impl Flash {
    pub(crate) fn new() -> Self {
        Self {
            acr: 0,
            sr: 0,
            cr: CR_LOCK,
            keys_seen: 0,
            locked_out: false,
            option_keys_seen: 0,
            optcr: 0x0FFF_AAED,
            erase: None,
            programming: None,
            busy: false,
            slowness: 0.0,
        }
    }

    /// A system reset. An erase under way stops where it is: the sector stays garbage.
    pub(crate) fn reset(&mut self) {
        *self = Self { slowness: self.slowness, ..Self::new() };
    }

    /// Wait states set.
    pub(crate) fn latency(&self) -> u32 {
        self.acr & 7
    }

    /// The level of the interrupt line.
    pub(crate) fn interrupt(&self) -> bool {
        self.sr & SR_EOP != 0 && self.cr & CR_EOPIE != 0 || self.sr & SR_OPERR != 0 && self.cr & CR_ERRIE != 0
    }

    pub(crate) fn read(&self, offset: u32) -> u32 {
        match offset {
            0x00 => self.acr,
            0x0C => self.sr | if self.busy { SR_BSY } else { 0 },
            0x10 => self.cr,
            0x14 => self.optcr,
            _ => 0,
        }
    }

    pub(crate) fn write(&mut self, memory: &mut Memory, now: Cycle, offset: u32, value: u32) -> Done {
        match offset {
            0x00 => self.write_acr(memory, value),
            0x04 => self.write_key(value),
            0x08 => {
                let expected = OPTION_KEYS[self.option_keys_seen.min(1)];
                self.option_keys_seen = if value == expected { self.option_keys_seen + 1 } else { 0 };
                if self.option_keys_seen == 2 {
                    self.optcr &= !1;
                }
                Done::default()
            }
            0x0C => {
                self.sr &= !(value & (SR_ERRORS | SR_EOP | SR_OPERR));
                Done::default()
            }
            0x10 => self.write_cr(memory, now, value),
            0x14 => {
                if self.optcr & 1 == 0 {
                    self.optcr = value & 0x0FFF_FFED;
                    Done::bug("the firmware rewrites option bytes, which is a step of set-up")
                } else {
                    Done::bug("FLASH_OPTCR is written while it is locked")
                }
            }
            _ => Done::default(),
        }
    }

    /// A write into flash memory itself: programming, if everything is right (RM0090 section 3.6.4).
    pub(crate) fn program(&mut self, memory: &mut Memory, offset: u32, bytes: &[u8]) -> Done {
        if self.cr & CR_PG == 0 || self.cr & (CR_SER | CR_MER) != 0 {
            self.fail(SR_PGSERR);
            return Done::bug("flash is written while FLASH_CR.PG is off");
        }
        if self.busy {
            self.fail(SR_PGSERR);
            return Done::bug("flash is written while an operation is under way");
        }
        if self.sr & SR_ERRORS != 0 {
            return Done::bug("flash is written while an error flag of FLASH_SR is set");
        }
        if 1 << (self.cr >> 8 & 3) != bytes.len() {
            self.fail(SR_PGPERR);
            return Done::bug("flash is written with another width than FLASH_CR.PSIZE says");
        }
        let place = offset as usize;
        let raises = memory.flash.get(place..place + bytes.len()).is_some_and(|old| {
            // A word may be written again only if no bit has to rise.
            old.iter().zip(bytes).any(|(old, new)| !old & new != 0)
        });
        self.programming = memory.flash.get(place..place + bytes.len()).map(|old| (offset, old.to_vec()));
        memory.program_flash(offset, bytes);
        self.busy = true;
        Done {
            busy_ns: Some(PROGRAM_NS),
            bug: raises.then(|| "flash is programmed where it was not erased".into()),
            ..Done::default()
        }
    }

    /// The operation is done.
    pub(crate) fn finish(&mut self, memory: &mut Memory) {
        self.busy = false;
        self.programming = None;
        self.cr &= !CR_STRT;
        if self.cr & CR_EOPIE != 0 {
            self.sr |= SR_EOP;
        }
        if let Some(Erase { offset, bytes }) = self.erase.take() {
            memory.overwrite_flash(offset, &vec![0xFF; bytes as usize]);
        }
    }

    /// The power fails: of what is being programmed some bits have fallen (an erase under way has left garbage already).
    pub(crate) fn cut(&mut self, memory: &mut Memory, noise: u64) {
        let Some((offset, old)) = self.programming.take() else { return };
        let at = offset as usize;
        let cut: Vec<u8> = old
            .iter()
            .zip(memory.flash[at..at + old.len()].iter())
            .zip(noise.to_le_bytes())
            .map(|((old, new), some)| new | old & some)
            .collect();
        memory.overwrite_flash(offset, &cut);
    }

    fn fail(&mut self, flag: u32) {
        self.sr |= flag;
        if self.cr & CR_ERRIE != 0 {
            self.sr |= SR_OPERR;
        }
    }

    fn write_acr(&mut self, memory: &mut Memory, value: u32) -> Done {
        let mut done = Done { access_control: true, ..Done::default() };
        let interface = &mut memory.flash_interface;
        if value & ACR_ICRST != 0 {
            if self.acr & value & ACR_ICEN != 0 {
                done.bug = Some("FLASH_ACR.ICRST is set while the instruction cache is on".into());
            } else {
                interface.flush_instruction_cache();
            }
        }
        if value & ACR_DCRST != 0 {
            if self.acr & value & ACR_DCEN != 0 {
                done.bug = Some("FLASH_ACR.DCRST is set while the data cache is on".into());
            } else {
                interface.flush_data_cache();
            }
        }
        self.acr = value & 0x1F07;
        interface.latency = (value & 7) as u8;
        interface.prefetch = value >> 8 & 1 == 1;
        interface.instruction_cache = value & ACR_ICEN != 0;
        interface.data_cache = value & ACR_DCEN != 0;
        done
    }

    fn write_key(&mut self, value: u32) -> Done {
        if self.cr & CR_LOCK == 0 {
            return Done::default();
        }
        if self.locked_out || value != KEYS[self.keys_seen.min(1)] {
            self.locked_out = true;
            return Done::bug("FLASH_KEYR is given a wrong key: flash stays locked until the next reset");
        }
        self.keys_seen += 1;
        if self.keys_seen == 2 {
            self.keys_seen = 0;
            self.cr &= !CR_LOCK;
        }
        Done::default()
    }

    fn write_cr(&mut self, memory: &mut Memory, now: Cycle, value: u32) -> Done {
        if self.cr & CR_LOCK != 0 {
            return Done::bug("FLASH_CR is written while it is locked");
        }
        if self.busy {
            return Done::bug("FLASH_CR is written while an operation is under way");
        }
        // STRT is set by software and cleared by the end of the operation; LOCK is set until the keys come again.
        self.cr = value & 0x8301_03FF & !CR_STRT;
        if value & CR_STRT == 0 {
            return Done::default();
        }
        let width = self.cr >> 8 & 3;
        let (range, busy_ns) = if self.cr & CR_MER != 0 {
            (
                Erase { offset: 0, bytes: crate::memory::FLASH_BYTES },
                self.erase_ns(crate::memory::FLASH_BYTES, width),
            )
        } else if self.cr & CR_SER != 0 {
            let Some(range) = sector(self.cr >> 3 & 0xF) else {
                self.fail(SR_PGSERR);
                return Done::bug("an erase names a sector this flash does not have");
            };
            (range, self.erase_ns(range.bytes, width))
        } else {
            return Done::bug("FLASH_CR.STRT is set with nothing to do");
        };
        // Until the erase is done the content is neither old nor blank.
        let mut state = now ^ u64::from(range.offset);
        let noise: Vec<u8> = (0..range.bytes)
            .map(|_| {
                state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
                (state >> 56) as u8
            })
            .collect();
        memory.overwrite_flash(range.offset, &noise);
        self.erase = Some(range);
        self.busy = true;
        self.cr |= CR_STRT;
        Done { busy_ns: Some(busy_ns), ..Done::default() }
    }

    /// Typical and longest erase times by width of programming (DS8626, flash memory programming).
    fn erase_ns(&self, bytes: u32, width: u32) -> u64 {
        let column = width.min(2) as usize;
        let (typical_ms, longest_ms) = match bytes {
            0x4000 => [(400, 800), (300, 600), (250, 500)][column],
            0x1_0000 => [(1200, 2400), (700, 1400), (550, 1100)][column],
            0x2_0000 => [(2000, 4000), (1300, 2600), (1000, 2000)][column],
            _ => [(16_000, 32_000), (11_000, 22_000), (8_000, 16_000)][column],
        };
        let slow = self.slowness.clamp(0.0, 1.0);
        ((f64::from(typical_ms) * (1.0 - slow) + f64::from(longest_ms) * slow) * 1e6) as u64
    }
}

/// Sectors 0 to 3 are 16 KiB, 4 is 64 KiB, 5 to 11 are 128 KiB (RM0090 table 5).
fn sector(number: u32) -> Option<Erase> {
    match number {
        0..=3 => Some(Erase { offset: number * 0x4000, bytes: 0x4000 }),
        4 => Some(Erase { offset: 0x1_0000, bytes: 0x1_0000 }),
        5..=11 => Some(Erase { offset: (number - 4) * 0x2_0000, bytes: 0x2_0000 }),
        _ => None,
    }
}

//! The registers of a DMA controller (RM0090 section 10.5).

use super::dma_requests::Request;

/// A stream is on.
pub(crate) const CR_EN: u32 = 1;
const CR_PFCTRL: u32 = 1 << 5;
/// Starts again at its end.
pub(crate) const CR_CIRC: u32 = 1 << 8;
const CR_PINC: u32 = 1 << 9;
const CR_MINC: u32 = 1 << 10;
const CR_PINCOS: u32 = 1 << 15;
const CR_DBM: u32 = 1 << 18;
const CR_CT: u32 = 1 << 19;

/// Flags of a stream, as they lie in its six bits of LISR or HISR.
pub(crate) const FEIF: u8 = 1;
/// Direct mode error.
pub(crate) const DMEIF: u8 = 1 << 2;
/// Transfer error.
pub(crate) const TEIF: u8 = 1 << 3;
/// Half of the items are done.
pub(crate) const HTIF: u8 = 1 << 4;
/// All items are done, or software has switched the stream off.
pub(crate) const TCIF: u8 = 1 << 5;

/// Which way a stream carries.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Direction {
    PeripheralToMemory,
    MemoryToPeripheral,
    MemoryToMemory,
}

/// One stream.
#[derive(Clone, Debug, Default)]
pub(crate) struct Stream {
    pub(crate) cr: u32,
    ndtr: u16,
    par: u32,
    memory: [u32; 2],
    fcr: u32,
    pub(crate) flags: u8,
    /// Items left.
    pub(crate) left: u16,
    /// Where the next peripheral-side access goes.
    pub(crate) peripheral_at: u32,
    /// Where the next memory-side access goes.
    pub(crate) memory_at: u32,
    /// Bytes between the two sides.
    pub(crate) fifo: [u8; 16],
    /// How many of them.
    pub(crate) fifo_used: usize,
    /// What can ask while it is on.
    pub(crate) requests: &'static [Request],
}

/// What the chip must do after a write.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Done {
    /// This stream was switched on.
    pub(crate) enabled: Option<usize>,
    /// This stream was switched off.
    pub(crate) disabled: Option<usize>,
    /// A mistake.
    pub(crate) bug: Option<&'static str>,
}

/// A controller: eight streams.
#[derive(Clone, Debug)]
pub(crate) struct Dma {
    pub(crate) streams: [Stream; 8],
    /// Streams that are on, as bits.
    pub(crate) on: u8,
}

impl Stream {
    pub(crate) fn enabled(&self) -> bool {
        self.cr & CR_EN != 0
    }

    pub(crate) fn channel(&self) -> u8 {
        (self.cr >> 25 & 7) as u8
    }

    pub(crate) fn priority(&self) -> u32 {
        self.cr >> 16 & 3
    }

    pub(crate) fn direction(&self) -> Direction {
        match self.cr >> 6 & 3 {
            0 => Direction::PeripheralToMemory,
            1 => Direction::MemoryToPeripheral,
            _ => Direction::MemoryToMemory,
        }
    }

    /// Bytes of an item on the peripheral side.
    pub(crate) fn peripheral_bytes(&self) -> u32 {
        1 << (self.cr >> 11 & 3).min(2)
    }

    /// Bytes of an access on the memory side: in direct mode those of the peripheral side (RM0090 section 10.3.13).
    pub(crate) fn memory_bytes(&self) -> u32 {
        if self.direct() { self.peripheral_bytes() } else { 1 << (self.cr >> 13 & 3).min(2) }
    }

    fn direct(&self) -> bool {
        self.fcr >> 2 & 1 == 0 && self.direction() != Direction::MemoryToMemory
    }

    /// Moves the peripheral-side address on.
    pub(crate) fn advance_peripheral(&mut self) {
        if self.cr & CR_PINC != 0 {
            let step = if self.cr & CR_PINCOS != 0 { 4 } else { self.peripheral_bytes() };
            self.peripheral_at = self.peripheral_at.wrapping_add(step);
        }
    }

    /// Moves the memory-side address on.
    pub(crate) fn advance_memory(&mut self) {
        if self.cr & CR_MINC != 0 {
            self.memory_at = self.memory_at.wrapping_add(self.memory_bytes());
        }
    }

    /// Whether a stream to a peripheral has room for another access to memory, and something is left to read.
    pub(crate) fn reads_ahead(&self) -> bool {
        let (item, access) = (self.peripheral_bytes() as usize, self.memory_bytes() as usize);
        let room =
            if self.direct() { self.fifo_used < item } else { self.fifo_used + access <= self.fifo.len() };
        self.enabled() && room && usize::from(self.left) * item > self.fifo_used
    }

    /// Counts an item. Answers whether the stream has come to its end and is off now.
    pub(crate) fn count_item(&mut self) -> bool {
        self.left = self.left.saturating_sub(1);
        if self.left == self.ndtr / 2 {
            self.flags |= HTIF;
        }
        if self.left > 0 {
            return false;
        }
        self.flags |= TCIF;
        if self.cr & (CR_CIRC | CR_DBM) != 0 {
            if self.cr & CR_DBM != 0 {
                self.cr ^= CR_CT;
            }
            self.rewind();
            return false;
        }
        self.cr &= !CR_EN;
        true
    }

    /// A bus error: the stream goes off.
    pub(crate) fn fail(&mut self, flag: u8) {
        self.flags |= flag;
        self.cr &= !CR_EN;
    }

    fn rewind(&mut self) {
        self.left = self.ndtr;
        self.peripheral_at = self.par;
        self.memory_at = self.memory[(self.cr & CR_CT != 0) as usize];
    }

    pub(crate) fn interrupt(&self) -> bool {
        // DMEIE to TCIE lie one bit below their flags.
        let enabled = (self.cr << 1) as u8 & (DMEIF | TEIF | HTIF | TCIF) | (self.fcr >> 7) as u8 & FEIF;
        self.flags & enabled != 0
    }
}

impl Dma {
    pub(crate) fn new() -> Self {
        Self { streams: std::array::from_fn(|_| Stream { fcr: 0x21, ..Stream::default() }), on: 0 }
    }

    /// The levels of the streams' interrupt lines, as bits.
    pub(crate) fn interrupts(&self) -> u8 {
        self.streams
            .iter()
            .enumerate()
            .fold(0, |lines, (n, stream)| lines | u8::from(stream.interrupt()) << n)
    }

    /// Brings [`Self::on`] up to date.
    pub(crate) fn note(&mut self, stream: usize) {
        let bit = 1 << stream;
        if self.streams[stream].enabled() { self.on |= bit } else { self.on &= !bit }
    }

    pub(crate) fn read(&self, offset: u32) -> u32 {
        match offset {
            0x00 => self.status(0),
            0x04 => self.status(4),
            0x10..=0xCC => {
                let stream = &self.streams[((offset as usize - 0x10) / 0x18) & 7];
                match (offset - 0x10) % 0x18 {
                    0x00 => stream.cr,
                    0x04 => u32::from(if stream.enabled() { stream.left } else { stream.rest() }),
                    0x08 => stream.par,
                    0x0C => stream.memory[0],
                    0x10 => stream.memory[1],
                    _ => stream.fcr & 0x87 | stream.fifo_status() << 3,
                }
            }
            _ => 0,
        }
    }

    pub(crate) fn write(&mut self, offset: u32, value: u32) -> Done {
        match offset {
            0x08 => self.clear(0, value),
            0x0C => self.clear(4, value),
            0x10..=0xCC => {
                let index = ((offset as usize - 0x10) / 0x18) & 7;
                let done = self.streams[index].write((offset - 0x10) % 0x18, value, index);
                self.note(index);
                return done;
            }
            _ => {}
        }
        Done::default()
    }

    fn status(&self, first: usize) -> u32 {
        let of = |n: usize| u32::from(self.streams[first + n].flags);
        of(0) | of(1) << 6 | of(2) << 16 | of(3) << 22
    }

    fn clear(&mut self, first: usize, value: u32) {
        for (n, shift) in [0, 6, 16, 22].into_iter().enumerate() {
            self.streams[first + n].flags &= !(value >> shift) as u8;
        }
    }
}

impl Stream {
    /// Items left while the stream is off.
    fn rest(&self) -> u16 {
        self.left
    }

    fn fifo_status(&self) -> u32 {
        match self.fifo_used {
            0 => 4,
            n @ 1..16 => (n / 4) as u32,
            _ => 5,
        }
    }

    fn write(&mut self, register: u32, value: u32, index: usize) -> Done {
        const BUSY: &str = "a register of a DMA stream is written while the stream is on";
        let mut done = Done::default();
        let on = self.enabled();
        match register {
            0x00 => {
                if on && value & CR_EN != 0 {
                    // Of a running stream only the interrupt enables may change, and circular mode may end.
                    const LOCKED: u32 = 0x0FFF_FFE0 & !CR_CIRC & !CR_CT;
                    if (value ^ self.cr) & LOCKED != 0 {
                        done.bug = Some("the set-up of a DMA stream is changed while the stream is on");
                    }
                    self.cr = self.cr & LOCKED | value & !LOCKED;
                    return done;
                }
                self.cr = value & 0x0FEF_FFFF;
                if !on && value & CR_EN != 0 {
                    if self.flags & (TCIF | HTIF | TEIF) != 0 {
                        done.bug =
                            Some("a DMA stream is switched on with flags of its last transfer still set");
                    }
                    if value & CR_PFCTRL != 0 {
                        done.bug =
                            Some("a DMA stream lets the peripheral control the flow, which is not emulated");
                    }
                    if self.left == 0 {
                        // A stream that came to its end starts over with what NDTR was last written with; one that was
                        // switched off before goes on with what was left (RM0090 sections 10.5.6 and 10.3.14).
                        self.left = self.ndtr;
                    }
                    if self.left == 0 {
                        // Nothing to do: EN falls at once.
                        self.cr &= !CR_EN;
                        done.bug = Some("a DMA stream is switched on with nothing to transfer");
                        return done;
                    }
                    self.ndtr = self.left;
                    self.fifo_used = 0;
                    self.rewind();
                    done.enabled = Some(index);
                } else if on {
                    self.flags |= TCIF;
                    done.disabled = Some(index);
                }
            }
            0x04 if on => done.bug = Some(BUSY),
            0x04 => (self.ndtr, self.left) = (value as u16, value as u16),
            0x08 if on => done.bug = Some(BUSY),
            0x08 => self.par = value,
            0x0C | 0x10 => {
                let which = (register as usize - 0x0C) / 4;
                // In double-buffer mode the buffer not in use may be changed.
                let in_use = (self.cr & CR_CT != 0) as usize == which;
                if on && (self.cr & CR_DBM == 0 || in_use) {
                    done.bug = Some(BUSY);
                } else {
                    self.memory[which] = value;
                }
            }
            _ if on => done.bug = Some(BUSY),
            _ => self.fcr = value & 0x87,
        }
        done
    }
}

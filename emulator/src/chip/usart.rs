//! The registers and shifters of a serial port (RM0090 section 30.6).

use crate::bus::Cycle;

const SR_PE: u32 = 1;
const SR_FE: u32 = 1 << 1;
const SR_NF: u32 = 1 << 2;
const SR_ORE: u32 = 1 << 3;
const SR_IDLE: u32 = 1 << 4;
const SR_RXNE: u32 = 1 << 5;
const SR_TC: u32 = 1 << 6;
const SR_TXE: u32 = 1 << 7;
/// Flags that go when SR and then DR are read.
const SR_READ_CLEARS: u32 = SR_PE | SR_FE | SR_NF | SR_ORE | SR_IDLE;
const CR1_SBK: u32 = 1;
const CR1_RE: u32 = 1 << 2;
const CR1_TE: u32 = 1 << 3;
const CR1_UE: u32 = 1 << 13;
const CR1_RWU: u32 = 1 << 1;
const CR2_CLKEN: u32 = 1 << 11;
const CR2_LINEN: u32 = 1 << 14;
const CR3_IREN: u32 = 1 << 1;
const CR3_HDSEL: u32 = 1 << 3;
const CR3_SCEN: u32 = 1 << 5;
const CR3_FLOW: u32 = 3 << 8;

/// What is in the shift register of the sender.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Sending {
    /// The idle frame that opens a transmission.
    Preamble,
    /// A break.
    Break,
    /// A word.
    Word(u16),
}

/// What [`Usart::sent`] put on the line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Sent {
    /// Nothing to see.
    Nothing,
    /// A byte.
    Byte(u8),
    /// A break.
    Break,
}

/// A frame as the receiver sampled it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Frame {
    /// Data bits, parity included.
    pub(crate) word: u16,
    /// No stop bit where one is due.
    pub(crate) framing: bool,
    /// Samples of a bit differ.
    pub(crate) noise: bool,
}

/// One serial port.
#[derive(Clone, Debug)]
pub(crate) struct Usart {
    sr: u32,
    /// Flags seen by the last read of SR.
    seen: u32,
    /// TC among them: a write to DR clears it then, and only then (RM0090 section 30.6.1).
    complete_seen: bool,
    /// A use that is not emulated, until it is told.
    bug: Option<&'static str>,
    brr: u32,
    cr1: u32,
    cr2: u32,
    cr3: u32,
    gtpr: u32,
    received: u16,
    waiting: Option<u16>,
    sending: Option<Sending>,
    /// A byte has come since the line was last reported idle.
    heard: bool,
    opened: bool,
}

impl Usart {
    pub(crate) fn new() -> Self {
        Self {
            sr: SR_TXE | SR_TC,
            seen: 0,
            complete_seen: false,
            bug: None,
            brr: 0,
            cr1: 0,
            cr2: 0,
            cr3: 0,
            gtpr: 0,
            received: 0,
            waiting: None,
            sending: None,
            heard: false,
            opened: false,
        }
    }

    /// Cycles of the bus clock in a bit: BRR counts sixteenths or, with OVER8, eighths of the divider's inverse
    /// (RM0090 section 30.3.4).
    pub(crate) fn bit_cycles(&self) -> u32 {
        let cycles =
            if self.cr1 >> 15 & 1 == 1 { (self.brr & 0xFFF0) >> 1 | self.brr & 7 } else { self.brr & 0xFFFF };
        cycles.max(8)
    }

    /// Whether a speed has been set.
    pub(crate) fn has_speed(&self) -> bool {
        self.brr != 0
    }

    /// Bits between start and stop, parity included.
    pub(crate) fn word_bits(&self) -> u32 {
        if self.cr1 >> 12 & 1 == 1 { 9 } else { 8 }
    }

    /// Length of a whole frame in half bits.
    fn frame_half_bits(&self) -> u32 {
        let stop = [2, 1, 4, 3][(self.cr2 >> 12 & 3) as usize];
        2 * (1 + self.word_bits()) + stop
    }

    /// Length of a frame [cycles of the core], where the bus clock takes `divider` of them.
    pub(crate) fn frame_cycles(&self, divider: u32) -> u64 {
        u64::from(self.frame_half_bits()) * u64::from(self.bit_cycles()) * u64::from(divider) / 2
    }

    pub(crate) fn receiving(&self) -> bool {
        self.cr1 & (CR1_UE | CR1_RE) == CR1_UE | CR1_RE
    }

    fn transmitting(&self) -> bool {
        self.cr1 & (CR1_UE | CR1_TE) == CR1_UE | CR1_TE
    }

    /// The level of the interrupt line (RM0090 table 148).
    pub(crate) fn interrupt(&self) -> bool {
        let enabled = |bit: u32| self.cr1 >> bit & 1 == 1;
        self.sr & SR_TXE != 0 && enabled(7)
            || self.sr & SR_TC != 0 && enabled(6)
            || self.sr & (SR_RXNE | SR_ORE) != 0 && enabled(5)
            || self.sr & SR_IDLE != 0 && enabled(4)
            || self.sr & SR_PE != 0 && enabled(8)
            || self.sr & (SR_FE | SR_NF | SR_ORE) != 0 && self.cr3 & 1 == 1 && self.cr3 >> 6 & 1 == 1
    }

    /// Whether the receiver asks for DMA.
    pub(crate) fn receive_requested(&self) -> bool {
        self.cr3 >> 6 & 1 == 1 && self.sr & SR_RXNE != 0
    }

    /// Whether the sender asks for DMA.
    pub(crate) fn transmit_requested(&self) -> bool {
        self.cr3 >> 7 & 1 == 1 && self.sr & SR_TXE != 0
    }

    pub(crate) fn read(&mut self, offset: u32) -> u32 {
        match offset {
            0x00 => {
                self.seen = self.sr & SR_READ_CLEARS;
                self.complete_seen = self.sr & SR_TC != 0;
                self.sr
            }
            0x04 => {
                self.sr &= !(self.seen | SR_RXNE);
                self.seen = 0;
                u32::from(self.received)
            }
            0x08 => self.brr,
            0x0C => self.cr1,
            0x10 => self.cr2,
            0x14 => self.cr3,
            0x18 => self.gtpr,
            _ => 0,
        }
    }

    /// Whether the receiver has just been switched on: a line that is idle then is told once, too.
    pub(crate) fn take_opened(&mut self) -> bool {
        std::mem::take(&mut self.opened)
    }

    /// The answer is when the shift register will be empty, if it has just been filled.
    pub(crate) fn write(&mut self, offset: u32, value: u32, now: Cycle, divider: u32) -> Option<Cycle> {
        match offset {
            // RXNE, TC, LBD and CTS are cleared by writing zero.
            0x00 => self.sr &= value | !(SR_RXNE | SR_TC | 0x300),
            0x04 => {
                self.sr &= !SR_TXE;
                if std::mem::take(&mut self.complete_seen) {
                    self.sr &= !SR_TC;
                }
                self.waiting = Some((value & 0x1FF) as u16);
                return self.load(now, divider);
            }
            0x08 => self.brr = value & 0xFFFF,
            0x0C => {
                let (was_transmitting, was_receiving) = (self.transmitting(), self.receiving());
                self.cr1 = value & 0xBFFF;
                self.note(value & CR1_RWU != 0, "is set to sleep until it is addressed (RWU)");
                self.opened = self.receiving() && !was_receiving;
                self.heard = self.receiving() && (self.heard || self.opened);
                if self.transmitting() && self.sending.is_none() {
                    if !was_transmitting {
                        self.sending = Some(Sending::Preamble);
                        return Some(now + self.frame_cycles(divider));
                    }
                    return self.load(now, divider);
                }
            }
            0x10 => {
                self.cr2 = value & 0x7F6F;
                self.note(value & CR2_LINEN != 0, "is set to LIN mode (LINEN)");
                self.note(value & CR2_CLKEN != 0, "is set to give its clock (CLKEN)");
            }
            0x14 => {
                self.cr3 = value & 0xFFF;
                self.note(value & CR3_IREN != 0, "is set to infrared (IREN)");
                self.note(value & CR3_HDSEL != 0, "is set to a single wire (HDSEL)");
                self.note(value & CR3_SCEN != 0, "is set to smart cards (SCEN)");
                self.note(value & CR3_FLOW != 0, "is set to flow control (RTSE, CTSE)");
            }
            0x18 => self.gtpr = value & 0xFFFF,
            _ => {}
        }
        None
    }

    /// A use that is not emulated, once.
    pub(crate) fn take_bug(&mut self) -> Option<&'static str> {
        self.bug.take()
    }

    fn note(&mut self, used: bool, what: &'static str) {
        if used {
            self.bug = Some(what);
        }
    }

    /// The shift register is empty: what it sent, and when it will be empty again.
    pub(crate) fn sent(&mut self, now: Cycle, divider: u32) -> (Sent, Option<Cycle>) {
        let sent = match self.sending.take() {
            Some(Sending::Word(word)) => Sent::Byte(word as u8),
            Some(Sending::Break) => Sent::Break,
            Some(Sending::Preamble) | None => Sent::Nothing,
        };
        let next = self.load(now, divider);
        if next.is_none() && sent != Sent::Nothing {
            self.sr |= SR_TC;
        }
        (sent, next)
    }

    /// A frame has arrived. Answers whether an idle line is to be looked for after it.
    pub(crate) fn receive(&mut self, frame: Frame) -> bool {
        if !self.receiving() {
            return false;
        }
        self.heard = true;
        if self.sr & SR_RXNE != 0 {
            self.sr |= SR_ORE;
            return true;
        }
        self.received = frame.word;
        self.sr |= SR_RXNE;
        if frame.framing {
            self.sr |= SR_FE;
        }
        if frame.noise && self.cr3 >> 11 & 1 == 0 {
            self.sr |= SR_NF;
        }
        if self.cr1 >> 10 & 1 == 1 {
            let odd = self.cr1 >> 9 & 1 == 1;
            if (frame.word.count_ones() % 2 == 1) != odd {
                self.sr |= SR_PE;
            }
        }
        true
    }

    /// The line has been idle for a frame: told once, until the next byte.
    pub(crate) fn idle(&mut self) {
        if self.heard && self.receiving() {
            self.sr |= SR_IDLE;
        }
        self.heard = false;
    }

    /// Moves what waits into the empty shift register.
    fn load(&mut self, now: Cycle, divider: u32) -> Option<Cycle> {
        if self.sending.is_some() || !self.transmitting() {
            return None;
        }
        if self.cr1 & CR1_SBK != 0 {
            self.cr1 &= !CR1_SBK;
            self.sending = Some(Sending::Break);
            return Some(now + self.frame_cycles(divider));
        }
        let word = self.waiting.take()?;
        self.sending = Some(Sending::Word(word));
        self.sr |= SR_TXE;
        Some(now + self.frame_cycles(divider))
    }
}

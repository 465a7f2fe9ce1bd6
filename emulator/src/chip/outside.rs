//! What the host and a test do to the chip from outside: serial lines, faults, time.

use super::map::{Block, place};
use super::serial_line::SerialByte;
use super::{Board, Chip, Pin};
use crate::bus::Cycle;
use crate::memory::Memory;

impl<B: Board> Chip<B> {
    /// The board.
    pub fn board(&self) -> &B {
        &self.board
    }

    /// The board, for what makes nothing happen on the chip; else use [`Self::with_board`].
    pub fn board_mut(&mut self) -> &mut B {
        &mut self.board
    }

    /// Lets the world act on the board, now, and does what the board asks for. Returns what `act` returns.
    ///
    /// The core looks at [`next_event`](crate::bus::Peripherals::next_event) and at the interrupt lines only after its
    /// own accesses: whoever runs it must let it look again after this.
    pub fn with_board<R>(
        &mut self,
        memory: &mut Memory,
        act: impl FnOnce(&mut B, &mut super::Effects) -> R,
    ) -> R {
        self.tell_board(memory, self.now, act)
    }

    /// Cycles to nanoseconds and back.
    pub fn clock(&self) -> &super::clock::Clock {
        &self.clock
    }

    /// Latest time anything happened or was looked at.
    pub fn now(&self) -> Cycle {
        self.now
    }

    /// The level on a pin as its input register shows it.
    pub fn level(&self, pin: Pin) -> bool {
        self.gpio[pin.port()].level(pin)
    }

    /// The level that a pin drives as a plain output.
    pub fn driven_level(&self, pin: Pin) -> Option<bool> {
        self.gpio[pin.port()].driven_level(pin.number())
    }

    /// Speed of the host on serial port `port` (1..=6) (baud); 921,600 at first.
    pub fn set_host_baud(&mut self, port: u8, baud: u32) {
        if let Some(line) = self.line(port) {
            line.baud = baud.max(1);
        }
    }

    /// Queues bytes that the host sends to serial port `port` (1..=6), back to back, from `ns` on or after what is
    /// queued already. Bytes sent while the port does not receive are lost.
    pub fn serial_send(&mut self, port: u8, ns: u64, bytes: &[u8]) {
        self.queue(port, |line| line.send(ns, bytes));
    }

    /// Queues a byte with a disturbed bit: it arrives, marked as noise.
    pub fn serial_send_noisy(&mut self, port: u8, ns: u64, byte: u8) {
        self.queue(port, |line| line.send_noisy(ns, byte));
    }

    /// Queues a break: the line held low for `length_ns`.
    pub fn serial_break(&mut self, port: u8, ns: u64, length_ns: u64) {
        self.queue(port, |line| line.send_break(ns, length_ns));
    }

    /// Queues silence of `length_ns`.
    pub fn serial_pause(&mut self, port: u8, ns: u64, length_ns: u64) {
        self.queue(port, |line| line.pause(ns, length_ns));
    }

    /// Bytes queued for a port and not yet received.
    pub fn serial_queued(&self, port: u8) -> usize {
        self.serial.get(usize::from(port).wrapping_sub(1)).map_or(0, super::serial_line::SerialLine::queued)
    }

    /// Takes what the firmware has sent on a port since the last call.
    pub fn serial_take(&mut self, port: u8) -> impl Iterator<Item = SerialByte> + '_ {
        self.line(port).map(|line| line.sent.drain(..)).into_iter().flatten()
    }

    /// Breaks that the firmware has sent on a port.
    pub fn serial_breaks(&self, port: u8) -> u32 {
        self.serial.get(usize::from(port).wrapping_sub(1)).map_or(0, |line| line.breaks)
    }

    /// Sets the slow internal oscillator, before the watchdog starts: 17 to 47 kHz by the data sheet (Hz).
    pub fn set_lsi_hz(&mut self, hz: u32) {
        self.iwdg.lsi_hz = hz.max(1);
    }

    /// Whether a DMA request of a timer that nobody has served outlives the clearing of its enable bit. The manual does
    /// not say; firmware must work with both. Off at first.
    pub fn set_sticky_timer_requests(&mut self, sticky: bool) {
        for timer in &mut self.timers {
            timer.requests.sticky = sticky;
        }
    }

    /// Whether enabling the DMA requests of a timer's update makes one at once where the flag of an update stands. The manual
    /// does not say; firmware must work with both. Off at first.
    pub fn set_standing_timer_requests(&mut self, standing: bool) {
        for timer in &mut self.timers {
            timer.requests.standing = standing;
        }
    }

    /// Supply of the chip (V); 3.3 at first. Only the voltage detector looks at it: a chip that is to stop must be stopped.
    pub fn set_supply_v(&mut self, volts: f64) {
        let change = self.minor.set_supply_v(volts);
        self.supply_detected(change);
    }

    /// Seeds the random number generator, whose numbers are the same on every run with the same seed.
    pub fn seed_rng(&mut self, seed: u64) {
        self.minor.rng().seed(seed);
    }

    /// Breaks the random number generator, or mends it.
    pub fn set_rng_defect(&mut self, defect: super::RngDefect) {
        self.minor.rng().defect = defect;
    }

    /// Cuts the power in the middle of whatever flash does and brings it back: a sector being erased keeps arbitrary
    /// content, a word being programmed has some of its bits (no source says which: any must be expected). The chip comes up
    /// from a power-on reset as soon as the core looks; RAM keeps its content, which is one of the things it may do.
    pub fn cut_power(&mut self, memory: &mut Memory, noise: u64) {
        self.flash.cut(memory, noise);
        // Caches are memory without power, too.
        memory.flash_interface.flush_instruction_cache();
        memory.flash_interface.flush_data_cache();
        self.ask_for_reset(super::rcc::CSR_POWER_UP);
    }

    /// Where erase times lie between typical (0) and longest (1).
    pub fn set_flash_slowness(&mut self, slowness: f64) {
        self.flash.slowness = slowness;
    }

    /// Stops the crystal (or lets it run again) at `at`, where the core stands: what came before keeps its rate. With the
    /// clock monitor on, the chip goes on with its internal oscillator and [`Self::nmi`] rises.
    pub fn fail_crystal(&mut self, memory: &mut Memory, at: Cycle, dead: bool) {
        self.catch_up(memory, at);
        let done = self.rcc.fail_crystal(dead);
        if let Some(text) = done.bug {
            memory.report(at, 0, text.into());
        }
        if done.clocks {
            self.change_clocks(memory, at, 0);
        }
    }

    /// Lets the PLL lock no more once it has been switched off, or lock again.
    pub fn set_pll_dead(&mut self, dead: bool) {
        self.rcc.pll_dead = dead;
    }

    /// The line of the non-maskable interrupt: up from the loss of the crystal until RCC_CIR.CSSC clears it.
    pub fn nmi(&self) -> bool {
        self.rcc.nmi()
    }

    /// Name of the peripheral at an address, for messages.
    pub fn peripheral_at(address: u32) -> Option<String> {
        match place(address) {
            super::Place::Block(block, _) => Some(Block::name(block)),
            _ => None,
        }
    }

    fn line(&mut self, port: u8) -> Option<&mut super::serial_line::SerialLine> {
        self.serial.get_mut(usize::from(port).wrapping_sub(1))
    }

    fn queue(&mut self, port: u8, act: impl FnOnce(&mut super::serial_line::SerialLine)) {
        if let Some(line) = self.line(port) {
            act(line);
            self.schedule_serial(port - 1);
        }
    }
}

//! Pins, pulses and the board; changes of the clocks.

use super::access::report;
use super::events::Slot;
use super::map::{self, Block};
use super::pin::{Route, SPI_PINS, TIMER_PINS};
use super::timer::Step;
use super::timer_outputs::Period;
use super::{Board, Chip, Effects, Pin, Pulse, flash, gpio};
use crate::bus::{Access, Cycle, NEVER};
use crate::memory::Memory;

impl<B: Board> Chip<B> {
    /// Brings a timer up to `now`: flags, requests, pulses.
    pub(super) fn sync_timer(&mut self, memory: &mut Memory, n: u8, now: Cycle) {
        let index = usize::from(n);
        while let Step::Period(period) = self.timers[index].step(now) {
            if self.pwm_timers >> index & 1 == 1 {
                self.emit(memory, index, period);
            }
            if self.timers[index].update_requested() || self.timers[index].channel_requests != 0 {
                self.pump(memory, period.end);
            }
        }
    }

    /// Ends the pulses of a timer where they are.
    pub(super) fn cut_pulses(&mut self, memory: &mut Memory, n: u8, now: Cycle) {
        let index = usize::from(n);
        if self.pwm_timers >> index & 1 == 1
            && let Some(period) = self.timers[index].so_far(now)
        {
            self.emit(memory, index, period);
            self.timers[index].cut(now);
        }
    }

    /// Schedules what a timer must do next and drives its interrupt lines.
    pub(super) fn timer_changed(&mut self, n: u8) {
        let index = usize::from(n);
        let watched = self.pwm_timers >> index & 1 == 1;
        self.events.set(Slot::Timer(n), self.timers[index].next_due(watched));
        self.refresh_timer(n);
    }

    /// Interrupt lines of a timer; some are shared (RM0090 table 62).
    pub(super) fn refresh_timer(&mut self, n: u8) {
        let shared: &[u8] = match n {
            0 | 8..=10 => &[0, 8, 9, 10],
            7 | 11..=13 => &[7, 11, 12, 13],
            _ => &[],
        };
        if shared.is_empty() {
            let index = usize::from(n);
            let level = self.timers[index].interrupts().contains(&true);
            return self.set_line(map::TIMER_IRQS[index][0], level);
        }
        let mut lines = 0_u128;
        for &member in shared {
            let index = usize::from(member);
            for (level, irq) in self.timers[index].interrupts().into_iter().zip(map::TIMER_IRQS[index]) {
                lines |= u128::from(level) << irq;
            }
        }
        for irq in map::TIMER_IRQS[usize::from(shared[0])] {
            self.set_line(irq, lines >> irq & 1 == 1);
        }
    }

    /// A write to a port.
    pub(super) fn write_gpio(&mut self, memory: &mut Memory, n: u8, register: u32, at: Cycle, value: u32) {
        let routes = matches!(register, 0x00 | 0x20 | 0x24);
        self.change_gpio(memory, n, at, routes, |port| port.write(register, value));
    }

    /// Changes a port and tells the board and EXTI what became of its pins.
    pub(super) fn change_gpio(
        &mut self,
        memory: &mut Memory,
        n: u8,
        at: Cycle,
        routes: bool,
        change: impl FnOnce(&mut gpio::Gpio),
    ) {
        let port = usize::from(n);
        let (drives_before, levels_before) = self.gpio[port].outputs();
        let seen_before = self.gpio[port].idr();
        change(&mut self.gpio[port]);
        let (drives, levels) = self.gpio[port].outputs();
        let seen = self.gpio[port].idr();
        if routes {
            self.route_outputs(memory, at);
        }
        let mut changed = drives ^ drives_before | (levels ^ levels_before) & drives;
        let ns = self.clock.ns(at);
        while changed != 0 {
            let number = changed.trailing_zeros() as usize;
            changed &= changed - 1;
            let level = self.gpio[port].driven_level(number);
            self.tell_board(memory, at, |board, effects| {
                board.output(ns, Pin::at(port, number), level, effects);
            });
        }
        self.edges(port, seen_before, seen);
    }

    /// Works out which pins carry which outputs of timers; a pulse on a pin that changes hands ends here.
    fn route_outputs(&mut self, memory: &mut Memory, at: Cycle) {
        let mut pins = [[None; 4]; 14];
        for &(timer, channel, route) in TIMER_PINS {
            if self.gpio[route.0.port()].leads(route) {
                pins[usize::from(timer) - 1][usize::from(channel)] = Some(route.0);
            }
        }
        for timer in 0..14_u8 {
            let index = usize::from(timer);
            if pins[index] == self.pwm_pins[index] {
                continue;
            }
            self.sync_timer(memory, timer, at);
            if let Some(mut period) = self.timers[index].so_far(at) {
                for (channel, high) in period.high.iter_mut().enumerate() {
                    if pins[index][channel] == self.pwm_pins[index][channel] {
                        *high = (0, 0);
                    }
                }
                self.emit(memory, index, period);
            }
            self.pwm_pins[index] = pins[index];
            let carried = u16::from(pins[index] != [None; 4]);
            self.pwm_timers = self.pwm_timers & !(1 << index) | carried << index;
            self.timer_changed(timer);
        }
    }

    /// Tells EXTI of pins whose level changed.
    fn edges(&mut self, port: usize, before: u16, after: u16) {
        let mut changed = before ^ after;
        if changed == 0 {
            return;
        }
        while changed != 0 {
            let number = changed.trailing_zeros() as usize;
            changed &= changed - 1;
            if self.exti.listens(Pin::at(port, number)) {
                self.exti.edge(number, after >> number & 1 == 1);
            }
        }
        self.refresh(Block::Exti);
    }

    /// Calls the board and does what it asks for.
    pub(super) fn tell_board<R>(
        &mut self,
        memory: &mut Memory,
        at: Cycle,
        call: impl FnOnce(&mut B, &mut Effects) -> R,
    ) -> R {
        let answer = call(&mut self.board, &mut self.effects);
        if !self.effects.levels.is_empty() {
            let mut levels = std::mem::take(&mut self.effects.levels);
            for (pin, level) in levels.drain(..) {
                let port = pin.port();
                let before = self.gpio[port].idr();
                self.gpio[port].set_external(pin.bit(), level);
                let after = self.gpio[port].idr();
                self.edges(port, before, after);
            }
            self.effects.levels = levels;
        }
        if !self.effects.serial.is_empty() {
            let ns = self.clock.ns(at);
            for (port, baud, bytes) in std::mem::take(&mut self.effects.serial) {
                self.set_host_baud(port, baud);
                self.serial_send(port, ns, &bytes);
            }
        }
        if !self.effects.bugs.is_empty() {
            for text in self.effects.bugs.drain(..) {
                memory.report(at, 0, text);
            }
        }
        self.schedule_board();
        answer
    }

    pub(super) fn schedule_board(&mut self) {
        let due = self.board.next_event_ns();
        if due != self.board_due_ns {
            self.board_due_ns = due;
            self.events.set(Slot::Board, self.clock.cycle(due));
        }
    }

    pub(super) fn schedule_serial(&mut self, port: u8) {
        let due = self.serial[usize::from(port)].next_ns();
        self.events.set(Slot::UsartRx(port), self.clock.cycle(due));
    }

    /// Whether any of `routes` is set up.
    pub(super) fn routed(&self, routes: &[Route]) -> bool {
        routes.iter().any(|route| self.gpio[route.0.port()].leads(*route))
    }

    /// An SPI may have begun a word.
    pub(super) fn spi_changed(
        &mut self,
        memory: &mut Memory,
        n: u8,
        at: Cycle,
        access: Access,
        started: bool,
    ) {
        let index = usize::from(n);
        if started {
            let divider = self.clock.apb_divider(map::spi_bus(n));
            let spi = &self.spis[index];
            let cycles = u32::from(spi.bits()) * spi.bit_cycles() * divider;
            self.events.set(Slot::Spi(n), at + u64::from(cycles));
            let [sck, _, mosi] = SPI_PINS[index];
            if !(self.routed(sck) && self.routed(mosi)) {
                let text = format!("SPI{} sends while SCK or MOSI is on no pin", n + 1);
                report(memory, access, Some(text));
            }
        } else if self.spis[index].shifting().is_none() {
            self.events.set(Slot::Spi(n), NEVER);
        }
        self.refresh(Block::Spi(n));
    }

    /// A write to RCC.
    pub(super) fn write_rcc(&mut self, memory: &mut Memory, register: u32, access: Access, value: u32) {
        let at = access.at;
        let clock = &self.clock;
        let after = |ns: u64| at + clock.cycles_for(ns);
        let done = self.rcc.write(register, value, at, after, self.minor.backup_open());
        report(memory, access, done.bug.map(String::from));
        if let Some((group, bits)) = done.resets {
            for block in map::resettable() {
                if block.gate().is_some_and(|(register, bit)| register == group && bits >> bit & 1 == 1) {
                    self.reset_block(memory, block, at);
                }
            }
            if group == 4 && bits & 0x100 != 0 {
                self.adcs = Default::default();
                self.adc_common = 0;
                (0..3).for_each(|n| self.events.set(Slot::Adc(n), NEVER));
                self.refresh(Block::Adc);
            }
        }
        if done.backup {
            self.minor.reset_backup();
        }
        if done.clocks {
            self.change_clocks(memory, at, access.pc);
        }
        self.refresh(Block::Rcc);
    }

    /// Takes over what RCC says of the clocks.
    pub(super) fn change_clocks(&mut self, memory: &mut Memory, at: Cycle, pc: u32) {
        let rates = self.rcc.rates(self.board.crystal_hz().unwrap_or(0));
        if rates == self.clock.rates() {
            return;
        }
        for timer in 0..14 {
            self.sync_timer(memory, timer, at);
        }
        self.clock.switch(at, rates);
        for timer in 0..14_u8 {
            let divider = self.clock.timer_divider(map::timer_bus(timer));
            self.timers[usize::from(timer)].set_divider(at, divider);
            self.timer_changed(timer);
        }
        self.events.set(Slot::Iwdg, self.clock.cycle(self.iwdg.due_ns()));
        self.events.set(Slot::Board, self.clock.cycle(self.board_due_ns));
        for port in 0..6 {
            self.schedule_serial(port);
        }
        // Limits of RM0090 section 7.2.
        let limits = [
            ("SYSCLK", rates.sysclk_hz, 168_000_000),
            ("PCLK1", rates.hclk_hz / rates.apb1_divider, 42_000_000),
            ("PCLK2", rates.hclk_hz / rates.apb2_divider, 84_000_000),
        ];
        for (name, hz, limit) in limits {
            if hz > limit {
                memory.report(at, pc, format!("{name} runs at {hz} Hz, above its limit of {limit} Hz"));
            }
        }
        self.check_wait_states(memory, at, pc);
    }

    /// Whether flash has the wait states that the core clock needs.
    pub(super) fn check_wait_states(&self, memory: &mut Memory, at: Cycle, pc: u32) {
        let hclk = self.clock.rates().hclk_hz;
        let needed = hclk.saturating_sub(1) / flash::HZ_PER_WAIT_STATE;
        let latency = self.flash.latency();
        if latency < needed {
            memory.report(at, pc, format!("flash has {latency} wait states at {hclk} Hz and needs {needed}"));
        }
    }

    /// Tells the board of the pulses of a period.
    fn emit(&mut self, memory: &mut Memory, timer: usize, period: Period) {
        let (start_ns, ns) = (self.clock.ns(period.start), self.clock.ns(period.end));
        let period_ns = self.clock.span_ns(period.end.saturating_sub(period.start));
        for (channel, &(delay, high)) in period.high.iter().enumerate() {
            if high == 0 {
                continue;
            }
            let Some(pin) = self.pwm_pins[timer][channel] else { continue };
            let pulse = Pulse {
                start_ns: if delay == 0 { start_ns } else { self.clock.ns(period.start + delay) },
                high_ns: self.clock.span_ns(high),
                period_ns,
                cut: period.cut,
            };
            self.tell_board(memory, period.end, |board, effects| board.pulse(ns, pin, pulse, effects));
        }
    }
}

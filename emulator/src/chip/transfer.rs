//! DMA at work: who asks, and one item after another (RM0090 section 10.3).
//!
//! In optimistic timing a request is served in the cycle it is made; in pessimistic timing a controller is busy with an item
//! for a while, and what else asks it waits.

use super::access::report;
use super::dma::{Direction, TEIF};
use super::dma_requests::{Request, requests};
use super::events::Slot;
use super::map::{self, Place, place};
use super::{Board, Chip};
use crate::bus::{Access, Cycle, Master, NEVER, Width};
use crate::memory::{CCM_BASE, CCM_BYTES, FLASH_BASE, FLASH_BYTES, Memory, SRAM_BASE, SRAM_BYTES};

/// Items served in one go before a request that never goes away counts as a mistake.
const MOST_ITEMS: u32 = 1 << 16;
/// Cycles of an item besides those of the bus its peripheral hangs on, at worst: request, arbitration and acknowledgement, the
/// access to memory, and a cycle lost there to the core (RM0090 section 10.3.3 names the steps; AN4031 counts them).
const ITEM_CYCLES: u64 = 6;
/// Cycles per item from memory to memory.
const COPY_CYCLES: u64 = 4;

/// Why DMA cannot reach an address.
enum Fault {
    /// Core-coupled memory is on no bus of DMA.
    Ccm,
    /// DMA1's peripheral port leads to APB1 only.
    Dma1Port,
    /// Nothing, or nothing emulated.
    Nothing,
}

impl<B: Board> Chip<B> {
    /// Serves every request that stands, the most urgent first, until none is left.
    pub(super) fn pump(&mut self, memory: &mut Memory, at: Cycle) {
        if self.dma[0].on | self.dma[1].on == 0 {
            return;
        }
        loop {
            let Some((controller, stream, request)) = self.most_urgent(at) else {
                self.wait_for_controllers(at);
                return;
            };
            self.dma_items += 1;
            if self.dma_items >= MOST_ITEMS {
                self.dma_items = 0;
                self.dma[controller].streams[stream].fail(TEIF);
                self.dma[controller].note(stream);
                let text =
                    "a DMA request is served without end: the stream does not reach who asks; it is stopped";
                memory.report(at, 0, text.into());
                return;
            }
            self.acknowledge(request);
            if self.pessimistic {
                let address = self.dma[controller].streams[stream].peripheral_at;
                self.dma_free_at[controller] = at + ITEM_CYCLES + super::bus_wait(&self.clock, address);
            }
            self.serve(memory, controller, stream, at);
            if let Request::TimerUpdate(n) | Request::TimerChannel(n, _) = request {
                self.timer_changed(n);
            }
        }
    }

    /// What asks a controller that is busy is looked at again when it is not.
    fn wait_for_controllers(&mut self, at: Cycle) {
        let mut waits = false;
        for controller in 0..2 {
            let free_at = self.dma_free_at[controller];
            let due = if free_at > at && self.asking(controller).is_some() { free_at } else { NEVER };
            waits |= due != NEVER;
            self.events.set(Slot::Dma(controller as u8), due);
        }
        if !waits {
            self.dma_items = 0;
        }
    }

    /// A stream has been switched on.
    pub(super) fn stream_enabled(
        &mut self,
        memory: &mut Memory,
        controller: usize,
        stream: usize,
        access: Access,
    ) {
        let state = &mut self.dma[controller].streams[stream];
        let copies = state.direction() == Direction::MemoryToMemory;
        state.requests = if copies { &[] } else { requests(controller, stream, state.channel()) };
        if copies {
            if controller == 0 {
                self.dma[0].streams[stream].fail(TEIF);
                self.dma[0].note(stream);
                report(memory, access, Some("DMA1 cannot copy from memory to memory".into()));
            } else {
                let end = access.at + COPY_CYCLES * u64::from(state.left);
                self.events.set(Slot::MemoryCopy(stream as u8), end);
            }
        } else if state.requests.is_empty() {
            let text = format!(
                "no peripheral asks on DMA{} stream {stream} channel {}",
                controller + 1,
                state.channel()
            );
            report(memory, access, Some(text));
        } else if state.direction() == Direction::MemoryToPeripheral {
            let result = self.fill(memory, controller, stream, access.at);
            self.conclude(memory, controller, stream, access.at, result);
        }
    }

    /// Carries a whole transfer from memory to memory.
    pub(super) fn copy_memory(&mut self, memory: &mut Memory, stream: usize, at: Cycle) {
        for _ in 0..self.dma[1].streams[stream].left {
            if self.dma[1].streams[stream].enabled() {
                self.serve(memory, 1, stream, at);
            }
        }
        let state = &self.dma[1].streams[stream];
        if state.enabled() {
            // Circular, which the manual forbids here: around once more.
            memory.report(
                at,
                0,
                format!("DMA2 stream {stream} copies memory in circular mode, which is not allowed"),
            );
            self.events.set(Slot::MemoryCopy(stream as u8), at + COPY_CYCLES * u64::from(state.left));
        }
    }

    /// The request to serve next, at a controller that is not busy.
    fn most_urgent(&self, at: Cycle) -> Option<(usize, usize, Request)> {
        (0..2).filter(|controller| self.dma_free_at[*controller] <= at).find_map(|controller| {
            self.asking(controller).map(|(stream, request)| (controller, stream, request))
        })
    }

    /// What asks a controller most urgently: by priority, then by number of the stream.
    #[inline]
    fn asking(&self, controller: usize) -> Option<(usize, Request)> {
        let dma = &self.dma[controller];
        let mut best: Option<(u32, usize, Request)> = None;
        let mut on = dma.on;
        while on != 0 {
            let stream = on.trailing_zeros() as usize;
            on &= on - 1;
            let state = &dma.streams[stream];
            let asking = state.requests.iter().find(|request| self.asserted(**request));
            if let Some(&request) = asking
                && best.is_none_or(|(priority, ..)| state.priority() > priority)
            {
                best = Some((state.priority(), stream, request));
            }
        }
        best.map(|(_, stream, request)| (stream, request))
    }

    fn asserted(&self, request: Request) -> bool {
        match request {
            Request::UsartRx(n) => self.usarts[usize::from(n)].receive_requested(),
            Request::UsartTx(n) => self.usarts[usize::from(n)].transmit_requested(),
            Request::SpiRx(n) => self.spis[usize::from(n)].receive_requested(),
            Request::SpiTx(n) => self.spis[usize::from(n)].transmit_requested(),
            Request::Adc(n) => self.adcs[usize::from(n)].requested(),
            Request::TimerUpdate(n) => self.timers[usize::from(n)].update_requested(),
            Request::TimerChannel(n, channel) => self.timers[usize::from(n)].channel_requested(channel),
        }
    }

    /// Timers take a request back once it is served; the others when their data register is reached.
    fn acknowledge(&mut self, request: Request) {
        match request {
            Request::TimerUpdate(n) => self.timers[usize::from(n)].acknowledge(None),
            Request::TimerChannel(n, channel) => self.timers[usize::from(n)].acknowledge(Some(channel)),
            _ => {}
        }
    }

    /// Carries one item.
    fn serve(&mut self, memory: &mut Memory, controller: usize, stream: usize, at: Cycle) {
        let result = match self.dma[controller].streams[stream].direction() {
            Direction::MemoryToPeripheral => self.item_out(memory, controller, stream, at),
            Direction::PeripheralToMemory | Direction::MemoryToMemory => {
                self.item_in(memory, controller, stream, at)
            }
        };
        self.conclude(memory, controller, stream, at, result);
    }

    /// What follows from an access: a stream that could not do it goes off.
    fn conclude(
        &mut self,
        memory: &mut Memory,
        controller: usize,
        stream: usize,
        at: Cycle,
        result: Result<(), (Fault, u32)>,
    ) {
        if let Err((fault, address)) = result {
            self.dma[controller].streams[stream].fail(TEIF);
            let who = format!("DMA{} stream {stream}", controller + 1);
            let text = match fault {
                Fault::Ccm => {
                    format!("{who} is pointed at core-coupled memory ({address:#010x}): it cannot reach it")
                }
                Fault::Dma1Port => {
                    format!("{who} is pointed at {address:#010x}: DMA1 reaches peripherals on APB1 only")
                }
                Fault::Nothing => {
                    format!("{who} is pointed at {address:#010x}, where nothing lies that is emulated")
                }
            };
            memory.report(at, 0, text);
        }
        self.dma[controller].note(stream);
        let level = self.dma[controller].streams[stream].interrupt();
        self.set_line(map::dma_irq(controller, stream), level);
    }

    fn item_in(
        &mut self,
        memory: &mut Memory,
        controller: usize,
        stream: usize,
        at: Cycle,
    ) -> Result<(), (Fault, u32)> {
        let state = &self.dma[controller].streams[stream];
        let (from, width) = (state.peripheral_at, state.peripheral_bytes());
        let copies = state.direction() == Direction::MemoryToMemory;
        let value = self.dma_read(memory, controller, from, width, at, !copies)?;
        let state = &mut self.dma[controller].streams[stream];
        state.advance_peripheral();
        let used = state.fifo_used;
        for (cell, byte) in state.fifo[used..].iter_mut().zip(value.to_le_bytes()).take(width as usize) {
            *cell = byte;
        }
        state.fifo_used += width as usize;
        let last = state.left <= 1;
        let wide = state.memory_bytes() as usize;
        // The rest of an incomplete word goes out at the end.
        while self.dma[controller].streams[stream].fifo_used >= wide
            || last && self.dma[controller].streams[stream].fifo_used > 0
        {
            let state = &self.dma[controller].streams[stream];
            let take = wide.min(state.fifo_used);
            let (to, value) = (state.memory_at, first_bytes(&state.fifo, take));
            self.dma_write(memory, controller, to, take as u32, value, at, false)?;
            let state = &mut self.dma[controller].streams[stream];
            state.fifo.copy_within(take.., 0);
            state.fifo_used -= take;
            state.advance_memory();
        }
        self.dma[controller].streams[stream].count_item();
        Ok(())
    }

    fn item_out(
        &mut self,
        memory: &mut Memory,
        controller: usize,
        stream: usize,
        at: Cycle,
    ) -> Result<(), (Fault, u32)> {
        self.fill(memory, controller, stream, at)?;
        let state = &mut self.dma[controller].streams[stream];
        let width = state.peripheral_bytes() as usize;
        let (to, value) = (state.peripheral_at, first_bytes(&state.fifo, width));
        state.fifo.copy_within(width.., 0);
        state.fifo_used = state.fifo_used.saturating_sub(width);
        state.advance_peripheral();
        self.dma_write(memory, controller, to, width as u32, value, at, true)?;
        let over = self.dma[controller].streams[stream].count_item();
        if over { Ok(()) } else { self.fill(memory, controller, stream, at) }
    }

    /// Reads ahead what is to go out: a stream to a peripheral does so when it is switched on and again behind every item,
    /// in direct mode for one item, else as much as there is room for (RM0090 section 10.3.7).
    fn fill(
        &mut self,
        memory: &mut Memory,
        controller: usize,
        stream: usize,
        at: Cycle,
    ) -> Result<(), (Fault, u32)> {
        while self.dma[controller].streams[stream].reads_ahead() {
            let state = &self.dma[controller].streams[stream];
            let (from, wide) = (state.memory_at, state.memory_bytes());
            let value = self.dma_read(memory, controller, from, wide, at, false)?;
            let state = &mut self.dma[controller].streams[stream];
            let used = state.fifo_used;
            for (cell, byte) in state.fifo[used..].iter_mut().zip(value.to_le_bytes()).take(wide as usize) {
                *cell = byte;
            }
            state.fifo_used += wide as usize;
            state.advance_memory();
        }
        Ok(())
    }

    fn dma_read(
        &mut self,
        memory: &mut Memory,
        controller: usize,
        address: u32,
        width: u32,
        at: Cycle,
        peripheral_port: bool,
    ) -> Result<u32, (Fault, u32)> {
        check_port(controller, address, peripheral_port)?;
        let length = width as usize;
        let plain = if (FLASH_BASE..FLASH_BASE + FLASH_BYTES).contains(&address) {
            memory.flash.get((address - FLASH_BASE) as usize..)
        } else if (SRAM_BASE..SRAM_BASE + SRAM_BYTES).contains(&address) {
            memory.sram.get((address - SRAM_BASE) as usize..)
        } else {
            None
        };
        if let Some(bytes) = plain {
            return Ok(bytes.iter().take(length).rev().fold(0, |word, &byte| word << 8 | u32::from(byte)));
        }
        let Place::Block(block, offset) = place(address) else { return Err((Fault::Nothing, address)) };
        let access = Access { at, address, width: access_width(width), pc: 0 };
        Ok(self.read_block(memory, block, offset, access, Master::Dma(controller as u8 + 1)))
    }

    #[allow(clippy::too_many_arguments, reason = "an access is that many things")]
    fn dma_write(
        &mut self,
        memory: &mut Memory,
        controller: usize,
        address: u32,
        width: u32,
        value: u32,
        at: Cycle,
        peripheral_port: bool,
    ) -> Result<(), (Fault, u32)> {
        check_port(controller, address, peripheral_port)?;
        if (SRAM_BASE..SRAM_BASE + SRAM_BYTES).contains(&address) {
            let start = (address - SRAM_BASE) as usize;
            for (cell, byte) in memory.sram[start..].iter_mut().zip(value.to_le_bytes()).take(width as usize)
            {
                *cell = byte;
            }
            return Ok(());
        }
        let Place::Block(block, offset) = place(address) else { return Err((Fault::Nothing, address)) };
        self.write_block(
            memory,
            block,
            offset,
            Access { at, address, width: access_width(width), pc: 0 },
            value,
        );
        Ok(())
    }
}

/// What a controller's port cannot reach (RM0090 figures 1 and 33).
fn check_port(controller: usize, address: u32, peripheral_port: bool) -> Result<(), (Fault, u32)> {
    if (CCM_BASE..CCM_BASE + CCM_BYTES).contains(&address) {
        return Err((Fault::Ccm, address));
    }
    if controller == 0 && peripheral_port && !(0x4000_0000..0x4000_8000).contains(&address) {
        return Err((Fault::Dma1Port, address));
    }
    Ok(())
}

fn access_width(bytes: u32) -> Width {
    match bytes {
        1 => Width::Byte,
        2 => Width::Half,
        _ => Width::Word,
    }
}

fn first_bytes(fifo: &[u8; 16], count: usize) -> u32 {
    fifo.iter().take(count.min(4)).rev().fold(0, |word, &byte| word << 8 | u32::from(byte))
}

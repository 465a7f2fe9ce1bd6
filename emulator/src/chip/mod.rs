//! The peripherals of the STM32F405, event by event in virtual time.
//!
//! [`Chip`] owns the models of the peripherals and the board around the chip. A model knows its own registers and
//! nothing else; whatever one peripheral does to another goes through the chip:
//!
//! | file | what |
//! |---|---|
//! | `map`, `pin`, `dma_requests` | tables of the manual: addresses, gates, interrupts, pins, DMA requests |
//! | `clock`, `events` | time: rates, nanoseconds, and what happens next |
//! | `rcc`, `flash`, `gpio`, `exti`, `timer`, `dma`, `usart`, `spi`, `adc`, `watchdog`, `rng`, `minor` | registers |
//! | `access`, `gates` | an access to a register, whether it gets there, and what follows from it |
//! | `transfer` | DMA at work |
//! | `wiring` | pins, pulses, the board, changes of the clocks |
//! | `happening` | what an event does |
//! | `outside` | what the host and a test do to the chip |
//! | `gates` | whether a block has its clock |
//! | `factory` | what the factory wrote |
//!
//! An event that nobody waits for does not exist: a free-running timer costs nothing until somebody reads it.

mod access;
mod adc;
pub mod board;
pub mod clock;
mod dma;
mod dma_requests;
mod events;
mod exti;
mod factory;
mod flash;
mod gates;
mod gpio;
mod happening;
mod map;
mod minor;
mod outside;
pub mod pin;
mod rcc;
mod rng;
mod serial_line;
mod spi;
mod timer;
mod timer_outputs;
mod timer_registers;
mod transfer;
mod usart;
mod watchdog;
mod wiring;

pub use board::{BareBoard, Board, Effects, Pulse, SpiWord};
pub use gpio::Mode;
pub use pin::Pin;
pub use rng::RngDefect;
pub use serial_line::SerialByte;

use crate::bus::{Access, AccessError, Cycle, Master, NEVER, Peripherals, Width};
use crate::memory::Memory;
use clock::Clock;
use events::Events;
use map::{Block, Place, place};

/// Nominal frequency of the slow internal oscillator (Hz); 17 to 47 kHz by the data sheet.
pub const LSI_NOMINAL_HZ: u32 = 32_000;

/// The chip and the board around it.
#[derive(Clone, Debug)]
pub struct Chip<B> {
    board: B,
    clock: Clock,
    events: Events,
    /// Levels of the interrupt lines.
    lines: u128,
    /// Latest time anything happened.
    now: Cycle,
    rcc: rcc::Rcc,
    flash: flash::Flash,
    gpio: [gpio::Gpio; 9],
    exti: exti::Exti,
    timers: [timer::Timer; 14],
    dma: [dma::Dma; 2],
    usarts: [usart::Usart; 6],
    serial: [serial_line::SerialLine; 6],
    spis: [spi::Spi; 3],
    adcs: [adc::Adc; 3],
    adc_common: u32,
    iwdg: watchdog::Iwdg,
    wwdg: watchdog::Wwdg,
    minor: minor::Minor,
    /// Pins that carry the outputs of the timers.
    pwm_pins: [[Option<Pin>; 4]; 14],
    /// Timers with any such pin, as bits.
    pwm_timers: u16,
    /// What the board asked for, reused from call to call.
    effects: Effects,
    board_due_ns: u64,
    /// A reset waits to be taken, for this reason (bits of RCC_CSR).
    reset_cause: Option<u32>,
    reset_taken: u32,
    /// Of each enable register the bits set last, and when.
    fresh_gates: [(u32, Cycle); 5],
    /// DMA takes its time.
    pessimistic: bool,
    /// When each controller is done with the item it carried last.
    dma_free_at: [Cycle; 2],
    /// Items carried without a pause.
    dma_items: u32,
}

impl<B: Board> Chip<B> {
    /// A chip at power-up on `board`.
    pub fn new(board: B) -> Self {
        let mut chip = Self {
            board,
            clock: Clock::new(),
            events: Events::new(),
            lines: 0,
            now: 0,
            rcc: rcc::Rcc::new(),
            flash: flash::Flash::new(),
            gpio: std::array::from_fn(gpio::Gpio::new),
            exti: exti::Exti::default(),
            timers: std::array::from_fn(timer::Timer::new),
            dma: std::array::from_fn(|_| dma::Dma::new()),
            usarts: std::array::from_fn(|_| usart::Usart::new()),
            serial: std::array::from_fn(|_| serial_line::SerialLine::new()),
            spis: std::array::from_fn(|_| spi::Spi::new()),
            adcs: std::array::from_fn(|_| adc::Adc::default()),
            adc_common: 0,
            iwdg: watchdog::Iwdg::new(LSI_NOMINAL_HZ),
            wwdg: watchdog::Wwdg::new(),
            minor: minor::Minor::new(),
            pwm_pins: [[None; 4]; 14],
            pwm_timers: 0,
            effects: Effects::default(),
            board_due_ns: u64::MAX,
            reset_cause: None,
            reset_taken: 0,
            fresh_gates: [(0, 0); 5],
            pessimistic: false,
            dma_free_at: [0; 2],
            dma_items: 0,
        };
        chip.schedule_board();
        chip
    }

    /// Drives the level of an interrupt line.
    fn set_line(&mut self, irq: u8, level: bool) {
        let bit = 1 << irq;
        if level { self.lines |= bit } else { self.lines &= !bit }
    }

    /// Makes everything up to `now` happen.
    #[inline]
    fn catch_up(&mut self, memory: &mut Memory, now: Cycle) {
        if self.events.next() <= now {
            self.happen_until(memory, now);
        }
        self.now = self.now.max(now);
    }

    fn happen_until(&mut self, memory: &mut Memory, now: Cycle) {
        // Nothing that lies behind a reset happens.
        while self.reset_cause.is_none()
            && let Some((slot, at)) = self.events.pop_due(now)
        {
            self.now = self.now.max(at);
            self.happen(memory, slot, at);
        }
    }
}

impl<B: Board> Peripherals for Chip<B> {
    fn read(&mut self, memory: &mut Memory, access: Access) -> Result<u32, AccessError> {
        self.catch_up(memory, access.at);
        match place(access.address) {
            Place::Block(block, offset) => {
                // No read by the core makes a peripheral ask for DMA.
                Ok(self.read_block(memory, block, offset, access, Master::Core))
            }
            Place::FlashMemory(offset) => {
                let at = offset as usize;
                Ok(memory.flash[at..]
                    .iter()
                    .take(bytes(access.width))
                    .rev()
                    .fold(0, |w, &b| w << 8 | u32::from(b)))
            }
            Place::Factory(offset) => Ok(factory::read(offset, bytes(access.width))),
            Place::Absent(name) => Err(AccessError::NotEmulated(access.address, name)),
            Place::Nothing => Err(AccessError::Nothing(access.address)),
        }
    }

    fn write(&mut self, memory: &mut Memory, access: Access, value: u32) -> Result<(), AccessError> {
        self.catch_up(memory, access.at);
        match place(access.address) {
            Place::Block(block, offset) => {
                self.write_block(memory, block, offset, access, value);
                self.pump(memory, access.at);
                Ok(())
            }
            Place::FlashMemory(offset) => {
                let width = bytes(access.width);
                let done =
                    self.flash.program(memory, offset & !(width as u32 - 1), &value.to_le_bytes()[..width]);
                self.flash_done(memory, access, done);
                Ok(())
            }
            Place::Factory(_) => Err(AccessError::ReadOnly(access.address, factory::NAME)),
            Place::Absent(name) => Err(AccessError::NotEmulated(access.address, name)),
            Place::Nothing => Err(AccessError::Nothing(access.address)),
        }
    }

    fn next_event(&self) -> Cycle {
        self.events.next()
    }

    fn advance(&mut self, memory: &mut Memory, now: Cycle) {
        self.catch_up(memory, now);
    }

    fn interrupt_lines(&self) -> u128 {
        self.lines
    }

    fn clocks_core_in_sleep(&self) -> bool {
        self.minor.debug_sleep()
    }

    fn non_maskable(&self) -> bool {
        self.rcc.nmi()
    }

    fn name_at(&self, address: u32) -> Option<String> {
        match place(address) {
            Place::Block(block, _) => Some(block.name()),
            Place::Absent(name) => Some(format!("{name}, which is not emulated")),
            Place::Factory(_) => Some(factory::NAME.into()),
            Place::FlashMemory(_) | Place::Nothing => None,
        }
    }

    fn take_event(&mut self) -> bool {
        self.exti.take_event()
    }

    fn set_pessimistic(&mut self, pessimistic: bool) {
        self.pessimistic = pessimistic;
    }

    fn wait_states(&self, address: u32) -> Cycle {
        bus_wait(&self.clock, address)
    }

    fn rests(&self, address: u32, at: Cycle) -> bool {
        match place(address) {
            // Status registers without a clock of their own.
            Place::Block(block @ Block::Spi(_), 0x08) => self.answers(block, at),
            _ => false,
        }
    }

    fn take_reset(&mut self) -> bool {
        match self.reset_cause.take() {
            Some(cause) => {
                self.reset_taken |= cause;
                true
            }
            None => false,
        }
    }

    fn reset(&mut self, memory: &mut Memory, now: Cycle) {
        self.catch_up(memory, now);
        for timer in 0..14 {
            self.cut_pulses(memory, timer, now);
        }
        self.rcc.system_reset(std::mem::take(&mut self.reset_taken));
        self.reset_cause = None;
        self.clock.switch(now, clock::Rates::RESET);
        self.flash.reset();
        memory.flash_interface.latency = 0;
        memory.flash_interface.prefetch = false;
        memory.flash_interface.instruction_cache = false;
        memory.flash_interface.data_cache = false;
        memory.flash_interface.busy_until = memory.flash_interface.busy_until.min(now);
        self.events = Events::new();
        self.dma_free_at = [0; 2];
        for block in map::resettable() {
            self.reset_block(memory, block, now);
        }
        self.adcs = std::array::from_fn(|_| adc::Adc::default());
        self.adc_common = 0;
        self.exti = exti::Exti::default();
        self.iwdg = watchdog::Iwdg::new(self.iwdg.lsi_hz);
        self.minor.reset();
        self.lines = 0;
        self.board_due_ns = u64::MAX;
        self.schedule_board();
        for port in 0..6 {
            self.schedule_serial(port);
        }
    }

    fn request_reset(&mut self) {
        self.ask_for_reset(rcc::CSR_SFTRSTF);
    }
}

impl<B> Chip<B> {
    fn ask_for_reset(&mut self, cause: u32) {
        *self.reset_cause.get_or_insert(0) |= cause;
    }
}

/// Bytes of an access.
fn bytes(width: Width) -> usize {
    match width {
        Width::Byte => 1,
        Width::Half => 2,
        Width::Word => 4,
    }
}

/// Cycles that an access waits for its bus at worst, beyond the one that the instruction takes.
///
/// On AHB another master may have just begun its access: one cycle. APB hangs behind a bridge that runs on the same clock,
/// divided (RM0090 section 2.1): the access waits for the next edge of that clock, up to a bus cycle less one, and takes two
/// bus cycles, set-up and access (AMBA APB, ARM IHI 0024, section 3). Writes count as long, though the core's buffer hides
/// those that come alone.
fn bus_wait(clock: &Clock, address: u32) -> Cycle {
    let apb = |bus| 3 * u64::from(clock.apb_divider(bus)) - 1;
    match address {
        0x4000_0000..=0x4000_FFFF => apb(clock::Apb::One),
        0x4001_0000..=0x4001_FFFF => apb(clock::Apb::Two),
        _ => 1,
    }
}

/// `cycle`, or never.
fn or_never(cycle: Option<Cycle>) -> Cycle {
    cycle.unwrap_or(NEVER)
}

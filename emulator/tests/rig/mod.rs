//! A chip without a core: a test reads and writes registers as firmware would.
#![allow(dead_code, unreachable_pub, reason = "each test file uses a part of it")]

use emulator::boards::SpeedyBeeF405V3;
use emulator::bus::{Access, AccessError, Cycle, Peripherals, Width};
use emulator::chip::{BareBoard, Board, Chip};
use emulator::memory::{Memory, SRAM_BASE};

pub const RCC: u32 = 0x4002_3800;
pub const FLASH: u32 = 0x4002_3C00;
pub const PWR: u32 = 0x4000_7000;
pub const GPIOA: u32 = 0x4002_0000;
pub const GPIOB: u32 = 0x4002_0400;
pub const GPIOC: u32 = 0x4002_0800;
pub const SYSCFG: u32 = 0x4001_3800;
pub const EXTI: u32 = 0x4001_3C00;
pub const TIM2: u32 = 0x4000_0000;
pub const TIM4: u32 = 0x4000_0800;
pub const TIM5: u32 = 0x4000_0C00;
pub const USART1: u32 = 0x4001_1000;
pub const SPI1: u32 = 0x4001_3000;
pub const ADC: u32 = 0x4001_2000;
pub const DMA1: u32 = 0x4002_6000;
pub const DMA2: u32 = 0x4002_6400;
pub const IWDG: u32 = 0x4000_3000;

pub const MS: u64 = 1_000_000;
pub const US: u64 = 1_000;

/// Chip, memory and the time of the next access.
pub struct Rig<B> {
    pub chip: Chip<B>,
    pub memory: Memory,
    pub at: Cycle,
}

pub fn bare() -> Rig<BareBoard> {
    Rig::new(BareBoard::default())
}

pub fn speedybee() -> Rig<SpeedyBeeF405V3> {
    Rig::new(SpeedyBeeF405V3::new())
}

impl<B: Board> Rig<B> {
    pub fn new(board: B) -> Self {
        Self { chip: Chip::new(board), memory: Memory::new(1), at: 0 }
    }

    fn access(&mut self, address: u32, width: Width) -> Access {
        // An access takes a few cycles.
        self.at += 4;
        Access { at: self.at, address, width, pc: 0x0800_0100 }
    }

    pub fn try_read(&mut self, address: u32) -> Result<u32, AccessError> {
        let access = self.access(address, Width::Word);
        self.chip.read(&mut self.memory, access)
    }

    pub fn read(&mut self, address: u32) -> u32 {
        self.try_read(address).expect("something lies there")
    }

    pub fn write(&mut self, address: u32, value: u32) {
        let access = self.access(address, Width::Word);
        self.chip.write(&mut self.memory, access, value).expect("something lies there");
    }

    pub fn write_half(&mut self, address: u32, value: u32) {
        let access = self.access(address, Width::Half);
        self.chip.write(&mut self.memory, access, value).expect("something lies there");
    }

    pub fn set(&mut self, address: u32, bits: u32) {
        let value = self.read(address);
        self.write(address, value | bits);
    }

    pub fn clear(&mut self, address: u32, bits: u32) {
        let value = self.read(address);
        self.write(address, value & !bits);
    }

    /// Lets `ns` pass.
    pub fn pass(&mut self, ns: u64) {
        let end = self.chip.clock().cycle(self.ns() + ns);
        self.chip.advance(&mut self.memory, end);
        self.at = end;
    }

    pub fn ns(&self) -> u64 {
        self.chip.clock().ns(self.at)
    }

    /// Polls until `bits` of a register are all set.
    pub fn wait_for(&mut self, address: u32, bits: u32) {
        for _ in 0..2_000_000 {
            if self.read(address) & bits == bits {
                return;
            }
        }
        panic!("bits {bits:#x} of {address:#x} stay clear");
    }

    pub fn irq(&self, number: u32) -> bool {
        self.chip.interrupt_lines() >> number & 1 == 1
    }

    /// Crystal and PLL: 168 MHz, PCLK1 42 MHz, PCLK2 84 MHz; every gate open.
    pub fn start_clocks(&mut self) {
        self.write(RCC + 0x40, 1 << 28);
        self.set(PWR, 1 << 14);
        self.set(RCC, 1 << 16);
        self.wait_for(RCC, 1 << 17);
        self.write(RCC + 0x04, 4 | 168 << 6 | 1 << 22 | 7 << 24);
        self.set(RCC, 1 << 24);
        self.wait_for(RCC, 1 << 25);
        self.write(FLASH, 5);
        self.write(RCC + 0x08, 2 | 5 << 10 | 4 << 13);
        self.wait_for(RCC + 0x08, 2 << 2);
        self.write(RCC + 0x30, 0x0070_11FF);
        self.write(RCC + 0x34, 0x40);
        self.write(RCC + 0x40, 0x3FFF_FFFF);
        self.write(RCC + 0x44, 0x0007_FFFF);
    }

    /// Sets a pin to an alternate function.
    pub fn alternate(&mut self, port: u32, pin: u32, function: u32) {
        let register = port + 0x20 + 4 * (pin / 8);
        self.clear(register, 15 << (4 * (pin % 8)));
        self.set(register, function << (4 * (pin % 8)));
        self.mode(port, pin, 2);
    }

    pub fn mode(&mut self, port: u32, pin: u32, mode: u32) {
        let value = self.read(port) & !(3 << (2 * pin));
        self.write(port, value | mode << (2 * pin));
    }

    /// Sets up a stream without switching it on.
    #[allow(clippy::too_many_arguments, reason = "they are the registers of a stream, in the manual's order")]
    pub fn stream(&mut self, dma: u32, stream: u32, cr: u32, count: u32, peripheral: u32, memory: u32) {
        let base = dma + 0x10 + 0x18 * stream;
        self.write(base, 0);
        let flags = 0x3D << [0, 6, 16, 22][stream as usize % 4];
        self.write(dma + 0x08 + 4 * (stream / 4), flags);
        self.write(base + 0x08, peripheral);
        self.write(base + 0x0C, memory);
        self.write(base + 0x04, count);
        self.write(base + 0x14, 0);
        self.write(base, cr);
    }

    pub fn start_stream(&mut self, dma: u32, stream: u32) {
        self.set(dma + 0x10 + 0x18 * stream, 1);
    }

    /// Flags of a stream: FE 1, DME 4, TE 8, HT 16, TC 32.
    pub fn stream_flags(&mut self, dma: u32, stream: u32) -> u32 {
        self.read(dma + 4 * (stream / 4)) >> [0, 6, 16, 22][stream as usize % 4] & 0x3D
    }

    pub fn stream_on(&mut self, dma: u32, stream: u32) -> bool {
        self.read(dma + 0x10 + 0x18 * stream) & 1 == 1
    }

    pub fn stream_left(&mut self, dma: u32, stream: u32) -> u32 {
        self.read(dma + 0x14 + 0x18 * stream)
    }

    pub fn put(&mut self, address: u32, bytes: &[u8]) {
        let start = (address - SRAM_BASE) as usize;
        self.memory.sram[start..start + bytes.len()].copy_from_slice(bytes);
    }

    pub fn get(&self, address: u32, count: usize) -> &[u8] {
        let start = (address - SRAM_BASE) as usize;
        &self.memory.sram[start..start + count]
    }

    pub fn bugs(&self) -> Vec<String> {
        self.memory.bugs.iter().map(|bug| bug.what.clone()).collect()
    }

    pub fn has_bug(&self, part: &str) -> bool {
        self.memory.bugs.iter().any(|bug| bug.what.contains(part))
    }

    pub fn assert_no_bugs(&self) {
        assert!(self.memory.bugs.is_empty(), "{:?}", self.memory.bugs);
    }
}

//! The inertial sensor BMI270 as its driver sees it (BST-BMI270-DS000).
//!
//! After power-up and after a soft reset the chip speaks I²C until it sees a rising edge of chip select. It gives no
//! data before 8192 bytes of configuration are loaded and its self-check has passed, which `INTERNAL_STATUS` tells.
//! In advanced power save, on after power-up, every write needs 450 µs before the next access.

mod configuration;
mod registers;
mod samples;

use std::collections::VecDeque;

use crate::chip::SpiWord;
use registers as reg;

/// Time that an access needs after a write in advanced power save (ns) (data sheet section 7.4).
const POWER_SAVE_DELAY_NS: u64 = 450_000;
/// Time between two writes in normal mode (ns).
const WRITE_DELAY_NS: u64 = 2_000;
/// From power-up or a soft reset to the first access (ns).
const START_UP_NS: u64 = 2_000_000;
/// Bytes of a complete configuration.
const CONFIG_BYTES: usize = 8192;
/// Highest clock of the interface (Hz).
const SPI_LIMIT_HZ: u32 = 10_000_000;

/// What was loaded into the sensor.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Upload {
    /// Bytes written.
    pub bytes: usize,
    /// FNV-1a hash (64 bits) of the configuration memory.
    pub hash: u64,
}

/// What may be wrong with a sensor.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Defect {
    /// It is not there; nobody drives its lines.
    Absent,
    /// It is another chip, which answers with this identity.
    Identity(u8),
    /// Its self-check after the upload of the configuration fails.
    Configuration,
    /// This register keeps what it holds, whatever is written.
    StuckRegister(u8),
    /// It reports this error of its own in ERR_REG.
    Error(u8),
    /// Its line to the chip is held low.
    StuckLow,
    /// One read of its data in so many finds nobody, a loose contact.
    Loose(u32),
    /// The gyro's axis by index, 0 to 2, has the wrong sign.
    ReversedAxis(u8),
    /// The gyro's axis by index is at the end of its range.
    Railed(u8),
}

/// The sensor.
#[derive(Clone, Debug)]
pub struct Bmi270 {
    /// What is wrong with it, if anything.
    pub defect: Option<Defect>,
    /// Rates of a hand that turns the board, on top of those given (rad/s).
    pub hand_radps: [f64; 3],
    registers: [u8; 128],
    /// No more I²C.
    spi: bool,
    selected: bool,
    position: u32,
    address: u8,
    reading: bool,
    config: Box<[u8]>,
    config_bytes: usize,
    uploaded: Option<Upload>,
    /// When the self-check after the upload is done, and whether it will pass (ns).
    init_due: Option<(u64, bool)>,
    /// Until when another access is too early, and why.
    quiet_until_ns: u64,
    quiet_why: &'static str,
    told: u32,
    pending: VecDeque<samples::Physical>,
    sensors: samples::Sensors,
    /// When the level of INT1 falls again by itself (ns).
    int_falls_ns: u64,
    int_asserted: bool,
    started_ns: u64,
    reset_asked: bool,
    /// Times that it was selected.
    selections: u32,
}

/// Mistakes, each told once.
const TOLD_CLOCK: u32 = 1;
const TOLD_MODE: u32 = 1 << 1;
const TOLD_QUIET: u32 = 1 << 2;
const TOLD_EARLY: u32 = 1 << 3;
const TOLD_UPLOAD: u32 = 1 << 4;
const TOLD_TRIM: u32 = 1 << 5;
const TOLD_I2C: u32 = 1 << 6;
const TOLD_FORMAT: u32 = 1 << 7;
const TOLD_READ_ONLY: u32 = 1 << 8;
const TOLD_RATE: u32 = 1 << 9;

impl Bmi270 {
    /// The sensor at power-up.
    pub fn new() -> Self {
        Self {
            defect: None,
            hand_radps: [0.0; 3],
            registers: reg::RESET,
            spi: false,
            selected: false,
            position: 0,
            address: 0,
            reading: false,
            config: vec![0; CONFIG_BYTES].into(),
            config_bytes: 0,
            uploaded: None,
            init_due: None,
            quiet_until_ns: START_UP_NS,
            quiet_why: "within 2 ms of power-up",
            told: 0,
            pending: VecDeque::new(),
            sensors: samples::Sensors::default(),
            int_falls_ns: u64::MAX,
            int_asserted: false,
            started_ns: 0,
            reset_asked: false,
            selections: 0,
        }
    }

    /// What the firmware loaded; none before a first INIT_CTRL = 1.
    pub fn uploaded(&self) -> Option<Upload> {
        self.uploaded
    }

    /// Whether configuration is loaded and checked.
    pub fn ready(&self) -> bool {
        self.registers[reg::INTERNAL_STATUS] & 0xF == 1
    }

    /// Output rate of the gyro (Hz): none while it is off.
    pub fn gyro_rate_hz(&self) -> Option<f64> {
        (self.ready() && self.registers[reg::PWR_CTRL] & 2 != 0)
            .then(|| 25.0 / 64.0 * f64::from(1_u32 << (self.registers[reg::GYR_CONF] & 0xF)))
    }

    /// A register, for tests.
    pub fn register(&self, address: u8) -> u8 {
        self.registers[usize::from(address & 0x7F)]
    }

    /// Chip select goes low (`true`) or high.
    pub fn select(&mut self, ns: u64, selected: bool, bugs: &mut Vec<String>) {
        if selected == self.selected {
            return;
        }
        self.selected = selected;
        if selected {
            self.position = 0;
            self.selections = self.selections.wrapping_add(1);
            if ns < self.quiet_until_ns {
                let text = format!("BMI270: an access comes {}", self.quiet_why);
                self.tell(TOLD_QUIET, text, bugs);
            }
        } else if std::mem::take(&mut self.reset_asked) {
            self.soft_reset(ns);
        } else {
            // The edge that ends I²C mode.
            self.spi = true;
        }
    }

    /// A byte on the bus at `ns`; the answer is what the sensor sent meanwhile.
    pub fn exchange(&mut self, ns: u64, word: SpiWord, bugs: &mut Vec<String>) -> u16 {
        if !self.selected {
            return 0xFFFF;
        }
        match self.defect {
            Some(Defect::Absent) => return 0xFFFF,
            Some(Defect::Loose(reads)) if self.selections.is_multiple_of(reads.max(1)) => return 0xFFFF,
            Some(Defect::StuckLow) => return 0,
            _ => {}
        }
        if word.clock_hz > SPI_LIMIT_HZ {
            let text = format!("BMI270: SPI runs at {} Hz, above its limit of 10 MHz", word.clock_hz);
            self.tell(TOLD_CLOCK, text, bugs);
        }
        if !matches!(word.mode, 0 | 3) {
            self.tell(TOLD_MODE, format!("BMI270: SPI mode {} instead of 0 or 3", word.mode), bugs);
            return 0xFFFF;
        }
        if word.bits != 8 || word.lsb_first {
            self.tell(TOLD_FORMAT, "BMI270: SPI words are not bytes with the first bit highest".into(), bugs);
            return 0xFFFF;
        }
        self.settle(ns);
        let byte = (word.value & 0xFF) as u8;
        let position = self.position;
        self.position += 1;
        if position == 0 {
            (self.reading, self.address) = (byte >> 7 == 1, byte & 0x7F);
            return 0xFFFF;
        }
        if !self.spi {
            if !self.reading {
                self.tell(
                    TOLD_I2C,
                    "BMI270: is written before a rising edge of chip select chose SPI".into(),
                    bugs,
                );
            }
            return 0xFFFF;
        }
        if !self.reading {
            self.write(ns, byte, bugs);
            self.step_address();
            return 0xFFFF;
        }
        if position == 1 {
            // The dummy byte of every read.
            return 0;
        }
        let value = self.read(ns, bugs);
        self.step_address();
        u16::from(value)
    }

    /// The level that INT1 drives; none while its output is off.
    pub fn interrupt_pin(&self) -> Option<bool> {
        let control = self.registers[reg::INT1_IO_CTRL];
        let active = control & 2 != 0;
        (control & 8 != 0).then_some(self.int_asserted == active)
    }

    /// When something happens next (ns).
    pub fn next_event_ns(&self) -> u64 {
        self.pending.front().map_or(u64::MAX, |sample| sample.ns).min(self.int_falls_ns)
    }

    /// Lets everything up to `ns` happen. Answers when a data-ready edge came on INT1, if one did.
    pub fn advance(&mut self, ns: u64, bugs: &mut Vec<String>) -> Option<u64> {
        self.settle(ns);
        let mut edge = None;
        if ns >= self.int_falls_ns {
            self.release_interrupt();
        }
        while let Some(sample) = self.pending.front().copied()
            && sample.ns <= ns
        {
            self.pending.pop_front();
            if self.convert(sample, bugs) {
                edge = Some(sample.ns);
            }
        }
        edge
    }

    fn step_address(&mut self) {
        if !matches!(usize::from(self.address), reg::INIT_DATA | reg::FIFO_DATA) {
            self.address = (self.address + 1) & 0x7F;
        }
    }

    /// Ends the self-check if its time has come.
    fn settle(&mut self, ns: u64) {
        if let Some((due, passes)) = self.init_due
            && ns >= due
        {
            self.init_due = None;
            self.registers[reg::INTERNAL_STATUS] = if passes { 1 } else { 2 };
        }
    }

    fn power_save(&self) -> bool {
        self.registers[reg::PWR_CONF] & 1 != 0
    }

    fn read(&mut self, ns: u64, bugs: &mut Vec<String>) -> u8 {
        let address = usize::from(self.address);
        match (address, self.defect) {
            (reg::CHIP_ID, Some(Defect::Identity(identity))) => return identity,
            (reg::ERR_REG, Some(Defect::Error(error))) => return error,
            _ => {}
        }
        match address {
            reg::DATA_FIRST..=reg::DATA_LAST => {
                if !self.ready() {
                    self.tell(TOLD_EARLY, "BMI270: data are read before INTERNAL_STATUS says 1".into(), bugs);
                    return 0;
                }
                // Reading data takes back data ready.
                let bit = if address < reg::GYRO_FIRST { 0x80 } else { 0x40 };
                self.registers[reg::STATUS] &= !bit;
                self.registers[address]
            }
            reg::SENSORTIME_0..=reg::SENSORTIME_2 => {
                // 39.0625 µs a count.
                let counts = ns.saturating_sub(self.started_ns) * 16 / 625_000;
                (counts >> (8 * (address - reg::SENSORTIME_0))) as u8
            }
            reg::INT_STATUS_0 | reg::INT_STATUS_1 | reg::EVENT => {
                let value = std::mem::take(&mut self.registers[address]);
                if address == reg::INT_STATUS_1 && self.registers[reg::INT_LATCH] & 1 != 0 {
                    self.release_interrupt();
                }
                value
            }
            reg::INIT_DATA => self.config.get(self.init_place()).copied().unwrap_or(0),
            _ => self.registers[address],
        }
    }

    fn write(&mut self, ns: u64, byte: u8, bugs: &mut Vec<String>) {
        let address = usize::from(self.address);
        let power_save = self.power_save();
        match address {
            _ if self.defect == Some(Defect::StuckRegister(self.address)) => {}
            reg::INIT_DATA => {
                let place = self.init_place() + self.config_bytes_of_burst();
                if let Some(cell) = self.config.get_mut(place) {
                    *cell = byte;
                }
                self.config_bytes += 1;
            }
            reg::INIT_CTRL => self.write_init_ctrl(ns, byte, bugs),
            reg::CMD => self.command(byte, bugs),
            reg::PWR_CONF => {
                self.registers[address] = byte & 7;
                if power_save && byte & 1 == 0 {
                    self.be_quiet(ns, POWER_SAVE_DELAY_NS, "within 450 µs of leaving advanced power save");
                    return;
                }
            }
            reg::PWR_CTRL => {
                self.sensors.enabled(ns, self.registers[address], byte);
                self.registers[address] = byte & 0xF;
            }
            reg::INT1_IO_CTRL => {
                self.registers[address] = byte;
            }
            reg::NVM_CONF => self.tell_trim(bugs),
            0x00..=0x23 | reg::GYR_CAS => {
                let text = format!("BMI270: the read-only register {address:#04x} is written");
                self.tell(TOLD_READ_ONLY, text, bugs);
            }
            _ => self.registers[address] = byte,
        }
        if self.power_save() {
            self.be_quiet(ns, POWER_SAVE_DELAY_NS, "within 450 µs of a write in advanced power save");
        } else if address != reg::CMD {
            self.be_quiet(ns, WRITE_DELAY_NS, "within 2 µs of a write");
        }
    }

    /// Takes effect when chip select rises: it takes another such edge to leave I²C mode.
    fn soft_reset(&mut self, ns: u64) {
        *self = Self {
            defect: self.defect,
            told: self.told,
            pending: std::mem::take(&mut self.pending),
            uploaded: self.uploaded,
            started_ns: ns,
            ..Self::new()
        };
        self.be_quiet(ns, START_UP_NS, "within 2 ms of a soft reset");
    }

    fn command(&mut self, byte: u8, bugs: &mut Vec<String>) {
        match byte {
            reg::CMD_SOFT_RESET => self.reset_asked = true,
            reg::CMD_NVM_PROG => self.tell_trim(bugs),
            _ => {}
        }
    }

    fn be_quiet(&mut self, ns: u64, length_ns: u64, why: &'static str) {
        (self.quiet_until_ns, self.quiet_why) = (ns + length_ns, why);
    }

    fn release_interrupt(&mut self) {
        (self.int_asserted, self.int_falls_ns) = (false, u64::MAX);
    }

    fn tell_trim(&mut self, bugs: &mut Vec<String>) {
        let text = "BMI270: the trim memory is written, which it survives some ten times".into();
        self.tell(TOLD_TRIM, text, bugs);
    }

    fn tell(&mut self, what: u32, text: String, bugs: &mut Vec<String>) {
        if self.told & what == 0 {
            self.told |= what;
            bugs.push(text);
        }
    }
}

impl Default for Bmi270 {
    fn default() -> Self {
        Self::new()
    }
}

//! Ports A to I (RM0090 section 8).

use super::pin::{Pin, Route};

/// What a pin is set to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mode {
    /// Input.
    Input,
    /// Plain output.
    Output,
    /// Driven by a peripheral.
    Alternate,
    /// Analog.
    Analog,
}

/// One port.
#[derive(Clone, Debug)]
pub(crate) struct Gpio {
    moder: u32,
    otyper: u32,
    ospeedr: u32,
    pupdr: u32,
    odr: u16,
    lckr: u32,
    lock_step: u8,
    afr: [u32; 2],
    reset_values: [u32; 3],
    /// Levels the board drives, where it does.
    external: u16,
    driven: u16,
}

impl Gpio {
    /// Ports A and B have the debug pins set up at reset.
    pub(crate) fn new(port: usize) -> Self {
        let reset_values = match port {
            0 => [0xA800_0000, 0x0C00_0000, 0x6400_0000],
            1 => [0x0000_0280, 0x0000_00C0, 0x0000_0100],
            _ => [0; 3],
        };
        Self {
            moder: reset_values[0],
            otyper: 0,
            ospeedr: reset_values[1],
            pupdr: reset_values[2],
            odr: 0,
            lckr: 0,
            lock_step: 0,
            afr: [0; 2],
            reset_values,
            external: 0,
            driven: 0,
        }
    }

    /// Registers to their reset values; what the board drives stays.
    pub(crate) fn reset(&mut self) {
        *self = Self {
            moder: self.reset_values[0],
            otyper: 0,
            ospeedr: self.reset_values[1],
            pupdr: self.reset_values[2],
            odr: 0,
            lckr: 0,
            lock_step: 0,
            afr: [0; 2],
            ..*self
        };
    }

    /// The board drives a pin or lets go of it.
    pub(crate) fn set_external(&mut self, bit: u16, level: Option<bool>) {
        match level {
            Some(true) => (self.external, self.driven) = (self.external | bit, self.driven | bit),
            Some(false) => (self.external, self.driven) = (self.external & !bit, self.driven | bit),
            None => self.driven &= !bit,
        }
    }

    /// What a pin is set to.
    pub(crate) fn mode(&self, number: usize) -> Mode {
        match self.moder >> (2 * number) & 3 {
            0 => Mode::Input,
            1 => Mode::Output,
            2 => Mode::Alternate,
            _ => Mode::Analog,
        }
    }

    /// Number of the alternate function of a pin that is set to one.
    pub(crate) fn function(&self, number: usize) -> Option<u8> {
        (self.mode(number) == Mode::Alternate)
            .then(|| (self.afr[number / 8] >> (4 * (number % 8)) & 15) as u8)
    }

    /// What the pin drives as a plain output: none while it floats or is not an output.
    pub(crate) fn driven_level(&self, number: usize) -> Option<bool> {
        let level = self.odr >> number & 1 == 1;
        let open_drain = self.otyper >> number & 1 == 1;
        (self.mode(number) == Mode::Output && !(open_drain && level)).then_some(level)
    }

    /// Pins that drive, and their levels.
    pub(crate) fn outputs(&self) -> (u16, u16) {
        // Bit 0 of each pair of MODER without bit 1: a plain output.
        let outputs = squeeze(self.moder & !(self.moder >> 1));
        let floating = self.otyper as u16 & self.odr;
        (outputs & !floating, self.odr)
    }

    /// The input data register.
    pub(crate) fn idr(&self) -> u16 {
        let (drives, levels) = self.outputs();
        let analog = squeeze(self.moder & self.moder >> 1);
        let pulled_up = squeeze(self.pupdr & !(self.pupdr >> 1));
        let from_outside = self.driven & self.external | !self.driven & pulled_up;
        (drives & levels | !drives & from_outside) & !analog
    }

    pub(crate) fn read(&self, offset: u32) -> u32 {
        match offset {
            0x00 => self.moder,
            0x04 => self.otyper,
            0x08 => self.ospeedr,
            0x0C => self.pupdr,
            0x10 => u32::from(self.idr()),
            0x14 => u32::from(self.odr),
            0x1C => self.lckr,
            0x20 => self.afr[0],
            0x24 => self.afr[1],
            _ => 0,
        }
    }

    pub(crate) fn write(&mut self, offset: u32, value: u32) {
        // Pins locked by LCKR keep their set-up.
        let locked = if self.lckr >> 16 & 1 == 1 { self.lckr as u16 } else { 0 };
        let two = spread(locked) * 3;
        match offset {
            0x00 => self.moder = self.moder & two | value & !two,
            0x04 => self.otyper = (self.otyper & u32::from(locked) | value & !u32::from(locked)) & 0xFFFF,
            0x08 => self.ospeedr = self.ospeedr & two | value & !two,
            0x0C => self.pupdr = self.pupdr & two | value & !two,
            0x14 => self.odr = value as u16,
            // Where both are asked for, set wins.
            0x18 => self.odr = self.odr & !((value >> 16) as u16) | value as u16,
            0x1C => self.write_lock(value),
            0x20 | 0x24 => {
                let half = (offset as usize - 0x20) / 4;
                let keep =
                    (0..8).filter(|n| locked >> (8 * half + n) & 1 == 1).fold(0, |m, n| m | 15 << (4 * n));
                self.afr[half] = self.afr[half] & keep | value & !keep;
            }
            _ => {}
        }
    }

    /// Whether the pin of `route` is set to its alternate function.
    pub(crate) fn leads(&self, (pin, function): Route) -> bool {
        self.function(pin.number()) == Some(function)
    }

    /// The level the pin sees.
    pub(crate) fn level(&self, pin: Pin) -> bool {
        self.idr() & pin.bit() != 0
    }

    /// LCKK: write 1, 0, 1 with the same pins (RM0090 section 8.4.8).
    fn write_lock(&mut self, value: u32) {
        if self.lckr >> 16 & 1 == 1 {
            return;
        }
        let key = value >> 16 & 1 == 1;
        self.lock_step = match (self.lock_step, key) {
            (0, true) => 1,
            (1, false) if value & 0xFFFF == self.lckr & 0xFFFF => 2,
            (2, true) if value & 0xFFFF == self.lckr & 0xFFFF => 3,
            _ => 0,
        };
        self.lckr = value & 0xFFFF | u32::from(self.lock_step == 3) << 16;
    }
}

/// Collects the even bits of a register with two bits a pin.
fn squeeze(pairs: u32) -> u16 {
    let mut x = pairs & 0x5555_5555;
    x = (x | x >> 1) & 0x3333_3333;
    x = (x | x >> 2) & 0x0F0F_0F0F;
    x = (x | x >> 4) & 0x00FF_00FF;
    (x | x >> 8) as u16
}

/// The inverse of [`squeeze`].
fn spread(bits: u16) -> u32 {
    let mut x = u32::from(bits);
    x = (x | x << 8) & 0x00FF_00FF;
    x = (x | x << 4) & 0x0F0F_0F0F;
    x = (x | x << 2) & 0x3333_3333;
    (x | x << 1) & 0x5555_5555
}

//! The gyro's bus: SPI1 by its registers, polled, every wait bounded.
//!
//! Polled, because a reading is short: 14 bytes take 21.3 µs on the wire at 5.25 MHz. DMA would free 1.7 % of the
//! processor and cost set-up, an interrupt and its latency, on the way from gyro to motors. The waits count polls, not
//! time, so that being interrupted is no timeout.

use embassy_stm32::gpio::{AfType, Flex, Level, Output, OutputType, Pull, Speed};
use embassy_stm32::pac::SPI1;
use embassy_stm32::pac::spi::regs::Sr;
use embassy_stm32::pac::spi::vals::{Br, Mstr};
use embassy_stm32::{Peri, peripherals, rcc};

use super::facts::{GyroBusParts, SPI_ALTERNATE_FUNCTION};

/// 84 MHz / 16 = 5.25 MHz; the sensor takes 10 MHz, and 84 MHz / 8 is more.
const CLOCK: Br = Br::DIV16;
/// Polls per wait. A byte takes 256 processor cycles and a poll at least 6: a working bus needs 45 at most. Bound of a
/// wait on a dead one: some 30 µs.
const POLLS: u32 = 400;

/// The bus moved no byte in time, or one was lost.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct BusError;

/// The bus with one sensor on it.
pub(super) struct Spi {
    select: Output<'static>,
    _spi: Peri<'static, peripherals::SPI1>,
    _pins: [Flex<'static>; 3],
}

impl Spi {
    /// Sets the bus up: mode 0, bytes, the sensor not selected.
    pub(super) fn new(parts: GyroBusParts) -> Self {
        let GyroBusParts { spi, clock, miso, mosi, select } = parts;
        rcc::enable_and_reset::<peripherals::SPI1>();
        let output = |pin: &mut Flex<'static>| {
            pin.set_as_af_unchecked(
                SPI_ALTERNATE_FUNCTION,
                AfType::output(OutputType::PushPull, Speed::VeryHigh),
            );
        };
        let mut pins = [Flex::new(clock), Flex::new(mosi), Flex::new(miso)];
        let [clock, mosi, miso] = &mut pins;
        output(clock);
        output(mosi);
        // With no sensor the line must not float: it then reads zeros, which are no measurement.
        miso.set_as_af_unchecked(SPI_ALTERNATE_FUNCTION, AfType::input(Pull::Down));
        SPI1.cr1().write(|w| {
            w.set_mstr(Mstr::MASTER);
            w.set_br(CLOCK);
            // Chip-select is a plain output; the peripheral is told that it is nobody's slave.
            w.set_ssm(true);
            w.set_ssi(true);
        });
        SPI1.cr1().modify(|w| w.set_spe(true));
        Self { select: Output::new(select, Level::High, Speed::High), _spi: spi, _pins: pins }
    }

    /// Writes bytes to a register, or from it on where it is one that advances.
    ///
    /// # Errors
    /// The bus does not work.
    pub(super) fn write(&mut self, register: u8, bytes: &[u8]) -> Result<(), BusError> {
        self.selected(|| {
            exchange(register)?;
            bytes.iter().try_for_each(|byte| exchange(*byte).map(|_| ()))
        })
    }

    /// Reads one register.
    ///
    /// # Errors
    /// The bus does not work.
    pub(super) fn read(&mut self, address: u8) -> Result<u8, BusError> {
        self.selected(|| {
            exchange(address)?;
            // A dummy comes first.
            exchange(0)?;
            exchange(0)
        })
    }

    /// Reads `N` bytes with no pause between them. For code that nothing interrupts for a byte's time (1.5 µs): at the
    /// control tick's priority.
    ///
    /// # Errors
    /// The bus does not work, or a byte was lost because an interrupt took too long.
    pub(super) fn read_burst<const N: usize>(&mut self, address: u8) -> Result<[u8; N], BusError> {
        self.selected(|| {
            let mut bytes = [0; N];
            // One byte in the shift register and one behind it, so that the clock never waits for the program.
            send(address);
            wait(Sr::txe)?;
            send(0);
            for _ in 0..2 {
                wait(Sr::rxne)?;
                let _ = receive();
                send(0);
            }
            let last = N.saturating_sub(2);
            for (index, byte) in bytes.iter_mut().enumerate() {
                wait(Sr::rxne)?;
                *byte = receive();
                if index < last {
                    send(0);
                }
            }
            Ok(bytes)
        })
    }

    /// Runs `transfer` with the sensor selected.
    fn selected<T>(&mut self, transfer: impl FnOnce() -> Result<T, BusError>) -> Result<T, BusError> {
        // What an earlier failure left behind: reading data, then status, clears it.
        let _ = receive();
        let _ = SPI1.sr().read();
        self.select.set_low();
        let result = transfer();
        let quiet = wait(|status| !status.bsy());
        self.select.set_high();
        let value = result?;
        quiet.map(|()| value)
    }
}

/// One byte each way. The clock rests until the byte is taken, so that none is lost however long that takes.
fn exchange(byte: u8) -> Result<u8, BusError> {
    send(byte);
    wait(Sr::rxne)?;
    Ok(receive())
}

fn send(byte: u8) {
    SPI1.dr().write(|w| w.set_dr(u16::from(byte)));
}

fn receive() -> u8 {
    SPI1.dr().read().dr() as u8
}

/// Waits, and fails at once where a byte was lost: reading the status after the data clears that flag.
fn wait(ready: impl Fn(&Sr) -> bool) -> Result<(), BusError> {
    for _ in 0..POLLS {
        let status = SPI1.sr().read();
        if status.ovr() {
            return Err(BusError);
        }
        if ready(&status) {
            return Ok(());
        }
    }
    Err(BusError)
}

//! The inertial sensor: set up once in thread mode, read in every control tick.
//!
//! Set-up takes some 110 ms, runs beside everything else and is tried a few times; each step of it is bounded in time
//! and says what went wrong. Until it is done arming waits; if it fails arming is refused and telemetry tells why.

use embassy_futures::yield_now;
use embassy_sync::blocking_mutex::Mutex;
use embassy_sync::blocking_mutex::raw::CriticalSectionRawMutex;
use embassy_time::{Duration, Instant, Timer};
use mintime_firmware::bmi270::{self, CrossAxis, register};
use mintime_firmware::gyro::ImuSample;
use mintime_shared::messages::GyroFault;

use core::cell::Cell;

use super::facts::{self, GyroParts};
use super::spi::{BusError, Spi};
use super::tick_source::{self, EdgeInput};

/// Times that set-up is tried.
const TRIES: u32 = 4;
/// Pause between two, and before the first: the sensor needs 2 ms after its supply has come up.
const PAUSE: Duration = Duration::from_millis(10);
/// How often the chip is asked whether it took its configuration file.
const INIT_POLL: Duration = Duration::from_millis(2);

/// What became of the sensor.
pub(super) enum Outcome {
    /// Ready to be read.
    Ready(Imu),
    /// Tried often enough.
    Failed(GyroFault),
}

/// The outcome on its way to the control tick.
static OUTCOME: Mutex<CriticalSectionRawMutex, Cell<Option<Outcome>>> = Mutex::new(Cell::new(None));

/// Takes the outcome of the set-up, once.
pub(super) fn take_outcome() -> Option<Outcome> {
    OUTCOME.lock(Cell::take)
}

/// A sensor that measures.
pub(super) struct Imu {
    spi: Spi,
    cross_axis: CrossAxis,
}

impl Imu {
    /// Reads the sample that the last edge announced, body axes, or `None` where the bus failed or the bytes are no
    /// measurement. Takes 24 µs. From the control tick only: see [`Spi::read_burst`].
    pub(super) fn sample(&mut self) -> Option<ImuSample> {
        let bytes = self.spi.read_burst(bmi270::READ | register::DATA_ACC_X).ok()?;
        let chip = bmi270::sample(&bytes, self.cross_axis)?;
        Some(ImuSample {
            gyro_radps: facts::to_body_axes(chip.gyro_radps),
            accel_mps2: facts::to_body_axes(chip.accel_mps2),
        })
    }
}

/// Sets the sensor up, hands it to the control tick and ends.
#[embassy_executor::task]
pub(super) async fn set_up(parts: GyroParts) {
    let edge = EdgeInput::new(parts.data_ready);
    let mut spi = Spi::new(parts.bus);
    let mut outcome = Err(GyroFault::Bus);
    for _ in 0..TRIES {
        Timer::after(PAUSE).await;
        outcome = configure(&mut spi).await;
        match outcome {
            Ok(_) => break,
            Err(fault) => log(fault),
        }
    }
    match outcome {
        Ok(cross_axis) => {
            defmt::info!("gyro BMI270 is set up");
            OUTCOME.lock(|slot| slot.set(Some(Outcome::Ready(Imu { spi, cross_axis }))));
            tick_source::enable_edge(edge);
        }
        Err(fault) => {
            defmt::error!("no gyro; arming is refused");
            OUTCOME.lock(|slot| slot.set(Some(Outcome::Failed(fault))));
        }
    }
}

/// Says what went wrong. By hand, for the text that people get on the host would bring its formatting with it.
fn log(fault: GyroFault) {
    let (what, value) = match fault {
        GyroFault::Bus => ("bus", 0),
        GyroFault::Identity(identity) => ("identity", identity),
        GyroFault::Configuration(status) => ("configuration file, status", status),
        GyroFault::Register(register) => ("register", register),
        GyroFault::Chip(error) => ("its own error", error),
    };
    defmt::warn!("gyro not set up: {=str} {=u8:#04x}", what, value);
}

/// One try, from whatever state the chip is in.
async fn configure(spi: &mut Spi) -> Result<CrossAxis, GyroFault> {
    // The chip powers up on I²C; a rising edge of chip-select turns it to SPI. The answer to that first read is void.
    read(spi, register::CHIP_ID)?;
    Timer::after_micros(bmi270::POWER_SAVE_GAP_US).await;
    write(spi, register::CMD, bmi270::SOFT_RESET)?;
    Timer::after_micros(bmi270::RESET_US).await;
    read(spi, register::CHIP_ID)?;
    Timer::after_micros(bmi270::POWER_SAVE_GAP_US).await;
    let identity = read(spi, register::CHIP_ID)?;
    if identity != bmi270::CHIP_ID {
        return Err(GyroFault::Identity(identity));
    }
    defmt::info!("gyro identity {=u8:#04x}", identity);
    Timer::after_micros(bmi270::POWER_SAVE_GAP_US).await;
    write(spi, register::PWR_CONF, bmi270::POWER_SAVE_OFF)?;
    Timer::after_micros(bmi270::POWER_SAVE_GAP_US).await;

    upload(spi).await?;

    for (register, value) in bmi270::SETTINGS {
        write(spi, register, value)?;
        if read(spi, register)? != value {
            return Err(GyroFault::Register(register));
        }
    }
    let cross_axis = CrossAxis::from_register(read(spi, register::GYR_CAS)?);
    Timer::after_micros(bmi270::SETTLE_US).await;
    match read(spi, register::ERR_REG)? {
        0 => Ok(cross_axis),
        error => Err(GyroFault::Chip(error)),
    }
}

/// Uploads the configuration file and waits until the chip has taken it. 14 ms of bus, in pieces.
async fn upload(spi: &mut Spi) -> Result<(), GyroFault> {
    write(spi, register::INIT_CTRL, 0)?;
    let mut position = 0;
    for chunk in bmi270::CONFIG_FILE.chunks(bmi270::CHUNK_BYTES) {
        spi.write(register::INIT_ADDR_0, &bmi270::chunk_address(position))?;
        write_gap();
        spi.write(register::INIT_DATA, chunk)?;
        write_gap();
        position = position.saturating_add(chunk.len() as u16);
        yield_now().await;
    }
    write(spi, register::INIT_CTRL, 1)?;

    let begin = Instant::now();
    loop {
        Timer::after(INIT_POLL).await;
        let status = read(spi, register::INTERNAL_STATUS)?;
        if status & bmi270::INIT_MESSAGE == bmi270::INIT_OK {
            return Ok(());
        }
        if begin.elapsed() >= Duration::from_micros(bmi270::INIT_TIMEOUT_US) {
            return Err(GyroFault::Configuration(status));
        }
    }
}

fn read(spi: &mut Spi, register: u8) -> Result<u8, GyroFault> {
    Ok(spi.read(bmi270::READ | register)?)
}

fn write(spi: &mut Spi, register: u8, value: u8) -> Result<(), GyroFault> {
    spi.write(register, &[value])?;
    write_gap();
    Ok(())
}

/// The pause that the chip needs behind a write.
fn write_gap() {
    cortex_m::asm::delay(facts::CORE_MHZ * bmi270::WRITE_GAP_NS / 1000);
}

impl From<BusError> for GyroFault {
    fn from(_: BusError) -> Self {
        Self::Bus
    }
}

//! What is to be known of the inertial sensor BMI270: registers, settings, and what its numbers mean. No hardware.
//!
//! Source: Bosch Sensortec, BMI270 data sheet BST-BMI270-DS000, sections 4.4 (initialization), 4.6 (sensor data), 5
//! (register map) and 6 (interfaces). The board's driver carries out what stands here.

use mintime_shared::model::GRAVITY_MPS2;

use crate::gyro::ImuSample;

/// Registers by address.
pub mod register {
    /// Identity of the chip, [`super::CHIP_ID`].
    pub const CHIP_ID: u8 = 0x00;
    /// Errors that the chip found in itself; zero when well.
    pub const ERR_REG: u8 = 0x02;
    /// First of twelve bytes: accelerometer x, y, z, then gyro x, y, z, low byte first.
    pub const DATA_ACC_X: u8 = 0x0C;
    /// What became of the configuration file, see [`super::INIT_OK`].
    pub const INTERNAL_STATUS: u8 = 0x21;
    /// Cross-axis sensitivity of the gyro, 7 bits, signed.
    pub const GYR_CAS: u8 = 0x3C;
    /// Data rate and filter of the accelerometer.
    pub const ACC_CONF: u8 = 0x40;
    /// Range of the accelerometer.
    pub const ACC_RANGE: u8 = 0x41;
    /// Data rate and filter of the gyro.
    pub const GYR_CONF: u8 = 0x42;
    /// Range of the gyro.
    pub const GYR_RANGE: u8 = 0x43;
    /// Electrical behaviour of pin INT1.
    pub const INT1_IO_CTRL: u8 = 0x53;
    /// Whether interrupts latch.
    pub const INT_LATCH: u8 = 0x55;
    /// Which data interrupts go to which pin.
    pub const INT_MAP_DATA: u8 = 0x58;
    /// Starts and ends the upload of the configuration file.
    pub const INIT_CTRL: u8 = 0x59;
    /// Where in the file the next chunk goes: two registers, see [`super::chunk_address`].
    pub const INIT_ADDR_0: u8 = 0x5B;
    /// Takes the configuration file; a burst to it does not advance the register.
    pub const INIT_DATA: u8 = 0x5E;
    /// Power saving.
    pub const PWR_CONF: u8 = 0x7C;
    /// Which sensors are on.
    pub const PWR_CTRL: u8 = 0x7D;
    /// Commands.
    pub const CMD: u8 = 0x7E;
}

/// Set in the address byte of a read. The first byte that comes back is a dummy.
pub const READ: u8 = 0x80;
/// What [`register::CHIP_ID`] holds.
pub const CHIP_ID: u8 = 0x24;
/// Command: reset everything. The chip then speaks I²C again, until the next rising edge of its chip-select.
pub const SOFT_RESET: u8 = 0xB6;
/// [`register::PWR_CONF`] while the configuration file is uploaded: advanced power saving off.
pub const POWER_SAVE_OFF: u8 = 0x00;
/// The message in [`register::INTERNAL_STATUS`] after a good upload, under [`INIT_MESSAGE`].
pub const INIT_OK: u8 = 0x01;
/// Bits of the message.
pub const INIT_MESSAGE: u8 = 0x0F;

/// A soft reset takes 2 ms; half as much again.
pub const RESET_US: u64 = 3_000;
/// Accesses may follow each other no faster while the chip saves power, and after that is switched off, µs (450).
pub const POWER_SAVE_GAP_US: u64 = 500;
/// Writes may follow each other no faster otherwise, ns.
pub const WRITE_GAP_NS: u32 = 2_000;
/// After the upload the chip needs up to 20 ms; it is given up after this long, µs.
pub const INIT_TIMEOUT_US: u64 = 150_000;
/// After the sensors are switched on the gyro needs 45 ms, and its first samples read zero, µs.
pub const SETTLE_US: u64 = 60_000;

/// The configuration file: Bosch's, see `vendor/bosch-bmi270`.
pub static CONFIG_FILE: &[u8; 8192] = include_bytes!("../vendor/bosch-bmi270/config_file.bin");
/// Bytes of the file that go up at once: 0.4 ms of bus, so that whoever else runs gets a turn between chunks.
pub const CHUNK_BYTES: usize = 256;

/// Values of [`register::INIT_ADDR_0`] and the register after it for a chunk at this byte of the file: the address
/// counts words of two bytes, four bits below and eight above.
pub const fn chunk_address(byte: u16) -> [u8; 2] {
    let word = byte / 2;
    [(word & 0x0F) as u8, (word >> 4) as u8]
}

/// Settings, (register, value), in the order to write them. Each reads back as written.
///
/// Both sensors at 800 Hz with the normal filter in high-performance mode: the gyro's bandwidth is then 256 Hz, the
/// widest and hence the one with the least delay. Data-ready rises on INT1, push-pull, not latched.
pub const SETTINGS: [(u8, u8); 9] = [
    (register::ACC_CONF, 0xAB),
    (register::ACC_RANGE, 0x03),
    // Filter and noise in high-performance mode (bits 7, 6), normal filter (2 in bits 5:4), 800 Hz (0xB).
    (register::GYR_CONF, 0xEB),
    // ±2000 °/s; bit 3 concerns the pre-filtered path, which is not in use.
    (register::GYR_RANGE, 0x08),
    (register::INT1_IO_CTRL, 0x0A),
    (register::INT_LATCH, 0x00),
    (register::INT_MAP_DATA, 0x04),
    // Temperature, accelerometer, gyro on; auxiliary sensor off.
    (register::PWR_CTRL, 0x0E),
    // Advanced power saving stays off: it would delay samples.
    (register::PWR_CONF, 0x02),
];

/// Bytes of one reading: x, y, z of the accelerometer, then of the gyro.
pub const SAMPLE_BYTES: usize = 12;

/// rad/s per count at ±2000 °/s: 16.384 counts per °/s.
const GYRO_RADPS_PER_COUNT: f32 = core::f32::consts::PI / 180.0 / 16.384;
/// m/s² per count at ±16 g: 2048 counts per g.
const ACCEL_MPS2_PER_COUNT: f32 = STANDARD_GRAVITY_MPS2 / 2048.0;
/// The g that accelerometers count in, m/s².
const STANDARD_GRAVITY_MPS2: f32 = 9.806_65;
const _: () = assert!((STANDARD_GRAVITY_MPS2 - GRAVITY_MPS2 as f32).abs() < 0.05);

/// Coupling of rotation about z into the reading about x, as the maker measured it on this very chip.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct CrossAxis {
    /// 1/512 each.
    factor_zx: i8,
}

impl CrossAxis {
    /// From the register [`register::GYR_CAS`]: bits 6:0, two's complement.
    pub const fn from_register(value: u8) -> Self {
        Self { factor_zx: ((value << 1) as i8) >> 1 }
    }
}

/// One reading in SI units along the chip's axes, or `None` where the bytes are no measurement: a bus that is stuck
/// reads all ones or all zeros, which noise alone keeps six real axes from.
///
/// A gyro axis at the end of its range reads ±34.9 rad/s, which the flight logic takes for saturated, whatever the
/// cross-axis term says.
pub fn sample(bytes: &[u8; SAMPLE_BYTES], cross_axis: CrossAxis) -> Option<ImuSample> {
    if bytes.iter().all(|b| *b == 0) || bytes.iter().all(|b| *b == 0xFF) {
        return None;
    }
    let [ax0, ax1, ay0, ay1, az0, az1, gx0, gx1, gy0, gy1, gz0, gz1] = *bytes;
    let accel = [[ax0, ax1], [ay0, ay1], [az0, az1]].map(i16::from_le_bytes);
    let [gx, gy, gz] = [[gx0, gx1], [gy0, gy1], [gz0, gz1]].map(i16::from_le_bytes);
    let coupled = i32::from(cross_axis.factor_zx) * i32::from(gz) / 512;
    let gx = if is_saturated(gx) { i32::from(gx) } else { i32::from(gx) - coupled };
    Some(ImuSample {
        gyro_radps: [gx, i32::from(gy), i32::from(gz)].map(|count| count as f32 * GYRO_RADPS_PER_COUNT),
        accel_mps2: accel.map(|count| f32::from(count) * ACCEL_MPS2_PER_COUNT),
    })
}

/// Whether a raw value is at the end of the range.
const fn is_saturated(count: i16) -> bool {
    count == i16::MAX || count == i16::MIN
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::config::GYRO_SATURATION_RADPS;
    use proptest::prelude::*;

    fn bytes(accel: [i16; 3], gyro: [i16; 3]) -> [u8; SAMPLE_BYTES] {
        let mut bytes = [0; SAMPLE_BYTES];
        for (slot, value) in bytes.chunks_exact_mut(2).zip(accel.into_iter().chain(gyro)) {
            slot.copy_from_slice(&value.to_le_bytes());
        }
        bytes
    }

    fn read(accel: [i16; 3], gyro: [i16; 3], cas: u8) -> ImuSample {
        sample(&bytes(accel, gyro), CrossAxis::from_register(cas)).expect("a measurement")
    }

    #[test]
    fn full_scale_and_one_g_read_as_the_data_sheet_says() {
        let sample = read([2048, -2048, 4096], [16384, -16384, 1], 0);
        let [x, y, z] = sample.accel_mps2;
        assert!((x - 9.80665).abs() < 1e-5 && (y + 9.80665).abs() < 1e-5 && (z - 19.6133).abs() < 1e-5);
        let [x, y, z] = sample.gyro_radps.map(f32::to_degrees);
        assert!((x - 1000.0).abs() < 1e-3 && (y + 1000.0).abs() < 1e-3 && (z - 0.061_035).abs() < 1e-5);
    }

    #[test]
    fn each_axis_has_its_place() {
        let sample = read([1, 2, 3], [4, 5, 6], 0);
        let counts = sample.gyro_radps.map(|v| libm::roundf(v / GYRO_RADPS_PER_COUNT));
        assert_eq!(counts, [4.0, 5.0, 6.0]);
        assert_eq!(sample.accel_mps2.map(|v| libm::roundf(v / ACCEL_MPS2_PER_COUNT)), [1.0, 2.0, 3.0]);
    }

    #[test]
    fn the_ends_of_the_range_count_as_saturated_whatever_the_cross_axis() {
        for end in [i16::MAX, i16::MIN] {
            let sample = read([0, 0, 2048], [end, 0, end], 0x3F);
            assert!(sample.gyro_radps[0].abs() >= GYRO_SATURATION_RADPS, "{sample:?}");
            assert!(sample.gyro_radps[2].abs() >= GYRO_SATURATION_RADPS, "{sample:?}");
        }
    }

    #[test]
    fn the_cross_axis_factor_is_a_signed_number_of_seven_bits() {
        let of_z =
            |cas| libm::roundf(read([0, 0, 1], [0, 0, 5120], cas).gyro_radps[0] / GYRO_RADPS_PER_COUNT);
        assert_eq!(of_z(0x00), 0.0);
        assert_eq!(of_z(0x01), -10.0);
        assert_eq!(of_z(0x3F), -630.0);
        assert_eq!(of_z(0x7F), 10.0);
        assert_eq!(of_z(0x40), 640.0);
        // Bit 7 is not part of it.
        assert_eq!(of_z(0x80), 0.0);
    }

    #[test]
    fn a_stuck_bus_is_no_measurement() {
        for stuck in [0x00, 0xFF] {
            assert_eq!(sample(&[stuck; SAMPLE_BYTES], CrossAxis::default()), None);
        }
        assert!(sample(&bytes([0, 0, 2048], [0; 3]), CrossAxis::default()).is_some());
    }

    /// Chunk addresses as the data sheet counts them: in words, four bits low, eight high.
    #[test]
    fn chunks_cover_the_file_without_gaps() {
        let mut expected = 0_usize;
        for (index, chunk) in CONFIG_FILE.chunks(CHUNK_BYTES).enumerate() {
            let [low, high] = chunk_address((index * CHUNK_BYTES) as u16);
            assert!(low <= 0x0F);
            assert_eq!((usize::from(high) << 4 | usize::from(low)) * 2, expected);
            expected += chunk.len();
        }
        assert_eq!(expected, 8192);
    }

    #[test]
    fn the_configuration_file_is_whole() {
        assert_eq!(mintime_shared::crc32(CONFIG_FILE.as_slice()), 0x229A_1189);
    }

    /// 800 Hz in both sensors, ±2000 °/s, ±16 g, data-ready on INT1 only, gyro and accelerometer on.
    #[test]
    fn the_settings_are_what_the_flight_logic_assumes() {
        let value = |register| SETTINGS.iter().find(|(r, _)| *r == register).map(|(_, v)| *v);
        assert_eq!(value(register::GYR_CONF).map(|v| v & 0x0F), Some(0x0B));
        assert_eq!(value(register::ACC_CONF).map(|v| v & 0x0F), Some(0x0B));
        assert_eq!(value(register::GYR_RANGE).map(|v| v & 0x07), Some(0));
        assert_eq!(value(register::ACC_RANGE).map(|v| v & 0x03), Some(3));
        assert_eq!(value(register::INT_MAP_DATA), Some(1 << 2));
        assert_eq!(value(register::PWR_CTRL).map(|v| v & 0x06), Some(0x06));
        assert_eq!(value(register::PWR_CONF).map(|v| v & 0x01), Some(0));
    }

    proptest! {
        /// Odd and monotone, finite, within the range: for any raw numbers.
        #[test]
        fn any_numbers_convert(accel: [i16; 3], gyro: [i16; 3], cas: u8) {
            if let Some(sample) = sample(&bytes(accel, gyro), CrossAxis::from_register(cas)) {
                prop_assert!(sample.accel_mps2.iter().all(|a| a.abs() <= 16.0 * STANDARD_GRAVITY_MPS2 * 1.0001));
                prop_assert!(sample.gyro_radps.iter().skip(1).all(|r| r.abs() <= 34.91));
                // The cross-axis term adds an eighth at most.
                prop_assert!(sample.gyro_radps[0].abs() <= 34.91 * 1.13);
            }
        }
    }
}

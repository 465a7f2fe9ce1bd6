//! From motion to the data registers of the BMI270.

use super::{Bmi270, Defect, TOLD_RATE, registers as reg};

/// Standard gravity (m/s²).
const STANDARD_GRAVITY: f64 = 9.806_65;
/// From enabling the gyro to its first valid sample (ns) (data sheet table 3: 45 ms from suspend).
const GYRO_START_NS: u64 = 45_000_000;
/// The same for the accelerometer (ns).
const ACCEL_START_NS: u64 = 2_000_000;
/// Length of a data-ready pulse that is not latched (ns).
const PULSE_NS: u64 = 156_250;

/// A physical sample on its way.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Physical {
    pub(super) ns: u64,
    rates_radps: [f64; 3],
    accel_mps2: [f64; 3],
}

/// When the sensors were switched on.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Sensors {
    gyro_on_ns: u64,
    accel_on_ns: u64,
    last_ns: Option<u64>,
}

impl Sensors {
    /// PWR_CTRL changes.
    pub(super) fn enabled(&mut self, ns: u64, old: u8, new: u8) {
        if new & !old & 2 != 0 {
            self.gyro_on_ns = ns;
        }
        if new & !old & 4 != 0 {
            self.accel_on_ns = ns;
        }
        self.last_ns = None;
    }
}

impl Bmi270 {
    /// Motion at `ns`, in axes of the sensor: rates (rad/s) and specific force (m/s²). Converted, with its data-ready
    /// edge, at that time, which may lie ahead but not before a sample already given.
    pub fn sample(&mut self, ns: u64, rates_radps: [f64; 3], accel_mps2: [f64; 3]) {
        self.pending.push_back(Physical { ns, rates_radps, accel_mps2 });
    }

    /// Takes a sample into the registers. Answers whether INT1 became active.
    pub(super) fn convert(&mut self, sample: Physical, bugs: &mut Vec<String>) -> bool {
        let power = self.registers[reg::PWR_CTRL];
        let (gyro, accel) = (power & 2 != 0, power & 4 != 0);
        if !self.ready() || !(gyro || accel) {
            return false;
        }
        if power & 8 != 0 {
            // 23 °C plus 1/512 K a count.
            (self.registers[reg::TEMPERATURE_0], self.registers[reg::TEMPERATURE_0 + 1]) = (0, 4);
        }
        if gyro {
            let started = sample.ns >= self.sensors.gyro_on_ns + GYRO_START_NS;
            // 2000, 1000, 500, 250, 125 dps full scale.
            let range_dps = 2000.0 / f64::from(1_u32 << (self.registers[reg::GYR_RANGE] & 7).min(4));
            let per_radps = 32768.0 / range_dps.to_radians();
            self.store(
                reg::GYRO_FIRST,
                self.disturbed(sample.rates_radps),
                if started { per_radps } else { 0.0 },
            );
            self.registers[reg::STATUS] |= 0x40;
        }
        if accel {
            let started = sample.ns >= self.sensors.accel_on_ns + ACCEL_START_NS;
            // 2, 4, 8, 16 g full scale.
            let range_g = 2.0 * f64::from(1_u32 << (self.registers[reg::ACC_RANGE] & 3));
            let per_mps2 = 32768.0 / (range_g * STANDARD_GRAVITY);
            self.store(reg::DATA_FIRST, sample.accel_mps2, if started { per_mps2 } else { 0.0 });
            self.registers[reg::STATUS] |= 0x80;
        }
        self.check_rate(sample.ns, gyro, bugs);
        self.registers[reg::INT_STATUS_1] |= u8::from(gyro) << 6 | u8::from(accel) << 7;
        let mapped = self.registers[reg::INT_MAP_DATA] & 4 != 0;
        if !mapped {
            return false;
        }
        let rose = !self.int_asserted;
        self.int_asserted = true;
        let latched = self.registers[reg::INT_LATCH] & 1 != 0;
        self.int_falls_ns = if latched { u64::MAX } else { sample.ns + PULSE_NS };
        rose
    }

    /// What the gyro makes of the rates where a hand turns it, or one of its axes is broken.
    fn disturbed(&self, mut rates_radps: [f64; 3]) -> [f64; 3] {
        rates_radps.iter_mut().zip(self.hand_radps).for_each(|(rate, hand)| *rate += hand);
        match self.defect {
            Some(Defect::ReversedAxis(axis)) => {
                rates_radps.iter_mut().skip(axis.into()).take(1).for_each(|rate| *rate = -*rate);
            }
            Some(Defect::Railed(axis)) => {
                rates_radps.iter_mut().skip(axis.into()).take(1).for_each(|rate| *rate = 100.0);
            }
            _ => {}
        }
        rates_radps
    }

    /// Quantises, saturates and stores three axes.
    fn store(&mut self, first: usize, values: [f64; 3], scale: f64) {
        for (axis, value) in values.into_iter().enumerate() {
            let counts = (value * scale).round().clamp(-32768.0, 32767.0) as i16;
            let [low, high] = counts.to_le_bytes();
            self.registers[first + 2 * axis] = low;
            self.registers[first + 2 * axis + 1] = high;
        }
    }

    /// Samples must come at the rate that the firmware has set: the world asks [`Bmi270::gyro_rate_hz`].
    fn check_rate(&mut self, ns: u64, gyro: bool, bugs: &mut Vec<String>) {
        let last = self.sensors.last_ns.replace(ns);
        if let (true, Some(last), Some(rate)) = (gyro, last, self.gyro_rate_hz()) {
            let period_ns = ns.saturating_sub(last) as f64;
            if !(0.8..1.25).contains(&(period_ns * rate / 1e9)) {
                let text =
                    format!("BMI270: samples come every {period_ns} ns while GYR_CONF asks for {rate} Hz");
                self.tell(TOLD_RATE, text, bugs);
            }
        }
    }
}

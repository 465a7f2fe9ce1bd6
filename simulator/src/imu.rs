//! Gyro and accelerometer: one chip with its own clock, mounted not quite straight.

use nalgebra::{Matrix3, Vector3};

use crate::{
    clock::Clock,
    fault::{Fault, Faults},
    filter::LowPass,
    noise::{Noise, Source},
    parameters::{ACCELEROMETER_G_MPS2, VehicleParameters},
    planning::turned,
};

/// One reading of gyro and accelerometer, in body axes x (forward), y (left), z (up).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ImuSample {
    /// Angular rates in counts, as they stand in the chip's registers.
    pub gyro_raw: [i16; 3],
    /// Specific force in counts, as it stands in the chip's registers.
    pub accelerometer_raw: [i16; 3],
    /// Angular rates, rad/s.
    pub rates_radps: [f32; 3],
    /// Specific force, m/s²: +9.81 along z on level ground.
    pub specific_force_mps2: [f32; 3],
}

/// The sensor chip.
#[derive(Clone, Debug)]
pub(crate) struct ImuSensor {
    clock: Clock,
    /// Body axes to sensor axes.
    mounting: Matrix3<f64>,
    gyro: Channel,
    accelerometer: Channel,
    vibration: Vibration,
    last: ImuSample,
}

impl ImuSensor {
    pub(crate) fn new(parameters: &VehicleParameters, seed: u64, specific_force: Vector3<f64>) -> Self {
        let VehicleParameters { imu, gyro, accelerometer, .. } = parameters;
        let mut timing = Noise::new(seed, Source::ImuClock);
        let clock_error = timing.within(imu.clock_error);
        // A chip was switched on some time before the flight, a perfect one exactly a period before.
        let phase = 1.0 - timing.share();
        let clock =
            Clock::new(imu.rate_hz * (1.0 + clock_error), if imu.clock_error > 0.0 { phase } else { 1.0 });
        let tilt = Vector3::from(Noise::new(seed, Source::ImuMounting).within3(imu.misalignment_rad));
        let mounting =
            turned(nalgebra::UnitQuaternion::identity(), tilt).to_rotation_matrix().into_inner().transpose();
        let channel = |errors, noise, bandwidth_hz, density, bias, scale_error, counts_per_unit, range| {
            let mut errors = Noise::new(seed, errors);
            let filter = LowPass::new(bandwidth_hz);
            // Without a filter, white noise reaches up to half the sampling rate.
            let noise_width_hz = filter.noise_bandwidth_hz(0.5 * imu.rate_hz);
            Channel {
                bias: Vector3::from(errors.normal3(bias)),
                scale: Vector3::from(errors.within3(scale_error)).add_scalar(1.0),
                deviation: density * libm::sqrt(noise_width_hz),
                noise: Noise::new(seed, noise),
                filter,
                counts_per_unit,
                counts_max: libm::rint(range * counts_per_unit),
                quantised: imu.quantised,
            }
        };
        let degree = core::f64::consts::PI / 180.0;
        let gyro_channel = channel(
            Source::GyroErrors,
            Source::GyroNoise,
            gyro.bandwidth_hz,
            gyro.noise_density_radps,
            gyro.bias_radps,
            gyro.scale_error,
            gyro.lsb_per_dps / degree,
            gyro.range_dps * degree,
        );
        let mut accelerometer_channel = channel(
            Source::AccelerometerErrors,
            Source::AccelerometerNoise,
            accelerometer.bandwidth_hz,
            accelerometer.noise_density_mps2,
            accelerometer.bias_mps2,
            accelerometer.scale_error,
            accelerometer.lsb_per_g / ACCELEROMETER_G_MPS2,
            accelerometer.range_g * ACCELEROMETER_G_MPS2,
        );
        accelerometer_channel.filter.settle(mounting * specific_force);
        Self {
            clock,
            mounting,
            gyro: gyro_channel,
            accelerometer: accelerometer_channel,
            vibration: Vibration::new(parameters, seed),
            last: ImuSample {
                gyro_raw: [0; 3],
                accelerometer_raw: [0; 3],
                rates_radps: [0.0; 3],
                specific_force_mps2: [0.0; 3],
            },
        }
    }

    pub(crate) fn redraw_noise(&mut self, seed: u64) {
        self.gyro.noise = Noise::new(seed, Source::GyroNoise);
        self.accelerometer.noise = Noise::new(seed, Source::AccelerometerNoise);
    }

    /// When the next sample is due, ns; `u64::MAX` for never.
    pub(crate) fn next_ns(&self, faults: &Faults) -> u64 {
        let due = self.clock.next_ns();
        // `plan` has moved the clock out of every silence that ends.
        if faults.active(Fault::ImuSilent, due) { u64::MAX } else { due }
    }

    /// Moves the next sample out of times of silence.
    pub(crate) fn plan(&mut self, faults: &Faults) {
        loop {
            let due = self.clock.next_ns();
            match faults.free_from_ns(Fault::ImuSilent, due) {
                u64::MAX => return,
                free if free == due => return,
                free => self.clock.skip_to(free),
            }
        }
    }

    /// A short time passes, at the end of which the body has these rates, specific force and rotor speeds.
    pub(crate) fn advance(
        &mut self,
        rates: Vector3<f64>,
        specific_force: Vector3<f64>,
        rotors: [f64; 4],
        step_s: f64,
    ) {
        let (shake_rates, shake_force) = self.vibration.advance(rotors, step_s);
        self.gyro.filter.advance(self.mounting * rates + shake_rates, step_s);
        self.accelerometer.filter.advance(self.mounting * specific_force + shake_force, step_s);
    }

    /// Takes the sample that is due at `now_ns`, and plans the next.
    pub(crate) fn sample(&mut self, now_ns: u64, faults: &Faults) -> ImuSample {
        let (mut gyro_raw, mut rates_radps) = self.gyro.sample();
        let (accelerometer_raw, specific_force_mps2) = self.accelerometer.sample();
        if faults.active(Fault::GyroReversed, now_ns) {
            gyro_raw = gyro_raw.map(i16::saturating_neg);
            rates_radps = rates_radps.map(|w| -w);
        }
        if !faults.active(Fault::ImuStuck, now_ns) {
            self.last = ImuSample { gyro_raw, accelerometer_raw, rates_radps, specific_force_mps2 };
        }
        self.clock.tick();
        self.plan(faults);
        self.last
    }
}

/// Three axes of one kind of sensor: low-pass filter, scale, bias, noise, quantisation, saturation.
#[derive(Clone, Debug)]
struct Channel {
    filter: LowPass,
    scale: Vector3<f64>,
    bias: Vector3<f64>,
    noise: Noise,
    /// Standard deviation of the noise of one sample.
    deviation: f64,
    counts_per_unit: f64,
    counts_max: f64,
    quantised: bool,
}

impl Channel {
    fn sample(&mut self) -> ([i16; 3], [f32; 3]) {
        let noise = Vector3::from(self.noise.normal3(self.deviation));
        let value = self.filter.output().component_mul(&self.scale) + self.bias + noise;
        // At full range the positive end of the register is one count short of the negative one.
        let counts = value.map(|v| {
            let counts = libm::rint(v * self.counts_per_unit).clamp(-self.counts_max, self.counts_max);
            counts.clamp(f64::from(i16::MIN), f64::from(i16::MAX))
        });
        let si = if self.quantised { counts / self.counts_per_unit } else { value };
        (<[f64; 3]>::from(counts).map(|c| c as i16), <[f64; 3]>::from(si).map(|v| v as f32))
    }
}

/// The shaking of the frame by unbalanced rotors.
#[derive(Clone, Debug)]
struct Vibration {
    /// Angle of each rotor, rad, 0 to 2π.
    angles: [f64; 4],
    /// For each rotor, where in its turn it pushes each gyro axis and each accelerometer axis hardest, rad.
    lead: [[f64; 6]; 4],
    rates_at_hover: f64,
    force_at_hover: f64,
    hover_speed: f64,
}

impl Vibration {
    fn new(parameters: &VehicleParameters, seed: u64) -> Self {
        let mut noise = Noise::new(seed, Source::Vibration);
        let mut angle = || core::f64::consts::TAU * noise.share();
        Self {
            angles: core::array::from_fn(|_| angle()),
            lead: core::array::from_fn(|_| core::array::from_fn(|_| angle())),
            rates_at_hover: parameters.gyro.vibration_radps,
            force_at_hover: parameters.accelerometer.vibration_mps2,
            hover_speed: parameters.hover_speed_radps(),
        }
    }

    fn advance(&mut self, rotors: [f64; 4], step_s: f64) -> (Vector3<f64>, Vector3<f64>) {
        let mut sums = [0.0; 6];
        if self.rates_at_hover == 0.0 && self.force_at_hover == 0.0 {
            return (Vector3::zeros(), Vector3::zeros());
        }
        for ((angle, lead), speed) in self.angles.iter_mut().zip(&self.lead).zip(rotors) {
            *angle = (*angle + speed * step_s) % core::f64::consts::TAU;
            let relative = speed / self.hover_speed;
            for (sum, lead) in sums.iter_mut().zip(lead) {
                *sum += relative * relative * libm::sin(*angle + lead);
            }
        }
        let [gx, gy, gz, ax, ay, az] = sums;
        (Vector3::new(gx, gy, gz) * self.rates_at_hover, Vector3::new(ax, ay, az) * self.force_at_hover)
    }
}

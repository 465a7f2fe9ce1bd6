//! Reproducible randomness: one generator for each source of error, so that adding or silencing one leaves the others
//! as they were.

use rand_core::Rng;
use rand_pcg::Pcg64Mcg;

/// A source of error. The number is part of what a seed means: never reuse or renumber one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Source {
    Rotors = 1,
    ImuClock = 2,
    ImuMounting = 3,
    GyroErrors = 4,
    GyroNoise = 5,
    AccelerometerErrors = 6,
    AccelerometerNoise = 7,
    Vibration = 8,
    CaptureOffset = 9,
    CaptureNoise = 10,
    CaptureTiming = 11,
}

/// The random numbers of one source. All functions are computed by `libm`, so that a seed means the same bytes on every
/// machine.
#[derive(Clone, Debug)]
pub(crate) struct Noise {
    generator: Pcg64Mcg,
    /// The second value of the last Box-Muller pair.
    spare: Option<f64>,
}

impl Noise {
    pub(crate) fn new(seed: u64, source: Source) -> Self {
        // Two rounds of mixing: seeds 1, 2, 3 and sources 1, 2, 3 must not give related streams.
        let high = mix(mix(seed).wrapping_add(source as u64));
        let low = mix(high);
        Self { generator: Pcg64Mcg::new(u128::from(high) << 64 | u128::from(low)), spare: None }
    }

    /// Uniform in \[0, 1).
    pub(crate) fn share(&mut self) -> f64 {
        // The upper 53 bits, one for each bit of the mantissa.
        (self.generator.next_u64() >> 11) as f64 * (1.0 / (1u64 << 53) as f64)
    }

    /// Uniform within ± `bound`.
    pub(crate) fn within(&mut self, bound: f64) -> f64 {
        (2.0 * self.share() - 1.0) * bound
    }

    /// Normal with mean 0 and standard deviation 1 (Box and Muller, 1958).
    pub(crate) fn normal(&mut self) -> f64 {
        if let Some(value) = self.spare.take() {
            return value;
        }
        // 1 − share lies in (0, 1], where the logarithm is finite.
        let radius = libm::sqrt(-2.0 * libm::log(1.0 - self.share()));
        let (sin, cos) = libm::sincos(core::f64::consts::TAU * self.share());
        self.spare = Some(radius * sin);
        radius * cos
    }

    /// Three independent normal values with a standard deviation.
    pub(crate) fn normal3(&mut self, deviation: f64) -> [f64; 3] {
        core::array::from_fn(|_| deviation * self.normal())
    }

    /// Three independent values, uniform within ± `bound`.
    pub(crate) fn within3(&mut self, bound: f64) -> [f64; 3] {
        core::array::from_fn(|_| self.within(bound))
    }
}

/// The output function of SplitMix64 (Steele, Lea and Flood, OOPSLA 2014): a bijection in which each input bit reaches
/// every output bit.
fn mix(value: u64) -> u64 {
    let mut z = value.wrapping_add(0x9E37_79B9_7F4A_7C15);
    z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    z ^ (z >> 31)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn moments_are_those_of_the_distributions() {
        let mut noise = Noise::new(7, Source::GyroNoise);
        const N: usize = 100_000;
        let normal: Vec<f64> = (0..N).map(|_| noise.normal()).collect();
        let moment = |k: i32| normal.iter().map(|v| v.powi(k)).sum::<f64>() / N as f64;
        assert!(moment(1).abs() < 0.015 && (moment(2) - 1.0).abs() < 0.02 && (moment(4) - 3.0).abs() < 0.15);
        let uniform: Vec<f64> = (0..N).map(|_| noise.within(0.5)).collect();
        assert!(uniform.iter().all(|v| (-0.5..0.5).contains(v)));
        let mean_square = uniform.iter().map(|v| v * v).sum::<f64>() / N as f64;
        assert!((mean_square - 1.0 / 12.0).abs() < 1e-3);
    }

    #[test]
    fn neighbouring_seeds_and_sources_are_unrelated() {
        const N: usize = 20_000;
        let pairs = [
            (Noise::new(1, Source::GyroNoise), Noise::new(2, Source::GyroNoise)),
            (Noise::new(1, Source::GyroNoise), Noise::new(1, Source::GyroErrors)),
            (Noise::new(0, Source::ImuClock), Noise::new(1, Source::Rotors)),
        ];
        for (mut a, mut b) in pairs {
            let correlation = (0..N).map(|_| a.normal() * b.normal()).sum::<f64>() / N as f64;
            assert!(correlation.abs() < 0.03, "{correlation}");
        }
    }
}

//! A second-order low-pass filter on three axes at the gyro's rate.
//!
//! A Butterworth filter by the bilinear transform with its cutoff in place. At low frequency it delays by
//! √2 T/(2 tan(π f T)), T being the period of the samples: 1.3 ms at 150 Hz and 800 Hz. Late or missing samples shift its cutoff for
//! that moment and nothing else.

use mintime_shared::replay::TICK_PERIOD_US;

/// Sampling rate for which coefficients are made, Hz.
const SAMPLE_HZ: f64 = 1.0e6 / TICK_PERIOD_US as f64;

/// The filter: transposed direct form II.
#[derive(Clone, Copy, Debug)]
pub struct LowPass {
    /// b0 (b1 is twice it, b2 equals it), a1, a2.
    b0: f32,
    a1: f32,
    a2: f32,
    memory: [[f32; 2]; 3],
}

impl LowPass {
    /// A filter with a −3 dB frequency, Hz, above zero and below half the sampling rate; settled at zero.
    pub const fn new(cutoff_hz: f64) -> Self {
        let k = tangent(core::f64::consts::PI * cutoff_hz / SAMPLE_HZ);
        let norm = 1.0 / (1.0 + core::f64::consts::SQRT_2 * k + k * k);
        Self {
            b0: (k * k * norm) as f32,
            a1: (2.0 * (k * k - 1.0) * norm) as f32,
            a2: ((1.0 - core::f64::consts::SQRT_2 * k + k * k) * norm) as f32,
            memory: [[0.0; 2]; 3],
        }
    }

    /// Delay at low frequency of a filter with this cutoff, s.
    pub const fn delay_s(cutoff_hz: f64) -> f64 {
        let k = tangent(core::f64::consts::PI * cutoff_hz / SAMPLE_HZ);
        core::f64::consts::FRAC_1_SQRT_2 / (SAMPLE_HZ * k)
    }

    /// Starts over, settled at a value. What is no number counts as zero.
    pub fn settle(&mut self, value: [f32; 3]) {
        for (memory, value) in self.memory.iter_mut().zip(value) {
            let value = if value.is_finite() { value } else { 0.0 };
            *memory = [value * (1.0 - self.b0), value * (self.b0 - self.a2)];
        }
    }

    /// Takes a sample and gives the filtered one. After one that is no number it starts over at zero.
    pub fn update(&mut self, sample: [f32; 3]) -> [f32; 3] {
        let mut out = sample;
        for (value, memory) in out.iter_mut().zip(&mut self.memory) {
            let x = *value;
            let [first, second] = *memory;
            let y = self.b0 * x + first;
            let next = [2.0 * self.b0 * x - self.a1 * y + second, self.b0 * x - self.a2 * y];
            let sound = y.is_finite() && next.iter().all(|m| m.is_finite());
            *memory = if sound { next } else { [0.0; 2] };
            *value = if sound { y } else { 0.0 };
        }
        out
    }
}

/// tan by its series of sine and cosine, for the compiler: exact to 1e-15 up to π/2.
const fn tangent(x: f64) -> f64 {
    let (mut sine, mut cosine) = (0.0, 0.0);
    let (mut term, mut n) = (1.0, 0);
    while n < 24 {
        // The terms xⁿ/n! with the signs + + − −.
        let signed = if n % 4 < 2 { term } else { -term };
        if n % 2 == 0 {
            cosine += signed;
        } else {
            sine += signed;
        }
        n += 1;
        term = term * x / n as f64;
    }
    sine / cosine
}

#[cfg(test)]
mod tests {
    use super::*;

    const CUTOFFS_HZ: [f64; 5] = [20.0, 80.0, 120.0, 150.0, 300.0];

    #[test]
    fn the_tangent_is_one() {
        for i in 1..150 {
            let x = f64::from(i) * 0.01;
            assert!((tangent(x) / libm::tan(x) - 1.0).abs() < 1e-13, "{x}");
        }
    }

    /// A ramp comes out late by the closed form, once the filter has settled.
    #[test]
    fn a_ramp_is_delayed_by_the_closed_form() {
        for hz in CUTOFFS_HZ {
            let mut filter = LowPass::new(hz);
            let mut out = [0.0; 3];
            for i in 0..800 {
                out = filter.update([i as f32; 3]);
            }
            let late_s = (799.0 - f64::from(out[1])) / SAMPLE_HZ;
            // Coefficients in `f32` are off by 1e-7, which a cutoff far below the sampling rate magnifies.
            assert!((late_s - LowPass::delay_s(hz)).abs() < 1e-5, "{hz}: {late_s}");
        }
        assert!((LowPass::delay_s(150.0) - 1.32e-3).abs() < 1e-5);
    }

    /// At its cutoff half the power is left, and its gain at rest is one.
    #[test]
    fn the_cutoff_is_where_it_is_said_to_be() {
        for hz in CUTOFFS_HZ {
            let mut filter = LowPass::new(hz);
            let (mut into, mut out) = (0.0, 0.0);
            for i in 0..16_000 {
                let x = libm::sin(core::f64::consts::TAU * hz * f64::from(i) / SAMPLE_HZ);
                let y = f64::from(filter.update([x as f32; 3])[2]);
                if i >= 8000 {
                    (into, out) = (into + x * x, out + y * y);
                }
            }
            assert!((out / into - 0.5).abs() < 2e-3, "{hz}: {}", out / into);
        }
    }

    #[test]
    fn it_settles_at_once_and_forgets_nonsense() {
        let mut filter = LowPass::new(150.0);
        filter.settle([1.0, -2.0, 3.5]);
        for _ in 0..5 {
            let out = filter.update([1.0, -2.0, 3.5]);
            assert!(out.iter().zip([1.0, -2.0, 3.5]).all(|(a, b)| (a - b).abs() < 1e-6), "{out:?}");
        }
        for bad in [f32::NAN, f32::INFINITY, f32::MAX] {
            assert!(filter.update([bad; 3]).iter().all(|v| v.is_finite()));
            filter.settle([bad; 3]);
        }
        filter.settle([0.0; 3]);
        assert_eq!(filter.update([0.0; 3]), [0.0; 3]);
    }
}

//! The low-pass filter inside a sensor.

use nalgebra::Vector3;

/// Two equal first-order poles: the smooth, non-ringing roll-off of a sensor's decimation filter.
///
/// Each pole is integrated exactly for an input that changes linearly over the step, so steps of any length are stable.
#[derive(Clone, Debug)]
pub(crate) struct LowPass {
    /// Time constant of each pole, s; `None` passes everything.
    time_constant_s: Option<f64>,
    input: Vector3<f64>,
    first: Vector3<f64>,
    second: Vector3<f64>,
}

/// Of two equal poles the −3 dB frequency is this times that of one: √(√2 − 1).
const BANDWIDTH_OF_TWO: f64 = 0.643_594_252_905_582_6;

impl LowPass {
    /// A filter with a −3 dB bandwidth in Hz, 0 for none, settled at zero.
    pub(crate) fn new(bandwidth_hz: f64) -> Self {
        let time_constant_s =
            (bandwidth_hz > 0.0).then(|| BANDWIDTH_OF_TWO / (core::f64::consts::TAU * bandwidth_hz));
        Self { time_constant_s, input: Vector3::zeros(), first: Vector3::zeros(), second: Vector3::zeros() }
    }

    /// Starts over, settled at a value.
    pub(crate) fn settle(&mut self, value: Vector3<f64>) {
        (self.input, self.first, self.second) = (value, value, value);
    }

    /// A time `step_s` passes, over which the input goes to `input` in a straight line.
    pub(crate) fn advance(&mut self, input: Vector3<f64>, step_s: f64) {
        let Some(tau) = self.time_constant_s else {
            self.settle(input);
            return;
        };
        let first = ramp_response(self.first, self.input, input, step_s / tau);
        self.second = ramp_response(self.second, self.first, first, step_s / tau);
        self.first = first;
        self.input = input;
    }

    /// What comes out now.
    pub(crate) fn output(&self) -> Vector3<f64> {
        self.second
    }

    /// Width in Hz of the rectangular filter that would pass as much white noise, or the fallback where no filter
    /// limits it.
    pub(crate) fn noise_bandwidth_hz(&self, fallback_hz: f64) -> f64 {
        // ∫df/(1 + (2πfτ)²)² over positive f.
        self.time_constant_s.map_or(fallback_hz, |tau| 1.0 / (8.0 * tau))
    }
}

/// One pole at the end of a step of `ratio` time constants, over which its input goes from `from` to `to`.
fn ramp_response(state: Vector3<f64>, from: Vector3<f64>, to: Vector3<f64>, ratio: f64) -> Vector3<f64> {
    let decay = libm::exp(-ratio);
    // Mean of the decay over the step; its series where the quotient would cancel.
    let mean = if ratio > 1e-5 { -libm::expm1(-ratio) / ratio } else { 1.0 - 0.5 * ratio };
    state * decay + from * (mean - decay) + to * (1.0 - mean)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn gain(bandwidth_hz: f64, frequency_hz: f64, step_s: f64) -> f64 {
        let mut filter = LowPass::new(bandwidth_hz);
        let (mut t, mut peak) = (0.0, 0.0_f64);
        while t < 0.2 {
            t += step_s;
            filter.advance(Vector3::x() * libm::sin(core::f64::consts::TAU * frequency_hz * t), step_s);
            if t > 0.1 {
                peak = peak.max(filter.output().x);
            }
        }
        peak
    }

    #[test]
    fn three_decibels_at_the_bandwidth() {
        assert!((gain(256.0, 256.0, 1e-5) - 0.5_f64.sqrt()).abs() < 1e-3);
        assert!((gain(256.0, 10.0, 1e-4) - 1.0).abs() < 1e-3);
        assert!((gain(0.0, 900.0, 1e-5) - 1.0).abs() < 1e-3);
    }

    #[test]
    fn a_ramp_comes_out_late_by_the_group_delay_for_any_step() {
        for step_s in [1e-9, 1e-5, 2.5e-4, 1e-2] {
            let mut filter = LowPass::new(256.0);
            let steps = if step_s < 1e-6 { 1000 } else { (0.1 / step_s) as usize };
            for k in 1..=steps {
                filter.advance(Vector3::z() * (k as f64 * step_s), step_s);
            }
            if step_s > 1e-6 {
                let delay = steps as f64 * step_s - filter.output().z;
                let expected = 2.0 * BANDWIDTH_OF_TWO / (core::f64::consts::TAU * 256.0);
                assert!((delay - expected).abs() < 1e-9, "{delay} {expected}");
            }
            assert!(filter.output().iter().all(|v| v.is_finite()));
        }
    }
}

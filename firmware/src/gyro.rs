//! What is believed of the gyro: its bias, learned while the vehicle stands still, and its health.

use crate::config::{
    BIAS_MAX_RADPS, CALIBRATION_TICKS, GYRO_FROZEN_DEMAND_RADPS, GYRO_FROZEN_TICKS, GYRO_MISSING_TICKS,
    GYRO_SATURATED_TICKS, GYRO_SATURATION_RADPS, STILL_SPREAD_RADPS,
};

use crate::config::control::SCALE_ERROR_MAX;
use mintime_shared::real::{at_least, at_most};

/// One reading of the inertial sensor, body axes forward-left-up.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ImuSample {
    /// Angular rate, rad/s.
    pub gyro_radps: [f32; 3],
    /// Specific force, m/s².
    pub accel_mps2: [f32; 3],
}

/// A window in which the vehicle stands still or does not, and the mean of its rates: the bias.
#[derive(Clone, Copy, Debug)]
pub(crate) struct StillWindow {
    count: u32,
    sum: [f32; 3],
    low: [f32; 3],
    high: [f32; 3],
}

impl StillWindow {
    pub(crate) const EMPTY: Self =
        Self { count: 0, sum: [0.0; 3], low: [f32::INFINITY; 3], high: [f32::NEG_INFINITY; 3] };

    /// Takes a sample. At the end of a window: the mean if the vehicle stood still, `Err` if it moved.
    pub(crate) fn take(&mut self, rates: [f32; 3]) -> Option<Result<[f32; 3], ()>> {
        for (((sum, low), high), rate) in
            self.sum.iter_mut().zip(&mut self.low).zip(&mut self.high).zip(rates)
        {
            *sum += rate;
            *low = at_most(*low, rate);
            *high = at_least(*high, rate);
        }
        self.count += 1;
        if self.count < CALIBRATION_TICKS {
            return None;
        }
        let mean = self.sum.map(|s| s / CALIBRATION_TICKS as f32);
        let still = self.low.iter().zip(self.high).all(|(low, high)| high - low <= STILL_SPREAD_RADPS);
        let credible = mean.iter().all(|m| m.abs() <= BIAS_MAX_RADPS);
        *self = Self::EMPTY;
        Some(if still && credible { Ok(mean) } else { Err(()) })
    }
}

/// The gyro's state as the supervisor sees it.
#[derive(Clone, Copy, Debug)]
pub struct Gyro {
    bias_radps: Option<[f32; 3]>,
    scale: [f32; 3],
    moving: bool,
    calibration: StillWindow,
    rates_radps: [f32; 3],
    last_raw: Option<[f32; 3]>,
    missing_ticks: u32,
    repeated_ticks: u32,
    saturated_ticks: u32,
    missing_total: u32,
    /// Samples in a row that equal the one before.
    identical_ticks: u32,
}

impl Gyro {
    /// Nothing known yet.
    pub const fn new() -> Self {
        Self {
            bias_radps: None,
            scale: [1.0; 3],
            moving: true,
            calibration: StillWindow::EMPTY,
            rates_radps: [0.0; 3],
            last_raw: None,
            missing_ticks: 0,
            repeated_ticks: 0,
            saturated_ticks: 0,
            missing_total: 0,
            identical_ticks: 0,
        }
    }

    /// Takes one tick's sample, or its absence. `setpoint` is the rate asked for over the past tick; `calibrate` is
    /// set while the motors are off. A sample with a NaN or infinity counts as missing.
    pub fn update(&mut self, sample: Option<&ImuSample>, setpoint: [f32; 3], calibrate: bool) {
        let Some(raw) = sample.map(|s| s.gyro_radps).filter(|g| g.iter().all(|r| r.is_finite())) else {
            self.missing_ticks = self.missing_ticks.saturating_add(1);
            self.missing_total = self.missing_total.saturating_add(1);
            return;
        };
        self.missing_ticks = 0;
        let demanded =
            setpoint.iter().zip(self.rates_radps).any(|(s, r)| (s - r).abs() > GYRO_FROZEN_DEMAND_RADPS);
        let repeated = self.last_raw == Some(raw);
        self.repeated_ticks = if repeated && demanded { self.repeated_ticks.saturating_add(1) } else { 0 };
        self.identical_ticks = if repeated { self.identical_ticks.saturating_add(1) } else { 0 };
        self.last_raw = Some(raw);
        let saturated = raw.iter().any(|r| r.abs() >= GYRO_SATURATION_RADPS);
        self.saturated_ticks = if saturated { self.saturated_ticks.saturating_add(1) } else { 0 };
        let spread = |bias: [f32; 3]| raw.iter().zip(bias).any(|(r, b)| (r - b).abs() > STILL_SPREAD_RADPS);
        if !self.moving && self.bias_radps.is_some_and(spread) {
            // A hand on the vehicle counts at once, stillness only after a whole window. Once it counts as moving the window
            // alone decides, so that a bias learned wrong or drifted away is learned anew.
            self.moving = true;
            self.calibration = StillWindow::EMPTY;
        } else if calibrate {
            match self.calibration.take(raw) {
                Some(Ok(bias)) => {
                    self.bias_radps = Some(bias);
                    self.moving = false;
                }
                Some(Err(())) => self.moving = true,
                None => {}
            }
        }
        if !calibrate {
            self.moving = true;
            self.calibration = StillWindow::EMPTY;
        }
        let bias = self.bias_radps.unwrap_or_default();
        for (((rate, raw), bias), scale) in self.rates_radps.iter_mut().zip(raw).zip(bias).zip(self.scale) {
            *rate = (raw - bias) * scale;
        }
    }

    /// Takes the factors by which the rates are multiplied, [`crate::calibration`]. Returns whether they are believed; if
    /// not, nothing has changed.
    pub fn set_scale(&mut self, scale: [f32; 3]) -> bool {
        // The very bounds that settings have: 1 − 0.95 is a little more than 0.05. False for NaN.
        let credible = scale.iter().all(|s| (1.0 - SCALE_ERROR_MAX..=1.0 + SCALE_ERROR_MAX).contains(s));
        if credible {
            self.scale = scale;
        }
        credible
    }

    /// Body rates with bias removed and scale corrected, rad/s; the last ones where samples are missing.
    pub fn rates_radps(&self) -> [f32; 3] {
        self.rates_radps
    }

    /// The same, or `None` where this tick had no sample.
    pub fn fresh_rates_radps(&self) -> Option<[f32; 3]> {
        (self.missing_ticks == 0 && self.last_raw.is_some()).then_some(self.rates_radps)
    }

    /// Whether the bias is known.
    pub fn is_calibrated(&self) -> bool {
        self.bias_radps.is_some()
    }

    /// The bias shall be learned anew.
    pub fn forget_bias(&mut self) {
        self.bias_radps = None;
        self.moving = true;
        self.calibration = StillWindow::EMPTY;
    }

    /// Whether the vehicle moved during the last window.
    pub fn is_moving(&self) -> bool {
        self.moving
    }

    /// Whether samples stayed away for too long.
    pub fn is_missing(&self) -> bool {
        self.missing_ticks >= GYRO_MISSING_TICKS || self.last_raw.is_none()
    }

    /// Whether the same sample keeps coming while another rate is asked for.
    pub fn is_frozen(&self) -> bool {
        self.repeated_ticks >= GYRO_FROZEN_TICKS
    }

    /// Whether the very same sample has come for a whole calibration window: no working gyro is that quiet.
    pub fn repeats_itself(&self) -> bool {
        self.identical_ticks >= CALIBRATION_TICKS
    }

    /// Whether the rates are beyond what can be measured.
    pub fn is_saturated(&self) -> bool {
        self.saturated_ticks >= GYRO_SATURATED_TICKS
    }

    /// Ticks without a sample since power-up.
    pub fn missing_total(&self) -> u32 {
        self.missing_total
    }
}

impl Default for Gyro {
    fn default() -> Self {
        Self::new()
    }
}

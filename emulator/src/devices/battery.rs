//! A battery behind a divider on an analog input.

/// A battery.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Battery {
    /// Voltage of the battery (V).
    pub volts: f64,
    /// Battery volts per volt on the pin.
    pub divider: f64,
}

impl Battery {
    /// Voltage on the pin (V).
    pub fn pin_v(&self) -> f64 {
        self.volts / self.divider
    }
}

//! Battery: the voltage that the speed controllers see.

use crate::parameters::Battery;

/// A battery in use.
#[derive(Clone, Debug)]
pub(crate) struct BatteryState {
    parameters: Battery,
    /// Remaining charge, 0 to 1.
    charge: f64,
}

impl BatteryState {
    pub(crate) fn new(parameters: &Battery) -> Self {
        Self { parameters: parameters.clone(), charge: parameters.charge }
    }

    /// Voltage without load, V.
    pub(crate) fn open_circuit_v(&self) -> f64 {
        let Battery { full_v, empty_v, .. } = self.parameters;
        empty_v + (full_v - empty_v) * self.charge
    }

    /// Voltage under load, V, when the rotors put `air_w` into the air: V = E − R P/V. Where the battery cannot deliver
    /// the power, half the open-circuit voltage, at which it delivers most.
    pub(crate) fn voltage_v(&self, air_w: f64) -> f64 {
        let e = self.open_circuit_v();
        let rest = e * e - 4.0 * self.parameters.resistance_ohm * self.power_w(air_w);
        0.5 * (e + libm::sqrt(rest.max(0.0)))
    }

    /// A time passes at a load: charge flows out.
    pub(crate) fn drain(&mut self, air_w: f64, step_s: f64) {
        let current = self.power_w(air_w) / self.voltage_v(air_w);
        self.charge = (self.charge - current * step_s / self.parameters.capacity_as).max(0.0);
    }

    fn power_w(&self, air_w: f64) -> f64 {
        self.parameters.electronics_w + air_w / self.parameters.efficiency
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::VehicleParameters;

    #[test]
    fn voltage_and_current_balance_the_power() {
        let battery = BatteryState::new(&VehicleParameters::nominal().battery);
        for air_w in [0.0, 100.0, 1500.0] {
            let v = battery.voltage_v(air_w);
            let current = (battery.open_circuit_v() - v) / 0.015;
            assert!((v * current - (5.0 + air_w / 0.75)).abs() < 1e-9);
        }
        // More than it has: it sags to half, and no further.
        assert_eq!(battery.voltage_v(1e9), 0.5 * battery.open_circuit_v());
    }

    #[test]
    fn discharge_counts_ampere_seconds() {
        let mut battery = BatteryState::new(&VehicleParameters::nominal().battery);
        let (e, v) = (battery.open_circuit_v(), battery.voltage_v(200.0));
        let current = (e - v) / 0.015;
        battery.drain(200.0, 1.0);
        assert!((e - battery.open_circuit_v() - 3.6 * current / 6480.0).abs() < 1e-9);
        battery.drain(200.0, 1e6);
        assert_eq!(battery.open_circuit_v(), 13.2);
    }
}

//! Battery: the voltage that the speed controllers see.

use crate::parameters::Battery;

impl Battery {
    /// Voltage without load, V, at a charge of 0 to 1.
    pub(crate) fn open_circuit_v(&self, charge: f64) -> f64 {
        self.empty_v + (self.full_v - self.empty_v) * charge.max(0.0)
    }

    /// Voltage under load, V, when the rotors put `air_w` into the air: V = E − R P/V. Where the battery cannot deliver
    /// the power, half the open-circuit voltage, at which it delivers most.
    pub(crate) fn voltage_v(&self, charge: f64, air_w: f64) -> f64 {
        let e = self.open_circuit_v(charge);
        let rest = e * e - 4.0 * self.resistance_ohm * self.power_w(air_w);
        0.5 * (e + libm::sqrt(rest.max(0.0)))
    }

    /// Charge that flows out, 1/s, as a share of the capacity.
    pub(crate) fn discharge_per_s(&self, charge: f64, air_w: f64) -> f64 {
        if charge <= 0.0 {
            return 0.0;
        }
        self.power_w(air_w) / (self.voltage_v(charge, air_w) * self.capacity_as)
    }

    fn power_w(&self, air_w: f64) -> f64 {
        self.electronics_w + air_w / self.efficiency
    }
}

#[cfg(test)]
mod tests {
    use crate::VehicleParameters;

    #[test]
    fn voltage_and_current_balance_the_power() {
        let battery = VehicleParameters::nominal().battery;
        for (charge, air_w) in [(1.0, 0.0), (0.9, 100.0), (0.2, 1500.0)] {
            let v = battery.voltage_v(charge, air_w);
            let current = (battery.open_circuit_v(charge) - v) / 0.015;
            assert!((v * current - (5.0 + air_w / 0.75)).abs() < 1e-9);
            assert!((battery.discharge_per_s(charge, air_w) * 6480.0 - current).abs() < 1e-9);
        }
        // More than it has: it sags to half, and no further.
        assert_eq!(battery.voltage_v(0.5, 1e9), 0.5 * battery.open_circuit_v(0.5));
        // Empty: it holds the end of its voltage.
        assert_eq!((battery.open_circuit_v(-1.0), battery.discharge_per_s(0.0, 10.0)), (13.2, 0.0));
    }
}

//! What a vehicle takes for a vehicle file and for settings: each bound, just within it and just beyond.

use mintime_shared::settings::{Settings, SettingsError};
use mintime_shared::vehicle::{VehicleConfig, VehicleError};

/// Changes of the reference vehicle, and what is said to each.
type Change<T, E> = (fn(&mut T), Result<(), E>);

#[test]
fn every_bound_of_a_vehicle_file() {
    use VehicleError as E;
    let changes: [Change<VehicleConfig, E>; 51] = [
        (|v| v.mass_kg = f32::NAN, Err(E::NotFinite)),
        (|v| v.sag_v_per_n = f32::INFINITY, Err(E::NotFinite)),
        (|v| v.mass_kg = 0.019, Err(E::Mass)),
        (|v| v.mass_kg = 20.1, Err(E::Mass)),
        (|v| v.inertia_kgm2 = [0.0, 1e-3, 1e-3], Err(E::Inertia)),
        (|v| v.inertia_kgm2 = [1e-3, 0.0, 1e-3], Err(E::Inertia)),
        (|v| v.inertia_kgm2 = [1e-3, 1e-3, 0.0], Err(E::Inertia)),
        (|v| v.inertia_kgm2 = [0.0; 3], Err(E::Inertia)),
        (|v| v.inertia_kgm2 = [5.1e-3, 2e-3, 3e-3], Err(E::Inertia)),
        (|v| v.inertia_kgm2 = [2e-3, 5.1e-3, 3e-3], Err(E::Inertia)),
        (|v| v.inertia_kgm2 = [2e-3, 3e-3, 5.1e-3], Err(E::Inertia)),
        (|v| v.inertia_kgm2 = [2e-3, 3e-3, 5.0e-3], Ok(())),
        (|v| v.arm_forward_m = 0.009, Err(E::Geometry)),
        (|v| v.arm_forward_m = 1.01, Err(E::Geometry)),
        (|v| v.arm_left_m = 0.009, Err(E::Geometry)),
        (|v| v.arm_left_m = 1.01, Err(E::Geometry)),
        (|v| v.torque_per_thrust_m = 0.0009, Err(E::Geometry)),
        (|v| v.torque_per_thrust_m = 0.201, Err(E::Geometry)),
        (|v| v.rotor_thrust_idle_n = 0.0, Err(E::Thrust)),
        (|v| v.rotor_thrust_idle_n = 8.5, Err(E::Thrust)),
        // Four of them are a quarter of its 7.37 N at 0.461.
        (|v| v.rotor_thrust_idle_n = 0.462, Err(E::Thrust)),
        (|v| v.rotor_thrust_idle_n = 0.460, Ok(())),
        (|v| v.rotor_thrust_max_n = 2.39, Err(E::Thrust)),
        (|v| v.thrust_linear_share = -0.01, Err(E::Rotor)),
        (|v| v.thrust_linear_share = 1.01, Err(E::Rotor)),
        (|v| v.rotor_lag_s = 0.0009, Err(E::Rotor)),
        (|v| v.rotor_lag_s = 0.201, Err(E::Rotor)),
        (|v| v.battery_critical_v = 2.0, Err(E::Battery)),
        (|v| v.battery_critical_v = 2.1, Ok(())),
        (|v| v.battery_critical_v = 14.0, Err(E::Battery)),
        (|v| v.battery_low_v = 17.77, Err(E::Battery)),
        (|v| v.battery_low_v = 17.7, Ok(())),
        (|v| v.battery_nominal_v = 51.7, Err(E::Battery)),
        (|v| v.battery_nominal_v = 51.6, Ok(())),
        (|v| v.sag_v_per_n = -0.01, Err(E::Battery)),
        (|v| v.sag_v_per_n = 1.01, Err(E::Battery)),
        (|v| v.plan_thrust_max_mps2 = 9.8, Err(E::PlanLimits)),
        (|v| v.plan_thrust_max_mps2 = 9.9, Ok(())),
        (|v| (v.rotor_thrust_max_n, v.plan_thrust_max_mps2) = (30.0, 100.1), Err(E::PlanLimits)),
        (|v| (v.rotor_thrust_max_n, v.plan_thrust_max_mps2) = (30.0, 100.0), Ok(())),
        (|v| v.plan_thrust_max_mps2 = 45.0, Err(E::PlanLimits)),
        // Four rotors at idle, with torque in reserve, must sink.
        // Arms so short for its inertia that the reserve of torque lifts it.
        (|v| v.inertia_kgm2 = [0.045, 0.0378, 0.0774], Err(E::PlanLimits)),
        (|v| v.inertia_kgm2 = [0.040, 0.0336, 0.0688], Ok(())),
        (|v| v.plan_rate_max_radps = 0.49, Err(E::PlanLimits)),
        (|v| v.plan_rate_max_radps = 0.5, Ok(())),
        (|v| v.plan_rate_max_radps = 30.0, Ok(())),
        (|v| v.plan_rate_max_radps = 30.1, Err(E::PlanLimits)),
        (|v| v.outputs = [0, 1, 2, 4], Err(E::Outputs)),
        (|v| v.outputs = [0, 1, 2, 2], Err(E::Outputs)),
        (|v| v.outputs = [3, 1, 0, 2], Ok(())),
        (|v| v.reversed = true, Ok(())),
    ];
    for (n, (change, want)) in changes.into_iter().enumerate() {
        let mut vehicle = VehicleConfig::REFERENCE;
        change(&mut vehicle);
        assert_eq!(vehicle.check(), want, "{n}: {vehicle:?}");
    }
}

#[test]
fn every_bound_of_the_settings() {
    use SettingsError as E;
    let changes: [Change<Settings, E>; 30] = [
        (|s| s.gyro_scale[1] = f32::NAN, Err(E::NotFinite)),
        (|s| s.gyro_cutoff_hz = f32::INFINITY, Err(E::NotFinite)),
        (|s| s.bench_thrust_mps2 = f32::NAN, Err(E::NotFinite)),
        (|s| s.gyro_scale[0] = 0.949, Err(E::GyroScale)),
        (|s| s.gyro_scale[1] = 1.051, Err(E::GyroScale)),
        (|s| s.gyro_scale[2] = 1.051, Err(E::GyroScale)),
        (|s| s.gyro_scale = [0.95, 1.0, 1.05], Ok(())),
        (|s| s.gyro_cutoff_hz = 39.9, Err(E::GyroCutoff)),
        (|s| s.gyro_cutoff_hz = 40.0, Ok(())),
        (|s| s.gyro_cutoff_hz = 350.0, Ok(())),
        (|s| s.gyro_cutoff_hz = 350.1, Err(E::GyroCutoff)),
        (|s| s.kill_channel = 0, Err(E::KillSwitch)),
        (|s| s.kill_channel = 1, Ok(())),
        (|s| s.kill_channel = 16, Ok(())),
        (|s| s.kill_channel = 17, Err(E::KillSwitch)),
        (|s| s.kill_run_us = 1000, Err(E::KillSwitch)),
        (|s| s.kill_run_us = 1001, Ok(())),
        (|s| s.kill_run_us = 1999, Ok(())),
        (|s| s.kill_run_us = 2000, Err(E::KillSwitch)),
        (|s| s.bench_thrust_mps2 = -0.1, Err(E::BenchThrust)),
        (|s| s.bench_thrust_mps2 = 5.0, Ok(())),
        (|s| s.bench_thrust_mps2 = 5.1, Err(E::BenchThrust)),
        (|s| s.heartbeat_ms = 149, Err(E::Timeouts)),
        (|s| s.heartbeat_ms = 150, Ok(())),
        (|s| s.heartbeat_ms = 2000, Ok(())),
        (|s| s.heartbeat_ms = 2001, Err(E::Timeouts)),
        (|s| s.recovery_ms = 499, Err(E::Timeouts)),
        (|s| s.recovery_ms = 500, Ok(())),
        (|s| s.recovery_ms = 5000, Ok(())),
        (|s| s.recovery_ms = 5001, Err(E::Timeouts)),
    ];
    for (n, (change, want)) in changes.into_iter().enumerate() {
        let mut settings = Settings::DEFAULT;
        change(&mut settings);
        assert_eq!(settings.check(), want, "{n}: {settings:?}");
    }
}

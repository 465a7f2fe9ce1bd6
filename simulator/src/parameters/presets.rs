//! The two built-in vehicles, with the source of every value.

use super::{
    Accelerometer, Battery, Body, Drag, Esc, Ground, Gyro, Imu, Model, MotionCapture, Rotors,
    STANDARD_GRAVITY_MPS2, VehicleParameters,
};

/// One degree per second in rad/s.
const DPS: f64 = core::f64::consts::PI / 180.0;

/// The unit in which accelerometers are specified, m/s² (by definition of the standard acceleration of gravity).
pub(crate) const ACCELEROMETER_G_MPS2: f64 = 9.806_65;

impl VehicleParameters {
    /// The Agilicious quadrotor (Foehn et al., "Agilicious: Open-source and open-hardware agile quadrotor for
    /// vision-based flight", Science Robotics 7(67), 2022, doi 10.1126/scirobotics.abl6259) with a Bosch BMI270 and a
    /// motion capture system, all with the imperfections that such hardware has. `docs/vehicles.md` gives the source of
    /// each value.
    pub fn nominal() -> Self {
        Self {
            model: Model::RigidBody,
            gravity_mps2: STANDARD_GRAVITY_MPS2,
            // Published parameters of the Agilicious vehicle, as collected in RotorPy's vehicle library.
            body: Body {
                mass_kg: 0.752,
                inertia_kgm2: [2.5e-3, 2.1e-3, 4.3e-3],
                rotor_forward_m: 0.075,
                rotor_left_m: 0.10,
            },
            rotors: Rotors {
                thrust_coefficient_ns2: 1.562_522e-6,
                torque_ratio_m: 0.022,
                time_constant_up_s: 0.033,
                time_constant_down_s: 0.033,
                // Assumed: bell and 5-inch propeller.
                inertia_kgm2: 5.6e-6,
                // Assumed: spread between propellers and motors of one batch.
                thrust_error: 0.03,
            },
            // Identified in flight by Faessler, Franchi and Scaramuzza, RA-L 3(2), 2018, on a vehicle of the same
            // laboratory and class; the body's own drag as in RotorPy's vehicle library.
            drag: Drag { rotor_per_s: [0.544, 0.386, 0.0], body_ns2_per_m2: [0.005, 0.005, 0.010] },
            // Assumed: four lithium-polymer cells of 1.8 Ah at 3 mΩ, 3 mΩ of leads, 4.2 V down to 3.3 V a cell.
            battery: Battery {
                full_v: 16.8,
                empty_v: 13.2,
                capacity_as: 6480.0,
                charge: 0.9,
                resistance_ohm: 0.015,
                efficiency: 0.75,
                electronics_w: 5.0,
            },
            // 8.5 N a rotor, the published limit, at the nominal 3.7 V a cell.
            esc: Esc { full_speed_radps: 2332.4, nominal_v: 14.8 },
            // BMI270 data sheet (BST-BMI270-DS000): 800 Hz, ±2000 dps, ±16 g.
            imu: Imu { rate_hz: 800.0, clock_error: 0.02, misalignment_rad: DPS, quantised: true },
            gyro: Gyro {
                range_dps: 2000.0,
                lsb_per_dps: 16.384,
                bandwidth_hz: 256.0,
                noise_density_radps: 0.007 * DPS,
                bias_radps: 0.5 * DPS,
                scale_error: 0.02,
                // Assumed: a few degrees per second, as unfiltered logs of small quadrotors show.
                vibration_radps: 0.03,
            },
            accelerometer: Accelerometer {
                range_g: 16.0,
                lsb_per_g: 2048.0,
                bandwidth_hz: 256.0,
                noise_density_mps2: 160e-6 * ACCELEROMETER_G_MPS2,
                bias_mps2: 0.02 * ACCELEROMETER_G_MPS2,
                scale_error: 0.004,
                // Assumed.
                vibration_mps2: 0.5,
            },
            motion_capture: MotionCapture {
                // Qualisys at ETH Zürich: 6 to 7 ms from motion to data at 200 Hz.
                rate_hz: 200.0,
                latency_s: 0.006,
                latency_jitter_s: 0.001,
                // Merriaux et al., Sensors 17(7) 1591, 2017, doi 10.3390/s17071591: Vicon, 0.15 mm static error.
                position_noise_m: 1e-4,
                // Assumed: that noise on markers some 0.2 m apart.
                attitude_noise_rad: 5e-4,
                attitude_offset_rad: 1e-3,
                drop_out: 0.0,
            },
            // Assumed: a drop from 10 cm, and 30°.
            ground: Ground { crash_speed_mps: 1.4, crash_tilt_rad: 0.52 },
        }
    }

    /// The planning model itself with perfect sensors: no lag, bias, delay, clock error or quantisation, and no noise but a
    /// last digit that stirs. What
    /// remains between plan and flight in such a vehicle is the flight software's own.
    pub fn ideal() -> Self {
        let nominal = Self::nominal();
        Self {
            model: Model::Planning,
            rotors: Rotors {
                time_constant_up_s: 0.001,
                time_constant_down_s: 0.001,
                inertia_kgm2: 0.0,
                thrust_error: 0.0,
                ..nominal.rotors
            },
            drag: Drag { rotor_per_s: [0.0; 3], body_ns2_per_m2: [0.0; 3] },
            battery: Battery {
                full_v: nominal.esc.nominal_v,
                empty_v: nominal.esc.nominal_v,
                resistance_ohm: 0.0,
                ..nominal.battery
            },
            imu: Imu { clock_error: 0.0, misalignment_rad: 0.0, quantised: false, ..nominal.imu },
            gyro: Gyro {
                bandwidth_hz: 0.0,
                // A gyro that repeats itself to the last bit counts as broken: a breath of noise, a thousandth of a real one's.
                noise_density_radps: 1.0e-7,
                bias_radps: 0.0,
                scale_error: 0.0,
                vibration_radps: 0.0,
                ..nominal.gyro
            },
            accelerometer: Accelerometer {
                bandwidth_hz: 0.0,
                noise_density_mps2: 0.0,
                bias_mps2: 0.0,
                scale_error: 0.0,
                vibration_mps2: 0.0,
                ..nominal.accelerometer
            },
            motion_capture: MotionCapture {
                latency_s: 0.0,
                latency_jitter_s: 0.0,
                position_noise_m: 0.0,
                attitude_noise_rad: 0.0,
                attitude_offset_rad: 0.0,
                ..nominal.motion_capture
            },
            ..nominal
        }
    }
}

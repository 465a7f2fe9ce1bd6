//! The gyro's imperfections, one by one and over many vehicles, within what the parameters state.

use mintime_simulator::{Command, Event, ImuSample, Model, Simulator, Start, VehicleParameters};

const DEGREE: f64 = std::f64::consts::PI / 180.0;

/// The next samples with their times.
fn samples(simulator: &mut Simulator, count: usize) -> Vec<(u64, ImuSample)> {
    let mut all = Vec::new();
    while all.len() < count {
        if let (time, Event::Gyro(sample)) = simulator.next_event().unwrap() {
            all.push((time, sample));
        }
    }
    all
}

fn on_ground(vehicle: &VehicleParameters, seed: u64) -> Simulator {
    Simulator::new(vehicle, seed, 0.0, Start::default()).unwrap()
}

fn mean(values: impl Iterator<Item = f64> + Clone) -> f64 {
    values.clone().sum::<f64>() / values.count() as f64
}

fn deviation(values: impl Iterator<Item = f64> + Clone) -> f64 {
    let centre = mean(values.clone());
    mean(values.map(|v| (v - centre) * (v - centre))).sqrt()
}

fn axis(samples: &[(u64, ImuSample)], axis: usize) -> impl Iterator<Item = f64> + Clone {
    samples.iter().map(move |(_, s)| f64::from(s.rates_radps[axis]))
}

#[test]
fn noise_and_bias_have_the_stated_size() {
    let vehicle = VehicleParameters::nominal();
    // Two poles with 256 Hz together pass as much noise as a rectangular filter of 312 Hz.
    let expected = 0.007 * DEGREE * 312.4_f64.sqrt();
    let mut biases = Vec::new();
    for seed in 0..60 {
        let readings = samples(&mut on_ground(&vehicle, seed), 800);
        for k in 0..3 {
            let noise = deviation(axis(&readings, k));
            // The quantum of 1.07 mrad/s adds its own twelfth.
            let with_quantum = (expected * expected + (DEGREE / 16.384).powi(2) / 12.0).sqrt();
            assert!((noise / with_quantum - 1.0).abs() < 0.12, "seed {seed}: {noise} {with_quantum}");
            biases.push(mean(axis(&readings, k)));
        }
    }
    let spread = deviation(biases.iter().copied());
    assert!((spread / (0.5 * DEGREE) - 1.0).abs() < 0.2, "{spread}");
    assert!(mean(biases.iter().copied()).abs() < 0.15 * DEGREE);
}

#[test]
fn scale_and_misalignment_stay_within_their_bounds_and_fill_them() {
    let mut vehicle = VehicleParameters::nominal();
    vehicle.model = Model::Planning;
    vehicle.gyro.noise_density_radps = 0.0;
    vehicle.gyro.bias_radps = 0.0;
    let (mut largest_scale, mut largest_cross) = (0.0_f64, 0.0_f64);
    for seed in 0..200 {
        let start = Start { height_m: 50.0, ..Start::default() };
        let mut simulator = Simulator::new(&vehicle, seed, 0.0, start).unwrap();
        let command = Command { throttle: [0.5; 4], rates_radps: [0.0, 20.0, 0.0], thrust_mps2: 9.81 };
        simulator.apply(command);
        let (_, sample) = samples(&mut simulator, 40)[39];
        let [x, y, z] = sample.rates_radps.map(|w| f64::from(w) / 20.0);
        largest_scale = largest_scale.max((y - 1.0).abs());
        largest_cross = largest_cross.max(x.abs()).max(z.abs());
    }
    // Misalignment by up to 1° about two axes shortens the reading by 0.03 % at most.
    assert!((0.018..0.0205).contains(&largest_scale), "{largest_scale}");
    assert!((0.015..DEGREE * 1.03).contains(&largest_cross), "{largest_cross}");
}

#[test]
fn counts_are_what_the_chip_would_hold() {
    let mut vehicle = VehicleParameters::ideal();
    vehicle.imu.quantised = true;
    for (rate, counts) in
        [(0.1, 94), (-0.1, -94), (10.0, 9387), (34.0, 31917), (60.0, 32767), (-60.0, -32768)]
    {
        let start = Start { height_m: 50.0, ..Start::default() };
        let mut simulator = Simulator::new(&vehicle, 0, 0.0, start).unwrap();
        simulator.apply(Command { throttle: [0.5; 4], rates_radps: [rate; 3], thrust_mps2: 9.81 });
        let (_, sample) = samples(&mut simulator, 2)[1];
        assert_eq!(sample.gyro_raw, [counts; 3]);
        let si = f64::from(counts) / 16.384 * DEGREE;
        assert!(sample.rates_radps.iter().all(|w| (f64::from(*w) - si).abs() < 1e-5));
        // 2048 counts per g: on the way up at 9.81 m/s².
        assert_eq!(sample.accelerometer_raw, [0, 0, 2049]);
    }
}

#[test]
fn the_filter_delays_a_steady_turn_up_by_its_group_delay() {
    let mut vehicle = VehicleParameters::ideal();
    vehicle.gyro.bandwidth_hz = 256.0;
    let start = Start { height_m: 50.0, ..Start::default() };
    let mut simulator = Simulator::new(&vehicle, 0, 0.0, start).unwrap();
    // 100 rad/s², in steps far shorter than the filter.
    let delay_s = 2.0 * 0.643_594 / (std::f64::consts::TAU * 256.0);
    for step in 0..2000_u32 {
        let rate = 0.01 * step as f32;
        simulator.apply(Command { throttle: [0.5; 4], rates_radps: [0.0, rate, 0.0], thrust_mps2: 9.81 });
        simulator.advance_to(u64::from(step + 1) * 100_000);
    }
    let (time, sample) = *samples(&mut simulator, 160).last().unwrap();
    assert_eq!(time, 200_000_000);
    let measured = (20.0 - f64::from(sample.rates_radps[1])) / 100.0;
    assert!((measured - delay_s).abs() < 1e-4, "{measured} {delay_s}");
}

#[test]
fn the_clock_is_wrong_but_steady() {
    let vehicle = VehicleParameters::nominal();
    let (mut slowest, mut fastest) = (f64::MAX, 0.0_f64);
    for seed in 0..200 {
        let times: Vec<u64> = samples(&mut on_ground(&vehicle, seed), 200).iter().map(|(t, _)| *t).collect();
        let period = (times[199] - times[0]) as f64 / 199.0;
        assert!(times.windows(2).all(|w| ((w[1] - w[0]) as f64 - period).abs() <= 1.0));
        assert!(times[0] <= period.ceil() as u64);
        let relative = 1e9 / period / 800.0;
        (slowest, fastest) = (slowest.min(relative), fastest.max(relative));
    }
    assert!((0.98 - 1e-6..0.982).contains(&slowest) && (1.018..1.02 + 1e-6).contains(&fastest));
}

#[test]
fn vibration_comes_at_the_rotors_frequency_and_grows_with_their_speed() {
    let mut vehicle = VehicleParameters::nominal();
    vehicle.gyro.noise_density_radps = 0.0;
    vehicle.gyro.bias_radps = 0.0;
    vehicle.imu.clock_error = 0.0;
    vehicle.imu.quantised = false;
    let shaking = |throttle: f32| {
        let mut simulator = on_ground(&vehicle, 4);
        simulator.apply(Command { throttle: [throttle; 4], ..Command::OFF });
        simulator.advance_to(500_000_000);
        while simulator.next_event_time_ns() <= simulator.now_ns() {
            simulator.next_event();
        }
        let speed = simulator.truth().rotor_speeds_radps[0];
        let readings = samples(&mut simulator, 800);
        assert!(simulator.truth().on_ground);
        let power = mean(axis(&readings, 1).map(|w| w * w));
        // The share of the power within the rotors' own frequency, by a single Fourier coefficient.
        let (mut re, mut im) = (0.0, 0.0);
        for (time, sample) in &readings {
            let (sin, cos) = (speed * *time as f64 * 1e-9).sin_cos();
            re += f64::from(sample.rates_radps[1]) * cos / 800.0;
            im += f64::from(sample.rates_radps[1]) * sin / 800.0;
        }
        (power.sqrt(), 2.0 * (re * re + im * im) / power)
    };
    let ((weak, weak_share), (strong, strong_share)) = (shaking(0.15), shaking(0.3));
    assert!(weak_share > 0.9 && strong_share > 0.9, "{weak_share} {strong_share}");
    // Four times the force, less what the filter takes off at the higher frequency.
    assert!((3.0..4.0).contains(&(strong / weak)), "{weak} {strong}");
}

#[test]
fn the_accelerometer_feels_gravity_on_the_ground_and_nothing_in_free_fall() {
    let vehicle = VehicleParameters::nominal();
    let readings = samples(&mut on_ground(&vehicle, 1), 400);
    let up = mean(readings.iter().map(|(_, s)| f64::from(s.specific_force_mps2[2])));
    assert!((up - 9.81).abs() < 0.8, "{up}");
    let start = Start { height_m: 50.0, ..Start::default() };
    let mut simulator = Simulator::new(&VehicleParameters::ideal(), 1, 0.0, start).unwrap();
    assert_eq!(samples(&mut simulator, 3)[2].1.specific_force_mps2, [0.0; 3]);
}

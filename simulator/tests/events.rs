//! Time and order: motion capture latency, determinism, faults.

use mintime_simulator::{Command, Event, Fault, FaultError, PoseSample, Simulator, Start, VehicleParameters};

const MS: u64 = 1_000_000;

fn in_air(vehicle: &VehicleParameters, seed: u64) -> Simulator {
    Simulator::new(vehicle, seed, 0.0, Start { height_m: 20.0, ..Start::default() }).unwrap()
}

/// Events up to a time, under throttles that change with each gyro sample.
fn flight(simulator: &mut Simulator, until_ns: u64) -> Vec<(u64, Event)> {
    let mut events = Vec::new();
    while simulator.next_event_time_ns() <= until_ns {
        let (time, event) = simulator.next_event().unwrap();
        if matches!(event, Event::Gyro(_)) {
            let throttle = core::array::from_fn(|i| 0.4 + 0.02 * ((time / MS + i as u64) % 5) as f32);
            simulator.apply(Command { throttle, ..Command::OFF });
        }
        events.push((time, event));
    }
    events
}

fn poses(events: &[(u64, Event)]) -> Vec<(u64, PoseSample)> {
    events
        .iter()
        .filter_map(|(t, e)| if let Event::MotionCapture(p) = e { Some((*t, *p)) } else { None })
        .collect()
}

fn gyro_times(events: &[(u64, Event)]) -> Vec<u64> {
    events.iter().filter(|(_, e)| matches!(e, Event::Gyro(_))).map(|(t, _)| *t).collect()
}

#[test]
fn one_seed_gives_one_flight() {
    let vehicle = VehicleParameters::nominal();
    let run = |seed| {
        let mut simulator = in_air(&vehicle, seed);
        let events = flight(&mut simulator, 800 * MS);
        format!("{events:?} {:?}", simulator.truth())
    };
    assert_eq!(run(11).into_bytes(), run(11).into_bytes());
    assert_ne!(run(11), run(12));
}

#[test]
fn silencing_one_error_leaves_the_others() {
    let vehicle = VehicleParameters::nominal();
    let mut quiet = vehicle.clone();
    quiet.gyro.noise_density_radps = 0.0;
    quiet.gyro.scale_error = 0.0;
    let (loud, quiet) =
        (flight(&mut in_air(&vehicle, 3), 200 * MS), flight(&mut in_air(&quiet, 3), 200 * MS));
    assert_eq!(gyro_times(&loud), gyro_times(&quiet));
    assert_eq!(poses(&loud), poses(&quiet));
    assert_ne!(loud, quiet);
}

#[test]
fn asking_more_often_changes_nothing_of_weight() {
    let vehicle = VehicleParameters::nominal();
    let (mut one, mut many) = (in_air(&vehicle, 3), in_air(&vehicle, 3));
    for simulator in [&mut one, &mut many] {
        simulator.apply(Command { throttle: [0.45, 0.44, 0.45, 0.46], ..Command::OFF });
    }
    one.advance_to(300 * MS);
    for k in 1..=30_000 {
        many.advance_to(k * MS / 100);
    }
    let (a, b) = (one.truth(), many.truth());
    for axis in 0..3 {
        assert!((a.position_m[axis] - b.position_m[axis]).abs() < 1e-9);
        assert!((a.rates_radps[axis] - b.rates_radps[axis]).abs() < 1e-8, "{a:?} {b:?}");
    }
    let times = |simulator: &mut Simulator| -> Vec<u64> {
        (0..200).map(|_| simulator.next_event().unwrap().0).collect()
    };
    let (all, again) = (times(&mut one), times(&mut many));
    assert!(all == again && all.is_sorted());
    // The past does not come back.
    one.advance_to(0);
    assert!(one.now_ns() >= 300 * MS);
}

#[test]
fn poses_are_late_and_show_the_past() {
    let mut vehicle = VehicleParameters::nominal();
    vehicle.motion_capture.position_noise_m = 0.0;
    vehicle.drag.body_ns2_per_m2 = [0.0; 3];
    let mut simulator = in_air(&vehicle, 5);
    // Motors off: it falls on a parabola.
    let mut last = 0;
    for k in 1..=100 {
        let (arrival, pose) = loop {
            if let (time, Event::MotionCapture(pose)) = simulator.next_event().unwrap() {
                break (time, pose);
            }
        };
        assert_eq!(pose.captured_ns, k * 5 * MS);
        assert!((6 * MS..=7 * MS).contains(&(arrival - pose.captured_ns)) && arrival > last);
        assert_eq!(simulator.now_ns(), arrival);
        last = arrival;
        let fallen = 0.5 * 9.81 * (pose.captured_ns as f64 * 1e-9).powi(2);
        assert!((pose.position_m[2] - 20.0 + fallen).abs() < 1e-9);
    }
}

#[test]
fn motion_capture_noise_has_the_stated_size() {
    let mut simulator = Simulator::new(&VehicleParameters::nominal(), 9, 0.0, Start::default()).unwrap();
    let seen = poses(&flight_on_ground(&mut simulator, 10_000 * MS));
    let n = seen.len() as f64;
    assert_eq!(seen.len(), 1998);
    let deviation = |value: &dyn Fn(&PoseSample) -> f64| {
        let mean = seen.iter().map(|(_, p)| value(p)).sum::<f64>() / n;
        (seen.iter().map(|(_, p)| (value(p) - mean).powi(2)).sum::<f64>() / n).sqrt()
    };
    for axis in 0..3 {
        assert!((deviation(&|p| p.position_m[axis]) / 1e-4 - 1.0).abs() < 0.08);
        // Half the angle stands in the quaternion's vector part.
        assert!((deviation(&|p| 2.0 * p.attitude[axis + 1]) / 5e-4 - 1.0).abs() < 0.08);
    }
}

fn flight_on_ground(simulator: &mut Simulator, until_ns: u64) -> Vec<(u64, Event)> {
    let mut events = Vec::new();
    while simulator.next_event_time_ns() <= until_ns {
        events.push(simulator.next_event().unwrap());
    }
    events
}

#[test]
fn lost_frames_are_as_many_as_stated() {
    let mut vehicle = VehicleParameters::nominal();
    vehicle.motion_capture.drop_out = 0.3;
    let mut simulator = Simulator::new(&vehicle, 9, 0.0, Start::default()).unwrap();
    let arrived = poses(&flight_on_ground(&mut simulator, 10_000 * MS)).len();
    assert!((1340..1460).contains(&arrived), "{arrived}");
}

#[test]
fn silent_sensors_say_nothing_and_come_back() {
    let mut simulator = Simulator::new(&VehicleParameters::ideal(), 0, 0.0, Start::default()).unwrap();
    simulator.inject(Fault::ImuSilent, 10 * MS..11 * MS).unwrap();
    simulator.inject(Fault::MotionCaptureSilent, 100 * MS..151 * MS).unwrap();
    let events = flight_on_ground(&mut simulator, 200 * MS);
    let mut expected: Vec<u64> = (1..=160).map(|k| k * 1_250_000).collect();
    expected.retain(|t| *t != 10 * MS);
    assert_eq!(gyro_times(&events), expected);
    let times: Vec<u64> = poses(&events).iter().map(|(t, _)| *t / MS).collect();
    assert_eq!(times, (1..20).chain(31..=40).map(|k| 5 * k).collect::<Vec<u64>>());

    simulator.inject(Fault::ImuSilent, 0..u64::MAX).unwrap();
    assert_eq!(simulator.next_event_time_ns(), 205 * MS);
    simulator.inject(Fault::MotionCaptureSilent, 0..u64::MAX).unwrap();
    assert_eq!(simulator.next_event_time_ns(), u64::MAX);
    assert_eq!(simulator.next_event(), None);
    simulator.advance_to(300 * MS);
    assert_eq!(simulator.now_ns(), 300 * MS);
}

#[test]
fn stuck_reversed_and_frozen_sensors_lie() {
    let start = Start { height_m: 100.0, ..Start::default() };
    let mut vehicle = VehicleParameters::ideal();
    // Exact comparisons below: not even the last digit stirs.
    vehicle.gyro.noise_density_radps = 0.0;
    let mut simulator = Simulator::new(&vehicle, 0, 0.0, start).unwrap();
    simulator.inject(Fault::ImuStuck, 100 * MS..200 * MS).unwrap();
    simulator.inject(Fault::GyroReversed, 300 * MS..400 * MS).unwrap();
    simulator.inject(Fault::MotionCaptureFrozen, 300 * MS..400 * MS).unwrap();
    let mut frozen = None;
    while let Some((time, event)) = simulator.next_event()
        && time < 500 * MS
    {
        match event {
            Event::Gyro(sample) => {
                let truth = simulator.truth().rates_radps[1] as f32;
                let read = sample.rates_radps[1];
                match time / MS {
                    100..200 => assert!(read < truth && (read - 0.078).abs() < 1e-6, "{time} {read}"),
                    300..400 => assert!(read == -truth && sample.gyro_raw[1] < 0),
                    _ => assert_eq!(read, truth),
                }
                let rate = (time / 1_250_000) as f32 * 1e-3;
                simulator.apply(Command {
                    throttle: [0.5; 4],
                    rates_radps: [0.0, rate, 0.0],
                    thrust_mps2: 9.0,
                });
            }
            Event::MotionCapture(pose) => match time / MS {
                300..400 => {
                    assert_eq!(pose.captured_ns, time);
                    assert_eq!(Some(pose.position_m), frozen);
                }
                _ => frozen = Some(pose.position_m),
            },
        }
    }
}

#[test]
fn a_dead_rotor_spins_down_and_the_vehicle_turns_over() {
    let mut simulator = in_air(&VehicleParameters::nominal(), 1);
    simulator.inject(Fault::RotorDead(1), 100 * MS..u64::MAX).unwrap();
    assert_eq!(simulator.inject(Fault::RotorDead(7), 0..1), Err(FaultError::NoSuchRotor(7)));
    simulator.apply(Command { throttle: [0.45; 4], ..Command::OFF });
    simulator.advance_to(300 * MS);
    let truth = simulator.truth();
    assert!(truth.rotor_speeds_radps[1] < 10.0 && truth.rotor_speeds_radps[0] > 900.0);
    // Front right has gone: it rolls to the right and its nose drops.
    assert!(truth.rates_radps[0] > 5.0 && truth.rates_radps[1] > 5.0, "{truth:?}");
}

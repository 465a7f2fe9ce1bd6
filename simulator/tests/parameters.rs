//! Vehicles from TOML: what is read, and what is refused with which sentence.

use mintime_simulator::{Model, ParameterError, Simulator, SimulatorError, Start, VehicleParameters};

fn refusal(text: &str) -> String {
    VehicleParameters::from_toml(text).unwrap_err().to_string()
}

#[test]
fn built_in_vehicles_are_valid_and_survive_a_round_trip() {
    for (base, vehicle) in [("nominal", VehicleParameters::nominal()), ("ideal", VehicleParameters::ideal())]
    {
        assert_eq!(vehicle.validate(), Ok(()));
        let text = vehicle.to_toml().unwrap();
        assert_eq!(VehicleParameters::from_toml(&text), Ok(vehicle.clone()));
        assert_eq!(VehicleParameters::from_toml(&format!("base = \"{base}\"")), Ok(vehicle));
    }
    assert_eq!(VehicleParameters::from_toml(""), Ok(VehicleParameters::nominal()));
}

/// The values that a slip of the keyboard would change unseen, against the published ones.
#[test]
fn nominal_is_the_published_vehicle() {
    let v = VehicleParameters::nominal();
    assert_eq!(
        (v.model, v.body.mass_kg, v.body.inertia_kgm2),
        (Model::RigidBody, 0.752, [0.0025, 0.0021, 0.0043])
    );
    assert_eq!((v.body.rotor_forward_m, v.body.rotor_left_m), (0.075, 0.1));
    assert_eq!((v.rotors.thrust_coefficient_ns2, v.rotors.torque_ratio_m), (1.562522e-6, 0.022));
    assert_eq!((v.rotors.time_constant_up_s, v.rotors.time_constant_down_s), (0.033, 0.033));
    assert!((v.thrust_mps2(1.0, 14.8) - 4.0 * 8.5 / 0.752).abs() < 2e-3);
    assert!((v.throttle(v.thrust_mps2(0.37, 15.0), 15.0) - 0.37).abs() < 1e-12);
    assert_eq!((v.imu.rate_hz, v.gyro.range_dps, v.gyro.lsb_per_dps), (800.0, 2000.0, 16.384));
}

#[test]
fn a_file_changes_only_what_it_says() {
    let text = "
        base = \"ideal\"
        model = \"rigid_body\"
        gravity_mps2 = 9.8
        [body]
        mass_kg = 1
        inertia_kgm2 = [3e-3, 3e-3, 5e-3]
        [motion_capture]
        latency_s = 0.01
    ";
    let vehicle = VehicleParameters::from_toml(text).unwrap();
    let mut expected = VehicleParameters::ideal();
    expected.model = Model::RigidBody;
    expected.gravity_mps2 = 9.8;
    expected.body.mass_kg = 1.0;
    expected.body.inertia_kgm2 = [3e-3, 3e-3, 5e-3];
    expected.motion_capture.latency_s = 0.01;
    assert_eq!(vehicle, expected);
}

#[test]
fn refusals_name_the_field_and_say_what_to_do() {
    for (text, parts) in [
        ("body.mass_kg = -0.7", ["body.mass_kg is -0.7", "above zero"]),
        ("body.mass_kg = nan", ["body.mass_kg is NaN", "finite"]),
        ("battery.full_v = inf", ["battery.full_v is inf", "finite"]),
        ("body.mass_kg = 752", ["full thrust per mass", "above gravity"]),
        ("body.inertia_kgm2 = [2.5e-3, 0.0, 4.3e-3]", ["body.inertia_kgm2 along y is 0", "above zero"]),
        ("body.inertia_kgm2 = [1e-3, 1e-3, 4e-3]", ["inertia_kgm2 is 0.004", "sum of the other two"]),
        ("body.inertia_kgm2 = [1e-3, 1e-3]", ["inertia_kgm2", "length 3"]),
        ("body.mas_kg = 0.7", ["unknown field `mas_kg`", "mass_kg"]),
        ("wings = 2", ["unknown field `wings`", "body"]),
        ("body.mass_kg = \"heavy\"", ["invalid type: string \"heavy\"", "f64"]),
        ("body = 3", ["invalid type: integer `3`", "Body"]),
        ("base = \"warped\"", ["no base vehicle `warped`", "base = \"nominal\""]),
        ("base = 3", ["no base vehicle `3`", "ideal"]),
        ("model = \"magic\"", ["magic", "rigid_body"]),
        ("gyro.scale_error = 2", ["gyro.scale_error is 2", "0.02 is 2 %"]),
        ("imu.rate_hz = 1e5", ["imu.rate_hz is 100000", "4000 Hz"]),
        ("rotors.time_constant_up_s = 1e-9", ["time_constant_up_s", "at least 0.001 s"]),
        ("battery.empty_v = 17", ["battery.empty_v is 17", "full_v"]),
        ("motion_capture.latency_jitter_s = 0.02", ["latency_jitter_s", "out of order"]),
        ("motion_capture.drop_out = 1", ["drop_out is 1", "0.99"]),
        ("gravity_mps2 = 1e9", ["gravity_mps2", "check the unit"]),
        ("[body", ["cannot be read", "line 1"]),
    ] {
        let sentence = refusal(text);
        for part in parts {
            assert!(sentence.contains(part), "{text}: {sentence}");
        }
    }
}

#[test]
fn a_simulation_checks_its_vehicle_and_its_start() {
    let mut broken = VehicleParameters::nominal();
    broken.rotors.thrust_coefficient_ns2 = f64::NAN;
    let error = Simulator::new(&broken, 0, 0.0, Start::default()).err();
    assert!(matches!(error, Some(SimulatorError::Parameters(ParameterError::Value { .. }))));
    for start in [
        Start { x_m: f64::NAN, ..Start::default() },
        Start { height_m: -1.0, ..Start::default() },
        Start { heading_rad: f64::INFINITY, ..Start::default() },
    ] {
        let error = Simulator::new(&VehicleParameters::ideal(), 0, 0.0, start).err();
        assert_eq!(error, Some(SimulatorError::Start));
    }
}

#[test]
fn the_examples_of_the_documentation_are_vehicles() {
    let text = include_str!("../../docs/vehicles.md");
    let examples: Vec<&str> =
        text.split("```toml\n").skip(1).filter_map(|rest| rest.split("```").next()).collect();
    assert_eq!(examples.len(), 2);
    for example in examples {
        assert!(VehicleParameters::from_toml(example).is_ok(), "{example}");
    }
}

/// Every field has its row in the documentation.
#[test]
fn the_documentation_names_every_field() {
    let text = include_str!("../../docs/vehicles.md");
    for line in VehicleParameters::nominal().to_toml().unwrap().lines() {
        let name = line.split(" = ").next().unwrap().trim_matches(['[', ']']);
        assert!(name.is_empty() || text.contains(name), "{name}");
    }
}

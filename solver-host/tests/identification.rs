//! Hops of simulated vehicles of known thrust and lag: does identification find both?

use mintime::flight::{HopFlight, HopPlan, HostedVehicle, Phase, Scene, Witness, fly_hops};
use mintime::identification::{IdentificationError, Identified, check, identify};
use mintime::mission::Room;
use mintime_shared::vehicle::VehicleConfig;
use mintime_simulator::VehicleParameters;

struct Unseen;

impl Witness for Unseen {
    fn phase(&mut self, _: Phase, _: f64) {}
    fn event(&mut self, _: f64, _: &str) {}
}

/// A vehicle whose rotors give this part of what its file says, with this lag.
fn airframe(strength: f64, lag_s: f64) -> VehicleParameters {
    let mut vehicle = VehicleParameters::nominal();
    vehicle.rotors.thrust_coefficient_ns2 *= strength;
    vehicle.rotors.time_constant_up_s = lag_s;
    vehicle.rotors.time_constant_down_s = lag_s;
    vehicle
}

/// Flies, and returns besides what it brought the true thrust scale: what the rotors give at their speeds, over what the
/// file takes them to give there.
fn hop(parameters: &VehicleParameters, seed: u64, plan: &HopPlan) -> (HopFlight, f64) {
    let scene = Scene { parameters, seed, ground_z_m: 0.0, heading_rad: 0.0, maneuver_s: 0.0 };
    let mut vehicle = HostedVehicle::new(&scene).expect("a vehicle");
    let flight = fly_hops(&mut vehicle, plan, &mut Unseen).expect("flown");
    let trace = vehicle.into_trace();
    assert!(!trace.last.expect("it has flown").crashed);
    let hovering = || {
        let (from, to) = flight.hover_s;
        trace.samples.iter().filter(move |s| (from..to).contains(&(s.time_ns as f64 * 1e-9)))
    };
    let count = hovering().count() as f64;
    let given = hovering().map(|s| s.truth.thrust_mps2).sum::<f64>() / count;
    let asked = hovering().map(|s| f64::from(s.setpoint_thrust_mps2)).sum::<f64>() / count;
    (flight, given / asked)
}

fn found(parameters: &VehicleParameters, seed: u64) -> (Identified, f64) {
    let (flight, truth) = hop(parameters, seed, &HopPlan::default());
    (identify(&flight, &VehicleConfig::REFERENCE).expect("enough data"), truth)
}

#[test]
fn thrust_and_lag_are_found_over_seeds() {
    let (mut scales, mut lags) = (Vec::new(), Vec::new());
    for seed in 1..=20_u32 {
        let part = f64::from(seed - 1) / 19.0;
        // ±10 % of thrust, and in no order with it lags of 22 to 60 ms.
        let strength = 0.9 + 0.2 * part;
        let lag_s = 0.022 + 0.002 * f64::from((7 * seed) % 20);
        let (found, truth) = found(&airframe(strength, lag_s), u64::from(seed));
        let (scale_error, lag_error_s) = (found.thrust_scale / truth - 1.0, found.lag_s - lag_s);
        assert!(scale_error.abs() < 0.01, "{seed}: {found:?}, truth {truth}");
        assert!(lag_error_s.abs() < 0.005, "{seed}: {found:?}, truth {lag_s}");
        assert!((found.step_scale / truth - 1.0).abs() < 0.03, "{seed}: {found:?}, truth {truth}");
        // 15 mΩ behind 15 A in hover, which grow by 1.5 times what the thrust grows by.
        let (sag, _) = found.sag_v_per_n.expect("the simulated battery sags");
        assert!((0.03..0.06).contains(&sag), "{found:?}");
        assert!((0.0..0.004).contains(&found.dead_time_s), "{found:?}");
        assert_eq!(found.hops, 12);
        scales.push(scale_error);
        lags.push((lag_error_s * 1e3, lag_error_s / found.lag_std_s));
    }
    let rms = |values: &mut dyn Iterator<Item = f64>| (values.map(|v| v * v).sum::<f64>() / 20.0).sqrt();
    let worst = |values: &mut dyn Iterator<Item = f64>| values.fold(0.0, |w: f64, v| w.max(v.abs()));
    let (scale, lag) = (rms(&mut scales.iter().copied()), rms(&mut lags.iter().map(|l| l.0)));
    let honest = rms(&mut lags.iter().map(|l| l.1));
    eprintln!(
        "scale: rms {:.4} %, worst {:.4} %; lag: rms {lag:.2} ms, worst {:.2} ms, {honest:.2} standard errors rms",
        scale * 100.0,
        100.0 * worst(&mut scales.iter().copied()),
        worst(&mut lags.iter().map(|l| l.0)),
    );
    // The standard error tells what to expect.
    assert!((0.4..2.5).contains(&honest), "{honest}");
}

#[test]
fn what_is_found_makes_the_vehicle_fly_as_its_file_says() {
    let parameters = airframe(0.9, 0.050);
    let (first, _) = found(&parameters, 7);
    let told = HopPlan { vehicle: None, ..HopPlan::default() };
    let flight = hop_as(&parameters, 8, &told, &first.vehicle);
    let second = identify(&flight, &first.vehicle).expect("enough data");
    // Another seed is another set of rotors.
    assert!((second.thrust_scale - 1.0).abs() < 0.03, "{second:?}");
    assert!((second.lag_s - 0.050).abs() < 0.002 && (second.response_s - 0.010).abs() < 0.002, "{second:?}");
    let again =
        identify(&hop_as(&parameters, 7, &told, &first.vehicle), &first.vehicle).expect("enough data");
    assert!((again.thrust_scale - 1.0).abs() < 0.002, "{again:?}");
}

#[test]
fn lag_is_found_behind_another_lead() {
    // A file that is far off, and one whose lag is so short that the firmware leads by nothing.
    for file_lag_s in [0.060, 0.008] {
        let file = VehicleConfig { rotor_lag_s: file_lag_s, ..VehicleConfig::REFERENCE };
        let flight = hop_as(&airframe(1.0, 0.033), 4, &HopPlan::default(), &file);
        let found = identify(&flight, &file).expect("enough data");
        assert!((found.lag_s - 0.033).abs() < 0.003, "{file_lag_s}: {found:?}");
    }
}

fn hop_as(parameters: &VehicleParameters, seed: u64, plan: &HopPlan, file: &VehicleConfig) -> HopFlight {
    let scene = Scene { parameters, seed, ground_z_m: 0.0, heading_rad: 0.0, maneuver_s: 0.0 };
    fly_hops(&mut HostedVehicle::told(&scene, file).expect("a vehicle"), plan, &mut Unseen).expect("flown")
}

#[test]
fn what_does_not_suffice_is_refused() {
    use IdentificationError as E;
    let nominal = VehicleParameters::nominal();
    let file = VehicleConfig::REFERENCE;
    let (flight, _) = hop(&nominal, 1, &HopPlan::default());

    let short = HopFlight { hover_s: (flight.hover_s.0, flight.hover_s.0 + 1.5), ..flight.clone() };
    assert!(matches!(identify(&short, &file), Err(E::ShortHover { .. })));
    let few = HopFlight { hops: flight.hops[..3].to_vec(), ..flight.clone() };
    assert_eq!(identify(&few, &file), Err(E::FewHops { hops: 3 }));
    let mut blind = flight.clone();
    blind
        .sights
        .retain(|s| s.pose.captured_s < flight.hover_s.0 + 2.0 || s.pose.captured_s > flight.hover_s.1);
    assert!(matches!(identify(&blind, &file), Err(E::Poses { .. })));
    let mut carried = flight.clone();
    for sight in &mut carried.sights {
        sight.pose.position_m.x += 0.1 * sight.pose.captured_s;
    }
    assert!(matches!(identify(&carried, &file), Err(E::Drift { .. })));
    let mut leaning = flight.clone();
    for sight in &mut leaning.sights {
        sight.pose.attitude *= nalgebra::UnitQuaternion::from_euler_angles(0.2, 0.0, 0.0);
    }
    assert!(matches!(identify(&leaning, &file), Err(E::Lean { .. })));
    // Cameras that shake.
    let mut blurred = flight.clone();
    for (i, sight) in blurred.sights.iter_mut().enumerate() {
        sight.pose.position_m.z += 0.01 * (i as f64 * 1.7).sin();
    }
    let error = identify(&blurred, &file).expect_err("nothing can be seen");
    assert!(
        matches!(error, E::Residual { .. } | E::LagUncertain { .. } | E::ScaleUncertain { .. }),
        "{error}"
    );
    // Poses with another clock.
    let mut late = flight.clone();
    for sight in &mut late.sights {
        sight.pose.captured_s -= 0.2;
    }
    late.hover_s = (flight.hover_s.0 - 0.2, flight.hover_s.1 - 0.2);
    assert!(identify(&late, &file).is_err());
}

#[test]
fn what_cannot_suffice_is_refused_before_it_flies() {
    use IdentificationError as E;
    let plan = HopPlan::default();
    let room = Room { x_m: (-1.0, 1.0), y_m: Some((-1.0, 1.0)), z_m: (-1.2, 1.0) };
    assert_eq!(check(&plan, Some(&room)), Ok(()));
    assert!(matches!(check(&HopPlan { hover_s: 1.0, ..plan }, None), Err(E::ShortHover { .. })));
    assert!(matches!(check(&HopPlan { hops: 2, ..plan }, None), Err(E::FewHops { .. })));
    assert!(matches!(check(&HopPlan { height_m: 0.3, ..plan }, None), Err(E::Low { .. })));
    assert!(matches!(check(&HopPlan { step_mps2: 9.0, ..plan }, None), Err(E::Step)));
    let low = Room { z_m: (-1.2, 0.2), ..room };
    assert!(matches!(check(&plan, Some(&low)), Err(E::Room { .. })));
    let narrow = Room { y_m: Some((-0.3, 1.0)), ..room };
    assert!(matches!(check(&plan, Some(&narrow)), Err(E::Room { .. })));
}

#[test]
fn the_command_identifies_the_hosted_vehicle() {
    let folder = tempfile::tempdir().expect("a folder");
    let mintime = |arguments: &[&str]| {
        let mut command = std::process::Command::new(env!("CARGO_BIN_EXE_mintime"));
        command
            .args(["vehicle", "hosted"])
            .args(arguments)
            .current_dir(folder.path())
            .output()
            .expect("it starts")
    };
    std::fs::write(folder.path().join("weak.toml"), "[rotors]\nthrust_coefficient_ns2 = 1.4e-6")
        .expect("written");
    let output = mintime(&["identify", "--plant", "weak.toml", "-o", "quad.json", "--json"]);
    let answer: serde_json::Value = serde_json::from_slice(&output.stdout).expect("JSON");
    assert!((answer["thrust_scale"].as_f64().expect("a number") - 0.896).abs() < 0.03, "{answer}");
    assert!((answer["lag_s"].as_f64().expect("a number") - 0.033).abs() < 0.005, "{answer}");
    let file = std::fs::read(folder.path().join("quad.json")).expect("written");
    let vehicle: VehicleConfig = serde_json::from_slice(&file).expect("a vehicle file");
    assert_eq!(vehicle.check(), Ok(()));
    assert_eq!(
        answer["vehicle"]["rotor_thrust_max_n"],
        serde_json::from_slice::<serde_json::Value>(&file).expect("JSON")["rotor_thrust_max_n"]
    );
    let output = mintime(&["identify", "--plant", "weak.toml", "--file", "quad.json", "--json"]);
    let answer: serde_json::Value = serde_json::from_slice(&output.stdout).expect("JSON");
    assert!((answer["thrust_scale"].as_f64().expect("a number") - 1.0).abs() < 0.002, "{answer}");

    for (arguments, told) in [
        (&["identify", "--hops", "2"][..], "fly 4 to 100"),
        (&["identify", "--height", "0.2"], "too low"),
        (&["identify", "--room", "-1,1,-1,1,-1,0.1"], "too small"),
        (&["identify", "--mocap", "-"], "brings its own cameras"),
        (&["identify", "--apply"], "-o FILE.json"),
    ] {
        let output = mintime(arguments);
        let text = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(!output.status.success() && text.contains(told), "{text}");
    }
}

//! Hops of simulated vehicles of known thrust and lag: does identification find both?

use mintime::flight::{HopFlight, HopPlan, HostedVehicle, Phase, Scene, Witness, fly_hops};
use mintime::identification::{Identified, identify};
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
    for (seed, strength, lag_s) in
        [(1, 0.9, 0.033), (2, 1.1, 0.033), (3, 1.0, 0.045), (4, 0.95, 0.025), (5, 1.05, 0.060)]
    {
        let (found, truth) = found(&airframe(strength, lag_s), seed);
        eprintln!(
            "{seed}: scale {:.4} ± {:.4} (truth {truth:.4}), step {:.4} ± {:.4}, lag {:.2} ± {:.2} ms (truth {:.1}), dead {:.2} ± {:.2} ms, β {:.3}, sag {:?}, residual {:.3} mm",
            found.thrust_scale,
            found.thrust_scale_std,
            found.step_scale,
            found.step_scale_std,
            found.lag_s * 1e3,
            found.lag_std_s * 1e3,
            lag_s * 1e3,
            found.dead_time_s * 1e3,
            found.dead_time_std_s * 1e3,
            found.damping_per_s,
            found.sag_v_per_n,
            found.residual_m * 1e3
        );
        assert!((found.thrust_scale / truth - 1.0).abs() < 0.01, "{found:?}");
        assert!((found.lag_s - lag_s).abs() < 0.005, "{found:?}");
    }
}

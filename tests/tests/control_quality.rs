//! How well the rate loop keeps a vehicle on its plan: measured over seeds on the simulated airframe.

use mintime::flight::{Phase, Witness};
use mintime::mission::{Flown, Mission, PlantChoice, Source, VehicleChoice, fly_mission, prepare};
use mintime::solver::Turns;
use mintime_shared::model::{Limits, State};
use mintime_shared::replay::Plan;

/// A witness that looks away.
struct Unseen;

impl Witness for Unseen {
    fn phase(&mut self, _: Phase, _: f64) {}
    fn event(&mut self, _: f64, _: &str) {}
}

/// What one flight missed its plan by.
#[derive(Clone, Copy, Debug, Default)]
struct Miss {
    position_m: f64,
    velocity_mps: f64,
    end_angle_rad: f64,
    /// Root mean square over the maneuver of flown less planned angle in the plane.
    angle_rms_rad: f64,
    /// Largest angle of the thrust axis out of the plane.
    lateral_rad: f64,
}

fn flown(x: f64, z: f64, seed: u64) -> Flown {
    let mission = Mission {
        source: Source::Solve {
            to: State::at_rest(x, z),
            limits: Limits::TABLE_I,
            turns: Turns::Any,
            heading_rad: 0.0,
        },
        plant: PlantChoice::from_argument("nominal").expect("a plant"),
        seed,
        room: None,
    };
    let prepared = prepare(&mission.source, None).expect("a maneuver");
    fly_mission(&mission, prepared, &VehicleChoice::Hosted, &mut Unseen).expect("a simulation")
}

fn miss(flown: &Flown) -> Miss {
    let end = flown.final_error().expect("it was flown to its end");
    let plan = Plan::new(&flown.prepared.table);
    let start_ns = flown.trace.start_ns.expect("it began");
    let (sin, cos) = flown.heading_rad().sin_cos();
    let (mut sum, mut count, mut lateral_rad) = (0.0, 0.0, 0.0f64);
    for sample in &flown.trace.samples {
        let t_s = (sample.time_ns as f64 - start_ns as f64) * 1e-9;
        if !(0.0..=f64::from(plan.duration_s())).contains(&t_s) {
            continue;
        }
        let planned = f64::from(plan.state_at(t_s as f32).theta);
        sum += (sample.truth.planar.theta - planned).powi(2);
        count += 1.0;
        let [w, x, y, z] = sample.truth.attitude_wxyz;
        // The body z axis in the world, and its part across the plane.
        let up = [2.0 * (x * z + w * y), 2.0 * (y * z - w * x)];
        lateral_rad = lateral_rad.max((up[1] * cos - up[0] * sin).abs().min(1.0).asin());
    }
    Miss {
        position_m: end.x_m.hypot(end.z_m),
        velocity_mps: end.vx_mps.hypot(end.vz_mps),
        end_angle_rad: end.theta_rad.abs(),
        angle_rms_rad: (sum / count).sqrt(),
        lateral_rad,
    }
}

/// Root mean square of each figure over ten seeds.
fn over_seeds(x: f64, z: f64) -> Miss {
    const SEEDS: u64 = 10;
    let mut total = Miss::default();
    for seed in 1..=SEEDS {
        let m = miss(&flown(x, z, seed));
        let add = |sum: &mut f64, value: f64| *sum += value * value;
        add(&mut total.position_m, m.position_m);
        add(&mut total.velocity_mps, m.velocity_mps);
        add(&mut total.end_angle_rad, m.end_angle_rad);
        add(&mut total.angle_rms_rad, m.angle_rms_rad);
        add(&mut total.lateral_rad, m.lateral_rad);
    }
    let mean = |sum: f64| (sum / SEEDS as f64).sqrt();
    Miss {
        position_m: mean(total.position_m),
        velocity_mps: mean(total.velocity_mps),
        end_angle_rad: mean(total.end_angle_rad),
        angle_rms_rad: mean(total.angle_rms_rad),
        lateral_rad: mean(total.lateral_rad),
    }
}

/// Prints the table; run it with `--ignored --nocapture`.
#[test]
#[ignore = "a measurement, not a test"]
fn table() {
    println!("maneuver      position m  velocity m/s  end angle rad  angle rms rad  out of plane rad");
    for (x, z) in [(5.0, 5.0), (0.0, 3.0), (-3.0, 4.0), (12.0, 0.0)] {
        let m = over_seeds(x, z);
        println!(
            "({x:4},{z:4})   {:10.3}  {:12.3}  {:13.4}  {:13.4}  {:16.4}",
            m.position_m, m.velocity_mps, m.end_angle_rad, m.angle_rms_rad, m.lateral_rad
        );
    }
}

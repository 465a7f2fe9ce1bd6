//! How well the rate loop keeps a vehicle on its plan: measured over seeds on the simulated airframe.

use mintime::flight::{Phase, Witness};
use mintime::mission::{Flown, Mission, PlantChoice, Source, VehicleChoice, fly_mission, prepare};
use mintime::solver::Turns;
use mintime_firmware::config::VehicleConfig;
use mintime_firmware::mixer::{Demand, RotorDrive, mix};
use mintime_firmware::rate_control::{RateController, RateInput};
use mintime_shared::model::{Limits, State};
use mintime_shared::plane::Plane;
use mintime_shared::replay::Plan;
use mintime_simulator::{Command, Event, Simulator, Start, VehicleParameters};

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

/// How a step of the pitch rate from hover is followed.
struct StepResponse {
    /// From 10 % to 90 %, s.
    rise_s: f64,
    /// Beyond the step, part of it.
    overshoot: f64,
    /// Largest angle about another axis, rad.
    cross_rad: f64,
}

/// On the simulated airframe with its own gyro, 5 rad/s for 0.25 s, about an axis of a plane.
fn step_response(seed: u64, heading_rad: f32) -> StepResponse {
    const STEP_RADPS: f32 = 5.0;
    let config = VehicleConfig::REFERENCE;
    let mut parameters = VehicleParameters::nominal();
    parameters.gyro.bias_radps = 0.0;
    let start = Start { height_m: 100.0, ..Start::default() };
    let mut simulator = Simulator::new(&parameters, seed, 0.0, start).expect("sound");
    let (mut rate, mut drive) = (RateController::new(), RotorDrive::new());
    let plane = Plane::new(heading_rad);
    let (mut asked, mut last_ns, mut begun_ns) = ([0.0; 3], 0, None);
    let (mut low_s, mut high_s, mut peak, mut across) = (None, None, 0.0f64, [0.0f64; 2]);
    let mut cross_rad = 0.0f64;
    while let Some((now, event)) = simulator.next_event() {
        let Event::Gyro(sample) = event else { continue };
        let dt_s = ((now - last_ns) as f32 * 1e-9).min(2.5e-3);
        last_ns = now;
        // Two seconds to settle in free air.
        let stepping = now > 2_000_000_000;
        let next = if stepping { plane.turn(STEP_RADPS) } else { [0.0; 3] };
        if stepping {
            let since = (now - *begun_ns.get_or_insert(now)) as f64 * 1e-9;
            let [lateral, turning, yaw] =
                plane.axes(simulator.truth().rates_radps.map(|r| r as f32)).map(f64::from);
            let part = turning / f64::from(STEP_RADPS);
            if part > 0.1 {
                low_s.get_or_insert(since);
            }
            if part > 0.9 {
                high_s.get_or_insert(since);
            }
            peak = peak.max(part);
            for (sum, rate) in across.iter_mut().zip([lateral, yaw]) {
                *sum += rate * f64::from(dt_s);
                cross_rad = cross_rad.max(sum.abs());
            }
            if since > 0.25 {
                break;
            }
        }
        let input = RateInput {
            asked,
            next,
            measured: sample.rates_radps,
            thrust_mps2: 9.81,
            dt_s,
            ..RateInput::default()
        };
        let demand = Demand { thrust_mps2: 9.81, acceleration_radps2: rate.update(&config, &input) };
        let mixed = mix(&config, &demand);
        rate.limited(&mixed.saturation);
        let battery = Some(simulator.battery_v());
        let throttle = drive.throttles(&config, mixed.thrusts_n, battery, dt_s);
        simulator.apply(Command { throttle, rates_radps: next, thrust_mps2: 9.81 });
        asked = next;
    }
    let rise_s = high_s.unwrap_or(f64::INFINITY) - low_s.unwrap_or(0.0);
    StepResponse { rise_s, overshoot: peak - 1.0, cross_rad }
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

/// Prints the tables; run it with `--ignored --nocapture`.
#[test]
#[ignore = "a measurement, not a test"]
fn tables() {
    println!("maneuver      position m  velocity m/s  end angle rad  angle rms rad  out of plane rad");
    for (x, z) in [(5.0, 5.0), (0.0, 3.0), (-3.0, 4.0), (12.0, 0.0)] {
        let m = over_seeds(x, z);
        println!(
            "({x:4},{z:4})   {:10.3}  {:12.3}  {:13.4}  {:13.4}  {:16.4}",
            m.position_m, m.velocity_mps, m.end_angle_rad, m.angle_rms_rad, m.lateral_rad
        );
    }
    println!("axis of a step of 5 rad/s   rise ms  overshoot  across rad");
    for heading_rad in [0.0, 0.8, 1.57] {
        let r = step_response(1, heading_rad);
        println!("{heading_rad:24}    {:8.1}  {:9.3}  {:10.4}", r.rise_s * 1e3, r.overshoot, r.cross_rad);
    }
}

/// A step is followed within what the rotors allow, hardly swings over, and pulls no other axis with it: in a diagonal
/// plane too, where the body is no gyroscope only because its torque is known.
#[test]
fn a_step_is_followed_in_every_plane() {
    for seed in 1..=5 {
        for i in 0..12 {
            let r = step_response(seed, i as f32 * 0.55);
            assert!(r.rise_s < 0.040 && r.overshoot < 0.25, "{i}: {} s, {}", r.rise_s, r.overshoot);
            assert!(r.cross_rad < 0.04, "{i}: {} rad", r.cross_rad);
        }
    }
}

/// The vehicle stays near its plan on the average over seeds, figures with a tenth to spare.
#[test]
fn flights_stay_near_their_plans() {
    for ((x, z), position_m, end_angle_rad, angle_rms_rad, lateral_rad) in
        [((5.0, 5.0), 1.38, 0.11, 0.13, 0.028), ((0.0, 3.0), 0.40, 0.135, 0.115, 0.028)]
    {
        let m = over_seeds(x, z);
        assert!(m.position_m < position_m && m.end_angle_rad < end_angle_rad, "({x}, {z}): {m:?}");
        assert!(m.angle_rms_rad < angle_rms_rad && m.lateral_rad < lateral_rad, "({x}, {z}): {m:?}");
        assert!(m.velocity_mps < 1.8, "({x}, {z}): {m:?}");
    }
}

//! Scale calibration by turns made by hand, with the simulated gyro and its errors.

use mintime_firmware::calibration::{Axis, CalibrationError, ScaleCalibration};
use mintime_firmware::gyro::{Gyro, ImuSample as GyroSample};
use mintime_simulator::{Command, Event, ImuSample, Simulator, Start, VehicleParameters};
use nalgebra::{Quaternion, UnitQuaternion, Vector3};

/// How a hand turns a vehicle.
#[derive(Clone, Copy)]
struct Hand {
    axis: Axis,
    turns: f64,
    /// Time for the turns, s.
    turning_s: f64,
    /// Amplitude of the wobble about the two other axes, rad.
    wobble_rad: f64,
    /// Stands still for this long after half the way, to change the grip, s.
    pause_s: f64,
    /// Stands otherwise than at the start by this, as a rotation vector, rad.
    misplaced_rad: [f64; 3],
}

const HAND: Hand = Hand {
    axis: Axis::Up,
    turns: 4.0,
    turning_s: 12.0,
    wobble_rad: 0.05,
    pause_s: 0.0,
    misplaced_rad: [0.0; 3],
};

/// It stands still for this long at first, s.
const STILL_S: f64 = 1.0;

fn unit(axis: Axis) -> Vector3<f64> {
    match axis {
        Axis::Forward => Vector3::x(),
        Axis::Left => Vector3::y(),
        Axis::Up => Vector3::z(),
    }
}

impl Hand {
    /// The attitude at a time: still, turned with a smooth beginning and end, still.
    fn attitude(&self, t: f64) -> UnitQuaternion<f64> {
        let tau = std::f64::consts::TAU;
        let (t, half) = (t - STILL_S, 0.5 * self.turning_s);
        let moving = if t < half { t } else { (t - self.pause_s).max(half) };
        let part = (moving / self.turning_s).clamp(0.0, 1.0);
        // Each half begins and ends at rest.
        let ease = |p: f64| p - (tau * p).sin() / tau;
        let done = if part < 0.5 { 0.5 * ease(2.0 * part) } else { 0.5 + 0.5 * ease(2.0 * part - 1.0) };
        let about = |axis: Vector3<f64>, angle: f64| UnitQuaternion::from_scaled_axis(axis * angle);
        let along = unit(self.axis);
        let (a, b) = (Vector3::new(along.z, along.x, along.y), Vector3::new(along.y, along.z, along.x));
        about(a, (tau * done * 5.0).sin() * self.wobble_rad)
            * about(b, (tau * done * 7.0).sin() * self.wobble_rad)
            * about(along, self.turns * tau * done)
            * about(Vector3::from(self.misplaced_rad), done)
    }
}

/// A nominal gyro in a vehicle that does as the hand does: the planning model, which follows any rate.
fn held(parameters: &VehicleParameters, seed: u64) -> Simulator {
    let parameters = VehicleParameters { model: VehicleParameters::ideal().model, ..parameters.clone() };
    let start = Start { height_m: 1.0e5, ..Start::default() };
    Simulator::new(&parameters, seed, 0.0, start).expect("sound parameters")
}

fn follow(simulator: &mut Simulator, rates: Vector3<f64>) {
    let rates_radps = [rates.x as f32, rates.y as f32, rates.z as f32];
    simulator.apply(Command { throttle: [0.5; 4], rates_radps, thrust_mps2: 9.81 });
}

fn calibrate_with(
    seed: u64,
    hand: &Hand,
    turns: i8,
    spoil: impl Fn(f64, &mut ImuSample),
) -> Result<f32, CalibrationError> {
    let mut simulator = held(&VehicleParameters::nominal(), seed);
    let mut calibration = ScaleCalibration::start(hand.axis, turns)?;
    let (mut last_ns, mut interval_ns) = (0, 1_250_000);
    while simulator.now_ns() < 80_000_000_000 {
        let (now, event) = simulator.next_event().expect("sensors work");
        let Event::Gyro(mut sample) = event else { continue };
        if last_ns > 0 {
            interval_ns = now - last_ns;
        }
        let t = now as f64 * 1e-9;
        spoil(t, &mut sample);
        let dt_s = ((now - last_ns) as f64 * 1e-9) as f32;
        last_ns = now;
        let seen = Some(sample.rates_radps).filter(|rates| !rates[0].is_nan());
        if let Some(result) = calibration.update(seen, dt_s) {
            // Once, and never again.
            assert_eq!(calibration.update(seen, dt_s), None);
            return result;
        }
        // The rates that lead to where the hand is at the next sample.
        let [w, x, y, z] = simulator.truth().attitude;
        let here = UnitQuaternion::new_normalize(Quaternion::new(w, x, y, z));
        let dt = interval_ns as f64 * 1e-9;
        follow(&mut simulator, (here.inverse() * hand.attitude(t + dt)).scaled_axis() / dt);
    }
    panic!("no result");
}

fn calibrate(seed: u64, hand: &Hand, turns: i8) -> Result<f32, CalibrationError> {
    calibrate_with(seed, hand, turns, |_, _| {})
}

/// The scale that the simulator drew for an axis, by a noiseless gyro of the same seed mounted straight: half the
/// difference of its readings at ±10 rad/s.
fn drawn_scale(seed: u64, axis: Axis) -> f64 {
    let mut parameters = VehicleParameters::nominal();
    parameters.gyro.noise_density_radps = 0.0;
    parameters.imu.misalignment_rad = 0.0;
    parameters.imu.quantised = false;
    let mut simulator = held(&parameters, seed);
    let mut reading = |rate: f64| {
        follow(&mut simulator, unit(axis) * rate);
        let until = simulator.now_ns() + 200_000_000;
        let mut last = 0.0;
        while simulator.now_ns() < until {
            if let Some((_, Event::Gyro(sample))) = simulator.next_event() {
                last = Vector3::from(sample.rates_radps.map(f64::from)).dot(&unit(axis));
            }
        }
        last
    };
    (reading(10.0) - reading(-10.0)) / 20.0
}

/// Every axis and both directions: what is left of a scale error of up to 2 % is below 0.05 %.
#[test]
fn the_scale_is_found() {
    let (mut worst_before, mut worst) = (0.0f64, 0.0f64);
    for seed in 1..=8 {
        for axis in [Axis::Forward, Axis::Left, Axis::Up] {
            for turns in [4i8, -4] {
                let hand = Hand { axis, turns: f64::from(turns), ..HAND };
                let factor = f64::from(calibrate(seed, &hand, turns).expect("a scale"));
                let scale = drawn_scale(seed, axis);
                worst_before = worst_before.max((scale - 1.0).abs());
                worst = worst.max((scale * factor - 1.0).abs());
            }
        }
    }
    println!("scale error {worst_before:.5} before, {worst:.6} after");
    assert!(worst_before > 0.015 && worst < 5e-4, "{worst_before} {worst}");
}

/// Half a degree off the edge after four turns costs what geometry says, and no more.
#[test]
fn putting_it_back_is_what_limits_it() {
    let off = 0.5f64.to_radians();
    let askew = Hand { misplaced_rad: [off, -off, off], ..HAND };
    let (a, b) = (calibrate(3, &HAND, 4).expect("a scale"), calibrate(3, &askew, 4).expect("a scale"));
    let cost = f64::from(a / b) - 1.0;
    let geometry = off / (4.0 * std::f64::consts::TAU);
    assert!((cost - geometry).abs() < 1e-4, "{cost} for {geometry}");
    // Fewer turns, more error.
    let once = Hand { turns: 1.0, turning_s: 3.0, ..HAND };
    let factor = f64::from(calibrate(3, &once, 1).expect("a scale"));
    assert!((factor * drawn_scale(3, Axis::Up) - 1.0).abs() < 2e-3);
}

/// A change of grip at half the way is not taken for the end.
#[test]
fn a_pause_is_not_the_end() {
    let hand = Hand { pause_s: 3.0, ..HAND };
    let factor = f64::from(calibrate(5, &hand, 4).expect("a scale"));
    assert!((factor * drawn_scale(5, Axis::Up) - 1.0).abs() < 5e-4);
}

/// Every mistake has a name of its own.
#[test]
fn mistakes_are_refused() {
    use CalibrationError as E;
    let fails = |hand: Hand, turns, error| assert_eq!(calibrate(2, &hand, turns), Err(error));
    fails(Hand { turns: -4.0, ..HAND }, 4, E::WrongDirection);
    fails(Hand { turns: 5.0, ..HAND }, 4, E::TooFar);
    fails(Hand { turns: 3.0, ..HAND }, 4, E::TooSlow);
    fails(Hand { turning_s: 40.0, ..HAND }, 4, E::TooSlow);
    fails(Hand { turns: 0.0, wobble_rad: 0.0, ..HAND }, 4, E::NotTurned);
    fails(Hand { turning_s: 1.0, ..HAND }, 4, E::TooFast);
    fails(Hand { misplaced_rad: [0.2, 0.0, 0.0], ..HAND }, 4, E::Wobble);
    for turns in [0, 5, -5, i8::MIN, i8::MAX] {
        assert_eq!(ScaleCalibration::start(Axis::Up, turns).err(), Some(E::Turns));
    }
    // A hand that never lets go, a gyro that drifts, and one that is far off.
    let restless = |t: f64, s: &mut ImuSample| s.rates_radps[0] += 0.2 * (9.0 * t).sin() as f32;
    assert_eq!(calibrate_with(2, &HAND, 4, restless), Err(E::NotStill));
    let drifting = |t: f64, s: &mut ImuSample| s.rates_radps[2] += 3.0e-4 * t as f32;
    assert_eq!(calibrate_with(2, &HAND, 4, drifting), Err(E::BiasDrift));
    let far_off = |_: f64, s: &mut ImuSample| s.rates_radps[2] *= 1.065;
    assert!(matches!(calibrate_with(2, &HAND, 4, far_off), Err(E::Implausible | E::TooFar)));
}

/// A sample that is missing costs its time and no angle; where too many are the turn says nothing.
#[test]
fn lost_samples_are_bridged_or_end_it() {
    const PERIOD_S: f64 = 1.25e-3;
    // In the fastest part of the turns, so many at once and so often.
    let losing = |count: f64, every_s: f64| {
        move |t: f64, s: &mut ImuSample| {
            if (4.0..10.0).contains(&t) && t % every_s < count * PERIOD_S {
                s.rates_radps = [f32::NAN; 3];
            }
        }
    };
    let whole = calibrate(5, &HAND, 4).expect("a scale");
    let some = calibrate_with(5, &HAND, 4, losing(6.0, 0.1)).expect("a scale");
    assert!((some / whole - 1.0).abs() < 5e-5, "{some} for {whole}");
    assert_eq!(calibrate_with(5, &HAND, 4, losing(10.0, 3.0)), Err(CalibrationError::SamplesLost));
}

/// A gyro that stands off by more than 5 % is refused, also where the end of the turn is still recognised as such.
#[test]
fn an_implausible_scale_is_refused() {
    for (believed, plausible) in [(0.9510, false), (0.9530, true), (1.0520, true), (1.0540, false)] {
        let mut calibration = ScaleCalibration::start(Axis::Up, 1).expect("a turn");
        let dt_s = 1.25e-3;
        let rate_radps = std::f32::consts::TAU * believed / (1000.0 * dt_s);
        let rates = [0.0; 500].into_iter().chain([rate_radps; 1000]).chain([0.0; 1600]);
        let result = rates.filter_map(|rate| calibration.update(Some([0.0, 0.0, rate]), dt_s)).next();
        let result = result.expect("it comes to its end");
        if plausible {
            let factor = result.expect("a scale");
            assert!((factor - 1.0 / believed).abs() < 0.01, "{believed}: {factor}");
        } else {
            assert_eq!(result, Err(CalibrationError::Implausible), "{believed}");
        }
    }
}

/// Samples and times that are no numbers change nothing, not even how long is waited.
#[test]
fn nonsense_changes_nothing() {
    let start = || ScaleCalibration::start(Axis::Up, 1).expect("a turn");
    let (nan, endless) = (f32::NAN, f32::INFINITY);
    for (rate_radps, dt_s) in
        [(nan, 0.0), (endless, 0.0), (-endless, 0.0), (0.0, nan), (0.0, endless), (0.0, -1.0)]
    {
        let (mut calibration, mut clean) = (start(), start());
        let mut ends = 0;
        for step in 0..20_000 {
            if step % 1000 == 0 {
                assert_eq!(calibration.update(Some([rate_radps, 0.0, 0.0]), dt_s), None);
            }
            let result = clean.update(Some([0.001, 0.0, 0.0]), 1.25e-3);
            assert_eq!(
                calibration.update(Some([0.001, 0.0, 0.0]), 1.25e-3),
                result,
                "{rate_radps} {dt_s} {step}"
            );
            assert_eq!(calibration.may_turn(), clean.may_turn());
            ends += u32::from(result == Some(Err(CalibrationError::NotTurned)));
        }
        assert_eq!(ends, 1);
    }
}

/// Whoever took long to put it down has as long as anybody to turn it.
#[test]
fn each_wait_has_its_own_time() {
    let mut calibration = ScaleCalibration::start(Axis::Up, 1).expect("a turn");
    let dt_s = 1.25e-3;
    for step in 0..12_000 {
        let restless = if step % 2 == 0 { 0.2 } else { -0.2 };
        assert_eq!(calibration.update(Some([restless, 0.0, 0.0]), dt_s), None);
    }
    let mut update = |_: &u32| calibration.update(Some([0.001, 0.0, 0.0]), dt_s);
    assert_eq!((0..400).filter_map(|step| update(&step)).count(), 0);
    let waited = (1..20_000).find(|step| update(step) == Some(Err(CalibrationError::NotTurned)));
    assert!(waited.is_some_and(|steps| steps.abs_diff(16_000) < 20), "{waited:?}");
}

/// The gyro multiplies by a credible scale and by no other.
#[test]
fn the_gyro_applies_the_scale() {
    let mut gyro = Gyro::new();
    let sample = GyroSample { gyro_radps: [1.0, -2.0, 3.0], accel_mps2: [0.0; 3] };
    assert!(gyro.set_scale([1.02, 0.98, 1.0]));
    for bad in [1.06, 0.9, 0.0, f32::NAN, f32::INFINITY] {
        assert!(!gyro.set_scale([1.0, bad, 1.0]));
    }
    gyro.update(Some(&sample), [0.0; 3], false);
    assert_eq!(gyro.rates_radps(), [1.02, -1.96, 3.0]);
}

//! Which poses are believed.

use nalgebra::{Quaternion, UnitQuaternion, Vector3};

use super::clock::CaptureClock;
use super::error::CaptureError;
use super::sample::CaptureSample;
use crate::flight::Pose;

/// Without an accepted pose for this long there is no motion capture, s.
pub const STALE_S: f64 = 0.1;
/// The very same pose for this long, in the air, is not a measurement, s: cameras have noise and vehicles move.
const FROZEN_S: f64 = 0.1;
/// No vehicle is faster, m/s ...
const FASTEST_MPS: f64 = 30.0;
/// ... but for noise, m.
const POSITION_NOISE_M: f64 = 0.02;
/// No vehicle turns faster, rad/s: its own gyro ends at 35 ...
const FASTEST_RADPS: f64 = 50.0;
/// ... but for noise, rad.
const ATTITUDE_NOISE_RAD: f64 = 0.05;
/// On the ground, a capture whose clock went back by more was restarted, s.
const RESTART_S: f64 = 0.5;

/// A box in the capture's frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Volume {
    /// Least and greatest x, y and z, m.
    pub range_m: [(f64, f64); 3],
}

impl Volume {
    fn check(&self, position_m: [f64; 3]) -> Result<(), CaptureError> {
        for ((axis, value_m), (least_m, most_m)) in
            ['x', 'y', 'z'].into_iter().zip(position_m).zip(self.range_m)
        {
            if !(least_m..=most_m).contains(&value_m) {
                return Err(CaptureError::OutsideRoom { axis, value_m, least_m, most_m });
            }
        }
        Ok(())
    }
}

/// Judges samples one by one.
#[derive(Debug)]
pub struct Monitor {
    clock: CaptureClock,
    latency_s: f64,
    room: Option<Volume>,
    /// The body that flies; the first one seen where none was named.
    name: Option<String>,
    chosen: bool,
    last: Option<CaptureSample>,
    /// When the last pose was accepted, and when it last differed from the one before, on the host's clock, s.
    accepted_s: f64,
    changed_s: f64,
    /// Why the samples since then were not.
    trouble: Option<CaptureError>,
    refused: u64,
}

impl Monitor {
    /// `name` is the body that flies, if it has to be told from others; `began_s` is now on the host's clock.
    pub fn new(name: Option<String>, room: Option<Volume>, latency_s: f64, began_s: f64) -> Self {
        Self {
            clock: CaptureClock::new(latency_s),
            latency_s,
            room,
            chosen: name.is_some(),
            name,
            last: None,
            accepted_s: began_s,
            changed_s: began_s,
            trouble: None,
            refused: 0,
        }
    }

    /// Where the body may be from now on.
    pub fn confine(&mut self, room: Volume) {
        self.room = Some(room);
    }

    /// Samples that were not believed.
    pub fn refused(&self) -> u64 {
        self.refused
    }

    /// Whether, and why, there is no motion capture at this time.
    pub fn trouble(&self, now_s: f64) -> Option<CaptureError> {
        let silent_s = now_s - self.accepted_s;
        (silent_s > STALE_S).then(|| self.trouble.clone().unwrap_or(CaptureError::Stale { silent_s }))
    }

    /// Notes a line that was no sample.
    pub fn refuse(&mut self, error: CaptureError) {
        self.refused += 1;
        self.trouble = Some(error);
    }

    /// Judges one sample. `None` for one of another body.
    ///
    /// # Errors
    /// [`CaptureError`]: not to be flown with.
    pub fn accept(
        &mut self,
        sample: CaptureSample,
        arrived_s: f64,
        flying: bool,
    ) -> Result<Option<Pose>, CaptureError> {
        match self.judge(&sample, arrived_s, flying) {
            Ok(true) => Ok(Some(self.take(sample, arrived_s))),
            Ok(false) => Ok(None),
            Err(error) => {
                self.refuse(error.clone());
                Err(error)
            }
        }
    }

    /// Whether it is a sample of the vehicle.
    fn judge(&mut self, sample: &CaptureSample, arrived_s: f64, flying: bool) -> Result<bool, CaptureError> {
        if self.name != sample.name {
            match (&self.name, &sample.name) {
                _ if self.chosen => return Ok(false),
                (Some(first), second) if self.last.is_some() => {
                    let second = second.clone().unwrap_or_default();
                    return Err(CaptureError::SeveralBodies { first: first.clone(), second });
                }
                (None, Some(second)) if self.last.is_some() => {
                    return Err(CaptureError::SeveralBodies { first: String::new(), second: second.clone() });
                }
                _ => self.name.clone_from(&sample.name),
            }
        }
        if let Some(last) = &self.last {
            let interval_s = sample.t_s - last.t_s;
            if !flying && interval_s < -RESTART_S {
                self.last = None;
                self.clock = CaptureClock::new(self.latency_s);
            } else if interval_s <= 0.0 {
                return Err(CaptureError::Backwards { before_s: last.t_s, after_s: sample.t_s });
            } else {
                jump(last, sample, interval_s)?;
                let same = last.position_m == sample.position_m && last.attitude_wxyz == sample.attitude_wxyz;
                let frozen_s = arrived_s - self.changed_s;
                if flying && same && frozen_s > FROZEN_S {
                    return Err(CaptureError::Frozen { frozen_s });
                }
                if !same || !flying {
                    self.changed_s = arrived_s;
                }
            }
        }
        if let Some(room) = &self.room {
            room.check(sample.position_m)?;
        }
        Ok(true)
    }

    fn take(&mut self, sample: CaptureSample, arrived_s: f64) -> Pose {
        let captured_s = self.clock.captured_s(sample.t_s, arrived_s);
        let pose = Pose {
            captured_s,
            arrived_s,
            position_m: Vector3::from(sample.position_m),
            attitude: rotation(&sample),
        };
        self.accepted_s = arrived_s;
        self.trouble = None;
        if self.last.is_none() {
            self.changed_s = arrived_s;
        }
        self.last = Some(sample);
        pose
    }
}

fn rotation(sample: &CaptureSample) -> UnitQuaternion<f64> {
    let [w, x, y, z] = sample.attitude_wxyz;
    UnitQuaternion::from_quaternion(Quaternion::new(w, x, y, z))
}

/// Refuses what no vehicle does.
fn jump(last: &CaptureSample, next: &CaptureSample, interval_s: f64) -> Result<(), CaptureError> {
    let distance_m = (Vector3::from(next.position_m) - Vector3::from(last.position_m)).norm();
    if distance_m > FASTEST_MPS * interval_s + POSITION_NOISE_M {
        return Err(CaptureError::PositionJump { distance_m, interval_s });
    }
    let angle_rad = rotation(last).angle_to(&rotation(next));
    if angle_rad > FASTEST_RADPS * interval_s + ATTITUDE_NOISE_RAD {
        return Err(CaptureError::AttitudeJump { angle_rad, interval_s });
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn sample(t_s: f64, x_m: f64) -> CaptureSample {
        CaptureSample { t_s, position_m: [x_m, 0.0, 1.0], attitude_wxyz: [1.0, 0.0, 0.0, 0.0], name: None }
    }

    fn monitor() -> Monitor {
        let room = Volume { range_m: [(-3.0, 3.0), (-2.0, 2.0), (0.0, 4.0)] };
        Monitor::new(None, Some(room), 0.0, 0.0)
    }

    #[test]
    fn a_flight_that_can_be_is_believed() {
        let mut monitor = monitor();
        for i in 0..400 {
            let t = f64::from(i) * 0.005;
            let pose = monitor.accept(sample(t + 77.0, (5.0 * t).sin()), t, true).expect("believed");
            assert!((pose.expect("this body").captured_s - t).abs() < 1e-6);
        }
        assert_eq!((monitor.refused(), monitor.trouble(2.09)), (0, None));
        assert!(matches!(monitor.trouble(2.2), Some(CaptureError::Stale { .. })));
    }

    #[test]
    fn each_fault_has_its_name() {
        let flown = |first: CaptureSample, second: CaptureSample| {
            let mut monitor = monitor();
            monitor.accept(first, 0.0, true).expect("the first one");
            let error = monitor.accept(second, 0.005, true).expect_err("a fault");
            assert_eq!(monitor.trouble(0.05), None, "one sample is not yet the end");
            assert_eq!(monitor.trouble(0.11), Some(error.clone()));
            error
        };
        assert!(matches!(flown(sample(1.0, 0.0), sample(1.0, 0.0)), CaptureError::Backwards { .. }));
        assert!(matches!(flown(sample(1.0, 0.0), sample(0.2, 0.0)), CaptureError::Backwards { .. }));
        assert!(matches!(flown(sample(1.0, 0.0), sample(1.005, 0.5)), CaptureError::PositionJump { .. }));
        let turned = CaptureSample { attitude_wxyz: [0.0, 1.0, 0.0, 0.0], ..sample(1.005, 0.0) };
        assert!(matches!(flown(sample(1.0, 0.0), turned), CaptureError::AttitudeJump { .. }));
        let named = |t, name: &str| CaptureSample { name: Some(name.into()), ..sample(t, 0.0) };
        assert!(matches!(flown(named(1.0, "a"), named(1.005, "b")), CaptureError::SeveralBodies { .. }));
        assert!(matches!(
            flown(sample(1.0, 2.95), sample(1.005, 3.05)),
            CaptureError::OutsideRoom { axis: 'x', .. }
        ));
    }

    #[test]
    fn a_pose_that_stands_still_is_one_on_the_ground_only() {
        let mut monitor = monitor();
        for i in 0..100 {
            let t = f64::from(i) * 0.005;
            monitor.accept(sample(t, 0.0), t, false).expect("it stands");
        }
        let mut error = None;
        for i in 100..140 {
            let t = f64::from(i) * 0.005;
            error = monitor.accept(sample(t, 0.0), t, true).err().or(error);
        }
        assert!(matches!(error, Some(CaptureError::Frozen { .. })), "{error:?}");
    }

    #[test]
    fn on_the_ground_a_restarted_capture_is_taken_up_again() {
        let mut monitor = monitor();
        monitor.accept(sample(1000.0, 0.0), 0.0, false).expect("first");
        let pose = monitor.accept(sample(3.0, 1.0), 5.0, false).expect("restarted").expect("this body");
        assert!((pose.captured_s - 5.0).abs() < 1e-9);
    }

    #[test]
    fn the_named_body_is_picked_out() {
        let mut monitor = Monitor::new(Some("quad".into()), None, 0.0, 0.0);
        let named = |t, name: &str| CaptureSample { name: Some(name.into()), ..sample(t, 0.0) };
        assert_eq!(monitor.accept(named(1.0, "wand"), 0.0, true), Ok(None));
        assert!(monitor.accept(named(1.0, "quad"), 0.0, true).expect("believed").is_some());
        assert_eq!(monitor.accept(named(1.0, "wand"), 0.0, true), Ok(None));
    }

    proptest! {
        #[test]
        fn whatever_comes_accepted_poses_are_ordered_slow_and_inside(
            steps in proptest::collection::vec((-0.02..0.05f64, -3.5..3.5f64, -1.0..1.0f64), 1..200),
        ) {
            let mut monitor = monitor();
            let (mut t, mut last): (f64, Option<(f64, f64)>) = (0.0, None);
            for (i, (step, x, q)) in steps.into_iter().enumerate() {
                t += step;
                let attitude_wxyz = [(1.0 - q * q).sqrt(), q, 0.0, 0.0];
                let s = CaptureSample { attitude_wxyz, ..sample(t, x) };
                if let Ok(Some(pose)) = monitor.accept(s, i as f64 * 0.005, true) {
                    let x = pose.position_m.x;
                    prop_assert!((-3.0..=3.0).contains(&x));
                    if let Some((before, at)) = last {
                        prop_assert!(t > before);
                        prop_assert!((x - at).abs() <= 30.0 * (t - before) + 0.021);
                    }
                    last = Some((t, x));
                }
            }
        }
    }
}

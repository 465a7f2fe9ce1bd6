//! The gyro's scale, learned by turning the vehicle by hand.
//!
//! A gyro's scale is off by up to 2 %, which a flip turns into 7° of attitude. Standing still says nothing about it; a
//! whole number of turns does: the vehicle ends as it began, so whatever turn the gyro believes is left is its error.
//!
//! The turn is integrated as a rotation and not as a sum of rates, so that a hand that wobbles, or a sensor mounted not
//! quite straight, costs next to nothing: only what is left *about the axis* at the end counts. What limits the
//! accuracy is how well the vehicle is put back: half a degree after four turns is 0.035 %. The bias is measured at both
//! ends; its noise adds 0.01 %.
//!
//! While the motors are off only. Work per sample: that of the attitude estimate, no trigonometry but at the end.

pub use mintime_shared::messages::CalibrationError;

use crate::attitude::{Rotation, turn_between};
use crate::config::GYRO_SATURATION_RADPS;
use crate::config::control::{
    SCALE_BIAS_DRIFT_RADPS, SCALE_ERROR_MAX, SCALE_GAP_MAX_S, SCALE_MOTION_RAD, SCALE_TURNING_MAX_S,
    SCALE_TURNS_MAX, SCALE_WAITING_MAX_S, SCALE_WOBBLE_RAD,
};
use crate::gyro::StillWindow;

/// A body axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axis {
    /// Forward: roll.
    Forward,
    /// Left: pitch.
    Left,
    /// Up: yaw.
    Up,
}

impl Axis {
    /// The component along the axis, and the two others.
    fn split(self, [x, y, z]: [f32; 3]) -> (f32, [f32; 2]) {
        match self {
            Self::Forward => (x, [y, z]),
            Self::Left => (y, [z, x]),
            Self::Up => (z, [x, y]),
        }
    }
}

#[derive(Clone, Copy, Debug)]
enum Phase {
    /// Until it has stood still for a window.
    Before,
    /// From then until it stands still again at the end.
    Turning { bias_radps: [f32; 3], rotation: Rotation, angle_rad: f32, last_radps: [f32; 3], moved: bool },
    /// Over, either way.
    Over,
}

/// A scale calibration under way.
#[derive(Clone, Copy, Debug)]
pub struct ScaleCalibration {
    axis: Axis,
    /// Whole turns, with their sense, rad.
    goal_rad: f32,
    phase: Phase,
    window: StillWindow,
    /// Since the last sample.
    unseen_s: f32,
    in_phase_s: f32,
    /// Since the first motion.
    turning_s: f32,
    /// It has stood still near the goal for a window.
    settled: bool,
}

impl ScaleCalibration {
    /// Begins: the vehicle stands still, and will be turned by `turns` whole turns about `axis`, right-handed where
    /// positive, then stand still as it stood before.
    ///
    /// # Errors
    /// [`CalibrationError::Turns`].
    pub fn start(axis: Axis, turns: i8) -> Result<Self, CalibrationError> {
        if turns == 0 || turns.unsigned_abs() > SCALE_TURNS_MAX {
            return Err(CalibrationError::Turns);
        }
        Ok(Self {
            axis,
            goal_rad: f32::from(turns) * core::f32::consts::TAU,
            phase: Phase::Before,
            window: StillWindow::EMPTY,
            unseen_s: 0.0,
            in_phase_s: 0.0,
            turning_s: 0.0,
            settled: false,
        })
    }

    /// Takes a tick's sample, the rates as the sensor gives them, rad/s, neither bias nor scale corrected; or its absence. `dt_s`
    /// is the time since the tick before. Returns the factor by which the axis' rates are to be multiplied, once. A sample that
    /// is no number is none; a time that is none changes nothing.
    pub fn update(
        &mut self,
        raw_radps: Option<[f32; 3]>,
        dt_s: f32,
    ) -> Option<Result<f32, CalibrationError>> {
        if !(dt_s >= 0.0 && dt_s.is_finite()) {
            return None;
        }
        self.unseen_s += dt_s;
        let raw_radps = raw_radps.filter(|raw| raw.iter().all(|r| r.is_finite()))?;
        let dt_s = core::mem::take(&mut self.unseen_s);
        self.in_phase_s += dt_s;
        let result = match self.phase {
            Phase::Before => self.wait(raw_radps),
            Phase::Turning { .. } => self.turn(raw_radps, dt_s),
            Phase::Over => None,
        };
        if result.is_some() {
            self.phase = Phase::Over;
        }
        result
    }

    /// Whether the vehicle may be turned now.
    pub fn may_turn(&self) -> bool {
        matches!(self.phase, Phase::Turning { .. })
    }

    fn wait(&mut self, raw_radps: [f32; 3]) -> Option<Result<f32, CalibrationError>> {
        if let Some(Ok(bias_radps)) = self.window.take(raw_radps) {
            self.phase = Phase::Turning {
                bias_radps,
                rotation: Rotation::IDENTITY,
                angle_rad: 0.0,
                last_radps: [0.0; 3],
                moved: false,
            };
            self.in_phase_s = 0.0;
            return None;
        }
        (self.in_phase_s > SCALE_WAITING_MAX_S).then_some(Err(CalibrationError::NotStill))
    }

    fn turn(&mut self, raw_radps: [f32; 3], dt_s: f32) -> Option<Result<f32, CalibrationError>> {
        use CalibrationError as E;
        let Phase::Turning { bias_radps, rotation, angle_rad, last_radps, moved } = &mut self.phase else {
            return None;
        };
        if dt_s > SCALE_GAP_MAX_S {
            return Some(Err(E::SamplesLost));
        }
        if raw_radps.iter().any(|r| r.abs() >= GYRO_SATURATION_RADPS) {
            return Some(Err(E::TooFast));
        }
        let mut rates = raw_radps;
        for (rate, bias) in rates.iter_mut().zip(*bias_radps) {
            *rate -= bias;
        }
        let turn = turn_between(*last_radps, rates, dt_s);
        *last_radps = rates;
        *rotation = rotation.turned(turn);
        *angle_rad += self.axis.split(turn).0;
        let sense = if self.goal_rad < 0.0 { -1.0 } else { 1.0 };
        let (turned, goal) = (*angle_rad * sense, self.goal_rad * sense);
        if turned < -SCALE_MOTION_RAD {
            return Some(Err(E::WrongDirection));
        }
        *moved |= turned > SCALE_MOTION_RAD;
        if !*moved {
            return (self.in_phase_s > SCALE_WAITING_MAX_S).then_some(Err(E::NotTurned));
        }
        self.turning_s += dt_s;
        if self.turning_s > SCALE_TURNING_MAX_S {
            return Some(Err(E::TooSlow));
        }
        if turned > goal * (1.0 + SCALE_ERROR_MAX) + SCALE_MOTION_RAD {
            return Some(Err(E::TooFar));
        }
        // A hand that changes its grip stands still as well: only near the goal is it the end. And only the second window:
        // the first may hold the last slow degrees of the turn.
        let bias_after = match self.window.take(raw_radps) {
            Some(Ok(mean)) if turned >= goal * (1.0 - SCALE_ERROR_MAX) => mean,
            Some(_) => {
                self.settled = false;
                return None;
            }
            None => return None,
        };
        if !core::mem::replace(&mut self.settled, true) {
            return None;
        }
        let (vector, before) = (rotation.vector(), *bias_radps);
        Some(self.conclude(vector, before, bias_after))
    }

    /// The factor, from the turn that the gyro believes is left at the end.
    fn conclude(
        &self,
        left_rad: [f32; 3],
        before: [f32; 3],
        after: [f32; 3],
    ) -> Result<f32, CalibrationError> {
        use CalibrationError as E;
        let mut drift = after;
        for (drift, before) in drift.iter_mut().zip(before) {
            *drift -= before;
        }
        if drift.iter().any(|d| d.abs() > SCALE_BIAS_DRIFT_RADPS) {
            return Err(E::BiasDrift);
        }
        let (left, across) = self.axis.split(left_rad);
        if across.iter().any(|a| a.abs() > SCALE_WOBBLE_RAD) {
            return Err(E::Wobble);
        }
        // The bias grew by half its drift on the average over the time integrated.
        let left = left - 0.5 * self.axis.split(drift).0 * self.in_phase_s;
        let factor = self.goal_rad / (self.goal_rad + left);
        // Written so that what is not a number fails.
        if (factor - 1.0).abs() <= SCALE_ERROR_MAX { Ok(factor) } else { Err(E::Implausible) }
    }
}

//! What all readers share: samples one by one, checked as they come.

use nalgebra::{Quaternion, UnitQuaternion, Vector3};

use super::flight::{Flight, Remark, Sample, derive_velocities};
use super::read_error::ReadError;

/// Largest position, m, and speed, m/s, that are taken for a flight's.
const BEYOND: f64 = 1e5;
/// How far a quaternion's length may be from 1: logs round to three decimals.
const UNIT_TOLERANCE: f64 = 0.01;

/// A vehicle's attitude as logs write it.
#[derive(Clone, Copy, Debug)]
pub(super) enum Attitude {
    /// Pitch in the x-z plane, rad.
    Pitch(f64),
    /// Body to world, (w, x, y, z).
    Quaternion([f64; 4]),
}

/// A flight as it is being read.
#[derive(Default)]
pub(super) struct Builder {
    samples: Vec<Sample>,
    velocities_missing: bool,
}

impl Builder {
    /// Adds a sample; `place` names it in an error. All numbers must be finite.
    pub(super) fn push(
        &mut self,
        place: impl Fn() -> String,
        t_s: f64,
        position_m: [f64; 3],
        velocity_mps: Option<[f64; 3]>,
        attitude: Attitude,
    ) -> Result<(), ReadError> {
        if let Some(last) = self.samples.last()
            && t_s <= last.t_s
        {
            return Err(ReadError::Order { place: place(), before_s: last.t_s, now_s: t_s });
        }
        let beyond = |values: &[f64]| values.iter().any(|v| v.abs() > BEYOND);
        if beyond(&position_m) {
            return Err(ReadError::Beyond { place: place(), what: "the position" });
        }
        if velocity_mps.is_some_and(|v| beyond(&v)) {
            return Err(ReadError::Beyond { place: place(), what: "the velocity" });
        }
        let thrust_axis = match attitude {
            Attitude::Pitch(theta) => {
                let (sin, cos) = theta.sin_cos();
                Vector3::new(sin, 0.0, cos)
            }
            Attitude::Quaternion([w, x, y, z]) => {
                let attitude = Quaternion::new(w, x, y, z);
                let length = attitude.norm();
                if (length - 1.0).abs() > UNIT_TOLERANCE {
                    return Err(ReadError::NotAUnit { place: place(), length });
                }
                UnitQuaternion::new_normalize(attitude) * Vector3::z()
            }
        };
        self.velocities_missing |= velocity_mps.is_none();
        let velocity_mps = Vector3::from(velocity_mps.unwrap_or_default());
        self.samples.push(Sample { t_s, position_m: position_m.into(), velocity_mps, thrust_axis });
        Ok(())
    }

    /// How many samples there are.
    pub(super) fn len(&self) -> usize {
        self.samples.len()
    }

    /// Takes samples back from the end, down to a number of them.
    pub(super) fn truncate(&mut self, samples: usize) {
        self.samples.truncate(samples);
    }

    /// The last time read, s.
    pub(super) fn last_s(&self) -> f64 {
        self.samples.last().map_or(0.0, |s| s.t_s)
    }

    /// The flight. Velocities are derived for all samples if one had none.
    pub(super) fn finish(mut self, mut remarks: Vec<Remark>) -> Result<Flight, ReadError> {
        if self.velocities_missing && self.samples.len() >= 2 {
            derive_velocities(&mut self.samples);
            remarks.push(Remark::VelocitiesDerived);
        }
        match self.samples.len() {
            0 => Err(ReadError::Empty),
            few => {
                let flight = Flight::new(self.samples).ok_or(ReadError::TooShort(few))?;
                Ok(Flight { remarks, ..flight })
            }
        }
    }
}

//! The 2,000 seeded random requests that the solver is measured on, in classes. Seed and ranges were fixed before the
//! solver was tuned; changing them would make its figures incomparable.

use core::f64::consts::PI;

use mintime::solver::{Request, Turns};
use mintime_shared::model::{GRAVITY_MPS2, Limits, State};

/// The seed of [`requests`].
pub(crate) const SEED: u64 = 20_261_122;

/// What kind of request.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Class {
    /// At rest and level at both ends, ±15 m × ±10 m.
    RestToRest,
    /// Any velocity (±6 m/s) and angle (±π) at both ends.
    Moving,
    /// Random limits, half of them at rest.
    Limits,
    /// Displacements of a centimetre.
    Tiny,
    /// Straight up or down.
    Vertical,
    /// Straight to the side.
    Horizontal,
    /// Start or end upside down.
    UpsideDown,
}

/// All classes and how many requests of each.
pub(crate) const CLASSES: [(Class, usize); 7] = [
    (Class::RestToRest, 500),
    (Class::Moving, 500),
    (Class::Limits, 400),
    (Class::Tiny, 150),
    (Class::Vertical, 100),
    (Class::Horizontal, 100),
    (Class::UpsideDown, 250),
];

/// SplitMix64 (Steele, Lea, Flood 2014): tiny, and the same everywhere.
pub(crate) struct Random(u64);

impl Random {
    /// From a seed.
    pub(crate) fn new(seed: u64) -> Self {
        Self(seed)
    }

    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    /// Uniform between two numbers.
    pub(crate) fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * (self.next() >> 11) as f64 / (1u64 << 53) as f64
    }

    fn moving(&mut self, x: f64, z: f64) -> State<f64> {
        State {
            x: self.between(-x, x),
            vx: self.between(-6.0, 6.0),
            z: self.between(-z, z),
            vz: self.between(-6.0, 6.0),
            theta: self.between(-PI, PI),
        }
    }

    fn request(&mut self, class: Class) -> Request {
        let mut request = Request {
            from: State::origin(),
            to: State::origin(),
            limits: Limits::TABLE_I,
            turns: Turns::Any,
        };
        match class {
            Class::RestToRest => {
                request.to = State::at_rest(self.between(-15.0, 15.0), self.between(-10.0, 10.0));
            }
            Class::Moving => {
                request.from = State { x: 0.0, z: 0.0, ..self.moving(0.0, 0.0) };
                request.to = self.moving(10.0, 8.0);
            }
            Class::Limits => {
                request.limits = Limits {
                    thrust_min_mps2: self.between(0.2, 6.0),
                    thrust_max_mps2: self.between(11.5, 45.0),
                    rate_max_radps: self.between(3.0, 25.0),
                    gravity_mps2: GRAVITY_MPS2,
                };
                if self.between(0.0, 1.0) < 0.5 {
                    request.to = State::at_rest(self.between(-15.0, 15.0), self.between(-10.0, 10.0));
                } else {
                    request.from = State { x: 0.0, z: 0.0, ..self.moving(0.0, 0.0) };
                    request.to = self.moving(10.0, 8.0);
                }
            }
            Class::Tiny => {
                let direction = self.between(-PI, PI);
                request.to = State::at_rest(0.01 * direction.sin(), 0.01 * direction.cos());
            }
            Class::Vertical => request.to = State::at_rest(0.0, self.between(-10.0, 10.0)),
            Class::Horizontal => request.to = State::at_rest(self.between(-15.0, 15.0), 0.0),
            Class::UpsideDown => {
                request.to = State::at_rest(self.between(-5.0, 5.0), self.between(-5.0, 5.0));
                let which = self.between(0.0, 3.0);
                if which < 2.0 {
                    request.from.theta = PI;
                }
                if which > 1.0 {
                    request.to.theta = PI;
                }
            }
        }
        request
    }
}

/// All requests, class by class.
pub(crate) fn requests() -> Vec<(Class, Request)> {
    let mut random = Random::new(SEED);
    CLASSES
        .iter()
        .flat_map(|&(class, count)| core::iter::repeat_n(class, count))
        .map(|class| (class, random.request(class)))
        .collect()
}

//! What a vehicle flies that nobody flies: upright, then down, for a bounded time.
//!
//! It turns upright by its own attitude estimate and sinks. How fast it sinks is not left to the thrust map, which may be
//! a tenth off: the accelerometer measures thrust per mass whatever the tilt, so the thrust asked for is adjusted until
//! the specific force is what was meant. Where less and less thrust leaves the specific force as it is, something else
//! carries the vehicle: it stands. At the beginning the rotors still turn as before: their thrust says nothing yet.
//!
//! A vehicle that was never asked to lift since it was armed stands on the ground: it gets no more thrust than it was asked
//! for, until it is seen to stand.

use mintime_shared::messages::Setpoint;
use mintime_shared::model::GRAVITY_MPS2;
use mintime_shared::real::{at_least, at_most};

use crate::config::{
    RECOVERY_FORCE, RECOVERY_GAIN_PER_S, RECOVERY_LOW_THRUST_MPS2, RECOVERY_RANGE, RECOVERY_SETTLES_S,
    RECOVERY_STANDS, RECOVERY_STANDS_S, RECOVERY_START, RECOVERY_UPRIGHT_COS,
};

/// A recovery under way.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Recovery {
    /// Thrust asked for, m/s², before its bounds.
    thrust_mps2: f32,
    /// The host's last thrust, m/s².
    asked_mps2: f32,
    /// It has been asked to lift since it was armed. If not it stands on the ground, and shall go on standing there.
    lifted: bool,
    /// Until the rotors have settled, s.
    settles_s: f32,
    /// For how long so little thrust has been enough, s.
    stands_s: f32,
}

impl Recovery {
    /// Specific force to sink with, m/s².
    const TARGET_MPS2: f32 = RECOVERY_FORCE * GRAVITY_MPS2 as f32;

    pub(crate) const fn new() -> Self {
        Self { thrust_mps2: 0.0, asked_mps2: 0.0, lifted: false, settles_s: 0.0, stands_s: 0.0 }
    }

    /// Begins. `asked_mps2` is what the host asked for last: in the air little of it may have been for a moment only, so no
    /// more than the beginning depends on it; of a vehicle that was never asked to lift (`lifted`) it is all that it gets.
    pub(crate) fn start(&mut self, asked_mps2: f32, lifted: bool) {
        let low = RECOVERY_START * Self::TARGET_MPS2;
        *self = Self {
            thrust_mps2: at_most(at_least(asked_mps2, low), Self::TARGET_MPS2),
            asked_mps2,
            lifted,
            settles_s: RECOVERY_SETTLES_S,
            stands_s: 0.0,
        };
    }

    /// What to fly until the next tick. `up` is the cosine of the tilt, `level_radps` the rates that right the vehicle,
    /// `force_mps2` the specific force along its up axis where it is known, finite.
    #[inline(never)]
    pub(crate) fn command(
        &mut self,
        up: f32,
        level_radps: [f32; 3],
        force_mps2: Option<f32>,
        dt_s: f32,
    ) -> Setpoint {
        // What stands on the ground and leans is not righted there: that would tip it.
        let level_radps = if self.lifted { level_radps } else { [0.0; 3] };
        if up < RECOVERY_UPRIGHT_COS {
            // Thrust would push it aside, or down. What lies on the ground gets none.
            let thrust_mps2 = at_most(RECOVERY_LOW_THRUST_MPS2, self.asked_mps2);
            self.settles_s = RECOVERY_SETTLES_S;
            self.stands_s = 0.0;
            return Setpoint { rates_radps: level_radps, thrust_mps2 };
        }
        let (low, high) = RECOVERY_RANGE;
        if self.settles_s > 0.0 {
            self.settles_s -= dt_s;
        } else if let Some(force) = force_mps2 {
            self.thrust_mps2 -= RECOVERY_GAIN_PER_S * dt_s * (force - Self::TARGET_MPS2);
            self.thrust_mps2 =
                at_most(at_least(self.thrust_mps2, low * Self::TARGET_MPS2), high * Self::TARGET_MPS2);
            let little = self.thrust_mps2 <= RECOVERY_STANDS * Self::TARGET_MPS2;
            self.stands_s = if little { self.stands_s + dt_s } else { 0.0 };
        }
        // Where it leans, its weight needs more.
        let thrust_mps2 = self.thrust_mps2 / at_least(up, RECOVERY_UPRIGHT_COS);
        let bound_mps2 =
            if self.lifted { at_least(self.asked_mps2, high * Self::TARGET_MPS2) } else { self.asked_mps2 };
        Setpoint { rates_radps: level_radps, thrust_mps2: at_most(thrust_mps2, bound_mps2) }
    }

    /// Whether it stands.
    pub(crate) fn stands(&self) -> bool {
        self.stands_s >= RECOVERY_STANDS_S
    }
}

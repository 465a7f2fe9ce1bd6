//! Plays a maneuver: the replay's commands, and a watch over whether the vehicle follows them.

use mintime_shared::replay::{Command, Plan, Replay, Step, TICK_PERIOD_US, TickPeriod};

use crate::config::{ENVELOPE_LATERAL_RAD, ENVELOPE_PITCH_RAD, LATE_ABORT_COUNT};

/// A maneuver being played, or the last one played.
#[derive(Clone, Debug, Default)]
pub struct Player {
    replay: Option<Replay>,
    elapsed_s: f32,
    complete: bool,
    late_ticks: u32,
    ticks: u32,
    missed_ticks: u32,
}

impl Player {
    /// Nothing played yet.
    pub const fn new() -> Self {
        Self { replay: None, elapsed_s: 0.0, complete: false, late_ticks: 0, ticks: 0, missed_ticks: 0 }
    }

    /// Starts a plan now.
    pub fn start(&mut self, plan: Plan, now_us: u64) {
        *self = Self { replay: Some(Replay::new(plan, now_us)), ..Self::new() };
    }

    /// Ends it, complete or not.
    pub fn stop(&mut self, complete: bool) {
        self.replay = None;
        self.complete = complete;
    }

    /// Takes the clock into account: call first in every tick of a maneuver, with the time since the last tick. Returns
    /// whether T has passed.
    pub fn observe(&mut self, now_us: u64, interval_us: u64, late: bool) -> bool {
        let Some(replay) = &self.replay else {
            return false;
        };
        let duration_s = replay.plan().duration_s();
        self.elapsed_s = replay.elapsed_s(now_us).min(duration_s);
        let over = replay.elapsed_s(now_us) >= duration_s;
        self.late_ticks = self.late_ticks.saturating_add(u32::from(late));
        let half = u64::from(TICK_PERIOD_US) / 2;
        let periods = interval_us.saturating_add(half) / u64::from(TICK_PERIOD_US);
        let missed = u32::try_from(periods.saturating_sub(1)).unwrap_or(u32::MAX);
        self.missed_ticks = self.missed_ticks.saturating_add(missed);
        over
    }

    /// The command until the next tick; `None` when there is nothing to play.
    pub fn command(&mut self, now_us: u64, period: &TickPeriod) -> Option<Command> {
        match self.replay.as_mut()?.tick(now_us, period) {
            Step::Fly(command) => {
                self.ticks = self.ticks.saturating_add(1);
                Some(command)
            }
            Step::Over => None,
        }
    }

    /// Whether a rotation has left the envelope around the plan: the rate loop's accumulated error, rad, about
    /// forward, left, up. Judged against the plan and not against the horizon: flips are planned.
    pub fn is_off_plan(&self, angle_error_rad: [f32; 3]) -> bool {
        let [roll, pitch, yaw] = angle_error_rad;
        roll.abs() > ENVELOPE_LATERAL_RAD
            || pitch.abs() > ENVELOPE_PITCH_RAD
            || yaw.abs() > ENVELOPE_LATERAL_RAD
    }

    /// Whether too many ticks were late.
    pub fn is_too_late(&self) -> bool {
        self.late_ticks >= LATE_ABORT_COUNT
    }

    /// Time played, s, at most T.
    pub fn elapsed_s(&self) -> f32 {
        self.elapsed_s
    }

    /// Whether the last maneuver ran to T.
    pub fn is_complete(&self) -> bool {
        self.complete
    }

    /// Ticks played.
    pub fn ticks(&self) -> u32 {
        self.ticks
    }

    /// Ticks that the clock says are missing between them.
    pub fn missed_ticks(&self) -> u32 {
        self.missed_ticks
    }
}

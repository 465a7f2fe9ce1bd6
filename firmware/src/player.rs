//! Plays a maneuver: the replay's commands, and a watch over whether the vehicle follows them.

use mintime_shared::plane::Plane;
use mintime_shared::replay::{Command, Plan, Replay, Step, TICK_PERIOD_US, TickPeriod};

use crate::config::{ENVELOPE_LATERAL_RAD, ENVELOPE_PITCH_RAD, LATE_ABORT_COUNT};

/// A maneuver being played, or the last one played.
#[derive(Clone, Debug, Default)]
pub struct Player {
    replay: Option<Replay>,
    playing: bool,
    elapsed_s: f32,
    complete: bool,
    late_ticks: u32,
    ticks: u32,
    missed_ticks: u32,
}

impl Player {
    /// Nothing played yet.
    pub const fn new() -> Self {
        Self {
            replay: None,
            playing: false,
            elapsed_s: 0.0,
            complete: false,
            late_ticks: 0,
            ticks: 0,
            missed_ticks: 0,
        }
    }

    /// Lays a plan ready, so that starting it takes no time. Not while one is played.
    pub fn load(&mut self, plan: Plan) {
        self.replay = Some(Replay::new(plan, 0));
    }

    /// Takes away what lies ready.
    pub fn unload(&mut self) {
        self.replay = None;
        self.playing = false;
    }

    /// Starts the plan that lies ready.
    pub fn start(&mut self, now_us: u64) {
        self.elapsed_s = 0.0;
        self.complete = false;
        self.late_ticks = 0;
        self.ticks = 0;
        self.missed_ticks = 0;
        if let Some(replay) = &mut self.replay {
            replay.restart(now_us);
            self.playing = true;
        }
    }

    /// Ends it, complete or not.
    pub fn stop(&mut self, complete: bool) {
        self.playing = false;
        self.complete = complete;
    }

    /// Takes the clock into account: call first in every tick of a maneuver, with the time since the last tick. Returns
    /// whether T has passed.
    pub fn observe(&mut self, now_us: u64, interval_us: u64, late: bool) -> bool {
        let Some(replay) = self.replay.as_ref().filter(|_| self.playing) else {
            return false;
        };
        let duration_s = replay.plan().duration_s();
        let elapsed_s = replay.elapsed_s(now_us);
        let over = elapsed_s >= duration_s;
        self.elapsed_s = if over { duration_s } else { elapsed_s };
        self.late_ticks = self.late_ticks.saturating_add(u32::from(late));
        // In 32 bits, for the vehicle divides 64 by a long routine.
        let interval_us = u32::try_from(interval_us).unwrap_or(u32::MAX);
        let periods = interval_us.saturating_add(TICK_PERIOD_US / 2) / TICK_PERIOD_US;
        let missed = periods.saturating_sub(1);
        self.missed_ticks = self.missed_ticks.saturating_add(missed);
        over
    }

    /// The command until the next tick; `None` when there is nothing to play.
    pub fn command(&mut self, now_us: u64, period: &TickPeriod) -> Option<Command> {
        match self.replay.as_mut().filter(|_| self.playing)?.tick(now_us, period) {
            Step::Fly(command) => {
                self.ticks = self.ticks.saturating_add(1);
                Some(command)
            }
            Step::Over => None,
        }
    }

    /// The vertical plane of the maneuver, in the body frame at its start.
    pub fn plane(&self) -> Plane {
        self.replay.as_ref().map_or(Plane::FORWARD, |replay| replay.plan().plane())
    }

    /// Whether a rotation has left the envelope around the plan: the rate loop's accumulated error, rad, about
    /// forward, left, up. Judged against the plan and not against the horizon, and in the plane's own axes: flips are
    /// planned, in any direction.
    pub fn is_off_plan(&self, angle_error_rad: [f32; 3]) -> bool {
        let [lateral, in_plane, yaw] = self.plane().axes(angle_error_rad);
        lateral.abs() > ENVELOPE_LATERAL_RAD
            || in_plane.abs() > ENVELOPE_PITCH_RAD
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

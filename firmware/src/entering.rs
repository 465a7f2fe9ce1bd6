//! What a change of state brings with it: the supervisor decides on it, the rest of the flight logic begins anew.

use mintime_shared::messages::{AbortReason, FlightState};

use crate::flight::FlightLogic;
use crate::recorder::RecordMemory;

impl<M: RecordMemory> FlightLogic<M> {
    /// What a change of state brings with it.
    #[inline(never)]
    pub(crate) fn enter(&mut self, old: FlightState, reason: Option<AbortReason>, now_us: u64) {
        self.state_since_us = now_us;
        let new = self.state();
        self.to_log = Some((old, reason));
        if old == FlightState::Maneuver {
            // Complete is what ended by itself: no reason to abort, and nobody's order to stop.
            let by_itself = matches!(new, FlightState::Tracking | FlightState::Recovery);
            self.player.stop(by_itself && reason.is_none());
            // The plan's accumulated error is no business of the host's setpoints.
            self.rate.reset(self.gyro.rates_radps());
        }
        self.runaway_ticks = 0;
        self.saturated_ticks = 0;
        match new {
            FlightState::Armed => {
                self.rate.reset(self.gyro.rates_radps());
                self.worst_interval_us = 0;
                self.setpoints_lost = 0;
                self.last_trigger = None;
                self.last_sequence = None;
                self.motor_test = None;
                // A vehicle that flies is turned by nobody's hand.
                self.turns = None;
                self.lifted = false;
            }
            FlightState::Maneuver => {
                self.rate.reset(self.gyro.rates_radps());
                self.recording = false;
                self.recorder.clear();
                self.missing_before = self.gyro.missing_total();
                self.player.start(now_us);
            }
            FlightState::Recovery => {
                let asked_mps2 = self.host_setpoint.map_or(0.0, |(setpoint, _)| setpoint.thrust_mps2);
                self.recovery.start(asked_mps2, self.lifted);
            }
            FlightState::Boot
            | FlightState::Calibrating
            | FlightState::Disarmed
            | FlightState::Landed
            | FlightState::Terminated => {
                // Setpoints from before arming do not lift.
                self.host_setpoint = None;
                self.recording = false;
            }
            FlightState::Tracking => {}
        }
    }
}

//! What a tick brings in: the time, the samples, and what is estimated from them.

use mintime_shared::messages::FlightState;

use crate::attitude::Motion;
use crate::config::LATE_US;
use crate::flight::{Clock, FlightLogic, TickInput};
use crate::recorder::RecordMemory;

impl<M: RecordMemory> FlightLogic<M> {
    /// Takes in what the sensors say.
    pub(crate) fn sense(&mut self, input: &TickInput) {
        self.battery_v = input.battery_v.filter(|v| self.config.is_plausible_battery(*v));
        self.drive_v = self.battery_v.or(self.drive_v);
        self.kill = input.kill;
        let motors_off = !self.state().motors_on();
        if motors_off {
            self.on_bench = self.kill_is_waived();
        }
        self.gyro.update(input.imu.as_ref(), self.commanded.rates_radps, motors_off);
        self.accel_mps2 = input.imu.map(|imu| imu.accel_mps2).filter(|a| a.iter().all(|v| v.is_finite()));
        self.to_estimate = Some(input.imu);
    }

    /// The attitude and the calibration by turns, from the sample of this tick: nothing that its motors wait for.
    #[inline(never)]
    pub(crate) fn estimate(&mut self) {
        let Some(imu) = self.to_estimate.take() else {
            return;
        };
        let motion = match self.state() {
            FlightState::Tracking => Motion::Flying,
            FlightState::Maneuver | FlightState::Recovery => Motion::Maneuver,
            _ => Motion::MotorsOff,
        };
        let dt_s = interval_s(self.interval_us);
        // Where the sample is missing the last rates have to do, and gravity says nothing.
        let accel_mps2 = self.accel_mps2.unwrap_or_default();
        self.attitude.update(self.gyro.rates_radps(), accel_mps2, dt_s, motion);
        if let Some(turns) = &mut self.turns
            && turns.found.is_none()
        {
            turns.found = turns.under_way.update(imu.map(|imu| imu.gyro_radps), dt_s);
        }
    }

    pub(crate) fn advance_clock(&mut self, now_us: u64) -> Clock {
        self.ticks = self.ticks.wrapping_add(1);
        let Some(last) = self.last_us else {
            self.last_us = Some(now_us);
            return Clock::Punctual;
        };
        if now_us < last {
            self.interval_us = 0;
            return Clock::Backwards;
        }
        self.last_us = Some(now_us);
        self.interval_us = now_us.saturating_sub(last);
        self.period.observe(self.interval_us);
        let worst = u32::try_from(self.interval_us).unwrap_or(u32::MAX);
        self.worst_interval_us = self.worst_interval_us.max(worst);
        let late = self.interval_us > LATE_US;
        self.late_ticks = self.late_ticks.saturating_add(u32::from(late));
        if late { Clock::Late } else { Clock::Punctual }
    }
}

/// In 32 bits: the processor converts those by itself.
pub(crate) fn interval_s(interval_us: u64) -> f32 {
    u32::try_from(interval_us).unwrap_or(u32::MAX) as f32 * 1.0e-6
}

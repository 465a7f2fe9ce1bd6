//! What is true of the vehicle this tick: for the supervisor, for whoever wants to arm or trigger, for telemetry.

use mintime_shared::messages::{ArmingBlock, FlightState, KillSwitch, Telemetry};
use mintime_shared::real::at_least;
use mintime_shared::table::LinkPolicy;

use crate::config::{
    ARMED_IDLE_US, ARMING_TILT_COS, BATTERY_SAG_TICKS, GATE_RATE_RADPS, LATE_ABORT_US, LIFT_THRUST_MPS2,
    LOST_SAMPLES_ABORT, RUNAWAY_ERROR_RADPS, RUNAWAY_TICKS, SATURATED_TICKS, SETPOINT_FRESH_US,
};
use crate::flight::{Clock, FlightLogic};
use crate::keeping::Key;
use crate::recorder::RecordMemory;
use crate::supervisor::Conditions;
use crate::tables::Committed;

impl<M: RecordMemory> FlightLogic<M> {
    /// Conditions that follow from sensors and time.
    pub(crate) fn watch(&mut self, now_us: u64) -> Conditions {
        use Conditions as C;
        let mut found = C::empty();
        let state = self.state();
        let maneuver = state == FlightState::Maneuver;
        let late = self.clock == Clock::Late;
        let over = maneuver && self.player.observe(now_us, self.interval_us, late);
        let runaway = state.airborne() && self.rate_error_radps() > RUNAWAY_ERROR_RADPS;
        self.runaway_ticks = if runaway { self.runaway_ticks.saturating_add(1) } else { 0 };
        let sags = self.battery_v.is_some_and(|v| v < self.config.battery_critical_v);
        self.sag_ticks = if sags { self.sag_ticks.saturating_add(1) } else { 0 };
        let in_state_us = now_us.saturating_sub(self.state_since_us);
        let waived = self.kill_is_waived();
        found.set(C::KILL, self.kill == KillSwitch::Stop);
        // Never heard, and not to be done without: as bad as lost.
        found
            .set(C::KILL_LOST, self.kill == KillSwitch::Lost || (self.kill == KillSwitch::Absent && !waived));
        found.set(C::CLOCK, self.clock == Clock::Backwards);
        found.set(C::GYRO_MISSING, self.gyro.is_missing());
        found.set(C::GYRO_FROZEN, self.gyro.is_frozen());
        found.set(C::GYRO_SATURATED, self.gyro.is_saturated());
        found.set(C::RUNAWAY, self.runaway_ticks >= RUNAWAY_TICKS);
        found.set(C::OVER, over);
        let blind = self.interval_us >= LATE_ABORT_US;
        found.set(C::LATE_TICKS, maneuver && (blind || self.player.is_too_late()));
        let lost = self.gyro.missing_total().saturating_sub(self.missing_before);
        found.set(C::LOST_SAMPLES, maneuver && lost >= LOST_SAMPLES_ABORT);
        found.set(C::OFF_PLAN, maneuver && self.player.is_off_plan(self.rate.angle_error_rad()));
        found.set(C::SATURATED, maneuver && self.saturated_ticks >= SATURATED_TICKS);
        found.set(C::BATTERY_SAG, self.sag_ticks >= BATTERY_SAG_TICKS);
        found.set(C::IDLE_TOO_LONG, state == FlightState::Armed && in_state_us >= ARMED_IDLE_US);
        // Speed controllers that have not armed keep nobody from calibrating: without a battery they never do.
        found.set(C::STARTING, self.starting && !self.capabilities.gyro);
        found.set(C::CALIBRATED, self.gyro.is_calibrated());
        let recovery = state == FlightState::Recovery;
        found.set(C::TOUCHED_DOWN, recovery && self.recovery.stands());
        let recovery_us = u64::from(self.settings.recovery_ms) * 1000;
        found.set(C::RECOVERY_OVER, recovery && in_state_us >= recovery_us);
        found
    }

    /// Conditions that follow from what the host says.
    pub(crate) fn host_conditions(&self, now_us: u64) -> Conditions {
        let mut found = Conditions::empty();
        found.set(Conditions::FRESH, self.setpoint_is_fresh(now_us));
        let lifts = self.host_setpoint.is_some_and(|(s, _)| s.thrust_mps2 >= LIFT_THRUST_MPS2);
        found.set(Conditions::LIFTS, lifts);
        found.set(Conditions::HOST_SILENT, self.host_is_silent(now_us));
        let abandons = self.tables.committed().is_some_and(|c| c.table.link == LinkPolicy::Abandon);
        found.set(Conditions::ABANDON, abandons);
        found
    }

    pub(crate) fn setpoint_is_fresh(&self, now_us: u64) -> bool {
        self.host_setpoint.is_some_and(|(_, at)| now_us.saturating_sub(at) <= SETPOINT_FRESH_US)
    }

    fn host_is_silent(&self, now_us: u64) -> bool {
        let timeout_us = u64::from(self.settings.heartbeat_ms) * 1000;
        self.heard_us.is_none_or(|at| now_us.saturating_sub(at) > timeout_us)
    }

    fn rate_error_radps(&self) -> f32 {
        let pairs = self.commanded.rates_radps.into_iter().zip(self.gyro.rates_radps());
        pairs.fold(0.0, |worst, (asked, done)| at_least((asked - done).abs(), worst))
    }

    /// No kill switch, but thrust is capped: work on the bench.
    pub(crate) fn kill_is_waived(&self) -> bool {
        self.kill == KillSwitch::Absent && self.settings.bench_thrust_mps2 > 0.0
    }

    /// Highest thrust allowed, m/s², where it is capped.
    pub(crate) fn thrust_cap_mps2(&self) -> Option<f32> {
        let on_bench = self.kill_is_waived() || self.on_bench;
        on_bench.then_some(self.settings.bench_thrust_mps2)
    }

    /// Whether the kill switch forbids to go on.
    pub(crate) fn kill_refuses(&self) -> bool {
        matches!(self.kill, KillSwitch::Stop | KillSwitch::Lost)
    }

    /// What blocks arming now.
    #[inline(never)]
    pub(crate) fn arming_block(&self) -> ArmingBlock {
        use ArmingBlock as B;
        let low = self.battery_v.is_some_and(|v| v < self.config.battery_low_v);
        let state = self.state();
        let terminated = state == FlightState::Terminated;
        // Why it is terminated has a bit of its own.
        let told = |number| terminated && self.incidents.is_termination(number);
        let incident = self.incidents.iter().any(|incident| !told(incident.number));
        B::none()
            .when(B::STARTING, self.starting)
            .when(B::NO_GYRO, !self.capabilities.gyro && !self.starting)
            .when(B::NO_MOTORS, !self.capabilities.motors && !self.starting)
            .when(B::GYRO_SILENT, self.capabilities.gyro && self.gyro.is_missing())
            .when(
                B::NOT_CALIBRATED,
                self.capabilities.gyro && !(self.gyro.is_calibrated() && self.attitude.is_known()),
            )
            .when(B::MOVING, self.gyro.is_calibrated() && self.gyro.is_moving())
            .when(B::GYRO_FROZEN, self.gyro.repeats_itself())
            .when(B::BATTERY_UNKNOWN, self.battery_v.is_none())
            .when(B::BATTERY_LOW, low)
            .when(B::KILL_SWITCH, self.kill == KillSwitch::Stop)
            .when(B::KILL_LOST, self.kill == KillSwitch::Lost)
            .when(B::NO_KILL_SWITCH, self.kill == KillSwitch::Absent && !self.kill_is_waived())
            .when(B::LATE_TICKS, self.interval_us >= LATE_ABORT_US)
            .when(B::TERMINATED, terminated)
            .when(B::INCIDENT, incident)
            .when(B::LANDED, state == FlightState::Landed)
            .when(B::TILTED, self.tilt_cos().is_some_and(|cos| cos < ARMING_TILT_COS))
            .when(B::NO_VEHICLE, !self.known)
            .when(B::STORING, self.is_storing())
            // Other values than were written last may be in force: nobody flies with them, whatever was acknowledged.
            .when(B::DAMAGED_VEHICLE, self.damaged.of(Key::Vehicle))
            .when(B::DAMAGED_SETTINGS, self.damaged.of(Key::Settings))
            .when(B::DAMAGED_PAIRING, self.damaged.of(Key::Pairing))
    }

    /// Whether the vehicle stands in the air as the table's start wants it: its thrust axis and rates are all it knows of that.
    pub(crate) fn is_in_start_gate(&self, committed: &Committed) -> bool {
        let calm = self.gyro.rates_radps().iter().all(|rate| rate.abs() <= GATE_RATE_RADPS);
        calm && committed.gate.is_met(self.attitude.up_in_body())
    }

    /// Cosine of the tilt; `None` before the vehicle was seen at rest.
    fn tilt_cos(&self) -> Option<f32> {
        let [_, _, up] = self.attitude.up_in_body();
        self.attitude.is_known().then_some(up)
    }

    /// How the vehicle is.
    #[inline(never)]
    pub(crate) fn telemetry(&self) -> Telemetry {
        Telemetry {
            time_us: self.last_us.unwrap_or(0),
            state: self.state(),
            arming_block: self.arming_block().0,
            abort: self.supervisor.abort(),
            incident: self.incidents.oldest(),
            kill: self.kill,
            table: self.tables.committed_checksum(),
            maneuver_s: self.player.elapsed_s(),
            maneuver_complete: self.player.is_complete(),
            maneuver_ticks: self.player.ticks(),
            maneuver_missed_ticks: self.player.missed_ticks(),
            battery_v: self.battery_v.unwrap_or(0.0),
            rates_radps: self.gyro.rates_radps(),
            up_body: self.attitude.up_in_body(),
            ticks: self.ticks,
            late_ticks: self.late_ticks,
            missing_samples: self.gyro.missing_total(),
            worst_interval_us: self.worst_interval_us,
            link_errors: self.link_errors,
            setpoints_lost: self.setpoints_lost,
            recorded: self.recorder.len(),
            events: self.events.newest(),
            board: self.board,
        }
    }
}

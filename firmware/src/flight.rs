//! The flight logic: one function of (time, IMU sample or none, battery, kill switch, inbox) to (motors, outbox).
//!
//! There is no clock, no hardware and no other state in it, so that host tests, a virtual board and the real board run
//! the same code on the same inputs and get the same outputs, bit for bit.
//!
//! A tick has two parts. [`FlightLogic::command`] is what the motors wait for; [`FlightLogic::conclude`] is everything
//! else and runs while their frame is on the wire: requests that do not bear on them, all answers, the record.
//!
//! Deadline: one call every gyro sample, 1.25 ms. Work is bounded: at most [`INBOX`] requests, one
//! transition, one replay tick over at most 24 segments; the dearest request, the commit of a table, integrates those
//! segments once and is accepted with the motors off only. Late calls are seen by the clock and reported; past a bound
//! they end a maneuver. Motors off is the answer to every unknown.

use heapless::Deque;
use mintime_shared::messages::{
    AbortReason, ArmingBlock, BoardTelemetry, FlightState, Message, RecordedTick, Setpoint, Telemetry, Uplink,
};
use mintime_shared::replay::{TICK_PERIOD_US, TickPeriod};

use crate::config::{
    ARMED_IDLE_US, BoardStatus, CONTROL_STEP_MAX_S, Capabilities, INBOX, LATE_ABORT_US, LATE_US,
    LIFT_THRUST_MPS2, LINK_DEAD_US, LINK_LOST_THRUST, MOTOR_COUNT, OUTBOX, RUNAWAY_ERROR_RADPS,
    RUNAWAY_TICKS, SETPOINT_FRESH_US, TELEMETRY_US, VehicleConfig,
};
use crate::gyro::{Gyro, ImuSample};
use crate::mixer::{Demand, RotorDrive, mix, to_outputs};
use crate::player::Player;
use crate::rate_control::{RateController, RateInput};
use crate::recorder::{RecordMemory, Recorder};
use crate::requests::{Tables, Verdicts};
use crate::supervisor::{Conditions, Supervisor};
use mintime_shared::model::GRAVITY_MPS2;
use mintime_shared::real::{at_least, at_most};

/// Requests that arrived since the last tick.
pub type Inbox = Deque<Uplink, INBOX>;
/// Messages on their way to the host.
pub type Outbox = Deque<Message, OUTBOX>;

/// All that the flight logic gets to know in one tick.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TickInput {
    /// The vehicle's clock, µs since power-up. Where it runs backwards the motors stop.
    pub now_us: u64,
    /// The sample that started this tick; `None` where it failed or stayed away.
    pub imu: Option<ImuSample>,
    /// Battery voltage, V; `None` where unknown.
    pub battery_v: Option<f32>,
    /// Whether the kill switch is on.
    pub kill: bool,
}

/// What the motors shall do until the next tick.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct TickOutput {
    /// Throttles of output lines 1..4, 0..1; `None` switches them off.
    pub throttle: Option<[f32; MOTOR_COUNT]>,
    /// The body rates and thrust that the throttles are meant to bring about.
    pub setpoint: Setpoint,
}

/// What the clock says of a tick.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Clock {
    Punctual,
    Late,
    /// It came before the last one.
    Backwards,
}

/// The whole on-board logic between sensors and motors.
#[derive(Debug)]
pub struct FlightLogic<M> {
    pub(crate) config: VehicleConfig,
    pub(crate) capabilities: Capabilities,
    pub(crate) supervisor: Supervisor,
    pub(crate) tables: Tables,
    pub(crate) recorder: Recorder<M>,
    pub(crate) link_errors: u32,
    gyro: Gyro,
    pub(crate) player: Player,
    rate: RateController,
    drive: RotorDrive,
    period: TickPeriod,
    last_us: Option<u64>,
    interval_us: u64,
    state_since_us: u64,
    /// The newest setpoint and when it came.
    pub(crate) host_setpoint: Option<(Setpoint, u64)>,
    /// What was commanded over the tick that just ended.
    commanded: Setpoint,
    /// Requests that the second part of the tick answers.
    pub(crate) verdicts: Verdicts,
    /// The tick that the second part records.
    to_record: Option<RecordedTick>,
    runaway_ticks: u32,
    /// Number of the request that triggered the last maneuver since arming, and when.
    pub(crate) last_trigger: Option<(u16, u64)>,
    next_telemetry_us: u64,
    ticks: u32,
    late_ticks: u32,
    worst_interval_us: u32,
    pub(crate) battery_v: Option<f32>,
    /// The last voltage known, for thrust compensation.
    drive_v: Option<f32>,
    kill: bool,
    /// Drivers of the board are still at work on their set-up.
    starting: bool,
    board: Option<BoardTelemetry>,
}

impl<M: RecordMemory> FlightLogic<M> {
    /// A vehicle that was just switched on. `record` is the memory for flight records.
    pub const fn new(config: VehicleConfig, capabilities: Capabilities, record: M) -> Self {
        Self {
            config,
            capabilities,
            supervisor: Supervisor::new(),
            tables: Tables::new(),
            recorder: Recorder::new(record),
            link_errors: 0,
            gyro: Gyro::new(),
            player: Player::new(),
            rate: RateController::new(),
            drive: RotorDrive::new(),
            period: TickPeriod::new(),
            last_us: None,
            interval_us: TICK_PERIOD_US as u64,
            state_since_us: 0,
            host_setpoint: None,
            commanded: Setpoint { rates_radps: [0.0; 3], thrust_mps2: 0.0 },
            verdicts: Verdicts::new(),
            to_record: None,
            runaway_ticks: 0,
            last_trigger: None,
            next_telemetry_us: 0,
            ticks: 0,
            late_ticks: 0,
            worst_interval_us: 0,
            battery_v: None,
            drive_v: None,
            kill: false,
            starting: false,
            board: None,
        }
    }

    /// What the supervisor is doing.
    pub fn state(&self) -> FlightState {
        self.supervisor.state()
    }

    /// Says how many received frames were not messages, for telemetry.
    pub fn set_link_errors(&mut self, count: u32) {
        self.link_errors = count;
    }

    /// Says what the board can do by now and how it does.
    pub fn set_board_status(&mut self, status: &BoardStatus) {
        self.capabilities = status.capabilities;
        self.starting = status.starting;
        self.board = Some(status.telemetry);
    }

    /// One tick: [`Self::command`] and [`Self::conclude`].
    pub fn tick(&mut self, input: &TickInput, inbox: &mut Inbox, outbox: &mut Outbox) -> TickOutput {
        let output = self.command(input, inbox);
        self.conclude(inbox, outbox);
        output
    }

    /// The part of a tick that the motors wait for. [`Self::conclude`] is due before the next one and takes the requests
    /// out of the inbox.
    pub fn command(&mut self, input: &TickInput, inbox: &Inbox) -> TickOutput {
        let clock = self.advance_clock(input.now_us);
        // Time stands still rather than runs backwards; the supervisor stops the motors for it.
        let now_us = self.last_us.unwrap_or(input.now_us);
        self.battery_v = input.battery_v.filter(|v| self.config.is_plausible_battery(*v));
        self.drive_v = self.battery_v.or(self.drive_v);
        self.kill = input.kill;
        let motors_off = !self.state().motors_on();
        self.gyro.update(input.imu.as_ref(), self.commanded.rates_radps, motors_off);

        let mut conditions = self.watch(now_us, clock);
        self.take_orders(inbox, now_us, &mut conditions);
        // A setpoint taken just now counts.
        conditions |= self.setpoint_conditions(now_us);
        if let Some((old, reason)) = self.supervisor.step(conditions) {
            self.enter(old, reason, now_us);
        }

        let setpoint = self.choose_setpoint(now_us);
        let output = self.control(setpoint);
        self.to_record = self.recorded(&output);
        // Here alone places of the frame become output lines.
        TickOutput { throttle: output.throttle.map(|t| to_outputs(&self.config, t)), ..output }
    }

    /// The part of a tick that the motors need not wait for: requests that do not bear on them, answers, the record.
    /// Nothing to do the second time.
    pub fn conclude(&mut self, inbox: &mut Inbox, outbox: &mut Outbox) {
        let now_us = self.last_us.unwrap_or(0);
        self.answer(inbox, now_us, outbox);
        if let Some(tick) = self.to_record.take() {
            self.recorder.push(now_us, tick);
        }
    }

    fn advance_clock(&mut self, now_us: u64) -> Clock {
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

    /// Conditions that follow from sensors and time.
    fn watch(&mut self, now_us: u64, clock: Clock) -> Conditions {
        let mut found = Conditions::empty();
        let state = self.state();
        let maneuver = state == FlightState::Maneuver;
        let over = maneuver && self.player.observe(now_us, self.interval_us, clock == Clock::Late);
        let error = self.rate_error_radps();
        let runaway = state != FlightState::Armed && state.motors_on() && error > RUNAWAY_ERROR_RADPS;
        self.runaway_ticks = if runaway { self.runaway_ticks.saturating_add(1) } else { 0 };
        let in_state_us = now_us.saturating_sub(self.state_since_us);
        found.set(Conditions::KILL, self.kill);
        found.set(Conditions::CLOCK, clock == Clock::Backwards);
        found.set(Conditions::GYRO_MISSING, self.gyro.is_missing());
        found.set(Conditions::GYRO_FROZEN, self.gyro.is_frozen());
        found.set(Conditions::GYRO_SATURATED, self.gyro.is_saturated());
        found.set(Conditions::RUNAWAY, self.runaway_ticks >= RUNAWAY_TICKS);
        found.set(Conditions::OVER, over);
        let blind = self.interval_us >= LATE_ABORT_US;
        found.set(Conditions::LATE_TICKS, maneuver && (blind || self.player.is_too_late()));
        found.set(Conditions::OFF_PLAN, maneuver && self.player.is_off_plan(self.rate.angle_error_rad()));
        found.set(Conditions::IDLE_TOO_LONG, state == FlightState::Armed && in_state_us >= ARMED_IDLE_US);
        found
    }

    /// Conditions that follow from the newest setpoint.
    fn setpoint_conditions(&self, now_us: u64) -> Conditions {
        let mut found = Conditions::empty();
        let since = |at: u64| now_us.saturating_sub(at);
        let age_us = self.host_setpoint.map(|(_, at)| since(at));
        found.set(Conditions::FRESH, self.setpoint_is_fresh(now_us));
        // Counted from when the link was lost too: after a long maneuver the host gets its time to come back.
        let alone_us = age_us.unwrap_or(u64::MAX).min(since(self.state_since_us));
        found.set(Conditions::LINK_DEAD, alone_us >= LINK_DEAD_US);
        let lifts = self.host_setpoint.is_some_and(|(s, _)| s.thrust_mps2 >= LIFT_THRUST_MPS2);
        found.set(Conditions::LIFTS, lifts);
        found
    }

    pub(crate) fn setpoint_is_fresh(&self, now_us: u64) -> bool {
        self.host_setpoint.is_some_and(|(_, at)| now_us.saturating_sub(at) <= SETPOINT_FRESH_US)
    }

    fn rate_error_radps(&self) -> f32 {
        let pairs = self.commanded.rates_radps.into_iter().zip(self.gyro.rates_radps());
        pairs.fold(0.0, |worst, (asked, done)| at_least((asked - done).abs(), worst))
    }

    /// What blocks arming now.
    pub(crate) fn arming_block(&self) -> ArmingBlock {
        use ArmingBlock as B;
        let low = self.battery_v.is_some_and(|v| v < self.config.battery_low_v);
        B::none()
            .when(B::STARTING, self.starting)
            .when(B::NO_GYRO, !self.capabilities.gyro && !self.starting)
            .when(B::NO_MOTORS, !self.capabilities.motors && !self.starting)
            .when(B::GYRO_SILENT, self.capabilities.gyro && self.gyro.is_missing())
            .when(B::NOT_CALIBRATED, self.capabilities.gyro && !self.gyro.is_calibrated())
            .when(B::MOVING, self.gyro.is_calibrated() && self.gyro.is_moving())
            .when(B::GYRO_FROZEN, self.gyro.repeats_itself())
            .when(B::BATTERY_UNKNOWN, self.battery_v.is_none())
            .when(B::BATTERY_LOW, low)
            .when(B::KILL_SWITCH, self.kill)
            .when(B::LATE_TICKS, self.interval_us >= LATE_ABORT_US)
            .when(B::STOPPED, self.state() == FlightState::Stopped)
    }

    /// What a change of state brings with it.
    fn enter(&mut self, old: FlightState, reason: Option<AbortReason>, now_us: u64) {
        self.state_since_us = now_us;
        let new = self.state();
        if old == FlightState::Maneuver {
            // Complete is what ended by itself: no reason to abort, and nobody's order to stop.
            let by_itself = matches!(new, FlightState::Flying | FlightState::LinkLost);
            self.player.stop(by_itself && reason.is_none());
            // The plan's accumulated error is no business of the host's setpoints.
            self.rate.reset(self.gyro.rates_radps());
        }
        match new {
            FlightState::Armed => {
                self.rate.reset(self.gyro.rates_radps());
                self.runaway_ticks = 0;
                self.worst_interval_us = 0;
                self.last_trigger = None;
                // Setpoints from before arming do not lift.
                self.host_setpoint = None;
            }
            FlightState::Maneuver => {
                self.rate.reset(self.gyro.rates_radps());
                self.runaway_ticks = 0;
                self.recorder.clear();
                self.player.start(now_us);
            }
            FlightState::Disarmed | FlightState::Stopped => {
                self.host_setpoint = None;
                self.runaway_ticks = 0;
            }
            FlightState::Flying | FlightState::LinkLost => {}
        }
    }

    /// What to fly until the next tick; `None` for motors that only idle or stand still.
    fn choose_setpoint(&mut self, now_us: u64) -> Option<Setpoint> {
        // Never more than the host last asked for: a vehicle that stands on the ground stays there.
        let asked_mps2 = self.host_setpoint.map_or(0.0, |(setpoint, _)| setpoint.thrust_mps2);
        let thrust_mps2 = at_most(LINK_LOST_THRUST * GRAVITY_MPS2 as f32, asked_mps2);
        let sink = Setpoint { rates_radps: [0.0; 3], thrust_mps2 };
        match self.state() {
            FlightState::Disarmed | FlightState::Stopped | FlightState::Armed => None,
            FlightState::Flying => Some(self.host_setpoint.map_or(sink, |(setpoint, _)| setpoint)),
            FlightState::Maneuver => {
                let plane = self.player.plane();
                let command = self.player.command(now_us, &self.period);
                Some(command.map_or(sink, |c| Setpoint {
                    rates_radps: plane.turn(c.rate_radps),
                    thrust_mps2: c.thrust_mps2,
                }))
            }
            FlightState::LinkLost => Some(sink),
        }
    }

    /// Rate control, mixing, and what the motors get.
    fn control(&mut self, setpoint: Option<Setpoint>) -> TickOutput {
        // In 32 bits: the processor converts those by itself.
        let interval_us = u32::try_from(self.interval_us).unwrap_or(u32::MAX);
        let dt_s = at_most(interval_us as f32 * 1.0e-6, CONTROL_STEP_MAX_S);
        let Some(setpoint) = setpoint else {
            self.commanded = Setpoint::default();
            self.rate.rest(self.gyro.rates_radps());
            let off = self.drive.rest(&self.config, dt_s);
            // Idle is zero demand: the mixer's floor keeps the rotors turning.
            let idle = (self.state() == FlightState::Armed)
                .then(|| self.drive.throttles(&self.config, off, self.drive_v, 0.0));
            return TickOutput { throttle: idle, setpoint: self.commanded };
        };
        let thrust_mps2 = setpoint.thrust_mps2;
        let input = RateInput {
            asked: self.commanded.rates_radps,
            next: setpoint.rates_radps,
            measured: self.gyro.rates_radps(),
            thrust_mps2,
            dt_s,
            follow_angle: self.state() == FlightState::Maneuver,
        };
        let demand = Demand { thrust_mps2, acceleration_radps2: self.rate.update(&self.config, &input) };
        let mixed = mix(&self.config, &demand);
        self.rate.limited(&mixed.saturation);
        let throttle = self.drive.throttles(&self.config, mixed.thrusts_n, self.drive_v, dt_s);
        self.commanded = setpoint;
        TickOutput { throttle: Some(throttle), setpoint }
    }

    /// What the record says of this tick; the recorder fills the interval in.
    fn recorded(&self, output: &TickOutput) -> Option<RecordedTick> {
        (self.state() == FlightState::Maneuver).then(|| RecordedTick {
            interval_us: 0,
            gyro_radps: self.gyro.fresh_rates_radps(),
            rate_radps: self.player.plane().axes(output.setpoint.rates_radps)[1],
            thrust_mps2: output.setpoint.thrust_mps2,
            throttle: output.throttle.unwrap_or_default(),
        })
    }

    /// Says how the vehicle is when it is time to. Once a tick, after the motors have their command: it would delay one
    /// tick in sixteen.
    pub fn telemeter(&mut self, outbox: &mut Outbox) {
        let Some(now_us) = self.last_us.filter(|now| *now >= self.next_telemetry_us) else {
            return;
        };
        self.next_telemetry_us = now_us.saturating_add(TELEMETRY_US);
        // A full outbox means a slow link: the next one will do.
        let _ = outbox.push_back(Message::Telemetry(self.telemetry()));
    }

    /// How the vehicle is.
    pub(crate) fn telemetry(&self) -> Telemetry {
        Telemetry {
            time_us: self.last_us.unwrap_or(0),
            state: self.state(),
            arming_block: self.arming_block().0,
            abort: self.supervisor.abort(),
            table: self.tables.committed_checksum(),
            maneuver_s: self.player.elapsed_s(),
            maneuver_complete: self.player.is_complete(),
            maneuver_ticks: self.player.ticks(),
            maneuver_missed_ticks: self.player.missed_ticks(),
            battery_v: self.battery_v.unwrap_or(0.0),
            rates_radps: self.gyro.rates_radps(),
            ticks: self.ticks,
            late_ticks: self.late_ticks,
            missing_samples: self.gyro.missing_total(),
            worst_interval_us: self.worst_interval_us,
            link_errors: self.link_errors,
            recorded: self.recorder.len(),
            board: self.board,
        }
    }
}

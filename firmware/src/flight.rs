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
    AbortReason, BoardTelemetry, CalibrationError, FlightState, Happening, IncidentCause, KillSwitch,
    Message, Purpose, RecordedTick, Refusal, Setpoint, TELEMETRY_PERIOD_US, Uplink, record_flags,
};
use mintime_shared::replay::{TICK_PERIOD_US, TickPeriod};
use mintime_shared::seal::PairingKey;
use mintime_shared::settings::Settings;

use crate::attitude::AttitudeEstimate;
use crate::calibration::ScaleCalibration;
use crate::config::{BoardStatus, Capabilities, INBOX, MOTOR_COUNT, OUTBOX, StoreStatus, VehicleConfig};
use crate::events::EventLog;
use crate::gyro::{Gyro, ImuSample};
use crate::incidents::Incidents;
use crate::keeping::{Keeper, Slots};
use crate::mixer::{RotorDrive, to_outputs};
use crate::player::Player;
use crate::rate_control::RateController;
use crate::recorder::{RecordMemory, Recorder};
use crate::recovery::Recovery;
use crate::requests::Verdicts;
use crate::store::Damage;
use crate::supervisor::Supervisor;
use crate::tables::Tables;

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
    /// What the kill switch says.
    pub kill: KillSwitch,
}

/// What the motors shall do until the next tick.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct TickOutput {
    /// Throttles of output lines 1..4, 0..1, where 0 stands still; `None` switches all of them off.
    pub throttle: Option<[f32; MOTOR_COUNT]>,
    /// The body rates and thrust that the throttles are meant to bring about.
    pub setpoint: Setpoint,
}

/// What the clock says of a tick.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Clock {
    Punctual,
    Late,
    /// It came before the last one.
    Backwards,
}

/// A calibration of the gyro's scale by guided turns.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Turns {
    /// The request that asked for it: number, axis, turns.
    pub(crate) asked: (u16, u8, i8),
    /// When it was last asked for.
    pub(crate) asked_us: u64,
    pub(crate) under_way: ScaleCalibration,
    /// What it has found.
    pub(crate) found: Option<Result<f32, CalibrationError>>,
}

/// One motor that turns while the others stand.
#[derive(Clone, Copy, Debug)]
pub(crate) struct MotorTest {
    /// Number of the request.
    pub(crate) number: u16,
    pub(crate) motor: u8,
    pub(crate) throttle: f32,
    pub(crate) until_us: u64,
}

/// The whole on-board logic between sensors and motors.
#[derive(Debug)]
pub struct FlightLogic<M> {
    // What it is.
    pub(crate) config: VehicleConfig,
    /// The vehicle has been told what it is.
    pub(crate) known: bool,
    pub(crate) settings: Settings,
    pub(crate) pairing: Option<PairingKey>,
    pub(crate) session: u32,
    pub(crate) slots: Slots,
    pub(crate) keeper: Keeper,
    /// Keys whose value in the store is damaged.
    pub(crate) damaged: Damage,
    /// Places of tables where the store holds something that is no table of this firmware: bit by bit.
    pub(crate) unreadable: u8,
    // What its board says.
    pub(crate) capabilities: Capabilities,
    /// Drivers of the board are still at work on their set-up.
    pub(crate) starting: bool,
    pub(crate) store: StoreStatus,
    pub(crate) board: Option<BoardTelemetry>,
    pub(crate) link_errors: u32,
    /// Counter of the last seal that the link took.
    pub(crate) last_counter: u32,
    // What it decides.
    pub(crate) supervisor: Supervisor,
    pub(crate) purpose: Purpose,
    /// No kill switch was heard before the motors were switched on: whatever is heard since, thrust stays capped.
    pub(crate) on_bench: bool,
    pub(crate) motor_test: Option<MotorTest>,
    pub(crate) incidents: Incidents,
    pub(crate) state_since_us: u64,
    // What it senses.
    pub(crate) gyro: Gyro,
    pub(crate) attitude: AttitudeEstimate,
    /// Guided turns under way, and who asked for them.
    pub(crate) turns: Option<Turns>,
    pub(crate) accel_mps2: Option<[f32; 3]>,
    pub(crate) battery_v: Option<f32>,
    /// The last voltage known, for thrust compensation.
    pub(crate) drive_v: Option<f32>,
    pub(crate) sag_ticks: u32,
    /// Samples that were missing before the maneuver began.
    pub(crate) missing_before: u32,
    pub(crate) kill: KillSwitch,
    // What it flies.
    pub(crate) tables: Tables,
    pub(crate) player: Player,
    pub(crate) recovery: Recovery,
    pub(crate) rate: RateController,
    pub(crate) drive: RotorDrive,
    /// What was commanded over the tick that just ended.
    pub(crate) commanded: Setpoint,
    /// It has been asked to lift since it was armed.
    pub(crate) lifted: bool,
    pub(crate) saturated_ticks: u32,
    pub(crate) runaway_ticks: u32,
    // Who flies it.
    /// When the host was last heard.
    pub(crate) heard_us: Option<u64>,
    /// The newest setpoint and when it came.
    pub(crate) host_setpoint: Option<(Setpoint, u64)>,
    /// Sequence number of the newest setpoint since arming.
    pub(crate) last_sequence: Option<u16>,
    pub(crate) setpoints_lost: u32,
    /// Number of the request that triggered the last maneuver since arming, and when.
    pub(crate) last_trigger: Option<(u16, u64)>,
    /// Requests that the second part of the tick answers.
    pub(crate) verdicts: Verdicts,
    pub(crate) last_refusal: Option<(u16, Refusal)>,
    /// Number of the request that learned the bias anew, and when it last came.
    pub(crate) calibrated_by: Option<(u16, u64)>,
    // When it is.
    pub(crate) period: TickPeriod,
    pub(crate) last_us: Option<u64>,
    pub(crate) interval_us: u64,
    pub(crate) clock: Clock,
    pub(crate) ticks: u32,
    pub(crate) late_ticks: u32,
    pub(crate) worst_interval_us: u32,
    // What it tells.
    pub(crate) recorder: Recorder<M>,
    /// Ticks are recorded outside a maneuver too.
    pub(crate) recording: bool,
    /// The state that was left and why, for the second part to log.
    pub(crate) to_log: Option<(FlightState, Option<AbortReason>)>,
    /// What the second part records.
    pub(crate) to_record: Option<TickOutput>,
    /// The sample, or its absence, that the second part estimates the attitude from.
    pub(crate) to_estimate: Option<Option<ImuSample>>,
    pub(crate) events: EventLog,
    pub(crate) telemetry_us: u64,
    pub(crate) next_telemetry_us: u64,
}

impl<M: RecordMemory> FlightLogic<M> {
    /// A vehicle that was just switched on. `config` is what it is, if it has been told; `record` is the memory for
    /// flight records.
    pub const fn new(config: Option<VehicleConfig>, capabilities: Capabilities, record: M) -> Self {
        let (config, known) = match config {
            Some(config) => (config, true),
            None => (VehicleConfig::REFERENCE, false),
        };
        Self {
            config,
            known,
            settings: Settings::DEFAULT,
            pairing: None,
            session: 0,
            slots: [const { None }; mintime_shared::messages::STORED_TABLES],
            keeper: Keeper::new(),
            damaged: Damage::NONE,
            unreadable: 0,
            capabilities,
            starting: false,
            store: StoreStatus { present: false, busy: false, finished: 0, failed: false },
            board: None,
            link_errors: 0,
            last_counter: 0,
            supervisor: Supervisor::new(),
            purpose: Purpose::Flight,
            on_bench: false,
            motor_test: None,
            incidents: Incidents::new(),
            state_since_us: 0,
            gyro: Gyro::new(),
            attitude: AttitudeEstimate::new(),
            turns: None,
            accel_mps2: None,
            battery_v: None,
            drive_v: None,
            sag_ticks: 0,
            missing_before: 0,
            kill: KillSwitch::Absent,
            tables: Tables::new(),
            player: Player::new(),
            recovery: Recovery::new(),
            rate: RateController::new(),
            drive: RotorDrive::new(),
            commanded: Setpoint { rates_radps: [0.0; 3], thrust_mps2: 0.0 },
            lifted: false,
            saturated_ticks: 0,
            runaway_ticks: 0,
            heard_us: None,
            host_setpoint: None,
            last_sequence: None,
            setpoints_lost: 0,
            last_trigger: None,
            verdicts: Verdicts::new(),
            last_refusal: None,
            calibrated_by: None,
            period: TickPeriod::new(),
            last_us: None,
            interval_us: TICK_PERIOD_US as u64,
            clock: Clock::Punctual,
            ticks: 0,
            late_ticks: 0,
            worst_interval_us: 0,
            recorder: Recorder::new(record),
            recording: false,
            to_log: None,
            to_record: None,
            to_estimate: None,
            events: EventLog::new(),
            telemetry_us: TELEMETRY_PERIOD_US,
            next_telemetry_us: 0,
        }
    }

    /// What the supervisor is doing.
    pub fn state(&self) -> FlightState {
        self.supervisor.state()
    }

    /// Says how many received frames were not messages, and the counter of the last seal taken: for who asks.
    pub fn set_link_status(&mut self, errors: u32, last_counter: u32) {
        self.link_errors = errors;
        self.last_counter = last_counter;
    }

    /// Says what this start's session is called; before anything is reported.
    pub fn set_session(&mut self, session: u32) {
        self.session = session;
        self.incidents.number_after(session);
    }

    /// Says what the board can do by now and how it does.
    pub fn set_board_status(&mut self, status: &BoardStatus) {
        self.capabilities = status.capabilities;
        self.starting = status.starting;
        self.board = Some(status.telemetry);
        self.note_store(status.store);
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
        self.clock = self.advance_clock(input.now_us);
        // Time stands still rather than runs backwards; the supervisor stops the motors for it.
        let now_us = self.last_us.unwrap_or(input.now_us);
        self.sense(input);

        let mut conditions = self.watch(now_us);
        self.take_orders(inbox, now_us, &mut conditions);
        // A setpoint taken just now counts, and any request says that the host is there.
        conditions |= self.host_conditions(now_us);
        if let Some((old, reason)) = self.supervisor.step(conditions) {
            self.enter(old, reason, now_us);
        }

        let setpoint = self.choose_setpoint(now_us);
        let output = self.control(setpoint, now_us);
        self.to_record = Some(output);
        // Here alone places of the frame become output lines.
        TickOutput { throttle: output.throttle.map(|t| to_outputs(&self.config, t)), ..output }
    }

    /// The part of a tick that the motors need not wait for: requests that do not bear on them, answers, the record.
    /// Nothing to do the second time.
    pub fn conclude(&mut self, inbox: &mut Inbox, outbox: &mut Outbox) {
        let now_us = self.last_us.unwrap_or(0);
        self.estimate();
        if let Some((old, reason)) = self.to_log.take() {
            let state = self.state();
            if old == FlightState::Calibrating && state == FlightState::Disarmed {
                self.events.push(now_us, Happening::Calibrated);
            }
            self.events.push(now_us, Happening::Entered(state));
            if let Some(reason) = reason {
                self.events.push(now_us, Happening::Aborted(reason));
            }
            if state == FlightState::Terminated {
                self.report(IncidentCause::Terminated(reason.unwrap_or(AbortReason::EmergencyStop)));
            }
        }
        self.answer(inbox, now_us, outbox);
        if let Some(tick) = self.to_record.take().and_then(|output| self.recorded(&output)) {
            self.recorder.push(now_us, tick);
        }
    }

    /// What the record says of this tick; the recorder fills the interval in.
    #[inline(never)]
    fn recorded(&self, output: &TickOutput) -> Option<RecordedTick> {
        let maneuver = self.state() == FlightState::Maneuver;
        let flag = |on: bool, bit: u16| if on { bit } else { 0 };
        (maneuver || (self.recording && self.state().airborne())).then(|| RecordedTick {
            interval_us: 0,
            gyro_radps: self.gyro.fresh_rates_radps(),
            rate_radps: self.player.plane().axes(output.setpoint.rates_radps)[1],
            thrust_mps2: output.setpoint.thrust_mps2,
            throttle: output.throttle.unwrap_or_default(),
            flags: flag(self.clock == Clock::Late, record_flags::LATE)
                | flag(self.saturated_ticks > 0, record_flags::SATURATED)
                | flag(self.setpoint_is_fresh(self.last_us.unwrap_or(0)), record_flags::HOST_FRESH)
                | flag(maneuver, record_flags::MANEUVER)
                | flag(self.battery_v.is_some(), record_flags::BATTERY),
        })
    }

    /// Says how the vehicle is when it is time to. Once a tick, after the motors have their command: it would delay one
    /// tick in sixteen.
    pub fn telemeter(&mut self, outbox: &mut Outbox) {
        // Where the clock ran backwards it stands still, but whoever listens shall hear of it.
        let due = |now: &u64| *now >= self.next_telemetry_us || self.clock == Clock::Backwards;
        let Some(now_us) = self.last_us.filter(due) else {
            return;
        };
        // Answers leave it a place. Where that is still taken the line is slow: the next tick tries again.
        if outbox.push_back(Message::Telemetry(self.telemetry())).is_ok() {
            self.next_telemetry_us = now_us.saturating_add(self.telemetry_us);
        }
    }
}

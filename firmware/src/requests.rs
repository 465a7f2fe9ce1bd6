//! What becomes of the host's requests, and the answer to each.

use heapless::Vec;
use mintime_shared::messages::{
    ArmingBlock, FlightState, Happening, Identity, MOTOR_TEST_MS_MAX, MOTOR_TEST_THROTTLE_MAX, Message,
    PROTOCOL_VERSION, Purpose, Refusal, Reply, Request, Setpoint, Uplink,
};
use mintime_shared::seal;
use mintime_shared::table::SCHEMA_HASH;

use crate::config::{FIRMWARE_VERSION, INBOX, OUTBOX, REPEATED_US, TELEMETRY_RANGE_MS};
use crate::flight::{FlightLogic, Inbox, MotorTest, Outbox};
use crate::keeping::{self, Key};
use crate::recorder::RecordMemory;
use crate::supervisor::Conditions;
use crate::tables::Commit;

/// What the first part of a tick makes of each request in the inbox, in order; the second part answers.
pub(crate) type Verdicts = Vec<Verdict, INBOX>;

/// What becomes of a request.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Verdict {
    /// It is nothing that the motors hang on: the second part carries it out.
    Later,
    /// Done, without an answer.
    Silent,
    /// Done already, or refused.
    Now(Result<(), Refusal>),
    /// Up to the supervisor: done if this state follows.
    After(FlightState),
}

impl<M: RecordMemory> FlightLogic<M> {
    /// Carries out what the motors hang on among the requests of one tick. What is up to the supervisor goes into
    /// `conditions`.
    pub(crate) fn take_orders(&mut self, inbox: &Inbox, now_us: u64, conditions: &mut Conditions) {
        self.verdicts.clear();
        let mut trigger = None;
        for uplink in inbox {
            let verdict = if uplink.version == PROTOCOL_VERSION {
                let recent = uplink.is_recent(now_us);
                // What has no time says not that its host is there: a bridge may have held it back.
                if recent && uplink.request.is_timed() {
                    self.heard_us = Some(now_us);
                }
                let verdict = if !recent && self.would_turn_motors(uplink, now_us) {
                    late(&uplink.request)
                } else {
                    self.take(uplink.number, &uplink.request, now_us, conditions)
                };
                // One maneuver a tick: another trigger would be told that its own is flown.
                if verdict == Verdict::After(FlightState::Maneuver)
                    && *trigger.get_or_insert(uplink.number) != uplink.number
                {
                    Verdict::Now(Err(Refusal::WrongState(FlightState::Maneuver)))
                } else {
                    verdict
                }
            } else {
                Verdict::Now(Err(Refusal::ProtocolVersion))
            };
            // The inbox is no longer than the list.
            let _ = self.verdicts.push(verdict);
        }
    }

    /// Carries out the rest and answers. Of what came in since, nothing is touched.
    pub(crate) fn answer(&mut self, inbox: &mut Inbox, now_us: u64, outbox: &mut Outbox) {
        let verdicts = core::mem::take(&mut self.verdicts);
        for verdict in &verdicts {
            // By reference: a request is 130 bytes long, and most use few of them.
            let Some(uplink) = inbox.front() else {
                return;
            };
            let number = uplink.number;
            let state = self.state();
            let reply = match *verdict {
                Verdict::Silent => None,
                Verdict::Now(Ok(())) => Some(Reply::Done),
                Verdict::Now(Err(refusal)) => Some(Reply::Refused(refusal)),
                Verdict::After(wanted) if state != wanted => Some(Reply::Refused(Refusal::WrongState(state))),
                Verdict::After(wanted) => {
                    if wanted == FlightState::Maneuver {
                        self.last_trigger = Some((number, now_us));
                    }
                    Some(Reply::Done)
                }
                Verdict::Later => {
                    Some(self.serve(number, &uplink.request, now_us).unwrap_or_else(Reply::Refused))
                }
            };
            if let Some(reply) = reply {
                if let Reply::Refused(refusal) = reply {
                    self.note_refusal(number, refusal, now_us);
                }
                // A full outbox means that the host asks faster than the link carries; it asks again after its timeout. The last
                // place is telemetry's: a host that does not hear it cannot fly.
                if outbox.len() < OUTBOX - 1 {
                    let _ = outbox.push_back(Message::Reply { number, reply });
                }
            }
            drop(inbox.pop_front());
        }
    }

    /// Into the event log, but each only once: a host that asks again and again must not flush it.
    #[inline(never)]
    fn note_refusal(&mut self, number: u16, refusal: Refusal, now_us: u64) {
        if self.last_refusal != Some((number, refusal)) {
            self.last_refusal = Some((number, refusal));
            // What passes by itself is asked for ten times a second.
            if !matches!(refusal, Refusal::ArmingBlocked(_)) {
                self.events.push(now_us, Happening::Refused(refusal));
            }
        }
    }

    /// Whether a request may bring about that a motor turns, or turns otherwise. Not where it has been carried out before.
    fn would_turn_motors(&self, uplink: &Uplink, now_us: u64) -> bool {
        match uplink.request {
            Request::Setpoint { .. } => true,
            Request::Arm(_) => self.state() != FlightState::Armed,
            Request::Trigger { checksum } => !self.has_triggered(uplink.number, checksum, now_us),
            Request::TestMotor { .. } => self.motor_test.is_none_or(|test| test.number != uplink.number),
            _ => false,
        }
    }

    /// Whether it was this very request that triggered the last maneuver.
    fn has_triggered(&self, number: u16, checksum: u32, now_us: u64) -> bool {
        is_repeated(self.last_trigger, number, now_us) && checksum == self.tables.committed_checksum()
    }

    fn take(&mut self, number: u16, request: &Request, now_us: u64, conditions: &mut Conditions) -> Verdict {
        match *request {
            Request::Heartbeat => Verdict::Silent,
            Request::Setpoint { sequence, setpoint } => self.take_setpoint(sequence, setpoint, now_us),
            Request::EmergencyStop => {
                *conditions |= Conditions::EMERGENCY_STOP;
                Verdict::After(FlightState::Terminated)
            }
            // It is so, whatever it is called.
            Request::Disarm if matches!(self.state(), FlightState::Boot | FlightState::Calibrating) => {
                Verdict::Now(Ok(()))
            }
            Request::Disarm => {
                *conditions |= Conditions::DISARM;
                Verdict::After(FlightState::Disarmed)
            }
            Request::Acknowledge { incident } => self.take_acknowledgement(incident, conditions),
            // Another one has come first.
            Request::Arm(purpose) if conditions.contains(Conditions::ARM) && self.purpose != purpose => {
                Verdict::Now(Err(Refusal::OtherPurpose))
            }
            Request::Arm(purpose) => match self.may_arm(purpose) {
                Ok(()) => {
                    if !self.state().motors_on() {
                        self.purpose = purpose;
                    }
                    *conditions |= Conditions::ARM;
                    Verdict::After(FlightState::Armed)
                }
                Err(refusal) => Verdict::Now(Err(refusal)),
            },
            // The answer was lost and the host asks again: it has been done. Never fly a maneuver twice for one request.
            Request::Trigger { checksum } if self.has_triggered(number, checksum, now_us) => {
                Verdict::Now(Ok(()))
            }
            Request::Trigger { checksum } => match self.may_trigger(checksum, now_us) {
                Ok(()) => {
                    *conditions |= Conditions::TRIGGER;
                    Verdict::After(FlightState::Maneuver)
                }
                Err(refusal) => Verdict::Now(Err(refusal)),
            },
            Request::TestMotor { motor, throttle, duration_ms } => {
                Verdict::Now(self.test_motor(number, motor, throttle, duration_ms, now_us))
            }
            _ => Verdict::Later,
        }
    }

    /// Only the oldest can be acknowledged: nobody skips what he has not been told of. Acknowledging what has been
    /// acknowledged is harmless.
    #[inline(never)]
    fn take_acknowledgement(&mut self, number: u16, conditions: &mut Conditions) -> Verdict {
        if self.state().motors_on() {
            return Verdict::Now(Err(Refusal::MotorsOn));
        }
        if self.incidents.is_over(number) {
            return Verdict::Now(Ok(()));
        }
        if self.incidents.oldest().is_none_or(|oldest| oldest.number != number) {
            return Verdict::Now(Err(Refusal::NoSuchIncident));
        }
        if self.leads_out(number) {
            if self.kill_refuses() {
                return Verdict::Now(Err(Refusal::KillSwitch));
            }
            *conditions |= Conditions::ACKNOWLEDGE;
        }
        Verdict::Later
    }

    /// Whether it is this incident that keeps the vehicle terminated.
    fn leads_out(&self, number: u16) -> bool {
        self.state() == FlightState::Terminated && self.incidents.is_termination(number)
    }

    /// What the motors do not hang on, in the state that the tick has led to.
    #[inline(never)]
    fn serve(&mut self, number: u16, request: &Request, now_us: u64) -> Result<Reply, Refusal> {
        let motors_off = || if self.state().motors_on() { Err(Refusal::MotorsOn) } else { Ok(()) };
        match *request {
            Request::Identify => Ok(Reply::Identity(self.identity())),
            Request::Status => Ok(Reply::Status(self.telemetry())),
            Request::SetTelemetry { period_ms } => {
                let (least, most) = TELEMETRY_RANGE_MS;
                if !(least..=most).contains(&period_ms) {
                    return Err(Refusal::OutOfRange);
                }
                self.telemetry_us = u64::from(period_ms) * 1000;
                self.next_telemetry_us = 0;
                Ok(Reply::Done)
            }
            Request::Stage { total, offset, ref bytes } => {
                motors_off()?;
                self.tables.stage(total, offset, bytes).map(|length| Reply::Staged { length })
            }
            Request::CommitTable { checksum } => {
                motors_off()?;
                let commit = self.tables.commit(checksum, &self.config)?;
                Ok(self.committed(commit, checksum, now_us))
            }
            Request::ReadTable => Ok(Reply::Table(self.tables.read())),
            Request::ListTables => {
                Ok(Reply::Tables(self.slots.iter().flatten().map(|slot| slot.listing.clone()).collect()))
            }
            Request::StoreTable { ref name, checksum } => {
                motors_off()?;
                let Some(place) = self.place_for(name) else { return Err(Refusal::StoreFull) };
                if self
                    .slots
                    .get(place)
                    .and_then(Option::as_ref)
                    .is_some_and(|slot| slot.listing.checksum == checksum)
                    && !self.damaged.of(Key::Table(place as u8))
                {
                    return Ok(Reply::Done);
                }
                if name.is_empty() || self.tables.committed_checksum() != checksum || checksum == 0 {
                    return Err(Refusal::NotCommitted);
                }
                let value = keeping::table_value(name, &self.tables.read());
                // Eight places.
                self.keep(Key::Table(place as u8), value, now_us)
            }
            Request::LoadTable { ref name } => {
                motors_off()?;
                let slot = self.slots.iter().flatten().find(|slot| slot.listing.name == *name);
                let slot = slot.ok_or(Refusal::NoSuchTable)?;
                let checksum = slot.listing.checksum;
                let commit = self.tables.load(&slot.bytes, checksum, &self.config)?;
                Ok(self.committed(commit, checksum, now_us))
            }
            Request::DeleteTable { ref name } => {
                motors_off()?;
                let named =
                    |slot: &Option<keeping::Slot>| slot.as_ref().is_some_and(|s| s.listing.name == *name);
                match self.slots.iter().position(named) {
                    None => Ok(Reply::Done),
                    Some(place) => self.keep(Key::Table(place as u8), Some(keeping::Value::new()), now_us),
                }
            }
            Request::ReadVehicle => Ok(Reply::Vehicle(self.known.then_some(self.config))),
            Request::WriteVehicle(config) => {
                motors_off()?;
                config.check().map_err(Refusal::Vehicle)?;
                if self.known && self.config == config && !self.damaged.of(Key::Vehicle) {
                    return Ok(Reply::Done);
                }
                self.keep(Key::Vehicle, keeping::value(&config), now_us)
            }
            Request::ReadSettings => Ok(Reply::Settings(self.settings)),
            Request::WriteSettings(settings) => {
                motors_off()?;
                settings.check().map_err(Refusal::Settings)?;
                if self.settings == settings && !self.damaged.of(Key::Settings) {
                    return Ok(Reply::Done);
                }
                self.keep(Key::Settings, keeping::value(&settings), now_us)
            }
            Request::Pair(key) => {
                motors_off()?;
                if self.pairing == key && !self.damaged.of(Key::Pairing) {
                    return Ok(Reply::Done);
                }
                let value = key.map_or(Some(keeping::Value::new()), |key| keeping::value(&key));
                self.keep(Key::Pairing, value, now_us)
            }
            Request::Calibrate => self.calibrate(number, now_us),
            Request::CalibrateScale { axis, turns } => self.calibrate_scale((number, axis, turns), now_us),
            // Another stop came with it: then it waits on, or nothing would be left to acknowledge.
            Request::Acknowledge { incident } if self.leads_out(incident) => {
                Err(Refusal::WrongState(FlightState::Terminated))
            }
            Request::Acknowledge { incident } => {
                // Not where the same acknowledgement came twice.
                if self.incidents.acknowledge(incident) {
                    self.events.push(now_us, Happening::Acknowledged(incident));
                }
                Ok(Reply::Done)
            }
            Request::Record => {
                if self.state() != FlightState::Tracking {
                    return Err(Refusal::WrongState(self.state()));
                }
                if !self.recording {
                    self.recorder.clear();
                    self.recording = true;
                }
                Ok(Reply::Done)
            }
            Request::ReadRecord { .. } if self.state() == FlightState::Maneuver => {
                Err(Refusal::WrongState(FlightState::Maneuver))
            }
            Request::ReadRecord { first } => {
                self.recorder.chunk(first).map(Reply::Record).ok_or(Refusal::NoRecord)
            }
            Request::ReadEvents { first } => Ok(Reply::Events(self.events.chunk(first))),
            // They have their verdict already.
            Request::Heartbeat
            | Request::Setpoint { .. }
            | Request::EmergencyStop
            | Request::Disarm
            | Request::Arm(_)
            | Request::TestMotor { .. }
            | Request::Trigger { .. } => Ok(Reply::Done),
        }
    }

    #[inline(never)]
    fn committed(&mut self, commit: Commit, checksum: u32, now_us: u64) -> Reply {
        let duration_s = match commit {
            Commit::Already(duration_s) => duration_s,
            Commit::New(plan) => {
                let duration_s = plan.duration_s();
                self.player.load(plan);
                self.events.push(now_us, Happening::Committed(checksum));
                duration_s
            }
        };
        Reply::Committed { checksum, duration_s }
    }

    #[inline(never)]
    fn take_setpoint(&mut self, sequence: u16, setpoint: Setpoint, now_us: u64) -> Verdict {
        if !setpoint.is_finite() {
            return Verdict::Now(Err(Refusal::NotFinite));
        }
        if !setpoint.is_in_range() {
            return Verdict::Now(Err(Refusal::OutOfRange));
        }
        if !self.state().motors_on() {
            return Verdict::Silent;
        }
        if self.purpose != Purpose::Flight {
            return Verdict::Now(Err(Refusal::OtherPurpose));
        }
        if let Some(last) = self.last_sequence {
            let step = sequence.wrapping_sub(last);
            // Half the numbers lie ahead, half behind: what is behind was overtaken on the way. Unless there was silence: then a
            // host begins anew, whatever its number. What was held back that long is late.
            let ahead = step <= u16::MAX / 2;
            if step == 0 || !ahead && self.setpoint_is_fresh(now_us) {
                return Verdict::Silent;
            }
            let lost = if ahead { u32::from(step) - 1 } else { 0 };
            self.setpoints_lost = self.setpoints_lost.saturating_add(lost);
        }
        self.last_sequence = Some(sequence);
        self.host_setpoint = Some((setpoint, now_us));
        Verdict::Silent
    }

    #[inline(never)]
    fn test_motor(
        &mut self,
        number: u16,
        motor: u8,
        throttle: f32,
        duration_ms: u16,
        now_us: u64,
    ) -> Result<(), Refusal> {
        if self.state() != FlightState::Armed {
            return Err(Refusal::WrongState(self.state()));
        }
        if self.purpose != Purpose::MotorTest {
            return Err(Refusal::OtherPurpose);
        }
        let sane = usize::from(motor) < crate::config::MOTOR_COUNT
            && (0.0..=MOTOR_TEST_THROTTLE_MAX).contains(&throttle)
            && duration_ms <= MOTOR_TEST_MS_MAX;
        if !sane {
            return Err(Refusal::OutOfRange);
        }
        // The answer was lost and the host asks again: its time goes on.
        if self.motor_test.is_none_or(|test| test.number != number) {
            let until_us = now_us.saturating_add(u64::from(duration_ms) * 1000);
            self.motor_test = Some(MotorTest { number, motor, throttle, until_us });
        }
        Ok(())
    }

    #[inline(never)]
    fn may_arm(&self, purpose: Purpose) -> Result<(), Refusal> {
        match self.state() {
            FlightState::Armed if self.purpose == purpose => Ok(()),
            FlightState::Armed => Err(Refusal::OtherPurpose),
            state if state.motors_on() => Err(Refusal::WrongState(state)),
            state => match self.arming_block() {
                block if block != ArmingBlock::none() => Err(Refusal::ArmingBlocked(block.0)),
                // It takes a tick from calibrated to disarmed.
                _ if state != FlightState::Disarmed => {
                    Err(Refusal::ArmingBlocked(ArmingBlock::NOT_CALIBRATED.0))
                }
                _ => Ok(()),
            },
        }
    }

    #[inline(never)]
    fn may_trigger(&self, checksum: u32, now_us: u64) -> Result<(), Refusal> {
        match self.state() {
            FlightState::Tracking => {}
            state => return Err(Refusal::WrongState(state)),
        }
        let Some(committed) = self.tables.committed().filter(|c| c.checksum == checksum) else {
            return Err(Refusal::NotCommitted);
        };
        if !self.setpoint_is_fresh(now_us) {
            return Err(Refusal::StaleSetpoint);
        }
        let Some(volts) = self.battery_v.filter(|v| *v >= self.config.battery_low_v) else {
            return Err(Refusal::BatteryLow);
        };
        let planned_mps2 = committed.table.limits.thrust_max_mps2;
        if planned_mps2 > at_hand(self.config.thrust_available_mps2(volts), self.thrust_cap_mps2()) {
            return Err(Refusal::BatteryThrust);
        }
        if self.is_in_start_gate(committed) { Ok(()) } else { Err(Refusal::OutsideGate) }
    }

    #[inline(never)]
    fn identity(&self) -> Identity {
        let limits = self.config.plan_limits();
        Identity {
            firmware_version: FIRMWARE_VERSION,
            table_schema: SCHEMA_HASH,
            vehicle: if self.known { self.config.hash() } else { 0 },
            session: self.session,
            paired: self.pairing.is_some(),
            last_counter: self.last_counter,
            last_counter_mac: self
                .pairing
                .as_ref()
                .map_or(0, |key| seal::vouch(key, self.session, self.last_counter)),
            thrust_min_mps2: limits.thrust_min_mps2,
            thrust_max_mps2: limits.thrust_max_mps2,
            rate_max_radps: limits.rate_max_radps,
        }
    }
}

/// What becomes of what would turn motors and came too late. A setpoint is not answered: the newest of those held back will do.
fn late(request: &Request) -> Verdict {
    if matches!(request, Request::Setpoint { .. }) {
        Verdict::Silent
    } else {
        Verdict::Now(Err(Refusal::Late))
    }
}

/// Whether a request of this number was there not long before: numbers wrap, and each host begins with its own.
pub(crate) fn is_repeated(before: Option<(u16, u64)>, number: u16, now_us: u64) -> bool {
    before.is_some_and(|(n, at_us)| n == number && now_us.saturating_sub(at_us) <= REPEATED_US)
}

fn at_hand(available_mps2: f32, cap_mps2: Option<f32>) -> f32 {
    cap_mps2.map_or(available_mps2, |cap| mintime_shared::real::at_most(available_mps2, cap))
}

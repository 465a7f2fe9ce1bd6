//! What becomes of the host's requests: the table store, and the answer to each.

use heapless::Vec;
use mintime_shared::messages::{
    ArmingBlock, FlightState, Identity, Message, PROTOCOL_VERSION, Refusal, Reply, Request, Setpoint,
};
use mintime_shared::replay::Plan;
use mintime_shared::table::{MAX_TABLE_BYTES, ManeuverTable, SCHEMA_HASH, TableError};

use crate::config::{FIRMWARE_VERSION, INBOX, REPEATED_TRIGGER_US, VehicleConfig};
use crate::flight::{FlightLogic, Inbox, Outbox};
use crate::recorder::RecordMemory;
use crate::supervisor::Conditions;

type TableBytes = Vec<u8, MAX_TABLE_BYTES>;

/// The staged bytes and the committed table. A commit checks everything first and then replaces the old table at
/// once; nothing else ever changes it.
#[derive(Clone, Debug, Default)]
pub(crate) struct Tables {
    staged: TableBytes,
    committed: Option<Committed>,
}

#[derive(Clone, Debug)]
struct Committed {
    table: ManeuverTable,
    checksum: u32,
}

impl Tables {
    pub(crate) const fn new() -> Self {
        Self { staged: Vec::new(), committed: None }
    }

    /// Checks the staged bytes and commits them. Returns the duration, s.
    fn commit(&mut self, checksum: u32, config: &VehicleConfig) -> Result<f32, Refusal> {
        if self.staged.is_empty() {
            // Asked again after the answer was lost: it is so already.
            let same = self.committed.as_ref().filter(|c| c.checksum == checksum);
            return same.map(|c| c.table.duration_s()).ok_or(Refusal::NotStaged);
        }
        let table = ManeuverTable::decode(&self.staged).map_err(Refusal::Table)?;
        if table.checksum() != checksum {
            return Err(Refusal::NotStaged);
        }
        table.check_for(config.hash(), &config.plan_limits()).map_err(Refusal::Table)?;
        let duration_s = table.duration_s();
        self.committed = Some(Committed { table, checksum });
        self.staged.clear();
        Ok(duration_s)
    }

    fn stage(&mut self, bytes: TableBytes) -> Result<u16, Refusal> {
        if bytes.is_empty() {
            return Err(Refusal::Table(TableError::Length));
        }
        let length = bytes.len() as u16;
        self.staged = bytes;
        Ok(length)
    }

    fn read(&self) -> TableBytes {
        let mut bytes = TableBytes::new();
        if let Some(c) = &self.committed {
            let mut buffer = [0; MAX_TABLE_BYTES];
            let length = c.table.encode(&mut buffer).unwrap_or(0);
            let _ = bytes.extend_from_slice(buffer.get(..length).unwrap_or_default());
        }
        bytes
    }

    /// Checksum of the committed table; 0 where there is none.
    pub(crate) fn committed_checksum(&self) -> u32 {
        self.committed.as_ref().map_or(0, |c| c.checksum)
    }

    /// The committed table, laid out in time.
    pub(crate) fn plan(&self) -> Option<Plan> {
        self.committed.as_ref().map(|c| Plan::new(&c.table))
    }
}

/// Answers that depend on what the supervisor makes of the request: done if this state follows.
pub(crate) type Pending = Vec<(u16, FlightState), INBOX>;

impl<M: RecordMemory> FlightLogic<M> {
    /// Carries out the requests of one tick. What is up to the supervisor goes into `conditions` and is answered after
    /// its step.
    pub(crate) fn take_requests(
        &mut self,
        inbox: &mut Inbox,
        now_us: u64,
        conditions: &mut Conditions,
        outbox: &mut Outbox,
    ) -> Pending {
        let mut pending = Pending::new();
        while let Some(uplink) = inbox.pop_front() {
            let number = uplink.number;
            let reply = if uplink.version == PROTOCOL_VERSION {
                self.take(number, uplink.request, now_us, conditions)
            } else {
                Outcome::Now(Reply::Refused(Refusal::ProtocolVersion))
            };
            match reply {
                Outcome::Now(reply) => send(outbox, number, reply),
                Outcome::Silent => {}
                // The inbox is no longer than the list.
                Outcome::After(state) => {
                    let _ = pending.push((number, state));
                }
            }
        }
        pending
    }

    /// Answers the requests that waited for the supervisor.
    pub(crate) fn answer(&mut self, pending: Pending, now_us: u64, outbox: &mut Outbox) {
        for (number, wanted) in pending {
            let state = self.state();
            if wanted == FlightState::Maneuver && state == wanted {
                self.last_trigger = Some((number, now_us));
            }
            let reply =
                if state == wanted { Reply::Done } else { Reply::Refused(Refusal::WrongState(state)) };
            send(outbox, number, reply);
        }
    }

    fn take(&mut self, number: u16, request: Request, now_us: u64, conditions: &mut Conditions) -> Outcome {
        let motors_on = self.state().motors_on();
        let result = match request {
            Request::Identify => Ok(Reply::Identity(self.identity())),
            Request::Status => Ok(Reply::Status(self.telemetry())),
            Request::StageTable(_) | Request::CommitTable { .. } if motors_on => Err(Refusal::MotorsOn),
            Request::StageTable(bytes) => self.tables.stage(bytes).map(|length| Reply::Staged { length }),
            Request::CommitTable { checksum } => {
                self.tables.commit(checksum, &self.config).map(|duration_s| Reply::Committed { duration_s })
            }
            Request::ReadTable => Ok(Reply::Table(self.tables.read())),
            Request::ReadRecord { .. } if self.state() == FlightState::Maneuver => {
                Err(Refusal::WrongState(FlightState::Maneuver))
            }
            Request::ReadRecord { first } => {
                self.recorder.chunk(first).map(Reply::Record).ok_or(Refusal::NoRecord)
            }
            Request::Setpoint(setpoint) => return self.take_setpoint(setpoint, now_us),
            Request::EmergencyStop => {
                *conditions |= Conditions::EMERGENCY_STOP;
                return Outcome::After(FlightState::Stopped);
            }
            Request::Disarm => {
                *conditions |= Conditions::DISARM;
                return Outcome::After(FlightState::Disarmed);
            }
            Request::Arm => match self.may_arm() {
                Ok(()) => {
                    *conditions |= Conditions::ARM;
                    return Outcome::After(FlightState::Armed);
                }
                Err(refusal) => Err(refusal),
            },
            // The answer was lost and the host asks again: it has been done. Never fly a maneuver twice for one request.
            Request::Trigger { checksum }
                if self.has_triggered(number, now_us) && checksum == self.tables.committed_checksum() =>
            {
                Ok(Reply::Done)
            }
            Request::Trigger { checksum } => match self.may_trigger(checksum, now_us) {
                Ok(()) => {
                    *conditions |= Conditions::TRIGGER;
                    return Outcome::After(FlightState::Maneuver);
                }
                Err(refusal) => Err(refusal),
            },
        };
        Outcome::Now(result.unwrap_or_else(Reply::Refused))
    }

    fn take_setpoint(&mut self, setpoint: Setpoint, now_us: u64) -> Outcome {
        if !setpoint.is_finite() {
            return Outcome::Now(Reply::Refused(Refusal::NotFinite));
        }
        if !setpoint.is_in_range() {
            return Outcome::Now(Reply::Refused(Refusal::OutOfRange));
        }
        if self.state().motors_on() {
            self.host_setpoint = Some((setpoint, now_us));
        }
        Outcome::Silent
    }

    /// Whether a maneuver was triggered by a request of this number, not long ago: numbers wrap.
    fn has_triggered(&self, number: u16, now_us: u64) -> bool {
        self.last_trigger
            .is_some_and(|(n, at)| n == number && now_us.saturating_sub(at) <= REPEATED_TRIGGER_US)
    }

    fn may_arm(&self) -> Result<(), Refusal> {
        match self.state() {
            FlightState::Armed => Ok(()),
            FlightState::Disarmed | FlightState::Stopped => match self.arming_block() {
                block if block == ArmingBlock::none() => Ok(()),
                ArmingBlock(bits) => Err(Refusal::ArmingBlocked(bits)),
            },
            state => Err(Refusal::WrongState(state)),
        }
    }

    fn may_trigger(&self, checksum: u32, now_us: u64) -> Result<(), Refusal> {
        match self.state() {
            FlightState::Flying => {}
            state => return Err(Refusal::WrongState(state)),
        }
        if self.tables.committed.is_none() || self.tables.committed_checksum() != checksum {
            return Err(Refusal::NotCommitted);
        }
        if !self.setpoint_is_fresh(now_us) {
            return Err(Refusal::StaleSetpoint);
        }
        if self.battery_v.is_none_or(|v| v < self.config.battery_low_v) {
            return Err(Refusal::BatteryLow);
        }
        Ok(())
    }

    fn identity(&self) -> Identity {
        Identity {
            firmware_version: FIRMWARE_VERSION,
            table_schema: SCHEMA_HASH,
            vehicle: self.config.hash(),
            thrust_max_mps2: self.config.plan_thrust_max_mps2,
            rate_max_radps: self.config.plan_rate_max_radps,
        }
    }
}

#[expect(clippy::large_enum_variant, reason = "no allocator to box with; it lives for one call")]
enum Outcome {
    /// Answer at once.
    Now(Reply),
    /// Answer when the supervisor has decided: done if this state follows.
    After(FlightState),
    /// No answer.
    Silent,
}

fn send(outbox: &mut Outbox, number: u16, reply: Reply) {
    // A full outbox means that the host asks faster than the link carries; it asks again after its timeout.
    let _ = outbox.push_back(Message::Reply { number, reply });
}

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
    /// Why the staged bytes cannot be flown, where that is known: a host that asks again and again costs nothing.
    refused: Option<Refusal>,
    committed: Option<Committed>,
}

#[derive(Clone, Debug)]
struct Committed {
    table: ManeuverTable,
    checksum: u32,
}

impl Tables {
    pub(crate) const fn new() -> Self {
        Self { staged: Vec::new(), refused: None, committed: None }
    }

    /// Checks the staged bytes and commits them. Returns the duration, s.
    fn commit(&mut self, checksum: u32, config: &VehicleConfig) -> Result<Commit, Refusal> {
        if self.staged.is_empty() {
            // Asked again after the answer was lost: it is so already.
            let same = self.committed.as_ref().filter(|c| c.checksum == checksum);
            return same.map(|c| Commit::Already(c.table.duration_s())).ok_or(Refusal::NotStaged);
        }
        if let Some(refusal) = self.refused {
            return Err(refusal);
        }
        let table = self.check(checksum, config).inspect_err(|refusal| {
            // It stays so until other bytes are staged, except that another checksum may be named.
            self.refused = Some(*refusal).filter(|r| *r != Refusal::NotStaged);
        })?;
        let plan = Plan::new(&table);
        self.committed = Some(Committed { table, checksum });
        self.staged.clear();
        Ok(Commit::New(plan))
    }

    /// The staged table, if it can be flown. The dearest thing there is: 0.3 ms.
    fn check(&self, checksum: u32, config: &VehicleConfig) -> Result<ManeuverTable, Refusal> {
        let table = ManeuverTable::decode(&self.staged).map_err(Refusal::Table)?;
        if table.checksum() != checksum {
            return Err(Refusal::NotStaged);
        }
        table.check_for(config.hash(), &config.plan_limits()).map_err(Refusal::Table)?;
        Ok(table)
    }

    fn stage(&mut self, bytes: &TableBytes) -> Result<u16, Refusal> {
        if bytes.is_empty() {
            return Err(Refusal::Table(TableError::Length));
        }
        let length = bytes.len() as u16;
        self.staged.clone_from(bytes);
        self.refused = None;
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
}

/// What a commit did.
#[expect(clippy::large_enum_variant, reason = "no allocator to box with; it lives for one call")]
enum Commit {
    /// The table is committed; this is it in time.
    New(Plan),
    /// It was before; its duration, s.
    Already(f32),
}

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
        for uplink in inbox {
            let verdict = if uplink.version == PROTOCOL_VERSION {
                self.take(uplink.number, &uplink.request, now_us, conditions)
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
            // By reference: a request is 200 bytes long, and most use few of them.
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
                Verdict::Later => Some(self.serve(&uplink.request).unwrap_or_else(Reply::Refused)),
            };
            if let Some(reply) = reply {
                // A full outbox means that the host asks faster than the link carries; it asks again after its timeout.
                let _ = outbox.push_back(Message::Reply { number, reply });
            }
            drop(inbox.pop_front());
        }
    }

    fn take(&mut self, number: u16, request: &Request, now_us: u64, conditions: &mut Conditions) -> Verdict {
        match *request {
            Request::Identify
            | Request::Status
            | Request::StageTable(_)
            | Request::CommitTable { .. }
            | Request::ReadTable
            | Request::ReadRecord { .. } => Verdict::Later,
            Request::Setpoint(setpoint) => self.take_setpoint(setpoint, now_us),
            Request::EmergencyStop => {
                *conditions |= Conditions::EMERGENCY_STOP;
                Verdict::After(FlightState::Stopped)
            }
            Request::Disarm => {
                *conditions |= Conditions::DISARM;
                Verdict::After(FlightState::Disarmed)
            }
            Request::Arm => match self.may_arm() {
                Ok(()) => {
                    *conditions |= Conditions::ARM;
                    Verdict::After(FlightState::Armed)
                }
                Err(refusal) => Verdict::Now(Err(refusal)),
            },
            // The answer was lost and the host asks again: it has been done. Never fly a maneuver twice for one request.
            Request::Trigger { checksum }
                if self.has_triggered(number, now_us) && checksum == self.tables.committed_checksum() =>
            {
                Verdict::Now(Ok(()))
            }
            Request::Trigger { checksum } => match self.may_trigger(checksum, now_us) {
                Ok(()) => {
                    *conditions |= Conditions::TRIGGER;
                    Verdict::After(FlightState::Maneuver)
                }
                Err(refusal) => Verdict::Now(Err(refusal)),
            },
        }
    }

    /// What the motors do not hang on, in the state that the tick has led to.
    fn serve(&mut self, request: &Request) -> Result<Reply, Refusal> {
        let motors_on = self.state().motors_on();
        match *request {
            Request::Identify => Ok(Reply::Identity(self.identity())),
            Request::Status => Ok(Reply::Status(self.telemetry())),
            Request::StageTable(_) | Request::CommitTable { .. } if motors_on => Err(Refusal::MotorsOn),
            Request::StageTable(ref bytes) => self.tables.stage(bytes).map(|length| Reply::Staged { length }),
            Request::CommitTable { checksum } => self.commit(checksum),
            Request::ReadTable => Ok(Reply::Table(self.tables.read())),
            Request::ReadRecord { .. } if self.state() == FlightState::Maneuver => {
                Err(Refusal::WrongState(FlightState::Maneuver))
            }
            Request::ReadRecord { first } => {
                self.recorder.chunk(first).map(Reply::Record).ok_or(Refusal::NoRecord)
            }
            // They have their verdict already.
            Request::Setpoint(_)
            | Request::EmergencyStop
            | Request::Disarm
            | Request::Arm
            | Request::Trigger { .. } => Ok(Reply::Done),
        }
    }

    fn commit(&mut self, checksum: u32) -> Result<Reply, Refusal> {
        let duration_s = match self.tables.commit(checksum, &self.config)? {
            Commit::Already(duration_s) => duration_s,
            Commit::New(plan) => {
                let duration_s = plan.duration_s();
                self.player.load(plan);
                duration_s
            }
        };
        Ok(Reply::Committed { duration_s })
    }

    fn take_setpoint(&mut self, setpoint: Setpoint, now_us: u64) -> Verdict {
        if !setpoint.is_finite() {
            return Verdict::Now(Err(Refusal::NotFinite));
        }
        if !setpoint.is_in_range() {
            return Verdict::Now(Err(Refusal::OutOfRange));
        }
        if self.state().motors_on() {
            self.host_setpoint = Some((setpoint, now_us));
        }
        Verdict::Silent
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

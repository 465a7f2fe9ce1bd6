//! The flight logic with its link: what a board owns.

use mintime_shared::messages::{FlightState, Incident, IncidentCause};

use crate::config::{BoardStatus, Capabilities, VehicleConfig};
use crate::flight::{FlightLogic, Inbox, Outbox, TickInput, TickOutput};
use crate::keeping::{Job, Key};
use crate::link::Link;
use crate::recorder::RecordMemory;
use crate::store::Damage;

/// Serial bytes and sensor samples in, serial bytes and throttles out.
#[derive(Debug)]
pub struct Vehicle<M> {
    link: Link,
    inbox: Inbox,
    outbox: Outbox,
    logic: FlightLogic<M>,
}

impl<M: RecordMemory> Vehicle<M> {
    /// A vehicle that was just switched on. `config` is what it is if it has been told, `None` until its vehicle file is
    /// [restored](Self::restore) or written; `record` is the memory for flight records, 20 bytes a tick.
    pub const fn new(config: Option<VehicleConfig>, capabilities: Capabilities, record: M) -> Self {
        Self {
            link: Link::new(),
            inbox: Inbox::new(),
            outbox: Outbox::new(),
            logic: FlightLogic::new(config, capabilities, record),
        }
    }

    /// Hands back what was kept under a key before the power went. Before the first tick. Returns whether it could be used.
    pub fn restore(&mut self, key: Key, value: &[u8]) -> bool {
        self.logic.restore(key, value)
    }

    /// Says of which keys the value that was written last may be lost. Before the first tick.
    pub fn note_damage(&mut self, damage: Damage) {
        self.logic.note_damage(damage);
    }

    /// Says what happened before this start, or to the board. It blocks arming until a person has acknowledged it. Returns
    /// its number.
    pub fn report(&mut self, cause: IncidentCause) -> u16 {
        self.logic.report(cause)
    }

    /// A number that no earlier start of this vehicle had: what seals are made for.
    pub fn set_session(&mut self, session: u32) {
        self.link.set_session(session);
        self.logic.set_session(session);
    }

    /// Takes bytes from the serial line, in any pieces.
    pub fn receive(&mut self, bytes: &[u8]) {
        // What an emergency stop may displace must not be a request with its verdict.
        self.conclude();
        self.link.receive(bytes, self.logic.pairing(), &mut self.inbox);
    }

    /// One control tick, as far as the motors wait for it; the rest of it is done by whatever is called next. Deadline and
    /// bounds: see [`crate::flight`].
    pub fn tick(&mut self, input: &TickInput) -> TickOutput {
        self.conclude();
        self.logic.set_link_status(self.link.errors(), self.link.last_counter());
        self.link.put_question(&mut self.inbox);
        self.logic.command(input, &self.inbox)
    }

    fn conclude(&mut self) {
        self.logic.conclude(&mut self.inbox, &mut self.outbox);
    }

    /// Does the rest of the tick, then fills `out` with bytes for the serial line and returns how many. After each tick,
    /// once the motors have their command.
    pub fn transmit(&mut self, out: &mut [u8]) -> usize {
        self.conclude();
        self.logic.telemeter(&mut self.outbox);
        self.link.transmit(&mut self.outbox, out)
    }

    /// Says what the board can do by now and how it does; takes effect with the next tick. Where nobody says, what
    /// [`Vehicle::new`] was given stays true.
    #[inline(never)]
    pub fn set_board_status(&mut self, status: &BoardStatus) {
        self.logic.set_board_status(status);
    }

    /// What the board shall write to flash now, if anything; the motors are off while there is. Done when
    /// [`crate::config::StoreStatus::finished`] names its ticket.
    pub fn job(&self) -> Option<&Job> {
        self.logic.job()
    }

    /// All that waits to be acknowledged, the oldest first.
    pub fn incidents(&self) -> impl Iterator<Item = &Incident> {
        self.logic.incidents()
    }

    /// What waits to be acknowledged; of several the oldest.
    pub fn incident(&self) -> Option<Incident> {
        self.logic.incident()
    }

    /// Whether a measured battery voltage can be this vehicle's.
    pub fn is_plausible_battery(&self, volts: Option<f32>) -> bool {
        volts.is_some_and(|v| self.logic.config().is_plausible_battery(v))
    }

    /// Whether it takes only what is sealed with its key.
    pub fn is_paired(&self) -> bool {
        self.logic.pairing().is_some()
    }

    /// What the supervisor is doing.
    pub fn state(&self) -> FlightState {
        self.logic.state()
    }

    /// Channel of the receiver that is the kill switch, from 1, and its threshold, µs: run above, stop at it and below.
    pub fn kill_switch(&self) -> (u8, u16) {
        let settings = self.logic.settings();
        (settings.kill_channel, settings.kill_run_us)
    }
}

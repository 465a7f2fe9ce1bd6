//! The flight logic with its link: what a board owns.

use mintime_shared::messages::FlightState;

use crate::config::{BoardStatus, Capabilities, VehicleConfig};
use crate::flight::{FlightLogic, Inbox, Outbox, TickInput, TickOutput};
use crate::link::Link;
use crate::recorder::RecordMemory;

/// Serial bytes and sensor samples in, serial bytes and throttles out.
#[derive(Debug)]
pub struct Vehicle<M> {
    link: Link,
    inbox: Inbox,
    outbox: Outbox,
    logic: FlightLogic<M>,
}

impl<M: RecordMemory> Vehicle<M> {
    /// A vehicle that was just switched on. `record` is the memory for flight records, 20 bytes a tick.
    pub const fn new(config: VehicleConfig, capabilities: Capabilities, record: M) -> Self {
        Self {
            link: Link::new(),
            inbox: Inbox::new(),
            outbox: Outbox::new(),
            logic: FlightLogic::new(config, capabilities, record),
        }
    }

    /// Takes bytes from the serial line, in any pieces.
    pub fn receive(&mut self, bytes: &[u8]) {
        // What an emergency stop may displace must not be a request with its verdict.
        self.conclude();
        self.link.receive(bytes, &mut self.inbox);
    }

    /// One control tick, as far as the motors wait for it; the rest of it is done by whatever is called next. Deadline and
    /// bounds: see [`crate::flight`].
    pub fn tick(&mut self, input: &TickInput) -> TickOutput {
        self.conclude();
        self.logic.set_link_errors(self.link.errors());
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
    pub fn set_board_status(&mut self, status: &BoardStatus) {
        self.logic.set_board_status(status);
    }

    /// What the supervisor is doing.
    pub fn state(&self) -> FlightState {
        self.logic.state()
    }
}

//! The host's end of the link: requests out, answers and telemetry in, over any [`Connection`].

use mintime_shared::framing::{Decoder, encode};
use mintime_shared::messages::{
    Downlink, Message, PROTOCOL_VERSION, Refusal, Reply, Request, Setpoint, Telemetry, Uplink,
};

use super::connection::{Connection, ConnectionError};

/// An answer is waited for this long before the request is sent again, s.
const ANSWER_TIMEOUT_S: f64 = 0.05;
/// Times a request is sent before the vehicle counts as silent. Every request is harmless when repeated.
const TRIES: u32 = 10;

/// Why a request has no answer.
#[derive(Debug, thiserror::Error)]
pub enum ClientError {
    /// The vehicle said no, and why.
    #[error("{0}")]
    Refused(Refusal),
    /// Nothing came back.
    #[error("the vehicle does not answer: check the link, the baud rate (921600) and the power")]
    Silent,
    /// Something else came back.
    #[error("the vehicle gave an answer that does not fit the question: update its firmware")]
    Mismatch,
    /// The vehicle speaks another protocol.
    #[error(
        "the vehicle speaks protocol version {0}, this mintime speaks {PROTOCOL_VERSION}: flash its firmware again"
    )]
    Version(u8),
    /// The line failed.
    #[error(transparent)]
    Connection(#[from] ConnectionError),
}

/// A request under way.
#[derive(Debug)]
struct Pending {
    number: u16,
    request: Request,
    sent_s: f64,
    tries: u32,
}

/// Keeps requests, answers and telemetry in order.
#[derive(Debug, Default)]
pub struct Client {
    decoder: Decoder,
    received: Vec<u8>,
    number: u16,
    /// Of the newest setpoint.
    sequence: u16,
    pending: Option<Pending>,
    telemetry: Option<Telemetry>,
    line_errors: u32,
    foreign_version: Option<u8>,
}

impl Client {
    /// The newest telemetry.
    pub fn telemetry(&self) -> Option<&Telemetry> {
        self.telemetry.as_ref()
    }

    /// Received frames that were not messages.
    pub fn line_errors(&self) -> u32 {
        self.line_errors
    }

    /// Streams a setpoint; it is not answered.
    ///
    /// # Errors
    /// [`ConnectionError`] of the line.
    pub fn stream(&mut self, line: &mut impl Connection, setpoint: Setpoint) -> Result<(), ConnectionError> {
        let number = self.next_number();
        self.sequence = self.sequence.wrapping_add(1);
        transmit(line, number, Request::Setpoint { sequence: self.sequence, setpoint })
    }

    /// Sends a request; [`poll`](Self::poll) brings the answer. One request at a time: an earlier one still under way
    /// is forgotten.
    ///
    /// # Errors
    /// [`ConnectionError`] of the line.
    pub fn ask(
        &mut self,
        line: &mut impl Connection,
        request: Request,
        now_s: f64,
    ) -> Result<(), ConnectionError> {
        let number = self.next_number();
        transmit(line, number, request.clone())?;
        self.pending = Some(Pending { number, request, sent_s: now_s, tries: 1 });
        Ok(())
    }

    /// Reads what has arrived and repeats a request that stays unanswered. `Some` with the answer to the request under
    /// way.
    ///
    /// # Errors
    /// [`ClientError`]; a refusal is one.
    pub fn poll(&mut self, line: &mut impl Connection, now_s: f64) -> Result<Option<Reply>, ClientError> {
        self.received.clear();
        line.receive(&mut self.received)?;
        let mut answer = None;
        for byte in core::mem::take(&mut self.received) {
            match self.decoder.push::<Downlink>(byte) {
                None => {}
                Some(Err(_)) => self.line_errors += 1,
                Some(Ok(Downlink { version, .. })) if version != PROTOCOL_VERSION => {
                    self.foreign_version = Some(version);
                }
                Some(Ok(Downlink { message: Message::Telemetry(telemetry), .. })) => {
                    self.telemetry = Some(telemetry);
                }
                Some(Ok(Downlink { message: Message::Reply { number, reply }, .. }))
                    if self.pending.as_ref().is_some_and(|p| p.number == number) =>
                {
                    if reply == Reply::Pending {
                        // It is under way: ask again later, for as long as somebody says so.
                        if let Some(pending) = &mut self.pending {
                            (pending.sent_s, pending.tries) = (now_s, 1);
                        }
                        continue;
                    }
                    answer = Some(reply);
                    self.pending = None;
                }
                // The answer to a request that was repeated and answered meanwhile.
                Some(Ok(Downlink { message: Message::Reply { .. }, .. })) => {}
            }
        }
        if let Some(Reply::Refused(refusal)) = answer {
            return Err(ClientError::Refused(refusal));
        }
        if answer.is_none() {
            self.repeat(line, now_s)?;
        }
        Ok(answer)
    }

    fn repeat(&mut self, line: &mut impl Connection, now_s: f64) -> Result<(), ClientError> {
        let Some(pending) = &mut self.pending else {
            return Ok(());
        };
        if now_s - pending.sent_s < ANSWER_TIMEOUT_S {
            return Ok(());
        }
        if pending.tries >= TRIES {
            self.pending = None;
            return Err(self.foreign_version.map_or(ClientError::Silent, ClientError::Version));
        }
        pending.tries += 1;
        pending.sent_s = now_s;
        Ok(transmit(line, pending.number, pending.request.clone())?)
    }

    fn next_number(&mut self) -> u16 {
        self.number = self.number.wrapping_add(1);
        self.number
    }
}

fn transmit(line: &mut impl Connection, number: u16, request: Request) -> Result<(), ConnectionError> {
    let uplink = Uplink { version: PROTOCOL_VERSION, number, request };
    // No request of the protocol is longer than a frame; the type bounds every part.
    let frame = encode(&uplink).map_err(|e| std::io::Error::other(e.to_string()))?;
    // A zero first: whatever noise or half a frame came before, this frame begins afresh.
    line.send(&[0])?;
    line.send(frame.as_bytes())
}

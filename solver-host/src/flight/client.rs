//! The host's end of the link: requests out, answers and telemetry in, over any [`Line`].
//!
//! Every request has a number; what stays unanswered is sent again under the same one, so that it is done once. `Pending`
//! is asked again until it is done. Where the vehicle is paired, everything but the question who it is carries a seal.

use std::collections::VecDeque;
use std::hash::BuildHasher;

use mintime_shared::framing::{Decoder, Frame};
use mintime_shared::messages::{
    Downlink, Message, PROTOCOL_VERSION, RECORD_BYTES, RecordChunk, RecordedTick, Refusal, Reply, Request,
    Setpoint, Telemetry, Uplink,
};
use mintime_shared::seal::{PairingKey, seal, vouch};

use super::connection::{ConnectionError, Line};
use super::seal_counter::{self, LONGEST_TRIP_S, SealCounter};

/// An answer is waited for this long before the request is sent again, s.
const ANSWER_TIMEOUT_S: f64 = 0.05;
/// Times a request is sent before the vehicle counts as silent. Every request is harmless when repeated.
const TRIES: u32 = 10;
/// A request whose seal is refused is sent anew, with the vehicle's counter known, this often.
const LEARNED_ANEW: u32 = 8;
/// Numbers that are remembered of what was sealed, and of questions who is there: a second of a flight.
const REMEMBERED: usize = 128;
/// What is under way on the vehicle is asked for again this often, s ...
const PENDING_PERIOD_S: f64 = 0.1;
/// ... and for this long, s: erasing a sector of flash takes two seconds at worst.
const PENDING_TIMEOUT_S: f64 = 10.0;
/// ... but for this long where a person turns the vehicle by hand, s: the vehicle's own patience, 20 s until it rests, 20 s until
/// it is turned, 30 s of turning.
const BY_HAND_TIMEOUT_S: f64 = 75.0;

/// Why a request has no answer.
#[derive(Debug, thiserror::Error)]
pub enum ClientError {
    /// The vehicle said no, and why.
    #[error("{0}")]
    Refused(Refusal),
    /// Nothing came back.
    #[error("the vehicle does not answer: check the link, the baud rate (921600) and the power")]
    Silent,
    /// It says that it is at it, but does not finish.
    #[error("the vehicle has been at it for {0} s and does not finish: switch it off and on, and try again")]
    Unfinished(f64),
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
#[derive(Clone, Debug)]
struct Pending {
    number: u16,
    request: Request,
    sent_s: f64,
    tries: u32,
    /// Since when the vehicle says that it is at it, s.
    working_since_s: Option<f64>,
    /// How it was refused, where that may pass: its seal was overtaken, or it came too late.
    refused: Option<Refusal>,
    /// It was sent anew with a counter that the vehicle told.
    learned: u32,
    /// Telemetry messages before it was asked.
    telemetry_count: u64,
}

/// A question who is there.
#[derive(Clone, Copy, Debug)]
struct Question {
    number: u16,
    asked_s: f64,
    /// For the counter of seals alone: whoever is at work with a vehicle does not want to hear that it has been reset.
    counter_only: bool,
}

/// Keeps requests, answers and telemetry in order.
#[derive(Clone, Debug, Default)]
pub struct Client {
    decoder: Decoder,
    received: Vec<u8>,
    /// Replies that have arrived and were not looked at.
    replies: VecDeque<(u16, Reply)>,
    number: u16,
    sequence: u16,
    pending: Option<Pending>,
    telemetry: Option<Telemetry>,
    telemetry_count: u64,
    /// The vehicle's clock as it was heard last.
    heard_ms: u32,
    line_errors: u32,
    repeats: u32,
    round_trip_s: Option<f64>,
    foreign_version: Option<u8>,
    key: Option<PairingKey>,
    /// The vehicle's session, if it wants seals.
    session: Option<u32>,
    seals: SealCounter,
    /// Numbers of what was sealed last.
    sealed: VecDeque<u16>,
    /// The last questions who is there.
    questions: VecDeque<Question>,
}

impl Client {
    /// A client that seals with this key where the vehicle asks for it.
    pub fn with_key(key: Option<PairingKey>) -> Self {
        Self { key, ..Self::default() }
    }

    /// Begins the requests' numbers at an arbitrary one: a vehicle that has just been asked by another program would take the
    /// same number for the same request.
    #[must_use]
    pub fn numbered_anew(mut self) -> Self {
        // Its keys are drawn at random.
        self.number = std::hash::RandomState::new().hash_one(std::process::id()) as u16;
        self
    }

    /// Seals with another key from now on.
    pub fn set_key(&mut self, key: Option<PairingKey>) {
        self.key = key;
    }

    /// Whether the vehicle has said which session its seals are made for.
    pub fn knows_session(&self) -> bool {
        self.session.is_some()
    }

    /// The newest telemetry.
    pub fn telemetry(&self) -> Option<&Telemetry> {
        self.telemetry.as_ref()
    }

    /// Telemetry messages so far.
    pub fn telemetry_count(&self) -> u64 {
        self.telemetry_count
    }

    /// Received frames that were not messages.
    pub fn line_errors(&self) -> u32 {
        self.line_errors
    }

    /// Requests that were sent again because no answer came in time.
    pub fn repeats(&self) -> u32 {
        self.repeats
    }

    /// From sending to answer, of the last request that was sent once, s.
    pub fn round_trip_s(&self) -> Option<f64> {
        self.round_trip_s
    }

    /// Streams a setpoint; it is not answered.
    ///
    /// # Errors
    /// [`ConnectionError`] of the line.
    pub fn stream(&mut self, line: &mut impl Line, setpoint: Setpoint) -> Result<(), ConnectionError> {
        self.sequence = self.sequence.wrapping_add(1);
        let number = self.next_number();
        self.transmit(line, number, Request::Setpoint { sequence: self.sequence, setpoint })
    }

    /// Tells the vehicle that the host is there; it is not answered.
    ///
    /// # Errors
    /// [`ConnectionError`] of the line.
    pub fn heartbeat(&mut self, line: &mut impl Line) -> Result<(), ConnectionError> {
        let number = self.next_number();
        self.transmit(line, number, Request::Heartbeat)
    }

    /// Sends a request; [`poll`](Self::poll) brings the answer. One request at a time: an earlier one still under way
    /// is forgotten.
    ///
    /// # Errors
    /// [`ConnectionError`] of the line.
    pub fn ask(&mut self, line: &mut impl Line, request: Request, now_s: f64) -> Result<(), ConnectionError> {
        let number = self.next_number();
        match request {
            Request::Identify => {
                remember(&mut self.questions, Question { number, asked_s: now_s, counter_only: false });
            }
            Request::EmergencyStop => self.seals.hurry(seal_counter::now_s()),
            _ => {}
        }
        self.transmit(line, number, request.clone())?;
        self.pending = Some(Pending {
            number,
            request,
            sent_s: now_s,
            tries: 1,
            working_since_s: None,
            refused: None,
            learned: 0,
            telemetry_count: self.telemetry_count,
        });
        Ok(())
    }

    /// Sends the request under way once more, under its number, without waiting for its time.
    ///
    /// # Errors
    /// [`ConnectionError`] of the line.
    pub fn insist(&mut self, line: &mut impl Line, now_s: f64) -> Result<(), ConnectionError> {
        let Some(pending) = &mut self.pending else {
            return Ok(());
        };
        pending.tries += 1;
        pending.sent_s = now_s;
        let (number, request) = (pending.number, pending.request.clone());
        if let Some(question) = self.questions.iter_mut().rfind(|q| q.number == number) {
            question.asked_s = now_s;
        } else if request == Request::Identify {
            // Its answer was not believed.
            remember(&mut self.questions, Question { number, asked_s: now_s, counter_only: false });
        }
        self.transmit(line, number, request)
    }

    /// Whether this request is under way.
    pub fn is_waiting_for(&self, request: &Request) -> bool {
        self.pending.as_ref().is_some_and(|pending| pending.request == *request)
    }

    /// Reads what has arrived and repeats a request that stays unanswered. `Some` with the answer to the request under
    /// way.
    ///
    /// # Errors
    /// [`ClientError`]; a refusal is one.
    pub fn poll(&mut self, line: &mut impl Line, now_s: f64) -> Result<Option<Reply>, ClientError> {
        self.hear(line)?;
        let mut answer = None;
        while let Some((number, reply)) = self.replies.pop_front() {
            self.keep_up(line, number, &reply, now_s)?;
            answer = self.take(number, reply, now_s).or(answer);
        }
        match answer {
            Some(Reply::Refused(refusal)) => return Err(ClientError::Refused(refusal)),
            Some(_) => {}
            None => self.repeat(line, now_s)?,
        }
        Ok(answer)
    }

    /// Reads what has arrived: telemetry counts at once, replies wait for [`poll`](Self::poll).
    fn hear(&mut self, line: &mut impl Line) -> Result<(), ConnectionError> {
        self.received.clear();
        // What came before a failure counts.
        let end = line.receive(&mut self.received);
        for byte in &self.received {
            match self.decoder.push::<Downlink>(*byte) {
                None => {}
                Some(Err(_)) => self.line_errors += 1,
                Some(Ok(Downlink { version, .. })) if version != PROTOCOL_VERSION => {
                    self.foreign_version = Some(version);
                }
                Some(Ok(Downlink { message: Message::Telemetry(telemetry), .. })) => {
                    self.heard_ms = telemetry.clock_ms();
                    self.telemetry = Some(telemetry);
                    self.telemetry_count += 1;
                }
                Some(Ok(Downlink { message: Message::Reply { number, reply }, .. })) => {
                    if let Reply::Status(telemetry) = &reply {
                        self.heard_ms = telemetry.clock_ms();
                    }
                    self.replies.push_back((number, reply));
                }
            }
        }
        end
    }

    /// What a reply means for the request under way: `Some` where it ends it. Answers to requests that were repeated and
    /// answered meanwhile mean nothing.
    fn take(&mut self, number: u16, reply: Reply, now_s: f64) -> Option<Reply> {
        let pending = self.pending.as_mut().filter(|p| p.number == number)?;
        match reply {
            Reply::Pending => {
                pending.working_since_s.get_or_insert(now_s);
                return None;
            }
            // On a line that reorders, a seal may be overtaken by a newer one: that alone proves no wrong key.
            Reply::Refused(Refusal::NotSealed) if self.key.is_some() && self.session.is_some() => {
                pending.refused = Some(Refusal::NotSealed);
                return None;
            }
            // Said again it carries a younger time.
            Reply::Refused(Refusal::Late) => {
                pending.refused = Some(Refusal::Late);
                return None;
            }
            _ => {}
        }
        if pending.tries == 1 {
            self.round_trip_s = Some(now_s - pending.sent_s);
        }
        self.pending = None;
        Some(reply)
    }

    /// What a reply says of seals, beside the answer it may be. Where this program's are refused the counter of another one may
    /// be ahead, and the vehicle is asked for it.
    fn keep_up(
        &mut self,
        line: &mut impl Line,
        number: u16,
        reply: &Reply,
        now_s: f64,
    ) -> Result<(), ConnectionError> {
        match reply {
            Reply::Identity(identity) => {
                // Late ones count, too: on a slow line there is no other. Once: other programs have the same numbers.
                let Some(place) = self.questions.iter().rposition(|q| q.number == number) else {
                    return Ok(());
                };
                let question = self.questions.remove(place);
                let ago_s = |question: &Question| now_s - question.asked_s;
                let Some(question) = question.filter(|q| ago_s(q) <= LONGEST_TRIP_S) else {
                    return Ok(());
                };
                let begins = !question.counter_only && self.session != Some(identity.session);
                if !question.counter_only {
                    self.session = identity.paired.then_some(identity.session);
                }
                let vouched =
                    |key| vouch(key, identity.session, identity.last_counter) == identity.last_counter_mac;
                if self.session != Some(identity.session) || !self.key.as_ref().is_some_and(vouched) {
                    return Ok(());
                }
                let (last, unix_s) = (identity.last_counter, seal_counter::now_s());
                if begins {
                    self.seals.meet(last, ago_s(&question), unix_s);
                } else {
                    self.seals.catch_up(last, ago_s(&question), unix_s);
                }
                let refused = |pending: &&mut Pending| {
                    pending.refused == Some(Refusal::NotSealed) && pending.learned < LEARNED_ANEW
                };
                if let Some(pending) = self.pending.as_mut().filter(refused) {
                    pending.learned += 1;
                    pending.refused = None;
                    pending.tries = 0;
                    self.insist(line, now_s)?;
                }
            }
            Reply::Refused(Refusal::NotSealed) if self.sealed.contains(&number) => {
                let recent = |last: &Question| now_s - last.asked_s < ANSWER_TIMEOUT_S;
                if !self.questions.back().is_some_and(recent) {
                    let number = self.next_number();
                    remember(&mut self.questions, Question { number, asked_s: now_s, counter_only: true });
                    self.transmit(line, number, Request::Identify)?;
                }
            }
            _ => {}
        }
        Ok(())
    }

    fn repeat(&mut self, line: &mut impl Line, now_s: f64) -> Result<(), ClientError> {
        let Some(pending) = &mut self.pending else {
            return Ok(());
        };
        let waited_s = now_s - pending.sent_s;
        let failure = if let Some(since_s) = pending.working_since_s {
            if waited_s < PENDING_PERIOD_S {
                return Ok(());
            }
            let by_hand = matches!(pending.request, Request::CalibrateScale { .. });
            let timeout_s = if by_hand { BY_HAND_TIMEOUT_S } else { PENDING_TIMEOUT_S };
            (now_s - since_s > timeout_s).then_some(ClientError::Unfinished(timeout_s))
        } else {
            if waited_s < ANSWER_TIMEOUT_S {
                return Ok(());
            }
            self.repeats += 1;
            let silent = self.foreign_version.map_or(ClientError::Silent, ClientError::Version);
            // It talks but does not answer what is sealed: what another key has sealed is noise to it.
            let unheard = self.key.is_some()
                && self.session.is_some()
                && pending.request != Request::Identify
                && self.telemetry_count > pending.telemetry_count;
            let refused = pending.refused.or(unheard.then_some(Refusal::NotSealed));
            let error = refused.map_or(silent, ClientError::Refused);
            (pending.tries >= TRIES).then_some(error)
        };
        if let Some(error) = failure {
            self.pending = None;
            return Err(error);
        }
        Ok(self.insist(line, now_s)?)
    }

    fn next_number(&mut self) -> u16 {
        self.number = self.number.wrapping_add(1);
        self.number
    }

    fn transmit(
        &mut self,
        line: &mut impl Line,
        number: u16,
        request: Request,
    ) -> Result<(), ConnectionError> {
        // The younger its time, the longer the request may be on its way. A line that cannot be read is no reason to say nothing;
        // whoever reads it hears of that.
        if request.is_timed() {
            let _ = self.hear(line);
        }
        // Whoever is asked who he is may have been switched off and on since: no session is known for sure.
        let sealed = (request != Request::Identify).then_some(self.key.zip(self.session)).flatten();
        let uplink = Uplink { version: PROTOCOL_VERSION, number, heard_ms: self.heard_ms, request };
        let mut frame = Frame::new();
        match sealed {
            Some((key, session)) => {
                remember(&mut self.sealed, number);
                let counter = self.seals.next(seal_counter::now_s())?;
                frame.fill_sealed(&uplink, |content| seal(&key, session, counter, content))
            }
            None => frame.fill(&uplink),
        }
        // No request of the protocol is longer than a frame; the type bounds every part.
        .map_err(|e| std::io::Error::other(e.to_string()))?;
        // A zero first: whatever noise or half a frame came before, this frame begins afresh. In one piece, so that it is one
        // datagram where it travels as such.
        let mut bytes = Vec::with_capacity(frame.as_bytes().len() + 1);
        bytes.push(0);
        bytes.extend_from_slice(frame.as_bytes());
        line.send(&bytes)
    }
}

/// Adds one to those remembered; the oldest makes room.
fn remember<T>(last: &mut VecDeque<T>, new: T) {
    if last.len() >= REMEMBERED {
        last.pop_front();
    }
    last.push_back(new);
}

/// Downloads the record, chunk by chunk: `call` asks the vehicle, `mismatch` says that its answer is none to the question.
pub(crate) fn download_record<E>(
    mut call: impl FnMut(Request) -> Result<Reply, E>,
    mismatch: impl Fn() -> E,
) -> Result<Vec<RecordedTick>, E> {
    let mut record = Vec::new();
    loop {
        let first = record.len() as u32;
        let Reply::Record(RecordChunk { first: got, total, bytes }) = call(Request::ReadRecord { first })?
        else {
            return Err(mismatch());
        };
        let (ticks, rest) = bytes.as_chunks::<RECORD_BYTES>();
        if got != first || !rest.is_empty() || (ticks.is_empty() && first < total) {
            return Err(mismatch());
        }
        record.extend(ticks.iter().map(RecordedTick::from_bytes));
        if record.len() as u32 >= total {
            return Ok(record);
        }
    }
}

#[cfg(test)]
mod tests {
    use std::collections::HashSet;

    use super::Client;

    /// Of sixteen programs in a row hardly any two begin with the same number.
    #[test]
    fn each_program_begins_with_numbers_of_its_own() {
        let first: HashSet<u16> = (0..16).map(|_| Client::default().numbered_anew().next_number()).collect();
        assert!(first.len() > 12, "{first:?}");
    }
}

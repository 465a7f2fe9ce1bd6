//! The serial link: bytes to requests, messages to bytes.
//!
//! Every length is bounded. Bytes that are not messages are counted and dropped; requests that arrive faster than the
//! flight logic takes them are dropped too, counted, and asked again by the host. Where host and vehicle are paired, what
//! is not sealed is refused, but for the question who is there: that is where a host learns the session's number. One in 20 ms is
//! taken, behind the host's own requests, so that strangers who ask do not keep those out.

use heapless::Deque;
use mintime_shared::framing::{Decoder, Frame, parse};
use mintime_shared::messages::{DownlinkRef, Message, PROTOCOL_VERSION, Refusal, Reply, Request, Uplink};
use mintime_shared::seal::{self, PairingKey};

use crate::flight::{Inbox, Outbox};

/// Ticks from one question of a stranger that is taken to the next: 20 ms. Each costs the line an answer that is six times as long.
const QUESTION_TICKS: u8 = 16;

/// Both directions of one link.
#[derive(Debug, Default)]
pub struct Link {
    decoder: Decoder,
    /// The frame under way.
    frame: Frame,
    /// How much of it is sent.
    sent: usize,
    errors: u32,
    /// The vehicle's session, part of every seal.
    session: u32,
    /// Counter of the last seal taken.
    last_counter: u32,
    /// Ticks until a stranger's question is taken again.
    deaf_ticks: u8,
    /// A stranger's question who is there.
    question: Option<Uplink>,
    /// Requests that were not sealed and wait for being told so.
    unsealed: Deque<u16, 2>,
}

impl Link {
    /// Nothing received, nothing to send.
    pub const fn new() -> Self {
        Self {
            decoder: Decoder::new(),
            frame: Frame::new(),
            sent: 0,
            errors: 0,
            session: 0,
            last_counter: 0,
            deaf_ticks: 0,
            question: None,
            unsealed: Deque::new(),
        }
    }

    /// A new session: seals of an older one count no more. Once, at power-up.
    pub fn set_session(&mut self, session: u32) {
        self.session = session;
        self.last_counter = 0;
    }

    /// The session's number.
    pub fn session(&self) -> u32 {
        self.session
    }

    /// Counter of the last seal taken in this session; 0 where there was none.
    pub fn last_counter(&self) -> u32 {
        self.last_counter
    }

    /// Received frames that were not messages, or found no room.
    pub fn errors(&self) -> u32 {
        self.errors
    }

    /// Takes received bytes, in any pieces. An emergency stop finds room whatever is waiting. With a key only what is sealed
    /// with it passes.
    #[inline(never)]
    pub fn receive(&mut self, mut bytes: &[u8], key: Option<&PairingKey>, inbox: &mut Inbox) {
        while let Some(content) = self.decoder.next_content(&mut bytes) {
            let uplink = match content {
                Err(_) => None,
                Ok(content) => match key {
                    None => parse(content).ok(),
                    Some(key) => match seal::open(key, self.session, self.last_counter, content) {
                        Some((content, counter)) => {
                            self.last_counter = counter;
                            parse(content).ok()
                        }
                        // Without a seal, or with one that is old or another's: whoever sent it is told. A stranger takes
                        // neither room that the host may need nor much of the line: he asks again.
                        None => match unsealed(content) {
                            Some(question) if matches!(question.request, Request::Identify) => {
                                if self.deaf_ticks == 0 {
                                    self.deaf_ticks = QUESTION_TICKS;
                                    self.question = Some(question);
                                    continue;
                                }
                                None
                            }
                            other => {
                                if let Some(other) = other {
                                    let _ = self.unsealed.push_back(other.number);
                                }
                                None
                            }
                        },
                    },
                },
            };
            let lost = uplink.is_none_or(|uplink| !admit(uplink, inbox));
            self.errors = self.errors.saturating_add(u32::from(lost));
        }
    }

    /// Puts a stranger's question behind all that the host said since the last tick, if there is room.
    pub fn put_question(&mut self, inbox: &mut Inbox) {
        if !inbox.is_full()
            && let Some(question) = self.question.take()
        {
            // There is room.
            let _ = inbox.push_back(question);
        }
    }

    /// Fills `out` with what is to be sent and returns how many bytes that is.
    #[inline(never)]
    pub fn transmit(&mut self, outbox: &mut Outbox, out: &mut [u8]) -> usize {
        self.deaf_ticks = self.deaf_ticks.saturating_sub(1);
        let mut written = 0;
        while let Some(room) = out.get_mut(written..).filter(|room| !room.is_empty()) {
            if self.sent == self.frame.as_bytes().len() {
                self.sent = 0;
                if let Some(number) = self.unsealed.pop_front() {
                    let message = &Message::Reply { number, reply: Reply::Refused(Refusal::NotSealed) };
                    let _ = self.frame.fill(&DownlinkRef { version: PROTOCOL_VERSION, message });
                    continue;
                }
                // By reference: the longest message has 250 bytes, most have few.
                let Some(message) = outbox.front() else {
                    self.frame.clear();
                    break;
                };
                // No message of the protocol is longer than a frame; of one that were the frame is empty.
                let _ = self.frame.fill(&DownlinkRef { version: PROTOCOL_VERSION, message });
                drop(outbox.pop_front());
            }
            let rest = self.frame.as_bytes().get(self.sent..).unwrap_or_default();
            let count = rest.len().min(room.len());
            if let (Some(room), Some(rest)) = (room.get_mut(..count), rest.get(..count)) {
                room.copy_from_slice(rest);
            }
            self.sent += count;
            written += count;
        }
        written
    }
}

/// The request in a content whose seal does not hold, or that has none.
fn unsealed(content: &[u8]) -> Option<Uplink> {
    let bare = || content.split_last_chunk::<{ seal::SEAL_BYTES }>().map(|(content, _)| content);
    parse(content).ok().or_else(|| parse(bare()?).ok())
}

/// Puts a request into the inbox; whether nothing was lost by it.
fn admit(uplink: Uplink, inbox: &mut Inbox) -> bool {
    let urgent = match uplink.request {
        Request::EmergencyStop => true,
        // It takes no emergency stop's place, or it would clear what the stop was to set.
        Request::Disarm => !inbox.back().is_some_and(|last| matches!(last.request, Request::EmergencyStop)),
        _ => false,
    };
    let displaced = urgent && inbox.is_full() && inbox.pop_back().is_some();
    inbox.push_back(uplink).is_ok() && !displaced
}

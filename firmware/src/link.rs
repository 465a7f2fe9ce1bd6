//! The serial link: bytes to requests, messages to bytes.
//!
//! Every length is bounded. Bytes that are not messages are counted and dropped; requests that arrive faster than the
//! flight logic takes them are dropped too, counted, and asked again by the host.

use mintime_shared::framing::{Decoder, Frame};
use mintime_shared::messages::{DownlinkRef, PROTOCOL_VERSION, Request, Uplink};

use crate::flight::{Inbox, Outbox};

/// Both directions of one link.
#[derive(Debug, Default)]
pub struct Link {
    decoder: Decoder,
    /// The frame under way.
    frame: Frame,
    /// How much of it is sent.
    sent: usize,
    errors: u32,
}

impl Link {
    /// Nothing received, nothing to send.
    pub const fn new() -> Self {
        Self { decoder: Decoder::new(), frame: Frame::new(), sent: 0, errors: 0 }
    }

    /// Received frames that were not messages, or found no room.
    pub fn errors(&self) -> u32 {
        self.errors
    }

    /// Takes received bytes, in any pieces. An emergency stop finds room whatever is waiting.
    pub fn receive(&mut self, bytes: &[u8], inbox: &mut Inbox) {
        for &byte in bytes {
            let lost = match self.decoder.push::<Uplink>(byte) {
                None => false,
                Some(Err(_)) => true,
                Some(Ok(uplink)) => {
                    let urgent = match uplink.request {
                        Request::EmergencyStop => true,
                        // It takes no emergency stop's place, or it would clear what the stop was to set.
                        Request::Disarm => {
                            !inbox.back().is_some_and(|last| last.request == Request::EmergencyStop)
                        }
                        _ => false,
                    };
                    let displaced = urgent && inbox.is_full() && inbox.pop_back().is_some();
                    inbox.push_back(uplink).is_err() || displaced
                }
            };
            self.errors = self.errors.saturating_add(u32::from(lost));
        }
    }

    /// Fills `out` with what is to be sent and returns how many bytes that is.
    pub fn transmit(&mut self, outbox: &mut Outbox, out: &mut [u8]) -> usize {
        let mut written = 0;
        while let Some(room) = out.get_mut(written..).filter(|room| !room.is_empty()) {
            if self.sent == self.frame.as_bytes().len() {
                // By reference: the longest message has 250 bytes, most have few.
                let Some(message) = outbox.front() else {
                    break;
                };
                self.sent = 0;
                // No message of the protocol is longer than a frame; of one that were the frame is empty.
                let _ = self.frame.fill(&DownlinkRef { version: PROTOCOL_VERSION, message });
                drop(outbox.pop_front());
            }
            let rest = self.frame.as_bytes().get(self.sent..).unwrap_or_default();
            let count = rest.len().min(room.len());
            for (slot, byte) in room.iter_mut().zip(rest) {
                *slot = *byte;
            }
            self.sent += count;
            written += count;
        }
        written
    }
}

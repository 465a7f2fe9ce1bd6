//! The seal of a paired link: a keyed MAC and a counter on every request.
//!
//! A cable needs none. On a radio a stranger could talk to the vehicle, or play back what he heard; so, once a
//! [`PairingKey`] is set, every request carries [`SEAL_BYTES`] behind its content: a counter that only grows, and
//! SipHash-2-4 (Aumasson and Bernstein 2012, a keyed pseudo-random function, 64 bit) over the vehicle's session number,
//! the counter and the content. The session number is new with every start of the vehicle, so that what was heard before
//! a reset is worth nothing after it.

use core::hash::Hasher;
use siphasher::sip::SipHasher24;

/// The secret that host and vehicle share.
pub type PairingKey = [u8; 16];

/// Bytes of a seal: counter and MAC.
pub const SEAL_BYTES: usize = 4 + 8;

/// The MAC of a request.
fn mac(key: &PairingKey, session: u32, counter: u32, content: &[u8]) -> u64 {
    let mut hasher = SipHasher24::new_with_key(key);
    hasher.write(&session.to_le_bytes());
    hasher.write(&counter.to_le_bytes());
    hasher.write(content);
    hasher.finish()
}

/// The seal of a request's content.
pub fn seal(key: &PairingKey, session: u32, counter: u32, content: &[u8]) -> [u8; SEAL_BYTES] {
    let [a, b, c, d] = counter.to_le_bytes();
    let [e, f, g, h, i, j, k, l] = mac(key, session, counter, content).to_le_bytes();
    [a, b, c, d, e, f, g, h, i, j, k, l]
}

/// The MAC by which a vehicle vouches for the counter that it took last. No request has these bytes for its content: they
/// begin with the version of no protocol.
pub fn vouch(key: &PairingKey, session: u32, last: u32) -> u64 {
    mac(key, session, last, b"\xfflast counter")
}

/// Takes the seal off: the content and the counter, if the key made it. The counter must be above the last one taken.
pub fn open<'a>(key: &PairingKey, session: u32, last: u32, sealed: &'a [u8]) -> Option<(&'a [u8], u32)> {
    let (content, tail) = sealed.split_last_chunk::<SEAL_BYTES>()?;
    let (counter, code) = tail.split_first_chunk::<4>()?;
    let counter = u32::from_le_bytes(*counter);
    let code = u64::from_le_bytes(code.try_into().ok()?);
    // Compared as a whole word: no early way out that time would tell.
    (code == mac(key, session, counter, content) && counter > last).then_some((content, counter))
}

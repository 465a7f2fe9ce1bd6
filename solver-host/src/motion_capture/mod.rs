//! Motion capture on a real vehicle: poses as JSON lines over UDP or standard input.
//!
//! ```text
//! datagram or line ─→ sample (strict) ─→ monitor (order, jumps, room, frozen) ─→ clock (capture to host) ─→ pose
//! ```
//!
//! Nothing that arrives can panic. A sample that is refused is not flown with; when none is accepted for
//! [`STALE_S`], the reason of the last refusal is why. The format is in `docs/motion-capture.md`.

mod clock;
mod error;
mod monitor;
mod sample;
mod source;

pub use clock::CaptureClock;
pub use error::CaptureError;
pub use monitor::{Monitor, STALE_S, Volume};
pub use sample::{CaptureSample, MAX_LINE_BYTES};
pub use source::{Capture, CaptureOptions};

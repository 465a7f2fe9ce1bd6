//! What a link and a board do, measured.

use mintime_shared::messages::{Reply, Request, Telemetry};

use super::link::Link;
use super::session::{Session, SessionError};
use crate::flight::ClientError;

/// Least, middle and greatest of a list of numbers.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct Spread {
    /// Least.
    pub least: f64,
    /// Half are below.
    pub median: f64,
    /// 99 % are below.
    pub p99: f64,
    /// Greatest.
    pub greatest: f64,
}

impl Spread {
    /// Of these numbers; `None` of none.
    pub fn of(mut values: Vec<f64>) -> Option<Self> {
        values.sort_by(f64::total_cmp);
        let at = |part: f64| values.get(((values.len() - 1) as f64 * part).round() as usize).copied();
        if values.is_empty() {
            return None;
        }
        Some(Self { least: at(0.0)?, median: at(0.5)?, p99: at(0.99)?, greatest: at(1.0)? })
    }
}

/// What was measured.
#[derive(Clone, Debug)]
pub struct Measurement {
    /// Requests that were sent.
    pub asked: u32,
    /// Requests that had to be sent again, and requests that stayed without an answer.
    pub repeated: u32,
    /// The latter.
    pub unanswered: u32,
    /// From request to answer, ms.
    pub round_trip_ms: Option<Spread>,
    /// Between two telemetry messages, as the host saw them arrive, ms.
    pub telemetry_ms: Option<Spread>,
    /// Telemetry messages a second.
    pub telemetry_hz: f64,
    /// Received frames that were damaged, here and on the vehicle.
    pub damaged: (u32, u32),
    /// How the vehicle is at the end.
    pub telemetry: Telemetry,
}

impl<L: Link> Session<L> {
    /// Asks for the status over and over for a while, and listens.
    ///
    /// # Errors
    /// [`SessionError`] of the line; silence is counted.
    pub fn measure(&mut self, duration_s: f64) -> Result<Measurement, SessionError> {
        const DURING: &str = "measuring";
        let mut telemetry = self.status()?;
        let began = (self.client().repeats(), self.client().line_errors(), telemetry.link_errors);
        let (mut trips, mut gaps) = (Vec::new(), Vec::new());
        let (mut asked, mut unanswered) = (0, 0);
        let (begin_s, first) = (self.now_s(), self.client().telemetry_count());
        let mut heard: Option<(u64, f64)> = None;
        while self.now_s() - begin_s < duration_s {
            asked += 1;
            let repeats = self.client().repeats();
            match self.call(DURING, Request::Status) {
                Ok(Reply::Status(status)) => {
                    telemetry = status;
                    if self.client().repeats() == repeats {
                        trips.extend(self.client().round_trip_s().map(|s| s * 1e3));
                    }
                }
                Ok(_) => {}
                Err(SessionError::Client { source: ClientError::Silent, .. }) => unanswered += 1,
                Err(error) => return Err(error),
            }
            self.listen(0.002)?;
            let (count, now_s) = (self.client().telemetry_count(), self.now_s());
            match heard {
                Some((before, since_s)) if count > before => {
                    gaps.push((now_s - since_s) * 1e3 / (count - before) as f64);
                    heard = Some((count, now_s));
                }
                None => heard = Some((count, now_s)),
                Some(_) => {}
            }
        }
        let lasted_s = (self.now_s() - begin_s).max(1e-9);
        Ok(Measurement {
            asked,
            repeated: self.client().repeats() - began.0,
            unanswered,
            round_trip_ms: Spread::of(trips),
            telemetry_ms: Spread::of(gaps),
            telemetry_hz: (self.client().telemetry_count() - first) as f64 / lasted_s,
            damaged: (self.client().line_errors() - began.1, telemetry.link_errors.saturating_sub(began.2)),
            telemetry,
        })
    }
}

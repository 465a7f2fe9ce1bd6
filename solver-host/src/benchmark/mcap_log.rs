//! Flight logs of `mintime fly`: the true motion from an MCAP file, whole or cut.

use std::collections::BTreeMap;

use mcap::McapError;
use mcap::read::{ChunkFlattener, Options};
use mcap::records::Record;
use mintime_shared::model::State;
use mintime_shared::table::{Kind, ManeuverTable};
use serde::Deserialize;

use super::builder::{Attitude, Builder};
use super::flight::{Declared, Flight, Remark};
use super::read_error::ReadError;
use crate::flight_log::{HEADING, METADATA};

/// What an MCAP file begins with.
pub(super) const MAGIC: &[u8] = b"\x89MCAP0\r\n";
/// The topic that holds the motion.
const TRUTH: &str = "/truth";

/// The part of a message that is needed; a number that was not finite is `null`.
#[derive(Deserialize)]
struct Truth {
    position_m: Vector,
    velocity_mps: Vector,
    attitude: Quaternion,
}

#[derive(Deserialize)]
struct Vector {
    x: Option<f64>,
    y: Option<f64>,
    z: Option<f64>,
}

impl Vector {
    fn known(&self) -> Option<[f64; 3]> {
        Some([self.x?, self.y?, self.z?])
    }
}

#[derive(Deserialize)]
struct Quaternion {
    w: Option<f64>,
    x: Option<f64>,
    y: Option<f64>,
    z: Option<f64>,
}

impl Quaternion {
    fn known(&self) -> Option<[f64; 4]> {
        Some([self.w?, self.x?, self.y?, self.z?])
    }
}

/// Reads a log of `mintime fly` from the bytes of its file.
///
/// A file without its end, as a broken connection or a full disk leaves it, is read as far as it goes, and a remark
/// says so. A chunk whose checksum is wrong is left out with everything after it.
///
/// # Errors
/// [`ReadError`]: everything but the kinds that belong to files and columns.
pub fn read_mcap(bytes: &[u8]) -> Result<Flight, ReadError> {
    let options = Options::IgnoreEndMagic | Options::ValidateChunkCrcs;
    let records = ChunkFlattener::new_with_options(bytes, options).map_err(|_| ReadError::NotMcap)?;
    let mut reading = Reading::default();
    let mut stopped = None;
    // Samples up to here are in chunks whose checksum was right.
    let mut vouched = 0;
    // What a message had wrong with it: told only if the checksum of its chunk says that it was written so.
    let mut fault = None;
    for record in records {
        match record {
            Ok(record) => {
                let chunk_ended = matches!(record, Record::MessageIndex(_) | Record::DataEnd(_));
                if chunk_ended && let Some(error) = fault.take() {
                    return Err(error);
                }
                if chunk_ended {
                    vouched = reading.builder.len();
                }
                if let Record::DataEnd(_) = record {
                    reading.ended = true;
                    break;
                }
                if fault.is_none() {
                    fault = reading.take(&record).err();
                }
            }
            Err(error) => {
                // In a chunk that merely ends early what was read is sound; in a damaged one nothing is.
                if fault.is_some() || !matches!(error, McapError::UnexpectedEof) {
                    reading.builder.truncate(vouched);
                }
                stopped = Some(error.to_string());
                break;
            }
        }
    }
    if !reading.ended && stopped.is_none() {
        stopped = Some("no end of data".to_owned());
    }
    reading.finish(stopped)
}

/// What has been read so far.
#[derive(Default)]
struct Reading {
    builder: Builder,
    truth_channel: Option<u16>,
    facts: BTreeMap<String, String>,
    messages: usize,
    unseen: usize,
    ended: bool,
}

impl Reading {
    fn take(&mut self, record: &Record<'_>) -> Result<(), ReadError> {
        match record {
            Record::Channel(channel) if channel.topic == TRUTH => self.truth_channel = Some(channel.id),
            Record::Metadata(metadata) if metadata.name == METADATA => {
                self.facts.clone_from(&metadata.metadata);
            }
            Record::Message { header, data } if Some(header.channel_id) == self.truth_channel => {
                self.messages += 1;
                let message = self.messages;
                let truth: Truth = serde_json::from_slice(data)
                    .map_err(|error| ReadError::Message { message, reason: error.to_string() })?;
                let (Some(position_m), Some(attitude)) = (truth.position_m.known(), truth.attitude.known())
                else {
                    self.unseen += 1;
                    return Ok(());
                };
                let t_s = header.log_time as f64 * 1e-9;
                let attitude = Attitude::Quaternion(attitude);
                let place = || format!("message {message} of /truth");
                self.builder.push(place, t_s, position_m, truth.velocity_mps.known(), attitude)?;
            }
            _ => {}
        }
        Ok(())
    }

    fn finish(self, stopped: Option<String>) -> Result<Flight, ReadError> {
        if self.builder.len() == 0 {
            return Err(ReadError::NoTruth { found: stopped });
        }
        let mut remarks = Vec::new();
        if let Some(found) = stopped {
            remarks.push(Remark::Cut { found, last_s: self.builder.last_s() });
        }
        if self.unseen > 0 {
            remarks.push(Remark::Unseen { samples: self.unseen });
        }
        let flight = self.builder.finish(remarks)?;
        Ok(Flight { declared: declared(&self.facts), ..flight })
    }
}

/// The maneuver that the metadata describe: its table is the whole of it.
fn declared(facts: &BTreeMap<String, String>) -> Option<Declared> {
    let start_ns: u64 = facts.get("maneuver_start_ns")?.parse().ok()?;
    let table = ManeuverTable::decode(&hex(facts.get("table_hex")?)?).ok()?;
    let (start, end): (State<f64>, State<f64>) = (table.start.cast(), table.end.cast());
    let asked: Option<f64> =
        facts.get(HEADING).and_then(|rad| rad.parse().ok()).filter(|rad: &f64| rad.is_finite());
    Some(Declared {
        start_s: start_ns as f64 * 1e-9,
        displacement: end.minus(start),
        // A learned table's own heading may make up for an askew gyro.
        heading_rad: asked.unwrap_or(f64::from(table.heading_rad)),
        limits: (table.kind != Kind::Learned).then(|| table.limits.cast()),
    })
}

/// Bytes from two hexadecimal digits each.
fn hex(text: &str) -> Option<Vec<u8>> {
    let digits: Vec<u8> = text.chars().map(|c| c.to_digit(16).map(|d| d as u8)).collect::<Option<_>>()?;
    let (pairs, rest) = digits.as_chunks::<2>();
    rest.is_empty().then(|| pairs.iter().map(|[high, low]| high << 4 | low).collect())
}

//! The MCAP writer: messages of all topics merged in order of time, header as metadata, table as attachment.

use std::borrow::Cow;
use std::collections::BTreeMap;
use std::fs::File;
use std::io::{BufWriter, Seek, Write};
use std::path::{Path, PathBuf};

use mcap::records::{MessageHeader, Metadata};
use mcap::{Attachment, McapError, WriteOptions};
use mintime_shared::model::State;

use super::data::{FlightLog, LogHeader};
use super::messages::messages;
use super::output::{OutputError, write_whole};
use super::schemas::Topic;

/// Name of the attachment that holds the maneuver table as it was uploaded.
pub const TABLE_ATTACHMENT: &str = "maneuver-table.bin";

/// Name of the metadata record that holds the header.
pub const METADATA: &str = "mintime";
/// Name of the fact that tells the heading of the plane that the maneuver is to be in, rad.
pub const HEADING: &str = "heading_rad";

/// Why a log was not written.
#[derive(Debug, thiserror::Error)]
pub enum LogError {
    /// The file cannot be written.
    #[error(transparent)]
    Output(#[from] OutputError),
    /// The content could not be put into the file.
    #[error("{} could not be written as MCAP ({source}): check the free space of the disk", path.display())]
    Mcap {
        /// The path as given.
        path: PathBuf,
        /// What the MCAP writer said.
        source: Box<McapError>,
    },
}

/// Writes a flight log as an MCAP file. The file appears only when it is whole; an existing one is replaced.
///
/// Same data, same bytes. Messages are in order of time and, at one time, in the order of the table of
/// [`flight_log`](crate::flight_log).
///
/// # Errors
/// [`LogError`] if the path cannot be written to (check with [`check_writable`](super::check_writable) before a
/// flight) or the disk is full.
pub fn write_mcap(log: &FlightLog, path: &Path) -> Result<(), LogError> {
    write_whole(path, |file: &mut BufWriter<File>| {
        fill(log, file).map_err(|source| LogError::Mcap { path: path.to_owned(), source: Box::new(source) })
    })
}

fn fill<W: Write + Seek>(log: &FlightLog, file: W) -> Result<(), McapError> {
    // Uncompressed: the compressors of MCAP are C libraries, and a flight is a few megabytes.
    let options = WriteOptions::new()
        .compression(None)
        .profile("")
        .library(concat!("mintime ", env!("CARGO_PKG_VERSION")));
    let mut writer = options.create(file)?;
    writer.write_metadata(&Metadata { name: METADATA.to_owned(), metadata: facts(&log.header) })?;
    if !log.header.table.is_empty() {
        let time_ns = log.header.maneuver_start_ns.unwrap_or(0);
        writer.attach(&Attachment {
            log_time: time_ns,
            create_time: time_ns,
            name: TABLE_ATTACHMENT.to_owned(),
            media_type: "application/octet-stream".to_owned(),
            data: Cow::Borrowed(&log.header.table),
        })?;
    }
    let mut channels = BTreeMap::new();
    for topic in Topic::ALL {
        let (name, schema_name) = topic.names();
        let schema = writer.add_schema(schema_name, "jsonschema", topic.schema().to_string().as_bytes())?;
        let channel = writer.add_channel(schema, name, "json", &BTreeMap::new())?;
        channels.insert(topic, (channel, 0_u32));
    }
    for message in messages(log) {
        let Some((channel_id, sequence)) = channels.get_mut(&message.topic) else { continue };
        let data = message.json().map_err(|error| McapError::Io(error.into()))?;
        let time = message.time_ns;
        writer.write_to_known_channel(
            &MessageHeader {
                channel_id: *channel_id,
                sequence: *sequence,
                log_time: time,
                publish_time: time,
            },
            &data,
        )?;
        *sequence = sequence.wrapping_add(1);
    }
    writer.finish()?;
    Ok(())
}

/// The header as the text fields of a metadata record. States are in the order (x, ẋ, z, ż, θ), SI units.
fn facts(header: &LogHeader) -> BTreeMap<String, String> {
    let mut facts: BTreeMap<String, String> = header.facts.iter().cloned().collect();
    let state = |state: State<f64>| format!("{:?}", state.to_array());
    let start = header.maneuver_start_ns.map_or_else(|| "none".to_owned(), |ns| ns.to_string());
    let table = header.table.iter().fold(String::new(), |hex, byte| hex + &format!("{byte:02x}"));
    let own = [
        ("mintime_version", header.mintime_version.clone()),
        ("seed", header.seed.to_string()),
        ("plant", header.plant.clone()),
        ("vehicle", header.vehicle.clone()),
        ("from", state(header.from)),
        ("to", state(header.to)),
        ("duration_s", header.duration_s.to_string()),
        ("turns", header.turns.to_string()),
        ("maneuver_start_ns", start),
        ("table_bytes", header.table.len().to_string()),
        ("table_hex", table),
    ];
    facts.extend(own.map(|(name, value)| (name.to_owned(), value)));
    facts
}

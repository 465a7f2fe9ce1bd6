//! A conversation with a vehicle: one question after the other, each with its answer.

use mintime_shared::messages::{
    Event, Identity, RecordedTick, Refusal, Reply, Request, STAGE_CHUNK_BYTES, StoredTable, TableName,
    Telemetry,
};
use mintime_shared::seal::PairingKey;
use mintime_shared::settings::Settings;
use mintime_shared::table::{MAX_TABLE_BYTES, ManeuverTable, SCHEMA_HASH, TableError};
use mintime_shared::vehicle::VehicleConfig;

use super::link::Link;
use crate::flight::{Client, ClientError, ConnectionError, download_record};
use crate::pack::for_vehicle;

/// An answer is looked for this often, s.
const LOOK_S: f64 = 0.002;
/// The vehicle hears from its host this often while it is listened to, s.
const HEARTBEAT_S: f64 = 0.1;

/// Why a vehicle could not be asked or told something.
#[derive(Debug, thiserror::Error)]
pub enum SessionError {
    /// The vehicle refused, or did not answer.
    #[error("{during}: {source}")]
    Client {
        /// What was being done.
        during: &'static str,
        /// What came back.
        source: ClientError,
    },
    /// The line failed.
    #[error(transparent)]
    Connection(#[from] ConnectionError),
    /// The table is none.
    #[error(transparent)]
    Table(#[from] TableError),
    /// The vehicle takes other tables.
    #[error(
        "the vehicle takes tables of another layout ({theirs:#010x}, this mintime writes {SCHEMA_HASH:#010x}): flash its firmware again"
    )]
    Schema {
        /// Its layout.
        theirs: u32,
    },
    /// The table read back is not the one sent.
    #[error("the table read back from the vehicle differs from the one sent: try again, check the line")]
    ReadBack,
    /// What was written reads back as something else.
    #[error("{what} read back from the vehicle differ from what was written: try again, check the line")]
    Kept {
        /// What.
        what: &'static str,
    },
    /// A name that the vehicle cannot keep.
    #[error("a table's name has 1 to 16 bytes: {0:?} does not")]
    Name(String),
    /// The vehicle wants a key.
    #[error("the vehicle is paired: give its key with --key FILE")]
    KeyWanted,
}

/// A vehicle that has said who it is.
#[derive(Debug)]
pub struct Session<L> {
    link: L,
    client: Client,
    identity: Identity,
    heartbeat_s: f64,
}

impl<L: Link> Session<L> {
    /// Asks who is there.
    ///
    /// # Errors
    /// [`SessionError`].
    pub fn begin(link: L, key: Option<PairingKey>) -> Result<Self, SessionError> {
        let identity = Identity {
            firmware_version: [0; 3],
            table_schema: 0,
            vehicle: 0,
            session: 0,
            paired: false,
            last_counter: 0,
            last_counter_mac: 0,
            thrust_min_mps2: 0.0,
            thrust_max_mps2: 0.0,
            rate_max_radps: 0.0,
        };
        let mut session = Self {
            link,
            client: Client::with_key(key).numbered_anew(),
            identity,
            heartbeat_s: f64::NEG_INFINITY,
        };
        session.identify()?;
        if session.identity.paired && key.is_none() {
            return Err(SessionError::KeyWanted);
        }
        Ok(session)
    }

    /// Who it is, as it said last.
    pub fn identity(&self) -> &Identity {
        &self.identity
    }

    /// What requests, answers and telemetry looked like.
    pub fn client(&self) -> &Client {
        &self.client
    }

    /// The link's clock, s.
    pub fn now_s(&self) -> f64 {
        self.link.now_s()
    }

    /// The link, for somebody else.
    pub fn into_link(self) -> L {
        self.link
    }

    /// Asks again who it is.
    ///
    /// # Errors
    /// [`SessionError`].
    pub fn identify(&mut self) -> Result<&Identity, SessionError> {
        const DURING: &str = "identifying the vehicle";
        match self.call(DURING, Request::Identify)? {
            Reply::Identity(identity) => {
                self.identity = identity;
                Ok(&self.identity)
            }
            _ => Err(mismatch(DURING)),
        }
    }

    /// Asks and waits for the answer.
    ///
    /// # Errors
    /// [`SessionError`]; a refusal is one.
    pub fn call(&mut self, during: &'static str, request: Request) -> Result<Reply, SessionError> {
        let failed = |source| SessionError::Client { during, source };
        let now_s = self.link.now_s();
        self.client.ask(&mut self.link, request, now_s)?;
        loop {
            self.link.wait(LOOK_S)?;
            let now_s = self.link.now_s();
            if let Some(reply) = self.client.poll(&mut self.link, now_s).map_err(failed)? {
                return Ok(reply);
            }
        }
    }

    /// Asks for something that is either done or refused.
    ///
    /// # Errors
    /// [`SessionError`].
    pub fn tell(&mut self, during: &'static str, request: Request) -> Result<(), SessionError> {
        match self.call(during, request)? {
            Reply::Done => Ok(()),
            _ => Err(mismatch(during)),
        }
    }

    /// Says that the host is there; it is not answered.
    ///
    /// # Errors
    /// [`SessionError`].
    pub fn heartbeat(&mut self) -> Result<(), SessionError> {
        Ok(self.client.heartbeat(&mut self.link)?)
    }

    /// Listens for a while, and lets the vehicle hear that the host is there.
    ///
    /// # Errors
    /// [`SessionError`].
    pub fn listen(&mut self, duration_s: f64) -> Result<(), SessionError> {
        let end_s = self.link.now_s() + duration_s;
        while self.link.now_s() < end_s {
            let now_s = self.link.now_s();
            if now_s - self.heartbeat_s >= HEARTBEAT_S {
                self.heartbeat_s = now_s;
                self.client.heartbeat(&mut self.link)?;
            }
            self.link.wait(LOOK_S.min(end_s - now_s))?;
            let now_s = self.link.now_s();
            let failed = |source| SessionError::Client { during: "listening", source };
            self.client.poll(&mut self.link, now_s).map_err(failed)?;
        }
        Ok(())
    }

    /// How it is.
    ///
    /// # Errors
    /// [`SessionError`].
    pub fn status(&mut self) -> Result<Telemetry, SessionError> {
        const DURING: &str = "asking for the status";
        match self.call(DURING, Request::Status)? {
            Reply::Status(telemetry) => Ok(telemetry),
            _ => Err(mismatch(DURING)),
        }
    }

    /// Stages a table in chunks, commits it and reads it back. A table for any vehicle becomes this one's own. Returns the
    /// checksum, of what was uploaded, and the duration, s.
    ///
    /// # Errors
    /// [`SessionError`].
    pub fn upload(&mut self, table: &ManeuverTable) -> Result<(u32, f32), SessionError> {
        const DURING: &str = "uploading the table";
        if self.identity.table_schema != SCHEMA_HASH {
            return Err(SessionError::Schema { theirs: self.identity.table_schema });
        }
        let table = for_vehicle(table, &self.identity)?;
        let mut buffer = [0; MAX_TABLE_BYTES];
        let length = table.encode(&mut buffer)?;
        let sent = &buffer[..length];
        let mut offset = 0;
        let mut gaps = 0;
        while offset < length {
            let end = length.min(offset + STAGE_CHUNK_BYTES);
            let bytes = heapless::Vec::from_slice(&sent[offset..end]).map_err(|_| TableError::Length)?;
            let request = Request::Stage { total: length as u16, offset: offset as u16, bytes };
            match self.call(DURING, request) {
                Ok(Reply::Staged { length }) => offset = usize::from(length),
                Ok(_) => return Err(mismatch(DURING)),
                // Somebody else staged meanwhile, or the vehicle was reset: go on where it wants.
                Err(SessionError::Client {
                    source: ClientError::Refused(Refusal::Gap { expected }), ..
                }) if gaps < 3 => {
                    gaps += 1;
                    offset = usize::from(expected);
                }
                Err(error) => return Err(error),
            }
        }
        let checksum = table.checksum();
        let Reply::Committed { duration_s, .. } = self.call(DURING, Request::CommitTable { checksum })?
        else {
            return Err(mismatch(DURING));
        };
        if self.read_table()? != sent {
            return Err(SessionError::ReadBack);
        }
        Ok((checksum, duration_s))
    }

    /// The committed table's bytes; empty where there is none.
    ///
    /// # Errors
    /// [`SessionError`].
    pub fn read_table(&mut self) -> Result<Vec<u8>, SessionError> {
        const DURING: &str = "reading the table back";
        match self.call(DURING, Request::ReadTable)? {
            Reply::Table(bytes) => Ok(bytes.to_vec()),
            _ => Err(mismatch(DURING)),
        }
    }

    /// What is stored by name.
    ///
    /// # Errors
    /// [`SessionError`].
    pub fn tables(&mut self) -> Result<Vec<StoredTable>, SessionError> {
        const DURING: &str = "listing the tables";
        match self.call(DURING, Request::ListTables)? {
            Reply::Tables(tables) => Ok(tables.to_vec()),
            _ => Err(mismatch(DURING)),
        }
    }

    /// Keeps the committed table by name.
    ///
    /// # Errors
    /// [`SessionError`].
    pub fn store(&mut self, name: &str, checksum: u32) -> Result<(), SessionError> {
        self.tell("storing the table", Request::StoreTable { name: table_name(name)?, checksum })
    }

    /// Commits a stored table. Returns its checksum and duration, s.
    ///
    /// # Errors
    /// [`SessionError`].
    pub fn load(&mut self, name: &str) -> Result<(u32, f32), SessionError> {
        const DURING: &str = "loading the table";
        match self.call(DURING, Request::LoadTable { name: table_name(name)? })? {
            Reply::Committed { checksum, duration_s } => Ok((checksum, duration_s)),
            _ => Err(mismatch(DURING)),
        }
    }

    /// Forgets a stored table.
    ///
    /// # Errors
    /// [`SessionError`].
    pub fn delete(&mut self, name: &str) -> Result<(), SessionError> {
        self.tell("deleting the table", Request::DeleteTable { name: table_name(name)? })
    }

    /// The vehicle file; `None` where it has none.
    ///
    /// # Errors
    /// [`SessionError`].
    pub fn vehicle(&mut self) -> Result<Option<VehicleConfig>, SessionError> {
        const DURING: &str = "reading the vehicle file";
        match self.call(DURING, Request::ReadVehicle)? {
            Reply::Vehicle(vehicle) => Ok(vehicle),
            _ => Err(mismatch(DURING)),
        }
    }

    /// Writes the vehicle file and reads it back.
    ///
    /// # Errors
    /// [`SessionError`].
    pub fn set_vehicle(&mut self, vehicle: &VehicleConfig) -> Result<(), SessionError> {
        self.tell("writing the vehicle file", Request::WriteVehicle(*vehicle))?;
        if self.vehicle()?.as_ref() != Some(vehicle) {
            return Err(SessionError::Kept { what: "vehicle parameters" });
        }
        self.identify()?;
        Ok(())
    }

    /// The settings.
    ///
    /// # Errors
    /// [`SessionError`].
    pub fn settings(&mut self) -> Result<Settings, SessionError> {
        const DURING: &str = "reading the settings";
        match self.call(DURING, Request::ReadSettings)? {
            Reply::Settings(settings) => Ok(settings),
            _ => Err(mismatch(DURING)),
        }
    }

    /// Writes the settings and reads them back.
    ///
    /// # Errors
    /// [`SessionError`].
    pub fn set_settings(&mut self, settings: &Settings) -> Result<(), SessionError> {
        self.tell("writing the settings", Request::WriteSettings(*settings))?;
        if self.settings()? != *settings {
            return Err(SessionError::Kept { what: "settings" });
        }
        Ok(())
    }

    /// Pairs, or unpairs with `None`. The vehicle asks for seals as soon as it has the key, so the answer itself may be lost
    /// on it: what counts is whether it takes what is sealed with the new key.
    ///
    /// # Errors
    /// [`SessionError`].
    pub fn pair(&mut self, key: Option<PairingKey>) -> Result<(), SessionError> {
        let asked = self.tell("pairing", Request::Pair(key));
        self.client.set_key(key);
        let paired = self.identify()?.paired;
        if paired != key.is_some() {
            asked?;
            return Err(SessionError::Kept { what: "pairing keys" });
        }
        match (self.status(), asked) {
            (Ok(_), _) => Ok(()),
            (Err(_), Err(error)) | (Err(error), Ok(())) => Err(error),
        }
    }

    /// Downloads the record.
    ///
    /// # Errors
    /// [`SessionError`].
    pub fn record(&mut self) -> Result<Vec<RecordedTick>, SessionError> {
        const DURING: &str = "downloading the record";
        download_record(|request| self.call(DURING, request), || mismatch(DURING))
    }

    /// All events that it remembers, each with its number.
    ///
    /// # Errors
    /// [`SessionError`].
    pub fn events(&mut self) -> Result<Vec<(u32, Event)>, SessionError> {
        const DURING: &str = "reading the events";
        let mut events = Vec::new();
        let mut wanted = 1;
        loop {
            let Reply::Events(chunk) = self.call(DURING, Request::ReadEvents { first: wanted })? else {
                return Err(mismatch(DURING));
            };
            let got = chunk.events.len() as u32;
            events.extend((chunk.first..).zip(chunk.events));
            wanted = chunk.first.saturating_add(got);
            if got == 0 || wanted > chunk.newest {
                return Ok(events);
            }
        }
    }
}

fn table_name(name: &str) -> Result<TableName, SessionError> {
    let wrong = || SessionError::Name(name.to_owned());
    if name.is_empty() {
        return Err(wrong());
    }
    TableName::try_from(name).map_err(|_| wrong())
}

fn mismatch(during: &'static str) -> SessionError {
    SessionError::Client { during, source: ClientError::Mismatch }
}

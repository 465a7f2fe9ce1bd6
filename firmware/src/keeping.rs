//! What outlives a power cycle: vehicle file, settings, pairing key and tables by name.
//!
//! The flight logic writes no flash. It asks its board for one [`Job`] at a time, only with the motors off, and takes what
//! was asked for into force when the board says that it is done; where the board has no store, at once. At power-up the
//! board hands back what it kept through the same door.

use heapless::Vec;
use mintime_shared::messages::{STORED_TABLES, StoredTable, TableName};
use mintime_shared::seal::PairingKey;
use mintime_shared::settings::Settings;
use mintime_shared::table::{MAX_TABLE_BYTES, ManeuverTable};
use mintime_shared::vehicle::VehicleConfig;

pub use crate::store::{Key, VALUE_BYTES};

/// First byte of each value: the layout of what follows. Another one is not read.
const LAYOUT: u8 = 1;

/// A value as it lies in flash.
pub type Value = Vec<u8, VALUE_BYTES>;

/// Something to be written.
#[derive(Clone, Debug, PartialEq)]
pub struct Job {
    /// Its number; grows.
    pub ticket: u32,
    /// What it is.
    pub key: Key,
    /// What shall be kept; empty: nothing.
    pub value: Value,
}

/// A stored table.
#[derive(Clone, Debug)]
pub(crate) struct Slot {
    pub(crate) listing: StoredTable,
    pub(crate) bytes: Vec<u8, MAX_TABLE_BYTES>,
}

const _: () = assert!(STORED_TABLES == crate::store::TABLES as usize);

/// The eight places.
pub(crate) type Slots = [Option<Slot>; STORED_TABLES];

/// What a value says once it is read.
pub(crate) enum Kept {
    Vehicle(VehicleConfig),
    Settings(Settings),
    Pairing(PairingKey),
    Table(usize, Slot),
}

/// Writes a value.
pub(crate) fn value(content: &impl serde::Serialize) -> Option<Value> {
    let mut bytes = [0; VALUE_BYTES];
    let length = postcard::to_slice(&(LAYOUT, content), &mut bytes).ok()?.len();
    Value::from_slice(bytes.get(..length)?).ok()
}

/// Writes a table's value.
pub(crate) fn table_value(name: &TableName, bytes: &Vec<u8, MAX_TABLE_BYTES>) -> Option<Value> {
    value(&(name, bytes))
}

/// Reads a value; `None` where it is not one that this firmware wrote and would take.
pub(crate) fn read(key: Key, bytes: &[u8]) -> Option<Kept> {
    fn content<T: serde::de::DeserializeOwned>(bytes: &[u8]) -> Option<T> {
        match postcard::take_from_bytes::<(u8, T)>(bytes) {
            Ok(((LAYOUT, content), [])) => Some(content),
            _ => None,
        }
    }
    match key {
        Key::Vehicle => content(bytes).filter(|v: &VehicleConfig| v.check().is_ok()).map(Kept::Vehicle),
        Key::Settings => content(bytes).filter(|s: &Settings| s.check().is_ok()).map(Kept::Settings),
        Key::Pairing => content(bytes).map(Kept::Pairing),
        Key::Table(place) => {
            let (name, bytes): (TableName, Vec<u8, MAX_TABLE_BYTES>) = content(bytes)?;
            let table = ManeuverTable::decode(&bytes).ok()?;
            let listing = StoredTable { name, checksum: table.checksum(), duration_s: table.duration_s() };
            Some(Kept::Table(usize::from(place), Slot { listing, bytes }))
        }
    }
}

/// The one job under way.
#[derive(Debug, Default)]
pub(crate) struct Keeper {
    job: Option<Job>,
    last_ticket: u32,
    /// Whether the last one failed, until somebody is told.
    failed: Option<Key>,
}

impl Keeper {
    pub(crate) const fn new() -> Self {
        Self { job: None, last_ticket: 0, failed: None }
    }

    pub(crate) fn job(&self) -> Option<&Job> {
        self.job.as_ref()
    }

    /// Begins a job; none is under way.
    pub(crate) fn begin(&mut self, key: Key, value: Value) {
        self.last_ticket = self.last_ticket.wrapping_add(1).max(1);
        self.failed = None;
        self.job = Some(Job { ticket: self.last_ticket, key, value });
    }

    /// Takes the job that the board has finished.
    pub(crate) fn finish(&mut self, ticket: u32, failed: bool) -> Option<Job> {
        let job = self.job.take_if(|job| job.ticket == ticket)?;
        if failed {
            self.failed = Some(job.key);
            return None;
        }
        Some(job)
    }

    /// Whether the last job for this key failed; told once.
    pub(crate) fn take_failure(&mut self, key: Key) -> bool {
        self.failed.take_if(|failed| *failed == key).is_some()
    }
}

//! What a vehicle keeps: its file, its settings, tables by name, the pairing key.

use std::error::Error;
use std::path::{Path, PathBuf};

use clap::{Args, Subcommand};
use mintime::vehicle::key_text;
use mintime_shared::seal::PairingKey;
use mintime_shared::table::ManeuverTable;
use serde::Serialize;
use serde::de::DeserializeOwned;
use serde_json::{Value, json};

use super::super::solve::write_bytes;
use super::super::table::read_bytes;
use super::{Bench, Said, to_json};

/// Arguments of `params`.
#[derive(Args)]
#[command(
    after_help = "Examples:\n  params                                print the vehicle file\n  params --save quad.json               \
                  save it to a file\n  params --file quad.json               write it from a file\n  params --set mass_kg=0.81             \
                  change one number\n  params --settings --set kill_channel=6   change a setting"
)]
pub(super) struct Params {
    /// The settings (calibration, kill switch, timeouts) instead of the vehicle file
    #[arg(long)]
    settings: bool,
    /// Write this JSON file to the vehicle
    #[arg(long, value_name = "FILE.json")]
    file: Option<PathBuf>,
    /// Change one value; may be given more than once
    #[arg(long, value_name = "NAME=VALUE")]
    set: Vec<String>,
    /// Save what the vehicle has to this JSON file
    #[arg(long, value_name = "FILE.json")]
    save: Option<PathBuf>,
}

impl Params {
    pub(super) fn run(&self, bench: &mut Bench) -> Said {
        let value = if self.settings {
            let now = bench.settings()?;
            if let Some(settings) = self.wanted(Some(&now))? {
                settings.check()?;
                bench.set_settings(&settings)?;
            }
            to_json(&bench.settings()?)?
        } else {
            let now = bench.vehicle()?;
            if let Some(vehicle) = self.wanted(now.as_ref())? {
                vehicle.check()?;
                bench.set_vehicle(&vehicle)?;
            }
            match bench.vehicle()? {
                Some(vehicle) => to_json(&vehicle)?,
                None => {
                    return Err(
                        "the vehicle has no vehicle file yet: write one with `params --file FILE.json`; \
                                docs/vehicles.md says what stands in it"
                            .into(),
                    );
                }
            }
        };
        let text = format!("{value:#}");
        if let Some(path) = &self.save {
            write_bytes(path, format!("{text}\n").as_bytes())?;
        }
        Ok((value, text))
    }

    /// What the vehicle shall have, if it shall have something else.
    fn wanted<T: Serialize + DeserializeOwned>(&self, now: Option<&T>) -> Result<Option<T>, Box<dyn Error>> {
        let mut value = match &self.file {
            Some(path) => Some(read_json(path)?),
            None => now.map(to_json).transpose()?,
        };
        for change in &self.set {
            let (name, to) = change.split_once('=').ok_or_else(|| format!("{change}: give NAME=VALUE"))?;
            let map = value.as_mut().and_then(Value::as_object_mut);
            let map = map.ok_or("there is nothing to change yet: write a whole file with --file first")?;
            let names = || map.keys().cloned().collect::<Vec<_>>().join(", ");
            let to =
                serde_json::from_str(to).map_err(|e| format!("{change}: the value is not JSON ({e})"))?;
            if !map.contains_key(name) {
                return Err(format!("{name} is no parameter: there are {}", names()).into());
            }
            map.insert(name.to_owned(), to);
        }
        if self.file.is_none() && self.set.is_empty() {
            return Ok(None);
        }
        value
            .map(|v| serde_json::from_value(v).map_err(|e| format!("not usable as parameters: {e}").into()))
            .transpose()
    }
}

pub(super) fn read_json(path: &Path) -> Result<Value, Box<dyn Error>> {
    let bytes = read_bytes(path)?;
    Ok(serde_json::from_slice(&bytes).map_err(|e| format!("{}: {e}", path.display()))?)
}

/// Arguments of `upload`.
#[derive(Args)]
pub(super) struct Upload {
    /// The table file, as `mintime solve -o` writes it; one for any vehicle becomes this one's own
    table: PathBuf,
    /// Also keep it on the vehicle under this name
    #[arg(long)]
    name: Option<String>,
}

impl Upload {
    pub(super) fn run(&self, bench: &mut Bench) -> Said {
        let table = ManeuverTable::decode(&read_bytes(&self.table)?)?;
        let (checksum, duration_s) = bench.upload(&table)?;
        if let Some(name) = &self.name {
            bench.store(name, checksum)?;
        }
        let kept = self.name.as_ref().map(|n| format!(", kept as {n}")).unwrap_or_default();
        let text = format!(
            "the vehicle will fly table {checksum:#010x}, {duration_s:.4} s, at the next trigger{kept}"
        );
        let value = json!({ "checksum": format!("{checksum:#010x}"), "duration_s": to_json(&duration_s)?, "name": self.name });
        Ok((value, text))
    }
}

/// Arguments of `tables`.
#[derive(Args)]
pub(super) struct Tables {
    #[command(subcommand)]
    action: Option<TableAction>,
}

/// What to do with stored tables; listed without any.
#[derive(Subcommand)]
enum TableAction {
    /// List them (as without a word)
    List,
    /// Keep the table that was uploaded last
    Store {
        /// Its name, at most 16 bytes
        name: String,
    },
    /// Make a stored table the one to fly
    Load {
        /// Its name
        name: String,
    },
    /// Forget a stored table
    Delete {
        /// Its name
        name: String,
    },
}

impl Tables {
    pub(super) fn run(&self, bench: &mut Bench) -> Said {
        match self.action.as_ref().unwrap_or(&TableAction::List) {
            TableAction::List => {}
            TableAction::Store { name } => {
                let checksum = bench.status()?.table;
                bench.store(name, checksum)?;
            }
            TableAction::Load { name } => {
                bench.load(name)?;
            }
            TableAction::Delete { name } => bench.delete(name)?,
        }
        let tables = bench.tables()?;
        let committed = bench.status()?.table;
        let lines: Vec<_> = tables
            .iter()
            .map(|t| {
                let mark = if t.checksum == committed { "*" } else { " " };
                format!("{mark} {:16} {:#010x} {:8.4} s", t.name.as_str(), t.checksum, t.duration_s)
            })
            .collect();
        let list: Vec<_> = tables
            .iter()
            .map(|t| {
                json!({
                    "name": t.name.as_str(),
                    "checksum": format!("{:#010x}", t.checksum),
                    "duration_s": t.duration_s,
                    "committed": t.checksum == committed,
                })
            })
            .collect();
        let text = if lines.is_empty() { "no tables are stored".to_owned() } else { lines.join("\n") };
        Ok((json!({ "tables": list, "committed": format!("{committed:#010x}") }), text))
    }
}

/// Arguments of `pair`.
#[derive(Args)]
#[command(
    after_help = "A paired vehicle takes only requests that are sealed with its key. Pair over a cable: whoever listens on a \
                  radio while you pair learns the key. Give the key to every later command with --key FILE."
)]
pub(super) struct Pair {
    /// Make a new key and write it to this file, which must not exist yet
    #[arg(long, value_name = "FILE", required_unless_present = "remove", conflicts_with = "remove")]
    new: Option<PathBuf>,
    /// Unpair: let the vehicle obey everybody again
    #[arg(long)]
    remove: bool,
}

impl Pair {
    pub(super) fn run(&self, bench: &mut Bench) -> Said {
        let Some(path) = &self.new else {
            bench.pair(None)?;
            return Ok((json!({ "paired": false }), "unpaired: the vehicle obeys everybody".to_owned()));
        };
        let mut key = PairingKey::default();
        getrandom::fill(&mut key).map_err(|e| format!("the system gives no random numbers ({e})"))?;
        // Kept before it is used: a key that is lost locks the vehicle.
        write_secret(path, &format!("{}\n", key_text(&key)))?;
        if let Err(error) = bench.pair(Some(key)) {
            let kept = path.display();
            return Err(
                format!("{error}; in case the vehicle took the key after all, it is in {kept}").into()
            );
        }
        let text = format!("paired; the key is in {}: keep it, and give it with --key", path.display());
        Ok((json!({ "paired": true, "key_file": path }), text))
    }
}

/// A new file that only its owner can read.
fn write_secret(path: &Path, text: &str) -> Result<(), String> {
    use std::io::Write as _;
    let mut options = std::fs::File::options();
    options.write(true).create_new(true);
    #[cfg(unix)]
    std::os::unix::fs::OpenOptionsExt::mode(&mut options, 0o600);
    let write = || {
        let mut file = options.open(path)?;
        file.write_all(text.as_bytes())?;
        file.sync_all()
    };
    write()
        .map_err(|e: std::io::Error| format!("{} cannot be written ({e}): name a new file", path.display()))
}

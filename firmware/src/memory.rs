//! What the flight logic keeps, restores and calibrates: all of it with the motors off.

use mintime_shared::messages::{
    ArmingBlock, CalibrationError, FlightState, Happening, Incident, IncidentCause, Refusal, Reply, TableName,
};
use mintime_shared::seal::PairingKey;
use mintime_shared::settings::Settings;
use mintime_shared::vehicle::VehicleConfig;

use crate::calibration::{Axis, ScaleCalibration};
use crate::config::StoreStatus;
use crate::flight::{FlightLogic, Turns};
use crate::keeping::{self, Job, Kept, Key, Value};
use crate::recorder::RecordMemory;
use crate::requests::is_repeated;
use crate::store::Damage;

impl<M: RecordMemory> FlightLogic<M> {
    /// Hands back what was kept under a key. Returns whether it could be used. The place of a table that could not is taken
    /// last.
    #[inline(never)]
    pub fn restore(&mut self, key: Key, value: &[u8]) -> bool {
        match keeping::read(key, value) {
            Some(Kept::Vehicle(config)) => {
                // A table that was checked for another vehicle is none for this one.
                if !self.known || self.config != config {
                    self.tables.forget();
                    self.player.unload();
                }
                self.config = config;
                self.known = true;
            }
            Some(Kept::Settings(settings)) => {
                self.settings = settings;
                // Both have been checked with the settings.
                let _ = self.gyro.set_scale(settings.gyro_scale);
                self.rate.set_cutoff_hz(settings.gyro_cutoff_hz);
            }
            Some(Kept::Pairing(key)) => self.pairing = Some(key),
            Some(Kept::Table(place, slot)) => {
                if let Some(there) = self.slots.get_mut(place) {
                    *there = Some(slot);
                }
            }
            None => {
                if let Key::Table(place) = key {
                    self.unreadable |= bit_of(place.into());
                }
                return false;
            }
        }
        true
    }

    /// Says of which keys the value that was written last may be lost. A person must know; each is told as damaged until it is
    /// written anew.
    pub fn note_damage(&mut self, damage: Damage) {
        self.damaged = damage;
        if damage.is_any() {
            self.report(IncidentCause::StoreDamaged);
        }
    }

    /// Something happened that a person must know of. It waits to be acknowledged, after what came before. Returns its
    /// number.
    #[inline(never)]
    pub fn report(&mut self, cause: IncidentCause) -> u16 {
        let number = self.incidents.push(cause);
        self.events.push(self.last_us.unwrap_or(0), Happening::Incident(cause));
        number
    }

    /// All that waits to be acknowledged, the oldest first.
    pub fn incidents(&self) -> impl Iterator<Item = &Incident> {
        self.incidents.iter()
    }

    /// What waits to be acknowledged; of several the oldest.
    pub fn incident(&self) -> Option<Incident> {
        self.incidents.oldest()
    }

    /// What the vehicle is, or is taken for until it has been told.
    pub fn config(&self) -> &VehicleConfig {
        &self.config
    }

    /// The settings in force.
    pub fn settings(&self) -> &Settings {
        &self.settings
    }

    /// The key that requests must be sealed with.
    pub fn pairing(&self) -> Option<&PairingKey> {
        self.pairing.as_ref()
    }

    /// What the board shall write now.
    pub fn job(&self) -> Option<&Job> {
        self.keeper.job().filter(|_| !self.state().motors_on())
    }

    /// Whether flash is being written, or about to be.
    pub(crate) fn is_storing(&self) -> bool {
        self.store.busy || self.keeper.job().is_some()
    }

    /// Where a table of this name lies, or may.
    pub(crate) fn place_for(&self, name: &TableName) -> Option<usize> {
        let named = self.slots.iter().position(|s| s.as_ref().is_some_and(|s| s.listing.name == *name));
        let free = |place: usize| self.slots.get(place).is_some_and(Option::is_none);
        let unread = |place: usize| self.unreadable & bit_of(place) != 0;
        let mut places = 0..self.slots.len();
        named
            .or_else(|| places.clone().find(|n| free(*n) && !unread(*n)))
            .or_else(|| places.find(|n| free(*n)))
    }

    /// Whether damage was found that nobody has read of yet.
    fn hides_damage(&self) -> bool {
        self.incidents.iter().any(|incident| incident.cause == IncidentCause::StoreDamaged)
    }

    /// Begins to keep a value, or says how far that is.
    #[inline(never)]
    pub(crate) fn keep(&mut self, key: Key, value: Option<Value>, now_us: u64) -> Result<Reply, Refusal> {
        if self.keeper.take_failure(key) {
            return Err(Refusal::StoreFailed);
        }
        if self.is_storing() {
            return Ok(Reply::Pending);
        }
        if self.hides_damage() {
            return Err(Refusal::ArmingBlocked(ArmingBlock::INCIDENT.0));
        }
        // Everything that is kept fits.
        let value = value.ok_or(Refusal::OutOfRange)?;
        if self.store.present {
            self.keeper.begin(key, value);
            return Ok(Reply::Pending);
        }
        self.take_into_force(key, &value, now_us);
        Ok(Reply::Done)
    }

    #[inline(never)]
    fn take_into_force(&mut self, key: Key, value: &Value, now_us: u64) {
        self.events.push(now_us, Happening::Stored);
        self.damaged.set(key, false);
        if let Key::Table(place) = key {
            self.unreadable &= !bit_of(place.into());
        }
        if !value.is_empty() {
            // It was written by this firmware a moment ago.
            let _ = self.restore(key, value);
            return;
        }
        match key {
            Key::Pairing => self.pairing = None,
            Key::Table(place) => {
                if let Some(there) = self.slots.get_mut(usize::from(place)) {
                    *there = None;
                }
            }
            Key::Vehicle | Key::Settings => {}
        }
    }

    /// Looks after the job under way.
    pub(crate) fn note_store(&mut self, store: StoreStatus) {
        self.store = store;
        if let Some(job) = self.keeper.finish(store.finished, store.failed) {
            self.take_into_force(job.key, &job.value, self.last_us.unwrap_or(0));
        }
        self.free_lost_place();
    }

    /// Where a table was damaged and none is left nobody can name it: once a person has read of the damage its place is freed.
    fn free_lost_place(&mut self) {
        if !self.damaged.is_any() || !self.store.present || self.is_storing() {
            return;
        }
        let lost = |key: &Key| match *key {
            Key::Table(place) => {
                self.damaged.of(*key) && self.slots.get(usize::from(place)).is_some_and(Option::is_none)
            }
            _ => false,
        };
        if let Some(key) = Key::ALL.into_iter().find(lost).filter(|_| !self.hides_damage()) {
            self.keeper.begin(key, Value::new());
            // Once: where flash fails the next start tells it again.
            self.damaged.set(key, false);
        }
    }

    /// Learns the gyro's bias anew; once per request.
    pub(crate) fn calibrate(&mut self, number: u16, now_us: u64) -> Result<Reply, Refusal> {
        let state = self.state();
        if !matches!(state, FlightState::Disarmed | FlightState::Calibrating) {
            return Err(Refusal::WrongState(state));
        }
        let repeated = is_repeated(self.calibrated_by, number, now_us);
        self.calibrated_by = Some((number, now_us));
        if state == FlightState::Calibrating {
            return Ok(Reply::Pending);
        }
        if repeated {
            return Ok(Reply::Done);
        }
        self.gyro.forget_bias();
        Ok(Reply::Pending)
    }

    /// Begins guided turns, says how far they are, keeps what they found.
    #[inline(never)]
    pub(crate) fn calibrate_scale(&mut self, asked: (u16, u8, i8), now_us: u64) -> Result<Reply, Refusal> {
        let (number, axis, turns) = asked;
        if turns == 0 {
            self.turns = None;
            return Ok(Reply::Done);
        }
        if self.state() != FlightState::Disarmed {
            return Err(Refusal::WrongState(self.state()));
        }
        let same = |turns: &&mut Turns| {
            turns.asked == asked && is_repeated(Some((number, turns.asked_us)), number, now_us)
        };
        let Some(under_way) = self.turns.as_mut().filter(same) else {
            let body_axis = match axis {
                0 => Axis::Forward,
                1 => Axis::Left,
                2 => Axis::Up,
                _ => return Err(Refusal::Calibration(CalibrationError::Turns)),
            };
            let begun = ScaleCalibration::start(body_axis, turns).map_err(Refusal::Calibration)?;
            self.turns = Some(Turns { asked, asked_us: now_us, under_way: begun, found: None });
            return Ok(Reply::Pending);
        };
        under_way.asked_us = now_us;
        match under_way.found {
            None => Ok(Reply::Pending),
            Some(Err(error)) => Err(Refusal::Calibration(error)),
            Some(Ok(scale)) => {
                let mut settings = self.settings;
                let slot = settings.gyro_scale.get_mut(usize::from(axis)).ok_or(Refusal::OutOfRange)?;
                // The calibration finds none beyond the bounds of settings.
                *slot = scale;
                if self.settings == settings && !self.damaged.of(Key::Settings) {
                    return Ok(Reply::Done);
                }
                self.keep(Key::Settings, keeping::value(&settings), now_us)
            }
        }
    }
}

/// Of a table's place, in a set of them.
fn bit_of(place: usize) -> u8 {
    1_u8.checked_shl(place as u32).unwrap_or(0)
}

//! The staged bytes and the committed table. A commit checks everything first and then replaces the old table at once;
//! nothing else ever changes it.

use heapless::Vec;
use mintime_shared::messages::Refusal;
use mintime_shared::plane::Plane;
use mintime_shared::replay::Plan;
use mintime_shared::table::{MAX_TABLE_BYTES, ManeuverTable, TableError};

use crate::config::{GATE_TILT_COS, VehicleConfig};

/// A table's bytes.
pub(crate) type TableBytes = Vec<u8, MAX_TABLE_BYTES>;

/// See the module's first line.
#[derive(Clone, Debug, Default)]
pub(crate) struct Tables {
    staged: TableBytes,
    /// Bytes of the whole table that is being staged.
    total: u16,
    /// Why the staged bytes cannot be flown, where that is known: a host that asks again and again costs nothing.
    refused: Option<Refusal>,
    committed: Option<Committed>,
}

/// The table to fly.
#[derive(Clone, Debug)]
pub(crate) struct Committed {
    pub(crate) table: ManeuverTable,
    pub(crate) checksum: u32,
    /// The attitude from which it may be triggered.
    pub(crate) gate: StartGate,
}

/// What a commit did.
#[expect(clippy::large_enum_variant, reason = "no allocator to box with; it lives for one call")]
pub(crate) enum Commit {
    /// The table is committed; this is it in time.
    New(Plan),
    /// It was before; its duration, s.
    Already(f32),
}

impl Tables {
    pub(crate) const fn new() -> Self {
        Self { staged: Vec::new(), total: 0, refused: None, committed: None }
    }

    /// Takes a chunk and returns how many bytes are held from the beginning on.
    #[inline(never)]
    pub(crate) fn stage(&mut self, total: u16, offset: u16, bytes: &[u8]) -> Result<u16, Refusal> {
        let (begin, end) = (usize::from(offset), usize::from(offset).saturating_add(bytes.len()));
        if bytes.is_empty() || usize::from(total) > MAX_TABLE_BYTES || end > usize::from(total) {
            return Err(Refusal::Table(TableError::Length));
        }
        if offset == 0 && self.total != total {
            self.staged.clear();
            self.total = total;
        }
        let held = self.staged.len();
        if total != self.total {
            return Err(Refusal::Table(TableError::Length));
        }
        if begin > held {
            // No longer than the longest table.
            return Err(Refusal::Gap { expected: held as u16 });
        }
        if self.staged.get(begin..end) != Some(bytes) {
            // New bytes, or other ones than before: what follows them counts no more.
            self.staged.truncate(begin);
            self.staged.extend_from_slice(bytes).map_err(|_| Refusal::Table(TableError::Length))?;
            self.refused = None;
        }
        Ok(self.staged.len() as u16)
    }

    /// Checks the staged bytes and commits them.
    pub(crate) fn commit(&mut self, checksum: u32, config: &VehicleConfig) -> Result<Commit, Refusal> {
        if self.staged.is_empty() {
            // Asked again after the answer was lost: it is so already.
            let same = self.committed.as_ref().filter(|c| c.checksum == checksum);
            return same.map(|c| Commit::Already(c.table.duration_s())).ok_or(Refusal::NotStaged);
        }
        if let Some(refusal) = self.refused {
            return Err(refusal);
        }
        if self.staged.len() < usize::from(self.total) {
            return Err(Refusal::Gap { expected: self.staged.len() as u16 });
        }
        let table = check(&self.staged, checksum, config).inspect_err(|refusal| {
            // It stays so until other bytes are staged, except that another checksum may be named.
            self.refused = Some(*refusal).filter(|r| *r != Refusal::NotStaged);
        })?;
        self.staged.clear();
        Ok(self.put(table, checksum))
    }

    /// Checks a stored table and commits it.
    pub(crate) fn load(
        &mut self,
        bytes: &[u8],
        checksum: u32,
        config: &VehicleConfig,
    ) -> Result<Commit, Refusal> {
        if let Some(same) = self.committed.as_ref().filter(|c| c.checksum == checksum) {
            return Ok(Commit::Already(same.table.duration_s()));
        }
        let table = check(bytes, checksum, config)?;
        Ok(self.put(table, checksum))
    }

    #[inline(never)]
    fn put(&mut self, table: ManeuverTable, checksum: u32) -> Commit {
        let plan = Plan::new(&table);
        let gate = StartGate::new(table.start.theta, plan.plane());
        self.committed = Some(Committed { table, checksum, gate });
        Commit::New(plan)
    }

    /// The vehicle has become another one: what was checked for the old one counts no more.
    pub(crate) fn forget(&mut self) {
        *self = Self::new();
    }

    /// The committed bytes; empty where there are none.
    #[inline(never)]
    pub(crate) fn read(&self) -> TableBytes {
        let mut bytes = TableBytes::new();
        if let Some(c) = &self.committed {
            let mut buffer = [0; MAX_TABLE_BYTES];
            let length = c.table.encode(&mut buffer).unwrap_or(0);
            let _ = bytes.extend_from_slice(buffer.get(..length).unwrap_or_default());
        }
        bytes
    }

    pub(crate) fn committed(&self) -> Option<&Committed> {
        self.committed.as_ref()
    }

    /// Checksum of the committed table; 0 where there is none.
    pub(crate) fn committed_checksum(&self) -> u32 {
        self.committed.as_ref().map_or(0, |c| c.checksum)
    }
}

/// The table in these bytes, if it can be flown. The dearest thing there is: 0.3 ms.
fn check(bytes: &[u8], checksum: u32, config: &VehicleConfig) -> Result<ManeuverTable, Refusal> {
    let table = ManeuverTable::decode(bytes).map_err(Refusal::Table)?;
    if table.checksum() != checksum {
        return Err(Refusal::NotStaged);
    }
    table.check_for(config.hash(), &config.plan_limits()).map_err(Refusal::Table)?;
    Ok(table)
}

/// Where world-up lies in the body at a table's start. Worked out with the commit, where no motor waits for it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct StartGate {
    plane: Plane,
    sin: f32,
    cos: f32,
}

impl StartGate {
    fn new(theta_rad: f32, plane: Plane) -> Self {
        let (sin, cos) = libm::sincosf(theta_rad);
        Self { plane, sin, cos }
    }

    /// Whether the thrust axis points where the start wants it, within [`crate::config::GATE_TILT_RAD`] in any direction. What turned
    /// about the vertical is not seen: the plane is one of the body's.
    pub(crate) fn is_met(&self, up_in_body: [f32; 3]) -> bool {
        // A thrust axis that tips towards the heading sees world-up lean the other way.
        let [along, _, up] = self.plane.axes(up_in_body);
        self.cos * up - self.sin * along >= GATE_TILT_COS
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::attitude::{AttitudeEstimate, Motion};
    use crate::config::GATE_TILT_RAD;

    /// Where world-up lies in a body that stood level and then turned by an angle in the plane of a heading.
    fn up_after(theta_rad: f32, heading_rad: f32) -> [f32; 3] {
        const STEPS: u16 = 200;
        let mut attitude = AttitudeEstimate::new();
        for _ in 0..2000 {
            attitude.update([0.0; 3], [0.0, 0.0, 9.81], 1.25e-3, Motion::MotorsOff);
        }
        let dt_s = 1.25e-3;
        // In the first step the rate rises from zero.
        let rate_radps = theta_rad / ((f32::from(STEPS) - 0.5) * dt_s);
        for _ in 0..STEPS {
            // In free fall, so that nothing but the turn counts.
            attitude.update(Plane::new(heading_rad).turn(rate_radps), [0.0; 3], dt_s, Motion::Maneuver);
        }
        attitude.up_in_body()
    }

    /// By turning there: within the gate's angle of the start's own, in its own direction, and nowhere else.
    #[test]
    fn the_gate_is_open_just_around_the_starts_attitude() {
        assert!((GATE_TILT_RAD.cos() - GATE_TILT_COS).abs() < 1e-6);
        for heading in [0.0_f32, 0.7, -2.4] {
            for start in -31..=31 {
                let start = start as f32 * 0.1;
                let gates =
                    [start, start + core::f32::consts::TAU].map(|s| StartGate::new(s, Plane::new(heading)));
                for away in [-0.5_f32, -0.125, -0.115, 0.0, 0.115, 0.125, 0.5] {
                    let up = up_after(start + away, heading);
                    for gate in gates {
                        assert_eq!(gate.is_met(up), away.abs() < GATE_TILT_RAD, "{heading} {start} {away}");
                    }
                }
                // The same tilt to the other side, and in another plane.
                if start.abs() > 0.2 && start.abs() < 2.9 {
                    assert!(!gates[0].is_met(up_after(-start, heading)), "{heading} {start}");
                    assert!(!gates[0].is_met(up_after(start, heading + 1.6)), "{heading} {start}");
                }
            }
        }
    }
}

//! The maneuver table byte by byte: where each field stands, what it means, what it says.

use mintime_shared::model::{RateMode, ThrustLevel};
use mintime_shared::table::{ANY_VEHICLE, Kind, LinkPolicy, ManeuverTable};
use serde::Serialize;

use crate::solver::MAX_SEGMENTS;

/// The encoded table and its fields, which cover it without gap.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct TableBytes {
    /// The bytes, hexadecimal, two digits each.
    pub hex: String,
    /// Its fields in order.
    pub fields: Vec<TableField>,
}

/// One field of a table.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct TableField {
    /// Where it begins, bytes.
    pub offset: usize,
    /// Its length, bytes.
    pub length: usize,
    /// What it is.
    pub name: String,
    /// What it says, with unit.
    pub value: String,
    /// What it is for.
    pub meaning: &'static str,
    /// Fields that belong together have one colour: index into their names, 0..8.
    pub group: usize,
}

/// What the fields of each group are about.
pub(super) const GROUPS: [&str; 8] =
    ["whose", "kind", "limits and plane", "start", "end", "singular arcs", "segments", "checksum"];

/// Indices into [`GROUPS`].
mod group {
    pub(super) const NAMES: usize = 0;
    pub(super) const KIND: usize = 1;
    pub(super) const LIMITS: usize = 2;
    pub(super) const START: usize = 3;
    pub(super) const END: usize = 4;
    pub(super) const ARCS: usize = 5;
    pub(super) const SEGMENTS: usize = 6;
    pub(super) const CHECK: usize = 7;
}

/// Where a table's numbers come from, in a word.
pub(super) fn origin(table: &ManeuverTable) -> &'static str {
    match table.kind {
        Kind::Extremal => "extremal",
        Kind::Retimed => "retimed",
        Kind::Learned => "learned",
    }
}

/// Puts fields one after the other.
struct Walk<'a> {
    bytes: &'a [u8],
    fields: Vec<TableField>,
    at: usize,
}

impl Walk<'_> {
    fn field(
        &mut self,
        length: usize,
        group: usize,
        name: impl Into<String>,
        value: String,
        meaning: &'static str,
    ) {
        self.fields.push(TableField { offset: self.at, length, name: name.into(), value, meaning, group });
        self.at += length;
    }

    fn float(&mut self, group: usize, name: impl Into<String>, unit: &str, meaning: &'static str) {
        let four = self.bytes.get(self.at..).and_then(|rest| rest.first_chunk::<4>());
        let value = four.map_or_else(String::new, |b| format!("{} {unit}", f32::from_le_bytes(*b)));
        self.field(4, group, name, value, meaning);
    }

    fn state(&mut self, group: usize, which: &str, meaning: &'static str) {
        for (name, unit) in
            [("x", "m"), ("speed in x", "m/s"), ("z", "m"), ("speed in z", "m/s"), ("pitch", "rad")]
        {
            self.float(group, format!("{which}: {name}"), unit, meaning);
        }
    }
}

impl TableBytes {
    /// Of a table and its encoding.
    pub(super) fn new(table: &ManeuverTable, bytes: &[u8]) -> Self {
        let mut walk = Walk { bytes, fields: Vec::with_capacity(20 + 2 * MAX_SEGMENTS), at: 0 };
        let word = |at: usize| {
            let four = bytes.get(at..).and_then(|rest| rest.first_chunk::<4>());
            four.map_or_else(String::new, |b| format!("{:08x}", u32::from_le_bytes(*b)))
        };
        walk.field(4, group::NAMES, "schema", word(0), "this layout; a vehicle refuses every other");
        let vehicle = match table.vehicle {
            ANY_VEHICLE => "any vehicle".to_owned(),
            _ => word(4),
        };
        walk.field(4, group::NAMES, "vehicle", vehicle, "hash of the vehicle it was made for");
        walk.field(1, group::KIND, "kind", origin(table).to_owned(), "where the numbers come from");
        let link = match table.link {
            LinkPolicy::Finish => "finish",
            LinkPolicy::Abandon => "abandon",
        };
        walk.field(1, group::KIND, "link loss", link.to_owned(), "what to do where the host falls silent");
        const LIMITS: &str = "limit that it was planned with; a vehicle refuses what is beyond its own";
        walk.float(group::LIMITS, "lowest thrust", "m/s²", LIMITS);
        walk.float(group::LIMITS, "highest thrust", "m/s²", LIMITS);
        walk.float(group::LIMITS, "highest pitch rate", "rad/s", LIMITS);
        walk.float(group::LIMITS, "gravity", "m/s²", "gravity that it was planned with");
        walk.float(group::LIMITS, "heading", "rad", "of the maneuver's plane, from forward to the left");
        walk.state(group::START, "start", "state in which the maneuver begins");
        walk.state(group::END, "end", "state in which it ends; the pitch counts full turns");
        let arcs = if table.arcs.is_some() { "yes" } else { "no" };
        walk.field(1, group::ARCS, "singular arcs", arcs.to_owned(), "whether a profile of the arcs follows");
        if table.arcs.is_some() {
            const ARC: &str = "rate on all singular arcs: width / (width² + (t − peak)²), eq. (15)";
            walk.float(group::ARCS, "arcs: width", "s", ARC);
            walk.float(group::ARCS, "arcs: peak", "s", ARC);
        }
        let count = table.segments().len().to_string();
        walk.field(1, group::SEGMENTS, "segments", count, "how many segments follow");
        for (i, segment) in table.segments().enumerate() {
            let rate = match segment.inputs.rate {
                RateMode::Plus => "+limit",
                RateMode::Minus => "−limit",
                RateMode::Singular => "on the arc",
            };
            let thrust = match segment.inputs.thrust {
                ThrustLevel::Min => "lowest",
                ThrustLevel::Max => "highest",
            };
            let name = format!("segment {}: inputs", i + 1);
            let value = format!("pitch rate {rate}, thrust {thrust}");
            walk.field(1, group::SEGMENTS, name, value, "bits 0 and 1: pitch rate; bit 2: thrust");
            walk.float(
                group::SEGMENTS,
                format!("segment {}: duration", i + 1),
                "s",
                "until the next switching time",
            );
        }
        let checksum = word(bytes.len().saturating_sub(4));
        walk.field(
            4,
            group::CHECK,
            "checksum",
            checksum,
            "CRC-32 of all before: the table's name on the link",
        );
        Self { hex: bytes.iter().map(|b| format!("{b:02x}")).collect(), fields: walk.fields }
    }
}

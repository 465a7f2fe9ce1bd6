//! The maneuver table: all that a vehicle needs to fly a maneuver, in some dozens of bytes.
//!
//! It holds the inputs and the duration of each segment. Singular arcs are stored as a *rate* profile, never as an
//! absolute angle: eq. (15) is a Lorentzian that depends on the costate only through a width and a peak time, two
//! numbers that all arcs of a maneuver share. So a retimed or learned table stays smooth, and the vehicle needs no
//! attitude.
//!
//! # Bytes
//!
//! postcard, little-endian, fixed order; a table with n segments and arcs takes 84 + 5 n bytes (8 fewer without arcs):
//!
//! | bytes | field |
//! |---|---|
//! | 4 | schema hash: this layout |
//! | 4 | vehicle hash: whom it was made for, 0 for any: then no vehicle takes it yet |
//! | 1 | kind: extremal 0, retimed 1, learned 2 |
//! | 1 | what to do where the link is lost on the way: finish 0, abandon 1 |
//! | 16 | limits it was planned with: thrust min, max (m/s²), rate (rad/s), gravity (m/s²), each `f32` |
//! | 4 | heading of the maneuver's plane from the body's forward axis towards left, rad, `f32` |
//! | 20 | start state x, ẋ, z, ż, θ, each `f32`, SI |
//! | 20 | end state, likewise; θ unwrapped, so the turns are in it |
//! | 1 or 9 | 0: no arcs; 1: width (s, signed) and peak time (s from the start), each `f32` |
//! | 1 | number of segments |
//! | 5 each | one byte of inputs (bits 0-1: rate + 0, − 1, singular 2; bit 2: thrust max), duration (s) `f32` |
//! | 4 | CRC-32 of all before |

use heapless::Vec;
use serde::{Deserialize, Serialize};

use crate::checksum;
use crate::minimum_principle::Costate;
use crate::model::{Inputs, Limits, LimitsError, RateMode, Segment, State, ThrustLevel};
use crate::motion::{self, Arc, Turn};

/// Most segments a table can hold. The longest extremal seen over thousands of random requests has 13.
pub const MAX_SEGMENTS: usize = 24;
/// Most bytes an encoded table can take: 84 + 5·24.
pub const MAX_TABLE_BYTES: usize = 204;
/// Longest maneuver accepted, s. A table is a maneuver, not a mission.
pub const MAX_DURATION_S: f32 = 10.0;
/// Vehicle hash of a table for any vehicle: none takes it before a host has made it that vehicle's own,
/// [`ManeuverTable::assigned_to`].
pub const ANY_VEHICLE: u32 = 0;

/// Identifies the layout above; changes with every change of it.
pub const SCHEMA_HASH: u32 = checksum::crc32(
    b"mintime table 2: schema u32, vehicle u32, kind u8, link u8, limits 4f32, heading f32, start 5f32, end 5f32, \
      arcs option(width f32, peak f32), segments [inputs u8, duration f32]",
);

/// Positions beyond this are nonsense for a maneuver in one room, m.
const MAX_POSITION_M: f32 = 1000.0;
/// Velocities beyond this are nonsense for a maneuver in one room, m/s.
const MAX_VELOCITY_MPS: f32 = 100.0;
/// Angles beyond this are nonsense, rad: eight turns.
const MAX_ANGLE_RAD: f32 = 51.0;
/// Highest thrust per mass, m/s², and body rate, rad/s, of any vehicle: hundreds of times what there is. Beyond, the motion of an
/// arc is no number in 32 bits.
const MAX_LIMIT: f32 = 1e4;
/// How far a table's gravity may be from the vehicle's, m/s²: gravity varies by that over the Earth.
const GRAVITY_TOLERANCE_MPS2: f32 = 0.05;
/// Largest magnitude of an arc's width and peak time, s: wider is straight, later is elsewhere.
pub const MAX_ARC_TIME_S: f32 = 1.0e6;
/// What a learned table may make up for, m/s²: drag at 15 m/s, and thrust that is a tenth off.
const LEARNED_ACCELERATION_MPS2: f32 = 5.0;
/// For so long at most, s: later, speed and drag have found their balance.
const LEARNED_DURATION_S: f32 = 2.0;
/// How much an arc may exceed the rate limit: rounding to `f32` only.
const ARC_RATE_TOLERANCE: f32 = 1.0e-4;

/// Where a table's numbers come from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Kind {
    /// Straight from a verified extremal.
    Extremal,
    /// Durations adjusted so that the tick-by-tick replay arrives exactly.
    Retimed,
    /// Durations adjusted by what earlier flights taught.
    Learned,
}

/// What becomes of a maneuver whose host falls silent on the way.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum LinkPolicy {
    /// Fly it to its end: half a flip is worse than a whole one.
    #[default]
    Finish,
    /// Give it up: level, sink, motors off.
    Abandon,
}

/// The rate on every singular arc of a maneuver: width / (width² + (t − peak)²), eq. (15) in SI units.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct ArcProfile {
    /// Signed width, s; its sign is the direction of the turn, 1/|width| the peak rate in rad/s.
    pub width_s: f32,
    /// Time of the peak, s from the maneuver's start. May lie outside the maneuver.
    pub peak_s: f32,
}

impl ArcProfile {
    /// The profile that a costate implies, for durations in s: eq. (15) with width (c2 c3 − c1 c4)/(c1² + c3²) and peak
    /// (c1 c2 + c3 c4)/(c1² + c3²), scaled by eq. (3). A costate that does not move (c1 = c3 = 0) means a straight line,
    /// and one that moves hardly an almost straight one: both become the widest profile there is.
    ///
    /// # Errors
    /// [`TableError::Arcs`] where (p2, p4) passes through zero, [`TableError::NotFinite`] for NaN and infinities.
    pub fn from_costate(costate: &Costate<f64>, limits: &Limits<f64>) -> Result<Self, TableError> {
        let Costate { c1, c2, c3, c4 } = *costate;
        let time_s = limits.scale().time_s;
        let norm2 = c1 * c1 + c3 * c3;
        let widest = f64::from(MAX_ARC_TIME_S);
        let (width_s, peak_s) = (time_s * (c2 * c3 - c1 * c4) / norm2, time_s * (c1 * c2 + c3 * c4) / norm2);
        if norm2 == 0.0 || width_s.abs() > widest || peak_s.abs() > widest {
            return Ok(Self { width_s: MAX_ARC_TIME_S, peak_s: 0.0 });
        }
        if !(width_s.is_finite() && peak_s.is_finite()) {
            return Err(TableError::NotFinite);
        }
        if width_s == 0.0 {
            return Err(TableError::Arcs);
        }
        Ok(Self { width_s: width_s as f32, peak_s: peak_s as f32 })
    }

    /// Largest magnitude of the rate between two times, s from the maneuver's start. It depends on how near the peak
    /// comes and on nothing else, so a profile as narrow as rounding cannot hide its peak.
    fn peak_rate(&self, from_s: f32, to_s: f32) -> f32 {
        let nearest = self.peak_s.max(from_s).min(to_s) - self.peak_s;
        // width/(width² + nearest²) without squares that underflow.
        let width = self.width_s.abs();
        1.0 / (width + nearest * (nearest / width))
    }

    /// The arc as entered at a time, s from the maneuver's start.
    pub fn entered_at(&self, time_s: f32) -> Arc<f32> {
        let since = time_s - self.peak_s;
        let norm2 = self.width_s * self.width_s + since * since;
        Arc { rate: self.width_s / norm2, drift: -since / norm2 }
    }
}

/// A maneuver as the vehicle takes it. SI units.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ManeuverTable {
    #[serde(with = "postcard::fixint::le")]
    schema: u32,
    /// Whom it was made for: a vehicle's hash, or [`ANY_VEHICLE`].
    #[serde(with = "postcard::fixint::le")]
    pub vehicle: u32,
    /// Where its numbers come from.
    pub kind: Kind,
    /// What to do where the link is lost on the way.
    pub link: LinkPolicy,
    /// Limits it was planned with.
    pub limits: Limits<f32>,
    /// Heading of the maneuver's vertical plane in the body frame at the start, rad: 0 is forward, positive to the left.
    /// The vehicle need not yaw there: [`crate::plane`].
    pub heading_rad: f32,
    /// Expected start.
    pub start: State<f32>,
    /// Expected end; θ unwrapped.
    pub end: State<f32>,
    /// The rate profile of the singular arcs, if there are any.
    pub arcs: Option<ArcProfile>,
    segments: Vec<TableSegment, MAX_SEGMENTS>,
}

#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
struct TableSegment {
    inputs: InputCode,
    duration_s: f32,
}

/// [`Inputs`] in one byte.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(into = "u8", try_from = "u8")]
struct InputCode(Inputs);

impl From<InputCode> for u8 {
    fn from(InputCode(inputs): InputCode) -> u8 {
        let rate = match inputs.rate {
            RateMode::Plus => 0,
            RateMode::Minus => 1,
            RateMode::Singular => 2,
        };
        let thrust = match inputs.thrust {
            ThrustLevel::Min => 0,
            ThrustLevel::Max => 4,
        };
        rate | thrust
    }
}

impl TryFrom<u8> for InputCode {
    type Error = &'static str;
    fn try_from(code: u8) -> Result<Self, Self::Error> {
        let rate = match code & 3 {
            0 => RateMode::Plus,
            1 => RateMode::Minus,
            2 => RateMode::Singular,
            _ => return Err("unknown rate mode"),
        };
        let thrust = match code >> 2 {
            0 => ThrustLevel::Min,
            1 => ThrustLevel::Max,
            _ => return Err("unknown thrust level"),
        };
        Ok(Self(Inputs { rate, thrust }))
    }
}

/// Why bytes or numbers are not a table that can be flown.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, thiserror::Error)]
pub enum TableError {
    /// Fewer bytes than the shortest table, or more than the longest.
    #[error("this is not a maneuver table: its length is wrong")]
    Length,
    /// The checksum does not match the bytes.
    #[error("the table is corrupt (checksum mismatch): compute or copy it again")]
    Checksum,
    /// The layout is another version's.
    #[error("the table has another layout version: make it again with this version of mintime")]
    Schema,
    /// The checksum holds but the content does not parse.
    #[error("the table's content does not parse: it was not written by mintime")]
    Malformed,
    /// Made for another vehicle.
    #[error("the table was made for another vehicle: make or learn it on this one")]
    OtherVehicle,
    /// Limits that cannot be planned with.
    #[error("the table's limits are unusable: {0}")]
    Limits(LimitsError),
    /// A number is NaN, infinite or absurdly large.
    #[error("the table holds a number that is not finite or out of range")]
    NotFinite,
    /// No segments.
    #[error("the table has no segments: there is nothing to fly")]
    Empty,
    /// More segments than a table can hold.
    #[error("the maneuver has more segments than a table can hold")]
    TooManySegments,
    /// A duration is zero or negative.
    #[error("a segment's duration is not above zero")]
    Duration,
    /// The whole takes longer than [`MAX_DURATION_S`].
    #[error("the maneuver is longer than the 10 s that a vehicle accepts")]
    TooLong,
    /// A singular segment without a profile, a profile without one, or an arc at minimum thrust.
    #[error("the table's singular arcs and their profile do not fit together")]
    Arcs,
    /// An arc would turn faster than the rate limit.
    #[error("a singular arc exceeds the rate limit")]
    ArcRate,
    /// The segments do not lead from the stated start to the stated end.
    #[error("the segments do not lead to the stated end: the table is inconsistent, compute it again")]
    End,
    /// The vehicle cannot deliver the thrust or rate that the table was planned with.
    #[error("the table asks for thrust or body rate that this vehicle does not have: plan within its limits")]
    BeyondVehicle,
    /// Planned for another gravity than the vehicle's.
    #[error("the table was planned with another gravity than the vehicle flies in: plan it with 9.81 m/s²")]
    Gravity,
    /// Made for [`ANY_VEHICLE`]: nobody has said yet that this one shall fly it.
    #[error(
        "the table is for any vehicle: mintime makes it one vehicle's own when it uploads it, once that vehicle has been told what it is (mintime vehicle ... params)"
    )]
    AnyVehicle,
}

/// How far the exact motion may miss the stated end.
struct EndTolerance {
    position_m: f32,
    velocity_mps: f32,
    angle_rad: f32,
}

impl Kind {
    /// Extremals and retimed tables reach their end in the model up to rounding in `f32`. A learned one misses it in
    /// the model so as to reach it in the world, by what [`LEARNED_ACCELERATION_MPS2`] does over its duration, as far as
    /// [`LEARNED_DURATION_S`]: here only nonsense is kept out.
    fn end_tolerance(self, duration_s: f32) -> EndTolerance {
        match self {
            Self::Extremal | Self::Retimed => {
                EndTolerance { position_m: 5.0e-3, velocity_mps: 1.0e-2, angle_rad: 1.0e-3 }
            }
            Self::Learned => {
                let duration_s =
                    if duration_s < LEARNED_DURATION_S { duration_s } else { LEARNED_DURATION_S };
                let velocity_mps = LEARNED_ACCELERATION_MPS2 * duration_s;
                let position_m = 0.5 * velocity_mps * duration_s;
                EndTolerance {
                    position_m: if position_m > 3.0 { position_m } else { 3.0 },
                    velocity_mps: if velocity_mps > 5.0 { velocity_mps } else { 5.0 },
                    angle_rad: 1.0,
                }
            }
        }
    }
}

impl ManeuverTable {
    /// Assembles and checks a table.
    ///
    /// # Errors
    /// The reason for which a vehicle would refuse it.
    pub fn new(
        header: TableHeader,
        arcs: Option<ArcProfile>,
        segments: impl IntoIterator<Item = Segment<f32>>,
    ) -> Result<Self, TableError> {
        let mut packed = Vec::new();
        for Segment { inputs, duration } in segments {
            packed
                .push(TableSegment { inputs: InputCode(inputs), duration_s: duration })
                .map_err(|_| TableError::TooManySegments)?;
        }
        let TableHeader { vehicle, kind, link, limits, heading_rad, start, end } = header;
        let table = Self {
            schema: SCHEMA_HASH,
            vehicle,
            kind,
            link,
            limits,
            heading_rad,
            start,
            end,
            arcs,
            segments: packed,
        };
        table.check()?;
        Ok(table)
    }

    /// The segments in order, durations in s.
    pub fn segments(&self) -> impl ExactSizeIterator<Item = Segment<f32>> + '_ {
        self.segments.iter().map(|s| Segment { inputs: s.inputs.0, duration: s.duration_s })
    }

    /// Total duration T, s.
    pub fn duration_s(&self) -> f32 {
        self.segments.iter().map(|s| s.duration_s).sum()
    }

    /// The CRC-32 that ends the encoding: the table's name on the link.
    pub fn checksum(&self) -> u32 {
        let mut buffer = [0; MAX_TABLE_BYTES];
        let length = self.encode(&mut buffer).unwrap_or(0);
        buffer.get(..length).and_then(|b| b.last_chunk::<4>()).map_or(0, |tail| u32::from_le_bytes(*tail))
    }

    /// Writes the table, checksum included, and returns its length. A buffer of [`MAX_TABLE_BYTES`] always suffices.
    ///
    /// # Errors
    /// [`TableError::Length`] where the buffer is too small.
    pub fn encode(&self, buffer: &mut [u8]) -> Result<usize, TableError> {
        let body = postcard::to_slice(self, buffer).map_err(|_| TableError::Length)?.len();
        checksum::append(buffer, body).ok_or(TableError::Length)
    }

    /// Reads a table and checks all that can be checked without knowing the vehicle.
    ///
    /// # Errors
    /// The first reason in the order: length, checksum, layout, content, then [`Self::check`].
    pub fn decode(bytes: &[u8]) -> Result<Self, TableError> {
        if bytes.len() > MAX_TABLE_BYTES {
            return Err(TableError::Length);
        }
        let (body, intact) = checksum::split(bytes).ok_or(TableError::Length)?;
        let schema = body.first_chunk::<4>().ok_or(TableError::Length)?;
        if !intact {
            return Err(TableError::Checksum);
        }
        if u32::from_le_bytes(*schema) != SCHEMA_HASH {
            return Err(TableError::Schema);
        }
        let (table, rest): (Self, _) = postcard::take_from_bytes(body).map_err(|_| TableError::Malformed)?;
        if !rest.is_empty() {
            return Err(TableError::Malformed);
        }
        table.check()?;
        Ok(table)
    }

    /// The validity check: numbers finite and in range, arcs consistent, and the exact motion over the segments leads
    /// from the stated start to the stated end.
    ///
    /// Bounded work: at most [`MAX_SEGMENTS`] closed-form segments.
    ///
    /// # Errors
    /// The first reason that applies.
    pub fn check(&self) -> Result<(), TableError> {
        self.limits.validate().map_err(TableError::Limits)?;
        let within = |values: [f32; 2], bound: f32| values.iter().all(|v| v.abs() <= bound);
        let in_range = |s: &State<f32>| {
            within([s.x, s.z], MAX_POSITION_M)
                && within([s.vx, s.vz], MAX_VELOCITY_MPS)
                && s.theta.abs() <= MAX_ANGLE_RAD
        };
        let limits = [self.limits.thrust_max_mps2, self.limits.rate_max_radps];
        if !(within(limits, MAX_LIMIT)
            && in_range(&self.start)
            && in_range(&self.end)
            && self.heading_rad.abs() <= 2.0 * core::f32::consts::PI)
        {
            return Err(TableError::NotFinite);
        }
        if self.segments.is_empty() {
            return Err(TableError::Empty);
        }
        if !self.segments.iter().all(|s| s.duration_s.is_finite()) {
            return Err(TableError::NotFinite);
        }
        if !self.segments.iter().all(|s| s.duration_s > 0.0) {
            return Err(TableError::Duration);
        }
        if self.duration_s() > MAX_DURATION_S {
            return Err(TableError::TooLong);
        }
        self.check_arcs()?;
        let tolerance = self.kind.end_tolerance(self.duration_s());
        let miss = self.planned_end().minus(self.end);
        let arrives = miss.x.abs() <= tolerance.position_m
            && miss.z.abs() <= tolerance.position_m
            && miss.vx.abs() <= tolerance.velocity_mps
            && miss.vz.abs() <= tolerance.velocity_mps
            && miss.theta.abs() <= tolerance.angle_rad;
        if arrives { Ok(()) } else { Err(TableError::End) }
    }

    /// The same table for one vehicle, by its hash: one for any vehicle becomes its own, one of its own stays as it is. For
    /// hosts, where somebody decides that a maneuver is meant for this vehicle.
    ///
    /// # Errors
    /// Those of [`Self::check_for`]; [`TableError::AnyVehicle`] for a hash that is none.
    pub fn assigned_to(&self, vehicle: u32, able: &PlanLimits) -> Result<Self, TableError> {
        let mut table = self.clone();
        if table.vehicle == ANY_VEHICLE {
            table.vehicle = vehicle;
        }
        table.check_for(vehicle, able)?;
        Ok(table)
    }

    /// Whether this vehicle may fly it: made for it, and within what it can do.
    ///
    /// # Errors
    /// [`TableError::AnyVehicle`], [`TableError::OtherVehicle`], [`TableError::Gravity`], [`TableError::BeyondVehicle`].
    pub fn check_for(&self, vehicle: u32, able: &PlanLimits) -> Result<(), TableError> {
        if self.vehicle == ANY_VEHICLE {
            return Err(TableError::AnyVehicle);
        }
        if self.vehicle != vehicle {
            return Err(TableError::OtherVehicle);
        }
        if (self.limits.gravity_mps2 - able.gravity_mps2).abs() > GRAVITY_TOLERANCE_MPS2 {
            return Err(TableError::Gravity);
        }
        // Written so that a bound that is not a number refuses.
        let within = self.limits.thrust_min_mps2 >= able.thrust_min_mps2
            && self.limits.thrust_max_mps2 <= able.thrust_max_mps2
            && self.limits.rate_max_radps <= able.rate_max_radps;
        if within { Ok(()) } else { Err(TableError::BeyondVehicle) }
    }

    fn check_arcs(&self) -> Result<(), TableError> {
        let singular = |s: &TableSegment| s.inputs.0.rate == RateMode::Singular;
        let Some(profile) = self.arcs else {
            return if self.segments.iter().any(singular) { Err(TableError::Arcs) } else { Ok(()) };
        };
        let time_in_range = |t: f32| t.abs() <= MAX_ARC_TIME_S;
        if !(time_in_range(profile.width_s) && time_in_range(profile.peak_s)) {
            return Err(TableError::NotFinite);
        }
        if profile.width_s == 0.0 || !self.segments.iter().any(singular) {
            return Err(TableError::Arcs);
        }
        let mut time_s = 0.0;
        for s in &self.segments {
            if singular(s) {
                if s.inputs.0.thrust == ThrustLevel::Min {
                    return Err(TableError::Arcs);
                }
                let peak = profile.peak_rate(time_s, time_s + s.duration_s);
                let bound = self.limits.rate_max_radps * (1.0 + ARC_RATE_TOLERANCE);
                if peak > bound {
                    return Err(TableError::ArcRate);
                }
            }
            time_s += s.duration_s;
        }
        Ok(())
    }

    /// Where the exact motion over the segments ends.
    fn planned_end(&self) -> State<f32> {
        let mut state = self.start;
        let mut time_s = 0.0;
        for Segment { inputs, duration } in self.segments() {
            let turn = turn(inputs.rate, self.limits.rate_max_radps, self.arcs, time_s, duration);
            let thrust = self.limits.thrust(inputs.thrust);
            state = motion::advance(state, thrust, self.limits.gravity_mps2, duration, &turn);
            time_s += duration;
        }
        state
    }
}

/// The turn over a part of a segment that begins at `begin_s` (s from the maneuver's start) and lasts `length_s`.
pub(crate) fn turn(
    rate: RateMode,
    rate_max_radps: f32,
    arcs: Option<ArcProfile>,
    begin_s: f32,
    length_s: f32,
) -> Turn<f32> {
    match (rate.sign::<f32>(), arcs) {
        (Some(sign), _) => motion::bang(sign * rate_max_radps, length_s),
        (None, Some(profile)) => motion::singular(profile.entered_at(begin_s), length_s),
        // No table has arcs without a profile.
        (None, None) => motion::bang(0.0, length_s),
    }
}

/// What a vehicle can be planned with.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlanLimits {
    /// Lowest collective thrust per mass, m/s²: rotors at idle.
    pub thrust_min_mps2: f32,
    /// Highest collective thrust per mass, m/s².
    pub thrust_max_mps2: f32,
    /// Highest body rate, rad/s.
    pub rate_max_radps: f32,
    /// Gravity where it flies, m/s².
    pub gravity_mps2: f32,
}

/// What a table states besides its segments.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TableHeader {
    /// Whom it is made for: a vehicle's hash, or [`ANY_VEHICLE`].
    pub vehicle: u32,
    /// Where its numbers come from.
    pub kind: Kind,
    /// What to do where the link is lost on the way.
    pub link: LinkPolicy,
    /// Limits it was planned with.
    pub limits: Limits<f32>,
    /// Heading of the plane in the body frame at the start, rad.
    pub heading_rad: f32,
    /// Expected start.
    pub start: State<f32>,
    /// Expected end, θ unwrapped.
    pub end: State<f32>,
}

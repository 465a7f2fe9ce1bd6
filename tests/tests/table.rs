//! The maneuver table: what goes in comes out, what is wrong is refused for the right reason, and the bytes stay put.

use mintime_shared::crc32;
use mintime_shared::framing::encode;
use mintime_shared::messages::{PROTOCOL_VERSION, Request, Uplink};
use mintime_shared::minimum_principle::Costate;
use mintime_shared::model::{Inputs, Limits, LimitsError, RateMode, Segment, State, ThrustLevel};
use mintime_shared::motion::{Arc, advance, bang, singular};
use mintime_shared::replay::{Plan, Replay, Step, TickPeriod};
use mintime_shared::table::{
    ANY_VEHICLE, ArcProfile, Kind, LinkPolicy, MAX_SEGMENTS, MAX_TABLE_BYTES, ManeuverTable, PlanLimits,
    SCHEMA_HASH, TableError, TableHeader,
};
use mintime_shared::vehicle::VehicleConfig;
use mintime_tests::{ReferenceCase, reference_cases};
use proptest::prelude::*;

fn bytes_of(table: &ManeuverTable) -> Vec<u8> {
    let mut buffer = [0; MAX_TABLE_BYTES];
    let length = table.encode(&mut buffer).expect("a table fits its buffer");
    buffer[..length].to_vec()
}

fn case(name: &str) -> ReferenceCase {
    reference_cases().into_iter().find(|c| c.name == name).expect("the case exists")
}

/// (5, 5): arcs, both thrust levels, six segments.
fn five_five() -> ManeuverTable {
    case("general_5_5").table()
}

/// Without arcs.
fn horizontal() -> ManeuverTable {
    case("horizontal_1").table()
}

/// Where the parts of an encoded table are.
mod at {
    use core::ops::Range;

    pub(super) const VEHICLE: Range<usize> = 4..8;
    pub(super) const KIND: usize = 8;
    pub(super) const LINK: usize = 9;
    pub(super) const THRUST_MIN: usize = 10;
    pub(super) const THRUST_MAX: usize = 14;
    pub(super) const RATE: usize = 18;
    pub(super) const GRAVITY: usize = 22;
    pub(super) const HEADING: usize = 26;
    pub(super) const START: usize = 30;
    pub(super) const END: usize = 50;
    pub(super) const OPTION: usize = 70;
    pub(super) const WIDTH: usize = 71;
    pub(super) const PEAK: usize = 75;
    /// In a table with arcs.
    pub(super) const COUNT: usize = 79;
    pub(super) const SEGMENTS: usize = 80;
}

/// Changes the body of a table and makes its checksum hold again.
fn forged(table: &ManeuverTable, change: impl FnOnce(&mut Vec<u8>)) -> Result<ManeuverTable, TableError> {
    let mut bytes = bytes_of(table);
    bytes.truncate(bytes.len() - 4);
    change(&mut bytes);
    ManeuverTable::decode(&sealed(bytes))
}

fn sealed(mut body: Vec<u8>) -> Vec<u8> {
    let checksum = crc32(&body);
    body.extend(checksum.to_le_bytes());
    body
}

fn put(body: &mut [u8], at: usize, value: f32) {
    body[at..at + 4].copy_from_slice(&value.to_le_bytes());
}

fn forged_float(at: usize, value: f32) -> Result<ManeuverTable, TableError> {
    forged(&five_five(), |body| put(body, at, value))
}

/// The header and segments that a table was made of.
fn taken_apart(table: &ManeuverTable) -> (TableHeader, Option<ArcProfile>, Vec<Segment<f32>>) {
    let ManeuverTable { vehicle, kind, limits, heading_rad, start, end, arcs, .. } = *table;
    let header = TableHeader { vehicle, kind, link: LinkPolicy::Finish, limits, heading_rad, start, end };
    (header, arcs, table.segments().collect())
}

/// Where segments lead, in `f64` and by the arc formula of the costate's two numbers, independently of the table.
fn led_to(header: &TableHeader, arcs: Option<ArcProfile>, segments: &[Segment<f32>]) -> State<f64> {
    let limits: Limits<f64> = header.limits.cast();
    let mut time = 0.0;
    segments.iter().fold(header.start.cast(), |state, segment| {
        let tau = f64::from(segment.duration);
        let turn = match (segment.inputs.rate.sign::<f64>(), arcs) {
            (Some(sign), _) => bang(sign * limits.rate_max_radps, tau),
            (None, Some(profile)) => {
                let (width, since) = (f64::from(profile.width_s), time - f64::from(profile.peak_s));
                let norm2 = width * width + since * since;
                singular(Arc { rate: width / norm2, drift: -since / norm2 }, tau)
            }
            (None, None) => unreachable!("a singular segment comes with a profile"),
        };
        time += tau;
        advance(state, limits.thrust(segment.inputs.thrust), limits.gravity_mps2, tau, &turn)
    })
}

// proptest 1.12 panics now and then in a range of floats whose bound next to zero is no multiple of the other one's last bit, so
// those bounds are binary fractions.
prop_compose! {
    fn limits()(min in 0.125f32..9.0, max in 10.5f32..30.0, rate in 1.0f32..12.0) -> Limits<f32> {
        Limits { thrust_min_mps2: min, thrust_max_mps2: max, rate_max_radps: rate, gravity_mps2: 9.81 }
    }
}

fn segment() -> impl Strategy<Value = Segment<f32>> {
    let rate = prop_oneof![Just(RateMode::Plus), Just(RateMode::Minus), Just(RateMode::Singular)];
    (rate, any::<bool>(), 1.0 / 8192.0..0.15f32).prop_map(|(rate, max, duration)| {
        // An arc is never at the lowest thrust.
        let max = max || rate == RateMode::Singular;
        let thrust = if max { ThrustLevel::Max } else { ThrustLevel::Min };
        Segment { inputs: Inputs { rate, thrust }, duration }
    })
}

prop_compose! {
    /// A table as a solver could write it: the segments are drawn, the end follows.
    fn valid_table()(
        limits in limits(),
        vehicle in any::<u32>(),
        kind in prop_oneof![Just(Kind::Extremal), Just(Kind::Retimed), Just(Kind::Learned)],
        heading_rad in -3.0f32..3.0,
        start in prop::array::uniform5(-3.0f32..3.0),
        wider in 1.0078125f32..20.0,
        left in any::<bool>(),
        peak_s in -1.0f32..3.0,
        segments in prop::collection::vec(segment(), 1..=MAX_SEGMENTS),
    ) -> ManeuverTable {
        let start = State::from_array(start);
        let mut header = TableHeader { vehicle, kind, link: LinkPolicy::Finish, limits, heading_rad, start, end: start };
        let arcs = segments.iter().any(|s| s.inputs.rate == RateMode::Singular).then(|| {
            let width_s = wider / limits.rate_max_radps;
            ArcProfile { width_s: if left { -width_s } else { width_s }, peak_s }
        });
        header.end = led_to(&header, arcs, &segments).cast();
        ManeuverTable::new(header, arcs, segments).expect("an honest table is accepted")
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(3000))]

    #[test]
    fn a_valid_table_survives_the_wire(table in valid_table()) {
        let bytes = bytes_of(&table);
        let arcs = if table.arcs.is_some() { 8 } else { 0 };
        prop_assert_eq!(bytes.len(), 76 + arcs + 5 * table.segments().len());
        let back = ManeuverTable::decode(&bytes);
        prop_assert_eq!(back.as_ref(), Ok(&table));
        prop_assert_eq!(&bytes[bytes.len() - 4..], &table.checksum().to_le_bytes()[..]);
        let (header, arcs, segments) = taken_apart(&table);
        prop_assert_eq!(ManeuverTable::new(header, arcs, segments), Ok(table));
    }

    /// A stated end away from where the segments lead is refused, except within the slack of its kind.
    #[test]
    fn a_wrong_end_is_refused(table in valid_table(), component in 0usize..5, off in 0.0234375f32..2.0, down in any::<bool>()) {
        let (mut header, arcs, segments) = taken_apart(&table);
        let mut end = header.end.to_array();
        end[component] += if down { -off } else { off };
        header.end = State::from_array(end);
        header.kind = Kind::Extremal;
        prop_assert_eq!(ManeuverTable::new(header, arcs, segments.clone()), Err(TableError::End));
        // A learned table misses in the model what it hits in the world, but not by more than 3 m, 5 m/s, what 5 m/s² do in its
        // duration, or a radian.
        header.kind = Kind::Learned;
        let (position, velocity) = learned_slack(table.duration_s());
        let slack = [position, velocity, position, velocity, 1.0][component];
        if off < 0.98 * slack {
            prop_assert!(ManeuverTable::new(header, arcs, segments.clone()).is_ok());
        }
        let mut end = header.end.to_array();
        end[component] += if down { -slack } else { slack };
        header.end = State::from_array(end);
        prop_assert_eq!(ManeuverTable::new(header, arcs, segments), Err(TableError::End));
    }

    /// Any mixture of a table's bytes and random ones behind a checksum that holds: no panic, and what is accepted is
    /// finite, bounded, leads where it says and can be replayed.
    #[test]
    fn bytes_behind_a_valid_checksum_give_a_sound_table_or_a_refusal(
        base in valid_table(),
        patches in prop::collection::vec((any::<prop::sample::Index>(), prop_oneof![
            prop::collection::vec(any::<u8>(), 1..5),
            prop::num::f32::ANY.prop_map(|f| f.to_le_bytes().to_vec()),
            (-2.0f32..2.0).prop_map(|f| f.to_le_bytes().to_vec()),
        ]), 0..4),
        aligned in any::<bool>(),
    ) {
        let decoded = forged(&base, |body| {
            for (place, patch) in &patches {
                let floats = (at::SEGMENTS.min(body.len()) - at::THRUST_MIN) / 4;
                let from = if aligned { at::THRUST_MIN + 4 * place.index(floats) } else { place.index(body.len()) };
                for (slot, byte) in body.iter_mut().skip(from.max(4)).zip(patch) {
                    *slot = *byte;
                }
            }
        });
        if let Ok(table) = decoded {
            sound(&table)?;
        }
    }

    #[test]
    fn random_bytes_behind_schema_and_checksum_give_a_sound_table_or_a_refusal(
        content in prop::collection::vec(any::<u8>(), 0..220),
    ) {
        let body = [&SCHEMA_HASH.to_le_bytes()[..], &content].concat();
        if let Ok(table) = ManeuverTable::decode(&sealed(body)) {
            sound(&table)?;
        }
    }

    #[test]
    fn random_bytes_never_panic(bytes in prop::collection::vec(any::<u8>(), 0..300)) {
        prop_assert!(ManeuverTable::decode(&bytes).is_err());
    }

    /// Whether an arc keeps to the rate limit is decided by its profile alone, however narrow: the peak of eq. (15) is
    /// 1/|width| where the arc holds its peak time.
    #[test]
    fn an_arc_through_its_peak_is_judged_by_its_width(
        exponent in -30.0f64..1.0, left in any::<bool>(), part in 0.0078125f32..0.99, before in 0.0f32..0.5, duration in 0.0625f32..0.3,
    ) {
        let width_s = (10f64.powf(exponent) as f32) * if left { -1.0 } else { 1.0 };
        let limits: Limits<f32> = Limits::TABLE_I.cast();
        let too_fast = 1.0 / width_s.abs() > limits.rate_max_radps * 1.001;
        let mut segments = vec![Segment { inputs: arc(), duration }];
        if before > 0.0 {
            segments.insert(0, Segment { inputs: plus(), duration: before });
        }
        let arcs = Some(ArcProfile { width_s, peak_s: before + part * duration });
        let mut header = TableHeader {
            vehicle: ANY_VEHICLE, kind: Kind::Learned, link: LinkPolicy::Finish,
            limits, heading_rad: 0.0,
            start: State::origin(), end: State::origin(),
        };
        // A turn too sharp for arithmetic leads nowhere.
        header.end = Some(led_to(&header, arcs, &segments)).filter(State::is_finite).unwrap_or_default().cast();
        let made = ManeuverTable::new(header, arcs, segments);
        if too_fast {
            prop_assert_eq!(made, Err(TableError::ArcRate));
        } else if 1.0 / width_s.abs() < limits.rate_max_radps * 0.999 {
            prop_assert!(made.is_ok(), "{:?}", made);
        }
    }
}

fn arc() -> Inputs {
    Inputs { rate: RateMode::Singular, thrust: ThrustLevel::Max }
}

fn plus() -> Inputs {
    Inputs { rate: RateMode::Plus, thrust: ThrustLevel::Max }
}

/// How far a learned table may miss its end in the model, m and m/s, for a duration in s.
fn learned_slack(duration_s: f32) -> (f32, f32) {
    let t = duration_s.min(2.0);
    ((2.5 * t * t).max(3.0), (5.0 * t).max(5.0))
}

/// What every accepted table must be, by another path than the check's own.
fn sound(table: &ManeuverTable) -> Result<(), TestCaseError> {
    prop_assert_eq!(table.check(), Ok(()));
    prop_assert_eq!(&ManeuverTable::decode(&bytes_of(table)), &Ok(table.clone()));
    let (header, arcs, segments) = taken_apart(table);
    let Limits { thrust_min_mps2: low, thrust_max_mps2: high, rate_max_radps, gravity_mps2 } = table.limits;
    prop_assert!(0.0 < low && low < gravity_mps2 && gravity_mps2 < high && high.is_finite());
    prop_assert!(0.0 < rate_max_radps && rate_max_radps.is_finite() && table.heading_rad.is_finite());
    prop_assert!(table.start.is_finite() && table.end.is_finite());
    prop_assert!((1..=MAX_SEGMENTS).contains(&segments.len()));
    prop_assert!(segments.iter().all(|s| s.duration > 0.0));
    prop_assert!(segments.iter().map(|s| s.duration).sum::<f32>() <= 10.0);
    let singular = segments.iter().any(|s| s.inputs.rate == RateMode::Singular);
    prop_assert_eq!(singular, arcs.is_some());
    let miss = led_to(&header, arcs, &segments).minus(header.end.cast());
    let (position, velocity) = learned_slack(table.duration_s());
    let (position, velocity) = (f64::from(position) + 0.2, f64::from(velocity) + 0.2);
    prop_assert!(miss.x.abs() < position && miss.z.abs() < position, "{:?}", miss);
    prop_assert!(
        miss.vx.abs() < velocity && miss.vz.abs() < velocity && miss.theta.abs() < 1.1,
        "{:?}",
        miss
    );

    let mut replay = Replay::new(Plan::new(table), 0);
    for tick in 0..8100 {
        match replay.tick(tick * 1250, &TickPeriod::new()) {
            Step::Over => return Ok(()),
            Step::Fly(command) => {
                prop_assert!(
                    command.rate_radps.is_finite() && command.thrust_mps2.is_finite(),
                    "{:?}",
                    command
                );
                prop_assert!(command.rate_radps.abs() <= 3.0 * rate_max_radps && command.thrust_mps2 >= 0.0);
            }
        }
    }
    prop_assert!(false, "the replay does not end");
    Ok(())
}

#[test]
fn every_reference_case_survives_the_wire() {
    for case in reference_cases() {
        let table = case.table();
        assert_eq!(ManeuverTable::decode(&bytes_of(&table)).as_ref(), Ok(&table), "{}", case.name);
        assert!((f64::from(table.duration_s()) - case.duration_s).abs() < 1e-6, "{}", case.name);
        assert_eq!(table.check_for(worked(), &able(1.0, 20.0, 10.0)), Ok(()), "{}", case.name);
    }
}

/// One radio packet: the request that stages (5, 5), framing and the longest request number included.
#[test]
fn five_five_fits_128_bytes_on_the_wire() {
    let bytes = heapless::Vec::from_slice(&bytes_of(&five_five())).expect("it fits");
    assert_eq!(bytes.len(), 114);
    let request = Request::Stage { total: 114, offset: 0, bytes };
    let uplink = Uplink { version: PROTOCOL_VERSION, number: u16::MAX, request, heard_ms: 0 };
    let frame = encode(&uplink).expect("it fits a frame");
    assert!(frame.as_bytes().len() <= 128, "{} bytes", frame.as_bytes().len());
}

/// Pinned: a vehicle in the field and a table on a disk must not come to mean something else. Whoever changes these
/// bytes on purpose changes the text of the schema too, so that its hash differs.
#[test]
fn the_bytes_of_five_five_are_these() {
    let hex: String = bytes_of(&five_five()).iter().map(|b| format!("{b:02x}")).collect();
    assert_eq!(hex, FIVE_FIVE);
}

const FIVE_FIVE: &str = "f870d22fc6423e2c00000000803f0000a04100002041c3f51c41\
    0000000000000000000000000000000000000000000000000000a040000000000000a0400000000000000000\
    0176bd44bcdaa66c3f060478ff503d06666f393f05f59d983e066351a63d0470b41e3e00bc00d03d8f2b9451";

/// Every reason at least once, for the input that it names. A new reason without a case here fails to compile.
#[test]
fn every_refusal_has_its_reason() {
    let table = five_five();
    let segments_of = |n: usize| {
        let (header, ..) = taken_apart(&table);
        ManeuverTable::new(header, None, vec![Segment { inputs: plus(), duration: 0.01 }; n])
    };
    let nan = f32::NAN;
    let cases: Vec<(&str, Result<ManeuverTable, TableError>, TableError)> = vec![
        ("nothing", ManeuverTable::decode(&[]), TableError::Length),
        ("seven bytes", ManeuverTable::decode(&[0; 7]), TableError::Length),
        ("too many bytes", ManeuverTable::decode(&[0; MAX_TABLE_BYTES + 1]), TableError::Length),
        ("noise", ManeuverTable::decode(&[0x55; 113]), TableError::Checksum),
        ("another schema", forged(&table, |b| b[0] ^= 1), TableError::Schema),
        ("an unknown kind", forged(&table, |b| b[at::KIND] = 3), TableError::Malformed),
        ("an unknown link policy", forged(&table, |b| b[at::LINK] = 2), TableError::Malformed),
        ("an unknown rate mode", forged(&table, |b| b[at::SEGMENTS] = 3), TableError::Malformed),
        ("an unknown thrust level", forged(&table, |b| b[at::SEGMENTS] = 8), TableError::Malformed),
        ("bytes too many", forged(&table, |b| b.push(0)), TableError::Malformed),
        ("bytes too few", forged(&table, |b| b.truncate(b.len() - 1)), TableError::Malformed),
        ("a segment count beyond the bytes", forged(&table, |b| b[at::COUNT] = 7), TableError::Malformed),
        ("a huge segment count", forged(&table, |b| b[at::COUNT] = 0x7f), TableError::Malformed),
        ("NaN thrust", forged_float(at::THRUST_MIN, nan), TableError::Limits(LimitsError::NotFinite)),
        ("infinite rate", forged_float(at::RATE, f32::INFINITY), TableError::Limits(LimitsError::NotFinite)),
        ("no gravity", forged_float(at::GRAVITY, 0.0), TableError::Limits(LimitsError::Gravity)),
        ("negative gravity", forged_float(at::GRAVITY, -9.81), TableError::Limits(LimitsError::Gravity)),
        ("a rate beyond all vehicles", forged_float(at::RATE, 1.001e4), TableError::NotFinite),
        ("a thrust beyond all vehicles", forged_float(at::THRUST_MAX, 1.001e4), TableError::NotFinite),
        ("zero rate", forged_float(at::RATE, 0.0), TableError::Limits(LimitsError::Rate)),
        ("negative rate", forged_float(at::RATE, -10.0), TableError::Limits(LimitsError::Rate)),
        (
            "zero thrust",
            forged_float(at::THRUST_MIN, 0.0),
            TableError::Limits(LimitsError::ThrustNotPositive),
        ),
        ("thrusts swapped", forged_float(at::THRUST_MAX, 0.5), TableError::Limits(LimitsError::ThrustOrder)),
        (
            "cannot sink",
            forged(&table, |b| put(b, at::THRUST_MIN, 9.81)),
            TableError::Limits(LimitsError::CannotSink),
        ),
        ("cannot lift", forged_float(at::THRUST_MAX, 9.81), TableError::Limits(LimitsError::CannotLift)),
        ("NaN heading", forged_float(at::HEADING, nan), TableError::NotFinite),
        ("a heading of many turns", forged_float(at::HEADING, 100.0), TableError::NotFinite),
        ("NaN start", forged_float(at::START + 8, nan), TableError::NotFinite),
        ("infinite start", forged_float(at::START + 4, f32::NEG_INFINITY), TableError::NotFinite),
        ("NaN end", forged_float(at::END + 16, nan), TableError::NotFinite),
        ("an end out of this world", forged_float(at::END, 1e4), TableError::NotFinite),
        ("NaN duration", forged_float(at::SEGMENTS + 1, nan), TableError::NotFinite),
        ("infinite duration", forged_float(at::SEGMENTS + 1, f32::INFINITY), TableError::NotFinite),
        ("NaN arc width", forged_float(at::WIDTH, nan), TableError::NotFinite),
        ("infinite arc width", forged_float(at::WIDTH, f32::INFINITY), TableError::NotFinite),
        ("NaN arc peak", forged_float(at::PEAK, nan), TableError::NotFinite),
        ("zero duration", forged_float(at::SEGMENTS + 1, 0.0), TableError::Duration),
        ("negative zero duration", forged_float(at::SEGMENTS + 1, -0.0), TableError::Duration),
        ("negative duration", forged_float(at::SEGMENTS + 1, -0.1), TableError::Duration),
        ("eleven seconds", forged_float(at::SEGMENTS + 1, 11.0), TableError::TooLong),
        ("no segments", segments_of(0), TableError::Empty),
        ("one segment too many", segments_of(MAX_SEGMENTS + 1), TableError::TooManySegments),
        ("arcs without a profile", without_profile(&table), TableError::Arcs),
        ("a profile without arcs", with_profile(&horizontal()), TableError::Arcs),
        ("an arc without width", forged_float(at::WIDTH, 0.0), TableError::Arcs),
        ("an arc at minimum thrust", arc_at_minimum_thrust(&table), TableError::Arcs),
        ("an arc too fast", fast_arc(&table), TableError::ArcRate),
        ("an arc too fast for numbers", endless_arc(&table), TableError::ArcRate),
        ("another end", forged_float(at::END, 5.1), TableError::End),
        ("another duration", longer_first(&table), TableError::End),
        (
            "another vehicle's",
            made_for(&table, 8).check_for(7, &able(1.0, 30.0, 15.0)).map(|()| table.clone()),
            TableError::OtherVehicle,
        ),
        (
            "another vehicle's, given to one",
            made_for(&table, 8).assigned_to(7, &able(1.0, 30.0, 15.0)),
            TableError::OtherVehicle,
        ),
        ("nobody's", fits(&made_for(&table, ANY_VEHICLE), able(1.0, 30.0, 15.0)), TableError::AnyVehicle),
        (
            "nobody's, for a vehicle that does not know what it is",
            made_for(&table, ANY_VEHICLE)
                .check_for(ANY_VEHICLE, &able(1.0, 30.0, 15.0))
                .map(|()| table.clone()),
            TableError::AnyVehicle,
        ),
        (
            "nobody's, given to nobody",
            made_for(&table, ANY_VEHICLE).assigned_to(ANY_VEHICLE, &able(1.0, 30.0, 15.0)),
            TableError::AnyVehicle,
        ),
        (
            "nobody's, given to one that is too weak",
            made_for(&table, ANY_VEHICLE).assigned_to(7, &able(1.0, 19.9, 15.0)),
            TableError::BeyondVehicle,
        ),
        ("too little thrust", fits(&table, able(1.01, 30.0, 15.0)), TableError::BeyondVehicle),
        ("too much thrust", fits(&table, able(1.0, 19.9, 15.0)), TableError::BeyondVehicle),
        (
            "the Moon's gravity",
            fits(&table, PlanLimits { gravity_mps2: 1.62, ..able(1.0, 30.0, 15.0) }),
            TableError::Gravity,
        ),
        ("too much rate", fits(&table, able(1.0, 30.0, 9.9)), TableError::BeyondVehicle),
        ("a vehicle of NaN thrust", fits(&table, able(1.0, nan, 15.0)), TableError::BeyondVehicle),
        ("a vehicle of NaN idle", fits(&table, able(nan, 30.0, 15.0)), TableError::BeyondVehicle),
    ];
    let mut seen = [false; 17];
    for (what, got, want) in cases {
        assert_eq!(got, Err(want), "{what}");
        let index = match want {
            TableError::Length => 0,
            TableError::Checksum => 1,
            TableError::Schema => 2,
            TableError::Malformed => 3,
            TableError::OtherVehicle => 4,
            TableError::Limits(_) => 5,
            TableError::NotFinite => 6,
            TableError::Empty => 7,
            TableError::TooManySegments => 8,
            TableError::Duration => 9,
            TableError::TooLong => 10,
            TableError::Arcs => 11,
            TableError::ArcRate => 12,
            TableError::End => 13,
            TableError::BeyondVehicle => 14,
            TableError::Gravity => 15,
            TableError::AnyVehicle => 16,
        };
        seen[index] = true;
        assert!(!want.to_string().is_empty());
    }
    assert_eq!(seen, [true; 17]);
    // And the bounds themselves are inside.
    assert_eq!(table.check_for(worked(), &able(1.0, 20.0, 10.0)), Ok(()));
    // What was for any vehicle is this one's now, and the same in all else; what is its own stays as it is.
    let own = made_for(&table, 7);
    assert_eq!(own.check_for(7, &able(1.0, 20.0, 10.0)), Ok(()));
    for table in [made_for(&table, ANY_VEHICLE), own.clone()] {
        assert_eq!(table.assigned_to(7, &able(1.0, 20.0, 10.0)).as_ref(), Ok(&own));
    }
}

/// Hash of the vehicle for which the reference maneuvers are packed.
fn worked() -> u32 {
    VehicleConfig::REFERENCE.hash()
}

/// The same table with another vehicle in its bytes.
fn made_for(table: &ManeuverTable, vehicle: u32) -> ManeuverTable {
    forged(table, |b| b[at::VEHICLE].copy_from_slice(&vehicle.to_le_bytes())).expect("it decodes")
}

fn able(thrust_min_mps2: f32, thrust_max_mps2: f32, rate_max_radps: f32) -> PlanLimits {
    PlanLimits { thrust_min_mps2, thrust_max_mps2, rate_max_radps, gravity_mps2: 9.81 }
}

/// The table, if such a vehicle may fly it.
fn fits(table: &ManeuverTable, able: PlanLimits) -> Result<ManeuverTable, TableError> {
    table.check_for(worked(), &able).map(|()| table.clone())
}

fn without_profile(table: &ManeuverTable) -> Result<ManeuverTable, TableError> {
    forged(table, |body| {
        body[at::OPTION] = 0;
        body.drain(at::WIDTH..at::COUNT);
    })
}

fn with_profile(table: &ManeuverTable) -> Result<ManeuverTable, TableError> {
    let (header, _, segments) = taken_apart(table);
    ManeuverTable::new(header, Some(ArcProfile { width_s: 1.0, peak_s: 0.5 }), segments)
}

fn arc_at_minimum_thrust(table: &ManeuverTable) -> Result<ManeuverTable, TableError> {
    let (header, arcs, mut segments) = taken_apart(table);
    for s in segments.iter_mut().filter(|s| s.inputs.rate == RateMode::Singular) {
        s.inputs.thrust = ThrustLevel::Min;
    }
    ManeuverTable::new(header, arcs, segments)
}

/// The same arcs under a rate limit that they exceed by a per mille.
/// Its peak lies within an arc, and is 1/width.
fn endless_arc(table: &ManeuverTable) -> Result<ManeuverTable, TableError> {
    let (header, _, segments) = taken_apart(table);
    let before = segments.iter().position(|s| s.inputs.rate == RateMode::Singular).expect("it has arcs");
    let peak_s = segments[..before].iter().map(|s| s.duration).sum::<f32>() + 0.5 * segments[before].duration;
    ManeuverTable::new(header, Some(ArcProfile { width_s: f32::from_bits(1), peak_s }), segments)
}

fn fast_arc(table: &ManeuverTable) -> Result<ManeuverTable, TableError> {
    let (mut header, arcs, segments) = taken_apart(table);
    let profile = arcs.expect("it has arcs");
    let mut time = 0.0;
    let mut fastest = 0.0f32;
    for s in &segments {
        if s.inputs.rate == RateMode::Singular {
            fastest = fastest.max(profile.entered_at(time).peak_rate(s.duration));
        }
        time += s.duration;
    }
    header.limits.rate_max_radps = fastest / 1.001;
    ManeuverTable::new(header, arcs, segments)
}

/// The arcs of one maneuver stand on the clock: a longer first segment shifts them.
fn longer_first(table: &ManeuverTable) -> Result<ManeuverTable, TableError> {
    let (header, arcs, mut segments) = taken_apart(table);
    segments[0].duration += 0.01;
    ManeuverTable::new(header, arcs, segments)
}

#[test]
fn a_table_cut_short_anywhere_is_refused() {
    for table in [five_five(), horizontal()] {
        let bytes = bytes_of(&table);
        for length in 0..bytes.len() {
            let want = if length < 8 { TableError::Length } else { TableError::Checksum };
            assert_eq!(ManeuverTable::decode(&bytes[..length]), Err(want), "{length} bytes");
            // And where the sender computed a checksum over the short body: content, not luck, refuses it.
            let sealed = sealed(bytes[..length.min(bytes.len() - 5)].to_vec());
            let refused = ManeuverTable::decode(&sealed).expect_err("a short body");
            assert!(matches!(refused, TableError::Length | TableError::Malformed), "{length}: {refused}");
        }
    }
}

#[test]
fn every_single_bit_flip_is_refused() {
    for case in reference_cases() {
        let bytes = bytes_of(&case.table());
        for bit in 0..8 * bytes.len() {
            let mut flipped = bytes.clone();
            flipped[bit / 8] ^= 1 << (bit % 8);
            assert_eq!(ManeuverTable::decode(&flipped), Err(TableError::Checksum), "{} bit {bit}", case.name);
        }
    }
}

#[test]
fn a_buffer_too_small_is_refused() {
    let table = five_five();
    for length in 0..114 {
        assert_eq!(table.encode(&mut vec![0; length]), Err(TableError::Length));
    }
    assert_eq!(table.encode(&mut [0; 114]), Ok(114));
}

/// Costates at the edges of what an arc profile can be made of.
#[test]
fn profiles_from_degenerate_costates() {
    let limits = Limits::TABLE_I;
    let profile = |c: [f64; 4]| ArcProfile::from_costate(&Costate::from_array(c), &limits);
    let straight = profile([0.0, 1.0, 0.0, -1.0]).expect("a costate that does not move");
    assert!(straight.entered_at(0.3).rate_at(0.5).abs() < 1e-5);
    let almost = profile([1e-12, 1.0, 0.0, -1.0]).expect("a costate that hardly moves");
    assert!(almost.entered_at(0.3).rate_at(0.5).abs() < 1e-5);
    // (p2, p4) on a line through the origin: the turn would be a jump.
    assert_eq!(profile([1.0, 1.0, 1.0, 1.0]), Err(TableError::Arcs));
    assert_eq!(profile([f64::NAN, 1.0, 0.0, 1.0]), Err(TableError::NotFinite));
    // The two numbers of eq. (15) in the dimensions of Table I: 1/10 s a unit.
    let known = profile([3.0, 2.0, 4.0, 1.0]).expect("an ordinary costate");
    assert!((known.width_s - 0.1 * 5.0 / 25.0).abs() < 1e-8, "{known:?}");
    assert!((known.peak_s - 0.1 * 10.0 / 25.0).abs() < 1e-8, "{known:?}");
}

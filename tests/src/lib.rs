//! What the end-to-end tests share: the reference maneuvers and how they become tables.

pub mod fuzz;

use mintime_shared::minimum_principle::Costate;
use mintime_shared::model::{Inputs, Limits, RateMode, Segment, State, ThrustLevel};
use mintime_shared::table::{ArcProfile, Kind, LinkPolicy, ManeuverTable, TableHeader};
use mintime_shared::vehicle::VehicleConfig;
use serde::Deserialize;

/// One maneuver whose duration, structure and costate were computed and checked by an independent solver.
#[derive(Clone, Debug)]
pub struct ReferenceCase {
    /// Its name.
    pub name: String,
    /// Start, SI.
    pub from: State<f64>,
    /// End as reached, SI; θ includes the turns.
    pub to: State<f64>,
    /// Limits.
    pub limits: Limits<f64>,
    /// Duration, s.
    pub duration_s: f64,
    /// Full turns.
    pub turns: i32,
    /// Dimensionless costate.
    pub costate: Costate<f64>,
    /// Durations in s.
    pub segments: Vec<Segment<f64>>,
}

#[derive(Deserialize)]
struct File {
    cases: Vec<Raw>,
}

#[derive(Deserialize)]
struct Raw {
    name: String,
    x0: [f64; 5],
    #[serde(rename = "xT")]
    x_t: [f64; 5],
    limits: RawLimits,
    #[serde(rename = "T_seconds")]
    t_seconds: f64,
    turns: i32,
    c: [f64; 4],
    segments: Vec<RawSegment>,
}

#[derive(Deserialize)]
struct RawLimits {
    f_min: f64,
    f_max: f64,
    omega_max: f64,
    g: f64,
}

#[derive(Deserialize)]
struct RawSegment {
    #[serde(rename = "u_R")]
    u_r: String,
    #[serde(rename = "u_T")]
    u_t: String,
    duration_s: f64,
}

/// All reference maneuvers.
///
/// # Panics
/// Where the data file is damaged.
pub fn reference_cases() -> Vec<ReferenceCase> {
    let file: File =
        serde_json::from_str(include_str!("../data/reference_cases.json")).expect("reference data parses");
    file.cases.into_iter().map(ReferenceCase::from).collect()
}

impl From<Raw> for ReferenceCase {
    fn from(raw: Raw) -> Self {
        let mut to = State::from_array(raw.x_t);
        to.theta += f64::from(raw.turns) * core::f64::consts::TAU;
        let segments = raw.segments.iter().map(|s| {
            let rate = match s.u_r.as_str() {
                "+" => RateMode::Plus,
                "-" => RateMode::Minus,
                _ => RateMode::Singular,
            };
            let thrust = if s.u_t == "max" { ThrustLevel::Max } else { ThrustLevel::Min };
            Segment { inputs: Inputs { rate, thrust }, duration: s.duration_s }
        });
        Self {
            name: raw.name,
            from: State::from_array(raw.x0),
            to,
            limits: Limits {
                thrust_min_mps2: raw.limits.f_min,
                thrust_max_mps2: raw.limits.f_max,
                rate_max_radps: raw.limits.omega_max,
                gravity_mps2: raw.limits.g,
            },
            duration_s: raw.t_seconds,
            turns: raw.turns,
            costate: Costate::from_array(raw.c),
            segments: segments.collect(),
        }
    }
}

impl ReferenceCase {
    /// The table that this maneuver packs into, for the worked vehicle, [`VehicleConfig::REFERENCE`].
    ///
    /// # Panics
    /// Where it does not: a defect of the table code.
    pub fn table(&self) -> ManeuverTable {
        let singular = self.segments.iter().any(|s| s.inputs.rate == RateMode::Singular);
        let arcs =
            singular.then(|| ArcProfile::from_costate(&self.costate, &self.limits).expect("arc profile"));
        let header = TableHeader {
            vehicle: VehicleConfig::REFERENCE.hash(),
            kind: Kind::Extremal,
            link: LinkPolicy::Finish,
            limits: self.limits.cast(),
            heading_rad: 0.0,
            start: self.from.cast(),
            end: self.to.cast(),
        };
        let segments =
            self.segments.iter().map(|s| Segment { inputs: s.inputs, duration: s.duration as f32 });
        ManeuverTable::new(header, arcs, segments).unwrap_or_else(|e| panic!("{}: {e}", self.name))
    }
}

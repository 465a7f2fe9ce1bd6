//! Plan, flight, cameras and the vehicle's record over time, each as columns of one length.

use mintime_shared::messages::RecordedTick;
use serde::Serialize;

use super::columns::Column;
use crate::flight_log::{FlightSample, PlannedSample};
use crate::mission::{PlanFrame, rate_in_plane};

/// Longer plans are thinned to this many samples.
const MOST_PLANNED: usize = 3000;

/// The plan over time.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct PlanSeries {
    /// Time, s.
    pub t: Column,
    /// Position in the plane, m.
    pub x: Column,
    /// Height, m.
    pub z: Column,
    /// Its velocity, m/s.
    pub vx: Column,
    /// Its velocity, m/s.
    pub vz: Column,
    /// Pitch, rad.
    pub theta: Column,
    /// Pitch rate, rad/s.
    pub rate: Column,
    /// Thrust per mass, m/s².
    pub thrust: Column,
    /// Switching function of the pitch rate, dimensionless; absent for a table from a file.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub phi_r: Option<Column>,
    /// Switching function of the thrust, dimensionless; absent for a table from a file.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub phi_t: Option<Column>,
}

impl PlanSeries {
    pub(super) fn new(planned: &[PlannedSample]) -> Self {
        let step = planned.len().div_ceil(MOST_PLANNED).max(1);
        let last = planned.len().saturating_sub(1);
        let kept: Vec<&PlannedSample> = planned
            .iter()
            .enumerate()
            .filter(|(i, _)| i.is_multiple_of(step) || *i == last)
            .map(|(_, p)| p)
            .collect();
        let column = |value: fn(&PlannedSample) -> f64| kept.iter().map(|p| value(p)).collect::<Column>();
        Self {
            t: column(|p| p.t_s),
            x: column(|p| p.state.x),
            z: column(|p| p.state.z),
            vx: column(|p| p.state.vx),
            vz: column(|p| p.state.vz),
            theta: column(|p| p.state.theta),
            rate: column(|p| p.rate_radps),
            thrust: column(|p| p.thrust_mps2),
            phi_r: column(|p| p.phi_r).if_any(),
            phi_t: column(|p| p.phi_t).if_any(),
        }
    }
}

/// The flight over time: the truth of a simulated vehicle, what the cameras saw of a real one. What is not known is absent.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct FlightSeries {
    /// Time, s.
    pub t: Column,
    /// Position in the plane, m.
    pub x: Column,
    /// Height, m.
    pub z: Column,
    /// Its velocity, m/s.
    pub vx: Column,
    /// Its velocity, m/s.
    pub vz: Column,
    /// Pitch, rad.
    pub theta: Column,
    /// Pitch rate, rad/s.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub rate: Option<Column>,
    /// Thrust per mass, m/s².
    #[serde(skip_serializing_if = "Option::is_none")]
    pub thrust: Option<Column>,
    /// The gyro's pitch rate, rad/s.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub gyro: Option<Column>,
    /// Commanded pitch rate, rad/s.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub rate_command: Option<Column>,
    /// Commanded thrust per mass, m/s².
    #[serde(skip_serializing_if = "Option::is_none")]
    pub thrust_command: Option<Column>,
    /// Throttles of motors 1 to 4, 0..1.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub motors: Option<[Column; 4]>,
    /// Battery, V.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub battery: Option<Column>,
}

/// A clock and a frame for what was logged.
pub(super) struct Coordinates {
    /// `None` where the maneuver never began: then the flight's own clock and the world.
    pub(super) frame: Option<PlanFrame>,
    pub(super) heading_rad: f64,
}

impl Coordinates {
    pub(super) fn since_s(&self, time_ns: u64) -> f64 {
        self.frame.map_or(time_ns as f64 * 1e-9, |f| f.since_s(time_ns))
    }

    fn in_plane(&self, rates: [f32; 3]) -> f64 {
        rate_in_plane(rates.map(f64::from), self.heading_rad)
    }
}

impl FlightSeries {
    pub(super) fn new(samples: &[FlightSample], coordinates: &Coordinates) -> Self {
        let column = |value: &dyn Fn(&FlightSample) -> f64| samples.iter().map(value).collect::<Column>();
        let state = |s: &FlightSample| {
            let planar = s.truth.planar;
            coordinates.frame.map_or(planar, |f| f.state(planar))
        };
        let [m1, m2, m3, m4] = [0, 1, 2, 3].map(|i: usize| column(&|s| f64::from(s.throttle[i])).if_any());
        Self {
            t: column(&|s| coordinates.since_s(s.time_ns)),
            x: column(&|s| state(s).x),
            z: column(&|s| state(s).z),
            vx: column(&|s| state(s).vx),
            vz: column(&|s| state(s).vz),
            theta: column(&|s| state(s).theta),
            rate: column(&|s| rate_in_plane(s.truth.body_rates_radps, coordinates.heading_rad)).if_any(),
            thrust: column(&|s| s.truth.thrust_mps2).if_any(),
            gyro: column(&|s| s.gyro_radps.map_or(f64::NAN, |g| coordinates.in_plane(g))).if_any(),
            rate_command: column(&|s| coordinates.in_plane(s.setpoint_radps)).if_any(),
            thrust_command: column(&|s| f64::from(s.setpoint_thrust_mps2)).if_any(),
            motors: m1.zip(m2).zip(m3.zip(m4)).map(|((a, b), (c, d))| [a, b, c, d]),
            battery: column(&|s| f64::from(s.battery_v)).if_any(),
        }
    }
}

/// What motion capture measured over time.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct CameraSeries {
    /// When the cameras looked, s.
    pub t: Column,
    /// Position in the plane, m.
    pub x: Column,
    /// Height, m.
    pub z: Column,
}

impl CameraSeries {
    /// `None` where motion capture measured nothing.
    pub(super) fn new(samples: &[FlightSample], coordinates: &Coordinates) -> Option<Self> {
        let poses: Vec<_> = samples.iter().filter_map(|s| s.mocap.map(|m| (s, m))).collect();
        let (sin, cos) = coordinates.heading_rad.sin_cos();
        let seen = |(s, m): &(&FlightSample, crate::flight_log::MocapSample)| {
            let [x, y, z] = m.position_m;
            let mut planar = s.truth.planar;
            (planar.x, planar.z) = (x * cos + y * sin, z);
            coordinates.frame.map_or(planar, |f| f.state(planar))
        };
        (!poses.is_empty()).then(|| Self {
            t: poses.iter().map(|(_, m)| coordinates.since_s(m.captured_ns)).collect(),
            x: poses.iter().map(|p| seen(p).x).collect(),
            z: poses.iter().map(|p| seen(p).z).collect(),
        })
    }
}

/// The vehicle's record of the maneuver: what its gyro and it itself said, tick by tick.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct RecordSeries {
    /// Time by the vehicle's clock, s.
    pub t: Column,
    /// The gyro's pitch rate, bias removed, rad/s.
    pub gyro: Column,
    /// Commanded pitch rate, rad/s.
    pub rate_command: Column,
    /// Commanded thrust per mass, m/s².
    pub thrust_command: Column,
    /// Throttles of motors 1 to 4, 0..1.
    pub motors: [Column; 4],
}

impl RecordSeries {
    /// `None` where nothing was recorded.
    pub(super) fn new(record: &[RecordedTick], coordinates: &Coordinates) -> Option<Self> {
        let column = |value: &dyn Fn(&RecordedTick) -> f64| record.iter().map(value).collect::<Column>();
        let mut t_us = 0_u64;
        let times = record.iter().map(|tick| {
            t_us += u64::from(tick.interval_us);
            t_us as f64 * 1e-6
        });
        (!record.is_empty()).then(|| Self {
            t: times.collect(),
            gyro: column(&|r| r.gyro_radps.map_or(f64::NAN, |g| coordinates.in_plane(g))),
            rate_command: column(&|r| f64::from(r.rate_radps)),
            thrust_command: column(&|r| f64::from(r.thrust_mps2)),
            motors: [0, 1, 2, 3].map(|i: usize| column(&|r| f64::from(r.throttle[i]))),
        })
    }
}

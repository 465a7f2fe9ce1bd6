//! What the cameras saw of a real flight, kept for its log and its picture.

use mintime::flight::{Phase, Sight, Trace, Witness};
use mintime::flight_log::{FlightSample, MocapSample, Truth};
use mintime_shared::model::State;
use nalgebra::Vector3;

/// A witness that keeps what it sees, and hands everything on.
pub(crate) struct Seen<'a, W> {
    witness: &'a mut W,
    heading_rad: f64,
    trace: Trace,
    /// Angle in the maneuver's plane, unwrapped, rad.
    theta_rad: f64,
}

impl<'a, W: Witness> Seen<'a, W> {
    /// For the plane of a heading, rad.
    pub(crate) fn new(witness: &'a mut W, heading_rad: f64) -> Self {
        Self { witness, heading_rad, trace: Trace::default(), theta_rad: 0.0 }
    }

    pub(crate) fn into_trace(self) -> Trace {
        self.trace
    }

    /// The motion as the cameras saw it; velocity is that since the pose before.
    fn motion(&mut self, sight: &Sight, captured_ns: u64) -> Truth {
        let (position_m, attitude) = (sight.pose.position_m, sight.pose.attitude);
        let before = self.trace.samples.last().and_then(|s| s.mocap.map(|m| (m, s.truth)));
        let velocity_mps = match before {
            Some((m, _)) if captured_ns > m.captured_ns => {
                (position_m - Vector3::from(m.position_m)) / ((captured_ns - m.captured_ns) as f64 * 1e-9)
            }
            Some((_, last)) => Vector3::from(last.velocity_mps),
            None => Vector3::zeros(),
        };
        let (sin, cos) = self.heading_rad.sin_cos();
        let along = |v: Vector3<f64>| v.x * cos + v.y * sin;
        let up = attitude * Vector3::z();
        let turn = core::f64::consts::TAU;
        let wrapped = along(up).atan2(up.z);
        self.theta_rad = wrapped + turn * ((self.theta_rad - wrapped) / turn).round();
        let q = attitude.quaternion();
        Truth {
            position_m: position_m.into(),
            velocity_mps: velocity_mps.into(),
            attitude_wxyz: [q.w, q.i, q.j, q.k],
            // Cameras measure neither rates nor thrust.
            body_rates_radps: [f64::NAN; 3],
            thrust_mps2: f64::NAN,
            planar: State {
                x: along(position_m),
                vx: along(velocity_mps),
                z: position_m.z,
                vz: velocity_mps.z,
                theta: self.theta_rad,
            },
        }
    }
}

impl<W: Witness> Witness for Seen<'_, W> {
    fn phase(&mut self, phase: Phase, now_s: f64) {
        self.witness.phase(phase, now_s);
    }

    fn event(&mut self, now_s: f64, text: &str) {
        self.witness.event(now_s, text);
    }

    fn saw(&mut self, sight: &Sight) {
        let ns = |s: f64| (s * 1e9).round().max(0.0) as u64;
        if let Some(since_s) = sight.maneuver_since_s {
            self.trace.start_ns.get_or_insert(ns(since_s));
        }
        let captured_ns = ns(sight.pose.captured_s);
        let truth = self.motion(sight, captured_ns);
        let said = sight.setpoint.unwrap_or_default();
        self.trace.samples.push(FlightSample {
            time_ns: ns(sight.pose.arrived_s),
            phase: sight.phase.name().to_owned(),
            truth,
            gyro_radps: None,
            setpoint_radps: said.rates_radps,
            setpoint_thrust_mps2: said.thrust_mps2,
            throttle: [f32::NAN; 4],
            battery_v: sight.battery_v.unwrap_or(f32::NAN),
            mocap: Some(MocapSample {
                captured_ns,
                position_m: truth.position_m,
                attitude_wxyz: truth.attitude_wxyz,
            }),
        });
        self.witness.saw(sight);
    }
}

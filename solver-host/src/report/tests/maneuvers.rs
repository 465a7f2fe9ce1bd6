//! Extremals of known structure and a crude flight of each, for pictures that look like the real ones.

use mintime_shared::minimum_principle::Costate;
use mintime_shared::model::{Inputs, Limits, RateMode, Segment, State, ThrustLevel};
use mintime_shared::motion::{Arc, Turn, advance, bang, singular};

use crate::report::{FlownSample, PlannedSample, ReportData};

/// A maneuver by its costate and segments: rate input, thrust input, duration in s.
pub(super) struct Maneuver {
    pub(super) name: &'static str,
    costate: [f64; 4],
    segments: &'static [(char, &'static str, f64)],
}

pub(super) const DIAGONAL: Maneuver = Maneuver {
    name: "x = 5 m, z = 5 m",
    costate: [-0.04660435507520619, -0.4211362940053405, -0.08064698938656481, -0.7511139662932578],
    segments: &[
        ('+', "max", 0.05102488250941447),
        ('s', "max", 0.7243560304103915),
        ('-', "max", 0.2980801267138544),
        ('s', "max", 0.08120991882647005),
        ('+', "max", 0.15498518926135643),
        ('+', "min", 0.10156390262528792),
    ],
};

pub(super) const FLIP: Maneuver = Maneuver {
    name: "z = 6 m",
    costate: [0.006300605258620619, 0.06179326644440672, -0.09798904103956045, -0.9588129119751744],
    segments: &[
        ('-', "max", 0.006435965228075562),
        ('s', "max", 0.758937817826012),
        ('+', "max", 0.15689008150074207),
        ('+', "min", 0.056465290666639856),
        ('+', "max", 0.25800754198726433),
        ('+', "min", 0.1634446279029915),
    ],
};

pub(super) const DASH: Maneuver = Maneuver {
    name: "x = 15 m",
    costate: [-0.05914861664950098, -0.5606822698341185, -5.46407325078455e-17, -0.09238749570641541],
    segments: &[
        ('+', "max", 0.13802761307347627),
        ('s', "max", 1.6197871505448738),
        ('+', "max", 0.1380276130734764),
    ],
};

pub(super) const SHORT: Maneuver = Maneuver {
    name: "x = 10 cm",
    costate: [-0.8681536618338519, -1.1751524031376686, -4.141221970252121e-17, 0.18966939912601494],
    segments: &[
        ('+', "min", 0.018478350124890897),
        ('+', "max", 0.049202779080699574),
        ('-', "max", 0.022575355289018693),
        ('-', "min", 0.09021154783314357),
        ('-', "max", 0.022575355289018682),
        ('+', "max", 0.049202779080699574),
        ('+', "min", 0.0184783501248909),
    ],
};

impl Maneuver {
    pub(super) fn segments(&self) -> Vec<Segment<f64>> {
        let input = |&(rate, thrust, duration): &(char, &str, f64)| {
            let rate = match rate {
                '+' => RateMode::Plus,
                '-' => RateMode::Minus,
                _ => RateMode::Singular,
            };
            let thrust = if thrust == "max" { ThrustLevel::Max } else { ThrustLevel::Min };
            Segment { inputs: Inputs { rate, thrust }, duration }
        };
        self.segments.iter().map(input).collect()
    }

    /// The plan by exact motion, sampled about every millisecond and on both sides of every switch.
    pub(super) fn planned(&self) -> Vec<PlannedSample> {
        let limits = Limits::TABLE_I;
        let (scale, range) = (limits.scale(), limits.dimensionless());
        let costate = Costate::from_array(self.costate);
        let mut start = State::origin();
        let mut start_s = 0.0;
        let mut samples = Vec::new();
        for segment in self.segments() {
            let u_t = range.thrust(segment.inputs.thrust);
            let arc: Option<Arc<f64>> =
                (segment.inputs.rate == RateMode::Singular).then(|| costate.arc(start_s / scale.time_s));
            let sign = segment.inputs.rate.sign::<f64>();
            let turn = |tau: f64| -> Turn<f64> {
                match (arc, sign) {
                    (Some(arc), _) => singular(arc, tau),
                    (None, sign) => bang(sign.unwrap_or(0.0), tau),
                }
            };
            let steps = (segment.duration / 1e-3).ceil() as u32;
            for i in 0..=steps {
                let t = segment.duration * f64::from(i) / f64::from(steps);
                let tau = t / scale.time_s;
                let state = advance(start, u_t, 1.0, tau, &turn(tau));
                let now = (start_s + t) / scale.time_s;
                let h = costate.rate_free_hamiltonian(now, &state, u_t);
                samples.push(PlannedSample {
                    t_s: start_s + t,
                    state: scale.to_si(state),
                    rate_radps: limits.rate_max_radps
                        * arc.map_or(sign.unwrap_or(0.0), |arc| arc.rate_at(tau)),
                    thrust_mps2: limits.thrust(segment.inputs.thrust),
                    phi_r: sign.map_or(0.0, |sign| -h / sign),
                    phi_t: costate.phi_t(now, state.theta),
                });
            }
            let tau = segment.duration / scale.time_s;
            start = advance(start, u_t, 1.0, tau, &turn(tau));
            start_s += segment.duration;
        }
        samples
    }

    /// A flight of the plan with lagging rate and thrust: half a second of hover, the maneuver, a catch.
    pub(super) fn flown(&self) -> Vec<FlownSample> {
        let planned = self.planned();
        let end = planned.last().map_or(0.0, |last| last.t_s);
        let goal = planned.last().map_or(State::origin(), |last| last.state);
        let mut state = State { x: 0.004, z: -0.003, ..State::origin() };
        let (mut rate, mut thrust) = (0.0, 9.81);
        let dt = 1e-3;
        (-500..(1000.0 * end + 1000.0) as i32)
            .map(|i| {
                let t_s = f64::from(i) * dt;
                let next = planned.partition_point(|p| p.t_s < t_s);
                let (phase, wanted_rate, wanted_thrust) = if t_s < 0.0 {
                    ("hover", -8.0 * state.theta, 9.81)
                } else if let Some(plan) = planned.get(next) {
                    ("maneuver", plan.rate_radps, plan.thrust_mps2)
                } else {
                    let turns = (goal.theta / core::f64::consts::TAU).round() * core::f64::consts::TAU;
                    let tilt = (0.25 * (goal.x - state.x) - 0.3 * state.vx).clamp(-0.6, 0.6);
                    let lift = 9.81 + 6.0 * (goal.z - state.z) - 4.0 * state.vz;
                    ("catch", 8.0 * (turns + tilt - state.theta), lift.clamp(1.0, 20.0))
                };
                rate += (wanted_rate - rate) * dt / 0.012;
                thrust += (wanted_thrust - thrust) * dt / 0.02;
                state.theta += rate * dt;
                state.vx += thrust * state.theta.sin() * dt;
                state.vz += (thrust * state.theta.cos() - 9.81) * dt;
                state.x += state.vx * dt;
                state.z += state.vz * dt;
                FlownSample { t_s, state, rate_radps: rate, thrust_mps2: thrust, phase: phase.to_owned() }
            })
            .collect()
    }

    pub(super) fn report(&self) -> ReportData {
        let planned = self.planned();
        let duration = planned.last().map_or(0.0, |last| last.t_s);
        ReportData {
            title: format!("Minimum-time maneuver to {}", self.name),
            subtitle: vec![
                "Rest to rest, Table I limits; flown by the hosted vehicle in the nominal plant, seed 1"
                    .to_owned(),
            ],
            planned,
            flown: self.flown(),
            segments: self.segments(),
            limits: Limits::TABLE_I,
            facts: [
                ("Duration T", format!("{duration:.4} s")),
                ("Full turns", "0".to_owned()),
                ("Segments", self.segments.len().to_string()),
                ("Table", "97 bytes".to_owned()),
                ("Peak speed", "9.31 m/s".to_owned()),
                ("Error at the end", "4.8 cm, 12 cm/s, 0.01 rad".to_owned()),
            ]
            .map(|(label, value)| (label.to_owned(), value))
            .to_vec(),
        }
    }
}

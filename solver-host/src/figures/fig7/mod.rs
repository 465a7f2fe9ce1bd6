//! Fig. 7: the maneuver to x = 5 m, z = 5 m as it is flown. The paper shows a measured flight after learning beside the
//! plan; here the flight logic flies a simulated vehicle (rotor lag, drag, noise, a gyro with a wrong scale), before it has
//! learned anything and after.

mod flights;

use super::fig6::singular_arcs;
use super::samples::{Instant, times};
use super::time_chart::{self, Curve, Mark, Panel};
use super::{Content, FigureError, Number};
use crate::drawing::axis::Range;
use crate::drawing::csv::Csv;
use crate::drawing::legend::{self, Key};
use crate::drawing::page;
use crate::drawing::style::{FLOWN, INK, MARGIN, SINGULAR, UNLEARNED, WIDTH};
use crate::drawing::svg::Svg;
use crate::mission::{Flown, PlanarError};
use crate::report::FlownSample;
use flights::Flights;

/// Between samples of the plan, s.
const STEP_S: f64 = 0.001;
/// Shown before the maneuver and after its end, s.
const AROUND_S: (f64, f64) = (0.1, 0.4);

/// What is drawn, in this order: the later over the earlier.
#[derive(Clone, Copy)]
enum Which {
    Unlearned,
    Learned,
    Planned,
}

impl Which {
    /// Its name in the table.
    fn name(self) -> &'static str {
        match self {
            Self::Unlearned => "unlearned",
            Self::Learned => "learned",
            Self::Planned => "planned",
        }
    }

    fn stroke(self) -> String {
        match self {
            Self::Unlearned => format!(r#"stroke="{UNLEARNED}" stroke-width="1.8" stroke-dasharray="2 3""#),
            Self::Learned => format!(r#"stroke="{FLOWN}" stroke-width="2.4""#),
            Self::Planned => format!(r#"stroke="{INK}" stroke-width="1.6" stroke-dasharray="6 3""#),
        }
    }
}

/// The maneuver in one way, over time from its start.
struct Track {
    which: Which,
    samples: Vec<Instant>,
}

impl Track {
    fn of_flight(which: Which, flown: &Flown) -> Self {
        let sample = |s: FlownSample| Instant {
            t_s: s.t_s,
            state: s.state,
            rate_radps: s.rate_radps,
            thrust_mps2: s.thrust_mps2,
        };
        Self { which, samples: FlownSample::of_flight(flown, AROUND_S).into_iter().map(sample).collect() }
    }
}

pub(super) fn draw() -> Result<Content, FigureError> {
    let Flights { plan, unlearned, learned, taught_by } = Flights::fly()?;
    let extremal = &plan.extremal;
    let duration_s = extremal.duration_s();
    let learned_s = f64::from(learned.prepared.table.duration_s());
    let ends = |flown: &Flown| {
        let early = || FigureError::Flight(flown.reason().unwrap_or_else(|| flown.outcome().to_owned()));
        flown.final_error().ok_or_else(early)
    };
    let (error, learned_error) = (ends(&unlearned)?, ends(&learned)?);
    let samples = times(duration_s, STEP_S).into_iter().map(|t| Instant::of(extremal, t)).collect();
    let tracks = [
        Track::of_flight(Which::Unlearned, &unlearned),
        Track::of_flight(Which::Learned, &learned),
        Track { which: Which::Planned, samples },
    ];

    let title = "Fig. 7: the maneuver to x = 5 m, z = 5 m, flown".to_owned();
    let lines = [
        format!(
            "Simulated, not measured: the flight logic on the nominal vehicle, gyro feedback only. At its end the first flight is {:.2} m off;",
            off_m(&error)
        ),
        format!(
            "after {taught_by} flights that taught, {:.1} cm. Learned T = {learned_s:.3} s, planned T = {duration_s:.3} s (in the paper about 1.7 s and 1.4 s). Then the vehicle is caught.",
            100.0 * off_m(&learned_error)
        ),
    ];
    let mut svg = Svg::default();
    let y = page::heading(&mut svg, WIDTH, &title, &lines);
    let keys = [
        Key::line(&Which::Planned.stroke(), "planned"),
        Key::line(&Which::Unlearned.stroke(), "first flight, nothing learned"),
        Key::line(&Which::Learned.stroke(), "learned"),
        Key::area(SINGULAR, "singular arc of the plan"),
        Key::upright(&Mark::planned(0.0).stroke, "start, T planned"),
        Key::upright(&Mark::learned(0.0).stroke, "T learned"),
    ];
    let y = legend::rows(&mut svg, &keys, (MARGIN, WIDTH - MARGIN), y + 34.0);
    let time = Range { low: -AROUND_S.0, high: learned_s.max(duration_s) + AROUND_S.1 };
    let marks = [Mark::planned(0.0), Mark::planned(duration_s), Mark::learned(learned_s)];
    let arcs = singular_arcs(extremal);
    let bottom = time_chart::draw(&mut svg, &panels(&tracks), time, &arcs, &marks, y + 26.0);
    let mut numbers = vec![
        Number::new("planned T =", duration_s, "s"),
        Number::new("learned T =", learned_s, "s"),
        Number::new("flights that taught:", taught_by as f64, ""),
    ];
    for (which, error) in [("first", &error), ("learned", &learned_error)] {
        numbers.extend([
            Number::new(format!("{which} flight, position error at T"), off_m(error), "m"),
            Number::new(
                format!("{which} flight, velocity error at T"),
                error.vx_mps.hypot(error.vz_mps),
                "m/s",
            ),
            Number::new(format!("{which} flight, pitch error at T"), error.theta_rad, "rad"),
        ]);
    }
    Ok(Content {
        svg: page::document(WIDTH, bottom + MARGIN, &title, &lines.join(" "), svg),
        title,
        tables: vec![("", csv(&tracks))],
        numbers,
    })
}

/// Distance from the planned end, m.
fn off_m(error: &PlanarError) -> f64 {
    error.x_m.hypot(error.z_m)
}

fn panels(tracks: &[Track]) -> [Panel; 6] {
    let panel = |label, value: fn(&Instant) -> f64| {
        let curve = |track: &Track| Curve {
            points: track.samples.iter().map(|i| (i.t_s, value(i))).collect(),
            stroke: format!(r#"class="{}" {}"#, track.which.name(), track.which.stroke()),
            name: None,
        };
        Panel::of(label, tracks.iter().map(curve).collect())
    };
    [
        panel("x (m)", |i| i.state.x),
        panel("z (m)", |i| i.state.z),
        panel("v_{x} (m/s)", |i| i.state.vx),
        panel("v_{z} (m/s)", |i| i.state.vz),
        panel("pitch θ (rad)", |i| i.state.theta),
        panel("pitch rate (rad/s)", |i| i.rate_radps),
    ]
}

fn csv(tracks: &[Track]) -> String {
    let mut csv = Csv::new("which,t_s,x_m,vx_mps,z_m,vz_mps,theta_rad,rate_radps,thrust_mps2");
    for Track { which, samples } in tracks.iter().rev() {
        for Instant { t_s, state: s, rate_radps, thrust_mps2 } in samples {
            csv.row([&which.name(), t_s, &s.x, &s.vx, &s.z, &s.vz, &s.theta, rate_radps, thrust_mps2]);
        }
    }
    csv.finish()
}

//! Fig. 7: the maneuver to x = 5 m, z = 5 m as it is flown. The paper shows a measured flight after learning; here the
//! flight logic flies a simulated vehicle (rotor lag, drag, noise, a gyro with a wrong scale) without having learned.

use mintime_shared::model::{Limits, State};

use super::fig6::singular_arcs;
use super::samples::{Instant, times};
use super::time_chart::{self, Curve, Panel};
use super::{Content, FigureError, Number};
use crate::drawing::axis::{Range, Steps};
use crate::drawing::csv::Csv;
use crate::drawing::legend::{self, Key};
use crate::drawing::page;
use crate::drawing::style::{FLOWN, INK, MARGIN, SINGULAR, WIDTH};
use crate::drawing::svg::Svg;
use crate::mission::{Mission, PlantChoice, Source, Unseen, VehicleChoice, fly_mission, prepare};
use crate::report::FlownSample;
use crate::solver::Turns;
use mintime_simulator::VehicleParameters;

/// Between samples of the plan, s.
const STEP_S: f64 = 0.001;
/// Shown before the maneuver and after its end, s.
const AROUND_S: (f64, f64) = (0.1, 0.4);
/// Seed of the simulated noise.
const SEED: u64 = 1;

pub(super) fn draw() -> Result<Content, FigureError> {
    let to = State::at_rest(5.0, 5.0);
    let source = Source::Solve { to, limits: Limits::TABLE_I, turns: Turns::Any, heading_rad: 0.0 };
    let plant = PlantChoice { name: "nominal".to_owned(), parameters: VehicleParameters::nominal() };
    let prepared = prepare(&source, None)?;
    let mission = Mission { source, plant, seed: SEED, room: None };
    let flown = fly_mission(&mission, prepared, &VehicleChoice::Hosted, &mut Unseen)?;
    let (Some(solution), Some(error)) = (&flown.prepared.solution, flown.final_error()) else {
        return Err(FigureError::Flight(flown.reason().unwrap_or_else(|| flown.outcome().to_owned())));
    };
    let extremal = &solution.extremal;
    let duration_s = extremal.duration_s();
    let plan: Vec<Instant> =
        times(duration_s, STEP_S).into_iter().map(|t| Instant::of(extremal, t)).collect();
    let flight = FlownSample::of_flight(&flown, AROUND_S);

    let title = "Fig. 7: the maneuver to x = 5 m, z = 5 m, flown".to_owned();
    let miss_m = error.x_m.hypot(error.z_m);
    let lines = [
        format!(
            "Simulated, not measured: the flight logic on the nominal vehicle, gyro feedback only, nothing learned. At T it is {miss_m:.2} m off."
        ),
        "The paper shows a vehicle after learning, which needed about 1.7 s. The vertical lines are t = 0 and T; after T the vehicle is caught."
            .to_owned(),
    ];
    let mut svg = Svg::default();
    let y = page::heading(&mut svg, WIDTH, &title, &lines);
    let keys = [
        Key::line(&format!(r#"stroke="{INK}" stroke-width="1.6" stroke-dasharray="6 3""#), "planned"),
        Key::line(&format!(r#"stroke="{FLOWN}" stroke-width="2.4""#), "flown (simulated)"),
        Key::area(SINGULAR, "singular arc of the plan"),
    ];
    let y = legend::rows(&mut svg, &keys, (MARGIN, WIDTH - MARGIN), y + 34.0);
    let time = Range { low: -AROUND_S.0, high: duration_s + AROUND_S.1 };
    let marks = [0.0, duration_s];
    let arcs = singular_arcs(extremal);
    let bottom = time_chart::draw(&mut svg, &panels(&plan, &flight), time, &arcs, &marks, y + 26.0);
    Ok(Content {
        svg: page::document(WIDTH, bottom + MARGIN, &title, &lines.join(" "), svg),
        title,
        tables: vec![("", csv(&plan, &flight))],
        numbers: vec![
            Number::new("T =", duration_s, "s"),
            Number::new("position error at T", miss_m, "m"),
            Number::new("velocity error at T", error.vx_mps.hypot(error.vz_mps), "m/s"),
            Number::new("pitch error at T", error.theta_rad, "rad"),
        ],
    })
}

fn panels(plan: &[Instant], flight: &[FlownSample]) -> [Panel; 6] {
    let panel = |label, steps, value: &dyn Fn(&State<f64>, f64) -> f64| {
        let flown = Curve {
            points: flight.iter().map(|f| (f.t_s, value(&f.state, f.rate_radps))).collect(),
            stroke: format!(r#"class="flown" stroke="{FLOWN}" stroke-width="2.4""#),
            name: None,
        };
        let planned = Curve {
            points: plan.iter().map(|i| (i.t_s, value(&i.state, i.rate_radps))).collect(),
            stroke: format!(r#"class="planned" stroke="{INK}" stroke-width="1.6" stroke-dasharray="6 3""#),
            name: None,
        };
        Panel::of(label, steps, vec![flown, planned])
    };
    [
        panel("x (m)", Steps::Decimal, &|s, _| s.x),
        panel("z (m)", Steps::Decimal, &|s, _| s.z),
        panel("v_{x} (m/s)", Steps::Decimal, &|s, _| s.vx),
        panel("v_{z} (m/s)", Steps::Decimal, &|s, _| s.vz),
        panel("pitch θ (°)", Steps::Degrees, &|s, _| s.theta.to_degrees()),
        panel("pitch rate (rad/s)", Steps::Decimal, &|_, rate| rate),
    ]
}

fn csv(plan: &[Instant], flight: &[FlownSample]) -> String {
    let mut csv = Csv::new("which,t_s,x_m,vx_mps,z_m,vz_mps,theta_rad,rate_radps,thrust_mps2");
    let mut row = |which: &str, t_s: f64, s: &State<f64>, rate: f64, thrust: f64| {
        csv.row([&which, &t_s, &s.x, &s.vx, &s.z, &s.vz, &s.theta, &rate, &thrust]);
    };
    for i in plan {
        row("planned", i.t_s, &i.state, i.rate_radps, i.thrust_mps2);
    }
    for f in flight {
        row("flown", f.t_s, &f.state, f.rate_radps, f.thrust_mps2);
    }
    csv.finish()
}

//! Fig. 6: inputs, states and switching functions of the maneuver to x = 5 m, z = 5 m.

use mintime_shared::model::RateMode;

use super::samples::{Instant, times};
use super::time_chart::{self, Curve, Panel};
use super::{Content, FigureError, Number};
use crate::drawing::axis::Range;
use crate::drawing::csv::Csv;
use crate::drawing::legend::{self, Key};
use crate::drawing::page;
use crate::drawing::style::{INK, LIMIT, MARGIN, SINGULAR, SWITCHING, WIDTH};
use crate::drawing::svg::Svg;
use crate::solver::{Extremal, Request, solve};

/// Between samples, s.
const STEP_S: f64 = 0.001;

/// A sample of the maneuver with its switching functions, dimensionless.
struct Sample {
    instant: Instant,
    phi_r: f64,
    phi_t: f64,
}

/// At even times, and on both sides of every switch.
fn samples(extremal: &Extremal) -> Vec<Sample> {
    let mut all = times(extremal.duration_s(), STEP_S);
    let mut t_s = 0.0;
    for segment in extremal.segments.iter().take(extremal.segments.len().saturating_sub(1)) {
        t_s += segment.duration;
        all.extend([t_s - 1e-9, t_s + 1e-9]);
    }
    all.sort_by(f64::total_cmp);
    let sample = |t_s: f64| Sample {
        instant: Instant::of(extremal, t_s),
        phi_r: extremal.phi_r_at(t_s),
        phi_t: extremal.phi_t_at(t_s),
    };
    all.into_iter().map(sample).collect()
}

/// Parts of the time axis with a singular arc, s.
pub(super) fn singular_arcs(extremal: &Extremal) -> Vec<(f64, f64)> {
    let mut t_s = 0.0;
    let spans = extremal.segments.iter().map(|segment| {
        let from = t_s;
        t_s += segment.duration;
        (segment.inputs.rate == RateMode::Singular).then_some((from, t_s))
    });
    spans.flatten().collect()
}

pub(super) fn draw() -> Result<Content, FigureError> {
    let extremal = solve(&Request::rest_to_rest(5.0, 5.0))?.extremal;
    let samples = samples(&extremal);
    let title = "Fig. 6: the maneuver to x = 5 m, z = 5 m".to_owned();
    let lines = [format!(
        "T = {:.4} s. The pitch rate is +max where Φ_{{R}} < 0, −max where Φ_{{R}} > 0, on an arc where Φ_{{R}} = 0, eq. (16); the thrust is full where Φ_{{T}} < 0, eq. (20).",
        extremal.duration_s()
    )];
    let mut svg = Svg::default();
    let y = page::heading(&mut svg, WIDTH, &title, &lines);
    let keys = [
        Key::line(&format!(r#"stroke="{INK}" stroke-width="1.8""#), "inputs, x, v_{x}, θ"),
        Key::line(&format!(r#"stroke="{INK}" stroke-width="1.8" stroke-dasharray="2 3""#), "z, v_{z}"),
        Key::line(
            &format!(r#"stroke="{SWITCHING}" stroke-width="1.8" stroke-dasharray="6 3""#),
            "Φ_{R}; Φ_{T}: switching functions, beside the inputs scaled",
        ),
        Key::line(&time_chart::zero(), "their zero"),
        Key::line(&format!(r#"stroke="{LIMIT}" stroke-width="1.5" stroke-dasharray="7 5""#), "limit"),
        Key::area(SINGULAR, "singular arc"),
    ];
    let y = legend::rows(&mut svg, &keys, (MARGIN, WIDTH - MARGIN), y + 34.0);
    let time = Range { low: 0.0, high: extremal.duration_s() };
    let arcs = singular_arcs(&extremal);
    let bottom = time_chart::draw(&mut svg, &panels(&extremal, &samples), time, &arcs, &[], y + 26.0);
    let mut t_s = 0.0;
    let mut numbers = vec![Number::new("T =", extremal.duration_s(), "s")];
    for segment in &extremal.segments {
        t_s += segment.duration;
        numbers.push(Number::new("a segment ends at t =", t_s, "s"));
    }
    Ok(Content {
        svg: page::document(WIDTH, bottom + MARGIN, &title, &lines[0], svg),
        title,
        tables: vec![("", csv(&samples))],
        numbers,
    })
}

fn panels(extremal: &Extremal, samples: &[Sample]) -> [Panel; 6] {
    let curve = |value: &dyn Fn(&Sample) -> f64, name: Option<&'static str>| Curve {
        points: samples.iter().map(|s| (s.instant.t_s, value(s))).collect(),
        stroke: format!(r#"class="input-or-state" stroke="{INK}" stroke-width="1.8""#),
        name,
    };
    let switching = |value: &dyn Fn(&Sample) -> f64, name: Option<&'static str>| Curve {
        stroke: format!(
            r#"class="switching" stroke="{SWITCHING}" stroke-width="1.8" stroke-dasharray="6 3""#
        ),
        ..curve(value, name)
    };
    let largest = |value: fn(&Sample) -> f64| samples.iter().map(|s| value(s).abs()).fold(1e-9, f64::max);
    let limits = extremal.limits;
    let (low, high, rate) = (limits.thrust_min_mps2, limits.thrust_max_mps2, limits.rate_max_radps);
    let phi_r_scale = 0.8 * rate / largest(|s| s.phi_r);
    let phi_t_scale = 0.45 * (high - low) / largest(|s| s.phi_t);
    let middle = 0.5 * (low + high);
    [
        Panel::of(
            "pitch rate (rad/s)",
            vec![
                switching(&|s| s.phi_r * phi_r_scale, Some("Φ_{R}")),
                curve(&|s| s.instant.rate_radps, None),
            ],
        )
        .limited(&[-rate, rate])
        .with_zero(0.0),
        Panel::of(
            "position (m)",
            vec![
                curve(&|s| s.instant.state.x, Some("x")),
                Curve {
                    stroke: format!(
                        r#"class="input-or-state" stroke="{INK}" stroke-width="1.8" stroke-dasharray="2 3""#
                    ),
                    ..curve(&|s| s.instant.state.z, Some("z"))
                },
            ],
        ),
        Panel::of(
            "thrust (m/s²)",
            vec![
                switching(&|s| middle + s.phi_t * phi_t_scale, Some("Φ_{T}")),
                curve(&|s| s.instant.thrust_mps2, None),
            ],
        )
        .limited(&[low, high])
        .with_zero(middle),
        Panel::of(
            "velocity (m/s)",
            vec![
                curve(&|s| s.instant.state.vx, Some("v_{x}")),
                Curve {
                    stroke: format!(
                        r#"class="input-or-state" stroke="{INK}" stroke-width="1.8" stroke-dasharray="2 3""#
                    ),
                    ..curve(&|s| s.instant.state.vz, Some("v_{z}"))
                },
            ],
        ),
        Panel::of("pitch θ (rad)", vec![curve(&|s| s.instant.state.theta, None)]),
        Panel::of(
            "Φ (dimensionless)",
            vec![
                switching(&|s| s.phi_r, Some("Φ_{R}")),
                Curve {
                    stroke: format!(
                        r#"class="switching" stroke="{SWITCHING}" stroke-width="1.8" stroke-dasharray="2 3""#
                    ),
                    ..curve(&|s| s.phi_t, Some("Φ_{T}"))
                },
            ],
        )
        .with_zero(0.0),
    ]
}

fn csv(samples: &[Sample]) -> String {
    let mut csv = Csv::new("t_s,x_m,vx_mps,z_m,vz_mps,theta_rad,rate_radps,thrust_mps2,phi_r,phi_t");
    for Sample { instant: i, phi_r, phi_t } in samples {
        let s = i.state;
        csv.row([&i.t_s, &s.x, &s.vx, &s.z, &s.vz, &s.theta, &i.rate_radps, &i.thrust_mps2, phi_r, phi_t]);
    }
    csv.finish()
}

//! What `mintime benchmark` says: a page for a person, JSON, CSV.

use std::fmt::Write as _;
use std::path::Path;

use mintime::benchmark::{Gains, Rules, Score, ScoreMap};
use mintime_shared::model::State;
use serde_json::{Value, json};

/// The page for a person.
pub(super) fn text(score: &Score, output: Option<&Path>) -> String {
    let optimal = &score.optimal.extremal;
    let state = |s: Option<&(f64, State<f64>)>| {
        s.map_or_else(String::new, |(_, s)| {
            format!(
                "x {:+.4} m, z {:+.4} m, vx {:+.4} m/s, vz {:+.4} m/s, pitch {:+.4} rad",
                s.x, s.z, s.vx, s.vz, s.theta
            )
        })
    };
    let mut lines = vec![
        format!("score      T / T* = {:.4}", score.score),
        format!(
            "flight     T = {:.4} s: left at {:.4} s, arrived at {:.4} s (log's clock), sampled every {:.4} s there",
            score.duration_s, score.leg.departure_s, score.leg.arrival_s, score.resolution_s
        ),
        format!("from       {}", state(score.flown.first())),
        format!("to         {}", state(score.flown.last())),
        format!(
            "fastest    T* = {:.4} s between these states, turns {}, verified against the minimum principle",
            optimal.duration_s(),
            optimal.turns
        ),
    ];
    if let (Some(t), Some(ratio)) = (score.nominal_duration_s, score.nominal_score) {
        lines.push(format!("nominal    T* = {t:.4} s between the states asked for: T / T* = {ratio:.4}"));
    }
    lines.push(format!(
        "plane      heading {:+.4} rad, left by {:.4} m at most",
        score.heading_rad, score.out_of_plane_m
    ));
    lines.extend(score.remarks.iter().map(|remark| format!("note       {remark}")));
    lines.extend(output.map(|path| format!("wrote      {}", path.display())));
    lines.join("\n")
}

/// The JSON answer. Field names are part of the interface.
pub(super) fn json(score: &Score, log: Option<&Path>, gains: Option<&Gains>, output: Option<&Path>) -> Value {
    let optimal = &score.optimal;
    let state = |s: Option<&(f64, State<f64>)>| s.map(|(_, state)| *state);
    json!({
        "log": log,
        "gains": gains,
        "score": score.score,
        "duration_s": score.duration_s,
        "departure_s": score.leg.departure_s,
        "arrival_s": score.leg.arrival_s,
        "resolution_s": score.resolution_s,
        "from": state(score.flown.first()),
        "to": state(score.flown.last()),
        "optimal": {
            "duration_s": optimal.extremal.duration_s(),
            "turns": optimal.extremal.turns,
            "limits": optimal.extremal.limits,
            "certificate": optimal.certificate,
        },
        "nominal": { "duration_s": score.nominal_duration_s, "score": score.nominal_score },
        "heading_rad": score.heading_rad,
        "out_of_plane_m": score.out_of_plane_m,
        "remarks": score.remarks.iter().map(ToString::to_string).collect::<Vec<_>>(),
        "output": output,
    })
}

/// The flight, and the fastest maneuver at the same times, at rest where it has ended.
pub(super) fn csv(score: &Score) -> String {
    let mut out = String::from(
        "t_s,x_m,vx_mps,z_m,vz_mps,theta_rad,optimal_x_m,optimal_vx_mps,optimal_z_m,optimal_vz_mps,optimal_theta_rad\n",
    );
    for (t_s, flown) in &score.flown {
        let cells = flown.to_array().into_iter().chain(score.optimal.extremal.state_at(*t_s).to_array());
        let cells: Vec<String> = cells.map(|v| v.to_string()).collect();
        // Writing to a string does not fail.
        let _ = writeln!(out, "{t_s},{}", cells.join(","));
    }
    out
}

/// The line below the title of the picture.
pub(super) fn subtitle(score: &Score) -> String {
    let mut text = format!(
        "T = {:.4} s; fastest between the same two states T* = {:.4} s, verified against the minimum principle",
        score.duration_s,
        score.optimal.extremal.duration_s()
    );
    if !score.remarks.is_empty() {
        let _ = write!(text, "; see the notes");
    }
    text
}

/// A map in a few numbers.
pub(super) struct MapSummary {
    points: usize,
    /// Points without a score.
    pub(super) failed: usize,
    /// Lowest, median and highest score.
    scores: Option<[f64; 3]>,
    wall_time_s: f64,
}

impl MapSummary {
    pub(super) fn new(map: &ScoreMap, wall_time_s: f64) -> Self {
        let mut all: Vec<f64> = map.scores().map(|(_, _, score)| score).collect();
        all.sort_by(f64::total_cmp);
        let scores = match (all.first(), all.get(all.len() / 2), all.last()) {
            (Some(low), Some(middle), Some(high)) => Some([*low, *middle, *high]),
            _ => None,
        };
        Self { points: map.grid.len(), failed: map.failed(), scores, wall_time_s }
    }

    fn range(&self) -> String {
        self.scores.map_or_else(
            || "no scores".to_owned(),
            |[low, middle, high]| format!("T / T* from {low:.3} to {high:.3}, median {middle:.3}"),
        )
    }

    pub(super) fn text(&self, output: Option<&Path>) -> String {
        let mut text = format!(
            "map        {} points, {} without score, {:.2} s\nscore      {}",
            self.points,
            self.failed,
            self.wall_time_s,
            self.range()
        );
        if let Some(path) = output {
            let _ = write!(text, "\nwrote      {}", path.display());
        }
        text
    }

    pub(super) fn json(&self, gains: &Gains, output: Option<&Path>) -> Value {
        json!({
            "gains": gains,
            "points": self.points,
            "failed": self.failed,
            "lowest_score": self.scores.map(|s| s[0]),
            "median_score": self.scores.map(|s| s[1]),
            "highest_score": self.scores.map(|s| s[2]),
            "wall_time_s": self.wall_time_s,
            "output": output,
        })
    }
}

/// The lines below the title of a map.
pub(super) fn map_subtitle(gains: &Gains, rules: &Rules, summary: &MapSummary) -> Vec<String> {
    let (limits, tolerance) = (&rules.limits, &rules.tolerance);
    vec![
        format!(
            "{}; thrust {} to {} m/s², {} rad/s; settled within {} m, {} m/s, {} rad for {} s",
            summary.range(),
            limits.thrust_min_mps2,
            limits.thrust_max_mps2,
            limits.rate_max_radps,
            tolerance.position_m,
            tolerance.velocity_mps,
            tolerance.angle_rad,
            rules.dwell_s
        ),
        format!(
            "gains: horizontal {} rad/s, damping {}; vertical {} rad/s, damping {}; pitch {} 1/s up to {} rad",
            gains.horizontal_radps,
            gains.horizontal_damping,
            gains.vertical_radps,
            gains.vertical_damping,
            gains.pitch_per_s,
            gains.pitch_max_rad
        ),
    ]
}

//! What `mintime learn` prints.

use std::path::Path;

use mintime::learning::{FlightEntry, HISTORY_FILE, History, Learned, StateError, TABLE_FILE};
use serde_json::{Value, json};

/// The JSON answer: the history, and where it is; `None` and why where it could not be kept. Field names are part of the interface.
pub(super) fn value(learned: &Learned, folder: Result<&Path, String>, page: Option<&Path>) -> Value {
    let mut value = json!(learned.history);
    let kept = folder.as_ref().ok();
    value["history"] = json!(kept.map(|folder| folder.join(HISTORY_FILE)));
    value["table"] = json!(kept.map(|folder| folder.join(TABLE_FILE)));
    if let Err(error) = folder {
        value["error"] = json!(error);
    }
    value["page"] = json!(page);
    value
}

/// One line about the newest flight.
pub(super) fn newest(history: &History) -> String {
    let repeats = history.repeats.len();
    match history.repeats.last() {
        Some(entry) => format!("repeat {repeats}: {}", flight(entry)),
        None => {
            let count = history.flights.len();
            history
                .flights
                .last()
                .map_or_else(String::new, |entry| format!("flight {count}: {}", flight(entry)))
        }
    }
}

/// The page for a person. `folder` is `None` where nothing could be kept: then the table is told.
pub(super) fn text(learned: &Learned, folder: Option<&Path>, page: Option<&Path>) -> String {
    let history = &learned.history;
    let mut lines = vec![format!("maneuver   {}, flown by {}", history.maneuver, history.vehicle)];
    lines.extend(history.identified.map(|found| {
        format!(
            "identified thrust {:.4} ± {:.4} of what the vehicle file says, rotor lag {:.1} ms",
            found.thrust_scale,
            found.thrust_scale_std,
            found.rotor_lag_s * 1e3
        )
    }));
    lines.push(format!(
        "duration   planned {:.4} s, learned {:.4} s: {:.3} of the optimum {:.4} s",
        history.planned_duration_s,
        history.learned_duration_s,
        history.learned_duration_s / history.optimum_duration_s,
        history.optimum_duration_s
    ));
    let numbered = |name: &'static str| {
        move |(i, entry): (usize, &FlightEntry)| format!("{name} {:2}  {}", i + 1, flight(entry))
    };
    lines.extend(history.flights.iter().enumerate().map(numbered("flight")));
    lines.extend(history.repeats.iter().enumerate().map(numbered("repeat")));
    lines.push(format!("outcome    {}", learned.stop));
    match folder {
        Some(folder) => lines.push(format!("kept       {}", folder.display())),
        None => {
            let best = history.best.and_then(|best| history.flights.get(best));
            lines.extend(best.map(|entry| format!("table      {} (not on disk)", entry.table)));
        }
    }
    lines.extend(page.map(|page| format!("page       {}", page.display())));
    lines.join("\n")
}

fn flight(entry: &FlightEntry) -> String {
    let seen = |error: &StateError| {
        format!(
            "{:.3} m, {:.3} m/s, {:.4} rad off: {:.2} tolerances",
            error.position_m(),
            error.velocity_mps(),
            error.theta_rad.abs(),
            error.in_tolerances()
        )
    };
    let across = entry.across.map_or_else(String::new, |a| {
        format!(", {:.3} m, {:.3} m/s out of the plane", a.y_m.abs(), a.vy_mps.abs())
    });
    let end = match (&entry.final_error, &entry.reason) {
        (Some(error), _) => format!("{}{across}", seen(error)),
        (None, reason) => format!("{}: {}", entry.outcome, reason.as_deref().unwrap_or("for no reason")),
    };
    format!("{:.4} s, {end}", entry.duration_s)
}

//! A study as CSV.

use super::Study;
use crate::drawing::csv::Csv;

/// One row for each maneuver, parameter and value. Where there is no maneuver, the last column says why.
pub(super) fn csv(study: &Study) -> String {
    let mut csv = Csv::new("x_m,z_m,parameter,value,unit,duration_s,turns,derivative,elasticity,note");
    for m in &study.maneuvers {
        for curve in &m.curves {
            let (name, unit) = (curve.parameter.name(), curve.parameter.unit());
            for point in &curve.points {
                match &point.outcome {
                    Ok(f) => csv.row([
                        &m.x_m,
                        &m.z_m,
                        &name,
                        &point.value,
                        &unit,
                        &f.duration_s,
                        &f.turns,
                        &f.derivative,
                        &f.elasticity,
                        &"",
                    ]),
                    Err(error) => {
                        let note = format!("\"{error}\"");
                        csv.row([&m.x_m, &m.z_m, &name, &point.value, &unit, &"", &"", &"", &"", &note]);
                    }
                }
            }
        }
    }
    csv.finish()
}

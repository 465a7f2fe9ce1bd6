//! Pictures are well-formed, complete, the same every time, and survive any data.

mod maneuvers;

use std::fs;
use std::path::Path;

use maneuvers::{DASH, DIAGONAL, FLIP, SHORT};

use super::*;

/// Writes the pictures for looking at: `MINTIME_REPORT_DIR=/tmp cargo test -p mintime --lib look_at -- --ignored`.
#[test]
#[ignore = "writes pictures for a person to look at"]
fn look_at_the_pictures() {
    let folder = std::env::var("MINTIME_REPORT_DIR").unwrap();
    for (name, maneuver) in [("diagonal", DIAGONAL), ("flip", FLIP), ("dash", DASH), ("short", SHORT)] {
        for ending in ["png", "svg"] {
            write(&maneuver.report(), &Path::new(&folder).join(format!("{name}.{ending}"))).unwrap();
        }
        let plan_only = ReportData { flown: Vec::new(), ..maneuver.report() };
        write(&plan_only, &Path::new(&folder).join(format!("{name}-plan.png"))).unwrap();
    }
}

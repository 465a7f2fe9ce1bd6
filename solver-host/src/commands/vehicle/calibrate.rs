//! The gyro's bias and scale, guided.

use std::io::BufRead as _;

use clap::{Args, Subcommand, ValueEnum};
use mintime_shared::messages::{FlightState, Request};
use serde_json::json;

use super::{Bench, Said};

/// A bias is learned in half a second of stillness, s.
const BIAS_TIMEOUT_S: f64 = 15.0;

/// Arguments of `calibrate`.
#[derive(Args)]
pub(super) struct Calibrate {
    #[command(subcommand)]
    what: What,
}

/// What to calibrate.
#[derive(Subcommand)]
enum What {
    /// Learn the gyro's bias anew: put the vehicle down and do not touch it
    Bias,
    /// Learn the gyro's scale from whole turns about one axis, guided along a straight edge
    Scale {
        /// Body axis
        axis: Axis,
        /// Whole turns; positive is right-handed: rolling right, nose down, turning left
        #[arg(long, value_name = "N", allow_hyphen_values = true)]
        turns: i8,
    },
}

/// A body axis.
#[derive(Clone, Copy, ValueEnum)]
enum Axis {
    /// Roll
    Forward,
    /// Pitch
    Left,
    /// Yaw
    Up,
}

impl Calibrate {
    pub(super) fn run(&self, bench: &mut Bench) -> Said {
        match self.what {
            What::Bias => bias(bench),
            What::Scale { axis, turns } => scale(bench, axis, turns),
        }
    }
}

fn bias(bench: &mut Bench) -> Said {
    eprintln!("mintime: do not touch the vehicle for two seconds");
    bench.tell("calibrating the bias", Request::Calibrate)?;
    settle(bench, BIAS_TIMEOUT_S)?;
    let [x, y, z] = bench.status()?.rates_radps;
    let text = format!("calibrated; left over are {x:+.4} {y:+.4} {z:+.4} rad/s");
    Ok((json!({ "calibrated": "bias", "rates_radps": [x, y, z] }), text))
}

fn scale(bench: &mut Bench, axis: Axis, turns: i8) -> Said {
    let before = bench.settings()?.gyro_scale;
    eprintln!(
        "mintime: 1. put the vehicle down against a straight edge and let go\n         2. press Enter, then turn it by exactly \
         {turns} whole turns about its {} axis,\n            within 30 s, not faster than a turn a second, back against the edge\n         3. let go: the vehicle \
         notices that it rests",
        match axis {
            Axis::Forward => "forward (roll)",
            Axis::Left => "left (pitch)",
            Axis::Up => "up (yaw)",
        }
    );
    let mut line = String::new();
    std::io::stdin().lock().read_line(&mut line)?;
    if line.is_empty() {
        return Err("nobody pressed Enter: run this from a terminal".into());
    }
    let index = axis as u8;
    // Answered once it is over.
    if let Err(error) = bench.tell("calibrating the scale", Request::CalibrateScale { axis: index, turns }) {
        // The vehicle must not go on waiting for a turn that nobody makes.
        let _ = bench.tell("giving the calibration up", Request::CalibrateScale { axis: index, turns: 0 });
        return Err(error.into());
    }
    let after = bench.settings()?.gyro_scale;
    let text = format!(
        "scale about that axis: {:.5} (before {:.5})",
        after[usize::from(index)],
        before[usize::from(index)]
    );
    Ok((json!({ "calibrated": "scale", "axis": index, "gyro_scale": after, "before": before }), text))
}

/// Waits until the vehicle no longer calibrates.
fn settle(bench: &mut Bench, timeout_s: f64) -> Result<(), Box<dyn std::error::Error>> {
    let since_s = bench.now_s();
    loop {
        bench.listen(0.1)?;
        if bench.status()?.state != FlightState::Calibrating {
            return Ok(());
        }
        if bench.now_s() - since_s > timeout_s {
            return Err(
                "the calibration does not come to an end: keep the vehicle still and try again".into()
            );
        }
    }
}

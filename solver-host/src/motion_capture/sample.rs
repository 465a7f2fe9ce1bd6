//! One line of motion capture, read strictly.

use serde::Deserialize;

use super::error::CaptureError;

/// Longest line that is looked at, bytes.
pub const MAX_LINE_BYTES: usize = 1024;
/// Norm of a quaternion may be off by this.
const NORM_TOLERANCE: f64 = 0.01;
/// Nothing is farther from the origin than this, m.
const FARTHEST_M: f64 = 1_000.0;
/// Times lie within this of zero, s: a wall clock fits, a microsecond count does not.
const LATEST_S: f64 = 1.0e10;
/// Longest name.
const MAX_NAME_BYTES: usize = 64;

/// A pose as the sender stated it, checked.
#[derive(Clone, Debug, PartialEq)]
pub struct CaptureSample {
    /// When the cameras looked, on their own clock, s.
    pub t_s: f64,
    /// Position, m.
    pub position_m: [f64; 3],
    /// Attitude, body to world, normalised.
    pub attitude_wxyz: [f64; 4],
    /// Which body.
    pub name: Option<String>,
}

/// The line as JSON has it.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Line {
    t: f64,
    position_m: [f64; 3],
    attitude_wxyz: [f64; 4],
    #[serde(default)]
    name: Option<String>,
}

impl CaptureSample {
    /// Reads one line.
    ///
    /// # Errors
    /// [`CaptureError`] for anything that is not a pose through and through.
    pub fn parse(line: &[u8]) -> Result<Self, CaptureError> {
        if line.len() > MAX_LINE_BYTES {
            return Err(CaptureError::TooLong { length: line.len() });
        }
        let format = |reason: String| CaptureError::Format { reason };
        let Line { t, position_m, attitude_wxyz, name } =
            serde_json::from_slice(line).map_err(|e| format(e.to_string()))?;
        if name.as_ref().is_some_and(|n| n.len() > MAX_NAME_BYTES) {
            return Err(format(format!("the name is longer than {MAX_NAME_BYTES} bytes")));
        }
        within("t", t, LATEST_S)?;
        for value in position_m {
            within("position_m", value, FARTHEST_M)?;
        }
        for value in attitude_wxyz {
            within("attitude_wxyz", value, 2.0)?;
        }
        let norm = attitude_wxyz.iter().map(|q| q * q).sum::<f64>().sqrt();
        // Finite: its parts are bounded.
        if (norm - 1.0).abs() > NORM_TOLERANCE {
            return Err(CaptureError::NotUnit { norm });
        }
        Ok(Self { t_s: t, position_m, attitude_wxyz: attitude_wxyz.map(|q| q / norm), name })
    }
}

/// False for NaN, too.
fn within(field: &'static str, value: f64, most: f64) -> Result<(), CaptureError> {
    if value.abs() <= most { Ok(()) } else { Err(CaptureError::Range { field, value }) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const GOOD: &str = r#"{"t":1.5,"position_m":[0.1,-2,3],"attitude_wxyz":[1,0,0,0.001],"name":"quad"}"#;

    #[test]
    fn a_good_line_is_read() {
        let sample = CaptureSample::parse(GOOD.as_bytes()).expect("a pose");
        assert_eq!((sample.t_s, sample.position_m), (1.5, [0.1, -2.0, 3.0]));
        assert_eq!(sample.name.as_deref(), Some("quad"));
        let norm: f64 = sample.attitude_wxyz.iter().map(|q| q * q).sum();
        assert!((norm - 1.0).abs() < 1e-12);
    }

    #[test]
    fn what_is_no_pose_is_refused_with_its_reason() {
        for (from, to, part) in [
            ("1.5", "\"now\"", "cannot be read"),
            ("1.5", "1e999", "cannot be read"),
            ("1.5", "NaN", "cannot be read"),
            ("1.5", "1.7e15", "t = 1700000000000000"),
            ("0.1", "1e4", "position_m"),
            ("[1,0", "[0.9,0", "norm 0.9"),
            ("[1,0", "[0,0", "norm 0.0"),
            ("[0.1,-2,3]", "[0.1,-2]", "cannot be read"),
            ("\"t\"", "\"time\"", "cannot be read"),
            ("}", "} {", "cannot be read"),
        ] {
            let error = CaptureSample::parse(GOOD.replacen(from, to, 1).as_bytes()).expect_err(to);
            assert!(error.to_string().contains(part), "{to}: {error}");
        }
        let long = vec![b' '; MAX_LINE_BYTES + 1];
        assert_eq!(CaptureSample::parse(&long), Err(CaptureError::TooLong { length: MAX_LINE_BYTES + 1 }));
    }

    proptest! {
        #[test]
        fn no_bytes_make_it_panic(bytes in proptest::collection::vec(any::<u8>(), 0..1500)) {
            let _ = CaptureSample::parse(&bytes);
        }

        #[test]
        fn a_damaged_line_is_refused_or_still_a_pose(at in 0..GOOD.len(), byte in any::<u8>()) {
            let mut bytes = GOOD.as_bytes().to_vec();
            bytes[at] = byte;
            if let Ok(sample) = CaptureSample::parse(&bytes) {
                let norm: f64 = sample.attitude_wxyz.iter().map(|q| q * q).sum();
                prop_assert!((norm - 1.0).abs() < 1e-9);
                prop_assert!(sample.t_s.is_finite() && sample.position_m.iter().all(|p| p.is_finite()));
            }
        }
    }
}

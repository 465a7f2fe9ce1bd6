//! Numbers on the command line: finite, comma-separated, as many as asked for.

use mintime::mission::Room;
use mintime_shared::model::State;

/// Where to fly: a distance in a vertical plane, and the plane's heading.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Displacement {
    /// Along the heading, m.
    pub(crate) along_m: f64,
    /// Up, m.
    pub(crate) up_m: f64,
    /// From the vehicle's forward axis to the left, rad.
    pub(crate) heading_rad: f64,
}

/// Parses one finite number.
pub(crate) fn finite(text: &str) -> Result<f64, String> {
    let value: f64 =
        text.trim().parse().map_err(|_| format!("`{text}` is not a number: write it like 1.5 or -2e-3"))?;
    if value.is_finite() { Ok(value) } else { Err(format!("`{text}` is not finite: give a finite number")) }
}

/// Parses exactly `N` finite numbers, separated by commas.
pub(crate) fn list<const N: usize>(text: &str) -> Result<[f64; N], String> {
    let values = text.split(',').map(finite).collect::<Result<Vec<_>, _>>()?;
    let count = values.len();
    values.try_into().map_err(|_| format!("{N} numbers separated by commas are needed, {count} were given"))
}

/// Parses one finite number above zero.
pub(crate) fn positive(text: &str) -> Result<f64, String> {
    finite(text).and_then(|v| {
        if v > 0.0 { Ok(v) } else { Err(format!("`{text}` is not above zero: give a positive number")) }
    })
}

/// Parses a state: `X,Z` at rest and level, or `X,VX,Z,VZ,THETA`.
pub(crate) fn state(text: &str) -> Result<State<f64>, String> {
    if text.split(',').count() == 2 {
        let [x, z] = list(text)?;
        return Ok(State::at_rest(x, z));
    }
    list::<5>(text).map(State::from_array).map_err(|e| format!("{e} (or 2: a position to be at rest at)"))
}

/// Parses a displacement: `X,Z` straight ahead, or `X,Y,Z` in the plane that leads there.
pub(crate) fn displacement(text: &str) -> Result<Displacement, String> {
    if text.split(',').count() == 2 {
        let [x, z] = list(text)?;
        return Ok(Displacement { along_m: x, up_m: z, heading_rad: 0.0 });
    }
    let [x, y, z] = list(text).map_err(|e| format!("{e} (or 2: ahead and up)"))?;
    // Straight back is flown backwards, as with two numbers.
    if y == 0.0 {
        return Ok(Displacement { along_m: x, up_m: z, heading_rad: 0.0 });
    }
    Ok(Displacement { along_m: x.hypot(y), up_m: z, heading_rad: y.atan2(x) })
}

/// Parses a room: `XMIN,XMAX,ZMIN,ZMAX`, or with `YMIN,YMAX` in between.
pub(crate) fn room(text: &str) -> Result<Room, String> {
    if text.split(',').count() == 6 {
        let [x0, x1, y0, y1, z0, z1] = list(text)?;
        return Ok(Room { x_m: (x0, x1), y_m: Some((y0, y1)), z_m: (z0, z1) });
    }
    let [x0, x1, z0, z1] = list(text).map_err(|e| format!("{e} (or 6: with YMIN,YMAX in between)"))?;
    Ok(Room { x_m: (x0, x1), y_m: None, z_m: (z0, z1) })
}

/// Parses a number of turns, or `any`.
pub(crate) fn turns(text: &str) -> Result<mintime::solver::Turns, String> {
    if text == "any" {
        return Ok(mintime::solver::Turns::Any);
    }
    let turns = text.parse().map_err(|_| format!("`{text}` is neither a whole number of turns nor `any`"))?;
    Ok(mintime::solver::Turns::Exactly(turns))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lists_have_the_length_asked_for_and_are_finite() {
        assert_eq!(list::<2>("-3,4"), Ok([-3.0, 4.0]));
        assert_eq!(list::<2>(" 1e-3 , -.5"), Ok([1e-3, -0.5]));
        for bad in ["", "1", "1,2,3", "nan,1", "1,inf", "1,-inf", "a,b", "1;2"] {
            assert!(list::<2>(bad).is_err(), "{bad}");
        }
    }

    #[test]
    fn three_numbers_are_a_plane_and_a_distance_in_it() {
        let planar = |along_m, up_m, heading_rad| Ok(Displacement { along_m, up_m, heading_rad });
        assert_eq!(displacement("-3,4"), planar(-3.0, 4.0, 0.0));
        assert_eq!(displacement("-3,0,4"), planar(-3.0, 4.0, 0.0));
        assert_eq!(displacement("3,4,5"), planar(5.0, 5.0, 4f64.atan2(3.0)));
        assert_eq!(displacement("0,-2,1"), planar(2.0, 1.0, -std::f64::consts::FRAC_PI_2));
        for bad in ["", "1", "1,2,3,4", "nan,1,1"] {
            assert!(displacement(bad).is_err(), "{bad}");
        }
        assert!(room("-1,1,-1").is_err() && room("-1,1,-1,1").is_ok_and(|r| r.y_m.is_none()));
        assert!(room("-1,1,-2,2,-3,3").is_ok_and(|r| r.y_m == Some((-2.0, 2.0)) && r.z_m == (-3.0, 3.0)));
    }

    #[test]
    fn turns_are_whole_or_any() {
        use mintime::solver::Turns;
        assert_eq!(turns("any"), Ok(Turns::Any));
        assert_eq!(turns("-1"), Ok(Turns::Exactly(-1)));
        assert!(turns("0.5").is_err());
    }
}

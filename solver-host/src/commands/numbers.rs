//! Numbers on the command line: finite, comma-separated, as many as asked for.

use mintime_shared::model::State;

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
    fn turns_are_whole_or_any() {
        use mintime::solver::Turns;
        assert_eq!(turns("any"), Ok(Turns::Any));
        assert_eq!(turns("-1"), Ok(Turns::Exactly(-1)));
        assert!(turns("0.5").is_err());
    }
}

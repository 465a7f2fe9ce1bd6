//! Columns of a CSV log: which quantity a header names, and what turns its unit into SI.

/// What a column holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Quantity {
    Time,
    X,
    Y,
    Z,
    Vx,
    Vy,
    Vz,
    Theta,
    Qw,
    Qx,
    Qy,
    Qz,
}

/// Number of quantities.
pub(super) const QUANTITIES: usize = 12;

/// Unit as it ends a header, and the factor to SI.
type Units = &'static [(&'static str, f64)];

const TIME: Units = &[("s", 1.0), ("ms", 1e-3), ("us", 1e-6), ("ns", 1e-9)];
const LENGTH: Units = &[("m", 1.0), ("cm", 1e-2), ("mm", 1e-3)];
const SPEED: Units = &[
    ("mps", 1.0),
    ("m_s", 1.0),
    ("cmps", 1e-2),
    ("cm_s", 1e-2),
    ("mmps", 1e-3),
    ("mm_s", 1e-3),
    ("kmph", 1.0 / 3.6),
    ("km_h", 1.0 / 3.6),
];
const ANGLE: Units = &[("rad", 1.0), ("deg", std::f64::consts::PI / 180.0)];
/// Part of a quaternion: no unit.
const NONE: Units = &[];

/// Names without units, and units, by quantity; the first name with the first unit is the one in the documentation.
const COLUMNS: [(Quantity, &[&str], Units); QUANTITIES] = [
    (Quantity::Time, &["t", "time", "timestamp"], TIME),
    (Quantity::X, &["x", "px", "pos_x", "position_x"], LENGTH),
    (Quantity::Y, &["y", "py", "pos_y", "position_y"], LENGTH),
    (Quantity::Z, &["z", "pz", "pos_z", "position_z"], LENGTH),
    (Quantity::Vx, &["vx", "vel_x", "velocity_x"], SPEED),
    (Quantity::Vy, &["vy", "vel_y", "velocity_y"], SPEED),
    (Quantity::Vz, &["vz", "vel_z", "velocity_z"], SPEED),
    (Quantity::Theta, &["theta"], ANGLE),
    (Quantity::Qw, &["qw", "q_w", "quat_w"], NONE),
    (Quantity::Qx, &["qx", "q_x", "quat_x"], NONE),
    (Quantity::Qy, &["qy", "q_y", "quat_y"], NONE),
    (Quantity::Qz, &["qz", "q_z", "quat_z"], NONE),
];

/// What a header says.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Header {
    /// A quantity and its factor to SI.
    Column(Quantity, f64),
    /// A quantity whose unit is missing or not known.
    NoUnit(Quantity),
    /// Something else.
    Extra,
}

/// Reads a header: `x_m`, `X [m]` and `pos_x (m)` are the same.
pub(super) fn header(text: &str) -> Header {
    let name = normalised(text);
    let mut without_unit = Header::Extra;
    for (quantity, bases, units) in COLUMNS {
        for base in bases {
            let Some(rest) = name.strip_prefix(base) else { continue };
            if rest.is_empty() {
                return if units.is_empty() {
                    Header::Column(quantity, 1.0)
                } else {
                    Header::NoUnit(quantity)
                };
            }
            let Some(unit) = rest.strip_prefix('_') else { continue };
            if let Some((_, factor)) = units.iter().find(|(name, _)| *name == unit) {
                return Header::Column(quantity, *factor);
            }
            // `x_ft` is a position in an unknown unit; `x_target_m` is something else.
            if !units.is_empty() && UNKNOWN_UNITS.contains(&unit) {
                without_unit = Header::NoUnit(quantity);
            }
        }
    }
    without_unit
}

/// Units that are understood and not converted: better refused than taken for a column of another meaning.
const UNKNOWN_UNITS: [&str; 12] =
    ["ft", "in", "inch", "km", "min", "h", "fps", "ft_s", "mph", "kn", "kt", "turns"];

/// The header that the documentation names for a quantity.
pub(super) fn expected(quantity: Quantity) -> String {
    let (_, bases, units) = COLUMNS[quantity as usize];
    match units.first() {
        Some((unit, _)) => format!("{}_{unit}", bases[0]),
        None => bases[0].to_owned(),
    }
}

/// The units that a quantity's header may end in.
pub(super) fn units(quantity: Quantity) -> String {
    let (_, _, units) = COLUMNS[quantity as usize];
    units.iter().map(|(unit, _)| format!("_{unit}")).collect::<Vec<_>>().join(", ")
}

/// Lower case, every run of other characters one underscore.
fn normalised(text: &str) -> String {
    let mut name = String::new();
    for c in text.trim().chars().flat_map(char::to_lowercase) {
        match c {
            'µ' | 'μ' => name.push('u'),
            'θ' => name.push_str("theta"),
            c if c.is_alphanumeric() => name.push(c),
            _ if name.is_empty() || name.ends_with('_') => {}
            _ => name.push('_'),
        }
    }
    name.trim_end_matches('_').to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_documented_name_is_found_under_its_quantity() {
        for (i, (quantity, bases, units)) in COLUMNS.into_iter().enumerate() {
            assert_eq!(quantity as usize, i);
            for base in bases {
                for (unit, factor) in units {
                    assert_eq!(header(&format!("{base}_{unit}")), Header::Column(quantity, *factor));
                }
            }
        }
    }

    #[test]
    fn spelling_is_forgiven_and_units_are_not_guessed() {
        assert_eq!(header(" X [mm] "), Header::Column(Quantity::X, 1e-3));
        assert_eq!(header("vx (m/s)"), Header::Column(Quantity::Vx, 1.0));
        assert_eq!(header("Time [µs]"), Header::Column(Quantity::Time, 1e-6));
        assert_eq!(header("θ_deg"), Header::Column(Quantity::Theta, 1f64.to_radians()));
        assert_eq!(header("qw"), Header::Column(Quantity::Qw, 1.0));
        assert_eq!(header("x"), Header::NoUnit(Quantity::X));
        assert_eq!(header("z_ft"), Header::NoUnit(Quantity::Z));
        for extra in ["thrust_mps2", "x_target_m", "phi_r", "", "battery", "xy_m"] {
            assert_eq!(header(extra), Header::Extra, "{extra}");
        }
    }
}

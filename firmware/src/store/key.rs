//! What the store keeps.

/// Tables that are kept.
pub const TABLES: u8 = 8;

/// What a value is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Key {
    /// The vehicle's parameters.
    Vehicle,
    /// How the board behaves: receiver, limits.
    Settings,
    /// The key that host and vehicle share.
    Pairing,
    /// A maneuver table, 0 to [`TABLES`] − 1; higher numbers are kept as the highest.
    Table(u8),
}

impl Key {
    /// Every key.
    pub const ALL: [Self; 11] = [
        Self::Vehicle,
        Self::Settings,
        Self::Pairing,
        Self::Table(0),
        Self::Table(1),
        Self::Table(2),
        Self::Table(3),
        Self::Table(4),
        Self::Table(5),
        Self::Table(6),
        Self::Table(7),
    ];

    /// Its number in flash, which never changes its meaning.
    pub const fn code(self) -> u8 {
        match self {
            Self::Vehicle => 1,
            Self::Settings => 2,
            Self::Pairing => 3,
            Self::Table(n) if n < TABLES => 16 + n,
            Self::Table(_) => 16 + TABLES - 1,
        }
    }
}

//! A series of numbers as the page carries it: 32-bit floats in base64, a third of what decimal numbers would take.

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use serde::{Serialize, Serializer};

/// Numbers over time. In JSON one string: little-endian `f32` in base64, NaN where there is no value.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Column(Vec<f32>);

impl Column {
    /// The numbers, in order.
    pub fn values(&self) -> &[f32] {
        &self.0
    }

    /// The column, or `None` where none of its numbers is finite.
    pub(super) fn if_any(self) -> Option<Self> {
        self.0.iter().any(|v| v.is_finite()).then_some(self)
    }
}

impl FromIterator<f64> for Column {
    /// Infinities are no values either.
    fn from_iter<I: IntoIterator<Item = f64>>(values: I) -> Self {
        let finite = |v: f64| {
            let narrow = v as f32;
            if narrow.is_finite() { narrow } else { f32::NAN }
        };
        Self(values.into_iter().map(finite).collect())
    }
}

impl Serialize for Column {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let bytes: Vec<u8> = self.0.iter().flat_map(|v| v.to_le_bytes()).collect();
        serializer.serialize_str(&STANDARD.encode(bytes))
    }
}

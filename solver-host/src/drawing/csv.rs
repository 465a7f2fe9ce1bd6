//! Tables of numbers as CSV.

use std::fmt::{Display, Write as _};

/// A growing table. Texts with commas come in quotes.
pub(crate) struct Csv {
    out: String,
    columns: usize,
}

impl Csv {
    /// With a header: names with units, separated by commas.
    pub(crate) fn new(header: &str) -> Self {
        Self { out: format!("{header}\n"), columns: header.split(',').count() }
    }

    /// One row; numbers in full, as many as there are columns.
    pub(crate) fn row<const N: usize>(&mut self, cells: [&dyn Display; N]) {
        debug_assert_eq!(N, self.columns);
        for (i, cell) in cells.iter().enumerate() {
            // Writing to a string does not fail.
            let _ = write!(self.out, "{}{cell}", if i == 0 { "" } else { "," });
        }
        self.out.push('\n');
    }

    pub(crate) fn finish(self) -> String {
        self.out
    }
}

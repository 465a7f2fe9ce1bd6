//! Flight logs as CSV: named columns with units, in any order, among others.

use csv::{ByteRecord, Reader, ReaderBuilder, StringRecord};

use super::builder::{Attitude, Builder};
use super::columns::{Header, QUANTITIES, Quantity, expected, header, units};
use super::flight::{Flight, Remark};
use super::read_error::ReadError;

/// Reads a CSV log from the bytes of its file.
///
/// Commas, semicolons or tabs between cells, Unix or Windows line ends, lines that begin with `#` and empty lines
/// anywhere, further columns. With semicolons or tabs a decimal comma is understood.
///
/// # Errors
/// [`ReadError`]: everything but the kinds that belong to files and MCAP.
pub fn read_csv(bytes: &[u8]) -> Result<Flight, ReadError> {
    if bytes.starts_with(b"\xff\xfe") || bytes.starts_with(b"\xfe\xff") {
        return Err(ReadError::Utf16);
    }
    // Comments may be in any encoding; a number that is not UTF-8 is refused where it stands. One kind of line end keeps
    // the count of lines exact.
    let text = String::from_utf8_lossy(bytes).replace("\r\n", "\n");
    let text = text.strip_prefix('\u{feff}').unwrap_or(&text);
    let no_line_break = !text.ends_with('\n');
    let text = if no_line_break { format!("{text}\n") } else { text.to_owned() };
    let Some(first) = text.lines().find(|line| !is_comment(line)) else { return Err(ReadError::Empty) };
    let delimiter = [b',', b';', b'\t']
        .into_iter()
        .max_by_key(|d| first.bytes().filter(|b| b == d).count())
        .unwrap_or(b',');
    let mut reader = ReaderBuilder::new()
        .delimiter(delimiter)
        .has_headers(false)
        .flexible(true)
        // A stray quotation mark must not swallow the lines after it.
        .quoting(false)
        .from_reader(text.as_bytes());
    let mut lines = Lines { reader: &mut reader, decimal_comma: delimiter != b',' };
    let Some((_, names)) = lines.next() else { return Err(ReadError::Empty) };
    let columns = Columns::new(&names)?;

    let mut builder = Builder::default();
    let mut remarks = Vec::new();
    // A fault is told only when a further line shows that it is not a cut at the end.
    let mut fault: Option<ReadError> = None;
    while let Some((line, cells)) = lines.next() {
        if let Some(error) = fault.take() {
            return Err(error);
        }
        let whole = cells.len() == names.len();
        fault = if whole {
            columns.push(&mut builder, line, &cells, lines.decimal_comma).err()
        } else {
            Some(ReadError::Ragged { line, found: cells.len(), expected: names.len() })
        };
    }
    match fault {
        Some(ReadError::Ragged { line, .. } | ReadError::NotANumber { line, .. }) if no_line_break => {
            let found = format!("line {line} is not whole");
            remarks.push(Remark::Cut { found, last_s: builder.last_s() });
        }
        Some(error) => return Err(error),
        None if no_line_break && builder.len() > 0 => remarks.push(Remark::NoLineBreak),
        None => {}
    }
    builder.finish(remarks)
}

fn is_comment(line: &str) -> bool {
    line.trim().is_empty() || line.trim_start().starts_with('#')
}

/// Lines with cells, and their numbers.
struct Lines<'a> {
    reader: &'a mut Reader<&'a [u8]>,
    decimal_comma: bool,
}

impl Lines<'_> {
    /// The next line that is neither empty nor a comment.
    fn next(&mut self) -> Option<(u64, StringRecord)> {
        let mut record = ByteRecord::new();
        // Reading from memory, without a fixed number of cells, does not fail.
        while self.reader.read_byte_record(&mut record).ok()? {
            let record = StringRecord::from_byte_record_lossy(record.clone());
            let blank = record.len() == 1 && record.get(0).is_some_and(|cell| cell.trim().is_empty());
            if !blank && !record.get(0).is_some_and(is_comment_cell) {
                // The reader stands at the beginning of the next line.
                return Some((self.reader.position().line() - 1, record));
            }
        }
        None
    }
}

fn is_comment_cell(cell: &str) -> bool {
    cell.trim_start().starts_with('#')
}

/// Where each quantity stands.
struct Columns {
    places: [Option<Column>; QUANTITIES],
}

#[derive(Clone)]
struct Column {
    index: usize,
    name: String,
    factor: f64,
}

impl Columns {
    fn new(names: &StringRecord) -> Result<Self, ReadError> {
        let mut places: [Option<Column>; QUANTITIES] = Default::default();
        let mut without_unit = Vec::new();
        for (index, name) in names.iter().enumerate() {
            match header(name) {
                Header::Column(quantity, factor) => {
                    let column = Column { index, name: name.trim().to_owned(), factor };
                    if let Some(other) = places[quantity as usize].replace(column) {
                        return Err(ReadError::TwoColumns {
                            first: other.name,
                            second: name.trim().to_owned(),
                            expected: expected(quantity),
                        });
                    }
                }
                Header::NoUnit(quantity) => without_unit.push((quantity, name)),
                Header::Extra => {}
            }
        }
        for (quantity, name) in without_unit {
            if places[quantity as usize].is_none() {
                return Err(ReadError::NoUnit {
                    found: name.trim().to_owned(),
                    expected: expected(quantity),
                    units: units(quantity),
                });
            }
        }
        let columns = Self { places };
        columns.complete(names)?;
        Ok(columns)
    }

    /// Everything that is needed is there, and nothing is there by half.
    fn complete(&self, names: &StringRecord) -> Result<(), ReadError> {
        use Quantity::{Qw, Qx, Qy, Qz, Theta, Time, Vx, Vy, Vz, X, Y, Z};
        let missing = |quantity, hint| ReadError::MissingColumn {
            expected: expected(quantity),
            found: names.iter().take(20).map(str::trim).collect::<Vec<_>>().join(" "),
            hint,
        };
        for needed in [Time, X, Z] {
            if !self.has(needed) {
                return Err(missing(needed, "; names carry their unit, like t_s, t_ms, x_m, x_mm"));
            }
        }
        let quaternion = [Qw, Qx, Qy, Qz];
        if quaternion.iter().any(|q| self.has(*q)) {
            if let Some(part) = quaternion.into_iter().find(|q| !self.has(*q)) {
                return Err(missing(part, "; a quaternion has four columns"));
            }
        } else if !self.has(Theta) {
            return Err(missing(Theta, "; the pitch, positive nose-down, or a quaternion qw, qx, qy, qz"));
        } else if self.has(Y) {
            return Err(missing(Qw, "; a flight with y_m needs its attitude as a quaternion"));
        }
        let speeds = if self.has(Y) { &[Vx, Vy, Vz][..] } else { &[Vx, Vz] };
        if speeds.iter().any(|v| self.has(*v))
            && let Some(part) = speeds.iter().find(|v| !self.has(**v))
        {
            return Err(missing(
                *part,
                "; give all components of the velocity, or none to have them derived",
            ));
        }
        Ok(())
    }

    fn has(&self, quantity: Quantity) -> bool {
        self.places[quantity as usize].is_some()
    }

    fn push(
        &self,
        builder: &mut Builder,
        line: u64,
        cells: &StringRecord,
        decimal_comma: bool,
    ) -> Result<(), ReadError> {
        let value = |quantity: Quantity| {
            let Some(column) = &self.places[quantity as usize] else { return Ok(0.0) };
            let text = cells.get(column.index).unwrap_or_default().trim();
            let number = if decimal_comma { text.replacen(',', ".", 1).parse() } else { text.parse::<f64>() };
            match number {
                Ok(number) if (number * column.factor).is_finite() => Ok(number * column.factor),
                _ => Err(ReadError::NotANumber {
                    line,
                    column: column.name.clone(),
                    text: text.chars().take(40).collect(),
                }),
            }
        };
        use Quantity::{Qw, Qx, Qy, Qz, Theta, Time, Vx, Vy, Vz, X, Y, Z};
        let position_m = [value(X)?, value(Y)?, value(Z)?];
        let velocity_mps = match self.has(Vx) {
            true => Some([value(Vx)?, value(Vy)?, value(Vz)?]),
            false => None,
        };
        let attitude = match self.has(Qw) {
            true => Attitude::Quaternion([value(Qw)?, value(Qx)?, value(Qy)?, value(Qz)?]),
            false => Attitude::Pitch(value(Theta)?),
        };
        builder.push(|| format!("line {line}"), value(Time)?, position_m, velocity_mps, attitude)
    }
}

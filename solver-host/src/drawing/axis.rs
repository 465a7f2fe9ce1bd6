//! Ranges, ticks at nice numbers, and their labels.

/// A range of an axis, low below high, both finite.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Range {
    pub(crate) low: f64,
    pub(crate) high: f64,
}

impl Range {
    /// The smallest range that holds all values, `None` without values. Values are taken to be finite.
    pub(crate) fn of(values: impl IntoIterator<Item = f64>) -> Option<Self> {
        values.into_iter().fold(None, |range: Option<Self>, v| {
            Some(range.map_or(Self { low: v, high: v }, |r| Self { low: r.low.min(v), high: r.high.max(v) }))
        })
    }

    pub(crate) fn span(&self) -> f64 {
        self.high - self.low
    }

    pub(crate) fn middle(&self) -> f64 {
        0.5 * (self.low + self.high)
    }

    /// Both ranges.
    pub(crate) fn and(self, other: Option<Self>) -> Self {
        other.map_or(self, |o| Self { low: self.low.min(o.low), high: self.high.max(o.high) })
    }

    /// What of this range lies within the other; an end of the other where nothing does.
    pub(crate) fn within(self, other: Self) -> Self {
        Self { low: self.low.clamp(other.low, other.high), high: self.high.clamp(other.low, other.high) }
    }

    /// At least `span` wide, about the same middle.
    pub(crate) fn at_least(self, span: f64) -> Self {
        if self.span() >= span {
            return self;
        }
        let middle = self.middle();
        Self { low: middle - 0.5 * span, high: middle + 0.5 * span }
    }

    /// Wider by a fraction of its span at both ends.
    pub(crate) fn padded(self, fraction: f64) -> Self {
        let pad = self.span() * fraction;
        Self { low: self.low - pad, high: self.high + pad }
    }
}

/// The smallest step of 1, 2 or 5 times a power of ten that makes at most `most` intervals.
pub(crate) fn nice_step(span: f64, most: f64) -> f64 {
    let wanted = span / most.max(1.0);
    if !(wanted.is_finite() && wanted > 0.0) {
        return 1.0;
    }
    let power = 10_f64.powi(wanted.log10().floor() as i32);
    [1.0, 2.0, 5.0, 10.0]
        .map(|m| m * power)
        .into_iter()
        .find(|step| *step >= wanted * (1.0 - 1e-9))
        .unwrap_or(10.0 * power)
}

/// Multiples of the step within the range: at most a hundred.
pub(crate) fn ticks(range: Range, step: f64) -> Vec<f64> {
    let first = (range.low / step - 1e-6).ceil();
    (0..100).map(|i| (first + f64::from(i)) * step).take_while(|v| *v <= range.high + 1e-6 * step).collect()
}

/// A tick's label with as many decimals as the step needs, and a true minus sign.
pub(crate) fn tick_label(value: f64, step: f64) -> String {
    let decimals = (-step.log10() - 1e-9).ceil().clamp(0.0, 9.0) as usize;
    let text = format!("{value:.decimals$}");
    if text.trim_matches(['-', '0', '.']).is_empty() {
        return "0".to_owned();
    }
    text.replace('-', "−")
}

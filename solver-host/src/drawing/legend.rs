//! Keys that say what is what.

use super::style::{FRAME, INK, TEXT_SIZE};
use super::svg::{Svg, TextStyle, px, text_width};

/// Width of a key's sample.
const SAMPLE: f64 = 34.0;
/// From a key's left edge to its text.
const INDENT: f64 = 42.0;
/// Between keys.
const GAP: f64 = 24.0;
/// From row to row.
const ROW: f64 = 26.0;

/// A key: a sample, drawn from (0, 0) at the text's base line to 34 units right, and its text.
#[derive(Clone, Debug)]
pub(crate) struct Key {
    sample: String,
    text: String,
}

impl Key {
    pub(crate) fn new(sample: String, text: impl Into<String>) -> Self {
        Self { sample, text: text.into() }
    }

    /// A line with these stroke attributes.
    pub(crate) fn line(attributes: &str, text: impl Into<String>) -> Self {
        Self::new(format!(r#"<path d="M0 -5H{SAMPLE}" fill="none" {attributes}/>"#), text)
    }

    /// An upright line with these stroke attributes.
    pub(crate) fn upright(attributes: &str, text: impl Into<String>) -> Self {
        Self::new(format!(r#"<path d="M17 -14V4" fill="none" {attributes}/>"#), text)
    }

    /// A dot of this radius.
    pub(crate) fn dot(radius: f64, attributes: &str, text: impl Into<String>) -> Self {
        Self::new(format!(r#"<circle cx="17" cy="-5" r="{radius}" {attributes}/>"#), text)
    }

    /// An area of this colour.
    pub(crate) fn area(fill: &str, text: impl Into<String>) -> Self {
        let sample =
            format!(r#"<rect x="0" y="-13" width="{SAMPLE}" height="16" fill="{fill}" stroke="{FRAME}"/>"#);
        Self::new(sample, text)
    }

    /// The vehicle, in this colour.
    pub(crate) fn vehicle(colour: &str, text: impl Into<String>) -> Self {
        Self::new(vehicle_sample(colour), text)
    }

    /// The same with the vehicle behind its sample.
    pub(crate) fn over_vehicle(mut self, colour: &str) -> Self {
        self.sample.insert_str(0, &vehicle_sample(colour));
        self
    }
}

fn vehicle_sample(colour: &str) -> String {
    format!(
        r##"<g transform="translate(17 -2) scale(30)" stroke="{colour}"><use href="#vehicle"/><path d="M0 0V-.5" stroke-width=".045"/></g>"##
    )
}

/// Rows of keys from `left` to `right`, the first with its base line at `y`. Returns the base line of the last.
pub(crate) fn rows(svg: &mut Svg, keys: &[Key], (left, right): (f64, f64), mut y: f64) -> f64 {
    let mut x = left;
    for key in keys {
        let width = INDENT + text_width(&key.text, TEXT_SIZE);
        if x > left && x + width > right {
            x = left;
            y += ROW;
        }
        svg.raw(&format!(r#"<g transform="translate({} {})">{}</g>"#, px(x), px(y), key.sample));
        svg.text((x + INDENT, y), &key.text, TextStyle::new(TEXT_SIZE, INK));
        x += width + GAP;
    }
    y
}

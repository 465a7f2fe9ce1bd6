//! Text into HTML.

use std::fmt::{Display, Write as _};

/// Text as it may stand in an element or in an attribute between quotation marks.
pub(super) fn escape(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => escaped.push_str("&amp;"),
            '<' => escaped.push_str("&lt;"),
            '>' => escaped.push_str("&gt;"),
            '"' => escaped.push_str("&quot;"),
            '\'' => escaped.push_str("&#39;"),
            _ => escaped.push(c),
        }
    }
    escaped
}

/// Replaces each `{{name}}` of a template, in one pass: what is put in is not looked at again.
pub(super) fn fill(template: &str, value: impl Fn(&str) -> String) -> String {
    let mut parts = template.split("{{");
    let mut text = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        match part.split_once("}}") {
            Some((name, rest)) => {
                text.push_str(&value(name));
                text.push_str(rest);
            }
            None => text.push_str(part),
        }
    }
    text
}

/// Writes elements one after the other.
#[derive(Default)]
pub(super) struct Html(String);

impl Html {
    pub(super) fn into_text(self) -> String {
        self.0
    }

    /// Markup as it is.
    pub(super) fn raw(&mut self, markup: impl Display) -> &mut Self {
        // Writing to a string does not fail.
        let _ = write!(self.0, "{markup}");
        self
    }

    /// An element with text in it; `open` is its name with attributes, e.g. `td class="number"`.
    pub(super) fn element(&mut self, open: &str, text: &str) -> &mut Self {
        let name = open.split(' ').next().unwrap_or(open);
        self.raw(format_args!("<{open}>{}</{name}>", escape(text)))
    }

    /// An element with text in which `_` begins the index of a symbol: Φ_R, u_R, ω_max.
    pub(super) fn math(&mut self, open: &str, text: &str) -> &mut Self {
        let name = open.split(' ').next().unwrap_or(open);
        let mut marked = escape(text);
        for (symbol, index) in [("Φ", "R"), ("Φ", "T"), ("u", "R"), ("ω", "max")] {
            let with_index = format!("{symbol}<sub>{index}</sub>");
            marked = marked.replace(&format!("{symbol}_{index}"), &with_index);
        }
        self.raw(format_args!("<{open}>{marked}</{name}>"))
    }

    /// The head of a table.
    pub(super) fn heads(&mut self, names: &[&str]) -> &mut Self {
        self.raw("<thead><tr>");
        for name in names {
            self.element("th scope=\"col\"", name);
        }
        self.raw("</tr></thead>")
    }
}

/// A number for people: few digits, powers of ten where it is very small or very large, a dash where there is none.
pub(super) fn number(value: f64) -> String {
    if !value.is_finite() {
        return "–".to_owned();
    }
    if value == 0.0 {
        return "0".to_owned();
    }
    let magnitude = value.abs();
    let text = if (1e-3..1e5).contains(&magnitude) {
        let digits = (3 - magnitude.log10().floor() as i32).clamp(0, 6) as usize;
        format!("{value:.digits$}")
    } else {
        let text = format!("{value:.2e}");
        let (mantissa, exponent) = text.split_once('e').unwrap_or((&text, "0"));
        format!("{mantissa}·10{}", superscript(exponent))
    };
    text.replace('-', "−")
}

fn superscript(exponent: &str) -> String {
    exponent
        .chars()
        .map(|c| match c {
            '-' => '⁻',
            '1' => '¹',
            '2' => '²',
            '3' => '³',
            '4' => '⁴',
            '5' => '⁵',
            '6' => '⁶',
            '7' => '⁷',
            '8' => '⁸',
            '9' => '⁹',
            _ => '⁰',
        })
        .collect()
}

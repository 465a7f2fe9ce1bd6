//! SVG text: elements, escaping and numbers. Nothing that is not finite gets into an attribute.

use std::fmt::Write as _;

use super::style::{INK, SMALL_SIZE};

/// A point on the page, SVG units, y down.
pub(crate) type Point = (f64, f64);

/// A rectangle on the page.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Rect {
    pub(crate) x: f64,
    pub(crate) y: f64,
    pub(crate) width: f64,
    pub(crate) height: f64,
}

impl Rect {
    pub(crate) fn right(&self) -> f64 {
        self.x + self.width
    }

    pub(crate) fn bottom(&self) -> f64 {
        self.y + self.height
    }
}

/// Where a text is anchored.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Anchor {
    Start,
    Middle,
    End,
}

/// How a text looks.
#[derive(Clone, Copy, Debug)]
pub(crate) struct TextStyle {
    pub(crate) size: f64,
    pub(crate) colour: &'static str,
    pub(crate) anchor: Anchor,
    pub(crate) bold: bool,
}

impl TextStyle {
    pub(crate) fn new(size: f64, colour: &'static str) -> Self {
        Self { size, colour, anchor: Anchor::Start, bold: false }
    }

    pub(crate) fn anchored(self, anchor: Anchor) -> Self {
        Self { anchor, ..self }
    }

    pub(crate) fn bold(self) -> Self {
        Self { bold: true, ..self }
    }
}

/// A growing SVG document. Colours and widths come as ready attributes, data only as numbers and escaped text.
#[derive(Default)]
pub(crate) struct Svg {
    out: String,
}

impl Svg {
    pub(crate) fn raw(&mut self, markup: &str) {
        self.out.push_str(markup);
        self.out.push('\n');
    }

    pub(crate) fn open_group(&mut self, attributes: &str) {
        let _ = writeln!(self.out, "<g {attributes}>");
    }

    pub(crate) fn close_group(&mut self) {
        self.out.push_str("</g>\n");
    }

    pub(crate) fn rect(&mut self, rect: &Rect, attributes: &str) {
        let [x, y, width, height] = [rect.x, rect.y, rect.width, rect.height].map(px);
        let _ =
            writeln!(self.out, r#"<rect x="{x}" y="{y}" width="{width}" height="{height}" {attributes}/>"#);
    }

    pub(crate) fn line(&mut self, from: Point, to: Point, attributes: &str) {
        let [x1, y1, x2, y2] = [from.0, from.1, to.0, to.1].map(px);
        let _ = writeln!(self.out, r#"<line x1="{x1}" y1="{y1}" x2="{x2}" y2="{y2}" {attributes}/>"#);
    }

    pub(crate) fn circle(&mut self, centre: Point, radius: f64, attributes: &str) {
        let [x, y, r] = [centre.0, centre.1, radius].map(px);
        let _ = writeln!(self.out, r#"<circle cx="{x}" cy="{y}" r="{r}" {attributes}/>"#);
    }

    /// A curve through points, thinned to what can be seen. Nothing for fewer than two points.
    pub(crate) fn curve(&mut self, points: &[Point], attributes: &str) {
        let points = simplify(points);
        if points.len() < 2 {
            return;
        }
        self.out.push_str("<polyline points=\"");
        for (i, (x, y)) in points.into_iter().enumerate() {
            let space = if i == 0 { "" } else { " " };
            let _ = write!(self.out, "{space}{},{}", px(x), px(y));
        }
        let _ = writeln!(self.out, "\" fill=\"none\" stroke-linejoin=\"round\" {attributes}/>");
    }

    /// An area within closed outlines, thinned to what can be seen; holes are outlines within others.
    pub(crate) fn area(&mut self, outlines: &[Vec<Point>], attributes: &str) {
        self.out.push_str("<path d=\"");
        for outline in outlines {
            let points = simplify(outline);
            if points.len() < 3 {
                continue;
            }
            for (i, (x, y)) in points.into_iter().enumerate() {
                let _ = write!(self.out, "{}{},{}", if i == 0 { 'M' } else { 'L' }, px(x), px(y));
            }
            self.out.push('Z');
        }
        let _ = writeln!(self.out, "\" fill-rule=\"evenodd\" {attributes}/>");
    }

    pub(crate) fn text(&mut self, at: Point, text: &str, style: TextStyle) {
        self.text_with(at, text, style, "");
    }

    /// Text that reads upwards, centred on the point.
    pub(crate) fn text_upwards(&mut self, at: Point, text: &str, style: TextStyle) {
        let rotation = format!(r#" transform="rotate(-90 {} {})""#, px(at.0), px(at.1));
        self.text_with(at, text, style.anchored(Anchor::Middle), &rotation);
    }

    /// The name of a level line, centred on the point and to be read over lines.
    pub(crate) fn level_name(&mut self, at: Point, text: &str) {
        self.open_group(
            r##"stroke="#ffffff" stroke-width="7" stroke-linejoin="round" paint-order="stroke""##,
        );
        self.text(at, text, TextStyle::new(SMALL_SIZE, INK).anchored(Anchor::Middle).bold());
        self.close_group();
    }

    fn text_with(&mut self, at: Point, text: &str, style: TextStyle, more: &str) {
        let anchor = match style.anchor {
            Anchor::Start => "",
            Anchor::Middle => r#" text-anchor="middle""#,
            Anchor::End => r#" text-anchor="end""#,
        };
        let weight = if style.bold { r#" font-weight="700""# } else { "" };
        let _ = writeln!(
            self.out,
            r#"<text x="{}" y="{}" font-size="{}" fill="{}"{anchor}{weight}{more}>{}</text>"#,
            px(at.0),
            px(at.1),
            px(style.size),
            style.colour,
            with_subscripts(text, style.size),
        );
    }

    pub(crate) fn finish(self) -> String {
        self.out
    }
}

/// A length with at most two decimals. What is not finite becomes 0, what is far off the page is brought nearer.
pub(crate) fn px(value: f64) -> String {
    let value = if value.is_finite() { value.clamp(-1e5, 1e5) } else { 0.0 };
    let mut text = format!("{value:.2}");
    // `{:.2}` always writes a point, so only decimals are cut.
    text.truncate(text.trim_end_matches('0').trim_end_matches('.').len());
    if text == "-0" { "0".to_owned() } else { text }
}

/// Text as XML character data; characters that XML 1.0 does not allow are left out.
pub(crate) fn escape(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            '\t' | '\n' | '\r' => out.push(' '),
            c if c < ' ' || matches!(c, '\u{fffe}' | '\u{ffff}') => {}
            c => out.push(c),
        }
    }
    out
}

/// Text as markup: what stands in `_{}` is a subscript. Shifted by hand, because not every viewer knows `baseline-shift`.
fn with_subscripts(text: &str, size: f64) -> String {
    let shift = px(SUBSCRIPT_DROP * size);
    let mut out = String::new();
    let mut rest = text;
    let mut lowered = false;
    while let Some((before, (subscript, after))) =
        rest.split_once("_{").and_then(|(before, tail)| Some((before, tail.split_once('}')?)))
    {
        raised(&mut out, before, &shift, lowered);
        // Writing to a string does not fail.
        let _ = write!(
            out,
            r#"<tspan dy="{shift}" font-size="{}">{}</tspan>"#,
            px(SUBSCRIPT_SIZE * size),
            escape(subscript)
        );
        (rest, lowered) = (after, true);
    }
    raised(&mut out, rest, &shift, lowered);
    out
}

/// Text on the base line, after a subscript or not.
fn raised(out: &mut String, text: &str, shift: &str, lowered: bool) {
    if lowered && !text.is_empty() {
        let _ = write!(out, r#"<tspan dy="-{shift}">{}</tspan>"#, escape(text));
    } else {
        out.push_str(&escape(text));
    }
}

/// Size of subscripts, relative.
const SUBSCRIPT_SIZE: f64 = 0.72;
/// How much lower they stand, in sizes of the text.
const SUBSCRIPT_DROP: f64 = 0.22;

/// About how wide a text is in the embedded font; subscripts count as they are drawn.
pub(crate) fn text_width(text: &str, size: f64) -> f64 {
    if let Some((before, tail)) = text.split_once("_{")
        && let Some((subscript, after)) = tail.split_once('}')
    {
        let sides = text_width(before, size) + text_width(after, size);
        return sides + text_width(subscript, SUBSCRIPT_SIZE * size);
    }
    let em = |c: char| match c {
        'i' | 'j' | 'l' | '\'' | '.' | ',' | ':' | ';' | '|' | '!' | ' ' => 0.27,
        'f' | 't' | 'r' | '(' | ')' | '[' | ']' | '-' | '/' => 0.37,
        'm' | 'w' | 'M' | 'W' | '@' => 0.88,
        c if c.is_uppercase() => 0.66,
        c if c.is_ascii() => 0.58,
        c if c < '\u{2e80}' => 0.6,
        _ => 1.0,
    };
    text.chars().map(em).sum::<f64>() * size
}

/// The text, cut with an ellipsis if it is wider than `width`.
pub(crate) fn fit(text: &str, size: f64, width: f64) -> String {
    if text_width(text, size) <= width {
        return text.to_owned();
    }
    let mut kept = String::new();
    for c in text.chars() {
        kept.push(c);
        if text_width(&kept, size) + size > width {
            break;
        }
    }
    kept.push('…');
    kept
}

/// The fewest of the points through which the curve looks the same: no point left out is further than a tenth of a
/// pixel from it (Douglas and Peucker's method).
fn simplify(points: &[Point]) -> Vec<Point> {
    const TOLERANCE: f64 = 0.1;
    let mut near: Vec<Point> = Vec::with_capacity(points.len());
    for &point in points {
        if near.last().is_none_or(|last| (last.0 - point.0).hypot(last.1 - point.1) > 0.02) {
            near.push(point);
        }
    }
    if near.len() < 3 {
        return near;
    }
    let last = near.len() - 1;
    let mut keep = vec![false; near.len()];
    keep[0] = true;
    keep[last] = true;
    let mut open = vec![(0, last)];
    while let Some((a, b)) = open.pop() {
        let farthest = (a + 1..b)
            .map(|i| (distance(near[i], near[a], near[b]), i))
            .max_by(|one, other| one.0.total_cmp(&other.0));
        if let Some((distance, i)) = farthest
            && distance > TOLERANCE
        {
            keep[i] = true;
            open.push((a, i));
            open.push((i, b));
        }
    }
    near.into_iter().zip(keep).filter_map(|(point, keep)| keep.then_some(point)).collect()
}

/// Distance of a point from the segment between two others.
fn distance(p: Point, a: Point, b: Point) -> f64 {
    let (dx, dy) = (b.0 - a.0, b.1 - a.1);
    let length2 = dx * dx + dy * dy;
    let along = if length2 > 0.0 { ((p.0 - a.0) * dx + (p.1 - a.1) * dy) / length2 } else { 0.0 };
    let along = along.clamp(0.0, 1.0);
    (p.0 - a.0 - along * dx).hypot(p.1 - a.1 - along * dy)
}

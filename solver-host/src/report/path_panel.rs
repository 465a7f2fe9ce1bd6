//! The path in the vertical plane, both axes to one scale, with the vehicle drawn along it.

use super::layout::PATH_PADDING;
use super::vehicle::{self, Symbol};
use super::view::{Instant, View};
use crate::drawing::axis::{Range, nice_step, tick_label, ticks};
use crate::drawing::style::{FLOWN, FRAME, GHOST, GRID, INK, MUTED, SMALL_SIZE, TEXT_SIZE};
use crate::drawing::svg::{Anchor, Point, Rect, Svg, TextStyle, text_width};

/// The part of the vertical plane to show, m, before it is fitted to a panel.
#[derive(Clone, Copy, Debug)]
pub(super) struct Extent {
    x: Range,
    z: Range,
}

impl Extent {
    pub(super) fn of(view: &View) -> Self {
        let ranges = |instants: &[Instant]| {
            Some((Range::of(instants.iter().map(|i| i.x_m))?, Range::of(instants.iter().map(|i| i.z_m))?))
        };
        let nothing = Range { low: 0.0, high: 0.0 };
        let (x, z) = ranges(&view.planned).or_else(|| ranges(&view.flown)).unwrap_or((nothing, nothing));
        // A vehicle that flies off must not shrink the plan to a dot: it leaves the picture instead. What it does
        // during the maneuver may take more room than what it does before and after.
        let span = x.span().max(z.span()).max(1e-3);
        let maneuver = |i: &&Instant| i.t_s >= 0.0 && i.t_s <= view.duration_s;
        let during: Vec<Instant> = view.flown.iter().filter(maneuver).copied().collect();
        let (mut all_x, mut all_z) = (x, z);
        for (instants, beyond) in [(&during, span.max(0.1)), (&view.flown, 0.4 * span)] {
            let around = |r: Range| Range { low: r.low - beyond, high: r.high + beyond };
            if let Some((flown_x, flown_z)) = ranges(instants) {
                all_x = all_x.and(Some(flown_x.within(around(x))));
                all_z = all_z.and(Some(flown_z.within(around(z))));
            }
        }
        let least = if view.planned.is_empty() && view.flown.is_empty() { 1.0 } else { 1e-3 };
        let longest = all_x.span().max(all_z.span()).max(least);
        // Neither side below a hundredth of the other: a vertical line has no width of its own.
        Self { x: all_x.at_least(0.01 * longest), z: all_z.at_least(0.01 * longest) }
    }

    pub(super) fn width(&self) -> f64 {
        self.x.span()
    }

    pub(super) fn height(&self) -> f64 {
        self.z.span()
    }

    /// The unit that makes good numbers of positions this large.
    pub(super) fn unit(&self) -> Unit {
        Unit::for_span(self.x.span().max(self.z.span()))
    }
}

/// A unit of length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Unit {
    pub(super) name: &'static str,
    pub(super) per_m: f64,
}

impl Unit {
    fn for_span(span_m: f64) -> Self {
        match span_m {
            s if s < 0.004 => Self { name: "mm", per_m: 1000.0 },
            s if s < 0.4 => Self { name: "cm", per_m: 100.0 },
            _ => Self { name: "m", per_m: 1.0 },
        }
    }
}

/// From metres in the plane to the page.
#[derive(Clone, Copy, Debug)]
pub(super) struct Plane {
    x: Range,
    z: Range,
    rect: Rect,
    scale: f64,
}

impl Plane {
    fn new(extent: &Extent, rect: Rect) -> Self {
        let inner = (rect.width - 2.0 * PATH_PADDING, rect.height - 2.0 * PATH_PADDING);
        let scale = (inner.0 / extent.width()).min(inner.1 / extent.height());
        let around = |range: Range, length: f64| {
            let half = 0.5 * length / scale;
            Range { low: range.middle() - half, high: range.middle() + half }
        };
        Self { x: around(extent.x, rect.width), z: around(extent.z, rect.height), rect, scale }
    }

    /// Pixels per metre.
    pub(super) fn scale(&self) -> f64 {
        self.scale
    }

    pub(super) fn point(&self, x_m: f64, z_m: f64) -> Point {
        let x = self.rect.x + (x_m - self.x.low) * self.scale;
        let y = self.rect.bottom() - (z_m - self.z.low) * self.scale;
        (x, y)
    }

    pub(super) fn of(&self, instant: &Instant) -> Point {
        self.point(instant.x_m, instant.z_m)
    }
}

/// Draws the panel.
pub(super) fn draw(svg: &mut Svg, view: &View, extent: &Extent, rect: Rect, thrust_max: f64) {
    let plane = Plane::new(extent, rect);
    axes(svg, &plane, extent.unit());

    svg.raw(r#"<clipPath id="plane">"#);
    svg.rect(&rect, "");
    svg.raw("</clipPath>");
    svg.open_group(r#"clip-path="url(#plane)""#);
    let planned: Vec<Point> = view.planned.iter().map(|i| plane.of(i)).collect();
    let part = |from: f64, to: f64| -> Vec<Point> {
        view.flown.iter().filter(|i| i.t_s >= from && i.t_s <= to).map(|i| plane.of(i)).collect()
    };
    let symbol = Symbol::new(&plane, thrust_max);
    let instants = vehicle::instants(&plane, &symbol, view);
    if view.flown.is_empty() {
        svg.curve(&planned, &format!(r#"stroke="{INK}" stroke-width="1.6""#));
        svg.open_group(&format!(r#"class="planned-vehicles" stroke="{INK}""#));
        symbol.draw(svg, &plane, &view.planned, &instants);
        svg.close_group();
    } else {
        let thin = format!(r#"stroke="{FLOWN}" stroke-width="1.4" stroke-dasharray="2 3""#);
        svg.curve(&part(view.window.low, 0.0), &thin);
        svg.curve(&part(view.duration_s, view.window.high), &thin);
        svg.open_group(&format!(r#"class="planned-vehicles" stroke="{GHOST}""#));
        symbol.draw(svg, &plane, &view.planned, &instants);
        svg.close_group();
        svg.curve(&part(0.0, view.duration_s), &format!(r#"stroke="{FLOWN}" stroke-width="1.8""#));
        svg.open_group(&format!(r#"class="flown-vehicles" stroke="{FLOWN}""#));
        symbol.draw(svg, &plane, &view.flown, &instants);
        svg.close_group();
        svg.curve(&planned, &format!(r#"stroke="{INK}" stroke-width="1.2""#));
    }
    ends(svg, &plane, view);
    svg.close_group();
    svg.rect(&rect, &format!(r#"fill="none" stroke="{FRAME}""#));
}

fn axes(svg: &mut Svg, plane: &Plane, unit: Unit) {
    let rect = plane.rect;
    svg.rect(&rect, "fill=\"#ffffff\"");
    let in_unit = |r: Range| Range { low: r.low * unit.per_m, high: r.high * unit.per_m };
    let (x, z) = (in_unit(plane.x), in_unit(plane.z));
    // One step for both axes shows that they have one scale.
    let longer = x.span().max(z.span());
    let step = nice_step(longer, (rect.width.max(rect.height) / 60.0).floor());
    let small = TextStyle::new(SMALL_SIZE, INK);
    let grid = format!(r#"stroke="{GRID}""#);
    for value in ticks(x, step) {
        let (px, _) = plane.point(value / unit.per_m, 0.0);
        svg.line((px, rect.y), (px, rect.bottom()), &grid);
        svg.text((px, rect.bottom() + 18.0), &tick_label(value, step), small.anchored(Anchor::Middle));
    }
    for value in ticks(z, step) {
        let (_, py) = plane.point(0.0, value / unit.per_m);
        svg.line((rect.x, py), (rect.right(), py), &grid);
        svg.text((rect.x - 8.0, py + 5.0), &tick_label(value, step), small.anchored(Anchor::End));
    }
    let label = TextStyle::new(TEXT_SIZE, INK);
    let middle = (rect.x + 0.5 * rect.width, rect.y + 0.5 * rect.height);
    svg.text((middle.0, rect.bottom() + 40.0), &format!("x ({})", unit.name), label.anchored(Anchor::Middle));
    svg.text_upwards((rect.x - 46.0, middle.1), &format!("z ({})", unit.name), label);
}

/// Marks where the plan starts and ends.
fn ends(svg: &mut Svg, plane: &Plane, view: &View) {
    let (Some(first), Some(last)) = (view.planned.first(), view.planned.last()) else { return };
    let (start, end) = (plane.of(first), plane.of(last));
    let mut taken: Vec<Point> = view.planned.iter().chain(&view.flown).map(|i| plane.of(i)).collect();
    svg.circle(start, 5.5, &format!("fill=\"#ffffff\" stroke=\"{INK}\" stroke-width=\"2.2\""));
    svg.circle(end, 5.5, &format!(r##"fill="{INK}" stroke="#ffffff" stroke-width="1.6""##));
    for (at, name) in [(start, "start"), (end, "end")] {
        let place = free_place(&plane.rect, at, name, &taken);
        svg.text((place.x, place.bottom() - 4.0), name, TextStyle::new(TEXT_SIZE, MUTED).bold());
        let middle = place.y + 0.5 * place.height;
        taken.extend([0.1, 0.5, 0.9].map(|part| (place.x + part * place.width, middle)));
    }
}

/// A place for a label near a point, over as little as possible.
fn free_place(panel: &Rect, at: Point, name: &str, taken: &[Point]) -> Rect {
    let (width, height) = (text_width(name, TEXT_SIZE) + 4.0, TEXT_SIZE + 4.0);
    let away = 34.0;
    let candidates = [
        (at.0 + away, at.1 - 0.5 * height),
        (at.0 - away - width, at.1 - 0.5 * height),
        (at.0 - 0.5 * width, at.1 + away - 12.0),
        (at.0 - 0.5 * width, at.1 - away - height + 4.0),
    ];
    let cost = |place: &Rect| {
        let inside = |p: &&Point| {
            p.0 > place.x - 8.0
                && p.0 < place.right() + 8.0
                && p.1 > place.y - 8.0
                && p.1 < place.bottom() + 8.0
        };
        let off = place.x < panel.x + 2.0
            || place.right() > panel.right() - 2.0
            || place.y < panel.y + 2.0
            || place.bottom() > panel.bottom() - 2.0;
        taken.iter().filter(inside).count() + if off { 1_000_000 } else { 0 }
    };
    let mut best: Option<(usize, Rect)> = None;
    for (x, y) in candidates {
        let place = Rect { x, y, width, height };
        let cost = cost(&place);
        if best.is_none_or(|(lowest, _)| cost < lowest) {
            best = Some((cost, place));
        }
    }
    best.map_or(Rect { x: at.0, y: at.1, width, height }, |(_, place)| place)
}

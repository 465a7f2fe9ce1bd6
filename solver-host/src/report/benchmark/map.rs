//! A map of scores over displacements: colours, and lines of equal score.

use crate::benchmark::{Cell, ScoreMap};
use crate::drawing::axis::{Range, nice_step, tick_label, ticks};
use crate::drawing::page;
use crate::drawing::plot::{Axes, Plot};
use crate::drawing::style::{AXIS_BELOW, AXIS_LEFT, FRAME, INK, MARGIN, MUTED, SMALL_SIZE, TEXT_SIZE, WIDTH};
use crate::drawing::svg::{Anchor, Point, Rect, Svg, TextStyle};

/// Room for the scale of colours on the right.
const SCALE: f64 = 120.0;
/// The map's height is within these.
const HEIGHT: (f64, f64) = (260.0, 860.0);
/// Scores above this part of all share the last colour: the smallest displacements would take the whole scale.
const SHOWN: f64 = 0.97;
/// Least distance of a level's name from the edge, from other levels' names, and from the same name.
const FROM_EDGE: f64 = 26.0;
const OTHER_LEVEL: f64 = 60.0;
const SAME_LEVEL: f64 = 420.0;
/// Dark to light, even steps of lightness (the colours of viridis, by Smith and van der Walt).
const COLOURS: [[f64; 3]; 6] = [
    [68.0, 1.0, 84.0],
    [65.0, 68.0, 135.0],
    [42.0, 120.0, 142.0],
    [34.0, 168.0, 132.0],
    [122.0, 209.0, 81.0],
    [253.0, 231.0, 37.0],
];

pub(super) fn draw(map: &ScoreMap, title: &str, subtitle: &[String]) -> String {
    let mut svg = Svg::default();
    let y = page::heading(&mut svg, WIDTH, title, subtitle) + 26.0;
    let (x, z) = (edges(&map.grid.x_m), edges(&map.grid.z_m));
    let width = WIDTH - 2.0 * MARGIN - AXIS_LEFT - SCALE;
    let height = (width * z.span() / x.span()).clamp(HEIGHT.0, HEIGHT.1);
    let rect = Rect { x: MARGIN + AXIS_LEFT, y, width, height };
    let plot = Plot { rect, x, y: z };
    plot.axes(&mut svg, &Axes { x: Some("displacement x (m)"), y: "displacement z (m)" });
    let colours = colour_range(map);
    cells(&mut svg, map, &plot, colours);
    let step = nice_step(colours.span(), 10.0);
    let levels = ticks(colours, step).into_iter().map(|level| (level, contour(map, level)));
    let levels: Vec<Level> =
        levels.map(|(level, pieces)| (tick_label(level, step), on_page(&plot, &pieces))).collect();
    svg.open_group(r##"stroke="#ffffff" stroke-opacity="0.75" stroke-width="1""##);
    for (from, to) in levels.iter().flat_map(|(_, pieces)| pieces) {
        svg.line(*from, *to, "");
    }
    svg.close_group();
    name_levels(&mut svg, &rect, &levels);
    plot.frame(&mut svg);
    scale(&mut svg, &rect, colours, step, map);
    page::document(WIDTH, y + height + AXIS_BELOW + MARGIN, title, &subtitle.join(" "), svg)
}

/// The name of a level, and the pieces of its lines on the page.
type Level = (String, Vec<(Point, Point)>);

fn on_page(plot: &Plot, pieces: &[(Point, Point)]) -> Vec<(Point, Point)> {
    pieces.iter().map(|(from, to)| (plot.point(*from), plot.point(*to))).collect()
}

/// Names each level where its line is farthest from all other names and from the edges, as often as there is room.
fn name_levels(svg: &mut Svg, rect: &Rect, levels: &[Level]) {
    let mut named: Vec<(Point, usize)> = Vec::new();
    loop {
        let free = |(at, own): (Point, usize)| {
            let edge = (at.0 - rect.x).min(rect.right() - at.0).min(at.1 - rect.y).min(rect.bottom() - at.1);
            let others = named.iter().map(|(other, level)| {
                let apart = (at.0 - other.0).hypot(at.1 - other.1);
                apart / if *level == own { SAME_LEVEL } else { OTHER_LEVEL }
            });
            others.fold(edge / FROM_EDGE, f64::min)
        };
        let middles = levels.iter().enumerate().flat_map(|(own, (_, pieces))| {
            pieces.iter().map(move |(a, b)| ((0.5 * (a.0 + b.0), 0.5 * (a.1 + b.1)), own))
        });
        let best = middles.map(|place| (free(place), place)).max_by(|a, b| a.0.total_cmp(&b.0));
        match best {
            Some((room, place)) if room >= 1.0 => named.push(place),
            _ => break,
        }
    }
    for ((x, y), level) in named {
        svg.level_name((x, y + 5.0), &levels[level].0);
    }
}

/// From the outer edge of the first cell to that of the last.
fn edges(places: &[f64]) -> Range {
    let range = Range::of(places.iter().copied()).unwrap_or(Range { low: 0.0, high: 1.0 });
    let half = if places.len() > 1 { 0.5 * range.span() / (places.len() - 1) as f64 } else { 0.5 };
    Range { low: range.low - half, high: range.high + half }
}

fn colour_range(map: &ScoreMap) -> Range {
    let mut scores: Vec<f64> = map.scores().map(|(_, _, score)| score).collect();
    scores.sort_by(f64::total_cmp);
    let part = |part: f64| scores.get((part * scores.len() as f64) as usize).copied();
    let low = scores.first().copied().unwrap_or(1.0);
    let high = part(SHOWN).or(scores.last().copied()).unwrap_or(2.0);
    Range { low: low.min(high), high }.at_least(0.1)
}

fn colour(range: Range, score: f64) -> String {
    let place = ((score - range.low) / range.span()).clamp(0.0, 1.0) * (COLOURS.len() - 1) as f64;
    let index = (place as usize).min(COLOURS.len() - 2);
    let part = place - index as f64;
    let [r, g, b] = [0, 1, 2]
        .map(|c| (COLOURS[index][c] + (COLOURS[index + 1][c] - COLOURS[index][c]) * part).round() as u8);
    format!("#{r:02x}{g:02x}{b:02x}")
}

fn cells(svg: &mut Svg, map: &ScoreMap, plot: &Plot, colours: Range) {
    let (nx, nz) = (map.grid.x_m.len().max(1) as f64, map.grid.z_m.len().max(1) as f64);
    let (dx, dz) = (plot.x.span() / nx, plot.y.span() / nz);
    for ((x, z), cell) in map.points().zip(&map.cells) {
        let fill = match cell {
            Cell::Scored { score, .. } => colour(colours, *score),
            Cell::Here => "#ffffff".to_owned(),
            Cell::Failed(_) => FRAME.to_owned(),
        };
        let (left, top) = plot.point((x - 0.5 * dx, z + 0.5 * dz));
        let (right, bottom) = plot.point((x + 0.5 * dx, z - 0.5 * dz));
        // A little larger, so that no seams show between neighbours.
        let rect = Rect { x: left, y: top, width: right - left + 0.4, height: bottom - top + 0.4 };
        svg.rect(&rect, &format!(r#"fill="{fill}""#));
    }
}

/// Pieces of the line of a score (marching triangles): each square of four neighbours is two triangles, and on each the
/// score is a plane.
pub(super) fn contour(map: &ScoreMap, level: f64) -> Vec<(Point, Point)> {
    let columns = map.grid.x_m.len();
    let corner = |((x, z), cell): ((f64, f64), &Cell)| match cell {
        Cell::Scored { score, .. } => Some((x, z, *score)),
        Cell::Here | Cell::Failed(_) => None,
    };
    let corners: Vec<Option<(f64, f64, f64)>> = map.points().zip(&map.cells).map(corner).collect();
    let mut pieces = Vec::new();
    for row in 0..map.grid.z_m.len().saturating_sub(1) {
        for column in 0..columns.saturating_sub(1) {
            let a = row * columns + column;
            let [Some(a), Some(b), Some(c), Some(d)] =
                [a, a + 1, a + columns, a + columns + 1].map(|i| corners.get(i).copied().flatten())
            else {
                continue;
            };
            for triangle in [[a, b, d], [a, d, c]] {
                let crossing = |(p, q): (usize, usize)| {
                    let (p, q) = (triangle[p], triangle[q]);
                    ((p.2 < level) != (q.2 < level)).then(|| {
                        let part = (level - p.2) / (q.2 - p.2);
                        (p.0 + (q.0 - p.0) * part, p.1 + (q.1 - p.1) * part)
                    })
                };
                let found: Vec<Point> = [(0, 1), (1, 2), (2, 0)].into_iter().filter_map(crossing).collect();
                if let [from, to] = found[..] {
                    pieces.push((from, to));
                }
            }
        }
    }
    pieces
}

fn scale(svg: &mut Svg, map_rect: &Rect, colours: Range, step: f64, map: &ScoreMap) {
    const BANDS: u32 = 120;
    let rect = Rect { x: map_rect.right() + 28.0, y: map_rect.y, width: 22.0, height: map_rect.height };
    let bar = Plot { rect, x: Range { low: 0.0, high: 1.0 }, y: colours };
    for i in 0..BANDS {
        let at = |i: u32| colours.low + colours.span() * f64::from(i) / f64::from(BANDS);
        let (top, bottom) = (bar.y(at(i + 1)), bar.y(at(i)));
        let band = Rect { y: top, height: bottom - top + 0.4, ..rect };
        svg.rect(&band, &format!(r#"fill="{}""#, colour(colours, 0.5 * (at(i) + at(i + 1)))));
    }
    bar.frame(svg);
    let small = TextStyle::new(SMALL_SIZE, INK);
    for value in ticks(colours, step) {
        let y = bar.y(value);
        svg.line((rect.right(), y), (rect.right() + 5.0, y), &format!(r#"stroke="{INK}""#));
        svg.text((rect.right() + 9.0, y + 5.0), &tick_label(value, step), small);
    }
    let middle = rect.y + 0.5 * rect.height;
    svg.text_upwards((rect.right() + 60.0, middle), "T / T*", TextStyle::new(TEXT_SIZE, INK));
    let most = map.scores().map(|(_, _, score)| score).fold(0.0, f64::max);
    if most > colours.high {
        let style = TextStyle::new(SMALL_SIZE, MUTED).anchored(Anchor::Middle);
        svg.text((rect.x + 11.0, rect.y - 8.0), &format!("up to {most:.2}"), style);
    }
}

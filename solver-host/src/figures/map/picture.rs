//! The map's picture: the quadrant, its part near the origin, and the list of structures.

use super::badge::{Badge, distance};
use super::{Chart, contour};
use crate::drawing::axis::Range;
use crate::drawing::legend::{self, Key};
use crate::drawing::page;
use crate::drawing::plot::{Axes, Plot};
use crate::drawing::style::{AXIS_BELOW, AXIS_LEFT, INK, MARGIN, MUTED, PAPER, SMALL_SIZE, WIDTH};
use crate::drawing::svg::{Anchor, Point, Rect, Svg, TextStyle};
use crate::solver::sweep::Structure;

/// Tints of regions: those without a turn in turn, then those with one.
const WITHOUT_TURN: [&str; 8] =
    ["#d6e6f4", "#f6f0cf", "#d3ebe0", "#e8e3f1", "#eaf2fa", "#fbf8e6", "#e6f4ee", "#f3f0f8"];
const WITH_TURN: [&str; 4] = ["#f9dcc9", "#f3c6b4", "#fbe9de", "#eeb49d"];
/// Tint of regions without a number.
const SLIVER: &str = "#ffffff";
/// Lines of equal T are this far apart, s; every second one is named.
const LEVEL_S: f64 = 0.1;

/// A structure with a number on a chart.
struct Listed<'a> {
    structure: &'a Structure,
    fill: &'static str,
    /// Where its number stands on the two charts.
    badges: [Option<Badge>; 2],
}

/// Title, SVG, and how many structures have a number.
pub(super) fn draw(charts: &[Chart; 2]) -> (String, String, usize) {
    let title = "Duration T(x, z) of the fastest maneuver, and its structure".to_owned();
    let lines = [
        "From rest at the origin to rest at (x, z). The other quadrants are mirror images, T(x, z) = T(|x|, |z|): below z = 0 the same maneuvers fly backwards."
            .to_owned(),
    ];
    let mut svg = Svg::default();
    let y = page::heading(&mut svg, WIDTH, &title, &lines);
    let keys = [
        Key::line(&format!(r#"stroke="{INK}" stroke-width="1""#), "equal T (s)"),
        Key::line(
            &format!(r#"stroke="{MUTED}" stroke-width="1.6" stroke-dasharray="5 3""#),
            "structure changes",
        ),
        Key::line(
            &format!(r#"stroke="{PAPER}" stroke-width="2.6""#),
            "number of full turns changes: T has a kink",
        ),
        Key::area(WITH_TURN[0], "reds: one full turn (a flip)"),
        Key::area(WITHOUT_TURN[0], "others: none"),
    ];
    let y = legend::rows(&mut svg, &keys, (MARGIN, WIDTH - MARGIN), y + 34.0);

    let plot = |x: f64, y: f64, width: f64, chart: &Chart| {
        let (x_end, z_end) = (last(&chart.grid.xs), last(&chart.grid.zs));
        Plot {
            rect: Rect { x, y, width, height: width * z_end / x_end },
            x: Range { low: 0.0, high: x_end },
            y: Range { low: 0.0, high: z_end },
        }
    };
    let left = MARGIN + AXIS_LEFT;
    let whole = plot(left, y + 22.0, WIDTH - MARGIN - left, &charts[0]);
    let detail = plot(left, whole.rect.bottom() + AXIS_BELOW + 46.0, 560.0, &charts[1]);
    let plots = [whole, detail];
    let (listed, unlisted) = list(charts, &plots);
    for (which, name) in ["whole", "detail"].into_iter().enumerate() {
        chart(&mut svg, (&charts[which], &plots[which]), (&listed, which), name);
    }
    let rect = detail.rect;
    let heading = TextStyle::new(SMALL_SIZE, MUTED).bold();
    svg.text((rect.x, rect.y - 8.0), "near the origin", heading);
    let end = structures(&mut svg, &listed, unlisted, (rect.right() + 44.0, rect.y));
    let bottom = (rect.bottom() + AXIS_BELOW).max(end) + MARGIN;
    (title.clone(), page::document(WIDTH, bottom, &title, &lines[0], svg), listed.len())
}

fn last(values: &[f64]) -> f64 {
    values.last().copied().unwrap_or(1.0)
}

/// The structures that have a number on one of the charts, those with the largest regions first, and how many have none.
fn list<'a>(charts: &'a [Chart; 2], plots: &[Plot; 2]) -> (Vec<Listed<'a>>, usize) {
    let mut all: Vec<(&Structure, f64)> = Vec::new();
    for chart in charts {
        for (structure, outlines) in chart.grid.structures.iter().zip(&chart.division.regions) {
            let covered: f64 = outlines.iter().map(|o| area(o)).sum();
            match all.iter_mut().find(|(s, _)| *s == structure) {
                Some((_, sum)) => *sum += covered,
                None if covered > 0.0 => all.push((structure, covered)),
                None => {}
            }
        }
    }
    all.sort_by(|a, b| b.1.total_cmp(&a.1));
    let (mut counts, mut unlisted) = ([0_usize; 2], 0);
    let mut listed: Vec<Listed<'a>> = Vec::new();
    for (structure, _) in all {
        let mut badges = [None; 2];
        for (which, (chart, plot)) in charts.iter().zip(plots).enumerate() {
            let taken: Vec<Point> = listed.iter().filter_map(|l| Some(l.badges[which]?.at)).collect();
            // Beside its region only on the last chart, and only if it has no place on another.
            let beside = which == 1 && badges[0].is_none();
            badges[which] = Badge::place(chart, plot, structure, &taken, beside);
        }
        if badges.iter().all(Option::is_none) {
            unlisted += 1;
            continue;
        }
        let tints: &[&'static str] = if structure.turns == 0 { &WITHOUT_TURN } else { &WITH_TURN };
        let count = &mut counts[usize::from(structure.turns != 0)];
        listed.push(Listed { structure, fill: tints[*count % tints.len()], badges });
        *count += 1;
    }
    (listed, unlisted)
}

fn area(outline: &[(f64, f64)]) -> f64 {
    0.5 * outline.windows(2).map(|p| p[0].0 * p[1].1 - p[1].0 * p[0].1).sum::<f64>()
}

fn chart(svg: &mut Svg, (chart, plot): (&Chart, &Plot), (listed, which): (&[Listed<'_>], usize), name: &str) {
    let grid = &chart.grid;
    plot.axes(svg, &Axes { x: Some("x (m)"), y: "z (m)" });
    plot.clipped(svg, name, |svg| {
        svg.open_group(r#"class="regions" shape-rendering="crispEdges""#);
        for (structure, outlines) in grid.structures.iter().zip(&chart.division.regions) {
            let fill = listed.iter().find(|l| l.structure == structure).map_or(SLIVER, |l| l.fill);
            if !outlines.is_empty() {
                let outlines: Vec<Vec<Point>> =
                    outlines.iter().map(|o| plot.points(o.iter().copied())).collect();
                svg.area(&outlines, &format!(r#"fill="{fill}""#));
            }
        }
        svg.close_group();
        for (a, b, line) in &chart.division.borders {
            let kink = grid.structures[*a].turns != grid.structures[*b].turns;
            let style = if kink {
                format!(r#"class="kink" stroke="{PAPER}" stroke-width="2.6""#)
            } else {
                format!(r#"class="change" stroke="{MUTED}" stroke-width="1.6" stroke-dasharray="5 3""#)
            };
            svg.curve(&plot.points(line.iter().copied()), &style);
        }
        let badges: Vec<(usize, Badge)> =
            listed.iter().enumerate().filter_map(|(i, l)| Some((i + 1, l.badges[which]?))).collect();
        let taken: Vec<Point> = badges.iter().map(|(_, badge)| badge.at).collect();
        levels(svg, chart, plot, &taken);
        for (number, badge) in badges {
            badge.draw(svg, number);
        }
    });
    plot.frame(svg);
}

/// Lines of equal T, every second one named where it crosses the diagonal of the plot.
fn levels(svg: &mut Svg, chart: &Chart, plot: &Plot, taken: &[Point]) {
    let longest = (0..chart.grid.nodes.len()).map(|n| chart.grid.duration_s(n)).fold(0.0, f64::max);
    let count = (longest / LEVEL_S).floor() as u32;
    for i in 1..=count {
        let named = i % 2 == 0;
        let width = if named { 1.3 } else { 0.6 };
        for line in contour::lines(&chart.grid, f64::from(i) * LEVEL_S) {
            let points = plot.points(line);
            svg.curve(&points, &format!(r#"class="level" stroke="{INK}" stroke-width="{width}""#));
            let corner = (plot.rect.x, plot.rect.bottom());
            if named
                && let Some(at) = on_diagonal(&points, plot)
                && distance(at, corner) > 64.0
                && taken.iter().all(|badge| distance(at, *badge) > 28.0)
            {
                svg.level_name((at.0, at.1 + 5.0), &format!("{:.1}", f64::from(i) * LEVEL_S));
            }
        }
    }
}

fn on_diagonal(points: &[Point], plot: &Plot) -> Option<Point> {
    let rect = plot.rect;
    let above = |p: &Point| (rect.bottom() - p.1) * rect.width - (p.0 - rect.x) * rect.height;
    points.windows(2).find(|pair| (above(&pair[0]) > 0.0) != (above(&pair[1]) > 0.0)).map(|pair| pair[0])
}

/// The list of structures, in the words of `mintime fly`. Returns its lower edge.
fn structures(svg: &mut Svg, listed: &[Listed<'_>], unlisted: usize, (x, top): Point) -> f64 {
    let mut y = top + 4.0;
    svg.text((x, y), "structures: pitch rate and thrust, in order", TextStyle::new(SMALL_SIZE, MUTED).bold());
    for (i, entry) in listed.iter().enumerate() {
        y += 27.0;
        let tint = Rect { x, y: y - 15.0, width: 30.0, height: 20.0 };
        svg.rect(&tint, &format!(r#"fill="{}" stroke="{MUTED}" stroke-width="0.6""#, entry.fill));
        let middle = TextStyle::new(SMALL_SIZE, INK).anchored(Anchor::Middle).bold();
        svg.text((x + 15.0, y), &(i + 1).to_string(), middle);
        let words = entry.structure.to_string().replace('-', "−");
        svg.text((x + 40.0, y), &words, TextStyle::new(SMALL_SIZE, INK));
    }
    y += 34.0;
    let more = format!("{unlisted} more have slivers along the lines: see map.csv.");
    for line in [
        "+ and − turn forward and back at the limit, s is a singular arc;",
        "max and min are the thrust.",
        more.as_str(),
    ] {
        svg.text((x, y), line, TextStyle::new(SMALL_SIZE, MUTED));
        y += 20.0;
    }
    y
}

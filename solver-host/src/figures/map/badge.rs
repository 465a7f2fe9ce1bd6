//! Where a structure's number goes on the map.

use super::Chart;
use crate::drawing::plot::Plot;
use crate::drawing::style::{INK, SMALL_SIZE};
use crate::drawing::svg::{Anchor, Point, Svg, TextStyle};
use crate::solver::sweep::Structure;

/// Room that a badge needs around its middle, page units.
const ROOM: f64 = 12.0;
/// A region at least this far from its border somewhere is worth a badge beside it, page units.
const SEEN: f64 = 2.0;

/// A number on the map.
#[derive(Clone, Copy, Debug)]
pub(super) struct Badge {
    /// Its middle.
    pub(super) at: Point,
    /// The place it is about, within the region.
    about: Point,
}

impl Badge {
    /// In the structure's region where that is widest. In a region too small for it: beside it, if `beside`, and clear of
    /// the badges `taken`.
    pub(super) fn place(
        chart: &Chart,
        plot: &Plot,
        structure: &Structure,
        taken: &[Point],
        beside: bool,
    ) -> Option<Self> {
        let own = chart.grid.structures.iter().position(|s| s == structure)?;
        let borders = |of: &dyn Fn(usize) -> bool| -> Vec<Point> {
            let lines = chart.division.borders.iter().filter(|b| of(b.0) || of(b.1));
            lines.flat_map(|b| plot.points(b.2.iter().copied())).collect()
        };
        let rect = plot.rect;
        let frame =
            |p: Point| (p.0 - rect.x).min(rect.right() - p.0).min(p.1 - rect.y).min(rect.bottom() - p.1);
        let room = |p: Point, rim: &[Point]| rim.iter().map(|q| distance(p, *q)).fold(frame(p), f64::min);
        let rim = borders(&|s| s == own);
        let (most, about) = chart
            .grid
            .nodes
            .iter()
            .enumerate()
            .filter(|(_, node)| node.structure == own)
            .map(|(i, _)| plot.point(chart.grid.place(i)))
            .map(|p| (room(p, &rim), p))
            .max_by(|a, b| a.0.total_cmp(&b.0))?;
        if most >= ROOM {
            return Some(Self { at: about, about });
        }
        if !beside || most < SEEN {
            return None;
        }
        let everywhere: Vec<Point> = borders(&|_| true).into_iter().chain(taken.iter().copied()).collect();
        (0..16)
            .map(|i| (f64::from(i) * std::f64::consts::TAU / 16.0).sin_cos())
            .flat_map(|(sin, cos)| [30.0, 45.0].map(|r| (about.0 + r * cos, about.1 + r * sin)))
            .filter(|p| frame(*p) >= ROOM && taken.iter().all(|t| distance(*t, *p) > 2.2 * ROOM))
            .map(|p| (room(p, &everywhere), p))
            .max_by(|a, b| a.0.total_cmp(&b.0))
            .map(|(_, at)| Self { at, about })
    }

    pub(super) fn draw(&self, svg: &mut Svg, number: usize) {
        svg.line(self.at, self.about, &format!(r#"stroke="{INK}" stroke-width="1""#));
        svg.circle(self.at, 11.0, &format!(r##"fill="#ffffff" stroke="{INK}" stroke-width="1.2""##));
        let style = TextStyle::new(SMALL_SIZE, INK).anchored(Anchor::Middle).bold();
        svg.text((self.at.0, self.at.1 + 5.0), &number.to_string(), style);
    }
}

pub(super) fn distance(a: Point, b: Point) -> f64 {
    (a.0 - b.0).hypot(a.1 - b.1)
}

//! Where everything goes on the page. A path that is not much wider than high stands on the left, with the time
//! panels stacked on its right; a wide one lies on top, with the time panels two by two below.

use super::path_panel::Extent;
use crate::drawing::style::{AXIS_BELOW, AXIS_LEFT, MARGIN, ROW, STRIP, WIDTH};
use crate::drawing::svg::Rect;

/// Plot areas, axis labels not included.
#[derive(Debug)]
pub(super) struct Layout {
    /// Height of the picture.
    pub(super) height: f64,
    /// The vertical plane.
    pub(super) path: Rect,
    /// The four time panels, and whether each carries the labels of the time axis.
    pub(super) time: [(Rect, bool); 4],
    /// The table of facts.
    pub(super) facts: Rect,
    /// Columns of the table.
    pub(super) columns: usize,
}

/// Paths wider than this many times their height lie on top.
const WIDE: f64 = 1.7;
/// Space the vehicle drawings need around the path.
pub(super) const PATH_PADDING: f64 = 44.0;

impl Layout {
    /// The layout below a header that ends at `top`.
    pub(super) fn new(top: f64, extent: &Extent, facts: usize) -> Self {
        if extent.width() > WIDE * extent.height() {
            wide(top, extent, facts)
        } else {
            tall(top, extent, facts)
        }
    }
}

fn tall(top: f64, extent: &Extent, facts: usize) -> Layout {
    const PANEL: f64 = 148.0;
    let table = facts as f64 * ROW;
    let gap = STRIP + 12.0;
    let stacked = 4.0 * PANEL + 3.0 * gap;
    // The path panel is at least square-ish beside a long table; the page grows then.
    let path_top = top + STRIP;
    let table_space = if facts == 0 { 0.0 } else { table + 16.0 };
    let path_height = (stacked - table_space).max(380.0);
    let inner = path_height - 2.0 * PATH_PADDING;
    let path_width = (inner * extent.width() / extent.height() + 2.0 * PATH_PADDING).clamp(300.0, 540.0);
    let path = Rect { x: MARGIN + AXIS_LEFT, y: path_top, width: path_width, height: path_height };
    let facts_rect =
        Rect { x: MARGIN, y: path.bottom() + AXIS_BELOW + 16.0, width: path.right() - MARGIN, height: table };

    let x = path.right() + 36.0 + AXIS_LEFT;
    let width = WIDTH - MARGIN - x;
    let panel = (PANEL).max((path_height + table_space - 3.0 * gap) / 4.0);
    let time = [0.0, 1.0, 2.0, 3.0]
        .map(|i| (Rect { x, y: path_top + i * (panel + gap), width, height: panel }, i > 2.5));
    let bottom = time[3].0.bottom() + AXIS_BELOW;
    Layout { height: bottom.max(facts_rect.bottom()) + MARGIN, path, time, facts: facts_rect, columns: 1 }
}

fn wide(top: f64, extent: &Extent, facts: usize) -> Layout {
    const PANEL: f64 = 168.0;
    let width = WIDTH - 2.0 * MARGIN - AXIS_LEFT;
    let inner = (width - 2.0 * PATH_PADDING) * extent.height() / extent.width();
    let height = (inner + 2.0 * PATH_PADDING).clamp(170.0, 420.0);
    let path = Rect { x: MARGIN + AXIS_LEFT, y: top, width, height };

    let columns_top = path.bottom() + AXIS_BELOW + STRIP + 22.0;
    let between = 30.0 + AXIS_LEFT;
    let half = 0.5 * (width - between);
    let lower = columns_top + PANEL + STRIP + 14.0;
    let right = path.x + half + between;
    let panel = |x, y| Rect { x, y, width: half, height: PANEL };
    let time = [
        (panel(path.x, columns_top), false),
        (panel(right, columns_top), false),
        (panel(path.x, lower), true),
        (panel(right, lower), true),
    ];
    let columns = 3;
    let rows = facts.div_ceil(columns);
    let facts_rect = Rect {
        x: MARGIN,
        y: lower + PANEL + AXIS_BELOW + 18.0,
        width: WIDTH - 2.0 * MARGIN,
        height: rows as f64 * ROW,
    };
    Layout { height: facts_rect.bottom() + MARGIN, path, time, facts: facts_rect, columns }
}

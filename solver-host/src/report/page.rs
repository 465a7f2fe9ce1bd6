//! The whole page: header, legend, panels, table of facts.

use super::data::ReportData;
use super::layout::Layout;
use super::path_panel::{self, Extent};
use super::view::View;
use super::{quantities, time_panel, vehicle};
use crate::drawing::legend::{self, Key};
use crate::drawing::page;
use crate::drawing::style::{
    FLOWN, FRAME, GHOST, INK, LIMIT, MARGIN, MUTED, ROW, SINGULAR, SWITCHING, TEXT_SIZE, WIDTH,
};
use crate::drawing::svg::{Anchor, Svg, TextStyle, fit, px, text_width};

/// The picture as SVG text.
pub(super) fn draw(data: &ReportData) -> String {
    let view = View::new(data);
    let extent = Extent::of(&view);
    let mut body = Svg::default();
    let top = header(&mut body, data, &view);
    let layout = Layout::new(top, &extent, data.facts.len());

    let largest = view.planned.iter().filter_map(|i| i.thrust_mps2).fold(1e-3, f64::max);
    let thrust_max = data.limits.thrust_max_mps2;
    let thrust_max = if thrust_max.is_finite() && thrust_max > 0.0 { thrust_max } else { largest };
    body.open_group(r#"class="path""#);
    path_panel::draw(&mut body, &view, &extent, layout.path, thrust_max);
    body.close_group();
    for (panel, (rect, labelled)) in quantities::panels(data, &view, extent.unit()).iter().zip(layout.time) {
        time_panel::draw(&mut body, &view, panel, rect, labelled);
    }
    facts(&mut body, data, &layout);

    page::document(WIDTH, layout.height, &data.title, &data.subtitle.join(" "), body)
}

/// Title, subtitle and legend. Returns where the panels may begin.
fn header(svg: &mut Svg, data: &ReportData, view: &View) -> f64 {
    let y = page::heading(svg, WIDTH, &data.title, &data.subtitle);
    legend(svg, data, view, y + 32.0) + 24.0
}

/// A row of keys, wrapped where it is full. Returns its lowest base line.
fn legend(svg: &mut Svg, data: &ReportData, view: &View, y: f64) -> f64 {
    let line = |colour: &str, width: f64, dashes: &str, text: &str| {
        Key::line(&format!(r#"stroke="{colour}" stroke-width="{width}" {dashes}"#), text)
    };
    let mut keys = Vec::new();
    let planned = line(INK, 1.8, "", "planned");
    if view.flown.is_empty() {
        keys.push(planned);
    } else {
        keys.push(planned.over_vehicle(GHOST));
        keys.push(line(FLOWN, 3.0, "", "flown"));
    }
    let colour = if view.flown.is_empty() { INK } else { FLOWN };
    let every = format!("vehicle every {} s, with thrust", px(vehicle::interval_s(view.duration_s)));
    keys.push(Key::vehicle(colour, every));
    keys.push(line(LIMIT, 1.5, r#"stroke-dasharray="7 5""#, "limit"));
    if !view.singular.is_empty() {
        keys.push(Key::area(SINGULAR, "singular arc (s)"));
    }
    if data.planned.iter().any(|p| p.phi_r.is_finite() || p.phi_t.is_finite()) {
        keys.push(line(SWITCHING, 1.6, "", "switching function −Φ, scaled"));
    }
    legend::rows(svg, &keys, (MARGIN, WIDTH - MARGIN), y)
}

fn facts(svg: &mut Svg, data: &ReportData, layout: &Layout) {
    let gap = 36.0;
    let columns = layout.columns.max(1);
    let width = (layout.facts.width - gap * (columns as f64 - 1.0)) / columns as f64;
    let rows = data.facts.len().div_ceil(columns);
    svg.open_group(r#"class="facts""#);
    for (i, (label, value)) in data.facts.iter().enumerate() {
        let (column, row) = (i / rows.max(1), i % rows.max(1));
        let x = layout.facts.x + column as f64 * (width + gap);
        let y = layout.facts.y + row as f64 * ROW;
        let value = fit(value, TEXT_SIZE, 0.6 * width);
        let space = width - text_width(&value, TEXT_SIZE) - 12.0;
        svg.text((x, y + 18.0), &fit(label, TEXT_SIZE, space), TextStyle::new(TEXT_SIZE, MUTED));
        let right = TextStyle::new(TEXT_SIZE, INK).anchored(Anchor::End).bold();
        svg.text((x + width, y + 18.0), &value, right);
        svg.line((x, y + ROW), (x + width, y + ROW), &format!(r#"stroke="{FRAME}" stroke-width="0.6""#));
    }
    svg.close_group();
}

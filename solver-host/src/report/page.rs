//! The whole page: header, legend, panels, table of facts.

use super::data::ReportData;
use super::layout::Layout;
use super::path_panel::{self, Extent};
use super::style::{
    FLOWN, FONT, FRAME, GHOST, INK, LIMIT, MARGIN, MUTED, ROW, SINGULAR, SWITCHING, TEXT_SIZE, TITLE_SIZE,
    WIDTH,
};
use super::svg::{Anchor, Rect, Svg, TextStyle, escape, fit, px, text_width};
use super::view::View;
use super::{quantities, time_panel, vehicle};

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

    let mut page = Svg::default();
    let (width, height) = (px(WIDTH), px(layout.height));
    page.raw(&format!(
        r#"<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" viewBox="0 0 {width} {height}" font-family="{FONT}" role="img">"#
    ));
    page.raw(&format!("<title>{}</title>", escape(&data.title)));
    page.raw(&format!("<desc>{}</desc>", escape(&data.subtitle.join(" "))));
    page.raw(&format!("<defs>{}</defs>", vehicle::DEFINITION));
    page.rect(&Rect { x: 0.0, y: 0.0, width: WIDTH, height: layout.height }, "fill=\"#ffffff\"");
    page.raw(&body.finish());
    page.raw("</svg>");
    page.finish()
}

/// Title, subtitle and legend. Returns where the panels may begin.
fn header(svg: &mut Svg, data: &ReportData, view: &View) -> f64 {
    let width = WIDTH - 2.0 * MARGIN;
    let mut y = MARGIN + 20.0;
    svg.text((MARGIN, y), &fit(&data.title, TITLE_SIZE, width), TextStyle::new(TITLE_SIZE, INK).bold());
    for line in &data.subtitle {
        y += 25.0;
        svg.text((MARGIN, y), &fit(line, TEXT_SIZE, width), TextStyle::new(TEXT_SIZE, MUTED));
    }
    legend(svg, data, view, y + 32.0) + 24.0
}

/// A row of keys, wrapped where it is full. Returns its lowest base line.
fn legend(svg: &mut Svg, data: &ReportData, view: &View, mut y: f64) -> f64 {
    let line = |colour: &str, width: f64, dashes: &str| {
        format!(r#"<path d="M0 -5H34" fill="none" stroke="{colour}" stroke-width="{width}" {dashes}/>"#)
    };
    let small = |colour: &str| {
        format!(
            r##"<g transform="translate(17 -2) scale(30)" stroke="{colour}"><use href="#vehicle"/><path d="M0 0V-.5" stroke-width=".045"/></g>"##
        )
    };
    let mut keys = vec![(line(INK, 1.8, ""), "planned".to_owned())];
    if !view.flown.is_empty() {
        keys[0].0.insert_str(0, &small(GHOST));
        keys.push((line(FLOWN, 3.0, ""), "flown".to_owned()));
    }
    let colour = if view.flown.is_empty() { INK } else { FLOWN };
    let every = format!("vehicle every {} s, with thrust", px(vehicle::interval_s(view.duration_s)));
    keys.push((small(colour), every));
    keys.push((line(LIMIT, 1.5, r#"stroke-dasharray="7 5""#), "limit".to_owned()));
    if !view.singular.is_empty() {
        let tint =
            format!(r##"<rect x="0" y="-13" width="34" height="16" fill="{SINGULAR}" stroke="{FRAME}"/>"##);
        keys.push((tint, "singular arc (s)".to_owned()));
    }
    if data.planned.iter().any(|p| p.phi_r.is_finite() || p.phi_t.is_finite()) {
        let text = "switching function −Φ, scaled".to_owned();
        keys.push((line(SWITCHING, 1.6, ""), text));
    }
    let mut x = MARGIN;
    for (drawing, text) in keys {
        let width = 42.0 + text_width(&text, TEXT_SIZE);
        if x > MARGIN && x + width > WIDTH - MARGIN {
            x = MARGIN;
            y += 26.0;
        }
        svg.raw(&format!(r#"<g transform="translate({} {})">{drawing}</g>"#, px(x), px(y)));
        svg.text((x + 42.0, y), &text, TextStyle::new(TEXT_SIZE, INK));
        x += width + 24.0;
    }
    y
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

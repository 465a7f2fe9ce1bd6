//! A whole SVG document around what was drawn, and its heading.

use super::style::{FONT, INK, MARGIN, MUTED, TEXT_SIZE, TITLE_SIZE};
use super::svg::{Rect, Svg, TextStyle, escape, fit, px};
use super::symbol;

/// The document: white, `width` by `height` units, described for those who cannot see it.
pub(crate) fn document(width: f64, height: f64, title: &str, description: &str, body: Svg) -> String {
    let mut page = Svg::default();
    let (w, h) = (px(width), px(height));
    page.raw(&format!(
        r#"<svg xmlns="http://www.w3.org/2000/svg" width="{w}" height="{h}" viewBox="0 0 {w} {h}" font-family="{FONT}" role="img">"#
    ));
    page.raw(&format!("<title>{}</title>", escape(title)));
    // A description has no subscripts.
    page.raw(&format!("<desc>{}</desc>", escape(&description.replace("_{", "_").replace('}', ""))));
    page.raw(&format!("<defs>{}</defs>", symbol::DEFINITION));
    page.rect(&Rect { x: 0.0, y: 0.0, width, height }, "fill=\"#ffffff\"");
    page.raw(&body.finish());
    page.raw("</svg>");
    page.finish()
}

/// Title and lines below it, across a page of this width. Returns the base line of the last.
pub(crate) fn heading(svg: &mut Svg, page_width: f64, title: &str, lines: &[String]) -> f64 {
    let width = page_width - 2.0 * MARGIN;
    let mut y = MARGIN + 20.0;
    svg.text((MARGIN, y), &fit(title, TITLE_SIZE, width), TextStyle::new(TITLE_SIZE, INK).bold());
    for line in lines {
        y += 25.0;
        svg.text((MARGIN, y), &fit(line, TEXT_SIZE, width), TextStyle::new(TEXT_SIZE, MUTED));
    }
    y
}

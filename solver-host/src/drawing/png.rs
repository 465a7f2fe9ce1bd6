//! SVG text to PNG, with an embedded font: the same pixels on every machine, with or without fonts of its own.

use std::sync::{Arc, LazyLock};

use resvg::tiny_skia::{Pixmap, Transform};
use resvg::usvg::{Options, Tree, fontdb};

use super::PictureError;

/// Pixels per SVG unit: sharp when a page shows the picture at half its size.
pub const PNG_SCALE: f32 = 2.0;

static FONTS: LazyLock<Arc<fontdb::Database>> = LazyLock::new(|| {
    let mut fonts = fontdb::Database::new();
    fonts.load_font_data(ttf_noto_sans::REGULAR.to_vec());
    fonts.load_font_data(ttf_noto_sans::BOLD.to_vec());
    fonts.set_sans_serif_family("Noto Sans");
    Arc::new(fonts)
});

/// The picture as a PNG file of [`PNG_SCALE`] times its size.
pub(crate) fn encode(svg: &str) -> Result<Vec<u8>, PictureError> {
    let rendering = |reason: String| PictureError::Rendering { reason };
    let tree = parse(svg).map_err(rendering)?;
    let size = tree.size().to_int_size().scale_by(PNG_SCALE);
    let pixmap = size.and_then(|size| Pixmap::new(size.width(), size.height()));
    let mut pixmap = pixmap.ok_or_else(|| rendering("it is too large".to_owned()))?;
    resvg::render(&tree, Transform::from_scale(PNG_SCALE, PNG_SCALE), &mut pixmap.as_mut());
    pixmap.encode_png().map_err(|error| rendering(error.to_string()))
}

pub(crate) fn parse(svg: &str) -> Result<Tree, String> {
    let options =
        Options { fontdb: FONTS.clone(), font_family: "Noto Sans".to_owned(), ..Options::default() };
    Tree::from_str(svg, &options).map_err(|error| error.to_string())
}

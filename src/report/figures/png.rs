//! SVG to PNG, the same bytes on every machine: with the font that comes with the program, and no other.

use std::sync::Arc;

use resvg::tiny_skia::{Pixmap, Transform};
use resvg::usvg::fontdb::Database;
use resvg::usvg::{Options, Tree};

use super::canvas::{PictureError, failed};
use super::metrics::FONT;

/// Pixels of the PNG for one of the SVG: at 96 pixels an inch, 192 dots an inch.
const SCALE: u16 = 2;

/// The picture as PNG, twice as many pixels wide and high as the SVG says.
///
/// Fonts of the machine are not looked at, so that the bytes depend on the picture alone.
///
/// ```
/// let svg = knotproof::report::figures::figure("fig4").map(|figure| figure.svg());
/// let png = knotproof::report::figures::png(&svg.ok_or("there is no Fig. 4")??)?;
/// assert!(png.starts_with(b"\x89PNG"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`PictureError`] if the text is no SVG, or one without a size.
pub fn png(svg: &str) -> Result<Vec<u8>, PictureError> {
    let mut fonts = Database::new();
    fonts.load_font_data(FONT.to_vec());
    let options = Options { fontdb: Arc::new(fonts), ..Options::default() };
    let tree = Tree::from_str(svg, &options).map_err(failed)?;
    let scale = f32::from(SCALE);
    let size = tree.size().scale_by(scale).ok_or_else(|| failed("the SVG has no size"))?.to_int_size();
    let mut pixels = Pixmap::new(size.width(), size.height()).ok_or_else(|| failed("the SVG has no size"))?;
    resvg::render(&tree, Transform::from_scale(scale, scale), &mut pixels.as_mut());
    pixels.encode_png().map_err(failed)
}

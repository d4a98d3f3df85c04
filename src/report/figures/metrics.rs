//! How much room a text takes, by the font that comes with the program.
//!
//! A browser that has not got the font takes another one; those that [`FONTS`](super::canvas) names are no wider.

use skrifa::instance::{LocationRef, Size};
use skrifa::{FontRef, MetadataProvider};

/// DejaVu Sans, reduced to the characters that the figures need.
pub(super) const FONT: &[u8] = include_bytes!("font/DejaVuSans-subset.ttf");

/// The ink of a text in pixels: from its origin to both sides, and from its base line up and down.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Ink {
    pub(super) width: f64,
    pub(super) above: f64,
    pub(super) below: f64,
}

/// What a character takes that the font has not got, in em: as much as its widest.
const UNKNOWN: f64 = 1.0;

/// The ink of a text of this size.
pub(super) fn ink(text: &str, size: u32) -> Ink {
    let em = f64::from(size);
    let font = FontRef::new(FONT).ok();
    // In units of an em.
    let metrics = font
        .as_ref()
        .map(|font| (font.charmap(), font.glyph_metrics(Size::new(1.0), LocationRef::default())));
    let mut ink = Ink { width: 0.0, above: 0.0, below: 0.0 };
    for c in text.chars() {
        let found = metrics.as_ref().and_then(|(map, metrics)| {
            let glyph = map.map(c)?;
            Some((metrics.advance_width(glyph)?, metrics.bounds(glyph)))
        });
        let (advance, bounds) =
            found.map_or((UNKNOWN, None), |(advance, bounds)| (f64::from(advance), bounds));
        ink.width += advance * em;
        if let Some(bounds) = bounds {
            ink.above = ink.above.max(f64::from(bounds.y_max) * em);
            ink.below = ink.below.max(f64::from(-bounds.y_min) * em);
        }
    }
    ink
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn digits_are_as_wide_as_each_other_and_letters_go_below_the_line() {
        let (digits, index, letter) = (ink("1111", 20), ink("G₂", 20), ink("p", 20));
        assert_eq!(digits, ink("7777", 20));
        assert!(digits.width > 40.0 && digits.width < 60.0 && digits.below == 0.0, "{digits:?}");
        assert!(letter.below > 3.0 && index.below < 1.0 && index.above > 10.0, "{letter:?}, {index:?}");
        assert!((ink("G₂", 40).width / index.width - 2.0).abs() < 1e-6);
    }
}

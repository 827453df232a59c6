//! The typeface of text in pictures: DejaVu Sans Mono, which is compiled into the program, so that
//! pictures have the same bytes on every machine.
use ab_glyph::{Font, FontRef, GlyphId, PxScale, point};

const FILE: &[u8] = include_bytes!("../fonts/dejavu-sans-mono.ttf");

/// The typeface in one size.
pub struct Typeface {
    font: FontRef<'static>,
    scale: PxScale,
    /// Distance from one character to the next, in pixels.
    advance: u32,
}

impl Typeface {
    /// The size in which characters are `advance` pixels apart: whole pixels, so that equal
    /// characters look equal. Capitals are then 1.21 times as high.
    pub fn new(advance: u32) -> Typeface {
        let font =
            FontRef::try_from_slice(FILE).expect("the file is in the program, and a test reads it");
        let per_pixel = font.height_unscaled() / font.h_advance_unscaled(font.glyph_id('0'));
        Typeface { font, scale: PxScale::from(per_pixel * advance as f32), advance }
    }

    /// Calls `put` for each pixel of a text with its distance from the text's beginning, its
    /// distance below the base line, and the share of the pixel that is inked, from 0 to 1.
    /// Characters that the typeface lacks are drawn as boxes.
    pub fn ink(&self, text: &str, mut put: impl FnMut(i64, i64, f32)) {
        for (number, character) in text.chars().enumerate() {
            let begin = number as i64 * i64::from(self.advance);
            self.ink_glyph(self.font.glyph_id(character), &mut |along, down, share| {
                put(begin + along, down, share)
            });
        }
    }

    fn ink_glyph(&self, id: GlyphId, put: &mut dyn FnMut(i64, i64, f32)) {
        let glyph = id.with_scale_and_position(self.scale, point(0.0, 0.0));
        let Some(outline) = self.font.outline_glyph(glyph) else { return };
        let corner = outline.px_bounds().min;
        let (left, top) = (corner.x as i64, corner.y as i64);
        outline.draw(|x, y, share| put(left + i64::from(x), top + i64::from(y), share.min(1.0)));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The pixels of the text: distance from its beginning, distance below the base line, and ink
    /// in tenths.
    fn drawn(text: &str) -> Vec<(i64, i64, u8)> {
        let mut pixels = vec![];
        Typeface::new(7).ink(text, |along, down, share| {
            let tenths = (share * 10.0).round() as u8;
            if tenths > 0 {
                pixels.push((along, down, tenths));
            }
        });
        pixels
    }

    #[test]
    fn characters_stand_on_their_base_line_within_their_cells() {
        for character in (' '..='~').chain(['\u{d7}', '\u{b7}', '\u{2212}', '\u{3b1}', '\u{e4}']) {
            for (along, down, _) in drawn(&character.to_string()) {
                assert!(
                    (0..7).contains(&along) && (-11..3).contains(&down),
                    "{character}: {along}, {down}"
                );
            }
        }
        // A capital's top and foot.
        let rows: Vec<i64> = drawn("H").into_iter().map(|(_, down, _)| down).collect();
        assert_eq!((rows.iter().min(), rows.iter().max()), (Some(&-9), Some(&-1)));
    }

    #[test]
    fn equal_characters_are_equal_and_edges_are_smooth() {
        let moved: Vec<_> =
            drawn("o").into_iter().map(|(along, down, share)| (along + 14, down, share)).collect();
        assert!(drawn("  o") == moved);
        assert!(drawn("o").iter().any(|&(_, _, share)| (2..9).contains(&share)));
    }

    #[test]
    fn what_is_not_there_is_a_box() {
        assert!(!drawn("\u{4e00}").is_empty() && drawn(" ").is_empty());
    }
}

//! Pictures in memory.
use std::ops::Range;

use specula_scene::Span;

/// An 8-bit picture, rows from the top.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Image {
    /// Pixels across.
    pub width: u32,
    /// Pixels down.
    pub height: u32,
    /// Red, green and blue of each pixel.
    pub pixels: Vec<[u8; 3]>,
}

impl Image {
    /// A picture of one colour.
    pub fn filled(width: u32, height: u32, colour: [u8; 3]) -> Image {
        Image { width, height, pixels: vec![colour; width as usize * height as usize] }
    }

    /// The pixels that a span covers.
    pub fn run(&self, span: &Span) -> &[[u8; 3]] {
        &self.pixels[self.places(span)]
    }

    /// The same, to be changed.
    pub fn run_mut(&mut self, span: &Span) -> &mut [[u8; 3]] {
        let places = self.places(span);
        &mut self.pixels[places]
    }

    fn places(&self, span: &Span) -> Range<usize> {
        let first = span.y as usize * self.width as usize + span.x as usize;
        first..first + span.length as usize
    }
}

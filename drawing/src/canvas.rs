//! A raster image with rectangles and text.
use image::{Rgb, RgbImage};

use super::typeface::Typeface;

/// Height of a capital in dots; text sizes are multiples of it.
pub const CHARACTER: u32 = 8;
/// Distance from one character to the next, in dots.
const ADVANCE: u32 = 7;

/// An image on which rectangles and text are drawn.
pub struct Canvas {
    image: RgbImage,
    typeface: Typeface,
    /// Pixels for each dot of a character, in both directions.
    dot: u32,
}

impl Canvas {
    /// A canvas of one colour, with `dot` pixels for each dot of a character.
    pub fn new(width: u32, height: u32, colour: Rgb<u8>, dot: u32) -> Canvas {
        Canvas::over(RgbImage::from_pixel(width, height, colour), dot)
    }

    /// A canvas that draws on an existing image.
    pub fn over(image: RgbImage, dot: u32) -> Canvas {
        Canvas { image, typeface: Typeface::new(ADVANCE * dot), dot }
    }

    /// Width of a text in pixels.
    pub fn text_width(text: &str, dot: u32) -> u32 {
        text.chars().count() as u32 * ADVANCE * dot
    }

    /// Sets the colour of a pixel; a pixel outside the canvas is ignored.
    pub fn put(&mut self, x: u32, y: u32, colour: Rgb<u8>) {
        if let Some(pixel) = self.image.get_pixel_mut_checked(x, y) {
            *pixel = colour;
        }
    }

    /// Fills a rectangle.
    pub fn fill(&mut self, (x, y): (u32, u32), (width, height): (u32, u32), colour: Rgb<u8>) {
        for row in y..y + height {
            for column in x..x + width {
                self.put(column, row, colour);
            }
        }
    }

    /// Writes text with the upper left corner of its capitals at (x, y).
    pub fn write(&mut self, (x, y): (u32, u32), text: &str, colour: Rgb<u8>) {
        let (left, base) = (i64::from(x), i64::from(y) + i64::from(CHARACTER * self.dot));
        let image = &mut self.image;
        self.typeface.ink(text, |along, down, share| {
            blend(image, (left + along, base + down), colour, share)
        });
    }

    /// Writes text that runs upwards, with the lower left corner of its capitals at (x, y).
    pub fn write_upwards(&mut self, (x, y): (u32, u32), text: &str, colour: Rgb<u8>) {
        let (base, bottom) = (i64::from(x) + i64::from(CHARACTER * self.dot), i64::from(y));
        let image = &mut self.image;
        self.typeface.ink(text, |along, down, share| {
            blend(image, (base + down, bottom - 1 - along), colour, share)
        });
    }

    /// The finished image.
    pub fn finish(self) -> RgbImage {
        self.image
    }
}

/// Mixes `colour` into a pixel with weight `share`, 0 to 1; a pixel outside the image is ignored.
fn blend(image: &mut RgbImage, (x, y): (i64, i64), colour: Rgb<u8>, share: f32) {
    let place = u32::try_from(x).ok().zip(u32::try_from(y).ok());
    let Some(pixel) = place.and_then(|(x, y)| image.get_pixel_mut_checked(x, y)) else { return };
    for (below, above) in pixel.0.iter_mut().zip(colour.0) {
        let (from, to) = (f32::from(*below), f32::from(above));
        *below = (from + (to - from) * share).round() as u8;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const WHITE: Rgb<u8> = Rgb([255; 3]);
    const BLACK: Rgb<u8> = Rgb([0; 3]);

    fn inked(canvas: Canvas) -> Vec<(u32, u32)> {
        let image = canvas.finish();
        image
            .enumerate_pixels()
            .filter(|(_, _, pixel)| **pixel != WHITE)
            .map(|(x, y, _)| (x, y))
            .collect()
    }

    #[test]
    fn words_run_upwards_as_they_run_along() {
        let (mut along, mut up) = (Canvas::new(40, 40, WHITE, 1), Canvas::new(40, 40, WHITE, 1));
        along.write((10, 10), "R 4", BLACK);
        up.write_upwards((10, 40 - 10), "R 4", BLACK);
        let mut turned: Vec<(u32, u32)> =
            inked(along).into_iter().map(|(x, y)| (y, 39 - x)).collect();
        turned.sort_by_key(|&(x, y)| (y, x));
        assert_eq!(turned, inked(up));
    }

    #[test]
    fn words_over_the_edge_are_cut_off() {
        let mut canvas = Canvas::new(8, 8, WHITE, 2);
        canvas.write((4, 0), "W\u{c4}W", BLACK);
        canvas.write_upwards((0, 3), "W\u{c4}W", BLACK);
        assert!(inked(canvas).len() < 64);
    }
}

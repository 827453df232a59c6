//! Pictures next to each other, each with its title above.
use image::{Rgb, RgbImage, imageops};
use specula_testbench::Image;

use specula_drawing::canvas::{CHARACTER, Canvas};

/// A picture with its title.
pub struct Panel {
    title: String,
    picture: RgbImage,
}

const PAPER: Rgb<u8> = Rgb([255, 255, 255]);
const INK: Rgb<u8> = Rgb([40, 40, 40]);
/// Distance around titles and between panels, in pixels.
const ROOM: u32 = CHARACTER;

impl Panel {
    /// A panel of a picture in memory.
    pub fn new(title: impl Into<String>, image: &Image) -> Panel {
        let bytes = image.pixels.as_flattened().to_vec();
        // An image has as many pixels as its width and height say.
        let picture = RgbImage::from_raw(image.width, image.height, bytes).unwrap_or_default();
        Panel { title: title.into(), picture }
    }

    fn width(&self) -> u32 {
        self.picture.width().max(Canvas::text_width(&self.title, 1))
    }
}

/// Draws panels from left to right.
pub fn side_by_side(panels: &[Panel]) -> RgbImage {
    let top = 2 * ROOM + CHARACTER;
    let width = panels.iter().map(|panel| panel.width() + ROOM).sum::<u32>() + ROOM;
    let height = panels.iter().map(|panel| panel.picture.height()).max().unwrap_or(0) + top + ROOM;
    let mut canvas = Canvas::new(width, height, PAPER, 1);
    let mut lefts = Vec::with_capacity(panels.len());
    let mut left = ROOM;
    for panel in panels {
        canvas.write((left, ROOM), &panel.title, INK);
        lefts.push(left);
        left += panel.width() + ROOM;
    }
    let mut sheet = canvas.finish();
    for (panel, left) in panels.iter().zip(lefts) {
        imageops::replace(&mut sheet, &panel.picture, left.into(), top.into());
    }
    sheet
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn panels_stand_beside_each_other_whole() {
        let (red, blue) = ([255, 0, 0], [0, 0, 255]);
        let sheet = side_by_side(&[
            Panel::new("a long title", &Image::filled(4, 3, red)),
            Panel::new("", &Image::filled(20, 5, blue)),
        ]);
        let count = |colour: [u8; 3]| sheet.pixels().filter(|pixel| pixel.0 == colour).count();
        assert_eq!((count(red), count(blue)), (12, 100));
        assert_eq!(sheet.dimensions(), (8 + 7 * 12 + 8 + 20 + 8, 24 + 5 + 8));
    }
}

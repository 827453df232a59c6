//! A drawing of rectangles and words.
use font8x8::legacy::BASIC_LEGACY;
use image::{Rgb, RgbImage};

/// Width and height of a character, in dots.
pub const CHARACTER: u32 = 8;

/// A drawing with words in it.
pub struct Canvas {
    image: RgbImage,
    /// Pixels for each dot of a character.
    dot: u32,
}

impl Canvas {
    /// A drawing of one colour, with `dot` pixels for each dot of a character.
    pub fn new(width: u32, height: u32, colour: Rgb<u8>, dot: u32) -> Canvas {
        Canvas { image: RgbImage::from_pixel(width, height, colour), dot }
    }

    /// A drawing that goes on over an image.
    pub fn over(image: RgbImage, dot: u32) -> Canvas {
        Canvas { image, dot }
    }

    /// Width of a text in pixels.
    pub fn text_width(text: &str, dot: u32) -> u32 {
        text.chars().count() as u32 * CHARACTER * dot
    }

    /// Colours a pixel; one outside the drawing is left out.
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

    /// Writes ASCII text with its upper left corner at (x, y).
    pub fn write(&mut self, (x, y): (u32, u32), text: &str, colour: Rgb<u8>) {
        for (number, character) in text.chars().enumerate() {
            let left = x + number as u32 * CHARACTER * self.dot;
            for (row, column) in dots(character) {
                let corner = (left + column * self.dot, y + row * self.dot);
                self.fill(corner, (self.dot, self.dot), colour);
            }
        }
    }

    /// Writes ASCII text that runs upwards, with its lower left corner at (x, y).
    pub fn write_upwards(&mut self, (x, y): (u32, u32), text: &str, colour: Rgb<u8>) {
        for (number, character) in text.chars().enumerate() {
            let bottom = y.saturating_sub(number as u32 * CHARACTER * self.dot);
            for (row, column) in dots(character) {
                let corner = (x + row * self.dot, bottom.saturating_sub((column + 1) * self.dot));
                self.fill(corner, (self.dot, self.dot), colour);
            }
        }
    }

    /// The drawing.
    pub fn finish(self) -> RgbImage {
        self.image
    }
}

/// Rows and columns of a character's dots; of one that is not ASCII none.
fn dots(character: char) -> impl Iterator<Item = (u32, u32)> {
    let rows = BASIC_LEGACY.get(character as usize).copied().unwrap_or([0; CHARACTER as usize]);
    // The leftmost dot is the lowest bit.
    let set = move |row: u32, column: u32| rows[row as usize] >> column & 1 == 1;
    (0..CHARACTER).flat_map(move |row| (0..CHARACTER).filter(move |&column| set(row, column)).map(move |column| (row, column)))
}

//! A heat map: where in the picture errors are, and how large.
use colorous::INFERNO;
use image::{Rgb, RgbImage};
use specula_testbench::{Comparison, ErrorFigures};

use super::scale::ColourScale;
use specula_drawing::canvas::{CHARACTER, Canvas};

/// Colour of the background.
const PAPER: Rgb<u8> = Rgb([255, 255, 255]);
/// Colour of text and ticks.
const INK: Rgb<u8> = Rgb([40, 40, 40]);
/// Colour of pixels in which nothing is shaded; the scale does not contain it.
const NOTHING: Rgb<u8> = Rgb([205, 208, 212]);
/// Text next to a box of that colour, which takes two characters.
const KEY: &str = "  nothing shaded. Colours: square root";
/// Pixels of a picture's shorter side for each dot of its text.
const PIXELS_PER_DOT: u32 = 240;
/// Lines of text that a legend beside the smallest pictures needs.
const FEWEST_LINES: u32 = 17;

/// Positions in the legend, in pixels.
struct Layout {
    dot: u32,
    /// Width and height of a character.
    unit: u32,
    picture: (u32, u32),
    corner: (u32, u32),
    bar: (u32, u32),
    bar_corner: (u32, u32),
    size: (u32, u32),
}

impl Layout {
    fn new(picture: (u32, u32), words: [&str; 3], ticks: &[(f64, String)]) -> Layout {
        let dot = (picture.0.min(picture.1) / PIXELS_PER_DOT).max(1);
        let unit = CHARACTER * dot;
        let corner = (unit, 3 * unit);
        let height = picture.1.max(FEWEST_LINES * unit);
        let bar = (2 * unit, height);
        let bar_corner = (corner.0 + picture.0 + 2 * unit, corner.1);
        let labels =
            ticks.iter().map(|(_, label)| Canvas::text_width(label, dot)).max().unwrap_or(0);
        let widest = words.map(|text| Canvas::text_width(text, dot)).into_iter().max().unwrap_or(0);
        let width = (bar_corner.0 + bar.0 + 2 * unit + labels).max(corner.0 + widest);
        Layout {
            dot,
            unit,
            picture,
            corner,
            bar,
            bar_corner,
            size: (width + unit, corner.1 + height + 4 * unit),
        }
    }
}

/// The total error of each pixel as a colour, with a legend.
pub fn heat_map(comparison: &Comparison) -> RgbImage {
    let (picture, total) =
        ((comparison.exact.width, comparison.exact.height), &comparison.errors.total);
    error_map("Total error |core - exact shading|, in LSB", picture, &comparison.error_map, total)
}

/// Errors of a picture's pixels as colours, with a title and a legend; negative errors stand for
/// pixels in which nothing is shaded.
pub fn error_map(
    title: &str,
    picture: (u32, u32),
    errors: &[f32],
    total: &ErrorFigures,
) -> RgbImage {
    let scale = ColourScale::reaching(total.max_lsb);
    let figures = figures(total);
    let layout = Layout::new(picture, [title, &figures, KEY], &scale.ticks());
    let mut canvas = Canvas::new(layout.size.0, layout.size.1, PAPER, layout.dot);
    canvas.write((layout.corner.0, layout.unit), title, INK);
    draw_errors(&mut canvas, &layout, &scale, errors);
    draw_bar(&mut canvas, &layout, &scale);
    let below = layout.corner.1 + layout.bar.1 + layout.unit;
    canvas.write((layout.corner.0, below), &figures, INK);
    let key = (layout.corner.0, below + 3 * layout.unit / 2);
    canvas.fill(key, (layout.unit, layout.unit), NOTHING);
    canvas.write(key, KEY, INK);
    canvas.finish()
}

/// The error of each pixel as a colour, in the picture's own size: the same colours without a
/// legend.
pub fn heat_picture(comparison: &Comparison) -> RgbImage {
    let scale = ColourScale::reaching(comparison.errors.total.max_lsb);
    let mut image = RgbImage::new(comparison.exact.width, comparison.exact.height);
    for (pixel, &error) in image.pixels_mut().zip(&comparison.error_map) {
        *pixel = colour_of(&scale, error);
    }
    image
}

fn figures(total: &ErrorFigures) -> String {
    format!("largest {:.2}, rms {:.2}, mean {:.2}", total.max_lsb, total.rms_lsb, total.mean_lsb)
}

fn draw_errors(canvas: &mut Canvas, layout: &Layout, scale: &ColourScale, errors: &[f32]) {
    for (row, line) in (0..).zip(errors.chunks(layout.picture.0 as usize)) {
        for (column, &error) in (0..).zip(line) {
            canvas.put(layout.corner.0 + column, layout.corner.1 + row, colour_of(scale, error));
        }
    }
}

/// Draws the scale's colours from bottom to top, with ticks and their numbers.
fn draw_bar(canvas: &mut Canvas, layout: &Layout, scale: &ColourScale) {
    let ((left, top), (width, height)) = (layout.bar_corner, layout.bar);
    for row in 0..height {
        let place = 1.0 - f64::from(row) / f64::from(height - 1);
        canvas.fill((left, top + row), (width, 1), colour(place));
    }
    for (number, label) in scale.ticks() {
        let y = top + ((1.0 - scale.place(number)) * f64::from(height - 1)).round() as u32;
        canvas.fill(
            (left + width, y.min(top + height - layout.dot)),
            (layout.unit / 2, layout.dot),
            INK,
        );
        // There is room above and below for half a character, so that labels are as far apart as
        // their ticks.
        canvas.write((left + width + layout.unit, y - layout.unit / 2), &label, INK);
    }
}

/// The colour of an error, which is negative where nothing is shaded.
fn colour_of(scale: &ColourScale, error: f32) -> Rgb<u8> {
    if error < 0.0 { NOTHING } else { colour(scale.place(error.into())) }
}

/// The colour at a place of the scale, 0 to 1: Inferno, which is perceptually uniform and also
/// readable in black and white.
fn colour(place: f64) -> Rgb<u8> {
    Rgb(INFERNO.eval_continuous(place).as_array())
}

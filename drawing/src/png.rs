//! A sheet as PNG, at twice its size, so that it is crisp on high-resolution screens.
use image::{Rgb, RgbImage};
use tiny_skia::{Color, FillRule, Path, PathBuilder, Pixmap, Rect, Stroke, Transform};

use super::palette::{Colour, light, thickness};
use super::{CAPITAL, Ink, Mark, Point, Sheet};
use crate::canvas::Canvas;

/// Pixels for each pixel of the sheet, and for each dot of a character.
const SCALE: u32 = 2;
/// Largest width or height of a picture.
const MAX_LENGTH: f64 = 16_384.0;
/// Largest number of pixels of a picture.
const MAX_PIXELS: f64 = 1e8;

/// The sheet as a picture on a light background; `None` if it would be too large to be of use.
pub fn png(sheet: &Sheet) -> Option<RgbImage> {
    let Sheet { size: (width, height), marks, .. } = sheet;
    let (width, height) = (width * f64::from(SCALE), height * f64::from(SCALE));
    if width.max(height) > MAX_LENGTH || width * height > MAX_PIXELS {
        return None;
    }
    let mut pixels = Pixmap::new(width as u32, height as u32)?;
    light(Ink::Paper).fill.into_iter().for_each(|rgb| pixels.fill(colour(rgb)));
    marks.iter().for_each(|mark| draw(&mut pixels, mark));
    let opaque = pixels
        .pixels()
        .iter()
        .flat_map(|pixel| [pixel.red(), pixel.green(), pixel.blue()])
        .collect();
    let image = RgbImage::from_raw(width as u32, height as u32, opaque)?;
    let mut canvas = Canvas::over(image, SCALE);
    // Text is written last, since no text lies below a shape.
    marks.iter().for_each(|mark| write(&mut canvas, mark));
    Some(canvas.finish())
}

fn draw(pixels: &mut Pixmap, mark: &Mark) {
    match mark {
        Mark::Box(ink, (x, y), (width, height)) => {
            let rect = Rect::from_xywh(*x as f32, *y as f32, *width as f32, *height as f32);
            fill(pixels, rect.map(PathBuilder::from_rect), light(*ink).fill);
        }
        Mark::Lines(ink, lines) => {
            let lines: Vec<Vec<Point>> = lines.iter().map(|(from, to)| vec![*from, *to]).collect();
            stroke(pixels, path(&lines, |_| {}), *ink);
        }
        Mark::Traces(ink, traces) => stroke(pixels, path(traces, |_| {}), *ink),
        Mark::Areas(ink, areas) => {
            let path = path(areas, PathBuilder::close);
            fill(pixels, path.clone(), light(*ink).fill);
            stroke(pixels, path, *ink);
        }
        Mark::Dots(ink, places, radius) => {
            for &(x, y) in places {
                fill(
                    pixels,
                    PathBuilder::from_circle(x as f32, y as f32, *radius as f32),
                    light(*ink).fill,
                );
            }
        }
        Mark::Text(..) | Mark::TextEnding(..) | Mark::TextCentred(..) | Mark::TextUpwards(..) => {}
    }
}

/// The path through points; `None` if there are no points.
fn path(pieces: &[Vec<Point>], end: impl Fn(&mut PathBuilder)) -> Option<Path> {
    let mut builder = PathBuilder::new();
    for points in pieces {
        for (number, &(x, y)) in points.iter().enumerate() {
            match number {
                0 => builder.move_to(x as f32, y as f32),
                _ => builder.line_to(x as f32, y as f32),
            }
        }
        end(&mut builder);
    }
    builder.finish()
}

fn fill(pixels: &mut Pixmap, path: Option<Path>, rgb: Option<Colour>) {
    if let Some((path, rgb)) = path.zip(rgb) {
        pixels.fill_path(&path, &paint(rgb), FillRule::Winding, scaled(), None);
    }
}

fn stroke(pixels: &mut Pixmap, path: Option<Path>, ink: Ink) {
    if let Some((path, rgb)) = path.zip(light(ink).stroke) {
        let stroke = Stroke { width: thickness(ink), ..Stroke::default() };
        pixels.stroke_path(&path, &paint(rgb), &stroke, scaled(), None);
    }
}

fn scaled() -> Transform {
    Transform::from_scale(SCALE as f32, SCALE as f32)
}

fn paint(rgb: Colour) -> tiny_skia::Paint<'static> {
    let mut paint = tiny_skia::Paint::default();
    paint.set_color(colour(rgb));
    paint
}

fn colour([red, green, blue]: Colour) -> Color {
    Color::from_rgba8(red, green, blue, 255)
}

fn write(canvas: &mut Canvas, mark: &Mark) {
    let (ink, (x, y), text, share) = match mark {
        Mark::TextUpwards(ink, place, text) => return write_upwards(canvas, *ink, *place, text),
        Mark::Text(ink, place, text) => (ink, place, text, 0.0),
        Mark::TextEnding(ink, place, text) => (ink, place, text, 1.0),
        Mark::TextCentred(ink, place, text) => (ink, place, text, 0.5),
        Mark::Box(..) | Mark::Lines(..) | Mark::Traces(..) | Mark::Areas(..) | Mark::Dots(..) => {
            return;
        }
    };
    let left = x * f64::from(SCALE) - share * f64::from(Canvas::text_width(text, SCALE));
    let top = (y - CAPITAL) * f64::from(SCALE);
    if let Some(rgb) = light(*ink).fill {
        canvas.write((left.max(0.0) as u32, top.max(0.0) as u32), text, Rgb(rgb));
    }
}

/// Writes text that runs upwards, centred at a point of its base line.
fn write_upwards(canvas: &mut Canvas, ink: Ink, (x, y): Point, text: &str) {
    let left = (x - CAPITAL) * f64::from(SCALE);
    let bottom = y * f64::from(SCALE) + f64::from(Canvas::text_width(text, SCALE)) / 2.0;
    if let Some(rgb) = light(ink).fill {
        canvas.write_upwards((left.max(0.0) as u32, bottom.max(0.0) as u32), text, Rgb(rgb));
    }
}

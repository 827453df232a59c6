//! The animation of a sequence, as a PNG with several frames (APNG), which browsers play and other
//! programs show the first frame of.
use std::fs::File;
use std::io::{self, BufWriter, Write};

use image::RgbImage;
use png::{BitDepth, ColorType, Compression, Encoder, EncodingError, Writer};

use super::picture_name;
use crate::output::Staging;

/// Name of the file.
pub const ANIMATION: &str = "animation.png";

/// Frames shown in a second.
const FRAMES_PER_SECOND: u16 = 24;

/// Writes the animation of `frames` frames whose pictures are in the folder, which plays over and
/// over.
///
/// A frame after the first one holds the pixels alone that change, in the smallest rectangle around
/// them, so that the file is smaller.
///
/// # Errors
/// The system's error if a picture cannot be read or the file cannot be written.
pub fn write_animation(staging: &Staging, name: &str, frames: u32) -> io::Result<()> {
    let mut before = read(staging, 0)?;
    let file = BufWriter::new(File::create(staging.file(name))?);
    let mut writer = header(file, &before, frames).map_err(io_error)?;
    writer.write_image_data(before.as_raw()).map_err(io_error)?;
    for number in 1..frames {
        let next = read(staging, number)?;
        write_change(&mut writer, &before, &next).map_err(io_error)?;
        before = next;
    }
    writer.finish().map_err(io_error)
}

fn header<W: Write>(file: W, first: &RgbImage, frames: u32) -> Result<Writer<W>, EncodingError> {
    let mut encoder = Encoder::new(file, first.width(), first.height());
    encoder.set_color(ColorType::Rgb);
    encoder.set_depth(BitDepth::Eight);
    encoder.set_compression(Compression::High);
    encoder.set_animated(frames, 0)?;
    encoder.set_frame_delay(1, FRAMES_PER_SECOND)?;
    encoder.write_header()
}

/// Writes a frame as the rectangle in which it differs from the one before.
fn write_change<W: Write>(
    writer: &mut Writer<W>,
    before: &RgbImage,
    next: &RgbImage,
) -> Result<(), EncodingError> {
    let [x, y, width, height] = changed(before, next);
    writer.reset_frame_position()?;
    writer.set_frame_dimension(width, height)?;
    writer.set_frame_position(x, y)?;
    let part = image::imageops::crop_imm(next, x, y, width, height).to_image();
    writer.write_image_data(part.as_raw())
}

/// The smallest rectangle that contains every pixel that changes, as column, row, width and height;
/// a single pixel if none does.
fn changed(before: &RgbImage, next: &RgbImage) -> [u32; 4] {
    let differs = |&(x, y): &(u32, u32)| before.get_pixel(x, y) != next.get_pixel(x, y);
    let all = (0..next.height()).flat_map(|y| (0..next.width()).map(move |x| (x, y)));
    let bounds = all
        .filter(differs)
        .map(|(x, y)| [x, y, x, y])
        .reduce(|a, b| [a[0].min(b[0]), a[1].min(b[1]), a[2].max(b[2]), a[3].max(b[3])]);
    let [left, top, right, bottom] = bounds.unwrap_or_default();
    [left, top, right - left + 1, bottom - top + 1]
}

/// The picture of a frame, which has been written.
fn read(staging: &Staging, number: u32) -> io::Result<RgbImage> {
    let picture = image::open(staging.file(&picture_name(number))).map_err(io::Error::other)?;
    Ok(picture.into_rgb8())
}

fn io_error(error: EncodingError) -> io::Error {
    match error {
        EncodingError::IoError(error) => error,
        other => io::Error::other(other),
    }
}

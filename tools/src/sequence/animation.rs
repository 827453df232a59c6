//! The animation of a sequence, as a PNG with several frames (APNG), which browsers play and other
//! programs show the first frame of.
use std::fs::File;
use std::io::{self, BufWriter, Write};
use std::ops::RangeFrom;

use image::RgbImage;
use png::chunk::ChunkType;
use png::{BitDepth, ColorType, Compression, Encoder, EncodingError, Writer};
use rayon::prelude::*;

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
/// them, so that the file is smaller. Frames are compressed side by side.
///
/// # Errors
/// The system's error if a picture cannot be read or the file cannot be written.
pub fn write_animation(staging: &Staging, name: &str, frames: u32) -> io::Result<()> {
    let file = BufWriter::new(File::create(staging.file(name))?);
    let mut writer = encoder(file, &read(staging, 0)?).write_header().map_err(io_error)?;
    let control = [frames, 0].map(u32::to_be_bytes).concat();
    writer.write_chunk(ChunkType(*b"acTL"), &control).map_err(io_error)?;
    let mut order = 0..;
    let numbers: Vec<u32> = (0..frames).collect();
    for numbers in numbers.chunks(rayon::current_num_threads()) {
        let parts = numbers.par_iter().map(|&number| Part::of(staging, number));
        let parts: Vec<io::Result<Part>> = parts.collect();
        for part in parts {
            part?.write(&mut writer, &mut order).map_err(io_error)?;
        }
    }
    writer.finish().map_err(io_error)
}

fn encoder<W: Write>(to: W, picture: &RgbImage) -> Encoder<'static, W> {
    let mut encoder = Encoder::new(to, picture.width(), picture.height());
    encoder.set_color(ColorType::Rgb);
    encoder.set_depth(BitDepth::Eight);
    encoder.set_compression(Compression::High);
    encoder
}

/// What a frame of the animation draws.
struct Part {
    /// Column, row, width and height.
    place: [u32; 4],
    /// The compressed pixels.
    data: Vec<u8>,
}

impl Part {
    /// The rectangle in which a frame differs from the one before.
    fn of(staging: &Staging, number: u32) -> io::Result<Part> {
        let own = read(staging, number)?;
        let place = match number.checked_sub(1) {
            None => [0, 0, own.width(), own.height()],
            Some(before) => changed(&read(staging, before)?, &own),
        };
        let [x, y, width, height] = place;
        let data =
            data_of(&png_of(&image::imageops::crop_imm(&own, x, y, width, height).to_image())?);
        Ok(Part { place, data })
    }

    /// Writes the chunks of this frame, with the numbers that come next in the animation's order.
    fn write<W: Write>(
        self,
        writer: &mut Writer<W>,
        order: &mut RangeFrom<u32>,
    ) -> Result<(), EncodingError> {
        // A frame takes two of 2^32 numbers.
        let mut next = || order.next().unwrap_or_default();
        let number = next();
        let [x, y, width, height] = self.place;
        let control = [number, width, height, x, y].map(u32::to_be_bytes).concat();
        // It is shown for so long, stays, and covers what was there.
        let shown = [1, FRAMES_PER_SECOND].map(u16::to_be_bytes).concat();
        writer.write_chunk(ChunkType(*b"fcTL"), &[&control[..], &shown, &[0, 0]].concat())?;
        match number {
            0 => writer.write_chunk(ChunkType(*b"IDAT"), &self.data),
            _ => {
                let numbered = [&next().to_be_bytes()[..], &self.data].concat();
                writer.write_chunk(ChunkType(*b"fdAT"), &numbered)
            }
        }
    }
}

/// A picture as a PNG file.
fn png_of(picture: &RgbImage) -> io::Result<Vec<u8>> {
    let mut bytes = vec![];
    let mut writer = encoder(&mut bytes, picture).write_header().map_err(io_error)?;
    writer.write_image_data(picture.as_raw()).map_err(io_error)?;
    writer.finish().map_err(io_error)?;
    Ok(bytes)
}

/// The compressed pixels of a PNG file: the data of its `IDAT` chunks.
fn data_of(png: &[u8]) -> Vec<u8> {
    let (mut data, mut rest) = (vec![], &png[8..]);
    // A chunk is its length, its name, its data and a checksum.
    while let Some((head, after)) = rest.split_first_chunk::<8>() {
        let length = u32::from_be_bytes([head[0], head[1], head[2], head[3]]) as usize;
        if head[4..] == *b"IDAT" {
            data.extend_from_slice(&after[..length]);
        }
        rest = &after[length + 4..];
    }
    data
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

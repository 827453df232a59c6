//! Pictures: PNG files, heat maps of errors, and pictures next to each other.
mod heat_map;
mod panels;
mod scale;

pub use heat_map::{error_map, heat_map, heat_picture};
pub use panels::{Panel, side_by_side};

use std::fs::{self, File};
use std::io::{self, BufWriter, Cursor, Write};
use std::path::Path;

use image::codecs::png::{CompressionType, FilterType, PngEncoder};
use image::{ExtendedColorType, ImageEncoder, ImageError, ImageFormat, RgbImage};
use specula_testbench::Image;

/// Writes a picture as PNG.
pub fn write_image(path: &Path, picture: &Image) -> io::Result<()> {
    write_png(path, picture.pixels.as_flattened(), (picture.width, picture.height))
}

/// A picture as the bytes of the file that [`write_image`] writes.
pub fn image_png(picture: &Image) -> io::Result<Vec<u8>> {
    png_of_pixels(picture.pixels.as_flattened(), (picture.width, picture.height))
}

/// Writes a drawing as PNG.
pub fn write_drawing(path: &Path, drawing: &RgbImage) -> io::Result<()> {
    write_png(path, drawing.as_raw(), drawing.dimensions())
}

/// Writes a drawing of lines and text as PNG, without PNG's filters, which would break its long
/// runs of one colour.
pub fn write_line_drawing(path: &Path, drawing: &RgbImage) -> io::Result<()> {
    encode(drawing, BufWriter::new(File::create(path)?), FilterType::NoFilter)
}

/// A picture as the bytes of a PNG file.
pub fn png(picture: &RgbImage) -> io::Result<Vec<u8>> {
    let mut bytes = vec![];
    encode(picture, &mut bytes, FilterType::Adaptive)?;
    Ok(bytes)
}

fn encode(drawing: &RgbImage, to: impl Write, filter: FilterType) -> io::Result<()> {
    let (width, height) = drawing.dimensions();
    let encoder = PngEncoder::new_with_quality(to, CompressionType::Default, filter);
    encoder.write_image(drawing.as_raw(), width, height, ExtendedColorType::Rgb8).map_err(io_error)
}

fn write_png(path: &Path, pixels: &[u8], size: (u32, u32)) -> io::Result<()> {
    fs::write(path, png_of_pixels(pixels, size)?)
}

fn png_of_pixels(pixels: &[u8], (width, height): (u32, u32)) -> io::Result<Vec<u8>> {
    let (colour, format) = (ExtendedColorType::Rgb8, ImageFormat::Png);
    let mut bytes = Cursor::new(vec![]);
    image::write_buffer_with_format(&mut bytes, pixels, width, height, colour, format)
        .map_err(io_error)?;
    Ok(bytes.into_inner())
}

fn io_error(error: ImageError) -> io::Error {
    match error {
        ImageError::IoError(error) => error,
        other => io::Error::other(other),
    }
}

//! Waveforms as pictures and text: windows of VCD and FST files, Specula's or another tool's.
//!
//! A [`DumpView`] opens a dump and makes a [`Figure`] of some signals and a window; [`text`],
//! [`svg`] and [`png`] draw figures and know nothing of dumps, so a figure may show other values
//! too.
mod catch_panic;
mod clock;
mod contents;
mod dump;
mod error;
mod figure;
mod fst;
mod input;
mod layout;
mod raw;
mod render;
mod save_file;
mod segments;
mod selection;
mod survey;
mod text;
mod time_axis;
mod value;
mod variables;
mod vcd;
mod view;
mod warnings;

pub use error::WaveError;
pub use figure::{Axis, Figure, Group, Shape, SignalRow};
pub use segments::Segment;
pub use selection::Selection;
pub use text::{columns_beside, most_columns, text};
pub use value::{Notation, Value};
pub use view::{DumpView, WindowRequest};

use image::RgbImage;

/// The figure as an SVG file, `width` pixels wide if that is given.
pub fn svg(figure: &Figure, width: Option<u32>) -> String {
    specula_drawing::svg(&render::render(figure, width))
}

/// The figure as a picture on a light background. If `width` is given, it counts pixels of the
/// sheet; the picture has two for each.
///
/// # Errors
/// [`WaveError::Large`] if it would be too large to be of use.
pub fn png(figure: &Figure, width: Option<u32>) -> Result<RgbImage, WaveError> {
    let amount = || format!("{} columns", figure.axis.numbers.len());
    let large = || WaveError::Large { signals: figure.rows().count(), amount: amount() };
    specula_drawing::png(&render::render(figure, width)).ok_or_else(large)
}

#[cfg(test)]
mod tests;

//! Waveforms as pictures and text: a window of a VCD or FST file, ours or another tool's.
//!
//! A [`View`] opens a dump and makes a [`Figure`] of some signals and a window; [`text`], [`svg`] and [`png`] draw figures and know nothing of dumps.
mod dump;
mod error;
mod figure;
mod fst_check;
mod guard;
mod layout;
mod reader;
mod ruler;
mod save_file;
mod selection;
mod sheet;
mod text;
mod value;
mod variables;
mod view;

pub use error::WaveError;
pub use figure::Figure;
pub use selection::Selection;
pub use text::{columns_beside, most_columns, text};
pub use view::{Asked, View};

use image::RgbImage;

use crate::drawing;

/// The figure as an SVG file.
pub fn svg(figure: &Figure) -> String {
    drawing::svg(&sheet::sheet(figure))
}

/// The figure as a picture on light paper.
///
/// # Errors
/// [`WaveError::Large`] if it would be too large to be of use.
pub fn png(figure: &Figure) -> Result<RgbImage, WaveError> {
    let large = || WaveError::Large { signals: figure.rows().count(), length: figure.axis.numbers.len() as u64 };
    drawing::png(&sheet::sheet(figure)).ok_or_else(large)
}

#[cfg(test)]
mod tests;

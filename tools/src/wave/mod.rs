//! Waveforms as pictures and text: a window of a VCD or FST file, ours or another tool's.
//!
//! A [`View`] opens a dump and makes a [`Figure`] of some signals and a window; [`text`], [`svg`] and [`png`] draw figures and know nothing of dumps.
mod dump;
mod error;
mod figure;
mod fst_check;
mod guard;
mod layout;
mod palette;
mod png;
mod reader;
mod ruler;
mod save_file;
mod selection;
mod sheet;
mod svg;
mod text;
mod value;
mod variables;
mod view;

pub use error::WaveError;
pub use figure::Figure;
pub use png::png;
pub use selection::Selection;
pub use svg::svg;
pub use text::{columns_beside, most_columns, text};
pub use view::{Asked, View};

#[cfg(test)]
mod tests;

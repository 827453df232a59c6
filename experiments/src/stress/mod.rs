//! The stress catalogue: docs/extremes.md row by row, with exact shading, the bit-true model and
//! the simulated core of every method.
//!
//! A [`row::CatalogueRow`] states an input and its requirements; a sweep tries all rows. In every row it is
//! required that the core gives the model's code in every clock in which it must and in no other,
//! that stated facts hold, that every shade is a number from 0 to 255, that no quantisation error
//! exceeds its proven bound, and that no pixel is farther from exact shading than 1 LSB or the
//! documented [`limits`] of the method. The results are reported next to the requirements, for each
//! method.
mod catalogue;
mod cell;
pub(crate) mod draw;
pub mod drift;
pub mod limits;
mod measured;
mod page;
mod raw;
mod requirement;
pub mod row;
pub mod scene;
mod sweep;
mod trial;
pub mod variant;

pub use catalogue::CATALOGUE;
pub use cell::{Cell, Worst};
pub use measured::{Counted, Far, Largest, Measurements};
pub use page::{page, row_requirements};
pub use raw::{ID as RAW, INPUT as RAW_INPUT};
pub use requirement::{Requirement, RowVerdict};
pub use row::{PixelPlace, TrialExtent};
pub use sweep::sweep;

//! The stress catalogue: EXTREMES.md row by row, through exact shading, the bit-true model and the simulated core of every method.
//!
//! A [`row::Row`] says what goes in and what is wanted; a sweep runs all of them. Everywhere it is wanted that the core gives the model's code
//! in every clock in which it must and in no other, that stated facts hold, that no shade is other than a number from 0 to 255, and that
//! no error is beyond its proven bound.
mod catalogue;
pub(crate) mod draw;
pub mod drift;
mod page;
mod raw;
pub mod row;
pub mod scene;
mod sweep;
mod trial;
pub mod variant;

pub use catalogue::CATALOGUE;
pub use page::page;
pub use raw::{ID as RAW, INPUT as RAW_INPUT, WANTED as RAW_WANTED};
pub use row::Extent;
pub use sweep::{Cell, Worst, sweep};
pub use trial::Fault;

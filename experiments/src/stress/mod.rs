//! The stress catalogue: docs/extremes.md row by row, through exact shading, the bit-true model and
//! the simulated core of every method.
//!
//! A [`row::Row`] says what goes in and what is asked; a sweep runs all of them. Everywhere it is
//! asked that the core gives the model's code in every clock in which it must and in no other, that
//! stated facts hold, that no shade is other than a number from 0 to 255, that no error of
//! quantisation is beyond its proven bound, and that no pixel is farther from exact shading than 1
//! LSB, or than the documented [`limits`] of the method. What came is told beside what is asked, of
//! each method.
mod asked;
mod catalogue;
mod cell;
pub(crate) mod draw;
pub mod drift;
pub mod limits;
mod measured;
mod page;
mod raw;
pub mod row;
pub mod scene;
mod sweep;
mod trial;
pub mod variant;

pub use asked::{Asked, Verdict};
pub use catalogue::CATALOGUE;
pub use cell::{Cell, Worst};
pub use measured::{Counted, Far, Largest, Measured};
pub use page::{besides, page};
pub use raw::{ID as RAW, INPUT as RAW_INPUT};
pub use row::{Extent, Place};
pub use sweep::sweep;

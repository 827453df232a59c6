//! Columns as their readers see them.
use super::memory::{Memory, Place};

/// A column as one reader sees it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Read {
    /// The column.
    pub place: Place,
    /// Clocks that the reader looks back.
    pub back: usize,
}

/// The lanes of a column as a reader sees them.
pub fn narrow(memory: &Memory, read: Read, clocks: usize) -> &[i32] {
    memory.narrow[read.place.index].read(read.back, clocks)
}

/// The lanes of a column as a reader sees them.
pub fn wide(memory: &Memory, read: Read, clocks: usize) -> &[i64] {
    memory.wide[read.place.index].read(read.back, clocks)
}

//! The number of operations of each kind.
use std::ops::Add;

/// The number of operations of each kind. As in the papers, doublings and halvings are shifts, and
/// comparisons are free.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Operations {
    /// Additions.
    pub adds: u32,
    /// Subtractions.
    pub subtractions: u32,
    /// Multiplications.
    pub multiplies: u32,
    /// Divisions.
    pub divisions: u32,
    /// Square roots.
    pub square_roots: u32,
}

impl Operations {
    /// No operations.
    pub const NONE: Operations =
        Operations { adds: 0, subtractions: 0, multiplies: 0, divisions: 0, square_roots: 0 };
}

impl Add for Operations {
    type Output = Operations;

    fn add(self, other: Operations) -> Operations {
        Operations {
            adds: self.adds + other.adds,
            subtractions: self.subtractions + other.subtractions,
            multiplies: self.multiplies + other.multiplies,
            divisions: self.divisions + other.divisions,
            square_roots: self.square_roots + other.square_roots,
        }
    }
}

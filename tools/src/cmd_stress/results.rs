//! The results of the catalogue, row by row.
use specula_experiments::stress::{Cell, RowVerdict};

/// The results of the catalogue.
pub struct Stress {
    pub seed: u64,
    pub spans: u32,
    pub rows: Vec<RowResult>,
}

/// The results of a row with each method.
pub struct RowResult {
    pub id: &'static str,
    pub input: &'static str,
    pub cells: Vec<Cell>,
}

impl RowResult {
    /// The worst verdict of any method; `None` if no method has a core for the row.
    pub fn verdict(&self) -> Option<RowVerdict> {
        self.cells.iter().filter_map(Cell::verdict).max()
    }

    pub fn has_fault(&self) -> bool {
        self.verdict() == Some(RowVerdict::Fault)
    }
}

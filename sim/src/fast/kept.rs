//! Values that one thread hands to another, in lanes as wide as they were computed in.
use std::ops::Range;

use specula_datapath::design::NodeId;

use crate::columns::Show;
use crate::{Batch, Lanes};

/// The watched signals over consecutive clocks.
pub struct Kept {
    first_clock: u64,
    /// Clocks kept so far.
    clocks: usize,
    /// Clocks that there is to be room for.
    room: usize,
    columns: Vec<Column>,
}

/// A signal's values.
enum Column {
    Narrow(Vec<i32>),
    Wide(Vec<i64>),
    Constant(i64, usize),
}

impl Kept {
    /// Room for these clocks, the first of which comes first.
    pub fn new(clocks: &Range<u64>) -> Kept {
        Kept {
            first_clock: clocks.start,
            clocks: 0,
            room: (clocks.end - clocks.start) as usize,
            columns: vec![],
        }
    }

    /// Appends a batch that follows on, of the signals of all the others.
    pub fn extend(&mut self, batch: &Batch) {
        if self.columns.is_empty() {
            self.columns = batch.columns().map(|lanes| Column::like(lanes, self.room)).collect();
        }
        for (column, lanes) in self.columns.iter_mut().zip(batch.columns()) {
            column.extend(lanes);
        }
        self.clocks += batch.clocks();
    }

    /// All of it, of these signals.
    pub fn batch<'a>(&'a self, nodes: &'a [NodeId]) -> Batch<'a> {
        Batch::new(self.first_clock, self.clocks, nodes, self)
    }
}

impl Show for Kept {
    fn lanes(&self, column: usize) -> Lanes<'_> {
        match &self.columns[column] {
            Column::Narrow(lanes) => Lanes::Narrow(lanes),
            Column::Wide(lanes) => Lanes::Wide(lanes),
            Column::Constant(value, clocks) => Lanes::Constant(*value, *clocks),
        }
    }
}

impl Column {
    /// An empty column with room for so many clocks.
    fn like(lanes: Lanes, clocks: usize) -> Column {
        match lanes {
            Lanes::Narrow(_) => Column::Narrow(Vec::with_capacity(clocks)),
            Lanes::Wide(_) => Column::Wide(Vec::with_capacity(clocks)),
            Lanes::Constant(value, _) => Column::Constant(value, 0),
        }
    }

    fn extend(&mut self, lanes: Lanes) {
        match (self, lanes) {
            (Column::Narrow(kept), Lanes::Narrow(lanes)) => kept.extend_from_slice(lanes),
            (Column::Wide(kept), Lanes::Wide(lanes)) => kept.extend_from_slice(lanes),
            (Column::Constant(_, kept), Lanes::Constant(_, clocks)) => *kept += clocks,
            _ => unreachable!("a plan says once how wide a signal's lanes are"),
        }
    }
}

//! Values of signals over consecutive clocks: as an engine shows them, and as they can be kept.
use std::ops::Range;

use specula_datapath::design::NodeId;

/// The values of one signal, one for each clock.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Lanes<'a> {
    /// In 32 bits.
    Narrow(&'a [i32]),
    /// In 64 bits.
    Wide(&'a [i64]),
    /// The same for this many clocks.
    Constant(i64, usize),
}

impl<'a> Lanes<'a> {
    /// The raw value in a row.
    ///
    /// # Panics
    /// If there is no such row.
    #[inline]
    pub fn get(self, row: usize) -> i64 {
        match self {
            Lanes::Narrow(lanes) => lanes[row].into(),
            Lanes::Wide(lanes) => lanes[row],
            Lanes::Constant(value, _) => value,
        }
    }

    /// Number of rows.
    pub fn clocks(self) -> usize {
        match self {
            Lanes::Narrow(lanes) => lanes.len(),
            Lanes::Wide(lanes) => lanes.len(),
            Lanes::Constant(_, clocks) => clocks,
        }
    }

    /// Some of the rows.
    pub fn rows(self, rows: Range<usize>) -> Lanes<'a> {
        match self {
            Lanes::Narrow(lanes) => Lanes::Narrow(&lanes[rows]),
            Lanes::Wide(lanes) => Lanes::Wide(&lanes[rows]),
            Lanes::Constant(value, _) => Lanes::Constant(value, rows.len()),
        }
    }

    /// All raw values.
    pub fn iter(self) -> impl Iterator<Item = i64> + 'a {
        (0..self.clocks()).map(move |row| self.get(row))
    }

    /// Smallest and largest value; none of no rows.
    pub fn extremes(self) -> Option<(i64, i64)> {
        // Folds without a branch, which compilers make wide.
        match self {
            Lanes::Narrow(lanes) => {
                let ends =
                    |(low, high): (i32, i32), &value: &i32| (low.min(value), high.max(value));
                let (low, high) = lanes.iter().fold((i32::MAX, i32::MIN), ends);
                (!lanes.is_empty()).then(|| (low.into(), high.into()))
            }
            Lanes::Wide(lanes) => {
                let ends =
                    |(low, high): (i64, i64), &value: &i64| (low.min(value), high.max(value));
                (!lanes.is_empty()).then(|| lanes.iter().fold((i64::MAX, i64::MIN), ends))
            }
            Lanes::Constant(value, clocks) => (clocks > 0).then_some((value, value)),
        }
    }

    /// The first row whose value lies outside `low..=high`.
    pub fn first_outside(self, low: i64, high: i64) -> Option<usize> {
        match self {
            // The whole column is looked at first, without a branch in the loop; in almost every
            // one there is nothing to find.
            Lanes::Narrow(lanes) => {
                let (low, high) =
                    (low.max(i32::MIN.into()) as i32, high.min(i32::MAX.into()) as i32);
                let outside = |value: i32| (value < low) | (value > high);
                let any = lanes.iter().fold(false, |any, &value| any | outside(value));
                if any { lanes.iter().position(|&value| outside(value)) } else { None }
            }
            Lanes::Wide(lanes) => lanes.iter().position(|value| !(low..=high).contains(value)),
            Lanes::Constant(value, clocks) => {
                (clocks > 0 && !(low..=high).contains(&value)).then_some(0)
            }
        }
    }
}

/// Columns that can be looked at, one for each watched signal.
pub trait Show {
    /// All rows of column number `column`.
    fn lanes(&self, column: usize) -> Lanes<'_>;
}

/// The watched signals over a batch of clocks, as an engine shows them. A column is looked up when
/// it is asked for, so that what nobody looks at costs nothing.
#[derive(Clone)]
pub struct Batch<'a> {
    first_clock: u64,
    rows: Range<usize>,
    nodes: &'a [NodeId],
    columns: &'a dyn Show,
}

impl<'a> Batch<'a> {
    /// `clocks` clocks from `first_clock` on of these signals; all columns have as many rows.
    pub fn new(
        first_clock: u64,
        clocks: usize,
        nodes: &'a [NodeId],
        columns: &'a dyn Show,
    ) -> Batch<'a> {
        Batch { first_clock, rows: 0..clocks, nodes, columns }
    }

    /// The clock of the first row.
    pub fn first_clock(&self) -> u64 {
        self.first_clock
    }

    /// Number of clocks.
    pub fn clocks(&self) -> usize {
        self.rows.len()
    }

    /// The clocks it covers.
    pub fn span(&self) -> Range<u64> {
        self.first_clock..self.first_clock + self.clocks() as u64
    }

    /// The signals, in the order of the columns.
    pub fn nodes(&self) -> &'a [NodeId] {
        self.nodes
    }

    /// The values of signal number `column`.
    ///
    /// # Panics
    /// If there are fewer signals.
    #[inline]
    pub fn lanes(&self, column: usize) -> Lanes<'a> {
        self.columns.lanes(column).rows(self.rows.clone())
    }

    /// The values of each signal.
    pub fn columns(&self) -> impl Iterator<Item = Lanes<'a>> + '_ {
        (0..self.nodes.len()).map(|column| self.lanes(column))
    }

    /// The values of a signal.
    pub fn of(&self, node: NodeId) -> Option<Lanes<'a>> {
        self.nodes.iter().position(|&n| n == node).map(|column| self.lanes(column))
    }

    /// The rows whose clocks lie in `window`.
    pub fn within(&self, window: &Range<u64>) -> Batch<'a> {
        let span = self.span();
        let first = window.start.clamp(span.start, span.end);
        let last = window.end.clamp(first, span.end);
        let row = |clock: u64| self.rows.start + (clock - span.start) as usize;
        Batch { first_clock: first, rows: row(first)..row(last), ..*self }
    }
}

/// One column of raw values for each watched signal, over consecutive clocks, kept.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Columns {
    /// The clock of the first row.
    pub first_clock: u64,
    /// The signals, in the order of the columns.
    pub nodes: Vec<NodeId>,
    /// The values, a column for each signal.
    pub values: Vec<Vec<i64>>,
}

impl Columns {
    /// Empty columns for these signals.
    pub fn new(nodes: &[NodeId]) -> Columns {
        Columns { first_clock: 0, nodes: nodes.to_vec(), values: vec![vec![]; nodes.len()] }
    }

    /// Number of clocks.
    pub fn clocks(&self) -> usize {
        self.values.first().map_or(0, Vec::len)
    }

    /// The clocks they cover.
    pub fn span(&self) -> Range<u64> {
        self.first_clock..self.first_clock + self.clocks() as u64
    }

    /// Empties them; the next row will be that of `first_clock`.
    pub fn restart(&mut self, first_clock: u64) {
        self.first_clock = first_clock;
        self.values.iter_mut().for_each(Vec::clear);
    }

    /// Appends a batch that has the same signals and follows on.
    pub fn extend(&mut self, batch: &Batch) {
        if self.clocks() == 0 {
            self.first_clock = batch.first_clock();
        }
        for (column, lanes) in self.values.iter_mut().zip(batch.columns()) {
            match lanes {
                Lanes::Narrow(lanes) => column.extend(lanes.iter().map(|&lane| i64::from(lane))),
                Lanes::Wide(lanes) => column.extend_from_slice(lanes),
                Lanes::Constant(value, clocks) => column.resize(column.len() + clocks, value),
            }
        }
    }

    /// The column of a signal.
    pub fn of(&self, node: NodeId) -> Option<&[i64]> {
        self.nodes.iter().position(|&n| n == node).map(|i| self.values[i].as_slice())
    }

    /// All of it as a batch.
    pub fn batch(&self) -> Batch<'_> {
        Batch::new(self.first_clock, self.clocks(), &self.nodes, self)
    }
}

impl Show for Columns {
    fn lanes(&self, column: usize) -> Lanes<'_> {
        Lanes::Wide(&self.values[column])
    }
}

//! Columns in memory.
use specula_datapath::design::Range;
use specula_kernels::Lane;

use crate::Lanes;

const NARROW: Range = Range::new(i32::MIN as i64, i32::MAX as i64);

/// Whether 32-bit lanes hold every value of a range.
pub fn fits_narrow(range: Range) -> bool {
    NARROW.low <= range.low && range.high <= NARROW.high
}

/// Lanes behind the batch that may be written and are never read. So many are written at a time.
pub const PADDING: usize = 8;

/// Where a column is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Place {
    /// Whether its lanes have 64 bits, or 32.
    pub wide: bool,
    /// Its number among those of its width.
    pub index: usize,
}

/// A column: some lanes of the batch before, then those of this batch.
#[derive(Clone, Debug, Default)]
pub struct Column<L> {
    /// Lanes kept of the batch before.
    pub history: usize,
    /// All lanes.
    pub lanes: Vec<L>,
}

impl<L: Lane> Column<L> {
    /// The `clocks` lanes of this batch as a reader sees them that looks `back` clocks.
    pub fn read(&self, back: usize, clocks: usize) -> &[L] {
        let first = self.history - back;
        &self.lanes[first..first + clocks]
    }

    /// The lanes of this batch from `from` to `clocks`.
    pub fn write(&mut self, from: usize, clocks: usize) -> &mut [L] {
        &mut self.lanes[self.history + from..self.history + clocks]
    }

    /// Keeps what the next batch may look back at.
    fn advance(&mut self, clocks: usize) {
        // Most histories are short: copies of a length that the compiler knows need no call.
        for first in (0..self.history).step_by(PADDING) {
            self.lanes.copy_within(clocks + first..clocks + first + PADDING, first);
        }
    }
}

/// All columns of an engine.
#[derive(Clone, Debug, Default)]
pub struct Memory {
    /// Columns of 32-bit lanes.
    pub narrow: Vec<Column<i32>>,
    /// Columns of 64-bit lanes.
    pub wide: Vec<Column<i64>>,
}

impl Memory {
    /// A new column with lanes for `batch` clocks, all 0, that keeps at least `history` lanes of
    /// the batch before.
    pub fn add(&mut self, wide: bool, history: usize, batch: usize) -> Place {
        let history = history.next_multiple_of(PADDING);
        if wide {
            self.wide.push(Column { history, lanes: vec![0; history + batch + PADDING] });
            Place { wide, index: self.wide.len() - 1 }
        } else {
            self.narrow.push(Column { history, lanes: vec![0; history + batch + PADDING] });
            Place { wide, index: self.narrow.len() - 1 }
        }
    }

    /// Lanes that a column keeps of the batch before.
    pub fn history(&self, place: Place) -> usize {
        if place.wide { self.wide[place.index].history } else { self.narrow[place.index].history }
    }

    /// A lane of this batch (or, below 0, of the one before).
    pub fn lane(&self, place: Place, at: isize) -> i64 {
        let lane = |history: usize| (history as isize + at) as usize;
        if place.wide {
            self.wide[place.index].lanes[lane(self.wide[place.index].history)]
        } else {
            self.narrow[place.index].lanes[lane(self.narrow[place.index].history)].into()
        }
    }

    /// Sets a lane of this batch.
    pub fn set_lane(&mut self, place: Place, at: usize, value: i64) {
        if place.wide {
            let column = &mut self.wide[place.index];
            column.lanes[column.history + at] = value;
        } else {
            let column = &mut self.narrow[place.index];
            column.lanes[column.history + at] = value as i32;
        }
    }

    /// Fills lanes `from..to` of this batch with one value.
    pub fn fill(&mut self, place: Place, from: usize, to: usize, value: i64) {
        if place.wide {
            self.wide[place.index].write(from, to).fill(value)
        } else {
            self.narrow[place.index].write(from, to).fill(value as i32)
        }
    }

    /// `clocks` lanes from lane `first` of this batch on, which is below 0 for lanes of the batch
    /// before.
    pub fn lanes(&self, place: Place, first: isize, clocks: usize) -> Lanes<'_> {
        let range = |history: usize| {
            let first = (history as isize + first) as usize;
            first..first + clocks
        };
        if place.wide {
            Lanes::Wide(&self.wide[place.index].lanes[range(self.wide[place.index].history)])
        } else {
            Lanes::Narrow(&self.narrow[place.index].lanes[range(self.narrow[place.index].history)])
        }
    }

    /// Writes a column of 32-bit lanes while the others are read; it must not be among those.
    pub fn write_narrow(&mut self, index: usize, write: impl FnOnce(&Memory, &mut Column<i32>)) {
        let mut column = std::mem::take(&mut self.narrow[index]);
        write(self, &mut column);
        self.narrow[index] = column;
    }

    /// Writes a column of 64-bit lanes while the others are read; it must not be among those.
    pub fn write_wide(&mut self, index: usize, write: impl FnOnce(&Memory, &mut Column<i64>)) {
        let mut column = std::mem::take(&mut self.wide[index]);
        write(self, &mut column);
        self.wide[index] = column;
    }

    /// Goes on to the next batch.
    pub fn advance(&mut self, clocks: usize) {
        self.narrow.iter_mut().for_each(|column| column.advance(clocks));
        self.wide.iter_mut().for_each(|column| column.advance(clocks));
    }
}

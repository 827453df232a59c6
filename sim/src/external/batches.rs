//! Rows gathered into batches.
use specula_datapath::design::NodeId;

use crate::{Batch, Columns, Flow, SimError};

/// Clocks handed over at a time.
const BATCH: usize = 1024;

/// Gathers rows and hands them over a batch at a time.
pub struct Batches<'a> {
    columns: Columns,
    /// The clock of the next row.
    clock: u64,
    flow: Flow,
    sink: &'a mut dyn FnMut(&Batch) -> Flow,
}

impl<'a> Batches<'a> {
    /// Rows of the `watched` signals from `first_clock` on, for `sink`.
    pub fn new(
        watched: &[NodeId],
        first_clock: u64,
        sink: &'a mut dyn FnMut(&Batch) -> Flow,
    ) -> Batches<'a> {
        let mut columns = Columns::new(watched);
        columns.restart(first_clock);
        Batches { columns, clock: first_clock, flow: Flow::Continue, sink }
    }

    /// The clock of the next row.
    pub fn clock(&self) -> u64 {
        self.clock
    }

    /// Adds the row of the next clock and says whether more are wanted.
    pub fn push(&mut self, row: impl IntoIterator<Item = i64>) -> Flow {
        for (column, value) in self.columns.values.iter_mut().zip(row) {
            column.push(value);
        }
        self.clock += 1;
        if self.columns.clocks() == BATCH { self.hand_over() } else { self.flow }
    }

    fn hand_over(&mut self) -> Flow {
        if self.flow == Flow::Continue && self.columns.clocks() > 0 {
            self.flow = (self.sink)(&self.columns.batch());
        }
        self.columns.restart(self.clock);
        self.flow
    }

    /// Hands over what is left; there must have been rows up to the clock `end`, unless the sink
    /// stopped them.
    ///
    /// # Errors
    /// [`SimError::TooFewClocks`] if there were not.
    pub fn finish(mut self, end: u64, tool: &'static str) -> Result<(), SimError> {
        match self.hand_over() {
            Flow::Continue if self.clock < end => {
                Err(SimError::TooFewClocks { tool, missing: self.clock, end })
            }
            _ => Ok(()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_come_in_batches_until_they_are_not_wanted() {
        let mut sizes = vec![];
        let mut sink = |columns: &Batch| {
            sizes.push((columns.first_clock(), columns.clocks()));
            if sizes.len() == 2 { Flow::Stop } else { Flow::Continue }
        };
        let mut batches = Batches::new(&[NodeId(0)], 10, &mut sink);
        let pushed = (0..5000).take_while(|&value| batches.push([value]) == Flow::Continue).count();
        assert!(batches.finish(5010, "a simulator").is_ok());
        assert_eq!((pushed, sizes), (2047, vec![(10, 1024), (1034, 1024)]));
    }

    #[test]
    fn missing_rows_are_noticed() {
        let mut sink = |_: &Batch| Flow::Continue;
        let mut batches = Batches::new(&[NodeId(0)], 10, &mut sink);
        batches.push([1]);
        assert!(matches!(
            batches.finish(12, "a simulator"),
            Err(SimError::TooFewClocks { missing: 11, end: 12, .. })
        ));
    }
}
